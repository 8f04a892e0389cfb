"""Tiles of a picture, processed one at a time so that small objects appear larger."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, UInt8

_NEAR = 0.01  # distance to a cut, relative to the tile's side, below which a box counts as cut


@dataclass(frozen=True)
class Tile:
    """A part of a picture of ``width`` x ``height`` pixels; right and bottom are exclusive."""

    x0: int
    y0: int
    x1: int
    y1: int
    width: int
    height: int

    @property
    def size(self) -> tuple[int, int]:
        """The width and height of the tile in pixels."""
        return self.x1 - self.x0, self.y1 - self.y0

    def cut(self, image: UInt8[np.ndarray, "h w 3"]) -> UInt8[np.ndarray, "th tw 3"]:
        """Return the tile's part of a picture."""
        return np.ascontiguousarray(image[self.y0 : self.y1, self.x0 : self.x1])

    def to_picture(self, boxes: Float[np.ndarray, "n 4"]) -> Float[np.ndarray, "n 4"]:
        """Convert boxes from fractions of the tile to picture pixels, clipped to the tile."""
        low, high = [self.x0, self.y0] * 2, [self.x1, self.y1] * 2
        return np.clip(boxes * np.tile(self.size, 2) + low, low, high)

    def to_part(self, boxes: Float[np.ndarray, "n 4"]) -> Float[np.ndarray, "n 4"]:
        """Convert boxes from picture pixels to fractions of the tile's sides."""
        return (boxes - [self.x0, self.y0] * 2) / np.tile(self.size, 2)

    def whole(self, mask: Bool[np.ndarray, "th tw"]) -> Bool[np.ndarray, "h w"]:
        """Convert a mask of the tile to a mask of the whole picture."""
        made = np.zeros((self.height, self.width), bool)
        made[self.y0 : self.y1, self.x0 : self.x1] = mask
        return made

    def cuts(self, boxes: Float[np.ndarray, "n 4"]) -> Bool[np.ndarray, "n"]:
        """Return which boxes touch a side of the tile that is not a side of the picture."""
        near = np.tile(self.size, 2) * _NEAR
        sides = np.array([self.x0, self.y0, self.x1, self.y1])
        inner = sides != [0, 0, self.width, self.height]
        return ((np.abs(boxes - sides) <= near) & inner).any(1)

    def told_by(
        self, boxes: Float[np.ndarray, "n 4"], scores: Float[np.ndarray, "n"], threshold: float
    ) -> Bool[np.ndarray, "n"]:
        """Return which boxes are valid: above the threshold, not cut, and at least a pixel wide."""
        sized = (boxes[:, 2:] - boxes[:, :2] >= 1).all(1)
        return (scores >= threshold) & ~self.cuts(boxes) & sized

    def holds(self, box: Float[np.ndarray, "4"], margin: float) -> bool:
        """Return whether a box with a margin of ``margin`` times its sides lies in the tile.

        No margin is required beyond the picture's own frame.
        """
        wide, high = (box[2:] - box[:2]) * margin
        margins = np.array([-wide, -high, wide, high])
        x0, y0, x1, y1 = np.clip(box + margins, 0, [self.width, self.height] * 2)
        return bool(x0 >= self.x0 and y0 >= self.y0 and x1 <= self.x1 and y1 <= self.y1)


def tiles_of(width: int, height: int, count: int, overlap: float) -> tuple[Tile, ...]:
    """Return the whole picture, then ``count`` x ``count`` tiles of the same aspect ratio.

    Neighbouring tiles share the fraction ``overlap`` of their side. A count of 1 adds no tiles.
    """
    whole = Tile(0, 0, width, height, width, height)
    if count == 1:
        return (whole,)
    across, down = _spans(width, count, overlap), _spans(height, count, overlap)
    parts = [Tile(x0, y0, x1, y1, width, height) for y0, y1 in down for x0, x1 in across]
    return (whole, *parts)


def closest(tiles: Sequence[Tile], box: Float[np.ndarray, "4"], margin: float) -> Tile:
    """Return the smallest tile that contains a box with its margin, or else the first one."""
    holding = [t for t in tiles if t.holds(box, margin)] or [tiles[0]]
    return min(holding, key=lambda t: t.size[0] * t.size[1])


def _spans(length: int, count: int, overlap: float) -> list[tuple[int, int]]:
    side = min(length, int(np.ceil(length / (count - (count - 1) * overlap))))
    starts = np.round(np.linspace(0, length - side, count)).astype(int)
    return [(int(s), int(s) + side) for s in starts]
