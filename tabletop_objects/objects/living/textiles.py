"""Objects of the ``living`` theme: textiles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.parts import box_part, hull_of, hull_part
from ...kit.primitives import pad, pillow
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import block, box, join, loft, prism, tube
from ...kit.surfaces import RGB, Look, Tile, tint_color

TONES = ("red", "teal", "navy", "mustard", "sage", "pink", "gray", "cream", "white", "terracotta")


def _cloth(look: Look, color: RGB) -> Tile:
    """Return a texture of plain, checked, striped or printed woven cloth."""
    other = look.own_color("white", "cream", "navy", "red", "mustard", "teal")
    kind = int(look.rng.integers(4))
    if kind == 0:
        return surfaces.fabric(look.rng, color)
    if kind == 1:
        return surfaces.fabric(look.rng, color, other, 28)
    if kind == 2:
        return surfaces.stripes([color, color, other, color], 4, side=96)
    return surfaces.fit(glaze_tile(look, color), 128, 128)


@category("cushion", size=(0.27, 0.25, 0.085), mass=0.3, material="fabric", aliases=("throw pillow",
          "decorative pillow", "square cushion", "sofa cushion", "seat cushion", "breast pad",
          "shoulder pad", "sanitary pad"), themes=("living",), roles=("big", "support"),
          colors=("teal", "mustard"))  # fmt: skip
def cushion(look: Look) -> Shape:
    """A square or oblong cushion lying flat, plump in the middle, with a piped seam."""
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
    loop = np.concatenate([np.column_stack([run, -edge]), np.column_stack([edge, run])[1:],
                           np.column_stack([-run, edge])[1:],
                           np.column_stack([-edge, -run])[1:-1]])  # fmt: skip
    seam = tube(
        np.column_stack([loop * [x / 2, y / 2], np.full(len(loop), low)]), 0.003, 6, loop=True
    )
    return put_down([(body, _cloth(look, color)), (seam, surfaces.plain(tint_color(color, 0.7)))],
                   body)  # fmt: skip


@category("pillow", size=(0.37, 0.23, 0.09), mass=0.4, material="fabric",
          aliases=("bed pillow", "small pillow", "head pillow", "white pillow"), themes=("living",),
          roles=("big", "support"), colors=("white",))  # fmt: skip
def pillow_(look: Look) -> Shape:
    """A long, plump bed pillow, white or striped."""
    x, y, h = look.between(0.34, 0.42), look.between(0.22, 0.26), look.between(0.08, 0.11)
    color = look.color("white", "white", "sky", "cream", "pink", "gray", "lavender")
    n = 15
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    rise = h / 2 * ((1 - u**4) * (1 - v**4)) ** 0.45 + 0.0008
    pull = 1 - 0.05 * (1 - np.abs(u * v))
    body = pillow(u * x / 2 * pull, v * y / 2 * pull, rise)
    body = body.move(z=-float(body.bounds[0, 2]) - 0.004)
    cloth = (
        surfaces.fabric(look.rng, color)
        if look.chance(0.6)
        else surfaces.stripes([color, color, color, tint_color(color, 0.75)], 9, side=128)
    )
    return put_down([(body, cloth)], body)


def flat(x: float, y: float, thick: float, tile: Tile, fringe: float, color: RGB) -> Shape:
    """Return a flat cloth, with fringes of length ``fringe`` at its short ends."""
    sheet = block(x, y, thick, 0.004)
    pieces: Pieces = [(sheet, tile)]
    if fringe:
        count = int(y / 0.008)
        threads = [box(fringe, 0.0028, 0.5 * thick).move(s * (x + fringe) / 2 - s * 0.001, (n + 0.5)
                                                         / count * y - y / 2) for n in range(count)
                   for s in (-1, 1)]  # fmt: skip
        pieces.append((join(threads), surfaces.plain(color)))
    return shape(pieces, [box_part(x, y, thick)])


@category("rug", size=(0.38, 0.225, 0.006), mass=0.4, material="fabric",
          aliases=("small rug", "carpet", "mini rug", "woven rug", "prayer rug"),
          themes=("living",), roles=("flat", "support", "big"), colors=("red", "navy"),
          state="lying flat")  # fmt: skip
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
    return flat(x, y, 0.006, image, 0.015, other)


@category("doily", size=(0.22, 0.22, 0.0012), mass=0.01, material="fabric",
          aliases=("lace doily", "crochet doily", "paper doily"), themes=("living",),
          roles=("flat", "support"), colors=("white",), state="lying flat")  # fmt: skip
def doily(look: Look) -> Shape:
    """A round lace doily with a scalloped edge."""
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


@category("quilt", size=(0.31, 0.24, 0.085), mass=0.9, material="fabric",
          aliases=("patchwork quilt", "folded quilt", "patchwork blanket"), themes=("living",),
          roles=("big", "support"), colors=("red", "blue"), state="lying folded")  # fmt: skip
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
                prints.polygon(image, [(i / 6, j / 6), (i / 6 + 0.16, j / 6),
                                       (i / 6, j / 6 + 0.16)], tint_color(hue, 1.4))  # fmt: skip
    layers = [pad(x * (1 - 0.01 * n), y, h / 3, 0.025, soft=0.5).move(0.003 * n, 0, n * h / 3)
              for n in range(3)]  # fmt: skip
    return put_down([(join(layers), image)], join(layers))


@category("travel_pillow", size=(0.25, 0.2, 0.085), mass=0.25, material="fabric",
          aliases=("neck pillow", "neck cushion", "travel cushion"), themes=("living",),
          roles=("big",), colors=("gray", "navy"), state="lying flat")  # fmt: skip
def travel_pillow(look: Look) -> Shape:
    """A horseshoe-shaped neck pillow lying flat, open to the front."""
    color = look.color("gray", "navy", "teal", "pink", "mustard", "purple", "black")
    k = look.between(0.85, 1.05)
    a = np.linspace(-0.28 * np.pi, 1.28 * np.pi, 26)
    path = np.column_stack([0.09 * np.cos(a), 0.095 * np.sin(a), np.full(26, 0.042)])
    ends = np.clip(np.minimum(a - a[0], a[-1] - a) / 0.35, 0.3, 1) ** 0.5
    body = tube(path, 0.045 * ends, 12)
    v = body.vertices
    parts = [hull_part(v[(v[:, 0] < -0.02) & (v[:, 1] < 0.06)]), hull_part(v[(v[:, 0] > 0.02)
             & (v[:, 1] < 0.06)]), hull_part(v[v[:, 1] > 0.03])]  # fmt: skip
    plush = surfaces.scratches(look.rng, color, tint_color(color, 0.88), 120)
    low = float(v[:, 2].min())
    made = shape([(body.move(z=-low), plush)], [type(p)(p.vertices - [0, 0, low]) for p in parts])
    return made.scale(k)


@category("blanket", size=(0.297, 0.269, 0.0886), mass=0.8, material="fabric",
          aliases=("folded blanket", "throw blanket", "wool blanket", "folded blankets"),
          themes=("living",), roles=("big", "support"), colors=("gray", "cream"),
          state="lying folded")  # fmt: skip
def blanket(look: Look) -> Shape:
    """A folded, patterned blanket or scarf with rounded folds and a fringed edge."""
    x, y, h = look.between(0.26, 0.34), look.between(0.2, 0.26), look.between(0.07, 0.11)
    color = look.color("gray", "cream", "teal", "red", "mustard", "navy", "sage", "pink", "brown")
    other = look.own_color("white", "cream", "navy", "red", "charcoal")
    cloth = look.pick([surfaces.knitting(look.rng, color, 30),
                       surfaces.fabric(look.rng, color, other, 24),
                       surfaces.stripes([color, color, other, color], 3, side=96),
                       surfaces.fabric(look.rng, color)])  # fmt: skip
    layers = look.pick([2, 3, 4])
    t = h / layers
    pieces, parts = [], []
    for n in range(layers):
        fold = block(x * (1 - 0.01 * n), y, t, 0.02)
        round_ = np.array([(0, -t / 2 + 0.0005), (0.55 * t, -0.3 * t), (0.75 * t, 0),
                           (0.55 * t, 0.3 * t), (0, t / 2 - 0.0005)])  # fmt: skip
        nose = loft(np.stack([np.column_stack([np.full(5, u), -round_[:, 0] - y / 2 + 0.006,
                                               round_[:, 1] + t / 2])
                              for u in (-0.49 * x, 0.49 * x)]), round_)  # fmt: skip
        jitter = look.between(-0.004, 0.004)
        pieces.append((join([fold, nose]).move(jitter, jitter, n * t), cloth))
    parts.append(box_part(0.98 * x, y, h))
    if look.chance(0.5):
        threads = [tube([((n / 29 - 0.5) * 0.94 * x, y / 2 - 0.004, h - 0.5 * t),
                         ((n / 29 - 0.5) * 0.94 * x, y / 2 + 0.022, h - 0.9 * t)], 0.0016, 4)
                   for n in range(30)]  # fmt: skip
        pieces.append((join(threads), surfaces.plain(other)))
    return shape(pieces, parts)
