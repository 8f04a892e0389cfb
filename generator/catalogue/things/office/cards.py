"""Cards, boards, chalk and pins."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, hull_of
from ...build.forms import lay_down
from ...build.outlines import arc
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

STEEL: RGB = (186, 189, 194)
Draw = Callable[[Look, RGB], textures.Tile]


def _card(
    x: float, y: float, h: float, draw: Draw, palette: tuple[str, ...], count: int = 1
) -> Callable[[Look], Shape]:
    """A flat card lying, or a small pile of them; ``draw`` prints its face."""

    def make(look: Look) -> Shape:
        k = look.between(0.98, 1.03)
        color = look.color(*palette)
        a, b = x * k, y * k
        tall = h * (count if count == 1 else int(look.rng.integers(count // 2, count)))
        body = block(a, b, tall, 0.03 * a)
        edge = textures.plain(tint_color(color, 0.9)) if count == 1 else textures.stripes(
            [color, tint_color(color, 0.82)], 12)  # fmt: skip
        face = block(0.995 * a, 0.995 * b, 0.0004, 0.03 * a).move(z=tall - 0.0002)
        return shape([(body, edge), (face, draw(look, color))], [box_part(a, b, tall)])

    return make


def _bank(look: Look, color: RGB) -> textures.Tile:
    image = textures.fit(textures.gradient(tint_color(color, 0.75), tint_color(color, 1.2),
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


def _identity(look: Look, color: RGB) -> textures.Tile:
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


def _business(look: Look, color: RGB) -> textures.Tile:
    image = prints.canvas(160, 92, color)
    ink, accent = readable_on(color), look.own_color("red", "teal", "gold", "blue", "orange")
    prints.disc(image, 0.17, 0.36, 0.15, accent)
    prints.write(image[:, 56:], look.pick(["JANE DOE", "A. MEYER", "STUDIO X", "T. CHEN"]), 0.45,
        0.28,
                 0.17, ink, bold=True)  # fmt: skip
    prints.lines(image, look.rng, (0.42, 0.48, 0.48, 0.36), 4, ink, 0.25)
    return image


def _rule_lines(look: Look, color: RGB) -> textures.Tile:
    image = prints.canvas(160, 96, color)
    for n in range(8):
        prints.fill(image, 0, 0.2 + 0.1 * n, 1, 0.012, (150, 180, 220) if n else (220, 100, 100))
    if look.chance(0.6):
        prints.lines(image, look.rng, (0.08, 0.26, 0.7, 0.4), 4, (60, 66, 100), 0.35)
    return image


def _postcard(look: Look, color: RGB) -> textures.Tile:
    image = prints.canvas(176, 120, color)
    image[7:-7, 7:-7] = textures.fit(prints.landscape(look.rng, 162, 106), 106, 162)
    word = look.pick(["GREETINGS", "HELLO", "PARIS", "ALPS", "BEACH"])
    prints.write(image, word, 0.5, 0.24, 0.2, (250, 250, 246), bold=True)
    return image


def greeting_card(look: Look) -> Shape:
    """A folded greeting card standing like a tent, its picture to the front."""
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
    return shape([(front, image), (rear, textures.plain(tint_color(color, 1.1)))],
                 [hull_of(front), hull_of(rear)])  # fmt: skip


def whiteboard(look: Look) -> Shape:
    """A small whiteboard on feet, something drawn on it."""
    k = look.between(0.88, 1.06)
    color = look.color("silver", "wooden", "black", "blue", "white", "red")
    x, h = 0.32 * k, 0.23 * k
    image = prints.canvas(192, 136, (250, 250, 249))
    inks = [(40, 70, 170), (200, 50, 50), (40, 130, 70)]
    kind = int(look.rng.integers(3))
    if kind == 0:
        prints.stroke(image, [(0.1, 0.85), (0.1, 0.2)], 0.02, inks[0])
        prints.stroke(image, [(0.1, 0.85), (0.9, 0.85)], 0.02, inks[0])
        t = np.linspace(0, 1, 20)
        curve = zip(0.12 + 0.74 * t, 0.8 - 0.5 * t**2 - 0.06 * np.sin(9 * t), strict=True)
        prints.stroke(image, list(curve), 0.025, inks[1])
    elif kind == 1:
        prints.write(image, look.pick(["TO DO", "IDEAS", "MONDAY", "a2+b2=c2", "E = mc2"]), 0.5,
            0.2,
                     0.18, inks[0], bold=True)  # fmt: skip
        for n in range(4):
            prints.disc(image, 0.14, 0.42 + 0.14 * n, 0.02, inks[1])
            prints.fill(image, 0.2, 0.41 + 0.14 * n, look.between(0.3, 0.66), 0.025, (60, 64, 80))
    else:
        for n, (u, v) in enumerate(((0.22, 0.3), (0.75, 0.28), (0.5, 0.75))):
            prints.disc(image, u, v, 0.16, inks[n], 0.135)
        prints.stroke(image, [(0.36, 0.3), (0.62, 0.3)], 0.02, (60, 60, 66))
        prints.stroke(image, [(0.28, 0.45), (0.42, 0.62)], 0.02, (60, 60, 66))
    lift, t = 0.02 * k, 0.01
    frame = box(x, t, h).move(z=lift)
    face = box(0.95 * x, 0.0012, 0.93 * h).move(y=-t / 2, z=lift + 0.035 * h)
    feet = [block(0.02 * k, 0.13 * k, lift + 0.006, 0.004).move(x=s * 0.36 * x) for s in (-1, 1)]
    return shape([(frame, look.surface(color, "plastic")), (face, image),
                  (join(feet), textures.plain(tint_color(color, 0.6)))],
                 [hull_of(frame), *(hull_of(s) for s in feet)])  # fmt: skip


def board_eraser(look: Look) -> Shape:
    """An eraser for a board: a grip over a felt pad."""
    k = look.between(0.9, 1.1)
    color = look.color("blue", "wooden", "black", "red", "green", "yellow")
    x, y = 0.125 * k, 0.05 * k
    felt = block(x, y, 0.016 * k, 0.005)
    grip = block(0.98 * x, 0.96 * y, 0.016 * k, 0.008, 0.004).move(z=0.0155 * k)
    return shape([(felt, textures.fabric(look.rng, look.own_color("charcoal", "gray", "navy"))),
                  (grip, look.surface(color, "plastic"))],
                 [hull_of(felt), hull_of(grip)])  # fmt: skip


def _stick(radius: float, long: float, palette: tuple[str, ...], square: bool) -> Callable:
    """A stick of chalk, pastel or charcoal lying."""

    def make(look: Look) -> Shape:
        k = look.between(0.85, 1.1)
        color = look.color(*palette)
        r, n = radius * k, long * k * look.between(0.8, 1.1)
        dust = textures.spots(look.rng, color, tint_color(color, 1.2 if sum(color) < 600 else 0.9),
                              0.15)  # fmt: skip
        if square:
            body = box(n, 1.8 * r, 1.8 * r)
            return shape([(body, dust)], [hull_of(body)])
        body = lay_down(cylinder(r, n, 20, top=0.88 * r), -n / 2, r)
        body = body.move(z=-float(body.bounds[0, 2]))
        return shape([(body, dust)], [flat_foot(body.vertices, 0.12)])

    return make


def highlighter(look: Look) -> Shape:
    """A flat highlighter lying, its cap in a bright colour."""
    k = look.between(0.92, 1.06)
    color = look.color("yellow", "lime", "pink", "orange", "cyan", "yellow")
    x, y, h = 0.118 * k, 0.026 * k, 0.014 * k
    bright = textures.speckles(look.rng, color, 3, 32)
    body = block(0.62 * x, y, h, 0.006, 0.003).move(x=-0.19 * x)
    cap = block(0.4 * x, 0.92 * y, 0.92 * h, 0.006, 0.003).move(x=0.3 * x, z=0.0)
    clip = box(0.3 * x, 0.008 * k, 0.003).move(x=0.24 * x, z=0.9 * h)
    dark = textures.plain((44, 44, 48))
    band = prints.canvas(96, 32, tint_color(color, 0.8))
    prints.write(band, look.pick(["MARK", "LUMI", "TEXT"]), 0.5, 0.5, 0.5, (30, 30, 34), bold=True)
    sign = box(0.45 * x, 0.6 * y, 0.0006).move(x=-0.2 * x, z=h - 0.0003)
    return shape([(body, bright), (cap, dark if look.chance(0.4) else bright), (clip, dark),
                  (sign, band)], [hull_of(body), hull_of(cap)])  # fmt: skip


def push_pin(look: Look) -> Shape:
    """A push pin lying on its side, larger than life."""
    k = look.between(1.0, 1.3)
    color = look.color("red", "blue", "yellow", "green", "white", "orange", "clear")
    head = lathe(np.array([(0, 0), (0.0055, 0), (0.0055, 0.0018), (0.0032, 0.004), (0.0036, 0.0105),
                           (0.005, 0.012), (0.005, 0.0135), (0, 0.0138)]) * k, 18)  # fmt: skip
    needle = lathe(np.array([(0, -0.011), (0.0006, -0.009), (0.0006, 0.0), (0, 0.0)]) * k, 8)
    lean = np.arctan2(0.0005, 0.0118)
    solids = [s.turn(1, np.pi / 2 - lean) for s in (head, needle)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    head, needle = (s.move(z=-low) for s in solids)
    return shape([(head, textures.speckles(look.rng, color, 3, 32)),
        (needle, textures.plain(STEEL))],
                 [flat_foot(head.vertices, 0.1), hull_of(needle)])  # fmt: skip


def paper_clip(look: Look) -> Shape:
    """One paper clip lying."""
    k = look.between(1.0, 1.5)
    color = look.color("silver", "silver", "red", "blue", "green", "yellow", "gold", "pink")
    r = 0.0007 * k
    way = [(-0.008, 0.0036), (0.01, 0.0036), *map(tuple, arc((0.0115, 0), 0.0036, np.pi / 2, -np.pi
           / 2, 6)), (-0.012, -0.0036), *map(tuple, arc((-0.013, -0.0006), 0.003, -np.pi / 2, -1.5 *
           np.pi, 6)), (0.007, 0.0024), *map(tuple, arc((0.0075, 0.0), 0.0024, np.pi / 2,
               -np.pi / 2,
                                                        5)), (-0.006, -0.0022)]  # fmt: skip
    path = np.array([(x, y, 0) for x, y in way]) * k + [0, 0, r]
    return shape([(tube(path, r, 6), textures.plain(color))],
                 [box_part(0.031 * k, 0.0082 * k, 1.7 * r,
                     (-0.0005 * k, 0, 0.15 * r))])  # fmt: skip


CATEGORIES = (
    Category("credit_card", _card(0.0856, 0.054, 0.0011, _bank, ("navy", "black", "red", "teal",
             "gold", "gray")), (0.0856, 0.054, 0.0012), 0.005, ("bank card", "debit card",
             "payment card", "gift card", "atm card", "loyalty card", "phone card", "punch card",
             "store card", "travel card", "metro card", "hotel key card", "key card", "oyster card",
             "bus pass", "hall pass", "transit card", "insurance card"),
             ("office",),
             ("flat",), ("navy",
             "black")),
    Category("id_card", _card(0.0856, 0.054, 0.0011, _identity, ("blue", "red", "green", "navy")),
             (0.0856, 0.054, 0.0012), 0.005, ("identity card", "id badge",
             "student card", "name badge", "driving licence", "membership card",
             "driver's license", "library card", "name tag card", "press card",
             "membership badge", "lanyard", "conference badge"), ("office",), ("flat",), ("blue",)),
    Category("business_card", _card(0.086, 0.052, 0.0009, _business, ("white", "cream", "black",
             "white")), (0.086, 0.052, 0.001), 0.0015, ("visiting card", "name card",
             "calling card"), ("office",), ("flat",), ("white",)),
    Category("index_card", _card(0.127, 0.076, 0.0009, _rule_lines, ("white", "cream", "yellow",
             "white")), (0.127, 0.076, 0.001), 0.003, ("flash card", "flashcard", "note card",
                 "record card", "cue card", "recipe card", "phonics card", "wax strip"),
             ("office",),
             ("flat",), ("white",)),
    Category("postcard", _card(0.148, 0.105, 0.0009, _postcard, ("white", "cream")),
             (0.148, 0.105, 0.001), 0.005, ("picture postcard", "holiday postcard", "post card"),
             ("office",), ("flat",), ("white",)),
    Category("greeting_card", greeting_card, (0.119, 0.073, 0.15), 0.02, ("birthday card",
                 "christmas card", "thank you card", "wedding card", "invitation",
                 "invitation card", "valentine card", "folded card", "get well card",
                 "get-well card",
             "valentine's card", "valentines card", "sympathy card", "notelet",
             "mother's day card", "anniversary card", "easter card", "father's day card",
             "condolence card", "new year card", "pop-up card", "quilled card", "pop up card",
             "table tent", "tent card", "menu card stand"),
             ("office",), ("tall",),
             ("pink", "sky"), 0.6),
    Category("whiteboard", whiteboard, (0.31, 0.126, 0.243), 0.7, ("dry erase board",
             "white board", "desk whiteboard", "mini whiteboard", "chalkboard slate",
             "blackboard", "writing slate", "slate board"), ("office",), ("big", "tall"),
             ("silver",)),
    Category("whiteboard_eraser", board_eraser, (0.125, 0.05, 0.0315), 0.05, ("board eraser",
             "blackboard eraser", "chalkboard eraser", "chalk eraser", "board rubber",
             "dry eraser", "whiteboard rubber"), ("office",), (), ("blue",)),
    Category("chalk", _stick(0.0055, 0.075, ("white", "white", "pink", "yellow", "sky"), False),
             (0.07, 0.0108, 0.0108), 0.01, ("piece of chalk", "chalk stick", "stick of chalk",
             "blackboard chalk", "tailor's chalk"), ("school",), (), ("white",), 0.6, "lying flat"),
    Category("pastel", _stick(0.0055, 0.062, ("red", "orange", "purple", "teal", "green", "pink"),
             True), (0.058, 0.0097, 0.0097), 0.008, ("oil pastel", "soft pastel", "pastel stick",
             "chalk pastel", "pastel crayon",
             "blending stump", "pencil stub"), ("craft",), (), ("red", "blue"), 0.6,
             "lying flat"),
    Category("charcoal_stick", _stick(0.0042, 0.09, ("black", "charcoal", "black"), False),
             (0.084, 0.0082, 0.0082), 0.004, ("drawing charcoal", "stick of charcoal",
             "charcoal piece", "willow charcoal"), ("craft",), (), ("black",), 0.6, "lying flat"),
    Category("highlighter", highlighter, (0.118, 0.0258, 0.0155), 0.018, ("highlighter pen",
             "highlighter marker", "text marker"), ("office",), ("flat",), ("yellow", "pink"),
             None, "lying flat"),
    Category("push_pin", push_pin, (0.0284, 0.0126, 0.0126), 0.001, ("pushpin", "map pin",
             "board pin"), ("office",), (), ("red", "blue"), None, "lying flat"),
    Category("paper_clip", paper_clip, (0.039, 0.0105, 0.0017), 0.001, ("paperclip", "clip",
             "single paper clip", "metal clip", "carabiner", "cycle clip", "toe clip",
             "mudguard clip", "baby gate latch"), ("office",), ("flat",), ("silver",)),
)  # fmt: skip
"""The module's categories."""
