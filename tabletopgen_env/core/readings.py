"""What is read of n worlds after a step."""

from __future__ import annotations

from dataclasses import dataclass

from jaxtyping import Bool, Float

from .arrays import Array


@dataclass(frozen=True, eq=False)
class Readings:
    """The robot and the objects of n worlds, each in its own base frame (see ``world``).

    Rows of objects that a world has not may hold anything finite.

    Attributes:
        joints, joint_velocities: of the arm, rad and rad/s.
        opening: of the gripper, metres.
        servos: commands of the arm, rad.
        gripper: command of the gripper, 0 closed, 255 open.
        tool, hand: the tool centre point, and the rotation of the hand.
        positions, rotations: centres of the objects' boxes, metres, and their rotations.
        linear, angular: velocities of the objects, base frame (m/s) and body frame (rad/s).
        touched: whether the left finger, the right finger, any part of the robot touches the
            target of each goal; false where it is the tool.
    """

    joints: Float[Array, "n 7"]
    joint_velocities: Float[Array, "n 7"]
    opening: Float[Array, "n"]
    servos: Float[Array, "n 7"]
    gripper: Float[Array, "n"]
    tool: Float[Array, "n 3"]
    hand: Float[Array, "n 3 3"]
    positions: Float[Array, "n k 3"]
    rotations: Float[Array, "n k 3 3"]
    linear: Float[Array, "n k 3"]
    angular: Float[Array, "n k 3"]
    touched: Bool[Array, "n g 3"]
