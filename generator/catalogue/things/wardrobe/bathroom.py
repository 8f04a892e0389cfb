"""Bathroom things lying on a table, and what a doctor measures with."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, hull_of, hull_part
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, loft, prism, sweep, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

TINTS = ("blue", "red", "green", "pink", "purple", "teal", "white", "orange", "black")


def toothbrush(look: Look) -> Shape:
    """A toothbrush lying on its back, bristles up, its head to the left."""
    long = look.between(0.17, 0.195)
    color = look.color(*TINTS)
    path = smooth([(-0.5 * long, 0, 0.0047), (-0.3 * long, 0, 0.0048), (-0.1 * long, 0, 0.0054),
                   (0.15 * long, 0, 0.0066), (0.5 * long, 0, 0.0055)], 4)  # fmt: skip
    t = np.linspace(0, 1, len(path))
    wide = np.interp(t, [0, 0.03, 0.14, 0.2, 0.3, 0.45, 0.7, 0.96, 1],
                     [0.7, 1.05, 1.1, 0.55, 0.5, 0.95, 1.15, 1.0, 0.6])  # fmt: skip
    rod = sweep(path, rectangle(0.0105, 0.0078, 0.003, 3), wide)
    skin = look.surface(color, "plastic")
    grip = block(0.3 * long, 0.0075, 0.003, 0.0035).move(x=0.22 * long, z=0.0085)
    tufts: dict[bool, list[Solid]] = {True: [], False: []}
    for i in range(7):
        for j in range(3):
            tuft = cylinder(0.0015, 0.011, 6).move(
                -0.48 * long + 0.0038 * i, (j - 1) * 0.0034, 0.006
            )
            tufts[i in (0, 3, 6)].append(tuft)
    pieces = [
        (rod, skin),
        (grip, textures.plain(tint_color(color, 0.6) if sum(color) > 250 else (220, 60, 60))),
        (join(tufts[False]), textures.plain((246, 246, 244))),
        (join(tufts[True]), textures.plain(look.own_color("sky", "blue", "green", "pink"))),
    ]
    x = rod.vertices[:, 0]
    return shape(
        pieces,
        [
            hull_part(rod.vertices[x < -0.2 * long]),
            hull_part(rod.vertices[x > -0.25 * long]),
            hull_of(*tufts[True]),
        ],
    )


def toothpaste(look: Look) -> Shape:
    """A tube of toothpaste lying flat, its cap to the left, its seam to the right."""
    x, y, h = look.between(0.13, 0.165), look.between(0.04, 0.05), look.between(0.028, 0.036)
    color = look.color("white", "white", "blue", "red", "green", "sky", "mint")
    other = look.own_color("red", "blue", "green", "teal", "navy")
    image = prints.canvas(192, 128, color)
    for k in (0, 1):
        part = image[64 * k : 64 * k + 64]
        prints.polygon(part, [(0, 0.9), (0.5, 0.62), (1, 0.9), (1, 1), (0, 1)], other)
        prints.polygon(part, [(0, 0), (0.6, 0), (0.25, 0.24), (0, 0.2)], tint_color(other, 1.4))
        prints.write(
            part,
            look.pick(["FRESH MINT", "DENTAL", "WHITE+", "TOOTHPASTE"]),
            0.52,
            0.45,
            0.3,
            tint_color(other, 0.7) if sum(color) > 420 else (250, 250, 250),
            bold=True,
        )
    n = 28
    a = 2 * np.pi * np.arange(n) / n
    rings = []
    for u in np.linspace(0, 1, 9):
        wide = y / 2 * (0.78 + 0.22 * u)
        tall = h / 2 * (1 - u**1.6) + 0.0012
        rings.append(
            np.column_stack(
                [
                    np.full(n, -x / 2 + 0.02 + (x - 0.02) * u),
                    wide * np.cos(a),
                    tall * np.sin(a) + 0.42 * h * (1 - u**1.4) + 0.004,
                ]
            )
        )
    circle = np.column_stack([np.cos(a), np.sin(a)])
    body = loft(np.stack(rings), circle)
    # round the tube u runs from the right side over the top: lay the picture along x instead
    v = body.vertices
    uv = np.column_stack([(v[:, 0] + x / 2) / x, (v[:, 1] + y / 2) / y])
    body = Solid(v, body.faces, np.clip(uv, 0, 1))
    low = -float(body.bounds[0, 2])
    body = body.move(z=low)
    seam = box(0.012, y, 0.0024).move(
        x=x / 2 - 0.004, z=float(body.vertices[v[:, 0] > 0.45 * x][:, 2].min())
    )
    cap = cylinder(0.011, 0.024, 20, top=0.0125, bevel=0.001).turn(1, np.pi / 2)
    cap = cap.move(x=-x / 2, z=max(0.42 * h + 0.004 + low, 0.0125))
    face = image[:64]
    x_ = body.vertices[:, 0]
    cap_part = hull_of(cap)
    return shape(
        [
            (body, face),
            (seam, textures.plain(tint_color(color, 0.9))),
            (cap, textures.plain(look.own_color("white", "red", "blue", "green"))),
        ],
        [
            flat_foot(body.vertices[x_ < 0.1 * x], 0.12),
            flat_foot(body.vertices[x_ > 0.0], 0.12),
            cap_part,
        ],
    )


def soap_bar(look: Look) -> Shape:
    """A bar of soap with a word pressed into it, alone or on its dish."""
    x, y, h = look.between(0.075, 0.095), look.between(0.05, 0.06), look.between(0.022, 0.03)
    color = look.color("white", "cream", "pink", "mint", "lavender", "yellow", "sage", "sky", "tan")
    outline = rectangle(x, y, look.pick([0.012, 0.024]), 6)
    bar = loft(
        np.stack(
            [
                np.column_stack([outline * s, np.full(len(outline), z)])
                for s, z in (
                    (0.86, 0),
                    (0.98, 0.25 * h),
                    (1.0, 0.5 * h),
                    (0.98, 0.75 * h),
                    (0.84, h),
                )
            ]
        ),
        outline,
    )
    sign = prints.canvas(96, 64, color)
    prints.write(
        sign,
        look.pick(["SOAP", "PURE", "DOVE", "LAVA", "OLIVE"]),
        0.5,
        0.5,
        0.32,
        tint_color(color, 0.72),
        True,
    )
    plate = block(0.66 * x, 0.6 * y, 0.0006, 0.008).move(z=h - 0.0002)
    skin = (
        textures.marble(look.rng, color, tint_color(color, 0.88))
        if look.chance(0.3)
        else textures.speckles(look.rng, color, 4, 32)
    )
    pieces, parts = [(bar, skin), (plate, sign)], [hull_of(bar)]
    if look.chance(0.45):
        up = 0.011
        dish = loft(
            np.stack(
                [
                    np.column_stack([rectangle(1, 1, 0.3, 5) * [a, b], np.full(24, z)])
                    for a, b, z in (
                        (0.8 * x, 0.7 * y, 0),
                        (1.3 * x, 1.34 * y, 0.016),
                        (1.25 * x, 1.27 * y, 0.016),
                        (0.95 * x, 0.9 * y, 0.0095),
                    )
                ]
            ),
            rectangle(1, 1, 0.3, 5),
        )
        pieces = [(s.move(z=up), t) for s, t in pieces]
        pieces.append(
            (dish, look.surface(look.own_color("white", "sky", "gray", "tan", "teal"), "ceramic"))
        )
        parts = [hull_of(pieces[0][0]), hull_of(dish)]
    return shape(pieces, parts)


def comb(look: Look) -> Shape:
    """A comb lying flat: one row of teeth, coarse and fine, or with a handle."""
    long, wide = look.between(0.15, 0.19), look.between(0.028, 0.036)
    color = look.color("black", "black", "bronze", "pink", "sky", "wooden", "red", "white")
    skin = look.surface(color, "plastic")
    t = 0.004
    handle = look.chance(0.4)
    span = 0.62 * long if handle else long
    spine = block(long, 0.011, t, 0.0054).move(y=wide / 2 - 0.0055)
    if handle:
        spine = join([spine, block(long - span + 0.01, 0.017, t, 0.008).move(
            x=span / 2, y=wide / 2 - 0.0085)])  # fmt: skip
    teeth = []
    x = -long / 2 + 0.006
    stop = -long / 2 + span - 0.006
    while x < stop:
        fine = x > -long / 2 + 0.5 * span
        teeth.append(
            box(0.0012 if fine else 0.0018, wide - 0.008, 0.7 * t).move(x, -0.004, 0.15 * t)
        )
        x += 0.0026 if fine else 0.0042
    ends = [
        box(0.006, wide - 0.003, t).move(u, -0.0015)
        for u in (-long / 2 + 0.003, -long / 2 + span - 0.003)
    ]
    return shape(
        [(join([spine, *teeth, *ends]), skin)],
        [box_part(span, wide, t, (-long / 2 + span / 2, 0, 0)), hull_of(spine)],
    )


def razor(look: Look) -> Shape:
    """A safety or disposable razor lying, its head to the left."""
    long = look.between(0.125, 0.145)
    color = look.color("silver", "blue", "pink", "black", "green", "orange", "white", "gold")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    wide = look.between(0.038, 0.043)
    path = smooth([(-0.36 * long, 0, 0.016), (-0.1 * long, 0, 0.0095), (0.2 * long, 0, 0.006),
                   (0.5 * long, 0, 0.0055)], 4)  # fmt: skip
    grip = sweep(
        path,
        rectangle(0.0115, 0.0105, 0.004, 3),
        np.interp(np.linspace(0, 1, len(path)), [0, 0.3, 0.8, 1], [0.6, 0.9, 1.0, 0.75]),
    )
    ribs = [
        torus(0.0064, 0.0009, 14, 5).turn(1, np.pi / 2).move(x=(0.12 + 0.05 * n) * long, z=0.0062)
        for n in range(6)
    ]
    head = block(0.016, wide, 0.011, 0.004, 0.002).turn(1, 0.25).move(x=-0.4 * long, z=0.0105)
    blades = [
        box(0.0012, 0.9 * wide, 0.0012)
        .turn(1, 0.25)
        .move(x=-0.4 * long + 0.003 * n, z=0.0212 - 0.0008 * n)
        for n in (-1, 0, 1)
    ]
    guard = box(0.005, wide, 0.004).turn(1, 0.25).move(x=-0.4 * long - 0.008, z=0.012)
    foot = box(0.012, 0.02, 0.011).move(x=-0.4 * long + 0.001)
    dark = textures.plain((50, 51, 56))
    return shape([(join([grip, *ribs]), skin), (join([head, foot]), dark),
                  (join(blades), textures.plain((206, 208, 214))),
                  (guard, textures.plain(look.own_color("mint", "white", "sky", "green")))],
                 [hull_of(head), hull_of(foot), hull_of(grip)])  # fmt: skip


def nail_file(look: Look) -> Shape:
    """A nail file lying flat: an emery board, or a steel one with a handle."""
    long = look.between(0.13, 0.18)
    color = look.color("pink", "coral", "gray", "black", "teal", "violet", "red", "white")
    if look.chance(0.6):
        wide = look.between(0.014, 0.02)
        board = block(long, wide, 0.003, wide / 2 - 0.0005)
        grit = textures.spots(look.rng, color, tint_color(color, 0.7), 0.35)
        top = block(0.985 * long, 0.92 * wide, 0.0006, wide / 2 - 0.0016).move(z=0.0029)
        return shape(
            [(board, textures.plain((240, 236, 228))), (top, grit)], [box_part(long, wide, 0.0034)]
        )
    blade = prism(
        np.array(
            [
                (-0.5 * long, -0.0005),
                (-0.4 * long, -0.0042),
                (0.16 * long, -0.0055),
                (0.16 * long, 0.0055),
                (-0.4 * long, 0.0042),
                (-0.5 * long, 0.0005),
            ]
        ),
        0.002,
        0.0034,
    )
    hatch = textures.grid((120, 124, 130), (196, 199, 204), 40, 10, 128)
    grip = block(0.36 * long, 0.012, 0.0058, 0.0055, 0.002).move(x=0.32 * long)
    return shape([(blade, hatch), (grip, look.surface(color, "plastic"))],
                 [hull_of(blade), hull_of(grip)])  # fmt: skip


CATEGORIES = (
    Category("toothbrush", toothbrush, (0.182, 0.0125, 0.017), 0.018, ("tooth brush",
             "manual toothbrush",
             "electric toothbrush", "interdental brush", "toothbrush head", "water flosser"),
             ("vanity",), ("flat",), ("blue", "red"), state="lying flat"),
    Category("toothpaste", toothpaste, (0.15, 0.045, 0.034), 0.11, ("tube of toothpaste",
             "toothpaste tube", "tooth paste"), ("vanity",), (), ("white", "red"),
             state="lying flat"),
    Category("soap_bar", soap_bar, (0.0877, 0.054, 0.0261), 0.1, ("bar of soap", "soap",
             "bar soap", "piece of soap", "surf wax", "soap on a rope", "bar of laundry soap",
             "laundry soap"), ("vanity",), (),
             ("white", "pink"),
             state="lying flat"),
    Category("comb", comb, (0.17, 0.032, 0.004), 0.018, ("hair comb", "pocket comb",
             "barber comb"), ("vanity",), ("flat",), ("black",), state="lying flat"),
    Category("razor", razor, (0.125, 0.041, 0.024), 0.035, ("safety razor", "shaving razor",
             "disposable razor", "razor blade", "cut-throat razor", "straight razor",
             "dermaplaning blade", "clipper guard", "shaver head"), ("vanity",), (), ("silver",
             "blue"),
             state="lying flat"),
    Category("nail_file", nail_file, (0.153, 0.0148, 0.00436), 0.008, ("emery board",
             "nail buffer"), ("vanity",), ("flat",), ("pink", "silver"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
