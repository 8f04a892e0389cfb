"""Placement of models with depth maps: a model's visible part is moved to the observed points."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from jaxtyping import Bool

from ....geometry import yaw_quaternion
from ....render.contact import Body
from ....render.raster import place, render
from ....scene import Model
from ..plane.plane import TablePlane
from .measure import ObservedSolid, table_points

_ACROSS = 60.0  # width of an object in the small renders, in pixels
_TIMES = 5  # maximum number of steps
_NEAR = 5e-4  # metres; a smaller step ends the iteration
_FEW = 20  # minimum number of visible pixels


def seat(
    model: Model,
    yaw: float,
    floor: float,
    solid: ObservedSolid,
    others: Bool[np.ndarray, "h w"],
    plane: TablePlane,
) -> Body:
    """Place a model of fixed size so that the centroid of its visible part matches the depth map.

    Both centroids cover visible surface only; parts covered by ``others`` are excluded. (Within the
    object's own mask alone, a model that is slightly too large would fit anywhere.) ``floor`` is
    the height of the object's support above the tabletop in metres.
    """
    camera = plane.camera
    factor = max(1.0, _span(solid, plane) / _ACROSS)
    width, height = (max(1, round(side / factor)) for side in (camera.width, camera.height))
    across, down = camera.offset
    small = replace(camera, width=width, height=height, offset=(across / factor, down / factor))
    shown = cv2.resize(others.astype(np.uint8), (width, height)) == 0
    size = np.asarray(model.size)
    body = Body(model.mesh, size, yaw, np.array([*solid.center, floor + size[2] / 2]))
    wanted, lowest = solid.points[:, :2].mean(0), solid.points[:, 2].min()
    for _ in range(_TIMES):
        item = place(body.mesh, body.scale, body.position, yaw_quaternion(body.yaw))
        depth = render([item], small, supersample=1).depth
        seen = table_points(np.where(np.isfinite(depth) & shown, depth, 0.0), small)
        seen = seen[seen[..., 2] >= lowest]
        if len(seen) < _FEW:
            return body
        shift = wanted - seen[:, :2].mean(0)
        body = replace(body, position=body.position + np.append(shift, 0.0))
        if np.abs(shift).max() < _NEAR:
            break
    return body


def _span(solid: ObservedSolid, plane: TablePlane) -> float:
    """Return the approximate width of an object in pixels."""
    away = float(plane.camera.to_camera(solid.points).mean(0)[2])
    return float(np.hypot(solid.extent[0], solid.top - solid.bottom)) / away * plane.camera.focal
