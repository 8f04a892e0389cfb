"""The projection of one instance's picture: the reference camera, cropped to the instance.

The modeler receives the view along the instance's own ray, but no distance. The unit of length is
therefore the *pixel at the object's depth*: the object frame has its origin on the ray through the
centre of the instance's box, one focal length (in reference pixels) from the camera along the
optical axis, with +x right, +y away and +z up as in the world frame.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ..geometry import view_rotation, wrap
from ..scene import Instance, View
from ..scene.triangles import Faces, Vertices

Vector = Float[np.ndarray, "3"]


def camera_view(view: View, pixel: Float[np.ndarray, "2"], width: int, height: int) -> View:
    """Return the view of the camera whose ray through ``pixel`` has the direction of ``view``.

    This is the inverse of ``geometry.ray_view``. Of the two such cameras, the one that looks more
    nearly along +y is returned.
    """
    focal = height / 2 / np.tan(view.fov / 2)
    right, down = (np.asarray(pixel, float) - [width / 2, height / 2]) / focal
    c, s = np.cos(view.roll), np.sin(view.roll)
    x, y = c * right - s * down, s * right + c * down  # as seen by a level camera
    sine = np.sqrt(1 + x * x + y * y) * np.sin(view.elevation) / np.sqrt(1 + y * y)
    first = np.arcsin(np.clip(sine, -1, 1))
    options = []
    for total in (first, np.pi - first):
        elevation = float(total - np.arctan(y))
        if total > first and elevation > np.pi / 2:
            continue
        elevation = float(np.clip(elevation, 1e-3, np.pi / 2))
        # In the camera's heading, the ray runs x to the right and `ahead` forwards.
        ahead = np.cos(elevation) - y * np.sin(elevation)
        azimuth = wrap(view.azimuth + np.arctan2(x, ahead))
        options.append(View(azimuth, elevation, view.fov, view.roll))
    return min(options, key=lambda v: abs(v.azimuth))


@dataclass(frozen=True, eq=False)
class Projection:
    """A pinhole camera with its principal point at ``center``, in pixels of the crop.

    ``rotation`` converts directions from the object frame to camera axes (x right, y down, z
    forward). ``position`` is the camera's position; ``width`` and ``height`` are those of the crop.
    """

    rotation: Float[np.ndarray, "3 3"]
    position: Vector
    focal: float
    center: Float[np.ndarray, "2"]
    width: int
    height: int

    @classmethod
    def of_instance(cls, instance: Instance, view: View) -> Projection:
        """Return the projection of an instance's crop; ``view`` is along the instance's own ray."""
        rows, columns = instance.mask.shape
        pixel = (instance.box[:2] + instance.box[2:]) / 2
        whole = camera_view(view, pixel, columns, rows)
        focal = rows / 2 / np.tan(view.fov / 2)
        offset = (pixel - [columns / 2, rows / 2]) / focal
        rotation = view_rotation(whole)
        position = -focal * (np.array([*offset, 1.0]) @ rotation)
        height, width = instance.crop.shape[:2]
        x0, y0, x1, y1 = instance.crop_box
        zoom = float(np.sqrt(width * height / ((x1 - x0) * (y1 - y0))))
        center = (np.array([columns / 2, rows / 2]) - [x0, y0]) * zoom
        return cls(rotation, position, focal * zoom, center, width, height)

    def resize(self, longest: int) -> Projection:
        """Return the same projection onto a picture whose longer side has ``longest`` pixels."""
        zoom = longest / max(self.width, self.height)
        size = max(1, round(self.width * zoom)), max(1, round(self.height * zoom))
        return dataclasses.replace(
            self, focal=self.focal * zoom, center=self.center * zoom, width=size[0], height=size[1]
        )

    @property
    def right(self) -> Vector:
        """Horizontal unit vector that points to the right in the picture."""
        return self.rotation[0]

    @property
    def away(self) -> Vector:
        """Horizontal unit vector that points away from the camera."""
        return np.array([-self.rotation[0, 1], self.rotation[0, 0], 0.0])

    @property
    def pixel(self) -> float:
        """Length of one pixel at the distance of the origin."""
        return float(np.linalg.norm(self.position)) / self.focal

    @property
    def sine(self) -> float:
        """Sine of the elevation at which the camera sees the origin."""
        return float(np.clip(self.position[2] / np.linalg.norm(self.position), 0.05, 1.0))

    def to_camera(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        """Convert points from the object frame to camera axes."""
        return (np.asarray(points, float) - self.position) @ self.rotation.T

    def project(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 2"]:
        """Return the crop pixels of points in the object frame."""
        p = self.to_camera(points)
        return p[:, :2] / np.maximum(p[:, 2:], 1e-6) * self.focal + self.center

    def on_plane(
        self, pixels: Float[np.ndarray, "n 2"], point: Vector, normal: Vector
    ) -> Float[np.ndarray, "n 3"]:
        """Return the intersections of the rays through crop ``pixels`` with a plane."""
        flat = (np.asarray(pixels, float) - self.center) / self.focal
        rays = np.column_stack([flat, np.ones(len(flat))]) @ self.rotation
        along = rays @ normal
        along = np.where(np.abs(along) < 1e-9, 1e-9, along)
        return self.position + rays * (((point - self.position) @ normal) / along)[:, None]

    def corners(self, vertices: Vertices, faces: Faces) -> Float[np.ndarray, "m 3 3"]:
        """Return (pixel x, pixel y, 1/depth) per face and corner, for ``raster.rasterise``."""
        p = self.to_camera(vertices)
        depth = np.maximum(p[:, 2:], 1e-6)
        return np.concatenate([p[:, :2] / depth * self.focal + self.center, 1 / depth], 1)[faces]

    def silhouette(self, vertices: Vertices, faces: Faces) -> Bool[np.ndarray, "h w"]:
        """Return the crop pixels that a closed mesh covers."""
        fixed = np.round((self.project(vertices) - 0.5) * 16).clip(-(2**20), 2**20)
        triangles = fixed.astype(np.int32)[faces]
        (ax, ay), (bx, by) = (triangles[:, k].T - triangles[:, 0].T for k in (1, 2))
        canvas = np.zeros((self.height, self.width), np.uint8)
        # The silhouette of a closed surface is that of its front faces (y points down).
        for triangle in triangles[ax * by - ay * bx < 0]:
            cv2.fillConvexPoly(canvas, triangle, 1, cv2.LINE_8, 4)
        return canvas > 0

    def hull_silhouette(self, vertices: Float[np.ndarray, "n 3"]) -> Bool[np.ndarray, "h w"]:
        """Return the crop pixels that the convex hull of ``vertices`` covers."""
        canvas = np.zeros((self.height, self.width), np.uint8)
        fill_hull(canvas, self.project(vertices))
        return canvas > 0

    def inside(
        self, mask: Bool[np.ndarray, "h w"], points: Float[np.ndarray, "... 3"]
    ) -> Bool[np.ndarray, "..."]:
        """Return which points project into ``mask``, which has the size of this projection."""
        pixels = np.floor(self.project(points.reshape(-1, 3))).astype(np.int64)
        x, y = pixels[:, 0], pixels[:, 1]
        on = (x >= 0) & (y >= 0) & (x < self.width) & (y < self.height)
        hit = np.zeros(len(pixels), bool)
        hit[on] = mask[y[on], x[on]]
        return hit.reshape(points.shape[:-1])


def fill_hull(canvas: UInt8[np.ndarray, "h w"], pixels: Float[np.ndarray, "n 2"]) -> None:
    """Fill the convex hull of ``pixels`` (centres at half-integers) with 1, in place."""
    fixed = np.round((pixels - 0.5) * 16).clip(-(2**20), 2**20).astype(np.int32)
    cv2.fillConvexPoly(canvas, cv2.convexHull(fixed), 1, cv2.LINE_8, 4)
