"""Candles, lanterns, incense, and what lights them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import rectangle, smooth
from ...build.recipes import Pieces, ball, open_vessel, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, open_box, prism, sweep, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look

WAXES = ("white", "cream", "red", "green", "navy", "pink", "purple", "yellow", "sage")
FLAME = textures.gradient((250, 160, 40), (255, 236, 140), np.random.default_rng(0), 2)
WICK = textures.plain((50, 44, 40))


def tea_light(look: Look) -> Shape:
    """A tea light: a thin metal cup of wax with a wick, some lit."""
    r, h = look.between(0.018, 0.021), look.between(0.014, 0.018)
    color = look.color("white", "white", "cream", "red", "green", "purple", "yellow")
    cup = lathe([(0, 0), (r, 0), (r, h), (0.93 * r, h), (0.93 * r, 0.8 * h), (0, 0.8 * h)], 28)
    wax = cylinder(0.92 * r, 0.002, 26).move(z=0.79 * h)
    wick = cylinder(0.0009, 0.007, 6).move(z=0.8 * h)
    foil = textures.brushed_metal(look.rng, (204, 206, 210))
    pieces: Pieces = [(cup, foil), (wax, textures.plain(color)), (wick, WICK)]
    if look.chance(0.5) or look.attributes.get("state") in ("lit", "burning"):
        pieces.append((ball(0.006, 0.006, 0.015, (0, 0, 0.8 * h + 0.013), 10), FLAME))
    made = shape(pieces, [cylinder_part(r, h)])
    return made.scale(look.between(0.9, 1.15))


def taper(look: Look) -> Shape:
    """A slim dinner candle in a small foot."""
    h, r = look.between(0.17, 0.24), look.between(0.009, 0.011)
    color = look.color(*WAXES)
    foot = lathe([(0, 0), (0.034, 0), (0.036, 0.005), (0.018, 0.012), (0.014, 0.03), (0, 0.03)], 24)
    stick = cylinder(r, h, 18, top=0.75 * r).move(z=0.026)
    wick = cylinder(0.0009, 0.01, 6).move(z=h + 0.026)
    wax = textures.speckles(look.rng, color, 4)
    pieces: Pieces = [
        (foot, look.surface(look.own_color("gold", "silver", "black", "white"), "metal")),
        (stick, wax),
        (wick, WICK),
    ]
    if look.chance(0.5):
        pieces.append((ball(0.009, 0.009, 0.022, (0, 0, h + 0.042), 10), FLAME))
    return put_down(pieces, foot, stick)


def votive(look: Look) -> Shape:
    """A candle in a coloured tumbler."""
    r, h = look.between(0.03, 0.037), look.between(0.06, 0.08)
    color = look.color("amber", "red", "teal", "purple", "green", "blue", "pink", "white")
    cup = lathe(
        [(0, 0), (0.85 * r, 0), (r, h), (0.92 * r, h), (0.86 * r, 0.7 * h), (0, 0.7 * h)], 28
    )
    wax = cylinder(0.85 * r, 0.003, 26).move(z=0.69 * h)
    wick = cylinder(0.001, 0.009, 6).move(z=0.7 * h)
    flame = ball(0.01, 0.01, 0.024, (0, 0, 0.7 * h + 0.02), 10)
    glass = textures.gradient(tint_color(color, 1.4), color, look.rng)
    pieces: Pieces = [
        (cup, glass),
        (wax, textures.plain((246, 238, 220))),
        (wick, WICK),
        (flame, FLAME),
    ]
    return put_down(pieces, cup)


def _branch(look: Look, arms: int, candles: bool) -> Shape:
    """A stand with ``arms`` lights in one plane, the middle one on the stem."""
    color = look.color("gold", "silver", "black", "brass", "bronze")
    metal = look.surface(color, "metal")
    half, top = (arms - 1) // 2, 0.13
    step = 0.036 if arms < 7 else 0.026
    foot = lathe([(0, 0), (0.05, 0), (0.052, 0.006), (0.02, 0.016), (0.008, 0.03), (0.007, 0.05),
                  (0.011, 0.056), (0.006, 0.062), (0.006, top), (0, top)], 24)  # fmt: skip
    solids: list[Solid] = [foot]
    for n in range(1, half + 1):
        x = n * step
        low = top - 0.02 - 0.75 * x
        path = [(0, 0, low), (0.62 * x, 0, low + 0.14 * x), (x, 0, low + 0.6 * x), (x, 0, top)]
        solids += [rod([(s * a, b, c) for a, b, c in path], 0.0042, 8) for s in (-1, 1)]
    places = [n * step for n in range(-half, half + 1)]
    raised = [0.014 if x == 0 else 0.0 for x in places]
    solids += [cylinder(0.006, 0.014, 14, top=0.012).move(x, 0, top - 0.006 + up)
               for x, up in zip(places, raised, strict=True)]  # fmt: skip
    solids.append(cylinder(0.006, 0.02, 10).move(z=top - 0.004))
    pieces: Pieces = [(join(solids), metal)]
    if candles:
        tall = 0.06 if arms < 7 else 0.045
        sticks = [cylinder(0.0062, tall, 12).move(x, 0, top + 0.004 + up)
                  for x, up in zip(places, raised, strict=True)]  # fmt: skip
        flames = [ball(0.007, 0.007, 0.016, (x, 0, top + tall + 0.013 + up), 8)
                  for x, up in zip(places, raised, strict=True)]  # fmt: skip
        pieces += [(join(sticks), textures.plain(look.own_color("white", "cream", "red", "blue"))),
                   (join(flames), FLAME)]  # fmt: skip
        return put_down(
            pieces, foot, join(solids[1:]), join(sticks), factor=look.between(0.9, 1.15)
        )
    return put_down(pieces, foot, join(solids[1:]), factor=look.between(0.9, 1.15))


def candelabra(look: Look) -> Shape:
    """A candelabra with three or five candles."""
    return _branch(look, look.pick([3, 5]), True)


def menorah(look: Look) -> Shape:
    """A menorah with nine candles."""
    return _branch(look, 9, True)


def lantern(look: Look) -> Shape:
    """A square lantern: a roof on four posts over a candle, a ring to carry it."""
    color = look.color("black", "white", "copper", "red", "teal", "silver", "bronze", "green")
    w, h = look.between(0.08, 0.1), look.between(0.12, 0.16)
    base = block(w + 0.016, w + 0.016, 0.014, 0.004, 0.002)
    posts = [box(0.008, 0.008, h).move(sx * (w / 2 - 0.004), sy * (w / 2 - 0.004), 0.013)
             for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    bars = [box(w, 0.004, 0.005).move(0, s * (w / 2 - 0.004), 0.013 + 0.5 * h) for s in (-1, 1)]
    bars += [box(0.004, w, 0.005).move(s * (w / 2 - 0.004), 0, 0.013 + 0.5 * h) for s in (-1, 1)]
    plate = block(w + 0.016, w + 0.016, 0.008, 0.004).move(z=h + 0.012)
    roof = cylinder(0.72 * w, 0.045, 4, top=0.02).turn(2, np.pi / 4).move(z=h + 0.019)
    cap = cylinder(0.018, 0.012, 16).move(z=h + 0.062)
    ring = torus(0.022, 0.003, 22, 8).turn(0, np.pi / 2).move(z=h + 0.092)
    wax = cylinder(0.022, 0.055, 20).move(z=0.013)
    flame = ball(0.012, 0.012, 0.028, (0, 0, 0.086), 10)
    paint = look.surface(color, "metal")
    pieces: Pieces = [(join([base, *posts, *bars, plate, roof, cap, ring]), paint),
                      (wax, textures.plain((248, 240, 222))), (flame, FLAME)]  # fmt: skip
    return shape(pieces, [hull_of(base, *posts, plate), hull_of(roof), hull_of(cap, ring)])


def incense_holder(look: Look) -> Shape:
    """A wooden boat for incense with one stick in it that glows."""
    color = look.color("wooden", "brown", "black", "tan", "white")
    long = look.between(0.22, 0.26)
    path = smooth([(-long / 2, 0, 0.006), (0.1 * long, 0, 0.006), (0.4 * long, 0, 0.012),
                   (long / 2, 0, 0.028)], 4)  # fmt: skip
    board = sweep(path, rectangle(0.036, 0.008, 0.003, 2))
    stick = straight((0.43 * long, 0, 0.02), (-0.36 * long, 0, 0.075), 0.0013, 6)
    ember = ball(0.004, 0.003, 0.004, (-0.362 * long, 0, 0.0753), 6)
    pieces: Pieces = [(board, look.surface(color, "wood")), (stick, textures.plain((120, 84, 60))),
                      (ember, textures.plain((240, 120, 50)))]  # fmt: skip
    low = board.move(z=-float(board.bounds[0, 2]))
    up = float(low.bounds[0, 2] - board.bounds[0, 2])
    pieces = [(s.move(z=up), t) for s, t in pieces]
    x = low.vertices[:, 0]
    return shape(pieces, [hull_part(low.vertices[x < 0.12 * long]),
                          hull_part(low.vertices[x > 0.05 * long])])  # fmt: skip


def oil_burner(look: Look) -> Shape:
    """An oil burner: a pierced pot with a tea light inside and a dish of oil above."""
    color = look.color("white", "teal", "terracotta", "black", "purple", "sage", "navy")
    r, h = look.between(0.04, 0.048), look.between(0.09, 0.11)
    pot = lathe([(0, 0), (0.9 * r, 0), (r, 0.3 * h), (0.8 * r, 0.8 * h), (0, 0.8 * h)], 28)
    dish = lathe([(0, 0.76 * h), (0.7 * r, 0.76 * h), (1.05 * r, h), (0.97 * r, h),
                  (0.66 * r, 0.86 * h), (0, 0.84 * h)], 28)  # fmt: skip
    arch = prism(
        [
            (-0.45 * r, 0),
            (0.45 * r, 0),
            (0.45 * r, 0.3 * h),
            (0.2 * r, 0.46 * h),
            (-0.2 * r, 0.46 * h),
            (-0.45 * r, 0.3 * h),
        ],
        0,
        0.004,
    ).turn(0, np.pi / 2)
    arch = arch.move(0, -0.93 * r, 0.1 * h)
    flame = ball(0.012, 0.006, 0.024, (0, -0.955 * r, 0.26 * h), 10)
    oil = cylinder(0.8 * r, 0.002, 26).move(z=0.905 * h)
    pieces: Pieces = [(join([pot, dish]), look.surface(color, "ceramic")),
                      (arch, textures.plain((60, 40, 30))), (flame, FLAME),
                      (oil, textures.plain((226, 196, 110)))]  # fmt: skip
    return put_down(pieces, pot, dish)


def lighter(look: Look) -> Shape:
    """A pocket lighter standing, its metal hood with wheel and button."""
    color = look.color("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")
    body = block(0.024, 0.0125, 0.056, 0.006)
    hood = block(0.022, 0.0115, 0.016, 0.005).move(z=0.0555)
    slot = box(0.01, 0.0118, 0.006).move(-0.004, 0, 0.0605)
    wheel = cylinder(0.0048, 0.006, 14).move(z=-0.003).turn(0, np.pi / 2).move(0.004, 0, 0.0725)
    key = box(0.008, 0.007, 0.006).turn(1, 0.3).move(0.0095, 0, 0.068)
    pieces: Pieces = [(body, look.surface(color, "plastic")),
                      (hood, textures.brushed_metal(look.rng, (196, 198, 204))),
                      (join([slot, wheel]), textures.plain((66, 66, 70))),
                      (key, textures.plain(tint_color(color, 0.6)))]  # fmt: skip
    return put_down(pieces, body, hood, factor=look.between(0.92, 1.12))


def matchbox(look: Look) -> Shape:
    """A matchbox lying, its drawer pulled out to show the matches."""
    color = look.color("red", "blue", "yellow", "green", "orange", "teal")
    x, y, h = 0.056, 0.037, 0.016
    image = prints.canvas(112, 72, color)
    prints.disc(image, 0.5, 0.5, 0.34, tint_color(color, 1.7))
    prints.write(image, look.pick(["MATCHES", "SAFETY", "FLAME"]), 0.5, 0.5, 0.2,
                 tint_color(color, 0.5), bold=True)  # fmt: skip
    sleeve = box(x, y, h)
    top = box(x - 0.001, y - 0.001, 0.0006).move(z=h - 0.0002)
    strike = box(x - 0.002, y + 0.0008, h - 0.004).move(z=0.002)
    out = look.between(0.012, 0.026)
    drawer = open_box(out, y - 0.003, h - 0.003, 0.0012, 0.0012)
    drawer = [s.move(-x / 2 - out / 2 + 0.0005, 0, 0.0015) for s in drawer]
    sticks = [
        box(out - 0.003, 0.0021, 0.0021).move(-x / 2 - out / 2, 0.0035 * n, 0.009 + 0.002 * (n % 2))
        for n in range(-4, 5)
    ]
    heads = [
        ball(
            0.0045, 0.0032, 0.0032, (-x / 2 - out + 0.0045, 0.0035 * n, 0.0101 + 0.002 * (n % 2)), 8
        )
        for n in range(-4, 5)
    ]
    pieces: Pieces = [
        (sleeve, textures.plain(color)),
        (top, image),
        (strike, textures.plain((96, 70, 60))),
        (join(drawer), textures.plain((236, 228, 208))),
        (join(sticks), textures.plain((226, 196, 140))),
        (join(heads), textures.plain((190, 44, 40))),
    ]
    made = shape(pieces, [box_part(x, y, h), hull_of(*drawer)])
    return made.scale(look.between(0.95, 1.3))


def match(look: Look) -> Shape:
    """A match lying."""
    color = look.color("red", "brown", "blue", "green", "black", "pink")
    long = look.between(0.045, 0.07)
    stick = box(long, 0.0024, 0.0024)
    head = ball(0.006, 0.0042, 0.004, (-long / 2 + 0.001, 0, 0.0015), 10)
    return put_down(
        [(stick, textures.wood(look.rng, (226, 196, 140))), (head, textures.plain(color))],
        stick,
        head,
    )


def dreidel(look: Look) -> Shape:
    """A dreidel leaning on its side: a square top with a letter on each face."""
    color = look.color("wooden", "blue", "red", "gold", "purple", "teal")
    cube = block(0.03, 0.03, 0.03, 0.003, 0.0015)
    tip = cylinder(0.019, 0.018, 4, top=0.001).turn(0, np.pi).turn(2, np.pi / 4)
    stem = cylinder(0.004, 0.026, 12, bevel=0.001).move(z=0.029)
    pieces: Pieces = [(join([cube, tip, stem]), look.surface(color, "wood"))]
    for k in range(4):
        image = prints.canvas(32, 32, tint_color(color, 1.15))
        prints.write(image, "NGHS"[k], 0.5, 0.5, 0.7, readable_on(color), bold=True)
        pieces.append(
            (box(0.024, 0.0006, 0.024).move(0, -0.0151, 0.003).turn(2, np.pi / 2 * k), image)
        )
    pieces = [(s.turn(1, np.pi / 2).move(z=0.015), t) for s, t in pieces]
    cube_ = cube.turn(1, np.pi / 2).move(z=0.015)
    rest = [s.turn(1, np.pi / 2).move(z=0.015) for s in (tip, stem)]
    return put_down(pieces, cube_, *rest, factor=look.between(0.85, 1.3))


def ring_dish(look: Look) -> Shape:
    """A small dish for rings and trinkets with a gold rim."""
    r = look.between(0.045, 0.06)
    color = look.color("white", "pink", "sage", "navy", "cream", "teal", "lavender")
    body, parts = open_vessel([(0.6 * r, 0), (0.9 * r, 0.008), (r, 0.02)], 0.0035, 0.004)
    rim = torus(0.985 * r, 0.0018, 32, 6).move(z=0.0195)
    return shape(
        [(body, look.surface(color, "ceramic")), (rim, textures.plain((222, 184, 96)))], parts
    )


CATEGORIES = (
    Category("tea_light", tea_light, (0.0384, 0.0384, 0.0299), 0.015, ("tealight", "tea candle",
             "tealight candle", "tea light candle", "floating candle"), ("living",), ("round",),
             ("white",)),
    Category("taper_candle", taper, (0.072, 0.072, 0.24), 0.2, ("taper", "dinner candle",
             "stick candle", "tall candle", "candle in a candlestick", "rushlight"), ("living",
             "dining"), ("tall",), ("white", "red")),
    Category("votive_candle", votive, (0.0662, 0.0662, 0.0823), 0.2, ("votive", "votive holder",
             "jar candle", "candle jar", "candle in a glass", "glass candle", "tea light holder",
             "tealight holder"), ("living",), ("round",), ("amber", "red")),
    Category("candelabra", candelabra, (0.13, 0.105, 0.22), 0.7, ("candelabrum",
             "branched candlestick", "three armed candlestick"), ("living", "dining"), ("tall",),
             ("gold", "silver")),
    Category("menorah", menorah, (0.25, 0.108, 0.22), 0.7, ("hanukkah menorah", "hanukkiah",
             "hanukkah candelabra"), ("living",), ("tall",), ("gold", "silver")),
    Category("lantern", lantern, (0.108, 0.108, 0.25), 0.6, ("candle lantern", "metal lantern",
             "garden lantern", "storm lantern", "lantern with a candle", "miner's lamp",
             "davy lamp", "paper lantern light", "hurricane lamp", "roman oil lamp"), ("living",),
             ("tall",), ("black", "white")),
    Category("incense_holder", incense_holder, (0.24, 0.036, 0.08), 0.06, ("incense",
             "incense stick", "incense burner", "incense sticks", "mosquito coil"), ("living",), (),
             ("wooden",)),
    Category("oil_burner", oil_burner, (0.09, 0.09, 0.1), 0.3, ("aroma burner", "oil diffuser",
             "wax melter", "fragrance burner", "essential oil burner", "aroma diffuser",
             "reed diffuser", "wax burner"), ("living",), ("round",), ("white", "teal")),
    Category("lighter", lighter, (0.025, 0.013, 0.079), 0.02, ("cigarette lighter",
             "pocket lighter", "gas lighter", "plastic lighter", "firesteel", "blowtorch"),
             ("living",), ("tall",), ("red", "blue")),
    Category("matchbox", matchbox, (0.085, 0.042, 0.018), 0.012, ("box of matches", "match box",
             "matches box", "matchbox collection"), ("living", "kitchen"), (), ("red", "blue"),
             state="lying"),
    Category("match", match, (0.06, 0.0042, 0.0035), 0.0003, ("matchstick", "match stick",
             "wooden match"), ("living",), (), ("red",), state="lying"),
    Category("dreidel", dreidel, (0.0808, 0.0341, 0.0337), 0.02, ("wooden dreidel", "hanukkah top"),
             ("living",), (), ("wooden", "blue"), state="lying"),
    Category("trinket_dish", ring_dish, (0.105, 0.105, 0.021), 0.09, ("ring dish", "jewelry dish",
             "jewellery dish", "trinket tray", "key dish", "trinket bowl", "ring tray",
             "coin dish"), ("vanity",), ("container", "round", "support"), ("white", "pink")),
)  # fmt: skip
"""The module's categories."""
