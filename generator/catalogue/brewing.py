"""What tea and coffee are made with."""

from __future__ import annotations

import numpy as np

from . import textures
from .category import Category
from .collision import box_part, cylinder_part, hull_of, hull_part
from .colors import tinted
from .look import Look
from .outlines import rectangle, smooth
from .shape import Shape, shape
from .solids import Solid, box, cylinder, ellipsoid, lathe, prism, sweep, tube


def _spout(start: tuple[float, float], end: tuple[float, float], low: float, top: float) -> Solid:
    """Return a curved spout in the x-z plane, ``low`` and ``top`` its radii, on the -x side."""
    (x0, z0), (x1, z1) = start, end
    path = smooth([(x0, 0, z0), (0.5 * (x0 + x1), 0, z0 + 0.25 * (z1 - z0)), (x1, 0, z1)], 4)
    return tube(path, np.linspace(low, top, len(path)), 10)


def teapot(look: Look) -> Shape:
    """A round teapot: spout to the left, handle to the right, a knob on its lid."""
    r, h = look.between(0.066, 0.076), look.between(0.105, 0.12)
    color = look.color("white", "teal", "cream", "navy", "terracotta", "black", "pink", "sage")
    glaze = look.surface(color, "ceramic")
    if look.chance(0.4) and not look.material:
        glaze = textures.spotted(look.rng, color, tinted(color, 1.5), 0.05)
    t = np.linspace(-1.0, 1.05, 12)
    wall = np.column_stack([r * np.cos(t), h * (0.5 + 0.5 * np.sin(t) / np.sin(1.05))])
    wall[:, 1] = np.maximum(wall[:, 1] - wall[0, 1], 0)
    top = float(wall[-1, 1])
    body = lathe([(0, 0), *wall, (0, top)])
    rim = 0.92 * float(wall[-1, 0])
    lid = lathe(
        [(0, top), (rim, top), (rim, top + 0.003), (0.6 * rim, top + 0.011), (0.007, top + 0.015),
         (0.006, top + 0.019), (0.011, top + 0.025), (0.008, top + 0.033), (0, top + 0.034)], 28,
    )  # fmt: skip
    spout = _spout((-0.82 * r, 0.3 * top), (-1.62 * r, 0.95 * top), 0.017, 0.0085)
    ear = tube(
        smooth([(0.82 * r, 0, 0.86 * top), (1.4 * r, 0, 0.92 * top), (1.62 * r, 0, 0.6 * top),
                (1.38 * r, 0, 0.25 * top), (0.9 * r, 0, 0.2 * top)], 4), 0.0065, 8,
    )  # fmt: skip
    ring = wall[:, 1]
    return shape(
        [(body, glaze), (lid, glaze), (spout, glaze), (ear, glaze)],
        [hull_part(body.vertices[body.vertices[:, 2] <= ring[5] + 1e-6]),
         hull_part(body.vertices[body.vertices[:, 2] >= ring[5] - 1e-6]),
         hull_of(lid), hull_of(spout),
         box_part(0.72 * r, 0.013, 0.7 * top, (1.26 * r, 0, 0.2 * top))],
    )  # fmt: skip


def kettle(look: Look) -> Shape:
    """An electric kettle on its base: spout to the left, handle to the right."""
    r, h = look.between(0.068, 0.076), look.between(0.185, 0.21)
    color = look.color("silver", "black", "red", "white", "cream", "sage")
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = textures.speckled(look.rng, (46, 46, 50), 3, 32)
    body = lathe(
        [(0, 0.02), (r, 0.02), (1.02 * r, 0.04), (0.74 * r, 0.92 * h), (0.6 * r, 0.96 * h),
         (0, 0.96 * h)],
    )  # fmt: skip
    base = cylinder(1.02 * r, 0.02, 32, bevel=0.003)
    lid = lathe([(0, 0.95 * h), (0.58 * r, 0.95 * h), (0.5 * r, 0.98 * h), (0, h)], 28)
    knob = cylinder(0.011, 0.014, 16, bevel=0.002).moved(z=0.99 * h)
    beak = np.array([(-1.18, 0.0), (-0.6, -0.42), (-0.6, 0.42)]) * r
    spout = prism(beak, 0.72 * h, 0.93 * h)
    grip = sweep(
        smooth([(0.68 * r, 0, 0.9 * h), (1.35 * r, 0, 0.93 * h), (1.62 * r, 0, 0.7 * h),
                (1.5 * r, 0, 0.34 * h), (1.25 * r, 0, 0.26 * h)], 4),
        rectangle(0.024, 0.014, 0.005, 2),
    )  # fmt: skip
    return shape(
        [(body, skin), (base, dark), (lid, dark), (knob, dark), (spout, skin), (grip, dark)],
        [cylinder_part(1.02 * r, 0.02), hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.024, 0.022, 0.5 * h, (1.5 * r, 0, 0.32 * h)),
         box_part(0.7 * r, 0.022, 0.016, (1.05 * r, 0, 0.87 * h))],
    )  # fmt: skip


def french_press(look: Look) -> Shape:
    """A coffee press: glass beaker with coffee, metal frame, plunger, handle to the right."""
    r, h = look.between(0.045, 0.052), look.between(0.15, 0.175)
    level = look.between(0.45, 0.75)
    coffee, clear = textures.plain((62, 38, 26)), textures.plain((206, 218, 220))
    metal = textures.brushed(look.rng, look.color("silver", "black", "copper", "gold"))
    dark = textures.speckled(look.rng, (44, 44, 48), 3, 32)
    body = lathe([(0, 0.01), (r, 0.01), (r, h), (0, h)], v=[0, 0.01, 0.99, 1])
    tile = textures.stacked((coffee, level), (clear, 1 - level), side=64)
    rings = [
        lathe([(0.98 * r, z), (1.03 * r, z), (1.03 * r, z + t), (0.98 * r, z + t)], loop=True)
        for z, t in ((0.004, 0.014), (0.5 * h, 0.006), (0.88 * h, 0.008))
    ]
    bars = [
        box(0.007, 0.003, 0.9 * h).moved(y=-1.02 * r).turned(2, np.pi / 2 * k + np.pi / 4)
        for k in range(4)
    ]
    lid = lathe([(0, h), (1.05 * r, h), (1.02 * r, h + 0.01), (0.4 * r, h + 0.018), (0, h + 0.018)])
    rod = cylinder(0.0025, 0.03, 10).moved(z=h + 0.014)
    knob = ellipsoid(0.018, 0.018, 0.018, 16, 10).moved(z=h + 0.05)
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
        ("electric kettle", "tea kettle"),
        ("kitchen",),
        ("tall",),
        ("silver", "black"),
    ),
    Category(
        "french_press",
        french_press,
        (0.14, 0.105, 0.225),
        0.6,
        ("coffee press", "coffee pot", "coffee maker", "cafetiere", "moka pot"),
        ("coffee", "kitchen"),
        ("tall",),
        ("silver", "black"),
    ),
)
