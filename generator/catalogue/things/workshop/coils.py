"""Parts of circuits: relays, transformers, coils, transistors, fuses, valves."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, DARK, STEEL_TONE, at_box, drum, plate, standing, steel
from ...build.outlines import rectangle
from ...build.recipes import put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import Solid, block, join, torus
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ...surfaces.textures import plain


def pins_at(places: list[tuple[float, float]], deep: float = 0.006, thick: float = 0.0012) -> Solid:
    """Return pins that reach down from ``deep`` to the table."""
    return join([at_box(thick, thick, deep, (x, y, 0)) for x, y in places])


def relay(look: Look) -> Shape:
    """A relay: a printed cube on pins."""
    color = look.color("blue", "black", "orange", "clear")
    k = look.between(0.9, 1.5)
    body = block(0.019, 0.0155, 0.0155, 0.0012, 0.0008).move(z=0.003)
    image = prints.canvas(96, 80, color)
    ink = (244, 244, 244) if sum(color) < 500 else (40, 40, 44)
    prints.write(
        image, look.pick(["SRD-05", "RLY 12V", "HK4100", "10A 250V"]), 0.5, 0.3, 0.2, ink, bold=True
    )
    prints.lines(image, look.rng, (0.12, 0.5, 0.76, 0.36), 3, ink, 0.7)
    face = at_box(0.0185, 0.015, 0.0005, (0, 0, 0.0182))
    pins = pins_at(
        [(-0.007, 0), (-0.007, 0.006), (-0.007, -0.006), (0.007, 0.005), (0.007, -0.005)], 0.004
    )
    return put_down(
        [(body, plain(color)), (face, image), (pins, steel(look))], body, pins, factor=k
    )


def transformer(look: Look) -> Shape:
    """A small transformer: laminated iron round a taped coil, with mounting ears."""
    color = look.color("yellow", "amber", "red", "blue")
    k = look.between(0.85, 1.25)
    core = [at_box(0.056, 0.022, 0.01, (0, 0, z)) for z in (0.0, 0.038)]
    core += [at_box(0.01, 0.022, 0.048, (x, 0, 0)) for x in (-0.023, 0.023)]
    coil = block(0.034, 0.042, 0.029, 0.008, 0.002).move(z=0.0095)
    ears = [at_box(0.016, 0.022, 0.0016, (s * 0.035, 0, 0)) for s in (-1, 1)]
    wires = [
        rod([(x, -0.02, 0.03), (1.4 * x, -0.034, 0.03), (1.6 * x, -0.045, 0.003)], 0.0014, 6)
        for x in (-0.012, 0.0, 0.012)
    ]
    iron = textures.stripes([(86, 84, 82), (110, 108, 106)], 12)
    return put_down(
        [
            (join(core), iron),
            (coil, textures.speckles(look.rng, color, 4)),
            (join(ears), steel(look)),
            (join(wires), plain(look.own_color("red", "black", "blue"))),
        ],
        join(core),
        coil,
        *ears,
        factor=k,
    )


def inductor(look: Look) -> Shape:
    """A ring core wound with copper wire, lying, its two ends out."""
    color = look.color("copper", "bronze", "green", "red")
    k = look.between(0.8, 1.4)
    core = torus(0.013, 0.0052, 28, 8).scale(1, 1, 1.15).move(z=0.006)
    turns = [
        torus(0.0062, 0.0009, 12, 5)
        .scale(1, 1, 1)
        .turn(0, np.pi / 2)
        .move(0.013, 0, 0.0067)
        .turn(2, n * 2 * np.pi / 22)
        for n in range(20)
    ]
    ends = [
        rod(
            [(0.013, s * 0.006, 0.004), (0.024, s * 0.008, 0.001), (0.036, s * 0.007, 0.0008)],
            0.0008,
            6,
        )
        for s in (-1, 1)
    ]
    tone = look.own_color("yellow", "green", "gray", "sky")
    return put_down(
        [(core, plain(tone)), (join([*turns, *ends]), steel(look, color))],
        core,
        join(turns),
        *ends,
        factor=k,
    )


def transistor(look: Look) -> Shape:
    """A transistor lying: a half-round head, three legs."""
    color = look.color("black", "charcoal")
    big = look.chance(0.5)
    k = look.between(0.9, 1.6)
    if big:
        body = at_box(0.01, 0.0095, 0.0045, (0.0, 0, 0))
        tab = plate(rectangle(0.0065, 0.01, 0.0004), 0.0013, at=(0.008, 0, 0))
        hole = drum(0.0019, 0.0003, (0.0085, 0, 0.0012), sides=12)
        legs = [at_box(0.013, 0.001, 0.0006, (-0.0112, y, 0.0012)) for y in (-0.0025, 0, 0.0025)]
    else:
        body = drum(0.0026, 0.005, (-0.0025, 0, 0.0024), 0, sides=14)
        tab = at_box(0.005, 0.005, 0.0012, (0, 0, 0))
        hole = at_box(0.0002, 0.0002, 0.0003, (0, 0, 0.0005))
        legs = [
            straight((-0.0022, 0, 0.002), (-0.016, y, 0.0005), 0.0004, 5)
            for y in (-0.0025, 0, 0.0025)
        ]
    image = textures.speckles(look.rng, color, 4)
    return put_down(
        [
            (body, image),
            (tab, steel(look) if big else image),
            (join(legs), steel(look)),
            (hole, plain(DARK)),
        ],
        join([body, tab]),
        join(legs),
        factor=k,
    )


def fuse(look: Look) -> Shape:
    """A glass fuse lying: two metal caps and a fine wire between."""
    color = look.color("clear", "white", "sky", "amber")
    k = look.between(0.9, 1.6)
    glass = drum(0.0026, 0.014, (-0.007, 0, 0.003), 0, sides=16)
    wire = straight((-0.007, -0.0004, 0.0056), (0.007, 0.0004, 0.0056), 0.0002, 5)
    caps = [drum(0.003, 0.0055, (x, 0, 0.003), 0, sides=16) for x in (-0.0105, 0.005)]
    return put_down(
        [
            (glass, plain(color)),
            (wire, plain((110, 90, 60))),
            (join(caps), steel(look, look.pick([STEEL_TONE, BRASS_TONE]))),
        ],
        join([glass, *caps]),
        factor=k,
        foot=0.4,
    )


def valve_tube(look: Look) -> Shape:
    """A radio valve standing: a glass bulb with metal plates on a base with pins."""
    color = look.color("black", "brown", "cream", "silver")
    k = look.between(0.9, 1.25)
    base = drum(0.0145, 0.016, (0, 0, 0.008), sides=24, bevel=0.001)
    pins = [
        drum(0.0014, 0.009, (0.009 * np.cos(a), 0.009 * np.sin(a), 0), sides=8)
        for a in np.arange(8) * np.pi / 4
    ]
    bulb = standing(
        (0.013, 0),
        (0.0145, 0.01),
        (0.0145, 0.042),
        (0.011, 0.054),
        (0.003, 0.059),
        at=(0, 0, 0.023),
        sides=26,
    )
    bands = textures.stack(
        (plain((196, 212, 214)), 0.24),
        (plain((96, 98, 102)), 0.4),
        (plain((188, 204, 208)), 0.1),
        (steel(look, (206, 208, 214)), 0.26),
    )
    plates = [
        at_box(0.012, 0.003, 0.026, (0, -0.0135, 0.034)),
        at_box(0.003, 0.006, 0.034, (0, -0.0137, 0.03)),
    ]
    tip = drum(0.0015, 0.004, (0, 0, 0.081), top=0.0004, sides=8)
    return put_down(
        [
            (base, look.surface(color, "plastic")),
            (join(pins), steel(look)),
            (bulb, bands),
            (join(plates), plain((70, 72, 78))),
            (tip, plain((200, 214, 216))),
        ],
        base,
        join(pins),
        bulb,
        factor=k,
    )


CATEGORIES = (
    Category("relay", relay, (0.0215, 0.0175, 0.0211), 0.012, ("power relay", "relay module"),
             ("electronics",), (), ("blue",)),
    Category("transformer", transformer, (0.0933, 0.073, 0.0521), 0.25, ("mains transformer",
             "electric transformer"), ("electronics",), (), ("yellow",)),
    Category("inductor", inductor, (0.0637, 0.0451, 0.0156), 0.012, ("copper coil", "choke coil",
             "toroidal coil", "wire coil"), ("electronics",), (),
             ("copper",)),
    Category("transistor", transistor, (0.027, 0.0088, 0.00573), 0.002, ("mosfet",
             "power transistor", "voltage regulator"), ("electronics",), (), ("black",)),
    Category("fuse", fuse, (0.0258, 0.00738, 0.00738), 0.002, ("glass fuse", "fuse holder"),
             ("electronics",), (), ("clear",)),
    Category("vacuum_tube", valve_tube, (0.0321, 0.0346, 0.0942), 0.035, ("radio valve",
             "electron tube", "valve tube", "radio tube"), ("electronics",), ("tall",),
             ("black",)),
)  # fmt: skip
"""The module's categories."""
