"""Matching of instances to planned objects, and names for all of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import combinations, count

import numpy as np
from jaxtyping import Float, UInt8
from scipy.optimize import linear_sum_assignment

from tabletop_objects import find_category

from ...layout.rest import support_of
from ...layout.scores import SIDES
from ...scene import TABLE, Instance, Model, Placement, PlannedObject, ScenePlan

_NEVER = 1e3  # cost of a pair that cannot match
_SUPPORT, _SIZE, _COLOR = 0.5, 0.1, 0.6
"""Costs of a different support, of a volume e^3 times as large, and of white instead of black."""


def match_planned(
    plan: ScenePlan,
    instances: Sequence[Instance],
    placed: Mapping[str, Placement],
    models: Mapping[str, Model],
) -> dict[str, str]:
    """Return the instance of each planned object, as a map from planned to instance names.

    ``models`` maps planned names to the plan's models. An instance with the planned word is
    preferred to one of the same category, which is preferred to one with the same last word
    ("coffee mug", "mug"). Objects with the same word are distinguished by their supports, their
    sizes and, if the text mentions any, their colours; identical objects by their positions
    relative to others.
    """
    labels = {i.name: i.label for i in instances if i.name in placed}
    nouns = {planned.name: planned.noun for planned in plan.objects}
    shown = [i for i in instances if i.name in placed]
    tones = [_tone(np.asarray(i.crop)) for i in shown]
    cost = np.full((len(plan.objects), len(shown)), _NEVER)
    for row, planned in enumerate(plan.objects):
        below, model = nouns.get(support_of(planned) or "", TABLE), models[planned.name]
        tone = model.mesh.texture.reshape(-1, 3).mean(0)
        for column, instance in enumerate(shown):
            unlike = _compare_words(planned, instance.label)
            if unlike is None:
                continue
            there = placed[instance.name]
            ratio = float(np.log(np.prod(there.scale) / np.prod(model.size))) / 3
            cost[row, column] = unlike + _SIZE * min(ratio * ratio, 4.0)
            cost[row, column] += _SUPPORT * (below != labels.get(there.on, TABLE))
            if "color" in planned.attributes:
                gap = float(np.linalg.norm(tones[column] - tone)) / np.linalg.norm([255] * 3)
                cost[row, column] += _COLOR * gap
    rows, columns = linear_sum_assignment(cost)
    pairs = {
        plan.objects[row].name: shown[column].name
        for row, column in zip(map(int, rows), map(int, columns), strict=True)
        if cost[row, column] < _NEVER
    }
    return _swap_alike(plan, pairs, placed)


def _tone(crop: UInt8[np.ndarray, "h w 4"]) -> Float[np.ndarray, "3"]:
    """Return the mean colour of a crop's visible pixels."""
    inside = crop[..., 3] > 127
    return crop[inside, :3].mean(0) if inside.any() else np.full(3, 127.5)


def _swap_alike(
    plan: ScenePlan, pairs: dict[str, str], placed: Mapping[str, Placement]
) -> dict[str, str]:
    """Return the pairs, with identical objects swapped if this satisfies more side relations."""
    alike: dict[str, list[str]] = {}
    for planned in plan.objects:
        if planned.name in pairs:
            look = f"{planned.noun} {sorted(planned.attributes.items())} {support_of(planned)}"
            alike.setdefault(look, []).append(planned.name)
    wrong = _count_wrong_sides(plan, pairs, placed)
    for one, other in (pair for names in alike.values() for pair in combinations(names, 2)):
        if not wrong:
            break
        swapped = pairs | {one: pairs[other], other: pairs[one]}
        left = _count_wrong_sides(plan, swapped, placed)
        if left < wrong:
            pairs, wrong = swapped, left
    return pairs


def _count_wrong_sides(
    plan: ScenePlan, pairs: Mapping[str, str], placed: Mapping[str, Placement]
) -> int:
    """Return the number of planned objects on the wrong side of another object or of the table."""
    at = {name: placed[found].translation[:2] for name, found in pairs.items()}
    at[TABLE] = np.zeros(2)
    return sum(
        float((at[o.name] - at[r.target]) @ np.array(SIDES[r.kind][2])) <= 0
        for o in plan.objects
        for r in o.relations
        if r.kind in SIDES and o.name in at and r.target in at
    )


def _compare_words(planned: PlannedObject, label: str) -> float | None:
    """Return the cost of a label for a planned object, or None if they do not match."""
    if label == planned.noun:
        return 0.0
    found = find_category(label)
    if found is not None and found.key == planned.category:
        return 2.0
    return 4.0 if label.split()[-1:] == planned.noun.split()[-1:] else None


def fresh_names(missing: Sequence[PlannedObject], taken: set[str]) -> dict[str, str]:
    """Return unused names for the ``missing`` objects."""
    names: dict[str, str] = {}
    used = set(taken)
    for planned in missing:
        stem = planned.name.rstrip("0123456789").rstrip("_")
        name = next(name for k in count(1) if (name := f"{stem}_{k}") not in used)
        names[planned.name] = name
        used.add(name)
    return names


def retarget(planned: PlannedObject, names: Mapping[str, str]) -> PlannedObject:
    """Return a planned object with its relations' targets renamed by ``names`` (old to new)."""
    relations = tuple(replace(r, target=names.get(r.target, r.target)) for r in planned.relations)
    return replace(planned, relations=relations)


def rename_plan(plan: ScenePlan, names: Mapping[str, str]) -> ScenePlan:
    """Return a plan with renamed objects; ``names`` maps old names to new ones."""
    objects = tuple(replace(retarget(o, names), name=names[o.name]) for o in plan.objects)
    groups = tuple(
        replace(
            group, members=tuple(names[name] for name in group.members),
            around=None if group.around is None else names[group.around],
        )
        for group in plan.groups
    )  # fmt: skip
    return replace(plan, objects=objects, groups=groups)
