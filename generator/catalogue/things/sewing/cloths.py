"""Cloths and soft furnishings: pillows, rugs, runners, fabrics, felt."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import pillow
from ...build.recipes import Pieces, pad, put_down
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look
from ...surfaces.textures import Tile

TONES = ("red", "teal", "navy", "mustard", "sage", "pink", "gray", "cream", "white", "terracotta")


def _cloth(look: Look, color: RGB) -> Tile:
    """Return woven cloth: plain, checked, striped or printed."""
    other = look.own_color("white", "cream", "navy", "red", "mustard", "teal")
    kind = int(look.rng.integers(4))
    if kind == 0:
        return textures.fabric(look.rng, color)
    if kind == 1:
        return textures.fabric(look.rng, color, other, 28)
    if kind == 2:
        return textures.stripes([color, color, other, color], 4, side=96)
    return textures.fit(glaze_tile(look, color), 128, 128)


def cushion(look: Look) -> Shape:
    """A square or oblong cushion lying, plump in the middle, with a piped seam."""
    x = look.between(0.24, 0.32)
    y = x * look.pick([1.0, 1.0, 0.66])
    h = look.between(0.075, 0.1)
    color = look.color(*TONES)
    n = 15
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    rise = h / 2 * np.sqrt(np.maximum((1 - u**4) * (1 - v**4), 0.0)) + 0.0008
    pull = 1 - 0.06 * (1 - np.abs(u * v))
    body = pillow(u * x / 2 * pull, v * y / 2 * pull, rise)
    low = -float(body.bounds[0, 2]) - 0.003
    body = body.move(z=low)
    edge = 1 - 0.06 * (1 - np.abs(np.linspace(-1, 1, 7)))
    run = np.linspace(-1, 1, 7)
    loop = np.concatenate(
        [
            np.column_stack([run, -edge]),
            np.column_stack([edge, run])[1:],
            np.column_stack([-run, edge])[1:],
            np.column_stack([-edge, -run])[1:-1],
        ]
    )
    seam = tube(
        np.column_stack([loop * [x / 2, y / 2], np.full(len(loop), low)]), 0.003, 6, loop=True
    )
    return put_down([(body, _cloth(look, color)), (seam, textures.plain(tint_color(color, 0.7)))],
                   body)  # fmt: skip


def pillow_shape(look: Look) -> Shape:
    """A white or striped bed pillow, long and plump."""
    x, y, h = look.between(0.34, 0.42), look.between(0.22, 0.26), look.between(0.08, 0.11)
    color = look.color("white", "white", "sky", "cream", "pink", "gray", "lavender")
    n = 15
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    rise = h / 2 * ((1 - u**4) * (1 - v**4)) ** 0.45 + 0.0008
    pull = 1 - 0.05 * (1 - np.abs(u * v))
    body = pillow(u * x / 2 * pull, v * y / 2 * pull, rise)
    body = body.move(z=-float(body.bounds[0, 2]) - 0.004)
    cloth = (
        textures.fabric(look.rng, color)
        if look.chance(0.6)
        else textures.stripes([color, color, color, tint_color(color, 0.75)], 9, side=128)
    )
    return put_down([(body, cloth)], body)


def _flat(x: float, y: float, thick: float, tile: Tile, fringe: float, color: RGB) -> Shape:
    """Return a flat cloth, threads hanging from its short ends where ``fringe`` is positive."""
    sheet = block(x, y, thick, 0.004)
    pieces: Pieces = [(sheet, tile)]
    if fringe:
        count = int(y / 0.008)
        threads = [
            box(fringe, 0.0028, 0.5 * thick).move(
                s * (x + fringe) / 2 - s * 0.001, (n + 0.5) / count * y - y / 2
            )
            for n in range(count)
            for s in (-1, 1)
        ]
        pieces.append((join(threads), textures.plain(color)))
    return shape(pieces, [box_part(x, y, thick)])


def rug(look: Look) -> Shape:
    """A small patterned rug with fringes."""
    x, y = look.between(0.3, 0.4), look.between(0.2, 0.25)
    color = look.color("red", "navy", "terracotta", "teal", "mustard", "beige", "gray")
    other = look.own_color("cream", "beige", "white")
    image = prints.canvas(160, 104, color)
    for k, hue in enumerate((other, tint_color(color, 0.6), other)):
        prints.fill(image, 0.04 + 0.03 * k, 0.05 + 0.045 * k, 0.92 - 0.06 * k, 0.9 - 0.09 * k, hue)
    prints.fill(image, 0.11, 0.17, 0.78, 0.66, color)
    for k in range(3):
        cx, w = 0.27 + 0.23 * k, 0.1
        prints.polygon(image, [(cx - w, 0.5), (cx, 0.24), (cx + w, 0.5), (cx, 0.76)], other)
        prints.polygon(image, [(cx - 0.6 * w, 0.5), (cx, 0.34), (cx + 0.6 * w, 0.5), (cx, 0.66)],
                       tint_color(color, 0.55))  # fmt: skip
    return _flat(x, y, 0.006, image, 0.015, other)


def table_runner(look: Look) -> Shape:
    """A long narrow cloth with bands at its ends."""
    x, y = look.between(0.5, 0.62), look.between(0.15, 0.19)
    color = look.color("white", "beige", "red", "sage", "navy", "gray", "mustard")
    image = textures.fit(textures.fabric(look.rng, color, threads=40), 64, 192).copy()
    other = tint_color(color, 0.6) if sum(color) > 300 else (240, 234, 220)
    for u in (0.04, 0.08, 0.88, 0.92):
        prints.fill(image, u, 0, 0.022, 1, other)
    return _flat(x, y, 0.0025, image, 0.012, color)


def tablecloth(look: Look) -> Shape:
    """A folded tablecloth: checked layers with a rounded fold in front."""
    x, y, h = look.between(0.24, 0.3), look.between(0.18, 0.22), look.between(0.025, 0.04)
    color = look.color("red", "blue", "white", "green", "yellow", "beige", "gray")
    cloth = textures.fabric(look.rng, color, (246, 244, 238), 26)
    count = look.pick([3, 4])
    t = h / count
    layers = [pad(x * (1 - 0.012 * n), y * (1 - 0.012 * n), t, 0.008, soft=0.45).move(
        0.002 * (n % 2), 0, n * t) for n in range(count)]  # fmt: skip
    return put_down([(join(layers), cloth)], join(layers))


def fabric_square(look: Look) -> Shape:
    """A square of printed cloth lying flat, one corner turned over."""
    side = look.between(0.15, 0.22)
    color = look.color(*TONES)
    tile = _cloth(look, color)
    h = side / 2
    cut = 0.3 * side
    sheet = prism([(-h, -h), (h, -h), (h, h - cut), (h - cut, h), (-h, h)], 0, 0.0018)
    flap = prism([(h, h - cut), (h - cut, h), (h - cut, h - cut)], 0.0018, 0.0036)
    return shape([(sheet, tile), (flap, textures.plain(tint_color(color, 1.35)))],
                 [box_part(side, side, 0.0018)])  # fmt: skip


def felt_sheet(look: Look) -> Shape:
    """A sheet of felt lying flat."""
    x, y = look.between(0.2, 0.3), look.between(0.15, 0.21)
    color = look.color("red", "green", "blue", "yellow", "orange", "purple", "pink", "black")
    tile = textures.scratches(look.rng, color, tint_color(color, 0.85), 160)
    return shape([(block(x, y, 0.0028, 0.002), tile)], [box_part(x, y, 0.0028)])


def doily(look: Look) -> Shape:
    """A round lace doily with a scalloped rim."""
    r = look.between(0.09, 0.13)
    color = look.color("white", "white", "cream", "ivory", "pink")
    n = 96
    a = 2 * np.pi * np.arange(n) / n
    away = r * (0.94 + 0.06 * np.abs(np.cos(9 * a)))
    sheet = prism(np.column_stack([away * np.cos(a), away * np.sin(a)]), 0, 0.0012)
    image = prints.canvas(160, 160, color)
    shade = (196, 186, 170)
    rounds = ((0.12, 6, 0.03), (0.2, 12, 0.025), (0.29, 18, 0.025), (0.38, 24, 0.022))
    for ring, count, size in (*rounds, (0.45, 30, 0.012)):
        for b in 2 * np.pi * np.arange(count) / count:
            prints.disc(image, 0.5 + ring * np.cos(b), 0.5 + ring * np.sin(b), size, shade)
        prints.disc(image, 0.5, 0.5, ring + 0.045, tint_color(color, 0.88), ring + 0.038)
    return shape([(sheet, image)], [box_part(1.4 * r, 1.4 * r, 0.0012),
                                    hull_of(sheet)])  # fmt: skip


def quilt(look: Look) -> Shape:
    """A folded patchwork quilt."""
    x, y, h = look.between(0.28, 0.34), look.between(0.22, 0.26), look.between(0.07, 0.1)
    first = look.color("red", "blue", "teal", "pink", "green", "mustard", "navy")
    image = prints.canvas(128, 128, (244, 238, 226))
    hues = [first, tint_color(first, 1.5), look.own_color(*TONES), look.own_color(*TONES)]
    for i in range(6):
        for j in range(6):
            hue = hues[int(look.rng.integers(4))]
            prints.fill(image, i / 6 + 0.006, j / 6 + 0.006, 0.154, 0.154, hue)
            if (i + j) % 2:
                prints.polygon(
                    image,
                    [(i / 6, j / 6), (i / 6 + 0.16, j / 6), (i / 6, j / 6 + 0.16)],
                    tint_color(hue, 1.4),
                )
    layers = [pad(x * (1 - 0.01 * n), y, h / 3, 0.025, soft=0.5).move(0.003 * n, 0, n * h / 3)
              for n in range(3)]  # fmt: skip
    return put_down([(join(layers), image)], join(layers))


def mannequin(look: Look) -> Shape:
    """A dressmaker's bust without head or arms on a stand."""
    color = look.color("beige", "cream", "white", "black", "pink", "gray")
    levels = [
        (0.036, 0.03, 0.09),
        (0.046, 0.036, 0.105),
        (0.033, 0.027, 0.14),
        (0.042, 0.034, 0.17),
        (0.046, 0.032, 0.19),
        (0.02, 0.018, 0.21),
        (0.013, 0.013, 0.216),
        (0.0125, 0.0125, 0.23),
    ]
    path = np.array(levels)
    body = lathe([(0, 0.09), *[(a, z) for a, _, z in levels], (0, 0.23)], 26).bend(
        lambda p: p * np.column_stack([np.ones(len(p)), np.interp(p[:, 2], path[:, 2],
                                       path[:, 1] / path[:, 0]), np.ones(len(p))]))  # fmt: skip
    knob = cylinder(0.008, 0.012, 14, top=0.005).move(z=0.229)
    pole = cylinder(0.005, 0.09, 12).move(z=0.006)
    foot = lathe([(0, 0), (0.05, 0), (0.052, 0.006), (0.03, 0.014), (0.008, 0.02), (0, 0.02)], 24)
    seam = [box(0.0014, 0.002, 0.1).move(0, -0.0335, 0.1)]
    wood = textures.wood(look.rng, look.own_color("brown", "wooden", "charcoal"))
    pieces: Pieces = [(body, textures.fabric(look.rng, color)), (join([knob, pole, foot]), wood),
                      (join(seam), textures.plain(tint_color(color, 0.7)))]  # fmt: skip
    return put_down(pieces, foot, pole, body, factor=look.between(0.9, 1.1))


CATEGORIES = (
    Category("cushion", cushion, (0.27, 0.25, 0.085), 0.3, ("throw pillow", "decorative pillow",
             "square cushion", "sofa cushion", "seat cushion", "breast pad", "shoulder pad",
             "sanitary pad"), ("living",), ("big", "support"),
             ("teal", "mustard")),
    Category("pillow", pillow_shape, (0.37, 0.23, 0.09), 0.4, ("bed pillow", "small pillow",
             "head pillow", "white pillow"), ("living",), ("big", "support"), ("white",)),
    Category("rug", rug, (0.38, 0.225, 0.006), 0.4, ("small rug", "carpet", "mini rug",
             "woven rug", "prayer rug"), ("living",), ("flat", "support", "big"), ("red", "navy"),
             state="lying flat"),
    Category("table_runner", table_runner, (0.58, 0.17, 0.0025), 0.12, ("runner",
             "linen runner", "cloth runner"), ("dining",), ("flat", "support", "big"), ("beige",
             "red"), state="lying flat"),
    Category("tablecloth", tablecloth, (0.27, 0.2, 0.032), 0.35, ("table cloth",
             "folded tablecloth", "tablecover"), ("dining",), ("support", "flat"), ("red",
             "white"), state="lying folded"),
    Category("fabric_square", fabric_square, (0.185, 0.185, 0.0036), 0.015, ("fabric",
             "piece of fabric",
             "piece of cloth", "cloth square", "handkerchief", "bandana", "hankie",
             "pocket square", "folded fabric", "microfiber cloth", "cleaning cloth",
             "fabric swatch", "patchwork square", "granny square", "crochet square",
             "leather strip", "laptop sleeve", "challah cover"),
             ("craft",), ("flat",), ("red", "teal"), state="lying flat"),
    Category("felt_sheet", felt_sheet, (0.25, 0.18, 0.0028), 0.02, ("sheet of felt",
             "felt square", "craft felt", "piece of felt", "felt pad", "kneeling pad", "kneeler"),
             ("craft",), ("flat", "support"),
             ("red", "green"), state="lying flat"),
    Category("doily", doily, (0.22, 0.22, 0.0012), 0.01, ("lace doily", "crochet doily",
             "paper doily"), ("living",), ("flat", "support"), ("white",), state="lying flat"),
    Category("quilt", quilt, (0.31, 0.24, 0.085), 0.9, ("patchwork quilt", "folded quilt",
             "patchwork blanket"), ("living",), ("big", "support"), ("red", "blue"),
             state="lying folded"),
    Category("mannequin", mannequin, (0.104, 0.104, 0.24), 0.4, ("dress form", "tailor dummy",
             "dressmaker dummy", "small mannequin", "mini mannequin", "tailors dummy",
             "mannequin head", "artist mannequin", "wooden mannequin"),
             ("craft",), ("tall",), ("beige",)),
)  # fmt: skip
"""The module's categories."""
