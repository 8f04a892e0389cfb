"""Selection of the generic solid for a silhouette: solids of each family are fitted and scored."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Float
from scipy import spatial

from ....meshes.pixels import Mask, dilate, mask_iou
from ....meshes.projection import Projection
from ....scene import SizePrior
from ....scene.triangles import scaled_normals
from .boxes import fit_box, fit_carved
from .extrusions import base_line, fit_prism, fit_upright, plane_outline
from .frames import bounded_gap
from .slices import best_stack, fit_slices, largest_slices, longest_run, reach_of
from .solids import ConvexSolid, PosedSolid, join, upright

_STRICT = 0.94  # minimum overlap of a real box
_LIKELY, _NAMED = 0.15, 0.1
"""Costs of proportions that are off by one expected error: the first cost applies if the
expectation is based on the object's appearance, the second if it is based on the object's name."""

_FARTHEST = 4.0  # expected errors; larger deviations cost no more

_STRAIGHT = float(np.cos(np.deg2rad(20)))
_DRAWN_OUT = ([1.05, 1.5, 2.5, 4.0, 6.0], [0.0, 0.1, 0.15, 0.1, 0.02])
"""Ratios of length to width of an outline that lies on the table, elongated towards the camera, and
their costs."""

_TOPPLING = ([3.5, 6.0, 10.0], [0.0, 0.12, 0.3])
"""Ratios of the height of an upright object to the width of its base, and their costs."""

_SHEET = ([12.0, 30.0], [0.0, 0.06])
"""Ratios of the height of an upright outline to its thickness, and their costs."""

_ACCIDENT = 0.08  # cost of an elongated object that points straight away from the camera


_PRICES = {"box": 0.0, "revolution": -0.02, "prism": 0.14, "upright": 0.1, "slices": 0.03,
           "carved": 0.045}  # fmt: skip
"""Cost of each family of shapes, in units of silhouette overlap."""

_REGULAR = {"prism": 0.05, "upright": 0.09}
"""Cost of regular extruded outlines that lie ("prism") or stand on their edge ("upright")."""


def candidates(
    mask: Mask, small: Projection, expected: Float[np.ndarray, "3"]
) -> tuple[PosedSolid, ...]:
    """Return the posed solids that fit the silhouette, one or two per family.

    ``expected`` are the proportions of the size prior (length, width, height), which decide what
    the silhouette leaves open, such as the thickness of a slab.
    """
    long, short, tall = *sorted(expected[:2], reverse=True), expected[2]
    bounding = fit_box(mask, small, expected)
    facing = float(np.arctan2(small.right[1], small.right[0]))
    yaws = [facing] + [y for y in [base_line(mask, small)] if y is not None]
    stroke = 0.6 * stroke_share(mask)
    depth = float(np.clip(short / max(long, tall), min(0.1, stroke), min(0.22, stroke)))
    thick = float(np.clip(tall / long, min(0.02, stroke), min(0.3, stroke)))
    found = (
        bounding,
        fit_revolution(mask, small),
        fit_slices(mask, small),
        fit_prism(mask, small, thick),
        *(fit_upright(mask, small, yaw, depth) for yaw in yaws),
        fit_carved(mask, small, bounding),
    )
    return tuple(p for p in found if p is not None)


def stroke_share(mask: Mask) -> float:
    """Return a silhouette's stroke width relative to its longer side, as a limit on thickness."""
    inside = cv2.distanceTransform(np.pad(mask, 1).astype(np.uint8), cv2.DIST_L2, 5)
    ridge = inside >= cv2.dilate(inside, np.ones((5, 5)))
    width = 2 * float(np.median(inside[ridge & (inside > 0)]))
    return width / max(np.ptp(np.nonzero(mask), axis=1).max(), 1)


def oddness(extent: Float[np.ndarray, "3"], size: SizePrior) -> float:
    """Return the cost of an extent whose proportions differ from the size prior."""
    if size.seen is None:
        return _NAMED * bounded_gap(extent, size.extent)
    return _LIKELY * min(size.seen.gap(extent), _FARTHEST)


def best_solid(mask: Mask, small: Projection, size: SizePrior) -> PosedSolid:
    """Return the generic solid that explains the silhouette best; see :func:`score`."""
    expected = size.extent if size.seen is None else size.seen.extent
    found = candidates(mask, small, expected)
    return max(found, key=lambda p: score(p, mask, small, size))


def score(posed: PosedSolid, mask: Mask, small: Projection, size: SizePrior) -> float:
    """Return how well a solid explains the picture: silhouette overlap minus its costs.

    Families with arbitrary outlines are cheap only if the outline is regular, a box must fit well,
    objects rarely point straight at the camera, and proportions should match the prior.
    """
    overlap = mask_iou(small.silhouette(posed.world, posed.solid.faces), mask)
    cost = _REGULAR[posed.kind] if is_regular(posed) else _PRICES[posed.kind]
    if posed.kind == "box":
        cost += max(0.0, _STRICT - overlap)
    extent = np.ptp(posed.solid.vertices, axis=0)
    return overlap - cost - accident(posed, small) - oddness(extent, size)


def accident(posed: PosedSolid, small: Projection) -> float:
    """Return the penalty for a low solid that points at the camera, or for a tall, thin solid.

    An upright object that is modelled as lying seems elongated towards the camera, so the cost of a
    lying outline begins early and grows steeply. Rectangles are often aligned with the camera and
    cost as much as boxes.
    """
    long, wide, tall = np.ptp(posed.solid.vertices, axis=0)
    if posed.kind in ("revolution", "upright", "slices"):
        sheet = np.interp(tall / wide, *_SHEET) if posed.kind == "upright" else 0.0
        base = max(np.sqrt(long * wide), long / 2)  # the depth is hardly visible
        return float(np.interp(tall / base, *_TOPPLING) + sheet)
    ratio = min(long / max(wide, tall), 3.0)
    along = abs(np.cos(posed.yaw) * small.away[0] + np.sin(posed.yaw) * small.away[1])
    price = _ACCIDENT * (ratio - 1.0) / 2.0 if ratio >= 1.3 and along > _STRAIGHT else 0.0
    if posed.kind == "prism" and not _rectangular(posed):
        spread, way = _drawn_out(posed)
        if abs(way @ small.away[:2]) > _STRAIGHT:
            price = max(price, float(np.interp(spread, *_DRAWN_OUT)))
    return float(price)


def _drawn_out(posed: PosedSolid) -> tuple[float, Float[np.ndarray, "2"]]:
    """Return the length-to-width ratio of a lying solid's top, and the direction of its length."""
    triangles = posed.world[posed.solid.faces]
    weight = np.maximum(scaled_normals(triangles)[:, 2], 0.0)
    points = triangles[:, :, :2].mean(1)
    middle = weight @ points / weight.sum()
    # The second moment of a triangle about its centroid is a twelfth of its corners'.
    corners = triangles[:, :, :2] - middle
    moment = np.einsum("t,tki,tkj->ij", weight, corners, corners)
    moment += 9 * np.einsum("t,ti,tj->ij", weight, points - middle, points - middle)
    values, ways = np.linalg.eigh(moment)
    return float(np.sqrt(values[1] / max(values[0], 1e-12))), ways[:, 1]


def _rectangular(posed: PosedSolid) -> bool:
    """Return whether a lying outline nearly fills its bounding rectangle."""
    sides = np.ptp(posed.solid.vertices, axis=0)
    return _area(posed, 2) > 0.9 * sides[0] * sides[1]


def _area(posed: PosedSolid, sweep: int) -> float:
    """Return an extruded outline's area: the solid's volume divided by the extrusion length."""
    points = posed.solid.vertices
    a, b, c = (points[posed.solid.faces[:, k]] for k in range(3))
    return float((np.cross(a, b) * c).sum() / 6 / np.ptp(points[:, sweep]))


def is_regular(posed: PosedSolid) -> bool:
    """Return whether an extruded outline has a regular shape.

    Rectangles and ellipses have one, and so do outlines that have an arm or are much longer than
    wide.
    """
    if posed.kind not in ("prism", "upright"):
        return False
    keep, sweep = ([0, 1], 2) if posed.kind == "prism" else ([0, 2], 1)
    points = posed.solid.vertices
    sides = np.ptp(points, axis=0)
    area = _area(posed, sweep)
    hull = spatial.ConvexHull(points[:, keep]).volume
    filled, solid = area / np.prod(sides[keep]), area / hull
    longest = max(sides[keep]) / min(sides[keep])
    round_ = solid > 0.95 and abs(filled - np.pi / 4) < 0.04
    return bool(filled > 0.9 or round_ or solid < 0.8 or longest > 5)


_LIMB = 0.015  # minimum area of a handle or a spout, as a fraction of the silhouette
_LIMBS = 3


def fit_revolution(mask: Mask, projection: Projection) -> PosedSolid | None:
    """Return the solid of revolution about a vertical axis, or None if no round solid fits."""
    width, tall = reach_of(mask, projection)
    heights = np.linspace(-tall, tall, 90)
    found = []
    for offset in np.linspace(-0.2, 0.2, 7) * width:
        stack = largest_slices(mask, projection, heights, np.array([offset]), 1.0, 36)
        stack = longest_run(stack, 0.012 * width)
        if stack is not None:
            found.append(stack)
    best = best_stack(found, mask, projection, free=False)
    if best is None:
        return None
    return _with_handle(best.pose("revolution", projection), mask, projection)


def _with_handle(body: PosedSolid, mask: Mask, projection: Projection) -> PosedSolid:
    """Add the few largest protruding parts of a round body as flat pieces facing the camera."""
    covered = projection.silhouette(body.world, body.solid.faces)
    rest = cv2.morphologyEx(
        (mask & ~covered).astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)
    )
    count, labels, stats, _ = cv2.connectedComponentsWithStats(rest)
    order = 1 + np.argsort(-stats[1:count, cv2.CC_STAT_AREA], kind="stable")
    solids = [body.solid]
    for k in order[:_LIMBS]:
        if stats[k, cv2.CC_STAT_AREA] < _LIMB * mask.sum():
            break
        limb = _limb((labels == k) & mask, mask, body, projection)
        if limb is not None:
            solids.append(limb)
    return PosedSolid("revolution", join(solids), body.yaw, body.position)


def _limb(piece: Mask, mask: Mask, body: PosedSolid, projection: Projection) -> ConvexSolid | None:
    """Convert a part of the silhouette beside a body to a flat solid that reaches into the body."""
    grown = dilate(piece, 7) & mask
    axes = np.array([projection.right, [0, 0, 1.0]])
    outline = plane_outline(grown, projection, body.position, axes, np.zeros((1, 3)))
    if outline is None or outline.bounds[1] < 0:
        return None
    across = float(np.ptp(body.solid.vertices[:, 0]))
    low, _, high, _ = outline.bounds
    return upright(outline, min(0.16 * across, 0.8 * (high - low)))
