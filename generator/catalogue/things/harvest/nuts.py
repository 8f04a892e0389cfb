"""Nuts, beans, peas, olives and pickles by the piece."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import streaks
from ...build.settled import limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, join, lathe, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..food.food import skin


def pea_pod(look: Look) -> Shape:
    """An open pod of peas lying."""
    long = look.between(0.075, 0.092)
    color = look.color("green", "lime", "green")
    half = rod(long, 0.0085, blunt=3, bend=0.008, squash=0.8)
    low = half.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0.001)]))
    rim = limb([(-0.5 * long, 0.004, 0.001), (0, -0.0125, 0.002), (0.5 * long, 0.004, 0.001)],
               [0.0008, 0.0012, 0.0008], 6)  # fmt: skip
    peas = [ellipsoid(d := 0.0125 - 0.012 * abs(u), d, d, 14, 8).move(
            u * long, 0.032 * u * u - 0.004, 0.0035)
            for u in (-0.3, -0.15, 0.0, 0.15, 0.3)]  # fmt: skip
    stalk = limb([(0.48 * long, 0.004, 0), (0.58 * long, 0.006, 0.002), (0.64 * long, 0.01, 0.004)],
                 [0.0025, 0.0016, 0.0016], 7)  # fmt: skip
    return settle(
        [
            (join([low, rim, stalk]), textures.speckles(look.rng, tint_color(color, 0.85), 8)),
            (join(peas), textures.plain(tint_color(color, 1.25))),
        ],
        0.1,
    )


def green_bean(look: Look) -> Shape:
    """A long green bean lying, a little bent."""
    long, r = look.between(0.11, 0.14), look.between(0.0042, 0.0052)
    color = look.color("green", "green", "lime", "yellow")
    bend = look.between(0.01, 0.024)
    u = np.linspace(-0.5, 0.5, 9)
    body = limb(
        np.column_stack([u * long, 4 * bend * u * u, 0 * u]),
        [0.0007, 0.8 * r, r, 0.92 * r, r, 0.92 * r, r, 0.75 * r, 0.0012],
        12,
    )
    return settle([(body, textures.speckles(look.rng, tint_color(color, 0.92), 12))], 0.2)


def bean(look: Look) -> Shape:
    """A kidney bean lying on its side."""
    long, r = look.between(0.015, 0.019), look.between(0.0042, 0.0052)
    color = look.color("maroon", "brown", "white", "black", "tan")
    body = rod(long, r, blunt=2.6, bend=0.32 * r * 2, squash=0.85)
    return settle([(body, textures.speckles(look.rng, color, 8))], 0.15)


def pea(look: Look) -> Shape:
    """A single green pea or chickpea."""
    d = look.between(0.008, 0.0105)
    color = look.color("green", "lime", "green")
    return settle(
        [(ellipsoid(d, d, 0.96 * d, 16, 10), textures.speckles(look.rng, color, 8))], 0.13
    )


def walnut(look: Look) -> Shape:
    """A walnut in its wrinkled shell, its seam upright."""
    d = look.between(0.034, 0.04)
    color = look.color("tan", "wooden", "beige")
    phase = look.rng.uniform(0, 6, 2)

    def warp(p: np.ndarray) -> np.ndarray:
        wave = 0.03 * np.sin(p @ np.array([420, 300, 360]) + phase[0])
        wave = wave + 0.03 * np.sin(p @ np.array([-350, 420, 260]) + phase[1])
        seam = 0.07 * np.exp(-((p[:, 1] / (0.06 * d)) ** 2))
        return p * (1 + wave + seam)[:, None]

    body = ellipsoid(1.1 * d, d, d, 34, 22).bend(warp)
    shell = textures.spots(look.rng, color, tint_color(color, 0.72), 0.25)
    return settle([(body, shell)], 0.12)


def almond(look: Look) -> Shape:
    """An almond lying flat, pointed to the left."""
    long = look.between(0.023, 0.028)
    color = look.color("copper", "brown", "bronze")
    body = limb(
        [
            (-0.5 * long, 0, 0),
            (-0.2 * long, 0, 0),
            (0.15 * long, 0, 0),
            (0.42 * long, 0, 0),
            (0.5 * long, 0, 0),
        ],
        [0.0004, 0.005, 0.0072, 0.005, 0.001],
        16,
        0.6,
    )
    return settle([(body, textures.stripes([tint_color(color, 0.9), tint_color(color, 0.72)], 9,
                                           upright=True))], 0.15)  # fmt: skip


def hazelnut(look: Look) -> Shape:
    """A hazelnut, its pale scar below, its tip up."""
    r = look.between(0.0085, 0.0105)
    color = look.color("copper", "bronze", "brown")
    body = lathe([(0, 0), (0.55 * r, 0), (0.92 * r, 0.5 * r), (r, 0.95 * r), (0.75 * r, 1.5 * r),
                  (0.3 * r, 1.86 * r), (0, 2.0 * r)], 24)  # fmt: skip
    tile = textures.stack((textures.plain((222, 190, 140)), 0.3), (streaks(
        look.rng, color, tint_color(color, 0.7), 14), 0.7))  # fmt: skip
    return shape([(body, tile)], [hull_of(body)])


def peanut(look: Look) -> Shape:
    """A peanut in its waisted shell lying."""
    long, r = look.between(0.036, 0.044), look.between(0.0075, 0.009)
    body = limb([(-0.5 * long, 0, 0), (-0.42 * long, 0, 0), (-0.24 * long, 0.001, 0), (0, 0.002, 0),
                 (0.24 * long, 0.001, 0), (0.42 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.1 * r, 0.7 * r, r, 0.72 * r, 1.02 * r, 0.75 * r, 0.1 * r], 16)  # fmt: skip
    color = look.color("tan", "beige", "wooden")
    y, x = np.mgrid[0:96, 0:96]
    net = (np.abs(np.sin(np.pi * x / 12)) < 0.25) | (np.abs(np.sin(np.pi * y / 12)) < 0.25)
    tile = np.where(net[..., None], np.array(tint_color(color, 0.78)), np.array(color))
    return settle([(body, tile.astype(np.uint8))], 0.13)


def cashew(look: Look) -> Shape:
    """A curved cashew lying."""
    k = look.between(0.9, 1.15)
    a = np.linspace(0.3, 2.85, 7)
    path = np.column_stack([0.0105 * np.cos(a), 0.009 * np.sin(a), 0 * a])
    color = look.color("cream", "beige", "tan")
    body = limb(path, [0.0012, 0.0042, 0.0052, 0.0052, 0.0055, 0.0048, 0.0012], 14)
    return settle([(body, textures.speckles(look.rng, color, 8))], 0.15).scale(k)


def pistachio(look: Look) -> Shape:
    """A pistachio, its pale shell open over the green kernel."""
    k = look.between(0.9, 1.15)
    color = look.color("beige", "cream", "tan")
    whole = rod(0.02, 0.0058, blunt=2.3, squash=0.8)
    half = whole.bend(lambda p: np.column_stack([p[:, 0], np.maximum(p[:, 1], 0), p[:, 2]]))
    shells = [half.turn(2, 0.22).move(y=0.0007), half.turn(2, np.pi - 0.22).move(y=-0.0007)]
    nut = rod(0.016, 0.0044, blunt=2.5, squash=0.9).move(x=0.001, z=0.0006)
    return settle([(join(shells), textures.speckles(look.rng, color, 6)),
                   (nut, textures.spots(look.rng, (140, 160, 76), (120, 80, 84), 0.25))],
                  0.15).scale(k)  # fmt: skip


def chestnut(look: Look) -> Shape:
    """A glossy chestnut with its pale scar."""
    d = look.between(0.028, 0.034)
    color = look.color("maroon", "brown", "copper")
    body = lathe([(0, 0), (0.3, 0), (0.48, 0.16), (0.5, 0.36), (0.36, 0.62), (0.12, 0.78),
                  (0.05, 0.86), (0, 0.87)], 26)  # fmt: skip
    tile = textures.stack((textures.plain((214, 180, 132)), 0.36), (streaks(
        look.rng, tint_color(color, 0.75), tint_color(color, 0.55), 16), 0.64))  # fmt: skip
    body = body.scale(d, 0.82 * d, d)
    return shape([(body, tile)], [hull_of(body)])


def acorn(look: Look) -> Shape:
    """An acorn lying in its scaly cup."""
    r = look.between(0.0085, 0.0105)
    color = look.color("copper", "tan", "bronze")
    nut = lathe([(0, 0), (0.9 * r, 0), (r, 0.6 * r), (0.9 * r, 1.7 * r), (0.5 * r, 2.3 * r),
                 (0.12 * r, 2.5 * r), (0, 2.7 * r)], 22)  # fmt: skip
    cup = lathe([(0, -0.8 * r), (0.6 * r, -0.65 * r), (1.12 * r, -0.1 * r), (1.14 * r, 0.4 * r),
                 (0.95 * r, 0.45 * r), (0, 0.4 * r)], 24)  # fmt: skip
    stalk = tube([(0, 0, -0.7 * r), (0.1 * r, 0, -1.5 * r)], 0.13 * r, 7)
    rough = textures.spots(look.rng, (132, 96, 60), (92, 66, 40), 0.35)
    laid = [
        (s.turn(1, np.pi / 2), t)
        for s, t in (
            (nut, streaks(look.rng, color, tint_color(color, 0.7), 12)),
            (join([cup, stalk]), rough),
        )
    ]
    return settle(laid, 0.13)


def olive(look: Look) -> Shape:
    """An olive lying, a red pepper in its hole, or plain."""
    long, r = look.between(0.021, 0.026), look.between(0.0078, 0.0095)
    color = look.color("olive", "olive", "black", "purple", "green")
    body = rod(long, r, blunt=2.4)
    red = ellipsoid(0.006, 0.007, 0.007, 10, 6).move(x=0.47 * long)
    tone = textures.plain((206, 56, 40) if look.chance(0.6) else (60, 50, 40))
    return settle([(body, skin(look, color, tint_color(color, 0.85), 0.6)), (red, tone)], 0.14)


def pickle(look: Look) -> Shape:
    """A warty pickled gherkin lying."""
    long, r = look.between(0.07, 0.09), look.between(0.011, 0.014)
    color = look.color("olive", "green", "olive")
    body = rod(long, r, blunt=4, bend=look.between(0.004, 0.01))
    warts = [ellipsoid(0.003, 0.003, 0.002, 6, 4).move(u * long, 0.004 * (4 * u * u - 0.5) + v * r,
             0.98 * r * np.sqrt(1 - v * v)) for u in np.linspace(-0.36, 0.36, 9)
             for v in (-0.6, 0.0, 0.6)]  # fmt: skip
    tile = streaks(look.rng, tint_color(color, 0.85), tint_color(color, 1.3), 14)
    return settle([(body, tile), (join(warts), textures.plain(tint_color(color, 0.75)))], 0.12)


_K = ("kitchen", "food")
CATEGORIES = (
    Category("pea_pod", pea_pod, (0.0984, 0.0249, 0.0147), 0.01, ("pod of peas", "peapod",
                 "edamame", "snap pea", "sugar snap", "edamame pod"),
             _K, ("edible",), ("green",), state="lying flat"),
    Category("green_bean", green_bean, (0.12, 0.0205, 0.00735), 0.007, ("string bean",
             "runner bean", "french bean"), _K, ("edible",), ("green",), state="lying flat"),
    Category("bean", bean, (0.0174, 0.00968, 0.00676), 0.0008, ("kidney bean",
                 "lentil"), _K, ("edible",), ("maroon",), state="lying flat"),
    Category("pea", pea, (0.00895, 0.00895, 0.00747), 0.0006, ("chickpea",), _K,
             ("edible", "round"), ("green",)),
    Category("walnut", walnut, (0.0428, 0.0378, 0.0352), 0.012, ("walnut half",
             "walnut shell", "peach pit",), _K,
             ("edible",),
             ("tan",)),
    Category("almond", almond, (0.0253, 0.0144, 0.00734), 0.0014, ("pine nut",
             "pine kernel"), _K, ("edible",), ("brown",),
             state="lying flat"),
    Category("hazelnut", hazelnut, (0.0191, 0.0191, 0.0191), 0.003, ("macadamia", "filbert",
             "macadamia nut", "cobnut", "beechnut"), _K, ("edible", "round"), ("copper",)),
    Category("peanut", peanut, (0.0414, 0.0165, 0.0144), 0.002, ("groundnut", "monkey nut"), _K,
             ("edible",), ("tan",), state="lying flat"),
    Category("cashew", cashew, (0.0244, 0.0128, 0.00952), 0.0016, ("cashew nut",), _K, ("edible",),
             ("cream",), state="lying flat"),
    Category("pistachio", pistachio, (0.0205, 0.0144, 0.00806), 0.0012, ("pistachio nut",), _K,
             ("edible",), ("beige",), state="lying flat"),
    Category("chestnut", chestnut, (0.0311, 0.0257, 0.0273), 0.012, ("conker", "sweet chestnut"),
             _K, ("edible", "round"), ("brown",)),
    Category("acorn", acorn, (0.0397, 0.0215, 0.0187), 0.005, (), ("living",), (), ("copper",),
             state="lying flat"),
    Category("olive", olive, (0.0257, 0.0169, 0.0142), 0.004, (), _K, ("edible",), ("olive",),
             state="lying flat"),
    Category("pickle", pickle, (0.0776, 0.0267, 0.0226), 0.03, ("gherkin", "pickled cucumber",
             "dill pickle", "cornichon"), _K, ("edible",), ("olive",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
