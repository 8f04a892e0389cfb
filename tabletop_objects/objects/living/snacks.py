"""Objects of the ``living`` theme: snacks."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import above, box_part, cylinder_part, hull_of
from ...kit.primitives import ball, limb, pillow
from ...kit.shapes import Pieces, Shape, category, settle, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, tint_color

BRIGHT = ("red", "orange", "yellow", "green", "pink", "purple", "sky", "crimson", "lime")
STICK: RGB = (244, 240, 230)


@category("lollipop", size=(0.13, 0.0385, 0.0222), mass=0.018, material="food", assembled=True,
          aliases=("lolly", "swirl lollipop"), themes=("living",), roles=("edible",),
          colors=("red", "pink"), state="lying flat")  # fmt: skip
def lollipop(look: Look) -> Shape:
    """A round or flat, swirled lollipop on its stick, lying flat."""
    r, long = look.between(0.017, 0.026), look.between(0.075, 0.1)
    color = look.color(*BRIGHT)
    rows, columns = np.mgrid[0:128, 0:128] / 127 - 0.5
    turn = np.arctan2(rows, columns) + 16 * np.hypot(rows, columns)
    other = np.array(tint_color(look.own_color("white", "yellow", "pink"), 1.3))
    swirl = np.where((np.sin(2 * turn) > 0)[..., None], np.array(color), other).astype(np.uint8)
    if look.chance(0.65):
        t = 0.5 * r
        head = cylinder(r, t, 32, bevel=0.25 * t)
        face = cylinder(0.9 * r, 0.0008, 32).move(z=t - 0.0003)
        stick = tube([(0.9 * r, 0, 0.0021), (r + long, 0, 0.0021)], 0.002, 8)
        pieces = [(head, surfaces.plain(color)), (face, swirl), (stick, surfaces.plain(STICK))]
        return shape(pieces, [hull_of(head, face), hull_of(stick)])
    ball = ellipsoid(1.5 * r, 1.5 * r, 1.5 * r, 24, 14)
    stick = tube([(0.6 * r, 0, -0.1 * r), (0.75 * r + long, 0, -0.75 * r + 0.0025)], 0.002, 8)
    tile = surfaces.stripes([color, tint_color(color, 1.4)], 3)
    return settle([(ball.turn(1, np.pi / 2), tile), (stick, surfaces.plain(STICK))], 0.02,
                  hulls=[[0], [1]])  # fmt: skip


@category("candy_cane", size=(0.107, 0.0603, 0.00939), mass=0.015, material="food",
          aliases=("peppermint stick", "christmas candy cane", "candy cane ornament"),
          themes=("living",), roles=("edible", "flat"), colors=("red",),
          state="lying flat")  # fmt: skip
def candy_cane(look: Look) -> Shape:
    """A striped candy cane with a hook, lying flat."""
    long, r = look.between(0.11, 0.14), look.between(0.0045, 0.006)
    a = np.linspace(0, np.pi, 9)
    hook = 0.2 * long
    path = np.concatenate([
        np.column_stack([np.linspace(0.62 * long, 0, 8)[:-1], np.zeros(7)]),
        np.column_stack([-hook * np.sin(a), hook - hook * np.cos(a)]),
        [[0.06 * long, 2 * hook]],
    ])  # fmt: skip
    cane = tube(np.column_stack([path, np.zeros(len(path))]), r, 12)
    color = look.color("red", "red", "green", "crimson")
    y, x = np.mgrid[0:128, 0:64]
    red = (x / 64 + 9 * y / 128) % 1 < 0.45
    tile = np.where(red[..., None], np.array(color), np.array((250, 248, 244))).astype(np.uint8)
    return settle([(cane, tile)], 0.12)


@category("gummy_bear", size=(0.0144, 0.0242, 0.0127), mass=0.003, material="food",
          aliases=("gummi bear", "gummy", "jelly bear", "gummy candy", "jelly baby"),
          themes=("living",), roles=("edible",), colors=("red", "green"),
          state="lying flat")  # fmt: skip
def gummy_bear(look: Look) -> Shape:
    """A small gummy bear, lying on its back."""
    k = look.between(0.9, 1.25)
    color = look.color(*BRIGHT)
    blobs = [ellipsoid(0.011, 0.009, 0.014, 14, 8).move(z=0.0075),
             ellipsoid(0.0095, 0.0085, 0.0085, 14, 8).move(y=-0.0005, z=0.0165)]  # fmt: skip
    blobs.append(ellipsoid(0.004, 0.004, 0.0032, 10, 6).move(y=-0.0045, z=0.0155))
    for s in (-1, 1):
        blobs += [
            ellipsoid(0.0034, 0.003, 0.0034, 8, 6).move(s * 0.0035, 0, 0.0205),
            ellipsoid(0.0038, 0.007, 0.0038, 8, 6).move(s * 0.0042, -0.004, 0.0105),
            ellipsoid(0.0048, 0.0085, 0.0048, 8, 6).move(s * 0.0042, -0.0045, 0.0024),
        ]
    tile = surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.2), look.rng)
    return settle([(join(blobs).turn(0, -np.pi / 2), tile)], 0.12).scale(k)


@category("licorice", size=(0.0527, 0.0492, 0.00525), mass=0.012, material="food",
          aliases=("liquorice", "licorice wheel", "liquorice wheel"), themes=("living",),
          roles=("edible", "flat"), colors=("black",), state="lying flat")  # fmt: skip
def licorice(look: Look) -> Shape:
    """A coiled wheel of liquorice lace."""
    r, t = look.between(0.02, 0.025), look.between(0.006, 0.008)
    turn = np.linspace(0, 6 * np.pi, 70)
    away = 0.15 * r + 0.78 * r * turn / turn[-1]
    lace = tube(np.column_stack([away * np.cos(turn), away * np.sin(turn), 0 * turn]), t / 2, 6)
    tail = limb([(0.93 * r, 0, 0), (0.96 * r, 0.5 * r, 0), (1.25 * r, 1.1 * r, 0)], [t / 2] * 3, 6)
    color = look.color("black", "black", "crimson", "brown")
    return settle([(join([lace, tail]), surfaces.speckles(look.rng, color, 6))], 0.15)


GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


@category("birthday_cake", size=(0.21, 0.21, 0.125), mass=0.8, material="food",
          aliases=("cake with candles", "candle cake"), themes=("living", "dining"),
          roles=("edible",), colors=("pink", "white"))  # fmt: skip
def birthday_cake(look: Look) -> Shape:
    """A frosted cake on a plate, with burning candles and piped decorations."""
    color = look.color("pink", "white", "brown", "yellow", "mint", "sky", "lavender")
    r, h = look.between(0.075, 0.095), look.between(0.055, 0.075)
    plate = cylinder(1.25 * r, 0.007, 32, bevel=0.002)
    body = cylinder(r, h, 32, bevel=0.004).move(z=0.006)
    drops = [ball(0.02, 0.02, 0.017, (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), h + 0.01), 8)
             for a in 2 * np.pi * np.arange(14) / 14]  # fmt: skip
    foot = [ball(0.018, 0.018, 0.016, (1.01 * r * np.cos(a), 1.01 * r * np.sin(a), 0.012), 8)
            for a in 2 * np.pi * np.arange(20) / 20]  # fmt: skip
    count = look.pick([5, 6, 8])
    places = [
        (0.5 * r * np.cos(a), 0.5 * r * np.sin(a)) for a in 2 * np.pi * np.arange(count) / count
    ]
    sticks = [cylinder(0.0034, 0.045, 10).move(x, y, h + 0.004) for x, y in places]
    flames = [ball(0.006, 0.006, 0.014, (x, y, h + 0.056), 8) for x, y in places]
    wax = surfaces.stripes([look.own_color(*GAY), (250, 250, 246)], 4)
    cream = surfaces.plain((250, 244, 232) if color[2] < 220 else look.own_color("pink", "brown"))
    pieces: Pieces = [(plate, surfaces.plain((240, 240, 238))), (body, surfaces.speckles(look.rng,
                      color, 5)), (join([*drops, *foot]), cream), (join(sticks), wax),
                      (join(flames), surfaces.plain((252, 196, 60)))]  # fmt: skip
    return shape(pieces, [cylinder_part(1.25 * r, 0.007), hull_of(body), hull_of(*sticks)])


@category("popcorn", size=(0.116, 0.116, 0.175), mass=0.12, material="paper", assembled=True,
          aliases=("popcorn box", "popcorn bucket", "box of popcorn", "bag of popcorn",
          "popcorn tub", "bucket of popcorn", "popcorn bag"), themes=("living",), roles=("edible",),
          colors=("red",))  # fmt: skip
def popcorn(look: Look) -> Shape:
    """A striped paper tub heaped with popcorn."""
    r, h = look.between(0.055, 0.068), look.between(0.13, 0.16)
    color = look.color("red", "red", "blue", "yellow", "teal", "orange")
    stripes = surfaces.stripes([color, (250, 248, 244)], look.pick([8, 10]), upright=True, side=160)
    image = surfaces.fit(stripes, 128, 160).copy()
    if look.chance(0.6):
        sign = image[:, 58:102]
        prints.disc(sign, 0.5, 0.5, 0.2, (250, 248, 244))
        prints.write(sign, "POP", 0.5, 0.5, 0.16, color, bold=True)
    square = look.chance(0.4)
    body = lathe([(0, 0), (0.72 * r, 0), (r, h), (0, h)], 4 if square else 30, v=[0, 0, 1, 1])
    body = body.turn(2, np.pi / 4) if square else body
    grow = 0.62 if square else 0.86
    corn = []
    for k in range(30):
        away, turn = grow * r * np.sqrt((k + 0.5) / 30), 2.4 * k
        lift = 0.3 * r * (1 - (away / r) ** 2)
        d = look.between(0.019, 0.027)
        corn.append(ellipsoid(d, 0.9 * d, 0.85 * d, 8, 5).turn(0, turn)
                    .move(away * np.cos(turn), away * np.sin(turn), h + lift))  # fmt: skip
    puff = surfaces.spots(look.rng, (250, 240, 206), (236, 200, 120), 0.2)
    heap = join(corn)
    return shape([(body, image), (heap, puff)], [hull_of(body), hull_of(heap)])


@category("chips_can", size=(0.077, 0.077, 0.24), mass=0.21, material="paper", aliases=("chip can",
          "can of chips", "pringles", "pringles can", "crisps tube", "tube of chips",
          "tube of crisps", "chips tube", "potato crisp tube", "crisp tube",
          "tube of potato crisps"), themes=("living", "food"), roles=("round", "tall"),
          colors=("red", "green"))  # fmt: skip
def chips_can(look: Look) -> Shape:
    """A tall paper tube of stacked crisps with a transparent lid."""
    r, h = look.between(0.036, 0.039), look.between(0.22, 0.255)
    color = look.color("red", "green", "purple", "orange", "blue", "yellow", "teal")
    image = prints.canvas(320, 256, color)
    front = image[:, 100:220]
    prints.disc(front, 0.5, 0.24, 0.115, (250, 244, 230))
    prints.disc(front, 0.46, 0.22, 0.014, (40, 34, 30))
    prints.disc(front, 0.54, 0.22, 0.014, (40, 34, 30))
    prints.fill(front, 0.36, 0.27, 0.28, 0.022, (90, 54, 30))
    word = look.pick(["CHIPS", "CRISPS", "STAX", "SALTY"])
    prints.write(front, word, 0.5, 0.45, 0.1, (255, 246, 180), bold=True)
    prints.write(front, look.pick(["ORIGINAL", "PAPRIKA", "ONION", "SALT"]), 0.5, 0.54, 0.05,
                 (255, 255, 250))  # fmt: skip
    for k in range(5):
        y = 0.66 + 0.05 * k
        t = np.linspace(0, 2 * np.pi, 20)
        prints.polygon(front, [(0.5 + 0.26 * np.cos(a), y + 0.05 * np.sin(a)) for a in t],
                       (238, 196 - 8 * (k % 2), 100))  # fmt: skip
    prints.fill(image, 0, 0.95, 1, 0.05, tint_color(color, 0.6))
    steel = surfaces.plain((196, 198, 202))
    body = lathe([(0, 0), (r, 0), (r, h - 0.008), (0, h - 0.008)], 32, v=[0, 0.0, 0.97, 1])
    lid = cylinder(r + 0.0012, 0.012, 32, bevel=0.002).move(z=h - 0.012)
    foot = torus(r - 0.0005, 0.0015, 30, 6).move(z=0.0015)
    tone = look.pick([(226, 230, 232), (226, 230, 232), tint_color(color, 0.7)])
    return shape([(body, image), (lid, surfaces.plain(tone)), (foot, steel)],
                 [cylinder_part(r, h - 0.01), hull_of(lid)])  # fmt: skip


@category("chips_bag", size=(0.17, 0.22, 0.047), mass=0.12, material="paper",
          aliases=("bag of chips", "chip bag", "crisps", "potato chips", "chips", "snack bag",
          "snack", "crisp packet", "packet of crisps", "packet of chips", "pack of crisps",
          "bag of crisps"), themes=("living", "dining"), roles=("flat",), colors=("red", "yellow"),
          state="lying flat", common=True)  # fmt: skip
def chips_bag(look: Look) -> Shape:
    """A puffed bag of crisps, lying on its back."""
    x, y, z = look.between(0.15, 0.19), look.between(0.19, 0.25), look.between(0.045, 0.06)
    color = look.color("red", "yellow", "green", "blue", "orange", "purple")
    other = look.own_color("yellow", "white", "red", "orange")
    front = prints.canvas(128, 160, color)
    prints.disc(front, 0.5, 0.4, 0.3, other)
    prints.disc(front, 0.5, 0.4, 0.26, tint_color(color, 0.8))
    word = look.pick(["CHIPS", "CRISPS", "NACHO", "SALTY", "CORN"])
    prints.write(front[:, 16:-16], word, 0.5, 0.4, 0.15, (255, 250, 235), bold=True)
    for _ in range(4):
        a, b = look.rng.uniform(0.2, 0.8), look.rng.uniform(0.68, 0.84)
        prints.disc(front, a, b, 0.075, (236, 196, 96))
    for v in (0.0, 0.95):
        prints.fill(front, 0, v, 1, 0.05, (212, 212, 216))
    n = 14
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    puff = (np.clip(1 - u**4, 0, 1) * np.clip(1 - v**4, 0, 1)) ** 0.6
    crease = 1 + 0.06 * surfaces.noise(look.rng, n, n, (3, 3), 1)
    lift = np.maximum(0.5 * z * puff * crease, 0.0006)
    wave = 1 - 0.05 * (1 - np.abs(v) ** 2)
    bag = pillow(u * wave * x / 2, v * y / 2, lift)
    return shape(
        [(bag.move(z=0.42 * z), front)],
        [box_part(0.62 * x, 0.66 * y, 0.84 * z), hull_of(bag.move(z=0.42 * z).bend(above))],
    )
