"""Boxes, urns, trees of wire, cards on show, small tanks."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    dye,
    hull_solid,
    metal,
    of,
    plastic,
    plate,
    shine,
    standing,
)
from ...build.recipes import Pieces, ball, rod
from ...build.solids import join, torus
from ...surfaces import glazes, prints, textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _humid(look: Look) -> Pieces:
    """A diffuser or humidifier: a soft drop with a seam and a wisp of mist."""
    color = look.color("white", "wooden", "cream", "sky", "sage")
    low = standing((0.05, 0), (0.056, 0.01), (0.058, 0.05))
    high = standing((0.058, 0.052), (0.05, 0.09), (0.026, 0.125), (0.012, 0.135))
    ring = standing((0.0585, 0.046), (0.0585, 0.054))
    mist = [
        ball(
            0.016 + 0.006 * k,
            0.014 + 0.005 * k,
            0.02,
            (0.006 * (-1) ** k, 0, 0.142 + 0.013 * k),
            10,
        )
        for k in range(3)
    ]
    return [
        (low, look.surface(color, "plastic")),
        (high, dye(look, "white", "cream")),
        (ring, dye(look, "gray", "gold")),
        (join(mist), textures.plain((236, 240, 244))),
    ]


def _urn(look: Look) -> Pieces:
    """A lidded urn on a foot with two handles."""
    color = look.color("brown", "navy", "gold", "teal", "white", "charcoal")
    tile = (
        glazes.glaze_tile(look, color)
        if look.chance(0.5)
        else metal(look, "brass", "bronze", "silver")
    )
    body = standing(
        (0.04, 0),
        (0.04, 0.01),
        (0.022, 0.022),
        (0.055, 0.07),
        (0.07, 0.11),
        (0.06, 0.145),
        (0.036, 0.165),
    )
    lid = standing(
        (0.042, 0.165), (0.04, 0.172), (0.02, 0.188), (0.008, 0.192), (0.012, 0.202), (0.004, 0.21)
    )
    grips = [
        rod(
            [(s * 0.062, 0, 0.13), (s * 0.09, 0, 0.135), (s * 0.09, 0, 0.1), (s * 0.066, 0, 0.085)],
            0.006,
            8,
        )
        for s in (-1, 1)
    ]
    return [(body, tile), (lid, tile), (join(grips), dye(look, "gold", "brown"))]


def _heartbox(look: Look) -> Pieces:
    """A heart-shaped box, a bow on its lid."""
    t = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    outline = (
        np.column_stack(
            [
                16 * np.sin(t) ** 3,
                13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t),
            ]
        )
        * 0.0052
    )
    body, lid = plate(0.97 * outline, 0.03), plate(outline, 0.018, 0.026)
    bow = [ball(0.05, 0.022, 0.012, (s * 0.024, 0.004, 0.047), 12).turn(2, 0.0) for s in (-1, 1)]
    knot = ball(0.014, 0.016, 0.014, (0, 0.004, 0.048), 10)
    band = at_box(0.012, 0.12, 0.0012, (0, -0.012, 0.0436))
    return [
        (body, tile := plastic(look, "red", "pink", "crimson", "purple")),
        (lid, tile),
        (join([*bow, knot]), ribbon := dye(look, "white", "gold", "pink")),
        (band, ribbon),
    ]


def _cat(look: Look) -> Pieces:
    """A lucky cat with a raised paw, a red collar and a gold coin."""
    coat = plastic(look, "white", "gold", "black", "red")
    body = standing((0.032, 0), (0.04, 0.012), (0.036, 0.05), (0.022, 0.07))
    head = ball(0.07, 0.06, 0.058, (0, -0.004, 0.09), 20)
    ears = [
        hull_solid(
            [
                (s * 0.03, -0.008, 0.105),
                (s * 0.012, -0.008, 0.112),
                (s * 0.022, 0.006, 0.108),
                (s * 0.028, -0.004, 0.13),
            ]
        )
        for s in (-1, 1)
    ]
    paw = rod(
        [(0.032, -0.01, 0.055), (0.05, -0.016, 0.085), (0.046, -0.02, 0.118)],
        [0.012, 0.011, 0.014],
        10,
    )
    arm = rod(
        [(-0.032, -0.012, 0.055), (-0.036, -0.034, 0.035), (-0.012, -0.042, 0.036)],
        [0.012, 0.011, 0.01],
        10,
    )
    collar = torus(0.026, 0.004, 26, 6).move(0, -0.002, 0.066)
    coin = at_block(0.022, 0.03, 0.004, 0.01).turn(0, np.pi / 2).move(0.0, -0.041, 0.034)
    eyes = [ball(0.011, 0.004, 0.005, (s * 0.014, -0.0325, 0.096), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.004, 0.004, (0, -0.0345, 0.087), 8)
    feet = [ball(0.022, 0.028, 0.016, (s * 0.02, -0.032, 0.007), 10) for s in (-1, 1)]
    return [
        (body, coat),
        (head, coat),
        (join(feet), coat),
        (paw, coat),
        (arm, coat),
        (join(ears), coat),
        (collar, textures.plain((206, 36, 40))),
        (coin, shine(look, "gold")),
        (join(eyes), BLACK),
        (nose, textures.plain((230, 120, 130))),
    ]


def _wiretree(look: Look) -> Pieces:
    """A tree of twisted wire with bead leaves on a stone."""
    wire = metal(look, "copper", "gold", "silver", "bronze")
    rock = ball(0.08, 0.06, 0.036, (0, 0, 0.01), 12)
    trunk = rod([(0, 0, 0.02), (0.006, 0.0, 0.06), (-0.004, 0, 0.095)], [0.011, 0.008, 0.007], 10)
    boughs, leaves = [], []
    for k in range(11):
        a, r, z = 2.4 * k, 0.03 + 0.03 * ((k * 7) % 11) / 11, 0.12 + 0.05 * (k / 11)
        tip = (r * np.cos(a), r * np.sin(a), z)
        boughs.append(
            rod([(-0.003, 0, 0.085), (0.4 * tip[0], 0.4 * tip[1], 0.5 * z + 0.045), tip], 0.0022, 6)
        )
        leaves += [
            ball(
                0.013,
                0.013,
                0.01,
                (
                    tip[0] + 0.011 * np.cos(n * 1.6),
                    tip[1] + 0.011 * np.sin(n * 1.6),
                    z + 0.004 * (n % 2),
                ),
                7,
            )
            for n in range(4)
        ]
    return [
        (rock, dye(look, "gray", "charcoal", "beige")),
        (trunk, wire),
        (join(boughs), wire),
        (join(leaves), dye(look, "green", "pink", "teal", "purple", "amber")),
    ]


def _vitrine(look: Look) -> Pieces:
    """A trading card in a clear case on a stand."""
    color = look.color("blue", "red", "green", "gold", "purple")
    image = prints.canvas(80, 112, color)
    prints.fill(image, 0.06, 0.04, 0.88, 0.92, (246, 240, 220))
    image[14:66, 10:70] = textures.fit(prints.artwork(look.rng, 60, 52), 52, 60)
    prints.lines(image, look.rng, (0.14, 0.66, 0.72, 0.24), 4, (110, 110, 116))
    tilt = -0.2
    case = at_block(0.086, 0.126, 0.008, 0.004).turn(0, np.pi / 2 + tilt)
    card = at_box(0.07, 0.1, 0.001, (0, 0, 0.0078)).turn(0, np.pi / 2 + tilt)
    low = float(case.bounds[0, 2])
    foot = at_box(0.06, 0.05, 0.01, (0, 0.012, 0))
    return [
        (case.move(z=-low + 0.004), textures.plain((206, 222, 230))),
        (foot, BLACK),
        (card.move(z=-low + 0.004), image),
    ]


_row = Rows("living", ("red", "blue")).of_shape


CATEGORIES = (
    _row("humidifier", of(_humid, bodies=2), (0.117, 0.117, 0.18), 0.5, (
             "mist diffuser", "scent diffuser", "essential oil diffuser", "air purifier",
             "diffuser", "dehumidifier"), ("white",)),
    _row("urn", of(_urn, bodies=2), (0.208, 0.147, 0.22), 1.0, ("funeral urn", "lidded urn",
             "ginger jar", "cremation urn", "grecian urn"), ("brown", "navy"),
             ("tall",)),
    _row("heart_box", of(_heartbox, bodies=2), (0.167, 0.151, 0.055), 0.2, ("heart shaped box",
             "heart-shaped box", "box of valentine chocolates", "heart shaped chocolate box",
             "valentine box"), ("red",)),
    _row("lucky_cat", of(_cat, bodies=5), (0.1, 0.09, 0.13), 0.3, ("maneki neko", "maneki-neko",
             "beckoning cat", "waving cat", "fortune cat", "chinese lucky cat"), ("white", "gold")),
    _row("wire_tree", of(_wiretree, bodies=3), (0.115, 0.123, 0.172), 0.3, ("gem tree",
             "copper tree", "crystal tree", "money tree ornament", "jewelry tree",
             "jewellery tree", "tree ornament sculpture"), ("copper",), ("tall",)),
    _row("card_display", of(_vitrine), (0.086, 0.055, 0.13), 0.1, ("sports card case",
             "graded card", "card slab"), ("blue",)),
)  # fmt: skip
"""The module's categories."""
