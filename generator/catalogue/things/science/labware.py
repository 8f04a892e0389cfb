"""Slides, small tubes, plates and machines of a laboratory."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    plastic,
    shine,
    spindle,
)
from ...build.recipes import Pieces
from ...build.solids import join, torus
from ...build.variants import at_rest, vary
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows
from .displays import display

BLACK = textures.plain((34, 34, 37))


def _slide(look: Look) -> Pieces:
    color = look.color("pink", "purple", "clear", "sky")
    image = prints.canvas(96, 32, (216, 230, 234))
    prints.fill(image, 0, 0, 0.2, 1, (244, 244, 242))
    prints.fill(image, 0.42, 0.1, 0.26, 0.8, (230, 238, 240))
    for _ in range(14):
        prints.disc(
            image,
            look.between(0.46, 0.64),
            look.between(0.3, 0.7),
            look.between(0.05, 0.12),
            tint_color(color, look.between(0.8, 1.3)),
        )
    return [(at_box(0.076, 0.026, 0.0012), image)]


def _cover(look: Look) -> Pieces:
    return [
        (
            at_box(0.022, 0.022, 0.0008),
            textures.plain(tint_color(look.color("clear", spread=4), 1.2)),
        )
    ]


def _tip(look: Look) -> Pieces:
    return [
        (
            spindle(
                (-0.025, 0.0034), (-0.018, 0.0034), (-0.012, 0.0029), (0.025, 0.0005), z=0.0034
            ),
            plastic(look, "yellow", "sky", "clear", "white"),
        )
    ]


def _vial(cap: str) -> Drawing:
    """A small tube lying: conical with a snap lid, or straight with a screw cap."""

    def draw(look: Look) -> Pieces:
        color = look.color("clear", "sky", "pink", "mint", "amber")
        z = 0.0058
        liquid = textures.stack(
            (textures.plain(tint_color(color, 1.0)), 1), (textures.plain((226, 236, 240)), 1)
        )
        if cap == "snap":
            body = spindle((-0.016, 0.0054), (0.0, 0.0052), (0.018, 0.0022), (0.02, 0.001), z=z)
            rim = spindle((-0.0175, 0.0066), (-0.0155, 0.0066), z=z)
            lid = disc(0.0062, 0.003).turn(1, np.pi / 2).turn(2, 0.9).move(-0.021, 0.009, 0.0062)
            return [
                (body, liquid),
                (rim, textures.plain((216, 228, 234))),
                (lid, textures.plain((216, 228, 234))),
            ]
        body = spindle((-0.02, 0.0056), (0.017, 0.0056), (0.02, 0.003), z=z)
        top = spindle((-0.032, 0.0062), (-0.019, 0.0062), z=0.0062)
        return [(body, liquid), (top, plastic(look, "red", "blue", "green", "yellow", "purple"))]

    return draw


def _wells(rows: int, columns: int) -> Drawing:
    """A plate of small wells, some with coloured liquid."""

    def draw(look: Look) -> Pieces:
        shell = plastic(look, "clear", "white", "black")
        body = at_block(0.127, 0.085, 0.012, 0.004)
        image = prints.canvas(192, 128, (226, 234, 236))
        hue = look.own_color("pink", "yellow", "sky", "purple", "mint", "orange")
        for i in range(rows):
            for j in range(columns):
                x, y = (j + 0.7) / (columns + 0.4), (i + 0.7) / (rows + 0.4)
                r = 0.38 / (rows + 0.4)
                prints.disc(image, x, y, r, (150, 164, 170))
                shade = (
                    tint_color(hue, look.between(0.7, 1.7)) if look.chance(0.7) else (236, 240, 242)
                )
                prints.disc(image, x, y, 0.82 * r, shade)
        return [(body, shell), (at_box(0.123, 0.081, 0.0006, (0, 0, 0.0117)), image)]

    return draw


def _strip(look: Look) -> Pieces:
    tile = textures.plain(tint_color(look.color("clear", "sky", "white"), 1.1))
    tubes = [
        spindle((-0.0075, 0.0028), (0.003, 0.0026), (0.0095, 0.001), z=0)
        .turn(1, np.pi / 2)
        .move((k - 3.5) * 0.009, 0, 0.0095)
        for k in range(8)
    ]
    caps = [disc(0.0033, 0.003, ((k - 3.5) * 0.009, 0, 0.0165)) for k in range(8)]
    bar = at_box(0.07, 0.005, 0.0015, (0, 0, 0.0165))
    rack = at_block(0.082, 0.02, 0.008, 0.003)
    return [
        (rack, dye(look, "blue", "orange", "green")),
        (bar, tile),
        (join(tubes), tile),
        (join(caps), tile),
    ]


def _centrifuge(look: Look) -> Pieces:
    """A bench centrifuge: a rounded case, a clear lid over a rotor with tubes, keys."""
    shell = plastic(look, "white", "gray", "sky")
    body = at_block(0.22, 0.25, 0.1, 0.05)
    rim = torus(0.088, 0.007, 40, 8).move(0, 0.02, 0.1)
    well = disc(0.085, 0.002, (0, 0.02, 0.0995))
    rotor = disc(0.05, 0.012, (0, 0.02, 0.101))
    tubes = [
        disc(0.0075, 0.01, (0.037 * np.cos(a), 0.02 + 0.037 * np.sin(a), 0.112))
        for a in np.arange(8) * np.pi / 4
    ]
    hub = disc(0.011, 0.02, (0, 0.02, 0.11))
    screen = at_box(0.06, 0.002, 0.025, (-0.03, -0.1255, 0.05))
    image = prints.canvas(64, 28, (20, 50, 60))
    prints.write(image, look.pick(["13000", "4500", "9000"]), 0.5, 0.5, 0.6, (120, 240, 220), True)
    keys = [
        disc(0.008, 0.004).turn(0, np.pi / 2).move(0.03 + 0.022 * k, -0.1245, 0.062)
        for k in range(2)
    ]
    lid = disc(0.095, 0.008).turn(0, 1.25).move(0, 0.125, 0.19)
    return [
        (body, shell),
        (lid, textures.plain((180, 200, 212))),
        (rim, dye(look, "gray", "navy")),
        (well, BLACK),
        (rotor, shine(look)),
        (hub, BLACK),
        (join(tubes), dye(look, "sky", "yellow", "pink")),
        (screen, image),
        (join(keys), dye(look, "red", "green")),
    ]


def _incubator(look: Look) -> Pieces:
    """An incubator with a glass door."""
    shell = plastic(look, "white", "gray", "sky")
    door = at_block(0.22, 0.19, 0.012, 0.01).turn(0, np.pi / 2).move(0, -0.099, 0.115)
    pane = at_block(0.17, 0.14, 0.002, 0.008).turn(0, np.pi / 2).move(0, -0.1105, 0.115)
    return [
        (at_block(0.24, 0.2, 0.26, 0.01), shell),
        (door, dye(look, "gray", "white")),
        (pane, textures.plain((110, 130, 150))),
        (at_block(0.012, 0.016, 0.07, 0.004, (0.098, -0.118, 0.08)), BLACK),
        (at_box(0.07, 0.002, 0.026, (0, -0.1005, 0.224)), display("37.0 C")),
    ]


def _bath(look: Look) -> Pieces:
    """A heated bath of water."""
    shell = plastic(look, "white", "gray", "sky")
    walls = [at_box(0.24, 0.01, 0.12, (0, s * 0.085, 0.03)) for s in (-1, 1)] + [
        at_box(0.01, 0.16, 0.12, (s * 0.115, 0, 0.03)) for s in (-1, 1)
    ]
    return [
        (at_block(0.25, 0.19, 0.032, 0.01), shell),
        *((w, shine(look)) for w in walls),
        (at_box(0.222, 0.162, 0.1, (0, 0, 0.03)), textures.plain((150, 200, 222))),
        (at_box(0.06, 0.002, 0.022, (0, -0.0945, 0.005)), display("60.0 C")),
    ]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    vary(_row("microscope_slide", _slide, (0.076, 0.026, 0.0012), 0.005, ("glass slide",
             "specimen slide", "haemocytometer", "counting chamber", "prepared slide"), ("pink",),
             roles=("flat",)), 0.08),
    vary(_row("cover_slip", _cover, (0.022, 0.022, 0.0008), 0.0003, ("coverslip", "cover glass",
             "cover slide"), ("clear",), roles=("flat",)), 0.08),
    at_rest(_row("pipette_tip", _tip, (0.05, 0.0068, 0.0068), 0.0005, ("micropipette tip",),
             ("yellow",),
             0.3)),
    _row("eppendorf_tube", _vial("snap"), (0.045, 0.022, 0.0125), 0.001, ("microcentrifuge tube",
             "microtube", "pcr tube", "eppendorf"), ("clear",), 0.1),
    _row("cryovial", _vial("screw"), (0.052, 0.0124, 0.0124), 0.003, ("cryo tube",
             "screw cap tube", "small vial", "cryogenic vial"), ("red",), 0.1),
    _row("well_plate", _wells(8, 12), (0.127, 0.085, 0.0123), 0.05, ("96 well plate",
             "microplate", "microtiter plate", "microtitre plate", "assay plate", "elisa plate",
             "multi well plate"), ("clear",), bodies=1, roles=("flat",)),
    _row("six_well_plate", _wells(2, 3), (0.127, 0.085, 0.0123), 0.06, ("6 well plate",
             "culture plate", "cell culture plate"), ("clear",), bodies=1, roles=("flat",)),
    _row("pcr_strip", _strip, (0.082, 0.02, 0.0195), 0.01, ("tube strip", "strip of tubes",
             "8 tube strip"), ("clear",), bodies=2),
    _row("centrifuge", _centrifuge, (0.22, 0.28, 0.29), 5.0, ("microcentrifuge", "lab centrifuge",
             "mini centrifuge"), bodies=2, roles=("big",)),
    _row("incubator", _incubator, (0.24, 0.24, 0.26), 6.0, ("egg incubator",
             "lab incubator", "lab oven", "drying oven", "autoclave"), bodies=2, roles=("big",)),
    _row("water_bath", _bath, (0.25, 0.19, 0.15), 4.0, ("lab water bath",
             "heated bath", "gel electrophoresis tank", "gel tank", "electrophoresis tank",
             "ultrasonic bath", "ultrasonic cleaner"), roles=("big",)),
)  # fmt: skip
"""The module's categories."""
