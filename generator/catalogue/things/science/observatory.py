"""Instruments of the sky, the weather and the classroom."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plastic,
    shine,
    standing,
    wood,
)
from ...build.outlines import arc
from ...build.recipes import Pieces, straight
from ...build.solids import join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows, tall

BLACK = textures.plain((34, 34, 37))


BRASS = ("brass", "gold", "bronze")


def _dial(look: Look, title: str, hands: int = 1) -> textures.Tile:
    """The face of a meter: marks, a word, a hand."""
    image = prints.canvas(96, 96, (246, 242, 228))
    for k in range(25):
        a = np.pi * 1.25 - k * np.pi * 1.5 / 24
        prints.disc(
            image,
            0.5 + 0.42 * np.cos(a),
            0.5 - 0.42 * np.sin(a),
            0.016 if k % 4 else 0.03,
            (40, 40, 44),
        )
    prints.write(image, title, 0.5, 0.7, 0.1, (60, 50, 40), True)
    for _ in range(hands):
        a = look.between(0.2, 2.9)
        prints.stroke(
            image,
            [
                (0.5 - 0.08 * np.cos(a), 0.5 + 0.08 * np.sin(a)),
                (0.5 + 0.34 * np.cos(a), 0.5 - 0.34 * np.sin(a)),
            ],
            0.03,
            (170, 40, 34),
        )
    prints.disc(image, 0.5, 0.5, 0.04, (60, 60, 64))
    return image


def _meter(title: str) -> Drawing:
    """A round meter in a brass ring, standing on a wooden foot."""

    def draw(look: Look) -> Pieces:
        tile, case = metal(look, *BRASS), wood(look, "brown", "wooden", "maroon")
        foot = at_block(0.13, 0.06, 0.022, 0.01)
        body = disc(0.055, 0.03).turn(0, np.pi / 2).move(0, 0.015, 0.072)
        rim = torus(0.054, 0.005, 36, 8).turn(0, np.pi / 2).move(0, -0.015, 0.072)
        face = disc(0.051, 0.001).turn(0, np.pi / 2).move(0, -0.0146, 0.072)
        return [(foot, case), (body, tile), (rim, tile), (face, _dial(look, title))]

    return draw


def _sextant(look: Look) -> Pieces:
    """A sextant lying: a sector frame with a scale, an arm, a telescope, mirrors."""
    tile = metal(look, *BRASS)
    curve = tube(
        [(*p, 0.012) for p in arc((0, 0.09), 0.17, -np.pi / 2 - 0.55, -np.pi / 2 + 0.55, 18)],
        0.008,
        8,
    )
    spokes = [
        straight((0, 0.09, 0.012), (0.17 * np.cos(a), 0.09 + 0.17 * np.sin(a), 0.012), 0.005, 8)
        for a in (-np.pi / 2 - 0.53, -np.pi / 2 + 0.53)
    ]
    cross = straight((-0.05, 0.0, 0.012), (0.05, 0.0, 0.012), 0.004, 8)
    arm = at_block(0.014, 0.19, 0.006, 0.005, (0, -0.09, 0.018)).turn(2, 0.22).move(0, 0.09, 0)
    scope = straight((-0.06, 0.045, 0.035), (0.06, 0.03, 0.035), 0.012, 14)
    stand = [disc(0.006, 0.03, (x, 0.036, 0.005), sides=10) for x in (-0.02, 0.02)]
    mirrors = [
        at_box(0.03, 0.004, 0.03, (0, 0.09, 0.02)),
        at_box(0.024, 0.004, 0.026, (0.05, 0.04, 0.02)).turn(2, 0.1),
    ]
    feet = [disc(0.006, 0.012, (x, y, 0)) for x, y in ((-0.08, -0.05), (0.08, -0.05), (0, 0.09))]
    return [
        (curve, tile),
        *((s, tile) for s in spokes),
        (cross, tile),
        (arm, tile),
        (join(feet), tile),
        (scope, BLACK),
        (join(stand), tile),
        (join(mirrors), textures.plain((206, 222, 230))),
    ]


def _cups(look: Look) -> Pieces:
    """An anemometer: three cups turning on a post over a foot."""
    foot, post = disc(0.05, 0.014), standing((0.008, 0.014), (0.007, 0.17), sides=12)
    arms, bowls = [], []
    for a in np.arange(3) * 2.0944 + 0.4:
        arms.append(straight((0, 0, 0.178), (0.06 * np.cos(a), 0.06 * np.sin(a), 0.178), 0.003, 6))
        cup = lathe(
            [(0, 0), (0.014, 0.003), (0.022, 0.016), (0.02, 0.016), (0.012, 0.006), (0, 0.004)], 18
        ).turn(0, np.pi / 2)
        bowls.append(cup.turn(2, a).move(0.07 * np.cos(a), 0.07 * np.sin(a), 0.178))
    hub = disc(0.013, 0.018, (0, 0, 0.17))
    return [
        (foot, dye(look, "charcoal", "white", "black")),
        (post, shine(look)),
        (hub, BLACK),
        (join(arms), shine(look)),
        *((b, plastic(look, "black", "red", "white")) for b in bowls),
    ]


def _rain(look: Look) -> Pieces:
    """A rain gauge: a marked clear tube, some water in it, a funnel rim."""
    tubes = textures.stack(
        (textures.plain((120, 178, 220)), 3),
        (textures.grid((90, 100, 110), (222, 232, 236), 12, 0), 7),
    )
    body = standing((0.024, 0.006), (0.03, 0.16))
    rim = lathe(
        [(0.026, 0), (0.042, 0.025), (0.042, 0.032), (0.038, 0.032), (0.024, 0.006)], 28, loop=True
    ).move(z=0.15)
    foot = disc(0.042, 0.008)
    return [
        (foot, plastic(look, "green", "yellow", "black")),
        (body, tubes),
        (rim, plastic(look, "green", "yellow", "black")),
    ]


_row = Rows("office", ("brass",), role=tall).of_drawing


CATEGORIES = (
    _row("sextant", _sextant, (0.179, 0.18, 0.0481), 0.9, ("brass sextant", "octant",
             "marine sextant"), bodies=9),
    _row("barometer", _meter("RAIN  FAIR"), (0.13, 0.06, 0.131), 0.6, ("aneroid barometer",
             "weather station", "brass barometer"), bodies=2),
    _row("hygrometer", _meter("HUMIDITY"), (0.13, 0.06, 0.131), 0.5, ("humidity meter",
             "humidity gauge", "analog thermometer", "dial thermometer",
             "thermo hygrometer"), bodies=2),
    _row("anemometer", _cups, (0.16, 0.16, 0.2), 0.3, ("wind meter", "wind gauge",
             "wind speed meter"), ("black",)),
    _row("rain_gauge", _rain, (0.084, 0.084, 0.182), 0.15, ("rain meter",), ("green",)),
)  # fmt: skip
"""The module's categories."""
