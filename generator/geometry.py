"""Rotations about the vertical, boxes, the pinhole camera, rays and 2D outlines.

``scene`` defines the frames.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Real
from numpy.typing import ArrayLike

from tabletop_objects.values import VECTOR, freeze

from .errors import InputError
from .scene import View

# ------------------------------------------------------------------------------------ rotations


def rotation_z(yaw: float) -> Float[np.ndarray, "3 3"]:
    """Return the rotation matrix of ``yaw`` radians about +z."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def wrap(angle: float) -> float:
    """Return ``angle`` (radians) wrapped to [-pi, pi)."""
    return float((angle + np.pi) % (2 * np.pi) - np.pi)


def rotation_yaw(rotation: Float[np.ndarray, "3 3"]) -> float:
    """Return the angle of a rotation's x axis about +z, in radians in [-pi, pi]."""
    return float(np.arctan2(rotation[1, 0], rotation[0, 0]))


def yaw_quaternion(yaw: float) -> Float[np.ndarray, "4"]:
    """Return the wxyz quaternion of ``yaw`` radians about +z."""
    return np.array([np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)])


def quaternion_matrix(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the rotation matrix of a unit wxyz quaternion."""
    w, x, y, z = (np.asarray(quaternion, float) / np.linalg.norm(quaternion)).tolist()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion_yaw(quaternion: Float[np.ndarray, "4"]) -> float:
    """Return the yaw of a wxyz quaternion: the angle of the body's x axis about +z, in radians."""
    w, x, y, z = quaternion
    return float(np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))


def turned_quaternion(quaternion: Float[np.ndarray, "4"], yaw: float) -> Float[np.ndarray, "4"]:
    """Return a wxyz quaternion rotated by ``yaw`` radians about the vertical."""
    w, x, y, z = quaternion
    c, s = np.cos(yaw / 2), np.sin(yaw / 2)
    return np.array([c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w])


def rotated_extent(extent: Float[np.ndarray, "3"], yaw: float) -> Float[np.ndarray, "2"]:
    """Return the world x and y extents of a box of size ``extent`` rotated by ``yaw`` radians."""
    c, s = abs(np.cos(yaw)), abs(np.sin(yaw))
    return np.array([c * extent[0] + s * extent[1], s * extent[0] + c * extent[1]])


# ------------------------------------------------------------------------------------- pixels


def mask_box(mask: Bool[np.ndarray, "h w"]) -> Float[np.ndarray, "4"]:
    """Return the tight bounding box (x0, y0, x1, y1) of a mask; x1 and y1 are exclusive.

    Raises:
        InputError: the mask is empty.
    """
    ys, xs = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
    if not len(ys):
        raise InputError("An empty mask has no bounding box.")
    return np.array([xs[0], ys[0], xs[-1] + 1, ys[-1] + 1], float)


# ------------------------------------------------------------------------------------- camera


@dataclass(frozen=True, eq=False)
class Camera:
    """A pinhole camera with square pixels.

    ``rotation`` maps world directions to camera axes (x right, y *down*, z forward). ``fov`` is the
    vertical field of view in radians. Pixel (0, 0) is the top-left corner, so pixel centres lie at
    half-integers. ``offset`` is the position of the principal point relative to the image centre
    (right, down), in pixels.
    """

    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]
    fov: float
    width: int
    height: int
    offset: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        freeze(self, position=VECTOR, rotation=(np.float64, (3, 3)))
        if self.width < 1 or self.height < 1 or not 0 < self.fov < np.pi:
            raise InputError(
                f"Camera must have a size of at least 1 and fov in (0, pi), got {self}."
            )

    @property
    def focal(self) -> float:
        """Focal length in pixels."""
        return self.height / 2 / np.tan(self.fov / 2)

    @property
    def center(self) -> Float[np.ndarray, "2"]:
        """The principal point in pixels."""
        return np.array([self.width / 2, self.height / 2]) + self.offset

    @classmethod
    def looking_at(
        cls, target: ArrayLike, view: View, distance: float, width: int, height: int
    ) -> Camera:
        """Return the camera ``distance`` metres from ``target`` in the direction of ``view``."""
        position = np.asarray(target, float) + distance * view_direction(view)
        return cls(position, view_rotation(view), view.fov, width, height)

    def to_camera(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        """Return world points in camera coordinates; z is the depth in metres."""
        return (np.asarray(points, float) - self.position) @ self.rotation.T

    def project(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 2"]:
        """Return the pixel coordinates of world points; those behind the camera are meaningless."""
        p = self.to_camera(points)
        return p[:, :2] / p[:, 2:] * self.focal + self.center

    def rays(self, pixels: Real[np.ndarray, "n 2"]) -> Float[np.ndarray, "n 3"]:
        """Return the unit world directions of the rays through ``pixels``."""
        uv = np.atleast_2d(np.asarray(pixels, float))
        p = np.column_stack([(uv - self.center) / self.focal, np.ones(len(uv))])
        d = p @ self.rotation
        squares = d * d
        length = np.sqrt((squares[:, 0] + squares[:, 1]) + squares[:, 2])
        return d / length[:, None]

    def on_plane(self, pixels: Real[np.ndarray, "n 2"], z: float) -> Float[np.ndarray, "n 3"]:
        """Return the points where the rays through ``pixels`` meet the plane at height ``z``.

        Rays at or above the horizon give NaN.
        """
        rays = self.rays(pixels)
        steps = (z - self.position[2]) / np.where(rays[:, 2] < -1e-9, rays[:, 2], np.nan)
        return self.position + rays * steps[:, None]


def view_direction(view: View) -> Float[np.ndarray, "3"]:
    """Return the unit vector from the target of ``view`` towards its camera."""
    c = np.cos(view.elevation)
    return np.array([c * np.sin(view.azimuth), -c * np.cos(view.azimuth), np.sin(view.elevation)])


def view_rotation(view: View) -> Float[np.ndarray, "3 3"]:
    """Return the world-to-camera rotation (rows: right, down, forward) of a view."""
    forward = -view_direction(view)
    level = np.array([np.cos(view.azimuth), np.sin(view.azimuth), 0.0])
    below = np.cross(forward, level)
    c, s = np.cos(view.roll), np.sin(view.roll)
    return np.stack([c * level + s * below, c * below - s * level, forward])


def ray_view(view: View, pixel: Real[np.ndarray, "2"], width: int, height: int) -> View:
    """Return ``view`` with its direction replaced by that of the ray through ``pixel``.

    An object away from the image centre is seen along its own ray, so its azimuth and elevation
    differ from the camera's. ``fov`` and ``roll`` are unchanged.
    """
    camera = Camera(np.zeros(3), view_rotation(view), view.fov, width, height)
    x, y, z = camera.rays(np.asarray(pixel, float)[None])[0]
    elevation = float(np.clip(np.arcsin(np.clip(-z, -1, 1)), 1e-3, np.pi / 2))
    return View(float(np.arctan2(-x, y)), elevation, view.fov, view.roll)


def framing_camera(
    points: Float[np.ndarray, "n 3"], view: View, width: int, height: int, margin: float = 0.06
) -> Camera:
    """Return the closest camera along ``view`` that shows all ``points`` with a margin.

    ``margin`` is the empty fraction of the picture on each side. The points are centred.
    """
    target = (points.min(0) + points.max(0)) / 2
    distance = 2.0 * float(np.linalg.norm(np.ptp(points, axis=0))) / np.tan(view.fov / 2)
    frame = np.array([width, height]) * (1 - 2 * margin)
    for _ in range(12):  # alternate between centring and approaching; this converges geometrically
        camera = Camera.looking_at(target, view, distance, width, height)
        low, high = _pixel_box(camera, points)
        shift = ((low + high) / 2 - [width / 2, height / 2]) * distance / camera.focal
        target = target + shift[0] * camera.rotation[0] + shift[1] * camera.rotation[1]
        distance *= float(((high - low) / frame).max())
    return Camera.looking_at(target, view, distance, width, height)


def _pixel_box(
    camera: Camera, points: Float[np.ndarray, "n 3"]
) -> tuple[Float[np.ndarray, "2"], Float[np.ndarray, "2"]]:
    """Return the minimum and maximum pixel coordinates of the projected points."""
    x, y, depth = camera.to_camera(points).T
    across, down = x / depth, y / depth
    low, high = (
        np.array([across.min(), down.min()]),
        np.array([across.max(), down.max()]),
    )
    return low * camera.focal + camera.center, high * camera.focal + camera.center


# ------------------------------------------------------------------------------------ outlines


def hull_points(points: Float[np.ndarray, "n d"]) -> Float[np.ndarray, "k d"]:
    """Return the vertices of the points' convex hull, or all distinct points if the set is flat."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        return points[ConvexHull(points).vertices]
    except QhullError:
        return np.unique(points, axis=0)


def convex_outline(points: Real[np.ndarray, "n 2"]) -> Float[np.ndarray, "k 2"]:
    """Return the convex hull of 2D points, counter-clockwise (Andrew's monotone chain)."""
    unique = _sort_distinct(np.round(np.asarray(points, float), 9))
    if len(unique) < 3:
        raise InputError("An outline needs at least three distinct points.")
    if len(unique) > len(_AROUND):
        unique = _leave_inner_out(unique)

    path = unique.tolist()  # plain floats: indexing two-element arrays one at a time is slow
    return np.array(_half_outline(path) + _half_outline(path[::-1]))


def _sort_distinct(points: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "m 2"]:
    """Return the distinct points, sorted by x, then y."""
    ordered = points[np.lexsort((points[:, 1], points[:, 0]))]
    new = np.ones(len(ordered), bool)
    new[1:] = (ordered[1:] != ordered[:-1]).any(1)
    return ordered[new]


def _half_outline(ordered: list[list[float]]) -> list[list[float]]:
    """Return one half of the convex hull of sorted points, without its last point."""
    chain: list[list[float]] = []
    for x, y in ordered:
        while len(chain) > 1:
            (x0, y0), (x1, y1) = chain[-2:]
            if (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) > 1e-12:
                break
            chain.pop()
        chain.append([x, y])
    return chain[:-1]


_AROUND = 2 * np.pi * np.arange(32) / 32
# in batches, which limits memory
_WAYS = np.column_stack([np.cos(_AROUND), np.sin(_AROUND)]).reshape(4, 8, 2)


def _leave_inner_out(points: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "k 2"]:
    """Return the points without those that certainly lie inside their convex hull.

    The removed points lie inside the polygon of the extreme points in 32 directions (S. Akl and G.
    Toussaint, "A fast convex hull algorithm", 1978).
    """
    far = np.concatenate([(points @ ways.T).argmax(0) for ways in _WAYS])
    corners = points[far[far != np.roll(far, 1)]]
    sides = np.roll(corners, -1, axis=0) - corners
    along, up = sides.T[:, :, None]
    x, y = points.T[:, None, :] - corners.T[:, :, None]
    return points[~(along * y - up * x > 1e-9).all(0)]


def inside_margin(
    points: Float[np.ndarray, "*n 2"], outline: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "m"]:
    """Return how far inside a convex counter-clockwise outline each point is (negative outside)."""
    ends = np.roll(outline, -1, axis=0)
    edges = ends - outline
    normals = np.column_stack([-edges[:, 1], edges[:, 0]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    points = np.atleast_2d(np.asarray(points, float))
    return ((points[:, None] - outline[None]) * normals[None]).sum(-1).min(1)


def proportion_gap(a: Float[np.ndarray, "3"], b: Float[np.ndarray, "3"]) -> float:
    """Return the mean absolute log ratio between the proportions of two extents.

    The two horizontal sides are compared in order of length; overall size does not count.
    """
    rows = [np.log(np.array([max(v[0], v[1]), min(v[0], v[1]), v[2]])) for v in (a, b)]
    gap = (rows[0] - rows[0].mean()) - (rows[1] - rows[1].mean())
    return float(np.abs(gap).mean())
