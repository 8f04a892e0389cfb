"""Filled rolls and pockets for lunch, and crisps."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import ellipse, rectangle
from ...build.recipes import pad
from ...build.settled import scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import box, ellipsoid, join, prism
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

BAKED = ("wooden", "tan", "amber", "copper")


def crust(look: Look, color: RGB) -> textures.Tile:
    """Return baked dough, darker below."""
    return textures.gradient(tint_color(color, 0.8), tint_color(color, 1.2), look.rng, 14)


def toasted_slice(look: Look, color: RGB) -> textures.Tile:
    """Return pale dough with brown spots."""
    return textures.spots(look.rng, tint_color(color, 1.35), tint_color(color, 0.7), 0.12)


def sausage_roll(look: Look) -> Shape:
    """A sausage roll: scored flaky pastry round a pink filling, lying."""
    long, color = look.between(0.075, 0.12), look.color(*BAKED)
    body = (
        prism(rectangle(0.046, 0.032, 0.013), -long / 2, long / 2)
        .turn(0, np.pi / 2)
        .turn(2, np.pi / 2)
        .move(z=0.016)
    )
    meat = (
        prism(rectangle(0.032, 0.02, 0.0095), -long / 2 - 0.001, long / 2 + 0.001)
        .turn(0, np.pi / 2)
        .turn(2, np.pi / 2)
        .move(z=0.015)
    )
    cuts = [
        box(0.003, 0.03, 0.002).turn(2, 0.4).move(x, 0, 0.0312)
        for x in np.linspace(-0.36, 0.36, 5) * long
    ]
    return settle(
        [
            (body, crust(look, color)),
            (meat, textures.spots(look.rng, (206, 140, 116), (160, 96, 80), 0.2)),
            (join(cuts), textures.plain(tint_color(color, 0.6))),
        ],
        0.0,
        hulls=[[0]],
    )


def pita(look: Look) -> Shape:
    """A pita pocket: a half round bread open at its straight side, filling coming out."""
    k, color = look.between(0.88, 1.1), look.color("tan", "beige", "wooden")
    half = ellipsoid(0.15, 0.15, 0.034, 28, 10).bend(
        lambda p: np.column_stack([p[:, 0], np.minimum(p[:, 1], 0.0), p[:, 2]])
    )
    balls = [
        ellipsoid(0.03, 0.03, 0.026, 12, 8).move(x, 0.004, 0.004) for x in (-0.034, 0.0, 0.036)
    ]
    leaves = (
        scatter(look, 0.012, 14, (0.016, 0.026), 0.0, stretch=(1, 0.6, 0.3))
        .scale(4.2, 1, 1)
        .move(0, 0.01, 0.006)
    )
    red = [
        ellipsoid(0.022, 0.02, 0.006, 10, 6).turn(0, 0.9).move(x, 0.014, 0.006)
        for x in (-0.05, -0.014, 0.02, 0.052)
    ]
    return settle(
        [
            (half, toasted_slice(look, color)),
            (join(balls), crust(look, (150, 96, 54))),
            (leaves, textures.plain((110, 164, 76))),
            (join(red), textures.plain((206, 56, 46))),
        ],
        0.06,
        hulls=[[0], [1, 3]],
    ).scale(k)


def _long_roll(long: tuple[float, float], ridged: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a filled long roll, toasted with grill marks or crusty."""

    def make(look: Look) -> Shape:
        size, color = look.between(*long), look.color(*BAKED)
        w, h = 0.36 * size, 0.13 * size
        low, top = (
            pad(size, w, h, 0.16 * size, soft=0.4),
            pad(size, w, h, 0.16 * size, soft=0.5).move(z=1.65 * h),
        )
        fill = [
            prism(rectangle(0.97 * size, 1.05 * w, 0.15 * size), z * h, (z + 0.26) * h)
            for z in (0.95, 1.2, 1.45)
        ]
        greens = scatter(look, 0.5 * w, 22, (0.012, 0.02), 1.35 * h, stretch=(1, 0.5, 0.4)).scale(
            2.4, 1, 1
        )
        pieces = [
            (join([low, top]), crust(look, color)),
            (fill[0], textures.plain((226, 130, 120))),
            (fill[1], textures.plain((250, 206, 90))),
            (fill[2], textures.plain((120, 170, 80))),
            (greens, textures.plain((236, 130, 50) if not ridged else (110, 160, 70))),
        ]
        if ridged:
            marks = [
                box(0.006, 0.84 * w, 0.002).turn(2, 0.5).move(x, 0, 2.63 * h)
                for x in np.linspace(-0.36, 0.36, 7) * size
            ]
            pieces.append((join(marks), textures.plain((90, 54, 32))))
        return shape(pieces, [hull_of(low), hull_of(top, *fill)])

    return make


def potato_crisp(look: Look) -> Shape:
    """A thin crisp of golden potato with blisters and brown spots."""
    outline = ellipse(look.between(0.042, 0.056), look.between(0.034, 0.042), 24)
    outline = outline * (1 + 0.05 * look.rng.normal(size=(24, 1)))
    color = look.color("amber", "gold")
    body = prism(outline, 0, 0.0026, 0.0008)
    blisters = [
        ellipsoid(0.008, 0.007, 0.0016, 8, 5).move(0.3 * x, 0.3 * y, 0.0026)
        for x, y in outline[[2, 11, 19]]
    ]
    skin = textures.spots(look.rng, tint_color(color, 1.15), tint_color(color, 0.7), 0.06)
    return shape([(body, skin), (join(blisters), textures.plain(tint_color(color, 1.25)))],
                 [hull_of(body)])  # fmt: skip


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("potato_crisp", potato_crisp, (0.049, 0.038, 0.0034), 0.002, ("single crisp",
        "single chip"), _F, _E, ("amber",), state="lying flat"),
    Category("sausage_roll", sausage_roll, (0.1, 0.046, 0.0332), 0.07, ("mini sausage roll",
        "pig in blanket"), _F, _E, ("wooden",), state="lying"),
    Category("pita_pocket", pita, (0.159, 0.102, 0.0313), 0.2, ("filled pita", "pita sandwich",
        "falafel pita", "stuffed pita", "falafel wrap"), _F, _E, ("tan",), state="lying"),
    Category("panini", _long_roll((0.16, 0.19), True), (0.173, 0.0668, 0.0601), 0.22,
             ("toasted panini", "pressed sandwich"), _F, _E, ("wooden",), state="lying flat"),
    Category("banh_mi", _long_roll((0.2, 0.25), False), (0.227, 0.088, 0.0783), 0.25,
             ("sub sandwich", "submarine sandwich", "baguette sandwich",
              "filled baguette", "hoagie"), _F, _E, ("wooden",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
