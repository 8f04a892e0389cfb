"""Conversion and validation of answers about a picture: kinds, supports, positions and sizes.

Each function raises ``Wrong`` if an answer contradicts itself or the picture.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....scene import TABLE, LayoutBox, Reference, Stacking, View
from ...protocols import Instances, Sizes
from ..server.answers import KindsAnswer, PlacesAnswer, RestAnswer, RestsAnswer
from ..server.json_text import Wrong
from .labelled import Labelled
from .plan_text import in_cm


def kinds(answer: KindsAnswer) -> tuple[str, ...]:
    """Return "table" and each kind's noun, repeated for each of its instances."""
    nouns = [" ".join(kind.noun.lower().split()) for kind in answer.kinds]
    twice = sorted({n for n in nouns if nouns.count(n) > 1})
    if twice:
        raise Wrong(f"these kinds are listed twice: {', '.join(twice)}. List each kind once.")
    counts = {n: k.count for n, k in zip(nouns, answer.kinds, strict=True) if n != TABLE}
    if not counts:
        raise Wrong("the answer lists no kind of object on the table.")
    return (TABLE, *(noun for noun, count in counts.items() for _ in range(count)))


def fixed_sizes(reference: Reference, instances: Instances) -> dict[str, np.ndarray]:
    """Return sizes from the prompt, in metres, unless they differ among objects of one kind."""
    found: dict[str, np.ndarray] = {}
    if reference.plan is None:
        return found
    for instance in instances:
        sizes = {t.size for t in reference.plan.objects if t.noun == instance.label}
        if instance.name == TABLE:
            sizes = {reference.plan.table.size}
        if len(sizes) == 1 and (only := sizes.pop()) is not None:
            found[instance.name] = np.array(only)
    return found


def stacking(answer: RestsAnswer, shown: Labelled) -> dict[str, Stacking]:
    """Return the support of each object; an object that it leans against is not a support."""
    supports = {}
    for name, rest in shown.match(answer.things, without=(0,)).items():
        _check_rest(rest, shown)
        below = shown.by_number[rest.support].name if rest.support else TABLE
        supports[name] = below, rest.how == "in"
    resting = {name: Stacking(_layer(name, supports), *on) for name, on in supports.items()}
    return {TABLE: Stacking(1), **resting}


def _check_rest(rest: RestAnswer, shown: Labelled) -> None:
    for other in (rest.support, rest.leans_at or 0):
        if other and other not in shown.by_number:
            raise Wrong(
                f"object {rest.id} rests on or leans against {other}, which is not in the list."
            )
        if other == rest.id:
            raise Wrong(f"object {rest.id} cannot rest on or lean against itself.")
    if rest.how == "in" and not rest.support:
        raise Wrong(f"object {rest.id} cannot be 'in' the table; it can only be 'on' it.")


def _layer(name: str, supports: Mapping[str, tuple[str, bool]]) -> int:
    seen = [name]
    while (below := supports[seen[-1]][0]) != TABLE:
        if below in seen:
            raise Wrong(f"these objects rest on one another in a circle: {', '.join(seen)}.")
        seen.append(below)
    return 1 + len(seen)


def layout(
    answer: PlacesAnswer, shown: Labelled, length: float, width: float
) -> dict[str, LayoutBox]:
    """Return objects' positions and sizes in metres, given the tabletop's size in centimetres."""
    by_name = shown.match(answer.places, without=(0,))
    beyond = [a.id for a in by_name.values() if abs(a.x) > length / 2 or abs(a.y) > width / 2]
    if beyond:
        numbers = ", ".join(map(str, beyond))
        raise Wrong(f"these objects lie beyond the edge of the tabletop: {numbers}.")
    return {
        name: LayoutBox(np.array([a.x, a.y]) / 100, np.array([a.length, a.width, a.height]) / 100)
        for name, a in by_name.items()
    }


def pose_facts(shown: Labelled, sizes: Sizes, view: View) -> dict[str, str]:
    """Return the facts for questions about poses: object sizes, and camera angles in degrees."""
    return {
        "listing": shown.listing(lambda i: in_cm(sizes[i.name].extent)),
        "elevation": f"{np.rad2deg(view.elevation):.0f}",
        "azimuth": f"{np.rad2deg(view.azimuth):.0f}",
    }
