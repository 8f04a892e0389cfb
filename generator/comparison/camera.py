"""The position of the picture's camera, estimated from the masks."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float
from scipy.optimize import OptimizeResult, least_squares

from ..bundle import Segments
from ..errors import InputError
from ..geometry import Camera, framing_camera, mask_box
from ..render.sheet import scene_items
from ..scene import TABLE, Scene

_EVEN = 0.01
"""Outlier threshold of a box edge, as a fraction of the picture's diagonal."""

_FAR = 5.0
"""Mean error of the box edges, relative to the outlier threshold, above which the fit is repeated
from camera positions closer to the scene."""

_NEARER = (0.3, 0.6, 1.0)
"""Logarithms of the factors by which the camera is moved closer to the scene when a fit is
repeated."""


def picture_camera(scene: Scene, segments: Segments) -> Camera:
    """Return the camera of the reference picture, in its pixels and the scene's world frame.

    Azimuth, elevation and field of view are those of the scene's ``view``. The three remaining
    numbers, the camera's position, minimise the distance between the boxes of the table and all
    objects and the boxes of their masks (robust least squares over box edges; boxes at the frame
    are clipped alike). Three numbers for the whole picture cannot move objects relative to each
    other.

    Raises:
        InputError: no instance of the picture is part of the scene.
    """
    height, width = segments.index.shape
    names = [TABLE, *(thing.name for thing in scene.objects)]
    solids = [np.asarray(item.vertices, float) for item in scene_items(scene)]
    shown = [
        (vertices, mask_box(mask))
        for name, vertices in zip(names, solids, strict=True)
        if (mask := segments.mask(name)).any()
    ]
    if not shown:
        raise InputError(
            "The scene contains none of the picture's instances, so the scene cannot be compared "
            "with the picture."
        )
    points = np.concatenate([vertices for vertices, _ in shown])
    start = framing_camera(points, scene.view, width, height)
    depth = float(start.to_camera(points.mean(0)[None])[0, 2])
    frame = np.array([width, height, width, height], float)

    def camera(steps: Float[np.ndarray, "3"]) -> Camera:
        """Return the camera moved right and down by fractions of the depth, with a scaled depth."""
        right, down, forward = start.rotation
        move = right * steps[0] + down * steps[1] + forward * (1 - np.exp(steps[2]))
        return Camera(start.position + depth * move, start.rotation, start.fov, width, height)

    def misses(steps: Float[np.ndarray, "3"]) -> Float[np.ndarray, "n"]:
        seen = camera(steps)
        edges = [np.clip(_box(seen, vertices), 0, frame) - box for vertices, box in shown]
        return np.concatenate(edges)

    scale = _EVEN * float(np.hypot(width, height))

    def fit(nearer: float) -> OptimizeResult:
        first = np.array([0.0, 0.0, -nearer])
        return least_squares(misses, first, loss="soft_l1", f_scale=scale, diff_step=1e-4)

    best = fit(0.0)
    # for a close view, the start that frames the whole scene is too far away
    if np.abs(best.fun).mean() > _FAR * scale:
        best = min([best, *(fit(nearer) for nearer in _NEARER)], key=lambda found: found.cost)
    return camera(best.x)


def _box(camera: Camera, vertices: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "4"]:
    """Return the pixel box of ``vertices``; those behind the camera are moved in front of it."""
    p = camera.to_camera(vertices)
    pixels = p[:, :2] / np.maximum(p[:, 2:], 1e-3) * camera.focal
    pixels += np.array([camera.width / 2, camera.height / 2])
    return np.concatenate([pixels.min(0), pixels.max(0)])
