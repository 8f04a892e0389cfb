"""Garden and balcony, candle holders and mirrors: what plants and rooms are dressed with."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, hull_part
from ...build.forms import blade
from ...build.outlines import ellipse, rectangle, smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, ellipsoid, join, lathe, loft, prism, sweep, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look
from .plants import Pieces, cactus_plant, planter


def watering_can(look: Look) -> Shape:
    """A watering can: its spout with a rose to the left, a handle to the right and above."""
    k = look.between(0.85, 1.1)
    color = look.color("green", "teal", "silver", "copper", "red", "yellow", "sky", "white", "pink")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    r, h = 0.058 * k, 0.125 * k
    body = lathe(
        [(0, 0), (r, 0), (0.94 * r, h), (0.9 * r, h), (0.9 * r, 0.8 * h), (0, 0.8 * h)], 30
    )
    around = np.linspace(-np.pi / 2, np.pi / 2, 13)
    half = 0.9 * r * np.column_stack([np.cos(around), np.sin(around)])
    top = prism(half, h - 0.002, h + 0.001)
    spout = tube([(-0.7 * r, 0, 0.16 * h), (-1.5 * r, 0, 0.7 * h), (-2.05 * r, 0, 1.12 * h)],
                 [0.017 * k, 0.011 * k, 0.009 * k], 12)  # fmt: skip
    way = np.arctan2(-0.55 * r, 0.42 * h)
    rose = lathe([(0, 0), (0.008, 0), (0.023, 0.02), (0.021, 0.024), (0, 0.026)], 20).scale(k, k, k)
    rose = rose.turn(1, way).move(-2.0 * r, 0, 1.09 * h)
    brace = tube([(-0.85 * r, 0, 0.9 * h), (-1.62 * r, 0, 0.82 * h)], 0.004 * k, 7)
    bail = sweep(
        smooth(
            [
                (-0.55 * r, 0, 0.97 * h),
                (-0.2 * r, 0, 1.36 * h),
                (0.7 * r, 0, 1.4 * h),
                (1.5 * r, 0, 0.95 * h),
                (1.42 * r, 0, 0.4 * h),
                (0.93 * r, 0, 0.22 * h),
            ],
            4,
        ),
        rectangle(0.013 * k, 0.008 * k, 0.003, 2),
    )
    rim = torus(0.94 * r, 0.003, 30, 6).move(z=h)
    dark = textures.plain(tint_color(color, 0.75))
    x = bail.vertices[:, 0]
    return shape(
        [(join([body, top, spout, brace]), skin), (join([rim, rose]), dark), (bail, skin)],
        [hull_of(body), hull_of(spout), hull_of(rose),
         hull_part(bail.vertices[(x < 0.75 * r)]), hull_part(bail.vertices[x > 0.6 * r])],
    )  # fmt: skip


def plant_pot(look: Look) -> Shape:
    """An empty flower pot of clay or glaze, maybe on a saucer."""
    r, h = look.between(0.055, 0.075), look.between(0.09, 0.125)
    color = look.color(
        "terracotta", "terracotta", "terracotta", "white", "gray", "teal", "black", "cream"
    )
    clay = glaze_tile(look, color) if look.chance(0.4) else look.surface(color, "stoneware")
    base = 0.006 if look.chance(0.5) else 0.0
    side = [(0.68 * r, 0), (0.92 * r, 0.76 * h), (r, 0.77 * h), (1.03 * r, h)]
    body, parts = open_vessel(side, 0.006, 0.008, 30)
    inside = textures.speckles(look.rng, tint_color(color, 0.7), 8, 32)
    pieces = [(body.move(z=base), textures.stack((clay, 50), (inside, 50), side=192))]
    if look.chance(0.5):
        soil = textures.speckles(look.rng, (74, 54, 40), 14)
        level = 0.62 * h
        wide = float(np.interp(level, [0, 0.76 * h], [0.68 * r, 0.92 * r])) - 0.005
        pieces.append(
            (lathe([(0, 0.009), (0.64 * r, 0.009), (wide, level), (0, level)]).move(z=base), soil)
        )
    raised = [ConvexPart(p.vertices + np.array([0, 0, base]), p.kind, p.axis) for p in parts]
    if base:
        dish = lathe([(0, 0), (0.86 * r, 0), (0.98 * r, 0.016), (0.93 * r, 0.016), (0.84 * r, base),
                      (0, base)], 30)  # fmt: skip
        pieces.append((dish, look.surface(tint_color(color, 0.92), "ceramic")))
        raised.append(cylinder_part(0.86 * r, base))
    return shape(pieces, raised)


def cactus(look: Look) -> Shape:
    """A cactus in a pot: a column with arms, a ball, or paddles, with spines and a bloom."""
    r, h = look.between(0.04, 0.055), look.between(0.055, 0.08)
    pieces = planter(look, r, h)
    green = look.color("green", "green", "olive", "sage", "teal", spread=16)
    plant, hulls = cactus_plant(look, green, h, r)
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), *hulls])


def succulent(look: Look) -> Shape:
    """A rosette of thick leaves in a small pot."""
    r, h = look.between(0.036, 0.05), look.between(0.045, 0.065)
    pieces: Pieces = planter(look, r, h)
    green = look.color("sage", "green", "mint", "teal", "olive", "lavender", "pink", spread=14)
    tip = look.pick([tint_color(green, 1.2), (206, 120, 130), tint_color(green, 0.7)])
    tile = textures.gradient(green, tip, look.rng, 4)
    leaves: list[Solid] = []
    count = 26
    for n in range(count):
        share = n / count
        long = 1.15 * r * (1.05 - 0.72 * share)
        lift = 0.25 + 1.15 * share
        leaf = ellipsoid(long, 0.5 * long, 0.2 * long, 10, 6).move(x=0.5 * long).turn(1, -lift)
        leaves.append(leaf.turn(2, 2.4 * n).move(z=0.92 * h + 0.014 * share))
    rosette = join(leaves)
    pieces.append((rosette, tile))
    return shape(pieces, [hull_of(pieces[0][0]), hull_of(rosette)])


def bouquet(look: Look) -> Shape:
    """A bunch of flowers lying in wrapping paper, tied with a ribbon, blooms to the left."""
    color = look.color("red", "pink", "yellow", "white", "violet", "orange", "coral")
    other = look.own_color("white", "yellow", "violet", "pink", "cream")
    paper = textures.speckles(
        look.rng, look.own_color("tan", "white", "pink", "sage", "sky"), 6, 32
    )
    k = look.between(0.9, 1.1)
    cone = loft(
        np.stack(
            [
                np.column_stack(
                    [
                        np.full(24, x),
                        ellipse(1, 1, 24)[:, 0] * w,
                        ellipse(1, 1, 24)[:, 1] * t + t / 2,
                    ]
                )
                for x, w, t in (
                    (0.16, 0.03, 0.024),
                    (0.1, 0.036, 0.026),
                    (0.0, 0.1, 0.05),
                    (-0.06, 0.15, 0.07),
                )
            ]
        )
        * k,
        ellipse(1, 1, 24),
    )
    ribbon = torus(0.017 * k, 0.004 * k, 20, 6).scale(1.05, 0.8, 2.2).turn(1, np.pi / 2)
    ribbon = ribbon.move(x=0.1 * k, z=0.0135 * k)
    stems = [tube([(0.14 * k, y * k, 0.012 * k), (0.22 * k, 1.7 * y * k, 0.009 * k)], 0.0028 * k, 6)
             for y in (-0.008, -0.003, 0.002, 0.007, 0.011)]  # fmt: skip
    blooms: dict[bool, list[Solid]] = {True: [], False: []}
    leaves = []
    for n in range(13):
        u, v = 2.4 * n, np.sqrt((n + 0.5) / 13)
        y, z = 0.066 * v * np.cos(u) * k, (0.036 + 0.028 * v * np.sin(u)) * k
        x = (-0.075 - 0.05 * (1 - v**2)) * k
        rose = join(
            [
                ellipsoid(0.044 * s * k, 0.044 * s * k, 0.022 * k, 8, 4).move(z=0.006 * m * k)
                for m, s in enumerate((1.0, 0.78, 0.5))
            ]
        )
        rose = rose.turn(1, -np.pi / 2 + 0.35).move(x, y, z + 0.012 * k)
        blooms[n % 3 != 0].append(rose)
        if n % 2:
            leaves.append(
                blade(
                    [
                        (x + 0.02, y, z),
                        (x - 0.005, 1.2 * y, z + 0.01),
                        (x - 0.03, 1.4 * y, z + 0.012),
                    ],
                    0.02 * k,
                )
            )
    every = join([*blooms[True], *blooms[False]])
    low = -float(every.bounds[0, 2])
    up = max(low, 0.0)
    green = textures.plain((76, 130, 62))
    return shape(
        [
            (cone, paper),
            (join([ribbon]), textures.plain(look.own_color("red", "white", "gold", "pink"))),
            (join(stems), green),
            (
                join(blooms[True]).move(z=up),
                textures.spots(look.rng, color, tint_color(color, 0.75), 0.25),
            ),
            (
                join(blooms[False]).move(z=up),
                textures.spots(look.rng, other, tint_color(other, 0.8), 0.25),
            ),
            (join(leaves).move(z=up), green),
        ],
        [flat_foot(cone.vertices, 0.12), hull_of(every.move(z=up)), hull_of(*stems)],
    )


def garden_trowel(look: Look) -> Shape:
    """A garden trowel lying, its hollow blade to the left."""
    k = look.between(0.9, 1.1)
    color = look.color("green", "red", "wooden", "black", "orange", "teal", "yellow")
    steel = textures.scratches(look.rng, (170, 174, 180), (196, 198, 202), 30)
    t = np.linspace(0, 1, 9)
    wide = 0.041 * k * np.array([0.06, 0.5, 0.78, 0.93, 1.0, 1.0, 0.96, 0.86, 0.6])
    rings = []
    for u, w in zip(t, wide, strict=True):
        x = (-0.15 + 0.145 * u) * k
        lane = np.linspace(-1, 1, 7)
        bow = 0.017 * k * lane**2 * min(w / (0.02 * k), 1) + 0.004 * k * u
        upper = np.column_stack([np.full(7, x), lane * w, bow + 0.0022])
        lower = np.column_stack([np.full(7, x), lane[::-1] * w, bow[::-1]])
        rings.append(np.concatenate([lower, upper]))
    flat = np.concatenate([np.column_stack([np.linspace(1, -1, 7), np.zeros(7)]),
                           np.column_stack([np.linspace(-1, 1, 7), np.full(7, 0.1)])])  # fmt: skip
    scoop = loft(np.stack(rings), flat[::-1])
    neck = tube(
        smooth([(-0.02 * k, 0, 0.007 * k), (0.02 * k, 0, 0.022 * k), (0.06 * k, 0, 0.016 * k)], 4),
        0.0055 * k,
        8,
    )
    grip = lathe(
        [
            (0, 0),
            (0.011, 0),
            (0.0145, 0.03),
            (0.012, 0.08),
            (0.0155, 0.118),
            (0.009, 0.13),
            (0, 0.13),
        ],
        18,
    ).scale(k, k, k)
    grip = grip.turn(1, np.pi / 2).move(x=0.05 * k, z=0.0155 * k)
    return shape([(scoop, steel), (neck, steel), (grip, look.surface(color, "wood"))],
                 [hull_of(scoop), hull_of(neck), hull_of(grip)])  # fmt: skip


def seed_packet(look: Look) -> Shape:
    """A paper packet of seeds lying flat, a flower or vegetable on its front."""
    x, y = look.between(0.078, 0.095), look.between(0.11, 0.135)
    color = look.color("green", "yellow", "red", "orange", "violet", "sky", "pink")
    image = prints.canvas(96, 144, (248, 244, 230))
    prints.fill(image, 0, 0, 1, 0.28, color)
    word = look.pick(["SEEDS", "TOMATO", "BASIL", "POPPY", "CARROT", "SUNFLOWER"])
    prints.write(image, word, 0.5, 0.2, 0.09, (250, 250, 246), bold=True)
    prints.stroke(image, [(0.5, 0.94), (0.5, 0.55)], 0.02, (80, 130, 60))
    prints.polygon(image, [(0.5, 0.82), (0.75, 0.7), (0.7, 0.84)], (96, 150, 70))
    prints.polygon(image, [(0.5, 0.76), (0.25, 0.64), (0.3, 0.78)], (96, 150, 70))
    for n in range(9):
        a = 2 * np.pi * n / 9
        prints.disc(image, 0.5 + 0.2 * np.cos(a), 0.52 + 0.133 * np.sin(a), 0.065, color)
    prints.disc(image, 0.5, 0.52, 0.09, (110, 70, 40) if look.chance(0.5) else (246, 206, 80))
    body = box(x, y, 0.0035)
    flap = box(x, 0.014, 0.0008).move(y=y / 2 - 0.008, z=0.0034)
    top = box(0.98 * x, 0.98 * y, 0.0004).move(z=0.0033)
    side = textures.speckles(look.rng, (244, 240, 226), 4, 32)
    return shape([(body, side), (top, image), (flap, textures.plain(tint_color(color, 0.85)))],
                 [box_part(x, y, 0.0037)])  # fmt: skip


CATEGORIES = (
    Category("watering_can", watering_can, (0.235, 0.115, 0.18), 0.4, ("garden can",
             "plant waterer", "small watering can"), ("living",), ("tall",), ("green", "silver")),
    Category("plant_pot", plant_pot, (0.13, 0.13, 0.11), 0.5, ("empty plant pot", "clay pot",
             "empty flower pot", "terracotta pot", "planter", "empty pot", "empty flowerpot",
             "flower planter"), ("living",), ("container", "round"), ("terracotta",)),
    Category("cactus", cactus, (0.0991, 0.0952, 0.159), 0.4, ("cacti", "potted cactus",
             "small cactus", "cactus plant", "cactus pot"), ("living", "office"), ("tall",),
             ("green",)),
    Category("succulent", succulent, (0.0949, 0.0914, 0.0843), 0.25, ("potted succulent",
             "succulent plant", "echeveria", "aloe", "aloe vera", "small succulent"), ("living",
             "office"), ("round",), ("sage", "green")),
    Category("bouquet", bouquet, (0.377, 0.153, 0.0912), 0.3, ("bouquet of flowers",
             "bunch of flowers", "flower bouquet", "bouquet of roses", "bunch of roses",
             "rose bouquet", "nosegay", "posy of flowers", "bunch of tulips",
             "bunch of daffodils", "bunch of lavender", "paper flower", "dead flower",
             "fabric flower", "silk flower", "dried flower bunch"), ("living", "dining"), ("big",),
             ("red",
             "pink"),
             state="lying flat"),
    Category("garden_trowel", garden_trowel, (0.33, 0.082, 0.032), 0.2, ("trowel", "hand trowel",
             "garden shovel", "small shovel", "hand shovel", "garden spade", "shovel",
             "trowel set"),
             ("living",), (), ("green", "wooden"), state="lying flat"),
    Category("seed_packet", seed_packet, (0.086, 0.122, 0.0042), 0.012, ("packet of seeds",
             "seeds", "pack of seeds", "flower seeds", "bag of seeds", "seed bag"), ("living",),
             ("flat",), ("green",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
