"""What one shaves and dries with, and cotton."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.recipes import Pieces, ball, pad, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, box, cylinder, join, lathe
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

SOFT = ("white", "sky", "pink", "mint", "lavender", "cream", "sage")


def cotton_ball(look: Look) -> Shape:
    """A cotton ball."""
    color = look.color("white", "white", "white", "pink", "sky", "cream")
    d = look.between(0.028, 0.045)
    puffs = [ball(0.5 * d, 0.5 * d, 0.45 * d, (0.27 * d * np.cos(2.4 * k) * np.sqrt(1 - z * z),
             0.27 * d * np.sin(2.4 * k) * np.sqrt(1 - z * z), 0.22 * d * z), 8)
             for k, z in enumerate(np.linspace(-0.9, 0.9, 14))]  # fmt: skip
    body = join(puffs).move(z=0.36 * d)
    return put_down([(body, textures.spots(look.rng, color, tint_color(color, 0.93), 0.3))], body)


def cotton_swab(look: Look) -> Shape:
    """A cotton bud lying."""
    color = look.color("white", "blue", "pink", "wooden", "green", "yellow")
    long = look.between(0.066, 0.085)
    r = 0.0012
    stick = straight((-long / 2, 0, 0.0026), (long / 2, 0, 0.0026), r, 8)
    buds = [ball(0.0135, 0.006, 0.006, (s * (long / 2 - 0.004), 0, 0.0027), 12) for s in (-1, 1)]
    return put_down([(stick, textures.plain(color)), (join(buds), textures.plain((250, 250, 248)))],
                   stick, *buds)  # fmt: skip


def cotton_pad(look: Look) -> Shape:
    """A round cotton pad with a pressed rim."""
    color = look.color("white", "white", "cream", "pink", "mint")
    r = look.between(0.024, 0.034)
    body = lathe(
        [(0, 0), (r, 0.0005), (r, 0.002), (0.88 * r, 0.0035), (0.8 * r, 0.0055), (0, 0.006)], 30
    )
    return put_down(
        [
            (
                body,
                textures.basketwork(look.rng, tint_color(color, 1.0), 30)
                if look.chance(0.3)
                else textures.fabric(look.rng, color),
            )
        ],
        body,
    )


def shaving_brush(look: Look) -> Shape:
    """A shaving brush standing on its handle, bristles up."""
    color = look.color("black", "wooden", "white", "brown", "silver", "red")
    handle = lathe(
        [
            (0, 0),
            (0.018, 0),
            (0.019, 0.006),
            (0.011, 0.024),
            (0.015, 0.042),
            (0.013, 0.052),
            (0, 0.052),
        ],
        24,
    )
    collar = cylinder(0.0135, 0.006, 24).move(z=0.05)
    hair = lathe([(0, 0.055), (0.0125, 0.055), (0.022, 0.092), (0.016, 0.106), (0, 0.11)], 22)
    bristle = textures.stack(
        (textures.plain((60, 52, 48)), 0.5), (textures.plain((226, 212, 190)), 0.5)
    )
    return put_down([(handle, look.surface(color, "wood")), (collar, textures.plain((206, 172,
        96))),
                    (hair, bristle)], handle, hair, factor=look.between(0.9, 1.15))  # fmt: skip


def electric_shaver(look: Look) -> Shape:
    """An electric shaver lying on its back, three round cutters at its head."""
    color = look.color("black", "navy", "silver", "gray", "red", "white")
    body = rod([(-0.03, 0, 0.02), (0.02, 0, 0.021), (0.075, 0, 0.018)], [0.021, 0.02, 0.0165], 18)
    body = body.scale(1, 1.15, 0.92)
    head = ball(0.05, 0.062, 0.034, (-0.045, 0, 0.021), 18)
    cutters = [
        cylinder(0.0125, 0.008, 18, bevel=0.001)
        .turn(1, -0.9)
        .move(-0.058 + 0.01 * (n == 1), 0.017 * (n - 1) * 1.05, 0.026 + 0.008 * (n == 1))
        for n in range(3)
    ]
    switch = block(0.02, 0.012, 0.004, 0.005).move(0.012, 0, 0.0375)
    stripe = block(0.05, 0.008, 0.002, 0.003).move(0.05, 0, 0.0345)
    grip = textures.plain((52, 54, 60))
    return put_down(
        [
            (body, look.surface(color, "plastic")),
            (head, grip),
            (join(cutters), textures.brushed_metal(look.rng, (206, 208, 214))),
            (join([switch, stripe]), textures.plain(look.own_color("silver", "blue", "orange"))),
        ],
        body,
        head,
        factor=look.between(0.9, 1.1),
    )


def _roll(look: Look, long: float, r: float, words: tuple[str, ...]) -> Shape:
    """A towel rolled up, lying: a spiral at its ends, a band near them."""
    color = look.color(*words)
    roll = cylinder(r, long, 26).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.97 * r)
    spiral = prints.canvas(96, 96, tint_color(color, 0.95))
    for n in range(5):
        prints.disc(spiral, 0.5, 0.5, 0.48 - 0.1 * n, tint_color(color, 0.72), 0.45 - 0.1 * n)
    ends = [
        cylinder(0.96 * r, 0.0016, 26)
        .turn(1, s * np.pi / 2)
        .move(s * (long / 2 - 0.0008), 0, 0.97 * r)
        for s in (-1, 1)
    ]
    bands = [cylinder(r + 0.0006, 0.012, 26).move(z=-0.006).turn(1, np.pi / 2).move(x, 0, 0.97 * r)
             for x in (-0.36 * long, 0.36 * long)]  # fmt: skip
    flap = box(long, 0.8 * r, 0.008).move(0, -0.55 * r, 0)
    terry = textures.spots(look.rng, color, tint_color(color, 0.9), 0.4)
    pieces: Pieces = [(join([roll, flap]), terry), (ends[0], spiral), (ends[1], spiral),
                      (join(bands), textures.plain(tint_color(color, 0.82)))]  # fmt: skip
    return put_down(pieces, roll, flap)


def rolled_towel(look: Look) -> Shape:
    """A rolled towel lying."""
    return _roll(look, look.between(0.22, 0.28), look.between(0.04, 0.052),
                 ("white", "teal", "pink", "gray", "sage", "navy", "mustard"))  # fmt: skip


def washcloth(look: Look) -> Shape:
    """A small square cloth folded in four, with a loop."""
    side = look.between(0.11, 0.15)
    color = look.color(*SOFT, "teal", "mustard", "navy")
    terry = textures.spots(look.rng, color, tint_color(color, 0.88), 0.4)
    layers = [pad(side - 0.003 * n, side - 0.002 * n, 0.006, 0.006, soft=0.45, steps=3)
              .move(z=0.006 * n) for n in range(4)]  # fmt: skip
    stripe = box(side - 0.012, 0.01, 0.0008).move(0, -0.32 * side, 0.0236)
    loop = rod(
        [
            (side / 2 - 0.008, side / 2 - 0.012, 0.016),
            (side / 2 + 0.01, side / 2 + 0.006, 0.008),
            (side / 2 - 0.012, side / 2 - 0.006, 0.014),
        ],
        0.0016,
        6,
    )
    return put_down(
        [(join(layers), terry), (join([stripe, loop]), textures.plain(tint_color(color, 0.75)))],
        join(layers),
    )


CATEGORIES = (
    Category(
        "cotton_ball",
        cotton_ball,
        (0.036, 0.036, 0.031),
        0.001,
        ("cotton wool", "cotton wool ball", "ball of cotton"),
        ("vanity",),
        ("round",),
        ("white",),
    ),
    Category(
        "cotton_swab",
        cotton_swab,
        (0.081, 0.006, 0.0057),
        0.0005,
        ("cotton bud", "q-tip", "q tip", "ear bud", "swab", "ear swab",
             "swab tube"),
        ("vanity",),
        (),
        ("white",),
        state="lying",
    ),
    Category(
        "cotton_pad",
        cotton_pad,
        (0.058, 0.058, 0.006),
        0.001,
        ("cotton round", "makeup pad", "makeup remover pad", "cotton disc", "hand warmer",
        "cotton wool pad", "makeup wipe"),
        ("vanity",),
        ("round", "flat"),
        ("white",),
        state="lying flat",
    ),
    Category(
        "shaving_brush",
        shaving_brush,
        (0.044, 0.044, 0.112),
        0.07,
        ("shave brush", "badger brush", "shaving kit"),
        ("vanity",),
        ("tall", "round"),
        ("black", "wooden"),
    ),
    Category(
        "electric_shaver",
        electric_shaver,
        (0.145, 0.062, 0.045),
        0.16,
        (
            "shaver",
            "electric razor",
            "beard trimmer",
            "hair trimmer",
            "trimmer",
            "hair clippers",
            "hair clipper", "nose hair trimmer", "bikini trimmer", "epilator device",
            "fabric shaver", "bobble remover",),
        ("vanity",),
        (),
        ("black", "navy"),
        state="lying",
    ),
    Category(
        "rolled_towel",
        rolled_towel,
        (0.25, 0.092, 0.09),
        0.35,
        ("rolled up towel", "towel roll", "rolled bath towel", "rolled hand towel",
             "bolt of fabric", "roll of fabric"),
        ("vanity",),
        (),
        ("white", "teal"),
        state="lying",
    ),
    Category(
        "washcloth",
        washcloth,
        (0.145, 0.145, 0.0245),
        0.04,
        (
            "wash cloth",
            "face cloth",
            "flannel",
            "facecloth",
            "face towel",
            "wash rag",
            "folded cloth",
            "rag", "chamois leather", "lens wipe", "screen wipe", "baby wipe",
             "antibacterial wipe", "wet wipe", "hanky",),
        ("vanity",),
        ("flat", "support"),
        ("white", "teal"),
        state="lying folded",
    ),
)  # fmt: skip
"""The module's categories."""
