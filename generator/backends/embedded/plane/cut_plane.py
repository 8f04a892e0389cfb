"""The outline of a tabletop that the frame cuts off: its edges where visible, or else the frame.

The usual fit (``plane``) explains a complete outline and estimates the camera from it. In a
close-up, or if the frame cuts it, an outline does not determine the camera. Here the camera is
given (by a depth map or by an estimate), and only the top's position, yaw and size on the plane are
fitted. Each point of the region's hull is either a *true* edge, on which the outline must lie, or
only *visible* (at the frame, beside an object, or where depth is unknown): the outline must contain
it and may extend further.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float
from scipy.optimize import least_squares

from ....errors import SceneError
from ....geometry import Camera, convex_outline, rotation_z, view_rotation, wrap
from ....meshes.pixels import dilate, distance_to, hull_corners, main_parts
from ....scene import View
from .plane import TABLE_LENGTH, OutlineShape, TablePlane, outline_distance

CUT_SHARE = 0.15
"""Fraction of its outline on the picture's edge above which a tabletop counts as cut off."""

VISIBLE_LENGTH = 1.0
"""Assumed length, in metres, of the longer visible side of a cut-off table of unknown size."""

REACH = 7.0
"""Maximum distance of a point along the plane, in multiples of the camera's height; farther points
are ignored."""

_SMALLEST = 0.004  # minimum area of a tabletop, as a fraction of the picture
_ISLAND = 0.05  # minimum area of a part, as a fraction of the largest part
_POINTS = 240  # number of samples along the hull
# margin at the frame and beside hidden regions, in pixels of a 640-pixel picture
_FRAME, _BESIDE = 3, 5
_BRIDGE = 0.25  # weight of a hull point without a nearby boundary of the region
_SHRINK = 0.6  # weight of shrinking a side without evidence
_ROUND = 0.3  # maximum corner radius, relative to the shorter side
_ARC = 0.45  # fraction of the boundary that must be true to distinguish curves from corners
_OVERHANG = 0.015  # camera heights by which objects may extend over the edge
_RIVAL = 0.7  # error ratio to the rectangle below which an ellipse or triangle is chosen


@dataclass(frozen=True, eq=False)
class _Rim:
    """Points on a region's convex hull: their ``places`` and ``pixel`` sizes, in plane units.

    ``true`` marks points on real edges; ``weights`` are their weights in the fit.
    """

    places: Float[np.ndarray, "n 2"]
    pixel: Float[np.ndarray, "n"]
    true: Bool[np.ndarray, "n"]
    weights: Float[np.ndarray, "n"]


def frame_share(mask: Bool[np.ndarray, "h w"]) -> float:
    """Return the fraction of the outline (convex hull) of ``mask`` that lies on the frame."""
    points = _sample(hull_corners(_region(mask)), _POINTS)
    return float(_at_frame(points, mask.shape).mean())


def is_cut(mask: Bool[np.ndarray, "h w"]) -> bool:
    """Return whether too much of a tabletop is cut off to estimate the camera from its outline."""
    return frame_share(mask) > CUT_SHARE


def plane_from_view(
    mask: Bool[np.ndarray, "h w"],
    view: View,
    *,
    hidden: Bool[np.ndarray, "h w"] | None = None,
    length: float | None = None,
    reach: float = REACH,
) -> TablePlane:
    """Return the tabletop, complete or cut, of a picture with a known camera.

    ``mask`` is the visible tabletop (the surface, without legs and apron; objects on it may be part
    of the mask or holes in it). The azimuth of ``view`` is estimated again from the edges.
    ``hidden`` pixels may hide more of the top: an edge of the mask beside them is not the table's.
    ``length`` is the longer side in metres; it defaults to ``VISIBLE_LENGTH`` if the frame cuts the
    top, and to ``TABLE_LENGTH`` otherwise. ``reach`` is the maximum distance along the plane, in
    camera heights.

    Raises:
        SceneError: the mask is too small, or lies at or above the horizon.
    """
    height, width = mask.shape
    ahead = replace(view, azimuth=0.0)
    camera = Camera(np.array([0, 0, 1.0]), view_rotation(ahead), view.fov, width, height)
    unit = plane_of_region(mask, camera, hidden, reach=reach)
    longer = length or (VISIBLE_LENGTH if is_cut(mask) else TABLE_LENGTH)
    return scaled_plane(unit, longer / max(unit.size))


def scaled_plane(plane: TablePlane, factor: float) -> TablePlane:
    """Return the same tabletop in the same picture, scaled in size and distance by ``factor``."""
    camera = replace(plane.camera, position=plane.camera.position * factor)
    size = (plane.size[0] * factor, plane.size[1] * factor)
    edge = None if plane.edge is None else plane.edge * factor
    return replace(plane, camera=camera, size=size, radius=plane.radius * factor, edge=edge)


def plane_of_region(
    mask: Bool[np.ndarray, "h w"],
    camera: Camera,
    hidden: Bool[np.ndarray, "h w"] | None = None,
    carried: Float[np.ndarray, "n 2"] | None = None,
    reach: float = REACH,
) -> TablePlane:
    """Return the tabletop whose visible part is ``mask``, for a camera above the plane z = 0.

    ``camera`` looks along +y of its own frame (metres, or any unit). The result's frame has its
    origin at the top's centre, and its axes along the top's sides. ``carried`` are positions (x, y
    in the camera's frame) of objects that are known to stand on the top; the outline contains them
    too.

    Raises:
        SceneError: the mask is too small, or lies at or above the horizon.
    """
    rim = _rim(mask, camera, hidden, reach)
    true = float(rim.true.mean())
    if carried is not None and len(carried) >= 3:
        rim = _holding(rim, carried)
    usual, *others = _fit(rim, "rectangle", False), _fit(rim, "ellipse", False)
    if true > 1 - CUT_SHARE:
        others += [_fit(rim, "triangle", flipped) for flipped in (False, True)]
    rival = min(others, key=lambda f: f.error)
    better = true > _ARC and rival.error < _RIVAL * usual.error
    return _as_plane(rival if better else usual, camera)


# ----------------------------------------------------------------------------------- the region


def _region(mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    region = main_parts(mask, _ISLAND)
    if region.sum() < _SMALLEST * mask.size:
        raise SceneError(
            f"The tabletop covers less than {_SMALLEST:.1%} of the picture. Use a closer "
            "picture of the table."
        )
    return region


def _sample(polygon: Float[np.ndarray, "k 2"], count: int) -> Float[np.ndarray, "n 2"]:
    """Return ``count`` evenly spaced points along a closed polygon."""
    closed = np.concatenate([polygon, polygon[:1]])
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))])
    at = (np.arange(count) + 0.5) * along[-1] / count
    return np.column_stack([np.interp(at, along, closed[:, k]) for k in range(2)])


def _at_frame(points: Float[np.ndarray, "n 2"], shape: tuple[int, ...]) -> Bool[np.ndarray, "n"]:
    near = _FRAME * max(shape) / 640
    size = np.array([shape[1], shape[0]])
    return np.asarray((points < near).any(1) | (points > size - near).any(1))


def _rim(
    mask: Bool[np.ndarray, "h w"],
    camera: Camera,
    hidden: Bool[np.ndarray, "h w"] | None,
    reach: float,
) -> _Rim:
    region = _region(mask)
    height, width = mask.shape
    y, x = np.mgrid[0:height, 0:width] + 0.5
    places = camera.on_plane(np.column_stack([x.ravel(), y.ravel()]), 0.0)[:, :2]
    seen = np.linalg.norm(places, axis=1) < reach * camera.position[2]
    in_reach = seen.reshape(mask.shape)  # NaN, above the horizon, counts as out of reach
    far = dilate(~in_reach, 3)
    region = _region(region & in_reach & ~far)
    points = _sample(hull_corners(region), _POINTS)
    behind = far if hidden is None else far | (hidden & ~region)
    beside = distance_to(behind, points) < _BESIDE * max(mask.shape) / 640
    true = ~(_at_frame(points, mask.shape) | beside)
    bridged = distance_to(region, points) > _BESIDE * max(mask.shape) / 640
    on_plane = camera.on_plane(points, 0.0)
    depth = camera.to_camera(on_plane)[:, 2]
    sine = np.clip(camera.position[2] / np.linalg.norm(on_plane - camera.position, axis=1), 0.05, 1)
    pixel = depth / camera.focal / np.sqrt(sine)
    return _Rim(on_plane[:, :2], pixel, true, np.where(bridged, _BRIDGE, 1.0))


def _holding(rim: _Rim, carried: Float[np.ndarray, "n 2"]) -> _Rim:
    """Return the rim with the outline of the points ``carried``, which must be on the tabletop."""
    outline = _sample(convex_outline(carried), _POINTS // 4)
    middle = carried.mean(0)
    away = np.linalg.norm(outline - middle, axis=1, keepdims=True)
    outline = middle + (outline - middle) * np.maximum(1 - _OVERHANG / np.maximum(away, 1e-9), 0)
    count = len(outline)
    return _Rim(
        np.concatenate([rim.places, outline]),
        np.concatenate([rim.pixel, np.full(count, np.median(rim.pixel))]),
        np.concatenate([rim.true, np.zeros(count, bool)]),
        np.concatenate([rim.weights, np.full(count, _BRIDGE)]),
    )


# ------------------------------------------------------------------------------------- the fit


@dataclass(frozen=True, eq=False)
class _Top:
    """A fitted outline on the plane, rotated by ``turn`` about ``center``.

    ``error`` is the robust root mean squared distance of true edge points in pixels.
    """

    shape: OutlineShape
    flipped: bool
    center: Float[np.ndarray, "2"]
    turn: float
    size: tuple[float, float]
    radius: float
    error: float


def _fit(rim: _Rim, shape: OutlineShape, flipped: bool) -> _Top:
    """Fit an outline of a given shape that passes through edge points and contains all others."""
    found = []
    for turn in _turns(rim) if shape == "rectangle" else (_turns(rim)[0], 0.0):
        turned = rim.places @ rotation_z(turn)[:2, :2]
        low, high = turned.min(0), turned.max(0)
        middle = rotation_z(turn)[:2, :2] @ (low + high) / 2
        start = np.array([*middle, turn, *np.log(np.maximum(high - low, 1e-6)), -2.5])
        step = np.array([*(high - low) / 10, 0.05, 0.05, 0.05, 1.0])
        found.append(
            least_squares(_residuals, start, args=(rim, shape, flipped), x_scale=step, max_nfev=60)
        )
    best = min(found, key=lambda f: f.cost)
    center, turn, size, radius = _unpack(best.x)
    off = _off(best.x, rim, shape, flipped)
    error = float(np.sqrt(np.average(2 * (np.sqrt(1 + off**2) - 1), weights=rim.weights)))
    return _Top(shape, flipped, center, turn, size, radius, error)


def _turns(rim: _Rim) -> list[float]:
    """Return likely yaws of the tabletop, in radians, from the main directions of its real edges.

    A top without any true edge is assumed to be aligned with the viewer.
    """
    ahead = np.roll(rim.places, -1, 0) - rim.places
    both = rim.true & np.roll(rim.true, -1)
    if not both.any():
        return [0.0]
    angle = np.arctan2(ahead[:, 1], ahead[:, 0])[both]
    weight = (np.linalg.norm(ahead, axis=1) / rim.pixel * rim.weights)[both]
    tried = np.deg2rad(np.arange(-45, 45, 1.0))
    # a rotation by 90 degrees gives the same sides
    near = np.cos(4 * (angle[None] - tried[:, None]))
    score = (np.exp(20 * (near - 1)) * weight).sum(1)
    first = int(score.argmax())
    apart = np.abs((tried - tried[first] + np.pi / 4) % (np.pi / 2) - np.pi / 4) > np.deg2rad(8)
    second = int(np.where(apart, score, -1).argmax())
    return [float(tried[first]), float(tried[second])]


def _unpack(p: np.ndarray) -> tuple[np.ndarray, float, tuple[float, float], float]:
    size = (float(np.exp(p[3])), float(np.exp(p[4])))
    return p[:2], float(p[2]), size, _ROUND * min(size) / (1 + float(np.exp(-p[5])))


def _off(p: np.ndarray, rim: _Rim, shape: OutlineShape, flipped: bool) -> Float[np.ndarray, "n"]:
    """Return the points' pixel distances from the outline; inside, points not on an edge have 0."""
    center, turn, size, radius = _unpack(p)
    places = (rim.places - center) @ rotation_z(turn)[:2, :2]
    off = outline_distance(places, shape, flipped, size, radius) / rim.pixel
    return np.where(rim.true, off, np.maximum(off, 0))


def _residuals(
    p: np.ndarray, rim: _Rim, shape: OutlineShape, flipped: bool
) -> Float[np.ndarray, "m"]:
    off = _off(p, rim, shape, flipped)
    robust = np.sign(off) * np.sqrt(2 * (np.sqrt(1 + off**2) - 1))
    least = np.log(np.maximum(np.ptp(rim.places, axis=0).min(), 1e-6)) - 1.5
    shrink = _SHRINK * (p[3:5] - least)
    prior = [*shrink, 0.5 * (p[5] + 2.5), 0.3 * p[2]]
    return np.concatenate([robust * np.sqrt(rim.weights), prior])


def _as_plane(top: _Top, camera: Camera) -> TablePlane:
    """Return the fitted tabletop as a ``TablePlane``, with the camera in the tabletop's frame."""
    quarter = 0.0 if top.shape == "triangle" else np.round(top.turn / (np.pi / 2)) * np.pi / 2
    turn, size = top.turn - quarter, top.size
    if round(quarter / (np.pi / 2)) % 2:
        size = (size[1], size[0])
    back = rotation_z(-turn)
    position = back @ (camera.position - [*top.center, 0.0])
    turned = replace(camera, position=position, rotation=camera.rotation @ back.T)
    up = turned.rotation[:, 2]
    elevation = float(np.clip(np.arcsin(np.clip(-up[2], -1, 1)), 0.02, np.pi / 2))
    roll = float(np.arctan2(-up[0], -up[1])) if np.hypot(up[0], up[1]) > 0.02 else 0.0
    view = View(wrap(-turn), elevation, camera.fov, roll)
    return TablePlane(view, turned, top.shape, top.flipped, size, top.radius, top.error)
