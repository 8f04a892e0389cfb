"""Action modes in joint space; see the table in the package docstring."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from ..robot.kinematics import LOWER, UPPER
from ..world.world import World
from .servos import Servos, box

JOINT_STEP = 0.1
"""Largest rotation of each joint per action at 20 Hz, in radians."""

JOINT_LEASH = 0.2
"""Maximum lead of a commanded joint over the measured one, in radians."""


class JointDelta:
    """Action mode "joint_delta": increments of the joint positions."""

    def __init__(self, servos: Servos) -> None:
        self.space = box(8)
        self.servos = servos
        self.command = np.zeros(7)

    def reset(self, world: World) -> None:
        """Start from the robot's current joint positions."""
        self.command = world.state.joints.copy()

    def apply(self, world: World, action: Float[np.ndarray, "8"]) -> None:
        """Advance the commanded joint positions by ``action``."""
        real = world.state.joints
        leash = JOINT_LEASH * self.servos.slack
        wanted = self.command + JOINT_STEP * self.servos.share * action[:7]
        before = self.command
        self.command = np.clip(real + np.clip(wanted - real, -leash, leash), LOWER, UPPER)
        self.servos.command(world, before, self.command, action[7])


class JointTarget(JointDelta):
    """Action mode "joint_target": target joint positions, scaled to the joint ranges."""

    def apply(self, world: World, action: Float[np.ndarray, "8"]) -> None:
        """Advance the commanded joint positions towards the target in ``action``."""
        left = LOWER + (action[:7] + 1) / 2 * (UPPER - LOWER) - self.command
        step = np.clip(left / (JOINT_STEP * self.servos.share), -1.0, 1.0)
        super().apply(world, np.array([*step, action[7]]))
