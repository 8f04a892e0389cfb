"""Signs, cards, certificates and booklets for parties."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import facing
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, ellipsoid, join, prism
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

GOLD: RGB = (206, 172, 90)


def sign(
    words: tuple[str, ...], x: float, h: float, kind: str, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a lettered sign: on a stake and foot, an easel, or a tent."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.9, 1.1), look.color(*palette)
        a, b = x * k, h * k
        word = look.pick(list(words)).split("|")
        image = prints.canvas(int(150 * min(a / b, 2.2)) + 1, 150, color)
        ink = readable_on(color)
        prints.fill(image, 0.03, 0.05, 0.94, 0.02, ink)
        prints.fill(image, 0.03, 0.93, 0.94, 0.02, ink)
        for n, line in enumerate(word):
            tall = 0.42 if len(line) < 3 else 0.62 / max(len(word), 2.2)
            prints.write(image, line, 0.5, (n + 0.75) / (len(word) + 0.5), tall, ink, bold=True)
        if kind == "tent":
            side = np.array(
                [
                    (-0.3 * b, 0),
                    (-0.3 * b + 0.002, 0),
                    (0, b - 0.003),
                    (0.3 * b - 0.002, 0),
                    (0.3 * b, 0),
                    (0, b),
                ]
            )
            body = prism(side, -a / 2, a / 2).turn(0, np.pi / 2).turn(2, np.pi / 2)
            lean = float(np.arctan2(0.3 * b, b))
            face = (
                box(0.97 * a, 0.0004, 0.94 * float(np.hypot(0.3 * b, b)))
                .turn(0, -lean)
                .move(y=-0.3 * b - 0.0004, z=0.002)
            )
            return shape(
                [(body, textures.plain(tint_color(color, 0.95))), (face, image)], [hull_of(body)]
            )
        board, edge = (
            facing(prism(rectangle(a, b, 0.01 * k), 0, 0.008)),
            0.0 if kind == "easel" else 0.05 * k,
        )
        panel = facing(prism(rectangle(0.95 * a, 0.92 * b, 0.008 * k), 0, 0.0006))
        z = b / 2 + 0.012 + edge
        pieces = [
            (board.move(y=0.004, z=z), look.surface(color, "wood" if kind == "stake" else "paper")),
            (panel.move(y=-0.0037, z=z), image),
        ]
        if kind == "stake":
            pole, foot = box(0.014, 0.01, z).move(y=0.009), block(0.6 * a, 0.06, 0.012, 0.008)
            pieces.append((join([pole, foot]), textures.wood(look.rng, (190, 144, 94))))
            return shape(pieces, [hull_of(foot), hull_of(pole), hull_of(pieces[0][0])])
        bar = [box(0.5 * a, 0.05, 0.012), box(0.5 * a, 0.01, 0.02).move(y=-0.02)]
        prop = [
            box(0.012, 0.008, 0.7 * b).turn(0, -0.25).move(s * 0.2 * a, 0.0, 0.01) for s in (-1, 1)
        ]
        foot = [box(0.012, 0.07, 0.01).move(s * 0.2 * a, 0.02) for s in (-1, 1)]
        del prop
        pieces.append(
            (
                join([*bar, *foot]),
                textures.brushed_metal(look.rng, GOLD)
                if look.chance(0.5)
                else textures.wood(look.rng, (190, 144, 94)),
            )
        )
        return shape(pieces, [hull_of(*bar, *foot), hull_of(pieces[0][0])])

    return make


def sheet_of(titles: tuple[str, ...], x: float, y: float, kind: str) -> Callable[[Look], Shape]:
    """Return the shape function of a printed sheet lying: a certificate, menu or booklet."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.93, 1.07), look.color("cream", "white", "ivory", "pink", "sage")
        ink = look.own_color("gold", "navy", "black", "maroon", "green")
        a, b, t = x * k, y * k, 0.0016 if kind != "booklet" else 0.004
        tall = int(190 * min(b / a, 1.6))
        image = prints.canvas(190, tall, color)
        prints.fill(image, 0.04, 0.03, 0.92, 0.94, ink)
        prints.fill(image, 0.05, 0.038, 0.9, 0.924, color)
        prints.fill(image, 0.065, 0.05, 0.87, 0.9, tint_color(ink, 1.2))
        prints.fill(image, 0.07, 0.054, 0.86, 0.892, color)
        prints.write(image, look.pick(list(titles)), 0.5, 0.2, 0.09, ink, bold=True)
        if kind == "menu":
            for n in range(4):
                prints.fill(image, 0.36, 0.33 + 0.15 * n, 0.28, 0.018, ink)
                prints.fill(image, 0.2, 0.38 + 0.15 * n, 0.6, 0.01, (130, 130, 134))
                prints.fill(image, 0.28, 0.41 + 0.15 * n, 0.44, 0.01, (130, 130, 134))
        elif kind == "certificate":
            prints.lines(image, look.rng, (0.18, 0.36, 0.64, 0.28), 5, (120, 120, 126))
            prints.disc(image, 0.5, 0.78, 0.09, (196, 44, 50))
            prints.disc(image, 0.5, 0.78, 0.06, (226, 180, 80))
            for s in (-1, 1):
                prints.fill(image, 0.5 + 0.25 * s - 0.1, 0.84, 0.2, 0.008, (70, 70, 76))
        else:
            prints.disc(image, 0.5, 0.52, 0.13, tint_color(ink, 1.3), 0.11)
            prints.write(image, look.pick(["A & J", "M & T", "K & S"]), 0.5, 0.52, 0.07, ink)
            prints.lines(image, look.rng, (0.28, 0.76, 0.44, 0.1), 2, (130, 130, 134))
        body = box(a, b, t)
        face = box(0.995 * a, 0.995 * b, 0.0004).move(z=t - 0.0002)
        pieces = [(body, textures.plain(color)), (face, image)]
        if kind == "booklet":
            bow = [
                ellipsoid(0.03, 0.014, 0.006, 10, 6)
                .turn(2, 0.5 * s)
                .move(-a / 2 + 0.012, 0.012 * s, t + 0.001)
                for s in (-1, 1)
            ]
            pieces.append((join(bow), textures.plain(ink)))
        return shape(pieces, [box_part(a, b, t)])

    return make


_W, _E = ("living",), ("living",)

CATEGORIES = (
    Category("table_number", sign(("1", "2", "5", "7", "12", "TABLE|3"), 0.1, 0.13, "easel",
                                  ("white", "cream", "black", "sage")), (0.0983, 0.08, 0.14), 0.12,
                                  ("table number card", "table number sign",
             "wedding table number"), _W, (), ("white",)),
    Category("signboard", sign(("WELCOME", "JUST|MARRIED", "EGG|HUNT", "BAR", "GIFTS|& CARDS",
                                "OPEN"), 0.2, 0.1, "stake", ("wooden", "white", "sky", "black",
                                    "cream")), (0.206, 0.06, 0.167), 0.25,
             ("small sign", "egg hunt sign", "just married sign",
              "welcome sign", "signpost", "garden sign", "party sign", "arrow sign"), _W, (),
              ("wooden",)),
    Category("table_plan", sign(("TABLE PLAN|A  B  C|1 . . . 2|3 . . . 4|5 . . . 6",
                                 "SEATING|1 . . . 2|3 . . . 4|5 . . . 6"), 0.2, 0.27, "easel",
                                 ("white", "cream", "sage", "black")), (0.192, 0.08, 0.272), 0.4,
                                 ("seating plan",
             "seating chart", "wedding table plan"), _W, ("tall",), ("white",)),
    Category("menu_card", sheet_of(("MENU", "DINNER", "WEDDING MENU"), 0.1, 0.2, "menu"),
             (0.103, 0.205, 0.0018), 0.015, ("cocktail menu",
                                             "menu sheet"),
                                             ("dining",), ("flat",),
             ("cream",), state="lying flat"),
    Category("certificate", sheet_of(("CERTIFICATE", "MARRIAGE", "DIPLOMA", "AWARD"), 0.25, 0.18,
                                     "certificate"), (0.252, 0.182, 0.0018), 0.012,
                                     ("wedding certificate", "marriage certificate",
                                      "marriage licence", "marriage license", "diploma",
             "award certificate", "birth certificate", "degree certificate"), ("office",),
             ("flat",), ("cream",), state="lying flat"),
    Category("order_of_service", sheet_of(("ORDER OF SERVICE", "PROGRAMME", "CEREMONY"), 0.13,
                                          0.19, "booklet"), (0.133, 0.193, 0.008), 0.03,
                                          ("order of service booklet", "wedding programme",
                                           "wedding program", "ceremony programme", "hymn sheet"),
                                           _W,
             ("flat",), ("cream",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
