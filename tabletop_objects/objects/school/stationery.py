"""Objects of the ``school`` theme: stationery."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import lay_down
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, prism, tube
from ...kit.surfaces import RGB, Look, tint_color
from ..craft.art_supplies import stick


@category("protractor", size=(0.112, 0.0645, 0.0018), mass=0.012, material="plastic",
          aliases=("half circle protractor", "angle measure"), themes=("school",), roles=("flat",),
          colors=("clear", "yellow"))  # fmt: skip
def protractor(look: Look) -> Shape:
    """A semicircular protractor with a scale, lying flat."""
    k = look.between(0.88, 1.15)
    color = look.color("clear", "sky", "yellow", "clear", "pink", "orange", "mint")
    r = 0.055 * k
    image = prints.canvas(192, 104, color)
    for n in range(37):
        a = np.pi * n / 36
        long = 0.12 if n % 6 == 0 else 0.08 if n % 2 == 0 else 0.05
        c, s = np.cos(a), np.sin(a)
        ends = [(0.5 + 0.49 * f * c, 0.92 - 0.9 * f * s) for f in (0.98, 0.98 - long)]
        prints.stroke(image, ends, 0.012, (30, 34, 44))
        if n % 6 == 0:
            x, y = round(96 + 70 * c), round(96 - 68 * s)
            cell = image[max(y - 7, 0) : y + 7, max(x - 12, 0) : x + 12]
            prints.write(cell, str(180 - 5 * n), 0.5, 0.5, 0.75, (30, 34, 44))
    prints.fill(image, 0, 0.93, 1, 0.012, (30, 34, 44))
    prints.polygon(image, [(0.5 + 0.22 * np.cos(t), 0.92 - 0.4 * np.sin(t)) for t in
                           np.linspace(0, np.pi, 16)], tint_color(color, 0.82))  # fmt: skip
    outline = np.concatenate([[(-r, -0.008 * k), (r, -0.008 * k)], arc((0, 0), r, 0, np.pi, 24)])
    body = prism(outline, 0, 0.0018)
    return shape([(body, image)], [hull_of(body)], opacity=0.9)


@category("set_square", size=(0.162, 0.13, 0.002), mass=0.02, material="plastic",
          aliases=("drawing triangle", "triangle ruler", "geometry triangle", "setsquare",
          "triangular ruler"), themes=("school",), roles=("flat",),
          colors=("clear", "sky"))  # fmt: skip
def set_square(look: Look) -> Shape:
    """A set square with a scale and a cut-out, lying flat."""
    k = look.between(0.88, 1.15)
    color = look.color("clear", "sky", "green", "orange", "clear", "yellow", "pink")
    x, y = 0.16 * k, look.pick([0.16, 0.0925]) * k
    h = 0.002
    image = prints.canvas(160, 160, color)
    for n in range(33):
        prints.fill(image, 0.02 + 0.029 * n, 0.95 if n % 2 else 0.92, 0.006, 0.08, (30, 34, 44))
        prints.fill(image, 0.0, 0.02 + 0.029 * n, 0.04 if n % 2 else 0.07, 0.006, (30, 34, 44))
    outer = np.array([(0, 0), (x, 0), (0, y)])
    middle = np.array([0.27 * x, 0.27 * y])
    inner = middle + (outer - middle) * 0.42
    bars = [prism(np.array([outer[n], outer[(n + 1) % 3], inner[(n + 1) % 3], inner[n]]), 0, h)
            for n in range(3)]  # fmt: skip
    span = np.array([x, y])
    shown = [Solid(b.vertices, b.faces, np.clip(b.vertices[:, :2] / span, 0, 1)) for b in bars]
    return shape([(b, image) for b in shown], [hull_of(b) for b in bars], opacity=0.9)


@category("drawing_compass", size=(0.148, 0.064, 0.0106), mass=0.03, material="metal",
          assembled=True, aliases=("pair of compasses", "geometry compass", "compasses",
          "school compass", "circle compass", "math compass", "dividers", "compass for drawing"),
          themes=("school",), colors=("silver",))  # fmt: skip
def drawing_compass(look: Look) -> Shape:
    """A pair of compasses lying flat: two legs joined at a knob."""
    k = look.between(0.9, 1.1)
    metal = look.surface(look.color("silver", "silver", "gold", "black", "blue"), "metal")
    spread, z = look.between(0.18, 0.34), 0.0042 * k
    legs = []
    for s in (-1, 1):
        way = [(0, 0, z), (0.115 * k * np.cos(s * spread), 0.115 * k * np.sin(s * spread), z)]
        legs.append(tube(way, np.array([0.0042, 0.003]) * k, 6))
    needle = tube([[0.112 * k * np.cos(spread), -0.112 * k *
                   np.sin(spread), z], [0.132 * k * np.cos(spread), -0.132 * k * np.sin(spread),
                                        z]], np.array([0.001, 0.0003]) * k, 6)  # fmt: skip
    lead = tube([[0.105 * k * np.cos(spread), 0.105 * k * np.sin(spread), z],
                 [0.13 * k * np.cos(spread), 0.13 * k * np.sin(spread), z]], 0.0032 * k,
                     8)  # fmt: skip
    hub = cylinder(0.0095 * k, 2 * z, 20)
    knob = lay_down(cylinder(0.0036 * k, 0.018 * k, 12), -0.024 * k, z)
    bow = tube(smooth([(0.05 * k, -0.05 * k * np.tan(spread), 2 * z), (0.05 * k, 0, 2.5 * z),
                       (0.05 * k, 0.05 * k * np.tan(spread), 2 * z)], 3), 0.0012 * k,
                           6)  # fmt: skip
    return shape([(join([*legs, hub]), metal), (join([knob, lead]), surfaces.plain((40, 40, 44))),
                  (join([needle, bow]), surfaces.plain((214, 216, 220)))],
                 [*(hull_of(s) for s in legs), hull_of(hub), hull_of(knob),
                     hull_of(lead)])  # fmt: skip


@category("abacus", size=(0.213, 0.087, 0.194), mass=0.45, material="wood", assembled=True,
          aliases=("counting frame", "bead frame", "row counter"), themes=("school",),
          roles=("tall", "big"), colors=("wooden",))  # fmt: skip
def abacus(look: Look) -> Shape:
    """An abacus: an upright frame with rows of coloured beads."""
    k = look.between(0.88, 1.06)
    wood = look.surface(look.color("wooden", "tan", "red", "wooden", "blue"), "wood")
    x, h, t = 0.22 * k, 0.2 * k, 0.012 * k
    frame = [box(t, 0.018 * k, h).move(x=s * (x - t) / 2) for s in (-1, 1)]
    frame += [box(x, 0.018 * k, t).move(z=z) for z in (0.012 * k, h - t)]
    feet = [block(t * 1.4, 0.09 * k, 0.014 * k, 0.004).move(x=s * (x - t) / 2) for s in (-1, 1)]
    pieces = [(join([*frame, *feet]), wood)]
    tones: tuple[RGB, ...] = ((200, 46, 44), (240, 200, 60), (60, 150, 80), (48, 98, 180),
                              (238, 132, 38))  # fmt: skip
    rods = []
    for n, tone in enumerate(tones):
        z = (0.044 + 0.031 * n) * k
        rods.append(tube([(-x / 2 + t / 2, 0, z), (x / 2 - t / 2, 0, z)], 0.0022 * k, 6))
        left = int(look.rng.integers(2, 9))
        beads = []
        for m in range(9):
            u = -x / 2 + t + (0.009 + 0.0158 * m) * k + (0.0 if m < left else 0.046 * k)
            beads.append(
                lay_down(cylinder(0.0125 * k, 0.0145 * k, 10, bevel=0.003 * k), u - 0.007 * k, z)
            )
        pieces.append((join(beads), surfaces.plain(tone)))
    pieces.append((join(rods), surfaces.plain((190, 192, 196))))
    return shape(pieces, [*(hull_of(s) for s in (*frame, *feet)),
                          box_part(x - 2 * t, 0.024 * k, 0.15 * k, (0, 0, 0.032 * k))])  # fmt: skip


def thick_book(titles: tuple[str, ...], size: tuple[float, float, float]) -> Callable[..., Shape]:
    """Return the shape function of a thick hardcover book with a title on its cover, lying flat."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        x, y, h = (v * k for v in size)
        color = look.color("navy", "red", "green", "maroon", "blue", "black", "teal", "orange")
        front = prints.canvas(128, 176, color)
        word = look.pick(titles)
        gold = look.own_color("gold", "cream", "white")
        prints.fill(front, 0.07, 0.05, 0.86, 0.9, gold)
        prints.fill(front, 0.085, 0.06, 0.83, 0.88, color)
        if titles[0] == "ATLAS":
            prints.disc(front, 0.5, 0.6, 0.25, (60, 120, 190))
            for a, b, r in ((0.4, 0.52, 0.08), (0.58, 0.62, 0.09), (0.48, 0.73, 0.06)):
                prints.disc(front, a, b, r, (90, 160, 90))
        elif titles[0] == "DICTIONARY":
            prints.write(front, "A-Z", 0.5, 0.62, 0.22, gold, bold=True)
        elif titles[0] == "COOKBOOK":
            prints.disc(front, 0.5, 0.62, 0.23, (244, 242, 236))
            prints.disc(front, 0.5, 0.62, 0.15, (214, 90, 60))
            prints.disc(front, 0.45, 0.6, 0.05, (110, 170, 80))
        else:
            for n in range(3):
                prints.fill(front, 0.2 + 0.06 * n, 0.5 + 0.12 * n, 0.5 - 0.04 * n, 0.06,
                            tint_color(color, 1.4))  # fmt: skip
        prints.write(front, word, 0.5, 0.22, 0.11, gold, bold=True)
        pages = box(0.95 * x, 0.97 * y, h - 0.005).move(x=0.01 * x, z=0.0025)
        covers = [box(x, y, 0.0027).move(z=z) for z in (0, h - 0.0027)]
        spine = box(0.0035, y, h).move(x=-x / 2 + 0.0017)
        back = prints.canvas(160, 40, color)
        prints.write(back, word, 0.5, 0.5, 0.5, gold, bold=True)
        turned = box(y, 0.0008, 0.94 * h).turn(2, -np.pi / 2).move(x=-x / 2, z=0.03 * h)
        return shape([(pages, prints.pages(look.rng)), (join([*covers, spine]), surfaces.speckles(
                      look.rng, color, 3, 32)), (turned, back),
                      (box(0.99 * x, 0.99 * y, 0.0005).move(z=h - 0.0002), front)],
                     [box_part(x, y, h)])  # fmt: skip

    return make


CATEGORIES = (
    Category("chalk", stick(0.0055, 0.075, ("white", "white", "pink", "yellow", "sky"), False),
             size=(0.07, 0.0108, 0.0108), mass=0.01, material="wax", friction=0.6,
             aliases=("piece of chalk", "chalk stick", "stick of chalk", "blackboard chalk",
             "tailor's chalk"), themes=("school",), colors=("white",), state="lying flat"),
    Category("dictionary", thick_book(("DICTIONARY", "LEXICON", "THESAURUS"), (0.155, 0.22, 0.055)),
             size=(0.155, 0.22, 0.055), mass=1.2, material="paper",
             aliases=("thesaurus", "encyclopedia", "lexicon", "encyclopaedia"), themes=("school",),
             roles=("support", "flat"), colors=("navy", "red")),
    Category("textbook",
             thick_book(("PHYSICS", "MATHS", "BIOLOGY", "HISTORY", "CHEMISTRY"), (0.2, 0.26, 0.03)),
             size=(0.2, 0.26, 0.03), mass=1.0, material="paper",
             aliases=("school book", "schoolbook", "math book", "course book", "text book"),
             themes=("school",), roles=("support", "flat", "big"), colors=("blue", "green")),
    Category("atlas", thick_book(("ATLAS", "WORLD ATLAS"), (0.24, 0.3, 0.022)),
             size=(0.24, 0.3, 0.022), mass=1.1, material="paper",
             aliases=("world atlas", "book of maps"), themes=("school",),
             roles=("support", "flat", "big"), colors=("navy",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
