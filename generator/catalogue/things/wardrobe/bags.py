"""Bags, cases and umbrellas."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.outlines import rectangle
from ...build.recipes import Pieces, ball, leather, pad, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, prism
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

TONES = ("brown", "black", "red", "tan", "navy", "teal", "pink", "mustard", "gray", "green")


def _body(
    x: float, y: float, h: float, levels: list[tuple[float, float, float]], corner: float
) -> Solid:
    """Return a bag's body: (x factor, y factor, z share) from the bottom up."""
    outline = rectangle(1, 1, corner, 5)
    return loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip


def _metal(look: Look) -> textures.Tile:
    return textures.brushed_metal(look.rng, look.pick([(206, 172, 96), (190, 194, 200)]))


def handbag(look: Look) -> Shape:
    """A leather handbag with two handles, a flap and a clasp."""
    x, y, h = look.between(0.19, 0.23), look.between(0.08, 0.1), look.between(0.13, 0.16)
    color = look.color(*TONES)
    body = _body(x, y, h, [(0.94, 0.9, 0), (1, 1, 0.06), (0.96, 0.85, 0.6), (0.84, 0.4, 0.97),
                           (0.82, 0.3, 1.0)], 0.22)  # fmt: skip
    flap = _body(0.8 * x, 0.05, 0.4 * h, [(1, 0.5, 0), (1.06, 1, 0.6), (1.05, 0.7, 1.0)], 0.3)
    flap = flap.move(0, -0.36 * y, 0.6 * h)
    handles = [rod([(-0.25 * x, s * 0.014, h - 0.012), (-0.22 * x, s * 0.018, h + 0.055),
                    (0, s * 0.02, h + 0.085), (0.22 * x, s * 0.018, h + 0.055),
                    (0.25 * x, s * 0.014, h - 0.012)], 0.0055, 8) for s in (-1, 1)]  # fmt: skip
    clasp = ball(0.02, 0.009, 0.016, (0, -0.36 * y - 0.022, 0.68 * h), 12)
    hide = leather(look.rng, color)
    dark = textures.plain(tint_color(color, 0.72))
    return put_down([(body, hide), (join([flap, *handles]), dark), (clasp, _metal(look))],
                   body, flap, join(handles))  # fmt: skip


def clasp_bag(look: Look) -> Shape:
    """A small round bag with a metal frame and a kiss clasp."""
    x, h = look.between(0.09, 0.12), look.between(0.065, 0.08)
    color = look.color("red", "pink", "teal", "black", "gold", "purple", "navy", "mustard")
    y = 0.42 * x
    body = _body(
        x, y, h, [(0.6, 0.6, 0), (0.95, 1.0, 0.2), (1.0, 0.95, 0.5), (0.86, 0.35, 0.97)], 0.45
    )
    frame = rod(
        [
            (-0.45 * x, 0, 0.72 * h),
            (-0.4 * x, 0, 0.98 * h),
            (0, 0, 1.02 * h),
            (0.4 * x, 0, 0.98 * h),
            (0.45 * x, 0, 0.72 * h),
        ],
        0.0045,
        8,
    )
    knobs = [
        ball(0.011, 0.011, 0.011, (s * 0.005, s * 0.003, 1.02 * h + 0.009), 10) for s in (-1, 1)
    ]
    cloth = textures.spots(look.rng, color, tint_color(color, 1.5), 0.12) if look.chance(0.4) else (
        leather(look.rng, color))  # fmt: skip
    return put_down(
        [(body, cloth), (join([frame, *knobs]), _metal(look))], body, join([frame, *knobs])
    )


def clutch(look: Look) -> Shape:
    """A flat evening bag lying, its flap like an envelope."""
    x, y, h = look.between(0.22, 0.26), look.between(0.13, 0.15), look.between(0.026, 0.034)
    color = look.color("black", "gold", "silver", "red", "pink", "navy", "purple")
    body = pad(x, y, h, 0.01, soft=0.4, steps=4)
    flap = prism([(-0.48 * x, 0.48 * y), (-0.48 * x, 0.1 * y), (0, -0.22 * y), (0.48 * x, 0.1 * y),
                  (0.48 * x, 0.48 * y)], h - 0.001, h + 0.0025)  # fmt: skip
    clasp = cylinder(0.009, 0.005, 18, bevel=0.001).move(0, -0.17 * y, h + 0.002)
    hide = leather(look.rng, color)
    return put_down(
        [(body, hide), (flap, textures.plain(tint_color(color, 0.82))), (clasp, _metal(look))],
        body,
        flap,
    )


def backpack(look: Look) -> Shape:
    """A small rucksack standing: a front pocket, zips, a loop and straps behind."""
    color = look.color("red", "navy", "green", "gray", "black", "teal", "mustard", "pink")
    x, y, h = 0.2, 0.11, 0.27
    body = _body(x, y, h, [(0.95, 0.95, 0), (1, 1, 0.05), (1, 1, 0.6), (0.92, 0.9, 0.85),
                           (0.6, 0.55, 0.98), (0.5, 0.4, 1.0)], 0.3)  # fmt: skip
    pocket = _body(
        0.155, 0.05, 0.12, [(0.95, 0.9, 0), (1, 1, 0.1), (1, 1, 0.75), (0.9, 0.6, 1.0)], 0.35
    )
    pocket = pocket.move(0, -y / 2 - 0.008, 0.02)
    zip_ = rod([(-0.095, -y / 2 + 0.002, 0.14), (-0.08, -0.045, 0.215), (0, -0.04, 0.245),
                (0.08, -0.045, 0.215), (0.095, -y / 2 + 0.002, 0.14)], 0.003, 6)  # fmt: skip
    line = box(0.125, 0.003, 0.004).move(0, -y / 2 - 0.034, 0.12)
    loop = rod([(-0.02, 0.01, h - 0.006), (-0.018, 0.01, h + 0.022), (0.018, 0.01, h + 0.022),
                (0.02, 0.01, h - 0.006)], 0.005, 8)  # fmt: skip
    straps = [rod([(s * 0.05, y / 2 - 0.01, 0.23), (s * 0.065, y / 2 + 0.024, 0.16),
                   (s * 0.075, y / 2 + 0.006, 0.03)], 0.011, 8) for s in (-1, 1)]  # fmt: skip
    cloth = textures.fabric(look.rng, color)
    other = textures.fabric(look.rng, look.own_color("gray", "black", "tan", "navy"))
    pieces: Pieces = [
        (body, cloth),
        (pocket, other),
        (join([zip_, line]), textures.plain((50, 50, 54))),
        (join([loop, *straps]), other),
    ]
    return put_down(pieces, body, pocket, join(straps), factor=look.between(0.75, 1.05))


def _case(look: Look, travel: bool) -> Shape:
    color = look.color("brown", "tan", "red", "navy", "teal", "black", "yellow")
    k = look.between(0.85, 1.1)
    x, y, h = (0.17, 0.09, 0.24) if travel else (0.28, 0.1, 0.19)
    lift = 0.014 if travel else 0.0
    shell = block(x, h, y, 0.022, 0.01).turn(0, np.pi / 2).move(0, y / 2, h / 2 + lift)
    metal = _metal(look)
    pieces: Pieces = []
    hulls = [shell]
    if travel:
        ribs = [
            block(0.012, h - 0.05, y + 0.005, 0.005, 0.002)
            .turn(0, np.pi / 2)
            .move(0.03 * n, y / 2 + 0.0025, h / 2 + lift)
            for n in (-2, -1, 0, 1, 2)
        ]
        wheels = [
            cylinder(0.009, 0.01, 14)
            .move(z=-0.005)
            .turn(1, np.pi / 2)
            .move(sx * (x / 2 - 0.026), sy * (y / 2 - 0.018), 0.009)
            for sx in (-1, 1)
            for sy in (-1, 1)
        ]
        stems = [box(0.014, 0.014, 0.012).move(sx * (x / 2 - 0.026), sy * (y / 2 - 0.018), 0.008)
                 for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
        pull = rod([(-0.04, 0, h + lift - 0.01), (-0.04, 0, h + 0.07), (0.04, 0, h + 0.07),
                    (0.04, 0, h + lift - 0.01)], 0.0045, 8, 6)  # fmt: skip
        pieces += [
            (shell, look.surface(color, "plastic")),
            (join(ribs), textures.plain(tint_color(color, 0.85))),
            (join([*wheels, *stems]), textures.plain((48, 48, 52))),
            (pull, metal),
        ]
        hulls += [join([*wheels, *stems]), pull]
    else:
        belts = [box(0.022, y + 0.004, h + 0.002).move(s * 0.085, 0, 0) for s in (-1, 1)]
        corners = [ball(0.04, y + 0.006, 0.04, (sx * (x / 2 - 0.012), 0, z), 12)
                   for sx in (-1, 1) for z in (0.014, h - 0.014)]  # fmt: skip
        grip = rod(
            [(-0.045, 0, h), (-0.035, 0, h + 0.03), (0.035, 0, h + 0.03), (0.045, 0, h)], 0.0065, 8
        )
        locks = [box(0.024, 0.006, 0.02).move(s * 0.05, -y / 2, h - 0.03) for s in (-1, 1)]
        pieces += [
            (shell, leather(look.rng, color)),
            (join([*belts, *corners, grip]), textures.plain(tint_color(color, 0.6))),
            (join(locks), metal),
        ]
        hulls += [grip]
    return put_down(pieces, *hulls, factor=k)


def suitcase(look: Look) -> Shape:
    """A small suitcase standing: a leather one with straps, or a hard shell on wheels."""
    return _case(look, look.chance(0.4))


def duffel_bag(look: Look) -> Shape:
    """A duffel bag lying: a long round bag with a zip, two handles and straps."""
    color = look.color("black", "navy", "red", "green", "gray", "tan", "teal")
    long, r = look.between(0.26, 0.32), look.between(0.07, 0.085)
    body = cylinder(r, long, 26, bevel=0.018).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.93 * r)
    ends = cylinder(r + 0.001, 0.012, 26).move(z=-0.006).turn(1, np.pi / 2)
    rims = [ends.move(s * (0.5 * long - 0.035), 0, 0.93 * r) for s in (-1, 1)]
    zip_ = box(0.7 * long, 0.008, 0.004).move(0, 0, 1.92 * r)
    handles = [rod([(-0.2 * long, s * 0.6 * r, 1.6 * r), (-0.17 * long, s * 0.3 * r, 2.15 * r),
                    (0, s * 0.2 * r, 2.5 * r), (0.17 * long, s * 0.3 * r, 2.15 * r),
                    (0.2 * long, s * 0.6 * r, 1.6 * r)], 0.0065, 8) for s in (-1, 1)]  # fmt: skip
    bands = [cylinder(r + 0.0015, 0.024, 26).move(z=-0.012).turn(1, np.pi / 2).move(
        s * 0.2 * long, 0, 0.93 * r) for s in (-1, 1)]  # fmt: skip
    other = textures.plain(tint_color(color, 0.6) if sum(color) > 200 else (110, 112, 118))
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (join([*rims, *handles, *bands]), other),
            (zip_, textures.plain((206, 208, 212))),
        ],
        body,
        join(handles),
    )


def umbrella(look: Look) -> Shape:
    """A rolled umbrella lying, its crook to the right."""
    color = look.color("black", "red", "navy", "yellow", "green", "purple", "pink", "blue")
    cloth = lathe([(0, 0), (0.007, 0), (0.021, 0.05), (0.024, 0.19), (0.017, 0.24), (0.006, 0.25),
                   (0, 0.25)], 16)  # fmt: skip
    n = 16
    fold = np.where(np.arange(n) % 2 == 0, 1.0, 0.8)
    angle = np.arctan2(cloth.vertices[:, 1], cloth.vertices[:, 0])
    f = fold[(angle / (2 * np.pi) * n).round().astype(int) % n][:, None]
    cloth = cloth.bend(lambda p: p * np.column_stack([f, f, np.ones(len(p))]))
    cloth = cloth.turn(1, np.pi / 2).move(-0.14, 0, 0.0225)
    shaft = straight((-0.185, 0, 0.0225), (0.17, 0, 0.013), 0.0035, 8)
    crook = rod([(0.12, 0, 0.014), (0.18, 0, 0.011), (0.215, 0.022, 0.0095), (0.19, 0.052, 0.0085),
                 (0.16, 0.05, 0.0085)], 0.0085, 10)  # fmt: skip
    band = cylinder(0.0235, 0.014, 18).turn(1, np.pi / 2).move(0.0, 0, 0.0225)
    wood = textures.wood(look.rng, look.own_color("brown", "wooden", "charcoal"))
    ribs = textures.stripes([color, tint_color(color, 0.75)], 8, upright=True, side=64)
    pieces: Pieces = [(cloth, ribs), (shaft, textures.plain((70, 72, 76))), (crook, wood),
                      (band, textures.plain(tint_color(color, 0.6)))]  # fmt: skip
    return put_down(pieces, cloth, crook, factor=look.between(0.85, 1.1), foot=0.3)


def sunglasses_case(look: Look) -> Shape:
    """A hard case for glasses, closed, lying."""
    x, y, h = look.between(0.155, 0.17), look.between(0.06, 0.07), look.between(0.042, 0.052)
    color = look.color("black", "brown", "navy", "red", "tan", "teal", "pink")
    body = pad(x, y, h, 0.03, soft=0.75, steps=6)
    seam = block(x + 0.0012, y + 0.0012, 0.002, 0.03).move(z=h / 2 - 0.001)
    mark = box(0.035, 0.008, 0.0006).move(0, 0, h - 0.0003)
    return put_down(
        [
            (body, leather(look.rng, color)),
            (seam, textures.plain(tint_color(color, 0.5))),
            (mark, _metal(look)),
        ],
        body,
    )


CATEGORIES = (
    Category("handbag", handbag, (0.21, 0.11, 0.23), 0.5, ("hand bag", "leather bag",
             "leather handbag", "shoulder bag", "ladies bag"), ("living",),
             ("big",), ("brown", "red")),
    Category("purse", clasp_bag, (0.105, 0.044, 0.087), 0.08, ("coin purse", "change purse",
             "small purse", "kiss lock purse"), ("living",), (), ("red", "pink")),
    Category("clutch", clutch, (0.24, 0.14, 0.034), 0.2, ("clutch bag", "evening bag",
             "clutch purse"), ("living",), ("flat",), ("black", "gold"), state="lying flat"),
    Category("backpack", backpack, (0.18, 0.16, 0.26), 0.5, ("rucksack", "school bag", "knapsack",
             "small backpack", "mini backpack", "schoolbag", "book bag", "pannier",
             "packing cube"), ("living",), ("big",
             "tall"), ("red", "navy")),
    Category("suitcase", suitcase, (0.286, 0.107, 0.245), 1.2, ("small suitcase", "luggage",
             "travel case", "vintage suitcase", "trolley case", "briefcase", "mini suitcase",
             "toy suitcase", "carry on", "trolley bag"), ("living",), ("big",), ("brown", "red")),
    Category("duffel_bag", duffel_bag, (0.29, 0.155, 0.2), 0.6, ("duffel", "gym bag",
             "sports bag", "travel bag", "duffle bag", "holdall", "weekend bag"), ("living",),
             ("big",), ("black", "navy"), state="lying"),
    Category("umbrella", umbrella, (0.38, 0.085, 0.045), 0.35, ("folded umbrella",
             "rolled umbrella", "closed umbrella", "parasol", "compact umbrella", "brolly"),
             ("living",),
             ("big",), ("black", "red"), state="lying"),
    Category("glasses_case", sunglasses_case, (0.163, 0.066, 0.047), 0.09, ("sunglasses case",
             "eyeglasses case",
             "spectacle case", "eyeglass case", "case for glasses", "spectacles case", "lens case",
             "key case", "lorgnette case", "camera case",
             "calling card case", "contact lens case", "retainer case"), ("living",), (),
             ("black", "brown"), state="lying"),
)  # fmt: skip
"""The module's categories."""
