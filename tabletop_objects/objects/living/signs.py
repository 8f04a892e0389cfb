"""Objects of the ``living`` theme: signs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import shine, wood
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, facing
from ...kit.shapes import Category, Drawing, Pieces, Shape, from_pieces, shape
from ...kit.solids import block, box, ellipsoid, join, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color

BLACK = surfaces.plain((34, 34, 37))


def _sign(texts: tuple[str, ...], palette: tuple[str, ...], kind: str) -> Drawing:
    """Return the drawing function of a wooden, tin or illuminated sign, or of a letter board."""

    def draw(look: Look) -> Pieces:
        text = look.pick(texts)
        if kind == "tin":
            color = look.color(*palette)
            image = prints.canvas(176, 120, color)
            ink = (tint_color(look.own_color("cream", "white"), 1.2) if sum(color) < 560
                   else (60, 40, 34))  # fmt: skip
            prints.fill(image, 0.03, 0.045, 0.94, 0.91, ink)
            prints.fill(image, 0.045, 0.065, 0.91, 0.87, color)
            prints.write(image, text, 0.5, 0.4, 0.3, ink, True)
            prints.fill(image, 0.2, 0.62, 0.6, 0.02, ink)
            prints.write(image, look.pick(["SINCE 1928", "BEST QUALITY", "OPEN DAILY"]), 0.5, 0.77,
                         0.1, ink, True)  # fmt: skip
            return [
                (at_block(0.3, 0.2, 0.003, 0.01), shine(look)),
                (at_block(0.298, 0.198, 0.0006, 0.01, (0, 0, 0.0028)), image),
            ]
        if kind == "board":
            image = prints.canvas(128, 128, look.color(*palette))
            for k in range(16):
                prints.fill(image, 0, k / 16, 1, 0.012, (20, 20, 22))
            for k, line in enumerate(text.split()):
                prints.write(image, line, 0.5, 0.28 + 0.2 * k, 0.13, (246, 246, 242), True)
            frame = wood(look, "wooden", "tan")
            body = at_box(0.25, 0.018, 0.25)
            face = at_box(0.226, 0.002, 0.226, (0, -0.009, 0.012))
            strut = [at_box(0.03, 0.07, 0.012, (s * 0.08, 0.02, 0)) for s in (-1, 1)]
            return [(body, frame), (strut[0], frame), (strut[1], frame), (face, image)]
        if kind == "neon":
            glow = surfaces.plain(tint_color(look.color(*palette), 1.35))
            base = at_box(0.2, 0.06, 0.014)
            back = at_box(0.2, 0.006, 0.12, (0, 0.012, 0.014))
            heart = look.chance(0.5)
            if heart:
                t = np.linspace(0, 2 * np.pi, 40)[:-1]
                path = np.column_stack([0.0026 * 16 * np.sin(t) ** 3, 0 * t - 0.002, 0.072 + 0.0026
                                        * (13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t)
                                           - np.cos(4 * t))])  # fmt: skip
                glows = [tube(path, 0.0045, 8, loop=True)]
            else:
                zig = [(-0.02, 0.12), (-0.045, 0.072), (-0.005, 0.072), (-0.03, 0.025)]
                glows = [
                    tube([(x + 0.025, -0.002, z + 0.004) for x, z in smooth(zig, 1)], 0.0045, 8)
                ]
                glows += [
                    tube([(x, -0.002, z) for x, z in ((-0.085, 0.03), (-0.085, 0.12))], 0.0035, 8),
                    tube([(x, -0.002, z) for x, z in ((0.085, 0.03), (0.085, 0.12))], 0.0035, 8),
                ]
            return [(base, BLACK), (back, BLACK), *((g, glow) for g in glows)]
        tile = wood(look, *palette)
        post = [at_box(0.1, 0.05, 0.014), at_box(0.014, 0.014, 0.12, (0, 0.004, 0.012))]
        board = at_box(0.19, 0.012, 0.075, (0, -0.008, 0.09))
        ground = look.own_color("cream", "wooden", "white", "teal")
        image = prints.canvas(160, 64, ground)
        prints.write(image, text, 0.5, 0.5, 0.42, (60, 40, 28), True)
        return [(post[0], tile), (post[1], tile), (board, tile), (at_box(0.176, 0.002, 0.062,
                                                                         (0, -0.0145, 0.0965)),
                                                                  image)]  # fmt: skip

    return draw


GOLD: RGB = (206, 172, 90)


def sign(
    words: tuple[str, ...], x: float, h: float, kind: str, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a lettered sign: on a stake, on an easel or as a folded tent."""

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
            side = np.array([(-0.3 * b, 0), (-0.3 * b + 0.002, 0), (0, b - 0.003),
                             (0.3 * b - 0.002, 0), (0.3 * b, 0), (0, b)])  # fmt: skip
            body = prism(side, -a / 2, a / 2).turn(0, np.pi / 2).turn(2, np.pi / 2)
            lean = float(np.arctan2(0.3 * b, b))
            face = (box(0.97 * a, 0.0004, 0.94
                        * float(np.hypot(0.3 * b, b))).turn(0, -lean).move(y=-0.3 * b - 0.0004,
                                                                           z=0.002))  # fmt: skip
            return shape(
                [(body, surfaces.plain(tint_color(color, 0.95))), (face, image)], [hull_of(body)]
            )
        board, edge = (facing(prism(rectangle(a, b, 0.01 * k), 0, 0.008)), 0.0 if kind == "easel"
                       else 0.05 * k)  # fmt: skip
        panel = facing(prism(rectangle(0.95 * a, 0.92 * b, 0.008 * k), 0, 0.0006))
        z = b / 2 + 0.012 + edge
        pieces = [
            (board.move(y=0.004, z=z), look.surface(color, "wood" if kind == "stake" else "paper")),
            (panel.move(y=-0.0037, z=z), image),
        ]
        if kind == "stake":
            pole, foot = box(0.014, 0.01, z).move(y=0.009), block(0.6 * a, 0.06, 0.012, 0.008)
            pieces.append((join([pole, foot]), surfaces.wood(look.rng, (190, 144, 94))))
            return shape(pieces, [hull_of(foot), hull_of(pole), hull_of(pieces[0][0])])
        bar = [box(0.5 * a, 0.05, 0.012), box(0.5 * a, 0.01, 0.02).move(y=-0.02)]
        prop = [
            box(0.012, 0.008, 0.7 * b).turn(0, -0.25).move(s * 0.2 * a, 0.0, 0.01) for s in (-1, 1)
        ]
        foot = [box(0.012, 0.07, 0.01).move(s * 0.2 * a, 0.02) for s in (-1, 1)]
        del prop
        pieces.append((join([*bar, *foot]), surfaces.brushed_metal(look.rng, GOLD)
                       if look.chance(0.5) else surfaces.wood(look.rng,
                                                              (190, 144, 94))))  # fmt: skip
        return shape(pieces, [hull_of(*bar, *foot), hull_of(pieces[0][0])])

    return make


def sheet_of(titles: tuple[str, ...], x: float, y: float, kind: str) -> Callable[[Look], Shape]:
    """Return the shape function of a printed sheet lying flat: a certificate, menu or booklet."""

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
        pieces = [(body, surfaces.plain(color)), (face, image)]
        if kind == "booklet":
            bow = [
                ellipsoid(0.03, 0.014, 0.006, 10, 6)
                .turn(2, 0.5 * s)
                .move(-a / 2 + 0.012, 0.012 * s, t + 0.001)
                for s in (-1, 1)
            ]
            pieces.append((join(bow), surfaces.plain(ink)))
        return shape(pieces, [box_part(a, b, t)])

    return make


CATEGORIES = (
    Category("wooden_sign", from_pieces()(_sign(("HOME", "WELCOME", "CAFE", "GARDEN"), ("wooden",
             "brown"), "wood")), size=(0.19, 0.05, 0.165), mass=0.2, material="wood",
             aliases=("desk sign", "name plate", "nameplate"), themes=("living",),
             colors=("wooden",)),
    Category("tin_sign", from_pieces()(_sign(("GARAGE", "COFFEE", "DINER", "ROUTE 7"), ("red",
             "navy", "green", "cream", "yellow"), "tin")), size=(0.3, 0.2, 0.0034), mass=0.3,
             material="metal", aliases=("enamel sign", "metal sign", "number plate",
             "license plate", "licence plate", "street sign", "road sign", "vintage sign"),
             themes=("living",), roles=("flat", "big"), colors=("red", "navy")),
    Category("letterboard", from_pieces()(_sign(("HELLO SUNNY DAY", "GOOD VIBES ONLY",
             "COFFEE FIRST PLEASE"), ("black", "charcoal"), "board")), size=(0.243, 0.0679, 0.243),
             mass=0.6, material="wood", aliases=("letter board", "message board", "felt board",
             "lightbox sign", "cinema lightbox"), themes=("living",), roles=("big", "tall"),
             colors=("black",)),
    Category("neon_sign",
             from_pieces()(_sign(("",), ("pink", "cyan", "purple", "yellow", "red"), "neon")),
             size=(0.2, 0.06, 0.136), mass=0.4, material="device",
             aliases=("neon light", "led sign", "neon lamp"), themes=("living",), roles=("big",),
             colors=("pink",)),
    Category("table_number", sign(("1", "2", "5", "7", "12", "TABLE|3"), 0.1, 0.13, "easel",
             ("white", "cream", "black", "sage")), size=(0.0983, 0.08, 0.14), mass=0.12,
             material="paper",
             aliases=("table number card", "table number sign", "wedding table number"),
             themes=("living",), colors=("white",)),
    Category("signboard", sign(("WELCOME", "JUST|MARRIED", "EGG|HUNT", "BAR", "GIFTS|& CARDS",
             "OPEN"), 0.2, 0.1, "stake", ("wooden", "white", "sky", "black", "cream")),
             size=(0.206, 0.06, 0.167), mass=0.25, material="wood", assembled=True,
             aliases=("small sign", "egg hunt sign", "just married sign", "welcome sign",
             "signpost", "garden sign", "party sign", "arrow sign"), themes=("living",),
             colors=("wooden",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
