"""Merging of convex parts, to limit their number per object."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations, count

import numpy as np
from jaxtyping import Float
from scipy.spatial import ConvexHull, QhullError

from generator.errors import SceneError, require_number
from generator.geometry import hull_points
from generator.physics.gate import judge
from generator.scene import ConvexPart, Scene

from ....robot.panda import Panda
from ....world.world import World

MOST_PARTS = 12
"""Default maximum number of convex parts per object; catalogue objects have up to 46."""


def cap_world(world: World, most: int, robot: Panda) -> World:
    """Return a world, with the same mount, in which no object has more than ``most`` convex parts.

    If an object has more, parts are merged, and the scene passes the gate and is compiled again.

    Raises:
        SceneError: the scene with merged parts fails its physical gate.
    """
    capped = cap_parts(world.scene, most)
    if capped is world.scene:
        return world
    if failures := judge(capped).failures:
        some = "; ".join(map(str, failures[:2]))
        raise SceneError(
            f"with at most {most} parts per object it fails its physical gate ({some})"
        )
    return World(capped, robot, world.mount)


_GAP = 1e-3  # maximum distance between neighbours, metres


def cap_parts(scene: Scene, most: int) -> Scene:
    """Return the scene with at most ``most`` convex parts for each object.

    Poses, masses and inertias do not change, nor do objects within the limit. Merged shapes are
    slightly larger, so check the scene again with the gate.

    Raises:
        InputError: ``most`` is below 1.
    """
    require_number("most", most, minimum=1, integer=True)
    if all(len(thing.parts) <= most for thing in scene.objects):
        return scene
    capped = (replace(thing, parts=merge_parts(thing.parts, most)) for thing in scene.objects)
    return scene.replace(objects=tuple(capped))


@dataclass(frozen=True, eq=False)
class _Piece:
    """A part with its volume in cubic metres."""

    part: ConvexPart
    volume: float

    def near(self, other: _Piece) -> bool:
        """Return whether the bounding boxes of two parts are within ``_GAP`` of each other."""
        (low, high), (lowest, highest) = self.part.bounds, other.part.bounds
        return bool((low <= highest + _GAP).all() and (lowest <= high + _GAP).all())

    def fill(self, other: _Piece) -> float:
        """Return the volume added by merging two parts."""
        return _volume(self._points(other)) - self.volume - other.volume

    def merge(self, other: _Piece) -> _Piece:
        """Return the convex hull of two parts."""
        points = self._points(other)
        return _Piece(ConvexPart(hull_points(points)), _volume(points))

    def _points(self, other: _Piece) -> Float[np.ndarray, "n 3"]:
        return np.concatenate([self.part.vertices, other.part.vertices])


def merge_parts(parts: Sequence[ConvexPart], most: int) -> tuple[ConvexPart, ...]:
    """Merge parts into at most ``most`` convex parts that cover them."""
    left = {k: _Piece(part, _volume(part.vertices)) for k, part in enumerate(parts)}
    fill = {
        (a, b): left[a].fill(left[b]) for a, b in combinations(left, 2) if left[a].near(left[b])
    }
    for new in count(len(left)):
        if len(left) <= most:
            break
        fill = fill or {(a, b): left[a].fill(left[b]) for a, b in combinations(left, 2)}
        pair = min(fill, key=lambda pair: (fill[pair], pair))
        fill = {other: added for other, added in fill.items() if not {*other} & {*pair}}
        one, other = map(left.pop, pair)
        merged = one.merge(other)
        fill |= {(k, new): piece.fill(merged) for k, piece in left.items() if piece.near(merged)}
        left[new] = merged
    return tuple(piece.part for piece in left.values())


def _volume(points: Float[np.ndarray, "n 3"]) -> float:
    """Return the volume of the points' convex hull in cubic metres, or 0 for coplanar points."""
    try:
        return float(ConvexHull(points).volume)
    except QhullError:
        return 0.0
