"""Tins and tubs of pet food."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look


def tin(
    words: tuple[str, ...], r: float, h: float, palette: tuple[str, ...], sign: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a tin with a ring pull, its label naming what is in it."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.93, 1.07), look.color(*palette)
        image = prints.canvas(320, 128, color)
        for start in (0.0, 0.5):
            part = image[:, int(320 * start) : int(320 * start) + 160]
            prints.disc(part, 0.5, 0.64, 0.27, tint_color(color, 1.6))
            _sign(part, sign, tint_color(color, 0.5))
            prints.write(part, look.pick(list(words)), 0.5, 0.2, 0.2, readable_on(color), bold=True)
        image = np.roll(image, 80, axis=1)
        rim = textures.plain((200, 202, 206))
        body = lathe([(0, 0), (r, 0), (r, h), (0, h)], 32, v=[0, 0, 1, 1])
        rings = [torus(r, 0.0014, 32, 6).move(z=z) for z in (0.0015, h - 0.0005)]
        lid = cylinder(0.97 * r, 0.001, 28).move(z=h - 0.0004)
        pull = [
            torus(0.0085, 0.0013, 16, 6).scale(1.2, 0.9, 1).move(0.3 * r, 0, h + 0.002),
            box(0.016, 0.008, 0.002).move(0.0, 0, h),
        ]
        made = [(body, image), (join([*rings, lid, *pull]), rim)]
        return shape([(s.scale(k, k, k), t) for s, t in made], [hull_of(body.scale(k, k, k))])

    return make


def _sign(image: prints.Canvas, sign: str, ink: RGB) -> None:
    if sign == "cat":
        prints.disc(image, 0.5, 0.68, 0.15, ink)
        for s in (-1, 1):
            prints.polygon(
                image, [(0.5 + 0.12 * s, 0.64), (0.5 + 0.11 * s, 0.43), (0.5 + 0.02 * s, 0.55)], ink
            )
    elif sign == "dog":
        prints.fill(image, 0.4, 0.6, 0.2, 0.09, ink)
        for x in (0.38, 0.62):
            for y in (0.58, 0.71):
                prints.disc(image, x, y, 0.07, ink)
    else:
        prints.disc(image, 0.48, 0.64, 0.13, ink)
        prints.polygon(image, [(0.56, 0.64), (0.68, 0.52), (0.68, 0.76)], ink)


_P = ("living",)

CATEGORIES = (
    Category("cat_food_tin", tin(("CAT", "MIAOW", "TUNA", "KITTY"), 0.038, 0.05,
                                 ("purple", "orange", "teal", "red", "yellow"), "cat"),
                                 (0.0783, 0.0783, 0.0528), 0.2,
             ("tin of cat food", "can of cat food", "cat food can", "wet cat food"), _P,
             ("round",), ("purple",)),
    Category("dog_food_tin", tin(("DOG", "WOOF", "BEEF", "CHUM"), 0.038, 0.1,
                                 ("red", "brown", "blue", "green", "yellow"), "dog"),
                                 (0.0778, 0.0778, 0.102), 0.42,
             ("tin of dog food", "can of dog food", "dog food can", "wet dog food", "pet food tin",
              "pet food can"), _P, ("round",), ("red",)),
    Category("fish_food_tub", tin(("FLAKES", "FISH", "AQUA"), 0.03, 0.09,
                                  ("yellow", "blue", "orange", "teal"), "fish"),
                                  (0.0627, 0.0627, 0.0929), 0.06,
             ("fish food", "tub of fish food", "fish flake", "mealworm tub", "tub of mealworms",
              "fish food container"), _P, ("round",), ("yellow",)),
)  # fmt: skip
"""The module's categories."""
