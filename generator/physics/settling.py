"""Letting a scene come to rest under gravity."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from ..geometry import quaternion_matrix
from ..scene import Pose, Scene
from .simulation import Simulation

_CHUNK = 0.1
_DAMPING = 3.0
_STILL = np.array([2e-3, 2e-2])  # m/s, rad/s


def settle(scene: Scene, seconds: float) -> tuple[Pose, ...]:
    """Simulate until everything rests, ``seconds`` at most; return the poses.

    Free motion dies out at 3 per second meanwhile, so that round things stop. It then runs without
    that for a tenth of a second: what is returned holds by itself.
    """
    simulation = Simulation(scene)
    simulation.place([o.pose for o in scene.objects])
    still = 0
    for _ in range(max(1, round(seconds / _CHUNK))):
        simulation.run(_CHUNK, _DAMPING)
        calm = bool((simulation.speeds() < _STILL).all())
        still = still + 1 if calm else 0
        if still >= 3:
            break
    simulation.run(_CHUNK)
    return simulation.poses


def leaning(poses: Sequence[Pose]) -> Float[np.ndarray, "n"]:
    """Return the angle between each object's own z axis and the vertical, radians."""
    up = [quaternion_matrix(p.quaternion)[2, 2] for p in poses]
    return np.arccos(np.clip(up, -1.0, 1.0)) if up else np.zeros(0)
