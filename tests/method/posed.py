"""Objects drawn at known yaws and cut out of their pictures, for the rotation stage."""

import dataclasses

import numpy as np

from generator.geometry import Camera, mask_box, yaw_quaternion
from generator.method.rotation import RotationConfig
from generator.render.raster import place, render
from generator.scene import Instance, Mesh, Model, Reference, View
from tabletop_objects import build

SIZE = (640, 480)
VIEW = View(azimuth=0.1, elevation=np.deg2rad(52.0), fov=np.deg2rad(38.0))
FAST = dataclasses.replace(
    RotationConfig(), coarse_step=np.deg2rad(10.0), candidates=4, steps=25, points=3000,
    resolution=72, finalists=2, close_points=6000, close_resolution=80,
)  # fmt: skip


def picture_of(
    model: Model, yaw: float, pixel: tuple[float, float], view: View = VIEW
) -> tuple[Instance, Reference]:
    """Cut ``model`` out of a picture in which it stands under ``pixel``, rotated by ``yaw``."""
    camera = Camera.looking_at(np.zeros(3), view, 0.9, *SIZE)
    position = camera.on_plane(np.array([pixel]), 0.0)[0] + [0, 0, model.size[2] / 2]
    item = place(model.mesh, model.size, position, yaw_quaternion(yaw))
    drawn = render([item], camera, supersample=1)
    mask = drawn.ids >= 0
    box = mask_box(mask)
    x0, y0, x1, y1 = box.astype(int)
    crop = np.dstack([drawn.image, mask.astype(np.uint8) * 255])[y0:y1, x0:x1]
    return Instance(model.name, model.label, box, mask, crop, box), Reference(drawn.image)


def box(size: tuple[float, float, float], front: tuple[int, int, int] | None = None) -> Model:
    """Return a grey box; ``front`` is the colour of one of its ends."""
    corners, faces, uv = [], [], []
    for axis in range(3):
        for side in (-0.5, 0.5):
            n = len(corners)
            for u, v in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
                corner = np.empty(3)
                corner[[axis, (axis + 1) % 3, (axis + 2) % 3]] = side, u, v
                corners.append(corner)
            quad = [[n, n + 1, n + 2], [n, n + 2, n + 3]]
            faces += quad if side > 0 else [f[::-1] for f in quad]
            uv += [[0.75 if (axis, side) == (0, 0.5) else 0.25, 0.5]] * 4
    texture = np.array([[(170, 170, 165), front or (170, 170, 165)]], np.uint8)
    mesh = Mesh(np.array(corners), np.array(faces), np.array(uv), texture)
    return dataclasses.replace(build("candle", 0), mesh=mesh, size=np.array(size))
