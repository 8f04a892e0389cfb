"""Readings of worlds that MuJoCo simulates one by one."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..goals.goal import Goal
from ..world.world import World
from .readings import Readings


class WorldRows:
    """Copies the states of n worlds into rows, and carries all of them into their base frames.

    Args:
        worlds: how many rows.
        objects: the most objects of a world.
        goals: the most goals of an episode.
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
        """Copy what a world's state is now; ``goals`` are those of its episode."""
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
        """Return the readings of all rows; those without an object hold anything finite."""
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
