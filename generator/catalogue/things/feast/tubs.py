"""Tubs, cups and punnets of food."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.forms import above
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look


def tub(
    words: tuple[str, ...], r: float, h: float, palette: tuple[str, ...], food: tuple[RGB, RGB]
) -> Callable[[Look], Shape]:
    """Return the shape function of a printed tub, shut or open with its food showing."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.92, 1.08), look.color(*palette)
        a, b = r * k, h * k
        body = lathe(
            [(0, 0), (0.84 * a, 0), (0.86 * a, 0.03 * b), (a, b), (0, b)], 34, v=[0, 0, 0.03, 1, 1]
        )
        image = prints.canvas(320, 112, color)
        for start in (0, 160):
            part = image[:, start : start + 160]
            prints.disc(part, 0.5, 0.52, 0.4, (250, 248, 240))
            prints.write(
                part[:, 44:116],
                look.pick(list(words)),
                0.5,
                0.42,
                0.24,
                tint_color(color, 0.6),
                bold=True,
            )
            prints.disc(part, 0.5, 0.72, 0.1, food[0])
        image = np.roll(image, 80, axis=1)
        if look.chance(0.5):
            rim = lathe(
                [
                    (0.9 * a, 0.97 * b),
                    (1.03 * a, 0.97 * b),
                    (1.03 * a, b + 0.002),
                    (0.9 * a, b + 0.002),
                ],
                34,
                loop=True,
            )
            top = ellipsoid(1.84 * a, 1.84 * a, 0.3 * a, 24, 8).move(z=b - 0.002)
            return shape(
                [
                    (body, image),
                    (rim, textures.plain(tint_color(color, 1.4))),
                    (top, textures.spots(look.rng, *food, 0.2)),
                ],
                [hull_of(body, rim)],
            )
        lid = lathe(
            [
                (0, 0.98 * b),
                (1.05 * a, 0.96 * b),
                (1.05 * a, b + 0.006),
                (0.96 * a, b + 0.008),
                (0.9 * a, b + 0.004),
                (0, b + 0.004),
            ],
            34,
        )
        print_ = prints.canvas(128, 128, color)
        prints.disc(print_, 0.5, 0.5, 0.4, tint_color(color, 1.5))
        prints.write(
            print_,
            look.pick(list(words)),
            0.5,
            0.5,
            0.14,
            readable_on(tint_color(color, 1.5)),
            bold=True,
        )
        face = cylinder(0.88 * a, 0.0006, 30).move(z=b + 0.004)
        return shape(
            [(body, image), (lid, textures.plain(tint_color(color, 0.85))), (face, print_)],
            [hull_of(body, lid)],
        )

    return make


def bubble_tea(look: Look) -> Shape:
    """A cup of bubble tea: milky tea, dark pearls at the bottom, a domed lid, a fat straw."""
    k, color = (
        look.between(0.9, 1.08),
        look.color("tan", "pink", "mint", "lavender", "orange", "beige"),
    )
    r, h = 0.044 * k, 0.125 * k
    cup = lathe([(0, 0), (0.72 * r, 0), (r, h), (0, h)], 30, v=[0, 0, 1, 1])
    image = textures.fit(textures.speckles(look.rng, color, 8), 96, 192).copy()
    for _ in range(46):
        prints.disc(image, look.rng.random(), look.rng.uniform(0.74, 0.98), 0.05, (48, 30, 26))
    image[:10] = 240
    dome = lathe(
        [
            (0, h),
            (1.04 * r, h),
            (1.04 * r, h + 0.006),
            (0.96 * r, h + 0.02 * k),
            (0.6 * r, h + 0.036 * k),
            (0, h + 0.04 * k),
        ],
        28,
    )
    straw = tube([(0.004, 0, h), (0.02 * k, 0, h + 0.09 * k)], 0.0055 * k, 12)
    return shape(
        [
            (cup, image),
            (dome, textures.plain((232, 238, 240))),
            (straw, textures.plain(look.own_color("pink", "green", "purple", "black", "yellow"))),
        ],
        [hull_of(cup), hull_of(dome), hull_of(straw)],
    )


def punnet(look: Look) -> Shape:
    """A punnet of berries: a clear or cardboard tray heaped with strawberries or blueberries."""
    k, color = look.between(0.88, 1.06), look.color("red", "red", "indigo", "crimson", "maroon")
    x, y, h = 0.15 * k, 0.11 * k, 0.055 * k
    outline = rectangle(x, y, 0.02 * k)
    rings = [(0.84, 0), (1.0, h), (0.97, h), (0.82, 0.006)]
    tray = loft(
        np.stack([np.column_stack([outline * s, np.full(len(outline), z)]) for s, z in rings]),
        outline,
    )
    strawberry = color[0] > 150
    d = 0.03 * k if strawberry else 0.018 * k
    rows = [
        (i, j)
        for i in range(-2 if strawberry else -3, 3 if strawberry else 4)
        for j in range(-1 if strawberry else -2, 2 if strawberry else 3)
    ]
    step = (x - 0.03 * k) / (5 if strawberry else 7)
    berries, caps = [], []
    for n, (i, j) in enumerate(rows):
        at = (
            i * step * 1.02,
            j * step * (1.0 if strawberry else 0.82),
            h + 0.25 * d * np.cos(2.3 * n),
        )
        berries.append(ellipsoid(d, 0.9 * d, 0.95 * d, 8, 6).turn(2, n).move(*at))
        if strawberry:
            caps.append(
                ellipsoid(0.5 * d, 0.5 * d, 0.1 * d, 5, 4).move(
                    at[0] + 0.18 * d, at[1], at[2] + 0.46 * d
                )
            )
    bed = prism(outline * 0.8, 0.006, 0.8 * h)
    seed = (
        textures.spots(look.rng, color, (250, 214, 120), 0.04)
        if strawberry
        else textures.spots(look.rng, color, tint_color(color, 1.3), 0.2)
    )
    shell = (
        textures.plain((216, 226, 228))
        if look.chance(0.6)
        else textures.speckles(look.rng, (120, 150, 90), 6)
    )
    pieces: list[tuple[Solid, textures.Tile]] = [
        (tray, shell),
        (bed, textures.plain(tint_color(color, 0.7))),
        (join(berries), seed),
    ]
    if caps:
        pieces.append((join(caps), textures.plain((90, 150, 66))))
    return shape(pieces, [hull_of(tray), hull_part(above(join(berries).vertices))])


_F = ("food",)

CATEGORIES = (
    Category("hummus_tub", tub(("HUMMUS", "HOUMOUS", "DIP"), 0.055, 0.045,
                               ("green", "orange", "red", "yellow"), ((226, 196, 140),
                                   (190, 150, 96))), (0.112, 0.112, 0.051), 0.22,
                                   ("pot of hummus", "dip tub", "guacamole tub",
             "salsa tub", "houmous tub", "tub of dip"), _F, ("round",), ("green",)),
    Category("coleslaw_tub", tub(("SLAW", "SALAD", "DELI"), 0.058, 0.055,
                                 ("sky", "green", "white", "yellow"), ((244, 240, 214),
                                     (236, 150, 80))), (0.119, 0.12, 0.0618), 0.3,
                                     ("tub of coleslaw", "potato salad tub", "pot of coleslaw",
             "tub of potato salad", "deli tub"), _F, ("round",), ("sky",)),
    Category("bubble_tea", bubble_tea, (0.0924, 0.0924, 0.218), 0.45, ("boba", "boba tea",
        "pearl milk tea", "cup of bubble tea"), _F, ("tall", "round"), ("tan",)),
    Category("punnet", punnet, (0.148, 0.109, 0.0757), 0.35, ("punnet of strawberries",
        "punnet of blueberries", "punnet of raspberries", "strawberry punnet",
        "box of strawberries", "fruit punnet", "punnet of berries",
             "punnet of cherries"), _F, (), ("red",)),
)  # fmt: skip
"""The module's categories."""
