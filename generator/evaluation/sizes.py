"""What size a thing usually has: what the text fixed, or what the catalogue knows of its word."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from tabletop_objects import get_category
from tabletop_objects.kit.surfaces import size_factor

from ..errors import InputError
from ..scene import Object, Scene


@dataclass(frozen=True, eq=False)
class UsualSize:
    """An object's extent (metres) over the usual one for its word.

    ``ratio`` is the one nearer to 1 of two: the ratio of the longest sides, and the geometric mean
    over the axes. A laptop that is shut is so no small one.
    """

    name: str
    usual: Float[np.ndarray, "3"]
    source: str
    ratio: float


def usual_sizes(scene: Scene) -> tuple[UsualSize, ...]:
    """Return the usual sizes of those objects whose word or plan tells one."""
    return tuple(
        UsualSize(thing.name, *known, _ratio(thing.scale, known[0]))
        for thing in scene.objects
        if (known := _usual(scene, thing)) is not None
    )


def _usual(scene: Scene, thing: Object) -> tuple[Float[np.ndarray, "3"], str] | None:
    planned = [p for p in scene.plan.objects if p.name == thing.name] if scene.plan else []
    if planned and planned[0].size is not None:
        return np.array(planned[0].size), "plan"
    factor = size_factor(planned[0].attributes) if planned else 1.0
    for word in (thing.model.category, thing.label):
        try:
            return factor * np.array(get_category(word).size), "catalogue"
        except InputError:
            continue
    return None


def _ratio(extent: Float[np.ndarray, "3"], usual: Float[np.ndarray, "3"]) -> float:
    mean = float(np.log(extent / usual).mean())
    longest = float(np.log(extent.max() / usual.max()))
    return float(np.exp(min(mean, longest, key=abs))) if mean * longest > 0 else 1.0
