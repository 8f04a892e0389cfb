"""What cameras show: pictures, depth and which slot each pixel belongs to.

Keys of the observation, by camera (``front``, ``wrist``, ``top``) and kind:

======================  ====================================================================
``front``               rgb: the picture, ``uint8`` (height, width, 3)
``front_depth``         depth: metres along the optical axis, ``float32`` (height, width);
                        10 where nothing is or what is lies farther
``front_segmentation``  segmentation: what the pixel shows, ``uint8`` (height, width): 0 the
                        background, 1 the robot with its pedestal, 2 the table with the marked
                        spot, 3 and up the objects in slot order (3 is slot 0, the target);
                        objects without a slot are background
======================  ====================================================================

``front`` looks at table and robot from across the table, ``wrist`` sits on the hand, and ``top``
looks straight down at the table, the robot's side below; it shows the whole top in pictures at
least as wide as high.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Shaped, UInt8

from generator.scene import TABLE

from ..robot.mount import PEDESTAL
from ..world.composition import FRONT_CAMERA, MARKER, TOP_CAMERA, WRIST_CAMERA
from ..world.world import World
from .config import ObservationConfig
from .kinds import Drawer, Kind

if TYPE_CHECKING:
    from collections.abc import Sequence

CAMERAS: Mapping[str, str] = MappingProxyType(
    {"front": FRONT_CAMERA, "wrist": WRIST_CAMERA, "top": TOP_CAMERA}
)
"""The model's cameras by their name in observations."""

SLOTS = 12
"""Objects that an observation has room for."""

DEPTH_FAR = 10.0
"""Depth that stands for everything farther, and for nothing at all, metres."""

BACKGROUND, ROBOT, TABLETOP, FIRST_SLOT = 0, 1, 2, 3
"""What the numbers of a segmentation mean."""

LAST_LABEL = FIRST_SLOT + SLOTS - 1


def picture_spaces(config: ObservationConfig) -> dict[str, spaces.Space[Any]]:
    """Return the space of each picture by its key."""
    made: dict[Kind, spaces.Space[Any]] = {
        "rgb": spaces.Box(0, 255, (*config.size, 3), np.uint8),
        "depth": spaces.Box(0.0, DEPTH_FAR, config.size, np.float32),
        "segmentation": spaces.Box(0, LAST_LABEL, config.size, np.uint8),
    }
    return {config.key(c, kind): made[kind] for c in config.cameras for kind in config.kinds}


def pictures(
    config: ObservationConfig, world: World, drawer: Drawer, order: Sequence[str]
) -> dict[str, Shaped[np.ndarray, "h w *_c"]]:
    """Return the pictures of ``config`` by their key, objects in the slots' ``order``."""
    labels = geom_labels(world, order)
    seen: dict[str, Shaped[np.ndarray, "h w *_c"]] = {}
    for camera in config.cameras:
        drawn = drawer.draw(world, CAMERAS[camera], config.kinds)
        for kind, picture in drawn.items():
            if kind == "depth":
                picture = np.minimum(picture, np.float32(DEPTH_FAR))
            elif kind == "segmentation":
                picture = labels[picture]
            seen[config.key(camera, kind)] = picture
    return seen


def geom_labels(world: World, order: Sequence[str]) -> UInt8[np.ndarray, "geoms"]:
    """Return what each geom is in a segmentation; the last entry is for geom -1, nothing."""
    model = world.model
    body = np.full(model.nbody, BACKGROUND, np.uint8)
    body[world.robot_bodies] = ROBOT
    body[model.body(PEDESTAL).id] = ROBOT
    body[[model.body(TABLE).id, model.body(MARKER).id]] = TABLETOP
    body[world.bodies[[world.index(name) for name in order]]] = FIRST_SLOT + np.arange(len(order))
    return np.append(body[model.geom_bodyid], np.uint8(BACKGROUND))
