"""Which generic solid a silhouette shows: one of each family is tried, the likeliest kept."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float
from scipy import spatial

from .boxes import fit_box, fit_carved
from .extrusions import base_line, fit_prism, fit_upright
from .framing import proportion_gap
from .pixels import mask_iou
from .projection import Projection
from .rounds import fit_revolution
from .solids import Posed

Mask = Bool[np.ndarray, "h w"]

_STRICT = 0.94  # a real box is met at least that well
_PRIOR = 0.05  # weight of the size prior's proportions
_ACCIDENT = 0.08  # price of an elongated thing pointing straight away from the camera


@dataclass(frozen=True)
class Price:
    """What a family costs against silhouette overlap; less if its outline is a regular one."""

    irregular: float
    regular: float


_PRICES = {
    "box": Price(0.0, 0.0),
    "revolution": Price(-0.02, -0.02),
    "prism": Price(0.14, 0.05),
    "upright": Price(0.08, 0.05),
    "carved": Price(0.035, 0.035),
}


def candidates(
    mask: Mask, small: Projection, expected: Float[np.ndarray, "3"]
) -> tuple[Posed, ...]:
    """Return the posed solids that fit the silhouette, one or two per family.

    ``expected`` are the size prior's proportions (length, width, height); they decide what the
    silhouette leaves open, such as how thick a slab is.
    """
    long, short, tall = *sorted(expected[:2], reverse=True), expected[2]
    bounding = fit_box(mask, small, expected)
    facing = float(np.arctan2(small.right[1], small.right[0]))
    yaws = [facing] + [y for y in [base_line(mask, small)] if y is not None]
    depth = float(np.clip(short / max(long, tall), 0.1, 0.22))
    found = (
        bounding,
        fit_revolution(mask, small),
        fit_prism(mask, small, float(np.clip(tall / long, 0.02, 0.3))),
        *(fit_upright(mask, small, yaw, depth) for yaw in yaws),
        fit_carved(mask, small, bounding),
    )
    return tuple(p for p in found if p is not None)


def best_solid(mask: Mask, small: Projection, expected: Float[np.ndarray, "3"]) -> Posed:
    """Return the generic solid that explains the silhouette best."""
    return max(candidates(mask, small, expected), key=lambda p: score(p, mask, small, expected))


def score(posed: Posed, mask: Mask, small: Projection, expected: Float[np.ndarray, "3"]) -> float:
    """Return how well a solid explains the picture: silhouette overlap less what it costs.

    A family that can take on any outline is cheap only where the outline is regular, a box must
    fit well; things that happen to point straight at the camera are unlikely; proportions should
    be the prior's.
    """
    overlap = mask_iou(small.silhouette(posed.world, posed.solid.faces), mask)
    price = _PRICES[posed.kind]
    cost = price.regular if is_regular(posed) else price.irregular
    if posed.kind == "box":
        cost += max(0.0, _STRICT - overlap)
    extent = np.ptp(posed.solid.vertices, axis=0)
    return overlap - cost - accident(posed, small) - _PRIOR * proportion_gap(extent, expected)


def accident(posed: Posed, small: Projection) -> float:
    """Return the price of a low, long solid whose long side points away from the camera."""
    long, wide, tall = np.ptp(posed.solid.vertices, axis=0)
    ratio = min(long / max(wide, tall), 3.0)
    along = abs(np.cos(posed.yaw) * small.away[0] + np.sin(posed.yaw) * small.away[1])
    if posed.kind in ("revolution", "upright") or ratio < 1.3 or along < np.cos(np.deg2rad(20)):
        return 0.0
    return _ACCIDENT * (ratio - 1.0) / 2.0


def is_regular(posed: Posed) -> bool:
    """Tell whether an extruded outline looks made to lie or stand like that.

    Rectangles and ellipses do, and outlines with an arm or much longer than wide.
    """
    if posed.kind not in ("prism", "upright"):
        return False
    keep = [0, 1] if posed.kind == "prism" else [0, 2]
    sweep = 2 if posed.kind == "prism" else 1
    points = posed.solid.vertices
    sides = np.ptp(points, axis=0)
    a, b, c = (points[posed.solid.faces[:, k]] for k in range(3))
    area = float((np.cross(a, b) * c).sum() / 6 / sides[sweep])
    hull = spatial.ConvexHull(points[:, keep]).volume
    filled, solid = area / np.prod(sides[keep]), area / hull
    longest = max(sides[keep]) / min(sides[keep])
    round_ = solid > 0.95 and abs(filled - np.pi / 4) < 0.04
    return bool(filled > 0.9 or round_ or solid < 0.8 or longest > 5)
