"""Proprioception: entries 0 to 31 of the flat state (``modes``), and the gripper's velocity.

=====  =========================================================  ==========  ====
entry  meaning                                                    range       unit
=====  =========================================================  ==========  ====
0-31   as in the flat state: joints, their speeds, the opening,
       tool and hand in the base frame, commands
32     opening velocity of the gripper, negative while closing    [-1, 1]     m/s
=====  =========================================================  ==========  ====
"""

from __future__ import annotations

import numpy as np
from gymnasium import spaces
from jaxtyping import Float

from ..robot.kinematics import forward
from ..robot.panda import HOME_CTRL
from ..world.world import World
from .bounds import ROBOT_BOUNDS, Noise

SHARED = 32
"""Number of entries shared with the flat state; its other entries need more than joint sensors."""

PROPRIO_BOUNDS = np.append(ROBOT_BOUNDS[:SHARED], 1.0)
"""Largest magnitude of each entry."""

PROPRIO_BOUNDS.setflags(write=False)


def proprioception_space() -> spaces.Box:
    """Return the space of the proprioceptive entries."""
    high = PROPRIO_BOUNDS.astype(np.float32)
    return spaces.Box(-high, high, dtype=np.float32)


def feel(world: World, noise: Noise | None = None) -> Float[np.ndarray, "33"]:
    """Return the current proprioceptive entries as ``float32``, clipped to their bounds."""
    entries = np.zeros(SHARED + 1)
    write_robot(entries, world, noise)
    entries[SHARED] = world.state.finger_velocities.sum()
    return np.clip(entries, -PROPRIO_BOUNDS, PROPRIO_BOUNDS).astype(np.float32)


def write_robot(entries: Float[np.ndarray, "n"], world: World, noise: Noise | None) -> None:
    """Write the robot's part of a state (entries 0 to 31), without clipping."""
    state = world.state
    joints, tool, hand = state.joints, world.to_base(state.tool), world.hand
    if noise is not None:
        (point, turned), (there, seen) = forward(joints), forward(joints + noise.joints)
        tool, hand = tool + there - point, seen @ turned.T @ hand
        joints = joints + noise.joints
    entries[0:7] = joints
    entries[7:14] = state.joint_velocities
    entries[14] = sum(state.fingers.tolist())
    entries[15:18] = tool
    entries[18:24].reshape(2, 3)[:] = hand.T[:2]
    entries[24:31] = state.servos - joints
    entries[31] = 2 * state.gripper.item() / HOME_CTRL[7] - 1
