"""Toys and small things for pets."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import blade
from ...build.outlines import rectangle, smooth
from ...build.recipes import pad
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    tube,
)
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (190, 194, 200)


def slicker_brush(look: Look) -> Shape:
    """A pet brush: a flat head full of wire pins on a handle, lying pins up."""
    k, color = (
        look.between(0.9, 1.1),
        look.color("blue", "pink", "green", "purple", "orange", "red"),
    )
    grip = limb(
        [(0.03, 0, 0.011), (0.07, 0, 0.011), (0.12, 0, 0.011), (0.135, 0, 0.011)],
        [0.008, 0.0085, 0.011, 0.006],
        12,
    )
    head = block(0.08, 0.05, 0.012, 0.008, 0.002)
    bed = box(0.068, 0.04, 0.002).move(z=0.012)
    pins = [cylinder(0.0006, 0.011, 4).turn(1, 0.25).move(0.008 * i - 0.028, 0.0072 * j, 0.0135)
            for i in range(8) for j in range(-2, 3)]  # fmt: skip
    tips = [ellipsoid(0.0022, 0.0022, 0.0022, 6, 4).move(0.008 * i - 0.0255, 0.0072 * j, 0.0245)
            for i in range(8) for j in range(-2, 3)]  # fmt: skip
    return settle([(join([grip, head]), look.surface(color, "plastic")),
                   (bed, textures.plain((54, 54, 60))),
                   (join(pins), textures.plain(STEEL)),
                   (join(tips), textures.plain(tint_color(color, 1.3)))],
                  0.0, hulls=[[0], [1, 3]]).scale(k)  # fmt: skip


def ball_thrower(look: Look) -> Shape:
    """A dog's ball thrower: a long curved stick with a cup that holds a tennis ball, lying."""
    k, color = look.between(0.85, 1.0), look.color("blue", "orange", "red", "purple", "green")
    stick = limb(
        [(-0.24, 0, 0.012), (-0.1, 0.01, 0.012), (0.06, 0.02, 0.014), (0.14, 0.01, 0.018)],
        [0.012, 0.008, 0.0075, 0.009],
        10,
        0.7,
    )
    cup = lathe(
        [
            (0.0, -0.034),
            (0.02, -0.028),
            (0.0345, 0),
            (0.03, 0.014),
            (0.0335, 0),
            (0.019, -0.026),
            (0, -0.031),
        ],
        22,
    )
    cup = cup.turn(1, -1.9).move(0.178, 0.006, 0.033)
    ball = ellipsoid(0.063, 0.063, 0.063, 20, 12).move(0.176, 0.006, 0.0325)
    felt = textures.scratches(look.rng, (204, 222, 62), (180, 200, 50), 150)
    return settle(
        [(join([stick, cup]), look.surface(color, "plastic")), (ball, felt)], 0.03, hulls=[[0], [1]]
    ).scale(k)


def cat_wand(look: Look) -> Shape:
    """A cat's wand: a thin rod, a cord, feathers and a bell at its end, lying."""
    k, color = (
        look.between(0.85, 1.0),
        look.color("pink", "blue", "green", "orange", "purple", "red"),
    )
    rod = tube([(-0.24, 0, 0.004), (0.08, 0, 0.004)], [0.004, 0.0026], 8)
    grip = tube([(-0.25, 0, 0.005), (-0.15, 0, 0.005)], 0.0055, 10)
    cord = limb(
        [(0.08, 0, 0.003), (0.12, 0.03, 0.0015), (0.16, -0.01, 0.0015), (0.19, 0.01, 0.003)],
        [0.001] * 4,
        5,
    )
    feathers = [blade([(0.19, 0.01, 0.005), (0.22, 0.01 + 0.02 * s, 0.009),
                       (0.26, 0.01 + 0.035 * s, 0.003)], 0.022, thick=0.15)
                for s in (-1, 0, 1)]  # fmt: skip
    bell = ellipsoid(0.012, 0.012, 0.012, 12, 8).move(0.188, 0.01, 0.006)
    hue = look.own_color("yellow", "red", "sky", "lime")
    return settle([(rod, textures.plain(tint_color(color, 0.9))), (grip,
        textures.speckles(look.rng, tint_color(color, 0.7), 6)),
                   (cord, textures.plain((60, 60, 66))), (join(feathers),
                                                          textures.scratches(look.rng, hue,
                                                              tint_color(hue, 0.75), 60)),
                   (bell, textures.plain((212, 172, 82)))], 0.05, hulls=[[0, 1],
                       [3, 4]]).scale(k)  # fmt: skip


def rope_toy(look: Look) -> Shape:
    """A dog's rope toy: a thick twisted rope knotted at both ends, frayed."""
    k, color = look.between(0.85, 1.15), look.color("blue", "red", "green", "orange", "teal")
    bend = look.between(0.0, 0.03)
    u = np.linspace(-1, 1, 13)
    rope = tube(np.column_stack([0.07 * u, bend * (u * u - 0.5), 0 * u]), 0.011, 10)
    knots = [ellipsoid(0.032, 0.04, 0.036, 14, 9).move(s * 0.072, bend / 2, 0) for s in (-1, 1)]
    frays = [limb([(s * 0.08, bend / 2, 0), (s * 0.1, bend / 2 + 0.009 * np.cos(a),
                                             0.007 * np.sin(a)),
                   (s * 0.125, bend / 2 + 0.022 * np.cos(a), 0.012 * np.sin(a))],
                   [0.005, 0.004, 0.0015], 6)
             for s in (-1, 1) for a in np.arange(7) * 0.9]  # fmt: skip
    y, x = np.mgrid[0:96, 0:96]
    twist = (x / 96 * 3 + y / 96 * 14) % 1
    tile = np.where((twist < 0.35)[..., None], np.array(color), np.array((244, 240, 228))).astype(
        np.uint8
    )
    return settle([(rope, tile), (join(knots), tile),
                   (join(frays), textures.stripes([color, (244, 240, 228)], 5, upright=True))],
                  0.14, hulls=[[0], [1]]).scale(k)  # fmt: skip


def cuttlebone(look: Look) -> Shape:
    """A cuttlebone: a flat white oval with a harder rim, lying."""
    k, color = look.between(0.85, 1.2), look.color("white", "ivory", "cream")
    body = ellipsoid(0.14, 0.052, 0.022, 26, 12).bend(lambda p: p * np.column_stack([
        np.ones(len(p)), 1 - 1.8 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    rim = ellipsoid(0.15, 0.06, 0.006, 26, 8).bend(lambda p: p * np.column_stack([
        np.ones(len(p)), 1 - 1.8 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    lines = textures.stripes([color, color, tint_color(color, 0.9)], 14, upright=True)
    return settle([(body, lines), (rim, textures.plain(tint_color(color, 0.86)))], 0.1).scale(k)


def bag_roll(look: Look) -> Shape:
    """A small roll of bags in a dispenser shaped like a bone or a tube, a bag hanging out."""
    k, color = look.between(0.9, 1.15), look.color("black", "blue", "green", "pink", "red")
    roll = cylinder(0.016, 0.06, 22, bevel=0.002).turn(1, np.pi / 2).move(-0.03, 0, 0.016)
    core = cylinder(0.007, 0.064, 14).turn(1, np.pi / 2).move(-0.032, 0, 0.016)
    tail = prism(rectangle(0.056, 0.05, 0.002), 0, 0.0012).move(y=-0.034)
    paws = prints.canvas(128, 64, color)
    for n in range(8):
        x, y = (n % 4 + 0.5) / 4, 0.3 + 0.45 * (n // 4)
        prints.disc(paws, x, y, 0.07, tint_color(color, 1.6))
        for s in (-1, 0, 1):
            prints.disc(paws, x + 0.03 * s, y - 0.12 + 0.03 * abs(s), 0.03, tint_color(color, 1.6))
    return settle([(roll, paws), (core, textures.plain((226, 214, 190))),
                   (tail, textures.plain(tint_color(color, 1.15)))],
                  0.02, hulls=[[0], [2]]).scale(k)  # fmt: skip


def clicker(look: Look) -> Shape:
    """A training clicker: a small rounded box with a button and a wrist loop."""
    k, color = (
        look.between(0.9, 1.15),
        look.color("blue", "red", "yellow", "green", "black", "purple"),
    )
    body = pad(0.06, 0.036, 0.018, 0.014)
    button = ellipsoid(0.022, 0.02, 0.01, 16, 8).move(-0.012, 0, 0.018)
    loop = tube(smooth([(0.029, 0.003, 0.009), (0.06, 0.014, 0.002), (0.085, 0, 0.002),
                        (0.06, -0.014, 0.002),
                        (0.029, -0.003, 0.009)], 5), 0.0016, 6)  # fmt: skip
    return settle([(body, look.surface(color, "plastic")),
                   (button, textures.plain(look.own_color("white", "yellow", "black"))),
                   (loop, textures.plain((40, 40, 44)))], 0.0, hulls=[[0],
                       [1]]).scale(k)  # fmt: skip


_P = ("living",)

CATEGORIES = (
    Category("slicker_brush", slicker_brush, (0.174, 0.0499, 0.0255), 0.09,
             ("cat brush", "dog brush", "pet brush", "grooming brush",
             "dog grooming brush", "pin brush", "pet comb"), _P, (), ("blue",), state="lying"),
    Category("ball_thrower", ball_thrower, (0.42, 0.0641, 0.0585), 0.2,
             ("ball launcher", "tennis ball thrower", "dog ball launcher",
             "dog ball thrower", "chuckit"), _P, ("big",), ("blue",), state="lying"),
    Category("cat_wand", keep_still(cat_wand), (0.475, 0.0659, 0.0108), 0.03,
             ("cat teaser", "feather wand", "feather toy", "cat feather toy",
             "cat teaser wand"), _P, ("big",), ("pink",), state="lying"),
    Category("rope_toy", rope_toy, (0.243, 0.0531, 0.0299), 0.1, ("dog rope", "rope chew",
        "dog rope toy", "tug toy", "dog toy", "rope dog toy"), _P, (),
             ("blue",), state="lying"),
    Category("cuttlebone", cuttlebone, (0.155, 0.0627, 0.0206), 0.02, ("cuttle bone",
        "cuttlefish bone"), _P, (), ("white",), state="lying"),
    Category("bag_roll", bag_roll, (0.0687, 0.0805, 0.0335), 0.03, ("poop bag roll",
        "poo bag roll", "dog poop bag", "dog waste bag", "poop bag",
             "poo bag", "roll of poop bags", "roll of poo bags"), _P, (), ("black",),
             state="lying"),
    Category("clicker", clicker, (0.12, 0.0371, 0.0237), 0.02, ("training clicker", "dog clicker",
        "dog training clicker"), _P, (), ("blue",)),
)  # fmt: skip
"""The module's categories."""
