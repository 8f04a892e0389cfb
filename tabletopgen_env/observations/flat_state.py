"""The flat state; see ``modes`` for its entries."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.geometry import rotation_yaw, wrap

from ..goals.goal import Goal
from ..world.world import World
from .bounds import BARE_BOUNDS, BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS, Noise
from .grasp_hint import misread
from .proprioception import write_robot


class FlatState:
    """A reader of the flat state of one world for one active goal.

    Args:
        world: the world.
        goal: the active goal.
        order: the objects by slot, the goal's target first; see ``modes.slot_order``.
        bare: whether to keep only entries 0-267.
        hinted: whether to append the entries of ``grasp_hint``.
    """

    def __init__(
        self, world: World, goal: Goal, order: Sequence[str], bare: bool, hinted: bool
    ) -> None:
        self._world, self._goal, self._bare = world, goal, bare
        self._rows = np.array([world.index(name) for name in order], int)
        self._bounds = BOUNDS[hinted, bare]
        self._still = still = np.zeros(len(self._bounds))  # the constant entries
        still[37] = world.scene.table.height - world.base_position[2]
        still[38:40] = world.half_top
        slots = self._slots(still)
        slots[:, 9:12] = world.half_extent[self._rows]
        slots[:, 18] = 1.0
        if not bare:
            still[len(BARE_BOUNDS)] = goal.reference is not None

    def read(
        self, noise: Noise | None = None, hint: Float[np.ndarray, "8"] | None = None
    ) -> Float[np.ndarray, "n"]:
        """Return the current state as ``float32``.

        ``noise`` is the noise of this reading, ``hint`` the entries of ``grasp_hint``.
        """
        world, goal, entries = self._world, self._goal, self._still.copy()
        self._read_robot(entries, noise)
        slots = self._read_objects(entries, noise)
        tool = entries[15:18]
        target = tool if goal.target is None else slots[0, :3]
        entries[34:37] = target - tool
        if not self._bare:
            region, shown = goal.region(world), entries[len(BARE_BOUNDS) :]
            shown[1:4] = middle = world.to_base(region.center)
            shown[4:6] = region.semi[:2]
            shown[6:8] = region.yaw - world.mount.yaw, region.semi[2]
            shown[8:11] = middle - target
        if hint is not None:
            entries[-len(hint) :] = hint if noise is None else self._misread(entries, hint, noise)
        bounds = self._bounds
        np.minimum(np.maximum(entries, -bounds, out=entries), bounds, out=entries)
        return entries.astype(np.float32)

    def _slots(self, entries: Float[np.ndarray, "n"]) -> Float[np.ndarray, "s 19"]:
        """Return a writable view of the filled object slots of a state."""
        size = len(SLOT_BOUNDS)
        first, count = len(ROBOT_BOUNDS), len(self._rows)
        return entries[first : first + size * count].reshape(count, size)

    def _read_robot(self, entries: Float[np.ndarray, "n"], noise: Noise | None) -> None:
        """Write the robot's entries (0 to 33)."""
        world, name = self._world, self._goal.target
        write_robot(entries, world, noise)
        left, right, _ = (False,) * 3 if name is None else world.touches(name)
        entries[32:34] = left, right

    def _read_objects(
        self, entries: Float[np.ndarray, "n"], noise: Noise | None
    ) -> Float[np.ndarray, "s 19"]:
        """Write the object slots, and return a view of the filled ones."""
        world, state, rows = self._world, self._world.state, self._rows
        slots, speed = self._slots(entries), state.velocities[rows]
        positions = world.to_base(state.positions[rows])
        rotations = world.base_rotation.T @ state.rotations[rows]
        slots[:, 15:18] = (rotations @ speed[:, 3:, None])[:, :, 0]
        if noise is not None:
            positions = positions + noise.positions[: len(rows)]
            rotations = Rotation.from_rotvec(noise.turns[: len(rows)]).as_matrix() @ rotations
        slots[:, 0:3] = positions
        slots[:, 3:6], slots[:, 6:9] = rotations[:, :, 0], rotations[:, :, 1]
        slots[:, 12:15] = speed[:, :3] @ world.base_rotation
        return slots

    def _misread(
        self, entries: Float[np.ndarray, "n"], hint: Float[np.ndarray, "8"], noise: Noise
    ) -> Float[np.ndarray, "8"]:
        """Return the grasp hint with sensor errors that match the noise of the other entries."""
        world = self._world
        tool = entries[15:18] - world.to_base(world.state.tool)
        yaw = wrap(float(np.arctan2(entries[19], entries[18])) - rotation_yaw(world.hand))
        return misread(hint, noise.positions[0], tool, yaw)
