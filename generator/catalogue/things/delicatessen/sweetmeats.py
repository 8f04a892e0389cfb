"""Fried balls and fritters, stuffed leaves, sweets of India and Turkey."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part
from ...build.settled import rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, ellipsoid, lathe, prism, torus
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def rough_ball(
    form: tuple[float, float, float],
    palette: tuple[str, ...],
    tone: float,
    bumps: float,
    spot: float,
    glossy: RGB | None = None,
) -> Callable[[Look], Shape]:
    """Return a ball of dough, meat or batter: smooth or knobbly."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        x, y, z = (v * k for v in form)
        color = tint_color(look.color(*palette), tone)
        body = ellipsoid(x, y, z, 20, 12)
        a = look.rng.uniform(0, 6, 3)
        body = body.bend(lambda p: p * (1 + bumps * (np.sin(240 * p[:, :1] + a[0]) + np.sin(
            260 * p[:, 1:2] + a[1]) + np.sin(230 * p[:, 2:] + a[2]))))  # fmt: skip
        tile = textures.spots(look.rng, color, tint_color(color, 0.72), spot)
        pieces = [(body, tile)]
        if glossy is not None:
            nuts = scatter(look, 0.16 * x, 5, (0.0035, 0.005), 0.49 * z)
            pieces.append((nuts, textures.plain(glossy)))
        return settle(pieces, 0.14)

    return make


def ring_fritter(look: Look) -> Shape:
    """Vada: a fried savoury ring."""
    r, t = look.between(0.023, 0.026), look.between(0.013, 0.015)
    body = torus(r, t, 28, 10).scale(1, 1, 0.9)
    return settle([(body, textures.spots(look.rng, look.color("copper", "amber"), (140, 76, 30),
                                         0.3))], 0.12)  # fmt: skip


def steamed_bun(look: Look) -> Shape:
    """Idli: a soft white steamed cake."""
    r, h = look.between(0.034, 0.04), look.between(0.022, 0.027)
    body = lathe([(0, 0), (0.5 * r, 0.0), (0.88 * r, 0.3 * h), (r, 0.55 * h), (0.8 * r, 0.85 * h),
                  (0.4 * r, h), (0, h)], 28)  # fmt: skip
    return settle([(body, textures.spots(look.rng, look.color("white", "ivory"), (232, 228, 216),
                                         0.2))], 0.04)  # fmt: skip


def dosa(look: Look) -> Shape:
    """A long crisp pancake rolled to an open tube."""
    long, r = look.between(0.24, 0.3), look.between(0.026, 0.032)
    t = np.linspace(0.2, 2 * np.pi + 1.0, 26)
    away = r * (0.8 + 0.05 * t)
    outer = np.column_stack([away * np.cos(t), away * np.sin(t)])
    inner = outer * (1 - 0.0018 / away)[:, None]
    sheet = prism(np.concatenate([outer, inner[::-1]]), -long / 2, long / 2).turn(1, np.pi / 2)
    tone = tint_color(look.color("amber", "copper"), 1.08)
    return settle([(sheet.scale(1, 1.15, 0.8), textures.spots(look.rng, tone, tint_color(
                   tone, 0.75), 0.3))], 0.06)  # fmt: skip


def sugared_cube(look: Look) -> Shape:
    """Turkish delight: a soft cube dusted with sugar."""
    x, h = look.between(0.023, 0.028), look.between(0.02, 0.024)
    color = look.color("pink", "yellow", "coral", "mint", "orange")
    body = block(x, x, h, 0.003, 0.002)
    return shape([(body, textures.spots(look.rng, tint_color(color, 1.3), (252, 250, 248), 0.4))],
                 [box_part(x, x, h)])  # fmt: skip


def barfi(look: Look) -> Shape:
    """A square of milk sweet with a leaf of silver and pistachio."""
    x, h = look.between(0.032, 0.04), look.between(0.014, 0.018)
    color = look.color("cream", "ivory", "mint", "pink", "tan")
    body = block(x, x, h, 0.001, 0.0008)
    leaf = box(0.75 * x, 0.75 * x, 0.0006).turn(2, 0.3).move(z=h - 0.0003)
    nuts = scatter(look, 0.25 * x, 7, (0.004, 0.006), h, stretch=(1, 0.5, 0.4))
    return shape([(body, textures.speckles(look.rng, tint_color(color, 1.05), 7)),
                  (leaf, textures.brushed_metal(look.rng, (206, 210, 214))),
                  (nuts, textures.plain((124, 158, 70)))], [box_part(x, x, h)])  # fmt: skip


def dolma(look: Look) -> Shape:
    """A vine leaf rolled around rice."""
    body = rod(look.between(0.055, 0.065), look.between(0.0105, 0.0125), blunt=6)
    green = look.color("olive", "olive", "green")
    veins = textures.leaf(look.rng, tint_color(green, 0.8))
    return settle([(body, veins)], 0.12)


def puri_shell(look: Look) -> Shape:
    """A hollow crisp ball, broken open above and filled."""
    r = look.between(0.021, 0.025)
    ball_ = lathe([(0, 0), (0.5 * r, 0.06 * r), (0.92 * r, 0.55 * r), (r, r), (0.86 * r, 1.45 * r),
                   (0.55 * r, 1.68 * r), (0.5 * r, 1.62 * r), (0.3 * r, 1.35 * r), (0, 1.35 * r)],
                  22)  # fmt: skip
    fill = scatter(look, 0.4 * r, 9, (0.007, 0.01), 1.5 * r)
    gold = textures.spots(look.rng, look.color("amber", "tan"), (170, 104, 44), 0.2)
    return settle([(ball_, gold), (fill, textures.speckles(look.rng, (116, 140, 60), 16))], 0.1,
                  hulls=[[0]])  # fmt: skip


_K = ("kitchen", "dining")
_E = ("edible",)
_R = ("edible", "round")
_L = "lying flat"


CATEGORIES = (
    Category("onion_bhaji", rough_ball((0.052, 0.048, 0.038), ("amber", "copper"), 0.95, 0.035,
             0.35), (0.0522, 0.0483, 0.0331), 0.04, ("bhaji", "pakora", "vegetable pakora",
             "onion pakora", "hush puppy", "arancini", "onion bhajis", "bhajis"), _K, _R,
             ("amber",)),
    Category("falafel", rough_ball((0.04, 0.04, 0.034), ("brown", "bronze"), 1.1, 0.015, 0.35),
             (0.0418, 0.042, 0.0305), 0.03, ("falafel ball",), _K, _R, ("brown",)),
    Category("kibbeh", rough_ball((0.075, 0.034, 0.034), ("brown", "copper"), 0.9, 0.006, 0.3),
             (0.0729, 0.0333, 0.0287), 0.05, ("kibbe", "kubbeh", "coxinha"), _K, _E, ("brown",),
             state=_L),
    Category("gulab_jamun", rough_ball((0.034, 0.034, 0.032), ("brown", "copper"), 0.72, 0.0, 0.05,
             (150, 180, 90)), (0.0339, 0.0339, 0.0291), 0.03, ("gulab jaman", "rasgulla"), _K, _R,
             ("brown",)),
    Category("laddu", rough_ball((0.042, 0.042, 0.038), ("orange", "amber", "yellow"), 1.0, 0.02,
             0.4, (226, 206, 150)), (0.0414, 0.0416, 0.0343), 0.045, ("ladoo", "laddoo",
             "besan laddu", "motichoor laddu", "laddus"), _K, _R, ("orange",)),
    vary(Category("vada", ring_fritter, (0.0773, 0.0773, 0.0215), 0.05, ("medu vada", "vadai",
             "vada fritter", "vadas"), _K, _R, ("copper",))),
    Category("idli", steamed_bun, (0.0727, 0.0727, 0.0236), 0.04, ("idly", "steamed rice cake",
             "idlis"), _K, _R, ("white",)),
    Category("dosa", dosa, (0.279, 0.0668, 0.0447), 0.12, ("masala dosa", "rolled pancake",
             "injera"), _K, ("edible", "big"), ("amber",), state=_L),
    Category("turkish_delight", sugared_cube, (0.026, 0.026, 0.0227), 0.015, ("lokum",
             "piece of turkish delight", "cube of turkish delight"), _K, _E, ("pink",)),
    Category("barfi", barfi, (0.0352, 0.0352, 0.0174), 0.025, ("burfi", "kaju katli", "milk sweet",
             "indian sweet", "fudge square", "barfis", "burfis"), _K, _E, ("cream",)),
    Category("dolma", dolma, (0.061, 0.0234, 0.0201), 0.025, ("stuffed vine leaf", "dolmades",
             "stuffed grape leaf", "cabbage roll", "dolmathes"), _K, _E, ("olive",), state=_L),
    Category("pani_puri", puri_shell, (0.0462, 0.0467, 0.036), 0.015, ("golgappa", "puri", "poori",
             "panipuri", "pani puris", "puris"), _K, _R, ("amber",)),
)  # fmt: skip
"""The module's categories."""
