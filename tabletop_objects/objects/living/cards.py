"""Objects of the ``living`` theme: cards."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Category, Shape, category, shape, vary
from ...kit.solids import block, box, cylinder, join
from ...kit.surfaces import RGB, Look, readable_on, tint_color

Draw = Callable[[Look, RGB], surfaces.Tile]


def _trading(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(120, 168, color)
    prints.fill(image, 0.05, 0.035, 0.9, 0.93, tint_color(color, 1.55))
    prints.write(image, look.pick(["FLAMOR", "AQUALIX", "STRIKER", "DRAGOL", "KEEPER"]), 0.42, 0.09,
                 0.07, (40, 40, 46), bold=True)  # fmt: skip
    prints.disc(image, 0.88, 0.09, 0.035, look.own_color("red", "blue", "gold"))
    image[26:92, 12:108] = surfaces.fit(prints.artwork(look.rng, 96, 66), 66, 96)
    prints.fill(image, 0.1, 0.575, 0.8, 0.05, color)
    prints.lines(image, look.rng, (0.12, 0.66, 0.76, 0.22), 4, (70, 70, 78))
    prints.fill(image, 0.1, 0.92, 0.2, 0.02, (70, 70, 78))
    return image


def _sport(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(120, 168, (250, 248, 242))
    prints.fill(image, 0.06, 0.05, 0.88, 0.76, look.pick([(150, 196, 226), (120, 170, 100)]))
    prints.disc(image, 0.5, 0.3, 0.09, (226, 184, 148))
    prints.fill(image, 0.4, 0.19, 0.2, 0.07, color)
    prints.fill(image, 0.4, 0.24, 0.3, 0.02, color)
    prints.polygon(image, [(0.22, 0.81), (0.3, 0.48), (0.7, 0.48), (0.78, 0.81)], color)
    prints.fill(image, 0.48, 0.45, 0.04, 0.36, tint_color(color, 1.5))
    prints.fill(image, 0.06, 0.82, 0.88, 0.12, color)
    prints.write(image, look.pick(["B. RUTHER", "LIONS 7", "J. SMITH", "ROVERS"]), 0.5, 0.88, 0.08,
                 readable_on(color), bold=True)  # fmt: skip
    return image


def _tarot(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(104, 180, (244, 234, 206))
    gold = (190, 146, 60)
    prints.fill(image, 0.06, 0.04, 0.88, 0.92, gold)
    prints.fill(image, 0.09, 0.055, 0.82, 0.89, color)
    name = look.pick(["THE SUN", "THE MOON", "THE STAR", "THE FOOL"])
    if name == "THE SUN":
        for n in range(12):
            a = n * np.pi / 6
            prints.polygon(image, [(0.5 + 0.2 * np.cos(a - 0.2), 0.42 + 0.116 * np.sin(a - 0.2)),
                                   (0.5 + 0.38 * np.cos(a), 0.42 + 0.22 * np.sin(a)),
                                   (0.5 + 0.2 * np.cos(a + 0.2), 0.42 + 0.116 * np.sin(a + 0.2))],
                           (246, 206, 80))  # fmt: skip
        prints.disc(image, 0.5, 0.42, 0.12, (250, 222, 110))
    elif name == "THE MOON":
        prints.disc(image, 0.5, 0.4, 0.16, (244, 236, 200))
        prints.disc(image, 0.6, 0.38, 0.14, color)
    elif name == "THE STAR":
        for a in np.arange(8) * np.pi / 4:
            prints.stroke(image, [(0.5, 0.4), (0.5 + 0.34 * np.cos(a), 0.4 + 0.2 * np.sin(a))],
                          0.02, (250, 236, 160))  # fmt: skip
        prints.disc(image, 0.5, 0.4, 0.05, (252, 246, 210))
    else:
        prints.disc(image, 0.5, 0.28, 0.07, (232, 192, 158))
        prints.polygon(image, [(0.28, 0.72), (0.4, 0.36), (0.6, 0.36), (0.72, 0.72)], (206, 60, 70))
    for n in range(5):
        prints.disc(image, 0.16 + 0.17 * n, 0.72 - 0.02 * (n % 2), 0.012, (250, 240, 200))
    prints.fill(image, 0.12, 0.82, 0.76, 0.1, (244, 234, 206))
    prints.write(image, name, 0.5, 0.87, 0.06, (60, 40, 40), bold=True)
    return image


def _bingo(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(150, 180, (250, 248, 242))
    prints.fill(image, 0.04, 0.03, 0.92, 0.15, color)
    for n, c in enumerate("BINGO"):
        prints.write(image[:, 6 + 28 * n : 32 + 28 * n], c, 0.5, 0.105, 0.1, readable_on(color),
                     bold=True)  # fmt: skip
        for m in range(5):
            y = 0.2 + 0.156 * m
            prints.fill(image, 0.045 + 0.186 * n, y, 0.166, 0.14, tint_color(color, 1.8))
            if (n, m) == (2, 2):
                prints.disc(image, 0.128 + 0.186 * n, y + 0.07, 0.06, color)
            else:
                prints.write(image[:, 6 + 28 * n : 32 + 28 * n], str(int(look.rng.integers(
                    1, 15)) + 15 * n), 0.5, y + 0.07, 0.07, (40, 40, 46))  # fmt: skip
    return image


def _scratch(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(130, 160, color)
    prints.write(image, look.pick(["LUCKY 7", "WIN BIG", "JACKPOT"]), 0.5, 0.14, 0.12,
                 (252, 240, 140), bold=True)  # fmt: skip
    for i in range(3):
        for j in range(3):
            tone = (176, 178, 184) if look.chance(0.75) else (250, 248, 240)
            prints.fill(image, 0.1 + 0.28 * i, 0.28 + 0.2 * j, 0.24, 0.16, tone)
            if tone[0] > 200:
                prints.write(image[:, int(13 + 36 * i) : int(44 + 36 * i)],
                             look.pick(["$5", "$1", "7"]), 0.5, 0.36 + 0.2 * j, 0.08, (200, 40, 40),
                             bold=True)  # fmt: skip
    prints.barcode(image, look.rng, 0.3, 0.9, 0.4)
    return image


def card(x: float, y: float, draw: Draw, palette: tuple[str, ...], tall: float = 0.0012
         ) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of a card lying face up, or of a deck if ``tall`` >= 3 mm."""

    def make(look: Look) -> Shape:
        k = look.between(0.98, 1.03)
        color = look.color(*palette)
        a, b = x * k, y * k
        h = tall if tall < 0.003 else tall * look.between(0.8, 1.15)
        body = block(a, b, h, 0.04 * a)
        face = block(0.995 * a, 0.995 * b, 0.0004, 0.04 * a).move(z=h - 0.0001)
        edge = surfaces.plain((238, 234, 224)) if h < 0.003 else surfaces.stripes(
            [(238, 234, 224), (206, 200, 188)], 12)  # fmt: skip
        return shape([(body, edge), (face, draw(look, color))], [box_part(a, b, h)])

    return make


@category("card_shuffler", size=(0.201, 0.118, 0.1), mass=0.5, material="device",
          aliases=("automatic card shuffler", "card shuffling machine"), themes=("living",),
          colors=("black",))  # fmt: skip
def card_shuffler(look: Look) -> Shape:
    """A card shuffler: a box with a slot for cards on each side and a tray between them."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "black", "green", "red")
    x, y, h = 0.2 * k, 0.1 * k, 0.095 * k
    body = block(0.42 * x, y, h, 0.01, 0.003)
    wings = [block(0.29 * x, 0.9 * y, 0.62 * h, 0.006, 0.002).move(x=s * 0.355 * x)
             for s in (-1, 1)]  # fmt: skip
    packs = [block(0.063, 0.086, 0.012, 0.003).turn(2, np.pi / 2).scale(0.66, 0.9, 1).move(
             x=s * 0.355 * x, z=0.62 * h) for s in (-1, 1)]  # fmt: skip
    mouth = box(0.3 * x, 0.002, 0.3 * h).move(y=-0.5 * y, z=0.12 * h)
    out = block(0.3 * x, 0.02, 0.01, 0.002).move(y=-0.58 * y, z=0.0)
    knob = cylinder(0.009, 0.006, 16).move(z=h - 0.001)
    return shape([(join([body, *wings, out]), surfaces.speckles(look.rng, tint_color(color, 0.9),
                                                                5)),
                  (join(packs), surfaces.stripes([(240, 236, 226), (206, 60, 60)], 3)),
                  (mouth, surfaces.plain((20, 20, 22))), (knob, surfaces.plain((206, 50, 50)))],
                 [hull_of(body, knob), hull_of(out),
                  *(hull_of(w, p) for w, p in zip(wings, packs, strict=True))])  # fmt: skip


_NIGHT = ("navy", "purple", "maroon", "teal")
_GAY = ("yellow", "red", "sky", "green", "purple", "orange")


CATEGORIES = (
    Category("trading_card", card(0.063, 0.088, _trading, _GAY), size=(0.0634, 0.0886, 0.0015),
             mass=0.002, material="paper", aliases=("pokemon card", "magic card",
             "collectible card", "collector's card", "top trumps card", "happy families card",
             "collectable card", "yugioh card", "card sleeve", "monster card", "holographic card"),
             themes=("living",), roles=("flat",), colors=("yellow",), state="lying flat"),
    Category("baseball_card", card(0.063, 0.088, _sport, ("red", "blue", "green", "orange")),
             size=(0.0632, 0.0883, 0.0015), mass=0.002, material="paper", aliases=("football card",
             "football sticker", "sports card", "basketball card", "panini sticker", "hockey card",
             "cigarette card"), themes=("living",), roles=("flat",), colors=("red", "blue"),
             state="lying flat"),
    Category("tarot_card", card(0.07, 0.12, _tarot, _NIGHT), size=(0.0701, 0.12, 0.0015),
             mass=0.002, material="paper",
             aliases=("oracle card", "fortune telling card", "angel card", "rune card"),
             themes=("living",), roles=("flat",), colors=("navy",), state="lying flat"),
    Category("tarot_deck", card(0.07, 0.12, _tarot, _NIGHT, 0.03), size=(0.0699, 0.12, 0.0292),
             mass=0.28, material="paper", aliases=("deck of tarot cards", "tarot cards deck",
             "oracle deck", "pack of tarot cards"), themes=("living",), colors=("navy",)),
    Category("trading_card_deck", card(0.063, 0.088, _trading, _GAY, 0.02),
             size=(0.0637, 0.089, 0.0204), mass=0.1, material="paper",
             aliases=("deck of pokemon cards", "pokemon deck", "stack of trading cards",
             "magic deck", "pack of pokemon cards", "booster pack"), themes=("living",),
             colors=("yellow",)),
    Category("bingo_card",
             vary(0.08)(card(0.14, 0.165, _bingo, ("red", "blue", "green", "purple"))),
             size=(0.139, 0.163, 0.0015), mass=0.006, material="paper",
             aliases=("bingo ticket", "bingo sheet", "lotto card"), themes=("living",),
             roles=("flat",), colors=("red", "blue"), state="lying flat"),
    Category("scratch_card", card(0.1, 0.125, _scratch, ("red", "green", "purple", "blue")),
             size=(0.101, 0.126, 0.0015), mass=0.004, material="paper",
             aliases=("scratchcard", "lottery scratch card", "scratch ticket"), themes=("living",),
             roles=("flat",), colors=("red",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
