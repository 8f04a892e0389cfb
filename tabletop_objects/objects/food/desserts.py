"""Objects of the ``food`` theme: desserts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import hull_of
from ...kit.primitives import blade
from ...kit.shapes import Category, Shape, category, keep_still, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, sweep, tube
from ...kit.surfaces import Look, tint_color
from .snacks import bun, crust


@category("ice_cream_sandwich", size=(0.103, 0.0473, 0.0298), mass=0.08, material="food",
          aliases=("ice cream wafer", "ice-cream sandwich"), themes=("food",), roles=("edible",),
          colors=("white",))  # fmt: skip
def ice_cream_sandwich(look: Look) -> Shape:
    """An ice cream sandwich: ice cream between two dark biscuits with holes."""
    k, color = look.between(0.9, 1.1), look.color("white", "cream", "pink", "brown")
    wafer = block(0.1, 0.046, 0.006, 0.004)
    ice = block(0.096, 0.043, 0.018, 0.004).move(z=0.005)
    image = prints.canvas(128, 64, (84, 52, 36))
    for i in range(9):
        for j in range(3):
            prints.disc(image, (i + 0.5) / 9, (j + 0.5) / 3, 0.05, (50, 30, 22))
    top = box(0.096, 0.042, 0.0004).move(z=0.0286)
    dark = surfaces.speckles(look.rng, (84, 52, 36), 6)
    made = [(join([wafer, wafer.move(z=0.0228)]), dark),
            (ice, surfaces.speckles(look.rng, color, 4)), (top, image)]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0])])


def _glass_sweet(layers: tuple[tuple[str, ...], ...], cream: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a layered dessert in a glass, with cream or fruit on top."""

    def make(look: Look) -> Shape:
        r, h = look.between(0.036, 0.044), look.between(0.07, 0.085)
        hues = [look.color(*layer) if n == 0 else look.own_color(*layer) for n,
                layer in enumerate(layers)]  # fmt: skip
        body = lathe([(0, 0), (0.7 * r, 0), (0.5 * r, 0.08 * h), (0.74 * r, 0.2 * h),
                      (r, 0.95 * h), (r, h), (0.93 * r, h), (0.9 * r, 0.93 * h), (0, 0.93 * h)], 30,
                     v=[0, 0.01, 0.02, 0.06, 0.95, 0.97, 0.98, 0.99, 1])  # fmt: skip
        glass = surfaces.plain((226, 236, 240))
        bands = [(surfaces.speckles(look.rng, hue, 10), 0.84 / len(hues)) for hue in hues]
        pieces = [(body, surfaces.stack((glass, 0.08), *bands, (glass, 0.08)))]
        top = lathe([(0, 0.9 * h), (0.89 * r, 0.92 * h), (0.6 * r, 1.06 * h), (0.25 * r, 1.16 * h),
                     (0, 1.2 * h)], 26)  # fmt: skip
        pieces.append((top, surfaces.speckles(look.rng, (250, 246, 234) if cream else hues[-1], 5)))
        bits = [ellipsoid(0.012, 0.011, 0.012, 9, 6).move(0.4 * r * np.cos(a), 0.4 * r * np.sin(a),
                                                          1.12 * h)
                for a in (0.4, 2.4, 4.6)]  # fmt: skip
        pieces.append((join(bits), surfaces.plain((196, 34, 50) if cream else (70, 40, 28))))
        return shape(pieces, [hull_of(body), hull_of(top)])

    return make


@category("croquembouche", size=(0.186, 0.186, 0.181), mass=0.6, material="food",
          aliases=("profiterole tower", "tower of profiteroles", "cream puff tower",
          "profiterole pyramid"), themes=("food",), roles=("edible", "tall"),
          colors=("amber",))  # fmt: skip
def croquembouche(look: Look) -> Shape:
    """A croquembouche: a cone of cream puffs with threads of caramel."""
    k, color = look.between(0.85, 1.05), look.color("amber", "tan", "gold", "wooden")
    puffs, d = [], 0.036
    z, r, ring = 0.016, 0.066, 0
    while r > 0.008:
        count = max(int(2 * np.pi * r / d), 1)
        puffs += [ellipsoid(d, d, 0.9 * d, 8, 5).move(r * np.cos(2 * np.pi * n / count + ring), r
                                                      * np.sin(2 * np.pi * n / count + ring), z)
                  for n in range(count)]  # fmt: skip
        z, r, ring = z + 0.027, r - 0.0105, ring + 1
    puffs.append(ellipsoid(d, d, 0.9 * d, 8, 5).move(z=z))
    a = np.linspace(0, 22, 70)
    caramel = tube(np.column_stack([(0.088 - 0.0031 * a) * np.cos(a), (0.088 - 0.0031 * a)
                                    * np.sin(a), 0.02 + 0.0078 * a]), 0.001, 4)  # fmt: skip
    plate = lathe([(0, 0), (0.07, 0), (0.1, 0.01), (0.1, 0.012), (0, 0.006)], 32)
    crust = surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.2), look.rng)
    made = [(plate, surfaces.plain((246, 244, 240))), (join(puffs), crust),
            (caramel, surfaces.plain((206, 140, 50)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0])])


@category("taiyaki", size=(0.136, 0.0683, 0.0276), mass=0.1, material="food",
          aliases=("fish waffle", "fish shaped cake"), themes=("food",), roles=("edible",),
          colors=("wooden",), state="lying flat")  # fmt: skip
def taiyaki(look: Look) -> Shape:
    """A taiyaki: a fish-shaped waffle with pressed scales, lying flat."""
    k, color = look.between(0.88, 1.08), look.color("wooden", "copper", "amber", "tan")
    side = smooth([(-0.065, 0.0), (-0.05, -0.024), (-0.01, -0.034), (0.03, -0.018), (0.042, -0.012),
                   (0.07, -0.03), (0.066, 0.0), (0.07, 0.03), (0.042, 0.012), (0.03, 0.018),
                   (-0.01, 0.034), (-0.05, 0.024), (-0.065, 0.0)], 3)[:-1]  # fmt: skip
    body = join([prism(side, 0, 0.024, 0.0)])
    y, x = np.mgrid[0:96, 0:160]
    scale = np.abs(np.sin(np.pi * (x / 14 + 0.5 * ((y // 12) % 2)))) * np.abs(
        np.sin(np.pi * y / 12)
    )
    image = np.clip(np.array(color) * (0.72 + 0.4 * scale[..., None]), 0, 255).astype(np.uint8)
    image[:, :52] = np.clip(np.array(color), 0, 255)
    eye = [cylinder(0.005, 0.003, 14).move(-0.044, 0.004, 0.0225)]
    fin = blade([(-0.01, 0.01, 0.024), (0.006, 0.02, 0.026), (0.02, 0.022, 0.024)], 0.012)
    return shape([(body.scale(k, k, k), image), (join([*eye, fin]).scale(k, k, k),
                                                 surfaces.plain(tint_color(color, 0.6)))],
                 [hull_of(body.scale(k, k, k))])  # fmt: skip


@category("churro", size=(0.15, 0.0355, 0.0217), mass=0.03, material="food",
          aliases=("churros stick", "youtiao"), themes=("food",), roles=("edible",),
          colors=("copper",), state="lying")  # fmt: skip
@keep_still
def churro(look: Look) -> Shape:
    """A churro: a ridged stick of fried dough rolled in sugar."""
    long, r = look.between(0.13, 0.18), look.between(0.009, 0.012)
    color, bend = look.color("copper", "wooden", "bronze"), look.between(0.0, 0.02)
    u = np.linspace(-1, 1, 15)
    a = np.arange(16) * np.pi / 8
    section = (
        np.column_stack([np.cos(a), np.sin(a)]) * (1 + 0.14 * (-1.0) ** np.arange(16))[:, None]
    )

    body = sweep(np.column_stack([long / 2 * u, bend * u * u, 0 * u]), section, r)
    return settle([(body, surfaces.spots(look.rng, color, (246, 232, 206), 0.12))], 0.1)


@category("concha", size=(0.0991, 0.0991, 0.0461), mass=0.08, material="food",
          aliases=("pan dulce", "mexican sweet bread", "melon pan"), themes=("food",),
          roles=("edible", "round"), colors=("pink",))  # fmt: skip
def concha(look: Look) -> Shape:
    """A concha: a round, sweet bun with a shell pattern of sugar paste."""
    r, color = look.between(0.045, 0.056), look.color("pink", "yellow", "white", "brown", "cream")
    bun = lathe([(0, 0), (0.9 * r, 0), (r, 0.2 * r), (0.9 * r, 0.55 * r), (0.5 * r, 0.82 * r),
                 (0, 0.88 * r)], 32)  # fmt: skip
    y, x = np.mgrid[0:128, 0:128]
    lines = (np.abs(((x / 128 * 12 + 0.5 * np.sin(y / 20)) % 1) - 0.5) < 0.12) | (
        np.abs(((y / 128 * 9) % 1) - 0.5) < 0.08
    )
    top = np.where(lines[..., None], np.array((226, 180, 120)), np.array(color)).astype(np.uint8)
    cap = lathe([(0, 0.5 * r), (0.92 * r, 0.5 * r), (0.92 * r, 0.58 * r), (0.52 * r, 0.86 * r),
                 (0, 0.93 * r)], 32)  # fmt: skip
    return shape([(bun, crust(look, (206, 150, 84))), (cap, top)], [hull_of(bun, cap)])


CATEGORIES = (
    Category("trifle", _glass_sweet((("crimson", "red", "purple"), ("tan", "wooden"), ("yellow",
             "gold")), True), size=(0.08, 0.0804, 0.0938), mass=0.25, material="glass",
             aliases=("fruit trifle", "parfait", "sherry trifle", "knickerbocker glory",
             "cranachan", "eton mess", "fool"), themes=("food",), roles=("edible", "round"),
             colors=("red",)),
    Category("chocolate_mousse", _glass_sweet((("brown", "maroon", "brown"), ("brown",)), False),
             size=(0.0789, 0.0793, 0.0944), mass=0.2, material="glass",
             aliases=("mousse", "chocolate pot", "pot au chocolat", "chocolate dessert"),
             themes=("food",), roles=("edible", "round"), colors=("brown",)),
    Category("mochi",
             bun((0.038, 0.05), 0.75, ("white", "pink", "mint", "lavender", "cream"), "mochi"),
             size=(0.0446, 0.0446, 0.0301), mass=0.045, material="food",
             aliases=("daifuku", "mochi ball"), themes=("food",), roles=("edible", "round"),
             colors=("white",)),
    Category("dorayaki", bun((0.085, 0.1), 0.42, ("copper", "wooden", "bronze"), "sandwich"),
             size=(0.0922, 0.0928, 0.0405), mass=0.07, material="food",
             aliases=("red bean pancake", "whoopie pie"), themes=("food",),
             roles=("edible", "round"), colors=("copper",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
