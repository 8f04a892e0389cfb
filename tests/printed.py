"""Boxes with a print, for tests of front detection."""

import numpy as np
from toy import CUBE_FACES, corners

from generator.scene import Mesh


def box(printed: bool = False) -> Mesh:
    """Return the unit box; if ``printed``, its side towards -y is half red."""
    points = corners([-0.5] * 3, [0.5] * 3)[CUBE_FACES].reshape(-1, 3)
    faces = np.arange(36).reshape(-1, 3)
    texture = np.full((1, 2, 3), 190, np.uint8)
    texture[0, 1] = (200, 20, 20)
    uv = np.full((36, 2), 0.25)
    if printed:
        front = (points[faces][..., 1] < -0.49).all(1)
        uv[faces[front].ravel(), 0] = 0.25 + 0.5 * (points[faces[front].ravel(), 0] > 0)
    return Mesh(points, faces, uv, texture)
