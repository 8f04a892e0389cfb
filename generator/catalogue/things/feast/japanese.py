"""Food of Japan and China, and other small round bites."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade, lobe
from ...build.outlines import smooth
from ...build.settled import scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, prism
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .savouries import crust


def temaki(look: Look) -> Shape:
    """A temaki: a cone of seaweed full of rice, salmon and cucumber, lying."""
    k, color = look.between(0.88, 1.1), look.color("coral", "orange", "crimson")
    cone = (
        lathe([(0, 0), (0.004, 0), (0.028, 0.1), (0.024, 0.1), (0.002, 0.01), (0, 0.01)], 22)
        .turn(1, -np.pi / 2)
        .turn(1, 0.27)
        .move(0.05, 0, 0.004)
    )
    rice = (
        scatter(look, 0.018, 26, (0.008, 0.011), 0.0, dome=0.01)
        .turn(1, -np.pi / 2)
        .move(-0.043, 0, 0.028)
    )
    fish = [box(0.012, 0.012, 0.05).turn(1, -1.2).move(-0.04, y, 0.026) for y in (-0.008, 0.006)]
    green = box(0.007, 0.008, 0.05).turn(1, -1.15).move(-0.036, 0.0, 0.036)
    return settle([(cone, textures.speckles(look.rng, (34, 50, 38), 10)),
                   (rice, textures.plain((250, 248, 240))), (join(fish),
                       textures.stripes([color, tint_color(color, 1.4)], 4)),
                   (green, textures.plain((120, 170, 90)))], 0.03, hulls=[[0],
                       [1, 2]]).scale(k)  # fmt: skip


def _bun(
    d: tuple[float, float], tall: float, palette: tuple[str, ...], kind: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a small round bite: mochi, dorayaki, scotch egg."""

    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*palette)
        h = tall * size
        if kind == "sandwich":
            cake = [ellipsoid(size, size, 0.62 * h, 26, 10).move(z=z * h) for z in (0.3, 0.74)]
            fill = cylinder(0.42 * size, 0.3 * h, 24).move(z=0.38 * h)
            return settle(
                [
                    (
                        join(cake),
                        textures.gradient(
                            tint_color(color, 1.3), tint_color(color, 0.75), look.rng
                        ),
                    ),
                    (fill, textures.plain((84, 44, 40))),
                ],
                0.02,
                hulls=[[0]],
            )
        body = ellipsoid(size, size, h, 24, 14)
        if kind == "mochi":
            tile = textures.spots(look.rng, color, tint_color(color, 1.4), 0.2)
            return settle([(body, tile)], 0.17)
        if kind == "egg":
            half = body.bend(
                lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0.02 * size)])
            )
            image = prints.canvas(128, 128, (160, 96, 56))
            for r, tone in (
                (0.44, (214, 160, 130)),
                (0.33, (250, 248, 240)),
                (0.19, (244, 180, 60)),
            ):
                prints.disc(image, 0.5, 0.5, r, tone)
            face = cylinder(0.495 * size, 0.0008, 28).move(z=0.02 * size)
            return settle(
                [
                    (half, textures.spots(look.rng, color, tint_color(color, 0.75), 0.3)),
                    (face, image),
                ],
                0.12,
                hulls=[[0]],
            )
        sauce = ellipsoid(0.8 * size, 0.8 * size, 0.4 * h, 18, 8).move(z=0.32 * h)
        flakes = scatter(
            look, 0.3 * size, 9, (0.14 * size, 0.22 * size), 0.48 * h, stretch=(1, 0.5, 0.2)
        )
        return settle(
            [
                (body, crust(look, color)),
                (sauce, textures.plain((84, 46, 30))),
                (flakes, textures.plain((150, 180, 100))),
            ],
            0.1,
            hulls=[[0]],
        )

    return make


def taiyaki(look: Look) -> Shape:
    """A taiyaki: a fish-shaped waffle lying, scales pressed into it."""
    k, color = look.between(0.88, 1.08), look.color("wooden", "copper", "amber", "tan")
    side = smooth(
        [
            (-0.065, 0.0),
            (-0.05, -0.024),
            (-0.01, -0.034),
            (0.03, -0.018),
            (0.042, -0.012),
            (0.07, -0.03),
            (0.066, 0.0),
            (0.07, 0.03),
            (0.042, 0.012),
            (0.03, 0.018),
            (-0.01, 0.034),
            (-0.05, 0.024),
            (-0.065, 0.0),
        ],
        3,
    )[:-1]
    body = join([prism(side, 0, 0.024, 0.0)])
    y, x = np.mgrid[0:96, 0:160]
    scale = np.abs(np.sin(np.pi * (x / 14 + 0.5 * ((y // 12) % 2)))) * np.abs(
        np.sin(np.pi * y / 12)
    )
    image = np.clip(np.array(color) * (0.72 + 0.4 * scale[..., None]), 0, 255).astype(np.uint8)
    image[:, :52] = np.clip(np.array(color), 0, 255)
    eye = [cylinder(0.005, 0.003, 14).move(-0.044, 0.004, 0.0225)]
    fin = blade([(-0.01, 0.01, 0.024), (0.006, 0.02, 0.026), (0.02, 0.022, 0.024)], 0.012)
    return shape(
        [
            (body.scale(k, k, k), image),
            (join([*eye, fin]).scale(k, k, k), textures.plain(tint_color(color, 0.6))),
        ],
        [hull_of(body.scale(k, k, k))],
    )


def shumai(look: Look) -> Shape:
    """A shumai: an open frilled dumpling, its filling and a pea on top."""
    k, color = look.between(0.88, 1.12), look.color("yellow", "cream", "gold")
    skin = lathe(
        [
            (0, 0),
            (0.014, 0),
            (0.018, 0.012),
            (0.0165, 0.024),
            (0.019, 0.03),
            (0.0165, 0.03),
            (0.014, 0.025),
            (0, 0.024),
        ],
        40,
    )
    fill = ellipsoid(0.03, 0.03, 0.016, 16, 8).move(z=0.026)
    pea = ellipsoid(0.007, 0.007, 0.007, 10, 7).move(z=0.034)
    made = [
        (lobe(skin, 14, 0.12), textures.speckles(look.rng, tint_color(color, 1.1), 6)),
        (fill, textures.spots(look.rng, (214, 150, 120), (240, 200, 180), 0.3)),
        (pea, textures.plain(look.own_color("orange", "green", "coral"))),
    ]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0, 1]])


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("temaki", temaki, (0.135, 0.054, 0.0556), 0.08, ("hand roll", "sushi hand roll",
        "sushi cone"), _F, _E, ("coral",), state="lying"),
    Category("mochi", _bun((0.038, 0.05), 0.75, ("white", "pink", "mint", "lavender", "cream"),
                           "mochi"), (0.0446, 0.0446, 0.0301), 0.045, ("daifuku",
                               "mochi ball"), _F, _R, ("white",)),
    Category("dorayaki", _bun((0.085, 0.1), 0.42, ("copper", "wooden", "bronze"), "sandwich"),
             (0.0922, 0.0928, 0.0405), 0.07, ("red bean pancake", "whoopie pie"), _F, _R,
             ("copper",), state="lying flat"),
    Category("takoyaki", _bun((0.036, 0.044), 0.92, ("wooden", "copper", "amber"), "ball"),
             (0.0393, 0.0393, 0.0332), 0.025, ("octopus ball",), _F, _R, ("wooden",)),
    Category("scotch_egg", _bun((0.06, 0.072), 1.0, ("copper", "bronze", "wooden", "tan", "amber",
                                                     "brown"), "egg"),
             (0.0633, 0.0633, 0.0297), 0.08, ("half scotch egg",), _F, _R, ("copper",)),
    Category("taiyaki", taiyaki, (0.136, 0.0683, 0.0276), 0.1, ("fish waffle", "fish shaped cake"),
             _F, _E, ("wooden",), state="lying flat"),
    Category("shumai", shumai, (0.0412, 0.0402, 0.039), 0.022, ("siu mai", "shaomai",
        "open dumpling"), _F, _R, ("yellow",)),
)  # fmt: skip
"""The module's categories."""
