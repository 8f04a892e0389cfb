"""Settling of a scene under gravity; objects that do not stand are given a weighted base."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float

from ..geometry import quaternion_matrix
from ..scene import ConvexPart, Object, Pose, Scene
from .inertia import MassProperties, box_mass, join_bodies
from .parts import lowest
from .simulation import Simulation, measure_motion

_CHUNK = 0.1  # seconds between two samples
_SHAKE = 0.5
_DAMPING = 3.0
_SOFT = 0.3  # ratio of frictional impedance (impratio) in the first phase
_COARSE = 4e-3  # seconds, time step of the first phase
_FIRM = 0.5  # maximum seconds until everything is at rest with the scene's own settings
_STILL = np.array([2e-4, 2e-3])  # m/s and rad/s: a fifth of the gate's limits
_SLOW = 5 * _STILL  # the same for soft friction, with which creep is about thirty times as fast


def settle(
    scene: Scene,
    seconds: float,
    minimum: float = 0.0,
    shake: float = 0.0,
    simulation: Simulation | None = None,
) -> tuple[Pose, ...]:
    """Simulate until all objects are at rest, for at most ``seconds``, and return the poses.

    The simulation takes at least ``minimum`` seconds. First, gravity is tilted by ``shake``
    (radians) towards each of four sides in turn, so that, for example, a brush that stands free in
    a mug falls against the rim and stays there. Free motion is damped at a rate of 3 per second, so
    that round objects stop, except in the last tenth of a second: the returned poses are stable
    without damping.

    Touching objects creep, and creep faster if friction is softer. Friction is therefore soft for
    up to half of the time, so that a heap of fruit settles as much in two seconds as it otherwise
    would in a minute. After that, the scene's own friction is used. Jitter does not count as
    motion. If the simulation diverges, the scene's own poses are returned, and the gate reports the
    failure. ``simulation`` is an existing simulation of the scene at its own poses.
    """
    simulation = simulation or Simulation(scene)
    option = simulation.model.opt
    firm, fine = option.impratio, option.timestep
    for side in range(4 if shake else 0):
        with simulation.conditions(shake, side * np.pi / 2, fine):
            simulation.run(_SHAKE)
    option.impratio, option.timestep = _SOFT, _COARSE
    _calm(simulation, min(minimum, seconds / 2), seconds / 2, 3, _SLOW)
    option.impratio, option.timestep = firm, fine
    _calm(simulation, 0.0, min(_FIRM, seconds / 2), 2, _STILL)
    simulation.run(_CHUNK)
    return tuple(o.pose for o in scene.objects) if simulation.diverged else simulation.poses


def _calm(
    simulation: Simulation, minimum: float, seconds: float, looks: int, pace: Float[np.ndarray, "2"]
) -> None:
    """Simulate until ``looks`` successive samples show no motion above ``pace`` (m/s, rad/s)."""
    still, now = 0, simulation.states
    for k in range(max(1, round(seconds / _CHUNK))):
        before = now
        simulation.run(_CHUNK, _DAMPING)
        now = simulation.states
        still = still + 1 if (measure_motion(before, now) <= _CHUNK * pace).all() else 0
        if still >= looks and (k + 1) * _CHUNK >= minimum:
            return


def has_toppled(thing: Object, pose: Pose, limit: float) -> bool:
    """Return whether an object leans by more than ``limit`` (radians) and its height has changed.

    A pencil or a die that rolls onto its next side keeps its height and has not toppled. An
    upside-down object that is taller than wide has toppled.
    """
    up = quaternion_matrix(pose.quaternion)[2]
    if np.arccos(np.clip(up[2], -1.0, 1.0)) <= limit:
        return False
    points = np.concatenate([part.vertices for part in thing.parts])
    before, after = np.ptp(points[:, 2]), np.ptp(points @ up)
    on_head = up[2] < -0.5 and before > 1.2 * np.ptp(points[:, :2], axis=0).max()
    return bool(on_head or abs(after - before) > 0.25 * before)


_FOOT = 0.25, 0.75  # minimum and maximum fraction of an object's mass in its foot


def on_foot(thing: Object) -> Object:
    """Return the object with a flat box (the foot) added below it, which carries part of the mass.

    The foot spans the object's box and is a thirtieth of its height, at least 2 mm. It has at least
    a quarter and at most three quarters of the mass: as much as is needed to lower the common
    centre of mass to a third of the height. The foot's own centre of mass is placed, as far as the
    foot extends, so that the common one is over the middle.
    """
    height = float(thing.scale[2])
    size = np.array([*thing.scale[:2], max(2e-3, height / 30)])
    middle = np.array([0.0, 0.0, lowest(thing) + size[2] / 2])
    rise = float(thing.com[2] - middle[2])
    needed = 1 - (height / 3 - size[2] / 2) / rise if rise > 0 else 0.0
    share = float(np.clip(needed, *_FOOT))
    aside = np.clip((1 - 1 / share) * (thing.com * [1, 1, 0]), -size / 2, size / 2)
    rest = MassProperties((1 - share) * thing.mass, thing.com, (1 - share) * thing.inertia)
    whole = join_bodies((rest, box_mass(share * thing.mass, middle + aside, size)))
    corners = middle + size * (np.indices((2, 2, 2)).reshape(3, 8).T - 0.5)
    parts = (*thing.parts, ConvexPart(corners, "box"))
    return replace(thing, parts=parts, com=whole.com, inertia=whole.inertia)
