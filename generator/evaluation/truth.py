"""Comparison of each object's yaw, position, size and support with those in the true scene."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from tabletop_objects import find_category
from tabletop_objects.kit.surfaces import size_factor

from ..geometry import quaternion_yaw
from ..scene import Object, Scene
from .surfaces.symmetry import order, yaw_error


@dataclass(frozen=True)
class PoseError:
    """Errors of one object relative to the object with the same name in the true scene.

    yaw: difference about the vertical in [0, pi], modulo the true object's symmetry, radians.
        Prints break symmetry: a book turned by half a turn has an error of pi.
    translation: distance of the box centres, metres; ``share`` is its ratio to the table's width.
    scale: geometric mean of the ratios of the extents, this scene over the true one;
        ``worst_axis`` is the ratio farthest from 1.
    support: whether it stands on or in the same object.
    symmetry: the true object's order of symmetry in shape and texture; infinity if it is round.
    """

    name: str
    yaw: float
    translation: float
    share: float
    scale: float
    worst_axis: float
    support: bool
    symmetry: float


@dataclass(frozen=True)
class TruthErrors:
    """Errors of the objects that are in both scenes; ``missing`` and ``extra`` name the others."""

    objects: tuple[PoseError, ...]
    missing: tuple[str, ...]
    extra: tuple[str, ...]

    def facts(self) -> dict[str, Any]:
        """Return the errors as JSON values; means over no objects are None."""
        found = self.objects

        def middle(values: list[float]) -> float | None:
            return round(float(np.mean(values)), 4) if values else None

        return {
            "matched": len(found),
            "missing": list(self.missing),
            "extra": list(self.extra),
            "mean_yaw_error_deg": middle([float(np.rad2deg(o.yaw)) for o in found]),
            "mean_translation_error_cm": middle([100 * o.translation for o in found]),
            "mean_translation_error_percent_of_table": middle([100 * o.share for o in found]),
            "mean_scale_error": middle([abs(np.log(o.scale)) for o in found]),
            "support_accuracy": middle([float(o.support) for o in found]),
            "objects": [
                {
                    "name": o.name,
                    "yaw_error_deg": round(float(np.rad2deg(o.yaw)), 2),
                    "symmetry": "round" if math.isinf(o.symmetry) else int(o.symmetry),
                    "translation_error_cm": round(100 * o.translation, 3),
                    "translation_error_percent_of_table": round(100 * o.share, 3),
                    "scale_ratio": round(o.scale, 4),
                    "worst_axis_ratio": round(o.worst_axis, 4),
                    "support_as_in_truth": o.support,
                }
                for o in found
            ],
        }


def truth_errors(scene: Scene, truth: Scene) -> TruthErrors:
    """Compare the settled poses of two scenes whose objects are matched by name.

    The table's width is the true table's extent along x. Tables stand at the origin in both scenes.
    """
    ours = {o.name: o for o in scene.objects}
    true = {o.name: o for o in truth.objects}
    width = float(truth.table.scale[0])
    return TruthErrors(
        tuple(_errors(ours[name], thing, width) for name, thing in true.items() if name in ours),
        tuple(sorted(true.keys() - ours.keys())),
        tuple(sorted(ours.keys() - true.keys())),
    )


def _errors(ours: Object, true: Object, width: float) -> PoseError:
    symmetry = order(true.model.mesh, true.scale)
    yaws = [quaternion_yaw(o.pose.quaternion) for o in (ours, true)]
    ratios = np.log(ours.scale / true.scale)
    away = float(np.linalg.norm(ours.pose.position - true.pose.position))
    return PoseError(
        ours.name,
        float(np.deg2rad(yaw_error(yaws[0], yaws[1], symmetry))),
        away,
        away / width,
        float(np.exp(ratios.mean())),
        float(np.exp(ratios[np.argmax(np.abs(ratios))])),
        (ours.placement.on, ours.placement.inside) == (true.placement.on, true.placement.inside),
        symmetry,
    )


@dataclass(frozen=True, eq=False)
class UsualSize:
    """An object's usual extent (metres), where it comes from, and how the actual extent compares.

    ``ratio`` is the ratio of the longest sides or the geometric mean over the axes, whichever is
    closer to 1, so that a closed laptop does not count as small.
    """

    name: str
    usual: Float[np.ndarray, "3"]
    source: str
    ratio: float


def usual_sizes(scene: Scene) -> tuple[UsualSize, ...]:
    """Return each object's usual size, if its noun or the plan determines one."""
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
        if (category := find_category(word)) is not None:
            return factor * np.array(category.size), "catalogue"
    return None


def _ratio(extent: Float[np.ndarray, "3"], usual: Float[np.ndarray, "3"]) -> float:
    mean = float(np.log(extent / usual).mean())
    longest = float(np.log(extent.max() / usual.max()))
    return float(np.exp(min(mean, longest, key=abs))) if mean * longest > 0 else 1.0
