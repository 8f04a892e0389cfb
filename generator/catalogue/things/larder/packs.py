"""Dry goods and drinks in bags, boxes and cartons."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.forms import packet
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

Pieces = list[tuple[Solid, textures.Tile]]
INKS = ("red", "blue", "green", "navy", "orange", "teal", "brown", "crimson")


def _fronts(look: Look, x: float, y: float, ground: RGB, front: textures.Tile) -> textures.Tile:
    """Return a print round a packet of depth y and width x: its front twice, small print beside.

    u = 0 is the middle of no side: ``packet`` over ``rectangle`` starts at the left front corner.
    """
    width = 384
    image = prints.canvas(width, 160, ground)
    wide = int(width * x / (2 * (x + y)))
    part = textures.fit(front, 160, wide)
    ink: RGB = (90, 90, 96) if sum(ground) > 380 else (210, 210, 206)
    for start in (0, int(width / 2)):
        image[:, start : start + wide] = part
        left = (start + wide) / width
        prints.lines(image, look.rng, (left + 0.02, 0.25, 0.5 - wide / width - 0.04, 0.4), 7, ink)
    return image


def _bag(
    look: Look, x: float, y: float, h: float, ground: RGB, front: textures.Tile, top: str
) -> Shape:
    """Return a paper or plastic bag: its top folded flat, or pressed to a seam."""
    image = _fronts(look, x, y, ground, front)
    rim: RGB = tuple(float(c) for c in front[2, 2])  # type: ignore[assignment]
    if top == "flat":
        levels = [(0.0, 0.96, 0.96), (0.004, 1, 1), (0.5 * h, 1.02, 1.03), (0.97 * h, 1, 1),
                  (h, 0.97, 0.97)]  # fmt: skip
        body = packet(rectangle(x, y, 0.006, 2), levels)
        fold = box(0.96 * x, 0.34 * y, 0.003).move(y=0.05 * y, z=h - 0.0006)
        return shape([(body, image), (fold, textures.plain(tint_color(rim, 0.92)))],
                     [hull_of(body)])  # fmt: skip
    levels = [(0.0, 0.94, 0.9), (0.006, 1, 1), (0.4 * h, 1.03, 1.12), (0.74 * h, 1.0, 0.86),
              (0.92 * h, 1.0, 0.08), (h, 1.0, 0.05)]  # fmt: skip
    body = packet(rectangle(x, y, 0.008, 2), levels)
    low = hull_part(body.vertices[body.vertices[:, 2] < 0.75 * h])
    return shape([(body, image)], [low, hull_part(body.vertices[body.vertices[:, 2] > 0.7 * h])])


def _front(look: Look, word: str, color: RGB, ground: RGB, kind: str) -> textures.Tile:
    """Return a bag's front: a title and a picture: an ear of wheat, cubes, a bowl of rice."""
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


def flour_bag(look: Look) -> Shape:
    """A paper bag of flour folded flat on top, an ear of wheat on its front."""
    x, y, h = look.between(0.095, 0.115), look.between(0.06, 0.075), look.between(0.155, 0.19)
    color, ground = (
        look.color(*INKS),
        look.pick([(244, 240, 228), (250, 250, 248), (222, 200, 160)]),
    )
    front = _front(look, look.pick(["FLOUR", "FLOUR", "WHEAT", "RYE"]), color, ground, "wheat")
    return _bag(look, x, y, h, ground, front, "flat")


def sugar_bag(look: Look) -> Shape:
    """A small paper bag or box of sugar, white cubes on its front."""
    x, y, h = look.between(0.085, 0.1), look.between(0.045, 0.06), look.between(0.13, 0.165)
    color = look.color("blue", "pink", "red", "yellow", "navy", "sky", "green")
    ground = look.pick([(250, 250, 248), (250, 228, 130), (236, 240, 246)])
    front = _front(look, "SUGAR", color, ground, "cubes")
    if look.chance(0.4):
        image = textures.fit(front, 160, 112)
        return shape([(box(x, y, h), image)], [box_part(x, y, h)])
    return _bag(look, x, y, h, ground, front, "flat")


def rice_bag(look: Look) -> Shape:
    """A bag of rice: plastic with a seam on top, or a small sack tied with a cord."""
    color = look.color("red", "green", "blue", "orange", "teal", "purple")
    if look.chance(0.65):
        x, y, h = look.between(0.11, 0.13), look.between(0.06, 0.07), look.between(0.19, 0.22)
        ground = look.pick([(250, 250, 248), (246, 240, 222), (250, 226, 120)])
        front = _front(look, look.pick(["RICE", "BASMATI", "JASMINE"]), color, ground, "bowl")
        return _bag(look, x, y, h, ground, front, "seam")
    r, h = look.between(0.06, 0.07), look.between(0.17, 0.2)
    cloth = textures.fabric(look.rng, (212, 184, 136), None, 24).copy()
    cloth = textures.fit(cloth, 128, 256).copy()
    part = cloth[:, 96:160]
    prints.write(part, "RICE", 0.5, 0.55, 0.2, color, bold=True)
    prints.fill(part, 0.1, 0.68, 0.8, 0.025, color)
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.16 * h), (0.98 * r, 0.5 * h), (0.5 * r, 0.78 * h),
                  (0.24 * r, 0.84 * h), (0.5 * r, 0.97 * h), (0.44 * r, h), (0, 0.95 * h)], 26,
                 v=[0, 0.02, 0.2, 0.5, 0.78, 0.84, 0.95, 0.98, 1])  # fmt: skip
    cord = cylinder(0.27 * r, 0.02 * h, 18).move(z=0.83 * h)
    return shape([(body, cloth), (cord, textures.plain(tint_color(color, 0.8)))],
                 [hull_part(body.vertices[body.vertices[:, 2] < 0.8 * h]),
                  hull_part(body.vertices[body.vertices[:, 2] > 0.75 * h])])  # fmt: skip


def pasta_box(look: Look) -> Shape:
    """A box of pasta: tall for spaghetti or broad, with a window that shows it."""
    tall = look.chance(0.5)
    x, y, h = (look.between(0.07, 0.085), 0.04, look.between(0.25, 0.28)) if tall else (
        look.between(0.12, 0.14), look.between(0.045, 0.06), look.between(0.17, 0.2))  # fmt: skip
    color = look.color("blue", "navy", "blue", "red", "green", "yellow")
    word = look.pick(["SPAGHETTI", "PASTA"] if tall else ["PASTA", "PENNE", "FUSILLI"])
    image = prints.canvas(96, 160, color)
    prints.fill(image, 0.06, 0.13, 0.88, 0.18, (250, 250, 248))
    prints.write(image, word, 0.5, 0.22, 0.1, (196, 42, 40), bold=True)
    prints.fill(image, 0.16, 0.42, 0.68, 0.44, (238, 206, 120))
    for k in range(14):
        if tall:
            prints.fill(image, 0.17 + 0.047 * k, 0.42, 0.016, 0.44, (214, 170, 80))
        else:
            a, b = look.rng.uniform(0.2, 0.75), look.rng.uniform(0.46, 0.82)
            turn = look.rng.uniform(0, np.pi)
            tip = (a + 0.09 * np.cos(turn), b + 0.05 * np.sin(turn))
            prints.stroke(image, [(a, b), tip], 0.028, (222, 180, 90))
            prints.stroke(image, [(a, b), tip], 0.01, (196, 146, 60))
    prints.fill(image, 0, 0.93, 1, 0.025, (246, 240, 222))
    side = textures.speckles(look.rng, color, 2, 32)
    panel = box(x, 0.0006, h)
    return shape([(box(x, y, h), side), (panel.move(y=-y / 2), image),
                  (panel.move(y=y / 2), image)], [box_part(x, y, h)])  # fmt: skip


def tea_box(look: Look) -> Shape:
    """A box of tea: closed, or open with a row of tea bags and a tag hanging out."""
    x, y, h = look.between(0.12, 0.15), look.between(0.065, 0.08), look.between(0.065, 0.085)
    color = look.color("green", "yellow", "red", "teal", "navy", "purple", "orange", "maroon")
    word = look.pick(["TEA", "GREEN TEA", "CHAMOMILE", "EARL GREY", "MINT", "CHAI"])
    image = prints.canvas(160, 88, color)
    for s in (-1, 1):
        prints.polygon(image, [(0.5, 0.86), (0.5 + 0.1 * s, 0.62), (0.5 + 0.24 * s, 0.58),
                               (0.5 + 0.16 * s, 0.8)], (110, 168, 80))  # fmt: skip
    prints.fill(image, 0.06, 0.12, 0.88, 0.4, (248, 244, 230))
    prints.write(image, word, 0.5, 0.32, 0.26, tint_color(color, 0.5), bold=True)
    skin = textures.speckles(look.rng, color, 2, 32)
    panel = box(x, 0.0006, h)
    if look.chance(0.55):
        lid = box(x, y, 0.0006).move(z=h - 0.0003)
        return shape(
            [
                (box(x, y, h), skin),
                (panel.move(y=-y / 2), image),
                (panel.move(y=y / 2), image),
                (lid, image),
            ],
            [box_part(x, y, h)],
        )
    flap = box(x, 0.002, 0.9 * y).turn(0, -0.5).move(y=y / 2 - 0.001, z=h - 0.004)
    bags = []
    count = 9
    paper = textures.speckles(look.rng, (240, 236, 222), 6, 32)
    for k in range(count):
        u = (k / (count - 1) - 0.5) * 0.84 * x
        bags.append(block(0.08 * x, 0.8 * y, 0.014, 0.003, 0.002).move(x=u, z=h - 0.008))
    string = tube([(0.2 * x, -0.3 * y, h + 0.004), (0.2 * x, -y / 2 - 0.003, h + 0.002),
                   (0.2 * x, -y / 2 - 0.004, 0.55 * h)], 0.0008, 5)  # fmt: skip
    tag = box(0.022, 0.001, 0.022).move(0.2 * x, -y / 2 - 0.004, 0.55 * h - 0.02)
    return shape(
        [(box(x, y, h), skin), (panel.move(y=-y / 2), image), (flap, image), (join(bags), paper),
         (string, textures.plain((250, 250, 246))), (tag, textures.plain(tint_color(color, 1.5)))],
        [box_part(x, y, h), hull_of(flap), hull_of(*bags)],
    )  # fmt: skip


def juice_carton(look: Look) -> Shape:
    """A carton of juice: a tall brick with a screw cap, or a small one with a straw."""
    fruit, word = look.pick(
        [
            ("orange", "ORANGE"),
            ("red", "CHERRY"),
            ("green", "APPLE"),
            ("purple", "GRAPE"),
            ("yellow", "MANGO"),
            ("crimson", "TOMATO"),
        ]
    )
    color = look.color(fruit)
    small = look.chance(0.4)
    x, y, h = (
        (0.052, 0.038, look.between(0.1, 0.115))
        if small
        else (look.between(0.085, 0.095), look.between(0.058, 0.066), look.between(0.19, 0.21))
    )
    ground = look.pick([(248, 248, 244), tint_color(color, 1.55), tint_color(color, 0.9)])
    image = prints.canvas(96, 160, ground)
    prints.fill(image, 0, 0, 1, 0.06, tint_color(color, 0.8))
    ink = readable_on(ground) if look.chance(0.5) else tint_color(color, 0.45)
    prints.write(image, word, 0.5, 0.2, 0.13, ink, bold=True)
    prints.write(image, "JUICE", 0.5, 0.31, 0.08, ink)
    tone = tint_color(color, 0.95)
    for a, b, s in ((0.5, 0.62, 0.17), (0.24, 0.74, 0.11), (0.78, 0.74, 0.11)):
        prints.disc(image, a, b, s, tone)
        prints.disc(image, a, b, 0.84 * s, tint_color(tone, 1.55))
        for k in range(8):
            way = (
                a + 0.75 * s * 160 / 96 * np.cos(k * np.pi / 4),
                b + 0.75 * s * np.sin(k * np.pi / 4),
            )
            prints.stroke(image, [(a, b), way], 0.008, tone)
    prints.fill(image, 0, 0.9, 1, 0.1, tint_color(color, 0.8))
    pieces: Pieces = [(box(x, y, h), image)]
    parts = [box_part(x, y, h)]
    if small:
        straw = tube(smooth([(0.015, 0.004, h - 0.002), (0.016, 0.003, h + 0.03),
                             (0.006, 0, h + 0.05)], 4), 0.0024, 8)  # fmt: skip
        pieces.append((straw, textures.stripes([(250, 250, 250), tone], 6)))
        parts.append(hull_of(straw))
    else:
        slope = box(x, y, 0.001).move(z=h - 0.0004)
        cap = cylinder(0.015, 0.016, 20, bevel=0.001).move(y=-0.14 * y, z=h)
        pieces += [
            (slope, textures.plain(tint_color(color, 0.9))),
            (cap, textures.plain(look.own_color("white", "orange", "green", "red"))),
        ]
        parts.append(hull_of(cap))
    return shape(pieces, parts)


CATEGORIES = (
    Category("flour_bag", flour_bag, (0.107, 0.07, 0.175), 1.0, ("bag of flour", "flour",
             "flour packet", "packet of flour", "flour sack", "baking flour"), ("kitchen",), (),
             ("white", "blue")),
    Category("sugar_bag", sugar_bag, (0.094, 0.053, 0.148), 0.7, ("bag of sugar", "sugar box",
             "packet of sugar", "box of sugar"), ("kitchen",), (), ("white", "blue")),
    Category("rice_bag", rice_bag, (0.128, 0.11, 0.189), 0.95, ("bag of rice", "rice",
             "packet of rice", "rice sack", "sack of rice", "rice packet"), ("kitchen",), (),
             ("white", "red")),
    Category("pasta_box", pasta_box, (0.1, 0.046, 0.23), 0.52, ("box of pasta", "spaghetti box",
             "macaroni box", "pasta packet", "macaroni", "lasagna box", "box of spaghetti",
             "box of macaroni"),
             ("kitchen",), ("tall",),
             ("blue",)),
    Category("tea_box", tea_box, (0.135, 0.101, 0.114), 0.12, ("box of tea", "tea bags",
             "teabag box", "box of tea bags", "tea packet", "green tea box"),
             ("kitchen", "tea"), (), ("green", "yellow")),
    Category("juice_carton", juice_carton, (0.077, 0.053, 0.194), 0.8, ("orange juice",
             "carton of juice", "orange juice carton", "apple juice", "carton of orange juice",
             "drink carton", "fruit juice", "boxed drink", "juice brick"), ("kitchen", "breakfast"),
             ("tall",), ("orange", "green")),
)  # fmt: skip
"""The module's categories."""
