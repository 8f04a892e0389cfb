"""A model's place on the table from a depth map: what shows of it lies where depth saw it."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from ...geometry import yaw_quaternion
from ...render.contact import Body
from ...render.raster import place, render
from ...scene import Instance
from .depth_measure import Solid, table_points
from .plane import TablePlane

_ACROSS = 60.0  # pixels across a thing in the small renders
_TIMES = 3  # how often it is moved
_FEW = 20  # pixels: less of it tells nothing


def seated(body: Body, instance: Instance, solid: Solid, plane: TablePlane) -> Body:
    """Move a body along the table until the middle of what shows of it is where depth saw it.

    Both middles are of visible surface alone, so the hidden back of a thing does no harm.
    """
    factor = max(1.0, float(np.sqrt(instance.mask.sum())) / _ACROSS)
    camera = plane.camera
    width, height = (max(1, round(side / factor)) for side in (camera.width, camera.height))
    across, down = camera.offset
    small = replace(camera, width=width, height=height, offset=(across / factor, down / factor))
    shown = cv2.resize(instance.mask.astype(np.uint8), (width, height)) > 0
    wanted = solid.points[:, :2].mean(0)
    for _ in range(_TIMES):
        item = place(body.mesh, body.scale, body.position, yaw_quaternion(body.yaw))
        depth = render([item], small, supersample=1).depth
        seen = table_points(np.where(np.isfinite(depth) & shown, depth, 0.0), small)
        seen = seen[np.isfinite(seen[..., 2])]
        if len(seen) < _FEW:
            return body
        shift = wanted - seen[:, :2].mean(0)
        body = replace(body, position=body.position + np.append(shift, 0.0))
    return body
