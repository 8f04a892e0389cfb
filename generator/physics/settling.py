"""Letting a scene come to rest under gravity."""

from __future__ import annotations

import numpy as np

from ..geometry import quaternion_matrix
from ..scene import Object, Pose, Scene
from .simulation import Simulation

_CHUNK = 0.1
_SHAKE = 0.5
_DAMPING = 3.0
_STILL = np.array([2e-4, 2e-3])  # m/s, rad/s: a twentieth of what the gate lets pass


def settle(
    scene: Scene, seconds: float, minimum: float = 0.0, shake: float = 0.0
) -> tuple[Pose, ...]:
    """Simulate until everything rests, from ``minimum`` to ``seconds`` long; return the poses.

    Before that, gravity leans by ``shake`` (radians) to each of four sides in turn: a brush that
    stands free in a mug falls against its rim, where it stays. Free motion dies out at 3 per second
    meanwhile, so that round things stop, but for the last tenth of a second: what is returned holds
    by itself. Where the simulation breaks down, the scene's own poses are returned, for the gate to
    say at what.
    """
    simulation = Simulation(scene)
    for side in range(4 if shake else 0):
        with simulation.conditions(shake, side * np.pi / 2, simulation.model.opt.timestep):
            simulation.run(_SHAKE)
    still = 0
    for k in range(max(1, round(seconds / _CHUNK))):
        simulation.run(_CHUNK, _DAMPING)
        still = still + 1 if (simulation.speeds() < _STILL).all() else 0
        if still >= 3 and (k + 1) * _CHUNK >= minimum:
            break
    simulation.run(_CHUNK)
    return tuple(o.pose for o in scene.objects) if simulation.diverged else simulation.poses


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
