"""A plan as text for an image model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ....layout.seats import seats
from ....scene import TABLE, PlannedGroup, ScenePlan


def in_words(plan: ScenePlan) -> tuple[str, str]:
    """Return descriptions of a plan's table and objects, one line per object."""
    table = plan.table
    length, width, height = (round(100 * v) for v in table.size)
    color = f"{table.color} " if table.color else ""
    top = (
        f"a {table.outline} {color}{table.material} table, {length} cm long, {width} cm deep and "
        f"{height} cm high, with {table.legs} legs"
    )
    called = _descriptions(plan)
    lines = []
    for number, thing in enumerate(plan.objects, start=1):
        size = f", {in_cm(thing.size)}" if thing.size else ""
        where = "; ".join(_PLACES[r.kind].format(called[r.target]) for r in thing.relations)
        lines.append(f"{number}. {called[thing.name]}{size}{': ' + where if where else ''}")
    lines += [_arrangement(group, plan) for group in plan.groups]
    return top, "\n".join(lines)


_PLACES = {
    "left_of": "to the left of {}",
    "right_of": "to the right of {}",
    "in_front_of": "in front of {}",
    "behind": "behind {}",
    "on": "on {}",
    "in": "inside {}",
    "next_to": "beside {}",
    "center": "in the middle of {}",
    "edge": "near the edge of {}",
}


_ARRANGED: Mapping[str, str] = {
    "row": "stand side by side in a row, the first on the left",
    "column": "stand one behind another, the first in front",
    "circle": "stand in a circle",
    "fan": "lie side by side, fanned out",
    "heap": "lie close together in a heap",
    "pyramid": "are piled up as a pyramid",
    "scatter": "lie scattered about",
    "grid": "stand in rows and columns",
    "group": "stand close together",
}


def _arrangement(group: PlannedGroup, plan: ScenePlan) -> str:
    """Describe the arrangement of a group's objects, using their numbers in the list."""
    numbers = {thing.name: n for n, thing in enumerate(plan.objects, start=1)}
    who = f"Things {', '.join(str(numbers[name]) for name in group.members)}"
    if group.seat is not None:
        number, count = group.seat
        x, y = seats(count, plan.table.outline, plan.table.size[:2])[number].side
        edge = ("right" if x > 0 else "left") if abs(x) > abs(y) else "back" if y > 0 else "front"
        return (
            f"{who} are laid for a person at the {edge} edge, as that person sees left and right."
        )
    around = f" around thing {numbers[group.around]}" if group.around else ""
    return f"{who} {_ARRANGED.get(group.kind, 'stand close together')}{around}."


def _descriptions(plan: ScenePlan) -> dict[str, str]:
    """Return each object's description: its appearance, and its number if its noun is repeated."""
    nouns = [thing.noun for thing in plan.objects]
    called = {TABLE: "the table"}
    for thing in plan.objects:
        looks = dict(thing.attributes)
        if "accent" in looks:
            looks["color"] = " and ".join(filter(None, (looks.get("color"), looks["accent"])))
        state, tail = looks.get("state", ""), ""
        if state.startswith("with "):  # the contents, unless the noun already names them
            tail = "" if f" of {state[5:]}" in thing.noun else f" {state}"
            del looks["state"]
        before = [looks[k] for k in ("size", "state", "color", "material") if k in looks]
        which = ""
        if nouns.count(thing.noun) > 1:
            earlier = [t.name for t in plan.objects if t.noun == thing.noun]
            which = f" (number {earlier.index(thing.name) + 1} of {len(earlier)})"
        called[thing.name] = f"the {' '.join([*before, thing.noun])}{tail}{which}"
    return called


def in_cm(size: Sequence[float] | np.ndarray) -> str:
    """Return a size in metres as text in centimetres."""
    return " by ".join(f"{100 * v:.3g}" for v in size) + " cm"
