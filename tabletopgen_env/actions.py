"""How a policy moves the robot: one small controller per action mode.

Both modes take ``float32`` actions in [-1, 1] at 20 Hz (25 simulation steps of 2 ms); values
beyond are clipped. The last entry is the gripper: -1 closed, +1 open (8 cm), in between in
proportion, as a position to go to.

========================  =====================================================================
``ee_delta`` (5 entries)  move the tool centre point by up to 25 mm along x, y and z of the
                          robot's base frame and turn the hand by up to 0.15 rad about the
                          vertical, per step; the hand keeps pointing down
``joint_delta`` (8)       turn joints 1 to 7 by up to 0.1 rad each, per step
========================  =====================================================================

Increments add to a *commanded* pose that starts at the robot's own and is never more than 4 cm
and 0.4 rad (``ee_delta``) or 0.2 rad (``joint_delta``) ahead of it, so pushing against the table
does not wind up. The servos' viscous lag is compensated: in free space the arm trails a moving
command by half an action (12 mm at full speed) and ends where it was sent to the millimetre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Protocol

import numpy as np
from gymnasium import spaces
from jaxtyping import Float

from generator.errors import InputError, choices
from generator.geometry import wrap

from .robot.franka import JOINTS
from .robot.kinematics import HOME, forward, ik_step
from .robot.panda import HOME_CTRL
from .world import World

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

ActionMode = Literal["ee_delta", "joint_delta"]

SUBSTEPS = 25
"""Simulation steps per action: 20 Hz at 2 ms."""

EE_STEP = 0.025
"""Largest move of the tool centre point per action and axis, metres."""

EE_TURN = 0.15
"""Largest turn of the hand about the vertical per action, radians."""

EE_LEASH = 0.04
"""How far the commanded point may be ahead of the real one, metres."""

YAW_LEASH = 0.4
"""How far the commanded yaw may be ahead of the real one, radians."""

JOINT_STEP = 0.1
"""Largest turn of each joint per action, radians."""

JOINT_LEASH = 0.2
"""How far a commanded joint may be ahead of the real one, radians."""

WORKSPACE: tuple[tuple[float, ...], ...] = ((-0.5, -0.8, -0.1), (0.85, 0.8, 0.7))
"""Lowest and highest commanded point in the base frame, metres."""

GRIPPER_CTRL = HOME_CTRL[-1]
"""The gripper command that opens it fully."""

SERVO_LEAD = 0.08
"""Seconds by which servo commands lead a moving reference.

A servo torque ``k (u - q) - d q'`` trails its command ``u`` by ``d / k`` = 0.1 s; leading by most
of that leaves it well damped.
"""

_PERIOD = 1 / 20
_JOINT_RATE = np.array([joint.velocity for joint in JOINTS]) * _PERIOD


class Controller(Protocol):
    """Turns actions into servo commands."""

    space: spaces.Box

    def reset(self, world: World) -> None:
        """Start from the robot's present pose."""
        ...

    def apply(self, world: World, action: Float[np.ndarray, "a"]) -> None:
        """Write the servo commands of one checked action to ``world.data.ctrl``."""
        ...


def controller(mode: str) -> Controller:
    """Return a controller for an action mode.

    Raises:
        InputError: no such mode.
    """
    if mode == "ee_delta":
        return EndEffectorDelta()
    if mode == "joint_delta":
        return JointDelta()
    raise InputError(
        f"Unknown action mode {mode!r}." + choices(str(mode), ["ee_delta", "joint_delta"])
    )


def checked(action: ArrayLike, space: spaces.Box) -> Float[np.ndarray, "a"]:
    """Return ``action`` as float64, clipped to ``space``.

    Raises:
        InputError: wrong shape, not numbers, or a NaN or infinity.
    """
    try:
        array = np.asarray(action, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"An action must be {space.shape[0]} numbers, got {action!r}.") from error
    if array.shape != space.shape:
        raise InputError(f"An action must have shape {space.shape}, got {array.shape}.")
    if not np.isfinite(array).all():
        raise InputError(f"An action must be finite, got {array.tolist()}.")
    return np.clip(array, space.low, space.high)


def _box(size: int) -> spaces.Box:
    return spaces.Box(-1.0, 1.0, (size,), np.float32)


class JointDelta:
    """Joint increments; see the module's table."""

    def __init__(self) -> None:
        self.space = _box(8)
        self._command = np.zeros(7)

    def reset(self, world: World) -> None:
        """Start from the robot's present joints."""
        self._command = world.data.qpos[world.arm_qpos].copy()

    def apply(self, world: World, action: Float[np.ndarray, "8"]) -> None:
        """Advance the commanded joints by ``action``."""
        real = world.data.qpos[world.arm_qpos]
        low, high = world.model.actuator_ctrlrange[world.actuators[:7]].T
        ahead = np.clip(self._command + JOINT_STEP * action[:7] - real, -JOINT_LEASH, JOINT_LEASH)
        before, self._command = self._command, np.clip(real + ahead, low, high)
        _command(world, before, self._command, action[7])


def _command(
    world: World,
    before: Float[np.ndarray, "7"],
    joints: Float[np.ndarray, "7"],
    gripper: float,
) -> None:
    """Write servo commands for a reference that moves from ``before`` to ``joints``."""
    lead = SERVO_LEAD / _PERIOD * (joints - before)
    low, high = world.model.actuator_ctrlrange[world.actuators[:7]].T
    world.data.ctrl[world.actuators[:7]] = np.clip(joints + lead, low, high)
    world.data.ctrl[world.actuators[7]] = GRIPPER_CTRL * (gripper + 1) / 2


class EndEffectorDelta:
    """Increments of the tool centre point and the hand's yaw; see the module's table.

    The commanded joints follow the commanded pose by damped least squares
    (``robot.kinematics.ik_step``), drawn towards the home posture where the arm is redundant, and
    never faster than the joints' rated speed.
    """

    def __init__(self) -> None:
        self.space = _box(5)
        self._joints = HOME.copy()
        self._point = np.zeros(3)
        self._yaw = 0.0

    def reset(self, world: World) -> None:
        """Start from the tool's present position and yaw."""
        self._joints = world.data.qpos[world.arm_qpos].copy()
        self._point, rotation = forward(self._joints)
        self._yaw = float(np.arctan2(rotation[1, 0], rotation[0, 0]))

    def apply(self, world: World, action: Float[np.ndarray, "5"]) -> None:
        """Advance the commanded pose by ``action`` and the commanded joints after it."""
        real = world.to_base(world.data.site_xpos[world.tcp])
        ahead = np.clip(self._point + EE_STEP * action[:3] - real, -EE_LEASH, EE_LEASH)
        self._point = np.clip(real + ahead, WORKSPACE[0], WORKSPACE[1])
        hand = world.base_rotation.T @ world.data.site_xmat[world.tcp].reshape(3, 3)
        turned = float(np.arctan2(hand[1, 0], hand[0, 0]))
        turn_ahead = wrap(self._yaw + EE_TURN * action[3] - turned)
        self._yaw = turned + float(np.clip(turn_ahead, -YAW_LEASH, YAW_LEASH))
        before = self._joints
        turn = ik_step(before, self._point, _pointing_down(self._yaw))[0] - before
        self._joints = before + turn / max(1.0, float((np.abs(turn) / _JOINT_RATE).max()))
        _command(world, before, self._joints, action[4])


def _pointing_down(yaw: float) -> Float[np.ndarray, "3 3"]:
    """Return the rotation of a hand that points straight down, its x axis at ``yaw``."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]])
