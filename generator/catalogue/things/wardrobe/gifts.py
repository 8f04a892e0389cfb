"""Gifts, bags, jewellery, and clothes that lie on tables."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, frame_parts, hull_of, hull_part
from ...build.forms import spread
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, ellipsoid, join, loft, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

BRIGHT = ("red", "teal", "navy", "pink", "white", "lavender", "black", "sage", "mustard", "sky")


def gift_box(look: Look) -> Shape:
    """A wrapped present: a box and its lid, crossed by a ribbon with a bow of loops."""
    x, y, h = look.between(0.11, 0.19), look.between(0.11, 0.15), look.between(0.07, 0.13)
    color = look.color(*BRIGHT)
    ribbon = textures.plain(look.own_color("gold", "white", "red", "green", "pink", "silver"))
    paper = textures.fit(glaze_tile(look, color), 128, 128)
    lid = box(x + 0.006, y + 0.006, 0.028).move(z=h - 0.026)
    bands = [box(0.024, y + 0.0078, h + 0.0025), box(x + 0.0078, 0.024, h + 0.0025)]
    loops = []
    for n in range(int(look.pick([4, 6]))):
        a = 2 * np.pi * n / 6 + 0.3
        loop = torus(0.017, 0.0045, 16, 6).scale(1, 0.42, 1).turn(0, np.pi / 2)
        loops.append(loop.move(x=0.014, z=0.012).turn(1, -0.5).turn(2, a).move(z=h + 0.006))
    knot = ellipsoid(0.018, 0.018, 0.014, 12, 8).move(z=h + 0.012)
    tails = [box(0.05, 0.016, 0.002).turn(1, 0.3).move(x=0.03).turn(2, a).move(z=h + 0.012)
             for a in (0.7, -0.9)]  # fmt: skip
    top = join([*loops, knot, *tails])
    cover = textures.fit(look.pick([paper, textures.plain(tint_color(color, 0.8))]), 128, 128)
    return shape(
        [(box(x, y, h - 0.01), paper), (lid, cover), (join(bands), ribbon), (top, ribbon)],
        [box_part(x, y, h - 0.01), hull_of(lid), hull_of(top)],
    )


def _bag(
    x: float, y: float, h: float, face: textures.Tile, side: textures.Tile
) -> list[tuple[Solid, textures.Tile]]:
    """Return an open standing bag's walls: printed in front and behind, folded at its sides."""
    t = 0.0022
    front = box(x, t, h)
    wing = box(t, y - 2 * t, h)
    return [
        (box(x, y, t), side),
        (front.move(y=-y / 2 + t / 2), face),
        (front.move(y=y / 2 - t / 2), face),
        (wing.move(x=-x / 2 + t / 2), side),
        (wing.move(x=x / 2 - t / 2), side),
    ]


def gift_bag(look: Look) -> Shape:
    """A coloured paper bag with cord handles and crumpled tissue paper."""
    x, y, h = look.between(0.13, 0.18), look.between(0.07, 0.09), look.between(0.17, 0.22)
    color = look.color(*BRIGHT)
    face = textures.fit(glaze_tile(look, color), 128, 128).copy()
    if look.chance(0.4):
        prints.disc(face, 0.5, 0.5, 0.24, (250, 248, 240))
        prints.write(face[:, 34:94], look.pick(["FOR YOU", "LOVE", "THANKS", "WOW"]), 0.5, 0.5, 0.1,
                     tint_color(color, 0.6), bold=True)  # fmt: skip
    pieces = _bag(x, y, h, face, textures.plain(tint_color(color, 0.88)))
    cord = textures.plain(look.own_color("white", "gold", "black", "red"))
    for s in (-1, 1):
        path = smooth(
            [
                (-0.24 * x, s * (y / 2 - 0.003), h - 0.015),
                (-0.2 * x, s * 0.4 * y, h + 0.05),
                (0.2 * x, s * 0.4 * y, h + 0.05),
                (0.24 * x, s * (y / 2 - 0.003), h - 0.015),
            ],
            5,
        )
        pieces.append((tube(path, 0.0026, 6), cord))
    tissue = textures.speckles(
        look.rng, look.own_color("white", "pink", "sky", "cream", "yellow"), 8, 32
    )
    n = 10
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    lift = 0.03 * (1 - 0.6 * u**2) + 0.022 * textures.noise(look.rng, n, n, (4, 4), 1)
    rim = np.maximum(np.abs(u), np.abs(v)) > 0.99
    lift = np.where(rim, -0.03, np.maximum(lift, 0))
    sheet = spread(
        np.stack([u * (x / 2 - 0.004), v * (y / 2 - 0.004), h - 0.012 + lift], -1), 0.0015
    )
    pieces.append((sheet, tissue))
    return shape(pieces, [box_part(x, y, h), hull_part(np.array([p for p in sheet.vertices
                                                                if p[2] > h - 0.02]))])  # fmt: skip


def paper_bag(look: Look) -> Shape:
    """A brown paper bag: open with its jagged rim, a lunch bag folded over, or with handles."""
    x, y, h = look.between(0.12, 0.16), look.between(0.075, 0.095), look.between(0.19, 0.25)
    color = look.color("tan", "tan", "bronze", "white", "beige")
    paper = textures.speckles(look.rng, color, 9, 64)
    face = textures.fit(paper, 128, 96).copy()
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
        return shape(
            [(body, paper), (fold, textures.plain(tint_color(color, 0.92))), (front, face)],
            [
                hull_part(body.vertices[body.vertices[:, 2] < 0.6 * h]),
                hull_part(body.vertices[body.vertices[:, 2] > 0.4 * h]),
                hull_of(fold),
            ],
        )
    pieces = _bag(x, y, h, face, textures.plain(tint_color(color, 0.9)))
    walls = list(frame_parts(x, y, h, 0.0022, 0.0022))
    if kind == "handles":
        for s in (-1, 1):
            path = smooth(
                [
                    (-0.22 * x, s * (y / 2 - 0.004), h - 0.02),
                    (-0.2 * x, s * 0.42 * y, h + 0.045),
                    (0.2 * x, s * 0.42 * y, h + 0.045),
                    (0.22 * x, s * (y / 2 - 0.004), h - 0.02),
                ],
                5,
            )
            pieces.append((tube(path, 0.003, 6), textures.plain(tint_color(color, 0.8))))
    return shape(pieces, walls)


CATEGORIES = (
    Category("gift_box", gift_box, (0.155, 0.14, 0.13), 0.4, ("gift", "present", "wrapped gift",
             "wrapped present", "birthday present", "christmas present", "birthday gift",
             "gift package", "pass the parcel", "pass-the-parcel parcel"), ("living",), (),
             ("red", "teal")),
    Category("gift_bag", gift_bag, (0.148, 0.0814, 0.261), 0.15, ("present bag", "party bag",
                 "shopping bag", "goodie bag", "party favour", "party favor", "wedding favour",
                 "favour bag"),
             ("living",), ("tall",),
             ("red", "pink")),
    Category("paper_bag", paper_bag, (0.14, 0.085, 0.235), 0.05, ("lunch bag", "brown bag",
             "brown paper bag", "takeaway bag", "bag", "grocery bag", "takeout bag", "bin liner",
             "bin bag", "plastic bag", "carrier bag", "anti-static bag", "rubbish bag"), ("kitchen",
             "office"), ("tall",), ("tan",)),
)  # fmt: skip
"""The module's categories."""
