"""For the studio and the desk: easels, colours, stencils, cutters, card files, lecterns."""

from __future__ import annotations

from ...build.making import (
    PAINTS,
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    metal,
    plastic,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.recipes import Pieces, rod, straight
from ...build.solids import join
from ...build.variants import at_rest
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 243, 240))


def _pans(look: Look) -> Pieces:
    """A watercolour box, open: two rows of pans, a lid behind, a brush."""
    case = metal(look, "black", "white", "silver", "red")
    body, lid = (
        at_block(0.19, 0.075, 0.014, 0.006),
        at_block(0.19, 0.075, 0.008, 0.006).turn(0, 1.1),
    )
    lid = lid.move(0, 0.055, 0.042)
    inner = at_block(0.178, 0.066, 0.001, 0.004, (0, 0, 0.0137))
    names = (
        "yellow",
        "orange",
        "red",
        "pink",
        "purple",
        "blue",
        "sky",
        "teal",
        "green",
        "lime",
        "brown",
        "black",
    )
    pieces: Pieces = [
        (body, case),
        (lid.move(z=-min(float(lid.bounds[0, 2]), 0.0)), case),
        (inner, WHITE),
    ]
    for k, name in enumerate(names):
        pieces.append(
            (
                at_block(
                    0.023,
                    0.019,
                    0.003,
                    0.003,
                    (-0.0725 + 0.029 * (k % 6), 0.019 - 0.024 * (k // 6), 0.0145),
                ),
                dye(look, name),
            )
        )
    brush = [
        spindle((-0.06, 0.0022), (0.03, 0.003), z=0.0185).move(y=-0.027),
        spindle((0.03, 0.0028), (0.05, 0.0006), z=0.0185).move(y=-0.027),
    ]
    return [*pieces, (brush[0], dye(look, "red", "black")), (brush[1], dye(look, "brown"))]


def _stencil(look: Look) -> Pieces:
    color = look.color("green", "blue", "orange", "yellow", "beige")
    image = prints.canvas(144, 96, color)
    hole = (246, 244, 238)
    kind = int(look.rng.integers(2))
    if kind:
        for k, letter in enumerate("ABCDEFGHIJKL"):
            prints.write(
                image, letter, 0.13 + 0.15 * (k % 6), 0.32 + 0.36 * (k // 6), 0.26, hole, True
            )
    else:
        for k in range(4):
            prints.disc(image, 0.16 + 0.225 * k, 0.3, 0.05 + 0.035 * k, hole)
            s = 0.06 + 0.03 * k
            prints.fill(image, 0.16 + 0.225 * k - s / 2, 0.74 - s * 0.75, s, 1.5 * s, hole)
    return [
        (at_block(0.2, 0.13, 0.0012, 0.006), textures.plain(color)),
        (at_box(0.19, 0.12, 0.0004, (0, 0, 0.001)), image),
    ]


def _screen(look: Look) -> Pieces:
    """A printing frame with mesh and a picture."""
    tile = wood(look, "wooden", "beige", "brown")
    sides = [at_box(0.26, 0.025, 0.022, (0, s * 0.1475, 0)) for s in (-1, 1)] + [
        at_box(0.025, 0.27, 0.022, (s * 0.1175, 0, 0)) for s in (-1, 1)
    ]
    image = textures.grid((222, 214, 190), (236, 230, 208), 32, 32).copy()
    color = look.own_color(*PAINTS)
    prints.disc(image, 0.5, 0.45, 0.26, color)
    prints.polygon(image, [(0.2, 0.85), (0.5, 0.3), (0.8, 0.85)], tint_color(color, 0.7))
    return [*((s, tile) for s in sides), (at_box(0.212, 0.272, 0.003, (0, 0, 0.002)), image)]


def _airbrush(look: Look) -> Pieces:
    steel = metal(look, "silver", "gold", "gray")
    z = 0.012
    body = spindle(
        (-0.08, 0.0055),
        (-0.075, 0.0085),
        (-0.02, 0.0085),
        (0.03, 0.0075),
        (0.05, 0.005),
        (0.062, 0.0022),
        z=z,
    )
    cup = standing((0.004, 0.018), (0.013, 0.028), (0.014, 0.042)).move(x=0.012)
    lever = rod([(-0.01, 0, 0.018), (-0.014, 0, 0.03), (-0.02, 0, 0.033)], 0.0028, 8)
    valve = at_block(0.012, 0.03, 0.014, 0.004, (-0.008, -0.018, 0.004))
    hose = rod(
        [
            (-0.008, -0.03, 0.01),
            (-0.01, -0.06, 0.005),
            (-0.05, -0.075, 0.004),
            (-0.09, -0.05, 0.004),
        ],
        0.0035,
        8,
        5,
    )
    return [(body, steel), (valve, steel), (hose, BLACK), (cup, steel), (lever, steel)]


def _spread(look: Look) -> Pieces:
    """A rotary cutter lying: a curved handle, a round blade at its end."""
    tile = plastic(look, "yellow", "pink", "purple", "teal", "red")
    grip = rod(
        [(-0.08, -0.012, 0.011), (-0.03, 0.004, 0.011), (0.02, 0.006, 0.011), (0.045, 0.0, 0.011)],
        [0.011, 0.012, 0.0105, 0.01],
        12,
    )
    head = at_block(0.034, 0.03, 0.016, 0.01, (0.05, 0, 0.002))
    blade = disc(0.0225, 0.0012, (0.062, -0.004, 0.0085), sides=36)
    nut = disc(0.009, 0.006, (0.06, -0.003, 0.0165))
    strip = spindle((-0.06, 0.0108), (0.0, 0.0108), z=0.0135).scale(1, 0.5, 1)
    return [
        (grip, tile),
        (head, tile),
        (blade, shine(look)),
        (nut, BLACK),
        (strip, dye(look, "gray", "black")),
    ]


def _remover(look: Look) -> Pieces:
    """A staple remover: two jaws with fangs on a hinge."""
    shell = plastic(look, "black", "red", "blue", "gray")
    pads = [
        at_block(0.045, 0.026, 0.008, 0.008).turn(1, s * 0.28).move(0, 0, 0.013 - s * 0.013)
        for s in (-1, 1)
    ]
    low = min(float(p.bounds[0, 2]) for p in pads)
    pads = [p.move(z=-low) for p in pads]
    fangs = [
        hull_solid(
            [
                (0.018, y - 0.002, z),
                (0.018, y + 0.002, z),
                (0.036, y, z - d),
                (0.034, y, z + d),
                (0.018, y, z + 1.6 * d),
            ]
        )
        for y in (-0.008, 0.008)
        for z, d in ((0.012, 0.004), (0.03, -0.004))
    ]
    hinge = straight((-0.02, -0.014, 0.018), (-0.02, 0.014, 0.018), 0.004, 10)
    return [(pads[0], shell), (pads[1], shell), (join(fangs), shine(look)), (hinge, shine(look))]


_row = Rows("office", ("black",)).of_drawing


CATEGORIES = (
    _row("watercolour_set", _pans, (0.189, 0.108, 0.078), 0.2, ("watercolor set", "watercolour box",
             "watercolor box", "watercolour pan set", "paint set", "paint box",
             "watercolor palette", "watercolour palette", "face paint set",
             "watercolor paint set", "watercolour paints"), bodies=2),
    _row("stencil", _stencil, (0.2, 0.13, 0.0014), 0.015, ("letter stencil", "drawing stencil",
             "lettering stencil", "stencil sheet", "shape template"), ("green",), roles=("flat",)),
    _row("silkscreen", _screen, (0.26, 0.32, 0.022), 0.5, ("silk screen", "screen printing frame",
             "printing screen", "screen print frame"), ("wooden",), roles=("flat", "big")),
    at_rest(_row("airbrush", _airbrush, (0.153, 0.0917, 0.0412), 0.15, ("air brush", "airbrush pen",
             "airbrush gun pen"), ("silver",), 0.1, 3)),
    _row("rotary_cutter", _spread, (0.168, 0.0449, 0.0242), 0.09, ("rotary fabric cutter",
             "fabric cutter", "roller cutter", "rotary trimmer", "rotary knife",
             "rotary blade cutter"), ("yellow",), 0.1, 3),
    at_rest(_row("staple_remover", _remover, (0.0603, 0.0282, 0.0455), 0.04, ("staple puller",
             "de stapler",
             "staple extractor"), ("black", "red"))),
)  # fmt: skip
"""The module's categories."""
