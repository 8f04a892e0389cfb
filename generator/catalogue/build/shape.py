"""A shape under construction: textured solids plus collision parts, packed into one mesh."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Int, UInt8

from ...scene import ConvexPart, Mesh, Slot
from ..surfaces.textures import Tile, plain
from .solids import Solid

MARGIN = 2
"""Pixels of each tile's rim repeated around it in the atlas, against bleeding."""


@dataclass(frozen=True, eq=False)
class Piece:
    """A solid and the texture tile its [0, 1]^2 shows."""

    solid: Solid
    tile: Tile


@dataclass(frozen=True, eq=False)
class Shape:
    """An object as its category's function makes it, in metres, standing on z = 0.

    ``slots`` are the places that a holder has, in metres.
    """

    pieces: tuple[Piece, ...]
    parts: tuple[ConvexPart, ...]
    opacity: float = 1.0
    slots: tuple[Slot, ...] = ()

    def scale(self, factor: float) -> Shape:
        """Return the shape enlarged by ``factor``."""
        return replace(
            self,
            pieces=tuple(Piece(p.solid.scale(factor, factor, factor), p.tile) for p in self.pieces),
            parts=tuple(ConvexPart(p.vertices * factor, p.kind, p.axis) for p in self.parts),
            slots=tuple(replace(slot, at=slot.at * factor) for slot in self.slots),
        )


def shape(
    pieces: Iterable[tuple[Solid, Tile]],
    parts: Sequence[ConvexPart],
    opacity: float = 1.0,
    slots: Sequence[Slot] = (),
) -> Shape:
    """Return a shape from (solid, tile) pairs, convex parts and places for things.

    What dips below z = 0 is pressed flat there.
    """
    flat = tuple(Piece(_press(s), t) for s, t in pieces)
    return Shape(flat, tuple(parts), opacity, tuple(slots))


def _press(solid: Solid) -> Solid:
    if solid.vertices[:, 2].min() >= 0:
        return solid
    return solid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))


def mesh_of(made: Shape) -> Mesh:
    """Merge a shape's pieces into one mesh with one texture atlas, in metres."""
    tiles: list[Tile] = []
    numbers: dict[tuple[tuple[int, ...], bytes], int] = {}
    which = []
    for piece in made.pieces:
        tile = piece.tile
        if (tile == tile[:1, :1]).all():
            tile = plain(tuple(tile[0, 0]))
        key = (tile.shape, tile.tobytes())
        if key not in numbers:
            numbers[key] = len(tiles)
            tiles.append(tile)
        which.append(numbers[key])
    atlas, corners = pack(tiles)
    size = np.array([atlas.shape[1], atlas.shape[0]], float)
    vertices, faces, uv, count = [], [], [], 0
    for piece, k in zip(made.pieces, which, strict=True):
        span = np.array([tiles[k].shape[1], tiles[k].shape[0]], float)
        at = piece.solid.uv * (span - 1) + 0.5  # from centre to centre of the rim's pixels
        low = np.array([corners[k, 0], size[1] - corners[k, 1] - span[1]])
        vertices.append(piece.solid.vertices)
        faces.append(piece.solid.faces + count)
        uv.append((low + at) / size)
        count += len(piece.solid.vertices)
    return Mesh(
        np.concatenate(vertices), np.concatenate(faces), np.concatenate(uv), atlas, made.opacity
    )


def pack(tiles: Sequence[Tile]) -> tuple[UInt8[np.ndarray, "h w 3"], Int[np.ndarray, "n 2"]]:
    """Pack tiles on shelves into one picture whose sides are multiples of 8.

    Returns the picture and each tile's upper left pixel (column, row); around each tile its rim
    is repeated ``MARGIN`` pixels wide. What stays free shows the tiles' mean colour.
    """
    sizes = np.array([[t.shape[1], t.shape[0]] for t in tiles]) + 2 * MARGIN
    width = int(max(sizes[:, 0].max(), np.sqrt(np.prod(sizes, axis=1).sum())))
    width = (width + 7) // 8 * 8
    order = sorted(range(len(tiles)), key=lambda k: (-sizes[k, 1], -sizes[k, 0], k))
    corners = np.zeros((len(tiles), 2), int)
    x = y = tall = 0
    for k in order:
        if x + sizes[k, 0] > width:
            x, y, tall = 0, y + tall, 0
        corners[k] = x, y
        x, tall = x + sizes[k, 0], max(tall, sizes[k, 1])
    height = (y + tall + 7) // 8 * 8
    atlas = np.empty((height, width, 3), np.uint8)
    atlas[:] = np.mean([tile.mean((0, 1)) for tile in tiles], axis=0).round()
    for k, tile in enumerate(tiles):
        column, row = corners[k]
        rim = np.pad(tile, ((MARGIN, MARGIN), (MARGIN, MARGIN), (0, 0)), mode="edge")
        atlas[row : row + rim.shape[0], column : column + rim.shape[1]] = rim
    return atlas, corners + MARGIN
