"""Clothes for the upper body, lying flat: waistcoats, vests, baby suits, braces."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import at_box, drum, plate, steel
from ...build.outlines import smooth
from ...build.recipes import put_down
from ...build.shape import Shape
from ...build.solids import join, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain
from .underwear import cloth, mirror


def waistcoat(look: Look) -> Shape:
    """A buttoned waistcoat lying flat."""
    color = look.color("charcoal", "navy", "brown", "gray", "maroon", "black", "olive")
    k = look.between(0.85, 1.05)
    half = [
        (0.0, -0.14),
        (0.03, -0.165),
        (0.05, -0.145),
        (0.12, -0.135),
        (0.115, 0.0),
        (0.09, 0.075),
        (0.095, 0.15),
        (0.05, 0.165),
        (0.0, 0.03),
    ]
    body = plate(mirror(half), 0.012)
    back = plate([(-0.055, 0.02), (0.055, 0.02), (0.05, 0.16), (-0.05, 0.16)], 0.006)
    edge = [
        tube(np.array([(s * 0.049, 0.163, 0.0118), (s * 0.002, 0.032, 0.0118)]), 0.0022, 6)
        for s in (-1, 1)
    ]
    seam = at_box(0.002, 0.165, 0.0012, (0, -0.054, 0.0115))
    buttons = [drum(0.0055, 0.003, (0.009, 0.01 - 0.035 * n, 0.0115), sides=12) for n in range(4)]
    welts = [at_box(0.05, 0.008, 0.0014, (s * 0.06, -0.07, 0.0115)) for s in (-1, 1)]
    dark = plain(tint_color(color, 0.55))
    return put_down(
        [
            (
                body,
                textures.fabric(
                    look.rng, color, tint_color(color, 1.2) if look.chance(0.4) else None
                ),
            ),
            (back, plain(tint_color(color, 0.7))),
            (join([*edge, seam, *welts]), dark),
            (join(buttons), plain((230, 220, 196))),
        ],
        body,
        factor=k,
    )


def vest(look: Look) -> Shape:
    """A sleeveless vest lying flat."""
    color = look.color("white", "gray", "black", "navy", "yellow", "red")
    k = look.between(0.85, 1.05)
    half = [(0.0, -0.17), (0.105, -0.17), (0.1, 0.04), (0.075, 0.08), (0.07, 0.16), (0.045, 0.16),
            (0.04, 0.1), (0.0, 0.08)]  # fmt: skip
    body = plate(mirror(half), 0.009)
    hem = at_box(0.21, 0.01, 0.0098, (0, -0.163, 0))
    trims = [
        tube(
            smooth(
                [(s * 0.075, 0.158, 0.0085), (s * 0.075, 0.08, 0.0085), (s * 0.1, 0.04, 0.0085)], 4
            ),
            0.002,
            6,
        )
        for s in (-1, 1)
    ]
    trims.append(
        tube(
            smooth(
                [
                    (-0.042, 0.158, 0.0085),
                    (-0.038, 0.105, 0.0085),
                    (0, 0.083, 0.0085),
                    (0.038, 0.105, 0.0085),
                    (0.042, 0.158, 0.0085),
                ],
                4,
            ),
            0.002,
            6,
        )
    )
    return put_down(
        [(body, cloth(look, color)), (join([hem, *trims]), plain(tint_color(color, 0.8)))],
        body,
        factor=k,
    )


def bodysuit(look: Look) -> Shape:
    """A baby's bodysuit lying flat, snaps at the bottom."""
    color = look.color("white", "sky", "pink", "mint", "yellow", "cream", "lavender")
    k = look.between(0.85, 1.1)
    half = [
        (0.0, -0.115),
        (0.022, -0.112),
        (0.04, -0.07),
        (0.075, -0.04),
        (0.072, 0.05),
        (0.12, 0.035),
        (0.128, 0.075),
        (0.06, 0.11),
        (0.03, 0.11),
        (0.0, 0.092),
    ]
    body = plate(mirror(half), 0.009)
    snaps = [drum(0.004, 0.003, (0.012 * n, -0.106, 0.0085), sides=10) for n in (-1, 0, 1)]
    tone = look.own_color("coral", "teal", "navy", "mustard", "pink")
    x, y = 0.0, 0.01
    heart = [drum(0.013, 0.0012, (s * 0.009, y + 0.009, 0.0086), sides=18) for s in (-1, 1)]
    heart.append(
        plate(
            [(-0.021, y + 0.004), (x, y - 0.024), (0.021, y + 0.004), (x, y + 0.012)],
            0.0012,
            at=(0, 0, 0.0086),
        )
    )
    collar = tube(
        smooth([(-0.03, 0.108, 0.0085), (0, 0.092, 0.0088), (0.03, 0.108, 0.0085)], 5), 0.003, 6
    )
    return put_down(
        [
            (body, cloth(look, color)),
            (join(snaps), steel(look)),
            (join(heart), plain(tone)),
            (collar, plain(tint_color(color, 0.75))),
        ],
        body,
        factor=k,
    )


def braces(look: Look) -> Shape:
    """Elastic braces lying: two straps that meet behind, with clips."""
    color = look.color("red", "navy", "black", "green", "mustard", "gray")
    k = look.between(0.85, 1.1)
    straps = []
    for s in (-1, 1):
        path = [
            (0, 0.12, 0.002),
            (s * 0.02, 0.06, 0.0022),
            (s * 0.06, -0.02, 0.002),
            (s * 0.055, -0.11, 0.002),
        ]
        straps.append(tube(smooth(path, 5), 0.011, 8, squash=0.16))
    back = at_box(0.022, 0.08, 0.0035, (0, 0.155, 0))
    patch = plate([(-0.02, 0.12), (0, 0.095), (0.02, 0.12), (0, 0.145)], 0.0055)
    clips = [
        at_box(0.02, 0.028, 0.007, (x, y, 0))
        for x, y in ((-0.055, -0.122), (0.055, -0.122), (0, 0.205))
    ]
    slides = [at_box(0.027, 0.012, 0.0055, (s * 0.062, -0.04, 0)) for s in (-1, 1)]
    lines = textures.stripes([color, tint_color(color, 1.25), color], 3, upright=True)
    return put_down(
        [
            (join([*straps, back]), lines),
            (patch, plain((110, 72, 48))),
            (join([*clips, *slides]), steel(look)),
        ],
        *straps,
        back,
        join(clips[:2]),
        factor=k,
    )


CATEGORIES = (
    Category("waistcoat", waistcoat, (0.232, 0.318, 0.014), 0.3, ("suit vest", "gilet",
             "formal vest"),
             ("living",), ("flat", "big"), ("charcoal",)),
    Category("vest", vest, (0.201, 0.315, 0.00977), 0.12, ("tank top", "vest top", "undershirt",
             "sleeveless shirt", "singlet"),
             ("living",), ("flat", "big"), ("white",)),
    Category("bodysuit", bodysuit, (0.251, 0.221, 0.0113), 0.06,
             ("baby bodysuit", "babygro", "baby grow", "onesie", "baby onesie", "romper",
             "baby vest",
              "baby clothes"), ("living",), ("flat", "big"), ("white", "sky")),
    Category("braces", braces, (0.146, 0.344, 0.00678), 0.09, ("suspenders", "pair of braces",
             "pair of suspenders",
             "trouser braces"), ("living",), ("flat", "big"), ("red",)),
)  # fmt: skip
"""The module's categories."""
