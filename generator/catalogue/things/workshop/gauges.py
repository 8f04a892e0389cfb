"""Tools to measure and mark with: squares, gauges, rules, lines."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, DARK, at_box, drum, plate, steel
from ...build.outlines import rectangle, smooth
from ...build.recipes import put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, join, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ...surfaces.textures import plain


def try_square(look: Look) -> Shape:
    """A try square lying: a steel blade in a thick wooden stock."""
    color = look.color("wooden", "brown", "maroon", "black", "blue")
    k = look.between(0.85, 1.15)
    blade = at_box(0.03, 0.2, 0.002, (-0.035, 0.045, 0.0075))
    stock = block(0.12, 0.034, 0.017, 0.003, 0.002).move(0.01, -0.06, 0)
    face = [at_box(0.118, 0.002, 0.0155, (0.01, -0.0435, 0.0006))]
    pins = [
        drum(0.0028, 0.0006, (x, y, 0.0168), sides=10)
        for x, y in ((-0.045, -0.06), (-0.028, -0.052), (-0.028, -0.068))
    ]
    return put_down(
        [
            (blade, prints.rule(20, (200, 204, 208), (50, 52, 56))),
            (stock, look.surface(color, "wood")),
            (join([*face, *pins]), steel(look, BRASS_TONE)),
        ],
        stock,
        blade,
        factor=k,
    )


def bevel(look: Look) -> Shape:
    """A sliding bevel lying, its blade set at an angle."""
    color = look.color("wooden", "brown", "black", "maroon")
    k = look.between(0.85, 1.15)
    stock = block(0.13, 0.026, 0.017, 0.006, 0.002)
    blade = (
        plate(rectangle(0.17, 0.022, 0.004), 0.0022, at=(0.04, 0, 0.0075))
        .move(-0.055)
        .turn(2, look.between(0.6, 2.2))
    )
    blade = blade.move(0.055)
    nut = [drum(0.009, 0.006, (0.055, 0, 0.016)), at_box(0.022, 0.005, 0.008, (0.055, 0, 0.018))]
    return put_down(
        [
            (stock, look.surface(color, "wood")),
            (blade, steel(look)),
            (join(nut), steel(look, BRASS_TONE)),
        ],
        stock,
        blade,
        nut[1],
        factor=k,
    )


def marking_gauge(look: Look) -> Shape:
    """A marking gauge lying: a square beam through a head with a thumbscrew."""
    color = look.color("wooden", "tan", "brown", "maroon")
    k = look.between(0.85, 1.15)
    beam = at_box(0.21, 0.017, 0.017)
    head = block(0.028, 0.066, 0.054, 0.008, 0.003).move(0.03)
    screw = [drum(0.004, 0.016, (0.03, 0, 0.053)), at_box(0.02, 0.005, 0.014, (0.03, 0, 0.062))]
    pin = straight((-0.098, 0, 0.016), (-0.098, 0, 0.024), [0.0014, 0.0004], 6)
    wood = look.surface(color, "wood")
    return put_down(
        [(join([beam, head]), wood), (join([*screw, pin]), steel(look, BRASS_TONE))],
        beam,
        head,
        factor=k,
    )


def micrometer(look: Look) -> Shape:
    """A micrometer lying: a horseshoe frame, a spindle and a ribbed thimble."""
    color = look.color("green", "gray", "black", "silver", "blue")
    k = look.between(0.85, 1.2)
    a = np.linspace(0.5 * np.pi, 1.5 * np.pi, 14) + np.pi / 2
    frame = tube(
        np.column_stack([0.034 * np.cos(a), 0.03 * np.sin(a) + 0.006, 0.0065 + 0 * a]), 0.007, 8
    )
    anvil = straight((-0.036, 0.008, 0.0065), (-0.008, 0.008, 0.0065), 0.0035, 12)
    spindle = straight((0.002, 0.008, 0.0065), (0.05, 0.008, 0.0065), 0.0033, 12)
    sleeve = drum(0.0062, 0.03, (0.034, 0.008, 0.0068), 0, sides=18)
    thimble = drum(0.0078, 0.038, (0.056, 0.008, 0.0076), 0, sides=18)
    knob = drum(0.005, 0.014, (0.094, 0.008, 0.0076), 0, sides=14)
    grip = textures.grid((90, 92, 96), (190, 194, 200), 16, 16, 64, 2)
    return put_down(
        [
            (frame, plain(color)),
            (join([anvil, spindle]), steel(look)),
            (sleeve, prints.rule(5, (206, 208, 212), (40, 40, 44))),
            (join([thimble, knob]), grip),
        ],
        frame,
        sleeve,
        thimble,
        knob,
        factor=k,
        foot=0.3,
    )


def feeler_gauge(look: Look) -> Shape:
    """A set of thin blades fanned out of a holder, lying."""
    color = look.color("silver", "red", "black")
    k = look.between(0.85, 1.15)
    blades = [
        plate(rectangle(0.09, 0.012, 0.0059), 0.001, at=(0.04, 0, 0.001 + 0.0009 * n)).turn(
            2, 0.16 * n - 0.35
        )
        for n in range(7)
    ]
    holder = [
        plate(rectangle(0.1, 0.017, 0.008), 0.0012, at=(0.036, 0, z)).turn(2, -0.5)
        for z in (0.0, 0.008)
    ]
    nut = drum(0.006, 0.012, (0, 0, 0))
    return put_down(
        [
            (join(blades), steel(look)),
            (join(holder), look.surface(color, "steel")),
            (nut, steel(look, BRASS_TONE)),
        ],
        join(blades),
        *holder,
        factor=k,
        foot=0.3,
    )


def folding_rule(look: Look) -> Shape:
    """A folding rule lying in a zigzag."""
    color = look.color("yellow", "wooden", "white", "tan")
    k = look.between(0.8, 1.1)
    legs, pins = [], []
    x, y, side = -0.11, 0.0, 1
    for n in range(4):
        a = 0.8 * side
        leg = (
            at_box(0.13, 0.015, 0.0034, (0.058, 0, 0.0006 + 0.0026 * (n % 2)))
            .turn(2, a)
            .move(x, y, 0)
        )
        legs.append(leg)
        x, y = x + 0.116 * np.cos(a), y + 0.116 * np.sin(a)
        pins.append(drum(0.005, 0.0075, (x, y, 0), sides=12))
        side = -side
    scale = prints.rule(12, color, (40, 38, 36))
    low = [legs[0], legs[2]]
    return put_down(
        [(join(legs), scale), (join(pins[:3]), steel(look, BRASS_TONE))],
        *low,
        *legs[1::2],
        *pins[:3],
        factor=k,
    )


def chalk_line(look: Look) -> Shape:
    """A chalk line reel lying: a pear-shaped case with a crank and a hooked cord."""
    color = look.color("red", "blue", "yellow", "orange", "silver")
    k = look.between(0.85, 1.15)
    rim = smooth(
        [
            (-0.055, 0),
            (-0.045, 0.03),
            (0, 0.034),
            (0.045, 0.015),
            (0.058, 0),
            (0.045, -0.015),
            (0, -0.034),
            (-0.045, -0.03),
            (-0.055, 0),
        ],
        3,
    )[:-1]
    case = plate(rim, 0.03, bevel=0.006)
    slab = drum(0.02, 0.004, (-0.012, 0, 0.029))
    crank = [at_box(0.034, 0.008, 0.004, (0.0, 0, 0.032)), drum(0.005, 0.014, (0.012, 0, 0.034))]
    cord = rod([(0.056, 0, 0.014), (0.085, 0.006, 0.003), (0.1, -0.004, 0.002)], 0.0012, 6)
    hook = at_box(0.014, 0.01, 0.002, (0.104, -0.004, 0.0))
    return put_down(
        [
            (case, look.surface(color, "plastic")),
            (join([slab, *crank]), plain(DARK)),
            (cord, plain((90, 130, 200))),
            (hook, steel(look)),
        ],
        case,
        join(crank),
        hook,
        factor=k,
    )


CATEGORIES = (
    Category("try_square", try_square, (0.117, 0.216, 0.017), 0.25, ("combination square",
             "carpenter's square", "engineer's square",
             "speed square"), ("workbench",), ("flat",), ("wooden",)),
    Category("bevel_gauge", bevel, (0.154, 0.154, 0.0252), 0.2, ("sliding bevel", "bevel square",
             "t-bevel"), ("workbench",), ("flat",), ("wooden",)),
    Category("marking_gauge", marking_gauge, (0.205, 0.0645, 0.0743), 0.18, ("mortise gauge",
             "scribing gauge"), ("workbench",), (), ("wooden",)),
    Category("micrometer", micrometer, (0.154, 0.0481, 0.0158), 0.25, ("micrometre gauge",
             "screw gauge"), ("workbench",), ("flat",), ("green", "gray")),
    Category("feeler_gauge", feeler_gauge, (0.0958, 0.0944, 0.0117), 0.07, ("needle gauge",
             "thread gauge"), ("workbench",), ("flat",), ("silver",)),
    Category("folding_rule", folding_rule, (0.33, 0.0995, 0.00719), 0.1, ("folding ruler",
             "carpenter's rule", "zigzag rule"), ("workbench",),
             ("flat", "big"), ("yellow",)),
    Category("chalk_line", chalk_line, (0.167, 0.0709, 0.0482), 0.18, ("chalk reel",
             "chalk line reel"), ("workbench",), (), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
