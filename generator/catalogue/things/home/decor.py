"""What stands on a table to look at, or to see by."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import bowl_parts, box_part, cylinder_part, hull_of
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, loft, torus, tube
from ...surfaces import textures
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def _stem(base: np.ndarray, tip: np.ndarray, thick: float = 0.0022) -> Solid:
    middle = (base + tip) / 2 + np.array([0, 0, 0.12]) * np.linalg.norm(tip[:2] - base[:2])
    return tube(smooth([base, middle, tip], 3), thick, 6)


def vase(look: Look) -> Shape:
    """A curved vase, open at the top; some hold flowers."""
    r, h = look.between(0.042, 0.064), look.between(0.16, 0.25)
    color = look.color(
        *("white", "white", "teal", "terracotta", "navy", "cream", "sage", "mustard", "black"),
        *("pink", "gray", "sky"),
    )
    style, phase = int(look.rng.integers(6)), look.between(0.4, 1.1)
    t = np.linspace(0, 1, 14)
    swell = [
        0.66 + 0.34 * np.sin(np.pi * (0.15 + 0.95 * t)),
        0.62 + 0.38 * np.sin(2 * np.pi * (t * 0.75 + 0.02)) * (1 - 0.35 * t),
        0.75 + 0.25 * np.cos(2 * np.pi * t * 0.8 + phase),
        0.86 + 0.14 * t,
        np.where(t < 0.55, np.sin(np.pi * (0.16 + 0.74 * t / 0.55)), 0.32 + 0.08 * t),
        0.55 + 0.45 * t**0.7,
    ][style]
    swell = np.maximum(swell / swell.max(), 0.3)
    outer = np.column_stack([r * swell, h * t])
    wall = 0.004
    inner = np.column_stack([outer[:, 0] - wall, outer[:, 1]])[:1:-1]
    body = lathe(
        [(0, 0), *outer, *inner, (0, inner[-1, 1])],
        v=[0, *np.linspace(0.01, 0.93, 14), *np.linspace(0.95, 0.99, len(inner)), 1],
    )
    glaze = textures.fit(glaze_tile(look, color), 128, 128)
    pieces = [(body, glaze)]
    within = np.column_stack([np.maximum(outer[:, 0] - wall, 0.006), np.maximum(outer[:, 1], wall)])
    parts = [*bowl_parts(outer, within, 13), cylinder_part(float(outer[0, 0]), 2 * wall)]
    if look.chance(0.45) and look.attributes.get("state") != "empty":
        pieces += _flowers(look, float(outer[-1, 0]), h)
    return shape(pieces, parts)


def _flowers(look: Look, mouth: float, h: float) -> list[tuple[Solid, textures.Tile]]:
    """Return stems with blossoms and leaves that come out of a mouth at height ``h``."""
    green = textures.plain((74, 122, 62))
    petal = textures.speckles(
        look.rng, look.own_color("red", "pink", "yellow", "violet", "white"), 8
    )
    heart = textures.plain((206, 150, 50))
    pieces = []
    for k in range(5):
        angle, out = 2 * np.pi * k / 5 + look.between(-0.3, 0.3), look.between(0.01, 0.05)
        way = np.array([np.cos(angle), np.sin(angle), 0.0])
        tip = way * (mouth + out) + [0, 0, h + look.between(0.07, 0.13)]
        pieces.append((_stem(way * 0.5 * mouth + [0, 0, h - 0.03], tip), green))
        petals = [
            ellipsoid(0.026, 0.016, 0.007, 6, 4).move(x=0.014, z=0.002).turn(2, np.pi / 3 * m)
            for m in range(6)
        ]
        pieces.append((join(petals).move(*tip), petal))
        pieces.append((ellipsoid(0.014, 0.014, 0.01, 8, 4).move(*tip).move(z=0.004), heart))
    return pieces


def sculpture(look: Look) -> Shape:
    """A small sculpture on a plinth: a bust, a twist, or balanced stones."""
    color = look.color("white", "bronze", "black", "gray", "gold", "terracotta", "teal", "pink")
    stone = look.surface(color, look.pick(["marble", "bronze", "stone"]))
    base = block(0.085, 0.085, 0.026, 0.004, 0.002)
    wood = textures.wood(look.rng, look.own_color("charcoal", "brown"), side=64)
    kind = look.pick(["bust", "bust", "twist", "stones", "figure", "ring"])
    if kind == "bust":
        chest = ellipsoid(0.11, 0.062, 0.085, 24, 12).move(z=0.05)
        neck = cylinder(0.018, 0.05, 20, top=0.016).move(z=0.078)
        head = ellipsoid(0.054, 0.066, 0.078, 24, 14).move(y=-0.004, z=0.155)
        nose = ellipsoid(0.012, 0.02, 0.024, 10, 8).move(y=-0.036, z=0.15)
        hair = ellipsoid(0.062, 0.066, 0.056, 20, 12).move(y=0.008, z=0.173)
        figure = [chest, neck, head, nose, hair]
    elif kind == "twist":
        square = rectangle(0.05, 0.05)
        rings = []
        for t in np.linspace(0, 1, 13):
            c, s = np.cos(2.4 * t), np.sin(2.4 * t)
            turned = square @ np.array([[c, s], [-s, c]]) * (1 - 0.45 * t)
            rings.append(np.column_stack([turned, np.full(4, 0.025 + 0.15 * t)]))
        figure = [loft(np.stack(rings), square, profile=np.array([(0.0, t) for t in range(13)]))]
    elif kind == "figure":  # slender, arms raised
        robe = cylinder(0.03, 0.075, 18, top=0.014, bevel=0.002).move(z=0.024)
        trunk = ellipsoid(0.04, 0.026, 0.07, 18, 10).move(z=0.118)
        head = ellipsoid(0.024, 0.026, 0.03, 16, 10).move(z=0.166)
        arms = [tube(smooth([(s * 0.012, 0, 0.138), (s * 0.036, 0, 0.15), (s * 0.03, 0, 0.188)], 4),
                     0.0055, 8) for s in (-1, 1)]  # fmt: skip
        figure = [robe, trunk, head, *arms]
    elif kind == "ring":
        turn = look.between(-0.4, 0.4)
        hoop = torus(0.05, 0.013, 28, 12).turn(0, np.pi / 2).turn(2, turn).move(z=0.085)
        figure = [hoop, ellipsoid(0.034, 0.034, 0.034, 18, 12).move(z=0.162)]
    else:
        sizes = [(0.08, 0.04), (0.064, 0.036), (0.05, 0.03), (0.034, 0.024)]
        figure, z = [], 0.024
        for wide, tall in sizes:
            figure.append(
                ellipsoid(wide, 0.85 * wide, tall, 20, 10)
                .turn(1, look.between(-0.12, 0.12))
                .move(look.between(-0.004, 0.004), 0, z + tall / 2)
            )
            z += tall * 0.9
    return shape(
        [(base, wood), *((solid, stone) for solid in figure)],
        [box_part(0.085, 0.085, 0.026), *[hull_of(solid) for solid in figure]],
    )


CATEGORIES = (
    Category(
        "vase",
        vase,
        (0.14, 0.13, 0.27),
        0.6,
        (
            "flower vase",
            "flowers",
            "flower",
            "vase of flowers",
            "flower arrangement",
            "floral arrangement",
            "centrepiece",
            "floral centrepiece",
            "centerpiece",
            "flower centrepiece",
            "table centrepiece",
            "krater",
            "bell krater",
            "burial urn",
            "funerary urn",
            "lekythos",
            "aryballos",
            "maya vase",
            "cameo glass vase",
            "jardiniere",
        ),
        ("living", "dining", "office"),
        ("container", "tall", "round"),
        ("white", "teal", "navy"),
    ),
    Category(
        "sculpture",
        sculpture,
        (0.09, 0.085, 0.18),
        0.9,
        (
            "statue",
            "bust",
            "statuette",
            "ornament",
            "marble bust",
            "venus de milo statuette",
            "nefertiti bust",
            "bronze statuette",
            "wood carving",
            "ivory carving",
            "jade carving",
            "scrimshaw",
            "plaster cast",
            "garden ornament",
        ),
        ("living", "office"),
        ("tall",),
        ("white", "bronze"),
    ),
)
