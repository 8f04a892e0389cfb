"""Shellfish, squid, eels and flat fish, whole."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade, lobe
from ...build.outlines import ellipse, smooth
from ...build.recipes import ball
from ...build.settled import hull_above, limb, settle
from ...build.settled import rod as log
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, prism, torus, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

FRIED: RGB = (222, 160, 74)


def mussel(look: Look) -> Shape:
    """A blue-black mussel, half open, orange inside."""
    k = look.between(0.9, 1.15)
    ring = (
        smooth(
            np.array(
                [
                    (-0.5, 0),
                    (-0.3, -0.2),
                    (0.1, -0.27),
                    (0.45, -0.18),
                    (0.5, 0.05),
                    (0.35, 0.2),
                    (0, 0.2),
                    (-0.3, 0.12),
                    (-0.5, 0),
                ]
            ),
            4,
        )[:-1]
        * 0.068
    )
    half = _dome(ring, 0.014)
    low = half.bend(lambda p: np.column_stack([p[:, :2], 0.014 - p[:, 2]]))
    low = Solid(low.vertices, low.faces[:, ::-1], low.uv)
    lift = half.turn(0, 0.55).move(y=0.004, z=0.022)
    meat = ellipsoid(0.044, 0.018, 0.012, 14, 8).move(0.003, -0.002, 0.015)
    color = look.color("navy", "charcoal", "black")
    shell = textures.stripes([tint_color(color, 0.7), tint_color(color, 1.15)], 7)
    inside = prism(ring * 0.94, 0.0125, 0.0146)
    return settle(
        [
            (join([low, lift]), shell),
            (meat, textures.plain((236, 150, 70))),
            (inside, textures.plain((196, 200, 214))),
        ],
        0.05,
        hulls=[[0]],
    ).scale(k)


def _dome(ring: np.ndarray, h: float) -> Solid:
    from ...build.solids import loft

    levels = [(1.0, 0), (0.97, 0.25 * h), (0.85, 0.6 * h), (0.55, 0.92 * h), (0.15, h)]
    return loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip


def scallop(look: Look) -> Shape:
    """A fan-shaped scallop in its half shell with white meat and coral."""
    k = look.between(0.9, 1.1)
    a = np.linspace(-0.25, np.pi + 0.25, 25)
    fan = np.column_stack([0.05 * np.cos(a), 0.048 * np.sin(a)]) * (1 + 0.03 * np.cos(24 * a))[
        :, None]  # fmt: skip
    outline = np.concatenate([[(0.016, -0.024)], fan, [(-0.016, -0.024)]])
    dish = prism(outline, 0.0, 0.006, 0.002)
    wall = lobe(torus(0.045, 0.0035, 60, 6), 24, 0.04).move(y=0.004, z=0.008)
    wall = wall.bend(lambda p: np.column_stack([p[:, 0], np.maximum(p[:, 1], -0.018), p[:, 2]]))
    color = look.color("coral", "beige", "cream", "terracotta")
    meat = cylinder(0.02, 0.018, 24, bevel=0.004).move(0, 0.006, 0.005)
    roe = log(0.04, 0.008, bend=0.014, blunt=4).move(0, 0.034, 0.012)
    return shape([(dish, textures.stripes([color, tint_color(color, 0.85)], 12, upright=True)),
                  (wall, textures.speckles(look.rng, color, 8)),
                  (meat, textures.speckles(look.rng, (248, 240, 222), 5)),
                  (roe, textures.plain((232, 110, 60)))],
                 [hull_of(dish), hull_of(meat)]).scale(k)  # fmt: skip


def squid(look: Look) -> Shape:
    """A squid lying: a pale mantle with fins, arms to the right."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "beige", "coral", "ivory")
    mantle = limb([(-0.13, 0, 0.0), (-0.08, 0, 0), (0, 0, 0), (0.03, 0, 0)],
                  [0.004, 0.024, 0.032, 0.027], 16, squash=0.65)  # fmt: skip
    fins = [blade([(-0.05, s * 0.01, 0), (-0.085, s * 0.05, 0), (-0.125, s * 0.012, 0)], 0.05,
                  thick=0.08) for s in (-1, 1)]  # fmt: skip
    head = ellipsoid(0.042, 0.036, 0.03, 14, 8).move(x=0.045)
    arms = [limb([(0.055, 0.004 * n, -0.004), (0.09, 0.011 * n, -0.008), (0.12, 0.016 * n +
                  0.01 * (-1) ** n, -0.012)], [0.0055, 0.004, 0.0012], 6)
            for n in (-3, -2, -1, 0, 1, 2, 3)]  # fmt: skip
    eyes = [ball(0.01, 0.01, 0.008, (0.045, s * 0.014, 0.01), 10) for s in (-1, 1)]
    tile = textures.spots(look.rng, color, tint_color(color, 0.75), 0.1)
    return settle(
        [
            (join([mantle, *fins, head]), tile),
            (join(arms), tile),
            (join(eyes), textures.plain((26, 24, 30))),
        ],
        0.15,
        hulls=[[0], [1]],
    ).scale(k)


def octopus(look: Look) -> Shape:
    """An octopus: a bulging head and eight curling arms with suckers."""
    k = look.between(0.9, 1.1)
    color = look.color("crimson", "coral", "purple", "pink")
    head = join([ellipsoid(0.07, 0.064, 0.075, 20, 12).move(0, 0.006, 0.058),
                 ellipsoid(0.06, 0.05, 0.04, 16, 8).move(0, 0, 0.022)])  # fmt: skip
    arms, cups = [], []
    for n in range(8):
        a = 2 * np.pi * (n + 0.5) / 8
        b = a + 0.5 * (-1) ** n
        path = [(0.02 * np.cos(a), 0.02 * np.sin(a), 0.018), (0.06 * np.cos(a), 0.06 * np.sin(a),
                0.009), (0.1 * np.cos(b), 0.1 * np.sin(b), 0.006), (0.09 * np.cos(b + 0.35),
                0.09 * np.sin(b + 0.35), 0.004)]  # fmt: skip
        arms.append(limb(path, [0.013, 0.0095, 0.006, 0.0018], 8))
        cups += [ball(0.006, 0.006, 0.004, (r * np.cos(a + 0.12), r * np.sin(a + 0.12), 0.006), 6)
                 for r in (0.05, 0.062)]  # fmt: skip
    eyes = [ball(0.014, 0.012, 0.014, (s * 0.02, -0.026, 0.05), 10) for s in (-1, 1)]
    pupils = [ball(0.007, 0.006, 0.007, (s * 0.021, -0.031, 0.05), 8) for s in (-1, 1)]
    tile = textures.spots(look.rng, color, tint_color(color, 1.3), 0.08)
    return shape(
        [
            (head, tile),
            (join(arms), tile),
            (join(cups), textures.plain((246, 214, 206))),
            (join(eyes), textures.plain((248, 244, 230))),
            (join(pupils), textures.plain((24, 22, 28))),
        ],
        [hull_of(head), *(hull_above(*arms[n : n + 2]) for n in (0, 2, 4, 6))],
    ).scale(k)


def tentacle(look: Look) -> Shape:
    """One curled octopus arm with rows of suckers."""
    k = look.between(0.9, 1.1)
    color = look.color("crimson", "purple", "coral")
    t = np.linspace(0, 1, 8)
    turn = 0.4 + 4.4 * t**1.4
    away = 0.075 * (1 - 0.8 * t)
    path = np.column_stack([away * np.cos(turn), away * np.sin(turn), 0 * t])
    radii = 0.013 * (1 - 0.85 * t) + 0.001
    arm = limb(path, list(radii), 10)
    points, wide = smooth(path, 4), np.interp(np.linspace(0, 1, 29), t, radii)
    cups = [cylinder(0.4 * w, 0.3 * w, 8).move(*(p + np.array([0, 0, 0.85 * w])))
            for p, w in zip(points, wide, strict=True)]  # fmt: skip
    return settle([(arm, textures.spots(look.rng, color, tint_color(color, 1.25), 0.1)),
                   (join(cups), textures.plain((246, 210, 206)))], 0.15).scale(k)  # fmt: skip


def urchin(look: Look) -> Shape:
    """A sea urchin with its spines."""
    k = look.between(0.9, 1.1)
    color = look.color("purple", "black", "maroon", "navy")
    core = ellipsoid(0.05, 0.05, 0.036, 20, 10).move(z=0.024)
    spines = []
    for n in range(90):
        up = 1 - 1.55 * (n + 0.5) / 90
        flat = np.sqrt(1 - up * up)
        way = np.array([flat * np.cos(2.4 * n), flat * np.sin(2.4 * n), up])
        a = np.array([0, 0, 0.024]) + way * [0.022, 0.022, 0.016]
        b = a + way * 0.024
        spines.append(tube([a, [b[0], b[1], max(b[2], 0.001)]], [0.0014, 0.0004], 4))
    dark = textures.speckles(look.rng, tint_color(color, 0.8), 9)
    return shape([(join([core, *spines]), dark)], [hull_of(core, *spines)]).scale(k)


def eel(look: Look) -> Shape:
    """A long smooth eel in a loose S."""
    k = look.between(0.9, 1.1)
    color = look.color("olive", "charcoal", "brown", "gray")
    body = limb([(-0.17, 0.0, 0), (-0.11, 0.045, 0), (-0.02, 0.01, 0), (0.06, -0.045, 0),
                 (0.14, -0.01, 0), (0.19, 0.03, 0)], [0.011, 0.015, 0.016, 0.014, 0.01, 0.002],
                12)  # fmt: skip
    fin = limb([(-0.08, 0.04, 0.014), (0.0, -0.004, 0.016), (0.07, -0.045, 0.013),
                (0.15, -0.006, 0.008)], [0.001, 0.0035, 0.0035, 0.001], 5)  # fmt: skip
    eyes = [ball(0.005, 0.005, 0.004, (-0.163, 0.002 + 0.009 * s, 0.008), 8) for s in (-1, 1)]
    return settle([(body, textures.gradient(tint_color(color, 1.4), tint_color(color, 0.8),
                                            look.rng)),
                   (fin, textures.plain(tint_color(color, 0.6))),
                   (join(eyes), textures.plain((240, 220, 120)))], 0.18).scale(k)  # fmt: skip


def flat_fish(look: Look) -> Shape:
    """A plaice or sole: oval and flat, fringed by its fins, spotted."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "olive", "tan", "gray")
    body = ellipsoid(0.2, 0.13, 0.024, 28, 10)
    fringe = prism(ellipse(0.21, 0.165, 32), -0.0022, 0.0022).move(x=0.006)
    tail = prism(np.array([(0.095, -0.01), (0.145, -0.034), (0.14, 0.034), (0.095, 0.01)]), -0.0022,
                 0.0022)  # fmt: skip
    eyes = [ball(0.011, 0.011, 0.01, (-0.075, y, 0.0085), 10) for y in (-0.008, 0.012)]
    pupils = [ball(0.005, 0.005, 0.005, (-0.076, y, 0.0125), 8) for y in (-0.008, 0.012)]
    dots = [ellipsoid(0.011, 0.011, 0.002, 10, 4).move(x, y, 0.0115 * np.sqrt(max(
            1 - (x / 0.1) ** 2 - (y / 0.065) ** 2, 0.1)))
            for x, y in ((-0.03, 0.03), (0.01, -0.03), (0.04, 0.02), (0.0, 0.008), (-0.04, -0.02),
                         (0.06, -0.015))]  # fmt: skip
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.8)),
                   (join([fringe, tail]), textures.speckles(look.rng, tint_color(color, 0.7), 8)),
                   (join(eyes), textures.plain((230, 220, 190))),
                   (join(pupils), textures.plain((22, 22, 26))),
                   (join(dots), textures.plain((222, 120, 50)))], 0.35).scale(k)  # fmt: skip


def bones(look: Look) -> Shape:
    """The bare bones of a fish with its head and tail."""
    k = look.between(0.9, 1.1)
    color = look.color("ivory", "white", "cream")
    spine = limb([(-0.07, 0, 0.004), (0, 0, 0.004), (0.09, 0, 0.004)], [0.0032, 0.003, 0.0018], 6)
    ribs = [limb([(x, 0, 0.004), (x + 0.008, s * 0.5 * w, 0.005), (x + 0.016, s * w, 0.002)],
                 [0.0018, 0.0015, 0.0008], 5)
            for x, w in ((-0.06, 0.032), (-0.042, 0.036), (-0.024, 0.034), (-0.006, 0.03),
                         (0.012, 0.025), (0.03, 0.02), (0.048, 0.014), (0.064, 0.009))
            for s in (-1, 1)]  # fmt: skip
    head = prism(smooth(np.array([(-0.125, 0), (-0.1, -0.026), (-0.068, -0.03), (-0.072, 0),
                                  (-0.068, 0.03), (-0.1, 0.026), (-0.125, 0)]), 3)[:-1], 0, 0.007,
                 0.002)  # fmt: skip
    tail = prism(np.array([(0.086, -0.003), (0.125, -0.032), (0.112, 0), (0.125, 0.032), (0.086,
                           0.003)]), 0.001, 0.005)  # fmt: skip
    eye = cylinder(0.0055, 0.001, 12).move(-0.098, 0.006, 0.0066)
    return shape([(join([spine, *ribs, head, tail]), textures.speckles(look.rng, color, 6)),
                  (eye, textures.plain((40, 38, 40)))],
                 [hull_above(spine, *ribs), hull_of(head), hull_of(tail)]).scale(k)  # fmt: skip


def ring(look: Look) -> Shape:
    """A battered ring of squid."""
    r, t = look.between(0.021, 0.027), look.between(0.007, 0.009)
    body = torus(r, t, 26, 10).scale(1, 0.92, 1.0)
    batter = textures.spots(look.rng, tint_color(look.color("amber", "tan"), 1.1), FRIED, 0.35)
    return settle([(body, batter)], 0.12)


_K = ("kitchen", "dining")
_E = ("edible",)
_L = "lying flat"


CATEGORIES = (
    Category("mussel", mussel, (0.0713, 0.0362, 0.0367), 0.025, ("mussel shell", "open mussel"),
             _K, _E, ("navy",), state=_L),
    Category("scallop", scallop, (0.0977, 0.0749, 0.0223), 0.07, ("king scallop",
             "scallop in its shell"), _K, _E, ("coral",), state=_L),
    Category("squid", squid, (0.249, 0.138, 0.0351), 0.2, ("cuttlefish", "raw squid",
             "whole squid"), _K, _E, ("pink",), state=_L),
    Category("octopus", octopus, (0.178, 0.178, 0.0962), 0.4, ("baby octopus", "toy octopus",
             "rubber octopus"), _K, _E, ("crimson",)),
    Category("octopus_tentacle", tentacle, (0.115, 0.0835, 0.0243), 0.1, ("tentacle",
             "squid tentacle", "grilled octopus"), _K, _E, ("crimson",), state=_L),
    Category("sea_urchin", urchin, (0.0918, 0.0919, 0.062), 0.1, ("urchin", "sea urchin shell"), _K,
             ("round",), ("purple",)),
    Category("eel", eel, (0.372, 0.12, 0.0293), 0.3, ("smoked eel", "moray", "lamprey"), _K, _E,
             ("olive",), state=_L),
    Category("flatfish", flat_fish, (0.247, 0.166, 0.0177), 0.3, ("plaice", "flounder",
             "dover sole", "lemon sole", "turbot", "halibut", "flat fish", "sole fish", "sole"), _K,
             ("edible", "flat"), ("brown",), state=_L),
    Category("fish_skeleton", bones, (0.244, 0.0711, 0.00743), 0.02, ("fishbone",
             "skeleton of a fish", "fish head"), _K, ("flat",), ("ivory",), state=_L),
)  # fmt: skip
"""The module's categories."""
