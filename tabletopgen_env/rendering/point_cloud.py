"""Point clouds of the objects on the table, from depth pictures.

=================  =========================================================================
``points``         ``float32`` (n, 3): base frame, metres
``point_ids``      ``uint8`` (n,): label of each point, numbered as in a segmentation (``views``):
                   1 the robot, 3 and up the objects in slot order
``point_mask``     ``uint8`` (n,): 1 for a point, 0 for padding, whose other entries are 0
=================  =========================================================================

The cloud contains the points in the arm's workspace that lie at least 3 mm above the table top,
which excludes the top itself. If the cameras see too many points, every k-th is taken, row by row
and camera by camera: the same pictures always give the same points.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Float, Shaped

from ..actions import WORKSPACE
from .config import ObservationConfig
from .views import CAMERAS, LAST_LABEL, geom_labels, model_camera

if TYPE_CHECKING:
    from generator.geometry import Camera

    from ..world.world import World
    from .kinds import DrawerOf

ABOVE = 0.003
"""Minimum height of points above the table top, in metres."""


def point_cloud_spaces(count: int) -> dict[str, spaces.Space[Any]]:
    """Return the spaces of a cloud with ``count`` points."""
    low, high = (np.tile(np.array(bound, np.float32), (count, 1)) for bound in WORKSPACE)
    return {
        "points": spaces.Box(low, high, dtype=np.float32),
        "point_ids": spaces.Box(0, LAST_LABEL, (count,), np.uint8),
        "point_mask": spaces.Box(0, 1, (count,), np.uint8),
    }


def point_cloud(
    config: ObservationConfig, world: World, drawers: DrawerOf, order: Sequence[str]
) -> dict[str, Shaped[np.ndarray, "n *_c"]]:
    """Return the point cloud seen by the cameras of ``config``; see also ``views.pictures``."""
    labels, points, ids = geom_labels(world, order), [], []
    low, high = np.array(WORKSPACE)
    low[2] = max(low[2], world.scene.table.height + ABOVE - world.base_position[2])
    for name, size in config.sizes.items():
        drawn = drawers(size).draw(world, CAMERAS[name], ("depth", "segmentation"))
        camera = model_camera(world, CAMERAS[name], *size)
        seen = world.to_base(unproject(camera, drawn["depth"]))
        inside = ((seen >= low) & (seen <= high)).all(1)
        points.append(seen[inside])
        ids.append(labels[drawn["segmentation"]].ravel()[inside])
    return _fit(np.concatenate(points), np.concatenate(ids), config.points)


def unproject(camera: Camera, depth: Float[np.ndarray, "h w"]) -> Float[np.ndarray, "hw 3"]:
    """Return the world points of a camera's pixels, row by row, with NaN for the background."""
    rows, columns = np.indices(depth.shape) + 0.5
    across = (columns - camera.center[0]) / camera.focal
    down = (rows - camera.center[1]) / camera.focal
    rays = np.stack([across, down, np.ones_like(down)], -1).reshape(-1, 3)
    z = depth.astype(np.float64).reshape(-1, 1)
    return np.where(np.isfinite(z), z, np.nan) * rays @ camera.rotation + camera.position


def _fit(
    points: Float[np.ndarray, "m 3"], ids: Shaped[np.ndarray, "m"], count: int
) -> dict[str, Shaped[np.ndarray, "n *_c"]]:
    """Return ``count`` of the points, taken at even intervals, or all of them with padding."""
    kept = np.arange(len(points))
    if len(points) > count:
        kept = np.arange(count) * len(points) // count
    padding = (0, count - len(kept))
    return {
        "points": np.pad(points[kept].astype(np.float32), (padding, (0, 0))),
        "point_ids": np.pad(ids[kept], padding),
        "point_mask": np.pad(np.ones(len(kept), np.uint8), padding),
    }
