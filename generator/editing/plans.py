"""Updates of a scene's plan after an edit; the plan determines the names and sizes of objects."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from ..method.planned import retarget
from ..scene import TABLE, PlannedGroup, PlannedObject, Relation, Scene


def planned_things(scene: Scene) -> tuple[PlannedObject, ...]:
    """Return the planned objects of a scene, or none if it has no plan."""
    return scene.plan.objects if scene.plan else ()


def swap_in_plan(scene: Scene, old: str, new: PlannedObject) -> Scene:
    """Return the scene with ``new`` instead of ``old`` in its plan, if it has a plan."""
    known = {o.name: o for o in planned_things(scene)}
    if old not in known:
        return add_to_plan(scene, new)
    objects = [new if o.name == old else retarget(o, {old: new.name}) for o in known.values()]
    return _with(scene, objects, {old: new.name})


def add_to_plan(scene: Scene, new: PlannedObject) -> Scene:
    """Return the scene with ``new`` in its plan, along with its relations to planned objects."""
    return _with(scene, [*planned_things(scene), new])


def remove_from_plan(scene: Scene, names: Collection[str]) -> Scene:
    """Return the scene with a plan that omits ``names`` and the relations to them."""
    return _with(scene, [o for o in planned_things(scene) if o.name not in names])


def move_in_plan(scene: Scene, name: str, relations: Sequence[Relation]) -> Scene:
    """Replace a moved object's relations in the plan, and drop outdated relations to the object.

    The moved object leaves its group.
    """
    objects = [
        replace(o, relations=tuple(relations))
        if o.name == name
        else replace(o, relations=tuple(r for r in o.relations if _held(r, name)))
        for o in planned_things(scene)
    ]
    return _with(scene, objects, {name: ""})


def restyle_plan(scene: Scene, names: Collection[str], style: str) -> Scene:
    """Return the scene with another style in its plan, provided all its objects are restyled."""
    if scene.plan is None or {o.name for o in scene.objects} - {*names}:
        return scene
    return scene.replace(plan=replace(scene.plan, style=style))


def _held(relation: Relation, name: str) -> bool:
    """Return whether a relation still holds after ``name`` moved with the objects it carries."""
    return relation.target != name or relation.kind in ("on", "in")


def _with(
    scene: Scene, objects: Sequence[PlannedObject], renamed: Mapping[str, str] | None = None
) -> Scene:
    """Return the scene; its plan, if any, has only ``objects`` and the relations among them.

    ``renamed`` maps members of groups to their new names, or to "" if they left the group.
    """
    if scene.plan is None:
        return scene
    names = {TABLE, *(o.name for o in objects)}
    related = tuple(
        replace(o, relations=tuple(r for r in o.relations if r.target in names)) for o in objects
    )
    groups = tuple(
        left
        for group in scene.plan.groups
        if (left := _regroup(group, names, renamed or {})) is not None
    )
    return scene.replace(plan=replace(scene.plan, objects=related, groups=groups))


def _regroup(
    group: PlannedGroup, names: Collection[str], renamed: Mapping[str, str]
) -> PlannedGroup | None:
    """Return what remains of a group, or None if fewer than two objects remain."""
    members = tuple(m for n in group.members if (m := renamed.get(n, n)) in names)
    around = renamed.get(group.around, group.around) if group.around else None
    around = around if around in names else None
    few = len(members) + (around is not None) < 2
    return None if few else replace(group, members=members, around=around)
