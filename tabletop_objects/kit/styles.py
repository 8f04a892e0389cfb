"""Drawing styles and requested colours, applied to the finished shape of any category.

A style changes a shape's solids and tiles and, if the solids grow, its convex parts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Float, Int

from ..errors import InputError, choices
from ..values import ConvexPart
from .shapes import Piece, Shape
from .solids import Solid, outward, refine, signed_volume
from .surfaces import RGB, Tile, rgb

MAX_FACES = 4800
"""Maximum number of faces of a styled shape."""

THICKER = 0.005
"""Distance by which the cartoon style moves surfaces outwards, relative to the longest side."""

ROUNDER = 0.035
"""Maximum radius by which the cartoon style rounds edges, relative to the longest side."""

KEPT = (0.2, 0.32, 0.5, 0.7)
"""Fractions of a solid's faces that the low-poly style tries to keep, in this order; it uses the
first with which the solid stays closed and in one piece."""

FEW = 60
"""Maximum number of faces of a solid that the low-poly style leaves as it is."""

SHEET = 0.2
"""Ratio of the shortest to the second-shortest side of a solid below which the low-poly style keeps
the solid's texture."""

STRAY = 0.06
"""Maximum deviation of a low-poly solid from the original, relative to its longest side."""

_LIGHT = np.array([-0.45, -0.55, 0.7])


def apply_style(made: Shape, style: str) -> Shape:
    """Return a shape drawn in a style; the style "" changes nothing.

    The style is one of ``STYLES``, in upper or lower case, with "_" or "-".

    Raises:
        InputError: the style is unknown.
    """
    word = style.lower().replace("_", "-").strip()
    if word in ("", "plain"):
        return made
    if word not in STYLES:
        raise InputError(f"Unknown style {style!r}." + choices(word, STYLES))
    return STYLES[word](made)


def flatten(tile: Tile, colors: int, saturation: float = 1.0, lightness: float = 1.0) -> Tile:
    """Return a tile with at most ``colors`` flat, more vivid colours and no fine detail."""
    from PIL import Image, ImageFilter

    picture = Image.fromarray(np.ascontiguousarray(tile))
    if min(tile.shape[:2]) > 16:
        picture = picture.filter(ImageFilter.MedianFilter(5))
    few = picture.quantize(colors, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    image = np.asarray(few.convert("RGB"), float)
    grey = image.mean(-1, keepdims=True)
    vivid = grey + (image - grey) * saturation
    return np.clip(np.round(vivid * lightness), 0, 255).astype(np.uint8)


def cartoon(made: Shape) -> Shape:
    """Return a shape with rounded edges, thicker solids and a few saturated colours."""
    reach = max(np.ptp(np.concatenate([p.solid.vertices for p in made.pieces]), axis=0))
    budget = MAX_FACES
    counts = [len(p.solid.faces) for p in made.pieces]
    pieces = []
    for k, piece in enumerate(made.pieces):
        soft = piece.solid
        if _closed(_weld(soft)[1][soft.faces]):  # open surfaces cannot be rounded
            share = budget - sum(counts[k + 1 :])
            fine = _refined_within(soft, 2 * ROUNDER * reach, share)
            soft = _press_flat(_thicken(_round(fine, ROUNDER * reach), THICKER * reach))
        budget -= len(soft.faces)
        pieces.append(Piece(soft, flatten(piece.tile, 5, 1.5, 1.08)))
    points = np.concatenate([p.solid.vertices for p in pieces])
    low, high = points.min(0), points.max(0)
    parts = tuple(_grow(part, THICKER * reach, low, high) for part in made.parts)
    return Shape(tuple(pieces), parts, made.opacity)


def _refined_within(solid: Solid, edge: float, maximum: int) -> Solid:
    """Split a solid's triangles until no edge exceeds ``edge`` or ``maximum`` faces are reached."""
    for _ in range(3):
        p = solid.vertices[solid.faces]
        longest = np.linalg.norm(p - np.roll(p, 1, 1), axis=-1).max()
        if longest <= edge or 4 * len(solid.faces) > min(maximum, 1000):
            break
        solid = refine(solid)
    return solid


def _weld(solid: Solid) -> tuple[Float[np.ndarray, "k 3"], Int[np.ndarray, "n"]]:
    """Return the distinct vertex positions of a solid, and the index of each vertex among them."""
    points, index = np.unique(solid.vertices.round(7) + 0.0, axis=0, return_inverse=True)
    return points, index.reshape(-1)


def _round(solid: Solid, radius: float) -> Solid:
    """Return a smoothed solid in the same bounding box; vertices move by at most ``radius``."""
    points, index = _weld(solid)
    faces = index[solid.faces]
    a, b, c = (points[faces[:, k]] for k in range(3))
    area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
    radius = min(radius, abs(signed_volume(points, faces)) / max(area, 1e-12))
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    degree = np.maximum(np.bincount(ends[:, 0], minlength=len(points)), 1)[:, None]
    soft = points
    for _ in range(3):
        total = np.stack(
            [np.bincount(ends[:, 0], soft[ends[:, 1], k], len(points)) for k in range(3)], 1
        )
        soft = 0.5 * soft + 0.5 * total / degree
    step = soft - points
    length = np.linalg.norm(step, axis=1, keepdims=True)
    soft = points + step * np.minimum(1, radius / np.maximum(length, 1e-12))
    return Solid(_fit(soft, points)[index], solid.faces, solid.uv)


def _fit(
    points: Float[np.ndarray, "k 3"], like: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "k 3"]:
    """Scale points to the bounding box of ``like``."""
    low, span = points.min(0), np.ptp(points, axis=0)
    ratio = np.ptp(like, axis=0) / np.where(span > 1e-9, span, 1)
    return like.min(0) + (points - low) * ratio


def _thicken(solid: Solid, thickness: float) -> Solid:
    """Move a solid's surface outwards along its vertex normals."""
    points, index = _weld(solid)
    faces = index[solid.faces]
    a, b, c = (points[faces[:, k]] for k in range(3))
    ways = np.cross(b - a, c - a)
    total = np.stack(
        [np.bincount(faces.T.ravel(), np.tile(ways[:, k], 3), len(points)) for k in range(3)], 1
    )
    total /= np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-20)
    return Solid((points + thickness * total)[index], solid.faces, solid.uv)


def _press_flat(solid: Solid) -> Solid:
    """Raise the points of a solid that are below the plane z = 0 to that plane."""
    return solid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))


def _grow(
    part: ConvexPart,
    by: float,
    low: Float[np.ndarray, "3"],
    high: Float[np.ndarray, "3"],
) -> ConvexPart:
    """Return a part enlarged by ``by`` on each side and clipped to a box."""
    first, last = part.bounds
    middle, span = (first + last) / 2, np.maximum(last - first, 1e-6)
    grown = middle + (part.vertices - middle) * (1 + 2 * by / span)
    return ConvexPart(np.clip(grown, low, high), part.kind, part.axis)


def low_poly(made: Shape) -> Shape:
    """Return a shape with coarse facets, each in one flat colour."""
    return Shape(tuple(_facet(piece) for piece in made.pieces), made.parts, made.opacity)


def _facet(piece: Piece) -> Piece:
    """Return a decimated piece with one colour per facet; simple pieces are not decimated."""
    solid = piece.solid
    tile = flatten(piece.tile, 3, 1.25, 1.04)
    span = np.sort(np.ptp(solid.vertices, axis=0))
    sheet = span[0] < SHEET * span[1] and len(solid.faces) <= 4 * FEW
    if sheet or len(solid.faces) <= FEW:
        return Piece(solid, tile)
    coarse, source = _decimate(solid)
    p = coarse.vertices[coarse.faces]
    flat = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    flat /= np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-20)
    h, w = tile.shape[:2]
    u, v = solid.uv[solid.faces[source]].mean(1).T
    rows, columns = np.minimum(((1 - v) * h).astype(int), h - 1), np.minimum(u * w, w - 1)
    light = 1 + 0.13 * np.clip(flat @ _LIGHT, -1, 1)
    colors = np.clip(tile[rows, columns.astype(int)] * light[:, None] / 6, 0, 42.5).round() * 6
    palette, paint = np.unique(colors, axis=0, return_inverse=True)
    across = paint.reshape(-1) / max(len(palette) - 1, 1)
    uv = np.column_stack([np.repeat(across, 3), np.full(3 * len(p), 0.5)])
    faces = np.arange(3 * len(p)).reshape(-1, 3)
    swatch = np.clip(np.repeat(palette[None], 8, axis=0), 0, 255).astype(np.uint8)
    return Piece(Solid(p.reshape(-1, 3), faces, uv), swatch)


def _decimate(solid: Solid) -> tuple[Solid, Int[np.ndarray, "m"]]:
    """Return a coarser closed solid in the same box, and each face's nearest original face."""
    import fast_simplification
    from scipy.spatial import KDTree

    points, index = _weld(solid)
    faces = index[solid.faces]
    whole, reach = abs(signed_volume(points, faces)), np.ptp(points, axis=0).max()
    tree = KDTree(_places(points, faces, reach))
    for share in KEPT:
        target = 1 - max(share, FEW / 2 / len(faces))
        v, f = fast_simplification.simplify(points, faces.astype(np.int32), target, agg=5)[:2]
        v = _fit(np.asarray(v, float), points)
        sound = len(f) and _closed(np.asarray(f)) and signed_volume(v, f) > 0.7 * whole
        if sound and _away(points, v, np.asarray(f)) < STRAY * reach:
            coarse = outward(Solid(v, np.asarray(f), np.zeros((len(v), 2))))
            return coarse, np.asarray(tree.query(_places(v, coarse.faces, reach))[1])
    return solid, np.arange(len(solid.faces))


def _away(
    points: Float[np.ndarray, "k 3"], v: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]
) -> float:
    """Return the approximate distance from a surface to the farthest point of ``points``."""
    from scipy.spatial import KDTree

    steps = np.linspace(0, 1, 9)
    weights = np.array([(a, b, 1 - a - b) for a in steps for b in steps if a + b < 1 + 1e-9])
    surface = np.einsum("wk,mkd->mwd", weights, v[faces]).reshape(-1, 3)
    return float(KDTree(surface).query(points)[0].max())


def _places(
    points: Float[np.ndarray, "k 3"], faces: Int[np.ndarray, "m 3"], reach: float
) -> Float[np.ndarray, "m 6"]:
    """Return the centres of faces and their weighted normals, for nearest-neighbour queries."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    ways = np.cross(b - a, c - a)
    ways /= np.maximum(np.linalg.norm(ways, axis=1, keepdims=True), 1e-20)
    return np.concatenate([(a + b + c) / 3, 0.15 * reach * ways], axis=1)


def _closed(faces: Int[np.ndarray, "m 3"]) -> bool:
    """Return whether each edge occurs equally often in both directions."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    count = int(edges.max()) + 1
    there, back = edges @ np.array([count, 1]), edges @ np.array([1, count])
    return bool((np.sort(there) == np.sort(back)).all())


STYLES: Mapping[str, Callable[[Shape], Shape]] = MappingProxyType(
    {"cartoon": cartoon, "low-poly": low_poly}
)
"""The styles besides the plain one."""

_LEAST = 0.25
"""Minimum fraction of the surface that shows a requested colour."""

_GREY = 20.0
"""Maximum difference from grey of a colour that counts as grey (RGB from 0 to 255)."""

_CLOSE = 60.0
"""Maximum difference in lightness between two greys with the same name."""

_ALIKE = 0.85
"""Minimum cosine of the angle between the hues of two colours with the same name."""

_STRONG = 0.35
"""Minimum strength of a colour relative to the requested colour."""

_CONTRAST = 0.6
"""Fraction of a texture tile's contrast that remains when the tile gets another colour."""


def show_color(made: Shape, word: str) -> Shape:
    """Return a shape that clearly shows a colour, repainting its largest tile if needed.

    The shape is unchanged if ``word`` does not name a colour.
    """
    asked = rgb(word)
    if asked is None:
        return made
    tiles = {piece.tile.tobytes(): piece.tile for piece in made.pieces}
    shown = dict.fromkeys(tiles, 0.0)
    for piece in made.pieces:
        solid = piece.solid
        shown[piece.tile.tobytes()] += solid.area
    seen = sum(area * _share(tiles[key], asked) for key, area in shown.items())
    if seen >= _LEAST * sum(shown.values()):
        return made
    largest = max(shown, key=lambda key: shown[key])
    paint = _paint(tiles[largest], asked)
    return replace(made, pieces=tuple(Piece(p.solid, paint) if p.tile.tobytes() == largest else p
                                      for p in made.pieces))  # fmt: skip


def _share(tile: Tile, color: RGB) -> float:
    """Return the fraction of a tile that has roughly the given colour, or a tint or shade of it."""
    pixels, asked = tile.reshape(-1, 3).astype(float), np.array(color)
    tones, tone = pixels - pixels.mean(1, keepdims=True), asked - asked.mean()
    strength, wanted = np.linalg.norm(tones, axis=1), float(np.linalg.norm(tone))
    if wanted < _GREY:
        near = np.abs(pixels.mean(1) - asked.mean()) < _CLOSE
        return float((near & (strength < 2 * _GREY)).mean())
    alike = tones @ tone > _ALIKE * strength * wanted
    return float((alike & (strength > _STRONG * wanted)).mean())


def _paint(tile: Tile, color: RGB) -> Tile:
    light = tile.astype(float).mean(-1, keepdims=True)
    shade = 1 + _CONTRAST * (light / max(float(light.mean()), 1.0) - 1)
    return np.clip(np.array(color) * shade, 0, 255).round().astype(np.uint8)
