"""Drums, bells and other things to strike, keyboards and pads."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.forms import lay_down
from ...build.outlines import rounded_polygon
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "blue", "yellow", "green", "orange", "purple", "teal", "pink")


def _drum(r0: float, h0: float, jingles: bool) -> Callable[[Look], Shape]:
    """A drum standing, skin up; a tambourine with pairs of jingles in its hoop."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        r, h = r0 * k, h0 * k
        color = look.color("red", "blue", "wooden", "green", "orange", "teal")
        body = cylinder(0.97 * r, h, 36)
        wood = textures.fit(look.surface(color, "wood"), 48, 192).copy()
        hoop_tone = look.own_color("silver", "wooden", "cream", "gold")
        extra = []
        if jingles:
            for n in range(6):
                prints.fill(wood, n / 6 + 0.03, 0.25, 0.1, 0.5, (40, 34, 30))
                a = 2 * np.pi * (n + 0.48) / 6 + np.pi / 2
                at = (0.95 * r * np.cos(a), 0.95 * r * np.sin(a))
                plate = cylinder(0.0105 * k, 0.0016, 14)
                extra += [plate.move(*at, z * h) for z in (0.4, 0.56)]
        else:
            for n in range(8):
                a, b = (n / 8, 0.1), (n / 8 + 0.0625, 0.9)
                prints.stroke(wood, [a, b, (n / 8 + 0.125, 0.1)], 0.05, (240, 236, 226))
        hoops = [torus(0.98 * r, 0.02 * r + 0.001, 36, 6).move(z=z) for z in
                 ((h - 0.003,) if jingles else (0.0035, h - 0.003))]  # fmt: skip
        skin = cylinder(0.955 * r, 0.0012, 36).move(z=h - 0.0008)
        drawn = [(body, wood), (join(hoops), textures.plain(hoop_tone)),
                 (skin, textures.speckles(look.rng, (240, 232, 214), 5, 64))]  # fmt: skip
        if extra:
            drawn.append((join(extra), textures.plain((222, 198, 120))))
        return shape(drawn, [cylinder_part(0.97 * r, h)])

    return make


def drumstick(look: Look) -> Shape:
    """One wooden drumstick lying."""
    k = look.between(0.75, 0.9)
    color = look.color("wooden", "tan", "beige", "wooden", "black", "red")
    body = lathe(np.array([(0, 0), (0.0055, 0.001), (0.0072, 0.006), (0.0072, 0.28),
        (0.0035, 0.375),
                           (0.0052, 0.384), (0.005, 0.391), (0, 0.395)]) * k, 16)  # fmt: skip
    body = lay_down(body, -0.2 * k, 0.0072 * k)
    return shape([(body, look.surface(color, "wood"))], [flat_foot(body.vertices, 0.12)])


def maraca(look: Look) -> Shape:
    """A maraca lying: a painted gourd on a handle."""
    k = look.between(0.85, 1.02)
    color = look.color(*BRIGHT)
    image = prints.canvas(128, 96, color)
    other = look.own_color("yellow", "white", "cream", "black")
    for n in range(8):
        prints.polygon(image, [(n / 8, 0.62), (n / 8 + 0.0625, 0.4), (n / 8 + 0.125, 0.62)], other)
    for y in (0.28, 0.7):
        prints.fill(image, 0, y, 1, 0.05, other)
    a = np.linspace(-1.35, np.pi / 2, 14)
    curve = np.column_stack([0.036 * np.cos(a), 0.165 + 0.046 * np.sin(a)])
    curve[-1, 0] = 0
    head = lathe(np.concatenate([[(0, curve[0, 1])], curve]) * k, 26)
    grip = lathe(np.array([(0, 0), (0.009, 0), (0.0105, 0.01), (0.0085, 0.04), (0.0095, 0.12),
                           (0, 0.124)]) * k, 16)  # fmt: skip
    lean = np.arctan2(0.026, 0.165)
    laid = [s.turn(1, np.pi / 2 - 0.0).turn(1, 0.0) for s in (head, grip)]
    laid = [s.turn(1, -lean) for s in laid]
    low = min(float(s.bounds[0, 2]) for s in laid)
    head, grip = (s.move(x=-0.1 * k, z=-low) for s in laid)
    wood = textures.wood(look.rng, (196, 150, 100), side=64)
    return shape([(head, image), (grip, wood)],
                 [flat_foot(head.vertices, 0.08), hull_of(grip)])  # fmt: skip


def xylophone(look: Look) -> Shape:
    """A toy xylophone: bars of rainbow colours on two rails, a mallet on them."""
    k = look.between(0.9, 1.08)
    wood = look.surface(look.color("wooden", "tan", "white"), "wood")
    tones = ((206, 48, 50), (238, 132, 38), (244, 206, 62), (110, 180, 70), (60, 150, 160),
             (48, 98, 180), (110, 74, 160), (220, 100, 150))  # fmt: skip
    pieces, parts = [], []
    for s in (-1, 1):
        rail = box(0.25 * k, 0.014 * k, 0.028 * k).turn(2, -s * 0.11).move(y=s * 0.038 * k)
        pieces.append((rail, wood))
    for n, tone in enumerate(tones):
        bar = block(0.025 * k, (0.145 - 0.0095 * n) * k, 0.007 * k, 0.003, 0.001)
        bar = bar.move(x=(-0.109 + 0.031 * n) * k, z=0.028 * k)
        pieces.append((bar, textures.brushed_metal(look.rng, tone)))
        pins = [cylinder(0.0032 * k, 0.0025, 8).move((-0.109 + 0.031 * n) * k, s *
                (0.057 - 0.004 * n) * k, 0.0345 * k) for s in (-1, 1)]  # fmt: skip
        pieces.append((join(pins), textures.plain((230, 230, 228))))
    stick = tube([(-0.09 * k, 0.012 * k, 0.0405 * k), (0.06 * k, -0.02 * k, 0.0405 * k)],
                 0.0032 * k, 8)  # fmt: skip
    ball = ellipsoid(0.02, 0.02, 0.02, 14, 8).scale(k, k, k).move(0.065 * k, -0.021 * k, 0.045 * k)
    pieces += [(stick, wood), (ball, textures.plain((196, 42, 40)))]
    parts = [hull_of(*[p[0] for p in pieces[2::2] if p[0].bounds[1, 2] < 0.0352 * k][:8]),
             hull_of(*[p[0] for p in pieces[:2]])]  # fmt: skip
    return shape(pieces, parts)


def triangle_bar(look: Look) -> Shape:
    """A steel triangle lying, its beater across it."""
    k = look.between(0.85, 1.1)
    r = 0.0045 * k
    corners = rounded_polygon(np.array([(-0.075, -0.055), (0.075, -0.055), (0.0, 0.075)]), 0.012, 4)
    way = np.roll(corners, -4, 0) * k
    way = np.column_stack([way, np.full(len(way), r)])
    way[-1] = way[-2] + 0.82 * (way[-1] - way[-2])
    bar = tube(way[:-2], r, 8)
    beater = tube(np.array([(-0.06, 0.055, 0.012), (0.05, -0.075, 0.012)]) * k, 0.003 * k, 8)
    knob = (
        ellipsoid(0.012, 0.012, 0.012, 10, 8).scale(k, k, k).move(0.05 * k, -0.075 * k, 0.012 * k)
    )
    metal = look.surface(look.color("silver", "silver", "gold", "charcoal"), "metal")
    steel = textures.brushed_metal(look.rng, (190, 192, 196))
    sides = [hull_of(tube(way[[a, b]], r, 8)) for a, b in ((0, 6), (5, 11), (10, len(way) - 3))]
    return shape([(bar, metal), (join([beater, knob]), steel)], [*sides, hull_of(beater)])


def hand_bell(look: Look) -> Shape:
    """A bell with a handle, standing on its rim."""
    k = look.between(0.85, 1.1)
    metal = look.surface(look.color("brass", "gold", "silver", "copper", "bronze"), "metal")
    bell = lathe(np.array([(0, 0.03), (0.026, 0.025), (0.034, 0.0), (0.038, 0.0), (0.031, 0.014),
                           (0.026, 0.034), (0.023, 0.05), (0.012, 0.058), (0, 0.06)]) * k,
                               32)  # fmt: skip
    grip = lathe(np.array([(0, 0.058), (0.006, 0.058), (0.0095, 0.075), (0.008, 0.1),
                           (0.0115, 0.118), (0.009, 0.128), (0, 0.131)]) * k, 20)  # fmt: skip
    wood = look.own_color("brown", "black", "wooden", "maroon")
    return shape([(bell, metal), (grip, textures.wood(look.rng, wood, side=64))],
                 [hull_of(bell), hull_of(grip)])  # fmt: skip


def cymbal(look: Look) -> Shape:
    """A brass cymbal lying, dome up."""
    k = look.between(0.85, 1.1)
    metal = look.surface(look.color("gold", "brass", "gold", "bronze"), "metal")
    body = lathe(np.array([(0, 0.018), (0.022, 0.014), (0.03, 0.005), (0.098, 0.0), (0.1, 0.0008),
                           (0.03, 0.0085), (0.024, 0.016), (0.012, 0.0215), (0, 0.023)]) * k,
                               40)  # fmt: skip
    grooves = [torus(r * k, 0.0006, 40, 4).move(z=(0.0085 - 0.0077 * (r - 0.03) / 0.07) * k)
               for r in (0.05, 0.065, 0.08)]  # fmt: skip
    knob = cylinder(0.004 * k, 0.006 * k, 12).move(z=0.022 * k)
    return shape([(body, metal), (join([*grooves, knob]), textures.plain((150, 116, 60)))],
                 [hull_of(body)])  # fmt: skip


def _keys(octaves: int, panel: bool) -> Callable[[Look], Shape]:
    """A keyboard with black and white keys, a panel of buttons behind them if asked."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        whites = 7 * octaves + 1
        x, y, h = (0.019 * whites + 0.02) * k, (0.17 if panel else 0.11) * k, 0.03 * k
        color = look.color("black", "charcoal", "red", "white", "black", "sky", "pink")
        image = prints.canvas(256, 96, (246, 245, 240))
        for n in range(whites):
            prints.fill(image, n / whites - 0.002, 0, 0.005, 1, (120, 120, 120))
        for n in range(whites - 1):
            if n % 7 not in (2, 6):
                prints.fill(image, (n + 0.72) / whites, 0, 0.56 / whites, 0.6, (28, 28, 30))
        deep = 0.092 * k
        body = block(x, y, h, 0.008, 0.002)
        field = box(x - 0.02 * k, deep, 0.003).move(y=-(y - deep) / 2 + 0.006 * k, z=h - 0.001)
        blacks = [box(0.0105 * k, 0.6 * deep, 0.006 * k).move(
            x=((n + 1) / whites - 0.5) * (x - 0.02 * k), y=-(y - deep) / 2 + 0.006 * k + 0.2 * deep,
            z=h + 0.0015) for n in range(whites - 1) if n % 7 not in (2, 6)]  # fmt: skip
        pieces = [(body, look.surface(color, "plastic")), (field, image),
                  (join(blacks), textures.plain((28, 28, 30)))]  # fmt: skip
        if panel:
            board = prints.canvas(192, 40, tint_color(color, 0.8))
            prints.fill(board, 0.4, 0.15, 0.2, 0.5, (150, 200, 190))
            for n in range(8):
                u = 0.12 + 0.03 * n if n < 7 else 0.36
                prints.disc(board, u, 0.3, 0.1, (210, 80, 70) if n % 3 == 0 else (200, 200, 200))
                prints.disc(board, 1 - u, 0.3 if n % 2 else 0.65, 0.11, (190, 190, 194))
            pieces.append((box(0.97 * x, 0.05 * k, 0.0015).move(y=y / 2 - 0.03 * k, z=h - 0.0005),
                           board))  # fmt: skip
        return shape(pieces, [box_part(x, y, h + 0.002)])

    return make


def drum_pad(look: Look) -> Shape:
    """A pad controller: sixteen lit rubber pads and knobs."""
    k = look.between(0.92, 1.08)
    color = look.color("black", "charcoal", "white", "black", "gray")
    x, y, h = 0.19 * k, 0.2 * k, 0.03 * k
    pieces = [(block(x, y, h, 0.008, 0.002), look.surface(color, "plastic"))]
    lights = [look.own_color("red", "orange", "cyan", "lime", "magenta") for _ in range(3)]
    for n in range(16):
        pad = block(0.036 * k, 0.036 * k, 0.005, 0.003, 0.001)
        tone = lights[int(look.rng.integers(3))] if look.chance(0.45) else (120, 122, 126)
        at = ((n % 4 - 1.5) * 0.042 * k, (n // 4 - 1.5) * 0.042 * k - 0.014 * k, h - 0.001)
        pieces.append((pad.move(*at), textures.plain(tone)))
    knobs = [cylinder(0.007 * k, 0.012 * k, 14, top=0.006 * k).move((n - 1.5) * 0.042 * k,
             0.082 * k, h - 0.001) for n in range(4)]  # fmt: skip
    pieces.append((join(knobs), textures.plain((60, 60, 64) if sum(color) > 300 else
                                               (190, 190, 194))))  # fmt: skip
    return shape(pieces, [box_part(x, y, h + 0.003), *[hull_of(s) for s in knobs]])


CATEGORIES = (
    Category("drum", _drum(0.1, 0.12, False), (0.2, 0.2, 0.12), 0.7, ("toy drum", "snare drum",
             "hand drum", "small drum", "toy drum ornament", "drum ornament"), ("music",),
             ("round", "big"), ("red",)),
    Category("tambourine", _drum(0.1, 0.045, True), (0.2, 0.2, 0.045), 0.3, ("tambourin",
             "timbrel"), ("music",), ("round", "flat", "big"), ("wooden",)),
    Category("drumstick", drumstick, (0.325, 0.0119, 0.0119), 0.04, ("drum stick",), ("music",),
             (), ("wooden",), None, "lying flat"),
    Category("maraca", maraca, (0.197, 0.067, 0.067), 0.09, ("rumba shaker", "maracas shaker",
             "maracas"),
             ("music",), (), ("red", "yellow")),
    Category("xylophone", xylophone, (0.247, 0.143, 0.055), 0.5, ("glockenspiel", "toy xylophone",
             "metallophone"), ("music",), ("big",)),
    Category("triangle", triangle_bar, (0.14, 0.135, 0.018), 0.16, ("musical triangle",
             "triangle instrument", "steel triangle"), ("music",), ("flat",), ("silver",)),
    Category("hand_bell", hand_bell, (0.074, 0.074, 0.128), 0.22, ("handbell", "school bell",
                 "dinner bell", "brass bell", "bell favour", "tibetan bell", "altar bell",
                 "sanctus bell"),
             ("music",), ("round",), ("brass",
             "gold")),
    Category("cymbal", cymbal, (0.195, 0.195, 0.0273), 0.35, ("crash cymbal",),
             ("music",), ("round", "flat"), ("gold",)),
    Category("synthesizer", _keys(3, True), (0.438, 0.17, 0.036), 1.6, ("piano keyboard",
             "keyboard piano", "electric piano", "synth", "electronic keyboard", "midi keyboard",
             "music keyboard", "synthesiser", "musical keyboard", "electric keyboard"), ("music",),
             ("big",), ("black",)),
    Category("toy_piano", _keys(2, False), (0.305, 0.11, 0.036), 0.8, ("piano", "mini piano",
             "keyboard toy", "piano toy"), ("music",), ("big",), ("red", "black")),
    Category("drum_pad", drum_pad, (0.19, 0.2, 0.041), 0.7, ("midi pad", "midi controller",
             "pad controller", "drum machine", "beat pad", "launchpad", "groovebox"), ("music",),
             (), ("black",)),
)  # fmt: skip
"""The module's categories."""
