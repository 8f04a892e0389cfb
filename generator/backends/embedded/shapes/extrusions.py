"""Slabs lying on the table and upright profiles, cut out of a silhouette."""

from __future__ import annotations

import cv2
import numpy as np
import shapely
import shapely.affinity
from jaxtyping import Bool, Float

from ....meshes.pixels import Mask
from ....meshes.projection import Projection
from .solids import PosedSolid, largest_polygon, prism, upright

_DRAWN_OUT = 5.0  # maximum ratio of an outline's length to its apparent length


def plane_outline(
    mask: Mask,
    projection: Projection,
    origin: np.ndarray,
    axes: np.ndarray,
    sweep: Float[np.ndarray, "k 3"],
    cells: int = 280,
) -> shapely.Polygon | None:
    """Return the largest outline in a plane such that its extrusion projects inside the mask.

    ``axes`` are the plane's two unit vectors (rows); ``sweep`` are the shifts of an extruded point.
    Coordinates are lengths along the axes from ``origin``. The result is None for a plane seen
    almost edge-on.
    """
    ys, xs = np.nonzero(mask)
    normal = np.cross(axes[0], axes[1])
    spread = projection.on_plane(np.column_stack([xs, ys]) + 0.5, origin, normal) - origin
    flat = spread @ axes.T
    ahead = projection.to_camera(spread + origin)[:, 2] > 0
    shown = projection.pixel * max(np.ptp(xs), np.ptp(ys)) + projection.pixel
    if not ahead.all() or np.ptp(flat, axis=0).max() > _DRAWN_OUT * shown:
        return None
    low, high = flat.min(0), flat.max(0)
    step = float((high - low).max()) / cells
    counts = np.maximum(np.ceil((high - low) / step).astype(int), 2) + 4
    start = low - 2 * step
    grid = np.stack(np.meshgrid(*(np.arange(c) for c in counts), indexing="xy"), -1) + 0.5
    points = origin + (grid * step + start) @ axes
    free = np.logical_and.reduce([projection.inside(mask, points + s) for s in sweep])
    outline = _trace(free)
    return None if outline is None else shapely.affinity.affine_transform(
        outline, [step, 0, 0, step, *(start + 0.5 * step)]
    )  # fmt: skip


def _trace(free: Bool[np.ndarray, "a b"]) -> shapely.Polygon | None:
    """Return the largest region of a grid as a simple polygon in cells, keeping large holes."""
    smooth = cv2.GaussianBlur(free.astype(np.float32), (0, 0), 0.7) > 0.42
    rings, tree = cv2.findContours(smooth.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    areas = [cv2.contourArea(ring) for ring in rings]
    outer = [k for k in range(len(rings)) if tree[0, k, 3] < 0 and areas[k] > 20]
    if not outer:
        return None
    largest = max(outer, key=lambda k: areas[k])
    least = 0.02 * areas[largest]
    holes = [k for k in range(len(rings)) if tree[0, k, 3] == largest and areas[k] > least]
    slack = 0.005 * max(free.shape)
    edge, *inner = (cv2.approxPolyDP(rings[k], slack, True)[:, 0] for k in (largest, *holes))
    if len(edge) < 3:
        return None
    grown = shapely.Polygon(edge).buffer(0.5, join_style="mitre")
    cut = [shapely.Polygon(ring) for ring in inner if len(ring) >= 3]
    outline = grown.difference(shapely.union_all([hole.buffer(0) for hole in cut]))
    outline = largest_polygon(outline)
    return outline if outline.is_valid and outline.area > 0 else None


def _longest_side(outline: shapely.Polygon) -> float:
    """Return the direction of the longer side of an outline's minimum bounding rectangle."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(outline))[:3]
    sides = np.diff(corners, axis=0)
    long = sides[int(np.linalg.norm(sides, axis=1).argmax())]
    return float(np.arctan2(long[1], long[0]))


def _swept_outline(
    mask: Mask, projection: Projection, axes: np.ndarray, sweep: np.ndarray, share: float
) -> tuple[shapely.Polygon, float] | None:
    """Fit an extruded outline in a plane through the origin; return it and the extrusion length.

    The length is ``share`` of the outline's longer side; ``sweep`` are the shifts for a length of
    1.
    """
    rough = plane_outline(mask, projection, np.zeros(3), axes, np.zeros((1, 3)), 60)
    if rough is None:
        return None
    bounds = np.array(rough.bounds)
    length = share * float((bounds[2:] - bounds[:2]).max())
    outline = plane_outline(mask, projection, np.zeros(3), axes, sweep * length)
    return None if outline is None else (outline, length)


def fit_prism(mask: Mask, projection: Projection, thickness: float) -> PosedSolid | None:
    """Return the slab on the table that fills ``mask``; thickness is relative to its length."""
    axes = np.array([[1.0, 0, 0], [0, 1.0, 0]])
    sweep = np.linspace(0, 1, 3)[:, None] * [0, 0, 1.0]
    found = _swept_outline(mask, projection, axes, sweep, thickness)
    if found is None:
        return None
    outline, height = found
    yaw = _longest_side(outline)
    center = np.array([outline.centroid.x, outline.centroid.y])
    turned = shapely.affinity.rotate(
        shapely.affinity.translate(outline, *(-center)), -yaw, origin=(0, 0), use_radians=True
    )
    return PosedSolid("prism", prism(turned, height), yaw, np.array([*center, 0.0]))


def base_line(mask: Mask, projection: Projection) -> float | None:
    """Return the yaw of the line along an object's lowest pixels, or None if it is not straight."""
    columns = np.flatnonzero(mask.any(0))
    if len(columns) < 12:
        return None
    cut = max(1, len(columns) // 12)
    columns = columns[cut:-cut]
    lowest = mask.shape[0] - 1 - mask[::-1, columns].argmax(0)
    slope, level = np.polyfit(columns, lowest, 1)
    rough = np.abs(slope * columns + level - lowest).mean()
    if rough > 0.02 * len(columns) + 0.6:
        return None
    ends = columns[[0, -1]].astype(float)
    pixels = np.column_stack([ends, slope * ends + level]) + 0.5
    a, b = projection.on_plane(pixels, np.zeros(3), np.array([0, 0, 1.0]))
    return float(np.arctan2(b[1] - a[1], b[0] - a[0]))


def fit_upright(mask: Mask, projection: Projection, yaw: float, depth: float) -> PosedSolid | None:
    """Return a vertical profile at ``yaw``, extruded to a solid that fills ``mask``.

    ``depth`` is the length of the extrusion relative to the longest side of the profile. The bottom
    is cut flat and, if the solid would tip over, widened to a foot.
    """
    axes = np.array([[np.cos(yaw), np.sin(yaw), 0.0], [0, 0, 1.0]])
    sweep = np.linspace(-0.5, 0.5, 3)[:, None] * [-np.sin(yaw), np.cos(yaw), 0.0]
    found = _swept_outline(mask, projection, axes, sweep, depth)
    if found is None:
        return None
    outline, thick = found
    standing = _stand(outline)
    x0, z0, x1, _ = standing.bounds
    middle = (x0 + x1) / 2
    standing = shapely.affinity.translate(standing, -middle, -z0)
    return PosedSolid("upright", upright(standing, thick), yaw, middle * axes[0] + [0, 0, z0])


def _stand(outline: shapely.Polygon) -> shapely.Polygon:
    """Give an upright profile (y up) a flat bottom under its centre of mass."""
    x0, y0, x1, y1 = outline.bounds
    tall = y1 - y0
    level = y0 + 0.015 * tall
    cut = outline.intersection(shapely.box(x0 - 1, level, x1 + 1, y1 + 1))
    cut = largest_polygon(cut)
    chord = cut.intersection(shapely.box(x0 - 1, level - 1, x1 + 1, level + 0.03 * tall)).bounds
    center, need = cut.centroid.x, 0.12 * max(tall, x1 - x0)
    left, right = min(chord[0], center - need), max(chord[2], center + need)
    if left < chord[0] - 1e-9 or right > chord[2] + 1e-9:
        cut = cut.union(shapely.box(left, level, right, level + 0.035 * tall))
    return largest_polygon(cut)
