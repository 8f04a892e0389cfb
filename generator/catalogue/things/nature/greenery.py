"""Ferns, ivy and bonsai in pots, wreaths, terrariums, and homes for birds."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of, hull_part, ring_parts
from ...build.forms import blade, side_view
from ...build.recipes import Pieces, ball, open_vessel, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..home.plants import planter


def _in_pot(look: Look, plant: Pieces, r: float, h: float) -> Shape:
    """Return a plant in a pot of radius ``r`` and height ``h``; plants grow from z = 0.88 h."""
    pieces = planter(look, r, h)
    crown = join([solid for solid, _ in plant])
    near = crown.vertices[np.hypot(*crown.vertices[:, :2].T) < 1.3 * r]
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), hull_part(near)])


def fern(look: Look) -> Shape:
    """A fern in a pot: arching fronds with leaflets on both sides."""
    r, h = look.between(0.042, 0.055), look.between(0.06, 0.085)
    green = look.own_color("green", "lime", "sage", spread=14)
    leaves: list[Solid] = []
    for k in range(10):
        out, up = look.between(0.075, 0.115), look.between(0.06, 0.12)
        t = np.linspace(0, 1, 9)[:, None]
        path = np.column_stack([out * t, 0 * t, h * 0.9 + up * np.sin(1.9 * t)])
        turn = 2.4 * k
        leaves.append(tube(path, 0.0013, 4).turn(2, turn))
        for n in range(2, 8):
            wide = 0.026 * (1.1 - n / 9)
            for s in (-1, 1):
                leaf = ellipsoid(wide, 0.009, 0.0015, 4, 4).turn(2, s * 1.1)
                leaves.append(leaf.move(path[n, 0] + 0.2 * wide, s * 0.42 * wide, path[n, 2])
                              .turn(2, turn))  # fmt: skip
    return _in_pot(look, [(join(leaves), textures.plain(green))], r, h)


def ivy(look: Look) -> Shape:
    """Ivy in a pot, its vines hanging over the rim."""
    r, h = look.between(0.045, 0.055), look.between(0.085, 0.11)
    green = look.own_color("green", "olive", "sage", spread=14)
    vines: list[Solid] = []
    leaves: list[Solid] = []
    for k in range(9):
        a = 2.4 * k
        low = look.between(0.015, 0.6 * h)
        path = [(0.3 * r, 0, 0.9 * h), (0.9 * r, 0, 1.22 * h), (1.3 * r, 0.006, 0.95 * h),
                (1.4 * r, -0.006, 0.5 * (h + low)), (1.38 * r, 0.004, low)]  # fmt: skip
        vine = rod(path, 0.0016, 5, 3).turn(2, a)
        vines.append(vine)
        for n in range(1, 7):
            p = vine.vertices[int(n / 7 * len(vine.vertices))]
            leaf = ellipsoid(0.026, 0.022, 0.0028, 5, 4).turn(1, 0.7 if n > 2 else -0.2)
            leaves.append(leaf.turn(2, a + look.between(-0.7, 0.7)).move(*p))
    tile = textures.spots(look.rng, green, tint_color(green, 1.5), 0.2)
    return _in_pot(look, [(join(leaves), tile), (join(vines), textures.plain((110, 96, 60)))], r, h)


def bonsai(look: Look) -> Shape:
    """A bonsai in a shallow dish: a bent trunk with clouds of leaves."""
    color = look.color("terracotta", "navy", "charcoal", "green", "brown", "gray")
    dish = box(0.15, 0.1, 0.03).bend(lambda p: p * np.column_stack(
        [0.88 + 4 * p[:, 2], 0.88 + 4 * p[:, 2], np.ones(len(p))]))  # fmt: skip
    feet = [box(0.016, 0.016, 0.008).move(sx * 0.05, sy * 0.03) for sx in (-1, 1) for sy in (-1, 1)]
    moss = ellipsoid(0.135, 0.088, 0.022, 18, 8).move(z=0.037)
    trunk = rod([(-0.02, 0, 0.036), (0.012, 0.004, 0.07), (-0.016, 0, 0.105), (0.004, 0, 0.14)],
                [0.013, 0.009, 0.007, 0.004], 10)  # fmt: skip
    arms = [rod([(0.004, 0, 0.075), (0.03, 0, 0.085), (0.055, 0, 0.096)], [0.006, 0.003], 7),
            rod([(-0.012, 0, 0.1), (-0.04, 0.004, 0.108), (-0.055, 0.004, 0.122)],
                [0.005, 0.003], 7)]  # fmt: skip
    green = look.own_color("green", "olive", "lime", "green", "red", spread=14)

    def knobbly(p: np.ndarray) -> np.ndarray:
        return p * (1 + 0.1 * np.sin(150 * p[:, :1]) * np.cos(170 * p[:, 1:2]))

    clouds = [ellipsoid(w, 0.8 * w, 0.42 * w, 14, 8).bend(knobbly).move(x, y, z)
              for x, y, z, w in ((0.006, 0, 0.152, 0.085), (0.058, 0, 0.106, 0.066),
                                 (-0.058, 0.004, 0.132, 0.066), (-0.01, 0.014, 0.132, 0.06),
                                 (0.03, -0.012, 0.134, 0.05))]  # fmt: skip
    pieces: Pieces = [
        (join([dish.move(z=0.006), *feet]), look.surface(color, "ceramic")),
        (moss, textures.spots(look.rng, (92, 122, 60), (120, 150, 80), 0.2)),
        (join([trunk, *arms]), textures.scratches(look.rng, (110, 80, 56), (70, 50, 36), 70)),
        (join(clouds), textures.spots(look.rng, green, tint_color(green, 1.3), 0.3)),
    ]
    return put_down(pieces, join([dish.move(z=0.006), *feet]), trunk, join(clouds),
                   factor=look.between(0.9, 1.15))  # fmt: skip


def herb_pot(look: Look) -> Shape:
    """A kitchen herb in a pot: a bush of small leaves."""
    r, h = look.between(0.042, 0.055), look.between(0.065, 0.085)
    green = look.own_color("green", "lime", "sage", "olive", spread=14)
    leaves: list[Solid] = []
    for k in range(70):
        t = (k + 0.5) / 70
        away = 0.062 * np.sqrt(t) * look.between(0.8, 1.1)
        z = h + 0.03 + 0.055 * (1 - t) + look.between(-0.012, 0.012)
        leaf = ellipsoid(0.027, 0.017, 0.004, 6, 4).turn(1, look.between(-0.2, 0.7))
        leaves.append(leaf.turn(2, 2.4 * k).move(away * np.cos(2.4 * k), away * np.sin(2.4 * k), z))
    stems = [straight((0.012 * np.cos(k), 0.012 * np.sin(k), 0.86 * h),
                      (0.035 * np.cos(k), 0.035 * np.sin(k), h + 0.05), 0.0018, 5)
             for k in range(7)]  # fmt: skip
    tile = textures.speckles(look.rng, green, 12)
    return _in_pot(
        look, [(join(leaves), tile), (join(stems), textures.plain(tint_color(green, 0.7)))], r, h
    )


def wreath(look: Look) -> Shape:
    """A wreath of fir or leaves lying flat, with berries and a bow."""
    color = look.color("green", "green", "olive", "sage", "tan")
    big = look.between(0.085, 0.115)
    sprigs: list[Solid] = []
    for k in range(60):
        a = 2 * np.pi * k / 60
        leaf = ellipsoid(0.05, 0.013, 0.011, 6, 4).turn(1, look.between(-0.5, 0.2))
        leaf = leaf.turn(2, a + np.pi / 2 + (0.6, -0.6, 0.05)[k % 3])
        out = big + (0.012, -0.012, 0)[k % 3]
        sprigs.append(leaf.move(out * np.cos(a), out * np.sin(a), 0.02 + 0.004 * (k % 2)))
    core = torus(big, 0.019, 30, 8).move(z=0.016)
    berries = [ball(0.014, 0.014, 0.014, ((big + 0.012 * (k % 2)) * np.cos(2 * np.pi * k / 11),
               (big + 0.012 * (k % 2)) * np.sin(2 * np.pi * k / 11), 0.037), 8)
               for k in range(11)]  # fmt: skip
    loops = [ball(0.045, 0.03, 0.016, (s * 0.024, -big, 0.045), 10) for s in (-1, 1)]
    tails = [box(0.014, 0.05, 0.003).turn(2, s * 0.4).move(s * 0.012, -big - 0.02, 0.036)
             for s in (-1, 1)]  # fmt: skip
    red = textures.plain(look.own_color("red", "gold", "white", "crimson"))
    fir = textures.speckles(look.rng, color, 16)
    wedges = ring_parts(
        [(big + 0.02, 0), (big + 0.026, 0.035)], [(big - 0.02, 0.035), (big - 0.02, 0)], 10
    )
    return shape([(join(sprigs), fir), (core, textures.plain(tint_color(color, 0.6))),
                  (join(berries), red), (join([*loops, *tails]), red)], wedges)  # fmt: skip


def terrarium(look: Look) -> Shape:
    """Plants, moss and stones under glass, drawn as a clear dome's contents on a wooden foot."""
    color = look.color("wooden", "brown", "black", "white", "tan")
    r, h = look.between(0.06, 0.075), look.between(0.13, 0.17)
    foot = cylinder(r, 0.018, 30, bevel=0.003)
    soil = lathe([(0, 0.018), (0.9 * r, 0.018), (0.9 * r, 0.035), (0.5 * r, 0.045), (0, 0.048)], 28)
    moss = [ball(0.036, 0.03, 0.022, (0.5 * r * np.cos(a), 0.5 * r * np.sin(a), 0.044), 10)
            for a in (0.5, 2.6, 4.4)]  # fmt: skip
    leaves = [
        blade(
            [(0, 0, 0.045), (0.25 * r, 0, 0.045 + 0.3 * h), (0.55 * r, 0, 0.045 + 0.42 * h)], 0.016
        ).turn(2, 1.05 * k)
        for k in range(6)
    ]
    stones = [ball(0.018, 0.015, 0.012, (0.66 * r * np.cos(a), 0.66 * r * np.sin(a), 0.04), 8)
              for a in (1.6, 3.5, 5.5)]  # fmt: skip
    rods = [rod([(0.9 * r, 0, 0.018), (0.92 * r, 0, 0.6 * h), (0.6 * r, 0, 0.92 * h), (0, 0, h)],
                0.0018, 6).turn(2, np.pi / 3 * k) for k in range(6)]  # fmt: skip
    bands = [torus(0.91 * r, 0.0018, 30, 6).move(z=z) for z in (0.022, 0.6 * h)]
    knob = ball(0.014, 0.014, 0.014, (0, 0, h + 0.004), 10)
    metal = textures.plain(look.pick([(206, 168, 96), (70, 72, 78), (236, 236, 234)]))
    dome = lathe(
        [(0, 0.018), (0.91 * r, 0.018), (0.92 * r, 0.6 * h), (0.6 * r, 0.92 * h), (0, h)], 20
    )
    green = look.own_color("green", "lime", "sage")
    pieces: Pieces = [(foot, look.surface(color, "wood")),
                      (soil, textures.speckles(look.rng, (84, 62, 46), 24)),
                      (join(moss), textures.spots(look.rng, (96, 130, 64), (130, 160, 84), 0.2)),
                      (join(leaves), textures.plain(green)),
                      (join(stones), textures.plain((200, 196, 188))),
                      (join([*rods, *bands, knob]), metal)]  # fmt: skip
    return shape(pieces, [cylinder_part(r, 0.02), hull_of(dome)])


def birdhouse(look: Look) -> Shape:
    """A wooden birdhouse with a round hole and a perch."""
    color = look.color("wooden", "blue", "red", "white", "yellow", "green", "teal")
    w, d, h = look.between(0.09, 0.11), look.between(0.085, 0.1), look.between(0.1, 0.12)
    walls = side_view([(-w / 2, 0), (w / 2, 0), (w / 2, h), (0, h + 0.45 * w), (-w / 2, h)], d)
    s45 = 0.733
    slope = 0.72 * w
    roof = [box(slope, d + 0.03, 0.007).move(x=-slope / 2 + 0.0035).turn(1, -s45)
            .move(0.0, 0, h + 0.45 * w + 0.002),
            box(slope, d + 0.03, 0.007).move(x=slope / 2 - 0.0035).turn(1, s45)
            .move(0.0, 0, h + 0.45 * w + 0.002)]  # fmt: skip
    hole = cylinder(0.018, 0.002, 22).turn(0, np.pi / 2).move(0, -d / 2 + 0.0008, 0.68 * h)
    rim = cylinder(0.022, 0.0015, 22).turn(0, np.pi / 2).move(0, -d / 2 + 0.0006, 0.68 * h)
    perch = straight((0, -d / 2 + 0.002, 0.4 * h), (0, -d / 2 - 0.03, 0.4 * h), 0.004)
    floor = box(w + 0.02, d + 0.02, 0.007)
    other = look.own_color("brown", "red", "charcoal", "white", "teal")
    pieces: Pieces = [
        (walls, look.surface(color, "wood")),
        (join(roof), textures.wood(look.rng, other)),
        (hole, textures.plain((30, 26, 24))),
        (join([rim, perch, floor]), textures.wood(look.rng, tint_color(color, 0.8))),
    ]
    return put_down(pieces, walls, floor, *roof)


def nest(look: Look) -> Shape:
    """A bird's nest of straw, open above; some hold three eggs."""
    color = look.color("brown", "tan", "bronze", "beige", "terracotta")
    r = look.between(0.06, 0.075)
    body, parts = open_vessel([(0.6 * r, 0), (0.92 * r, 0.014), (r, 0.032), (0.92 * r, 0.042)],
                              0.022, 0.012)  # fmt: skip
    straws: list[Solid] = []
    for k in range(46):
        a, z = 2.4 * k, 0.01 + 0.034 * ((k * 7) % 46) / 46
        out = 0.93 * r + look.between(-0.004, 0.003)
        b = a + look.between(0.35, 0.6)
        straws.append(straight((out * np.cos(a), out * np.sin(a), z),
                               (out * np.cos(b), out * np.sin(b), z + look.between(-0.008, 0.008)),
                               0.0016, 4))  # fmt: skip
    straw = textures.scratches(look.rng, color, tint_color(color, 0.6), 90)
    return shape([(body, straw), (join(straws), textures.plain(tint_color(color, 1.25)))], parts)


def bird_feeder(look: Look) -> Shape:
    """A bird feeder to stand: a tray with seeds, a tube and a roof."""
    color = look.color("wooden", "green", "red", "black", "copper", "teal")
    r = look.between(0.062, 0.075)
    tray = cylinder(r, 0.014, 28, bevel=0.002)
    seeds = cylinder(0.9 * r, 0.004, 28).move(z=0.0125)
    pipe = cylinder(0.034, 0.11, 24).move(z=0.014)
    ports = [cylinder(0.008, 0.003, 12).turn(0, np.pi / 2).move(0, -0.0325, z).turn(2, a)
             for z in (0.045, 0.09) for a in (0, np.pi / 2, np.pi, -np.pi / 2)]  # fmt: skip
    roof = cylinder(1.05 * r, 0.042, 28, top=0.008).move(z=0.122)
    hook = torus(0.01, 0.0022, 16, 6).turn(0, np.pi / 2).move(z=0.17)
    grain = textures.spots(look.rng, (196, 154, 92), (74, 60, 48), 0.3)
    skin = look.surface(color, "metal")
    pieces: Pieces = [(join([tray, roof]), skin), (join([seeds, pipe]), grain),
                      (join([*ports, hook]), textures.plain((52, 52, 56)))]  # fmt: skip
    return put_down(pieces, tray, pipe, roof, factor=look.between(0.9, 1.15))


def bird_cage(look: Look) -> Shape:
    """A small bird cage: a round tray, bars that meet in a dome, a bird on its perch."""
    color = look.color("white", "black", "gold", "brass", "mint", "silver")
    r, h = look.between(0.075, 0.09), look.between(0.2, 0.25)
    wire = look.surface(color, "metal")
    base = cylinder(1.06 * r, 0.02, 28, bevel=0.002)
    bars = [
        rod(
            [
                (r, 0, 0.018),
                (r, 0, 0.4 * h),
                (0.92 * r, 0, 0.75 * h),
                (0.4 * r, 0, 0.96 * h),
                (0.01, 0, h),
            ],
            0.0016,
            5,
            2,
        ).turn(2, 2 * np.pi * k / 16)
        for k in range(16)
    ]
    hoops = [torus(r, 0.0018, 28, 6).move(z=z) for z in (0.25 * h, 0.55 * h)]
    ring = torus(0.014, 0.0024, 18, 6).turn(0, np.pi / 2).move(z=h + 0.013)
    perch = straight((-0.97 * r, 0, 0.36 * h), (0.97 * r, 0, 0.36 * h), 0.0032, 8)
    hue = textures.plain(look.own_color("yellow", "blue", "green", "orange"))
    bird = [ball(0.03, 0.028, 0.046, (0, 0, 0.36 * h + 0.022), 12),
            ball(0.026, 0.025, 0.025, (0, -0.003, 0.36 * h + 0.05), 12),
            box(0.012, 0.006, 0.05).turn(0, -0.5).move(0, 0.006, 0.36 * h - 0.026)]  # fmt: skip
    beak = cylinder(0.005, 0.01, 8, top=0.0006).turn(0, np.pi / 2).move(0, -0.014, 0.36 * h + 0.05)
    pieces: Pieces = [(join([base, *bars, *hoops, ring]), wire), (join(bird), hue),
                      (join([perch, beak]), textures.wood(look.rng, (190, 144, 94)))]  # fmt: skip
    return put_down(pieces, base, join(bars))


CATEGORIES = (
    Category("fern", fern, (0.203, 0.195, 0.175), 0.5, ("potted fern", "fern plant", "boston fern"),
             ("living",), ("tall",), ("green",)),
    Category("ivy", ivy, (0.16, 0.16, 0.12), 0.6, ("potted ivy", "ivy plant", "trailing plant",
                 "hanging plant", "string of hearts", "pothos", "philodendron"),
             ("living",), (), ("green",)),
    Category("bonsai", bonsai, (0.185, 0.105, 0.175), 0.8, ("bonsai tree", "bonsai plant"),
             ("living", "office"), (), ("terracotta",)),
    Category("herb_pot", herb_pot, (0.14, 0.14, 0.16), 0.5, ("basil plant", "potted basil",
                 "mint plant", "potted herb", "pot of basil", "pot of herbs", "pot of mint",
                 "pot of chives", "pot of parsley", "pot of coriander", "pot of thyme",
                 "pot of rosemary", "parsley plant", "chive plant"),
             ("kitchen", "living"), ("tall",),
             ("terracotta",)),
    Category("wreath", wreath, (0.27, 0.28, 0.055), 0.25, ("christmas wreath", "door wreath",
             "leaf wreath", "laurel wreath", "flower wreath", "garland"), ("living",), ("big",),
             ("green",), state="lying flat"),
    Category("terrarium", terrarium, (0.135, 0.135, 0.165), 0.8, ("plant terrarium",
             "glass terrarium", "glass dome"), ("living",), ("tall", "round"),
             ("wooden",)),
    Category("birdhouse", birdhouse, (0.125, 0.145, 0.16), 0.45, ("bird house", "nest box",
             "nesting box", "bird box"), ("living",), ("tall",), ("wooden", "blue")),
    Category("nest", nest, (0.135, 0.135, 0.05), 0.06, ("bird nest", "birds nest", "bird's nest",
             "easter nest"), ("living",), ("container", "round"), ("brown",)),
    Category("bird_feeder", bird_feeder, (0.145, 0.145, 0.185), 0.4, ("birdfeeder",
             "feeder"), ("living",), ("tall",), ("green", "wooden")),
    Category("bird_cage", bird_cage, (0.175, 0.175, 0.25), 0.6, ("birdcage", "cage",
             "small bird cage", "bird in a cage"), ("living",), ("tall",), ("white", "gold")),
)  # fmt: skip
"""The module's categories."""
