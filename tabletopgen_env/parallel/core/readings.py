"""Readings of n worlds after a step, collected from their MuJoCo data."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from ...goals.goal import Goal
from ...world.world import World
from .arrays import Array


class WorldRows:
    """The states of n worlds, copied into rows and transformed to the worlds' base frames.

    Args:
        worlds: number of rows.
        objects: maximum number of objects per world.
        goals: maximum number of goals per episode.
    """

    def __init__(self, worlds: int, objects: int, goals: int) -> None:
        several = (worlds, objects)
        self._joints, self._joint_velocities = np.zeros((worlds, 7)), np.zeros((worlds, 7))
        self._fingers, self._commands = np.zeros((worlds, 2)), np.zeros((worlds, 8))
        self._tool, self._hand = np.zeros((worlds, 3)), np.tile(np.eye(3), (worlds, 1, 1))
        self._positions = np.zeros((*several, 3))
        self._rotations = np.tile(np.eye(3), (*several, 1, 1))
        self._velocities = np.zeros((*several, 6))
        self._touched = np.zeros((worlds, goals, 3), bool)
        self._base, self._turn = np.zeros((worlds, 3)), np.tile(np.eye(3), (worlds, 1, 1))

    def copy(self, row: int, world: World, goals: Sequence[Goal]) -> None:
        """Copy a world's current state to a row; ``goals`` are the goals of its episode."""
        state, count = world.state, len(world.names)
        self._joints[row] = state.joints
        self._joint_velocities[row] = state.joint_velocities
        self._fingers[row] = state.fingers
        self._commands[row, :7] = state.servos
        self._commands[row, 7] = state.gripper[0]
        self._tool[row], self._hand[row] = state.tool, state.hand
        self._positions[row, :count] = state.positions
        self._rotations[row, :count] = state.rotations
        self._velocities[row, :count] = state.velocities
        self._base[row], self._turn[row] = world.base_position, world.base_rotation
        for k, goal in enumerate(goals):
            self._touched[row, k] = goal.target is not None and world.touches(goal.target)

    def read(self) -> Readings:
        """Return the readings of all rows; rows without an object hold arbitrary finite values."""
        turn, back = self._turn, self._turn.transpose(0, 2, 1)
        return Readings(
            joints=self._joints.copy(),
            joint_velocities=self._joint_velocities.copy(),
            opening=self._fingers.sum(1),
            servos=self._commands[:, :7].copy(),
            gripper=self._commands[:, 7].copy(),
            tool=((self._tool - self._base)[:, None] @ turn)[:, 0],
            hand=back @ self._hand,
            positions=(self._positions - self._base[:, None]) @ turn,
            rotations=back[:, None] @ self._rotations,
            linear=self._velocities[..., :3] @ turn,
            angular=self._velocities[..., 3:].copy(),
            touched=self._touched.copy(),
        )


@dataclass(frozen=True, eq=False)
class Readings:
    """The robots and objects of n worlds, in the base frame of each world (see ``world``).

    Rows without an object may hold arbitrary finite values.

    Attributes:
        joints, joint_velocities: of the arm, rad and rad/s.
        opening: opening of the gripper, metres.
        servos: commands of the arm, rad.
        gripper: command of the gripper, 0 closed, 255 open.
        tool, hand: the tool centre point, and the rotation of the hand.
        positions, rotations: centres of the objects' boxes, metres, and their rotations.
        linear, angular: velocities of the objects, base frame (m/s) and body frame (rad/s).
        touched: whether the left finger, the right finger, or any part of the robot touches the
            target of each goal; false if the target is the tool.
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
