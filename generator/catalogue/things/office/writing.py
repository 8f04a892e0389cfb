"""Pens, pencils and what they stand in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, lathe, loft
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def _lying(profile: list[tuple[float, float]], sides: int) -> Solid:
    """Return a rod of revolution lying along x on z = 0, its widest facet down."""
    rod = lathe(profile, sides).turn(1, np.pi / 2)
    low, high = rod.bounds
    return rod.move(x=-(low[0] + high[0]) / 2, z=-low[2])


def pen(look: Look) -> Shape:
    """A ball pen lying flat, with tip, barrel, grip and clip."""
    r, length = look.between(0.0048, 0.0056), look.between(0.138, 0.15)
    color = look.color(
        "blue", "black", "red", "green", "silver", "white", "teal", "pink", "gold", "purple"
    )
    metal = look.pick([(188, 190, 196), (188, 190, 196), (200, 164, 84), (50, 50, 54)])
    barrel = _lying(
        [
            (0, 0),
            (0.0012, 0),
            (r, 0.026),
            (r, length - 0.008),
            (0.6 * r, length - 0.007),
            (0.6 * r, length),
            (0, length),
        ],
        12,
    )
    tile = textures.stripes(
        [
            metal,
            look.pick([tint_color(color, 0.6), (44, 44, 48)]),
            color,
            color,
            look.pick([color, tint_color(color, 1.5)]),
            color,
            color,
            metal,
        ],
        side=64,
    )
    clip = box(0.045, 0.0028, 0.0016).move(x=length / 2 - 0.034, z=2 * r + 0.0006)
    knob = box(0.006, 0.0028, 0.0022).move(x=length / 2 - 0.014, z=2 * r - 0.001)
    return shape(
        [(barrel, tile), (clip, textures.plain(metal)), (knob, textures.plain(metal))],
        [
            box_part(length - 0.03, 1.7 * r, 2 * r, (0.014, 0, 0)),
            hull_part(barrel.vertices[barrel.vertices[:, 0] < -length / 2 + 0.03]),
        ],
    )


def pencil(look: Look) -> Shape:
    """A six-sided pencil lying on a facet: lead, wood, paint, ferrule, rubber."""
    r, length = 0.0039, look.between(0.16, 0.185)
    color = look.color(
        *("yellow", "yellow", "red", "blue", "green", "black", "orange", "wooden", "pink", "white")
    )
    rod = _lying(
        [
            (0, 0),
            (0.0009, 0.004),
            (r, 0.022),
            (r, length - 0.016),
            (r, length - 0.002),
            (0.9 * r, length),
            (0, length),
        ],
        6,
    )
    tile = textures.stripes(
        [
            (50, 50, 54),
            (222, 186, 132),
            (222, 186, 132),
            *[color] * 24,
            (190, 170, 90),
            (190, 170, 90),
            (226, 140, 146),
            (226, 140, 146),
            (226, 140, 146),
        ],
    )
    return shape([(rod, tile)], [hull_of(rod)])


def marker(look: Look) -> Shape:
    """A thick felt pen lying flat with its cap on."""
    r, length = look.between(0.0085, 0.0095), look.between(0.12, 0.135)
    color = look.color(
        "red", "blue", "green", "black", "purple", "orange", "pink", "yellow", "teal"
    )
    barrel = look.pick([(240, 240, 236), (240, 240, 236), (44, 44, 48), color])
    body = _lying([(0, 0), (r * 0.92, 0), (r * 0.92, length * 0.66), (0, length * 0.66)], 16)
    cap = _lying(
        [(0, 0), (r, 0), (r, 0.32 * length), (0.72 * r, 0.38 * length), (0, 0.38 * length)], 16
    )
    shell = textures.stripes([color, barrel, barrel, color, barrel, color], side=48)
    return shape(
        [
            (body.move(x=-0.17 * length, z=0.08 * r), shell),
            (cap.move(x=0.31 * length), textures.plain(color)),
        ],
        [
            box_part(0.66 * length, 1.5 * r, 1.84 * r, (-0.17 * length, 0, 0.08 * r)),
            box_part(0.36 * length, 1.5 * r, 2 * r, (0.31 * length, 0, 0)),
        ],
    )


def pencil_holder(look: Look) -> Shape:
    """A cup with pens and pencils standing in it."""
    r, h = look.between(0.038, 0.043), look.between(0.09, 0.105)
    color = look.color("black", "white", "teal", "wooden", "coral", "silver", "navy", "mustard")
    wall = look.surface(color, look.pick(["plastic", "wood", "metal"]))
    if look.chance(0.5):
        wall = glaze_tile(look, color)
    elif look.chance(0.4):
        wall = prints.mesh_holes(color, tint_color(color, 0.5), 10, 20)
    cup = lathe([(0, 0), (r, 0), (r, h), (r - 0.003, h), (r - 0.003, 0.005), (0, 0.005)], 28)
    pieces = [(cup, wall)]
    parts = [cylinder_part(r, h)]
    for k in range(int(look.rng.integers(4, 7))):
        angle, tall = 2.4 * k + look.between(0, 0.6), look.between(0.13, 0.17)
        way = np.array([np.cos(angle), np.sin(angle)])
        tint = textures.plain(look.own_color("yellow", "red", "blue", "green", "black", "orange"))
        stick = _leaning(way, 0.012, r - 0.007, h, tall)
        tip = _leaning(way, 0.012, r - 0.007, h, tall + 0.012, tall)
        wood = textures.plain((222, 186, 132))
        pieces += [(stick, tint), (tip, wood)]
        if k < 5:
            parts.append(hull_part(stick.vertices))
    return shape(pieces, parts)


def _leaning(
    way: np.ndarray, low: float, reach: float, rim: float, top: float, start: float = 0.006
) -> Solid:
    """Return a rod (or, from ``start`` on, its tip) leaning outwards against a rim."""
    hexagon = np.array([[np.cos(a), np.sin(a)] for a in np.pi / 3 * np.arange(6)])
    tip = start > 0.01
    rings = []
    for z, radius in [(start, 0.004), (top, 0.0012 if tip else 0.004)]:
        middle = way * (-low + (reach + low) * z / rim)
        rings.append(np.column_stack([hexagon * radius + middle, np.full(6, z)]))
    return loft(np.stack(rings), hexagon)


CATEGORIES = (
    Category(
        "pen",
        pen,
        (0.145, 0.0105, 0.0125),
        0.012,
        (
            "ballpoint pen",
            "fountain pen",
            "stylus",
            "tablet pen",
            "rollerball pen",
            "four colour pen",
            "four-colour pen",
            "red pen",
            "blue pen",
            "fineliner",
            "pen refill",
            "stylus pen",
            "black pen",
            "gel pen",
            "biro",
        ),
        ("office",),
        ("flat",),
        ("blue", "black", "red"),
        state="lying flat",
    ),
    Category(
        "pencil",
        pencil,
        (0.173, 0.0078, 0.0068),
        0.006,
        (
            "colored pencil",
            "carpenter pencil",
            "mechanical pencil",
            "pencil extender",
            "lead refill tube",
        ),
        ("office", "craft"),
        ("flat",),
        ("yellow", "red"),
        state="lying flat",
    ),
    Category(
        "marker",
        marker,
        (0.128, 0.018, 0.018),
        0.02,
        ("felt pen", "whiteboard marker", "felt-tip pen", "felt tip", "felt tip pen"),
        ("office", "craft"),
        ("flat",),
        ("red", "blue", "green"),
        state="lying flat",
    ),
    Category(
        "pencil_holder",
        pencil_holder,
        (0.1, 0.1, 0.165),
        0.25,
        ("pen holder", "pen cup", "pencil cup", "pencil pot"),
        ("office", "craft"),
        ("tall", "round"),
        ("black", "white"),
    ),
)
