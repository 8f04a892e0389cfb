"""Live views of the robot and the objects in MuJoCo's data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int


@dataclass(frozen=True, eq=False)
class WorldState:
    """Writable live views of one world's ``data``.

    Positions (m) and rotations (to the world frame) refer to the start of the last substep, as in
    MuJoCo; joints, velocities and commands to its end.

    Attributes:
        joints, joint_velocities: joints of the arm, rad and rad/s.
        fingers, finger_velocities: the two finger slides, m and m/s.
        servos: the commands of the arm, rad.
        gripper: the command of the gripper, 0 closed, 255 open.
        tool, hand: position of the tool centre point, rotation of the hand.
        positions, rotations: centres of the objects' boxes, and their rotations.
        velocities: the objects' linear (world frame) and angular (body frame) velocities.
    """

    joints: Float[np.ndarray, "7"]
    joint_velocities: Float[np.ndarray, "7"]
    fingers: Float[np.ndarray, "2"]
    finger_velocities: Float[np.ndarray, "2"]
    servos: Float[np.ndarray, "7"]
    gripper: Float[np.ndarray, "1"]
    tool: Float[np.ndarray, "3"]
    hand: Float[np.ndarray, "3 3"]
    positions: Float[np.ndarray, "k 3"]
    rotations: Float[np.ndarray, "k 3 3"]
    velocities: Float[np.ndarray, "k 6"]


def span(addresses: Int[np.ndarray, "n"]) -> slice:
    """Return consecutive MuJoCo addresses as a slice."""
    if not len(addresses):
        return slice(0, 0)
    first, last = int(addresses[0]), int(addresses[-1])
    assert (np.diff(addresses) == 1).all(), "MuJoCo addresses of one group must be consecutive"
    return slice(first, last + 1)
