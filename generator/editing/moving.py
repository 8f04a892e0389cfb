"""A thing put elsewhere on its table, with what stands on and in it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..errors import SceneError
from ..geometry import inside_margin, turned_quaternion
from ..physics.parts import base
from ..physics.seating import nearest_free, overlapping, seat_on_table
from ..scene import TABLE, Object, Placement, Pose, Scene
from .placing import carried_to, pose


def moved_to(scene: Scene, thing: Object, where: tuple[float, float] | None, turn: float) -> Scene:
    """Return the scene with a thing, and its load, at a place on the table, or turned."""
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
    """Return the scene with a thing, and its load, at a placement found by relations."""
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
    """Refuse a place that is taken or off the table, and name the nearest free one."""
    thing = scene.object(name)
    if thing.placement.on != TABLE:
        return
    off = inside_margin(base(thing, thing.pose), scene.table.outline).min() < 0
    if not off and not overlapping(scene, name):
        return
    free = nearest_free(scene, name, thing.pose)
    x, y = thing.pose.position[:2]
    tail = "Remove or move something first."
    if free is not None:
        tail = f"The nearest free place is at {free.position[0]:.3f} {free.position[1]:.3f}."
    why = "it would be off the table" if off else "something is in the way"
    raise SceneError(f"{name} cannot stand at {x:.3f} {y:.3f} (metres): {why}. {tail}")
