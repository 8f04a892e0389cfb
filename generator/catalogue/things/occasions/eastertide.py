"""Easter: bunny ears, egg trees, dye kits."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.outlines import smooth
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import box, ellipsoid, join, lathe, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look


def bunny_ears(look: Look) -> Shape:
    """A headband with two bunny ears, lying on its back."""
    k, color = look.between(0.88, 1.08), look.color("white", "pink", "gray", "brown", "black")
    a = np.linspace(-0.25, np.pi + 0.25, 19)
    band = tube(
        np.column_stack([0.065 * np.cos(a), 0.07 * np.sin(a) - 0.05, np.full(19, 0.004)]), 0.004, 8
    )
    ears, inner = [], []
    for s in (-1, 1):
        path = [
            (0.026 * s, 0.015, 0.005),
            (0.04 * s, 0.07, 0.009),
            (0.046 * s, 0.13, 0.008),
            (0.048 * s, 0.17, 0.005),
        ]
        ears.append(limb(path, [0.012, 0.023, 0.02, 0.002], 12, 0.32))
        inner.append(
            limb([(x, y, z + 0.0035) for x, y, z in path], [0.007, 0.014, 0.011, 0.001], 10, 0.3)
        )
    return settle(
        [
            (join([band, *ears]), textures.scratches(look.rng, color, tint_color(color, 0.9), 120)),
            (join(inner), textures.plain((240, 168, 186))),
        ],
        0.06,
        hulls=[[0]],
    ).scale(k)


def egg_tree(look: Look) -> Shape:
    """An Easter tree: bare twigs in a pot with painted eggs hanging from them."""
    k, color = look.between(0.85, 1.06), look.color("white", "sage", "pink", "terracotta", "sky")
    pot = lathe(
        [
            (0, 0),
            (0.036, 0),
            (0.046, 0.06),
            (0.048, 0.068),
            (0.04, 0.068),
            (0.038, 0.06),
            (0, 0.058),
        ],
        26,
    )
    twigs, eggs = [], ([], [], [])
    for n in range(8):
        a, h = 2.4 * n, 0.2 + 0.02 * (n % 3)
        out = 0.05 + 0.035 * (n % 2)
        x, y = np.cos(a), np.sin(a)
        tip = (out * x, out * y, h)
        twigs.append(
            tube(
                smooth(
                    [(0.008 * x, 0.008 * y, 0.055), (0.3 * out * x, 0.3 * out * y, 0.12), tip], 3
                ),
                0.0018,
                5,
            )
        )
        side = (1.35 * out * x - 0.02 * y, 1.35 * out * y + 0.02 * x, h - 0.04)
        twigs.append(tube([(0.6 * out * x, 0.6 * out * y, 0.6 * h + 0.02), side], 0.0013, 4))
        eggs[n % 3].append(
            ellipsoid(0.02, 0.02, 0.027, 12, 8).move(side[0], side[1], side[2] - 0.022)
        )
        twigs.append(tube([side, (side[0], side[1], side[2] - 0.01)], 0.0005, 4))
    hues = [
        look.own_color("yellow", "pink"),
        look.own_color("sky", "mint"),
        look.own_color("violet", "coral"),
    ]
    made = [
        (pot, look.surface(color, "ceramic")),
        (join(twigs), textures.plain((120, 92, 66))),
        *(
            (join(e), textures.stripes([h, (250, 248, 240), h], 3))
            for e, h in zip(eggs, hues, strict=True)
        ),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(*[t.scale(k, k, k) for t in twigs[::3]])])


def dye_kit(look: Look) -> Shape:
    """A boxed kit for dyeing eggs: painted eggs and pots of colour on its front."""
    k, color = look.between(0.9, 1.1), look.color("pink", "yellow", "sky", "mint", "lavender")
    x, y, h = 0.15 * k, 0.045 * k, 0.18 * k
    image = prints.canvas(170, 200, color)
    prints.write(image, "EGG DYE", 0.5, 0.13, 0.13, readable_on(color), bold=True)
    prints.write(image, "KIT", 0.5, 0.26, 0.1, readable_on(color), bold=True)
    hues: tuple[RGB, ...] = (
        (236, 84, 110),
        (250, 206, 60),
        (80, 160, 220),
        (110, 180, 90),
        (150, 100, 190),
    )
    for n, hue in enumerate(hues):
        at = 0.14 + 0.18 * n
        prints.disc(image, at, 0.54 + 0.05 * (n % 2), 0.08, hue)
        prints.disc(image, at, 0.51 + 0.05 * (n % 2), 0.07, hue)
        prints.fill(image, at - 0.07, 0.54 + 0.05 * (n % 2), 0.14, 0.02, (250, 248, 240))
        prints.fill(image, at - 0.06, 0.78, 0.12, 0.14, hue)
        prints.fill(image, at - 0.07, 0.75, 0.14, 0.04, (250, 250, 250))
    panel = box(x, 0.0005, h)
    return shape(
        [
            (box(x, y, h), textures.plain(tint_color(color, 0.85))),
            (panel.move(y=-y / 2), image),
            (panel.move(y=y / 2), image),
        ],
        [box_part(x, y, h)],
    )


_W, _E = ("living",), ("living",)

CATEGORIES = (
    Category("bunny_ears", keep_still(bunny_ears), (0.132, 0.228, 0.015), 0.05,
             ("bunny ear headband", "rabbit ears", "bunny ears headband", "rabbit ear headband",
              "cat ears headband", "bunny ear"), _E, (), ("white",), state="lying"),
    Category("easter_tree", egg_tree, (0.218, 0.227, 0.233), 0.4, ("egg tree", "twig tree",
        "easter egg tree"), _E, ("tall",), ("white",)),
    Category("egg_dye_kit", dye_kit, (0.151, 0.0459, 0.182), 0.15, ("egg dye",
        "egg decorating kit", "egg colouring kit", "egg coloring kit", "egg painting kit",
        "easter egg dye", "egg dyeing kit"), _E, (), ("pink",)),
)  # fmt: skip
"""The module's categories."""
