"""Slips of paper: receipts, menus, vouchers, stickers, wrappers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import spread
from ...build.recipes import put_down
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, lathe
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from .shopfront import _menu_page

PAPER: RGB = (248, 247, 242)
INK: RGB = (46, 46, 52)


def paper_roll(look: Look) -> Shape:
    """A narrow roll of till paper lying on its flat side, its end loose."""
    r, h = look.between(0.03, 0.038), look.between(0.057, 0.08)
    color = look.color("white", "white", "yellow", "pink")
    roll = lathe([(0.3 * r, 0), (r, 0), (r, h), (0.3 * r, h)], 34, loop=True)
    core = lathe([(0.24 * r, 0), (0.31 * r, 0), (0.31 * r, h), (0.24 * r, h)], 20, loop=True)
    tail = box(1.0 * r, 0.0012, 0.96 * h).move(x=0.5 * r, y=-r + 0.0006)
    return shape([(join([roll, tail]), textures.speckles(look.rng, color, 3)),
                  (core, textures.plain((188, 150, 106)))],
                 [cylinder_part(r, h), hull_of(tail)])  # fmt: skip


def receipt(look: Look) -> Shape:
    """A till receipt, slightly curled."""
    k = look.between(0.9, 1.1)
    image = prints.canvas(96, 220, look.color("white", "ivory", "white"))
    prints.write(image, look.pick(["SHOP", "CAFE", "MARKET", "STORE"]), 0.5, 0.07, 0.06, INK,
                 bold=True)  # fmt: skip
    for n in range(11):
        y = 0.16 + 0.052 * n
        prints.fill(image, 0.08, y, look.between(0.3, 0.5), 0.014, (90, 90, 96))
        prints.fill(image, 0.78, y, 0.14, 0.014, (90, 90, 96))
    prints.write(image, "TOTAL", 0.3, 0.78, 0.06, INK, bold=True)
    prints.fill(image, 0.7, 0.765, 0.22, 0.025, INK)
    prints.barcode(image, look.rng, 0.2, 0.85, 0.6)
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, 3), np.linspace(-0.5, 0.5, 13))
    lift = 0.012 * np.maximum(np.abs(v) * 2 - 0.45, 0) ** 2
    sheet = spread(np.stack([0.072 * u, 0.17 * v, lift], -1), 0.0007)
    return shape([(sheet, image)], [box_part(0.072, 0.1, 0.0008), hull_of(sheet)]).scale(k)


def menu(look: Look) -> Shape:
    """A restaurant's menu: a folded card standing ajar, or a sheet lying."""
    k = look.between(0.92, 1.06)
    color = look.color("cream", "white", "maroon", "navy", "black", "green")
    image = _menu_page(look, color, 140, 200)
    t = 0.0028
    card = box(0.155 * k, 0.22 * k, t)
    face = box(0.154 * k, 0.219 * k, 0.0005).move(z=t - 0.0002)
    return shape([(card, textures.plain(tint_color(color, 0.85))), (face, image)],
                 [box_part(0.155 * k, 0.22 * k, t)])  # fmt: skip


def place_card(look: Look) -> Shape:
    """A small tent of card with a name on it."""
    k = look.between(0.92, 1.1)
    color = look.color("white", "cream", "ivory", "pink", "mint", "sky")
    image = prints.canvas(150, 84, color)
    gold = (190, 150, 70)
    prints.fill(image, 0.04, 0.08, 0.92, 0.03, gold)
    prints.fill(image, 0.04, 0.88, 0.92, 0.03, gold)
    prints.write(image, look.pick(["Anna", "James", "Emma", "Leo", "Sofia", "Oliver"]), 0.5, 0.5,
                 0.34, (60, 52, 60))  # fmt: skip
    x, h, t, lean = 0.09 * k, 0.05 * k, 0.0012, 0.45
    leaves = []
    for s in (-1, 1):
        leaf = box(x, t, h).move(z=-h).turn(0, s * lean).move(z=h * np.cos(lean))
        leaves.append(leaf.move(z=-float(leaf.bounds[0, 2])))
    front = leaves[0] if leaves[0].bounds[0, 1] < leaves[1].bounds[0, 1] else leaves[1]
    rear = leaves[1] if front is leaves[0] else leaves[0]
    return shape([(front, image), (rear, textures.plain(tint_color(color, 0.97)))],
                 [hull_of(front), hull_of(rear)])  # fmt: skip


def sticker(look: Look) -> Shape:
    """A round, bright sticker lying."""
    r = look.between(0.02, 0.028)
    color = look.color("red", "yellow", "orange", "green", "blue", "pink")
    image = prints.canvas(96, 96, color)
    prints.disc(image, 0.5, 0.5, 0.44, tint_color(color, 1.5))
    prints.disc(image, 0.5, 0.5, 0.38, color)
    prints.write(image, look.pick(["SALE", "1.99", "50%", "NEW", "FREE", "WOW"]), 0.5, 0.5, 0.26,
                 readable_on(color), bold=True)  # fmt: skip
    disc = cylinder(r, 0.0009, 34)
    face = cylinder(0.99 * r, 0.0003, 34).move(z=0.0008)
    return shape([(disc, textures.plain(PAPER)), (face, image)], [cylinder_part(r, 0.0011)])


def wrapper(look: Look) -> Shape:
    """An empty, crumpled foil wrapper of gum or a sweet."""
    k = look.between(0.9, 1.2)
    color = look.color("silver", "red", "green", "gold", "purple", "pink", "blue")
    u, v = np.meshgrid(np.linspace(-1, 1, 15), np.linspace(-1, 1, 13))
    a = look.rng.uniform(0, 6, 4)
    lift = 0.0045 + 0.0025 * np.sin(5 * u + 3 * v + a[0]) + 0.002 * np.sin(7 * v - 4 * u + a[1])
    lift = np.maximum(lift * (0.5 + 0.7 * np.abs(u)), 0.0003)
    twist = 0.34 + 0.66 * np.minimum(np.abs(np.abs(u) - 0.62) * 3.2 + 0.1, 1.0)
    pieces = spread(np.stack([0.036 * u, 0.019 * v * twist, lift], -1), 0.0008)
    image = textures.fit(textures.brushed_metal(look.rng, color), 64, 96).copy()
    prints.fill(image, 0.36, 0.2, 0.28, 0.6, tint_color(color, 1.5))
    prints.write(image[:, 30:66], look.pick(["MINT", "GUM", "TOFFEE"]), 0.5, 0.5, 0.26,
                 tint_color(color, 0.5), bold=True)  # fmt: skip
    return put_down([(pieces, image)], factor=k)


def scorecard(look: Look) -> Shape:
    """A ruled card for scores with a few figures."""
    k = look.between(0.92, 1.08)
    color = look.color("white", "cream", "mint", "pink")
    image = textures.fit(textures.grid((120, 130, 150), color, 12, 5, 160), 170, 120).copy()
    prints.fill(image, 0, 0, 1, 0.09, (70, 96, 140))
    for n in range(10):
        prints.write(image[:, 24 * (n % 5) : 24 * (n % 5) + 24], str(int(look.rng.integers(1, 60))),
                     0.5, 0.13 + 0.083 * (n // 2 + 0.4), 0.05, (50, 60, 130))  # fmt: skip
    x, y = 0.105 * k, 0.148 * k
    return shape([(box(x, y, 0.0012), textures.plain(color)),
                  (box(0.99 * x, 0.99 * y, 0.0004).move(z=0.001), image)],
                 [box_part(x, y, 0.0013)])  # fmt: skip


def voucher(look: Look) -> Shape:
    """A gift voucher: a decorated slip of card."""
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
    return shape([(box(x, y, 0.0011), textures.plain(color)),
                  (box(0.995 * x, 0.99 * y, 0.0004).move(z=0.0009), image)],
                 [box_part(x, y, 0.0012)])  # fmt: skip


_O = ("office",)
_F = ("flat",)
_L = "lying flat"


CATEGORIES = (
    Category("till_roll", paper_roll, (0.0683, 0.0685, 0.0729), 0.12, ("receipt roll",
             "roll of receipts", "till paper", "receipt paper", "thermal paper roll",
             "roll of till paper"), _O, ("round",), ("white",)),
    Category("receipt", receipt, (0.0704, 0.166, 0.00423), 0.002, ("till receipt", "shop receipt",
             "sales receipt", "supermarket receipt", "paper receipt", "invoice slip", "bill slip"),
             _O, _F, ("white",), state=_L),
    Category("menu", menu, (0.157, 0.223, 0.0031), 0.06, ("restaurant menu",
             "cafe menu", "takeaway menu", "drinks menu", "wine list", "dessert menu"),
             ("dining",), _F, ("cream", "maroon"), state=_L),
    Category("place_card", place_card, (0.093, 0.046, 0.047), 0.003, ("place name card",
             "name tent", "table name card", "wedding place card",
             "place setting card", "reserved sign", "name place card"),
             ("dining",), (), ("white",)),
    Category("sticker", sticker, (0.0486, 0.0488, 0.0011), 0.001, ("pricing sticker",
             "round sticker", "price sticker", "vinyl sticker", "smiley sticker",
             "decal"), _O, _F, ("red", "yellow"), state=_L),
    Category("wrapper", wrapper, (0.078, 0.0411, 0.0117), 0.001, ("sweet wrapper", "gum wrapper",
             "chocolate wrapper", "chewing gum wrapper", "crumpled wrapper",
             "empty wrapper", "foil wrapper", "toffee wrapper", "bubblegum wrapper"), _O, (),
             ("silver",), state=_L),
    Category("scorecard", scorecard, (0.105, 0.148, 0.0014), 0.004, ("score card",
             "bridge scorecard", "score sheet", "golf scorecard", "scoresheet"), _O,
             _F, ("white",), state=_L),
    Category("voucher", voucher, (0.158, 0.0739, 0.0013), 0.004, ("gift voucher",
             "gift certificate", "discount coupon", "money off coupon"), _O, _F, ("red", "gold"),
             state=_L),
)  # fmt: skip
"""The module's categories."""
