"""Merge convex parts of objects until a batch has room for them."""

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
"""Convex parts that an object has unless said otherwise; catalogue objects have up to 46."""


def cap_world(world: World, most: int, robot: Panda) -> World:
    """Return a world whose objects have at most ``most`` convex parts, with the same mount.

    Where any has more, parts are merged, and the scene is gated and
    compiled anew.

    Raises:
        SceneError: the scene does not pass its physical gate with merged parts.
    """
    capped = cap_parts(world.scene, most)
    if capped is world.scene:
        return world
    if failures := judge(capped).failures:
        some = "; ".join(map(str, failures[:2]))
        raise SceneError(f"with {most} parts an object it fails its physical gate ({some})")
    return World(capped, robot, world.mount)


_GAP = 1e-3  # metres between neighbours, at most


def cap_parts(scene: Scene, most: int) -> Scene:
    """Return the scene with at most ``most`` convex parts for each object.

    Poses, masses and inertias stay, as does what has no more parts. Shapes that were merged are
    somewhat larger than before: the gate has to judge whether the scene still holds.

    Raises:
        InputError: ``most`` is below 1.
    """
    require_number("cap_parts needs most", most, minimum=1, integer=True)
    if all(len(thing.parts) <= most for thing in scene.objects):
        return scene
    capped = (replace(thing, parts=merge_parts(thing.parts, most)) for thing in scene.objects)
    return scene.replace(objects=tuple(capped))


@dataclass(frozen=True, eq=False)
class _Piece:
    """A part, and its volume in cubic metres."""

    part: ConvexPart
    volume: float

    def near(self, other: _Piece) -> bool:
        """Return whether the boxes of two parts come within ``_GAP``."""
        (low, high), (lowest, highest) = self.part.bounds, other.part.bounds
        return bool((low <= highest + _GAP).all() and (lowest <= high + _GAP).all())

    def fill(self, other: _Piece) -> float:
        """Return the volume that merging two parts adds."""
        return _volume(self._points(other)) - self.volume - other.volume

    def merge(self, other: _Piece) -> _Piece:
        """Return the convex hull of two parts."""
        points = self._points(other)
        return _Piece(ConvexPart(hull_points(points)), _volume(points))

    def _points(self, other: _Piece) -> Float[np.ndarray, "n 3"]:
        return np.concatenate([self.part.vertices, other.part.vertices])


def merge_parts(parts: Sequence[ConvexPart], most: int) -> tuple[ConvexPart, ...]:
    """Return at most ``most`` convex parts that cover all that ``parts`` cover."""
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
    """Return the volume of the convex hull of points, cubic metres; flat ones have none."""
    try:
        return float(ConvexHull(points).volume)
    except QhullError:
        return 0.0
