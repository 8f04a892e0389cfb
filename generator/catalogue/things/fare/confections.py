"""Sweets by the piece: wrapped ones, lollipops, canes, jellies, marshmallows, ice pops."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import lobe
from ...build.outlines import rectangle
from ...build.settled import limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "orange", "yellow", "green", "pink", "purple", "sky", "crimson", "lime")
STICK: RGB = (244, 240, 230)


def candy(look: Look) -> Shape:
    """A sweet in a twisted wrapper, its two ends fanned out."""
    r, long = look.between(0.0095, 0.012), look.between(0.022, 0.027)
    color = look.color(*BRIGHT)
    stripes = textures.stripes([color, color, (250, 246, 240)], look.pick([3, 5]), upright=True)
    body = rod(long, r, blunt=4)
    ends = []
    for s in (-1, 1):
        fan = lathe([(0, 0), (0.22 * r, 0), (1.05 * r, 1.3 * r), (0, 0.9 * r)], 40)
        fan = lobe(fan, 12, 0.25).turn(1, s * np.pi / 2).move(x=s * 0.47 * long)
        ends.append(fan.scale(1, 1, 0.8))
    skin = stripes if look.chance(0.6) else textures.speckles(look.rng, color, 5)
    return settle([(body, skin), (join(ends), textures.plain(tint_color(color, 1.15)))], 0.12)


def lollipop(look: Look) -> Shape:
    """A swirled flat lollipop or a round one, lying, on its stick."""
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
        pieces = [(head, textures.plain(color)), (face, swirl), (stick, textures.plain(STICK))]
        return shape(pieces, [hull_of(head, face), hull_of(stick)])
    ball = ellipsoid(1.5 * r, 1.5 * r, 1.5 * r, 24, 14)
    stick = tube([(0.6 * r, 0, -0.1 * r), (0.75 * r + long, 0, -0.75 * r + 0.0025)], 0.002, 8)
    tile = textures.stripes([color, tint_color(color, 1.4)], 3)
    return settle([(ball.turn(1, np.pi / 2), tile), (stick, textures.plain(STICK))], 0.02,
                  hulls=[[0], [1]])  # fmt: skip


def candy_cane(look: Look) -> Shape:
    """A striped cane with a hook, lying flat."""
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


def marshmallow(look: Look) -> Shape:
    """A soft white or pink cylinder standing."""
    r, h = look.between(0.012, 0.016), look.between(0.022, 0.03)
    color = look.color("white", "white", "pink", "cream", "sky")
    body = lathe([(0, 0), (0.75 * r, 0), (0.96 * r, 0.1 * h), (r, 0.3 * h), (r, 0.7 * h),
                  (0.96 * r, 0.9 * h), (0.75 * r, h), (0, 1.01 * h)], 24)  # fmt: skip
    return shape([(body, textures.speckles(look.rng, color, 4))], [hull_of(body)])


def jelly(look: Look) -> Shape:
    """A fluted dome of jelly turned out on a small plate."""
    r, h = look.between(0.042, 0.055), look.between(0.045, 0.06)
    color = look.color("red", "green", "orange", "purple", "yellow", "pink")
    dome = lathe([(0, 0), (r, 0), (0.92 * r, 0.5 * h), (0.78 * r, 0.86 * h), (0.6 * r, h),
                  (0.28 * r, h), (0.18 * r, 0.9 * h), (0, 0.9 * h)], 60)  # fmt: skip
    dome = lobe(dome, int(look.pick([10, 12, 14])), 0.1)
    plate = lathe([(0, 0), (0.9 * r, 0), (1.35 * r, 0.009), (1.35 * r, 0.011), (0, 0.005)], 32)
    tile = textures.gradient(tint_color(color, 0.85), tint_color(color, 1.25), look.rng)
    return shape([(plate, textures.plain((246, 244, 240))), (dome.move(z=0.0045), tile)],
                 [hull_of(plate), hull_of(dome.move(z=0.0045))])  # fmt: skip


def gummy_bear(look: Look) -> Shape:
    """A small gummy bear lying on its back."""
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
    tile = textures.gradient(tint_color(color, 0.85), tint_color(color, 1.2), look.rng)
    return settle([(join(blobs).turn(0, -np.pi / 2), tile)], 0.12).scale(k)


def chewing_gum(look: Look) -> Shape:
    """A slim packet of chewing gum sticks, one pulled out."""
    x, y, h = look.between(0.068, 0.08), look.between(0.02, 0.026), look.between(0.011, 0.014)
    color = look.color("green", "blue", "teal", "red", "yellow", "pink")
    face = prints.canvas(160, 56, color)
    prints.disc(face, 0.2, 0.5, 0.3, tint_color(color, 1.6))
    prints.write(face, look.pick(["GUM", "MINT", "FRESH"]), 0.6, 0.5, 0.5,
                 (250, 250, 248), bold=True)  # fmt: skip
    stick = box(0.02, 0.8 * y, 0.28 * h).move(x=x / 2 + 0.006, z=0.36 * h)
    foil = textures.plain((214, 216, 222))
    top = box(x, y, 0.0006).move(z=h - 0.0003)
    return shape([(box(x, y, h), textures.speckles(look.rng, color, 4)), (top, face),
                  (stick, foil)], [box_part(x, y, h), hull_of(stick)])  # fmt: skip


def truffle(look: Look) -> Shape:
    """A chocolate praline in a pleated paper case."""
    r = look.between(0.013, 0.017)
    tone: RGB = look.color("brown", "maroon", "cream", "brown")
    dark = tint_color(tone, 0.62) if sum(tone) < 500 else tone
    case = lobe(lathe([(0, 0), (0.85 * r, 0), (1.18 * r, 0.75 * r), (1.1 * r, 0.75 * r),
                       (0.8 * r, 0.08 * r), (0, 0.08 * r)], 56), 18, 0.1)  # fmt: skip
    ball = lathe([(0, 0.1 * r), (0.75 * r, 0.1 * r), (r, 0.6 * r), (0.86 * r, 1.15 * r),
                  (0.4 * r, 1.5 * r), (0, 1.55 * r)], 22)  # fmt: skip
    swirl = tube(
        [
            (-0.6 * r, 0.2 * r, 1.38 * r),
            (-0.2 * r, -0.25 * r, 1.55 * r),
            (0.2 * r, 0.25 * r, 1.55 * r),
            (0.6 * r, -0.2 * r, 1.38 * r),
        ],
        0.09 * r,
        6,
    )
    gold = textures.plain(look.own_color("gold", "brown", "red", "white"))
    line = textures.plain((244, 232, 206) if sum(dark) < 400 else (92, 54, 36))
    return shape([(case, gold), (ball, textures.speckles(look.rng, dark, 5)), (swirl, line)],
                 [hull_of(case, ball, swirl)])  # fmt: skip


def _bar(x: float, y: float, h: float, radius: float) -> Solid:
    return block(x, y, h, radius, 0.3 * h)


def ice_pop(look: Look) -> Shape:
    """An ice lolly lying on its side, its flat stick to the right."""
    x, y, h = look.between(0.085, 0.1), look.between(0.042, 0.05), look.between(0.018, 0.022)
    color = look.color("red", "orange", "pink", "brown", "lime", "sky", "yellow")
    side = rectangle(x, y, 0.46 * y, 6)
    side[:, 0] = np.where(side[:, 0] > 0, np.minimum(side[:, 0], 0.42 * x), side[:, 0])
    keep = np.append(np.abs(np.diff(side, axis=0)).sum(1) > 1e-9, True)
    body = prism(side[keep], 0, h, 0.28 * h)
    grooves = [rod(0.62 * x, 0.0035, sides=8).move(-0.08 * x, s * 0.2 * y, h) for s in (-1, 1)]
    other = tint_color(look.own_color("white", "yellow", "brown", "pink"), 1.1)
    tile = textures.gradient(color, tint_color(color, 1.2), look.rng)
    if look.chance(0.4):
        tile = textures.stripes([color, other, tint_color(color, 0.7)], 1, upright=True)
    stick = block(0.06, 0.011, 0.0025, 0.005).move(x=0.42 * x + 0.018, z=0.001)
    return shape([(body, tile), (join(grooves), textures.plain(tint_color(color, 0.75))),
                  (stick, textures.wood(look.rng, (226, 196, 148)))],
                 [hull_of(body), hull_of(stick)])  # fmt: skip


def granola_bar(look: Look) -> Shape:
    """A bar of oats and nuts, half out of its wrapper."""
    x, y, h = look.between(0.1, 0.12), look.between(0.032, 0.038), look.between(0.018, 0.022)
    color = look.color("green", "orange", "blue", "red", "teal", "purple")
    bar = _bar(0.5 * x, y - 0.004, h - 0.004, 0.005).move(x=-0.24 * x, z=0.001)
    oats = textures.spots(look.rng, (206, 160, 96), (128, 78, 44), 0.3)
    wrap = _bar(0.56 * x, y, h, 0.004).move(x=0.2 * x)
    fin = box(0.012, 1.02 * y, 0.002).move(x=0.48 * x + 0.005, z=0.4 * h)
    face = prints.canvas(128, 72, color)
    prints.write(face, look.pick(["OATS", "ENERGY", "PROTEIN", "NUTS"]), 0.5, 0.4, 0.34,
                 (250, 250, 246), bold=True)  # fmt: skip
    prints.fill(face, 0, 0.72, 1, 0.12, tint_color(color, 1.5))
    top = box(0.5 * x, 0.8 * y, 0.0007).move(x=0.2 * x, z=h - 0.0003)
    return shape(
        [
            (bar, oats),
            (wrap, textures.plain(color)),
            (top, face),
            (fin, textures.plain((208, 210, 214))),
        ],
        [hull_of(bar), hull_of(wrap)],
    )


def ice_cream_cone(look: Look) -> Shape:
    """An ice cream cone lying on its side: a waffle cone and one or two scoops."""
    r, long = look.between(0.026, 0.031), look.between(0.1, 0.12)
    color = look.color("pink", "brown", "cream", "mint", "yellow", "lavender")
    cone = lathe([(0, 0), (0.1 * r, 0), (0.92 * r, long), (0, long)], 28)
    rows, columns = np.mgrid[0:128, 0:128]
    net = (((rows + columns) % 16) < 3) | (((rows - columns) % 16) < 3)
    wafer = np.where(net[..., None], np.array((166, 108, 52)), np.array((220, 166, 96)))
    band = cylinder(r, 0.22 * long, 28).move(z=0.8 * long)
    ball = ellipsoid(2.2 * r, 2.2 * r, 2.1 * r, 24, 14).move(z=1.12 * long)
    frill = lobe(torus(0.95 * r, 0.2 * r, 40, 8), 11, 0.1).move(z=1.01 * long)
    scoop = [ball, frill]
    if look.chance(0.4):
        scoop.append(ellipsoid(1.9 * r, 1.9 * r, 1.8 * r, 22, 12).move(z=1.12 * long + 1.4 * r))
    pieces = [
        (cone, wafer.astype(np.uint8)),
        (band, textures.plain((214, 158, 88))),
        (join(scoop), textures.spots(look.rng, color, tint_color(color, 0.8), 0.08)),
    ]
    lean = np.arcsin(r / (1.12 * long))
    laid = [(s.turn(1, lean - np.pi / 2).move(x=0.5 * long), tile) for s, tile in pieces]
    return settle(laid, 0.05, hulls=[[0, 1], [2]])


def licorice(look: Look) -> Shape:
    """A wheel of liquorice lace."""
    r, t = look.between(0.02, 0.025), look.between(0.006, 0.008)
    turn = np.linspace(0, 6 * np.pi, 70)
    away = 0.15 * r + 0.78 * r * turn / turn[-1]
    lace = tube(np.column_stack([away * np.cos(turn), away * np.sin(turn), 0 * turn]), t / 2, 6)
    tail = limb([(0.93 * r, 0, 0), (0.96 * r, 0.5 * r, 0), (1.25 * r, 1.1 * r, 0)], [t / 2] * 3, 6)
    color = look.color("black", "black", "crimson", "brown")
    return settle([(join([lace, tail]), textures.speckles(look.rng, color, 6))], 0.15)


CATEGORIES = (
    Category("candy", candy, (0.0499, 0.0239, 0.0179), 0.008, ("sweets", "wrapped candy",
                 "wrapped sweet", "caramel", "candy wrapper", "boiled sweet", "bonbon",
                 "hard candy"),
             ("coffee", "living"), ("edible",), ("red", "yellow", "green"), state="lying flat"),
    Category("lollipop", lollipop, (0.13, 0.0385, 0.0222), 0.018, ("lolly", "swirl lollipop"),
             ("living",), ("edible",), ("red", "pink"), state="lying flat"),
    Category("candy_cane", candy_cane, (0.107, 0.0603, 0.00939), 0.015, ("peppermint stick",
             "christmas candy cane", "candy cane ornament"), ("living",), ("edible", "flat"),
             ("red",), state="lying flat"),
    Category("marshmallow", marshmallow, (0.0284, 0.0284, 0.0264), 0.007, ("marshmallow ghost",),
             ("coffee",), ("edible", "round"), ("white", "pink")),
    Category("jelly", jelly, (0.124, 0.124, 0.0573), 0.18, ("jello", "panna cotta",
                 "gelatin dessert", "flan", "jelly dessert",  "blancmange",
             "jelly bowl", "bowl of jelly"),
             ("dining",), ("edible", "round"), ("red", "green")),
    Category("gummy_bear", gummy_bear, (0.0144, 0.0242, 0.0127), 0.003, ("gummi bear", "gummy",
                 "jelly bear", "gummy candy", "jelly baby"),
             ("living",), ("edible",), ("red", "green"),
             state="lying flat"),
    Category("chewing_gum", chewing_gum, (0.0886, 0.0236, 0.0128), 0.015, ("gum", "pack of gum",
             "gum packet", "stick of gum", "packet of chewing gum", "pack of chewing gum"),
             ("office",), ("flat",), ("green", "blue"), state="lying flat"),
    Category("truffle", truffle, (0.0385, 0.0377, 0.0257), 0.014, ("chocolate truffle",
                 "chocolate praline", "praline"), ("coffee",), ("edible", "round"), ("brown",)),
    Category("ice_pop", ice_pop, (0.133, 0.0461, 0.0235), 0.08, ("popsicle", "ice lolly",
             "ice cream bar", "ice cream stick", "frozen pop", "kulfi"), ("kitchen",), ("edible",
             "flat"), ("red", "orange"), state="lying flat"),
    Category("granola_bar", granola_bar, (0.116, 0.036, 0.0206), 0.04, ("energy bar", "protein bar",
             "cereal bar", "muesli bar", "snack bar", "oat bar"), ("office",), ("edible",),
             ("green", "orange"), state="lying flat"),
    Category("ice_cream_cone", ice_cream_cone, (0.164, 0.0683, 0.0673), 0.11, ("ice cream cornet",
             "cone of ice cream", "waffle cone", "gelato cone"), ("kitchen",), ("edible",), ("pink",
             "cream"), state="lying down"),
    Category("licorice", licorice, (0.0527, 0.0492, 0.00525), 0.012, ("liquorice", "licorice wheel",
             "liquorice wheel"), ("living",), ("edible", "flat"), ("black",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
