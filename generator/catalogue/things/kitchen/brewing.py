"""What tea and coffee are made with."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import arc, rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, lathe, prism, sweep, tube
from ...surfaces import textures
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look
from ...surfaces.textures import Tile


def _spout(start: tuple[float, float], end: tuple[float, float], low: float, top: float) -> Solid:
    """Return a curved spout in the x-z plane, ``low`` and ``top`` its radii, on the -x side."""
    (x0, z0), (x1, z1) = start, end
    path = smooth([(x0, 0, z0), (0.5 * (x0 + x1), 0, z0 + 0.25 * (z1 - z0)), (x1, 0, z1)], 4)
    return tube(path, np.linspace(low, top, len(path)), 10)


def teapot(look: Look) -> Shape:
    """A teapot, round, tall or flat: spout to the left, handle to the right or over the top."""
    r, h = look.between(0.062, 0.078), look.between(0.1, 0.125)
    color = look.color(
        *("white", "white", "teal", "cream", "navy", "terracotta", "black", "pink", "sage"),
        *("mustard", "sky", "brown", "red"),
    )
    kind, bail = look.pick(["round", "round", "pear", "drum"]), look.chance(0.22)
    glaze, side = glaze_tile(look, color), look.surface(color, "ceramic")
    t = np.linspace(-1.0, 1.05, 12)
    lift = 0.5 + 0.5 * np.sin(t) / np.sin(1.05)
    swell = {
        "round": np.cos(t),
        "pear": np.cos(0.92 * t + 0.28) * (1 - 0.12 * lift),
        "drum": np.cos(t) ** 0.45 * (0.97 - 0.2 * lift),
    }[kind]
    wall = np.column_stack([r * swell, h * lift])
    wall[:, 1] = np.maximum(wall[:, 1] - wall[0, 1], 0)
    top = float(wall[-1, 1])
    body = lathe([(0, 0), *wall, (0, top)], v=[0, *np.linspace(0.02, 0.98, 12), 1])
    rim = min(0.92 * float(wall[-1, 0]), 0.6 * r)
    knob = look.between(0.008, 0.013)
    lid = lathe(
        [(0, top), (rim, top), (rim, top + 0.003), (0.6 * rim, top + 0.011), (0.007, top + 0.015),
         (0.006, top + 0.019), (knob, top + 0.025), (0.7 * knob, top + 0.033), (0, top + 0.034)],
        28,
    )  # fmt: skip
    low = float(np.interp(0.3 * top, wall[:, 1], wall[:, 0]))
    spout = _spout((-low + 0.012, 0.3 * top), (-low - 0.65 * r, 0.95 * top), 0.017, 0.0085)
    back = [np.interp(z * top, wall[:, 1], wall[:, 0]) - 0.004 for z in (0.86, 0.2)]
    grip = look.surface(look.pick([color, (150, 108, 66), (44, 44, 48)]), "plastic")
    if bail:
        curve = arc((0, 0), 1.0, 0.12 * np.pi, 0.88 * np.pi, 14)
        path = np.column_stack([0.98 * r * curve[:, 0], 0 * curve[:, 0],
                                0.35 * top + 1.15 * top * curve[:, 1]])  # fmt: skip
        ear = tube(path, 0.0055, 8)
        parts = [box_part(r, 0.011, 0.014, (0, 0, float(path[:, 2].max()) - 0.01))]
    else:
        ear = tube(
            smooth([(back[0], 0, 0.86 * top), (1.4 * r, 0, 0.92 * top), (1.62 * r, 0, 0.6 * top),
                    (1.38 * r, 0, 0.25 * top), (back[1], 0, 0.2 * top)], 4), 0.0065, 8,
        )  # fmt: skip
        parts = [box_part(0.72 * r, 0.013, 0.7 * top, (1.26 * r, 0, 0.2 * top))]
    ring = wall[:, 1]
    return shape(
        [(body, glaze), (lid, side), (spout, side), (ear, grip if bail else side)],
        [hull_part(body.vertices[body.vertices[:, 2] <= ring[5] + 1e-6]),
         hull_part(body.vertices[body.vertices[:, 2] >= ring[5] - 1e-6]),
         hull_of(lid), hull_of(spout), *parts],
    )  # fmt: skip


def kettle(look: Look) -> Shape:
    """A kettle: an electric jug on its base, a gooseneck, or a dome for the stove."""
    kind = look.pick(["jug", "jug", "gooseneck", "dome"])
    color = look.color(
        "silver", "silver", "black", "red", "white", "cream", "sage", "teal", "copper"
    )
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = textures.speckles(look.rng, look.own_color("charcoal", "black", "brown"), 3, 32)
    r, h = look.between(0.066, 0.078), look.between(0.18, 0.215)
    if kind == "dome":
        return _stove_kettle(look, 1.12 * r, 0.62 * h, skin, dark)
    up = look.between(0.62, 0.9)
    body = lathe(
        [(0, 0.02), (r, 0.02), (1.02 * r, 0.04), (up * r, 0.92 * h), (0.94 * up * r, 0.96 * h),
         (0, 0.96 * h)], v=[0, 0.01, 0.05, 0.9, 0.95, 1],
    )  # fmt: skip
    tile = skin
    if look.chance(0.35):  # a glass window, or a band
        band = textures.plain(look.pick([(150, 186, 200), (40, 40, 44), (200, 202, 206)]))
        tile = textures.stack((skin, 3), (band, look.pick([1, 4])), (skin, 4), side=96)
    base = cylinder(1.02 * r, 0.02, 32, bevel=0.003)
    lid = lathe([(0, 0.95 * h), (0.9 * up * r, 0.95 * h), (0.75 * up * r, 0.98 * h), (0, h)], 28)
    knob = cylinder(0.011, 0.014, 16, bevel=0.002).move(z=0.99 * h)
    if kind == "jug":
        beak = np.array([(-1.1, 0.0), (-0.6, -0.4), (-0.6, 0.4)]) * r * (up + 0.24)
        spout = prism(beak, 0.72 * h, 0.93 * h)
    else:
        path = smooth([(-0.9 * r, 0, 0.16 * h), (-1.5 * r, 0, 0.28 * h), (-1.5 * r, 0, 0.7 * h),
                       (-1.95 * r, 0, 0.9 * h)], 4)  # fmt: skip
        spout = tube(path, np.linspace(0.011, 0.006, len(path)), 10)
    start = up * r - 0.008
    grip = sweep(
        smooth([(start, 0, 0.9 * h), (1.35 * r, 0, 0.93 * h), (1.62 * r, 0, 0.7 * h),
                (1.5 * r, 0, 0.34 * h), (1.25 * r, 0, 0.26 * h)], 4),
        rectangle(0.024, 0.014, 0.005, 2),
    )  # fmt: skip
    return shape(
        [(body, tile), (base, dark), (lid, dark), (knob, dark), (spout, skin), (grip, dark)],
        [cylinder_part(1.02 * r, 0.02), hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.024, 0.022, 0.5 * h, (1.5 * r, 0, 0.32 * h)),
         box_part(0.7 * r, 0.022, 0.016, (1.05 * r, 0, 0.87 * h))],
    )  # fmt: skip


def _stove_kettle(look: Look, r: float, h: float, skin: Tile, dark: Tile) -> Shape:
    """Return a wide kettle with a handle over its dome."""
    t = np.linspace(0, 1, 8)
    dome = np.column_stack([r * np.cos(1.25 * t**1.3), 0.012 + (h - 0.012) * t])
    body = lathe([(0, 0), (0.9 * r, 0), *dome, (0, h)], 32)
    lid = lathe([(0, h - 0.002), (0.36 * r, h - 0.002), (0.3 * r, h + 0.006), (0, h + 0.01)], 24)
    knob = ellipsoid(0.02, 0.02, 0.018, 14, 8).move(z=h + 0.016)
    spout = _spout((-0.8 * r, 0.42 * h), (-1.4 * r, 0.98 * h), 0.02, 0.011)
    curve = arc((0, 0), 1.0, 0.0, np.pi, 16)
    path = np.column_stack(
        [0.8 * r * curve[:, 0], 0 * curve[:, 0], 0.62 * h + 0.95 * h * curve[:, 1]]
    )
    bow = sweep(path, rectangle(0.02, 0.011, 0.004, 2))
    top = float(path[:, 2].max())
    return shape(
        [(body, skin), (lid, skin), (knob, dark), (spout, skin), (bow, dark)],
        [hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.9 * r, 0.02, 0.013, (0, 0, top - 0.013)),
         *[box_part(0.012, 0.018, 0.5 * h, (s * 0.73 * r, 0, 0.7 * h)) for s in (-1, 1)]],
    )  # fmt: skip


def french_press(look: Look) -> Shape:
    """A coffee press: glass beaker with coffee, metal frame, plunger, handle to the right."""
    r, h = look.between(0.045, 0.052), look.between(0.15, 0.175)
    level = look.between(0.45, 0.75)
    coffee, clear = textures.plain((62, 38, 26)), textures.plain((206, 218, 220))
    metal = textures.brushed_metal(
        look.rng, look.color("silver", "black", "copper", "gold", "white", "red", "teal")
    )
    dark = textures.speckles(look.rng, (44, 44, 48), 3, 32)
    body = lathe([(0, 0.01), (r, 0.01), (r, h), (0, h)], v=[0, 0.01, 0.99, 1])
    tile = textures.stack((coffee, level), (clear, 1 - level), side=64)
    rings = [
        lathe([(0.98 * r, z), (1.03 * r, z), (1.03 * r, z + t), (0.98 * r, z + t)], loop=True)
        for z, t in ((0.004, 0.014), (0.5 * h, 0.006), (0.88 * h, 0.008))
    ]
    bars = [
        box(0.007, 0.003, 0.9 * h).move(y=-1.02 * r).turn(2, np.pi / 2 * k + np.pi / 4)
        for k in range(4)
    ]
    lid = lathe([(0, h), (1.05 * r, h), (1.02 * r, h + 0.01), (0.4 * r, h + 0.018), (0, h + 0.018)])
    rod = cylinder(0.0025, 0.03, 10).move(z=h + 0.014)
    knob = ellipsoid(0.018, 0.018, 0.018, 16, 10).move(z=h + 0.05)
    grip = tube(
        smooth([(1.0 * r, 0, 0.9 * h), (1.65 * r, 0, 0.88 * h), (1.8 * r, 0, 0.6 * h),
                (1.65 * r, 0, 0.2 * h), (1.0 * r, 0, 0.16 * h)], 4), 0.0075, 8,
    )  # fmt: skip
    foot = cylinder(1.03 * r, 0.01, 32, bevel=0.001)
    return shape(
        [(body, tile), (foot, metal), *((s, metal) for s in (*rings, *bars)), (lid, metal),
         (rod, metal), (knob, dark), (grip, dark)],
        [cylinder_part(1.03 * r, h), hull_of(lid), cylinder_part(0.007, 0.042, (0, 0, h + 0.016)),
         box_part(0.8 * r, 0.014, 0.75 * h, (1.42 * r, 0, 0.15 * h))],
    )  # fmt: skip


CATEGORIES = (
    Category(
        "teapot",
        teapot,
        (0.23, 0.14, 0.145),
        0.7,
        ("tea pot", "pot of tea"),
        ("coffee", "dining", "kitchen"),
        (),
        ("white", "teal", "cream"),
    ),
    Category(
        "kettle",
        kettle,
        (0.21, 0.146, 0.21),
        1.0,
        ("electric kettle", "tea kettle", "copper kettle"),
        ("kitchen",),
        ("tall",),
        ("silver", "black"),
    ),
    Category(
        "french_press",
        french_press,
        (0.14, 0.105, 0.225),
        0.6,
        ("coffee press", "cafetiere"),
        ("coffee", "kitchen"),
        ("tall",),
        ("silver", "black"),
    ),
)
