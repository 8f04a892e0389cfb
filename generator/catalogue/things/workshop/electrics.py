"""Parts for circuits: switches, relays, coils, valves, cells, clips, displays, probes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.outlines import rectangle
from ...build.recipes import put_down, rod, straight
from ...build.shape import Shape
from ...build.sketch import BRASS, DARK, STEEL, bar, cut, disc, lies, plain, steel, turned
from ...build.solids import Solid, block, join, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _pins(places: list[tuple[float, float]], deep: float = 0.006, thick: float = 0.0012) -> Solid:
    """Return pins that reach down from ``deep`` to the table."""
    return join([bar(thick, thick, deep, (x, y, 0)) for x, y in places])


def toggle_switch(look: Look) -> Shape:
    """A toggle switch: a body with lugs, a threaded bush and a bat lever."""
    color = look.color("red", "blue", "black", "green")
    k = look.between(0.9, 1.5)
    body = bar(0.028, 0.016, 0.018, (0, 0, 0.007))
    top = bar(0.028, 0.016, 0.002, (0, 0, 0.0245))
    bush = disc(0.006, 0.011, (0, 0, 0.026), fine=16)
    nut = disc(0.009, 0.0025, (0, 0, 0.028), fine=6)
    lean = 0.35 * look.pick([-1, 1])
    lever = (
        turned([(0.0022, 0), (0.0022, 0.006), (0.0036, 0.018), (0.002, 0.022)], fine=12)
        .turn(1, lean)
        .move(z=0.036)
    )
    pins = join([bar(0.0012, 0.004, 0.008, (x, 0, 0)) for x in (-0.009, 0, 0.009)])
    return put_down(
        [(body, plain(color)), (join([top, bush, nut, lever, pins]), steel(look))],
        body,
        bush,
        pins,
        factor=k,
    )


def rocker_switch(look: Look) -> Shape:
    """A rocker switch in its frame, marked 0 and 1."""
    color = look.color("black", "red", "green", "white")
    k = look.between(0.9, 1.4)
    body = bar(0.028, 0.02, 0.02, (0, 0, 0.006))
    frame = block(0.034, 0.026, 0.004, 0.002, 0.001).move(z=0.025)
    rock = [
        bar(0.014, 0.018, 0.004, (0, 0, 0)).turn(1, s * 0.28).move(s * 0.007, 0, 0.028 + 0.001 * s)
        for s in (-1, 1)
    ]
    marks = [
        bar(0.001, 0.006, 0.0006, (0.008, 0, 0.0318)),
    ]
    zero = torus(0.003, 0.0006, 14, 5).turn(1, -0.25).move(-0.008, 0, 0.0322)
    pins = join([bar(0.0012, 0.005, 0.008, (x, 0, 0)) for x in (-0.008, 0.008)])
    return put_down(
        [
            (join([body, frame]), plain((44, 44, 48))),
            (join(rock), plain(color)),
            (join([*marks, zero]), plain((240, 240, 240) if sum(color) < 560 else (40, 40, 44))),
            (pins, steel(look)),
        ],
        body,
        frame,
        pins,
        factor=k,
    )


def potentiometer(look: Look) -> Shape:
    """A potentiometer: a round can with three lugs and a shaft, with its knob or without."""
    color = look.color("silver", "blue", "green", "black")
    k = look.between(0.9, 1.35)
    can = disc(0.0125, 0.011, fine=24, bevel=0.001)
    lugs = [
        cut(
            [
                (x - 0.0014, -0.012),
                (x + 0.0014, -0.012),
                (x + 0.0014, -0.021),
                (x - 0.0014, -0.021),
            ],
            0.001,
            (0, 0, 0.003),
        )
        for x in (-0.005, 0, 0.005)
    ]
    bush, nut = (
        disc(0.0045, 0.009, (0, 0, 0.011), fine=16),
        disc(0.0075, 0.002, (0, 0, 0.013), fine=6),
    )
    shaft = disc(0.003, 0.014, (0, 0, 0.018), fine=14)
    pieces = [(can, look.surface(color, "metal")), (join([*lugs, bush, nut, shaft]), steel(look))]
    if look.chance(0.5):
        pieces += [
            (disc(0.0095, 0.012, (0, 0, 0.023), top=0.008, fine=20), plain(DARK)),
            (bar(0.0014, 0.008, 0.0008, (0, 0.003, 0.0347)), plain((240, 240, 240))),
        ]
    return put_down(pieces, can, shaft, *(p[0] for p in pieces[2:3]), factor=k)


def knob(look: Look) -> Shape:
    """A round knob with a ribbed rim and a pointer line."""
    color = look.color("black", "silver", "red", "cream", "blue", "brown")
    k = look.between(0.8, 1.6)
    skirt = disc(0.018, 0.004, fine=28, bevel=0.001)
    body = disc(0.0145, 0.016, (0, 0, 0.003), top=0.013, fine=24)
    ribs = [
        bar(0.0024, 0.0018, 0.014, (0.0142, 0, 0.004)).turn(2, n * np.pi / 10) for n in range(20)
    ]
    cap = disc(0.0105, 0.0012, (0, 0, 0.0186), fine=24)
    line = bar(0.0018, 0.008, 0.0014, (0, 0.008, 0.0188))
    paint = look.surface(color, "plastic")
    return put_down(
        [(join([skirt, body, *ribs]), paint), (cap, steel(look)), (line, plain((240, 60, 50)))],
        skirt,
        body,
        factor=k,
    )


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
    face = bar(0.0185, 0.015, 0.0005, (0, 0, 0.0182))
    pins = _pins(
        [(-0.007, 0), (-0.007, 0.006), (-0.007, -0.006), (0.007, 0.005), (0.007, -0.005)], 0.004
    )
    return put_down(
        [(body, plain(color)), (face, image), (pins, steel(look))], body, pins, factor=k
    )


def transformer(look: Look) -> Shape:
    """A small transformer: laminated iron round a taped coil, with mounting ears."""
    color = look.color("yellow", "amber", "red", "blue")
    k = look.between(0.85, 1.25)
    core = [bar(0.056, 0.022, 0.01, (0, 0, z)) for z in (0.0, 0.038)]
    core += [bar(0.01, 0.022, 0.048, (x, 0, 0)) for x in (-0.023, 0.023)]
    coil = block(0.034, 0.042, 0.029, 0.008, 0.002).move(z=0.0095)
    ears = [bar(0.016, 0.022, 0.0016, (s * 0.035, 0, 0)) for s in (-1, 1)]
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
        body = bar(0.01, 0.0095, 0.0045, (0.0, 0, 0))
        tab = cut(rectangle(0.0065, 0.01, 0.0004), 0.0013, (0.008, 0, 0))
        hole = disc(0.0019, 0.0003, (0.0085, 0, 0.0012), fine=12)
        legs = [bar(0.013, 0.001, 0.0006, (-0.0112, y, 0.0012)) for y in (-0.0025, 0, 0.0025)]
    else:
        body = disc(0.0026, 0.005, (-0.0025, 0, 0.0024), 0, fine=14)
        tab = bar(0.005, 0.005, 0.0012, (0, 0, 0))
        hole = bar(0.0002, 0.0002, 0.0003, (0, 0, 0.0005))
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
    glass = disc(0.0026, 0.014, (-0.007, 0, 0.003), 0, fine=16)
    wire = straight((-0.007, -0.0004, 0.0056), (0.007, 0.0004, 0.0056), 0.0002, 5)
    caps = [disc(0.003, 0.0055, (x, 0, 0.003), 0, fine=16) for x in (-0.0105, 0.005)]
    return put_down(
        [
            (glass, plain(color)),
            (wire, plain((110, 90, 60))),
            (join(caps), steel(look, look.pick([STEEL, BRASS]))),
        ],
        join([glass, *caps]),
        factor=k,
        foot=0.4,
    )


def valve_tube(look: Look) -> Shape:
    """A radio valve standing: a glass bulb with metal plates on a base with pins."""
    color = look.color("black", "brown", "cream", "silver")
    k = look.between(0.9, 1.25)
    base = disc(0.0145, 0.016, (0, 0, 0.008), fine=24, bevel=0.001)
    pins = [
        disc(0.0014, 0.009, (0.009 * np.cos(a), 0.009 * np.sin(a), 0), fine=8)
        for a in np.arange(8) * np.pi / 4
    ]
    bulb = turned(
        [(0.013, 0), (0.0145, 0.01), (0.0145, 0.042), (0.011, 0.054), (0.003, 0.059)],
        (0, 0, 0.023),
        26,
    )
    bands = textures.stack(
        (plain((196, 212, 214)), 0.24),
        (plain((96, 98, 102)), 0.4),
        (plain((188, 204, 208)), 0.1),
        (steel(look, (206, 208, 214)), 0.26),
    )
    plates = [
        bar(0.012, 0.003, 0.026, (0, -0.0135, 0.034)),
        bar(0.003, 0.006, 0.034, (0, -0.0137, 0.03)),
    ]
    tip = disc(0.0015, 0.004, (0, 0, 0.081), top=0.0004, fine=8)
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


def solar_panel(look: Look) -> Shape:
    """A small solar panel lying, with two wires."""
    color = look.color("navy", "black", "blue")
    x, y = look.between(0.09, 0.15), look.between(0.07, 0.1)
    base, face = block(x, y, 0.004, 0.003, 0.0008), bar(0.95 * x, 0.94 * y, 0.0008, (0, 0, 0.0037))
    cells = textures.grid((196, 204, 214), color, 4, int(look.pick([4, 6])), 160, 3)
    fine = cells.copy()
    fine[::10] = np.clip(fine[::10].astype(int) + 26, 0, 255)
    wires = [
        rod(
            [
                (x / 2 - 0.004, s * 0.006, 0.002),
                (x / 2 + 0.015, s * 0.01, 0.002),
                (x / 2 + 0.035, s * 0.004 - 0.012, 0.0013),
            ],
            0.0012,
            6,
        )
        for s in (-1, 1)
    ]
    return put_down(
        [
            (base, plain((226, 228, 230) if look.chance(0.5) else (50, 52, 58))),
            (face, fine),
            (wires[0], plain((200, 40, 40))),
            (wires[1], plain((34, 34, 38))),
        ],
        base,
        *wires,
    )


def segment_display(look: Look) -> Shape:
    """A seven-segment display module with lit digits."""
    color = look.color("red", "green", "blue", "yellow")
    k = look.between(0.85, 1.2)
    n = look.pick([1, 2, 4])
    x = 0.016 * n + 0.004
    body = block(x, 0.024, 0.01, 0.001, 0.0005).move(z=0.003)
    image = prints.canvas(64 * n, 96, (40, 36, 36))
    dim = tint_color(color, 0.28)
    shapes = {
        0: "abcdef",
        1: "bc",
        2: "abged",
        3: "abgcd",
        4: "fgbc",
        5: "afgcd",
        6: "afgedc",
        7: "abc",
        8: "abcdefg",
        9: "abcdfg",
    }
    places = {
        "a": (0.2, 0.12, 0.5, 0.08),
        "d": (0.2, 0.8, 0.5, 0.08),
        "g": (0.2, 0.46, 0.5, 0.08),
        "f": (0.16, 0.18, 0.12, 0.3),
        "b": (0.64, 0.18, 0.12, 0.3),
        "e": (0.16, 0.52, 0.12, 0.3),
        "c": (0.64, 0.52, 0.12, 0.3),
    }
    for d in range(n):
        lit = shapes[int(look.rng.integers(10))]
        for name, (u, v, w, h) in places.items():
            prints.fill(
                image, (d + u) / n, v, w / n, h, tint_color(color, 1.25) if name in lit else dim
            )
        prints.disc(image, (d + 0.88) / n, 0.85, 0.05, dim)
    face = bar(0.98 * x, 0.0235, 0.0006, (0, 0, 0.0127))
    pins = _pins(
        [(u, s * 0.009) for u in np.linspace(-0.4 * x, 0.4 * x, 5) for s in (-1, 1)], 0.004, 0.0008
    )
    return put_down(
        [
            (body, plain((232, 230, 224) if look.chance(0.4) else (50, 50, 54))),
            (face, image),
            (pins, steel(look)),
        ],
        body,
        pins,
        factor=k,
    )


def lcd_module(look: Look) -> Shape:
    """A character display on its board: two lines of text in a metal frame."""
    color = look.color("blue", "lime", "green")
    k = look.between(0.9, 1.15)
    board, frame = (
        block(0.08, 0.036, 0.0016, 0.001).move(z=0.004),
        bar(0.071, 0.026, 0.007, (0, 0, 0.0052)),
    )
    glass = bar(0.064, 0.0155, 0.0006, (0, 0, 0.0119))
    image = prints.canvas(192, 48, color)
    ink = (240, 246, 255) if sum(color) < 340 else (40, 56, 30)
    prints.write(
        image, look.pick(["HELLO WORLD", "TEMP 21.5 C", "READY", "TIME 12:04"]), 0.5, 0.3, 0.34, ink
    )
    prints.write(
        image, look.pick(["TABLETOP", "VOLTS 4.97", "> START", "OK"]), 0.5, 0.72, 0.34, ink
    )
    pads = [disc(0.0009, 0.0004, (-0.036 + 0.0025 * n, 0.0158, 0.0055), fine=8) for n in range(16)]
    posts = [
        disc(0.003, 0.0045, (sx * 0.036, sy * 0.0145, 0), fine=10)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return put_down(
        [
            (join([board, *posts]), plain((40, 110, 70))),
            (frame, plain(DARK)),
            (glass, image),
            (join(pads), plain(BRASS)),
        ],
        board,
        frame,
        *posts,
        factor=k,
    )


def coin_cell(look: Look) -> Shape:
    """A button cell lying, its plus side up."""
    color = look.color("silver", "gray", "gold")
    r = look.between(0.0055, 0.0115)
    h = look.between(0.2, 0.42) * r
    body = disc(r, h, fine=28, bevel=0.12 * h)
    face = disc(0.86 * r, 0.0004, (0, 0, h - 0.00015), fine=28)
    image = prints.canvas(96, 96, color)
    ink = tint_color(color, 0.6)
    prints.write(
        image, look.pick(["CR2032", "LR44", "CR2025", "SR626"]), 0.5, 0.62, 0.16, ink, bold=True
    )
    prints.write(image, "+", 0.5, 0.32, 0.3, ink, bold=True)
    return put_down([(body, steel(look, color)), (face, image)], body)


def crocodile_clip(look: Look) -> Shape:
    """A crocodile clip lying, its sleeve coloured, its jaws toothed, a lead behind."""
    color = look.color("red", "black", "green", "yellow", "blue", "white")
    k = look.between(0.9, 1.5)
    teeth = [(0.016 - 0.002 * n, 0.0002 + 0.0009 * (n % 2)) for n in range(7)]
    rim = np.array([(0, 0), (0.004, 0.0028), (0.018, 0.0022), (0.021, 0), (0.018, 0.0005), *teeth])
    upper, lower = (cut(rim * [1, s] + [0, s * 0.0003], 0.0045) for s in (1, -1))
    sleeve = rod(
        [(-0.026, 0, 0.0042), (-0.012, 0, 0.0045), (0.004, 0, 0.0045)], [0.0032, 0.0046, 0.0048], 10
    )
    tail = rod([(-0.025, 0, 0.0038), (-0.036, 0.003, 0.0016), (-0.048, 0, 0.0013)], 0.0013, 8)
    return put_down(
        [
            (join([upper.move(z=0.002), lower.move(z=0.002)]), steel(look)),
            (join([sleeve, tail]), plain(color)),
        ],
        sleeve,
        join([upper.move(z=0.002), lower.move(z=0.002)]),
        tail,
        factor=k,
        foot=0.3,
    )


def banana_plug(look: Look) -> Shape:
    """A banana plug lying: a coloured grip and a sprung tip."""
    color = look.color("red", "black", "yellow", "green", "blue")
    k = look.between(0.9, 1.4)
    grip = disc(0.0048, 0.026, (-0.026, 0, 0.0055), 0, fine=16, bevel=0.001)
    ribs = [
        torus(0.0048, 0.0006, 16, 5).turn(1, np.pi / 2).move(-0.022 + 0.004 * n, 0, 0.0055)
        for n in range(4)
    ]
    collar = disc(0.0056, 0.004, (-0.002, 0, 0.0055), 0, fine=16)
    tip = lies(
        turned(
            [(0.002, 0), (0.0024, 0.004), (0.003, 0.01), (0.0022, 0.017), (0.001, 0.019)], fine=14
        ),
        0.0,
        0,
        0.0055,
    )
    return put_down(
        [(join([grip, *ribs, collar]), plain(color)), (tip, steel(look))],
        grip,
        collar,
        tip,
        factor=k,
        foot=0.3,
    )


def battery_holder(look: Look) -> Shape:
    """A plastic tray for round cells, with springs and two wires."""
    color = look.color("black", "charcoal", "white")
    k = look.between(0.9, 1.1)
    base = bar(0.062, 0.034, 0.002)
    walls = [bar(0.062, 0.002, 0.013, (0, s * 0.016, 0)) for s in (-1, 1)] + [
        bar(0.002, 0.034, 0.014, (s * 0.03, 0, 0)) for s in (-1, 1)
    ]
    rib = bar(0.058, 0.0015, 0.006, (0, 0, 0.0015))
    coils = [
        disc(0.004, 0.006, (-0.029, 0.008, 0.0075), 0, top=0.002, fine=12),
        disc(0.004, 0.006, (0.023, -0.008, 0.0075), 0, fine=12),
    ]
    wires = [
        rod([(0.03, y, 0.006), (0.045, y + 0.002, 0.003), (0.065, y - 0.006, 0.0013)], 0.0012, 6)
        for y in (-0.008, 0.008)
    ]
    return put_down(
        [
            (join([base, *walls, rib]), plain(color)),
            (join(coils), steel(look)),
            (wires[0], plain((206, 40, 40))),
            (wires[1], plain((30, 30, 34))),
        ],
        base,
        *walls,
        *wires,
        factor=k,
    )


CATEGORIES = (
    Category("toggle_switch", toggle_switch, (0.0347, 0.0223, 0.071), 0.02, ("lever switch",
             "switch"), ("electronics",), (), ("red", "blue")),
    Category("rocker_switch", rocker_switch, (0.0382, 0.0292, 0.0391), 0.012, ("power switch",
             "push switch", "dip switch", "on-off switch"), ("electronics",), (),
             ("black",)),
    Category("potentiometer", potentiometer, (0.0278, 0.0373, 0.0366), 0.015, ("rotary encoder",
             "encoder", "trimmer potentiometer", "variable resistor"),
             ("electronics",), (), ("silver",)),
    Category("knob", knob, (0.0385, 0.0385, 0.0216), 0.012, ("control knob", "drawer knob",
             "volume knob", "dial knob", "doorknob", "cabinet knob",
             "dial"), ("electronics",), ("round",), ("black",)),
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
    Category("solar_panel", solar_panel, (0.153, 0.0831, 0.0045), 0.06, ("solar cell",
             "mini solar panel", "photovoltaic panel"), ("electronics",), ("flat",), ("navy",)),
    Category("segment_display", segment_display, (0.0373, 0.0245, 0.0136), 0.012,
             ("seven-segment display", "seven segment display", "digit display",
             "led display", "7-segment display"), ("electronics",), (), ("red",)),
    Category("lcd_module", lcd_module, (0.0846, 0.0381, 0.0132), 0.035, ("lcd display", "lcd",
             "character display", "lcd screen", "oled display", "display module"),
             ("electronics",), ("flat",), ("blue", "green")),
    Category("coin_cell", coin_cell, (0.0161, 0.0161, 0.0029), 0.003, ("button cell",
             "button battery", "coin battery", "watch battery"), ("electronics",), ("flat",),
             ("silver",)),
    Category("crocodile_clip", crocodile_clip, (0.0754, 0.0104, 0.00986), 0.006,
             ("alligator clip", "croc clip", "crocodile lead", "test clip", "oscilloscope probe"),
             ("electronics",), (), ("red", "black")),
    Category("banana_plug", banana_plug, (0.051, 0.0127, 0.0126), 0.008, ("banana connector",
             "4 mm plug"), ("electronics",), (), ("red", "black")),
    Category("battery_holder", battery_holder, (0.0979, 0.0345, 0.0142), 0.015, ("battery tray",
             "battery case", "battery slot", "cell holder"), ("electronics",), (),
             ("black",)),
)  # fmt: skip
"""The module's categories."""
