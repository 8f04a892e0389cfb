"""Electronics of a bench and its small parts: boards, a scope, sticks, chargers, cells, bulbs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

WIRES = ("red", "black", "blue", "green", "yellow", "orange", "white")
DARK: RGB = (36, 37, 41)


def breadboard(look: Look) -> Shape:
    """A solderless breadboard: rows of holes, coloured rails, wires and parts plugged in."""
    x, y, h = look.pick([(0.165, 0.055, 0.0095), (0.083, 0.055, 0.0095)])
    color = look.color("white", "white", "white", "cream", "sky", "black", "red", "green")
    image = prints.canvas(int(x * 2400), 132, color)
    wide = image.shape[1]
    hole = tint_color(color, 0.4) if sum(color) > 300 else (120, 120, 124)
    for row in (0.06, 0.12, 0.88, 0.94, *np.linspace(0.24, 0.43, 5), *np.linspace(0.57, 0.76, 5)):
        for column in range(int(x / 0.0029)):
            if row not in (0.06, 0.12, 0.88, 0.94) or column % 6 < 5:
                prints.fill(image, 0.02 + 0.0029 * column / x * 0.97, row - 0.012,
                            3 / wide, 0.024, hole)  # fmt: skip
    for v, tone in ((0.03, (206, 50, 50)), (0.15, (50, 80, 190)), (0.85, (206, 50, 50)),
                    (0.97, (50, 80, 190))):  # fmt: skip
        prints.fill(image, 0.02, v - 0.004, 0.96, 0.01, tone)
    prints.fill(image, 0, 0.475, 1, 0.05, tint_color(color, 0.78))
    base = box(x, y, h - 0.0004)
    top = box(x, y, 0.0006).move(z=h - 0.0006)
    pieces: list[tuple[Solid, textures.Tile]] = [(base, textures.plain(color)), (top, image)]
    parts = [box_part(x, y, h)]
    if look.chance(0.8):
        for _ in range(int(look.rng.integers(1, 3))):
            u = look.between(-0.3, 0.3) * x
            chip = box(0.022, 0.0075, 0.004).move(x=u, z=h + 0.001)
            legs = box(0.02, 0.0095, 0.0014).move(x=u, z=h - 0.0002)
            pieces += [(chip, textures.plain(DARK)), (legs, textures.plain((190, 192, 198)))]
        for _ in range(int(look.rng.integers(3, 7))):
            a = np.array([look.between(-0.42, 0.42) * x, look.between(-0.3, 0.3) * y, h])
            b = np.array([look.between(-0.42, 0.42) * x, look.between(-0.3, 0.3) * y, h])
            mid = (a + b) / 2 + [0, 0, look.between(0.008, 0.018)]
            wire = tube(smooth([a, mid, b], 5), 0.0008, 5)
            pieces.append((wire, textures.plain(look.own_color(*WIRES))))
        for _ in range(int(look.rng.integers(1, 4))):
            at = (look.between(-0.4, 0.4) * x, look.between(-0.25, 0.25) * y, h)
            bulb = lathe([(0, 0.004), (0.0027, 0.004), (0.0027, 0.008), (0.0015, 0.0105),
                          (0, 0.011)], 12)  # fmt: skip
            leads = tube([(0, 0, 0), (0, 0, 0.005)], 0.0006, 5)
            pieces += [(bulb.move(*at), textures.plain(look.own_color("red", "green", "yellow"))),
                       (leads.move(*at), textures.plain((190, 192, 198)))]  # fmt: skip
    return shape(pieces, parts)


def circuit_board(look: Look) -> Shape:
    """A microcontroller or single-board computer: chips, headers, plugs on a printed board."""
    x, y = look.pick([(0.0686, 0.0534), (0.085, 0.056), (0.045, 0.018)])
    color = look.color("teal", "blue", "green", "navy", "red", "purple", "black")
    base = tint_color(color, 0.72)
    image = prints.canvas(192, int(192 * y / x), base)
    for _ in range(46):
        a, b = look.rng.uniform(0.03, 0.97, 2)
        dx, dy = look.rng.choice([-1, 1], 2) * look.rng.uniform(0.03, 0.12, 2)
        way = [(a, b), (a + dx, b), (a + dx + 0.3 * dy, b + dy)]
        prints.stroke(image, way, 0.008, tint_color(color, 1.12))
    for _ in range(26):
        a, b = look.rng.uniform(0.04, 0.93, 2)
        prints.fill(
            image, a, b, 0.022, 0.02, look.pick([(40, 40, 44), (206, 190, 150), (180, 182, 188)])
        )
    for u in (0.03, 0.97):
        for v in (0.06, 0.94):
            prints.disc(image, u, v, 0.035, (212, 190, 110))
            prints.disc(image, u, v, 0.02, (240, 240, 236))
    prints.write(
        image, look.pick(["UNO", "PI", "NANO", "MCU", "IoT"]), 0.62, 0.6, 0.1, (244, 244, 244)
    )
    board = box(x, y, 0.0016).move(z=0.0024)
    top = box(x, y, 0.0002).move(z=0.004)
    feet = box(0.9 * x, 0.86 * y, 0.0024)
    z = 0.0042
    metal, dark = textures.plain((196, 198, 204)), textures.plain(DARK)
    tall = 0.0085 if y > 0.03 else 0.0022
    pins = [box(0.7 * x, 0.0045, tall).move(0.1 * x, s * (0.5 * y - 0.004), z) for s in (-1, 1)]
    chip = box(0.3 * min(x, 2 * y), 0.3 * min(x, 2 * y) * (0.4 if y < 0.03 else 1), 0.0016)
    chip = chip.move(0.08 * x, -0.04 * y if y > 0.03 else 0, z)
    usb = box(0.016, 0.012, 0.0105).move(-0.5 * x + 0.006, 0.24 * y, z)
    pieces = [
        (feet, textures.plain(tint_color(base, 0.8))),
        (board, textures.plain(base)),
        (top, image),
        (join([*pins, chip]), dark),
    ]
    parts = [box_part(x, y, 0.0042), *(hull_of(p) for p in pins)]
    if y > 0.03:
        jack = box(0.013, 0.009, 0.011).move(-0.5 * x + 0.005, -0.3 * y, z)
        cans = [cylinder(0.0034, 0.007, 14).move(-0.26 * x, v * y, z) for v in (-0.28, -0.12)]
        pieces += [(join([usb, *cans]), metal), (jack, dark)]
        if x > 0.08:
            pieces.append((join([box(0.017, 0.0145, 0.0155).move(0.5 * x - 0.007, v * y, z)
                                   for v in (-0.26, 0.26)]), metal))  # fmt: skip
            parts.append(box_part(0.017, 0.66 * y, 0.0155, (0.5 * x - 0.007, 0, z)))
        parts += [hull_of(usb), hull_of(jack)]
    else:
        plug = box(0.008, 0.009, 0.004).move(-0.5 * x + 0.003, 0, z)
        pieces.append((plug, metal))
        parts.append(hull_of(plug))
    return shape(pieces, parts)


def oscilloscope(look: Look) -> Shape:
    """A bench oscilloscope: a screen with traces, knobs, sockets, a handle on top."""
    x, y, h = look.between(0.28, 0.34), look.between(0.12, 0.15), look.between(0.14, 0.165)
    color = look.color("gray", "white", "beige", "charcoal", "navy", "silver")
    shell = textures.speckles(look.rng, color, 3, 32)
    face = prints.canvas(256, 128, tint_color(color, 0.86 if sum(color) > 300 else 1.2))
    prints.fill(face, 0.04, 0.1, 0.54, 0.72, (16, 22, 24))
    prints.fill(face, 0.05, 0.12, 0.52, 0.68, (20, 34, 36))
    for k in range(1, 10):
        prints.fill(face, 0.05 + 0.052 * k, 0.12, 0.002, 0.68, (54, 76, 76))
    for k in range(1, 8):
        prints.fill(face, 0.05, 0.12 + 0.085 * k, 0.52, 0.004, (54, 76, 76))
    t = np.linspace(0, 1, 80)
    pace, phase = look.between(2, 5), look.between(0, 6)
    wave = 0.36 + 0.14 * np.sin(2 * np.pi * pace * t + phase)
    prints.stroke(face, [(0.055 + 0.51 * u, v) for u, v in zip(t, wave, strict=True)], 0.014,
                  look.pick([(250, 220, 60), (90, 240, 120)]))  # fmt: skip
    square = 0.66 + 0.06 * np.sign(np.sin(2 * np.pi * pace * t))
    prints.stroke(face, [(0.055 + 0.51 * u, v) for u, v in zip(t, square, strict=True)], 0.012,
                  (90, 210, 240))  # fmt: skip
    for k in range(6):
        prints.fill(face, 0.6, 0.13 + 0.115 * k, 0.035, 0.07, (226, 228, 230))
    front = box(x, 0.004, h).move(y=-y / 2 - 0.002, z=0.014)
    body = block(x, y, h, 0.008, 0.002).move(z=0.014)
    dark = textures.plain((52, 54, 60))
    knob = facing(lathe([(0, 0), (0.011, 0), (0.0105, 0.014), (0, 0.014)], 18))
    small = facing(lathe([(0, 0), (0.0075, 0), (0.007, 0.011), (0, 0.011)], 14))
    knobs = [knob.move(u * x, -y / 2 - 0.003, 0.014 + 0.72 * h) for u in (0.2, 0.3, 0.41)]
    knobs += [small.move(u * x, -y / 2 - 0.003, 0.014 + 0.46 * h) for u in (0.18, 0.26, 0.34, 0.42)]
    plug = facing(lathe([(0, 0), (0.0095, 0), (0.0095, 0.003), (0.006, 0.003), (0.006, 0.014),
                         (0, 0.014)], 14))  # fmt: skip
    plugs = [plug.move(u * x, -y / 2 - 0.003, 0.014 + 0.16 * h) for u in (0.2, 0.31, 0.42)]
    grip = tube(smooth([(-0.4 * x, 0, h + 0.01), (-0.36 * x, 0, h + 0.04), (0.36 * x, 0, h + 0.04),
                        (0.4 * x, 0, h + 0.01)], 4), 0.007, 8)  # fmt: skip
    feet = [cylinder(0.01, 0.016, 12).move(sx * 0.4 * x, sy * 0.36 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    return shape(
        [
            (body, shell),
            (front, face),
            (join([*knobs, *feet, grip]), dark),
            (join(plugs), textures.plain((196, 198, 204))),
        ],
        [box_part(0.82 * x, 0.76 * y, 0.016), hull_of(body, front), hull_of(*knobs), hull_of(grip)],
    )


def battery(look: Look) -> Shape:
    """A round AA or AAA cell standing, or a rectangular 9 V block."""
    color = look.color("black", "gold", "green", "red", "blue", "orange", "silver", "yellow")
    steel = textures.plain((200, 202, 208))
    other = look.pick([(200, 150, 80), (206, 208, 212), (40, 40, 44), (230, 190, 60)])
    image = prints.canvas(128, 96, color)
    prints.fill(image, 0, 0, 1, 0.3, other)
    prints.write(image[:, 44:84], look.pick(["AA", "1.5V", "POWER", "ALKA"]), 0.5, 0.6, 0.2,
                 (250, 250, 248) if sum(color) < 400 else (30, 30, 34), bold=True)  # fmt: skip
    if look.chance(0.75):
        r, h = look.pick([(0.00725, 0.0505), (0.0165, 0.06), (0.013, 0.05)])
        body = lathe([(0, 0), (0.9 * r, 0), (r, 0.001), (r, 0.955 * h), (0.86 * r, 0.96 * h),
                      (0.4 * r, 0.962 * h), (0.38 * r, h), (0, h)], 24,
                     v=[0, 0, 0.02, 0.93, 0.95, 0.97, 0.99, 1])  # fmt: skip
        tile = textures.stack((steel, 2), (image, 91), (steel, 7), side=128)
        return shape([(body, tile)], [cylinder_part(r, 0.955 * h), cylinder_part(0.36 * r, h)])
    x, y, h = 0.0265, 0.0175, 0.0455
    body = block(x, y, h, 0.002, 0.0005)
    snaps = [cylinder(0.003, 0.0025, 12).move(x=-0.0063, z=h),
             lathe([(0, 0), (0.0042, 0), (0.0044, 0.0025), (0.003, 0.0025), (0.003, 0.001),
                    (0, 0.001)], 6).move(x=0.0063, z=h)]  # fmt: skip
    panel = box(x, 0.0004, 0.9 * h).move(y=-y / 2 - 0.0001, z=0.05 * h)
    front = image[:, 34:94].copy()
    return shape([(body, textures.plain(color)), (panel, front), (join(snaps), steel)],
                 [box_part(x, y, h), hull_of(*snaps)])  # fmt: skip


def light_bulb(look: Look) -> Shape:
    """A light bulb lying on its side: clear, white or amber glass and a screw base."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "amber", "clear", "golden", "sky")
    t = np.linspace(0.16 * np.pi, np.pi, 12)
    ball = [(0.03 * k * np.sin(a), 0.078 * k - 0.03 * k * np.cos(a) * 1.02) for a in t]
    ball[-1] = (0.0, ball[-1][1])
    glass = lathe([(0, 0.026 * k), (0.0125 * k, 0.026 * k), (0.014 * k, 0.036 * k), *ball], 26)
    a = np.linspace(0, 4 * 2 * np.pi, 40)
    thread = tube(np.column_stack([0.0132 * k * np.cos(a), 0.0132 * k * np.sin(a),
                                   0.007 * k + 0.017 * k * a / a[-1]]), 0.0012 * k, 5)  # fmt: skip
    base = lathe(
        [
            (0, 0),
            (0.004, 0),
            (0.006, 0.004),
            (0.0128 * k, 0.006 * k),
            (0.0128 * k, 0.027 * k),
            (0, 0.027 * k),
        ],
        22,
    )
    down = [s.turn(1, np.pi / 2 + np.arctan2(0.0155, 0.095)).move(x=-0.05 * k)
            for s in (glass, thread, base)]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s in down)
    glass, thread, base = (s.move(z=-low) for s in down)
    shine = textures.gradient(tint_color(color, 1.05), tint_color(color, 1.3), look.rng, 2)
    metal = textures.plain((190, 188, 182))
    return shape([(glass, shine), (join([thread, base]), metal)],
                 [hull_of(base, thread), flat_foot(glass.vertices, 0.08)])  # fmt: skip


CATEGORIES = (
    Category("breadboard", breadboard, (0.114, 0.055, 0.0223), 0.08, ("electronics breadboard",
             "prototyping board", "solderless breadboard", "proto board", "protoboard"), ("lab",
             "workbench"), ("flat",), ("white",), state="lying flat"),
    Category("circuit_board", circuit_board, (0.065, 0.0367, 0.0134), 0.03, ("arduino",
             "arduino board", "raspberry pi", "microcontroller", "pcb", "motherboard",
             "development board", "electronics board", "arduino uno",
             "raspberry pi board", "printed circuit board", "microcontroller board",
             "esp32 board", "micro:bit", "network card", "microbit", "esp32"),
             ("lab", "workbench"), ("flat",),
             ("green", "blue"), state="lying flat"),
    Category("oscilloscope", oscilloscope, (0.31, 0.155, 0.21), 3.2, ("digital oscilloscope",
             "signal generator", "function generator", "logic analyser", "logic analyzer"),
             ("lab", "workbench"), ("big", "screen"), ("gray", "white")),
    Category("battery", battery, (0.0242, 0.0209, 0.0506), 0.05, ("aa battery", "aaa battery",
             "batteries", "9v battery", "d battery", "alkaline battery", "d cell", "c cell",
             "aa cell", "pack of batteries"), ("workbench", "office"),
             (), ("black", "gold")),
    Category("light_bulb", light_bulb, (0.105, 0.0577, 0.0576), 0.045, ("lightbulb", "bulb",
             "led bulb", "lamp bulb", "incandescent bulb"), ("workbench",), (), ("white", "amber"),
             state="lying down"),
)  # fmt: skip
"""The module's categories."""
