"""RGB-D pictures of painted tables in a room, with sensor noise and ground truth."""

from dataclasses import dataclass

import numpy as np
from painted import Picture, paint

from generator.geometry import Camera, mask_box
from generator.scene import TABLE, Instance, Intrinsics, OutlineKind, Reference

FRAME = (320, 240)
THINGS = [("bowl", 0.2, 0.15, 0.0), ("mug", -0.25, 0.05, 0.0), ("apple", 0.1, -0.15, 0.0)]


@dataclass(frozen=True, eq=False)
class Shot:
    """A painted table in a room: its depth map with sensor noise, and intrinsics."""

    picture: Picture
    depth: np.ndarray
    intrinsics: Intrinsics


def shoot(outline: OutlineKind = "rectangle", things=THINGS, *, noise=0.001, **view) -> Shot:
    picture = paint(outline, "oak", things, size=FRAME, **view)
    camera = picture.camera
    depth = np.where(np.isfinite(picture.depth), picture.depth, room(camera))
    depth = depth + np.random.default_rng(0).normal(size=depth.shape) * noise * depth**2
    center = camera.center - 0.5
    intrinsics = Intrinsics(camera.focal, camera.focal, center[0], center[1])
    return Shot(picture, depth.astype(np.float32), intrinsics)


def room(camera: Camera) -> np.ndarray:
    """Return the depth of a floor at z = 0 and of a wall 2 m behind the table's centre."""
    y, x = np.mgrid[0 : camera.height, 0 : camera.width] + 0.5
    rays = camera.rays(np.column_stack([x.ravel(), y.ravel()]))
    floor = -camera.position[2] / np.where(rays[:, 2] < -1e-9, rays[:, 2], np.nan)
    wall = (2.0 - camera.position[1]) / np.where(rays[:, 1] > 1e-9, rays[:, 1], np.nan)
    steps = np.nan_to_num(np.fmin(floor, wall))
    return (steps * (rays @ camera.rotation[2])).reshape(y.shape)


def scene_of(shot: Shot, names: tuple[str, ...]) -> tuple[Reference, tuple[Instance, ...]]:
    reference = Reference(shot.picture.image, depth=shot.depth, intrinsics=shot.intrinsics)
    instances = []
    for number, name in enumerate((TABLE, *names)):
        mask = shot.picture.ids == number
        box = mask_box(mask)
        x0, y0, x1, y1 = box.astype(int)
        crop = np.dstack([shot.picture.image, mask * np.uint8(255)])[y0:y1, x0:x1]
        instances.append(Instance(name, name, box, mask, crop, box))
    return reference, tuple(instances)
