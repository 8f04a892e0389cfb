"""Planned relations and supports that hold in the settled scene according to its report."""

from __future__ import annotations

from dataclasses import replace

from .plan import TABLE, Relation
from .result import Object, Scene


def held_relations(scene: Scene, name: str) -> tuple[Relation, ...]:
    """Return the planned relations of an object that hold in the settled scene.

    If the report records no relation outcomes, all planned relations of the object are returned.
    """
    planned = scene.plan.objects if scene.plan else ()
    requested = next((o.relations for o in planned if o.name == name), ())
    outcomes = scene.report.relations if scene.report else ()
    if not outcomes:
        return requested
    held = {(o.kind, o.target) for o in outcomes if o.name == name and o.holds}
    return tuple(r for r in requested if (r.kind, r.target) in held)


def hold_supports(scene: Scene) -> Scene:
    """Return the scene, with the table as support for objects that missed their planned support.

    An object that does not rest on or in the support named in its placement is assigned to the
    table. If nothing changes, the same scene is returned.
    """
    outcomes = scene.report.relations if scene.report else ()
    denied = {(o.name, o.kind, o.target) for o in outcomes if not o.holds}

    def hold(thing: Object) -> Object:
        place = thing.placement
        if place.on == TABLE:
            return thing
        if (thing.name, "in" if place.inside else "on", place.on) not in denied:
            return thing
        return replace(thing, placement=replace(place, on=TABLE, inside=False))

    objects = tuple(map(hold, scene.objects))
    changed = any(new is not old for new, old in zip(objects, scene.objects, strict=True))
    return scene.replace(objects=objects) if changed else scene
