"""The tabletop as a plane: camera and size from the outline of the top surface.

One least-squares problem serves every outline: find the camera (azimuth, elevation, field of view,
position) and the table (ratio of depth to length, corner radius) that make the outline's edge
points, projected onto the plane, lie on a rounded rectangle, an ellipse or a triangle. Weak priors
determine what a single view leaves open: for example, the field of view and the depth of a
rectangle seen head-on.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import cv2
import numpy as np
import shapely
from jaxtyping import Bool, Float
from scipy.optimize import least_squares

from ....geometry import Camera, view_direction, view_rotation
from ....scene import OutlineKind, PlannedTable, View
from .outline import Outline

OutlineShape = Literal["rectangle", "ellipse", "triangle"]

TABLE_LENGTH = 1.2
"""Length (x extent) in metres of a table of unknown size."""

RADIUS = 0.3
"""The maximum corner radius, relative to the shorter side."""

_ELEVATION_SPREAD = np.deg2rad(3.5)  # typical error of the detector's elevation
_FOV_SPREAD = 0.25  # typical error of the logarithm of the detected field of view
_EDGE = 1.2  # accuracy of an edge point in pixels
_TRUST = 12.0  # number of independent edge points that a complete outline is worth


@dataclass(frozen=True)
class _Kind:
    """A kind of tabletop, with priors for log(width / length) and for the azimuth in radians."""

    shape: OutlineShape
    flipped: bool
    aspect: tuple[float, float]
    azimuth: float
    planned: tuple[OutlineKind, ...]


_KINDS = (
    _Kind("rectangle", False, (np.log(0.58), 0.22), np.deg2rad(25.0),
          ("rectangle", "square", "slatted")),
    _Kind("ellipse", False, (0.0, 0.03), np.deg2rad(3.0), ("round",)),
    _Kind("ellipse", False, (np.log(0.62), 0.12), np.deg2rad(8.0), ("oval",)),
    _Kind("triangle", False, (np.log(0.88), 0.12), np.deg2rad(12.0), ("triangle",)),
    _Kind("triangle", True, (np.log(0.88), 0.12), np.deg2rad(12.0), ()),
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class TablePlane:
    """The tabletop in one picture: its shape, its size and the camera.

    ``camera`` is in metres with the *centre of the top surface* as origin (x right, y away, z up);
    its scale follows from ``size``, the top's (length, width) in metres. ``shape`` is the outline's
    kind; ``flipped`` is True for a triangle whose tip points to the viewer; ``radius`` is the
    corner radius in metres; ``error`` is the median distance of the edge points from the outline in
    picture pixels. ``edge`` is the detected outline in metres, convex and counter-clockwise, if it
    matches none of those shapes; ``shape`` is then the most similar one.
    """

    view: View
    camera: Camera
    shape: OutlineShape
    flipped: bool
    size: tuple[float, float]
    radius: float
    error: float
    edge: Float[np.ndarray, "m 2"] | None = None

    def top(self, grow: float = 0.0) -> Float[np.ndarray, "k 2"]:
        """Return the tabletop's outline seen from above, widened by ``grow`` metres."""
        if self.edge is None:
            return outline_points(self.shape, self.flipped, self.size, self.radius, grow)
        widened = shapely.Polygon(self.edge).buffer(grow) if grow else shapely.Polygon(self.edge)
        return np.asarray(shapely.orient_polygons(widened).exterior.coords)[:-1]

    def to_table(self, pixels: Float[np.ndarray, "n 2"], z: float = 0.0) -> np.ndarray:
        """Project picture pixels to x, y in metres on the plane ``z`` metres above the tabletop."""
        return self.camera.on_plane(pixels, z)[:, :2]

    def elevation_at(self, box: Float[np.ndarray, "4"]) -> float:
        """Return the angle below the horizon, in radians, of a pixel box's lower edge."""
        ray = self.camera.rays(np.array([[(box[0] + box[2]) / 2, box[3]]]))[0]
        return float(np.arcsin(np.clip(-ray[2] / np.linalg.norm(ray), -1.0, 1.0)))

    def to_pixels(self, points: Float[np.ndarray, "n 2"], z: float = 0.0) -> np.ndarray:
        """Return the picture pixels of table points at height ``z`` above the tabletop."""
        points = np.atleast_2d(points)
        return self.camera.project(np.column_stack([points, np.full(len(points), z)]))

    def mask(self, grow: float = 0.0) -> Bool[np.ndarray, "h w"]:
        """Return the pixels inside the outline, widened by ``grow`` metres."""
        canvas = np.zeros((self.camera.height, self.camera.width), np.uint8)
        cv2.fillPoly(canvas, [np.round(self.to_pixels(self.top(grow)) - 0.5).astype(np.int32)], 1)
        return canvas > 0


# ----------------------------------------------------------------------------- ideal outlines


def _convex_distance(
    points: Float[np.ndarray, "n 2"], corners: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "n"]:
    """Return the signed distance from a convex counter-clockwise polygon (positive outside)."""
    edges = np.roll(corners, -1, 0) - corners
    normals = np.column_stack([edges[:, 1], -edges[:, 0]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    rel = points[:, None] - corners
    inner = (rel * normals).sum(-1).max(1)
    share = np.clip((rel * edges).sum(-1) / (edges**2).sum(-1), 0, 1)
    outer = np.linalg.norm(rel - share[..., None] * edges, axis=-1).min(1)
    return np.where(inner > 0, outer, inner)


def outline_distance(
    points: Float[np.ndarray, "n 2"],
    shape: OutlineShape,
    flipped: bool,
    size: tuple[float, float],
    radius: float,
) -> Float[np.ndarray, "n"]:
    """Return the signed distance in metres of table points from an outline (positive outside).

    The outline fills ``size`` exactly. For a rectangle and a triangle, ``radius`` is the corner
    radius; an ellipse approaches a rectangle as it grows (a superellipse, like oval tables).
    """
    half = np.asarray(size) / 2
    if shape == "ellipse":
        power = 2.0 + 4.0 * radius / max(size)
        scaled = np.maximum(np.abs(points) / half, 1e-6)
        level = (scaled**power).sum(1) ** (1 / power)
        slope = np.linalg.norm(scaled ** (power - 1) / half, axis=1) * level ** (1 - power)
        return (level - 1.0) / np.maximum(slope, 1e-9)
    if shape == "rectangle":
        q = np.abs(points) - (half - radius)
        outer = np.linalg.norm(np.maximum(q, 0), axis=1)
        return outer + np.minimum(q.max(1), 0) - radius
    x, y = half - radius
    corners = np.array([[-x, -y], [x, -y], [0.0, y]])
    return _convex_distance(points, -corners if flipped else corners) - radius


def outline_points(
    shape: OutlineShape,
    flipped: bool,
    size: tuple[float, float],
    radius: float,
    grow: float = 0.0,
    count: int = 128,
) -> Float[np.ndarray, "k 2"]:
    """Return points on an outline, counter-clockwise, computed along rays from its centre."""
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    rays = np.column_stack([np.cos(angle), np.sin(angle)])
    middle = np.array([0.0, (size[1] / 6 if flipped else -size[1] / 6) * (shape == "triangle")])
    low, high = np.zeros(count), np.full(count, 1.5 * max(size) + grow)
    for _ in range(40):
        mid = (low + high) / 2
        out = outline_distance(middle + rays * mid[:, None], shape, flipped, size, radius) > grow
        low, high = np.where(out, low, mid), np.where(out, mid, high)
    return middle + rays * low[:, None]


# --------------------------------------------------------------------------------------- fitting


@dataclass(frozen=True, eq=False)
class _Fit:
    """A fitted camera and tabletop outline; the outline's length is 1.

    ``parameters``: azimuth, elevation, log fov, target x, y, log distance, log aspect, and the
    logit of the corner radius relative to its maximum.
    """

    parameters: Float[np.ndarray, "8"]
    kind: _Kind
    cost: float
    error: float


def _radius(parameters: Float[np.ndarray, "8"]) -> float:
    """Return the corner radius relative to the length."""
    return float(RADIUS / (1 + np.exp(-parameters[7])) * min(1.0, np.exp(parameters[6])))


def _camera(parameters: Float[np.ndarray, "8"], width: int, height: int) -> Camera:
    azimuth, elevation, log_fov, x, y, log_distance = parameters[:6]
    view = View(azimuth, float(np.clip(elevation, 0.02, np.pi / 2)), float(np.exp(log_fov)))
    position = np.array([x, y, 0.0]) + np.exp(log_distance) * view_direction(view)
    return Camera(position, view_rotation(view), view.fov, width, height)


def _pixels_off(
    parameters: Float[np.ndarray, "8"],
    points: Float[np.ndarray, "n 2"],
    kind: _Kind,
    frame: tuple[int, int],
) -> Float[np.ndarray, "n"]:
    """Return edge points' distances from the outline in pixels, to first order."""
    camera = _camera(parameters, *frame)
    on_plane = camera.on_plane(points, 0.0)
    seen = np.asarray(np.isfinite(on_plane).all(1))
    on_plane = np.where(seen[:, None], on_plane, 0.0)
    depth = np.maximum(camera.to_camera(on_plane)[:, 2], 1e-6)
    size = (1.0, float(np.exp(parameters[6])))
    off = outline_distance(on_plane[:, :2], kind.shape, kind.flipped, size, _radius(parameters))
    slant = np.sqrt(max(np.sin(parameters[1]), 0.01))
    return np.where(seen, off * camera.focal * slant / depth, 1e3)


def _residuals(
    parameters: Float[np.ndarray, "8"],
    points: Float[np.ndarray, "n 2"],
    kind: _Kind,
    aspect: tuple[float, float],
    frame: tuple[int, int],
    expected: Float[np.ndarray, "3"],
) -> Float[np.ndarray, "m"]:
    """Return robust edge distances and the priors' terms, whose squares sum to the cost.

    A misdetected part of the edge has many points that are all displaced to one side: beyond the
    accuracy of an edge point, their loss grows linearly with the distance instead of quadratically.
    """
    off = _pixels_off(parameters, points, kind, frame) / _EDGE
    robust = np.sign(off) * np.sqrt(2 * _TRUST / len(points) * (np.sqrt(1 + off**2) - 1))
    p = parameters
    prior = [
        p[0] / kind.azimuth, (p[1] - expected[1]) / _ELEVATION_SPREAD,
        (p[2] - expected[2]) / _FOV_SPREAD, (p[6] - aspect[0]) / aspect[1], (p[7] + 2) / 2,
    ]  # fmt: skip
    return np.concatenate([robust, prior])


_LOWER = np.array([-1.2, 0.1, np.log(0.15), -9, -9, -3, np.log(0.2), -8])
_UPPER = np.array([1.2, np.pi / 2 - 0.01, np.log(1.6), 9, 9, 4, np.log(1.7), 8])


def _view_parameters(view: View) -> Float[np.ndarray, "3"]:
    return np.array([view.azimuth, view.elevation, np.log(view.fov)])


def _bounds(view: View | None) -> tuple[np.ndarray, np.ndarray]:
    """Return the parameters' lower and upper bounds; a given view fixes its three angles."""
    if view is None:
        return _LOWER, _UPPER
    given = _view_parameters(view)
    return np.r_[given - _PINNED, _LOWER[3:]], np.r_[given + _PINNED, _UPPER[3:]]


def _fit(
    outline: Outline,
    kind: _Kind,
    frame: tuple[int, int],
    plan: PlannedTable | None,
    expected: View,
    view: View | None,
) -> _Fit:
    """Fit a camera and an outline of unit length to the edge points of ``outline``."""
    aspect = kind.aspect
    if plan is not None:
        aspect = (float(np.log(plan.size[1] / plan.size[0])), 0.05)
    points = outline.points[:: max(1, len(outline.points) // 100)]
    arguments = (points, kind, aspect, frame, _view_parameters(expected))
    low, high = _bounds(view)
    starts = _starts(outline.hull, frame, expected)
    if kind.shape != "rectangle":  # seen rotated, the other shapes look almost the same
        starts = starts[:1]
    starts = [np.clip(s, low, high) for s in starts]
    costs = [float((_residuals(s, *arguments) ** 2).sum()) for s in starts]
    found = [
        least_squares(
            _residuals, starts[k], bounds=(low, high), args=arguments, x_scale=_STEP,
            max_nfev=40, ftol=1e-5,
        )
        for k in np.argsort(costs)[:2]
    ]  # fmt: skip
    best = min(found, key=lambda f: f.cost)
    error = float(np.median(np.abs(_pixels_off(best.x, points, kind, frame))))
    return _Fit(best.x, kind, float(2 * best.cost), error)


_PINNED = 1e-6  # radians and log; the range of a fixed parameter
_STEP = np.array([0.1, 0.1, 0.1, 0.05, 0.05, 0.1, 0.1, 1.0])  # typical size of a change


def _starts(
    hull: Float[np.ndarray, "k 2"], frame: tuple[int, int], expected: View
) -> list[np.ndarray]:
    """Return three initial guesses with different azimuths, from the outline and expected view."""
    low, high = hull.min(0), hull.max(0)
    span = high[0] - low[0]
    elevation = max(expected.elevation, 0.15)
    focal = frame[1] / 2 / np.tan(expected.fov / 2)
    shift = ((low + high) / 2 - np.array(frame) / 2) / span
    x, y = -shift[0], shift[1] / np.sin(elevation)
    aspect = np.clip((high[1] - low[1]) / span / np.sin(elevation), 0.3, 1.2)
    starts = []
    for azimuth in (0.0, 0.5, -0.5):
        c, s = np.cos(azimuth), np.sin(azimuth)
        across = [c * x - s * y, s * x + c * y, np.log(focal / span)]
        first = [azimuth, elevation, np.log(expected.fov), *across, np.log(aspect), -2.0]
        starts.append(np.array(first))
    return starts


def fit_plane(
    outline: Outline,
    factor: float,
    size: tuple[int, int],
    expected: View,
    plan: PlannedTable | None = None,
    length: float | None = None,
    view: View | None = None,
) -> TablePlane:
    """Estimate the camera and the tabletop from a complete tabletop's outline, in working pixels.

    ``factor`` is working pixels per picture pixel, ``size`` the picture's width and height in
    pixels, and ``expected`` the elevation and field of view that the picture suggests. ``plan``,
    ``length`` and ``view`` are as in ``tabletop.find_tabletop``; the length defaults to
    ``TABLE_LENGTH``.
    """
    frame = round(size[0] * factor), round(size[1] * factor)
    kinds = [k for k in _KINDS if plan is None or plan.outline in k.planned]
    fits = (_fit(outline, kind, frame, plan, expected, view) for kind in kinds)
    best = min(fits, key=lambda fit: fit.cost)
    metres = length or (plan.size[0] if plan else TABLE_LENGTH)
    p, kind, unit = best.parameters, best.kind, _camera(best.parameters, *size)
    camera = replace(unit, position=unit.position * metres)
    view = View(float(p[0]), float(p[1]), unit.fov)
    top, radius = (metres, metres * float(np.exp(p[6]))), _radius(p) * metres
    return TablePlane(view, camera, kind.shape, kind.flipped, top, radius, best.error / factor)
