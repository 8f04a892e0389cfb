"""Clothes that lie flat: shorts, briefs, bras, swimsuits."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import at_box, plate
from ...build.outlines import smooth
from ...build.recipes import ball, put_down
from ...build.shape import Shape
from ...build.solids import join, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile, plain

CLOTH = ("navy", "red", "gray", "teal", "black", "pink", "sky", "green", "white")


def cloth(look: Look, color: RGB) -> Tile:
    """Return cloth: plain, striped or checked."""
    kind = look.pick([0, 0, 1, 2])
    if kind == 1:
        return textures.stripes([color, color, tint_color(color, 1.5)], 7, upright=look.chance(0.5))
    return textures.fabric(look.rng, color, tint_color(color, 1.45) if kind == 2 else None)


def mirror(half: list[tuple[float, float]]) -> np.ndarray:
    """Return an outline from its right half, given from the bottom up."""
    right = np.array(half, float)
    left = right[::-1] * [-1, 1]
    return np.concatenate([right, left[np.abs(left[:, 0]) > 1e-9]])


def shorts(look: Look) -> Shape:
    """Shorts lying flat, with a waistband and a drawstring."""
    color = look.color(*CLOTH)
    k, leg = look.between(0.9, 1.1), look.between(0.9, 1.15)
    rim = mirror([(0.0, -0.03), (0.018, -0.115 * leg), (0.125, -0.1 * leg), (0.1, 0.085)])
    body = plate(rim, 0.012)
    band = at_box(0.2, 0.022, 0.0135, (0, 0.078, 0))
    seam = at_box(0.003, 0.11, 0.001, (0, 0.022, 0.0118))
    hems = [plate([(s * 0.0165, -0.104 * leg), (s * 0.018, -0.115 * leg), (s * 0.125, -0.1 * leg),
                 (s * 0.1225, -0.088 * leg)], 0.013) for s in (-1, 1)]  # fmt: skip
    cords = [
        tube(
            smooth(
                [(s * 0.004, 0.078, 0.0145), (s * 0.014, 0.05, 0.0142), (s * 0.01, 0.03, 0.0142)], 4
            ),
            0.0018,
            6,
        )
        for s in (-1, 1)
    ]
    dark = plain(tint_color(color, 0.65))
    return put_down(
        [
            (body, cloth(look, color)),
            (join([band, *hems]), plain(tint_color(color, 0.85))),
            (seam, dark),
            (join(cords), plain((240, 238, 230))),
        ],
        body,
        band,
        factor=k,
    )


def briefs(look: Look) -> Shape:
    """Underpants lying flat."""
    color = look.color("white", "pink", "gray", "black", "sky", "red", "lavender")
    k = look.between(0.9, 1.1)
    rim = mirror([(0.0, -0.075), (0.026, -0.07), (0.05, -0.02), (0.115, 0.03), (0.105, 0.075)])
    body = plate(rim, 0.008)
    band = plate([(-0.105, 0.06), (0.105, 0.06), (0.104, 0.08), (-0.104, 0.08)], 0.0105)
    edge = [
        tube(
            smooth(
                [(s * 0.026, -0.07, 0.0075), (s * 0.05, -0.02, 0.0075), (s * 0.114, 0.029, 0.0075)],
                4,
            ),
            0.0022,
            6,
        )
        for s in (-1, 1)
    ]
    trim = plain(tint_color(color, 0.75) if sum(color) > 260 else (210, 210, 214))
    return put_down([(body, cloth(look, color)), (join([band, *edge]), trim)], body, band, factor=k)


def bra(look: Look) -> Shape:
    """A bra lying: two cups, straps and a band."""
    color = look.color("white", "black", "pink", "red", "lavender", "beige", "teal")
    k = look.between(0.9, 1.1)
    cups = [ball(0.105, 0.1, 0.075, (s * 0.056, 0, 0.002), 20) for s in (-1, 1)]
    band = at_box(0.3, 0.034, 0.006, (0, -0.028, 0))
    straps = [
        tube(
            smooth(
                [
                    (s * 0.07, 0.03, 0.026),
                    (s * 0.075, 0.09, 0.004),
                    (s * 0.1, 0.12, 0.004),
                    (s * 0.14, 0.06, 0.004),
                    (s * 0.142, -0.02, 0.004),
                ],
                5,
            ),
            0.0055,
            8,
            squash=0.5,
        )
        for s in (-1, 1)
    ]
    bow = [ball(0.014, 0.01, 0.008, (s * 0.007, -0.02, 0.02), 8) for s in (-1, 1)]
    lace = [
        tube(
            smooth(
                [
                    (s * (0.056 - 0.05 * np.cos(a)), 0.046 * np.sin(a), 0.012)
                    for a in np.linspace(0.2, np.pi - 0.2, 7)
                ],
                3,
            ),
            0.003,
            6,
        )
        for s in (-1, 1)
    ]
    trim = plain(tint_color(color, 0.7) if sum(color) > 240 else (120, 120, 126))
    return put_down(
        [
            (join([*cups, band]), textures.speckles(look.rng, color, 4)),
            (join([*straps, *bow, *lace]), trim),
        ],
        *cups,
        band,
        *straps,
        factor=k,
    )


def swimsuit(look: Look) -> Shape:
    """A one-piece swimsuit lying flat."""
    color = look.color("navy", "red", "teal", "pink", "black", "yellow")
    k = look.between(0.85, 1.1)
    half = [
        (0.0, -0.15),
        (0.022, -0.145),
        (0.05, -0.09),
        (0.088, -0.05),
        (0.068, 0.02),
        (0.075, 0.06),
        (0.05, 0.085),
        (0.056, 0.14),
        (0.042, 0.14),
        (0.036, 0.08),
        (0.0, 0.055),
    ]
    body = plate(mirror(half), 0.008)
    belt = plate([(-0.0715, 0.0), (0.0715, 0.0), (0.0695, 0.016), (-0.0695, 0.016)], 0.0088)
    return put_down(
        [(body, cloth(look, color)), (belt, plain(look.own_color("white", "yellow", "navy")))],
        body,
        factor=k,
    )


def bikini(look: Look) -> Shape:
    """A bikini lying: a top with ties above a bottom."""
    color = look.color("red", "yellow", "turquoise", "pink", "navy", "orange")
    k = look.between(0.9, 1.1)
    cups = [plate([(s * 0.004, 0.03), (s * 0.085, 0.03), (s * 0.05, 0.1)], 0.01) for s in (-1, 1)]
    band = tube(
        smooth([(-0.14, 0.036, 0.003), (0, 0.03, 0.003), (0.14, 0.036, 0.003)], 5), 0.003, 8
    )
    ties = [
        tube(
            smooth(
                [(s * 0.05, 0.095, 0.003), (s * 0.045, 0.13, 0.003), (s * 0.02, 0.15, 0.003)], 4
            ),
            0.0025,
            8,
        )
        for s in (-1, 1)
    ]
    rim = mirror([(0.0, -0.1), (0.02, -0.096), (0.04, -0.05), (0.085, -0.025), (0.082, 0.0)])
    low = plate(rim, 0.008)
    knots = [
        tube(
            smooth(
                [(s * 0.083, -0.012, 0.004), (s * 0.105, -0.02, 0.004), (s * 0.11, -0.045, 0.003)],
                4,
            ),
            0.0025,
            8,
        )
        for s in (-1, 1)
    ]
    return put_down([(join([*cups, low]), cloth(look, color)), (join([band, *ties, *knots]),
                     plain(tint_color(color, 0.75)))], *cups, low, band, factor=k)  # fmt: skip


CATEGORIES = (
    Category("shorts", shorts, (0.244, 0.202, 0.0157), 0.15,
             ("pair of shorts", "boxer shorts", "swimming trunks", "swim shorts", "trunks",
             "swim trunks",
              "running shorts", "boxers"), ("living",), ("flat", "big"), ("navy", "red")),
    Category("briefs", briefs, (0.235, 0.158, 0.0107), 0.05,
             ("underpants", "knickers", "panties", "underwear", "pair of knickers"),
             ("living",), ("flat", "big"), ("white",)),
    Category("bra", bra, (0.295, 0.172, 0.0388), 0.08, ("brassiere", "sports bra"), ("living",),
             ("big",), ("white", "pink")),
    Category("swimsuit", swimsuit, (0.177, 0.291, 0.00883), 0.12,
             ("swimming costume", "bathing suit", "one-piece swimsuit", "leotard"),
             ("living",), ("flat", "big"), ("navy", "red")),
    Category("bikini", bikini, (0.289, 0.26, 0.0103), 0.08, ("bikini top", "two-piece swimsuit"),
             ("living",), ("flat", "big"), ("red",)),
)  # fmt: skip
"""The module's categories."""
