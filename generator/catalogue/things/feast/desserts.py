"""Desserts in glasses and towers, and machines for sweets."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.shape import Shape, shape
from ...build.solids import block, box, ellipsoid, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def gumball_machine(look: Look) -> Shape:
    """A gumball machine: a globe of coloured balls on a red stand with a turning handle."""
    k, color = look.between(0.85, 1.08), look.color("red", "red", "blue", "black", "pink")
    base = lathe(
        [
            (0, 0),
            (0.06, 0),
            (0.062, 0.012),
            (0.045, 0.03),
            (0.045, 0.085),
            (0.056, 0.1),
            (0.05, 0.108),
            (0, 0.108),
        ],
        28,
    )
    globe = ellipsoid(0.145, 0.145, 0.14, 30, 18).move(z=0.17)
    image = prints.canvas(200, 100, (226, 236, 240))
    hues: tuple[RGB, ...] = (
        (206, 44, 44),
        (244, 206, 62),
        (60, 150, 80),
        (52, 104, 190),
        (238, 132, 38),
        (240, 240, 236),
        (230, 120, 170),
    )
    for n in range(230):
        prints.disc(image, look.rng.random(), look.rng.uniform(0.25, 1.0), 0.045, hues[n % 7])
    lid = lathe(
        [(0, 0.232), (0.036, 0.232), (0.032, 0.25), (0.01, 0.256), (0.008, 0.268), (0, 0.27)], 22
    )
    plate = box(0.05, 0.004, 0.05).move(0, -0.046, 0.036)
    handle = [
        box(0.03, 0.008, 0.007).move(0, -0.052, 0.066),
        box(0.024, 0.008, 0.016).move(0, -0.05, 0.036),
    ]
    made = [
        (join([base, lid]), look.surface(color, "plastic")),
        (globe, image),
        (plate, textures.brushed_metal(look.rng, (200, 204, 208))),
        (join(handle), textures.plain((60, 62, 66))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(base.scale(k, k, k)), hull_of(made[1][0]), hull_of(lid.scale(k, k, k))]
    )


def candy_dispenser(look: Look) -> Shape:
    """A candy dispenser: a slim stem with a cartoon head that tips back."""
    k, color = (
        look.between(0.9, 1.1),
        look.color("red", "blue", "yellow", "green", "pink", "purple"),
    )
    stem, foot = box(0.02, 0.014, 0.08).move(z=0.006), block(0.034, 0.03, 0.007, 0.008)
    head = ellipsoid(0.034, 0.03, 0.034, 18, 12).move(z=0.1)
    ears = [ellipsoid(0.016, 0.007, 0.016, 10, 7).move(s * 0.016, 0.002, 0.116) for s in (-1, 1)]
    eyes = [ellipsoid(0.006, 0.004, 0.008, 8, 6).move(s * 0.007, -0.014, 0.104) for s in (-1, 1)]
    nose = ellipsoid(0.008, 0.008, 0.006, 8, 6).move(0, -0.0155, 0.097)
    hue = look.own_color("yellow", "white", "orange", "brown", "black")
    made = [
        (join([stem, foot]), look.surface(color, "plastic")),
        (join([head, *ears]), textures.speckles(look.rng, hue, 3)),
        (join([*eyes]), textures.plain((24, 24, 26))),
        (nose, textures.plain((206, 44, 44))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(foot.scale(k, k, k)), hull_of(stem.scale(k, k, k)), hull_of(made[1][0])]
    )


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
    dark = textures.speckles(look.rng, (84, 52, 36), 6)
    made = [
        (join([wafer, wafer.move(z=0.0228)]), dark),
        (ice, textures.speckles(look.rng, color, 4)),
        (top, image),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0])])


def _glass_sweet(layers: tuple[tuple[str, ...], ...], cream: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a dessert in layers in a glass, cream or fruit on top."""

    def make(look: Look) -> Shape:
        r, h = look.between(0.036, 0.044), look.between(0.07, 0.085)
        hues = [
            look.color(*layer) if n == 0 else look.own_color(*layer)
            for n, layer in enumerate(layers)
        ]
        body = lathe([(0, 0), (0.7 * r, 0), (0.5 * r, 0.08 * h), (0.74 * r, 0.2 * h),
                      (r, 0.95 * h), (r, h), (0.93 * r, h), (0.9 * r, 0.93 * h), (0, 0.93 * h)], 30,
                     v=[0, 0.01, 0.02, 0.06, 0.95, 0.97, 0.98, 0.99, 1])  # fmt: skip
        glass = textures.plain((226, 236, 240))
        bands = [(textures.speckles(look.rng, hue, 10), 0.84 / len(hues)) for hue in hues]
        pieces = [(body, textures.stack((glass, 0.08), *bands, (glass, 0.08)))]
        top = lathe(
            [
                (0, 0.9 * h),
                (0.89 * r, 0.92 * h),
                (0.6 * r, 1.06 * h),
                (0.25 * r, 1.16 * h),
                (0, 1.2 * h),
            ],
            26,
        )
        pieces.append((top, textures.speckles(look.rng, (250, 246, 234) if cream else hues[-1], 5)))
        bits = [
            ellipsoid(0.012, 0.011, 0.012, 9, 6).move(
                0.4 * r * np.cos(a), 0.4 * r * np.sin(a), 1.12 * h
            )
            for a in (0.4, 2.4, 4.6)
        ]
        pieces.append((join(bits), textures.plain((196, 34, 50) if cream else (70, 40, 28))))
        return shape(pieces, [hull_of(body), hull_of(top)])

    return make


def croquembouche(look: Look) -> Shape:
    """A croquembouche: a cone of cream puffs with threads of caramel."""
    k, color = look.between(0.85, 1.05), look.color("amber", "tan", "gold", "wooden")
    puffs, d = [], 0.036
    z, r, ring = 0.016, 0.066, 0
    while r > 0.008:
        count = max(int(2 * np.pi * r / d), 1)
        puffs += [
            ellipsoid(d, d, 0.9 * d, 8, 5).move(
                r * np.cos(2 * np.pi * n / count + ring),
                r * np.sin(2 * np.pi * n / count + ring),
                z,
            )
            for n in range(count)
        ]
        z, r, ring = z + 0.027, r - 0.0105, ring + 1
    puffs.append(ellipsoid(d, d, 0.9 * d, 8, 5).move(z=z))
    a = np.linspace(0, 22, 70)
    caramel = tube(
        np.column_stack(
            [(0.088 - 0.0031 * a) * np.cos(a), (0.088 - 0.0031 * a) * np.sin(a), 0.02 + 0.0078 * a]
        ),
        0.001,
        4,
    )
    plate = lathe([(0, 0), (0.07, 0), (0.1, 0.01), (0.1, 0.012), (0, 0.006)], 32)
    crust = textures.gradient(tint_color(color, 0.8), tint_color(color, 1.2), look.rng)
    made = [
        (plate, textures.plain((246, 244, 240))),
        (join(puffs), crust),
        (caramel, textures.plain((206, 140, 50))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0])])


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("gumball_machine", gumball_machine, (0.141, 0.141, 0.263), 0.9,
             ("bubblegum machine", "sweet dispenser", "gum machine", "candy machine"), _F,
             ("tall", "round"), ("red",)),
    Category("candy_dispenser", candy_dispenser, (0.0469, 0.0346, 0.124), 0.03,
             ("pez",), _F, ("tall",), ("red",)),
    Category("ice_cream_sandwich", ice_cream_sandwich, (0.103, 0.0473, 0.0298), 0.08,
             ("ice cream wafer", "ice-cream sandwich"), _F, _E, ("white",)),
    Category("trifle", _glass_sweet((("crimson", "red", "purple"), ("tan", "wooden"),
                                     ("yellow", "gold")), True), (0.08, 0.0804, 0.0938), 0.25,
                                     ("fruit trifle", "parfait", "sherry trifle",
                                      "knickerbocker glory",
             "cranachan", "eton mess", "fool"), _F, _R, ("red",)),
    Category("chocolate_mousse", _glass_sweet((("brown", "maroon", "brown"), ("brown",)), False),
             (0.0789, 0.0793, 0.0944), 0.2, ("mousse", "chocolate pot", "pot au chocolat",
                                             "chocolate dessert"), _F, _R,
             ("brown",)),
    Category("croquembouche", croquembouche, (0.186, 0.186, 0.181), 0.6,
             ("profiterole tower", "tower of profiteroles", "cream puff tower",
              "profiterole pyramid"), _F, ("edible", "tall"), ("amber",)),
)  # fmt: skip
"""The module's categories."""
