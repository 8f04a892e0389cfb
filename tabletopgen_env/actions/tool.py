"""Action modes for the tool centre point; see the table in the package docstring."""

from __future__ import annotations

import math

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.geometry import rotation_yaw, wrap

from ..robot.franka import JOINTS
from ..robot.kinematics import HOME, forward, ik_step, pointing_down, rotation_vector
from ..world.world import World
from .servos import Servos, box

EE_STEP = 0.025
"""Largest motion of the tool centre point per action and axis at 20 Hz, in metres."""

EE_TURN = 0.15
"""Largest rotation of the hand per action and axis at 20 Hz, in radians."""

EE_LEASH = 0.04
"""Maximum lead of the commanded point over the measured one, in metres."""

YAW_LEASH = 0.4
"""Maximum lead of the commanded yaw or rotation over the measured one, in radians."""

WORKSPACE: tuple[tuple[float, ...], ...] = ((-0.5, -0.8, -0.1), (0.85, 0.8, 0.7))
"""Lower and upper bounds of the commanded point in the base frame, in metres."""

YAW_REACH = np.pi / 2
"""Largest target yaw of ``ToolAbsolute``, in radians."""

LOWEST_POINT, HIGHEST_POINT = np.array(WORKSPACE)
"""Bounds of ``WORKSPACE`` as arrays."""

JOINT_SPEED = np.array([joint.velocity for joint in JOINTS])
"""Rated speeds of the joints, in rad/s."""

PULL = 0.05
"""Weight that pulls the joints towards home, per action at 20 Hz; see ``kinematics.ik_step``."""

for _constant in (LOWEST_POINT, HIGHEST_POINT, JOINT_SPEED):
    _constant.setflags(write=False)


def _clip(
    values: Float[np.ndarray, "n"], low: Float[np.ndarray, "n"], high: Float[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Compute ``np.clip(values, low, high)`` in half the time."""
    return np.minimum(np.maximum(values, low), high)


class Arm:
    """A commanded position of the tool centre point, and the joint positions that follow it.

    The joints follow by damped least squares (``robot.kinematics.ik_step``). The redundant degree
    of freedom is pulled towards home, and no joint exceeds its rated speed.
    """

    def __init__(self, servos: Servos) -> None:
        self.point = np.zeros(3)
        self._servos = servos
        self._most = JOINT_SPEED * servos.period
        self._leash = np.full(3, EE_LEASH * servos.slack)
        self._joints = HOME.copy()

    def reset(self, world: World) -> Float[np.ndarray, "3 3"]:
        """Start from the robot's current pose and return the rotation of the tool."""
        self._joints = world.state.joints.copy()
        self.point, rotation = forward(self._joints)
        return rotation

    def move(self, world: World, action: Float[np.ndarray, "3"]) -> None:
        """Advance the commanded point by the x, y and z entries of an action."""
        real = world.to_base(world.state.tool)
        ahead = self.point + EE_STEP * self._servos.share * action - real
        near = real + _clip(ahead, -self._leash, self._leash)
        self.point = _clip(near, LOWEST_POINT, HIGHEST_POINT)

    def follow(self, world: World, rotation: Float[np.ndarray, "3 3"], gripper: float) -> None:
        """Command joint positions that track the commanded point and ``rotation``."""
        before, joints = self._joints, self._joints
        pull = PULL * min(1.0, self._servos.share)
        for _ in range(math.ceil(self._servos.slack)):
            joints = ik_step(joints, self.point, rotation, pull=pull)[0]
        turn = joints - before
        excess = max(map(abs, (turn / self._most).tolist()))
        self._joints = joints if excess <= 1 else before + turn / excess
        self._servos.command(world, before, self._joints, gripper)


class ToolDelta:
    """Action mode "ee_delta": increments of the tool centre point and of the hand's yaw."""

    size = 5  # entries of an action

    def __init__(self, servos: Servos) -> None:
        self.space = box(self.size)
        self.servos = servos
        self.arm = Arm(servos)
        self.yaw = 0.0

    def reset(self, world: World) -> None:
        """Start from the tool's current position and yaw."""
        self.yaw = rotation_yaw(self.arm.reset(world))

    def apply(self, world: World, action: Float[np.ndarray, "5"]) -> None:
        """Advance the commanded pose by ``action`` and make the commanded joints follow it."""
        self.arm.move(world, action[:3])
        real, leash = rotation_yaw(world.hand), YAW_LEASH * self.servos.slack
        ahead = wrap(self.yaw + EE_TURN * self.servos.share * action[3] - real)
        self.yaw = real + min(max(ahead, -leash), leash)
        self.arm.follow(world, pointing_down(self.yaw), action[4])


class ToolDeltaPosition(ToolDelta):
    """Action mode "ee_delta_pos": increments of the tool centre point only."""

    size = 4

    def apply(self, world: World, action: Float[np.ndarray, "4"]) -> None:
        """Advance the commanded point by ``action``."""
        super().apply(world, np.array([*action[:3], 0.0, action[3]]))


class ToolDelta6D:
    """Action mode "ee_delta_6d": increments of the tool centre point and of the hand's rotation."""

    def __init__(self, servos: Servos) -> None:
        self.space = box(7)
        self.servos = servos
        self._arm = Arm(servos)
        self._rotation = np.eye(3)

    def reset(self, world: World) -> None:
        """Start from the tool's current pose."""
        self._rotation = self._arm.reset(world)

    def apply(self, world: World, action: Float[np.ndarray, "7"]) -> None:
        """Advance the commanded pose by ``action`` and make the commanded joints follow it."""
        self._arm.move(world, action[:3])
        real, leash = world.hand, YAW_LEASH * self.servos.slack
        turn = Rotation.from_rotvec(EE_TURN * self.servos.share * action[3:6]).as_matrix()
        ahead = rotation_vector(turn @ self._rotation @ real.T)
        ahead *= min(1.0, leash / max(float(np.linalg.norm(ahead)), 1e-9))
        self._rotation = Rotation.from_rotvec(ahead).as_matrix() @ real
        self._arm.follow(world, self._rotation, action[6])


class ToolAbsolute(ToolDelta):
    """Action mode "ee_absolute": a target pose for the tool, with the hand pointing down."""

    def apply(self, world: World, action: Float[np.ndarray, "5"]) -> None:
        """Advance the commanded pose towards the target in ``action``.

        The hand turns through yaw 0, never through yaw pi, which joint 7 cannot cross.
        """
        move = LOWEST_POINT + (action[:3] + 1) / 2 * (HIGHEST_POINT - LOWEST_POINT) - self.arm.point
        move /= max(EE_STEP * self.servos.share, float(np.linalg.norm(move)))
        turn = (YAW_REACH * action[3] - self.yaw) / (EE_TURN * self.servos.share)
        super().apply(world, np.array([*move, np.clip(turn, -1.0, 1.0), action[4]]))
