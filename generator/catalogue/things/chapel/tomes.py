"""Holy and magic books, scrolls, and what is read with them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    cloth,
    disc,
    dye,
    hull_solid,
    metal,
    of,
    spindle,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod
from ...build.solids import join, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look

GILT: RGB = (206, 168, 84)


def _cross(image: prints.Canvas) -> None:
    prints.fill(image, 0.46, 0.22, 0.08, 0.5, GILT)
    prints.fill(image, 0.28, 0.34, 0.44, 0.06, GILT)


def _crescent(image: prints.Canvas) -> None:
    ground = tuple(float(c) for c in image[2, 2])
    prints.disc(image, 0.5, 0.48, 0.26, GILT)
    prints.disc(image, 0.5, 0.48, 0.22, ground)  # type: ignore[arg-type]
    for k in range(8):
        a = np.pi / 4 * k
        x, y = 0.5 + 0.2 * np.cos(a), 0.48 + 0.15 * np.sin(a)
        prints.polygon(image, [(x - 0.04, y), (x, y - 0.035), (x + 0.04, y), (x, y + 0.035)], GILT)
    prints.disc(image, 0.5, 0.48, 0.08, GILT)


def _pentagram(image: prints.Canvas) -> None:
    a = np.pi / 2 + np.arange(5) * 4 * np.pi / 5
    points = [(0.5 + 0.3 * np.cos(t), 0.5 - 0.22 * np.sin(t)) for t in a]
    prints.disc(image, 0.5, 0.5, 0.25, GILT, 0.235)
    prints.stroke(image, [*points, points[0]], 0.014, GILT)


def _tome(mark: object, *colors: str) -> Drawing:
    """A thick bound book lying, a golden mark on its cover."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        x, y, h = 0.13, 0.185, 0.038
        front = prints.canvas(96, 136, color)
        prints.fill(front, 0.05, 0.035, 0.9, 0.93, GILT)
        prints.fill(front, 0.065, 0.047, 0.87, 0.906, color)
        mark(front)  # type: ignore[operator]
        skin = textures.speckles(look.rng, color, 8, 64)
        edge = textures.plain(look.own_color("gold", "cream", "cream"))
        boards = [at_box(x, y, 0.0025, (0, 0, z)) for z in (0, h - 0.0025)]
        spine = at_block(0.006, y, h, 0.002, (-x / 2, 0, 0))
        leaves = at_box(x - 0.006, y - 0.006, h - 0.004, (-0.001, 0, 0.002))
        top = at_box(0.99 * x, 0.99 * y, 0.0004, (0, 0, h - 0.0002))
        ribbon = at_box(0.005, 0.03, 0.0006, (0.01, -y / 2 - 0.013, 0.012))
        return [(join([*boards, spine]), skin), (leaves, edge), (top, front),
                (ribbon, dye(look, "crimson", "gold"))]  # fmt: skip

    return draw


def _torah(look: Look) -> Pieces:
    """A scroll in an embroidered mantle, lying, its wooden rollers at both ends."""
    velvet = look.color("navy", "crimson", "cream")
    stick = wood(look, "brown", "wooden")
    coat = at_block(0.24, 0.1, 0.052, 0.03)
    front = prints.canvas(96, 64, velvet)
    prints.fill(front, 0.04, 0.05, 0.92, 0.06, GILT)
    prints.fill(front, 0.04, 0.89, 0.92, 0.06, GILT)
    for turn in (0.0, np.pi):
        a = turn + np.pi / 2 + np.arange(3) * 2 * np.pi / 3
        points = [(0.5 + 0.15 * np.cos(t), 0.5 - 0.23 * np.sin(t)) for t in a]
        prints.stroke(front, [*points, points[0]], 0.03, GILT)
    top = at_box(0.2, 0.08, 0.0008, (0, 0, 0.0516))
    rolls = [spindle((-0.17, 0.01), (-0.15, 0.012), (-0.149, 0.006), (0.149, 0.006), (0.15, 0.012),
                    (0.17, 0.01), z=0.026).move(y=y) for y in (-0.026, 0.026)]  # fmt: skip
    discs = [spindle((x, 0.022), (x + 0.006, 0.022), z=0.0265).move(y=y)
             for x in (-0.14, 0.134) for y in (-0.026, 0.026)]  # fmt: skip
    return [(coat, textures.speckles(look.rng, velvet, 9)), (top, front),
            (join(rolls), stick), (join(discs), stick)]  # fmt: skip


def _parchment(look: Look) -> Pieces:
    """A written sheet of parchment lying half unrolled between two rolls."""
    paper = look.color("beige", "cream", "tan")
    image = prints.canvas(96, 128, paper)
    prints.lines(image, look.rng, (0.12, 0.16, 0.76, 0.66), 15, (98, 74, 52), 0.3)
    prints.disc(image, 0.7, 0.9, 0.045, (150, 30, 34))
    sheet = at_box(0.15, 0.17, 0.0012)
    rolls = [spindle((-0.078, 0.009), (0.078, 0.009), z=0.009).move(y=y) for y in (-0.09, 0.09)]
    tile = textures.spots(look.rng, paper, (176, 146, 102), 0.06)
    return [(sheet, image), *((r, tile) for r in rolls)]


def _cap(look: Look) -> Pieces:
    """A skullcap lying dome up."""
    color = look.color("black", "navy", "white", "blue", "maroon")
    rim = disc(0.08, 0.009, top=0.078, sides=32)
    dome = ball(0.156, 0.156, 0.11, (0, 0, 0.003), 28)
    band = textures.stripes([color, (232, 226, 214), color], 1)
    return [(rim, band), (dome, textures.fabric(look.rng, color))]


def _case(look: Look) -> Pieces:
    """A slender case for a doorpost, a letter on its front, lying."""
    tile = metal(look, "silver", "brass", "bronze")
    body = at_block(0.1, 0.02, 0.012, 0.006)
    ends = [ball(0.016, 0.018, 0.011, (x, 0, 0.006), 12) for x in (-0.052, 0.052)]
    mark = [at_box(0.012, 0.002, 0.0012, (0, y, 0.0117)) for y in (-0.005, 0, 0.005)]
    foot = at_box(0.002, 0.012, 0.0012, (0.006, 0, 0.0117))
    return [(join([body, *ends]), tile), (join([*mark, foot]), dye(look, "gold"))]


def _pointer(look: Look) -> Pieces:
    """A silver pointer ending in a small hand, a chain at its head."""
    tile = metal(look, "silver", "silver", "gold")
    body = spindle((-0.09, 0.004), (-0.085, 0.008), (-0.078, 0.004), (-0.05, 0.0045), (-0.045,
             0.007),
                  (-0.04, 0.0045), (0.02, 0.0035), (0.024, 0.0055), (0.028, 0.0035),
                  (0.068, 0.0028), z=0.008)  # fmt: skip
    hand = at_block(0.014, 0.008, 0.004, 0.002, (0.074, 0, 0.006))
    finger = at_block(0.014, 0.0025, 0.003, 0.001, (0.087, 0.002, 0.0065))
    a = np.linspace(0, 2 * np.pi, 24)[:-1]
    chain = tube(np.column_stack([-0.1 - 0.014 * np.cos(a), 0.012 * np.sin(a), 0 * a + 0.0016]),
                 0.0014, 5, loop=True)  # fmt: skip
    return [(join([body, hand, finger]), tile), (chain, tile)]


def _phylactery(look: Look) -> Pieces:
    """A black leather cube on a base, its strap coiled beside it."""
    black = textures.speckles(look.rng, look.color("black", "charcoal"), 6)
    base, top = at_box(0.045, 0.06, 0.008), at_box(0.032, 0.032, 0.03, (0, 0.006, 0.008))
    path = [(0.02, -0.02, 0.004), (0.05, -0.035, 0.004), (0.07, 0, 0.004), (0.05, 0.03, 0.004),
            (0.034, 0.01, 0.004), (0.05, -0.012, 0.004), (0.058, 0.005, 0.004)]  # fmt: skip
    return [(base, black), (top, black), (tube(smooth(path, 6), 0.004, 6, squash=0.4), black)]


def _matzo(look: Look) -> Pieces:
    color = look.color("cream", "beige")
    image = textures.spots(look.rng, color, (150, 104, 60), 0.06).copy()
    for k in range(1, 10):
        for n in range(14):
            prints.disc(image, (n + 0.5) / 14, k / 10, 0.008, (150, 110, 70))
    return [(at_box(0.17, 0.17, 0.004), image)]


def _rest(look: Look) -> Pieces:
    """A folding book stand: two crossed boards with pierced ends."""
    tile = wood(look, "brown", "wooden", "tan")
    one = at_box(0.19, 0.008, 0.2, (0, 0, -0.06))
    pair = [one.turn(0, a) for a in (0.6, -0.6)]
    low = min(float(p.bounds[0, 2]) for p in pair)
    return [(p.move(z=-low), tile) for p in pair]


def _flags(look: Look) -> Pieces:
    """Five small flags on a cord, lying in a row."""
    cord = rod([(-0.2, 0.05, 0.002), (0, 0.062, 0.002), (0.2, 0.05, 0.002)], 0.0014, 6, 8)
    pieces: Pieces = [(cord, textures.plain((236, 230, 214)))]
    for k, word in enumerate(("blue", "white", "red", "green", "yellow")):
        color = look.own_color(word)
        image = prints.canvas(48, 48, color)
        prints.lines(image, look.rng, (0.15, 0.15, 0.7, 0.7), 7, (60, 56, 60), 0.3)
        pieces.append((at_box(0.068, 0.08, 0.0012, (-0.152 + 0.076 * k, 0.012, 0.0002)), image))
    return pieces


def _palm(look: Look) -> Pieces:
    color = look.color("sage", "olive", "mustard")
    tile = textures.scratches(look.rng, color, tuple(0.8 * c for c in color))  # type: ignore[arg-type]
    return [(at_box(0.012, 0.13, 0.003), tile), (at_box(0.075, 0.012, 0.003, (0, 0.025, 0.002)),
             tile), (hull_solid([(x, y, z) for x in (-0.009, 0.009) for y in (0.019, 0.037)
                              for z in (0, 0.0065)]), tile)]  # fmt: skip


def _shawl(look: Look) -> Pieces:
    color = look.color("white", "ivory", "cream")
    stripe = textures.stripes([color, color, (40, 52, 104), color, (40, 52, 104), color, color], 2,
                              upright=True)  # fmt: skip
    body = [at_block(0.24 - 0.006 * k, 0.17, 0.011, 0.012, (0, 0, 0.01 * k)) for k in range(3)]
    knots = [at_box(0.003, 0.035, 0.002, (x, -0.1, 0.0)) for x in (-0.11, -0.104, 0.104, 0.11)]
    return [(join(body), stripe), (join(knots), cloth(look, "white", "ivory"))]


CATEGORIES = (
    Category("bible", of(_tome(_cross, "black", "maroon", "brown", "navy"), bodies=2),
             (0.138, 0.221, 0.0397), 0.6, ("holy bible", "missal", "prayer book",
             "holy book", "psalter", "new testament"), ("living",), ("flat", "support"),
             ("black",), state="lying flat"),
    Category("quran", of(_tome(_crescent, "green", "teal", "navy", "maroon"), bodies=2),
             (0.134, 0.215, 0.0386), 0.6, ("koran",), ("living",), ("flat", "support"), ("green",),
             state="lying flat"),
    Category("grimoire", of(_tome(_pentagram, "maroon", "purple", "black", "brown"), bodies=2),
             (0.136, 0.219, 0.0392), 0.7, ("spell book", "spellbook", "magic book",
             "book of spells", "old tome", "tome", "wizard book"), ("living",),
             ("flat", "support"), ("maroon",), state="lying flat"),
    Category("torah_scroll", of(_torah), (0.34, 0.1, 0.0525), 1.2, ("torah", "torah roll",
             "sefer torah"), ("living",), ("big",), ("navy",), state="lying"),
    Category("parchment", of(_parchment, 0.05), (0.156, 0.2, 0.018), 0.02, ("unrolled scroll",
             "open scroll", "old document", "parchment sheet", "sheet of parchment", "royal decree",
             "ancient manuscript", "manuscript", "declaration"), ("office",), ("flat",),
             ("beige",), state="lying flat"),
    Category("kippah", of(_cap, bodies=2), (0.16, 0.16, 0.058), 0.03, ("yarmulke", "skullcap",
             "kippa"), ("living",), (), ("black", "navy")),
    Category("mezuzah", of(_case, 0.05), (0.12, 0.02, 0.0125), 0.06, ("mezuzah case",),
             ("living",), ("flat",), ("silver",), state="lying"),
    Category("yad", of(_pointer, 0.1), (0.213, 0.0267, 0.0163), 0.06, ("torah pointer",),
             ("living",), (), ("silver",), state="lying"),
    Category("tefillin", of(_phylactery), (0.097, 0.069, 0.038), 0.08, ("phylactery",),
             ("living",), (), ("black",)),
    Category("matzo", of(_matzo), (0.17, 0.17, 0.004), 0.03, ("matzah", "matza", "sheet of matzo",
             "knackebrod"), ("kitchen",), ("flat", "edible"), ("cream",)),
    Category("book_rest", of(_rest), (0.191, 0.165, 0.17), 0.4, ("quran stand", "rehal",
             "koran stand", "book stand with crossed boards", "folding book stand"), ("living",),
             (), ("brown",)),
    vary(Category("prayer_flags", of(_flags), (0.396, 0.0904, 0.00298), 0.02, ("prayer flag",
             "string of prayer flags", "tibetan flags",
             "pennant garland"), ("living",), ("flat", "big"), ("blue",),
             state="lying"), 0.2),
    Category("palm_cross", of(_palm), (0.075, 0.13, 0.0065), 0.004, ("cross of palm leaf",),
             ("living",), ("flat",), ("sage",), state="lying"),
    vary(Category("prayer_shawl", of(_shawl), (0.24, 0.205, 0.031), 0.3, ("tallit", "tallis",
             "folded tallit"), ("living",), (), ("white",))),
)  # fmt: skip
"""The module's categories."""
