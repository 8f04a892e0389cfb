"""Coffee pots, bowls of tofu and punch, ticket dispensers, cone stands, sacks, stollen."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.outlines import smooth
from ...build.recipes import ball
from ...build.settled import crockery, limb, rod, scatter, serve, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def coffee_pot(look: Look) -> Shape:
    """A tall enamel or steel coffee pot: a spout, a handle, a lid with a knob."""
    k = look.between(0.92, 1.08)
    color = look.color("silver", "navy", "white", "red", "teal", "copper")
    body = lathe(
        np.maximum(smooth([(0, 0), (0.058, 0), (0.06, 0.008), (0.052, 0.08), (0.042, 0.15), (0.04,
                   0.158), (0, 0.158)], 3), 0), 30)  # fmt: skip
    lid = lathe([(0, 0.156), (0.041, 0.156), (0.039, 0.166), (0.014, 0.178), (0, 0.179)], 26)
    knob = ball(0.02, 0.02, 0.02, (0, 0, 0.186), 14)
    spout = limb([(-0.046, 0, 0.07), (-0.075, 0, 0.1), (-0.084, 0, 0.135), (-0.1, 0, 0.15)],
                 [0.015, 0.011, 0.0085, 0.006], 10)  # fmt: skip
    grip = limb([(0.042, 0, 0.148), (0.085, 0, 0.145), (0.09, 0, 0.09), (0.054, 0, 0.05)],
                [0.0065, 0.007, 0.007, 0.0055], 8)  # fmt: skip
    metal = look.surface(color, "steel" if color[0] > 180 and color[2] > 180 else "plastic")
    dark = textures.plain((34, 32, 34))
    return shape(
        [(join([body, lid, spout]), metal), (join([knob, grip]), dark)],
        [hull_of(body), hull_of(lid, knob), hull_of(spout), hull_of(grip)],
    ).scale(k)


def tofu_dish(look: Look) -> Shape:
    """A bowl of tofu cubes in a red or brown sauce with spring onion."""
    r, h = look.between(0.075, 0.085), look.between(0.055, 0.065)
    color = look.color("white", "navy", "teal", "black", "cream")
    dish = crockery(r, h)
    sauce = cylinder(0.86 * r, 0.004, 30).move(z=0.7 * h)
    tone = look.pick([(160, 44, 22), (112, 62, 30), (176, 66, 26)])
    cubes = [
        box(0.021, 0.021, 0.017)
        .turn(2, 1.1 * n)
        .move(
            0.66 * r * np.sqrt((n + 0.4) / 13) * np.cos(2.4 * n),
            0.66 * r * np.sqrt((n + 0.4) / 13) * np.sin(2.4 * n),
            0.68 * h + 0.003 * (n % 3),
        )
        for n in range(13)
    ]
    onion = scatter(look, 0.55 * r, 22, (0.005, 0.007), 0.7 * h + 0.02, stretch=(1, 1, 0.4))
    food = [(sauce, textures.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)),
            (join(cubes), textures.speckles(look.rng, (246, 240, 222), 6)),
            (onion, textures.plain((96, 160, 70)))]  # fmt: skip
    return serve(look, dish, look.surface(color, "ceramic"), food)


def ticket_dispenser(look: Look) -> Shape:
    """A rounded dispenser of queue tickets on a foot, a numbered ticket hanging out."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "red", "blue", "green")
    foot = block(0.12, 0.09, 0.012, 0.015, 0.002)
    post = block(0.03, 0.02, 0.05, 0.006).move(z=0.01)
    drum = cylinder(0.075, 0.045, 34, bevel=0.006).turn(0, np.pi / 2).move(0, 0.0225, 0.13)
    face = cylinder(0.058, 0.002, 30).turn(0, np.pi / 2).move(0, -0.0215, 0.13)
    ticket = box(0.032, 0.0014, 0.05).turn(0, -0.25).move(0, -0.026, 0.028)
    image = prints.canvas(60, 96, (250, 248, 240))
    prints.write(image, str(int(look.rng.integers(10, 99))), 0.5, 0.5, 0.4, (40, 40, 46), bold=True)
    sign = prints.canvas(120, 120, (250, 248, 242))
    prints.write(sign, "TAKE", 0.5, 0.4, 0.16, (60, 60, 66), bold=True)
    prints.write(sign, "A NUMBER", 0.5, 0.6, 0.12, (60, 60, 66), bold=True)
    return shape(
        [
            (join([foot, post]), textures.plain((60, 60, 64))),
            (drum, textures.speckles(look.rng, color, 4)),
            (face, sign),
            (ticket, image),
        ],
        [hull_of(foot), hull_of(post), hull_of(drum, face), hull_of(ticket)],
    ).scale(k)


def cone_stand(look: Look) -> Shape:
    """A stand with round holes that holds ice cream cones, two cones in it."""
    k = look.between(0.94, 1.06)
    color = look.color("wooden", "clear", "white", "silver")
    top = block(0.19, 0.07, 0.008, 0.01, 0.001).move(z=0.11)
    legs = [block(0.008, 0.07, 0.112, 0.002).move(x=s * 0.09) for s in (-1, 1)]
    foot = block(0.19, 0.08, 0.008, 0.01, 0.001)
    rings = [torus(0.021, 0.003, 24, 6).move(x=x, z=0.119) for x in (-0.055, 0, 0.055)]
    cones = [cylinder(0.003, 0.1, 20, top=0.023).move(x=x, z=0.04) for x in (-0.055, 0.055)]
    hole = cylinder(0.019, 0.001, 20).move(0, 0, 0.1178)
    net = textures.grid((176, 116, 56), (222, 166, 96), 8, 10, width=2)
    return shape([(join([top, *legs, foot]), look.surface(color, "wood")),
                  (join(rings), textures.plain(tint_color(color, 0.8))), (join(cones), net),
                  (hole, textures.plain((50, 44, 40)))],
                 [hull_of(top), hull_of(foot), *(hull_of(s) for s in legs), hull_of(*cones)]
                 ).scale(k)  # fmt: skip


def stollen(look: Look) -> Shape:
    """A folded fruit loaf under a coat of icing sugar, one slice cut off."""
    long, r = look.between(0.19, 0.24), look.between(0.045, 0.052)
    body = rod(long, r, blunt=5, squash=0.72)
    fold = rod(0.92 * long, 0.62 * r, blunt=5, squash=0.7).move(y=-0.3 * r, z=0.42 * r)
    face = cylinder(0.8 * r, 0.014, 26).turn(1, np.pi / 2).scale(1, 1.1, 0.72).move(x=0.56 * long)
    sugar = textures.spots(look.rng, look.color("white", "white"), (226, 190, 140), 0.1)
    crumb = textures.spots(look.rng, (232, 198, 138), (110, 50, 40), 0.1)
    return settle([(join([body, fold]), sugar), (face, crumb)], 0.1, hulls=[[0], [1]])


def punch_bowl(look: Look) -> Shape:
    """A wide glass punch bowl of pink punch with fruit, a ladle hooked in it."""
    k = look.between(0.92, 1.06)
    color = look.color("pink", "red", "orange", "clear")
    foot = lathe([(0, 0), (0.06, 0), (0.05, 0.012), (0.03, 0.022), (0, 0.022)], 28)
    bowl = lathe(
        [
            (0, 0.02),
            (0.06, 0.022),
            (0.12, 0.06),
            (0.135, 0.12),
            (0.13, 0.12),
            (0.114, 0.064),
            (0, 0.05),
        ],
        36,
    )
    punch = cylinder(0.124, 0.003, 34).move(z=0.095)
    fruit = scatter(look, 0.09, 9, (0.03, 0.036), 0.099, stretch=(1, 1, 0.25))
    ladle = [
        limb([(0.03, 0, 0.1), (0.09, 0, 0.15), (0.145, 0, 0.17), (0.16, 0, 0.15)], [0.0035] * 4, 8),
        ellipsoid(0.05, 0.05, 0.02, 16, 6).move(0.02, 0, 0.102),
    ]
    steel = textures.brushed_metal(look.rng, (190, 194, 198))
    return shape([(join([foot, bowl]), textures.plain((216, 228, 232))),
                  (punch, textures.speckles(look.rng, color, 5)),
                  (fruit, textures.plain((246, 206, 80))), (join(ladle), steel)],
                 [hull_of(foot), hull_of(bowl), hull_of(*ladle)]).scale(k)  # fmt: skip


def bag_of_fuel(look: Look) -> Shape:
    """A paper sack of charcoal standing, its top folded, a flame on its front."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "black", "red", "orange")
    x, y, h = 0.2 * k, 0.1 * k, 0.28 * k
    body = block(x, y, 0.88 * h, 0.03, 0.012)
    top = box(0.94 * x, 0.018, 0.14 * h).move(z=0.86 * h)
    image = prints.canvas(120, 150, color)
    ink = readable_on(color)
    prints.polygon(
        image,
        [
            (0.3, 0.8),
            (0.26, 0.6),
            (0.4, 0.42),
            (0.46, 0.54),
            (0.54, 0.32),
            (0.7, 0.56),
            (0.72, 0.72),
            (0.62, 0.84),
        ],
        (240, 120, 30),
    )
    prints.polygon(image, [(0.42, 0.82), (0.42, 0.68), (0.52, 0.56), (0.6, 0.7), (0.56, 0.82)],
                   (252, 206, 70))  # fmt: skip
    prints.write(image, look.pick(["CHARCOAL", "BRIQUETTES", "BBQ"]), 0.5, 0.18, 0.13, ink,
                 bold=True)  # fmt: skip
    front = box(0.78 * x, 0.001, 0.74 * h).move(y=-y / 2, z=0.05 * h)
    paper = textures.speckles(look.rng, color, 6)
    return shape([(join([body, top]), paper), (front, image)],
                 [box_part(x, y, 0.88 * h), hull_of(top)])  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("coffee_pot", coffee_pot, (0.203, 0.126, 0.196), 0.6, ("percolator",
             "enamel coffee pot", "coffee percolator", "camping coffee pot", "tin coffee pot"),
             ("coffee",), ("tall",), ("silver", "navy")),
    Category("tofu_dish", tofu_dish, (0.158, 0.158, 0.064), 0.6, ("mapo tofu", "bowl of tofu",
             "tofu stew", "tofu soup", "fried tofu dish"), ("dining",), ("edible", "round"),
             ("white",)),
    vary(Category("ticket_dispenser", ticket_dispenser, (0.146, 0.0881, 0.201), 0.5,
             ("queue ticket dispenser", "take a number dispenser", "number dispenser",
             "queue number dispenser"), ("office",), ("tall",), ("red",))),
    Category("cone_holder", cone_stand, (0.192, 0.081, 0.142), 0.3, ("cone stand",
             "ice cream cone stand", "ice cream cone holder", "cone rack"), ("kitchen",),
             ("tall",), ("wooden",)),
    Category("stollen", stollen, (0.237, 0.0951, 0.0661), 0.6, ("christmas stollen", "stollen cake",
             "christstollen"), ("coffee",), ("edible", "big"), ("white",), state=_D),
    Category("punch_bowl", punch_bowl, (0.298, 0.27, 0.173), 2.5, ("bowl of punch", "punchbowl",
             "glass punch bowl"), ("dining",), ("big",), ("pink",)),
    Category("charcoal_bag", bag_of_fuel, (0.206, 0.103, 0.288), 2.0, ("bag of charcoal",
             "sack of charcoal", "bag of briquettes", "bag of coal", "charcoal sack"), _L,
             ("tall", "big"), ("tan", "black")),
)  # fmt: skip
"""The module's categories."""
