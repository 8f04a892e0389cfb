"""Power tools: sanders, routers, guns, saws, small machines, their blades and discs."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    plastic,
    plate,
    shine,
    spindle,
    standing,
)
from ...build.outlines import rectangle
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, lathe, prism
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows, wide

BLACK = textures.plain((36, 36, 39))


BODIES = ("teal", "red", "green", "yellow", "blue", "orange")


def _sander(kind: str) -> Drawing:
    """A palm sander: a motor over a pad; round, square, pointed like an iron, or a belt."""

    def draw(look: Look) -> Pieces:
        tile = plastic(look, *BODIES)
        if kind == "belt":
            body = at_block(0.2, 0.085, 0.07, 0.02, (0, 0, 0.022))
            belt = (
                prism(rectangle(0.24, 0.044, 0.021, 8), -0.04, 0.04)
                .turn(0, np.pi / 2)
                .move(z=0.022)
            )
            grips = [
                rod(
                    [(0.02, 0, 0.09), (0.0, 0, 0.135), (-0.08, 0, 0.14), (-0.1, 0, 0.09)], 0.014, 10
                ),
                ball(0.045, 0.045, 0.05, (0.085, 0, 0.105), 14),
            ]
            return [
                (belt, dye(look, "brown", "maroon")),
                (body, tile),
                (grips[0], BLACK),
                (grips[1], BLACK),
            ]
        if kind == "mouse":
            outline = np.array(
                [(-0.06, -0.045), (0.0, -0.048), (0.075, 0.0), (0.0, 0.048), (-0.06, 0.045)]
            )
            pad, foam = plate(outline, 0.01, 0.003), plate(0.98 * outline, 0.0032)
            body = ball(0.15, 0.078, 0.075, (-0.01, 0, 0.045), 20)
            grip = ball(0.11, 0.06, 0.04, (-0.02, 0, 0.08), 16)
            vents = [at_box(0.003, 0.079, 0.016, (-0.05 + 0.008 * k, 0, 0.036)) for k in range(3)]
            return [
                (foam, dye(look, "brown")),
                (pad, BLACK),
                (body, tile),
                (grip, BLACK),
                (join(vents), BLACK),
            ]
        pad = (
            disc(0.062, 0.012, (0, 0, 0.003))
            if kind == "orbital"
            else at_block(0.11, 0.1, 0.012, 0.006, (0, 0, 0.003))
        )
        paper = disc(0.061, 0.0035) if kind == "orbital" else at_block(0.108, 0.098, 0.0035, 0.006)
        motor = standing(
            (0.05, 0.015), (0.045, 0.03), (0.04, 0.06), (0.046, 0.075), (0.044, 0.11), (0.03, 0.128)
        )
        cap = ball(0.088, 0.084, 0.05, (0, 0, 0.115), 20)
        bag = ball(0.09, 0.05, 0.05, (0.085, 0, 0.045), 14)
        cord = rod(
            [(-0.03, 0, 0.12), (-0.075, 0, 0.11), (-0.11, 0.02, 0.05), (-0.13, 0.03, 0.004)],
            0.004,
            8,
        )
        return [
            (paper, dye(look, "brown", "maroon")),
            (pad, BLACK),
            (motor, tile),
            (cap, BLACK),
            (bag, dye(look, "charcoal", "gray")),
            (cord, BLACK),
        ]

    return draw


def _router(look: Look) -> Pieces:
    """A router: a motor between two knobs on posts over a round base."""
    tile = plastic(look, *BODIES)
    base = lathe([(0.02, 0), (0.075, 0), (0.075, 0.01), (0.02, 0.01)], 36, loop=True)
    posts = [straight((s * 0.05, 0, 0.008), (s * 0.05, 0, 0.13), 0.006, 10) for s in (-1, 1)]
    motor = standing((0.034, 0.05), (0.042, 0.07), (0.042, 0.16), (0.036, 0.185), (0.02, 0.19))
    yoke = at_block(0.14, 0.06, 0.035, 0.02, (0, 0, 0.085))
    knobs = [ball(0.042, 0.042, 0.05, (s * 0.088, 0, 0.105), 14) for s in (-1, 1)]
    bit = spindle((0, 0.004), (0.05, 0.004)).turn(1, -np.pi / 2).move(z=0.005)
    collet = disc(0.013, 0.02, (0, 0, 0.034))
    return [
        (base, BLACK),
        (posts[0], shine(look)),
        (posts[1], shine(look)),
        (motor, tile),
        (yoke, tile),
        (knobs[0], BLACK),
        (knobs[1], BLACK),
        (collet, shine(look)),
        (bit.move(z=0.002), shine(look)),
    ]


def _planer(look: Look) -> Pieces:
    tile = plastic(look, *BODIES)
    sole = at_box(0.28, 0.085, 0.012)
    body = hull_solid(
        [
            (x, y, z)
            for y in (-0.042, 0.042)
            for x, z in ((-0.13, 0.012), (-0.12, 0.06), (0.05, 0.08), (0.12, 0.05), (0.13, 0.012))
        ]
    )
    grip = rod([(-0.1, 0, 0.06), (-0.1, 0, 0.115), (-0.03, 0, 0.13), (0.03, 0, 0.08)], 0.016, 10)
    knob = ball(0.045, 0.045, 0.05, (0.1, 0, 0.08), 14)
    return [(sole, shine(look)), (body, tile), (grip, BLACK), (knob, BLACK)]


def _pen(look: Look) -> Pieces:
    """A rotary tool lying: a slim body, a collar, a bit with a small wheel."""
    tile = plastic(look, "gray", "charcoal", *BODIES)
    z = 0.026
    body = spindle(
        (-0.095, 0.02), (-0.085, 0.026), (0.02, 0.025), (0.05, 0.018), (0.07, 0.0125), z=z
    )
    band = spindle((-0.03, 0.0268), (0.02, 0.0258), z=z)
    nose = spindle((0.07, 0.009), (0.088, 0.0075), z=z)
    bit = spindle((0.088, 0.0016), (0.11, 0.0016), z=z)
    wheel = spindle((0.106, 0.011), (0.109, 0.011), z=z)
    cord = rod(
        [(-0.09, 0, z), (-0.12, 0, 0.015), (-0.15, 0.02, 0.004), (-0.11, 0.05, 0.004)], 0.0036, 8, 5
    )
    return [
        (body, tile),
        (nose, shine(look)),
        (wheel, dye(look, "brown", "gray")),
        (cord, BLACK),
        (band, BLACK),
        (bit, shine(look)),
    ]


_row = Rows("workbench", ("teal", "red"), "lying", role=wide).of_drawing


CATEGORIES = (
    _row("orbital_sander", _sander("orbital"), (0.251, 0.119, 0.134), 1.2, ("sander",
             "electric sander", "palm sander", "random orbit sander"), bodies=5),
    _row("sheet_sander", _sander("sheet"), (0.265, 0.102, 0.142), 1.2, ("finishing sander",),
             bodies=5),
    _row("detail_sander", _sander("mouse"), (0.161, 0.0965, 0.1), 0.8, ("mouse sander",
             "corner sander"), bodies=4),
    _row("belt_sander", _sander("belt"), (0.24, 0.085, 0.155), 2.5, ("band sander",)),
    _row("plunge_router", _router, (0.22, 0.15, 0.19), 2.0, ("router tool", "wood router",
             "router machine", "trim router"), bodies=8),
    _row("electric_planer", _planer, (0.28, 0.085, 0.146), 2.0, ("planer", "power planer",
             "power plane")),
    _row("rotary_tool", _pen, (0.27, 0.08, 0.053), 0.6, ("dremel", "dremel tool", "engraver",
             "engraving tool", "engraving pen", "mini grinder", "die grinder",
             "dental handpiece"), ("gray",), 0.06, 4),
)  # fmt: skip
"""The module's categories."""
