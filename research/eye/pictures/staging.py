"""A training scene: a table with objects, a camera, lamps, and a background."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float, UInt8

from generator.geometry import Camera, framing_camera, inside_margin, rotation_z
from generator.scene import View
from tabletop_objects.kit.outlines import rectangle

from . import patterns
from .arranging import Placed, arrange
from .gl import Lamp, PlacedMesh
from .supply import Supply

Setting = Literal["white", "gradient", "room", "clutter"]
SETTINGS: tuple[tuple[Setting, float], ...] = (
    ("white", 0.4),
    ("gradient", 0.15),
    ("room", 0.3),
    ("clutter", 0.15),
)
"""Backgrounds and their probabilities."""

Tone = Literal["any", "white", "dark"]
TONES: tuple[tuple[Tone, float], ...] = (("any", 0.78), ("white", 0.14), ("dark", 0.08))
"""White objects on white tables, dark ones on dark tables, and their probabilities."""

_EYE_LEVEL = 0.08
"""Share of pictures taken from just above the tabletop."""

_PRODUCT = 0.4
"""Share of scenes in the style of shops and image models: a whole table, objects at real size."""


@dataclass(frozen=True, eq=False)
class Staging:
    """A scene ready to be drawn.

    ``objects[k]`` draws ``placed[k]``; ``tabletop`` draws the table and its covers; the
    ``surroundings`` are background. ``backdrop`` is the picture far behind everything. ``outline``
    has the top's corners in the world, metres. ``cartoon`` adds drawn outlines. ``mirror`` is the
    strength of the objects' reflection in the top.
    """

    placed: tuple[Placed, ...]
    objects: tuple[PlacedMesh, ...]
    tabletop: tuple[PlacedMesh, ...]
    surroundings: tuple[PlacedMesh, ...]
    backdrop: UInt8[np.ndarray, "s s 3"]
    outline: Float[np.ndarray, "k 3"]
    camera: Camera
    view: View
    lamps: tuple[Lamp, ...]
    setting: Setting
    cartoon: bool
    mirror: float


def stage(rng: np.random.Generator, supply: Supply, side: int) -> Staging:
    """Draw one random scene for a square picture of ``side`` pixels."""
    index = int(rng.integers(len(supply.tables)))
    table = supply.tables[index]
    height = float(table.size[2])
    outline = supply.outlines[index] * table.size[:2]
    product = bool(rng.random() < _PRODUCT)
    placed = arrange(rng, supply, outline, height, _count(rng), tidy=product)
    corners = np.column_stack([outline, np.full(len(outline), height)])
    solid = table.mesh.vertices * table.size
    view, camera = _camera(rng, supply, placed, corners, solid, side, whole=product)
    setting = SETTINGS[int(rng.choice(len(SETTINGS), p=[share for _, share in SETTINGS]))][0]
    if product and rng.random() < 0.5:
        setting = "white" if rng.random() < 0.6 else "gradient"
    cartoon = bool(rng.random() < 0.12)
    lamps = _lamps(rng, view, cartoon)
    tone = TONES[int(rng.choice(len(TONES), p=[share for _, share in TONES]))][0]
    tone = tone if supply.borrows else "any"
    tabletop = [*_furniture(rng, supply, index, tone), *_covers(rng, supply, outline, height)]
    backdrop, surroundings = _surroundings(rng, supply, setting, camera, view, outline, lamps)
    return Staging(
        tuple(placed),
        tuple(_draw(rng, supply, p, tone) for p in placed),
        tuple(tabletop),
        tuple(surroundings),
        backdrop,
        corners,
        camera,
        view,
        tuple(lamps),
        setting,
        cartoon,
        float(rng.uniform(0.05, 0.3)) if rng.random() < 0.15 else 0.0,
    )


def _count(rng: np.random.Generator) -> int:
    """Return a number of objects: mostly 4 to 12, up to 20, a few tables empty."""
    if rng.random() < 0.02:
        return 0
    return int(rng.integers(1, 21)) if rng.random() < 0.4 else int(rng.integers(4, 13))


# ------------------------------------------------------------------------------------ camera


def _camera(
    rng: np.random.Generator,
    supply: Supply,
    placed: list[Placed],
    corners: Float[np.ndarray, "k 3"],
    table: Float[np.ndarray, "n 3"],
    side: int,
    whole: bool,
) -> tuple[View, Camera]:
    """Return a camera: of the ``whole`` table, of its top, or close to some objects."""
    tops = [corners] + [p.vertices(supply.models[p.model])[::7] for p in placed]
    framing = rng.random() * (0.5 if whole else 1.0)
    if framing < 0.5:
        points = np.concatenate([*tops, table + np.array([0.0, 0.0, corners[0, 2] / 2])])
        margin, highest = float(rng.uniform(0.01, 0.14)), 65.0
    elif framing < 0.72:
        points = np.concatenate(tops)
        margin, highest = float(rng.uniform(-0.2, 0.08)), 85.0
    else:
        points = _close(rng, tops[1:], corners)
        margin, highest = float(rng.uniform(-0.08, 0.22)), 85.0
    elevation = np.clip(rng.normal(36, 12), 15, highest)
    if whole:
        elevation = np.clip(rng.normal(30, 9), 13, 60)
    elif rng.random() < 0.3:
        elevation = rng.uniform(15, highest)
    if rng.random() < _EYE_LEVEL:
        elevation = rng.uniform(2, 15)
    turned = rng.uniform(-180, 180) if rng.random() < 0.15 else rng.normal(0, 14)
    if rng.random() < 0.35:
        turned = 0.0
    view = View(*(float(np.deg2rad(a)) for a in (turned, elevation, rng.uniform(20, 70))))
    camera = framing_camera(points, view, side, side, margin)
    slip = rng.normal(0, 0.06, 2) if framing > 0.3 else np.zeros(2)
    reach = float(np.linalg.norm(camera.position - points.mean(0))) * np.tan(view.fov / 2)
    shift = reach * (slip[0] * camera.rotation[0] + slip[1] * camera.rotation[1])
    return view, Camera(camera.position + shift, camera.rotation, view.fov, side, side)


def _close(
    rng: np.random.Generator,
    things: list[Float[np.ndarray, "m 3"]],
    corners: Float[np.ndarray, "k 3"],
) -> Float[np.ndarray, "n 3"]:
    """Return points of some neighbouring objects, or of a part of an empty top."""
    if not things:
        middle = corners.mean(0)
        return middle + (corners - middle) * float(rng.uniform(0.3, 0.8))
    centers = np.array([t.mean(0) for t in things])
    first = centers[int(rng.integers(len(things)))]
    near = np.argsort(np.linalg.norm(centers - first, axis=1))
    points = np.concatenate([things[k] for k in near[: int(rng.integers(2, 10))]])
    low, high = points.min(0), points.max(0)
    low[2] = corners[0, 2]
    pad = np.maximum(0.24 - (high - low)[:2], 0) / 2
    low[:2], high[:2] = low[:2] - pad, high[:2] + pad
    return np.stack(np.meshgrid(*np.stack([low, high], 1)), -1).reshape(-1, 3)


# ------------------------------------------------------------------------------------- light


def _lamps(rng: np.random.Generator, view: View, cartoon: bool) -> list[Lamp]:
    """Return a fill light without shadows and one to three lamps, hard or soft."""
    count = int(rng.choice([1, 1, 2, 3]))
    strength = float(rng.uniform(0.75, 1.08))
    fill = float(rng.uniform(0.4, 0.72)) + (0.15 if cartoon else 0.0)
    if rng.random() < 0.12:  # like sun through a window: shadows are nearly black
        fill = float(rng.uniform(0.2, 0.35))
    lamps = [Lamp(_down(rng, view, 0.2), (0.08, 0.08, 0.08), fill - 0.08, 0.0, shadow=False)]
    for k in range(count):
        share = max(strength - fill, 0.15) / count
        tint = 1 + rng.normal(0, 0.05, 3)
        r, g, b = np.clip(share * tint, 0, 1)
        soft = float(rng.choice([0.004, 0.03, 0.07, 0.12]))
        gloss = float(rng.uniform(0, 0.6))
        way = _down(rng, view, 0.5)
        lamps.append(Lamp(way, (float(r), float(g), float(b)), 0.0, gloss, k < 2, soft))
    return lamps


def _down(rng: np.random.Generator, view: View, spread: float) -> Float[np.ndarray, "3"]:
    """Return a downward direction, more often away from the viewer than towards."""
    way = rotation_z(view.azimuth) @ np.array([*rng.normal([0.0, spread / 2], spread), -1.0])
    return way / np.linalg.norm(way)


# ------------------------------------------------------------------------------------ things


def _draw(rng: np.random.Generator, supply: Supply, placed: Placed, tone: Tone) -> PlacedMesh:
    """Return the drawn object: with its own look, or another colour or texture."""
    mesh = supply.model_mesh(placed.model)
    texture = mesh
    color = np.ones(4)
    chance = rng.random() if supply.borrows else 1.0
    if chance < 0.06:
        texture = int(rng.choice([*supply.cloths, *supply.prints, *supply.surfaces]))
    elif chance < 0.16:  # one colour
        texture = 0
        color[:3] = np.array(patterns.any_color(rng)) / 255
    elif chance < 0.2:  # white or nearly black
        texture = 0
        color[:3] = _level(rng, "white" if rng.random() < 0.5 else "dark")
    elif tone != "any" and chance < 0.7:
        texture = 0
        color[:3] = _level(rng, tone)
    elif chance < 0.4:
        color[:3] = rng.uniform(0.6, 1, 3)
    opacity = supply.models[placed.model].mesh.opacity
    color[3] = opacity if opacity < 1 else 1.0
    if color[3] == 1 and rng.random() < 0.015:
        color[3] = rng.uniform(0.35, 0.7)
    r, g, b, a = (float(c) for c in color)
    return PlacedMesh(
        mesh,
        placed.rotation @ np.diag(placed.size),
        placed.position,
        texture,
        (r, g, b, a),
        float(rng.choice([0.05, 0.2, 0.6, 1.0])),
        float(rng.uniform(0.1, 0.9)),
    )


def _level(rng: np.random.Generator, tone: Tone) -> Float[np.ndarray, "3"]:
    """Return a nearly white or nearly black level."""
    grey = rng.uniform(0.8, 1) if tone == "white" else rng.uniform(0.06, 0.26)
    return grey * rng.uniform(0.92, 1, 3)


def _furniture(
    rng: np.random.Generator, supply: Supply, index: int, tone: Tone
) -> list[PlacedMesh]:
    """Return the table: as built, or its top plain white or coloured, or covered by a texture."""
    size = supply.tables[index].size
    mesh = supply.table_mesh(index)
    at = np.array([0.0, 0.0, size[2] / 2])
    gloss = float(rng.choice([0.0, 0.1, 0.5]))
    legs = PlacedMesh(mesh, np.diag(size), at, mesh, _paint(rng), gloss, 0.6)
    chance = rng.random() if tone == "any" else 0.5
    if chance < 0.45:
        top = PlacedMesh(mesh + 1, np.diag(size), at, mesh, legs.color, gloss, 0.6)
    elif chance < 0.8:
        plain = np.full(3, rng.uniform(0.8, 1)) if rng.random() < 0.6 else rng.uniform(0, 1, 3)
        if tone != "any":
            plain = _level(rng, tone)
        r, g, b = (float(c) for c in plain * rng.uniform(0.95, 1, 3))
        top = PlacedMesh(mesh + 1, np.diag(size), at, 0, (r, g, b, 1.0), gloss, 0.6)
    else:
        look = supply.cloths if chance > 0.96 else supply.surfaces
        top = PlacedMesh(mesh + 2, np.diag(size), at, int(rng.choice(look)), specular=gloss)
    if 0.45 < chance < 0.6:  # legs like the top
        legs = dataclasses.replace(legs, texture=0, color=top.color)
    return [legs, top]


def _paint(rng: np.random.Generator) -> tuple[float, float, float, float]:
    if rng.random() > 0.2:
        return (1.0, 1.0, 1.0, 1.0)
    grey = float(rng.uniform(0.2, 1))
    r, g, b = rng.uniform(0.35, 1, 3) if rng.random() < 0.5 else (grey, grey, grey)
    return float(r), float(g), float(b), 1.0


def _covers(
    rng: np.random.Generator, supply: Supply, outline: Float[np.ndarray, "k 2"], height: float
) -> list[PlacedMesh]:
    """Return sometimes a cloth over most of the top; smaller ones count as objects."""
    if rng.random() > 0.06:
        return []
    size = np.array([*(np.ptp(outline, axis=0) * rng.uniform(0.6, 0.95, 2)), 0.001])
    at = np.array([*outline.mean(0), height])
    if (inside_margin(at[:2] + rectangle(size[0], size[1]), outline) < 0).any():
        return []
    return [_board(int(rng.choice(supply.cloths)), size, at, int(rng.integers(3)))]


def _board(
    texture: int,
    size: Float[np.ndarray, "3"],
    at: Float[np.ndarray, "3"],
    repeat: int,
    yaw: float = 0.0,
    glow: float = 0.0,
) -> PlacedMesh:
    """Return a box of the stock with a textured upper side."""
    return PlacedMesh(repeat, rotation_z(yaw) @ np.diag(size), at, texture, glow=glow, specular=0.0)


# ------------------------------------------------------------------------------- surroundings


def _surroundings(
    rng: np.random.Generator,
    supply: Supply,
    setting: Setting,
    camera: Camera,
    view: View,
    outline: Float[np.ndarray, "k 2"],
    lamps: list[Lamp],
) -> tuple[UInt8[np.ndarray, "s s 3"], list[PlacedMesh]]:
    """Return the backdrop's picture and the objects around the table."""
    side = 512
    if setting == "white":
        shade = 255 if rng.random() < 0.8 else int(rng.integers(240, 255))
        backdrop = np.full((side, side, 3), shade, np.uint8)
        return backdrop, _white_floor(rng, lamps, shade / 255) if rng.random() < 0.65 else []
    if setting == "gradient":
        return patterns.gradient(rng), []
    backdrop = patterns.blurred_clutter(rng)
    if setting == "clutter" and rng.random() < 0.5:
        return backdrop, []
    return backdrop, _room(rng, supply, view, outline)


def _white_floor(rng: np.random.Generator, lamps: list[Lamp], shade: float) -> list[PlacedMesh]:
    """Return a floor as bright as the backdrop except for a faint shadow.

    Its emission compensates for the missing light.
    """
    depth = float(rng.uniform(0.02, 0.18))
    steady = [lamp for lamp in lamps if not lamp.shadow]
    given = sum(lamp.ambient - lamp.diffuse[0] * lamp.direction[2] for lamp in steady)
    cast = sum(-lamp.diffuse[0] * lamp.direction[2] for lamp in lamps if lamp.shadow)
    glow = max(0.0, max(1 - depth, 1.002 - cast) - given)
    size = np.array([14.0, 14.0, 0.02])
    return [
        PlacedMesh(
            0, np.diag(size), np.array([0, 0, -0.01]), 0, (shade, shade, shade, 1.0), 0, 0, glow
        )
    ]


def _room(
    rng: np.random.Generator, supply: Supply, view: View, outline: Float[np.ndarray, "k 2"]
) -> list[PlacedMesh]:
    """Return a floor, sometimes walls, and furniture around the table but not in front of it."""
    away = np.array([-np.sin(view.azimuth), np.cos(view.azimuth)])
    reach = float(np.abs(outline).max())
    turn = float(rng.normal(0, 0.3)) + view.azimuth
    size = np.array([12.0, 12.0, 0.02])
    floor = int(rng.choice(supply.surfaces))
    things = [_board(floor, size, np.array([0, 0, -0.011]), int(rng.integers(1, 3)), turn)]
    if rng.random() < 0.7:
        distance = 1.5 * reach + float(rng.exponential(0.8)) + 0.1
        at = np.array([*(away * distance), 1.5])
        wall = int(rng.choice(supply.surfaces))
        slab = np.array([12.0, 0.04, 3.0])
        glow = float(rng.uniform(0.1, 0.4))  # lamps above hardly illuminate walls
        things.append(_board(wall, slab, at, int(rng.integers(3)), turn, glow))
    for _ in range(int(rng.integers(0, 8))):
        way = away @ np.array([[np.cos(a := rng.uniform(-1.4, 1.4)), np.sin(a)],
                               [-np.sin(a), np.cos(a)]])  # fmt: skip
        far = 1.6 * reach + float(rng.uniform(0.2, 2.2))
        things += _bystander(rng, supply, way * far)
    return things


def _bystander(
    rng: np.random.Generator, supply: Supply, at: Float[np.ndarray, "2"]
) -> list[PlacedMesh]:
    """Return a box, an enlarged object, or another tabletop with a few objects on it."""
    yaw, kind = float(rng.uniform(-np.pi, np.pi)), rng.random()
    every = (*supply.surfaces, *supply.cloths, *supply.prints)
    if kind < 0.5:
        size = rng.uniform([0.1, 0.1, 0.2], [0.7, 0.5, 1.4])
        place = np.array([*at, size[2] / 2])
        return [_board(int(rng.choice(every)), size, place, int(rng.integers(2)), yaw)]
    if kind < 0.65:
        return _another_table(rng, supply, at, yaw)
    index = int(rng.integers(len(supply.models)))
    size = supply.models[index].size
    size = size * float(rng.uniform(0.3, 0.9) / size.max())
    mesh, place = supply.model_mesh(index), np.array([*at, size[2] / 2])
    return [PlacedMesh(mesh, rotation_z(yaw) @ np.diag(size), place, mesh)]


def _another_table(
    rng: np.random.Generator, supply: Supply, at: Float[np.ndarray, "2"], yaw: float
) -> list[PlacedMesh]:
    index = int(rng.integers(len(supply.tables)))
    size, first = supply.tables[index].size * [0.7, 0.7, 1.0], supply.table_mesh(index)
    place, turn = np.array([*at, size[2] / 2]), rotation_z(yaw)
    things = [PlacedMesh(first + k, turn @ np.diag(size), place, first) for k in range(2)]
    for _ in range(int(rng.integers(4))):
        k = int(rng.integers(len(supply.models)))
        model, mesh = supply.models[k], supply.model_mesh(k)
        spot = at + turn[:2, :2] @ (rng.uniform(-0.25, 0.25, 2) * size[:2])
        rest = np.array([*spot, size[2] + model.size[2] / 2])
        things.append(PlacedMesh(mesh, turn @ np.diag(model.size), rest, mesh))
    return things


def backdrop_board(camera: Camera, texture: int) -> PlacedMesh:
    """Return an emissive board far behind everything that fills the camera's picture."""
    distance = 25.0
    extent = 2.2 * distance * np.tan(camera.fov / 2) * max(1.0, camera.width / camera.height)
    right, down, forward = camera.rotation
    turn = np.column_stack([right, forward, -down])  # its -y side faces the camera
    linear = turn @ np.diag([extent, 0.01, extent])
    return PlacedMesh(
        0, linear, camera.position + distance * forward, texture, specular=0.0, glow=1.0
    )
