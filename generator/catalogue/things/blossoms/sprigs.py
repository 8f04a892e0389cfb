"""Sprigs, petals and single blooms without a stem."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part
from ...build.forms import blade
from ...build.outlines import ellipse, smooth
from ...build.recipes import Pieces, ball, put_down, rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, join, prism, refine
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..nature.flowers import corolla
from .heads import GREEN, layered_head


def lotus(look: Look) -> Shape:
    """An open water lily on its round leaf."""
    k = look.between(0.9, 1.15)
    color = look.color("pink", "white", "pink", "lavender")
    leaf = cylinder(0.062, 0.004, 26)
    head = layered_head([(11, 0.05, 0.019, 0.22, 0), (9, 0.044, 0.018, 0.6, 0.002),
                    (7, 0.036, 0.015, 1.0, 0.004)], 0.009, fade=-0.05)(look, color)  # fmt: skip
    bloom = [(s.move(z=0.008), t) for s, t in head]
    pieces: Pieces = [(leaf, textures.leaf(look.rng, (70, 120, 66))), *bloom]
    return put_down(pieces, leaf, join([s for s, _ in bloom]), factor=k)


def petal(look: Look) -> Shape:
    """One fallen petal, slightly cupped."""
    k = look.between(0.85, 1.2)
    color = look.color("red", "pink", "white", "crimson", "yellow")
    ring = [(-0.022, 0), (-0.012, -0.012), (0.006, -0.018), (0.02, -0.011), (0.0195, 0),
            (0.02, 0.011), (0.006, 0.018), (-0.012, 0.012), (-0.022, 0)]  # fmt: skip
    flat = refine(refine(prism(smooth(ring, 3)[:-1], 0, 0.0011)))
    one = flat.bend(
        lambda p: p + np.column_stack([0 * p[:, :2], 14 * (p[:, 0] ** 2 + p[:, 1] ** 2)])
    )
    return put_down([(one, textures.speckles(look.rng, color, 9))], factor=k)


def holly(look: Look) -> Shape:
    """A sprig of holly: prickly leaves and red berries."""
    k = look.between(0.9, 1.15)
    side = [(0, 0.0), (0.1, 0.14), (0.22, 0.1), (0.36, 0.22), (0.5, 0.12), (0.64, 0.2), (0.8, 0.08)]
    edge = [*[(x, -y) for x, y in side], (1.0, 0.0), *side[:0:-1]]
    leaf = prism(np.array(edge) * 0.062, 0, 0.0022)
    spiny = [leaf.turn(1, -0.12).turn(2, a).move(0.006 * np.cos(a), 0.006 * np.sin(a), 0.001)
             for a in (0.35, 2.75, -1.6, -2.9)]  # fmt: skip
    stick = rod([(0, 0, 0.002), (0.004, 0.03, 0.003), (0.0, 0.065, 0.0022)], 0.0021, 6)
    red = [ball(0.0115, 0.0115, 0.0115, (x, y, 0.006), 10)
           for x, y in ((0.004, -0.001), (-0.008, 0.004), (-0.002, -0.011))]  # fmt: skip
    green = textures.leaf(look.rng, look.color("green", "teal", "green"))
    return put_down([(join(spiny), tint(green)), (stick, textures.plain((104, 82, 56))),
                     (join(red), textures.plain((204, 30, 36)))], factor=k)  # fmt: skip


def tint(tile: textures.Tile) -> textures.Tile:
    """Return a darker tile."""
    return (tile * 0.72).astype(np.uint8)


def frond(look: Look) -> Shape:
    """A fern frond or palm frond lying flat: leaflets on both sides of a rib."""
    k = look.between(0.85, 1.15)
    color = look.color("green", "green", "lime", "olive")
    long = 0.26
    leaflets = []
    for n in range(20):
        t = (n + 1) / 21
        reach = 0.06 * np.sin(np.pi * (0.12 + 0.88 * t)) ** 0.8 + 0.006
        for s in (-1, 1):
            x = long * (t - 0.5)
            leaflets.append(blade([(x, 0, 0.002), (x + 0.3 * reach, s * 0.55 * reach, 0.004),
                                   (x + 0.45 * reach, s * reach, 0.0018)], 0.0125, thick=0.12,
                                  sides=4))  # fmt: skip
    rib = rod([(-0.58 * long, 0, 0.002), (0, 0, 0.0026), (0.53 * long, 0, 0.002)], 0.0018, 6)
    body = join([*leaflets, rib])
    return put_down([(body, textures.speckles(look.rng, color, 10))], factor=k)


def blossom_branch(look: Look) -> Shape:
    """A twig with pink blossoms along it."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "pink", "white", "coral")
    sticks = [rod([(-0.13, 0, 0.003), (-0.03, 0.012, 0.008), (0.06, -0.004, 0.006),
                   (0.14, 0.01, 0.003)], [0.0034, 0.003, 0.002, 0.0012], 7),
              rod([(-0.03, 0.012, 0.007), (0.02, 0.045, 0.006), (0.06, 0.055, 0.004)],
                  [0.002, 0.001], 6),
              rod([(0.02, 0.0, 0.007), (0.06, -0.035, 0.005)], [0.0018, 0.001], 6, 2)]  # fmt: skip
    blooms: list[Solid] = []
    hearts = []
    spots = [
        (-0.06, 0.014),
        (-0.02, 0.004),
        (0.01, 0.042),
        (0.045, 0.056),
        (0.03, -0.008),
        (0.06, -0.036),
        (0.085, 0.006),
        (0.12, 0.004),
        (0.065, 0.044),
        (0.1, 0.014),
    ]
    for n, (x, y) in enumerate(spots):
        ring = corolla(5, 0.013, 0.012, 0.3, n)
        blooms += [p.turn(0, 0.3 * (-1) ** n).move(x, y, 0.011) for p in ring]
        hearts.append(ball(0.005, 0.005, 0.004, (x, y, 0.0135), 6))
    return put_down([(join(sticks), textures.speckles(look.rng, (96, 70, 54), 10)),
                     (join(blooms), textures.speckles(look.rng, color, 6)),
                     (join(hearts), textures.plain((214, 80, 100)))], factor=k)  # fmt: skip


def corsage(look: Look) -> Shape:
    """A small spray to pin on: a bloom, leaves, a ribbon bow."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "pink", "red", "lavender")
    head = layered_head([(8, 0.024, 0.02, 0.2, 0), (7, 0.02, 0.017, 0.6, 0.002),
                    (5, 0.014, 0.012, 1.0, 0.004)], 0.005, None, 0.05)(look, color)  # fmt: skip
    leaves = [blade([(0, 0, 0.002), (0.02 * np.cos(a), 0.02 * np.sin(a), 0.006),
                     (0.046 * np.cos(a), 0.046 * np.sin(a), 0.002)], 0.02, thick=0.15)
              for a in (0.4, 1.3, 2.4)]  # fmt: skip
    bow = [blade([(0, -0.01, 0.004), (s * 0.02, -0.03, 0.009), (s * 0.03, -0.05, 0.002)], 0.016,
                 thick=0.25) for s in (-1, 1)]  # fmt: skip
    bloom = [(s.move(z=0.006), t) for s, t in head]
    sheen = textures.plain(look.own_color("white", "pink", "silver", "gold"))
    pieces: Pieces = [(join(leaves), textures.plain(GREEN)), (join(bow), sheen), *bloom]
    return put_down(pieces, join([*leaves, *bow]), join([s for s, _ in bloom]), factor=k)


def pressed_flower(look: Look) -> Shape:
    """A card with a pressed flower on it, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color("purple", "pink", "yellow", "blue", "red")
    image = prints.canvas(112, 160, (246, 240, 224))
    prints.stroke(image, [(0.5, 0.9), (0.47, 0.65), (0.5, 0.36)], 0.02, (96, 120, 70))
    for s in (-1, 1):
        prints.polygon(image, [(0.48, 0.68), (0.48 + s * 0.2, 0.56), (0.48 + s * 0.24, 0.62),
                               (0.48 + s * 0.12, 0.7)], (112, 134, 80))  # fmt: skip
    for a in np.linspace(0, 2 * np.pi, 8)[:-1]:
        ring = ellipse(0.16, 0.26, 12) @ np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
        away = 0.16 * np.array([np.sin(a), np.cos(a)])
        points = [(0.5 + 1.2 * (x + away[0]), 0.33 + 0.8 * (y + away[1])) for x, y in ring * 0.7]
        prints.polygon(image, points, tint_color(color, look.between(0.8, 1.1)))
    prints.disc(image, 0.5, 0.33, 0.04, (222, 176, 60))
    x, y = 0.09 * k, 0.128 * k
    face = box(0.99 * x, 0.99 * y, 0.0004).move(z=0.0012)
    card = box(x, y, 0.0014)
    return shape([(card, textures.plain((240, 232, 212))), (face, image)],
                 [box_part(x, y, 0.0014)])  # fmt: skip


def sprout(look: Look) -> Shape:
    """A sprig of mistletoe: paired leaves and white berries, tied with a ribbon."""
    k = look.between(0.9, 1.1)
    color = look.color("olive", "green", "lime")
    leaves, stems, berries = [], [], []
    for n, a in enumerate((-0.7, 0.0, 0.7)):
        way = np.array([np.sin(a), -np.cos(a)])
        tip = 0.05 * way
        stems.append(rod([(0, 0.03, 0.003), (0, 0, 0.004), (*tip, 0.004)], 0.0016, 6))
        for s in (-1, 1):
            end = tip + 0.045 * np.array([np.sin(a + 0.5 * s), -np.cos(a + 0.5 * s)])
            leaves.append(
                blade(
                    [(*tip, 0.004), (*(0.5 * (tip + end)), 0.007), (*end, 0.002)], 0.016, thick=0.2
                )
            )
        berries += [ball(0.009, 0.009, 0.009, (tip[0] + 0.005 * s, tip[1] + 0.003 * n, 0.008), 8)
                    for s in (-1, 1)]  # fmt: skip
    knot = ball(0.016, 0.01, 0.01, (0, 0.012, 0.005), 10)
    body = join([*leaves, *stems])
    return put_down(
        [
            (body, textures.plain(color)),
            (join(berries), textures.plain((246, 246, 238))),
            (knot, textures.plain((196, 36, 40))),
        ],
        body,
        factor=k,
        foot=0.3,
    )


_L = ("living",)
CATEGORIES = (
    Category("lotus", lotus, (0.13, 0.131, 0.0446), 0.04, ("lotus flower", "water lily",
             "waterlily", "lotus blossom", "water lily flower"), _L, ("round",), ("pink",)),
    Category("petal", keep_still(petal), (0.0459, 0.0386, 0.00899), 0.001, ("rose petal",
             "flower petal",
             "petal of a rose"), _L, (), ("red", "pink"), state="lying flat"),
    Category("holly", keep_still(holly), (0.129, 0.133, 0.0116), 0.01, ("holly sprig",
             "sprig of holly",
             "holly leaf", "holly branch"), _L, (), ("green",), state="lying flat"),
    Category("mistletoe", sprout, (0.147, 0.119, 0.0124), 0.01, ("sprig of mistletoe",
             "mistletoe sprig"), _L, (), ("green",), state="lying flat"),
    Category("fern_frond", frond, (0.287, 0.131, 0.00411), 0.008, ("frond", "fern leaf",
             "palm frond", "palm leaf"), _L, (), ("green",), state="lying flat"),
    Category("blossom_branch", blossom_branch, (0.269, 0.114, 0.0182), 0.02,
             ("cherry blossom branch", "cherry blossom", "branch of cherry blossom", "blossom",
             "apple blossom", "blossom twig", "cherry blossom twig"), _L, (), ("pink",),
             state="lying flat"),
    Category("corsage", corsage, (0.077, 0.095, 0.0206), 0.015, ("buttonhole flower",
             "wrist corsage"), _L, (), ("white", "pink"), state="lying flat"),
    Category("pressed_flower", pressed_flower, (0.0869, 0.124, 0.0016), 0.006, ("flower pressing",
             "herbarium sheet"), _L, ("flat",), ("purple",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
