"""Fit generic solids to a silhouette: the largest solid of a family that stays inside the mask.

Each ``fit_*`` gets the mask of the object and the projection it is seen under, both small (about
150 pixels), and returns the solid posed in the object frame, or None where the family has no
member that fits.
"""

from __future__ import annotations

import cv2
import numpy as np
import shapely
from jaxtyping import Bool, Float
from scipy import optimize

from ...geometry import rotation_z
from .framing import frame_to_mask, proportion_gap, simplex
from .projection import Projection, fill_hull, mask_iou
from .solids import Posed, Solid, box, heightfield, prism, revolution, simplify_profile, upright

_CIRCLE = np.column_stack(
    [np.cos(np.arange(32) * np.pi / 16), np.sin(np.arange(32) * np.pi / 16), np.zeros(32)]
)
_UNIT_BOX = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0.0, 1.0)])

Mask = Bool[np.ndarray, "h w"]


# ---------------------------------------------------------------------------------------- boxes


def _box_at(parameters: np.ndarray, projection: Projection, mask: Mask) -> tuple[np.ndarray, float, np.ndarray]:
    yaw, width, height = parameters[0], np.exp(parameters[1]), np.exp(parameters[2])
    corners = (_UNIT_BOX * [width, 1.0, height]) @ rotation_z(yaw).T
    scale, shift = frame_to_mask(corners, projection, mask)
    return corners * scale + shift, scale, shift


def fit_box(
    mask: Mask, projection: Projection, expected: Float[np.ndarray, "3"] | None = None
) -> Posed:
    """Return the upright box, any yaw, whose silhouette agrees best with ``mask``.

    ``expected`` are proportions (length, width, height) that break ties.
    """

    def loss(parameters: np.ndarray) -> float:
        if not (-1.6 < parameters[1] < 3 and -4 < parameters[2] < 3):
            return 2.0
        corners, *_ = _box_at(parameters, projection, mask)
        value = 1 - mask_iou(projection.hull_silhouette(corners), mask)
        if expected is not None:
            sides = np.array([np.exp(parameters[1]), 1.0, np.exp(parameters[2])])
            value += 0.01 * proportion_gap(sides, expected)
        return value

    grid = [
        np.array([yaw, np.log(w), np.log(h)])
        for yaw in np.arange(12) * np.pi / 12 + 0.02
        for w in (1.0, 1.5, 2.3, 4.0)
        for h in (0.07, 0.2, 0.45, 0.9, 1.7, 3.0)
    ]
    starts = sorted(grid, key=loss)[:4]
    found = [
        optimize.minimize(loss, s, method="Nelder-Mead",
                          options={"maxfev": 110, "initial_simplex": simplex(s, (0.15, 0.2, 0.25))})
        for s in starts
    ]
    best = min(found, key=lambda r: r.fun).x
    _, scale, shift = _box_at(best, projection, mask)
    width, height, yaw = float(np.exp(best[1])), float(np.exp(best[2])), float(best[0])
    if width < 1:
        return Posed("box", box(scale, scale * width, scale * height), yaw + np.pi / 2, shift)
    return Posed("box", box(scale * width, scale, scale * height), yaw, shift)


# ----------------------------------------------------------------------------------- revolution


def _stack(
    projection: Projection, axis: np.ndarray, heights: np.ndarray, radii: np.ndarray
) -> Mask:
    canvas = np.zeros((projection.height, projection.width), np.uint8)
    rings = [projection.project(_CIRCLE * r + axis + [0, 0, z]) for z, r in zip(heights, radii, strict=True)]
    for lower, upper in zip(rings[:-1], rings[1:], strict=True):
        fill_hull(canvas, np.concatenate([lower, upper]))
    return canvas > 0


def _largest_radii(
    mask: Mask, projection: Projection, axis: np.ndarray, heights: np.ndarray, reach: float
) -> np.ndarray:
    """Return per height the radius of the largest circle about the axis whose picture is inside."""
    radii = np.linspace(0, reach, 56)[1:]
    points = _CIRCLE[None, None] * radii[None, :, None, None] + axis
    points = points + np.array([0, 0, 1.0]) * heights[:, None, None, None]
    fits = projection.inside(mask, points).mean(-1) > 0.97
    count = np.cumprod(fits, axis=1).sum(1)
    return np.where(count > 0, radii[np.maximum(count - 1, 0)], 0.0)


def fit_revolution(mask: Mask, projection: Projection) -> Posed | None:
    """Return the solid of revolution about a vertical axis, or None if nothing round fits.

    The largest profile comes from circles inside the silhouette. What a flat top or bottom hides
    is ambiguous, so the base is put as high and the top as low as the silhouette allows.
    """
    width = int(mask.any(0).sum())
    unit = float(np.linalg.norm(projection.position)) / projection.focal
    reach, tall = 0.62 * width * unit, 1.3 * int(mask.any(1).sum()) * unit
    tall /= max(np.sqrt(1 - projection.sine**2), 0.25)
    heights = np.linspace(-tall, tall, 120)
    best: tuple[float, np.ndarray, np.ndarray, np.ndarray] | None = None
    for offset in np.linspace(-0.2, 0.2, 9):
        axis = offset * width * unit * projection.right
        radii = _largest_radii(mask, projection, axis, heights, reach)
        run = _longest_run(radii > 0.02 * reach)
        if run is None:
            continue
        z, r = heights[run], radii[run]
        score = mask_iou(_stack(projection, axis, z, r), mask)
        if best is None or score > best[0]:
            best = (score, axis, z, r)
    if best is None:
        return None
    _, axis, z, r = best
    z, r = _trim(mask, projection, axis, z, r)
    r = np.convolve(np.pad(r, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    keep = simplify_profile(z, r, 18, 0.012)
    axis = axis + [0, 0, z[0]]
    return Posed("revolution", revolution(z[keep] - z[0], r[keep]), 0.0, axis)


def _longest_run(flags: np.ndarray) -> slice | None:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    runs = [(b - a, a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    if not runs or max(runs)[0] < 4:
        return None
    _, start, stop = max(runs)
    return slice(start, stop)


def _trim(
    mask: Mask, projection: Projection, axis: np.ndarray, z: np.ndarray, r: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Cut the profile's ends as far as the silhouette does not notice."""
    whole = mask_iou(_stack(projection, axis, z, r), mask)

    def longest(cut: list[tuple[int, int]]) -> tuple[int, int]:
        low, high = 0, len(cut) - 1
        while low < high:
            middle = (low + high + 1) // 2
            a, b = cut[middle]
            score = mask_iou(_stack(projection, axis, z[a:b], r[a:b]), mask)
            low, high = (middle, high) if score > whole - 0.006 else (low, middle - 1)
        return cut[low]

    a, _ = longest([(k, len(z)) for k in range(len(z) - 3)])
    _, b = longest([(a, k) for k in range(len(z), a + 2, -1)])
    return z[a:b], r[a:b]


# ------------------------------------------------------------------------------------- extrusion


def _plane_outline(
    mask: Mask,
    projection: Projection,
    origin: np.ndarray,
    axes: np.ndarray,
    sweep: Float[np.ndarray, "k 3"],
    cells: int = 150,
) -> shapely.Polygon | None:
    """Return the largest outline in a plane whose swept picture stays inside the mask.

    ``axes`` are the plane's two unit vectors (rows); ``sweep`` the shifts that an extruded point
    goes through. Coordinates are lengths along the axes from ``origin``.
    """
    ys, xs = np.nonzero(mask)
    normal = np.cross(axes[0], axes[1])
    spread = projection.on_plane(np.column_stack([xs, ys]) + 0.5, origin, normal) - origin
    flat = spread @ axes.T
    low, high = flat.min(0), flat.max(0)
    step = float((high - low).max()) / cells
    counts = np.maximum(np.ceil((high - low) / step).astype(int), 2) + 4
    start = low - 2 * step
    grid = np.stack(np.meshgrid(*(np.arange(c) for c in counts), indexing="xy"), -1) + 0.5
    points = origin + (grid * step + start) @ axes
    free = np.logical_and.reduce([projection.inside(mask, points + s) for s in sweep])
    smooth = cv2.GaussianBlur(free.astype(np.float32), (0, 0), 1.2) > 0.5
    contours, _ = cv2.findContours(smooth.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    contours = [c for c in contours if cv2.contourArea(c) > 20]
    if not contours:
        return None
    ring = max(contours, key=cv2.contourArea)
    ring = cv2.approxPolyDP(ring, 0.012 * cells, True)[:, 0].astype(float)
    if len(ring) < 3:
        return None
    outline = shapely.Polygon((ring + 0.5) * step + start).buffer(0.5 * step, join_style="mitre").buffer(0)
    if isinstance(outline, shapely.MultiPolygon):
        outline = max(outline.geoms, key=lambda g: g.area)
    outline = shapely.Polygon(outline.exterior)
    return outline if outline.is_valid and outline.area > 0 else None


def _longest_side(outline: shapely.Polygon) -> float:
    """Return the direction of the longer side of the smallest rectangle around an outline."""
    corners = np.asarray(shapely.minimum_rotated_rectangle(outline).exterior.coords)[:3]
    sides = np.diff(corners, axis=0)
    long = sides[int(np.linalg.norm(sides, axis=1).argmax())]
    return float(np.arctan2(long[1], long[0]))


def fit_prism(mask: Mask, projection: Projection, thickness: float) -> Posed | None:
    """Return the flat slab lying on the table that fills ``mask``.

    ``thickness`` is relative to the longest side.
    """
    axes = np.array([[1.0, 0, 0], [0, 1.0, 0]])
    rough = _plane_outline(mask, projection, np.zeros(3), axes, np.zeros((1, 3)), 60)
    if rough is None:
        return None
    bounds = np.array(rough.bounds)
    height = thickness * float((bounds[2:] - bounds[:2]).max())
    sweep = np.linspace(0, 1, 3)[:, None] * [0, 0, height]
    outline = _plane_outline(mask, projection, np.zeros(3), axes, sweep)
    if outline is None:
        return None
    yaw = _longest_side(outline)
    center = np.array([outline.centroid.x, outline.centroid.y])
    turned = shapely.affinity.rotate(
        shapely.affinity.translate(outline, *(-center)), -yaw, origin=(0, 0), use_radians=True
    )
    return Posed("prism", prism(turned, height), yaw, np.array([*center, 0.0]))


def base_line(mask: Mask, projection: Projection) -> float | None:
    """Return the yaw of the straight lower edge of a standing object, or None without one.

    The lowest pixels of the columns are taken as the edge where the object meets the table.
    """
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


def fit_upright(mask: Mask, projection: Projection, yaw: float, depth: float) -> Posed | None:
    """Return the standing profile in the vertical plane of ``yaw`` that fills ``mask``.

    ``depth`` of the extrusion is relative to the longest side of the profile. The bottom is cut
    flat and, where it would tip, widened to a foot.
    """
    axes = np.array([[np.cos(yaw), np.sin(yaw), 0.0], [0, 0, 1.0]])
    normal = np.array([-np.sin(yaw), np.cos(yaw), 0.0])
    rough = _plane_outline(mask, projection, np.zeros(3), axes, np.zeros((1, 3)), 60)
    if rough is None:
        return None
    bounds = np.array(rough.bounds)
    thick = depth * float((bounds[2:] - bounds[:2]).max())
    sweep = np.linspace(-0.5, 0.5, 3)[:, None] * normal * thick
    outline = _plane_outline(mask, projection, np.zeros(3), axes, sweep)
    if outline is None:
        return None
    standing = _stand(outline)
    x0, z0, x1, _ = standing.bounds
    middle = (x0 + x1) / 2
    standing = shapely.affinity.translate(standing, -middle, -z0)
    return Posed("upright", upright(standing, thick), yaw, middle * axes[0] + [0, 0, z0])


def _stand(outline: shapely.Polygon) -> shapely.Polygon:
    """Give a standing profile (y up) a flat bottom under its centre of mass."""
    x0, y0, x1, y1 = outline.bounds
    tall = y1 - y0
    level = y0 + 0.015 * tall
    cut = outline.intersection(shapely.box(x0 - 1, level, x1 + 1, y1 + 1))
    if isinstance(cut, shapely.MultiPolygon):
        cut = max(cut.geoms, key=lambda g: g.area)
    chord = cut.intersection(shapely.box(x0 - 1, level - 1, x1 + 1, level + 0.03 * tall)).bounds
    center, need = cut.centroid.x, 0.12 * max(tall, x1 - x0)
    left, right = min(chord[0], center - need), max(chord[2], center + need)
    if left < chord[0] - 1e-9 or right > chord[2] + 1e-9:
        cut = cut.union(shapely.box(left, level, right, level + 0.035 * tall))
    if isinstance(cut, shapely.MultiPolygon):
        cut = max(cut.geoms, key=lambda g: g.area)
    return shapely.Polygon(cut.exterior)


# ------------------------------------------------------------------------------- carved in a box


def fit_carved(mask: Mask, projection: Projection, bounding: Posed, cells: int = 26) -> Posed | None:
    """Return what the silhouette leaves of a box when carved as columns from above.

    Mirrored halves of the box are made alike where the silhouette allows.
    """
    width, depth, height = np.ptp(bounding.solid.vertices, axis=0)
    x, y = np.meshgrid(
        np.linspace(-width / 2, width / 2, cells), np.linspace(-depth / 2, depth / 2, cells), indexing="ij"
    )
    turn = rotation_z(bounding.yaw)
    base = np.stack([x, y, np.zeros_like(x)], -1) @ turn.T + bounding.position
    levels = np.linspace(0, 1.3 * height, 40)
    columns = base[None] + levels[:, None, None, None] * np.array([0, 0, 1.0])
    inside = np.cumprod(projection.inside(mask, columns), axis=0).sum(0)
    heights = np.where(inside > 1, levels[np.maximum(inside - 1, 0)], 0.0)
    if (heights > 0).sum() < 9:
        return None

    def posed(grid: np.ndarray) -> Posed:
        return Posed("carved", heightfield(grid, width, depth), bounding.yaw, bounding.position)

    def score(grid: np.ndarray) -> float:
        candidate = posed(grid)
        return mask_iou(projection.silhouette(candidate.world, candidate.solid.faces), mask)

    reached = score(heights)
    for mirrored in (np.minimum(heights, heights[:, ::-1]), np.minimum(heights, heights[::-1])):
        if (mirrored > 0).sum() >= 9 and score(mirrored) > reached - 0.02:
            heights = np.minimum(heights, mirrored)
    return recentered(posed(heights))


def recentered(posed: Posed) -> Posed:
    """Move a solid's own origin to the middle of its base."""
    low, high = posed.solid.vertices.min(0), posed.solid.vertices.max(0)
    shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    from ...scene import ConvexPart

    parts = tuple(ConvexPart(p.vertices - shift, p.kind, p.axis) for p in posed.solid.parts)
    solid = Solid(posed.solid.vertices - shift, posed.solid.faces, parts)
    return Posed(posed.kind, solid, posed.yaw, posed.position + rotation_z(posed.yaw) @ shift)
