"""A camera of the model as a pinhole camera."""

from __future__ import annotations

import numpy as np

from generator.geometry import Camera

from ..world.world import World


def model_camera(world: World, name: str, height: int, width: int) -> Camera:
    """Return a camera of the model at its present pose."""
    index = world.model.camera(name).id
    axes = world.data.cam_xmat[index].reshape(3, 3)
    rotation = np.stack([axes[:, 0], -axes[:, 1], -axes[:, 2]])
    fov = float(np.deg2rad(world.model.cam_fovy[index]))
    return Camera(world.data.cam_xpos[index].copy(), rotation, fov, width, height)
