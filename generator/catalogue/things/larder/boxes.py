"""Sweet and salty things in boxes and tubs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import box, ellipsoid, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def cookie_box(look: Look) -> Shape:
    """A box of biscuits, biscuits shown on its front."""
    x, y, h = look.between(0.15, 0.19), look.between(0.05, 0.065), look.between(0.1, 0.13)
    color = look.color("blue", "red", "green", "purple", "yellow", "brown", "teal", "pink")
    image = prints.canvas(176, 112, color)
    prints.disc(image, 0.5, 1.25, 0.75, tint_color(color, 1.4))
    word = look.pick(["COOKIES", "BISCUITS", "CHOCO", "CRACKERS"])
    prints.write(image, word, 0.5, 0.2, 0.2, readable_on(color), bold=True)
    dark = look.chance(0.3)
    for a in (0.24, 0.5, 0.76):
        prints.disc(image, a, 0.64, 0.2, (64, 42, 34) if dark else (214, 160, 90))
        prints.disc(image, a, 0.64, 0.17, (86, 58, 46) if dark else (226, 178, 110))
        for k in range(6):
            u, v = 0.1 * np.cos(k * 1.05 + a * 9), 0.1 * np.sin(k * 1.05 + a * 9)
            prints.disc(image, a + u * 112 / 176, 0.64 + v, 0.024, (76, 44, 28) if not dark
                        else (240, 236, 226))  # fmt: skip
    panel = box(x, 0.0006, h)
    top = box(x, y, 0.0006).move(z=h - 0.0003)
    sign = prints.canvas(176, 64, color)
    prints.write(sign, word, 0.5, 0.5, 0.4, readable_on(color), bold=True)
    return shape([(box(x, y, h), textures.speckles(look.rng, color, 2, 32)),
                  (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image), (top, sign)],
                 [box_part(x, y, h)])  # fmt: skip


def pudding_box(look: Look) -> Shape:
    """A small box of pudding or jelly powder with a dish of it on the front."""
    x, y, h = look.between(0.085, 0.11), look.between(0.03, 0.04), look.between(0.075, 0.09)
    color = look.color("brown", "red", "yellow", "green", "orange", "crimson", "blue")
    word = look.pick(["PUDDING", "PUDDING", "JELLY", "CHOCOLATE", "GELATIN"])
    tone = look.pick([(96, 58, 38), (220, 60, 70), (244, 214, 120), (150, 200, 90)])
    image = prints.canvas(128, 104, color)
    prints.fill(image, 0, 0.1, 1, 0.28, (248, 246, 240))
    prints.write(image, word, 0.5, 0.25, 0.2, tint_color(color, 0.6), bold=True)
    prints.disc(image, 0.5, 0.68, 0.2, tone)
    prints.disc(image, 0.5, 0.52, 0.07, (252, 250, 244))
    prints.polygon(image, [(0.2, 0.7), (0.8, 0.7), (0.66, 0.92), (0.34, 0.92)], (250, 250, 250))
    panel = box(x, 0.0006, h)
    return shape([(box(x, y, h), textures.speckles(look.rng, color, 2, 32)),
                  (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image)],
                 [box_part(x, y, h)])  # fmt: skip


def popcorn(look: Look) -> Shape:
    """A striped paper tub heaped with popcorn."""
    r, h = look.between(0.055, 0.068), look.between(0.13, 0.16)
    color = look.color("red", "red", "blue", "yellow", "teal", "orange")
    stripes = textures.stripes([color, (250, 248, 244)], look.pick([8, 10]), upright=True, side=160)
    image = textures.fit(stripes, 128, 160).copy()
    if look.chance(0.6):
        sign = image[:, 58:102]
        prints.disc(sign, 0.5, 0.5, 0.2, (250, 248, 244))
        prints.write(sign, "POP", 0.5, 0.5, 0.16, color, bold=True)
    square = look.chance(0.4)
    body = lathe([(0, 0), (0.72 * r, 0), (r, h), (0, h)], 4 if square else 30, v=[0, 0, 1, 1])
    body = body.turn(2, np.pi / 4) if square else body
    grow = 0.62 if square else 0.86
    corn = []
    for k in range(30):
        away, turn = grow * r * np.sqrt((k + 0.5) / 30), 2.4 * k
        lift = 0.3 * r * (1 - (away / r) ** 2)
        d = look.between(0.019, 0.027)
        corn.append(ellipsoid(d, 0.9 * d, 0.85 * d, 8, 5).turn(0, turn)
                    .move(away * np.cos(turn), away * np.sin(turn), h + lift))  # fmt: skip
    puff = textures.spots(look.rng, (250, 240, 206), (236, 200, 120), 0.2)
    heap = join(corn)
    return shape([(body, image), (heap, puff)], [hull_of(body), hull_of(heap)])


def toothpick(look: Look) -> Shape:
    """A round holder of toothpicks standing upright."""
    r, h = look.between(0.018, 0.022), look.between(0.04, 0.05)
    color = look.color("white", "red", "wooden", "teal", "silver", "navy", "yellow")
    cup = lathe(
        [(0, 0), (r, 0), (0.95 * r, h), (0.84 * r, h), (0.84 * r, 0.5 * h), (0, 0.5 * h)], 26
    )
    picks = []
    for k in range(20):
        away, turn = 0.62 * r * np.sqrt((k + 0.5) / 20), 2.4 * k
        at = np.array([away * np.cos(turn), away * np.sin(turn)])
        top = (*(1.35 * at), h + 0.02 + look.between(0, 0.003))
        picks.append(tube([(*at, 0.5 * h), top], [0.0011, 0.0004], 5))
    bunch = join(picks)
    return shape([(cup, look.surface(color, "ceramic")),
                  (bunch, textures.plain((222, 188, 136)))],
                 [cylinder_part(0.95 * r, h), hull_of(bunch)])  # fmt: skip


CATEGORIES = (
    Category("cookie_box", cookie_box, (0.17, 0.058, 0.115), 0.28, ("box of cookies",
             "biscuit box", "box of biscuits", "cookies box", "box of crackers", "cookie packet",
             "biscuit packet", "packet of biscuits", "packet of cookies", "packet of crackers",
             "cracker packet"), ("kitchen", "tea"), (), ("blue", "red")),
    Category("pudding_box", pudding_box, (0.098, 0.036, 0.083), 0.12, ("box of pudding",
             "chocolate pudding", "pudding", "gelatin box", "jello box", "pudding mix",
             "chocolate pudding box", "gelatin", "baking mix", "gelatin packet", "jelly packet"),
             ("kitchen",), (), ("brown",
             "red")),
    Category("popcorn", popcorn, (0.116, 0.116, 0.175), 0.12, ("popcorn box", "popcorn bucket",
             "box of popcorn", "bag of popcorn", "popcorn tub", "bucket of popcorn",
             "popcorn bag"), ("living",), ("edible",), ("red",)),
    Category("toothpicks", toothpick, (0.04, 0.04, 0.067), 0.05, ("toothpick holder",
                 "box of toothpicks", "cocktail sticks", "toothpick dispenser"), ("dining",),
             ("round",), ("white", "wooden")),
)  # fmt: skip
"""The module's categories."""
