"""Which instance shows which planned thing, and the names of all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import count

import numpy as np
from scipy.optimize import linear_sum_assignment

from ...language.naming import find_category
from ...layout.resting import support_of
from ...scene import TABLE, Model, Placement, PlannedObject, ScenePlan

_NEVER = 1e3  # cost of a pair that is none
_OTHER_SUPPORT, _OTHER_SIZE = 0.5, 0.2  # costs; of a size that is e times another


def match_planned(
    plan: ScenePlan,
    labels: Mapping[str, str],
    placed: Mapping[str, Placement],
    models: Mapping[str, Model],
) -> dict[str, str]:
    """Return which instance shows which planned thing: planned name to instance name.

    ``labels`` are the instances' words, ``models`` the plan's by planned name. An instance shows a
    thing of its own word before one of its kind, and that before one whose last word is the same
    ("coffee mug", "mug"). Things of one word are told apart by what they stand on or in, then by
    their size.
    """
    nouns = {planned.name: planned.noun for planned in plan.objects}
    names = list(labels)
    cost = np.full((len(plan.objects), len(names)), _NEVER)
    for row, planned in enumerate(plan.objects):
        below = nouns.get(support_of(planned) or "", TABLE)
        for column, name in enumerate(names):
            unlike = _compare_words(planned, labels[name])
            if unlike is None:
                continue
            under = labels.get(placed[name].on, TABLE)
            ratio = np.prod(placed[name].scale) / np.prod(models[planned.name].size)
            cost[row, column] = unlike + _OTHER_SUPPORT * (below != under)
            cost[row, column] += _OTHER_SIZE * min(abs(float(np.log(ratio))) / 3, 2.0)
    rows, columns = linear_sum_assignment(cost)
    return {
        plan.objects[row].name: names[column]
        for row, column in zip(map(int, rows), map(int, columns), strict=True)
        if cost[row, column] < _NEVER
    }


def _compare_words(planned: PlannedObject, label: str) -> float | None:
    """Return how unlike a label is to what a planned thing is called; None for another thing."""
    if label == planned.noun:
        return 0.0
    found = find_category(label)
    if found is not None and found.key == planned.category:
        return 2.0
    return 4.0 if label.split()[-1:] == planned.noun.split()[-1:] else None


def fresh_names(missing: Sequence[PlannedObject], taken: set[str]) -> dict[str, str]:
    """Return names for ``missing`` that no instance has."""
    names: dict[str, str] = {}
    used = set(taken)
    for planned in missing:
        stem = planned.name.rstrip("0123456789").rstrip("_")
        name = next(name for k in count(1) if (name := f"{stem}_{k}") not in used)
        names[planned.name] = name
        used.add(name)
    return names


def retarget(planned: PlannedObject, names: Mapping[str, str]) -> PlannedObject:
    """Return a planned thing with its relations to what is renamed by ``names``, old to new."""
    relations = tuple(replace(r, target=names.get(r.target, r.target)) for r in planned.relations)
    return replace(planned, relations=relations)


def rename_plan(plan: ScenePlan, names: Mapping[str, str]) -> ScenePlan:
    """Return a plan whose things have other names, old to new."""
    objects = tuple(replace(retarget(o, names), name=names[o.name]) for o in plan.objects)
    groups = tuple(
        replace(
            group, members=tuple(names[name] for name in group.members),
            around=None if group.around is None else names[group.around],
        )
        for group in plan.groups
    )  # fmt: skip
    return replace(plan, objects=objects, groups=groups)
