"""Let a scene come to rest under gravity; objects that cannot stand get a weighted foot."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float

from ..geometry import quaternion_matrix
from ..scene import ConvexPart, Object, Pose, Scene
from .inertia import MassProperties, box_mass, join_bodies
from .parts import lowest
from .simulation import Simulation, measure_motion

_CHUNK = 0.1  # seconds between two looks
_SHAKE = 0.5
_DAMPING = 3.0
_SOFT = 0.3  # the friction's stiffness (impratio) while things find their places
_COARSE = 4e-3  # seconds, the time step meanwhile
_FIRM = 0.5  # seconds at most until everything holds with the scene's own settings
_STILL = np.array([2e-4, 2e-3])  # m/s, rad/s: a fifth of what the gate lets pass
_SLOW = 5 * _STILL  # the same with soft friction, which creeps some thirty times as fast


def settle(
    scene: Scene,
    seconds: float,
    minimum: float = 0.0,
    shake: float = 0.0,
    simulation: Simulation | None = None,
) -> tuple[Pose, ...]:
    """Simulate until everything rests, from ``minimum`` to ``seconds`` long; return the poses.

    Before that, gravity leans by ``shake`` (radians) to each of four sides in turn: a brush that
    stands free in a mug falls against its rim, where it stays. Free motion dies out at 3 per second
    meanwhile, so that round things stop, but for the last tenth of a second: what is returned holds
    by itself.

    What touches creeps, and faster with softer friction: for up to half of the time friction is
    soft, so that a heap of fruit comes in two seconds to where it would creep in a minute; then it
    is as it is in the scene. A tremble in place is no motion. Where the simulation breaks down, the
    scene's own poses are returned, for the gate to say at what. ``simulation`` is one of the scene
    at its own poses, if there is one already.
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
    """Simulate until in so many looks nothing has moved on faster than ``pace`` (m/s, rad/s)."""
    still, now = 0, simulation.states
    for k in range(max(1, round(seconds / _CHUNK))):
        before = now
        simulation.run(_CHUNK, _DAMPING)
        now = simulation.states
        still = still + 1 if (measure_motion(before, now) <= _CHUNK * pace).all() else 0
        if still >= looks and (k + 1) * _CHUNK >= minimum:
            return


def has_toppled(thing: Object, pose: Pose, limit: float) -> bool:
    """Whether an object set upright leans more than ``limit`` (radians) and is not as it was.

    A pencil that rolls onto its next side, or a die, keeps its height and has not toppled; what is
    taller than wide has, if it stands on its head.
    """
    up = quaternion_matrix(pose.quaternion)[2]
    if np.arccos(np.clip(up[2], -1.0, 1.0)) <= limit:
        return False
    points = np.concatenate([part.vertices for part in thing.parts])
    before, after = np.ptp(points[:, 2]), np.ptp(points @ up)
    on_head = up[2] < -0.5 and before > 1.2 * np.ptp(points[:, :2], axis=0).max()
    return bool(on_head or abs(after - before) > 0.25 * before)


_FOOT = 0.25, 0.75  # the least and the largest share of its weight that a thing has in its foot


def on_foot(thing: Object) -> Object:
    """Return the object with a flat box under it that has a share of its weight.

    The foot spans the object's box and is a thirtieth of its height, 2 mm at least. It has a
    quarter of the weight, or as much (up to three) as draws the whole's centre down to a third of
    the height; its own lies so that the whole's is over the middle, as far as the foot reaches.
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
