"""Toy animals that do not stand on four straight legs: dinosaurs, dragons, frogs, birds."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.recipes import Pieces, ball, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import cylinder, join, prism
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

DARK = textures.plain((34, 32, 34))


def dinosaur(look: Look) -> Shape:
    """A toy dinosaur that looks to the left: a long-necked one or a rex on its hind legs."""
    color = look.color("green", "olive", "teal", "orange", "violet", "blue", "red")
    skin = textures.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    pale = textures.plain(tint_color(color, 1.5))
    k = look.between(0.92, 1.1)
    plates = []
    if look.chance(0.5):  # a sauropod
        body = ball(0.075, 0.044, 0.046, (0, 0, 0.042), 18)
        neck = rod([(-0.025, 0, 0.048), (-0.05, 0, 0.068), (-0.062, 0, 0.1)],
                   [0.015, 0.011, 0.008], 10)  # fmt: skip
        head = ball(0.03, 0.018, 0.017, (-0.07, 0, 0.105), 12)
        tail = rod([(0.025, 0, 0.045), (0.06, 0, 0.034), (0.1, 0, 0.022)],
                   [0.016, 0.009, 0.002], 10)  # fmt: skip
        legs = join([cylinder(0.0095, 0.04, 12, top=0.011).move(x, y)
                     for x in (-0.02, 0.022) for y in (-0.013, 0.013)])  # fmt: skip
        eyes = join([ball(0.004, 0.004, 0.004, (-0.075, s * 0.008, 0.109), 8) for s in (-1, 1)])
        spine = [(-0.04, 0.08), (-0.02, 0.064), (0, 0.066), (0.02, 0.064), (0.045, 0.052)]
    else:  # a rex
        body = ball(0.04, 0.036, 0.07, (0, 0, 0.06), 18).turn(1, -0.25).move(x=0.015)
        neck = rod([(-0.005, 0, 0.08), (-0.015, 0, 0.098), (-0.02, 0, 0.106)], 0.013, 10)
        head = join([ball(0.046, 0.028, 0.028, (-0.03, 0, 0.112), 14),
                     ball(0.03, 0.022, 0.012, (-0.034, 0, 0.099), 12)])  # fmt: skip
        tail = rod([(0.012, 0, 0.05), (0.05, 0, 0.026), (0.09, 0, 0.006)],
                   [0.018, 0.011, 0.003], 10)  # fmt: skip
        feet = [ball(0.034, 0.018, 0.016, (-0.006, s * 0.016, 0.005), 10) for s in (-1, 1)]
        thighs = [ball(0.03, 0.018, 0.045, (0.006, s * 0.016, 0.03), 12) for s in (-1, 1)]
        arms = [straight((-0.01, s * 0.014, 0.074), (-0.026, s * 0.014, 0.066), 0.004, 6)
                for s in (-1, 1)]  # fmt: skip
        legs = join([*feet, *thighs, *arms])
        eyes = join([ball(0.006, 0.004, 0.006, (-0.034, s * 0.012, 0.12), 8) for s in (-1, 1)])
        spine = [(0.0, 0.108), (0.014, 0.09), (0.024, 0.07), (0.036, 0.05), (0.054, 0.032)]
    for x, z in spine:
        plates.append(cylinder(0.007, 0.012, 4, top=0.0006).scale(1, 0.4, 1).move(x, 0, z - 0.004))
    pieces: Pieces = [(body, skin), (neck, skin), (head, skin), (tail, skin), (legs, skin),
                      (join(plates), pale), (eyes, DARK)]  # fmt: skip
    return put_down(pieces, body, head, tail, legs, factor=k)


def dragon(look: Look) -> Shape:
    """A toy dragon with raised wings, sitting."""
    color = look.color("red", "green", "purple", "teal", "black", "blue")
    skin = textures.spots(look.rng, color, tint_color(color, 1.3), 0.15)
    belly = textures.plain(look.pick([(236, 196, 110), tint_color(color, 1.6)]))
    body = ball(0.056, 0.05, 0.076, (0, 0, 0.034), 18)
    front = ball(0.03, 0.036, 0.06, (-0.016, 0, 0.034), 14)
    neck = rod([(0, 0, 0.06), (-0.006, 0, 0.08), (-0.016, 0, 0.096)], [0.015, 0.011, 0.01], 10)
    head = join([ball(0.034, 0.03, 0.028, (-0.018, 0, 0.102), 14),
                 ball(0.028, 0.02, 0.015, (-0.036, 0, 0.097), 12)])  # fmt: skip
    horns = [cylinder(0.004, 0.02, 8, top=0.0008).turn(1, 0.6).move(-0.01, s * 0.01, 0.112)
             for s in (-1, 1)]  # fmt: skip
    feet = [ball(0.03, 0.02, 0.014, (-0.024, s * 0.02, 0.005), 10) for s in (-1, 1)]
    tail = rod(
        [(0.02, 0, 0.012), (0.05, 0.01, 0.008), (0.062, -0.02, 0.007), (0.04, -0.046, 0.007)],
        [0.014, 0.009, 0.006, 0.003],
        8,
    )
    outline = np.array([(0, 0), (0.05, 0.005), (0.042, 0.018), (0.05, 0.04), (0.03, 0.036),
                        (0.012, 0.05)])  # fmt: skip
    wings = [prism(outline, -0.001, 0.001).turn(0, np.pi / 2).turn(2, s * 0.6)
             .move(0.012, s * 0.016, 0.045) for s in (-1, 1)]  # fmt: skip
    eyes = join([ball(0.006, 0.005, 0.006, (-0.027, s * 0.011, 0.109), 8) for s in (-1, 1)])
    pieces: Pieces = [
        (join([body, neck, *feet]), skin),
        (front, belly),
        (head, skin),
        (join(horns), belly),
        (tail, skin),
        (join(wings), belly),
        (eyes, DARK),
    ]
    return put_down(pieces, join([body, *feet]), join([neck, head]), tail, *wings,
                   factor=look.between(0.95, 1.2))  # fmt: skip


def frog(look: Look) -> Shape:
    """A ceramic frog crouching."""
    color = look.color("green", "lime", "olive", "teal", "green")
    skin = textures.spots(look.rng, color, tint_color(color, 0.7), 0.1)
    pale = textures.plain(tint_color(color, 1.7))
    body = ball(0.066, 0.06, 0.048, (0, 0, 0.022), 18).turn(1, 0.2).move(z=0.002)
    head = ball(0.04, 0.054, 0.034, (-0.028, 0, 0.04), 16)
    bulges = [ball(0.017, 0.017, 0.017, (-0.032, s * 0.017, 0.056), 12) for s in (-1, 1)]
    pupils = [ball(0.009, 0.008, 0.01, (-0.038, s * 0.019, 0.058), 8) for s in (-1, 1)]
    legs = [ball(0.044, 0.022, 0.03, (0.018, s * 0.03, 0.013), 12) for s in (-1, 1)]
    feet = [ball(0.03, 0.02, 0.008, (x, s * y, 0.002), 10)
            for s in (-1, 1) for x, y in ((-0.036, 0.022), (0.0, 0.042))]  # fmt: skip
    arms = [straight((-0.026, s * 0.02, 0.03), (-0.034, s * 0.022, 0.004), 0.006) for s in (-1, 1)]
    mouth = ball(0.032, 0.05, 0.003, (-0.033, 0, 0.036), 14)
    pieces: Pieces = [(join([body, head, *bulges, *legs, *feet, *arms]), skin),
                      (mouth, pale), (join(pupils), DARK)]  # fmt: skip
    return put_down(pieces, join([body, *legs, *feet]), join([head, *bulges]),
                   factor=look.between(0.9, 1.2))  # fmt: skip


def bird(look: Look) -> Shape:
    """A small bird figure on its feet, looking to the left."""
    color = look.color("blue", "red", "yellow", "teal", "brown", "white", "sky")
    skin = textures.speckles(look.rng, color, 8)
    chest = textures.plain(look.pick([(240, 196, 140), (250, 246, 236), tint_color(color, 1.5)]))
    wing = textures.plain(tint_color(color, 0.7))
    body = ball(0.074, 0.048, 0.05, (0, 0, 0.027), 18)
    breast = ball(0.04, 0.042, 0.042, (-0.017, 0, 0.024), 14)
    head = ball(0.036, 0.034, 0.034, (-0.028, 0, 0.056), 16)
    beak = cylinder(0.006, 0.016, 10, top=0.0006).turn(1, -np.pi / 2).move(-0.043, 0, 0.055)
    tail = prism([(0, -0.008), (0.045, -0.014), (0.045, 0.014), (0, 0.008)], 0, 0.005)
    tail = tail.turn(1, -0.25).move(0.03, 0, 0.028)
    wings = [ball(0.052, 0.01, 0.028, (0.006, s * 0.023, 0.031), 12) for s in (-1, 1)]
    eyes = [ball(0.005, 0.004, 0.005, (-0.036, s * 0.0135, 0.061), 8) for s in (-1, 1)]
    foot = cylinder(0.019, 0.004, 14)
    pieces: Pieces = [(body, skin), (breast, chest), (head, skin), (tail, wing),
                      (join(wings), wing), (join([beak, foot]), textures.plain((226, 150, 50))),
                      (join(eyes), DARK)]  # fmt: skip
    return put_down(pieces, body, foot, head, beak, tail, factor=look.between(0.9, 1.15))


CATEGORIES = (
    Category(
        "toy_dinosaur",
        dinosaur,
        (0.165, 0.047, 0.12),
        0.08,
        (
            "dinosaur",
            "dinosaur toy",
            "dinosaur figure",
            "dino",
            "t rex",
            "t-rex",
            "tyrannosaurus",
            "brontosaurus",
            "plastic dinosaur",
            "tyrannosaurus rex",
        ),
        ("toys",),
        (),
        ("green",),
    ),
    Category(
        "toy_dragon",
        dragon,
        (0.115, 0.085, 0.125),
        0.09,
        ("dragon", "dragon figure", "dragon figurine", "dragon statue", "dragon toy"),
        ("toys",),
        (),
        ("red", "green"),
    ),
    Category(
        "frog",
        frog,
        (0.0965, 0.111, 0.0695),
        0.15,
        (
            "ceramic frog",
            "toy frog",
            "frog figurine",
            "frog figure",
            "toad",
            "frog statue",
            "garden frog",
            "stone frog",
            "frog model",
        ),
        ("toys", "living"),
        (),
        ("green",),
    ),
    Category(
        "bird",
        bird,
        (0.12, 0.05, 0.076),
        0.08,
        (
            "bird figure",
            "toy bird",
            "wooden bird",
            "ceramic bird",
            "bird statue",
            "robin",
            "songbird",
            "robin ornament",
            "bird ornament",
        ),
        ("toys", "living"),
        (),
        ("blue", "red"),
    ),
)
"""The module's categories."""
