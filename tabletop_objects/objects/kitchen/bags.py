"""Objects of the ``kitchen`` theme: bags."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, frame_parts, hull_of, hull_part
from ...kit.primitives import packet, pillow
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, open_box, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color


@category("coffee_bag", size=(0.1, 0.063, 0.2), mass=0.27, material="paper",
          aliases=("bag of coffee", "bag of coffee beans", "coffee packet", "coffee",
          "coffee pouch"), themes=("kitchen", "coffee"), roles=("tall",), colors=("brown", "black"),
          common=True)  # fmt: skip
def coffee_bag(look: Look) -> Shape:
    """An upright bag of coffee with a folded, clipped top."""
    x, y, h = look.between(0.085, 0.11), look.between(0.055, 0.07), look.between(0.17, 0.23)
    color = look.color("brown", "black", "tan", "red", "green", "cream", "teal")
    word = look.pick(["COFFEE", "ROAST", "ARABICA", "BEANS", "ESPRESSO"])
    image = prints.canvas(320, 160, color)
    other = look.own_color("cream", "mustard", "white", "copper", "orange")
    kind = int(look.rng.integers(2))
    for u in (0.0, 0.5):
        start, wide = int(u * 320) + 5, int(160 * x / (x + y)) - 8
        part = image[:, start : start + wide]
        if kind:
            prints.fill(part, 0.12, 0.36, 0.76, 0.44, other)
        else:
            prints.disc(part, 0.5, 0.58, 0.26, other)
        ink = readable_on(other)
        prints.write(part[:, 12:-12], word, 0.5, 0.52, 0.16, ink, bold=True)
        prints.write(part, "250 g", 0.5, 0.7, 0.09, ink)
    outline = rectangle(x, y, 0.006, 2)
    body = packet(
        outline,
        [(0, 0.94, 0.94), (0.004, 1, 1), (0.55 * h, 1.0, 1.0), (0.86 * h, 1.0, 0.5),
         (0.93 * h, 1.0, 0.12), (h, 1.0, 0.1)],
    )  # fmt: skip
    clip = box(1.02 * x, 0.016, 0.014).move(z=0.92 * h)
    tie = surfaces.plain(look.own_color("gold", "black", "tan", "silver"))
    return shape(
        [(body, image), (clip, tie)],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.6 * h]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.5 * h])],
    )  # fmt: skip


PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def panel(look: Look, word: str, color: RGB, wide: int = 120, tall: int = 120) -> surfaces.Tile:
    """Return the print of a lid or front: a title on a band and a round picture."""
    image = prints.canvas(wide, tall, color)
    prints.disc(image, 0.5, 0.7, 0.24, tint_color(color, 1.55))
    prints.disc(image, 0.5, 0.7, 0.15, tint_color(color, 0.7))
    prints.fill(image, 0, 0.16, 1, 0.28, PALE)
    prints.write(image, word, 0.5, 0.31, 0.17, tint_color(color, 0.55), bold=True)
    return image


def soft_pack(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float, float],
              seam: bool = True) -> Make:  # fmt: skip
    """Return a filled plastic or paper packet lying flat, with crimped ends."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        u = np.linspace(-1, 1, 15)
        gx, gy = np.meshgrid(u, u)
        swell = np.clip((1 - gx**6) * (1 - gy**4), 0, 1) ** 0.5
        lift = 0.5 * h * (0.03 + 0.97 * swell)
        body = pillow(0.5 * x * gx, 0.5 * y * gy, lift)
        low = 0.3 * h
        body = body.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2] + low, 0)]))
        image = panel(look, look.pick(words), color, 150, max(int(150 * y / x), 48))
        if seam:
            for left in (0.0, 0.95):
                prints.fill(image, left, 0, 0.05, 1, tint_color(color, 0.8))
        return shape([(body, image)], [hull_of(body)])

    return make


@category("open_paper_bag", size=(0.166, 0.109, 0.204), mass=0.03, material="paper", hollow=True,
          aliases=("open bag", "paper sack", "empty paper bag", "open brown bag", "sack",
          "open shopping bag", "paper shopping bag", "empty bag"), themes=("kitchen",),
          roles=("container", "tall"), colors=("tan",))  # fmt: skip
def open_paper_bag(look: Look) -> Shape:
    """An upright, open brown paper bag."""
    k = look.between(0.92, 1.08)
    color = look.color("tan", "tan", "white", "brown", "beige")
    x, y, h, t = 0.16 * k, 0.105 * k, 0.2 * k, 0.0024
    walls = open_box(x, y, h, t, t)
    paper = surfaces.speckles(look.rng, color, 9)
    fold = [box(0.0016, y * 0.98, 0.0016).move(x=s * x / 2, z=0.5 * h) for s in (-1, 1)]
    creases = [tube([(s * x / 2, -y / 2, 0.001), (s * x / 2, 0, 0.4 * h),
                     (s * x / 2, y / 2, 0.001)], 0.0012, 5) for s in (-1, 1)]  # fmt: skip
    return shape([(join(walls), paper), (join([*fold, *creases]), surfaces.plain(
                  tint_color(color, 0.82)))], frame_parts(x, y, h, t, t))  # fmt: skip


INKS = ("red", "blue", "green", "navy", "orange", "teal", "brown", "crimson")


def _fronts(look: Look, x: float, y: float, ground: RGB, front: surfaces.Tile) -> surfaces.Tile:
    """Return a print for a packet of width x and depth y, with two fronts and small print.

    u = 0 is at the left front corner, where a ``packet`` with a ``rectangle`` as outline starts.
    """
    width = 384
    image = prints.canvas(width, 160, ground)
    wide = int(width * x / (2 * (x + y)))
    part = surfaces.fit(front, 160, wide)
    ink: RGB = (90, 90, 96) if sum(ground) > 380 else (210, 210, 206)
    for start in (0, int(width / 2)):
        image[:, start : start + wide] = part
        left = (start + wide) / width
        prints.lines(image, look.rng, (left + 0.02, 0.25, 0.5 - wide / width - 0.04, 0.4), 7, ink)
    return image


def _bag(
    look: Look, x: float, y: float, h: float, ground: RGB, front: surfaces.Tile, top: str
) -> Shape:
    """Return a paper or plastic bag with its top folded flat or pressed into a seam."""
    image = _fronts(look, x, y, ground, front)
    rim: RGB = tuple(float(c) for c in front[2, 2])  # type: ignore[assignment]
    if top == "flat":
        levels = [(0.0, 0.96, 0.96), (0.004, 1, 1), (0.5 * h, 1.02, 1.03), (0.97 * h, 1, 1),
                  (h, 0.97, 0.97)]  # fmt: skip
        body = packet(rectangle(x, y, 0.006, 2), levels)
        fold = box(0.96 * x, 0.34 * y, 0.003).move(y=0.05 * y, z=h - 0.0006)
        return shape([(body, image), (fold, surfaces.plain(tint_color(rim, 0.92)))],
                     [hull_of(body)])  # fmt: skip
    levels = [(0.0, 0.94, 0.9), (0.006, 1, 1), (0.4 * h, 1.03, 1.12), (0.74 * h, 1.0, 0.86),
              (0.92 * h, 1.0, 0.08), (h, 1.0, 0.05)]  # fmt: skip
    body = packet(rectangle(x, y, 0.008, 2), levels)
    low = hull_part(body.vertices[body.vertices[:, 2] < 0.75 * h])
    return shape([(body, image)], [low, hull_part(body.vertices[body.vertices[:, 2] > 0.7 * h])])


def _front(look: Look, word: str, color: RGB, ground: RGB, kind: str) -> surfaces.Tile:
    """Return a bag's front: a title and a picture of wheat, sugar cubes or a bowl of rice."""
    image = prints.canvas(112, 160, ground)
    prints.fill(image, 0, 0, 1, 0.13, color)
    prints.fill(image, 0, 0.87, 1, 0.13, color)
    if look.chance(0.5):
        prints.fill(image, 0, 0.2, 1, 0.22, color)
        prints.write(image, word, 0.5, 0.31, 0.13, readable_on(color), bold=True)
    else:
        prints.write(image, word, 0.5, 0.3, 0.14, color, bold=True)
        prints.fill(image, 0.2, 0.41, 0.6, 0.012, color)
    if kind == "wheat":
        gold = (206, 156, 60)
        prints.stroke(image, [(0.5, 0.84), (0.5, 0.5)], 0.012, gold)
        for k in range(5):
            y = 0.52 + 0.055 * k
            for s in (-1, 1):
                prints.polygon(image, [(0.5, y + 0.04), (0.5 + s * 0.16, y - 0.03),
                                       (0.5 + s * 0.06, y - 0.04)], gold)  # fmt: skip
    elif kind == "cubes":
        for a, b in ((0.34, 0.68), (0.52, 0.68), (0.43, 0.55)):
            prints.fill(image, a, b, 0.16, 0.11, tint_color(color, 1.6))
            prints.fill(image, a + 0.015, b + 0.01, 0.13, 0.09, (252, 252, 250))
    else:
        prints.disc(image, 0.5, 0.64, 0.15, (252, 252, 250))
        prints.fill(image, 0.2, 0.64, 0.6, 0.02, color)
        prints.polygon(image, [(0.22, 0.65), (0.78, 0.65), (0.64, 0.8), (0.36, 0.8)], color)
    prints.write(image, look.pick(["1 kg", "2 lb", "500 g"]), 0.5, 0.93, 0.07, readable_on(color))
    return image


@category("flour_bag", size=(0.107, 0.07, 0.175), mass=1.0, material="paper",
          aliases=("bag of flour", "flour", "flour packet", "packet of flour", "flour sack",
          "baking flour"), themes=("kitchen",), colors=("white", "blue"))  # fmt: skip
def flour_bag(look: Look) -> Shape:
    """A paper bag of flour with a flat folded top and an ear of wheat on its front."""
    x, y, h = look.between(0.095, 0.115), look.between(0.06, 0.075), look.between(0.155, 0.19)
    color, ground = (look.color(*INKS), look.pick([(244, 240, 228), (250, 250, 248),
                                                   (222, 200, 160)]))  # fmt: skip
    front = _front(look, look.pick(["FLOUR", "FLOUR", "WHEAT", "RYE"]), color, ground, "wheat")
    return _bag(look, x, y, h, ground, front, "flat")


@category("sugar_bag", size=(0.094, 0.053, 0.148), mass=0.7, material="paper",
          aliases=("bag of sugar", "sugar box", "packet of sugar", "box of sugar"),
          themes=("kitchen",), colors=("white", "blue"))  # fmt: skip
def sugar_bag(look: Look) -> Shape:
    """A small paper bag or box of sugar with white cubes on its front."""
    x, y, h = look.between(0.085, 0.1), look.between(0.045, 0.06), look.between(0.13, 0.165)
    color = look.color("blue", "pink", "red", "yellow", "navy", "sky", "green")
    ground = look.pick([(250, 250, 248), (250, 228, 130), (236, 240, 246)])
    front = _front(look, "SUGAR", color, ground, "cubes")
    if look.chance(0.4):
        image = surfaces.fit(front, 160, 112)
        return shape([(box(x, y, h), image)], [box_part(x, y, h)])
    return _bag(look, x, y, h, ground, front, "flat")


@category("rice_bag", size=(0.128, 0.11, 0.189), mass=0.95, material="paper",
          aliases=("bag of rice", "rice", "packet of rice", "rice sack", "sack of rice",
          "rice packet"), themes=("kitchen",), colors=("white", "red"))  # fmt: skip
def rice_bag(look: Look) -> Shape:
    """A bag of rice: plastic with a seam on top, or a small sack tied with a cord."""
    color = look.color("red", "green", "blue", "orange", "teal", "purple")
    if look.chance(0.65):
        x, y, h = look.between(0.11, 0.13), look.between(0.06, 0.07), look.between(0.19, 0.22)
        ground = look.pick([(250, 250, 248), (246, 240, 222), (250, 226, 120)])
        front = _front(look, look.pick(["RICE", "BASMATI", "JASMINE"]), color, ground, "bowl")
        return _bag(look, x, y, h, ground, front, "seam")
    r, h = look.between(0.06, 0.07), look.between(0.17, 0.2)
    cloth = surfaces.fabric(look.rng, (212, 184, 136), None, 24).copy()
    cloth = surfaces.fit(cloth, 128, 256).copy()
    part = cloth[:, 96:160]
    prints.write(part, "RICE", 0.5, 0.55, 0.2, color, bold=True)
    prints.fill(part, 0.1, 0.68, 0.8, 0.025, color)
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.16 * h), (0.98 * r, 0.5 * h), (0.5 * r, 0.78 * h),
                  (0.24 * r, 0.84 * h), (0.5 * r, 0.97 * h), (0.44 * r, h), (0, 0.95 * h)], 26,
                 v=[0, 0.02, 0.2, 0.5, 0.78, 0.84, 0.95, 0.98, 1])  # fmt: skip
    cord = cylinder(0.27 * r, 0.02 * h, 18).move(z=0.83 * h)
    return shape([(body, cloth), (cord, surfaces.plain(tint_color(color, 0.8)))],
                 [hull_part(body.vertices[body.vertices[:, 2] < 0.8 * h]),
                  hull_part(body.vertices[body.vertices[:, 2] > 0.75 * h])])  # fmt: skip


def bag(
    x: float, y: float, h: float, face: surfaces.Tile, side: surfaces.Tile
) -> list[tuple[Solid, surfaces.Tile]]:
    """Return the walls of an open, upright bag with printed faces and folded sides."""
    t = 0.0022
    front = box(x, t, h)
    wing = box(t, y - 2 * t, h)
    return [(box(x, y, t), side), (front.move(y=-y / 2 + t / 2), face),
            (front.move(y=y / 2 - t / 2), face), (wing.move(x=-x / 2 + t / 2), side),
            (wing.move(x=x / 2 - t / 2), side)]  # fmt: skip


@category("paper_bag", size=(0.14, 0.085, 0.235), mass=0.05, material="paper", hollow=True,
          aliases=("lunch bag", "brown bag", "brown paper bag", "takeaway bag", "bag",
          "grocery bag", "takeout bag", "bin liner", "bin bag", "plastic bag", "carrier bag",
          "anti-static bag", "rubbish bag"), themes=("kitchen", "office"), roles=("tall",),
          colors=("tan",), opened="open_paper_bag")  # fmt: skip
def paper_bag(look: Look) -> Shape:
    """A brown paper bag: open with a jagged rim, a folded lunch bag, or a bag with handles."""
    x, y, h = look.between(0.12, 0.16), look.between(0.075, 0.095), look.between(0.19, 0.25)
    color = look.color("tan", "tan", "bronze", "white", "beige")
    paper = surfaces.speckles(look.rng, color, 9, 64)
    face = surfaces.fit(paper, 128, 96).copy()
    if look.chance(0.5):
        ink = look.own_color("green", "black", "red", "navy")
        prints.disc(face, 0.5, 0.45, 0.2, ink)
        prints.write(face, look.pick(["FRESH", "LUNCH", "CAFE", "BAKERY", "ECO"]), 0.5, 0.46, 0.09,
                     (250, 248, 240), bold=True)  # fmt: skip
    kind = look.pick(["open", "folded", "handles"])
    if kind == "folded":
        outline = rectangle(1, 1, 0.05, 1)
        body = loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), z)])
                              for a, b, z in ((1, 1, 0), (1, 1, 0.5 * h), (1, 0.5, 0.8 * h),
                                              (1, 0.16, 0.93 * h))]), outline)  # fmt: skip
        fold = block(1.01 * x, 0.2 * y, 0.16 * h, 0.004).move(z=0.84 * h)
        front = box(0.9 * x, 0.0006, 0.45 * h).move(y=-y / 2 - 0.0002, z=0.03 * h)
        return shape([(body, paper), (fold, surfaces.plain(tint_color(color, 0.92))),
                      (front, face)], [hull_part(body.vertices[body.vertices[:, 2] < 0.6 * h]),
                                       hull_part(body.vertices[body.vertices[:, 2] > 0.4 * h]),
                                       hull_of(fold)])  # fmt: skip
    pieces = bag(x, y, h, face, surfaces.plain(tint_color(color, 0.9)))
    walls = list(frame_parts(x, y, h, 0.0022, 0.0022))
    if kind == "handles":
        for s in (-1, 1):
            path = smooth([(-0.22 * x, s * (y / 2 - 0.004), h - 0.02),
                           (-0.2 * x, s * 0.42 * y, h + 0.045), (0.2 * x, s * 0.42 * y, h + 0.045),
                           (0.22 * x, s * (y / 2 - 0.004), h - 0.02)], 5)  # fmt: skip
            pieces.append((tube(path, 0.003, 6), surfaces.plain(tint_color(color, 0.8))))
    return shape(pieces, walls)


CATEGORIES = (
    Category("food_packet", soft_pack(("NOODLES", "CHEESE", "HAM", "MASALA", "PASTA", "NUTS"),
             ("red", "orange", "green", "blue", "yellow", "purple"), (0.15, 0.105, 0.03)),
             size=(0.15, 0.105, 0.0239), mass=0.15, material="paper", aliases=("ramen packet",
             "packet of noodles", "noodle packet", "cheese packet", "ham packet", "sausage packet",
             "packet of ham", "packet of cheese", "garam masala packet", "spice packet",
             "packet of peanuts", "peanut packet", "salted peanut packet", "packet of nuts",
             "packet of sausages", "packet of bacon", "bacon packet", "frozen peas",
             "bag of frozen peas", "packet of ramen", "soup packet", "packet", "food pouch",
             "cat food pouch", "packet of soup", "snack packet", "jerky packet",
             "packet of spices"), themes=("kitchen",), roles=("flat",), colors=("red", "orange"),
             state="lying flat"),
    Category("spaghetti_packet", soft_pack(("SPAGHETTI", "PASTA", "LINGUINE"), ("blue", "navy",
             "yellow", "red"), (0.27, 0.07, 0.035)), size=(0.27, 0.07, 0.028), mass=0.5,
             material="paper", aliases=("packet of spaghetti", "packet of pasta", "bag of pasta",
             "dried spaghetti", "pack of spaghetti"), themes=("kitchen",), colors=("blue",),
             state="lying flat"),
    Category("sachet", soft_pack(("KETCHUP", "SUGAR", "YEAST", "SALT", "MAYO", "SAUCE"), ("red",
             "white", "yellow", "brown", "pink", "blue"), (0.082, 0.042, 0.008)),
             size=(0.0819, 0.042, 0.0064), mass=0.008, material="paper", aliases=("ketchup sachet",
             "sugar sachet", "yeast packet", "ketchup packet", "sugar packet", "sauce sachet",
             "sauce packet", "salt sachet", "yeast sachet", "sweetener sachet", "mayonnaise sachet",
             "mustard sachet", "soy sauce packet", "coffee sachet", "sachet of sugar",
             "sachet of ketchup", "sugar stick", "silica gel", "silica gel packet",
             "shampoo sachet", "wet wipe sachet", "salt packet", "pepper sachet"),
             themes=("kitchen",), roles=("flat",), colors=("red", "white"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
