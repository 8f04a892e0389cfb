"""Parts of a car one sees and holds: wheel, lamps, mirrors, caps, jacks, fobs."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plastic,
    shine,
    spindle,
    standing,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, lathe, torus
from ...build.variants import at_rest
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _wheel(look: Look) -> Pieces:
    """A steering wheel lying: rim, three spokes, a hub with a horn pad."""
    rim = torus(0.17, 0.014, 44, 10).move(z=0.03)
    spokes = [
        at_box(0.15, 0.035, 0.012, (0.085, 0, 0.022)).turn(2, a) for a in (0, np.pi, -np.pi / 2)
    ]
    hub = [disc(0.052, 0.035, (0, 0, 0.004)), disc(0.03, 0.006, (0, 0, 0.037))]
    return [(rim, plastic(look, "black", "brown", "charcoal", "tan")), *((s, dye(look, "charcoal",
             "silver")) for s in spokes),
            (hub[0], dye(look, "black")), (hub[1], shine(look))]  # fmt: skip


def _hubcap(look: Look) -> Pieces:
    steel = metal(look, "silver", "silver", "gray", "black")
    face = standing(
        (0.165, 0),
        (0.17, 0.004),
        (0.165, 0.016),
        (0.13, 0.022),
        (0.05, 0.026),
        (0.03, 0.03),
        sides=40,
    )
    slots = [
        disc(0.018, 0.002, sides=14).scale(1.5, 1, 1).move(0.11, 0, 0.022).turn(2, a)
        for a in np.arange(8) * np.pi / 4
    ]
    badge = disc(0.026, 0.003, (0, 0, 0.029))
    return [(face, steel), (join(slots), BLACK), (badge, dye(look, "blue", "red", "black"))]


def _headlight(look: Look) -> Pieces:
    """A round headlight standing on its rim: a chrome ring, a ribbed glass."""
    bowl = lathe(
        [(0, 0), (0.02, 0), (0.03, 0.012), (0.07, 0.05), (0.08, 0.07), (0.08, 0.08), (0, 0.08)], 32
    )
    lens = ball(0.15, 0.15, 0.036, (0, 0, 0.08), 28)
    ring = torus(0.08, 0.006, 36, 8).move(z=0.078)
    turn = np.pi / 2 - 0.12
    solids = [s.turn(0, turn) for s in (bowl, ring, lens)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    foot = at_box(0.07, 0.08, 0.012, (0, 0.03, 0))
    bowl, ring, lens = (s.move(z=-low + 0.004) for s in solids)
    image = textures.stripes([(236, 242, 246), (206, 216, 224)], 12, upright=True)
    return [
        (foot, BLACK),
        (bowl, dye(look, "black", "charcoal")),
        (ring, shine(look)),
        (lens, image),
    ]


def _mirror(look: Look) -> Pieces:
    """A rear-view mirror: a wide rounded glass in a dark shell on a stalk."""
    shell = plastic(look, "black", "charcoal", "gray")
    body = at_block(0.22, 0.065, 0.022, 0.028).turn(0, np.pi / 2 - 0.25)
    glass = at_block(0.208, 0.055, 0.002, 0.025, (0, 0, 0.0215)).turn(0, np.pi / 2 - 0.25)
    low = float(body.bounds[0, 2])
    body, glass = body.move(z=-low), glass.move(z=-low)
    stalk = rod([(0, 0.012, 0.04), (0, 0.05, 0.03), (0, 0.065, 0.009)], 0.007, 10)
    base = disc(0.024, 0.01, (0, 0.065, 0))
    return [
        (body, shell),
        (stalk, shell),
        (base, shell),
        (glass, textures.gradient((150, 170, 186), (226, 236, 242), look.rng)),
    ]


def _wiper(look: Look) -> Pieces:
    rubber = at_box(0.44, 0.007, 0.012)
    spine = at_block(0.4, 0.011, 0.007, 0.003, (0, 0, 0.011))
    arms = rod(
        [(-0.18, 0, 0.016), (-0.08, 0, 0.03), (0, 0, 0.034), (0.08, 0, 0.03), (0.18, 0, 0.016)],
        0.004,
        8,
    )
    hook = at_block(0.04, 0.014, 0.02, 0.004, (0, 0, 0.022))
    foot = at_box(0.3, 0.016, 0.003)
    return [
        (rubber, BLACK),
        (spine, metal(look, "black", "charcoal")),
        (arms, dye(look, "black")),
        (hook, dye(look, "black", "gray")),
        (foot, BLACK),
    ]


def _knob(look: Look) -> Pieces:
    """A gear knob with the shift pattern on top, on its collar."""
    color = look.color("black", "brown", "silver", "white", "red")
    body = standing((0.014, 0), (0.016, 0.02), (0.026, 0.05), (0.026, 0.066), (0.018, 0.076))
    image = prints.canvas(64, 64, (30, 30, 32))
    for x in (0.28, 0.5, 0.72):
        prints.fill(image, x - 0.02, 0.24, 0.04, 0.52, (236, 236, 232))
    prints.fill(image, 0.27, 0.48, 0.46, 0.05, (236, 236, 232))
    for n, (x, y) in enumerate(
        ((0.28, 0.14), (0.28, 0.88), (0.5, 0.14), (0.5, 0.88), (0.72, 0.14)), 1
    ):
        prints.write(image, str(n), x, y, 0.17, (236, 236, 232))
    boot = standing((0.045, 0), (0.044, 0.006), (0.03, 0.016), (0.018, 0.03))
    return [
        (boot, dye(look, "black", "charcoal")),
        (body.move(z=0.022), look.surface(color)),
        (disc(0.017, 0.002, (0, 0, 0.0975)), image),
    ]


def _brace(look: Look) -> Pieces:
    """A wheel brace: four arms with sockets, lying as a cross."""
    steel = metal(look, "silver", "gray", "charcoal")
    arms = [
        straight((0, 0, 0.012), (0.17 * np.cos(a), 0.17 * np.sin(a), 0.012), 0.007, 10)
        for a in np.arange(4) * np.pi / 2
    ]
    ends = [
        straight(
            (0.15 * np.cos(a), 0.15 * np.sin(a), 0.013),
            (0.19 * np.cos(a), 0.19 * np.sin(a), 0.013),
            0.013,
            12,
        )
        for a in np.arange(4) * np.pi / 2
    ]
    return [
        (join([arms[0], arms[2]]), steel),
        (join([arms[1], arms[3]]), steel),
        *((e, shine(look)) for e in ends),
    ]


def _jack(look: Look) -> Pieces:
    """A scissor jack half raised: a foot, a diamond of arms, a screw with a crank."""
    tile = metal(look, "red", "black", "yellow", "charcoal")
    foot = at_block(0.12, 0.07, 0.008, 0.006)
    left, right, low, high = (-0.11, 0.085), (0.11, 0.085), (0.0, 0.012), (0.0, 0.16)
    arms = []
    for a, b in ((low, left), (low, right), (left, high), (right, high)):
        arms.append(straight((a[0], -0.018, a[1]), (b[0], -0.018, b[1]), 0.01, 4))
        arms.append(straight((a[0], 0.018, a[1]), (b[0], 0.018, b[1]), 0.01, 4))
    screw = straight((-0.13, 0, 0.085), (0.15, 0, 0.085), 0.0065, 10)
    nuts = [at_box(0.024, 0.05, 0.026, (x, 0, 0.072)) for x in (-0.11, 0.11)]
    saddle = at_block(0.06, 0.05, 0.012, 0.004, (0, 0, 0.162))
    return [
        (foot, tile),
        (join(arms), tile),
        (join(nuts), tile),
        (saddle, tile),
        (screw, shine(look)),
    ]


def _gauge(look: Look) -> Pieces:
    """A tyre gauge: a dial on a short stem with a chuck."""
    dial = disc(0.03, 0.016)
    rim = torus(0.03, 0.003, 30, 6).move(z=0.014)
    image = prints.canvas(96, 96, (246, 244, 238))
    for k in range(11):
        a = np.pi * 1.25 - k * np.pi * 0.15
        prints.disc(image, 0.5 + 0.38 * np.cos(a), 0.5 - 0.38 * np.sin(a), 0.03, (40, 40, 44))
    prints.stroke(image, [(0.5, 0.5), (0.72, 0.28)], 0.05, (200, 40, 36))
    prints.write(image, "PSI", 0.5, 0.72, 0.14, (40, 40, 44), True)
    face = disc(0.027, 0.0012, (0, 0, 0.0155))
    stem = spindle(
        (0.028, 0.006), (0.08, 0.006), (0.084, 0.01), (0.1, 0.01), (0.104, 0.007), z=0.01
    )
    return [
        (dial, plastic(look, "black", "red", "charcoal")),
        (stem, shine(look, "silver", "brass")),
        (rim, BLACK),
        (face, image),
    ]


def _pump(look: Look) -> Pieces:
    """A foot pump: a barrel between steel arms, a pedal, a gauge, a hose."""
    tile = metal(look, "red", "blue", "black", "yellow")
    base = [at_box(0.24, 0.012, 0.012, (0, s * 0.05, 0)) for s in (-1, 1)]
    cross = [at_box(0.016, 0.11, 0.012, (x, 0, 0)) for x in (-0.11, 0.11)]
    barrel = straight((-0.06, 0, 0.035), (0.075, 0, 0.075), 0.026, 18)
    arms = [straight((-0.11, s * 0.036, 0.012), (0.09, s * 0.036, 0.1), 0.006, 6) for s in (-1, 1)]
    pedal = at_block(0.05, 0.1, 0.012, 0.006, (0.09, 0, 0.096))
    dial = disc(0.02, 0.012, (-0.08, 0, 0.04))
    hose = rod(
        [
            (-0.09, 0, 0.03),
            (-0.15, 0.03, 0.008),
            (-0.13, 0.1, 0.006),
            (-0.02, 0.115, 0.006),
            (0.08, 0.1, 0.006),
        ],
        0.0055,
        8,
        6,
    )
    return [
        (join([*base]), tile),
        (join(cross), tile),
        (barrel, shine(look, "silver", "charcoal")),
        (join(arms), tile),
        (pedal, BLACK),
        (dial, textures.plain((240, 238, 232))),
        (hose, BLACK),
    ]


_row = Rows("workbench", ("black",)).of_drawing


CATEGORIES = (
    _row("steering_wheel", _wheel, (0.353, 0.353, 0.0377), 1.5, ("car steering wheel",
             "toy steering wheel"), roles=("flat", "big"), foot=0.0),
    _row("hubcap", _hubcap, (0.34, 0.34, 0.032), 0.5, ("hub cap", "wheel trim", "alloy wheel"),
             ("silver",), bodies=1, roles=("flat", "big")),
    at_rest(_row("headlight", _headlight, (0.17, 0.168, 0.173), 0.6, ("car headlight",
             "fog light"), ("silver",), bodies=3)),
    _row("rear_view_mirror", _mirror, (0.226, 0.122, 0.068), 0.3, ("rearview mirror", "wing mirror",
             "car mirror", "side mirror"), bodies=3),
    _row("wiper_blade", _wiper, (0.44, 0.016, 0.044), 0.2, ("windscreen wiper",
             "windshield wiper", "wiper"), roles=("big",)),
    _row("gear_knob", _knob, (0.09, 0.09, 0.0995), 0.2, ("gear stick", "gear lever", "shift knob",
             "gear shift")),
    _row("wheel_brace", _brace, (0.38, 0.38, 0.026), 1.2, ("lug wrench", "tyre iron", "tire iron",
             "wheel wrench"), ("silver",), 0.05, roles=("flat", "big")),
    _row("car_jack", _jack, (0.28, 0.07, 0.174), 2.5, ("scissor jack", "bottle jack"), ("red",)),
    _row("tyre_gauge", _gauge, (0.138, 0.0664, 0.0201), 0.1, ("tyre pressure gauge", "tire gauge",
             "tire pressure gauge", "pressure gauge"), bodies=2),
    _row("foot_pump", _pump, (0.291, 0.185, 0.113), 1.5, (), ("red",)),
)  # fmt: skip
"""The module's categories."""
