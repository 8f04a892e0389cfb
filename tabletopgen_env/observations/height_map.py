"""Height maps of the objects on the table, around the active target and around its goal.

With ``geometry="height_map"`` the observation has an entry ``height_map``, ``uint8`` of three maps
of 48 × 48 cells of 5 mm (24 cm a side), whatever the scene. Row i and column j are along x and y of
the *target's heading frame*: z up, x along the bearing of the x axis of the target's box (slot 0 of
the state has both), so an object looks the same at every position and yaw. Cell (i, j) is at (i -
23.5, j - 23.5) · 5 mm from the centre of the map, and holds the height of the highest surface in
it.

=======  ================================  ======================================================
map      centre                            shows
=======  ================================  ======================================================
0        centre of the target's box        only the target
1        centre of the target's box        everything else: obstacles for a descending hand
2        centre of the goal region         everything except the target: its future support
=======  ================================  ======================================================

Values are heights above the table top in steps of 2 mm: 0 where there is nothing, at most 255 (51
cm). The maps follow target and goal as they move. If the tool itself is the target (Reach), all
values are 0.

The maps are idealised: they have no noise, show every surface that is visible from above, even if
something hides it from a camera, exclude the robot, and separate the target from the other objects.
They are computed from the collision shapes. With noise in the observation (``randomization``) the
frame is that of the noisy pose in the state. No planner is involved: the maps contain no
information about grasps or places of release.

Poses are rounded to 0.5 mm and 5 mrad, and tilts to 0.01, before a map is computed; while no object
moves by more, the previous maps are returned.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from gymnasium import spaces
from jaxtyping import Float, UInt8

from generator.geometry import rotation_yaw, rotation_z

from ..expert.planning.heights import HeightMap, height_map, move_parts
from ..goals.goal import Goal
from ..world.world import World
from .bounds import Noise

MAPS, CELLS = 3, 48
"""Number of maps, and of cells along a side of each."""

CELL, STEP = 0.005, 0.002
"""Size of a cell, and unit of height, in metres."""

_FINE = CELL / 2  # spacing of the sampled points, metres: walls are thinner than a cell
_PLACE, _TURN, _TILT = 5e-4, 5e-3, 0.01  # resolution of poses: metres, radians, of an axis
_MAX_SHAPES = 1024  # number of cached shapes


def height_map_space() -> spaces.Box:
    """Return the space of the maps."""
    return spaces.Box(0, 255, (MAPS, CELLS, CELLS), np.uint8)


class _Pose(NamedTuple):
    """A rounded pose of an object: centre (m, world), heading (radians), and tilt as a matrix."""

    center: Float[np.ndarray, "3"]
    heading: float
    tilt: Float[np.ndarray, "3 3"]


class HeightLook:
    """A scanner that computes height maps of scenes and caches scanned shapes and the last maps."""

    def __init__(self) -> None:
        self._shapes: dict[tuple[str, str, bytes], HeightMap] = {}
        self._key: tuple[object, ...] = ()
        self._seen: UInt8[np.ndarray, "3 48 48"] = np.zeros((MAPS, CELLS, CELLS), np.uint8)

    def __reduce__(self) -> tuple[type[HeightLook], tuple[()]]:
        """Return the state for copying or pickling, without the cached values."""
        return HeightLook, ()

    def maps(
        self, world: World, goal: Goal, noise: Noise | None = None
    ) -> UInt8[np.ndarray, "3 48 48"]:
        """Return the current maps of a goal's target; ``noise`` is the noise of the state."""
        if goal.target is None:
            return np.zeros((MAPS, CELLS, CELLS), np.uint8)
        poses = {name: _pose(world, name) for name in world.names if name not in world.absent}
        own = poses[goal.target]
        middle, heading = own.center[:2], own.heading
        if noise is not None:
            middle = middle + noise.positions[0, :2]
            heading = heading + float(noise.turns[0, 2])
        there = _PLACE * np.rint(goal.region(world).center[:2] / _PLACE)
        key = (
            world.digest, goal.target, heading, middle.tobytes(), there.tobytes(),
            *((p.center.tobytes(), p.heading, p.tilt.tobytes()) for p in poses.values()),
        )  # fmt: skip
        if key != self._key:
            rest = [name for name in poses if name != goal.target]
            views = (([goal.target], middle), (rest, middle), (rest, there))
            self._seen = np.stack([
                self._scan(world, poses, names, at, heading) for names, at in views
            ])  # fmt: skip
            self._key = key
        return self._seen.copy()

    def _scan(
        self,
        world: World,
        poses: dict[str, _Pose],
        names: Iterable[str],
        middle: Float[np.ndarray, "2"],
        heading: float,
    ) -> UInt8[np.ndarray, "48 48"]:
        """Return the height map of the objects ``names`` around ``middle`` (x, y, world)."""
        points = middle + _GRID @ rotation_z(heading)[:2, :2].T
        heights = np.zeros(len(points))
        for name in names:
            pose = poses[name]
            shape = self._shape(world, name, pose.tilt)
            reach = _HALF_DIAGONAL + _FINE * float(np.hypot(*shape.heights.shape)) / 2
            if np.hypot(*(pose.center[:2] - middle)) > reach:
                continue
            own = (points - pose.center[:2]) @ rotation_z(pose.heading)[:2, :2]
            above = shape.at(own) + (pose.center[2] - world.scene.table.height)
            np.maximum(heights, above, out=heights)
        fine = heights.reshape(CELLS, 2, CELLS, 2).max((1, 3))
        return np.rint(np.minimum(fine / STEP, 255.0)).astype(np.uint8)

    def _shape(self, world: World, name: str, tilt: Float[np.ndarray, "3 3"]) -> HeightMap:
        """Return an object's heights above its centre, on a grid in the object's heading frame."""
        key = (world.digest, name, tilt.tobytes())
        found = self._shapes.get(key)
        if found is None:
            if len(self._shapes) >= _MAX_SHAPES:
                self._shapes.clear()
            parts = move_parts(world.scene.object(name).parts, np.zeros(3), tilt)
            bounds = np.abs(np.stack([part.bounds[:, :2] for part in parts])).max((0, 1))
            far = (np.ceil(bounds / _FINE) - 0.5) * _FINE
            found = self._shapes[key] = height_map(parts, -far, far - _FINE / 2, _FINE)
        return found


def _pose(world: World, name: str) -> _Pose:
    rotation = world.rotation(name)
    heading = _TURN * round(rotation_yaw(rotation) / _TURN)
    tilt = _TILT * np.rint(rotation_z(-heading) @ rotation / _TILT) + 0.0  # no -0.0
    return _Pose(_PLACE * np.rint(world.position(name) / _PLACE), heading, tilt)


def _grid() -> Float[np.ndarray, "n 2"]:
    axis = (np.arange(2 * CELLS) - (2 * CELLS - 1) / 2) * _FINE
    return np.stack(np.meshgrid(axis, axis, indexing="ij"), -1).reshape(-1, 2)


_GRID, _HALF_DIAGONAL = _grid(), CELL * CELLS / np.sqrt(2)
_GRID.setflags(write=False)
