"""Things of the bathroom: paper, cotton, brushes, towels."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, frame_parts
from ...build.outlines import rectangle
from ...build.recipes import ball, pad, put_down, rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, ellipsoid, join, lathe, loft, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def toilet_roll(look: Look) -> Shape:
    """A roll of toilet paper standing, its last sheet hanging down."""
    r, h = look.between(0.048, 0.058), look.between(0.092, 0.105)
    color = look.color("white", "white", "cream", "pink", "sky")
    roll = lathe([(0.02, 0), (r, 0), (r, h), (0.02, h)], 30, loop=True)
    core = lathe(
        [(0.0185, 0), (0.021, 0), (0.021, h + 0.0006), (0.0185, h + 0.0006)], 24, loop=True
    )
    sheet = box(0.05, 0.0012, h - 0.002).turn(2, -0.25).move(0.03, -r * 0.9, 0.001)
    paper = textures.spots(look.rng, color, tint_color(color, 0.95), 0.15)
    rings = textures.stripes([color, tint_color(color, 0.93)], 16, side=64)
    lid = lathe([(0.021, h - 0.0005), (r - 0.001, h - 0.0005), (r - 0.001, h + 0.0004),
                 (0.021, h + 0.0004)], 30, loop=True)  # fmt: skip
    return shape(
        [(roll, paper), (core, textures.plain((190, 160, 120))), (sheet, paper), (lid, rings)],
        [cylinder_part(r, h)],
    )


def loofah(look: Look) -> Shape:
    """A ruffled bath puff with a cord."""
    color = look.color("pink", "teal", "purple", "white", "green", "blue", "orange")
    d = look.between(0.09, 0.12)
    ruffles: list[Solid] = []
    for k in range(26):
        z = -0.92 + 1.84 * k / 25
        a = 2.4 * k
        leaf = torus(0.15 * d, 0.028 * d, 12, 5).scale(1, 1, 0.8).turn(0, 0.9 * k).turn(1, 0.7 * k)
        out = 0.33 * d * np.sqrt(1 - z * z)
        ruffles.append(leaf.move(out * np.cos(a), out * np.sin(a), 0.34 * d * z))
    core = ball(0.78 * d, 0.78 * d, 0.76 * d, (0, 0, 0), 14)
    cord = rod(
        [
            (0.3 * d, 0, -0.3 * d),
            (0.6 * d, 0.05 * d, -0.45 * d),
            (0.75 * d, 0, -0.455 * d),
            (0.62 * d, -0.08 * d, -0.45 * d),
            (0.32 * d, -0.02 * d, -0.32 * d),
        ],
        0.0018,
        6,
    )
    net = prints.mesh_holes(color, tint_color(color, 0.75), 16, 16)
    body = join([*ruffles, core])
    body = body.move(z=-float(body.bounds[0, 2]) - 0.004)
    return put_down([(body, net), (cord.move(z=0.46 * d), textures.plain((246, 246, 244)))], body)


def soap_dish(look: Look) -> Shape:
    """An open soap dish with ridges."""
    x, y, h = look.between(0.12, 0.14), look.between(0.085, 0.1), look.between(0.024, 0.032)
    color = look.color("white", "teal", "wooden", "gray", "pink", "navy", "sage")
    outline = rectangle(1, 1, 0.2, 5)
    t = 0.0045
    levels = [(x - 0.02, y - 0.02, 0), (x, y, h), (x - 2 * t, y - 2 * t, h),
              (x - 0.02 - 2 * t, y - 0.02 - 2 * t, t)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    ribs = join([block(0.007, y - 0.04, 0.003, 0.003).move(x=0.017 * n, z=t - 0.0005)
                 for n in range(-2, 3)])  # fmt: skip
    skin = look.surface(color, "ceramic")
    return shape([(body, skin), (ribs, textures.plain(tint_color(color, 0.9)))],
                 frame_parts(x - 0.012, y - 0.012, h, t, t))  # fmt: skip


def tissue_pack(look: Look) -> Shape:
    """A pocket pack of tissues, one drawn out at the slit."""
    x, y, h = look.between(0.1, 0.115), look.between(0.053, 0.06), look.between(0.022, 0.028)
    color = look.color("sky", "blue", "green", "pink", "lavender", "white", "teal")
    body = pad(x, y, h, 0.006, soft=0.35, steps=3)
    image = prints.canvas(112, 60, color)
    prints.fill(image, 0, 0.42, 1, 0.14, (246, 246, 244))
    prints.write(image, look.pick(["TISSUES", "SOFT"]), 0.27, 0.22, 0.24, readable_on(color), True)
    top = box(0.94 * x, 0.88 * y, 0.0008).move(z=h - 0.0004)
    tip = ellipsoid(0.05, 0.012, 0.03, 8, 5).move(0.008, 0, h + 0.006)
    return put_down([(body, textures.plain(tint_color(color, 0.92))), (top, image),
                    (tip, textures.plain((250, 250, 248)))], body, tip)  # fmt: skip


def floss(look: Look) -> Shape:
    """A box of dental floss, its lid open over a bit of thread."""
    color = look.color("white", "mint", "blue", "teal", "pink", "green")
    k = look.between(0.9, 1.15)
    body = block(0.042, 0.018, 0.05, 0.008, 0.002)
    lid = block(0.03, 0.018, 0.01, 0.004, 0.002).move(0.004, 0, 0.049)
    label = box(0.032, 0.0008, 0.022).move(0, -0.009, 0.012)
    image = prints.canvas(64, 44, tint_color(color, 0.6))
    prints.write(image, "FLOSS", 0.5, 0.5, 0.4, (250, 250, 248), bold=True)
    thread = rod(
        [(-0.014, 0, 0.05), (-0.02, 0, 0.062), (-0.034, -0.002, 0.058), (-0.038, -0.002, 0.04)],
        0.0008,
        5,
    )
    return put_down(
        [
            (body, look.surface(color, "plastic")),
            (lid, textures.plain(tint_color(color, 0.8))),
            (label, image),
            (thread, textures.plain((244, 246, 246))),
        ],
        body,
        lid,
        factor=k,
    )


CATEGORIES = (
    Category(
        "toilet_roll",
        toilet_roll,
        (0.106, 0.106, 0.099),
        0.12,
        ("roll of toilet paper", "toilet paper roll", "loo roll"),
        ("vanity",),
        ("round",),
        ("white",),
    ),
    Category(
        "loofah",
        loofah,
        (0.12, 0.1, 0.1),
        0.04,
        ("bath puff", "shower puff", "bath sponge", "bath pouf", "shower sponge", "loofa", "luffa"),
        ("vanity",),
        (),
        ("pink", "teal"),
    ),
    Category(
        "soap_dish",
        soap_dish,
        (0.13, 0.092, 0.028),
        0.15,
        ("soap tray", "soap holder", "dish for soap", "empty soap dish"),
        ("vanity",),
        ("container", "support"),
        ("white",),
    ),
    Category(
        "tissue_pack",
        tissue_pack,
        (0.107, 0.0565, 0.045),
        0.03,
        ("pack of tissues", "pocket tissues", "tissue packet", "packet of tissues",
            "packet tissues", "pack of wipes", "packet of wipes",),
        ("vanity",),
        (),
        ("sky", "blue"),
        state="lying flat",
    ),
    Category(
        "dental_floss",
        floss,
        (0.06, 0.019, 0.064),
        0.03,
        ("floss", "floss box", "box of dental floss"),
        ("vanity",),
        (),
        ("white", "mint"),
    ),
)  # fmt: skip
"""The module's categories."""
