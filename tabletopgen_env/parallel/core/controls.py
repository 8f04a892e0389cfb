"""The action modes of n robots; see ``actions`` for their definitions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Bool, Float

from ...actions import JOINT_LEASH, JOINT_STEP, ActionMode, Servos
from ...actions.servos import GRIPPER_CTRL, SERVO_LEAD
from ...actions.tool import (
    EE_LEASH,
    EE_STEP,
    EE_TURN,
    HIGHEST_POINT,
    JOINT_SPEED,
    LOWEST_POINT,
    PULL,
    YAW_LEASH,
    YAW_REACH,
)
from ...robot.kinematics import LOWER, UPPER
from .arms import arms_at, ik_steps, rotation_vectors, rotations_of
from .arrays import Array, like, namespace, squares, wrap, yaw_of


@dataclass(frozen=True, eq=False)
class Commands:
    """The commands of n robots.

    Attributes:
        joints: arm joints, rad.
        point: target positions of the tool centre points, base frame, metres.
        yaw: target yaw of the hands, rad.
        hand: target rotations of the hands, for modes in which they can tilt.
    """

    joints: Float[Array, "n 7"]
    point: Float[Array, "n 3"]
    yaw: Float[Array, "n"]
    hand: Float[Array, "n 3 3"]


@dataclass(frozen=True, eq=False)
class RobotPose:
    """The poses of n robots: joints (rad), tool centre point (m) and the hand's rotation."""

    joints: Float[Array, "n 7"]
    tool: Float[Array, "n 3"]
    hand: Float[Array, "n 3 3"]


def start_commands(joints: Float[Array, "n 7"]) -> Commands:
    """Return commands that hold the robots at the joint angles ``joints``."""
    arms = arms_at(joints)
    return Commands(joints, arms.tool, yaw_of(arms.hand), arms.hand)


def restart(commands: Commands, joints: Float[Array, "n 7"], rows: Bool[Array, "n"]) -> Commands:
    """Return the commands, with those in the masked ``rows`` reset to hold ``joints``."""
    fresh, xp = start_commands(joints), namespace(joints)

    def pick(new: Array, old: Array) -> Array:
        return xp.where(xp.reshape(rows, (-1, *[1] * (new.ndim - 1))), new, old)

    return Commands(**{name: pick(new, getattr(commands, name))
                       for name, new in vars(fresh).items()})  # fmt: skip


def advance(
    mode: ActionMode,
    servos: Servos,
    before: Commands,
    pose: RobotPose,
    actions: Float[Array, "n a"],
) -> tuple[Commands, Float[Array, "n 8"]]:
    """Apply ``actions`` in [-1, 1]; return the new commands and the servo commands.

    Servo commands are joints (rad) and the gripper's 0 to 255, as written by ``Servos.command``.
    """
    xp = namespace(actions)
    after = _MODES[mode](servos, before, pose, actions)
    lead = SERVO_LEAD / servos.period * (after.joints - before.joints)
    low, high = (like(bound, actions) for bound in (LOWER, UPPER))
    arm = xp.minimum(xp.maximum(after.joints + lead, low), high)
    gripper = actions[:, -1:]
    if servos.gripper == "binary":
        gripper = xp.where(gripper >= 0, xp.ones_like(gripper), -xp.ones_like(gripper))
    return after, xp.concat([arm, GRIPPER_CTRL * (gripper + 1) / 2], axis=-1)


def _move(servos: Servos, before: Commands, pose: RobotPose, action: Array) -> Commands:
    """Move the commanded points by the x, y and z entries of actions."""
    xp = namespace(action)
    leash = EE_LEASH * servos.slack
    ahead = before.point + EE_STEP * servos.share * action - pose.tool
    near = pose.tool + xp.clip(ahead, -leash, leash)
    low, high = (like(np.asarray(bound), action) for bound in (LOWEST_POINT, HIGHEST_POINT))
    return replace(before, point=xp.minimum(xp.maximum(near, low), high))


def _follow(servos: Servos, commands: Commands, rotation: Array) -> Commands:
    """Return commands whose joints follow the commanded points and ``rotation``."""
    xp = namespace(rotation)
    before, joints = commands.joints, commands.joints
    pull = PULL * min(1.0, servos.share)
    for _ in range(math.ceil(servos.slack)):
        joints = ik_steps(joints, commands.point, rotation, pull)
    turn = joints - before
    excess = xp.max(xp.abs(turn) / like(JOINT_SPEED * servos.period, turn), axis=-1)
    return replace(commands, joints=before + turn / xp.clip(excess, min=1.0)[:, None])


def _delta(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    moved = _move(servos, before, pose, actions[:, :3])
    real, leash = yaw_of(pose.hand), YAW_LEASH * servos.slack
    ahead = wrap(before.yaw + EE_TURN * servos.share * actions[:, 3] - real)
    yaw = real + xp.clip(ahead, -leash, leash)
    c, s, zero = xp.cos(yaw), xp.sin(yaw), xp.zeros_like(yaw)
    down = xp.stack([c, s, zero, s, -c, zero, zero, zero, zero - 1], axis=-1)
    return _follow(servos, replace(moved, yaw=yaw), xp.reshape(down, (-1, 3, 3)))


def _delta_position(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    still = xp.zeros_like(actions[:, :1])
    return _delta(servos, before, pose, xp.concat([actions[:, :3], still, actions[:, 3:]], axis=-1))


def _delta_6d(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    moved = _move(servos, before, pose, actions[:, :3])
    turn = rotations_of(EE_TURN * servos.share * actions[:, 3:6])
    ahead = rotation_vectors(turn @ before.hand @ xp.matrix_transpose(pose.hand))
    leash = YAW_LEASH * servos.slack
    ahead = ahead * xp.clip(leash / xp.clip(xp.sqrt(squares(ahead)), min=1e-9), max=1.0)[:, None]
    hand = rotations_of(ahead) @ pose.hand
    return _follow(servos, replace(moved, hand=hand), hand)


def _absolute(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    low, high = (like(np.asarray(bound), actions) for bound in (LOWEST_POINT, HIGHEST_POINT))
    move = low + (actions[:, :3] + 1) / 2 * (high - low) - before.point
    move = move / xp.clip(xp.sqrt(squares(move)), min=EE_STEP * servos.share)[:, None]
    turn = (YAW_REACH * actions[:, 3] - before.yaw) / (EE_TURN * servos.share)
    turn = xp.clip(turn, -1.0, 1.0)[:, None]
    return _delta(servos, before, pose, xp.concat([move, turn, actions[:, 4:]], axis=-1))


def _joint_delta(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    leash = JOINT_LEASH * servos.slack
    wanted = before.joints + JOINT_STEP * servos.share * actions[:, :7]
    near = pose.joints + xp.clip(wanted - pose.joints, -leash, leash)
    low, high = (like(bound, actions) for bound in (LOWER, UPPER))
    return replace(before, joints=xp.minimum(xp.maximum(near, low), high))


def _joint_target(servos: Servos, before: Commands, pose: RobotPose, actions: Array) -> Commands:
    xp = namespace(actions)
    low, high = (like(bound, actions) for bound in (LOWER, UPPER))
    left = low + (actions[:, :7] + 1) / 2 * (high - low) - before.joints
    return _joint_delta(
        servos, before, pose, xp.clip(left / (JOINT_STEP * servos.share), -1.0, 1.0)
    )


_MODES: Mapping[ActionMode, Callable[[Servos, Commands, RobotPose, Array], Commands]] = (
    MappingProxyType(
        {
            "ee_delta": _delta,
            "ee_delta_pos": _delta_position,
            "ee_delta_6d": _delta_6d,
            "ee_absolute": _absolute,
            "joint_delta": _joint_delta,
            "joint_target": _joint_target,
        }
    )
)
