"""Model of a picture's table: a measured top, legs from the silhouette, and the picture's colours.

The top is painted as in the picture: a plain top stays plain despite shadows on it, and a patterned
top keeps its pattern.
"""

from __future__ import annotations

import dataclasses

import cv2
import numpy as np
import shapely
from jaxtyping import Bool, Float, Int
from scipy import ndimage

from tabletop_objects.kit.outlines import ellipse, rectangle, rounded_polygon

from ...meshes import texture_bake
from ...meshes.projection import Projection
from ...meshes.shading import estimate_shading
from ...meshes.unwrap import unwrap
from ...scene import Instance, Mesh, Model, SizePrior, View
from .shapes.frames import small_mask
from .table_fit import Fitted, Silhouette, fit_table

_COARSE, _FINE = 240, 480  # longer side in pixels of the compared silhouettes
_EDGE = 0.02  # distance from the top's edge to reliable colours, relative to the length
_PLAIN = 14.0  # grey level noise within a hand's breadth, below which a top is plain
_BESIDE = 0.01  # width of the halo around an object, relative to the crop's longer side
_SHADE = 0.05  # likewise for its shadow
_DARK = 0.8  # relative brightness of the top below which a point is in shadow
_SHADES = 20  # number of levels per colour channel
_RARE = 0.02  # fraction of the top below which a colour is rare
_PATCH = (
    0.0007,
    0.03,
)  # minimum area of adjacent rare colours that are an object, as a fraction of the top
_CELLS = 192  # cells along the longer side of the top for inpainting


def model_table(
    instance: Instance, size: SizePrior, view: View, seed: int, texture: int, quick: bool = False
) -> Model:
    """Return a model of the picture's table, with yaw 0; ``quick`` shortens the search.

    The top has the prior's outline, or the common one whose silhouette fits best. Legs and height
    are those that explain the silhouette below it; the prior's height is kept if the picture does
    not show the height.
    """
    projection = Projection.of_instance(instance, view)
    small = [projection.resize(side) for side in (_COARSE, _FINE)]
    seen = [
        Silhouette(small_mask(instance, p), _places(instance, p.width, p.height)[2], p)
        for p in small
    ]
    extent = np.clip(size.extent, 0.2, 4.0)
    tops = _usual_tops(*extent[:2]) if size.outline is None else [np.asarray(size.outline)]
    tops = [top * (extent[:2] / np.ptp(top, axis=0)) for top in tops]
    fits = (fit_table(top, float(extent[2]), *seen, quick=quick) for top in tops)
    best = max(fits, key=lambda fit: fit.overlap)
    model = best.form.build()
    return dataclasses.replace(model, mesh=_paint(best, model, instance, projection, texture))


def _places(
    instance: Instance, width: int, height: int
) -> tuple[Int[np.ndarray, "h w"], Int[np.ndarray, "h w"], Bool[np.ndarray, "h w"]]:
    """Return each crop pixel's closest row and column in the picture, and whether it is inside."""
    x0, y0, x1, y1 = instance.crop_box
    columns = np.floor(x0 + (np.arange(width) + 0.5) * (x1 - x0) / width).astype(int)
    rows = np.floor(y0 + (np.arange(height) + 0.5) * (y1 - y0) / height).astype(int)
    rows, columns = np.meshgrid(rows, columns, indexing="ij")
    tall, wide = instance.mask.shape
    held = (rows >= 0) & (rows < tall) & (columns >= 0) & (columns < wide)
    return rows.clip(0, tall - 1), columns.clip(0, wide - 1), held


def _usual_tops(length: float, width: float) -> list[Float[np.ndarray, "_k 2"]]:
    """Return the common outlines of a tabletop of the given length and width."""
    corners = np.array([[-0.5, -0.5], [0.5, -0.5], [0.0, 0.5]]) * [length, width]
    triangle = rounded_polygon(corners, 0.1 * min(length, width), 4)
    triangle = triangle - (triangle.min(0) + triangle.max(0)) / 2
    round_top = ellipse(length, width, 64)
    tops = [rectangle(length, width, r * min(length, width), 6) for r in (0.02, 0.14, 0.3)]
    return [*tops, round_top, triangle, -triangle]


# ------------------------------------------------------------------------------------- colours


def _paint(
    fit: Fitted, model: Model, instance: Instance, projection: Projection, size: int
) -> Mesh:
    """Return the table's mesh in the picture's colours; top and legs are painted separately."""
    mesh = model.mesh
    world = fit.world(np.asarray(mesh.vertices, float))
    image, mask = texture_bake.opaque_colors(instance.crop)
    atlas = unwrap(mesh.vertices * model.size, mesh.faces, size)
    surface = texture_bake.surface_of(atlas, world)
    sight = texture_bake.CropView.of(world, mesh.faces, projection)
    pixels = projection.project(surface.point)
    bare = mask & ~_cover(instance, mask, _BESIDE)
    own = texture_bake.sample(np.dstack([mask, bare]).astype(np.uint8), pixels) > 0.5
    visible = sight.sees(surface) & own[:, 0]
    colors = texture_bake.sample(image, pixels)
    colors = estimate_shading(colors, surface.normal, visible).remove(colors, surface.normal)
    slab = 0.5 - fit.form.thickness / fit.form.height - 1e-4
    on_top = (mesh.vertices[mesh.faces, 2] > slab).all(1)[atlas.face]
    clear = visible & own[:, 1]
    upper = clear & on_top & (surface.normal[:, 2] > 0.9)
    upper &= _within(surface.point[:, :2], on_top)
    texels = np.full(colors.shape, 200.0)
    if upper.sum() > 40:
        shade = _cover(instance, mask, _SHADE).astype(np.uint8)
        near = texture_bake.sample(shade[..., None], pixels)[:, 0] > 0.5
        dark = colors.mean(1) < _DARK * np.median(colors[upper].mean(1))
        texels[:] = np.median(colors[upper], 0)
        texels[on_top] = top_colors(surface.point, colors, upper & ~(near & dark))[on_top]
    rim = on_top & (np.abs(surface.normal[:, 2]) < 0.5)
    for part in (rim, ~on_top):
        if (clear & part).sum() > 40:
            texels[part] = np.median(colors[clear & part], 0)
    return texture_bake.apply_texture(atlas, mesh.vertices, texture_bake.lay_out(atlas, texels))


def _within(
    points: Float[np.ndarray, "t 2"], on_top: Bool[np.ndarray, "t"]
) -> Bool[np.ndarray, "t"]:
    """Return which points are not near the tabletop's edge, where the picture may show its side."""
    top = shapely.convex_hull(shapely.MultiPoint(points[on_top]))
    low, high = points[on_top].min(0), points[on_top].max(0)
    inner = top.buffer(-_EDGE * float((high - low).max()))
    return np.asarray(shapely.contains_xy(inner, points))


def _cover(
    instance: Instance, mask: Bool[np.ndarray, "h w"], reach: float
) -> Bool[np.ndarray, "h w"]:
    """Return pixels of objects over the table, dilated by ``reach`` times the crop's long side."""
    rows, columns, held = _places(instance, mask.shape[1], mask.shape[0])
    hidden = mask & ~(instance.mask[rows, columns] & held)
    brush = 2 * max(1, round(reach * max(mask.shape))) + 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (brush, brush))
    return cv2.dilate(hidden.astype(np.uint8), kernel) > 0


def top_colors(
    points: Float[np.ndarray, "t 3"], colors: Float[np.ndarray, "t 3"], clear: Bool[np.ndarray, "t"]
) -> Float[np.ndarray, "t 3"]:
    """Return the colours of a top's points: one colour if it is plain, or else the picture's.

    ``clear`` marks points where the picture shows the bare top. Elsewhere the surrounding colours
    are extended, first along the top's longer side, like grain and boards.
    """
    middle = np.median(colors[clear], 0)
    if unrest(colors[clear], _cells(points[clear])) < _PLAIN:
        return np.broadcast_to(middle, colors.shape)
    flat = points[:, :2] - points[:, :2].min(0)
    at = np.floor(flat / flat.max() * (_CELLS - 1)).astype(int)
    side = at.max(0)[::-1] + 1
    total, count = np.zeros((*side, 3), np.float32), np.zeros(side, np.float32)
    np.add.at(total, (at[clear, 1], at[clear, 0]), colors[clear])
    np.add.at(count, (at[clear, 1], at[clear, 0]), 1.0)
    strange = find_strange(total / np.maximum(count, 1)[..., None], count > 0)
    clear = clear & ~strange[at[:, 1], at[:, 0]]
    total[strange], count[strange] = 0, 0
    filled = np.broadcast_to(middle, total.shape).astype(np.float32)
    for spread in ((90.0, 12.0), (24.0, 2.5)):  # coarse first; closer colours have more weight
        weight = cv2.GaussianBlur(count, (0, 0), spread[0], sigmaY=spread[1])
        smooth = cv2.GaussianBlur(total, (0, 0), spread[0], sigmaY=spread[1])
        trust = (weight / (weight + 0.02))[..., None]
        filled = trust * smooth / np.maximum(weight, 1e-6)[..., None] + (1 - trust) * filled
    carried = texture_bake.sample(filled, at + 0.5)
    return np.where(clear[:, None], colors, carried)


def find_strange(
    colors: Float[np.ndarray, "h w 3"], known: Bool[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Return the cells of a top that show an undetected object.

    Their colours are rare on the top and adjacent to each other; grain and speckles are rare too,
    but spread all over the top.
    """
    bins = np.minimum(colors / 256 * _SHADES, _SHADES - 1).astype(int)
    histogram = np.zeros((_SHADES,) * 3, np.float32)
    np.add.at(histogram, tuple(bins[known].T), 1.0)
    for axis in range(3):  # neighbouring levels count as one colour
        histogram = ndimage.convolve1d(histogram, np.ones(3, np.float32), axis, mode="constant")
    usual = histogram[tuple(bins.reshape(-1, 3).T)].reshape(known.shape)
    rare = (known & (usual < _RARE * known.sum())).astype(np.uint8)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(rare, connectivity=8)
    area = stats[:, cv2.CC_STAT_AREA]
    alone = (area > _PATCH[0] * known.sum()) & (area < _PATCH[1] * known.sum())
    alone[0] = False
    patch = np.isin(labels, np.flatnonzero(alone)).astype(np.uint8)
    return (cv2.dilate(patch, np.ones((5, 5), np.uint8)) > 0) & known


def _cells(point: Float[np.ndarray, "t 3"], count: int = 10) -> Int[np.ndarray, "t"]:
    """Return the grid cell of each point, with ``count`` cells along the table's longest side."""
    flat = point[:, :2] - point[:, :2].min(0)
    index = np.minimum((flat / max(float(flat.max()), 1e-9) * count).astype(int), count - 1)
    return index[:, 0] * count + index[:, 1]


def unrest(colors: Float[np.ndarray, "t 3"], cell: Int[np.ndarray, "t"]) -> float:
    """Return the typical spread of brightness within cells of the surface, in grey levels.

    Light that fades across the table is almost constant within a cell and has no effect.
    """
    brightness = colors.mean(1)
    spreads = []
    for k in np.unique(cell):
        own = brightness[cell == k]
        if len(own) >= 12:
            spreads.append(float(np.subtract(*np.quantile(own, [0.95, 0.05]))))
    return float(np.median(spreads)) if spreads else 0.0
