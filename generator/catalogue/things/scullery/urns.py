"""Urns with taps, and fondue sets."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import smooth
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look
from .contraptions import metal

STEEL: RGB = (190, 194, 200)


def _urn(samovar: bool) -> Callable[[Look], Shape]:
    """Return the shape function of an urn with a tap: a bellied samovar or a plain boiler."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.06)
        color = look.color(
            *(
                ("gold", "brass", "silver", "red", "copper")
                if samovar
                else ("silver", "silver", "black", "white")
            )
        )
        if samovar:
            body = lathe([(0, 0), (0.075, 0), (0.07, 0.02), (0.035, 0.045), (0.035, 0.06),
                          (0.07, 0.09), (0.1, 0.19), (0.104, 0.25), (0.09, 0.27), (0.05, 0.285),
                          (0.05, 0.3),
                          (0.062, 0.312), (0, 0.312)], 34)  # fmt: skip
            top = lathe(
                [
                    (0, 0.31),
                    (0.035, 0.31),
                    (0.055, 0.335),
                    (0.05, 0.365),
                    (0.02, 0.38),
                    (0.008, 0.395),
                    (0, 0.398),
                ],
                24,
            )
            z = 0.12
        else:
            body = lathe(
                [(0, 0), (0.1, 0), (0.1, 0.02), (0.105, 0.03), (0.105, 0.29), (0, 0.29)], 34
            )
            top = lathe(
                [(0, 0.285), (0.108, 0.285), (0.1, 0.305), (0.03, 0.315), (0.03, 0.33), (0, 0.332)],
                30,
            )
            z = 0.07
        tap = [
            tube([(0, -0.07, z), (0, -0.14, z), (0, -0.145, z - 0.025)], 0.008, 9),
            cylinder(0.011, 0.02, 12).move(0, -0.125, z - 0.004),
            box(0.034, 0.008, 0.007).move(0, -0.125, z + 0.018),
        ]
        grips = [
            tube(
                smooth(
                    [
                        (s * 0.095, 0, 0.2),
                        (s * 0.13, 0, 0.21),
                        (s * 0.13, 0, 0.245),
                        (s * 0.095, 0, 0.25),
                    ],
                    4,
                ),
                0.007,
                8,
            )
            for s in (-1, 1)
        ]
        dark = textures.plain((44, 36, 32))
        made = [
            (join([body, top]), look.surface(color, "brass" if samovar else "steel")),
            (join(tap[:2]), metal(look, (206, 172, 96) if samovar else STEEL)),
            (join([tap[2], *grips]), dark),
        ]
        made = [(s.scale(k, k, k), t) for s, t in made]
        return shape(
            made,
            [
                hull_of(body.scale(k, k, k)),
                hull_of(top.scale(k, k, k)),
                hull_of(*[t.scale(k, k, k) for t in tap]),
                *[hull_of(g.scale(k, k, k)) for g in grips],
            ],
        )

    return make


def fondue_set(look: Look) -> Shape:
    """A fondue set: a pot of melted cheese on a stand over a burner, long forks in it."""
    k, color = look.between(0.88, 1.06), look.color("red", "orange", "black", "silver", "blue")
    pot = lathe(
        [
            (0, 0.085),
            (0.06, 0.085),
            (0.08, 0.1),
            (0.085, 0.16),
            (0.079, 0.16),
            (0.076, 0.145),
            (0, 0.145),
        ],
        30,
    )
    cheese = cylinder(0.077, 0.002, 28).move(z=0.146)
    ring = torus(0.07, 0.004, 30, 6).move(z=0.09)
    legs = [
        tube(
            smooth(
                [
                    (0.07 * np.cos(a), 0.07 * np.sin(a), 0.09),
                    (0.085 * np.cos(a), 0.085 * np.sin(a), 0.05),
                    (0.09 * np.cos(a), 0.09 * np.sin(a), 0),
                ],
                3,
            ),
            0.005,
            7,
        )
        for a in np.arange(3) * 2.094 + 0.5
    ]
    foot = torus(0.09, 0.004, 30, 6).move(z=0.004)
    lamp = lathe([(0, 0), (0.03, 0), (0.03, 0.03), (0.02, 0.04), (0, 0.04)], 18)
    grip = limb([(0.08, 0, 0.145), (0.12, 0, 0.15), (0.17, 0, 0.155)], [0.007, 0.009, 0.01], 8)
    forks = [
        tube(
            [
                (0.03 * np.cos(a), 0.03 * np.sin(a), 0.146),
                (0.12 * np.cos(a), 0.12 * np.sin(a), 0.24),
            ],
            0.0018,
            6,
        )
        for a in (1.2, 2.5, 4.2)
    ]
    tips = [
        tube(
            [
                (0.1 * np.cos(a), 0.1 * np.sin(a), 0.219),
                (0.14 * np.cos(a), 0.14 * np.sin(a), 0.261),
            ],
            0.0045,
            7,
        )
        for a in (1.2, 2.5, 4.2)
    ]
    made = [
        (pot, look.surface(color, "plastic")),
        (cheese, textures.speckles(look.rng, (250, 214, 110), 8)),
        (join([ring, *legs, foot, lamp, *forks]), metal(look)),
        (join([grip, *tips]), textures.plain((50, 36, 30))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(*[s.scale(k, k, k) for s in (*legs, foot)]),
            hull_of(made[0][0]),
            hull_of(grip.scale(k, k, k)),
            hull_of(*[s.scale(k, k, k) for s in tips]),
        ],
    )


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("samovar", _urn(True), (0.271, 0.246, 0.381), 3.0, ("tea urn", "russian samovar"), _K,
             ("tall", "big"), ("gold",)),
    Category("hot_water_urn", _urn(False), (0.282, 0.26, 0.331), 2.5, ("water urn", "coffee urn",
        "water boiler", "catering urn", "hot drinks urn"), _K, ("tall", "big"), ("silver",)),
    Category("fondue_set", fondue_set, (0.275, 0.248, 0.253), 1.4, ("fondue", "fondue pot",
        "cheese fondue", "chocolate fondue"), _K, _B, ("red",)),
)  # fmt: skip
"""The module's categories."""
