"""What a text asks for and its drawing does not show, put where the plan has it.

Image models forget things, and hide the pencils in a mug. What no drawing showed is built from the
catalogue and placed among what was rebuilt from the picture; the provenance names each.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import count

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from ..layout import arrange_more, build_models
from ..layout.resting import support_of
from ..scene import (
    TABLE,
    Instance,
    Model,
    Placement,
    PlannedGroup,
    PlannedObject,
    ScenePlan,
    names_in,
)


@dataclass(frozen=True, eq=False)
class Supplement:
    """Models and placements of what was added, by name, and a warning for each."""

    models: Mapping[str, Model]
    placements: tuple[Placement, ...]
    warnings: tuple[str, ...]

    def without(self, failures: Sequence[str]) -> Supplement:
        """Return what is left without the things that a failed gate names, and all on them.

        Nothing is left if it names none: what nobody saw must not spoil what was seen.
        """
        words = {word for failure in failures for word in names_in(failure)}
        added = {p.name for p in self.placements}
        gone = added & words or added
        while more := {p.name for p in self.placements if p.on in gone} - gone:
            gone |= more
        messages = tuple(f"{name} would not stand there and was left out." for name in sorted(gone))
        return Supplement(
            {name: model for name, model in self.models.items() if name not in gone},
            tuple(p for p in self.placements if p.name not in gone),
            self.warnings + messages,
        )


NOTHING = Supplement({}, (), ())

_UNSEEN = "is not to be seen in the drawing"


def supplement(
    plan: ScenePlan | None,
    instances: Sequence[Instance],
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_scale: Float[np.ndarray, "3"],
    seed: int,
    gone: Sequence[str] = (),
) -> Supplement:
    """Return what of a plan no instance shows, placed by its relations.

    No plan (a picture without a text) asks for nothing. ``models`` are the instances' and the
    table's, ``placements`` where they stand, world frame; ``table_scale`` is the table's extent,
    metres; ``seed`` of the looks and places of what is added. ``gone`` names instances that were
    seen, but left out; the plan's take their place.
    """
    if plan is None:
        return NOTHING
    placed = {p.name: p for p in placements}
    labels = {i.name: i.label for i in instances if i.name in placed}
    shown = match_planned(plan, labels, placed)
    missing = [planned for planned in plan.objects if planned.name not in shown]
    if not missing:
        return NOTHING
    names = shown | fresh_names(missing, {*placed, *(i.name for i in instances)})
    built = build_models(plan, seed)
    added = {names[planned.name]: built[planned.name] for planned in missing}
    there = {name: replace(models[name], size=p.scale) for name, p in placed.items()}
    table = replace(models[TABLE], size=table_scale)
    planned = tuple(replace(retarget(o, names), name=names[o.name]) for o in plan.objects)
    groups = tuple(_rename_group(group, names) for group in plan.groups)
    renamed = replace(plan, objects=planned, groups=groups)
    layout = arrange_more(renamed, placed, {**there, **added}, table, seed)
    lost = {*added} - {p.name for p in layout.placements}
    unfit = {i.label for i in instances if i.name in gone}
    nouns = {names[planned.name]: planned.noun for planned in missing}
    warnings = [
        f"{name} {'is in place of what was left out' if nouns[name] in unfit else _UNSEEN}; "
        + ("there is no room for it." if name in lost else "it stands where the plan has it.")
        for name in added
    ]
    kept = {name: model for name, model in added.items() if name not in lost}
    return Supplement(kept, layout.placements, (*warnings, *layout.warnings))


def match_planned(
    plan: ScenePlan, labels: Mapping[str, str], placed: Mapping[str, Placement]
) -> dict[str, str]:
    """Return which instance shows which planned object: planned name to instance name.

    Things of one word are told apart by what they stand on or in.
    """
    nouns = {planned.name: planned.noun for planned in plan.objects}
    pairs: dict[str, str] = {}
    for noun in dict.fromkeys(nouns.values()):
        wanted = [planned for planned in plan.objects if planned.noun == noun]
        found = [name for name, label in labels.items() if label == noun]
        below = [nouns.get(support_of(planned) or "", TABLE) for planned in wanted]
        under = [labels.get(placed[name].on, TABLE) for name in found]
        cost = np.array([[float(a != b) for b in under] for a in below])
        rows, columns = linear_sum_assignment(cost.reshape(len(below), len(under)))
        for row, column in zip(map(int, rows), map(int, columns), strict=True):
            pairs[wanted[row].name] = found[column]
    return pairs


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


def _rename_group(group: PlannedGroup, names: Mapping[str, str]) -> PlannedGroup:
    members = tuple(names[name] for name in group.members)
    return replace(group, members=members, around=names[group.around] if group.around else None)
