"""Whether a picture determines an object's pose: similarity to the object's other sides."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float

from generator.geometry import Camera, yaw_quaternion
from generator.render.raster import place, render
from generator.render.shading import Light
from generator.scene import Model

DISTINCT = 0.04
"""Minimum difference, in [0, 1], at which a picture distinguishes two poses."""

_SIDE = 72  # maximum side of the compared pictures, pixels
_SMALL = 40  # side in pixels below which pictures are supersampled
_APART = 30.0  # minimum angle of another side, degrees


def window(camera: Camera, box: Float[np.ndarray, "4"], zoom: float = 1.0) -> Camera:
    """Return the camera that shows only a pixel box of ``camera``, magnified by ``zoom``."""
    width, height = (max(1, round(float(side) * zoom)) for side in box[2:] - box[:2])
    offset = (camera.center - box[:2]) * zoom - np.array([width, height]) / 2
    fov = 2 * np.arctan(height / 2 / (camera.focal * zoom))
    return Camera(
        camera.position, camera.rotation, float(fov), width, height,
        (float(offset[0]), float(offset[1])),
    )  # fmt: skip


def close_up(
    model: Model,
    yaw: float,
    position: Float[np.ndarray, "3"],
    camera: Camera,
    light: Light,
    side: int,
) -> tuple[Float[np.ndarray, "s s 4"], Float[np.ndarray, "4"]]:
    """Draw a posed object cropped tightly into a square: RGBA in [0, 1], and the square's box."""
    item = place(model.mesh, model.size, position, yaw_quaternion(yaw))
    pixels = camera.project(item.vertices)
    low, high = pixels.min(0), pixels.max(0)
    half = 0.53 * float((high - low).max())
    middle = (low + high) / 2
    box = np.concatenate([middle - half, middle + half])
    near = window(camera, box, side / (2 * half))
    drawn = render([item], near, light=light, supersample=2 if side < _SMALL else 1, shadows=False)
    return np.dstack([drawn.image / 255.0, drawn.ids >= 0]), box


def difference(
    a: Float[np.ndarray, "s s 4"], b: Float[np.ndarray, "s s 4"], seen: Bool[np.ndarray, "s s"]
) -> float:
    """Return the difference of two pictures where both are ``seen``, in [0, 1].

    It is the mean over both silhouettes of the largest channel's difference, which is 1 where only
    one of the two is present.
    """
    inside, both = np.maximum(a[..., 3], b[..., 3]) * seen, a[..., 3] * b[..., 3] * seen
    colour = np.abs(a[..., :3] - b[..., :3]).max(-1)
    return float((inside - both + both * colour).sum() / max(float(inside.sum()), 1.0))


def alike(
    model: Model,
    yaw: float,
    position: Float[np.ndarray, "3"],
    camera: Camera,
    light: Light,
    front: Bool[np.ndarray, "h w"],
    symmetry: float = 1,
) -> float:
    """Return the ``difference`` to the most similar other side in the same picture.

    The object is rotated in place, drawn under the same light at the size it has in the picture (up
    to ``_SIDE`` pixels), and cropped tightly; pixels that ``front`` hides in the true picture are
    ignored. Other sides are at least 30 degrees away, modulo the object's own ``symmetry``.
    """
    item = place(model.mesh, model.size, position, yaw_quaternion(yaw))
    side = int(np.clip(np.ptp(camera.project(item.vertices), axis=0).max(), 8, _SIDE))
    true, box = close_up(model, yaw, position, camera, light, side)
    at = (np.arange(side) + 0.5) / side
    columns = np.clip(box[0] + at * (box[2] - box[0]), 0, camera.width - 1).astype(int)
    rows = np.clip(box[1] + at * (box[3] - box[1]), 0, camera.height - 1).astype(int)
    seen = ~front[np.ix_(rows, columns)]

    def differ(angle: float) -> float:
        other, _ = close_up(model, yaw + np.deg2rad(angle), position, camera, light, side)
        return difference(true, other, seen)

    period = 360.0 / symmetry
    reach = min(_APART, period / 3)
    angles = np.arange(reach, period - reach + 1e-6, 10.0)
    costs = np.array([differ(a) for a in angles])
    least = float(costs.min())
    for k in np.argsort(costs)[:2]:
        finer = [a for a in angles[k] + np.array([-5, -2.5, 2.5, 5])
                 if reach <= a <= period - reach]  # fmt: skip
        least = min([least, *(differ(a) for a in finer)])
    return least
