"""Spiders, bats, ravens, rats and snakes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade
from ...build.recipes import ball, put_down
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, join, prism, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..nursery.dinosaurs import bird

BLACK = textures.plain((24, 22, 26))


def spider(look: Look) -> Shape:
    """A plastic spider on eight bent legs."""
    k = look.between(0.85, 1.25)
    color = look.color("black", "black", "charcoal", "purple", "orange")
    body = ellipsoid(0.036, 0.032, 0.028, 16, 10).move(0.024, 0, 0.019)
    head = ellipsoid(0.022, 0.02, 0.017, 14, 8).move(-0.006, 0, 0.015)
    legs = []
    for s in (-1, 1):
        for n, a in enumerate((0.75, 1.3, 1.85, 2.4)):
            way = np.array([-np.cos(a), s * np.sin(a)])
            reach = 0.056 + 0.006 * (n in (0, 3))
            legs.append(limb([(*(0.006 * way), 0.014), (*(0.45 * reach * way), 0.032),
                              (*(0.8 * reach * way), 0.02), (*(reach * way), 0.0012)],
                             [0.003, 0.0024, 0.002, 0.0011], 6))  # fmt: skip
    eyes = [ball(0.0042, 0.0042, 0.0042, (-0.015, s * 0.0045, 0.0195), 8) for s in (-1, 1)]
    tile = textures.speckles(look.rng, tint_color(color, 0.85), 8)
    mark = ellipsoid(0.012, 0.01, 0.004, 10, 4).move(0.026, 0, 0.0325)
    return shape(
        [
            (join([body, head]), tile),
            (join(legs), tile),
            (join([*eyes, mark]), textures.plain((206, 40, 40))),
        ],
        [hull_of(body, head), *(hull_above(*legs[n : n + 4]) for n in (0, 4))],
    ).scale(k)


def bat(look: Look) -> Shape:
    """A rubber bat lying with its wings spread."""
    k = look.between(0.9, 1.2)
    color = look.color("black", "black", "charcoal", "purple")
    side = [
        (0.0, 0.012),
        (0.03, 0.022),
        (0.06, 0.034),
        (0.1, 0.028),
        (0.094, 0.002),
        (0.078, -0.012),
        (0.066, 0.0),
        (0.05, -0.02),
        (0.038, -0.004),
        (0.02, -0.026),
        (0.012, -0.012),
    ]
    outline = np.array([(x, y) for x, y in side[::-1]] + [(-x, y) for x, y in side[1:]])
    wings = prism(outline, 0, 0.003, 0.0008)
    body = ellipsoid(0.024, 0.046, 0.02, 14, 8).move(0, -0.003, 0.008)
    head = ball(0.022, 0.022, 0.018, (0, 0.024, 0.0085), 12)
    ears = [blade([(s * 0.006, 0.03, 0.009), (s * 0.009, 0.038, 0.011), (s * 0.01, 0.044, 0.01)],
                  0.009) for s in (-1, 1)]  # fmt: skip
    ribs = [
        tube([(s * 0.012, 0.014, 0.0034), (s * x, y, 0.0034)], 0.0012, 5)
        for s in (-1, 1)
        for x, y in ((0.06, 0.032), (0.078, -0.01), (0.05, -0.017))
    ]
    eyes = [ball(0.004, 0.004, 0.004, (s * 0.005, 0.028, 0.016), 8) for s in (-1, 1)]
    dark = textures.speckles(look.rng, color, 8)
    return put_down([(join([wings, body, head, *ears]), dark),
                     (join(ribs), textures.plain(tint_color(color, 1.25))),
                     (join(eyes), textures.plain((220, 40, 40)))], wings, join([body, head]),
                    factor=k)  # fmt: skip


def raven(look: Look) -> Shape:
    """A black bird standing."""
    thing = bird(Look(look.rng, {"color": "black", **look.attributes})).scale(1.5)
    dark = [replace(p, tile=(p.tile * 0.22 + 14).astype(np.uint8)) for p in thing.pieces[1:6]]
    return replace(thing, pieces=(thing.pieces[0], *dark, thing.pieces[6]))


def rat(look: Look) -> Shape:
    """A rat or toy mouse on its belly, ears up, a long tail."""
    k = look.between(0.85, 1.15)
    color = look.color("gray", "gray", "brown", "charcoal", "white")
    body = ellipsoid(0.09, 0.05, 0.046, 18, 10).move(0.012, 0, 0.022)
    head = limb([(-0.02, 0, 0.024), (-0.045, 0, 0.022), (-0.068, 0, 0.014)], [0.02, 0.016, 0.004],
                12)  # fmt: skip
    ears = [ellipsoid(0.006, 0.018, 0.02, 10, 6).move(-0.034, s * 0.014, 0.04) for s in (-1, 1)]
    feet = [ellipsoid(0.02, 0.01, 0.008, 8, 5).move(x, s * 0.02, 0.004) for x in (-0.024, 0.035)
            for s in (-1, 1)]  # fmt: skip
    tail = limb([(0.052, 0, 0.012), (0.085, 0.014, 0.004), (0.115, -0.006, 0.003), (0.145, 0.008,
                0.002)], [0.0045, 0.0032, 0.0025, 0.0012], 6)  # fmt: skip
    eyes = [ball(0.005, 0.005, 0.005, (-0.05, s * 0.0105, 0.0275), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.006, 0.005, (-0.0705, 0, 0.0145), 8)
    fur = textures.scratches(look.rng, color, tint_color(color, 0.8), 120)
    pink = textures.plain((226, 160, 156))
    return shape([(join([body, head]), fur), (join([*ears, *feet, tail, nose]), pink),
                  (join(eyes), BLACK)], [hull_above(body), hull_above(head), hull_above(tail),
                                         hull_above(*feet)]).scale(k)  # fmt: skip


def snake(look: Look) -> Shape:
    """A rubber snake coiled up, head raised."""
    k = look.between(0.9, 1.2)
    color = look.color("green", "lime", "black", "brown", "orange", "red")
    t = np.linspace(0, 1, 12)
    turn = 4.4 * np.pi * t
    away = 0.062 - 0.04 * t
    path = np.column_stack([away * np.cos(turn), away * np.sin(turn), 0.006 + 0.02 * t])
    path = np.concatenate([[(0.09, 0.012, 0.004)], path, [(0.006, -0.004, 0.05), (-0.02, -0.03,
                           0.056)]])  # fmt: skip
    radii = [0.0015, *np.interp(t, [0, 0.3, 1], [0.005, 0.009, 0.0095]), 0.0095, 0.0105]
    body = limb(path, radii, 10)
    body = body.move(z=-float(body.bounds[0, 2]))
    head = ellipsoid(0.03, 0.024, 0.017, 14, 8).turn(2, 0.85).move(-0.026, -0.036, 0.056)
    eyes = [ball(0.005, 0.005, 0.005, (-0.033 + s * 0.0065, -0.036 - s * 0.0065, 0.063), 8)
            for s in (-1, 1)]  # fmt: skip
    fork = [tube([(-0.035, -0.047, 0.054), (-0.044 + s * 0.002, -0.058 - s * 0.002, 0.052)], 0.0008,
                 5) for s in (-1, 1)]  # fmt: skip
    bands = textures.stripes([color, color, tint_color(color, 0.55)], 9)
    made = shape(
        [
            (join([body, head]), bands),
            (join(eyes), BLACK),
            (join(fork), textures.plain((206, 30, 50))),
        ],
        [hull_above(body.scale(1, 1, 0.42)), hull_of(head)],
    )
    return made.scale(k)


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("spider", spider, (0.104, 0.123, 0.0379), 0.015, ("plastic spider", "rubber spider",
             "toy spider", "halloween spider", "fake spider"), _L, (), ("black",)),
    Category("toy_bat", bat, (0.213, 0.0745, 0.0192), 0.03, ("rubber bat", "plastic bat",
             "vampire bat", "halloween bat", "bat decoration"), _L, (), ("black",), state=_D),
    Category("raven", raven, (0.205, 0.0864, 0.113), 0.2, ("crow", "raven figure", "plastic raven",
             "fake crow", "blackbird", "raven ornament"), _L, (), ("black",)),
    Category("rat", rat, (0.221, 0.0505, 0.0505), 0.04, ("plastic rat", "rubber rat", "toy rat",
             "fake rat", "mouse figurine", "rat figurine", "plush mouse"), _L, (),
             ("gray",)),
    Category("snake", snake, (0.158, 0.13, 0.0692), 0.08, ("rubber snake", "toy snake",
             "plastic snake", "fake snake", "coiled snake", "snake figurine", "cobra"), _L, (),
             ("green",)),
)  # fmt: skip
"""The module's categories."""
