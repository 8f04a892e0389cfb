"""Camera views: pictures, depth and segmentation.

Keys of the observation, by camera (``front``, ``wrist``, ``top``, ``side``) and kind:

======================  ====================================================================
``front``               rgb: the picture, ``uint8`` (height, width, 3)
``front_depth``         depth: metres along the optical axis, ``float32`` (height, width);
                        10 for the background and anything farther
``front_segmentation``  segmentation: the label of each pixel, ``uint8`` (height, width): 0 the
                        background, 1 the robot with its pedestal, 2 the table with the marked
                        spot, 3 and up the objects in slot order (3 is slot 0, the target);
                        objects without a slot are background
``front_target``        with ``target_mark="mask"``: the visible part of the target, ``uint8``
                        (height, width) of 0 and 1
``front_calibration``   with ``calibration``: ``float32`` (16,), the first three rows of the
                        camera's extrinsics in order, then fx, fy, cx and cy of its intrinsics
                        in units of the picture's height; see ``camera_calibration``
======================  ====================================================================

``front`` views table and robot from across the table, ``side`` from the robot's left, ``wrist`` is
mounted on the hand, and ``top`` looks straight down at the table, with the robot's side at the
bottom. All but ``wrist`` show the whole table top in pictures at least as wide as high.

With ``target_mark="overlay"`` the target is outlined and tinted in magenta, as if a person pointed
it out to the policy. If the tool itself is the target (Reach), nothing is marked.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Bool, Float, Shaped, UInt8

from generator.scene import TABLE

from ..robot.mount import PEDESTAL
from ..world.composition import FRONT_CAMERA, MARKER, SIDE_CAMERA, TOP_CAMERA, WRIST_CAMERA
from ..world.world import World
from .config import CameraName, ObservationConfig
from .kinds import DrawerOf, Kind

if TYPE_CHECKING:
    from collections.abc import Sequence


from generator.geometry import Camera

CAMERAS: Mapping[str, str] = MappingProxyType(
    {"front": FRONT_CAMERA, "wrist": WRIST_CAMERA, "top": TOP_CAMERA, "side": SIDE_CAMERA}
)
"""MuJoCo camera names by their name in observations."""

SLOTS = 12
"""Maximum number of objects in an observation."""

DEPTH_FAR = 10.0
"""Depth of the background and of anything farther, in metres."""

BACKGROUND, ROBOT, TABLETOP, FIRST_SLOT = 0, 1, 2, 3
"""Labels of a segmentation."""

LAST_LABEL = FIRST_SLOT + SLOTS - 1

_TINT, _TINTED = np.array([255.0, 0.0, 200.0]), 0.35  # colour, opacity inside
_TINT.setflags(write=False)
_FARTHEST = 10.0  # bound of a calibration's entries: metres or picture heights


def picture_spaces(config: ObservationConfig) -> dict[str, spaces.Space[Any]]:
    """Return the space of each picture, keyed by observation key."""
    made: dict[str, spaces.Space[Any]] = {}
    for camera, size in config.sizes.items():
        for kind in config.kinds:
            made[config.key(camera, kind)] = _picture_space(kind, size)
        if config.target_mark == "mask":
            made[mask_key(camera)] = spaces.Box(0, 1, size, np.uint8)
        if config.calibration:
            made[calibration_key(camera)] = spaces.Box(-_FARTHEST, _FARTHEST, (16,), np.float32)
    return made


def _picture_space(kind: Kind, size: tuple[int, int]) -> spaces.Space[Any]:
    if kind == "rgb":
        return spaces.Box(0, 255, (*size, 3), np.uint8)
    if kind == "depth":
        return spaces.Box(0.0, DEPTH_FAR, size, np.float32)
    return spaces.Box(0, LAST_LABEL, size, np.uint8)


def mask_key(camera: CameraName) -> str:
    """Return the key of the target mask of a camera."""
    return f"{camera}_target"


def calibration_key(camera: CameraName) -> str:
    """Return the key of a camera's calibration."""
    return f"{camera}_calibration"


def pictures(
    config: ObservationConfig,
    world: World,
    drawers: DrawerOf,
    order: Sequence[str],
    target: str | None,
) -> dict[str, Shaped[np.ndarray, "..."]]:
    """Return the pictures of ``config`` by key; ``order`` lists the objects in the slots.

    ``target`` is the object to mark, None for none.
    """
    labels = geom_labels(world, order)
    marked = config.target_mark != "none"
    kinds = tuple(dict.fromkeys((*config.kinds, *(("segmentation",) if marked else ()))))
    seen: dict[str, Shaped[np.ndarray, "..."]] = {}
    for camera, size in config.sizes.items():
        drawn = drawers(size).draw(world, CAMERAS[camera], kinds)
        if "segmentation" in drawn:
            drawn["segmentation"] = labels[drawn["segmentation"]]
        if "depth" in drawn:
            drawn["depth"] = np.minimum(drawn["depth"], np.float32(DEPTH_FAR))
        if marked:
            mask = (drawn["segmentation"] == FIRST_SLOT) & (target is not None)
            if config.target_mark == "mask":
                seen[mask_key(camera)] = mask.astype(np.uint8)
            else:
                drawn["rgb"] = _tint(drawn["rgb"], mask)
        seen |= {config.key(camera, kind): drawn[kind] for kind in config.kinds}
    if config.calibration:
        for camera, found in camera_calibration(config, world).items():
            lens = found["intrinsics"] / config.sizes[camera][0]
            entries = [*found["extrinsics"][:3].ravel(), lens[0, 0], lens[1, 1], *lens[:2, 2]]
            seen[calibration_key(camera)] = np.array(entries, np.float32)
    return seen


def _tint(picture: UInt8[np.ndarray, "h w 3"], mask: Bool[np.ndarray, "h w"]) -> np.ndarray:
    """Return a copy of a picture with a tinted region, whose edge has the full colour."""
    inside = mask.copy()
    inside[:-1] &= mask[1:]
    inside[1:] &= mask[:-1]
    inside[:, :-1] &= mask[:, 1:]
    inside[:, 1:] &= mask[:, :-1]
    share = np.where(inside, _TINTED, 1.0)[mask, None]
    tinted = picture.copy()
    tinted[mask] = np.rint((1 - share) * picture[mask] + share * _TINT)
    return tinted


def camera_calibration(
    config: ObservationConfig, world: World
) -> dict[CameraName, dict[str, Float[np.ndarray, "n n"]]]:
    """Return the current calibration of each camera of ``config``.

    ``intrinsics`` (3, 3) in pixels, with the *centre* of the top-left pixel at (0, 0), and
    ``extrinsics`` (4, 4), which transforms points of the camera's frame (x right, y down, z
    forward, metres) to the base frame. Both follow the conventions of OpenCV and ROS.
    """
    found = {}
    for name, size in config.sizes.items():
        camera = model_camera(world, CAMERAS[name], *size)
        pose = np.eye(4)
        pose[:3, :3] = world.base_rotation.T @ camera.rotation.T
        pose[:3, 3] = world.to_base(camera.position)
        lens = np.diag([camera.focal, camera.focal, 1.0])
        lens[:2, 2] = camera.center - 0.5
        found[name] = {"intrinsics": lens, "extrinsics": pose}
    return found


def geom_labels(world: World, order: Sequence[str]) -> UInt8[np.ndarray, "geoms"]:
    """Return the segmentation label of each geom; the last entry is for geom -1, the background."""
    model = world.model
    body = np.full(model.nbody, BACKGROUND, np.uint8)
    body[world.robot_bodies] = ROBOT
    body[model.body(PEDESTAL).id] = ROBOT
    body[[model.body(TABLE).id, model.body(MARKER).id]] = TABLETOP
    body[world.bodies[[world.index(name) for name in order]]] = FIRST_SLOT + np.arange(len(order))
    return np.append(body[model.geom_bodyid], np.uint8(BACKGROUND))


def model_camera(world: World, name: str, height: int, width: int) -> Camera:
    """Return a camera of the model at its current pose."""
    index = world.model.camera(name).id
    axes = world.data.cam_xmat[index].reshape(3, 3)
    rotation = np.stack([axes[:, 0], -axes[:, 1], -axes[:, 2]])
    fov = float(np.deg2rad(world.model.cam_fovy[index]))
    return Camera(world.data.cam_xpos[index].copy(), rotation, fov, width, height)
