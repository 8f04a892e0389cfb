"""Objects of the ``living`` theme: religious items."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import cloth, dye, metal, shine, wood
from ...kit.outlines import smooth
from ...kit.parts import hull_of, open_vessel
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    hull_solid,
    rod,
    spindle,
    standing,
    standing_plate,
    straight,
)
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    category,
    from_pieces,
    put_down,
    shape,
    vary,
)
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ..toys.shapes import body
from .leaves import bundle


def _cross(figure: bool, stepped: bool) -> Drawing:
    """Return the drawing function of a cross on a base, with or without a figure."""

    def draw(look: Look) -> Pieces:
        tile = look.surface(look.color("brown", "gold", "wooden", "silver"), look.pick(
            ["wood", "metal"] if not figure else ["wood"]))  # fmt: skip
        post = at_box(0.018, 0.012, 0.2, (0, 0, 0.015))
        bar = at_box(0.11, 0.012, 0.018, (0, 0, 0.14))
        base = [at_block(0.09, 0.06, 0.012, 0.004), at_block(0.06, 0.04, 0.01, 0.003,
                                                             (0, 0, 0.012))]  # fmt: skip
        pieces: Pieces = [(s, tile) for s in (*base, post, bar)]
        if figure:
            pale = shine(look, "gold", "silver")
            body = [rod([(0, -0.009, 0.085), (0.002, -0.01, 0.11), (0, -0.011, 0.14)],
                        [0.004, 0.006, 0.0075], 8),
                    *(rod([(s * 0.005, -0.011, 0.143), (s * 0.026, -0.009, 0.15),
                           (s * 0.046, -0.008, 0.152)], [0.004, 0.003, 0.0025], 6) for s in (-1,
             1)),
                    rod([(0, -0.009, 0.088), (0.003, -0.012, 0.07), (0, -0.008, 0.052)],
                        [0.005, 0.0042, 0.003], 8), ball(0.011, 0.011, 0.014, (0.003, -0.013,
             0.157), 10)]  # fmt: skip
            pieces += [(b, pale) for b in body]
        return pieces

    return draw


def _beads(cross: bool) -> Drawing:
    """Return the drawing function of a loop of beads with a cross or a tassel, lying flat."""

    def draw(look: Look) -> Pieces:
        bead = look.surface(
            look.color("brown", "black", "wooden", "maroon", "white", "green"), "wood"
        )
        other = dye(look, "gold", "silver")
        a = 2 * np.pi * np.arange(46) / 46
        wave = 1 + 0.08 * np.sin(3 * a + look.between(0, 6))
        x, y = 0.075 * wave * np.cos(a), 0.055 * wave * np.sin(a)
        balls = [ellipsoid(0.0085, 0.0085, 0.0085, 8, 5).move(u, v, 0.0042)
                 for u, v in zip(x, y, strict=True)]  # fmt: skip
        end = float(y[34])
        more = [ellipsoid(0.0085, 0.0085, 0.0085, 8, 5).move(float(x[34]), end - 0.0095 * n, 0.0042)
                for n in range(1, 5)]  # fmt: skip
        tip = end - 0.045
        if cross:
            last = [at_box(0.006, 0.04, 0.003, (float(x[34]), tip - 0.018, 0)),
                    at_box(0.024, 0.006, 0.003, (float(x[34]), tip - 0.01, 0))]  # fmt: skip
        else:
            last = [rod([(float(x[34]), tip, 0.005), (float(x[34]) + 0.003, tip - 0.035, 0.004)],
                        [0.003, 0.007], 10)]  # fmt: skip
        return [(join(balls), bead), (join(more), bead), (join(last), other)]

    return draw


def _cup(lid: bool) -> Callable[[Look], Shape]:
    def make(look: Look) -> Shape:
        """A metal chalice: a cup on a knobbed stem, with a cover and a cross if ``lid`` is set."""
        k = look.between(0.9, 1.1)
        tile = metal(look, "gold", "gold", "silver")
        stem = lathe([(0, 0), (0.045, 0), (0.046, 0.006), (0.03, 0.014), (0.009, 0.03),
                      (0.008, 0.05), (0.017, 0.06), (0.017, 0.066), (0.008, 0.076), (0.012, 0.09),
                      (0, 0.09)], 28)  # fmt: skip
        side = [(0.012, 0.0), (0.036, 0.022), (0.042, 0.05), (0.044, 0.075)]
        bowl, parts = open_vessel(side, 0.0022, 0.004)
        pieces = [(stem, tile), (bowl.move(z=0.088), tile)]
        moved = [type(p)(p.vertices + np.array([0, 0, 0.088]), p.kind, p.axis) for p in parts]
        if not lid:
            return shape(pieces, [hull_of(stem), *moved]).scale(k)
        top = lathe(
            [(0, 0), (0.046, 0), (0.046, 0.004), (0.03, 0.022), (0.006, 0.03), (0, 0.03)], 28
        )
        knob = [at_box(0.004, 0.004, 0.028, (0, 0, 0.028)), at_box(0.018, 0.004, 0.004,
                                                                   (0, 0, 0.043))]  # fmt: skip
        cap = [s.move(z=0.163) for s in (top, *knob)]
        full = standing((0.012, 0.088), (0.036, 0.11), (0.044, 0.163))
        return shape([*pieces, (join(cap), tile)],
                     [hull_of(stem), hull_of(full), hull_of(cap[0]),
             hull_of(*cap[1:])]).scale(k)  # fmt: skip

    return make


@category("thurible", size=(0.143, 0.142, 0.109), mass=0.5, material="metal", assembled=True,
          aliases=("censer", "incense censer", "swinging censer"), themes=("living",),
          colors=("brass",))  # fmt: skip
@from_pieces(foot=0.02)
def thurible(look: Look) -> Pieces:
    """A censer: a footed bowl with a perforated lid and its chains around it."""
    tile = metal(look, "gold", "brass", "silver")
    bowl = standing((0.028, 0), (0.03, 0.006), (0.016, 0.014), (0.042, 0.035), (0.046, 0.055))
    lid = standing((0.046, 0.056), (0.038, 0.075), (0.018, 0.092), (0.014, 0.1), (0.004, 0.112))
    dark = surfaces.plain((30, 26, 24))
    holes = [ball(0.008, 0.008, 0.012, (0.038 * np.cos(a), 0.038 * np.sin(a), 0.071), 8)
             for a in np.arange(8) * np.pi / 4]  # fmt: skip
    chains = [tube(smooth([(0.03 * np.cos(a), 0.03 * np.sin(a), 0.058),
                           (0.055 * np.cos(a), 0.055 * np.sin(a), 0.03),
                           (0.085 * np.cos(a), 0.085 * np.sin(a), 0.0022),
                           (0.1 * np.cos(a + 0.8), 0.1 * np.sin(a + 0.8), 0.0022)], 6), 0.0018, 6)
              for a in (-2.2, -1.2, -0.4)]  # fmt: skip
    return [(bowl, tile), (lid, tile), (join(holes), dark), (join(chains), tile)]


@category("monstrance", size=(0.14, 0.1, 0.27), mass=0.8, material="metal", assembled=True,
          aliases=("sunburst monstrance",), themes=("living",), roles=("tall",),
          colors=("gold",))  # fmt: skip
@from_pieces()
def monstrance(look: Look) -> Pieces:
    """A monstrance: a golden sun with a glass centre on a stem."""
    tile = metal(look, "gold", "gold", "silver")
    stem = standing((0.05, 0), (0.05, 0.008), (0.02, 0.02), (0.008, 0.04), (0.016, 0.06),
                    (0.008, 0.075), (0.006, 0.12))  # fmt: skip
    a = np.pi / 2 + np.arange(48) * 2 * np.pi / 48
    r = np.where(np.arange(48) % 2, 0.034, np.where(np.arange(48) % 4, 0.07, 0.058))
    sun = standing_plate(np.column_stack([r * np.cos(a), 0.18 + r * np.sin(a)]), 0.006)
    glass = disc(0.02, 0.012).turn(0, np.pi / 2).move(0, 0.006, 0.18)
    top = [at_box(0.004, 0.004, 0.024, (0, 0, 0.245)), at_box(0.016, 0.004, 0.004, (0, 0, 0.256))]
    return [(stem, tile), (sun, tile), (join(top), tile),
            (glass, surfaces.gradient((236, 236, 226), (255, 252, 244), look.rng))]  # fmt: skip


@category("icon", size=(0.131, 0.0762, 0.171), mass=0.3, material="metal",
          aliases=("religious icon", "icon of a saint", "saint icon", "holy picture",
          "orthodox icon"), themes=("living",), colors=("gold",))  # fmt: skip
@from_pieces()
def icon(look: Look) -> Pieces:
    """An upright icon leaning on a support, painted with a haloed saint on gold."""
    image = prints.canvas(96, 128, (206, 168, 88))
    robe = look.color("crimson", "navy", "green", "maroon")
    prints.polygon(image, [(0.12, 1), (0.2, 0.62), (0.5, 0.5), (0.8, 0.62), (0.88, 1)], robe)
    prints.disc(image, 0.5, 0.36, 0.24, (236, 206, 120))
    prints.disc(image, 0.5, 0.36, 0.22, (222, 186, 96))
    prints.disc(image, 0.5, 0.37, 0.15, (92, 58, 38))
    prints.disc(image, 0.5, 0.38, 0.115, (214, 168, 126))
    for s in (-1, 1):
        prints.disc(image, 0.5 + 0.055 * s, 0.36, 0.014, (40, 28, 22))
    prints.fill(image, 0.49, 0.37, 0.02, 0.05, (170, 120, 86))
    prints.polygon(image, [(0.4, 0.46), (0.6, 0.46), (0.5, 0.55)], (92, 58, 38))
    frame = wood(look, "brown", "gold", "wooden")
    board = at_box(0.13, 0.016, 0.17).turn(0, -0.18)
    low = float(board.bounds[0, 2])
    board = board.move(z=-low)
    art = at_box(0.11, 0.002, 0.15, (0, -0.0085, 0.01)).turn(0, -0.18).move(z=-low)
    strut = at_box(0.03, 0.006, 0.12).turn(0, 0.35).move(y=0.065)
    strut = strut.move(z=-float(strut.bounds[0, 2]))
    return [(board, frame), (art, image), (strut, frame)]


def _horn(curve: float, r: float, palette: tuple[str, ...]) -> Drawing:
    """Return the drawing function of a curved horn lying flat, wider towards its mouth."""

    def draw(look: Look) -> Pieces:
        color = look.color(*palette)
        path = smooth([(-0.13, -curve, 0.35 * r), (-0.06, 0.1 * curve, 0.5 * r),
                       (0.03, 0.3 * curve, 0.8 * r), (0.12, -0.9 * curve, r)], 8)  # fmt: skip
        radii = np.interp(np.linspace(0, 1, len(path)), [0, 0.4, 1], [0.2 * r, 0.48 * r, r])
        horn = tube(path, radii, 16)
        mouth = tube([path[-1] - 0.0006 * (path[-1] - path[-2]),
             path[-1] + 0.06 * (path[-1] - path[-2])],
                     0.84 * r, 16)  # fmt: skip
        band = tube(path[-6:-4], radii[-5] * 1.06, 16)
        tip = tube(path[:3], radii[:3] * 1.35, 12)
        tile = surfaces.gradient(tuple(0.55 * c for c in color), color, look.rng)  # type: ignore[arg-type]
        gilt = dye(look, "gold", "silver")
        return [(horn, tile), (mouth, surfaces.plain((46, 34, 26))), (band, gilt), (tip, gilt)]

    return draw


@category("prayer_wheel", size=(0.11, 0.08, 0.166), mass=0.3, material="metal",
          aliases=("tibetan prayer wheel", "mani wheel"), themes=("living",),
          colors=("brass",))  # fmt: skip
@from_pieces()
def prayer_wheel(look: Look) -> Pieces:
    """A prayer wheel: an ornate drum with a tip on a turned handle."""
    gold = metal(look, "brass", "gold", "copper")
    base = disc(0.04, 0.014)
    stem = standing((0.008, 0.014), (0.01, 0.05), (0.007, 0.075), sides=14)
    drum = disc(0.036, 0.055, (0, 0, 0.075))
    band = disc(0.0366, 0.03, (0, 0, 0.0875))
    image = prints.canvas(192, 48, (150, 40, 44))
    for k in range(10):
        prints.write(image, "OM", 0.05 + 0.1 * k, 0.5, 0.4, (226, 190, 96), True)
    lid = standing((0.04, 0.13), (0.036, 0.136), (0.012, 0.146), (0.008, 0.156), (0.002, 0.166))
    weight = [ball(0.012, 0.012, 0.012, (0.06, 0, 0.1), 10),
              rod([(0.036, 0, 0.105), (0.055, 0, 0.1)], 0.0012, 6)]  # fmt: skip
    return [(base, wood(look, "brown")), (stem, wood(look, "brown")), (drum, gold), (lid, gold),
            (band, image), (join(weight), gold)]  # fmt: skip


@category("vajra", size=(0.139, 0.0333, 0.0324), mass=0.15, material="metal", aliases=("dorje",),
          themes=("living",), colors=("brass",), state="lying")  # fmt: skip
@from_pieces(foot=0.1)
def vajra(look: Look) -> Pieces:
    """A vajra lying flat: two crowns of bent prongs on a round grip."""
    tile = metal(look, "brass", "bronze", "gold")
    grip = spindle((-0.03, 0.009), (-0.022, 0.0115), (-0.014, 0.008), (-0.008, 0.011), (0, 0.013),
                  (0.008, 0.011), (0.014, 0.008), (0.022, 0.0115), (0.03, 0.009),
             z=0.016)  # fmt: skip
    prongs = []
    for s in (-1, 1):
        for a in np.arange(4) * np.pi / 2 + np.pi / 4:
            y, z = np.cos(a), np.sin(a)
            prongs.append(rod([(s * 0.028, 0.006 * y, 0.016 + 0.006 * z),
                               (s * 0.045, 0.019 * y, 0.016 + 0.019 * z),
                               (s * 0.066, 0.004 * y, 0.016 + 0.004 * z)], [0.004, 0.0035,
             0.0015], 6))  # fmt: skip
        prongs.append(rod([(s * 0.028, 0, 0.016), (s * 0.07, 0, 0.016)], [0.004, 0.001], 8))
    return [(grip, tile), (join(prongs), tile)]


@category("puja_thali", size=(0.2, 0.2, 0.033), mass=0.4, material="metal",
          aliases=("puja plate", "thali", "aarti plate", "puja tray"), themes=("living",),
          roles=("flat",), colors=("brass",))  # fmt: skip
@from_pieces()
def puja_thali(look: Look) -> Pieces:
    """A brass puja plate with an oil lamp, a bell, red powder and petals."""
    tile = metal(look, "brass", "silver", "copper")
    dish = standing((0.085, 0), (0.1, 0.012), (0.098, 0.012), (0.084, 0.004), sides=36)
    pots = [disc(0.018, 0.014, (x, y, 0.003), top=0.021) for x, y in ((-0.04, 0.03), (0.04, 0.03))]
    fill = [disc(0.018, 0.002, (x, y, 0.016)) for x, y in ((-0.04, 0.03), (0.04, 0.03))]
    lamp = disc(0.016, 0.012, (0, -0.04, 0.003), top=0.022)
    flame = ball(0.007, 0.007, 0.018, (0, -0.046, 0.024), 10)
    petals = [ball(0.018, 0.012, 0.006, (0.05 * np.cos(a), -0.02 + 0.03 * np.sin(a), 0.007), 8)
              for a in (0, 0.4, 3.0, 3.5)]  # fmt: skip
    return [(dish, tile), (join([*pots, lamp]), tile), (fill[0], dye(look, "crimson")),
            (fill[1], dye(look, "mustard")), (flame, surfaces.plain((250, 190, 70))),
            (join(petals), dye(look, "orange", "pink"))]  # fmt: skip


@category("ankh", size=(0.05, 0.1, 0.008), mass=0.04, material="metal",
          aliases=("egyptian cross", "key of life"), themes=("living",), roles=("flat",),
          colors=("gold",), state="lying")  # fmt: skip
@from_pieces(foot=0.05)
def ankh(look: Look) -> Pieces:
    """An ankh lying flat: a metal cross with a loop as its upper arm."""
    tile = metal(look, "gold", "silver", "bronze")
    a = np.linspace(-1.2, 2 * np.pi - 1.94, 26)
    ring = tube(
        np.column_stack([0.016 * np.cos(a), 0.032 + 0.022 * np.sin(a), 0 * a + 0.004]), 0.004, 8
    )
    return [(ring, tile), (at_box(0.009, 0.055, 0.007, (0, -0.017, 0)), tile),
            (at_box(0.05, 0.009, 0.007, (0, 0.006, 0)), tile)]  # fmt: skip


@category("pentacle", size=(0.074, 0.074, 0.006), mass=0.04, material="metal",
          aliases=("pentagram", "star in a circle"), themes=("living",), roles=("flat",),
          colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def pentacle(look: Look) -> Pieces:
    """A pentacle lying flat: a five-pointed star in a ring."""
    tile = metal(look, "silver", "gold", "bronze")
    a = np.pi / 2 + np.arange(6) * 4 * np.pi / 5
    star = [rod([(0.032 * np.cos(p), 0.032 * np.sin(p), 0.003),
                 (0.032 * np.cos(q), 0.032 * np.sin(q), 0.003)], 0.0018, 6)
            for p, q in itertools.pairwise(a)]  # fmt: skip
    return [(torus(0.034, 0.003, 40, 8).move(z=0.003), tile), (join(star), tile)]


@category("communion_wafer", size=(0.034, 0.034, 0.0022), mass=0.001, material="food",
          aliases=("wafer host", "sacramental bread"), themes=("living",), roles=("flat", "edible"),
          colors=("ivory",))  # fmt: skip
@from_pieces()
def communion_wafer(look: Look) -> Pieces:
    """A thin, round wafer marked with a cross."""
    color = look.color("ivory", "cream")
    top = surfaces.plain(color).repeat(8, 0).repeat(8, 1)
    dark = tuple(0.9 * c for c in color)
    prints.fill(top, 0.46, 0.2, 0.08, 0.6, dark)  # type: ignore[arg-type]
    prints.fill(top, 0.25, 0.38, 0.5, 0.08, dark)  # type: ignore[arg-type]
    return [(disc(0.017, 0.0022), top)]


@category("reliquary", size=(0.13, 0.08, 0.14), mass=0.7, material="metal",
          aliases=("golden shrine", "relic box", "casket reliquary"), themes=("living",),
          colors=("gold",))  # fmt: skip
@from_pieces()
def reliquary(look: Look) -> Pieces:
    """A reliquary: a golden, house-shaped box with gems and a cross on its roof."""
    gold = metal(look, "gold", "gold", "silver")
    body = at_box(0.12, 0.07, 0.06, (0, 0, 0.012))
    foot = at_block(0.13, 0.08, 0.012, 0.004)
    roof = standing_plate([(-0.04, 0.072), (0.04, 0.072), (0, 0.115)], 0.124).turn(2, np.pi / 2)
    gems = [[ball(0.012, 0.006, 0.014, (x, -0.036, 0.042), 10)] for x in (-0.04, 0, 0.04)]
    top = [at_box(0.005, 0.005, 0.028, (0, 0, 0.112)), at_box(0.018, 0.005, 0.005, (0, 0, 0.126))]
    tones = ("crimson", "blue", "green")
    return [(foot, gold), (body, gold), (roof, gold), (join(top), gold),
            *((g[0], dye(look, t)) for g, t in zip(gems, tones, strict=True))]  # fmt: skip


GILT: RGB = (206, 168, 84)


def _bible_cross(image: prints.Canvas) -> None:
    prints.fill(image, 0.46, 0.22, 0.08, 0.5, GILT)
    prints.fill(image, 0.28, 0.34, 0.44, 0.06, GILT)


def _crescent(image: prints.Canvas) -> None:
    ground = tuple(float(c) for c in image[2, 2])
    prints.disc(image, 0.5, 0.48, 0.26, GILT)
    prints.disc(image, 0.5, 0.48, 0.22, ground)  # type: ignore[arg-type]
    for k in range(8):
        a = np.pi / 4 * k
        x, y = 0.5 + 0.2 * np.cos(a), 0.48 + 0.15 * np.sin(a)
        prints.polygon(image, [(x - 0.04, y), (x, y - 0.035), (x + 0.04, y), (x, y + 0.035)], GILT)
    prints.disc(image, 0.5, 0.48, 0.08, GILT)


def tome(mark: object, *colors: str) -> Drawing:
    """Return the drawing function of a thick book with a golden symbol on its cover, lying flat."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        x, y, h = 0.13, 0.185, 0.038
        front = prints.canvas(96, 136, color)
        prints.fill(front, 0.05, 0.035, 0.9, 0.93, GILT)
        prints.fill(front, 0.065, 0.047, 0.87, 0.906, color)
        mark(front)  # type: ignore[operator]
        skin = surfaces.speckles(look.rng, color, 8, 64)
        edge = surfaces.plain(look.own_color("gold", "cream", "cream"))
        boards = [at_box(x, y, 0.0025, (0, 0, z)) for z in (0, h - 0.0025)]
        spine = at_block(0.006, y, h, 0.002, (-x / 2, 0, 0))
        leaves = at_box(x - 0.006, y - 0.006, h - 0.004, (-0.001, 0, 0.002))
        top = at_box(0.99 * x, 0.99 * y, 0.0004, (0, 0, h - 0.0002))
        ribbon = at_box(0.005, 0.03, 0.0006, (0.01, -y / 2 - 0.013, 0.012))
        return [(join([*boards, spine]), skin), (leaves, edge), (top, front),
                (ribbon, dye(look, "crimson", "gold"))]  # fmt: skip

    return draw


@category("torah_scroll", size=(0.34, 0.1, 0.0525), mass=1.2, material="wood",
          aliases=("torah", "torah roll", "sefer torah"), themes=("living",), roles=("big",),
          colors=("navy",), state="lying")  # fmt: skip
@from_pieces()
def torah_scroll(look: Look) -> Pieces:
    """A scroll in an embroidered mantle lying flat, with wooden rollers at both ends."""
    velvet = look.color("navy", "crimson", "cream")
    stick = wood(look, "brown", "wooden")
    coat = at_block(0.24, 0.1, 0.052, 0.03)
    front = prints.canvas(96, 64, velvet)
    prints.fill(front, 0.04, 0.05, 0.92, 0.06, GILT)
    prints.fill(front, 0.04, 0.89, 0.92, 0.06, GILT)
    for turn in (0.0, np.pi):
        a = turn + np.pi / 2 + np.arange(3) * 2 * np.pi / 3
        points = [(0.5 + 0.15 * np.cos(t), 0.5 - 0.23 * np.sin(t)) for t in a]
        prints.stroke(front, [*points, points[0]], 0.03, GILT)
    top = at_box(0.2, 0.08, 0.0008, (0, 0, 0.0516))
    rolls = [spindle((-0.17, 0.01), (-0.15, 0.012), (-0.149, 0.006), (0.149, 0.006), (0.15, 0.012),
                    (0.17, 0.01), z=0.026).move(y=y) for y in (-0.026, 0.026)]  # fmt: skip
    discs = [spindle((x, 0.022), (x + 0.006, 0.022), z=0.0265).move(y=y)
             for x in (-0.14, 0.134) for y in (-0.026, 0.026)]  # fmt: skip
    return [(coat, surfaces.speckles(look.rng, velvet, 9)), (top, front),
            (join(rolls), stick), (join(discs), stick)]  # fmt: skip


@category("kippah", size=(0.16, 0.16, 0.058), mass=0.03, material="fabric", hollow=True,
          aliases=("yarmulke", "skullcap", "kippa"), themes=("living",),
          colors=("black", "navy"))  # fmt: skip
@from_pieces(bodies=2)
def kippah(look: Look) -> Pieces:
    """A kippah lying with its dome up."""
    color = look.color("black", "navy", "white", "blue", "maroon")
    rim = disc(0.08, 0.009, top=0.078, sides=32)
    dome = ball(0.156, 0.156, 0.11, (0, 0, 0.003), 28)
    band = surfaces.stripes([color, (232, 226, 214), color], 1)
    return [(rim, band), (dome, surfaces.fabric(look.rng, color))]


@category("mezuzah", size=(0.12, 0.02, 0.0125), mass=0.06, material="metal",
          aliases=("mezuzah case",), themes=("living",), roles=("flat",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.05)
def mezuzah(look: Look) -> Pieces:
    """A mezuzah lying flat: a slender case with a letter on its front."""
    tile = metal(look, "silver", "brass", "bronze")
    body = at_block(0.1, 0.02, 0.012, 0.006)
    ends = [ball(0.016, 0.018, 0.011, (x, 0, 0.006), 12) for x in (-0.052, 0.052)]
    mark = [at_box(0.012, 0.002, 0.0012, (0, y, 0.0117)) for y in (-0.005, 0, 0.005)]
    foot = at_box(0.002, 0.012, 0.0012, (0.006, 0, 0.0117))
    return [(join([body, *ends]), tile), (join([*mark, foot]), dye(look, "gold"))]


@category("yad", size=(0.213, 0.0267, 0.0163), mass=0.06, material="metal",
          aliases=("torah pointer",), themes=("living",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.1)
def yad(look: Look) -> Pieces:
    """A silver Torah pointer that ends in a small hand, with a chain at its head."""
    tile = metal(look, "silver", "silver", "gold")
    body = spindle((-0.09, 0.004), (-0.085, 0.008), (-0.078, 0.004), (-0.05, 0.0045), (-0.045,
             0.007),
                  (-0.04, 0.0045), (0.02, 0.0035), (0.024, 0.0055), (0.028, 0.0035),
                  (0.068, 0.0028), z=0.008)  # fmt: skip
    hand = at_block(0.014, 0.008, 0.004, 0.002, (0.074, 0, 0.006))
    finger = at_block(0.014, 0.0025, 0.003, 0.001, (0.087, 0.002, 0.0065))
    a = np.linspace(0, 2 * np.pi, 24)[:-1]
    chain = tube(np.column_stack([-0.1 - 0.014 * np.cos(a), 0.012 * np.sin(a), 0 * a + 0.0016]),
                 0.0014, 5, loop=True)  # fmt: skip
    return [(join([body, hand, finger]), tile), (chain, tile)]


@category("tefillin", size=(0.097, 0.069, 0.038), mass=0.08, material="leather",
          aliases=("phylactery",), themes=("living",), colors=("black",))  # fmt: skip
@from_pieces()
def tefillin(look: Look) -> Pieces:
    """A phylactery: a black leather cube on a base, with its strap coiled beside it."""
    black = surfaces.speckles(look.rng, look.color("black", "charcoal"), 6)
    base, top = at_box(0.045, 0.06, 0.008), at_box(0.032, 0.032, 0.03, (0, 0.006, 0.008))
    path = [(0.02, -0.02, 0.004), (0.05, -0.035, 0.004), (0.07, 0, 0.004), (0.05, 0.03, 0.004),
            (0.034, 0.01, 0.004), (0.05, -0.012, 0.004), (0.058, 0.005, 0.004)]  # fmt: skip
    return [(base, black), (top, black), (tube(smooth(path, 6), 0.004, 6, squash=0.4), black)]


@category("prayer_flags", size=(0.396, 0.0904, 0.00298), mass=0.02, material="fabric",
          assembled=True,
          aliases=("prayer flag", "string of prayer flags", "tibetan flags", "pennant garland"),
          themes=("living",), roles=("flat", "big"), colors=("blue",), state="lying")  # fmt: skip
@vary(0.2)
@from_pieces()
def prayer_flags(look: Look) -> Pieces:
    """Five small flags on a cord, lying in a row."""
    cord = rod([(-0.2, 0.05, 0.002), (0, 0.062, 0.002), (0.2, 0.05, 0.002)], 0.0014, 6, 8)
    pieces: Pieces = [(cord, surfaces.plain((236, 230, 214)))]
    for k, word in enumerate(("blue", "white", "red", "green", "yellow")):
        color = look.own_color(word)
        image = prints.canvas(48, 48, color)
        prints.lines(image, look.rng, (0.15, 0.15, 0.7, 0.7), 7, (60, 56, 60), 0.3)
        pieces.append((at_box(0.068, 0.08, 0.0012, (-0.152 + 0.076 * k, 0.012, 0.0002)), image))
    return pieces


@category("palm_cross", size=(0.075, 0.13, 0.0065), mass=0.004, material="paper",
          aliases=("cross of palm leaf",), themes=("living",), roles=("flat",), colors=("sage",),
          state="lying")  # fmt: skip
@from_pieces()
def palm_cross(look: Look) -> Pieces:
    """A cross of two palm leaf strips lying flat, with a square knot where they meet."""
    color = look.color("sage", "olive", "mustard")
    tile = surfaces.scratches(look.rng, color, tuple(0.8 * c for c in color))  # type: ignore[arg-type]
    return [(at_box(0.012, 0.13, 0.003), tile), (at_box(0.075, 0.012, 0.003, (0, 0.025, 0.002)),
             tile), (hull_solid([(x, y, z) for x in (-0.009, 0.009) for y in (0.019, 0.037)
                              for z in (0, 0.0065)]), tile)]  # fmt: skip


@category("prayer_shawl", size=(0.24, 0.205, 0.031), mass=0.3, material="fabric",
          aliases=("tallit", "tallis", "folded tallit"), themes=("living",),
          colors=("white",))  # fmt: skip
@vary()
@from_pieces()
def prayer_shawl(look: Look) -> Pieces:
    """A folded pale shawl with dark blue stripes, and tassels at its front corners."""
    color = look.color("white", "ivory", "cream")
    stripe = surfaces.stripes([color, color, (40, 52, 104), color, (40, 52, 104), color, color], 2,
                              upright=True)  # fmt: skip
    body = [at_block(0.24 - 0.006 * k, 0.17, 0.011, 0.012, (0, 0, 0.01 * k)) for k in range(3)]
    knots = [at_box(0.003, 0.035, 0.002, (x, -0.1, 0.0)) for x in (-0.11, -0.104, 0.104, 0.11)]
    return [(join(body), stripe), (join(knots), cloth(look, "white", "ivory"))]


@category("paten", size=(0.17, 0.17, 0.012), mass=0.2, material="metal", hollow=True,
          aliases=("communion plate", "gold plate", "golden plate", "golden dish",
          "offering plate"), themes=("living",), roles=("container", "flat"),
          colors=("gold",))  # fmt: skip
def paten(look: Look) -> Shape:
    """A paten: a shallow metal dish with a rim, for communion wafers."""
    tile = metal(look, "gold", "gold", "silver")
    side = [(0.05, 0.0), (0.07, 0.006), (0.085, 0.012)]
    body, parts = open_vessel(side, 0.0025, 0.003)
    return shape([(body, tile)], parts).scale(look.between(0.9, 1.1))


FLAME = surfaces.gradient((250, 160, 40), (255, 236, 140), np.random.default_rng(0), 2)


def branch(look: Look, arms: int, candles: bool) -> Shape:
    """Return a stand with ``arms`` candle holders in a row, with the middle one on the stem."""
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
        pieces += [(join(sticks), surfaces.plain(look.own_color("white", "cream", "red", "blue"))),
                   (join(flames), FLAME)]  # fmt: skip
        return put_down(
            pieces, foot, join(solids[1:]), join(sticks), factor=look.between(0.9, 1.15)
        )
    return put_down(pieces, foot, join(solids[1:]), factor=look.between(0.9, 1.15))


@category("menorah", size=(0.25, 0.108, 0.22), mass=0.7, material="metal", assembled=True,
          aliases=("hanukkah menorah", "hanukkiah", "hanukkah candelabra"), themes=("living",),
          roles=("tall",), colors=("gold", "silver"), opened="empty_candelabra")  # fmt: skip
def menorah(look: Look) -> Shape:
    """A menorah with nine candles."""
    return branch(look, 9, True)


@category("dreidel", size=(0.0808, 0.0341, 0.0337), mass=0.02, material="wood",
          aliases=("wooden dreidel", "hanukkah top"), themes=("living",), colors=("wooden", "blue"),
          state="lying")  # fmt: skip
def dreidel(look: Look) -> Shape:
    """A dreidel leaning on its side: a square spinning top with a letter on each face."""
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


def _hexagram() -> list[Solid]:
    a = np.pi / 2 + np.arange(3) * 2 * np.pi / 3
    made = []
    for turn in (0, np.pi):
        corners = 0.034 * np.column_stack([np.cos(a + turn), np.sin(a + turn)])
        for k in range(3):
            p, q = corners[k], corners[(k + 1) % 3]
            made.append(straight((*p, 0.004), (*q, 0.004), 0.004, 8))
    return made


CATEGORIES = (
    Category("cross", from_pieces()(_cross(False, True)), size=(0.11, 0.06, 0.215), mass=0.3,
             material="wood", assembled=True, aliases=("wooden cross", "standing cross",
             "altar cross", "metal cross", "christian cross", "gold cross"), themes=("living",),
             roles=("tall",), colors=("brown", "gold")),
    Category("crucifix", from_pieces(bodies=4)(_cross(True, True)), size=(0.11, 0.06, 0.215),
             mass=0.35, material="wood", assembled=True,
             aliases=("standing crucifix", "cross with jesus"), themes=("living",), roles=("tall",),
             colors=("brown",)),
    Category("rosary", from_pieces(foot=0.1)(_beads(True)), size=(0.159, 0.195, 0.00836), mass=0.03,
             material="wood", assembled=True, aliases=("rosary beads", "rosary with a cross"),
             themes=("living",), roles=("flat",), colors=("brown", "black"), state="lying"),
    Category("prayer_beads", from_pieces(foot=0.1)(_beads(False)), size=(0.157, 0.189, 0.0103),
             mass=0.035, material="wood", assembled=True, aliases=("mala", "tasbih", "mala beads",
             "misbaha", "mala necklace", "prayer bead", "buddhist beads"), themes=("living",),
             roles=("flat",), colors=("brown",), state="lying"),
    Category("chalice", _cup(False), size=(0.092, 0.092, 0.163), mass=0.3, material="metal",
             hollow=True, aliases=("communion cup", "kiddush cup", "golden goblet", "metal goblet",
             "silver goblet", "golden cup", "holy grail", "grail"), themes=("living",),
             roles=("container", "tall"), colors=("gold", "silver")),
    Category("ciborium", _cup(True), size=(0.092, 0.092, 0.22), mass=0.4, material="metal",
             aliases=("covered chalice", "lidded goblet"), themes=("living",), roles=("tall",),
             colors=("gold",)),
    Category("shofar",
             from_pieces(foot=0.1, bodies=1)(_horn(0.04, 0.022, ("beige", "brown", "tan"))),
             size=(0.26, 0.085, 0.042), mass=0.25, material="metal", aliases=("ram horn",
             "drinking horn", "viking horn", "war horn", "blowing horn", "hunting horn",
             "animal horn"), themes=("living",), colors=("beige", "brown"), state="lying"),
    Category("bible", from_pieces(bodies=2)(tome(_bible_cross, "black", "maroon", "brown", "navy")),
             size=(0.138, 0.221, 0.0397), mass=0.6, material="paper", aliases=("holy bible",
             "missal", "prayer book", "holy book", "psalter", "new testament"), themes=("living",),
             roles=("flat", "support"), colors=("black",), state="lying flat"),
    Category("quran", from_pieces(bodies=2)(tome(_crescent, "green", "teal", "navy", "maroon")),
             size=(0.134, 0.215, 0.0386), mass=0.6, material="paper", aliases=("koran",),
             themes=("living",), roles=("flat", "support"), colors=("green",), state="lying flat"),
    Category("hexagram", from_pieces(foot=0.1)(body(_hexagram)), size=(0.0649, 0.071, 0.00789),
             mass=0.03, material="metal", aliases=("star of david", "six pointed star"),
             themes=("living",), roles=("flat",), colors=("gold", "blue")),
    Category("sage_bundle", bundle(("sage", "gray", "sage"), 1.5), size=(0.148, 0.046, 0.0279),
             mass=0.03, material="food", assembled=True,
             aliases=("smudge stick", "bundle of sage", "white sage bundle", "sage stick"),
             themes=("living",), colors=("sage",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
