"""Things that stand about at home: banks, chests, boxes, albums, fans, crystals, clocks."""

from __future__ import annotations

import itertools

import numpy as np

from ...build.category import Category
from ...build.collision import frame_parts
from ...build.forms import spread
from ...build.recipes import ball, leather, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, open_box, prism, torus
from ...surfaces import prints, textures
from ...surfaces.artwork import landscape
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRASS = (206, 172, 96)


def piggy_bank(look: Look) -> Shape:
    """A pig of china with a slot in its back."""
    color = look.color("pink", "pink", "white", "sky", "gold", "red")
    skin = textures.speckles(look.rng, color, 4)
    body = ball(0.115, 0.092, 0.09, (0, 0, 0.056), 24)
    snout = cylinder(0.02, 0.022, 20, bevel=0.003).turn(1, -np.pi / 2).move(-0.046, 0, 0.055)
    holes = [ball(0.004, 0.008, 0.011, (-0.068, s * 0.008, 0.056), 8) for s in (-1, 1)]
    eyes = [ball(0.008, 0.008, 0.009, (-0.045, s * 0.024, 0.075), 10) for s in (-1, 1)]
    ears = [cylinder(0.015, 0.024, 4, top=0.001).scale(0.6, 1, 1).turn(0, -s * 0.5)
            .move(-0.03, s * 0.027, 0.086) for s in (-1, 1)]  # fmt: skip
    legs = [cylinder(0.0145, 0.035, 16, top=0.017).move(sx * 0.032, sy * 0.025)
            for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    tail = rod([(0.055, 0, 0.06), (0.066, 0.006, 0.068), (0.064, -0.004, 0.076), (0.07, 0.0, 0.08)],
               0.003, 7)  # fmt: skip
    slot = box(0.034, 0.005, 0.004).move(0.004, 0, 0.0982)
    dark = textures.plain((44, 34, 36))
    return put_down(
        [(join([body, snout, *ears, *legs, tail]), skin), (join([*holes, *eyes, slot]), dark)],
        body,
        join(legs),
        join([snout]),
        factor=look.between(0.85, 1.15),
    )


def treasure_chest(look: Look) -> Shape:
    """A wooden chest with a vaulted lid, metal bands and a lock."""
    color = look.color("brown", "wooden", "tan", "red", "black")
    k = look.between(0.85, 1.15)
    x, y, h = 0.16, 0.1, 0.06
    wood = textures.wood(look.rng, color, planks=5)
    chest = box(x, y, h)
    lid = cylinder(y / 2, x, 24).move(z=-x / 2).turn(1, np.pi / 2).scale(1, 1, 0.72)
    lid = lid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])).move(z=h)
    bands: list[Solid] = []
    for u in (-0.42 * x, 0.0, 0.42 * x):
        bands.append(box(0.014, y + 0.003, h + 0.001).move(u))
        hoop = (
            cylinder(y / 2 + 0.0015, 0.014, 24).move(z=-0.007).turn(1, np.pi / 2).scale(1, 1, 0.74)
        )
        bands.append(hoop.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))
                     .move(u, 0, h))  # fmt: skip
    rim = box(x + 0.002, y + 0.002, 0.008).move(z=h - 0.005)
    lock = box(0.022, 0.006, 0.026).move(0, -y / 2 - 0.002, h - 0.018)
    hole = box(0.004, 0.002, 0.009).move(0, -y / 2 - 0.0055, h - 0.012)
    metal = textures.brushed_metal(look.rng, look.pick([BRASS, (96, 98, 104)]))
    return put_down([(join([chest, lid]), wood), (join([*bands, rim, lock]), metal),
                    (hole, textures.plain((30, 28, 28)))], chest, lid, factor=k)  # fmt: skip


def wooden_box(look: Look) -> Shape:
    """An open wooden box, its lid off."""
    x, y, h = look.between(0.17, 0.22), look.between(0.12, 0.15), look.between(0.07, 0.095)
    color = look.color("wooden", "tan", "brown", "white", "teal")
    t = 0.007
    wood = look.surface(color, "wood")
    joints = [box(0.0075, 0.0075, 0.2 * h).move(sx * (x / 2 - 0.0036), sy * (y / 2 - 0.0036), z * h)
              for sx in (-1, 1) for sy in (-1, 1) for z in (0.2, 0.6)]  # fmt: skip
    return shape([(join(open_box(x, y, h, t, t)), wood), (join(joints), textures.wood(look.rng,
                  tint_color(color, 0.75)))], frame_parts(x, y, h, t, t))  # fmt: skip


def photo_album(look: Look) -> Shape:
    """A photo album lying: a cover with a framed picture, a ribbon at its spine."""
    x, y, h = look.between(0.22, 0.26), look.between(0.19, 0.23), look.between(0.028, 0.04)
    color = look.color("brown", "red", "navy", "black", "teal", "cream", "pink")
    pages = box(x - 0.014, y - 0.012, h - 0.006).move(0.004, 0, 0.003)
    covers = [block(x, y, 0.0035, 0.004).move(z=z) for z in (0, h - 0.0035)]
    spine = box(0.005, y, h).move(-x / 2 + 0.0025)
    frame = box(0.5 * x, 0.42 * y, 0.0012).move(0.01, 0.0, h - 0.0004)
    photo = box(0.45 * x, 0.36 * y, 0.0008).move(0.01, 0.0, h + 0.0003)
    band = box(0.012, y + 0.001, h + 0.0008).move(-0.36 * x)
    hide = leather(look.rng, color)
    return put_down(
        [
            (pages, prints.pages(look.rng)),
            (join([*covers, spine]), hide),
            (frame, textures.plain(BRASS)),
            (photo, textures.fit(landscape(look.rng, 96, 64), 64, 96)),
            (band, textures.plain(tint_color(color, 0.65) if sum(color) > 200 else BRASS)),
        ],
        join(covers),
    )


def folding_fan(look: Look) -> Shape:
    """An open folding fan lying, pleated, with sticks that meet at a rivet."""
    color = look.color("red", "black", "pink", "blue", "white", "green", "purple")
    n = 19
    k = look.between(0.85, 1.1)
    a = np.linspace(0.12, np.pi - 0.12, n)
    rows = []
    for r in (0.075, 0.13, 0.185):
        z = 0.004 + 0.004 * (np.arange(n) % 2)
        rows.append(np.column_stack([-r * np.cos(a), r * np.sin(a) - 0.09, z]))
    leaf = spread(np.stack(rows), 0.0012)
    sticks = [
        box(0.19 if i in (0, n - 1) else 0.09, 0.006, 0.0018)
        .move(0.095 if i in (0, n - 1) else 0.045)
        .turn(2, float(np.pi - a[i]))
        .move(0, -0.09, 0.0025 + 0.00009 * i)
        for i in range(0, n, 2)
    ]
    pin = cylinder(0.005, 0.006, 14).move(0, -0.09, 0.001)
    image = prints.canvas(160, 96, color)
    ink = tint_color(color, 1.7) if sum(color) < 560 else (200, 60, 70)
    for j in range(5):
        prints.disc(image, 0.15 + 0.175 * j, 0.5 + 0.16 * (-1) ** j, 0.1, ink)
        prints.disc(image, 0.15 + 0.175 * j, 0.5 + 0.16 * (-1) ** j, 0.04, color)
    return put_down(
        [
            (leaf, image),
            (join(sticks), textures.wood(look.rng, (110, 74, 48))),
            (pin, textures.plain(BRASS)),
        ],
        leaf,
        join([*sticks, pin]),
        factor=k,
    )


def music_box(look: Look) -> Shape:
    """A music box with a crank, its drum and comb seen on top."""
    color = look.color("wooden", "red", "brown", "teal", "navy", "pink")
    k = look.between(0.85, 1.2)
    base = block(0.09, 0.07, 0.045, 0.004, 0.002)
    plate = box(0.078, 0.058, 0.001).move(z=0.0445)
    drum = cylinder(0.0115, 0.05, 20).move(z=-0.025).turn(1, np.pi / 2).move(-0.002, 0.008, 0.052)
    dots = prints.mesh_holes(BRASS, (110, 86, 40), 10, 18)
    comb = join(
        [box(0.0024, 0.022, 0.0016).move(-0.024 + 0.004 * n, -0.012, 0.047) for n in range(12)]
    )
    crank = join([straight((0.044, 0.008, 0.03), (0.062, 0.008, 0.03), 0.0024, 8),
                  straight((0.062, 0.008, 0.03), (0.062, -0.012, 0.04), 0.0024, 8),
                  straight((0.061, -0.012, 0.04), (0.074, -0.012, 0.04), 0.0042, 10)])  # fmt: skip
    return put_down(
        [
            (base, look.surface(color, "wood")),
            (plate, textures.plain((60, 52, 46))),
            (drum, dots),
            (comb, textures.brushed_metal(look.rng, (200, 204, 210))),
            (crank, textures.brushed_metal(look.rng, BRASS)),
        ],
        base,
        drum,
        crank,
        factor=k,
    )


def crystal(look: Look) -> Shape:
    """A cluster of six-sided crystal points on a rough foot."""
    color = look.color("purple", "lavender", "pink", "white", "teal", "blue", "green")
    k = look.between(0.8, 1.2)
    points: list[Solid] = []
    for n in range(8):
        tall = look.between(0.04, 0.085) if n else 0.1
        r = 0.19 * tall * look.between(0.8, 1.1)
        one = lathe([(0, 0), (r, 0), (0.95 * r, 0.72 * tall), (0, tall)], 6)
        lean = 0.0 if n == 0 else look.between(0.25, 0.6)
        points.append(
            one.turn(1, lean)
            .turn(2, 2.4 * n)
            .move(0.012 * np.cos(2.4 * n) * (n > 0), 0.012 * np.sin(2.4 * n) * (n > 0), 0.008)
        )
    foot = ball(0.075, 0.068, 0.036, (0, 0, 0.012), 9)
    return put_down(
        [
            (
                join(points),
                textures.gradient(tint_color(color, 0.8), tint_color(color, 1.5), look.rng),
            ),
            (foot, textures.spots(look.rng, (120, 112, 106), (90, 84, 80), 0.2)),
        ],
        foot,
        join(points),
        factor=k,
    )


def mantel_clock(look: Look) -> Shape:
    """A mantel clock of wood with an arched top, a dial and feet."""
    color = look.color("brown", "wooden", "black", "red", "tan")
    k = look.between(0.85, 1.15)
    a = np.linspace(0, np.pi, 13)
    arch = np.column_stack([0.06 * np.cos(a), 0.085 + 0.06 * np.sin(a)])
    outline = np.concatenate([[(-0.06, 0.018), (0.06, 0.018)], arch])
    body = prism(outline, -0.03, 0.03).turn(0, np.pi / 2)
    base = block(0.16, 0.08, 0.018, 0.004, 0.003)
    ring = torus(0.043, 0.004, 32, 8).turn(0, np.pi / 2).move(0, -0.031, 0.085)
    dial = cylinder(0.042, 0.002, 32).turn(0, np.pi / 2).move(0, -0.0295, 0.085)
    face = prints.clock_face(look.rng, (246, 240, 224), (44, 38, 36))
    knob = ball(0.016, 0.016, 0.02, (0, 0, 0.152), 12)
    wood = textures.wood(look.rng, color)
    return put_down(
        [(join([body, base]), wood), (join([ring, knob]), textures.plain(BRASS)), (dial, face)],
        base,
        body,
        factor=k,
    )


def eiffel_tower(look: Look) -> Shape:
    """A small metal model of the Eiffel tower."""
    color = look.color("bronze", "black", "gold", "silver", "copper", "brown")
    k = look.between(0.85, 1.2)
    levels = [
        (0.05, 0.0),
        (0.034, 0.035),
        (0.026, 0.06),
        (0.014, 0.1),
        (0.006, 0.16),
        (0.003, 0.185),
    ]
    slim = [0.006, 0.005, 0.004, 0.003, 0.002, 0.0016]
    line = [(r - 0.006 * (r > 0.01), z) for r, z in levels]
    legs = [
        rod([(sx * r, sy * r, z) for r, z in line], slim, 4, 3) for sx in (-1, 1) for sy in (-1, 1)
    ]
    decks = [
        box(2 * r, 2 * r, 0.005).move(z=z)
        for r, z in ((0.036, 0.036), (0.02, 0.08), (0.008, 0.155))
    ]
    rungs = []
    for (r, z), (q, w) in itertools.pairwise(levels[1:5]):
        for s in (-1, 1):
            for t in (-1, 1):
                e, f = 0.93 * r - 0.004, 0.93 * q - 0.003
                rungs.append(straight((t * e, s * e, z), (-t * f, s * f, w), 0.0013, 4))
                rungs.append(straight((s * e, t * e, z), (s * f, -t * f, w), 0.0013, 4))
    arch = [
        rod(
            [(-0.036, s * 0.044, 0.008), (0, s * 0.037, 0.033), (0.036, s * 0.044, 0.008)], 0.002, 5
        )
        for s in (-1, 1)
    ]
    tip = straight((0, 0, 0.16), (0, 0, 0.2), [0.004, 0.001], 6)
    feet = [
        box(0.016, 0.016, 0.006).move(sx * 0.045, sy * 0.045) for sx in (-1, 1) for sy in (-1, 1)
    ]
    iron = textures.brushed_metal(look.rng, color)
    whole = join([*legs, *decks, *rungs, *arch, tip, *feet])
    return put_down([(whole, iron)], join(feet), join([*legs, *decks]), factor=k)


CATEGORIES = (
    Category("piggy_bank", piggy_bank, (0.14, 0.093, 0.115), 0.35, ("money box", "coin bank",
             "pig bank", "savings bank", "money bank"), ("living",), (), ("pink",)),
    Category("treasure_chest", treasure_chest, (0.163, 0.106, 0.097), 0.5, ("chest", "wooden chest",
             "pirate chest", "small chest", "toy chest", "reliquary casket", "casket",
             "mimic chest miniature"), ("living", "toys"), (), ("brown",)),
    Category("wooden_box", wooden_box, (0.195, 0.135, 0.082), 0.5, ("wood box", "open wooden box",
             "timber box"), ("living",), ("container",), ("wooden",)),
    Category("photo_album", photo_album, (0.24, 0.21, 0.035), 0.8, ("album", "picture album",
             "scrapbook", "wedding album", "scrap book", "stamp collection", "stamp album",
             "coin album", "sticker album"), ("living",), ("support", "big"), ("brown", "red"),
             state="lying flat"),
    Category("folding_fan", folding_fan, (0.384, 0.193, 0.00833), 0.05, ("hand fan", "paper fan",
             "japanese fan", "folding hand fan", "spanish fan"), ("living",), ("flat", "big"),
             ("red",), state="lying open"),
    Category("music_box", music_box, (0.123, 0.072, 0.065), 0.3, ("musical box", "musical box toy"),
             ("living",), (), ("wooden", "red")),
    Category("crystal", crystal, (0.0756, 0.08, 0.106), 0.3, ("crystal cluster", "amethyst",
             "quartz", "healing crystal", "rose quartz", "smoky quartz", "calcite",
             "amethyst cluster", "selenite wand"), ("living",), (), ("purple", "pink")),
    Category("mantel_clock", mantel_clock, (0.16, 0.08, 0.162), 0.9, ("mantle clock",
             "mantelpiece clock", "wooden clock", "antique clock", "shelf clock",
             "grandfather clock", "grandfather clock model", "astronomical clock model",
             "ship clock"), ("living",), (), ("brown",)),
    Category("eiffel_tower", eiffel_tower, (0.107, 0.107, 0.2), 0.3, ("eiffel tower model",
             "model eiffel tower", "miniature eiffel tower", "eiffel tower figurine"), ("living",),
             ("tall",), ("bronze", "black")),
)  # fmt: skip
"""The module's categories."""
