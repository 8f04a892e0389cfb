"""What a policy sees. Every space is the same for every scene.

All positions are metres in the *base frame* (see ``world``); rotations are the first two columns
of the rotation matrix (x axis, then y axis).

The flat state
--------------
Target and goal are those of the active goal (see ``tasks.task``). Where the tool itself is the
target (Reach), its entries 32 to 36 are zero and no slot is special.

======  =============================================================  ==========  ========
index   meaning                                                        range       unit
======  =============================================================  ==========  ========
0-6     arm joint positions                                            [-4, 4]     rad
7-13    arm joint velocities                                           [-10, 10]   rad/s
14      opening of the gripper                                         [0, 0.1]    m
15-17   tool centre point                                              [-3, 3]     m
18-23   rotation of the hand                                           [-1, 1]
24-30   commanded minus real arm joints                                [-4, 4]     rad
31      commanded opening: -1 closed, 1 open                           [-1, 1]
32-33   left, right finger touches the target                          {0, 1}
34-36   target minus tool centre point                                 [-3, 3]     m
37-39   table top: height, half length and half width of its outline   [-3, 3]     m
40-267  twelve object slots of 19 entries, see below; slot 0 is the target, slot 1 the object
        that carries the goal region if one does, the others by their distance from the target
        when its goal became active
268     an object carries the goal region                              {0, 1}
269-271 centre of the goal region                                      [-3, 3]     m
272-275 its semi-axes x', y', its yaw, its semi-axis z                 [-4, 4]     m, rad
276-278 centre of the goal region minus target                         [-3, 3]     m
279-286 with ``grasp_hint``: where to grasp the target or let go of it, see ``grasp_hint``
======  =============================================================  ==========  ========

An object slot: 0-2 centre of its box [m], 3-8 rotation, 9-11 half its extent [m], 12-14 linear
velocity [m/s, within 10], 15-17 angular velocity [rad/s, within 50], 18 mask (1 filled, 0 empty;
an empty slot is all zeros). Values beyond the range are clipped. Objects beyond the twelfth are
not shown.

The modes
---------
=====================  ========================================================================
``state``              the flat state (279 entries; 287 with the hint)
``goal``               a dict for hindsight replay: ``observation`` is the flat state without the
                       goal (entries 0-267, and the hint), ``achieved_goal`` and ``desired_goal``
                       are the task's goal vectors
``pixels``             a dict of pictures, see ``views``
``pixels+state``       the same with ``state``
``point_cloud``        a dict of points, see ``point_cloud``
``point_cloud+state``  the same with ``state``
=====================  ========================================================================
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.geometry import rotation_yaw, wrap

from ..goals.goal import Goal
from ..rendering.config import ObservationConfig
from ..rendering.point_cloud import point_cloud_spaces
from ..rendering.views import SLOTS, picture_spaces
from ..robot.kinematics import forward
from ..robot.panda import HOME_CTRL
from ..tasks.task import center
from ..world.world import World
from .grasp_hint import HINT_BOUNDS, misread

ROBOT_BOUNDS = np.array(
    [4.0] * 7 + [10.0] * 7 + [0.1] + [3.0] * 3 + [1.0] * 6 + [4.0] * 7 + [1.0] * 3 + [3.0] * 6
)
SLOT_BOUNDS = np.array([3.0] * 3 + [1.0] * 6 + [3.0] * 3 + [10.0] * 3 + [50.0] * 3 + [1.0])
GOAL_BOUNDS = np.array([1.0] + [3.0] * 3 + [4.0] * 4 + [3.0] * 3)
GOAL_VECTOR_BOUNDS = np.array([3.0] * 3 + [4.0] * 4 + [1.0])

_BARE_BOUNDS = np.concatenate([ROBOT_BOUNDS, np.tile(SLOT_BOUNDS, SLOTS)])
_GOAL_VECTORS = ("achieved_goal", "desired_goal")
_NONE = np.empty(0)
_BOUNDS = {  # of the flat state's entries, by whether there is a hint and whether the goal is out
    (hinted, bare): np.concatenate(
        [_BARE_BOUNDS, _NONE if bare else GOAL_BOUNDS, HINT_BOUNDS if hinted else _NONE]
    )
    for hinted in (False, True)
    for bare in (False, True)
}
for _constant in (ROBOT_BOUNDS, SLOT_BOUNDS, GOAL_BOUNDS, GOAL_VECTOR_BOUNDS, *_BOUNDS.values()):
    _constant.setflags(write=False)


def _box(bounds: Float[np.ndarray, "n"]) -> spaces.Box:
    high = bounds.astype(np.float32)
    return spaces.Box(-high, high, dtype=np.float32)


def observation_space(config: ObservationConfig, goals: int = 1) -> spaces.Space[Any]:
    """Return the space of an observation; ``goals`` is how many a goal vector has room for."""
    mode = config.mode
    state = _box(_BOUNDS[bool(config.grasp_hint), mode == "goal"])
    if mode == "state":
        return state
    if mode == "goal":
        vectors = {k: _box(np.tile(GOAL_VECTOR_BOUNDS, goals)) for k in _GOAL_VECTORS}
        return spaces.Dict({"observation": state, **vectors})
    pixels = mode.startswith("pixels")
    entries = picture_spaces(config) if pixels else point_cloud_spaces(config.points)
    return spaces.Dict({**entries, "state": state} if mode.endswith("+state") else entries)


def slot_order(world: World, goal: Goal) -> list[str]:
    """Return the objects in slot order: target, the goal's object, then the nearest, at most 12."""
    first = [name for name in (goal.target, goal.reference) if name is not None]
    middle = goal.region(world).center if goal.target is None else world.position(goal.target)
    rest = [name for name in world.names if name not in first and name not in world.absent]
    rest.sort(key=lambda name: (float(np.linalg.norm(world.position(name) - middle)), name))
    return (first + rest)[:SLOTS]


@dataclass(frozen=True, eq=False)
class Noise:
    """What is added to one reading of the state, but not to goals.

    ``joints`` (rad) are added to the arm's, and the tool's pose follows; ``positions`` (m) and
    ``turns`` (rotation vectors) are added to the objects by slot, base frame.
    """

    joints: Float[np.ndarray, "7"]
    positions: Float[np.ndarray, "slots 3"]
    turns: Float[np.ndarray, "slots 3"]


def robot_state(world: World, goal: Goal, noise: Noise | None = None) -> Float[np.ndarray, "40"]:
    """Return entries 0-39 of the flat state."""
    data = world.data
    joints = data.qpos[world.arm_qpos]
    tcp = world.to_base(data.site_xpos[world.tcp])
    hand = world.hand
    at = world.to_base(center(world, goal))
    if noise is not None:
        (point, turned), (there, seen) = forward(joints), forward(joints + noise.joints)
        tcp, hand = tcp + there - point, seen @ turned.T @ hand
        joints = joints + noise.joints
        at = tcp if goal.target is None else at + noise.positions[0]
    command = data.ctrl[world.actuators]
    left, right, _ = (False,) * 3 if goal.target is None else world.touches(goal.target)
    state = np.empty(len(ROBOT_BOUNDS))
    state[0:7] = joints
    state[7:14] = data.qvel[world.arm_dof]
    state[14] = sum(data.qpos[world.finger_qpos].tolist())
    state[15:18] = tcp
    state[18:21], state[21:24] = hand[:, 0], hand[:, 1]
    state[24:31] = command[:7] - joints
    state[31:34] = 2 * command[7] / HOME_CTRL[7] - 1, left, right
    state[34:37] = at - tcp
    state[37] = world.scene.table.height - world.base_position[2]
    state[38:40] = world.half_top
    return state


def object_slots(
    world: World, order: list[str], noise: Noise | None = None
) -> Float[np.ndarray, "slots 19"]:
    """Return the object slots of the flat state for objects in ``order``."""
    rows = np.array([world.index(name) for name in order], int)
    bodies = world.bodies[rows]
    rotation = world.base_rotation.T @ world.data.xmat[bodies].reshape(-1, 3, 3)
    speed = world.velocities()[rows]
    spin = np.einsum("kij,kj->ki", rotation, speed[:, 3:])
    position = world.to_base(world.data.xpos[bodies])
    if noise is not None:
        position = position + noise.positions[: len(rows)]
        rotation = Rotation.from_rotvec(noise.turns[: len(rows)]).as_matrix() @ rotation
    slots = np.zeros((SLOTS, 19))
    filled = slots[: len(rows)]
    filled[:, 0:3] = position
    filled[:, 3:9] = rotation[:, :, :2].transpose(0, 2, 1).reshape(-1, 6)
    filled[:, 9:12] = world.half_extent[rows]
    filled[:, 12:15] = speed[:, :3] @ world.base_rotation
    filled[:, 15:18] = spin
    filled[:, 18] = 1.0
    return slots


def flat_state(
    world: World,
    order: list[str],
    goal: Goal,
    bare: bool = False,
    noise: Noise | None = None,
    hint: Float[np.ndarray, "8"] | None = None,
) -> Float[np.ndarray, "n"]:
    """Return the flat state, objects in the slots' ``order``, the target first.

    ``bare`` leaves out all but entries 0-267; ``noise`` is that of this reading, None none;
    ``hint`` the entries of ``grasp_hint``, the last ones.
    """
    bounds = _BOUNDS[hint is not None, bare]
    robot, slots = robot_state(world, goal, noise), object_slots(world, order, noise)
    state = np.empty(len(bounds))
    state[: len(robot)] = robot
    state[len(robot) : len(_BARE_BOUNDS)] = slots.ravel()
    if not bare:
        region = goal.region(world)
        middle = world.to_base(region.center)
        shown = state[len(_BARE_BOUNDS) :]
        shown[0] = goal.reference is not None
        shown[1:4] = middle
        shown[4:6] = region.semi[:2]
        shown[6:8] = region.yaw - world.mount.yaw, region.semi[2]
        shown[8:11] = middle - (robot[15:18] if goal.target is None else slots[0, :3])
    if hint is not None:
        state[-len(hint) :] = hint
        if noise is not None:
            tool = robot[15:18] - world.to_base(world.data.site_xpos[world.tcp])
            yaw = wrap(float(np.arctan2(robot[19], robot[18])) - rotation_yaw(world.hand))
            state[-len(hint) :] = misread(hint, noise.positions[0], tool, yaw)
    np.minimum(np.maximum(state, -bounds, out=state), bounds, out=state)
    return state.astype(np.float32)
