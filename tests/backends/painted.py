"""Painted test pictures with ground truth: a table of the catalogue with objects."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from generator.geometry import Camera, mask_box, yaw_quaternion
from generator.render.raster import place, render
from generator.render.sheet import framing_camera
from generator.scene import Detection, Instance, OutlineKind, PlannedTable, View
from generator.tables import build_table
from tabletop_objects import build

UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])
SIZES: dict[OutlineKind, tuple[float, float, float]] = {
    "rectangle": (1.2, 0.7, 0.74),
    "square": (0.9, 0.9, 0.74),
    "round": (1.0, 1.0, 0.74),
    "oval": (1.4, 0.85, 0.74),
    "triangle": (1.1, 1.0, 0.74),
    "slatted": (1.3, 0.75, 0.72),
}


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture, its camera, and the object id and depth (m) of every pixel."""

    image: np.ndarray
    ids: np.ndarray
    camera: Camera
    plan: PlannedTable
    depth: np.ndarray


def paint(
    outline: OutlineKind,
    material: str,
    things: list[tuple[str, float, float, float]],
    *,
    azimuth: float = 0.0,
    elevation: float = 52.0,
    fov: float = 36.0,
    size: tuple[int, int] = (640, 480),
    table: float = 1.0,
) -> Picture:
    """Paint a table with objects (category, x, y, z above the top; metres); angles in degrees.

    ``table`` scales the usual size of the table.
    """
    length, width, height = SIZES[outline]
    across = (table * length, table * width, height)
    plan = PlannedTable(outline, material, "straight", across)
    model = build_table(plan, 0)
    extent = np.asarray(plan.size)
    items = [place(model.mesh, extent, np.array([0, 0, extent[2] / 2]), UPRIGHT, 0)]
    for index, (key, x, y, z) in enumerate(things, start=1):
        made = build(key, 1)
        position = np.array([x, y, extent[2] + z + made.size[2] / 2])
        items.append(place(made.mesh, made.size, position, yaw_quaternion(0.4), index))
    points = np.concatenate([item.vertices for item in items])
    view = View(*np.deg2rad([azimuth, elevation, fov]))
    camera = framing_camera(points, view, *size)
    drawn = render(items, camera)
    return Picture(drawn.image, drawn.ids, camera, plan, drawn.depth)


def detections(picture: Picture, names: Sequence[str]) -> dict[str, Detection]:
    """Return the place of each object in a picture, by names such as "mug_1", the table first."""
    return {
        name: Detection(name.removesuffix("_1"), mask_box(picture.ids == k), picture.ids == k)
        for k, name in enumerate(names)
    }


def as_shown(image: np.ndarray, name: str, found: Detection) -> Instance:
    """Return the instance of an object's visible part in a picture, without completion."""
    x0, y0, x1, y1 = found.box.astype(int)
    crop = np.dstack([image, 255 * found.mask.astype(np.uint8)])[y0:y1, x0:x1]
    return Instance(name, found.label, found.box, found.mask, crop, found.box)
