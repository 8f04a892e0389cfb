"""What MuJoCo's data holds of the robot and the objects, as live views."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int


@dataclass(frozen=True, eq=False)
class WorldState:
    """Views of one world's ``data``: they follow it, and what is written to them is written there.

    Positions (m) and rotations (to the world frame) are of the last substep's beginning, as
    MuJoCo leaves them; joints, velocities and commands are of its end.

    Attributes:
        joints, joint_velocities: of the arm, rad and rad/s.
        fingers, finger_velocities: of the two slides, m and m/s.
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
    """Return addresses, which follow one another as MuJoCo lays them out, as a slice."""
    if not len(addresses):
        return slice(0, 0)
    first, last = int(addresses[0]), int(addresses[-1])
    assert (np.diff(addresses) == 1).all(), "MuJoCo keeps what was added together together"
    return slice(first, last + 1)
