"""Placement of edited objects: at a position, or beside, on or in another object."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..errors import PlaceError, SceneError
from ..geometry import inside_margin, rotation_z, turned_quaternion, yaw_quaternion
from ..layout import arrange_more, unmet_relations
from ..layout.rest import sunk
from ..physics.parts import base, highest, lowest
from ..physics.separation import ancestry
from ..physics.simulation import Simulation
from ..physics.standing_height import carry, nearest_free, overlapping, seat_on_table, seat_stacked
from ..scene import (
    TABLE,
    Model,
    Object,
    Placement,
    PlannedObject,
    PlannedTable,
    Pose,
    Scene,
    ScenePlan,
)
from .request import as_planned


def moved_to(scene: Scene, thing: Object, where: tuple[float, float] | None, turn: float) -> Scene:
    """Return the scene after moving or turning an object together with the objects it carries."""
    if where is None or thing.placement.on == TABLE:
        x, y, z = thing.pose.position
        position = np.array([*((x, y) if where is None else where), z])
        there = Pose(position, turned_quaternion(thing.pose.quaternion, turn))
        thing_now = replace(thing, pose=there)
    else:
        placement = replace(thing.placement, on=TABLE, inside=False)
        thing_now = pose(thing, replace(placement, yaw=placement.yaw + turn))
        there = Pose(np.array([*where, 0.0]), thing_now.pose.quaternion)
        thing_now = seat_on_table(replace(thing_now, pose=there), scene.table.height)
    placement = replace(
        thing_now.placement, yaw=thing.placement.yaw + turn, translation=thing_now.pose.position
    )
    done = carried_to(scene, thing.name, thing_now.pose, turn)
    done = _with(done, replace(thing_now, placement=placement))
    _check_place(done, thing.name)
    return done


def moved_by(scene: Scene, thing: Object, place: Placement) -> Scene:
    """Return the scene after moving an object, together with those it carries, to a placement."""
    turn = place.yaw - thing.placement.yaw
    if place.on == TABLE == thing.placement.on:
        position = np.array([*place.translation[:2], thing.pose.position[2]])
        there = Pose(position, turned_quaternion(thing.pose.quaternion, turn))
        now = replace(thing, placement=place, pose=there)
    else:
        now = pose(thing, place)
        now = seat_on_table(now, scene.table.height) if place.on == TABLE else now
    return _with(carried_to(scene, thing.name, now.pose, turn), now)


def _with(scene: Scene, thing: Object) -> Scene:
    return scene.replace(objects=tuple(thing if o.name == thing.name else o for o in scene.objects))


def _check_place(scene: Scene, name: str) -> None:
    """Check that an object's requested position is free and on the table.

    Raises:
        PlaceError: it is not; the error has the nearest free position.
    """
    thing = scene.object(name)
    if thing.placement.on != TABLE:
        return
    off = inside_margin(base(thing, thing.pose), scene.table.outline).min() < 0
    if not off and not overlapping(scene, name):
        return
    x, y = thing.pose.position[:2]
    tail, free = "Remove or move another object first.", None
    if (there := nearest_free(scene, name, thing.pose)) is not None:
        free = round(float(there.position[0]), 3), round(float(there.position[1]), 3)
        tail = f"The nearest free position is ({free[0]:.3f}, {free[1]:.3f}) m."
    why = "the position is off the table" if off else "another object is in the way"
    raise PlaceError(
        f"{name} cannot stand at ({x:.3f}, {y:.3f}) m: {why}. {tail}",
        "off the table" if off else "occupied",
        free,
    )


_TOUCH = 1e-3  # maximum distance between touching objects, metres


def loads(scene: Scene, name: str) -> tuple[str, ...]:
    """Return the names of all objects directly or indirectly on or in an object, lowest first."""
    chains = sorted(ancestry(scene.objects), key=len)
    names = [[scene.objects[k].name for k in chain] for chain in chains]
    return tuple(chain[0] for chain in names if name in chain[1:])


def set_down(scene: Scene, names: Sequence[str]) -> Scene:
    """Set down objects, together with those they carry, at the nearest free positions.

    Raises:
        SceneError: There is no room for an object, or it does not fit into its vessel.
    """
    for name in names:
        thing = scene.object(name)
        if thing.placement.on != TABLE:
            continue
        thing = seat_on_table(thing, scene.table.height)
        place = nearest_free(scene, name, thing.pose)
        if place is None:
            width, depth = (100 * float(v) for v in thing.scale[:2])
            raise SceneError(
                f"There is no room on the table for {name} ({width:.0f} x {depth:.0f} cm). Remove "
                "or move another object first."
            )
        scene = carry(scene, {name: place})
    above = {n for name in names for n in loads(scene, name)}
    stacked = above | {n for n in names if scene.object(n).placement.on != TABLE}
    scene = seat_stacked(scene, stacked)
    for name in sorted(stacked):
        _check_inside(scene, scene.object(name))
    return scene


def place_by_relations(
    scene: Scene, planned: PlannedObject, model: Model, yaw: float, away: Sequence[str], seed: int
) -> Placement:
    """Return a free placement for an object according to its relations to objects in the scene.

    ``model`` has its final size; ``yaw`` is its yaw on the table, radians. The objects in ``away``
    are being moved and are therefore ignored.

    Raises:
        SceneError: There is no room at the requested position.
    """
    there = [o for o in scene.objects if o.name not in away]
    placed = {o.name: replace(o.placement, translation=o.pose.position) for o in there}
    models = {o.name: replace(o.model, size=o.scale) for o in there} | {planned.name: model}
    table = replace(scene.table.model, size=scene.table.scale)
    things = (planned, *beneath(scene, planned, away))
    plan = ScenePlan(planned.noun, PlannedTable(), things, "plain")
    layout = arrange_more(plan, placed, models, table, seed, {planned.name: yaw})
    advice = "Remove or move another object first, or choose another position."
    if layout.warnings or not layout.placements:
        reasons = layout.warnings or (f"There is no free place on the table for {planned.name}.",)
        raise SceneError(f"{' '.join(reasons).split(';')[0].rstrip('.')}. {advice}")
    (placement,) = layout.placements
    wrong = unmet_relations(planned, placement, placed, models, table)
    if wrong and placement.on == TABLE:
        asked = " and ".join(f"{r.kind.replace('_', ' ')} {r.target}" for r in wrong)
        raise SceneError(f"There is no room for {planned.name} {asked}. {advice}")
    return placement


def beneath(
    scene: Scene, planned: PlannedObject, away: Sequence[str] = ()
) -> tuple[PlannedObject, ...]:
    """Return the targets of an object's relations, and the objects already on or in the targets."""
    targets = {r.target: r for r in planned.relations if r.target != TABLE}
    found = []
    for thing in scene.objects:
        below = targets.get(thing.placement.on)
        if thing.name in targets:
            found.append(as_planned(scene, thing))
        elif below and below.kind in ("on", "in") and thing.name not in away:
            found.append(replace(as_planned(scene, thing), relations=(below,)))
    return tuple(found)


def pose(thing: Object, placement: Placement) -> Object:
    """Return an object that stands upright at a placement."""
    pose = Pose(placement.translation, yaw_quaternion(placement.yaw))
    return replace(thing, placement=placement, pose=pose)


def carried_to(scene: Scene, name: str, pose: Pose, turn: float) -> Scene:
    """Move an object and those it carries to a pose, turning them by ``turn`` radians."""
    start = scene.object(name).pose.position
    above = {*loads(scene, name)}

    def move(thing: Object) -> Object:
        if thing.name == name:
            return replace(thing, pose=pose)
        if thing.name not in above:
            return thing
        aside = rotation_z(turn) @ (thing.pose.position - start)
        placement = replace(thing.placement, yaw=thing.placement.yaw + turn)
        there = Pose(pose.position + aside, turned_quaternion(thing.pose.quaternion, turn))
        return replace(thing, placement=placement, pose=there)

    return scene.replace(objects=tuple(move(o) for o in scene.objects))


def check_held(scene: Scene, names: Sequence[str]) -> None:
    """Check that objects still rest on their supports.

    Raises:
        SceneError: An object fell off its support.
    """
    simulation = Simulation(scene)
    simulation.place([o.pose for o in scene.objects])
    touching = simulation.contacts(margin=_TOUCH).deepest()
    index = {o.name: k for k, o in enumerate(scene.objects)}
    for name in names:
        below = scene.object(name).placement.on
        if below == TABLE:
            continue
        near = {k for pair in touching for k in pair if index[name] in pair} - {index[name]}
        beside = {index[o.name] for o in scene.objects if o.placement.on == below}
        if not near & {index[below], *beside}:
            raise SceneError(
                f"{name} does not stay on {below}. Move or remove {below} first, or choose another "
                "object or position."
            )


def _check_inside(scene: Scene, thing: Object) -> None:
    if not thing.placement.inside:
        return
    vessel = scene.object(thing.placement.on)
    rim = float(vessel.pose.position[2]) + highest(vessel)
    heaped = any(o.placement.on == vessel.name and o is not thing for o in scene.objects)
    middle = thing.pose.position + np.array([0.0, 0.0, lowest(thing) + thing.scale[2] / 2])
    if not sunk(replace(thing.placement, translation=middle), rim, heaped=heaped):
        raise SceneError(
            f"{thing.name} does not fit into {vessel.name}. Move or remove one of them first, or "
            "choose another object."
        )
