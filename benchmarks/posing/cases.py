"""Single objects of known pose, drawn by the NumPy renderer, as input of the rotation stage."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from generator.errors import InputError, SceneError
from generator.evaluation.surfaces.symmetry import order
from generator.geometry import Camera, mask_box, yaw_quaternion
from generator.render.raster import Item, place, render
from generator.render.shading import Light
from generator.scene import Instance, Model, Reference, View
from research.eye.pictures import patterns
from tabletop_objects import CATEGORIES, build

from .distinct import DISTINCT, alike, window
from .spoiling import Spoiling, blur, erode, occluder, punch, wrong_size

WIDTH, HEIGHT = 1024, 768
TABLE_WIDTH = 1.2  # metres across the picture's centre
VARIANTS = {"dev": (30_000, 40_000), "test": (40_000, 50_000)}
"""Catalogue seeds of each split, disjoint from the package's own training and evaluation seeds."""

STREAMS = {"dev": 101, "test": 202}
"""Keys of the splits' random number generators."""

_LEAST = 300  # minimum pixels of a mask
_TRIES = 150  # maximum number of objects tried per case


@dataclass(frozen=True, eq=False)
class TurnCase:
    """One object whose yaw is estimated.

    ``true`` is the true object, ``model`` the optimiser's input (its size may be wrong); ``camera``
    and ``yaw`` are true, ``view`` is the assumed one. ``instance`` and ``reference`` are the
    perturbed input; ``front`` marks pixels of an occluder, known from the masks of other instances.
    ``order`` is the object's rotational symmetry, ``hidden`` its hidden share, ``apart`` the
    difference to the most similar other side in this picture. ``dropped`` lists the objects drawn
    before it, with the reasons why each was rejected.
    """

    variant: str
    true: Model
    model: Model
    instance: Instance
    reference: Reference
    camera: Camera
    view: View
    light: Light
    yaw: float
    position: Float[np.ndarray, "3"]
    order: float
    hidden: float
    apart: float
    front: Bool[np.ndarray, "h w"]
    dropped: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Draw:
    """The distribution of cases.

    ``split`` and ``seed`` select them, ``only`` restricts the categories, ``models`` are foreign
    objects that replace the catalogue's; ``elevations`` are the camera's, degrees. ``symmetric``
    includes objects with a finite symmetry, whose yaw errors are then modulo that symmetry.
    """

    split: str = "dev"
    seed: int = 1
    spoiling: Spoiling = field(default_factory=Spoiling)
    only: tuple[str, ...] = ()
    models: tuple[Model, ...] = ()
    elevations: tuple[float, float] = (30.0, 65.0)
    symmetric: bool = False

    def rng(self, number: int) -> np.random.Generator:
        """Return the random number generator of case ``number``, independent of all others."""
        return np.random.default_rng([STREAMS[self.split], self.seed, number])

    def object(self, rng: np.random.Generator) -> tuple[str, Model]:
        """Return a random object and the name of its variant."""
        if self.models:
            model = self.models[int(rng.integers(len(self.models)))]
            return model.name, model
        keys: Sequence[str] = self.only or sorted(CATEGORIES)
        key, number = keys[int(rng.integers(len(keys)))], int(rng.integers(*VARIANTS[self.split]))
        return f"{key}:{number}", build(key, number)


def draw_case(draw: Draw, number: int) -> TurnCase:
    """Return case ``number``: objects are drawn until one gives a well-posed case.

    Raises:
        SceneError: no object does, after many tries.
    """
    rng = draw.rng(number)
    dropped: list[tuple[str, str]] = []
    for _ in range(_TRIES):
        variant, model = draw.object(rng)
        symmetry = order(model.mesh, model.size)
        if math.isinf(symmetry) or (symmetry > 1 and not draw.symmetric):
            dropped.append((variant, "symmetric"))
            continue
        case = pose_case(model, variant, symmetry, draw, rng)
        if isinstance(case, str):
            dropped.append((variant, case))
            continue
        return dataclasses.replace(case, dropped=tuple(dropped))
    raise SceneError(f"{_TRIES} objects gave no case, since they look similar from several sides.")


def pose_case(
    model: Model, variant: str, symmetry: float, draw: Draw, rng: np.random.Generator
) -> TurnCase | str:
    """Place ``model`` at random, draw it and perturb the input, or return why it is rejected."""
    spoiling = draw.spoiling
    camera, view = _camera(draw, rng)
    light = _light(spoiling, rng)
    yaw = float(rng.uniform(-np.pi, np.pi))
    for _ in range(50):
        pixel = rng.uniform(0.08, 0.92, (1, 2)) * [WIDTH, HEIGHT]
        position = camera.on_plane(pixel, 0.0)[0] + [0, 0, model.size[2] / 2]
        item = place(model.mesh, model.size, position, yaw_quaternion(yaw), 1)
        shown = camera.project(item.vertices)
        if (shown > 3).all() and (shown < [WIDTH - 3, HEIGHT - 3]).all():
            break
    else:
        return "too large"
    picture, mask = photograph(item, camera, light, rng)
    front = occluder(mask, float(rng.uniform(0, spoiling.occlude)), rng)
    hidden = float((mask & front).sum() / max(int(mask.sum()), 1))
    picture = blur(_paint(picture, front, rng), spoiling.blur)
    visible = punch(erode(mask & ~front, spoiling.erode), spoiling.holes, rng)
    if visible.sum() < _LEAST:
        return "too small"
    apart = alike(model, yaw, position, camera, light, front, symmetry)
    if apart < DISTINCT:
        return "alike"
    off = rng.uniform(-1, 1, 2) * np.deg2rad([spoiling.azimuth, spoiling.elevation])
    elevation = float(np.clip(view.elevation + off[1], 0.02, np.pi / 2))
    believed = View(view.azimuth + float(off[0]), elevation, view.fov)
    given = dataclasses.replace(model, size=wrong_size(model.size, spoiling.size_error, rng))
    return TurnCase(
        variant, model, given, cut_out(model, picture, visible, hidden > 0), Reference(picture),
        camera, believed, light, yaw, position, symmetry, hidden, apart, front,
    )  # fmt: skip


def _camera(draw: Draw, rng: np.random.Generator) -> tuple[Camera, View]:
    view = View(
        float(rng.uniform(-0.2, 0.2)),
        float(np.deg2rad(rng.uniform(*draw.elevations))),
        float(np.deg2rad(rng.uniform(30, 45))),
    )
    return looking_camera(view), view


def looking_camera(view: View) -> Camera:
    """Return the camera of ``view``, aimed at the origin, the table's centre."""
    distance = TABLE_WIDTH / 2 / np.tan(view.fov / 2) * HEIGHT / WIDTH
    return Camera.looking_at(np.zeros(3), view, distance, WIDTH, HEIGHT)


def _light(spoiling: Spoiling, rng: np.random.Generator) -> Light:
    direction = np.array([*rng.uniform(-0.6, 0.6, 2), 0.8])
    tint = rng.uniform(1 - spoiling.tint, 1, 3)
    sun = float(rng.uniform(max(0.0, 0.35 - spoiling.light / 2), 0.35 + spoiling.light / 2))
    return Light(direction, sun=sun, tint=(float(tint[0]), float(tint[1]), float(tint[2])))


def photograph(
    item: Item, camera: Camera, light: Light, rng: np.random.Generator
) -> tuple[UInt8[np.ndarray, "h w 3"], Bool[np.ndarray, "h w"]]:
    """Draw an item (id 1) on a random ground at height 0; return the picture and its mask.

    The ground is drawn only around the item; the rest of the picture has its mean colour.
    """
    tile = patterns.surface(rng)
    low, high = item.vertices[:, :2].min(0), item.vertices[:, :2].max(0)
    middle, half = (low + high) / 2, 1.5 * float((high - low).max()) + 0.1
    corners = middle + half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    ground = Item(np.column_stack([corners, np.zeros(4)]), np.array([[0, 1, 2], [0, 2, 3]]),
                  uv, tile, 0)  # fmt: skip
    pixels = camera.project(item.vertices)
    pad = 0.15 * np.ptp(pixels, axis=0).max() + 8
    box = np.concatenate([np.floor(pixels.min(0) - pad), np.ceil(pixels.max(0) + pad)])
    box = np.clip(box, 0, [WIDTH, HEIGHT] * 2)
    red, green, blue = (int(v) for v in tile.reshape(-1, 3).mean(0))
    drawn = render([ground, item], window(camera, box), light=light, background=(red, green, blue))
    x0, y0, x1, y1 = box.astype(int)
    picture = np.full((camera.height, camera.width, 3), (red, green, blue), np.uint8)
    mask = np.zeros(picture.shape[:2], bool)
    picture[y0:y1, x0:x1], mask[y0:y1, x0:x1] = drawn.image, drawn.ids == 1
    return picture, mask


def _paint(
    picture: UInt8[np.ndarray, "h w 3"], front: Bool[np.ndarray, "h w"], rng: np.random.Generator
) -> UInt8[np.ndarray, "h w 3"]:
    """Draw an occluder."""
    pattern = patterns.clutter(rng, 128, 24)
    size = (picture.shape[1], picture.shape[0])
    return np.where(front[..., None], cv2.resize(pattern, size), picture)


def cut_out(
    model: Model, picture: UInt8[np.ndarray, "h w 3"], mask: Bool[np.ndarray, "h w"], hidden: bool
) -> Instance:
    """Return the instance of a mask; its crop excludes hidden parts."""
    box = mask_box(mask)
    around = np.clip(box + np.array([-8, -8, 8, 8]), 0, [WIDTH, HEIGHT] * 2)
    x0, y0, x1, y1 = around.astype(int)
    crop = np.dstack([picture, mask.astype(np.uint8) * 255])[y0:y1, x0:x1]
    return Instance("thing", model.label, box, mask, crop, around, hidden)


def usable(models: Sequence[Model], symmetric: bool) -> tuple[Model, ...]:
    """Return the foreign models that can give a case: see ``Draw.symmetric``.

    Raises:
        InputError: none can.
    """
    orders = [order(m.mesh, m.size) for m in models]
    most = math.inf if symmetric else 2
    kept = tuple(m for m, n in zip(models, orders, strict=True) if n < most)
    if not kept:
        raise InputError(
            "All meshes are rotationally symmetric, so none gives a case. Pass others"
            + (", not of revolution." if symmetric else ", or --symmetric.")
        )
    return kept
