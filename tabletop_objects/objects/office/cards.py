"""Objects of the ``office`` theme: cards."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box
from ...kit.surfaces import RGB, Look, readable_on, tint_color


@category("scorecard", size=(0.105, 0.148, 0.0014), mass=0.004, material="paper",
          aliases=("score card", "bridge scorecard", "score sheet", "golf scorecard", "scoresheet"),
          themes=("office",), roles=("flat",), colors=("white",), state="lying flat")  # fmt: skip
def scorecard(look: Look) -> Shape:
    """A ruled scorecard with a few numbers."""
    k = look.between(0.92, 1.08)
    color = look.color("white", "cream", "mint", "pink")
    image = surfaces.fit(surfaces.grid((120, 130, 150), color, 12, 5, 160), 170, 120).copy()
    prints.fill(image, 0, 0, 1, 0.09, (70, 96, 140))
    for n in range(10):
        prints.write(image[:, 24 * (n % 5) : 24 * (n % 5) + 24], str(int(look.rng.integers(1, 60))),
                     0.5, 0.13 + 0.083 * (n // 2 + 0.4), 0.05, (50, 60, 130))  # fmt: skip
    x, y = 0.105 * k, 0.148 * k
    return shape([(box(x, y, 0.0012), surfaces.plain(color)),
                  (box(0.99 * x, 0.99 * y, 0.0004).move(z=0.001), image)],
                 [box_part(x, y, 0.0013)])  # fmt: skip


Draw = Callable[[Look, RGB], surfaces.Tile]


def _card(
    x: float, y: float, h: float, draw: Draw, palette: tuple[str, ...], count: int = 1
) -> Callable[[Look], Shape]:
    """Return the shape function of a card or a pile of cards; ``draw`` prints the face."""

    def make(look: Look) -> Shape:
        k = look.between(0.98, 1.03)
        color = look.color(*palette)
        a, b = x * k, y * k
        tall = h * (count if count == 1 else int(look.rng.integers(count // 2, count)))
        body = block(a, b, tall, 0.03 * a)
        edge = surfaces.plain(tint_color(color, 0.9)) if count == 1 else surfaces.stripes(
            [color, tint_color(color, 0.82)], 12)  # fmt: skip
        face = block(0.995 * a, 0.995 * b, 0.0004, 0.03 * a).move(z=tall - 0.0002)
        return shape([(body, edge), (face, draw(look, color))], [box_part(a, b, tall)])

    return make


def _bank(look: Look, color: RGB) -> surfaces.Tile:
    image = surfaces.fit(surfaces.gradient(tint_color(color, 0.75), tint_color(color, 1.2),
        look.rng,
                                           3), 100, 160).copy()  # fmt: skip
    ink = readable_on(color)
    prints.fill(image, 0.09, 0.34, 0.14, 0.18, (222, 190, 110))
    prints.fill(image, 0.15, 0.34, 0.012, 0.18, (160, 130, 70))
    prints.write(image, "4812 5566 0913 2207", 0.5, 0.65, 0.1, ink)
    prints.write(image[:, :90], "ALEX SMITH", 0.5, 0.86, 0.09, ink)
    prints.disc(image, 0.8, 0.84, 0.1, (220, 70, 60))
    prints.disc(image, 0.88, 0.84, 0.1, (240, 170, 60))
    return image


def _identity(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(160, 100, (244, 245, 246))
    prints.fill(image, 0, 0, 1, 0.22, color)
    prints.write(image, look.pick(["ID CARD", "STUDENT", "STAFF", "MEMBER"]), 0.5, 0.11, 0.13,
                 readable_on(color), bold=True)  # fmt: skip
    prints.fill(image, 0.06, 0.3, 0.28, 0.6, (190, 204, 216))
    prints.disc(image, 0.2, 0.52, 0.12, (222, 178, 146))
    prints.polygon(image, [(0.09, 0.9), (0.13, 0.68), (0.27, 0.68), (0.31, 0.9)], (70, 80, 110))
    prints.lines(image, look.rng, (0.42, 0.34, 0.5, 0.36), 4, (90, 96, 108))
    prints.barcode(image, look.rng, 0.42, 0.74, 0.4)
    return image


def _business(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(160, 92, color)
    ink, accent = readable_on(color), look.own_color("red", "teal", "gold", "blue", "orange")
    prints.disc(image, 0.17, 0.36, 0.15, accent)
    prints.write(image[:, 56:], look.pick(["JANE DOE", "A. MEYER", "STUDIO X", "T. CHEN"]), 0.45,
        0.28,
                 0.17, ink, bold=True)  # fmt: skip
    prints.lines(image, look.rng, (0.42, 0.48, 0.48, 0.36), 4, ink, 0.25)
    return image


def _rule_lines(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(160, 96, color)
    for n in range(8):
        prints.fill(image, 0, 0.2 + 0.1 * n, 1, 0.012, (150, 180, 220) if n else (220, 100, 100))
    if look.chance(0.6):
        prints.lines(image, look.rng, (0.08, 0.26, 0.7, 0.4), 4, (60, 66, 100), 0.35)
    return image


def _postcard(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(176, 120, color)
    image[7:-7, 7:-7] = surfaces.fit(prints.landscape(look.rng, 162, 106), 106, 162)
    word = look.pick(["GREETINGS", "HELLO", "PARIS", "ALPS", "BEACH"])
    prints.write(image, word, 0.5, 0.24, 0.2, (250, 250, 246), bold=True)
    return image


@category("greeting_card", size=(0.119, 0.073, 0.15), mass=0.02, material="paper", assembled=True,
          friction=0.6, aliases=("birthday card", "christmas card", "thank you card",
          "wedding card", "invitation", "invitation card", "valentine card", "folded card",
          "get well card", "get-well card", "valentine's card", "valentines card", "sympathy card",
          "notelet", "mother's day card", "anniversary card", "easter card", "father's day card",
          "condolence card", "new year card", "pop-up card", "quilled card", "pop up card",
          "table tent", "tent card", "menu card stand"), themes=("office",), roles=("tall",),
          colors=("pink", "sky"))  # fmt: skip
def greeting_card(look: Look) -> Shape:
    """A folded greeting card standing like a tent with its picture in front."""
    k = look.between(0.9, 1.08)
    color = look.color("pink", "sky", "yellow", "mint", "cream", "red", "lavender")
    x, h, t, lean = 0.12 * k, 0.155 * k, 0.0016, 0.24
    image = prints.canvas(120, 156, color)
    ink = readable_on(color)
    word = look.pick(["HAPPY BIRTHDAY", "THANK YOU", "WITH LOVE", "CONGRATS", "BEST WISHES"])
    prints.write(image, word, 0.5, 0.16, 0.09, ink, bold=True)
    for n in range(5):
        a = n * 2 * np.pi / 5
        prints.disc(image, 0.5 + 0.17 * np.cos(a), 0.6 + 0.13 * np.sin(a), 0.09, look.own_color(
            "red", "orange", "purple", "blue"))  # fmt: skip
    prints.disc(image, 0.5, 0.6, 0.07, (246, 214, 90))
    leaves = []
    for s in (-1, 1):
        leaf = box(x, t, h).move(z=-h).turn(0, s * lean).move(z=h * np.cos(lean))
        leaves.append(leaf.move(z=-float(leaf.bounds[0, 2])))
    front = leaves[0] if leaves[0].bounds[0, 1] < leaves[1].bounds[0, 1] else leaves[1]
    rear = leaves[1] if front is leaves[0] else leaves[0]
    return shape([(front, image), (rear, surfaces.plain(tint_color(color, 1.1)))],
                 [hull_of(front), hull_of(rear)])  # fmt: skip


CATEGORIES = (
    Category("credit_card",
             _card(0.0856, 0.054, 0.0011, _bank, ("navy", "black", "red", "teal", "gold", "gray")),
             size=(0.0856, 0.054, 0.0012), mass=0.005, material="plastic", aliases=("bank card",
             "debit card", "payment card", "gift card", "atm card", "loyalty card", "phone card",
             "punch card", "store card", "travel card", "metro card", "hotel key card", "key card",
             "oyster card", "bus pass", "hall pass", "transit card", "insurance card"),
             themes=("office",), roles=("flat",), colors=("navy", "black")),
    Category("id_card", _card(0.0856, 0.054, 0.0011, _identity, ("blue", "red", "green", "navy")),
             size=(0.0856, 0.054, 0.0012), mass=0.005, material="plastic", aliases=("identity card",
             "id badge", "student card", "name badge", "driving licence", "membership card",
             "driver's license", "library card", "name tag card", "press card", "membership badge",
             "lanyard", "conference badge"), themes=("office",), roles=("flat",), colors=("blue",)),
    Category("business_card",
             _card(0.086, 0.052, 0.0009, _business, ("white", "cream", "black", "white")),
             size=(0.086, 0.052, 0.001), mass=0.0015, material="paper",
             aliases=("visiting card", "name card", "calling card"), themes=("office",),
             roles=("flat",), colors=("white",)),
    Category("index_card",
             _card(0.127, 0.076, 0.0009, _rule_lines, ("white", "cream", "yellow", "white")),
             size=(0.127, 0.076, 0.001), mass=0.003, material="paper", aliases=("flash card",
             "flashcard", "note card", "record card", "cue card", "recipe card", "phonics card",
             "wax strip"), themes=("office",), roles=("flat",), colors=("white",)),
    Category("postcard", _card(0.148, 0.105, 0.0009, _postcard, ("white", "cream")),
             size=(0.148, 0.105, 0.001), mass=0.005, material="paper",
             aliases=("picture postcard", "holiday postcard", "post card"), themes=("office",),
             roles=("flat",), colors=("white",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
