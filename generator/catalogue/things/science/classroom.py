"""Models of planets, drawing aids, cubes and puzzles of the classroom."""

from __future__ import annotations

import numpy as np

from ...build.making import at_block, disc, hull_solid, metal, plate, standing
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, straight
from ...build.solids import join, lathe
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows, tall

BLACK = textures.plain((34, 34, 37))


def _vane(look: Look) -> Pieces:
    """A weather vane: a cockerel and an arrow over crossed letters on a foot."""
    tile = metal(look, "black", "copper", "charcoal", "bronze")
    foot, post = (
        standing((0.05, 0), (0.048, 0.008), (0.012, 0.016)),
        straight((0, 0, 0.01), (0, 0, 0.2), 0.004, 10),
    )
    cross = [
        straight((-0.06, 0, 0.11), (0.06, 0, 0.11), 0.0026, 8),
        straight((0, -0.06, 0.11), (0, 0.06, 0.11), 0.0026, 8),
    ]
    ends = [
        ball(0.014, 0.014, 0.014, p, 8)
        for p in ((-0.06, 0, 0.11), (0.06, 0, 0.11), (0, -0.06, 0.11), (0, 0.06, 0.11))
    ]
    arrow = [
        straight((-0.09, 0, 0.17), (0.07, 0, 0.17), 0.003, 8),
        hull_solid(
            [
                (0.07, 0, 0.185),
                (0.07, 0, 0.155),
                (0.1, 0, 0.17),
                (0.07, 0.002, 0.17),
                (0.07, -0.002, 0.17),
            ]
        ),
    ]
    bird = smooth(
        [
            (-0.075, 0.245),
            (-0.08, 0.215),
            (-0.05, 0.2),
            (-0.03, 0.185),
            (0.02, 0.185),
            (0.035, 0.21),
            (0.035, 0.24),
            (0.05, 0.245),
            (0.035, 0.262),
            (0.02, 0.255),
            (0.01, 0.225),
            (-0.02, 0.215),
            (-0.045, 0.235),
            (-0.055, 0.262),
        ],
        4,
    )
    cock = plate(bird, 0.003).turn(0, np.pi / 2).move(y=0.0015)
    return [
        (foot, tile),
        (post, tile),
        *((c, tile) for c in cross),
        (join(ends), tile),
        (join(arrow), tile),
        (cock, tile),
    ]


def _sundial(look: Look) -> Pieces:
    color = look.color("bronze", "gray", "brass", "beige", "copper")
    image = prints.canvas(128, 128, color)
    dark = tint_color(color, 0.45)
    prints.disc(image, 0.5, 0.5, 0.47, dark, 0.45)
    for k in range(13):
        a = np.pi * (k / 12)
        prints.stroke(
            image,
            [
                (0.5 + 0.16 * np.cos(a), 0.55 - 0.16 * np.sin(a)),
                (0.5 + 0.36 * np.cos(a), 0.55 - 0.36 * np.sin(a)),
            ],
            0.01,
            dark,
        )
        prints.write(
            image,
            str((k + 5) % 12 + 1),
            0.5 - 0.41 * np.cos(a),
            0.55 - 0.41 * np.sin(a),
            0.07,
            dark,
        )
    tile = look.surface(color, "metal")
    foot = standing((0.06, 0), (0.05, 0.014), (0.04, 0.03), (0.075, 0.046), (0.08, 0.056), sides=36)
    face = disc(0.076, 0.001, (0, 0, 0.0556), sides=36)
    fin = hull_solid(
        [
            (x, y, z)
            for x in (-0.002, 0.002)
            for y, z in ((-0.02, 0.056), (0.05, 0.056), (0.05, 0.11))
        ]
    )
    return [(foot, tile), (fin, tile), (face, image)]


def _planet(look: Look) -> Pieces:
    """A ringed planet on a stand."""
    color = look.color("tan", "orange", "teal", "purple", "terracotta")
    bands = textures.stripes(
        [color, tint_color(color, 1.3), tint_color(color, 0.85), color, tint_color(color, 1.15)], 2
    )
    foot = standing((0.035, 0), (0.034, 0.006), (0.006, 0.012), (0.005, 0.04))
    globe = ball(0.08, 0.08, 0.08, (0, 0, 0), 26).turn(1, 0.4).move(z=0.075)
    ring = (
        lathe([(0.05, -0.001), (0.075, -0.001), (0.075, 0.001), (0.05, 0.001)], 44, loop=True)
        .turn(1, 0.4)
        .move(z=0.075)
    )
    return [(foot, BLACK), (globe, bands), (ring, textures.plain(tint_color(color, 1.5)))]


def _sphere(look: Look) -> Pieces:
    """A planisphere: a star disc in a card sleeve with an oval window."""
    image = prints.canvas(128, 128, (24, 34, 78))
    for _ in range(90):
        prints.disc(
            image,
            look.between(0.1, 0.9),
            look.between(0.1, 0.9),
            look.between(0.004, 0.01),
            (232, 236, 246),
        )
    card = prints.canvas(128, 128, look.color("navy", "teal", "purple", "black"))
    base = at_block(0.2, 0.2, 0.003, 0.02)
    rim = disc(0.095, 0.0008, (0, 0, 0.0028), sides=44)
    ringed = prints.canvas(96, 96, (240, 236, 220))
    for k in range(36):
        a = k * np.pi / 18
        prints.disc(ringed, 0.5 + 0.46 * np.cos(a), 0.5 + 0.46 * np.sin(a), 0.012, (60, 60, 70))
    window = disc(0.08, 0.0008, (0, 0, 0.0033), sides=44)
    return [(base, card), (rim, ringed), (window, image)]


_row = Rows("office", ("brass",), role=tall).of_drawing


CATEGORIES = (
    _row("weather_vane", _vane, (0.2, 0.13, 0.265), 0.6, ("weathervane", "wind vane",
             "weathercock"), ("black",)),
    _row("sundial", _sundial, (0.16, 0.16, 0.11), 0.9, ("sun dial", "brass sundial"), ("bronze",),
             bodies=2),
    _row("planet_model", _planet, (0.14, 0.15, 0.115), 0.2, ("model planet", "saturn model",
             "planet", "model of saturn", "moon globe", "mars globe"), ("tan",)),
    _row("planisphere", _sphere, (0.2, 0.2, 0.0041), 0.06, ("star wheel", "star finder",
             "colour wheel", "color wheel"), ("navy",)),
)  # fmt: skip
"""The module's categories."""
