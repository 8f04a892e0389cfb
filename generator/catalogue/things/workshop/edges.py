"""Tools with a point or an edge, and what sharpens them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, at_box, drum, lies, plate, standing, steel
from ...build.outlines import rectangle
from ...build.recipes import put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, join, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def whetstone(look: Look) -> Shape:
    """A sharpening stone of two grits, on a wooden or rubber foot."""
    color = look.color("gray", "terracotta", "white", "charcoal", "sage")
    k = look.between(0.85, 1.1)
    low = at_box(0.17, 0.06, 0.012, (0, 0, 0.012))
    top = at_box(0.17, 0.06, 0.012, (0, 0, 0.0235))
    foot = block(0.2, 0.075, 0.016, 0.006, 0.002)
    wood = textures.wood(look.rng, (200, 164, 112)) if look.chance(0.5) else plain((60, 62, 66))
    return put_down(
        [
            (top, textures.spots(look.rng, color, tint_color(color, 0.85), 0.3)),
            (low, textures.speckles(look.rng, tint_color(color, 0.6), 6)),
            (foot, wood),
        ],
        foot,
        join([low, top]),
        factor=k,
    )


def awl(look: Look) -> Shape:
    """An awl lying: a thin spike in a round handle."""
    color = look.color("wooden", "red", "brown", "black", "tan")
    k = look.between(0.85, 1.2)
    handle = lies(
        standing(
            (0.006, 0), (0.0145, 0.012), (0.0165, 0.03), (0.011, 0.06), (0.008, 0.07), sides=18
        ),
        -0.07,
        0,
        0.0155,
    )
    collar = drum(0.0078, 0.012, (-0.002, 0, 0.0155), 0, sides=14)
    spike = straight((0.008, 0, 0.0155), (0.085, 0, 0.0155), [0.0034, 0.0004], 10)
    spike = spike.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] - 0.013 * np.clip((p[:, 0] - 0.008) / 0.077, 0, 1)]
        )
    )
    return put_down(
        [
            (handle, look.surface(color, "wood")),
            (collar, steel(look, BRASS_TONE)),
            (spike, steel(look)),
        ],
        handle,
        spike,
        factor=k,
        foot=0.25,
    )


def punch(look: Look) -> Shape:
    """A steel punch lying, its middle knurled."""
    color = look.color("silver", "charcoal", "black", "bronze")
    k = look.between(0.85, 1.2)
    bar_ = lies(
        standing(
            (0.004, 0), (0.0065, 0.004), (0.0065, 0.08), (0.0022, 0.115), (0.0008, 0.12), sides=14
        ),
        -0.06,
        0,
        0.0062,
    )
    grip = drum(0.0068, 0.045, (-0.036, 0, 0.0062), 0, sides=16)
    knurl = textures.grid((70, 72, 76), (140, 144, 150), 14, 14, 64, 2)
    return put_down([(bar_, steel(look, color)), (grip, knurl)], bar_, grip, factor=k, foot=0.35)


def folding_knife(look: Look) -> Shape:
    """A pocket knife lying, its blade and tools half out."""
    color = look.color("red", "red", "black", "wooden", "green", "blue")
    k = look.between(0.85, 1.15)
    scales = [
        plate(rectangle(0.09, 0.026, 0.0125, 6), 0.004, at=(0, 0, z), bevel=0.001)
        for z in (0.0, 0.012)
    ]
    liner = plate(rectangle(0.087, 0.024, 0.0118, 6), 0.009, at=(0, 0, 0.0035))
    blade = plate(
        [(0, -0.0065), (0.055, -0.006), (0.068, 0.002), (0.05, 0.0065), (0, 0.0065)],
        0.002,
        at=(0, 0, 0.0035),
    )
    blade = blade.turn(2, look.between(0.3, 0.9)).move(0.037, 0.004, 0)
    short = plate(
        [(0, -0.005), (0.03, -0.004), (0.036, 0.003), (0, 0.005)], 0.002, at=(0, 0, 0.0085)
    ).turn(2, np.pi - 0.7)
    short = short.move(-0.037, 0.004, 0)
    screw = rod(
        [
            (-0.005, 0.01, 0.008),
            (-0.012, 0.03, 0.008),
            (-0.004, 0.034, 0.008),
            (-0.012, 0.038, 0.008),
        ],
        0.0014,
        6,
    )
    cross = [
        at_box(0.012, 0.0035, 0.0008, (0.015, 0, 0.0156)),
        at_box(0.0035, 0.012, 0.0008, (0.015, 0, 0.0156)),
    ]
    ring = torus(0.005, 0.0009, 14, 5).move(-0.049, 0, 0.008)
    return put_down(
        [
            (join(scales), look.surface(color, "plastic")),
            (join([liner, blade, short, screw, ring]), steel(look)),
            (join(cross), plain((236, 236, 240))),
        ],
        join([*scales, liner]),
        blade,
        short,
        factor=k,
    )


def multitool(look: Look) -> Shape:
    """A folding multi-tool lying open: plier jaws between two handles, a blade out."""
    color = look.color("silver", "black", "charcoal", "green")
    k = look.between(0.85, 1.15)
    handles = [
        plate(rectangle(0.1, 0.016, 0.006), 0.015, at=(-0.048, 0, 0), bevel=0.002)
        .turn(2, s * 0.24)
        .move(0.0, s * -0.006, 0)
        for s in (-1, 1)
    ]
    jaws = [
        plate(
            [(0, 0), (0.005, s * 0.011), (0.03, s * 0.009), (0.058, s * 0.002), (0.058, 0)],
            0.008,
            at=(0, s * 0.001, 0.0035),
        )
        for s in (-1, 1)
    ]
    pivot = drum(0.006, 0.014, (0.004, 0, 0.001))
    blade = (
        plate([(0, -0.005), (0.05, -0.004), (0.06, 0.002), (0, 0.005)], 0.002, at=(0, 0, 0.006))
        .turn(2, 2.2)
        .move(-0.09, -0.03, 0)
    )
    return put_down(
        [
            (join(handles), look.surface(color, "metal")),
            (join([*jaws, blade]), steel(look)),
            (pivot, plain((80, 82, 88))),
        ],
        *handles,
        join(jaws),
        blade,
        factor=k,
    )


CATEGORIES = (
    Category("whetstone", whetstone, (0.192, 0.072, 0.0341), 0.7, ("oilstone", "sharpening stone",
             "honing stone", "grindstone", "whet stone",
             "water stone"), ("workbench", "kitchen"), ("flat",), ("gray",)),
    Category("awl", awl, (0.162, 0.0344, 0.0331), 0.06, ("bradawl", "scratch awl", "scribe",
             "scriber", "seam ripper", "gimlet", "bodkin"), ("workbench",),
             (), ("wooden",)),
    Category("centre_punch", punch, (0.122, 0.0138, 0.0132), 0.08, ("center punch", "nail punch",
             "nail set", "pin punch", "metal punch",
             "leather punch"), ("workbench",), (), ("silver",)),
    Category("pocket_knife", folding_knife, (0.157, 0.0544, 0.0161), 0.09, ("swiss army knife",
             "penknife", "pen knife", "folding knife", "jackknife",
             "camping knife"), ("workbench",), (), ("red",)),
    Category("multitool", multitool, (0.191, 0.0737, 0.0155), 0.22, ("multi-tool", "multi tool",
             "bike multi-tool", "leatherman", "pocket tool"),
             ("workbench",), (), ("silver", "black")),
)  # fmt: skip
"""The module's categories."""
