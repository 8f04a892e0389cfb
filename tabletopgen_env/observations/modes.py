"""Observation modes and their spaces. Every space is the same for all scenes.

All positions are metres in the *base frame* (see ``world``); rotations are the first two columns
of the rotation matrix (x axis, then y axis).

The flat state
--------------
Target and goal are those of the active goal (see ``tasks.task``). If the tool itself is the target
(Reach), entries 32 to 36 are zero and no slot is special.

======  =============================================================  ==========  ========
index   meaning                                                        range       unit
======  =============================================================  ==========  ========
0-6     arm joint positions                                            [-4, 4]     rad
7-13    arm joint velocities                                           [-10, 10]   rad/s
14      opening of the gripper                                         [0, 0.1]    m
15-17   tool centre point                                              [-3, 3]     m
18-23   rotation of the hand                                           [-1, 1]
24-30   commanded minus measured arm joints                            [-4, 4]     rad
31      commanded opening: -1 closed, 1 open                           [-1, 1]
32-33   left, right finger touches the target                          {0, 1}
34-36   target minus tool centre point                                 [-3, 3]     m
37-39   table top: height, half length and half width of its outline   [-3, 3]     m
40-267  twelve object slots of 19 entries, see below; slot 0 is the
        target, slot 1 the object that carries the goal region, if
        any; the others are sorted by distance from the target at
        the activation of its goal
268     an object carries the goal region                              {0, 1}
269-271 centre of the goal region                                      [-3, 3]     m
272-275 its semi-axes x', y', its yaw, its semi-axis z                 [-4, 4]     m, rad
276-278 centre of the goal region minus target                         [-3, 3]     m
279-286 with ``grasp_hint``: where to grasp or release the target
======  =============================================================  ==========  ========

An object slot: 0-2 centre of its box [m], 3-8 rotation, 9-11 half its extent [m], 12-14 linear
velocity [m/s, within 10], 15-17 angular velocity [rad/s, within 50], 18 mask (1 filled, 0 empty; an
empty slot is all zeros). Values are clipped to their ranges. Objects beyond the twelfth are
omitted.

The modes
---------
=====================  ========================================================================
``state``              the flat state (279 entries; 287 with the hint)
``goal``               a dict for hindsight replay: ``observation`` is the flat state without the
                       goal (entries 0-267, and the hint), ``achieved_goal`` and ``desired_goal``
                       are the task's goal vectors
``pixels``             a dict of pictures, see ``views``
``pixels+proprio``     the inputs of a real robot: pictures, ``proprio`` (see
                       ``proprioception``) and ``instruction``
``pixels+state``       pictures with ``state``
``point_cloud``        a dict of points, see ``point_cloud``
``point_cloud+state``  the same with ``state``
=====================  ========================================================================

With ``instruction``, the other modes with pictures or points include the instruction too (see
``instructions``); with ``target_mark``, the pictures mark the target, and with ``calibration``, the
observation includes the calibration of each camera (see ``views``).

``geometry="height_map"`` adds the entry ``height_map`` (see ``height_map``); the mode ``state`` is
then a dict of ``state`` and ``height_map``. It is not available for ``goal`` and
``pixels+proprio``.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Float

from ..goals.goal import Goal
from ..rendering.config import ObservationConfig
from ..rendering.point_cloud import point_cloud_spaces
from ..rendering.views import SLOTS, picture_spaces
from ..world.world import World
from .bounds import BOUNDS, GOAL_VECTOR_BOUNDS
from .height_map import height_map_space
from .instructions import instruction_space
from .proprioception import proprioception_space

_GOAL_VECTORS = ("achieved_goal", "desired_goal")


def _box(bounds: Float[np.ndarray, "n"]) -> spaces.Box:
    high = bounds.astype(np.float32)
    return spaces.Box(-high, high, dtype=np.float32)


def observation_space(config: ObservationConfig, goals: int = 1) -> spaces.Space[Any]:
    """Return the space of an observation; ``goals`` is the number of goals in a goal vector."""
    mode = config.mode
    state = _box(BOUNDS[bool(config.grasp_hint), mode == "goal"])
    shapes = {"height_map": height_map_space()} if config.looks else {}
    if mode == "state":
        return spaces.Dict({"state": state, **shapes}) if shapes else state
    if mode == "goal":
        vectors = {k: _box(np.tile(GOAL_VECTOR_BOUNDS, goals)) for k in _GOAL_VECTORS}
        return spaces.Dict({"observation": state, **vectors})
    pixels = mode.startswith("pixels")
    entries = picture_spaces(config) if pixels else point_cloud_spaces(config.points)
    entries = {**entries, **shapes}
    assert config.instruction is not None
    if config.instruction != "none":
        entries["instruction"] = instruction_space(config.instruction)
    if mode.endswith("+state"):
        entries["state"] = state
    elif mode.endswith("+proprio"):
        entries["proprio"] = proprioception_space()
    return spaces.Dict(entries)


def slot_order(world: World, goal: Goal) -> list[str]:
    """Return up to 12 objects by slot: the target, the goal's reference, and others by distance."""
    first = [name for name in (goal.target, goal.reference) if name is not None]
    middle = goal.region(world).center if goal.target is None else world.position(goal.target)
    rest = [name for name in world.names if name not in first and name not in world.absent]
    rest.sort(key=lambda name: (float(np.linalg.norm(world.position(name) - middle)), name))
    return (first + rest)[:SLOTS]
