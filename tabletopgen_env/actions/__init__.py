"""Action modes: one controller class per mode.

All modes take ``float32`` actions in [-1, 1] at 20 Hz (25 simulation steps of 2 ms) or at
``control_hz``; values outside that range are clipped. The last entry controls the gripper.

======================  =======================================================================
``ee_delta`` (5)        move the tool centre point by up to 25 mm along x, y and z of the robot's
                        base frame and turn the hand by up to 0.15 rad about the vertical, per
                        step; the hand keeps pointing down
``ee_delta_pos`` (4)    x, y and z as above; the hand keeps pointing down and keeps its yaw
``ee_delta_6d`` (7)     x, y and z as above, then a rotation vector about the axes of the base
                        frame, up to 0.15 rad per entry and step; the hand may tilt
``ee_absolute`` (5)     target of the tool centre point: x, y and z over ``WORKSPACE`` of
                        the base frame, yaw over [-pi/2, pi/2] (a two-finger hand needs no more).
                        The commanded pose moves there in a straight line, by up to 25 mm and 0.15
                        rad per step; the hand keeps pointing down
``joint_delta`` (8)     turn joints 1 to 7 by up to 0.1 rad each, per step
``joint_target`` (8)    target positions of joints 1 to 7, each over its range; the commanded
                        joints move there by up to 0.1 rad per step
======================  =======================================================================

========================  =====================================================================
gripper ``"continuous"``  position: -1 is closed, +1 is open (8 cm), linear in between
gripper ``"binary"``      values of at least 0 open the gripper fully, others close it
========================  =====================================================================

The amounts per step apply at 20 Hz; at other rates they are scaled to keep the speeds at 0.5 m/s, 3
rad/s and 2 rad/s.

Increments add to a *commanded* pose, which starts at the robot's pose and is never more than 4 cm
and 0.4 rad (``ee_…``) or 0.2 rad (``joint_…``) ahead of it (proportionally more below 20 Hz), so
pushing against the table causes no windup. The servos' viscous lag is compensated: in free space
the arm trails a moving command by half an action (12 mm at full speed) and reaches its target to
within a millimetre.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from generator.errors import require_known

from .joints import JOINT_LEASH, JOINT_STEP, JointDelta, JointTarget
from .servos import CONTROL_HZ, Controller, GripperMode, Servos, check_action
from .tool import (
    EE_LEASH,
    EE_STEP,
    EE_TURN,
    WORKSPACE,
    YAW_LEASH,
    ToolAbsolute,
    ToolDelta,
    ToolDelta6D,
    ToolDeltaPosition,
)

__all__ = [
    "ACTIONS",
    "CONTROL_HZ",
    "EE_LEASH",
    "EE_STEP",
    "EE_TURN",
    "JOINT_LEASH",
    "JOINT_STEP",
    "WORKSPACE",
    "YAW_LEASH",
    "ActionConfig",
    "ActionMode",
    "Controller",
    "GripperMode",
    "Servos",
    "check_action",
]

ActionMode = Literal[
    "ee_delta", "ee_delta_pos", "ee_delta_6d", "ee_absolute", "joint_delta", "joint_target"
]

ACTIONS: Mapping[ActionMode, Callable[[Servos], Controller]] = MappingProxyType(
    {
        "ee_delta": ToolDelta,
        "ee_delta_pos": ToolDeltaPosition,
        "ee_delta_6d": ToolDelta6D,
        "ee_absolute": ToolAbsolute,
        "joint_delta": JointDelta,
        "joint_target": JointTarget,
    }
)
"""The controller class of each action mode."""


@dataclass(frozen=True)
class ActionConfig:
    """Settings of the action space.

    Args:
        mode: "ee_delta", "ee_delta_pos", "ee_delta_6d", "ee_absolute", "joint_delta" or
            "joint_target"; see the table in the module docstring.
        gripper: "continuous" or "binary": interpretation of the last entry of an action.
        control_hz: actions per second; divides 500.

    Raises:
        InputError: the mode or gripper is unknown, or the rate does not divide 500.
    """

    mode: ActionMode = "ee_delta"
    gripper: GripperMode = Servos.gripper
    control_hz: int = Servos.hz

    def __post_init__(self) -> None:
        require_known(self.mode, ACTIONS, "Unknown action mode")
        Servos(self.control_hz, self.gripper)

    def controller(self) -> Controller:
        """Return a new controller for the configured action mode."""
        return ACTIONS[self.mode](Servos(self.control_hz, self.gripper))
