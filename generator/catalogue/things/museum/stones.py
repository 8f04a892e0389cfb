"""Worked stone: slabs and plinths, tablets, flints, small monuments."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import at_box, drum, plate, standing
from ...build.outlines import ellipse, rectangle
from ...build.recipes import ball, pad, put_down, rod
from ...build.shape import Shape
from ...build.solids import Solid, block, box, join, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile, plain


def _stone(look: Look, *colors: str) -> Tile:
    """Return stone in a colour asked for or of ``colors``, plain or veined."""
    color = look.color(*colors)
    if look.material:
        return look.surface(color, "stone")
    if look.chance(0.5):
        return textures.marble(look.rng, color, tint_color(color, 0.7))
    return textures.spots(look.rng, color, tint_color(color, 0.65), 0.2)


def slab(look: Look) -> Shape:
    """A rectangular slab of stone."""
    x, y = look.between(0.18, 0.26), look.between(0.13, 0.19)
    made = block(x, y, look.between(0.016, 0.026), 0.004, 0.0015)
    return put_down([(made, _stone(look, "gray", "charcoal", "white", "tan", "sage"))], made)


def plinth(look: Look) -> Shape:
    """A low square plinth: a foot, a shaft and a top plate."""
    s, h = look.between(0.1, 0.14), look.between(0.045, 0.075)
    parts = [at_box(s, s, 0.2 * h), at_box(0.86 * s, 0.86 * s, 0.66 * h, (0, 0, 0.17 * h)),
             at_box(s, s, 0.2 * h, (0, 0, 0.8 * h))]  # fmt: skip
    return put_down([(join(parts), _stone(look, "white", "cream", "gray", "beige"))], *parts)


def mirror_tile(look: Look) -> Shape:
    """A square mirror lying, its edge ground."""
    s = look.between(0.13, 0.19)
    glass = block(s, s, 0.005, 0.003, 0.001)
    face = at_box(0.94 * s, 0.94 * s, 0.0006, (0, 0, 0.0047))
    y, x = np.mgrid[0:96, 0:96] / 96
    gleam = np.clip(1 - np.abs((x - y + look.between(-0.3, 0.3)) * 5), 0, 1)[..., None] * 60
    sheen = np.clip(np.array([168, 190, 200]) + 26 * (y[..., None] - 0.5) + gleam, 0, 250)
    edge = look.color("silver", "gray", "sky")
    return put_down([(glass, plain(edge)), (face, sheen.astype(np.uint8))], glass)


def clay_tablet(look: Look) -> Shape:
    """A tablet covered with rows of wedge-shaped signs."""
    color = look.color("tan", "terracotta", "brown", "gray", "charcoal", spread=14)
    x, y = look.between(0.08, 0.11), look.between(0.11, 0.14)
    made = pad(x, y, 0.02, 0.012, soft=0.6)
    image = textures.speckles(look.rng, color, 8, 128).copy()
    ink = tint_color(color, 0.5)
    for row in range(9):
        for n in range(9):
            a, b = 0.1 + 0.09 * n + look.between(-0.02, 0.02), 0.12 + 0.09 * row
            tip = (a + look.between(0.0, 0.05), b + look.between(0.02, 0.06))
            prints.polygon(image, [(a, b), (a + 0.03, b + 0.01), tip], ink)
    sheet = at_box(0.82 * x, 0.82 * y, 0.0008, (0, 0, 0.0196))
    return put_down([(made, textures.speckles(look.rng, color, 8)), (sheet, image)], made)


def arrowhead(look: Look) -> Shape:
    """A knapped point of flint, barbed, lying."""
    color = look.color("charcoal", "gray", "brown", "tan", "cream")
    k, w = look.between(0.8, 1.4), look.between(0.8, 1.2)
    half = [(0.032, 0), (0.012, 0.008), (-0.006, 0.0135), (-0.02, 0.016), (-0.015, 0.008),
            (-0.025, 0.006)]  # fmt: skip
    rim = np.array([*half, *[(x, -y) for x, y in half[:0:-1]]]) * [1, w]
    jag = 1 + 0.05 * np.array([look.between(-1, 1) for _ in rim])[:, None]
    base = plate(rim * jag, 0.0035)
    ridge = plate(0.62 * rim * jag, 0.0035, at=(0.001, 0, 0.0024))
    top = plate(0.24 * rim, 0.002, at=(0.001, 0, 0.0055))
    flint = textures.scratches(look.rng, color, tint_color(color, 1.3), 70)
    return put_down(
        [
            (base, flint),
            (
                join([ridge, top]),
                textures.scratches(look.rng, tint_color(color, 1.12), tint_color(color, 0.8), 70),
            ),
        ],
        base,
        ridge,
        factor=k,
    )


def pottery_shard(look: Look) -> Shape:
    """A broken piece of a painted pot, slightly curved, lying."""
    color = look.color("terracotta", "tan", "cream", "brown", "white")
    n, k = 9, look.between(0.75, 1.3)
    a = 2 * np.pi * (np.arange(n) + 0.35 * look.rng.uniform(-1, 1, n)) / n
    r = 0.034 * look.rng.uniform(0.72, 1.2, n)
    rim = np.column_stack([1.25 * r * np.cos(a), r * np.sin(a)])
    body = plate(rim, 0.0065)
    image = textures.speckles(look.rng, color, 8, 96).copy()
    ink = look.own_color("black", "brown", "navy", "crimson")
    for row in (0.2, 0.62):
        prints.fill(image, 0, row, 1, 0.06, ink)
    prints.stroke(image, [(0.1 * i, 0.36 + 0.12 * (i % 2)) for i in range(11)], 0.05, ink)
    skin = plate(0.97 * rim, 0.0008, at=(0, 0, 0.0062))
    return put_down([(body, plain(tint_color(color, 0.75))), (skin, image)], body, factor=k)


def scarab(look: Look) -> Shape:
    """A scarab carved of stone: wing cases, head and legs on a flat oval."""
    color = look.color("turquoise", "teal", "green", "navy", "gold", "charcoal")
    k = look.between(0.85, 1.2)
    base = plate(ellipse(0.066, 0.046, 28), 0.006)
    back = ball(0.05, 0.041, 0.034, (-0.006, 0, 0.007), 20)
    collar = ball(0.02, 0.036, 0.024, (0.018, 0, 0.007), 16)
    head = ball(0.016, 0.022, 0.014, (0.028, 0, 0.006), 12)
    seam = [
        rod([(0.01, 0.0, 0.021), (-0.006, 0, 0.0243), (-0.03, 0, 0.01)], 0.0009, 6),
        rod([(0.01, 0.017, 0.011), (0.0105, 0, 0.021), (0.01, -0.017, 0.011)], 0.0009, 6),
    ]
    legs = [
        rod([(x, s * 0.016, 0.008), (x + d, s * 0.023, 0.008)], 0.002, 6)
        for x, d in ((0.016, 0.008), (0.0, 0.003), (-0.018, -0.006))
        for s in (-1, 1)
    ]
    dark = plain(tint_color(color, 0.45))
    return put_down(
        [(join([base, back, collar, head]), look.surface(color, "stone")),
         (join([*seam, *legs]), dark)],
        base, back, collar, head, factor=k,
    )  # fmt: skip


def obelisk(look: Look) -> Shape:
    """An obelisk on a stepped base."""
    k = look.between(0.85, 1.2)
    steps = [at_box(0.06, 0.06, 0.01), at_box(0.046, 0.046, 0.012, (0, 0, 0.01))]
    shaft = drum(0.021, 0.13, (0, 0, 0.022), top=0.013, sides=4).turn(2, np.pi / 4)
    tip = drum(0.013, 0.02, (0, 0, 0.152), top=0.0005, sides=4).turn(2, np.pi / 4)
    stone = _stone(look, "gray", "beige", "charcoal", "tan", "terracotta")
    return put_down([(join([*steps, shaft, tip]), stone)], *steps, shaft, tip, factor=k)


def moai(look: Look) -> Shape:
    """A head of the Easter Island kind: long nose, heavy brow, flat top."""
    k = look.between(0.85, 1.2)
    neck = block(0.052, 0.05, 0.03, 0.012)
    face = block(0.056, 0.056, 0.08, 0.014, 0.006).move(z=0.028)
    brow = at_box(0.054, 0.016, 0.012, (0, -0.026, 0.082))
    nose = at_box(0.015, 0.018, 0.042, (0, -0.028, 0.046))
    chin = block(0.034, 0.02, 0.014, 0.005).move(0, -0.024, 0.029)
    lips = at_box(0.026, 0.01, 0.006, (0, -0.028, 0.043))
    ears = [at_box(0.008, 0.016, 0.045, (s * 0.03, 0, 0.045)) for s in (-1, 1)]
    eyes = [at_box(0.014, 0.004, 0.008, (s * 0.016, -0.0275, 0.073)) for s in (-1, 1)]
    color = look.color("gray", "charcoal", "tan", "sage", spread=14)
    rock = textures.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    body = [neck, face, brow, nose, chin, *ears]
    return put_down([(join([*body, lips]), rock), (join(eyes), plain(tint_color(color, 0.4)))],
                    *body, factor=k)  # fmt: skip


def totem_pole(look: Look) -> Shape:
    """A carved pole of three painted faces under a pair of wings."""
    k = look.between(0.85, 1.2)
    color = look.color("wooden", "brown", "tan")
    base = drum(0.03, 0.008)
    trunk = drum(0.021, 0.165, (0, 0, 0.007))
    paint: dict[str, list[Solid]] = {"red": [], "white": [], "black": [], "teal": []}
    for n in range(3):
        z = 0.018 + 0.05 * n
        paint[("red", "teal", "red")[n]] += [at_box(0.036, 0.01, 0.007, (0, -0.018, z + 0.035))]
        paint["white"] += [
            ball(0.015, 0.008, 0.013, (s * 0.01, -0.019, z + 0.027)) for s in (-1, 1)
        ]
        paint["black"] += [
            ball(0.007, 0.008, 0.008, (s * 0.01, -0.021, z + 0.027)) for s in (-1, 1)
        ]
        if n == 2:
            paint["teal"].append(drum(0.006, 0.03, (0, -0.017, z + 0.018), top=0.001, sides=8)
                                 .move(0, 0.017, -z - 0.018).turn(0, np.pi / 2)
                                 .move(0, -0.017, z + 0.018))  # fmt: skip
        else:
            paint["red"].append(at_box(0.026, 0.01, 0.009, (0, -0.018, z + 0.005)))
            paint["white"].append(at_box(0.022, 0.011, 0.003, (0, -0.018, z + 0.008)))
    rim = np.array(
        [(-0.06, 0.02), (0, 0.002), (0.06, 0.02), (0.054, 0.04), (0, 0.026), (-0.054, 0.04)]
    )
    wing = plate(rim, 0.008).turn(0, np.pi / 2).move(0, 0.012, 0.12)
    paint["teal"].append(wing)
    tones = {name: look.own_color(name) for name in paint}
    pieces = [(join([base, trunk]), textures.wood(look.rng, color))]
    pieces += [(join(solids), plain(tones[name])) for name, solids in paint.items()]
    return put_down(pieces, base, trunk, wing, factor=k)


def house_brick(look: Look) -> Shape:
    """A fired brick with a hollow frog on top."""
    color = look.color("terracotta", "brown", "red", "cream", spread=14)
    k = look.between(0.92, 1.06)
    body = block(0.215, 0.1025, 0.06, 0.002)
    frame = [at_box(0.215, 0.02, 0.006, (0, s * 0.041, 0.059)) for s in (-1, 1)]
    frame += [at_box(0.035, 0.1025, 0.006, (s * 0.09, 0, 0.059)) for s in (-1, 1)]
    tile = textures.spots(look.rng, color, tint_color(color, 0.6), 0.12)
    whole = box(0.215, 0.1025, 0.065)
    return put_down(
        [
            (body, textures.spots(look.rng, tint_color(color, 0.9), tint_color(color, 0.5), 0.2)),
            (join(frame), tile),
        ],
        whole,
        factor=k,
    )


def paperweight(look: Look) -> Shape:
    """A glass dome with coloured swirls and flowers in it."""
    color = look.color("blue", "purple", "green", "red", "amber", "teal", "pink")
    k = look.between(0.85, 1.15)
    dome = standing((0.03, 0), (0.036, 0.008), (0.037, 0.02), (0.032, 0.034), (0.02, 0.044),
                   (0.008, 0.0478), sides=28)  # fmt: skip
    image = prints.canvas(160, 96, tint_color(color, 1.3))
    for n in range(16):
        tone = look.own_color("white", "yellow", "pink", "navy", "mint", "coral")
        x, y = (n % 8 + 0.5 * (n // 8)) / 8, 0.3 + 0.3 * (n // 8)
        prints.disc(image, x, y, 0.13, color)
        prints.disc(image, x, y, 0.09, tone)
        prints.disc(image, x, y, 0.035, (250, 230, 120))
    prints.fill(image, 0, 0.86, 1, 0.14, tint_color(color, 0.6))
    gleam = ball(0.02, 0.008, 0.004, (-0.008, -0.012, 0.0425), 10)
    return put_down([(dome, image), (gleam, plain((250, 252, 252)))], dome, factor=k)


def fossil(look: Look) -> Shape:
    """An ammonite: a ribbed spiral on a slice of rock."""
    color = look.color("tan", "gray", "brown", "charcoal", "cream")
    k = look.between(0.75, 1.25)
    t = np.linspace(0, 5 * np.pi, 110)
    r = 0.003 + 0.029 * (t / t[-1]) ** 1.3
    path = np.column_stack([r * np.cos(t), r * np.sin(t), 0.013 + 0 * t])
    shell = tube(path, (0.0012 + 0.0056 * r / 0.032) * (1 + 0.16 * np.cos(14 * t)), 7)
    base = plate(rectangle(0.085, 0.075, 0.03, 3) * 1.0, 0.012, bevel=0.003)
    stone = textures.spots(look.rng, tint_color(color, 0.6), tint_color(color, 0.4), 0.2)
    return put_down([(base, stone), (shell, textures.speckles(look.rng, color, 10))],
                    base, shell, factor=k)  # fmt: skip


CATEGORIES = (
    Category("slab", slab, (0.214, 0.163, 0.0196), 1.6,
             ("stone slab", "marble slab", "slate slab", "granite slab", "slab of stone",
              "slab of marble", "slab of slate"), ("living",), ("support", "flat", "big"),
             ("gray",)),
    Category("plinth", plinth, (0.116, 0.116, 0.0615), 1.4,
             ("pedestal", "stone plinth", "display plinth", "marble plinth", "low plinth",
              "stone pedestal", "statue base", "museum plinth"),
             ("living",), ("support", "big"), ("white", "gray")),
    Category("mirror_tile", mirror_tile, (0.152, 0.152, 0.0053), 0.3,
             ("mirrored tile", "square mirror", "mirror plate", "flat mirror"),
             ("living",), ("support", "flat"), ("silver",)),
    Category("clay_tablet", clay_tablet, (0.0936, 0.129, 0.0204), 0.35,
             ("cuneiform tablet", "stone tablet", "inscribed tablet", "rosetta stone",
              "rosetta stone replica", "rune stone", "inscribed stone"),
             ("living",), ("flat",), ("tan",)),
    Category("arrowhead", arrowhead, (0.0595, 0.0323, 0.00781), 0.015,
             ("flint arrowhead", "stone arrowhead", "spearhead", "flint spearhead", "arrow head",
              "spear head", "bronze spearhead"), ("living",), ("flat",), ("gray",)),
    Category("pottery_shard", pottery_shard, (0.0902, 0.0689, 0.00771), 0.03,
             ("potsherd", "pot sherd", "sherd", "shard", "pot shard", "ceramic shard",
              "shard of pottery", "broken pottery"), ("living",), ("flat",), ("terracotta",)),
    Category("scarab", scarab, (0.0707, 0.0502, 0.0261), 0.09,
             ("scarab beetle", "egyptian scarab", "scarab amulet"), ("living",), (), ("teal",)),
    Category("obelisk", obelisk, (0.0586, 0.0586, 0.168), 0.4,
             ("obelisk model", "stone obelisk", "egyptian obelisk"),
             ("living",), ("tall",), ("gray",)),
    Category("moai", moai, (0.0715, 0.0684, 0.114), 0.4,
             ("moai figure", "moai statue", "moai head", "easter island head",
              "easter island statue"), ("living",), (), ("gray",)),
    Category("totem_pole", totem_pole, (0.122, 0.0783, 0.175), 0.15,
             ("totem pole model", "carved totem"), ("living",), ("tall",), ("wooden",)),
    Category("house_brick", house_brick, (0.212, 0.101, 0.064), 2.6,
             ("house brick", "clay brick", "fired brick", "brick of clay", "masonry brick"),
             ("workbench",), ("support",), ("terracotta",)),
    Category("paperweight", paperweight, (0.0759, 0.0759, 0.0491), 0.25,
             ("glass paperweight", "paper weight", "dome paperweight"),
             ("office", "living"), (), ("blue", "purple")),
    Category("fossil", fossil, (0.0823, 0.0726, 0.0174), 0.15,
             ("ammonite fossil", "fossil shell"),
             ("living",), (), ("tan", "gray")),
)  # fmt: skip
"""The module's categories."""
