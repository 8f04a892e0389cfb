"""A table with six objects of distinct shape and colour: pictures, masks and GLB files.

Things are told apart by their colour, also in a cut-out, so that a server of the tests can look at
what it is sent instead of being told.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
import trimesh
from fitted_models import Example
from jaxtyping import Bool, Float, UInt8
from PIL import Image
from trimesh.visual.material import PBRMaterial

from generator.geometry import Camera, framing_camera, mask_box, yaw_quaternion
from generator.render.raster import place, render
from generator.render.sheet import TOP_DOWN
from generator.scene import TABLE, Mesh, View

TEXT = "a table with a book, a mug, a box, a can, a speaker and a candle"
VIEW = View(0.0, float(np.deg2rad(55)), float(np.deg2rad(30)))

_TOP = (0.9, 0.6, 0.72)  # length, width, height of the table, metres
_WIDE = (384, 256)  # pixels of the reference picture
_PIXELS = 400.0  # pixels per metre of the top view


@dataclass(frozen=True)
class Thing:
    """One object: its size (m), colour, and position relative to the table's centre (m)."""

    noun: str
    round: bool
    size: tuple[float, float, float]
    color: tuple[int, int, int]
    at: tuple[float, float] = (0.0, 0.0)
    yaw: float = 0.0

    @property
    def shape(self) -> trimesh.Trimesh:
        """The object's mesh in metres, z up, about its centre."""
        if self.noun == TABLE:
            return _table(self.size)
        if self.round:
            return trimesh.creation.cylinder(self.size[0] / 2, self.size[2], sections=20)
        return trimesh.creation.box(self.size)

    @property
    def glb(self) -> bytes:
        """The object as a GLB file, y up, in its colour."""
        shape = self.shape
        x, y, z = shape.vertices.T
        shape = trimesh.Trimesh(np.column_stack([x, z, -y]), shape.faces, process=False)
        look = PBRMaterial(baseColorTexture=Image.new("RGB", (16, 16), self.color))
        uv = np.full((len(shape.vertices), 2), 0.5)
        shape.visual = trimesh.visual.TextureVisuals(uv=uv, material=look)
        return trimesh.Scene(shape).export(file_type="glb")


THINGS = {
    thing.noun: thing
    for thing in (
        Thing("book", False, (0.22, 0.16, 0.05), (40, 60, 210), (-0.27, -0.16), 0.3),
        Thing("mug", True, (0.1, 0.1, 0.1), (210, 35, 35), (0.02, -0.13)),
        Thing("box", False, (0.2, 0.14, 0.1), (40, 180, 50), (0.27, -0.05), -0.2),
        Thing("can", True, (0.1, 0.1, 0.09), (215, 40, 200), (-0.3, 0.1)),
        Thing("speaker", False, (0.14, 0.12, 0.14), (40, 200, 210), (-0.04, 0.15)),
        Thing("candle", True, (0.11, 0.11, 0.12), (225, 220, 40), (0.27, 0.21)),
    )
}
BARE = Thing(TABLE, False, _TOP, (150, 105, 65))


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture of the table, and the mask of each object in it, the table first."""

    image: UInt8[np.ndarray, "h w 3"]
    masks: dict[str, Bool[np.ndarray, "h w"]]


@cache
def drawn() -> Picture:
    points = BARE.shape.vertices + np.array([0, 0, _TOP[2] / 2])
    return _taken(framing_camera(points, VIEW, *_WIDE))


@cache
def from_above() -> Picture:
    """Return the top view, which the table top fills."""
    wide, high = (round(_PIXELS * side) for side in _TOP[:2])
    fov = TOP_DOWN.fov
    height = _TOP[2] + _TOP[1] / 2 / float(np.tan(fov / 2))
    rows = np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]])
    return _taken(Camera(np.array([0.0, 0, height]), rows, fov, wide, high))


def boxes_from_above() -> dict[str, list[float]]:
    """Return the objects' boxes in the top view, on a grid of 1000."""
    picture = from_above()
    high, wide = picture.image.shape[:2]
    boxes = {noun: mask_box(picture.masks[noun]) for noun in THINGS}
    return {noun: list(1000 * box / [wide, high, wide, high]) for noun, box in boxes.items()}


def shown_in(picture: UInt8[np.ndarray, "h w c"]) -> Thing:
    """Return the object whose colour a cut-out shows."""
    colors = picture[..., :3][picture[..., 3] > 127] if picture.shape[2] == 4 else picture
    seen = _chroma(np.median(colors.reshape(-1, 3), axis=0))
    return min((BARE, *THINGS.values()), key=lambda t: np.linalg.norm(_chroma(t.color) - seen))


def _chroma(color: object) -> Float[np.ndarray, "3"]:
    value = np.asarray(color, float)
    return value / np.linalg.norm(value)


def _taken(camera: Camera) -> Picture:
    items = []
    for k, thing in enumerate((BARE, *THINGS.values())):
        foot = _TOP[2] if k else 0.0
        middle = np.array([*thing.at, foot + thing.size[2] / 2])
        texture = np.full((2, 2, 3), thing.color, np.uint8)
        shape = thing.shape
        uv = np.full((len(shape.vertices), 2), 0.5)
        mesh = Mesh(shape.vertices, shape.faces, uv, texture)
        items.append(place(mesh, np.ones(3), middle, yaw_quaternion(thing.yaw), k))
    seen = render(items, camera)
    names = (TABLE, *THINGS)
    return Picture(seen.image, {name: seen.ids == k for k, name in enumerate(names)})


def _table(size: tuple[float, float, float]) -> trimesh.Trimesh:
    length, width, height = size
    thick, leg = 0.04, 0.06
    parts = [trimesh.creation.box((length, width, thick))]
    parts[0].apply_translation([0, 0, (height - thick) / 2])
    for x in (-1, 1):
        for y in (-1, 1):
            made = trimesh.creation.box((leg, leg, height - thick))
            made.apply_translation([x * (length - leg) / 2, y * (width - leg) / 2, -thick / 2])
            parts.append(made)
    return trimesh.util.concatenate(parts)


def examples() -> list[Example]:
    """Return the pictures that the test segmenter must know: the drawing and the top view.

    The words come in the order in which they are asked for: that of the answers to list_objects,
    then that of the instances, which begins with what is farthest away.
    """
    front, above = drawn(), from_above()
    far_first = sorted(THINGS, key=lambda noun: float(mask_box(front.masks[noun])[3]))
    return [
        Example(front.image, (TABLE, *THINGS), front.masks),
        Example(above.image, (TABLE, *far_first), above.masks),
    ]
