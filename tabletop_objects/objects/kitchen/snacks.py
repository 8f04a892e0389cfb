"""Objects of the ``kitchen`` theme: snacks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.primitives import bent_rod, limb, scatter
from ...kit.shapes import Category, Shape, category, settle, vary
from ...kit.solids import box, ellipsoid, join, lathe, prism, torus
from ...kit.surfaces import RGB, Look, tint_color
from .nuts import Heap, heap


def rough_ball(
    form: tuple[float, float, float],
    palette: tuple[str, ...],
    tone: float,
    bumps: float,
    spot: float,
    glossy: RGB | None = None,
) -> Callable[[Look], Shape]:
    """Return the shape function of a smooth or knobbly ball of dough, meat or batter."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        x, y, z = (v * k for v in form)
        color = tint_color(look.color(*palette), tone)
        body = ellipsoid(x, y, z, 20, 12)
        a = look.rng.uniform(0, 6, 3)
        body = body.bend(lambda p: p * (1 + bumps * (np.sin(240 * p[:, :1] + a[0]) + np.sin(
            260 * p[:, 1:2] + a[1]) + np.sin(230 * p[:, 2:] + a[2]))))  # fmt: skip
        tile = surfaces.spots(look.rng, color, tint_color(color, 0.72), spot)
        pieces = [(body, tile)]
        if glossy is not None:
            nuts = scatter(look, 0.16 * x, 5, (0.0035, 0.005), 0.49 * z)
            pieces.append((nuts, surfaces.plain(glossy)))
        return settle(pieces, 0.14)

    return make


@category("vada", size=(0.0773, 0.0773, 0.0215), mass=0.05, material="food",
          aliases=("medu vada", "vadai", "vada fritter", "vadas"), themes=("kitchen", "dining"),
          roles=("edible", "round"), colors=("copper",))  # fmt: skip
@vary()
def vada(look: Look) -> Shape:
    """A vada: a fried savoury ring."""
    r, t = look.between(0.023, 0.026), look.between(0.013, 0.015)
    body = torus(r, t, 28, 10).scale(1, 1, 0.9)
    return settle([(body, surfaces.spots(look.rng, look.color("copper", "amber"), (140, 76, 30),
                                         0.3))], 0.12)  # fmt: skip


@category("idli", size=(0.0727, 0.0727, 0.0236), mass=0.04, material="food",
          aliases=("idly", "steamed rice cake", "idlis"), themes=("kitchen", "dining"),
          roles=("edible", "round"), colors=("white",))  # fmt: skip
def idli(look: Look) -> Shape:
    """An idli: a soft, white steamed cake."""
    r, h = look.between(0.034, 0.04), look.between(0.022, 0.027)
    body = lathe([(0, 0), (0.5 * r, 0.0), (0.88 * r, 0.3 * h), (r, 0.55 * h), (0.8 * r, 0.85 * h),
                  (0.4 * r, h), (0, h)], 28)  # fmt: skip
    return settle([(body, surfaces.spots(look.rng, look.color("white", "ivory"), (232, 228, 216),
                                         0.2))], 0.04)  # fmt: skip


@category("dosa", size=(0.279, 0.0668, 0.0447), mass=0.12, material="food",
          aliases=("masala dosa", "rolled pancake", "injera"), themes=("kitchen", "dining"),
          roles=("edible", "big"), colors=("amber",), state="lying flat")  # fmt: skip
def dosa(look: Look) -> Shape:
    """A dosa: a long, crisp pancake rolled into an open tube."""
    long, r = look.between(0.24, 0.3), look.between(0.026, 0.032)
    t = np.linspace(0.2, 2 * np.pi + 1.0, 26)
    away = r * (0.8 + 0.05 * t)
    outer = np.column_stack([away * np.cos(t), away * np.sin(t)])
    inner = outer * (1 - 0.0018 / away)[:, None]
    sheet = prism(np.concatenate([outer, inner[::-1]]), -long / 2, long / 2).turn(1, np.pi / 2)
    tone = tint_color(look.color("amber", "copper"), 1.08)
    return settle([(sheet.scale(1, 1.15, 0.8), surfaces.spots(look.rng, tone, tint_color(
                   tone, 0.75), 0.3))], 0.06)  # fmt: skip


@category("dolma", size=(0.061, 0.0234, 0.0201), mass=0.025, material="food",
          aliases=("stuffed vine leaf", "dolmades", "stuffed grape leaf", "cabbage roll",
          "dolmathes"), themes=("kitchen", "dining"), roles=("edible",), colors=("olive",),
          state="lying flat")  # fmt: skip
def dolma(look: Look) -> Shape:
    """A dolma: a vine leaf rolled around rice."""
    body = bent_rod(look.between(0.055, 0.065), look.between(0.0105, 0.0125), blunt=6)
    green = look.color("olive", "olive", "green")
    veins = surfaces.leaf(look.rng, tint_color(green, 0.8))
    return settle([(body, veins)], 0.12)


@category("pani_puri", size=(0.0462, 0.0467, 0.036), mass=0.015, material="food",
          aliases=("golgappa", "puri", "poori", "panipuri", "pani puris", "puris"),
          themes=("kitchen", "dining"), roles=("edible", "round"), colors=("amber",))  # fmt: skip
def pani_puri(look: Look) -> Shape:
    """A pani puri: a hollow, crisp ball, broken open at the top and filled."""
    r = look.between(0.021, 0.025)
    ball_ = lathe([(0, 0), (0.5 * r, 0.06 * r), (0.92 * r, 0.55 * r), (r, r), (0.86 * r, 1.45 * r),
                   (0.55 * r, 1.68 * r), (0.5 * r, 1.62 * r), (0.3 * r, 1.35 * r), (0, 1.35 * r)],
                  22)  # fmt: skip
    fill = scatter(look, 0.4 * r, 9, (0.007, 0.01), 1.5 * r)
    gold = surfaces.spots(look.rng, look.color("amber", "tan"), (170, 104, 44), 0.2)
    return settle([(ball_, gold), (fill, surfaces.speckles(look.rng, (116, 140, 60), 16))], 0.1,
                  hulls=[[0]])  # fmt: skip


@category("pretzel", size=(0.152, 0.11, 0.0212), mass=0.08, material="food",
          aliases=("soft pretzel", "brezel", "salted pretzel"), themes=("kitchen", "dining"),
          roles=("edible", "flat"), colors=("brown",), state="lying flat")  # fmt: skip
def pretzel(look: Look) -> Shape:
    """A salted pretzel knot lying flat."""
    k, r = look.between(0.95, 1.15), look.between(0.0072, 0.009)
    half = [(0.0, -0.054), (0.036, -0.046), (0.062, -0.014), (0.057, 0.024), (0.03, 0.032),
            (0.004, 0.002), (-0.024, -0.04)]  # fmt: skip
    first = [(x, y, 0.0 if n < 4 else 0.0035) for n, (x, y) in enumerate(half)]
    second = [(-x, y, 0.0 if n < 4 else 0.0065) for n, (x, y) in enumerate(half)]
    path = k * np.array([*second[::-1], *first[1:]])
    radii = r * np.concatenate([[0.55, 0.7], np.full(len(path) - 4, 1.0), [0.7, 0.55]])
    knot = limb(path, [*radii], 10)
    salt = []
    points = smooth(path, 4)
    for _ in range(22):
        n = int(look.rng.integers(4, len(points) - 4))
        x, y, z = points[n]
        salt.append(box(0.003, 0.0025, 0.0022).turn(2, look.between(0, 3)).move(
            x, y, z + 0.85 * r))  # fmt: skip
    brown = skin(look, look.color("bronze", "brown", "copper"), (104, 56, 26), 0.6)
    return settle([(knot, brown), (join(salt), surfaces.plain((250, 248, 240)))], 0.15)


CATEGORIES = (
    Category("onion_bhaji",
             rough_ball((0.052, 0.048, 0.038), ("amber", "copper"), 0.95, 0.035, 0.35),
             size=(0.0522, 0.0483, 0.0331), mass=0.04, material="food", aliases=("bhaji", "pakora",
             "vegetable pakora", "onion pakora", "hush puppy", "arancini", "onion bhajis",
             "bhajis"), themes=("kitchen", "dining"), roles=("edible", "round"), colors=("amber",)),
    Category("falafel", rough_ball((0.04, 0.04, 0.034), ("brown", "bronze"), 1.1, 0.015, 0.35),
             size=(0.0418, 0.042, 0.0305), mass=0.03, material="food", aliases=("falafel ball",),
             themes=("kitchen", "dining"), roles=("edible", "round"), colors=("brown",)),
    Category("kibbeh", rough_ball((0.075, 0.034, 0.034), ("brown", "copper"), 0.9, 0.006, 0.3),
             size=(0.0729, 0.0333, 0.0287), mass=0.05, material="food",
             aliases=("kibbe", "kubbeh", "coxinha"), themes=("kitchen", "dining"),
             roles=("edible",), colors=("brown",), state="lying flat"),
    Category("kibble",
             heap(Heap((0.028, 0.036), 0.009, "ball", ("brown", "copper", "tan", "bronze"))),
             size=(0.0722, 0.0722, 0.0228), mass=0.03, material="food", aliases=("dry dog food",
             "dry cat food", "pet kibble", "dog kibble", "cat kibble", "cat biscuit",
             "heap of kibble", "pile of kibble", "mound of kibble", "kibble heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("brown",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
