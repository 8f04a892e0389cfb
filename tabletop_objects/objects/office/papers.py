"""Objects of the ``office`` theme: paper goods."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import at_block, at_box, ball, spindle, spread
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    category,
    from_pieces,
    put_down,
    shape,
    vary,
)
from ...kit.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ..living.signs import sheet_of


def _stars(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (20, 28, 66)
    pale: RGB = (226, 232, 246)
    for r in (0.46, 0.32, 0.17):
        prints.disc(image, 0.5, 0.5, r, (90, 110, 170), r - 0.008)
    for _ in range(70):
        prints.disc(image, look.between(0.08, 0.92), look.between(0.08, 0.92),
                    look.between(0.004, 0.011), pale)  # fmt: skip
    for _ in range(5):
        x, y = look.between(0.2, 0.7), look.between(0.2, 0.7)
        way = [(x + 0.06 * k, y + look.between(-0.07, 0.07)) for k in range(4)]
        prints.stroke(image, way, 0.006, (150, 170, 220))
        for p in way:
            prints.disc(image, *p, 0.014, (250, 244, 214))


def _telegram(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0.05, 1, 0.16, (206, 176, 92))
    prints.write(image, "TELEGRAM", 0.5, 0.13, 0.12, (40, 34, 26), True)
    for k in range(4):
        prints.fill(image, 0.08, 0.32 + 0.14 * k, 0.84, 0.09, (250, 248, 238))
        prints.lines(image, look.rng, (0.1, 0.345 + 0.14 * k, 0.8, 0.04), 1, INK, 0.8)


def _ransom(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for row, text in enumerate(("PAY", "THE", "MONEY", "NOW")):
        for k, letter in enumerate(text):
            x, y = 0.16 + 0.16 * k, 0.2 + 0.2 * row
            ground = look.own_color("yellow", "red", "sky", "white", "black", "pink")
            prints.fill(image, x - 0.06, y - 0.06, 0.13, 0.13, ground)
            prints.write(image, letter, x, y, 0.09, (20, 20, 24) if sum(ground) > 300
                         else (250, 250, 246), True)  # fmt: skip


def _list(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, look.pick(["LIST", "TO BUY", "TO DO"]), 0.5, 0.09, 0.08, accent, True)
    for k in range(8):
        y = 0.21 + 0.092 * k
        prints.fill(image, 0.1, y - 0.012, 0.06, 0.03, INK)
        prints.fill(image, 0.115, y - 0.006, 0.03, 0.018, (250, 250, 246))
        way = [
            (0.22 + 0.04 * n, y + 0.012 * (-1) ** n) for n in range(int(look.rng.integers(6, 15)))
        ]
        prints.stroke(image, way, 0.007, (50, 60, 130))


def _film(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (26, 32, 40)
    bone: RGB = (186, 204, 214)
    top = look.between(0.12, 0.2)
    prints.stroke(image, [(0.5, 0.06), (0.5, 0.95)], 0.05, bone)
    for k in range(8):
        y = top + 0.085 * k
        for s in (-1, 1):
            prints.stroke(image, [(0.5, y), (0.5 + s * 0.26, y - 0.02), (0.5 + s * 0.36, y + 0.07)],
                          0.018, bone)  # fmt: skip
    prints.fill(image, 0.04, 0.03, 0.16, 0.03, (226, 230, 234))


def _chart(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for k, (text, tall) in enumerate(
        (
            ("E", 0.16),
            ("F P", 0.11),
            ("T O Z", 0.085),
            ("L P E D", 0.065),
            ("P E C F D", 0.05),
            ("E D F C Z P", 0.04),
        )
    ):
        prints.write(
            image, text, 0.5, 0.13 + (0, 0.2, 0.36, 0.49, 0.6, 0.69)[k], tall, (20, 20, 22), True
        )
    prints.fill(image, 0.2, 0.9, 0.6, 0.015, (206, 40, 40))


def _swatch(look: Look, image: prints.Canvas, accent: RGB) -> None:
    names = ("red", "orange", "yellow", "lime", "green", "teal", "sky", "blue", "purple", "pink",
             "brown", "gray")  # fmt: skip
    for k, name in enumerate(names):
        prints.fill(
            image, 0.06 + 0.225 * (k % 4), 0.08 + 0.29 * (k // 4), 0.2, 0.22, look.own_color(name)
        )
        prints.fill(image, 0.08 + 0.225 * (k % 4), 0.32 + 0.29 * (k // 4), 0.12, 0.015, GRAY)


def _poster(look: Look, image: prints.Canvas, accent: RGB) -> None:
    h, w = image.shape[:2]
    image[: int(0.78 * h)] = surfaces.fit(
        prints.artwork(look.rng, w, int(0.78 * h)), int(0.78 * h), w
    )
    prints.write(
        image, look.pick(["CONCERT", "CINEMA", "TRAVEL", "SUMMER"]), 0.5, 0.87, 0.09, accent, True
    )
    prints.fill(image, 0.2, 0.94, 0.6, 0.012, GRAY)


@category("report", size=(0.218, 0.297, 0.0136), mass=0.35, material="paper",
          aliases=("bound report", "annual report", "school report", "book report", "thesis",
          "dissertation", "first aid manual", "user manual", "instruction manual", "handbook",
          "instruction booklet", "report binder"), themes=("office",), roles=("flat",),
          colors=("white",), state="lying flat")  # fmt: skip
@from_pieces(spread=0.06)
def report(look: Look) -> Pieces:
    """A bound report lying flat, with a comb binding along its edge and a printed cover."""
    color = look.color("white", "sky", "navy", "cream", "gray")
    cover = prints.canvas(128, 176, color)
    ink = (250, 250, 246) if sum(color) < 380 else (34, 40, 60)
    accent = look.own_color("crimson", "blue", "teal", "orange")
    prints.fill(cover, 0, 0.58, 1, 0.03, accent)
    prints.write(
        cover, look.pick(["REPORT", "ANNUAL REPORT", "STUDY"]), 0.54, 0.34, 0.075, ink, True
    )
    prints.fill(cover, 0.3, 0.44, 0.5, 0.015, ink)  # type: ignore[arg-type]
    for k in range(5):
        tall = 0.05 + 0.04 * k
        prints.fill(cover, 0.3 + 0.09 * k, 0.92 - tall, 0.06, tall, accent)
    pages = at_box(0.205, 0.292, 0.011, (0, 0, 0.0008))
    boards = [at_box(0.21, 0.297, 0.0009, (0, 0, z)) for z in (0, 0.0117)]
    rings = [at_block(0.016, 0.005, 0.0136, 0.002, (-0.105, y, 0))
             for y in np.linspace(-0.135, 0.135, 19)]  # fmt: skip
    return [(boards[0], surfaces.plain(color)), (pages, prints.pages(look.rng, (244, 242, 236))),
             (boards[1], cover),
            (join(rings), dye(look, "black", "white", "navy"))]  # fmt: skip


def _invoice(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0, 1, 0.05, accent)
    prints.write(image, look.pick(["INVOICE", "BILL"]), 0.3, 0.11, 0.06, accent, True)
    prints.lines(image, look.rng, (0.08, 0.18, 0.4, 0.1), 4, GRAY)
    for k in range(8):
        prints.fill(image, 0.08, 0.34 + 0.055 * k, 0.84, 0.003, GRAY)
        prints.lines(image, look.rng, (0.1, 0.355 + 0.055 * k, 0.4, 0.03), 1, INK, 0.5)
        prints.fill(image, 0.78, 0.36 + 0.055 * k, 0.12, 0.014, INK)
    prints.fill(image, 0.6, 0.82, 0.32, 0.06, accent)
    prints.write(image, "TOTAL", 0.76, 0.85, 0.035, (250, 250, 246), True)


def _contract(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, "CONTRACT", 0.5, 0.09, 0.06, INK, True)
    prints.lines(image, look.rng, (0.1, 0.16, 0.8, 0.58), 18, GRAY)
    for x in (0.1, 0.56):
        prints.fill(image, x, 0.87, 0.34, 0.006, INK)
        way = [(x + 0.03 + 0.03 * k, 0.85 - 0.03 * (k % 2) - 0.01 * np.sin(k)) for k in range(9)]
        prints.stroke(image, way, 0.008, (40, 60, 150))


def _letterhead(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.disc(image, 0.16, 0.08, 0.04, accent)
    prints.fill(image, 0.26, 0.06, 0.4, 0.02, accent)
    prints.lines(image, look.rng, (0.1, 0.18, 0.4, 0.08), 3, GRAY)
    prints.lines(image, look.rng, (0.1, 0.32, 0.8, 0.44), 13, INK)
    prints.stroke(
        image, [(0.12 + 0.03 * k, 0.86 - 0.03 * (k % 2)) for k in range(9)], 0.008, (40, 60, 150)
    )


def _resume(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0, 0.32, 1, accent)
    prints.disc(image, 0.16, 0.12, 0.07, (232, 200, 172))
    prints.lines(image, look.rng, (0.05, 0.26, 0.22, 0.5), 12, (226, 226, 230))
    prints.write(image, "RESUME", 0.66, 0.08, 0.06, INK, True)
    for y in (0.18, 0.45, 0.7):
        prints.fill(image, 0.38, y, 0.3, 0.016, accent)
        prints.lines(image, look.rng, (0.38, y + 0.04, 0.54, 0.18), 6, GRAY)


def _coupon(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0.02, 0.05, 0.96, 0.9, accent)
    prints.fill(image, 0.68, 0.05, 0.012, 0.9, (250, 250, 246))
    prints.write(
        image, look.pick(["20% OFF", "GIFT 50", "FREE"]), 0.34, 0.42, 0.3, (250, 250, 246), True
    )
    prints.lines(image, look.rng, (0.1, 0.7, 0.45, 0.14), 2, (236, 230, 226))
    prints.barcode(image, look.rng, 0.73, 0.36, 0.22)


def _blueprint(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (34, 78, 150)
    pale: RGB = (214, 228, 246)
    for k in range(1, 12):
        prints.fill(image, k / 12, 0, 0.003, 1, (58, 102, 172))
        prints.fill(image, 0, k / 12, 1, 0.004, (58, 102, 172))
    for path in ([(0.1, 0.12), (0.72, 0.12), (0.72, 0.75), (0.1, 0.75), (0.1, 0.12)], [(0.4,
             0.12), (0.4, 0.5)],
                 [(0.1, 0.5), (0.3, 0.5)], [(0.5, 0.5), (0.72, 0.5)], [(0.4, 0.75), (0.4,
             0.62)]):  # fmt: skip
        prints.stroke(image, path, 0.014, pale)
    prints.disc(image, 0.4, 0.5, 0.11, pale, 0.1)
    prints.fill(image, 0.76, 0.72, 0.2, 0.22, pale)
    prints.lines(image, look.rng, (0.78, 0.75, 0.16, 0.16), 4, (34, 78, 150))


def _floor(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for path in ([(0.1, 0.12), (0.9, 0.12), (0.9, 0.85), (0.1, 0.85), (0.1, 0.12)], [(0.45, 0.12),
             (0.45, 0.5)],
                 [(0.1, 0.5), (0.3, 0.5)], [(0.55, 0.5), (0.9, 0.5)], [(0.45, 0.85), (0.45,
             0.66)]):  # fmt: skip
        prints.stroke(image, path, 0.02, INK)
    prints.fill(image, 0.16, 0.2, 0.16, 0.2, (190, 206, 226))
    prints.fill(image, 0.65, 0.22, 0.16, 0.12, (226, 206, 180))
    prints.disc(image, 0.66, 0.68, 0.08, (206, 222, 196))


@category("blueprint", size=(0.38, 0.27, 0.032), mass=0.05, material="paper",
          aliases=("building plan", "architect plan", "technical drawing", "construction plan"),
          themes=("office",), roles=("flat",), colors=("blue",), state="lying flat")  # fmt: skip
@vary(0.08)
@from_pieces(spread=0.06)
def blueprint(look: Look) -> Pieces:
    """A half-rolled blueprint."""
    image = prints.canvas(176, 128, (34, 78, 150))
    _blueprint(look, image, INK)
    sheet = at_box(0.36, 0.27, 0.0011)
    roll = (spindle((-0.135, 0.008), (-0.135, 0.016), (0.135, 0.016),
                    (0.135, 0.008)).turn(2, np.pi / 2).move(x=0.185))  # fmt: skip
    return [(sheet, image), (roll, surfaces.plain((236, 238, 240)))]


A4 = (0.21, 0.297)
INK: RGB = (62, 62, 70)
GRAY: RGB = (140, 140, 146)
Print = Callable[[Look, prints.Canvas, RGB], None]
"""Prints one paper, in its accent colour."""


def paper(
    x: float, y: float, mark: Print, *grounds: str, sheets: int = 1, accents: tuple[str, ...] = ()
) -> Drawing:
    """Return the drawing function of a stack of paper sheets; ``mark`` prints the top sheet."""

    def draw(look: Look) -> Pieces:
        ground = look.color(*grounds)
        accent = look.own_color(*(accents or ("navy", "crimson", "green", "teal", "maroon")))
        wide = 128 if y >= x else 176
        image = prints.canvas(wide, round(min(max(wide * y / x, 32), 250)), ground)
        mark(look, image, accent)
        h = 0.0011
        pieces: Pieces = []
        for k in range(sheets - 1):
            turn = look.between(-0.06, 0.06)
            pieces.append((at_box(x, y, h).turn(2, turn).move(0.004 * k, -0.003 * k, h * k),
                           surfaces.plain(ground)))  # fmt: skip
        return [*pieces, (at_box(x, y, h, (0, 0, h * (sheets - 1))), image)]

    return draw


@category("parchment", size=(0.156, 0.2, 0.018), mass=0.02, material="paper",
          aliases=("unrolled scroll", "open scroll", "old document", "parchment sheet",
          "sheet of parchment", "royal decree", "ancient manuscript", "manuscript", "declaration"),
          themes=("office",), roles=("flat",), colors=("beige",), state="lying flat")  # fmt: skip
@from_pieces(foot=0.05)
def parchment(look: Look) -> Pieces:
    """A sheet of parchment with writing, half unrolled between two rolls."""
    paper = look.color("beige", "cream", "tan")
    image = prints.canvas(96, 128, paper)
    prints.lines(image, look.rng, (0.12, 0.16, 0.76, 0.66), 15, (98, 74, 52), 0.3)
    prints.disc(image, 0.7, 0.9, 0.045, (150, 30, 34))
    sheet = at_box(0.15, 0.17, 0.0012)
    rolls = [spindle((-0.078, 0.009), (0.078, 0.009), z=0.009).move(y=y) for y in (-0.09, 0.09)]
    tile = surfaces.spots(look.rng, paper, (176, 146, 102), 0.06)
    return [(sheet, image), *((r, tile) for r in rolls)]


PAPER: RGB = (248, 247, 242)
RECEIPT_INK: RGB = (46, 46, 52)


@category("till_roll", size=(0.0683, 0.0685, 0.0729), mass=0.12, material="paper",
          aliases=("receipt roll", "roll of receipts", "till paper", "receipt paper",
          "thermal paper roll", "roll of till paper"), themes=("office",), roles=("round",),
          colors=("white",))  # fmt: skip
def till_roll(look: Look) -> Shape:
    """A narrow roll of till paper lying on its flat side, with a loose end."""
    r, h = look.between(0.03, 0.038), look.between(0.057, 0.08)
    color = look.color("white", "white", "yellow", "pink")
    roll = lathe([(0.3 * r, 0), (r, 0), (r, h), (0.3 * r, h)], 34, loop=True)
    core = lathe([(0.24 * r, 0), (0.31 * r, 0), (0.31 * r, h), (0.24 * r, h)], 20, loop=True)
    tail = box(1.0 * r, 0.0012, 0.96 * h).move(x=0.5 * r, y=-r + 0.0006)
    return shape([(join([roll, tail]), surfaces.speckles(look.rng, color, 3)),
                  (core, surfaces.plain((188, 150, 106)))],
                 [cylinder_part(r, h), hull_of(tail)])  # fmt: skip


@category("receipt", size=(0.0704, 0.166, 0.00423), mass=0.002, material="paper",
          aliases=("till receipt", "shop receipt", "sales receipt", "supermarket receipt",
          "paper receipt", "invoice slip", "bill slip"), themes=("office",), roles=("flat",),
          colors=("white",), state="lying flat")  # fmt: skip
def receipt(look: Look) -> Shape:
    """A slightly curled till receipt."""
    k = look.between(0.9, 1.1)
    image = prints.canvas(96, 220, look.color("white", "ivory", "white"))
    prints.write(image, look.pick(["SHOP", "CAFE", "MARKET", "STORE"]), 0.5, 0.07, 0.06,
                 RECEIPT_INK, bold=True)  # fmt: skip
    for n in range(11):
        y = 0.16 + 0.052 * n
        prints.fill(image, 0.08, y, look.between(0.3, 0.5), 0.014, (90, 90, 96))
        prints.fill(image, 0.78, y, 0.14, 0.014, (90, 90, 96))
    prints.write(image, "TOTAL", 0.3, 0.78, 0.06, RECEIPT_INK, bold=True)
    prints.fill(image, 0.7, 0.765, 0.22, 0.025, RECEIPT_INK)
    prints.barcode(image, look.rng, 0.2, 0.85, 0.6)
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, 3), np.linspace(-0.5, 0.5, 13))
    lift = 0.012 * np.maximum(np.abs(v) * 2 - 0.45, 0) ** 2
    sheet = spread(np.stack([0.072 * u, 0.17 * v, lift], -1), 0.0007)
    return shape([(sheet, image)], [box_part(0.072, 0.1, 0.0008), hull_of(sheet)]).scale(k)


@category("sticker", size=(0.0486, 0.0488, 0.0011), mass=0.001, material="paper",
          aliases=("pricing sticker", "round sticker", "price sticker", "vinyl sticker",
          "smiley sticker", "decal"), themes=("office",), roles=("flat",), colors=("red", "yellow"),
          state="lying flat")  # fmt: skip
def sticker(look: Look) -> Shape:
    """A round, bright sticker, lying flat."""
    r = look.between(0.02, 0.028)
    color = look.color("red", "yellow", "orange", "green", "blue", "pink")
    image = prints.canvas(96, 96, color)
    prints.disc(image, 0.5, 0.5, 0.44, tint_color(color, 1.5))
    prints.disc(image, 0.5, 0.5, 0.38, color)
    prints.write(image, look.pick(["SALE", "1.99", "50%", "NEW", "FREE", "WOW"]), 0.5, 0.5, 0.26,
                 readable_on(color), bold=True)  # fmt: skip
    disc = cylinder(r, 0.0009, 34)
    face = cylinder(0.99 * r, 0.0003, 34).move(z=0.0008)
    return shape([(disc, surfaces.plain(PAPER)), (face, image)], [cylinder_part(r, 0.0011)])


@category("wrapper", size=(0.078, 0.0411, 0.0117), mass=0.001, material="paper", assembled=True,
          aliases=("sweet wrapper", "gum wrapper", "chocolate wrapper", "chewing gum wrapper",
          "crumpled wrapper", "empty wrapper", "foil wrapper", "toffee wrapper",
          "bubblegum wrapper"), themes=("office",), colors=("silver",),
          state="lying flat")  # fmt: skip
def wrapper(look: Look) -> Shape:
    """An empty, crumpled foil wrapper."""
    k = look.between(0.9, 1.2)
    color = look.color("silver", "red", "green", "gold", "purple", "pink", "blue")
    u, v = np.meshgrid(np.linspace(-1, 1, 15), np.linspace(-1, 1, 13))
    a = look.rng.uniform(0, 6, 4)
    lift = 0.0045 + 0.0025 * np.sin(5 * u + 3 * v + a[0]) + 0.002 * np.sin(7 * v - 4 * u + a[1])
    lift = np.maximum(lift * (0.5 + 0.7 * np.abs(u)), 0.0003)
    twist = 0.34 + 0.66 * np.minimum(np.abs(np.abs(u) - 0.62) * 3.2 + 0.1, 1.0)
    pieces = spread(np.stack([0.036 * u, 0.019 * v * twist, lift], -1), 0.0008)
    image = surfaces.fit(surfaces.brushed_metal(look.rng, color), 64, 96).copy()
    prints.fill(image, 0.36, 0.2, 0.28, 0.6, tint_color(color, 1.5))
    prints.write(image[:, 30:66], look.pick(["MINT", "GUM", "TOFFEE"]), 0.5, 0.5, 0.26,
                 tint_color(color, 0.5), bold=True)  # fmt: skip
    return put_down([(pieces, image)], factor=k)


@category("voucher", size=(0.158, 0.0739, 0.0013), mass=0.004, material="paper",
          aliases=("gift voucher", "gift certificate", "discount coupon", "money off coupon"),
          themes=("office",), roles=("flat",), colors=("red", "gold"),
          state="lying flat")  # fmt: skip
def voucher(look: Look) -> Shape:
    """A decorated gift voucher."""
    k = look.between(0.94, 1.08)
    color = look.color("red", "gold", "purple", "teal", "pink", "navy")
    image = prints.canvas(190, 90, color)
    ink = readable_on(color)
    prints.fill(image, 0.03, 0.07, 0.94, 0.03, ink)
    prints.fill(image, 0.03, 0.9, 0.94, 0.03, ink)
    prints.write(image, look.pick(["GIFT VOUCHER", "GIFT VOUCHER", "COUPON"]), 0.5, 0.36, 0.2, ink,
                 bold=True)  # fmt: skip
    prints.write(image, look.pick(["$ 25", "$ 50", "10 % OFF", "$ 100"]), 0.5, 0.68, 0.22, ink)
    x, y = 0.16 * k, 0.075 * k
    return shape([(box(x, y, 0.0011), surfaces.plain(color)),
                  (box(0.995 * x, 0.99 * y, 0.0004).move(z=0.0009), image)],
                 [box_part(x, y, 0.0012)])  # fmt: skip


@category("calendar", size=(0.183, 0.07, 0.134), mass=0.16, material="paper", assembled=True,
          aliases=("desk calendar", "tent calendar", "desktop calendar", "flip calendar",
          "perpetual calendar"), themes=("office",), roles=("tall",),
          colors=("white", "red"))  # fmt: skip
def calendar(look: Look) -> Shape:
    """A ring-bound desk calendar with a month and a picture, or a pair of date blocks."""
    color = look.color("white", "red", "navy", "teal", "black", "wooden", "mustard")
    if look.chance(0.25):
        wood = look.surface(color, "wood")
        x = look.between(0.11, 0.13)
        tray = [box(x, 0.05, 0.01), box(x, 0.008, 0.075).move(y=0.021, z=0.01)]
        pieces, parts = [(join(tray), wood)], [hull_of(s) for s in tray]
        for k, digit in enumerate((look.rng.integers(0, 3), look.rng.integers(1, 10))):
            face = prints.canvas(64, 64, (246, 240, 226))
            prints.write(face, str(int(digit)), 0.5, 0.5, 0.7, (40, 40, 46), bold=True)
            cube = box(0.04, 0.036, 0.04).move((k - 0.5) * 0.045, -0.002, 0.027)
            pieces.append((cube, face))
        month = prints.canvas(128, 24, (246, 240, 226))
        name = look.pick(["JANUARY", "MAY", "JULY", "OCTOBER", "MARCH"])
        prints.write(month, name, 0.5, 0.5, 0.6, (176, 40, 40), bold=True)
        bar = box(0.09, 0.036, 0.017).move(y=-0.002, z=0.01)
        pieces.append((bar, month))
        parts.append(box_part(0.09, 0.036, 0.057, (0, -0.002, 0.01)))
        return shape(pieces, parts)
    x, h = look.between(0.17, 0.22), look.between(0.13, 0.17)
    y = 0.5 * h
    image = prints.canvas(192, 144, (250, 249, 246))
    picture = look.chance(0.5)
    left = 0.5 if picture else 0.06
    if picture:
        image[14:, 8:90] = prints.artwork(look.rng, 82, 130)
    title: tuple[float, float, float] = color if sum(color) < 520 else (180, 40, 44)
    months = ["JAN", "MAY", "JULY", "OCT", "NOV", "APRIL"]
    part = image[:, int(left * 192) : 186]
    prints.fill(part, 0, 0.06, 1, 0.16, title)
    prints.write(part, look.pick(months), 0.5, 0.14, 0.12, readable_on(title), bold=True)
    start = int(look.rng.integers(7))
    for day in range(31):
        u, v = (day + start) % 7, (day + start) // 7
        tone = (196, 60, 56) if u == 6 else (80, 82, 90)
        prints.fill(part, 0.05 + 0.135 * u, 0.3 + 0.115 * v, 0.075, 0.055, tone)
    lean = np.arctan2(0.5 * y, h)
    sheet = box(x, 0.003, h)
    front = sheet.turn(0, -lean).move(y=-0.5 * y)
    back = sheet.turn(0, lean).move(y=0.5 * y)
    foot = box(x, y, 0.002)
    wire = torus(0.006, 0.001, 12, 5).turn(1, np.pi / 2)
    rings = [wire.move(x=(k / 15 - 0.5) * 0.9 * x, z=h - 0.002) for k in range(16)]
    page = box(0.94 * x, 0.001, 0.92 * h).turn(0, -lean).move(y=-0.5 * y - 0.0022, z=0.003)
    card = look.surface(color)
    return shape([(join([front, back, foot]), card), (page, image),
                  (join(rings), surfaces.plain((70, 72, 78)))],
                 [hull_of(front, foot), hull_of(back)])  # fmt: skip


@category("envelope", size=(0.193, 0.117, 0.003), mass=0.02, material="paper", aliases=("mail",),
          themes=("office",), roles=("flat",), colors=("white", "cream"), state="lying flat",
          common=True)  # fmt: skip
def envelope(look: Look) -> Shape:
    """An envelope with a stamp and an address, or with its flap up."""
    x, y = look.between(0.16, 0.225), look.between(0.11, 0.125)
    color = look.color("white", "cream", "tan", "sky", "pink", "sage")
    image = prints.canvas(224, 128, color)
    if look.chance(0.5):
        prints.lines(image, look.rng, (0.42, 0.5, 0.4, 0.3), 4, (60, 62, 80), 0.3)
        prints.lines(image, look.rng, (0.05, 0.08, 0.22, 0.16), 3, (90, 92, 100), 0.3)
        stamp = prints.landscape(look.rng, 30, 36)
        prints.fill(image, 0.83, 0.07, 0.145, 0.3, (250, 250, 246))
        image[11:47, 188:218] = stamp
        prints.disc(image, 0.76, 0.24, 0.13, tint_color(color, 0.6), 0.115)
    else:
        u, v = np.linspace(-1, 1, 224)[None], np.linspace(0, 1, 128)[:, None]
        edge = np.abs(v - 0.62 * (1 - np.abs(u))) < 0.012
        image[edge] = np.array(tint_color(color, 0.7), np.uint8)
        image[(v < 0.62 * (1 - np.abs(u))).astype(bool)] = np.array(
            tint_color(color, 0.9), np.uint8
        )
        if look.chance(0.6):
            wax = look.own_color("red", "crimson", "navy", "gold")
            prints.disc(image, 0.5, 0.58, 0.1, wax)
            prints.disc(image, 0.5, 0.58, 0.06, tint_color(wax, 0.8))
    if look.chance(0.3):
        for k in range(18):
            ink = ((190, 50, 50), (50, 80, 160), (245, 245, 240))[k % 3]
            for v in (0, 0.95):
                prints.fill(image, k / 18, v, 1 / 18, 0.05, ink)
    body = box(x, y, 0.003)
    return shape([(body, image)], [box_part(x, y, 0.003)])


@category("paper_stack", size=(0.215, 0.3, 0.005), mass=0.05, material="paper", aliases=("paper",
          "document", "papers", "sheet of paper", "scrap of paper", "newspaper page",
          "construction paper sheet", "origami paper pack", "tissue paper sheet",
          "tracing paper pad", "scrapbook page", "fishing licence", "card blank",
          "sheet of cardstock", "sheet of card", "traveller's cheque", "swimming certificate",
          "times table poster", "reward chart", "kirigami card", "paper ream", "ream of paper",
          "agenda", "application form", "leaflet", "flyer"), themes=("office",),
          roles=("support", "flat"), state="lying flat", common=True)  # fmt: skip
def paper_stack(look: Look) -> Shape:
    """A few printed sheets in a slightly uneven stack."""
    x, y, t = 0.21, 0.297, 0.0012
    pieces = []
    count = int(look.rng.integers(3, 6))
    for k in range(count):
        tile = prints.sheet(look.rng, picture=look.chance(0.4))
        turn = look.between(-0.05, 0.05) if k else 0.0
        pieces.append((box(x, y, t).turn(2, turn).move(z=k * t), tile))
    return shape(pieces, [box_part(x, y, t * count)])


@category("letter", size=(0.18, 0.245, 0.012), mass=0.006, material="paper", assembled=True,
          aliases=("handwritten letter", "love letter", "handwritten note", "typed letter",
          "letter to santa", "letter to father christmas"), themes=("office",), roles=("flat",),
          colors=("white", "cream"), state="lying flat")  # fmt: skip
def letter(look: Look) -> Shape:
    """A handwritten or typed letter with creases where it was folded in three."""
    x, y = look.between(0.15, 0.21), look.between(0.21, 0.28)
    color = look.color("white", "white", "cream", "ivory", "pink", "sky", spread=10)
    image = prints.canvas(144, 192, color)
    ink = look.own_color("navy", "black", "charcoal", "indigo")
    if look.chance(0.6):
        for row in range(11):
            width = 0.3 if row == 0 else look.between(0.6, 0.8) if row < 9 else 0.35
            t = np.linspace(0, 1, int(30 * width) + 6)
            wave = (
                0.1 + 0.072 * row + 0.012 * np.sin(46 * t * width + row) * np.sin(17 * t + 2 * row)
            )
            prints.stroke(
                image, [(0.12 + width * u, v) for u, v in zip(t, wave, strict=True)], 0.006, ink
            )
    else:
        prints.fill(image, 0.1, 0.05, 0.24, 0.05, look.own_color("red", "teal", "navy", "green"))
        prints.lines(image, look.rng, (0.62, 0.06, 0.26, 0.06), 3, (120, 120, 126))
        prints.lines(image, look.rng, (0.12, 0.22, 0.76, 0.56), 15, (110, 110, 116))
        t = np.linspace(0, 1, 20)
        prints.stroke(
            image, [(0.14 + 0.24 * u, 0.87 + 0.02 * np.sin(30 * u)) for u in t], 0.008, ink
        )
    rows, columns = 19, 5
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, columns), np.linspace(-0.5, 0.5, rows))
    crease = 0.035 * np.clip(np.abs(v) - 1 / 6, 0, 1)
    page = spread(np.stack([u * x, v * y, crease], -1), 0.0008)
    return shape([(page, image)], [box_part(x, 0.36 * y, 0.0008), *(box_part(x, 0.3 * y, 0.006,
                                                                             (0, s * 0.34 * y, 0.0))
                                                                    for s in (-1, 1))])  # fmt: skip


@category("price_tag", size=(0.101, 0.0382, 0.0294), mass=0.008, material="paper", assembled=True,
          aliases=("price label", "price card", "price sign", "sale tag"), themes=("office",),
          roles=("flat",), colors=("white", "yellow"))  # fmt: skip
def price_tag(look: Look) -> Shape:
    """A price tag that lies flat with a hole and a string, or leans on a small stand."""
    color = look.color("white", "yellow", "tan", "red", "orange", "lime", "sky")
    price = f"{int(look.rng.integers(1, 99))}.{look.pick(['99', '50', '00', '95'])}"
    ink = readable_on(color)
    if look.chance(0.5):
        x, y = look.between(0.06, 0.085), look.between(0.034, 0.045)
        cut = 0.25 * y
        outline = np.array([(-x / 2 + cut, -y / 2), (x / 2, -y / 2), (x / 2, y / 2),
                            (-x / 2 + cut, y / 2), (-x / 2, y / 2 - cut),
                            (-x / 2, -y / 2 + cut)])  # fmt: skip
        card = prism(outline, 0, 0.0014)
        image = prints.canvas(128, 72, color)
        prints.disc(image, 0.12, 0.5, 0.12, tint_color(color, 0.6))
        prints.disc(image, 0.12, 0.5, 0.07, (60, 50, 44))
        prints.write(image[:, 26:], price, 0.52, 0.5, 0.4, ink, bold=True)
        face = prism(outline * 0.995, 0.0013, 0.0017)
        string = tube(smooth([(-x / 2 + 0.009, 0, 0.002), (-x / 2 - 0.01, 0.006, 0.0014),
                              (-x / 2 - 0.035, 0.016, 0.0012), (-x / 2 - 0.04, 0.0, 0.0012),
                              (-x / 2 - 0.012, -0.004, 0.0014), (-x / 2 + 0.009, 0, 0.0024)], 4),
                      0.0007, 5)  # fmt: skip
        return shape([(card, surfaces.plain(tint_color(color, 0.92))), (face, image),
                      (string, surfaces.plain((236, 230, 214)))], [hull_of(card)])  # fmt: skip
    x, h = look.between(0.07, 0.1), look.between(0.045, 0.06)
    image = prints.canvas(144, 80, color)
    prints.fill(image, 0, 0, 1, 0.2, tint_color(color, 0.75))
    prints.write(image, price, 0.5, 0.5, 0.4, ink, bold=True)
    foot = block(0.6 * x, 0.035, 0.006, 0.006, 0.001)
    lean = 0.2
    card = box(x, 0.002, h).turn(0, -lean).move(z=0.005)
    face = box(0.97 * x, 0.0006, 0.95 * h).turn(0, -lean).move(y=-0.0012, z=0.006)
    clip = box(0.3 * x, 0.012, 0.006).move(y=0.001, z=0.004)
    dark = surfaces.plain(look.own_color("black", "silver", "white", "wooden"))
    return shape([(join([foot, clip]), dark), (card, surfaces.plain(tint_color(color, 0.92))),
                  (face, image)], [hull_of(foot), hull_of(card)])  # fmt: skip


@category("crumpled_paper", size=(0.0613, 0.0595, 0.0481), mass=0.005, material="paper",
          aliases=("crumpled paper ball", "paper ball", "balled-up paper", "scrunched paper",
          "crumpled sheet", "crumpled note", "ball of paper", "scrunched-up paper",
          "crumpled newspaper", "wad of paper"), themes=("office",), colors=("white",))  # fmt: skip
def crumpled_paper(look: Look) -> Shape:
    """A sheet crumpled into a ball."""
    color = look.color("white", "cream", "yellow", "sky", "white")
    d = look.between(0.045, 0.075)
    lump = ball(d, d, 0.86 * d, (0, 0, 0.41 * d), 30)
    knots = look.rng.normal(size=(26, 3))
    knots /= np.linalg.norm(knots, axis=1, keepdims=True)

    def warp(p: np.ndarray) -> np.ndarray:
        way = p - [0, 0, 0.41 * d]
        unit = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-9)
        near = np.sort(unit @ knots.T, axis=1)[:, -2:]
        dent = 1 - 0.24 * np.clip((near[:, 1] - near[:, 0]) / 0.13, 0, 1)
        return way * dent[:, None] + [0, 0, 0.41 * d]

    made = lump.bend(warp)
    made = made.move(z=-float(made.bounds[0, 2]) - 0.06 * d)
    image = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 120)
    return put_down([(made, image)], made)


CATEGORIES = (
    Category("star_chart",
             vary(0.08)(from_pieces(spread=0.06)(paper(0.28, 0.28, _stars, "navy"))),
             size=(0.28, 0.28, 0.0011), mass=0.008, material="paper",
             aliases=("star map", "sky map", "constellation chart", "constellation map"),
             themes=("office",), roles=("flat",), colors=("navy",), state="lying flat"),
    Category("telegram",
             vary(0.08)(from_pieces(spread=0.06)(paper(0.2, 0.13, _telegram, "beige", "cream"))),
             size=(0.2, 0.13, 0.0011), mass=0.003, material="paper", aliases=("telegraph message",),
             themes=("office",), roles=("flat",), colors=("beige",), state="lying flat"),
    Category("ransom_note", from_pieces(spread=0.06)(paper(0.17, 0.2, _ransom, "white", "cream")),
             size=(0.17, 0.2, 0.0011), mass=0.004, material="paper", aliases=("collage note",),
             themes=("office",), roles=("flat",), colors=("white",), state="lying flat"),
    Category("shopping_list",
             from_pieces(spread=0.06)(paper(0.1, 0.16, _list, "white", "yellow", "cream")),
             size=(0.1, 0.16, 0.0011), mass=0.002, material="paper", aliases=("to do list",
             "grocery list", "todo list", "packing list", "handwritten list", "wish list"),
             themes=("office",), roles=("flat",), colors=("white",), state="lying flat"),
    Category("xray_film", from_pieces(spread=0.06)(paper(0.24, 0.3, _film, "charcoal")),
             size=(0.24, 0.3, 0.0011), mass=0.01, material="paper",
             aliases=("x ray film", "x ray", "xray", "x ray image", "x-ray film", "x-ray"),
             themes=("office",), roles=("flat",), colors=("charcoal",), state="lying flat"),
    Category("eye_chart", vary(0.08)(from_pieces(spread=0.06)(paper(0.2, 0.29, _chart, "white"))),
             size=(0.2, 0.29, 0.0011), mass=0.006, material="paper",
             aliases=("eye test chart", "snellen chart", "vision chart"), themes=("office",),
             roles=("flat",), colors=("white",), state="lying flat"),
    Category("colour_chart",
             vary(0.08)(from_pieces(spread=0.06)(paper(0.21, 0.16, _swatch, "white"))),
             size=(0.21, 0.16, 0.0011), mass=0.006, material="paper", aliases=("color chart",
             "paint chart", "colour card", "color swatch", "colour swatch", "paint swatch",
             "colour sample card", "periodic table"), themes=("office",), roles=("flat",),
             colors=("white",), state="lying flat"),
    Category("poster", from_pieces(spread=0.06)(paper(0.3, 0.42, _poster, "white", "cream")),
             size=(0.3, 0.42, 0.0011), mass=0.02, material="paper", aliases=("art print",
             "film poster", "movie poster", "concert poster", "unframed print"), themes=("office",),
             roles=("flat",), colors=("white",), state="lying flat"),
    Category("invoice", from_pieces(spread=0.06)(paper(*A4, _invoice, "white")),
             size=(0.21, 0.297, 0.0011), mass=0.005, material="paper", aliases=("bill",
             "tax return", "bank statement", "payslip", "pay slip", "utility bill", "tax form",
             "order form"), themes=("office",), roles=("flat",), colors=("white",),
             state="lying flat"),
    Category("contract",
             from_pieces(spread=0.06)(paper(*A4, _contract, "white", "ivory", sheets=3)),
             size=(0.225, 0.305, 0.0033), mass=0.015, material="paper", aliases=("agreement",
             "lease agreement", "affidavit", "subpoena", "insurance policy", "treaty",
             "signed contract", "legal document", "rental agreement", "last will", "testament"),
             themes=("office",), roles=("flat",), colors=("white",), state="lying flat"),
    Category("official_letter",
             vary(0.08)(from_pieces(spread=0.06)(paper(*A4, _letterhead, "white", "ivory"))),
             size=(0.21, 0.297, 0.0011), mass=0.005, material="paper", aliases=("business letter",
             "prescription", "memo", "memorandum", "cover letter", "iou", "prescription note",
             "printed letter"), themes=("office",), roles=("flat",), colors=("white",),
             state="lying flat"),
    Category("resume", from_pieces(spread=0.06)(paper(*A4, _resume, "white")),
             size=(0.21, 0.297, 0.0011), mass=0.005, material="paper",
             aliases=("cv", "curriculum vitae", "job application"), themes=("office",),
             roles=("flat",), colors=("white",), state="lying flat"),
    Category("coupon", from_pieces(spread=0.06)(paper(0.15, 0.07, _coupon, "white", accents=("red",
             "orange", "green", "purple", "blue"))), size=(0.15, 0.07, 0.0011), mass=0.002,
             material="paper", aliases=("gift coupon", "discount voucher"), themes=("office",),
             roles=("flat",), colors=("white",), state="lying flat"),
    Category("floor_plan", from_pieces(spread=0.06)(paper(0.297, 0.21, _floor, "white", "cream")),
             size=(0.297, 0.21, 0.0011), mass=0.006, material="paper",
             aliases=("floorplan", "ground plan", "house plan", "site plan"), themes=("office",),
             roles=("flat",), colors=("white",), state="lying flat"),
    Category("certificate",
             sheet_of(("CERTIFICATE", "MARRIAGE", "DIPLOMA", "AWARD"), 0.25, 0.18, "certificate"),
             size=(0.252, 0.182, 0.0018), mass=0.012, material="paper",
             aliases=("wedding certificate", "marriage certificate", "marriage licence",
             "marriage license", "diploma", "award certificate", "birth certificate",
             "degree certificate"), themes=("office",), roles=("flat",), colors=("cream",),
             state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
