"""Altar things: crosses, cups, censers, beads, icons, wheels and horns."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    of,
    shine,
    standing,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, open_vessel, rod, standing_plate
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look


def _cross(figure: bool, stepped: bool) -> Drawing:
    """A standing cross on a base, with a figure on it or without."""

    def draw(look: Look) -> Pieces:
        tile = look.surface(look.color("brown", "gold", "wooden", "silver"), look.pick(
            ["wood", "metal"] if not figure else ["wood"]))  # fmt: skip
        post = at_box(0.018, 0.012, 0.2, (0, 0, 0.015))
        bar = at_box(0.11, 0.012, 0.018, (0, 0, 0.14))
        base = [
            at_block(0.09, 0.06, 0.012, 0.004),
            at_block(0.06, 0.04, 0.01, 0.003, (0, 0, 0.012)),
        ]
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
    """A loop of beads lying, with a cross or a tassel."""

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
        """A metal cup on a stem with a knob; with ``lid`` covered and a cross on top."""
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
        knob = [
            at_box(0.004, 0.004, 0.028, (0, 0, 0.028)),
            at_box(0.018, 0.004, 0.004, (0, 0, 0.043)),
        ]
        cap = [s.move(z=0.163) for s in (top, *knob)]
        full = standing((0.012, 0.088), (0.036, 0.11), (0.044, 0.163))
        return shape([*pieces, (join(cap), tile)],
                     [hull_of(stem), hull_of(full), hull_of(cap[0]),
             hull_of(*cap[1:])]).scale(k)  # fmt: skip

    return make


def _censer(look: Look) -> Pieces:
    """A censer: a footed bowl with a pierced lid, its chains laid round it."""
    tile = metal(look, "gold", "brass", "silver")
    bowl = standing((0.028, 0), (0.03, 0.006), (0.016, 0.014), (0.042, 0.035), (0.046, 0.055))
    lid = standing((0.046, 0.056), (0.038, 0.075), (0.018, 0.092), (0.014, 0.1), (0.004, 0.112))
    dark = textures.plain((30, 26, 24))
    holes = [ball(0.008, 0.008, 0.012, (0.038 * np.cos(a), 0.038 * np.sin(a), 0.071), 8)
             for a in np.arange(8) * np.pi / 4]  # fmt: skip
    chains = [tube(smooth([(0.03 * np.cos(a), 0.03 * np.sin(a), 0.058),
                           (0.055 * np.cos(a), 0.055 * np.sin(a), 0.03),
                           (0.085 * np.cos(a), 0.085 * np.sin(a), 0.0022),
                           (0.1 * np.cos(a + 0.8), 0.1 * np.sin(a + 0.8), 0.0022)], 6), 0.0018, 6)
              for a in (-2.2, -1.2, -0.4)]  # fmt: skip
    return [(bowl, tile), (lid, tile), (join(holes), dark), (join(chains), tile)]


def _monstrance(look: Look) -> Pieces:
    """A golden sun with a glass middle on a stem."""
    tile = metal(look, "gold", "gold", "silver")
    stem = standing((0.05, 0), (0.05, 0.008), (0.02, 0.02), (0.008, 0.04), (0.016, 0.06),
                    (0.008, 0.075), (0.006, 0.12))  # fmt: skip
    a = np.pi / 2 + np.arange(48) * 2 * np.pi / 48
    r = np.where(np.arange(48) % 2, 0.034, np.where(np.arange(48) % 4, 0.07, 0.058))
    sun = standing_plate(np.column_stack([r * np.cos(a), 0.18 + r * np.sin(a)]), 0.006)
    glass = disc(0.02, 0.012).turn(0, np.pi / 2).move(0, 0.006, 0.18)
    top = [at_box(0.004, 0.004, 0.024, (0, 0, 0.245)), at_box(0.016, 0.004, 0.004, (0, 0, 0.256))]
    return [(stem, tile), (sun, tile), (join(top), tile),
            (glass, textures.gradient((236, 236, 226), (255, 252, 244), look.rng))]  # fmt: skip


def _icon(look: Look) -> Pieces:
    """A painted icon standing: a saint with a halo on gold, leaning on a foot."""
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


CATEGORIES = (
    Category("cross", of(_cross(False, True)), (0.11, 0.06, 0.215), 0.3, ("wooden cross",
             "standing cross", "altar cross", "metal cross", "christian cross", "gold cross"),
             ("living",), ("tall",), ("brown", "gold")),
    Category("crucifix", of(_cross(True, True), bodies=4), (0.11, 0.06, 0.215), 0.35,
             ("standing crucifix", "cross with jesus"), ("living",), ("tall",), ("brown",)),
    Category("rosary", of(_beads(True), 0.1), (0.159, 0.195, 0.00836), 0.03, ("rosary beads",
             "rosary with a cross"), ("living",), ("flat",), ("brown", "black"), state="lying"),
    Category("prayer_beads", of(_beads(False), 0.1), (0.157, 0.189, 0.0103), 0.035, ("mala",
             "tasbih", "mala beads", "misbaha", "mala necklace", "prayer bead",
             "buddhist beads"), ("living",), ("flat",), ("brown",), state="lying"),
    Category("chalice", _cup(False), (0.092, 0.092, 0.163), 0.3, ("communion cup", "kiddush cup",
             "golden goblet", "metal goblet", "silver goblet", "golden cup", "holy grail", "grail"),
             ("living",), ("container", "tall"), ("gold", "silver")),
    Category("ciborium", _cup(True), (0.092, 0.092, 0.22), 0.4, ("covered chalice",
             "lidded goblet"), ("living",), ("tall",), ("gold",)),
    Category("thurible", of(_censer, 0.02), (0.143, 0.142, 0.109), 0.5, ("censer", "incense censer",
             "swinging censer"), ("living",), (), ("brass",)),
    Category("monstrance", of(_monstrance), (0.14, 0.1, 0.27), 0.8, ("sunburst monstrance",),
             ("living",), ("tall",), ("gold",)),
    Category("icon", of(_icon), (0.131, 0.0762, 0.171), 0.3, ("religious icon", "icon of a saint",
             "saint icon", "holy picture", "orthodox icon"), ("living",), (), ("gold",)),
)  # fmt: skip
"""The module's categories."""
