"""Hand tools with a flat, hollow or wiry head."""

from __future__ import annotations

import numpy as np

from ...build.outlines import rectangle, smooth
from ...build.recipes import Pieces
from ...build.settled import limb
from ...build.solids import cylinder, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .implements import row, steel, with_handle


def _swatter(look: Look, color: RGB, z: float) -> Pieces:
    plate = prism(rectangle(0.11, 0.1, 0.02), 0, 0.0022).move(-0.055, 0, z - 0.001)
    return [(plate, prints.mesh_holes(tint_color(color, 1.15), tint_color(color, 0.5), 12, 12))]


def _spork(look: Look, color: RGB, z: float) -> Pieces:
    outline = np.array([(0.012, -0.004), (0.012, 0.004), (-0.012, 0.018), (-0.034, 0.02),
                        (-0.052, 0.016), (-0.041, 0.0105), (-0.056, 0.0055), (-0.043, 0),
                        (-0.056, -0.0055), (-0.041, -0.0105), (-0.052, -0.016), (-0.034, -0.02),
                        (-0.012, -0.018)])  # fmt: skip
    head = prism(outline, 0, 0.002).bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + 9 * p[:, 1] ** 2 + 2.5 * (p[:, 0] + 0.02) ** 2]
        )
    )
    return [(head.move(z=z - 0.006), textures.plain(color))]


def _leaf_plate(look: Look, color: RGB, z: float) -> Pieces:
    plate = prism(
        smooth(
            [
                (0, -0.006),
                (0, 0.006),
                (-0.03, 0.024),
                (-0.08, 0.02),
                (-0.1, 0),
                (-0.08, -0.02),
                (-0.03, -0.024),
            ],
            3,
        ),
        0,
        0.002,
    )
    holes = [
        cylinder(0.002 + 0.0006 * n, 0.0006, 12).move(
            -0.025 - 0.016 * (n % 4), (n // 4 - 0.5) * 0.02, 0.0017
        )
        for n in range(8)
    ]
    return [
        (plate.move(z=z - 0.001), steel(look)),
        (join([h.move(z=z - 0.001) for h in holes]), textures.plain((30, 30, 34))),
    ]


def _separator(look: Look, color: RGB, z: float) -> Pieces:
    cup = lathe(
        [(0, -0.018), (0.02, -0.014), (0.033, 0.004), (0.031, 0.004), (0.019, -0.012), (0, -0.016)],
        24,
    ).move(-0.034, 0, z)
    slots = [
        torus(0.026, 0.0018, 30, 5).move(-0.034, 0, z - 0.003),
        torus(0.017, 0.0012, 24, 5).move(-0.034, 0, z - 0.0115),
    ]
    return [
        (cup, textures.plain(tint_color(color, 1.2))),
        (join(slots), textures.plain((30, 30, 32))),
    ]


def _balloon(look: Look, color: RGB, z: float) -> Pieces:
    """Return the tube and tip of a baster."""
    pipe = (
        lathe([(0, 0), (0.011, 0), (0.0115, 0.13), (0.004, 0.17), (0.003, 0.2), (0, 0.2)], 18)
        .turn(1, -np.pi / 2)
        .move(0.0, 0, z)
    )
    image = prints.canvas(96, 24, (214, 226, 230))
    for n in range(9):
        prints.fill(image, 0.1, 0.08 + 0.07 * n, 0.4, 0.02, (70, 80, 90))
    return [(pipe, textures.fit(image, 64, 64))]


def _jaw(look: Look, color: RGB, z: float) -> Pieces:
    ring = lathe([(0.026, 0), (0.032, 0), (0.032, 0.016), (0.026, 0.016)], 26, loop=True).move(
        -0.03, 0, z - 0.008
    )
    teeth = [
        cylinder(0.003, 0.016, 5).move(-0.03 + 0.026 * np.cos(a), 0.026 * np.sin(a), z - 0.008)
        for a in np.arange(14) * 0.449
    ]
    return [(join([ring, *teeth]), textures.plain((44, 44, 48)))]


def _curl(look: Look, color: RGB, z: float) -> Pieces:
    loop = tube(
        smooth(
            [
                (0, -0.004, z),
                (-0.02, -0.018, z),
                (-0.05, -0.016, z),
                (-0.062, 0, z),
                (-0.05, 0.016, z),
                (-0.02, 0.018, z),
                (0, 0.004, z),
            ],
            4,
        ),
        0.0022,
        7,
    )
    return [(loop, steel(look))]


def _matcha(look: Look, color: RGB, z: float) -> Pieces:
    tines = [limb([(0, 0.011 * np.cos(a), z + 0.011 * np.sin(a)), (-0.03, 0.02 * np.cos(a),
        z + 0.02 * np.sin(a)), (-0.06, 0.024 * np.cos(a), z + 0.024 * np.sin(a)),
                   (-0.068, 0.019 * np.cos(a), z + 0.019 * np.sin(a))],
                   [0.0016, 0.0014, 0.001, 0.0008],
                   4) for a in 2 * np.pi * np.arange(24) / 24]  # fmt: skip
    thread = torus(0.0125, 0.0018, 18, 6).turn(1, np.pi / 2).move(-0.004, 0, z)
    return [(join(tines), textures.plain((226, 202, 140))), (thread, textures.plain((40, 34, 34)))]


def _spatula_scraper(look: Look, color: RGB, z: float) -> Pieces:
    return [
        (
            prism(rectangle(0.09, 0.06, 0.012), 0, 0.006).move(-0.045, 0, z - 0.003),
            textures.plain(tint_color(color, 1.2)),
        )
    ]


CATEGORIES = (
    row("fly_swatter", with_handle(_swatter, (0.09, 0.12), 0.2, ("red", "blue", "green", "yellow",
        "pink")), 0.04, (0.427, 0.102, 0.0203), "fly swat", "fly-swatter", "swatter"),
    row("spork", with_handle(_spork, (0.08, 0.1), 0.0, ("red", "blue", "green", "orange", "gray",
                                                     "black"), 0.0055), 0.015,
                                                     (0.149, 0.0405, 0.013), "camping spork",
                                                     "plastic spork",
         "titanium spork"),
    row("herb_stripper", with_handle(_leaf_plate, (0.05, 0.07), 0.01), 0.05, (0.173, 0.0499,
    0.0211),
         "herb peeler", "kale stripper"),
    row("egg_separator", with_handle(_separator, (0.06, 0.08), 0.0, ("white", "yellow", "red",
        "green", "sky"), 0.006), 0.03, (0.132, 0.065, 0.024), "yolk separator"),
    row("turkey_baster", with_handle(_balloon, (0.06, 0.07), 0.0, ("red", "black", "blue", "orange",
        "gray"), 0.02), 0.08, (0.264, 0.0453, 0.0444), "baster", "meat baster"),
    row("jar_opener", with_handle(_jaw, (0.11, 0.14), 0.0, r=0.01), 0.12, (0.187, 0.0634, 0.0223),
         "lid opener", "bottle grip", "jar wrench"),
    row("butter_curler", with_handle(_curl, (0.08, 0.1), 0.04), 0.04, (0.2, 0.0434, 0.0209),
         "butter scraper"),
    row("matcha_whisk", with_handle(_matcha, (0.04, 0.05), 0.0, ("wooden", "tan", "cream"), 0.013),
         0.02, (0.115, 0.0511, 0.0501), "bamboo whisk", "chasen", "tea whisk"),
    row("dough_scraper", with_handle(_spatula_scraper, (0.1, 0.13), 0.0), 0.06,
         (0.204, 0.0601, 0.0201), "bowl scraper", "silicone scraper", "jar spatula",
         "dish scraper"),
)  # fmt: skip
"""The module's categories."""
