"""Affordances of scene objects for a parallel gripper, computed from their collision shapes.

Pure functions of ``generator.scene.Object``. Poses are in the world frame, openings in the object's
body frame (metres). The functions determine which objects a robot could manipulate; the expert
plans the grasps themselves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy import ndimage
from scipy.spatial import ConvexHull

from generator.geometry import convex_outline, hull_points, quaternion_matrix
from generator.scene import ConvexPart, Object

GRIPPER_OPENING = 0.08
"""Maximum opening of the Franka hand, in metres."""

FINGER_CLEARANCE = 0.006
"""Total clearance on the two sides of an object between the open fingers, in metres."""

WIDEST = GRIPPER_OPENING - FINGER_CLEARANCE
"""Width of the widest object that the fingers can span, in metres."""

MAX_MASS = 1.5
"""Maximum mass, in kg, of an object that can be grasped by friction (the arm's payload is 3 kg)."""

MIN_HEIGHT = 0.012
"""Height of the flattest object that the fingers can pick up from a table top, in metres."""

WALL_DEPTH = 0.015
"""Minimum depth of a hollow that counts as an opening, in metres."""

THICKEST_WALL = 0.03
"""Maximum thickness of a wall that can be grasped at its rim, in metres."""

WIDEST_FLARE = 0.5
"""Maximum outward slope of a wall that can be grasped at its rim (metres per metre). A hand that
points straight down slips off steeper slopes."""

LEVEL = 0.003
"""Maximum unevenness of a flat top, in metres."""

_GRID = 48
_FINE = 0.002  # metres, about the thickness of walls
_MIN_HOLLOW = 8 / _GRID**2  # fraction of the bounding rectangle
_BLOCK = 2**16  # numbers per block, sized to fit the processor's cache
_UPRIGHT = np.cos(np.deg2rad(20.0))


@dataclass(frozen=True, eq=False)
class Opening:
    """The hollow of a container, as an upright elliptic cylinder in the body frame.

    ``center`` (x, y) and ``semi`` (semi-axes along the body's x and y, metres) describe the clear
    cross-section; ``floor`` (of the hollow) and ``rim`` are z coordinates; ``wall`` is the
    thickness of the wall at the rim and ``thickness`` that of the floor; ``flare`` is the slope of
    the hollow's radius over height (0 for upright walls, 1 for 45 degrees).
    """

    center: Float[np.ndarray, "2"]
    semi: Float[np.ndarray, "2"]
    floor: float
    rim: float
    wall: float
    thickness: float
    flare: float

    @property
    def depth(self) -> float:
        """The height of the rim above the floor of the hollow, in metres."""
        return self.rim - self.floor


def collision_points(obj: Object) -> Float[np.ndarray, "n 3"]:
    """Return all vertices of the collision parts in the body frame."""
    return np.concatenate([part.vertices for part in obj.parts])


def outer_points(obj: Object, most: int) -> Float[np.ndarray, "n 3"]:
    """Return the hull vertices of an object's collision parts, in the body frame.

    At most ``most`` vertices are returned, each the outermost one in some direction.
    """
    points = hull_points(collision_points(obj))
    if len(points) <= most:
        return points
    number = np.arange(most) + 0.5
    height, bearing = 1 - 2 * number / most, number * np.pi * (1 + np.sqrt(5))
    across = np.sqrt(1 - height**2)
    directions = np.stack([across * np.cos(bearing), across * np.sin(bearing), height])
    return points[np.unique((points @ directions).argmax(0))]


def grasp_width(obj: Object) -> float:
    """Return the smallest horizontal width of the resting object over all yaw angles, in metres."""
    points = (collision_points(obj) @ quaternion_matrix(obj.pose.quaternion).T)[:, :2]
    angles = np.linspace(0, np.pi, 36, endpoint=False)
    across = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float(np.ptp(across, axis=0).min())


def resting_height(obj: Object) -> float:
    """Return the height of the resting object in metres."""
    return float(np.ptp(collision_points(obj) @ quaternion_matrix(obj.pose.quaternion)[2]))


def footprint(obj: Object) -> Float[np.ndarray, "k 2"]:
    """Return the convex outline of the resting object, seen from above, in the world frame."""
    turned = collision_points(obj) @ quaternion_matrix(obj.pose.quaternion).T
    return convex_outline((turned + obj.pose.position)[:, :2])


def why_not_graspable(obj: Object, hollow: Opening | None) -> str | None:
    """Return why a parallel gripper cannot grasp the resting object, or None if it can.

    ``hollow`` is the object's ``opening``: objects too wide for the fingers can be grasped at a
    thin wall.
    """
    if (reason := why_not_liftable(obj)) is not None:
        return reason
    if not is_too_wide(obj):
        return None
    if hollow is not None and hollow.wall <= THICKEST_WALL and hollow.depth >= 2 * WALL_DEPTH:
        return None if hollow.flare <= WIDEST_FLARE else "the walls lean too far to be gripped"
    wide = f"the object is {100 * grasp_width(obj):.1f} cm wide"
    return f"{wide}, but the gripper spans only {100 * WIDEST:.1f} cm"


def why_not_liftable(obj: Object) -> str | None:
    """Return why no grasp could lift the object, or None if some grasp might."""
    if obj.mass > MAX_MASS:
        return f"the mass of {obj.mass:.3g} kg exceeds {MAX_MASS} kg"
    height = resting_height(obj)
    if height < MIN_HEIGHT:
        return f"the height of {1000 * height:.0f} mm is less than {1000 * MIN_HEIGHT:.0f} mm"
    return None


def is_too_wide(obj: Object) -> bool:
    """Return whether the resting object is too wide for the fingers in every direction."""
    return grasp_width(obj) > WIDEST


def is_upright(obj: Object) -> bool:
    """Return whether the object rests within 20 degrees of its canonical orientation."""
    return bool(quaternion_matrix(obj.pose.quaternion)[2, 2] >= _UPRIGHT)


def opening(obj: Object) -> Opening | None:
    """Return the hollow of a container, or None if the object has none.

    The collision parts are scanned from above on a grid. The hollow is the region at least
    ``WALL_DEPTH`` below the rim, which is the highest surface around it. If the scan shows no
    hollow in an object whose model is a container, a finer scan follows (the wall may be thinner
    than a cell, or a handle may rise above the rim); the rim is then the height at which the hollow
    would overflow.
    """
    scan = _scan(obj, np.array([_GRID, _GRID]))
    top, outside = scan.top, _outside(scan.top)
    rim = float(np.quantile(top[np.isfinite(top)], 0.98))
    found = _opening(scan, rim, _hollow(top, rim - WALL_DEPTH, outside))
    if found is not None or not obj.model.container:
        return found
    fine = np.ceil((scan.high - scan.low)[:2] / _FINE).astype(int)
    scan = _scan(obj, np.maximum(fine, _GRID))
    top = np.asarray(ndimage.grey_closing(scan.top, 3))  # without hairline gaps between parts
    outside = _outside(top)
    for rim in np.arange(scan.high[2], scan.low[2] + WALL_DEPTH, -LEVEL):
        basin = _hollow(top, float(rim), outside)
        inner = basin & (top < rim - WALL_DEPTH)
        if 2 * inner.sum() > basin.sum():  # ignore the rim of a full cup
            return _opening(scan, float(rim), inner)
    return None


class _Scan(NamedTuple):
    """A scan of a body from above: its bounding box, and each cell's position and height (m)."""

    low: Float[np.ndarray, "3"]
    high: Float[np.ndarray, "3"]
    x: Float[np.ndarray, "nx ny"]
    y: Float[np.ndarray, "nx ny"]
    top: Float[np.ndarray, "nx ny"]


def _scan(obj: Object, count: Int[np.ndarray, "2"]) -> _Scan:
    """Scan an object from above on a grid of ``count`` cells along the body's x and y axes."""
    low, high = (f(collision_points(obj), axis=0) for f in (np.min, np.max))
    cell = (high - low)[:2] / count
    middles = [low[k] + cell[k] * (np.arange(count[k]) + 0.5) for k in (0, 1)]
    x, y = np.meshgrid(*middles, indexing="ij")
    return _Scan(low, high, x, y, scan_surface(obj.parts, middles))


def _opening(scan: _Scan, rim: float, inner: Bool[np.ndarray, "nx ny"]) -> Opening | None:
    """Return the opening of the cells ``inner`` below ``rim``, or None if it is too shallow."""
    low, high, x, y, top = scan
    if not inner.any():
        return None
    floor = float(np.quantile(top[inner], 0.05))
    if rim - floor < WALL_DEPTH:
        return None
    cell = (high - low)[:2] / top.shape
    center = np.array([x[inner].mean(), y[inner].mean()])
    spans = np.array([np.ptp(x[inner]), np.ptp(y[inner])]) + cell
    wall = float(((high - low)[:2] - spans).min() / 2)
    below, above = floor + 0.25 * (rim - floor), rim - WALL_DEPTH
    narrow, wide = (
        np.sqrt((inner & (top < z)).sum() * cell.prod() / np.pi) for z in (below, above)
    )
    flare = float((wide - narrow) / (above - below)) if above > below + 1e-3 else 0.0
    return Opening(center, spans / 2, floor, rim, wall, floor - float(low[2]), flare)


@dataclass(frozen=True, eq=False)
class Plateau:
    """The largest disc on an object's flat top, in the body frame and in metres."""

    center: Float[np.ndarray, "3"]
    radius: float


def plateau(obj: Object) -> Plateau | None:
    """Return the flat top of the resting object, or None if it has none.

    A grid cell is flat if it lies within ``LEVEL`` of the highest surface. The disc is the largest
    one that covers only flat cells.
    """
    turn = quaternion_matrix(obj.pose.quaternion)
    parts = tuple(ConvexPart(part.vertices @ turn.T) for part in obj.parts)
    points = np.concatenate([part.vertices for part in parts])
    low, high = points.min(0), points.max(0)
    cell = float((high - low)[:2].max()) / _GRID
    axes = [np.arange(low[k] + cell / 2, high[k], cell) for k in (0, 1)]
    x, y = np.meshgrid(*axes, indexing="ij")
    top = scan_surface(parts, axes)
    flat = np.pad(top >= top.max() - LEVEL, 1)
    depth = np.asarray(ndimage.distance_transform_edt(flat))[1:-1, 1:-1]
    row, column = np.unravel_index(int(depth.argmax()), depth.shape)
    radius = (float(depth[row, column]) - 0.5) * cell
    if radius <= 0:
        return None
    return Plateau(np.array([x[row, column], y[row, column], float(top.max())]) @ turn, radius)


def _outside(top: Float[np.ndarray, "nx ny"]) -> Bool[np.ndarray, "nx ny"]:
    """Return a mask of the cells outside a solid, extended by one cell into the solid."""
    # Parts may leave hairline gaps between them.
    whole = np.asarray(ndimage.binary_fill_holes(np.isfinite(top)), dtype=bool)
    return ndimage.binary_dilation(np.pad(~whole, 1, constant_values=True))[1:-1, 1:-1]


def _hollow(
    top: Float[np.ndarray, "nx ny"], level: float, outside: Bool[np.ndarray, "nx ny"]
) -> Bool[np.ndarray, "nx ny"]:
    """Return a mask of the largest region below ``level`` that is separate from ``outside``."""
    labels = np.empty(top.shape, dtype=np.int32)
    ndimage.label(np.isfinite(top) & (top < level), output=labels)  # type: ignore[arg-type]
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0
    sizes[labels[outside]] = 0
    best = int(sizes.argmax())
    return (labels == best) & (sizes[best] > _MIN_HOLLOW * top.size)


def scan_surface(
    parts: Iterable[ConvexPart], axes: Sequence[Float[np.ndarray, "_"]]
) -> Float[np.ndarray, "nx ny"]:
    """Return the height of the highest surface at each grid point, or -inf where there is none."""
    heights = np.full((len(axes[0]), len(axes[1])), -np.inf)
    for part, cells, points in cells_under(parts, axes):
        window = heights[cells]
        np.maximum(window, top_surface((part,), points).reshape(window.shape), out=window)
    return heights


def cells_under(
    parts: Iterable[ConvexPart], axes: Sequence[Float[np.ndarray, "_"]]
) -> Iterator[tuple[ConvexPart, tuple[slice, slice], Float[np.ndarray, "n 2"]]]:
    """Yield each part over a grid, with the cells in the part's bounds and the cells' positions."""
    for part in parts:
        low, high = part.bounds
        i, j = (
            slice(int(axis.searchsorted(low[k])), int(axis.searchsorted(high[k], "right")))
            for k, axis in enumerate(axes)
        )
        if i.start < i.stop and j.start < j.stop:
            x, y = np.meshgrid(axes[0][i], axes[1][j], indexing="ij")
            yield part, (i, j), np.column_stack([x.ravel(), y.ravel()])


def top_surface(
    parts: tuple[ConvexPart, ...], points: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n"]:
    """Return the height of the highest surface at each (x, y), or -inf where there is none."""
    best = np.full(len(points), -np.inf)
    for part in parts:
        hit, _, ceiling = part_span(part, points)
        best[hit] = np.maximum(best[hit], ceiling)
    return best


def part_span(
    part: ConvexPart, points: Float[np.ndarray, "n 2"]
) -> tuple[Int[np.ndarray, "m"], Float[np.ndarray, "m"], Float[np.ndarray, "m"]]:
    """Return the indices of points (x, y) over a part, and the part's extent in height there.

    The surfaces are the highest downward-facing and the lowest upward-facing plane of its hull.
    """
    low, high = part.bounds[:, :2]
    near = np.flatnonzero(((points >= low) & (points <= high)).all(1))
    if not len(near):
        return near, np.empty(0), np.empty(0)
    planes = _planes(part)
    block = max(_BLOCK // len(planes), 1)
    spans = [_span(planes, points[near[k : k + block]]) for k in range(0, len(near), block)]
    hit, ground, ceiling = (np.concatenate(values) for values in zip(*spans, strict=True))
    return near[hit], ground[hit], ceiling[hit]


@lru_cache(maxsize=1024)
def _planes(part: ConvexPart) -> Float[np.ndarray, "p 4"]:
    """Return the planes of the faces of a part's hull: outward normals, and offsets in metres."""
    return ConvexHull(part.vertices, qhull_options="QJ").equations


def _span(
    planes: Float[np.ndarray, "p 4"], points: Float[np.ndarray, "n 2"]
) -> tuple[Bool[np.ndarray, "n"], Float[np.ndarray, "n"], Float[np.ndarray, "n"]]:
    """Return whether each (x, y) is over the hull, and the hull's lower and upper heights there."""
    # Avoid a matrix product: at this size it wakes BLAS threads, which then spin for 80 ms.
    nz = planes[:, 2]
    upper, lower, wall = (planes[k] for k in (nz > 1e-9, nz < -1e-9, np.abs(nz) <= 1e-9))
    ceiling = (_over(upper, points) / -upper[:, 2:3]).min(0, initial=np.inf)
    ground = (_over(lower, points) / -lower[:, 2:3]).max(0, initial=-np.inf)
    return (ceiling >= ground) & (_over(wall, points) <= 0).all(0), ground, ceiling


def _over(
    planes: Float[np.ndarray, "p 4"], points: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "p n"]:
    """Return the signed distance of each point (x, y, 0) from each plane."""
    return planes[:, :1] * points[:, 0] + planes[:, 1:2] * points[:, 1] + planes[:, 3:]
