"""The tabletop as a plane: camera and size from the outline of the top surface.

One least-squares problem serves every outline: choose camera (azimuth, elevation, field of view,
position) and table (depth to length, corner radius) so that the outline's edge points, carried
onto the plane, lie on a rounded rectangle, an ellipse or a triangle. Weak priors settle what a
single view leaves open: a rectangle seen head-on does not tell field of view from depth.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy.optimize import least_squares

from ...errors import SceneError
from ...geometry import Camera, view_direction, view_rotation
from ...scene import PlannedTable, View
from .outline import Candidate, candidates, working_copy

OutlineShape = Literal["rectangle", "ellipse", "triangle"]

TABLE_LENGTH = 1.2
"""Length (x extent) in metres of a table of unknown size."""

_ELEVATION, _ELEVATION_SPREAD = np.deg2rad(50.0), np.deg2rad(13.0)
_FOV, _FOV_SPREAD = np.deg2rad(36.0), np.deg2rad(4.5)
_AZIMUTH_SPREAD = np.deg2rad(25.0)
_ASPECT: dict[str, tuple[float, float]] = {  # log of depth / length: mean, spread
    "rectangle": (np.log(0.58), 0.22),
    "ellipse": (0.0, 0.12),
    "triangle": (np.log(0.8), 0.15),
}
_EDGE = 1.2  # pixels: how well an edge point is known
_TRUST = 12.0  # independent edge points that a whole outline counts for


@dataclass(frozen=True, eq=False)
class TablePlane:
    """The tabletop of one picture.

    ``camera`` is in metres with the *centre of the top surface* as origin (x right, y away, z
    up); its scale rests on ``size``, the top's (length, width) in metres. ``shape`` tells the
    outline's kind; ``flipped`` a triangle whose tip points to the viewer; ``radius`` the corner
    radius in metres. ``outline`` is the fitted outline in picture pixels, ``error`` the median
    distance of the edge points from it in pixels.
    """

    view: View
    camera: Camera
    shape: OutlineShape
    flipped: bool
    size: tuple[float, float]
    radius: float
    outline: Float[np.ndarray, "k 2"]
    error: float

    def to_table(self, pixels: Float[np.ndarray, "n 2"], z: float = 0.0) -> np.ndarray:
        """Return table x, y in metres of picture pixels, on the plane ``z`` above the top."""
        return self.camera.on_plane(pixels, z)[:, :2]

    def to_pixels(self, points: Float[np.ndarray, "n 2"], z: float = 0.0) -> np.ndarray:
        """Return the picture pixels of table points at height ``z`` above the top."""
        points = np.atleast_2d(points)
        return self.camera.project(np.column_stack([points, np.full(len(points), z)]))

    def mask(self, grow: float = 0.0) -> Bool[np.ndarray, "h w"]:
        """Return the pixels inside the outline, widened by ``grow`` metres."""
        canvas = np.zeros((self.camera.height, self.camera.width), np.uint8)
        points = outline_points(self.shape, self.flipped, self.size, self.radius, grow)
        cv2.fillPoly(canvas, [np.round(self.to_pixels(points) - 0.5).astype(np.int32)], 1)
        return canvas > 0


# ----------------------------------------------------------------------------- ideal outlines


def _triangle(length: float, width: float, flipped: bool) -> Float[np.ndarray, "3 2"]:
    tip = -1.0 if flipped else 1.0
    corners = np.array([[-length / 2, -tip * width / 2], [length / 2, -tip * width / 2]])
    return np.vstack([corners, [0.0, tip * width / 2]])


def outline_distance(
    points: Float[np.ndarray, "n 2"],
    shape: OutlineShape,
    flipped: bool,
    size: tuple[float, float],
    radius: float,
) -> Float[np.ndarray, "n"]:
    """Return the signed distance of table points from an outline, positive outside, metres."""
    half = np.asarray(size) / 2
    if shape == "ellipse":
        scaled = np.linalg.norm(points / half, axis=1)
        slope = np.linalg.norm(points / half**2, axis=1)
        return scaled * (scaled - 1.0) / np.maximum(slope, 1e-9)
    if shape == "rectangle":
        q = np.abs(points) - (half - radius)
        outer = np.linalg.norm(np.maximum(q, 0), axis=1)
        return outer + np.minimum(q.max(1), 0) - radius
    corners = _triangle(*size, flipped)
    if flipped:
        corners = corners[::-1]
    edges = np.roll(corners, -1, 0) - corners
    normals = np.column_stack([edges[:, 1], -edges[:, 0]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    offsets = ((points[:, None] - corners) * normals).sum(-1) + radius
    worst = np.sort(np.maximum(offsets, 0), axis=1)[:, ::-1]
    return np.where(offsets.max(1) > 0, np.hypot(worst[:, 0], worst[:, 1]), offsets.max(1)) - radius


def outline_points(
    shape: OutlineShape,
    flipped: bool,
    size: tuple[float, float],
    radius: float,
    grow: float = 0.0,
    count: int = 128,
) -> Float[np.ndarray, "k 2"]:
    """Return points on an outline, counter-clockwise, found along rays from its middle."""
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
    parameters: Float[np.ndarray, "8"]
    shape: OutlineShape
    flipped: bool
    cost: float
    error: float


def _camera(parameters: np.ndarray, width: int, height: int) -> Camera:
    azimuth, elevation, log_fov, x, y, log_distance = parameters[:6]
    view = View(azimuth, float(np.clip(elevation, 0.02, np.pi / 2)), float(np.exp(log_fov)))
    position = np.array([x, y, 0.0]) + np.exp(log_distance) * view_direction(view)
    return Camera(position, view_rotation(view), view.fov, width, height)


def _aspect_prior(shape: OutlineShape, plan: PlannedTable | None) -> tuple[float, float]:
    if plan is None:
        return _ASPECT[shape]
    return float(np.log(plan.size[1] / plan.size[0])), 0.04


def _fit(
    candidate: Candidate,
    shape: OutlineShape,
    flipped: bool,
    start: np.ndarray,
    frame: tuple[int, int],
    plan: PlannedTable | None,
) -> _Fit:
    """Fit camera and outline of unit length to the candidate's edge points."""
    mean, spread = _aspect_prior(shape, plan)
    points = candidate.points
    trust = np.sqrt(_TRUST / len(points)) / _EDGE

    def pixels_off(p: np.ndarray) -> np.ndarray:
        camera = _camera(p, *frame)
        on_plane = camera.on_plane(points, 0.0)
        seen = np.isfinite(on_plane).all(1)
        depth = np.where(seen, camera.to_camera(np.nan_to_num(on_plane))[:, 2], 1.0)
        aspect, radius = np.exp(p[6]), 0.3 / (1 + np.exp(-p[7])) * min(1.0, float(np.exp(p[6])))
        flat = np.nan_to_num(on_plane[:, :2])
        off = outline_distance(flat, shape, flipped, (1.0, float(aspect)), radius)
        slant = np.sqrt(np.sin(p[1])) if p[1] > 0 else 0.1
        return np.where(seen, off * camera.focal * slant / np.maximum(depth, 1e-6), 1e3)

    def residuals(p: np.ndarray) -> np.ndarray:
        off = pixels_off(p) * trust
        robust = np.sign(off) * np.sqrt(2 * (np.sqrt(1 + off**2) - 1))
        prior = [
            p[0] / _AZIMUTH_SPREAD,
            (p[1] - _ELEVATION) / _ELEVATION_SPREAD,
            (p[2] - np.log(_FOV)) / (_FOV_SPREAD / _FOV),
            (p[6] - mean) / spread,
            (p[7] + 2) / 2,
        ]
        return np.concatenate([robust, prior])

    lower = [-1.2, 0.1, np.log(0.15), -9, -9, -3, np.log(0.2), -8]
    upper = [1.2, np.pi / 2 - 0.01, np.log(1.6), 9, 9, 4, np.log(1.7), 8]
    found = least_squares(residuals, np.clip(start, lower, upper), bounds=(lower, upper))
    error = float(np.median(np.abs(pixels_off(found.x))))
    return _Fit(found.x, shape, flipped, float(2 * found.cost), error)


def _starts(hull: Float[np.ndarray, "k 2"], frame: tuple[int, int]) -> list[np.ndarray]:
    width, height = frame
    low, high = hull.min(0), hull.max(0)
    span = high[0] - low[0]
    focal = height / 2 / np.tan(_FOV / 2)
    shift = ((low + high) / 2 - np.array([width, height]) / 2) / span
    starts = []
    for elevation in np.deg2rad([35.0, 60.0]):
        for azimuth in (0.0, 0.5, -0.5):
            x, y = -shift[0], shift[1] / np.sin(elevation)
            c, s = np.cos(azimuth), np.sin(azimuth)
            aspect = np.clip((high[1] - low[1]) / span / np.sin(elevation), 0.3, 1.2)
            starts.append(
                np.array([azimuth, elevation, np.log(_FOV), c * x - s * y, s * x + c * y,
                          np.log(focal / span), np.log(aspect), -2.0])
            )
    return starts


_SHAPES: tuple[tuple[OutlineShape, bool], ...] = (
    ("rectangle", False),
    ("ellipse", False),
    ("triangle", False),
    ("triangle", True),
)


def _shapes(plan: PlannedTable | None) -> tuple[tuple[OutlineShape, bool], ...]:
    if plan is None:
        return _SHAPES
    if plan.outline in ("round", "oval"):
        return (("ellipse", False),)
    if plan.outline == "triangle":
        return _SHAPES[2:]
    return (("rectangle", False),)


def _best_fit(candidate: Candidate, frame: tuple[int, int], plan: PlannedTable | None) -> _Fit:
    starts = _starts(candidate.hull, frame)
    fits = [
        _fit(candidate, shape, flipped, start, frame, plan)
        for shape, flipped in _shapes(plan)
        for start in starts[:: 1 if shape == "rectangle" else 3]
    ]
    return min(fits, key=lambda fit: fit.cost)


def find_plane(
    image: UInt8[np.ndarray, "h w 3"],
    plan: PlannedTable | None = None,
    length: float | None = None,
) -> TablePlane:
    """Find the tabletop in a picture and the camera that sees it.

    Args:
        image: the picture; the table's whole top should be in it.
        plan: what a text said of the table; fixes its shape and proportions if given.
        length: the table's length in metres; default: the plan's, else ``TABLE_LENGTH``.

    Raises:
        SceneError: nothing in the picture looks like a tabletop.
    """
    lab, factor = working_copy(image)
    height, width = lab.shape[:2]
    found = candidates(lab)
    if not found:
        raise SceneError(
            "No table found: no large even surface stands out from a plain background. "
            "Use a picture that shows the whole table on a light, plain ground."
        )
    ranked = []
    for candidate in found[:2]:
        fit = _best_fit(candidate, (width, height), plan)
        ranked.append((candidate.score / (1 + fit.error / 4), fit))
    fit = max(ranked, key=lambda pair: pair[0])[1]
    metres = length or (plan.size[0] if plan else TABLE_LENGTH)
    return _plane(fit, metres, image.shape[1], image.shape[0], factor)


def _plane(fit: _Fit, length: float, width: int, height: int, factor: float) -> TablePlane:
    unit = _camera(fit.parameters, width, height)
    view = View(float(fit.parameters[0]), float(fit.parameters[1]), unit.fov)
    aspect = float(np.exp(fit.parameters[6]))
    radius = float(0.3 / (1 + np.exp(-fit.parameters[7])) * min(1.0, aspect)) * length
    size = (length, length * aspect)
    camera = Camera(unit.position * length, unit.rotation, unit.fov, width, height)
    points = outline_points(fit.shape, fit.flipped, size, radius)
    outline = camera.project(np.column_stack([points, np.zeros(len(points))]))
    return TablePlane(
        view, camera, fit.shape, fit.flipped, size, radius, outline, fit.error / factor
    )
