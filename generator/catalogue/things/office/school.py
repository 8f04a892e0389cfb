"""School and office things: drawing tools, cards, boards, chalk, thick books, pins."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import lay_down
from ...build.outlines import arc, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def protractor(look: Look) -> Shape:
    """A half-round protractor with a scale, lying."""
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


def set_square(look: Look) -> Shape:
    """A drawing triangle with a scale and a cut-out, lying."""
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


def drawing_compass(look: Look) -> Shape:
    """A pair of compasses lying: two legs joined at a knob."""
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
    return shape([(join([*legs, hub]), metal), (join([knob, lead]), textures.plain((40, 40, 44))),
                  (join([needle, bow]), textures.plain((214, 216, 220)))],
                 [*(hull_of(s) for s in legs), hull_of(hub), hull_of(knob),
                     hull_of(lead)])  # fmt: skip


def abacus(look: Look) -> Shape:
    """A standing frame with rows of coloured beads."""
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
        pieces.append((join(beads), textures.plain(tone)))
    pieces.append((join(rods), textures.plain((190, 192, 196))))
    return shape(pieces, [*(hull_of(s) for s in (*frame, *feet)),
                          box_part(x - 2 * t, 0.024 * k, 0.15 * k, (0, 0, 0.032 * k))])  # fmt: skip


def _thick_book(titles: tuple[str, ...], size: tuple[float, float, float]) -> Callable[..., Shape]:
    """A thick hardcover lying, a title across its cover."""

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
        return shape([(pages, prints.pages(look.rng)), (join([*covers, spine]), textures.speckles(
                      look.rng, color, 3, 32)), (turned, back),
                      (box(0.99 * x, 0.99 * y, 0.0005).move(z=h - 0.0002), front)],
                     [box_part(x, y, h)])  # fmt: skip

    return make


def rubber_band(look: Look) -> Shape:
    """A rubber band lying in a loose loop."""
    k = look.between(0.9, 1.25)
    color = look.color("tan", "red", "blue", "green", "yellow", "tan", "pink")
    a = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    r = 0.022 * k * (1 + 0.14 * np.cos(2 * a + look.between(0, 6)) + 0.06 * np.cos(3 * a))
    h = 0.0028
    way = np.column_stack([1.25 * r * np.cos(a), 0.85 * r * np.sin(a)])
    rings = []
    for x, y in way:
        n = np.array([x, y]) / np.hypot(x, y)
        rings.append([(*(np.array([x, y]) + n * s), z) for s, z in (
            (-0.0006, 0), (0.0006, 0), (0.0006, h), (-0.0006, h))])  # fmt: skip
    band = loft(np.array(rings), np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * 1.0,
                profile=np.column_stack([a, 0 * a]), loop=True)  # fmt: skip
    hulls = []
    for m in range(8):
        index = np.arange(5 * m, 5 * m + 6) % 40
        hulls.append(hull_of(Solid(np.array(rings)[index].reshape(-1, 3), np.zeros((0, 3), int),
                                   np.zeros((24, 2)))))  # fmt: skip
    return shape([(band, textures.plain(color))], hulls)


def gavel(look: Look) -> Shape:
    """A judge's gavel lying across its sound block."""
    k = look.between(0.9, 1.06)
    color = look.color("brown", "wooden", "maroon", "brown", "black")
    wood = look.surface(color, "wood")
    plate = cylinder(0.048 * k, 0.02 * k, 32, bevel=0.004)
    head = lathe(np.array([(0, 0), (0.02, 0), (0.0225, 0.004), (0.0215, 0.014), (0.018, 0.018),
                           (0.02, 0.045), (0.018, 0.072), (0.0215, 0.076), (0.0225, 0.086),
                           (0.02, 0.09), (0, 0.09)]) * k, 24)  # fmt: skip
    head = head.turn(0, np.pi / 2).move(y=0.045 * k, z=0.0425 * k)
    grip = lathe(np.array([(0, 0), (0.0065, 0), (0.006, 0.05), (0.0085, 0.13), (0.0105, 0.17),
                           (0.007, 0.19), (0, 0.192)]) * k, 16)  # fmt: skip
    lean = np.arctan2(0.027, 0.17)
    grip = grip.turn(1, np.pi / 2 + lean).move(z=0.0425 * k)
    brass = torus(0.0206 * k, 0.0016 * k, 24, 6).turn(0, np.pi / 2).move(z=0.0425 * k)
    return shape([(join([plate, head, grip]), wood), (brass, textures.plain((206, 170, 90)))],
                 [hull_of(plate), hull_of(head), hull_of(grip)])  # fmt: skip


CATEGORIES = (
    Category("protractor", protractor, (0.112, 0.0645, 0.0018), 0.012, ("half circle protractor",
             "angle measure"), ("school",), ("flat",), ("clear", "yellow")),
    Category("set_square", set_square, (0.162, 0.13, 0.002), 0.02, ("drawing triangle",
             "triangle ruler", "geometry triangle", "setsquare", "triangular ruler"), ("school",),
             ("flat",), ("clear", "sky")),
    Category("drawing_compass", drawing_compass, (0.148, 0.064, 0.0106), 0.03,
             ("pair of compasses", "geometry compass", "compasses", "school compass",
              "circle compass", "math compass", "dividers", "compass for drawing"), ("school",), (),
              ("silver",)),
    Category("abacus", abacus, (0.213, 0.087, 0.194), 0.45, ("counting frame", "bead frame",
             "row counter"),
             ("school",), ("tall", "big"), ("wooden",)),
    Category("dictionary", _thick_book(("DICTIONARY", "LEXICON", "THESAURUS"),
             (0.155, 0.22, 0.055)), (0.155, 0.22, 0.055), 1.2, ("thesaurus", "encyclopedia",
             "lexicon", "encyclopaedia"), ("school",), ("support", "flat"), ("navy", "red")),
    Category("textbook", _thick_book(("PHYSICS", "MATHS", "BIOLOGY", "HISTORY", "CHEMISTRY"),
             (0.2, 0.26, 0.03)), (0.2, 0.26, 0.03), 1.0, ("school book", "schoolbook",
             "math book", "course book", "text book"), ("school",), ("support", "flat", "big"),
             ("blue", "green")),
    Category("atlas", _thick_book(("ATLAS", "WORLD ATLAS"), (0.24, 0.3, 0.022)),
             (0.24, 0.3, 0.022), 1.1, ("world atlas", "book of maps"), ("school",),
             ("support", "flat", "big"), ("navy",)),
    Category("cookbook", _thick_book(("COOKBOOK", "RECIPES", "BAKING"), (0.19, 0.24, 0.024)),
             (0.19, 0.24, 0.024), 0.8, ("cookery book", "cook book", "baking book"),
             ("kitchen",), ("support", "flat"), ("orange", "teal")),
    Category("rubber_band", rubber_band, (0.058, 0.0405, 0.0028), 0.001, ("elastic band",
             "elastic", "hair band", "elastic band roll", "loom bands"), ("office",), ("flat",),
             ("tan", "red")),
    Category("gavel", gavel, (0.235, 0.095, 0.065), 0.3, ("judge gavel", "judge hammer",
             "auction hammer", "judge's gavel"), ("office",), (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
