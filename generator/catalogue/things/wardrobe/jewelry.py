"""Jewellery, and the box it lies in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, frame_parts, hull_of, hull_part, ring_parts
from ...build.forms import facing
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    open_box,
    torus,
    tube,
)
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def jewelry_box(look: Look) -> Shape:
    """A jewellery box, its lid open with a mirror, a cushioned tray with pearls and rings."""
    x, y, h = look.between(0.16, 0.21), look.between(0.12, 0.15), look.between(0.06, 0.08)
    color = look.color("brown", "white", "pink", "maroon", "teal", "black", "wooden", "cream")
    skin = look.surface(color, look.pick(["wood", "leather"]))
    velvet = textures.speckles(
        look.rng, look.own_color("crimson", "navy", "cream", "purple", "pink"), 8
    )
    gold = textures.brushed_metal(look.rng, (212, 172, 82))
    case = join(open_box(x, y, h, 0.008, 0.008))
    bed = box(x - 0.016, y - 0.016, h - 0.022).move(z=0.008)
    lean = look.between(0.2, 0.4)
    lid = box(x, 0.014, 0.9 * y).turn(0, -lean).move(y=y / 2 + 0.004, z=h - 0.004)
    glass = box(0.84 * x, 0.001, 0.74 * y).turn(0, -lean)
    glass = glass.move(y=y / 2 + 0.004 - 0.0078 * np.cos(lean), z=h + 0.008)
    shine = textures.gradient((150, 172, 184), (226, 236, 240), look.rng, 3)
    top = h - 0.014
    t = np.linspace(0, 2 * np.pi, 22, endpoint=False)
    beads = [
        ellipsoid(0.0085, 0.0085, 0.0085, 8, 6).move(
            -0.2 * x + 0.03 * np.cos(a), 0.026 * np.sin(a), top + 0.004
        )
        for a in t
    ]
    rings = [torus(0.0085, 0.0015, 16, 6).turn(0, np.pi / 2 - 0.2).move((0.14 + 0.12 * n) * x,
                                                                          -0.18 * y, top + 0.006)
             for n in range(3)]  # fmt: skip
    gems = [
        ellipsoid(0.007, 0.006, 0.006, 8, 5).move((0.14 + 0.12 * n) * x, -0.18 * y, top + 0.016)
        for n in range(3)
    ]
    lock = facing(block(0.016, 0.02, 0.004, 0.004)).move(y=-y / 2, z=0.7 * h)
    pieces = [
        (join([case, lid]), skin),
        (bed, velvet),
        (glass, shine),
        (join(beads), textures.plain((246, 242, 234))),
        (join([*rings, lock]), gold),
        (join(gems), textures.plain(look.own_color("red", "cyan", "green", "violet"))),
    ]
    return shape(
        pieces,
        [
            *frame_parts(x, y, h, 0.008, 0.008),
            box_part(x - 0.016, y - 0.016, h - 0.014),
            hull_of(lid),
        ],
    )


def ring(look: Look) -> Shape:
    """A finger ring lying flat with a stone, or a plain band."""
    k = look.between(0.95, 1.15)
    color = look.color("gold", "silver", "gold", "copper", "silver")
    metal = look.surface(color, "metal")
    wide = look.between(0.002, 0.004)
    band = (
        lathe(
            [(0.0088, -wide), (0.0102, -wide), (0.0106, 0), (0.0102, wide), (0.0088, wide)],
            34,
            loop=True,
        )
        .scale(k, k, k)
        .move(z=wide * k)
    )
    angles = np.linspace(0, 2 * np.pi, 11)[:-1]
    parts = [
        box_part(
            0.0055 * k,
            0.0055 * k,
            2 * wide * k,
            (0.0075 * k * np.cos(a), 0.0075 * k * np.sin(a), 0),
        )
        for a in angles
    ]
    pieces = [(band, metal)]
    if look.chance(0.75):
        gem = lathe(
            [(0, -0.003), (0.0036, 0.0005), (0.0024, 0.0022), (0, 0.0022)], look.pick([8, 6])
        )
        gem = gem.scale(k, k, k).turn(0, np.pi / 2).move(y=-0.0128 * k, z=wide * k)
        claw = cylinder(0.003 * k, 0.004 * k, 10).turn(0, np.pi / 2).move(y=-0.0092 * k, z=wide * k)
        up = max(0.0, -float(min(gem.bounds[0, 2], claw.bounds[0, 2])))
        tone = look.own_color("sky", "red", "green", "violet", "white", "navy")
        pieces = [
            (band.move(z=up), metal),
            (claw.move(z=up), metal),
            (gem.move(z=up), textures.plain(tone)),
        ]
        parts = [type(p)(p.vertices + np.array([0, 0, up]), p.kind, p.axis) for p in parts]
        parts.append(hull_of(pieces[1][0], pieces[2][0]))
    return shape(pieces, parts)


def necklace(look: Look) -> Shape:
    """A necklace lying in a loop: pearls, beads, or a chain with a pendant; or a short bracelet."""
    color = look.color("white", "ivory", "gold", "silver", "red", "teal", "violet", "sky")
    r = look.between(0.05, 0.075)
    count = 44
    t = 2 * np.pi * np.arange(count) / count
    wobble = 1 + 0.08 * np.sin(2 * t + look.between(0, 6)) + 0.05 * np.sin(3 * t)
    path = np.column_stack([1.15 * r * wobble * np.cos(t), 0.9 * r * wobble * np.sin(t)])
    d = 2 * np.pi * r / count * 0.92
    kind = look.pick(["pearls", "chain", "beads"])
    pieces: list[tuple[Solid, textures.Tile]] = []
    if kind == "chain":
        d = 0.0035
        metal = look.own_color("gold", "silver", "copper")
        line = tube(np.column_stack([path, np.full(count, 0.5 * d)]), 0.5 * d, 6, loop=True)
        pieces.append((line, textures.stripes([metal, tint_color(metal, 0.55)], 60, side=240)))
    else:
        other = textures.plain(look.own_color("white", "gold", "navy", "coral", "mint"))
        main = textures.plain(color)
        one = ellipsoid(d, d, d, 8, 5)
        odd = [one.move(x, y, 0.5 * d) for x, y in path[1::2]]
        even = [one.move(x, y, 0.5 * d) for x, y in path[::2]]
        pieces += [(join(even), main), (join(odd), main if kind == "pearls" else other)]
    low = path[int(np.argmin(path[:, 1]))]
    if kind != "pearls":
        drop = _heart(0.016).move(low[0], low[1] - 0.014)
        pieces.append((drop, look.surface(color, "metal")))
    parts = []
    for k in range(0, count, 2):
        near = path[[k, (k + 1) % count, (k + 2) % count]]
        points = np.concatenate(
            [
                np.column_stack([near + np.array([dx, dy]), np.full(3, z)])
                for dx in (-0.3 * d, 0.3 * d)
                for dy in (-0.3 * d, 0.3 * d)
                for z in (0, d)
            ]
        )
        parts.append(hull_part(points))
    return shape(pieces, parts)


def _heart(size: float) -> Solid:
    """Return a flat heart pointing to -y, ``size`` wide, on z = 0."""
    t = np.linspace(0, 2 * np.pi, 26)[:-1]
    x = 16 * np.sin(t) ** 3
    y = 13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)
    outline = np.column_stack([x, y])[::-1] * size / 34
    return loft(
        np.stack([np.column_stack([outline, np.full(len(outline), z)]) for z in (0, 0.004)]),
        outline,
    )


def bracelet(look: Look) -> Shape:
    """A bangle, a bracelet of beads, or an open cuff lying flat."""
    r = look.between(0.029, 0.035)
    color = look.color(
        "gold", "silver", "copper", "teal", "red", "wooden", "black", "violet", "sky"
    )
    metal = look.surface(color, "metal")
    angles = np.linspace(0, 2 * np.pi, 15)[:-1]
    if look.chance(0.5):
        wide = look.between(0.004, 0.011)
        band = lathe([(r - 0.0025, 0), (r, 0.0006), (r + 0.0006, wide), (r, 2 * wide - 0.0006),
                      (r - 0.0025, 2 * wide)], 40, loop=True)  # fmt: skip
        tile = metal if look.chance(0.5) else glaze_tile(look, color)
        return shape(
            [(band, tile)],
            [*ring_parts([(r, 0), (r, 2 * wide)], [(r - 0.0025, 2 * wide), (r - 0.0025, 0)])],
        )
    count = 20
    d = 2 * np.pi * r / count * 0.95
    other = textures.plain(look.own_color("white", "gold", "navy", "coral", "mint", "black"))
    bead = ellipsoid(d, d, d, 12, 8)
    at = [
        (r * np.cos(2 * np.pi * n / count), r * np.sin(2 * np.pi * n / count), 0.5 * d)
        for n in range(count)
    ]
    step = look.pick([2, 4, 5])
    one = [bead.move(*p) for n, p in enumerate(at) if n % step]
    two = [bead.move(*p) for n, p in enumerate(at) if n % step == 0]
    parts = [box_part(0.9 * d, 0.9 * d, d, (r * np.cos(a), r * np.sin(a), 0)) for a in angles]
    return shape([(join(one), metal), (join(two), other)], parts)


CATEGORIES = (
    Category("jewelry_box", jewelry_box, (0.185, 0.18, 0.19), 0.7, ("jewellery box", "jewel box",
             "jewelry case", "trinket box", "jewellery case"), ("vanity",), ("big",),
             ("brown", "pink"), state="standing open"),
    Category("ring", ring, (0.0226, 0.0263, 0.0072), 0.006, ("finger ring", "wedding ring",
             "engagement ring", "gold ring", "diamond ring", "wedding band", "posy ring",
             "jump ring", "curtain ring", "shower curtain ring", "split ring", "towel ring",
             "teething ring", "toe ring", "signet ring", "bishop ring", "nose ring",
             "friendship ring", "eternity ring", "signet seal ring", "engagement band"), ("vanity",
             ),
             ("flat",), ("gold", "silver"), state="lying flat"),
    Category("necklace", necklace, (0.155, 0.126, 0.00812), 0.04, ("pearl necklace", "jewelry",
             "jewellery", "string of pearls", "pearls", "gold necklace",
             "bead necklace", "gold chain",
             "rosary chain", "lariat", "sautoir", "choker"), ("vanity",), ("flat",), ("white",
             "gold"),
             state="lying flat"),
    Category("bracelet", bracelet, (0.0676, 0.0676, 0.014), 0.025, ("bangle", "wristband",
             "beaded bracelet", "worry beads", "gold torc", "torc", "sweatband", "wrist band",
             "captain's armband", "loom band", "anklet", "ankle bracelet", "friendship bracelet",
             "charm bracelet"), ("vanity",), ("flat", "round"),
             ("gold", "silver"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
