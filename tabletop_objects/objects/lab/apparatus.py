"""Objects of the ``lab`` theme: apparatus."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, shine, steel, wood
from ...kit.outlines import rectangle, smooth
from ...kit.parts import above, box_part, cylinder_part, hull_of
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    facing,
    lay_down,
    rod,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, in_sizes, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, sweep, torus, tube
from ...kit.surfaces import RGB, Look, plain, tint_color
from .labware import marks

WIRES = ("red", "black", "blue", "green", "yellow", "orange", "white")
DARK: RGB = (36, 37, 41)


@category("breadboard", size=(0.114, 0.055, 0.0223), mass=0.08, material="plastic", assembled=True,
          aliases=("electronics breadboard", "prototyping board", "solderless breadboard",
          "proto board", "protoboard"), themes=("lab", "workbench"), roles=("flat",),
          colors=("white",), state="lying flat")  # fmt: skip
def breadboard(look: Look) -> Shape:
    """A solderless breadboard with rows of holes, coloured rails, wires and plugged-in parts."""
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
    pieces: list[tuple[Solid, surfaces.Tile]] = [(base, surfaces.plain(color)), (top, image)]
    parts = [box_part(x, y, h)]
    if look.chance(0.8):
        for _ in range(int(look.rng.integers(1, 3))):
            u = look.between(-0.3, 0.3) * x
            chip = box(0.022, 0.0075, 0.004).move(x=u, z=h + 0.001)
            legs = box(0.02, 0.0095, 0.0014).move(x=u, z=h - 0.0002)
            pieces += [(chip, surfaces.plain(DARK)), (legs, surfaces.plain((190, 192, 198)))]
        for _ in range(int(look.rng.integers(3, 7))):
            a = np.array([look.between(-0.42, 0.42) * x, look.between(-0.3, 0.3) * y, h])
            b = np.array([look.between(-0.42, 0.42) * x, look.between(-0.3, 0.3) * y, h])
            mid = (a + b) / 2 + [0, 0, look.between(0.008, 0.018)]
            wire = tube(smooth([a, mid, b], 5), 0.0008, 5)
            pieces.append((wire, surfaces.plain(look.own_color(*WIRES))))
        for _ in range(int(look.rng.integers(1, 4))):
            at = (look.between(-0.4, 0.4) * x, look.between(-0.25, 0.25) * y, h)
            bulb = lathe([(0, 0.004), (0.0027, 0.004), (0.0027, 0.008), (0.0015, 0.0105),
                          (0, 0.011)], 12)  # fmt: skip
            leads = tube([(0, 0, 0), (0, 0, 0.005)], 0.0006, 5)
            pieces += [(bulb.move(*at), surfaces.plain(look.own_color("red", "green", "yellow"))),
                       (leads.move(*at), surfaces.plain((190, 192, 198)))]  # fmt: skip
    return shape(pieces, parts)


@category("circuit_board", size=(0.065, 0.0367, 0.0134), mass=0.03, material="plastic",
          assembled=True, aliases=("arduino", "arduino board", "raspberry pi", "microcontroller",
          "pcb", "motherboard", "development board", "electronics board", "arduino uno",
          "raspberry pi board", "printed circuit board", "microcontroller board", "esp32 board",
          "micro:bit", "network card", "microbit", "esp32"), themes=("lab", "workbench"),
          roles=("flat",), colors=("green", "blue"), state="lying flat")  # fmt: skip
def circuit_board(look: Look) -> Shape:
    """A microcontroller or single-board computer: a circuit board with chips, pins and sockets."""
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
    metal, dark = surfaces.plain((196, 198, 204)), surfaces.plain(DARK)
    tall = 0.0085 if y > 0.03 else 0.0022
    pins = [box(0.7 * x, 0.0045, tall).move(0.1 * x, s * (0.5 * y - 0.004), z) for s in (-1, 1)]
    chip = box(0.3 * min(x, 2 * y), 0.3 * min(x, 2 * y) * (0.4 if y < 0.03 else 1), 0.0016)
    chip = chip.move(0.08 * x, -0.04 * y if y > 0.03 else 0, z)
    usb = box(0.016, 0.012, 0.0105).move(-0.5 * x + 0.006, 0.24 * y, z)
    pieces = [(feet, surfaces.plain(tint_color(base, 0.8))), (board, surfaces.plain(base)),
              (top, image), (join([*pins, chip]), dark)]  # fmt: skip
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


@category("oscilloscope", size=(0.31, 0.155, 0.21), mass=3.2, material="device",
          aliases=("digital oscilloscope", "signal generator", "function generator",
          "logic analyser", "logic analyzer"), themes=("lab", "workbench"), roles=("big", "screen"),
          colors=("gray", "white"))  # fmt: skip
def oscilloscope(look: Look) -> Shape:
    """A bench oscilloscope with traces on its screen, knobs, sockets and a handle on top."""
    x, y, h = look.between(0.28, 0.34), look.between(0.12, 0.15), look.between(0.14, 0.165)
    color = look.color("gray", "white", "beige", "charcoal", "navy", "silver")
    shell = surfaces.speckles(look.rng, color, 3, 32)
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
    dark = surfaces.plain((52, 54, 60))
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
    return shape([(body, shell), (front, face), (join([*knobs, *feet, grip]), dark),
                  (join(plugs), surfaces.plain((196, 198, 204)))],
                 [box_part(0.82 * x, 0.76 * y, 0.016), hull_of(body, front), hull_of(*knobs),
                  hull_of(grip)])  # fmt: skip


STEEL: RGB = (186, 189, 194)


@category("bunsen_burner", size=(0.093, 0.081, 0.16), mass=0.5, material="metal", assembled=True,
          aliases=("gas burner", "lab burner", "bunsen"), themes=("lab",), roles=("tall",),
          colors=("charcoal",))  # fmt: skip
def bunsen_burner(look: Look) -> Shape:
    """A Bunsen burner, sometimes lit, with a base, a gas inlet and a barrel with an air ring."""
    k = look.between(0.9, 1.08)
    color = look.color("charcoal", "green", "black", "blue", "gray")
    foot = lathe(np.array([(0, 0), (0.04, 0), (0.041, 0.004), (0.036, 0.012), (0.014, 0.022),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    barrel = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.008, 0.13), (0.0092, 0.132),
                             (0.0092, 0.14), (0.0065, 0.14), (0.0065, 0.136), (0, 0.136)]) * k,
                                 22)  # fmt: skip
    collar = cylinder(0.0108 * k, 0.02 * k, 22).move(z=0.032 * k)
    inlet = lay_down(cylinder(0.0048 * k, 0.05 * k, 14), 0.005 * k, 0.03 * k)
    knob = lay_down(cylinder(0.009 * k, 0.008 * k, 12), -0.03 * k, 0.03 * k)
    spots = [box(0.006 * k, 0.001, 0.009 * k).move(y=-0.0106 * k, z=0.037 * k)]
    brass = surfaces.brushed_metal(look.rng, (204, 170, 96))
    steel = surfaces.brushed_metal(look.rng, STEEL)
    pieces = [(foot, look.surface(color, "metal")), (barrel, steel),
              (join([collar, inlet, knob]), brass), (join(spots),
                  surfaces.plain((30, 30, 32)))]  # fmt: skip
    if look.chance(0.4):
        flame = lathe(np.array([(0, 0.134), (0.005, 0.138), (0.0085, 0.15), (0.006, 0.172),
                                (0.001, 0.19), (0, 0.192)]) * k, 16)  # fmt: skip
        pieces.append((flame, surfaces.gradient((70, 120, 240), (150, 200, 250), look.rng)))
    return shape(pieces, [cylinder_part(0.04 * k, 0.011 * k), hull_of(foot),
                          cylinder_part(0.0092 * k, 0.12 * k, (0, 0, 0.02 * k)),
                          hull_of(collar), hull_of(inlet)])  # fmt: skip


@category("lab_tripod", size=(0.135, 0.124, 0.1305), mass=0.4, material="metal", assembled=True,
          aliases=("tripod stand", "heating tripod", "bunsen tripod", "laboratory tripod",
          "lab stand"), themes=("lab",), roles=("support", "tall"),
          colors=("charcoal",))  # fmt: skip
def lab_tripod(look: Look) -> Shape:
    """A tripod with a gauze mat, for heating."""
    k = look.between(0.9, 1.06)
    color = look.color("charcoal", "black", "gray", "silver")
    r, h = 0.062 * k, 0.13 * k
    ring = lathe([(0.82 * r, h - 0.006), (r, h - 0.006), (r, h), (0.82 * r, h)], 34, loop=True)
    legs = [tube([(1.22 * r * np.cos(a), 1.22 * r * np.sin(a), 0.0),
                  (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), h - 0.003)], 0.0042 * k, 8)
            for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    net = surfaces.fit(surfaces.grid((120, 122, 126), (186, 188, 192), 16, 16, 96), 96, 96).copy()
    prints.disc(net, 0.5, 0.5, 0.34, (232, 230, 224))
    mat = box(1.9 * r, 1.9 * r, 0.002).move(z=h)
    return shape([(join([ring, *legs]), look.surface(color, "metal")), (mat, net)],
                 [*(hull_of(s.bend(above)) for s in legs),
                     cylinder_part(r, 0.006, (0, 0, h - 0.006)),
                  hull_of(mat)])  # fmt: skip


@category("retort_stand", size=(0.115, 0.175, 0.365), mass=1.1, material="metal", assembled=True,
          aliases=("burette stand", "burette", "ring stand", "clamp stand", "buret",
          "laboratory stand"), themes=("lab",), roles=("tall", "big"),
          colors=("gray",))  # fmt: skip
def retort_stand(look: Look) -> Shape:
    """A stand with a rod and a clamp that holds a burette."""
    k = look.between(0.8, 0.95)
    color = look.color("gray", "green", "charcoal", "blue", "white")
    base = box(0.13 * k, 0.2 * k, 0.016 * k)
    rod = cylinder(0.0055 * k, 0.4 * k, 14).move(y=0.07 * k, z=0.014 * k)
    boss = block(0.022 * k, 0.03 * k, 0.03 * k, 0.004).move(y=0.07 * k, z=0.27 * k)
    arm = tube(np.array([(0, 0.07, 0.285), (0, -0.01, 0.285)]) * k, 0.0045 * k, 8)
    ring = lathe([(0.009 * k, 0), (0.014 * k, 0), (0.014 * k, 0.016 * k), (0.009 * k, 0.016 * k)],
        20,
                 loop=True).move(y=-0.022 * k, z=0.277 * k)  # fmt: skip
    glass = lathe(np.array([(0, 0.07), (0.0015, 0.07), (0.002, 0.09), (0.0085, 0.105),
                            (0.0085, 0.4), (0.0105, 0.404), (0, 0.404)]) * k, 20)  # fmt: skip
    glass = glass.move(y=-0.022 * k)
    tap = lay_down(cylinder(0.003 * k, 0.03 * k, 10), -0.015 * k, 0.096 * k).move(y=-0.022 * k)
    liquid = look.own_color(*LIQUIDS)
    fill = surfaces.stack((surfaces.plain(tint_color(liquid, 1.1)), 0.6), (marks(GLASS), 0.4))
    steel = surfaces.brushed_metal(look.rng, STEEL)
    return shape([(base, look.surface(color, "metal")), (join([rod, arm]), steel),
                  (join([boss, ring]), surfaces.plain((70, 72, 76))), (glass, fill),
                  (tap, surfaces.plain((206, 52, 46)))],
                 [hull_of(base), hull_of(rod), hull_of(boss, arm), hull_of(ring),
                     hull_of(glass)])  # fmt: skip


@category("balance_scale", size=(0.272, 0.12, 0.226), mass=0.7, material="metal", assembled=True,
          aliases=("beam balance", "balance", "scales of justice", "pan balance", "balance scales",
          "justice scales", "old scale"), themes=("lab",), roles=("tall", "big"),
          colors=("brass",))  # fmt: skip
def balance_scale(look: Look) -> Shape:
    """A beam balance with two hanging pans."""
    k = look.between(0.88, 1.06)
    metal = look.surface(look.color("brass", "gold", "silver", "copper", "black"), "metal")
    base = lathe(np.array([(0, 0), (0.06, 0), (0.062, 0.006), (0.05, 0.016), (0.012, 0.024),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    post = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.005, 0.06), (0.0065, 0.12), (0.005, 0.2),
                           (0.009, 0.215), (0.004, 0.228), (0, 0.232)]) * k, 18)  # fmt: skip
    tilt = look.between(-0.1, 0.1)
    beam = box(0.2 * k, 0.007 * k, 0.009 * k).turn(1, tilt).move(z=0.205 * k)
    pieces: list[Solid] = [base, post, beam]
    parts = [cylinder_part(0.06 * k, 0.008 * k), hull_of(base), hull_of(post), hull_of(beam)]
    for s in (-1, 1):
        x, top = s * 0.098 * k, (0.208 - s * 0.098 * np.tan(tilt)) * k
        bottom = top - 0.1 * k
        dish = lathe([(0, 0), (0.02 * k, 0.001), (0.04 * k, 0.01 * k), (0.041 * k, 0.012 * k),
                      (0.038 * k, 0.0115 * k), (0.02 * k, 0.003), (0, 0.002)], 26)  # fmt: skip
        pieces.append(dish.move(x=x, z=bottom))
        for a in np.arange(3) * 2 * np.pi / 3 + np.pi / 2:
            foot = (x + 0.039 * k * np.cos(a), 0.039 * k * np.sin(a), bottom + 0.011 * k)
            pieces.append(tube([foot, (x, 0, top)], 0.0009 * k, 5))
        parts += [cylinder_part(0.04 * k, 0.011 * k, (x, 0, bottom)),
                  box_part(0.012 * k, 0.012 * k, 0.088 * k,
                      (x, 0, bottom + 0.011 * k))]  # fmt: skip
    return shape([(join(pieces), metal)], parts)


@category("glass_prism", size=(0.0805, 0.034, 0.03), mass=0.09, material="glass", aliases=("prism",
          "optical prism", "light prism", "crystal prism", "triangular glass prism"),
          themes=("lab",), colors=("clear",))  # fmt: skip
@in_sizes(0.12)
def glass_prism(look: Look) -> Shape:
    """A triangular glass prism lying flat, with rainbow light in it."""
    k = look.between(0.88, 1.15)
    color = look.color("clear", "clear", "sky")
    long, side = 0.08 * k, 0.034 * k
    outline = np.array([(-side / 2, 0), (side / 2, 0), (0, 0.866 * side)])
    body = prism(outline, -long / 2, long / 2, 0.0008).turn(0, np.pi / 2).turn(2, np.pi / 2)
    tones = [(230, 60, 60), (240, 150, 50), (240, 220, 80), (90, 190, 100), (80, 130, 220),
             (150, 90, 200)]  # fmt: skip
    rainbow = surfaces.stripes([color, *(tint_color(t, 1.3) for t in tones)],
                               1, upright=True)  # fmt: skip
    return shape([(body, rainbow)], [hull_of(body)], opacity=0.78)


LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral", "red")
GLASS: RGB = (206, 222, 226)


@category("microscope", size=(0.13, 0.18, 0.33), mass=2.4, material="device", themes=("lab",),
          roles=("tall", "big"), colors=("white", "gray"), common=True)  # fmt: skip
def microscope(look: Look) -> Shape:
    """A microscope with a base, a stage, a curved arm and an eyepiece that faces the viewer."""
    body = look.color("white", "gray", "navy", "cream", "black", "teal", "red")
    tall, pair = look.between(0.9, 1.12), look.pick([0.0, 0.0, 0.017])
    shell, dark = surfaces.speckles(look.rng, body, 4), surfaces.plain((44, 46, 50))
    metal = surfaces.brushed_metal(look.rng, (176, 180, 186))
    foot = block(0.13, 0.17, 0.028, 0.03, 0.006)
    arm = sweep([(0, 0.06, 0.02), (0, 0.066, 0.12), (0, 0.05, 0.2), (0, 0.0, 0.245)],
                rectangle(0.045, 0.035, 0.01, 2))  # fmt: skip
    head = block(0.06, 0.07, 0.05, 0.012, 0.004).move(y=-0.01, z=0.225)
    tube = cylinder(0.016, 0.1, 16, bevel=0.003).turn(0, np.deg2rad(40)).move(y=-0.02, z=0.26)
    eye = join([tube.move(x=-pair), tube.move(x=pair)]) if pair else tube
    lens = cylinder(0.011, 0.075, 16, top=0.018).move(y=-0.012, z=0.15)
    stage = block(0.12, 0.1, 0.012, 0.008).move(y=-0.015, z=0.11)
    knob = cylinder(0.022, 0.1, 18, bevel=0.004).turn(1, np.pi / 2).move(-0.05, 0.055, 0.085)
    return shape([(foot, shell), (arm, shell), (head, shell), (eye, dark), (lens, metal),
                  (stage, dark), (knob, dark)], [box_part(0.13, 0.17, 0.028),
                                                 box_part(0.045, 0.045, 0.205, (0, 0.055, 0.028)),
                                                 box_part(0.12, 0.1, 0.012, (0, -0.015, 0.11)),
                                                 hull_of(lens), hull_of(head), hull_of(eye),
                                                 hull_of(knob)]).scale(tall)  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("thermocycler", size=(0.2, 0.26, 0.153), mass=5.0, material="device",
          aliases=("pcr machine", "thermal cycler"), themes=("lab",), roles=("big",),
          colors=("white",))  # fmt: skip
@from_pieces(bodies=3)
def thermocycler(look: Look) -> Pieces:
    """A thermocycler: a case with a lid, a knob and a display on top."""
    shell = plastic(look, "white", "gray", "sky")
    return [(at_block(0.2, 0.26, 0.12, 0.02), shell), (at_block(0.14, 0.12, 0.035, 0.012,
                                                                (0, 0.05, 0.118)),
                                                       dye(look, "gray", "navy", "charcoal")),
            (disc(0.02, 0.018, (0, -0.03, 0.118)), BLACK), (at_box(0.08, 0.035, 0.001,
                                                                   (-0.03, -0.09, 0.1195)),
                                                            display("PCR 95"))]  # fmt: skip


@category("spectrophotometer", size=(0.24, 0.28, 0.134), mass=5.0, material="device",
          aliases=("photometer", "colorimeter", "spectrometer", "plate reader"), themes=("lab",),
          roles=("big",), colors=("white",))  # fmt: skip
@from_pieces(bodies=3)
def spectrophotometer(look: Look) -> Pieces:
    """A spectrophotometer with a lid on its sample chamber."""
    shell = plastic(look, "white", "gray", "sky")
    return [(at_block(0.24, 0.28, 0.1, 0.02), shell), (at_block(0.14, 0.12, 0.035, 0.012,
                                                                (0, 0.05, 0.099)),
                                                       dye(look, "gray", "navy", "charcoal")),
            (at_block(0.05, 0.04, 0.016, 0.006, (0.07, -0.04, 0.099)), BLACK),
            (at_box(0.08, 0.035, 0.001, (-0.03, -0.09, 0.0995)), display("0.482 A"))]  # fmt: skip


@category("butterfly_net", size=(0.48, 0.186, 0.044), mass=0.15, material="plastic", assembled=True,
          aliases=("insect net", "bug net", "pooter"), themes=("lab",), roles=("big",),
          colors=("white",))  # fmt: skip
@from_pieces()
def butterfly_net(look: Look) -> Pieces:
    """A butterfly net lying flat: a hoop with a tapering bag and a long handle."""
    hoop = torus(0.09, 0.003, 40, 6).move(0.1, 0, 0.0032)
    color = look.color("white", "green", "sky", "yellow", "pink")
    bag = lathe(
        [(0.0, 0.0), (0.088, 0.0), (0.08, 0.02), (0.05, 0.035), (0.012, 0.042), (0.0, 0.043)], 30
    ).move(0.1, 0, 0.001)
    stick = spindle((-0.28, 0.006), (0.012, 0.006), z=0.006)
    mesh = surfaces.grid(tint_color(color, 0.8), tint_color(color, 1.2), 24, 24)
    grip = spindle((-0.285, 0.009), (-0.18, 0.009), z=0.009)
    return [(bag, mesh), (hoop, shine(look)), (stick, wood(look, "wooden")), (grip, BLACK)]


def display(text: str) -> prints.Canvas:
    """Return an image of a dark screen that shows ``text``."""
    screen = prints.canvas(64, 28, (20, 40, 70))
    prints.write(screen, text, 0.5, 0.5, 0.55, (140, 230, 250), True)
    return screen


KIPPS_APPARATUS_GLASS = surfaces.plain((210, 228, 232))


@category("plant_press", size=(0.22, 0.164, 0.066), mass=0.9, material="wood",
          aliases=("flower press", "herbarium press"), themes=("lab",), roles=("support", "big"),
          colors=("wooden",))  # fmt: skip
@from_pieces()
def plant_press(look: Look) -> Pieces:
    """A plant press: paper between two boards with slats on top and two straps."""
    tile = wood(look, "wooden", "beige")
    boards = [at_box(0.22, 0.16, 0.01, (0, 0, z)) for z in (0, 0.045)]
    paper = at_box(0.21, 0.15, 0.036, (0, 0, 0.0095))
    slats = [at_box(0.014, 0.16, 0.006, (x, 0, 0.0545)) for x in np.linspace(-0.09, 0.09, 6)]
    straps = [at_box(0.02, 0.164, 0.066, (x, 0, 0)) for x in (-0.05, 0.05)]
    return [(boards[0], tile), (paper, prints.pages(look.rng)), (boards[1], tile),
            (join(slats), tile), (straps[0], s := dye(look, "brown", "black", "green")),
            (straps[1], s)]  # fmt: skip


@category("ant_farm", size=(0.2, 0.08, 0.181), mass=0.7, material="plastic",
          aliases=("formicarium", "ant nest", "insect house"), themes=("lab",), roles=("tall",),
          colors=("green",))  # fmt: skip
@from_pieces(bodies=3)
def ant_farm(look: Look) -> Pieces:
    """An ant farm: a flat glass case with tunnels in sand."""
    image = surfaces.spots(look.rng, (206, 168, 112), (170, 130, 80), 0.2).copy()
    image = surfaces.fit(image, 128, 176).copy()
    image[:34] = (196, 222, 236)
    x, y = 0.2, 0.3
    for _ in range(4):
        way = [(x, 0.27)]
        for k in range(6):
            x, y = float(np.clip(x + look.between(-0.16, 0.2), 0.06, 0.94)), 0.36 + 0.1 * k
            way.append((x, y))
            prints.disc(image, x, y, 0.04, (110, 78, 46))
        prints.stroke(image, way, 0.035, (110, 78, 46))
        x = look.between(0.1, 0.9)
    for _ in range(16):
        px, py = look.between(0.1, 0.9), look.between(0.3, 0.92)
        prints.fill(image, px, py, 0.022, 0.012, (26, 20, 18))
    frame = plastic(look, "green", "black", "red", "blue")
    foot = at_block(0.2, 0.08, 0.02, 0.01)
    body = at_box(0.19, 0.03, 0.15, (0, 0, 0.018))
    top = at_box(0.2, 0.036, 0.016, (0, 0, 0.165))
    return [(foot, frame), (body, frame), (top, frame), (at_box(0.175, 0.002, 0.14,
                                                                (0, -0.0155, 0.023)),
                                                         image)]  # fmt: skip


@category("kipps_apparatus", size=(0.138, 0.118, 0.266), mass=0.9, material="glass",
          aliases=("kipp apparatus", "gas generator", "distillation apparatus",
          "alchemist apparatus"), themes=("lab",), roles=("tall",), colors=("clear",))  # fmt: skip
@from_pieces()
def kipps_apparatus(look: Look) -> Pieces:
    """Kipp's apparatus: a tower of three glass vessels with a tap at the side."""
    foot = standing((0.05, 0), (0.055, 0.01), (0.06, 0.05), (0.03, 0.085))
    middle = ball(0.09, 0.09, 0.08, (0, 0, 0.12), 22)
    upper = ball(0.1, 0.1, 0.085, (0, 0, 0.205), 22)
    neck = standing((0.012, 0.24), (0.018, 0.27))
    tap = [
        straight((0.04, 0, 0.12), (0.08, 0, 0.12), 0.006, 8),
        at_block(0.008, 0.03, 0.012, 0.003, (0.065, 0, 0.118)),
    ]
    color = look.color("clear", "sky", "mint")
    return [(foot, surfaces.gradient(color, (226, 236, 238), look.rng)),
            (middle, KIPPS_APPARATUS_GLASS), (upper, surfaces.gradient(color, (226, 236, 238),
                                                                       look.rng)),
            (neck, KIPPS_APPARATUS_GLASS), (join(tap), dye(look, "brown", "gray"))]  # fmt: skip


@category("quadrat", size=(0.25, 0.25, 0.01), mass=0.15, material="plastic",
          aliases=("sampling frame", "grid frame"), themes=("lab",), roles=("flat", "big"),
          colors=("white",))  # fmt: skip
@from_pieces()
def quadrat(look: Look) -> Pieces:
    """A quadrat: a square frame with a grid of strings, lying flat."""
    tile = plastic(look, "white", "red", "wooden", "yellow")
    s = 0.24
    sides = [at_box(s, 0.01, 0.01, (0, t * s / 2, 0)) for t in (-1, 1)] + [
        at_box(0.01, s, 0.01, (t * s / 2, 0, 0)) for t in (-1, 1)
    ]
    lines = [
        straight((-s / 2, y, 0.006), (s / 2, y, 0.006), 0.001, 5) for y in (-0.06, 0, 0.06)
    ] + [straight((x, -s / 2, 0.006), (x, s / 2, 0.006), 0.001, 5) for x in (-0.06, 0, 0.06)]
    return [*((p, tile) for p in sides), (join(lines), surfaces.plain((60, 60, 64)))]


CENTRIFUGE_BLACK = surfaces.plain((34, 34, 37))


@category("centrifuge", size=(0.22, 0.28, 0.29), mass=5.0, material="device",
          aliases=("microcentrifuge", "lab centrifuge", "mini centrifuge"), themes=("lab",),
          roles=("big",), colors=("white",))  # fmt: skip
@from_pieces(bodies=2)
def centrifuge(look: Look) -> Pieces:
    """A bench centrifuge: a rounded case with keys and a clear lid over a rotor with tubes."""
    shell = plastic(look, "white", "gray", "sky")
    body = at_block(0.22, 0.25, 0.1, 0.05)
    rim = torus(0.088, 0.007, 40, 8).move(0, 0.02, 0.1)
    well = disc(0.085, 0.002, (0, 0.02, 0.0995))
    rotor = disc(0.05, 0.012, (0, 0.02, 0.101))
    tubes = [disc(0.0075, 0.01, (0.037 * np.cos(a), 0.02 + 0.037 * np.sin(a), 0.112))
             for a in np.arange(8) * np.pi / 4]  # fmt: skip
    hub = disc(0.011, 0.02, (0, 0.02, 0.11))
    screen = at_box(0.06, 0.002, 0.025, (-0.03, -0.1255, 0.05))
    image = prints.canvas(64, 28, (20, 50, 60))
    prints.write(image, look.pick(["13000", "4500", "9000"]), 0.5, 0.5, 0.6, (120, 240, 220), True)
    keys = [disc(0.008, 0.004).turn(0, np.pi / 2).move(0.03 + 0.022 * k, -0.1245, 0.062)
            for k in range(2)]  # fmt: skip
    lid = disc(0.095, 0.008).turn(0, 1.25).move(0, 0.125, 0.19)
    return [(body, shell), (lid, surfaces.plain((180, 200, 212))), (rim, dye(look, "gray", "navy")),
            (well, CENTRIFUGE_BLACK), (rotor, shine(look)), (hub, CENTRIFUGE_BLACK),
            (join(tubes), dye(look, "sky", "yellow", "pink")), (screen, image),
            (join(keys), dye(look, "red", "green"))]  # fmt: skip


@category("incubator", size=(0.24, 0.24, 0.26), mass=6.0, material="device",
          aliases=("egg incubator", "lab incubator", "lab oven", "drying oven", "autoclave"),
          themes=("lab",), roles=("big",), colors=("white",))  # fmt: skip
@from_pieces(bodies=2)
def incubator(look: Look) -> Pieces:
    """An incubator with a glass door."""
    shell = plastic(look, "white", "gray", "sky")
    door = at_block(0.22, 0.19, 0.012, 0.01).turn(0, np.pi / 2).move(0, -0.099, 0.115)
    pane = at_block(0.17, 0.14, 0.002, 0.008).turn(0, np.pi / 2).move(0, -0.1105, 0.115)
    return [
        (at_block(0.24, 0.2, 0.26, 0.01), shell),
        (door, dye(look, "gray", "white")),
        (pane, surfaces.plain((110, 130, 150))),
        (at_block(0.012, 0.016, 0.07, 0.004, (0.098, -0.118, 0.08)), CENTRIFUGE_BLACK),
        (at_box(0.07, 0.002, 0.026, (0, -0.1005, 0.224)), display("37.0 C")),
    ]


@category("water_bath", size=(0.25, 0.19, 0.15), mass=4.0, material="device",
          aliases=("lab water bath", "heated bath", "gel electrophoresis tank", "gel tank",
          "electrophoresis tank", "ultrasonic bath", "ultrasonic cleaner"), themes=("lab",),
          roles=("big",), colors=("white",))  # fmt: skip
@from_pieces()
def water_bath(look: Look) -> Pieces:
    """A heated water bath."""
    shell = plastic(look, "white", "gray", "sky")
    walls = [at_box(0.24, 0.01, 0.12, (0, s * 0.085, 0.03)) for s in (-1, 1)] + [
        at_box(0.01, 0.16, 0.12, (s * 0.115, 0, 0.03)) for s in (-1, 1)
    ]
    return [(at_block(0.25, 0.19, 0.032, 0.01), shell), *((w, shine(look)) for w in walls),
            (at_box(0.222, 0.162, 0.1, (0, 0, 0.03)), surfaces.plain((150, 200, 222))),
            (at_box(0.06, 0.002, 0.022, (0, -0.0945, 0.005)), display("60.0 C"))]  # fmt: skip


@category("lever", size=(0.105, 0.0633, 0.152), mass=0.35, material="plastic",
          aliases=("control lever", "hand lever", "lever handle"), themes=("lab",), roles=("tall",),
          colors=("red",))  # fmt: skip
def lever(look: Look) -> Shape:
    """A lever on a stand, with a ball at its end."""
    color = look.color("red", "black", "blue", "yellow", "green")
    k = look.between(0.85, 1.15)
    base = block(0.1, 0.06, 0.018, 0.006, 0.003)
    cheeks = [at_box(0.03, 0.008, 0.035, (0, s * 0.014, 0.016)) for s in (-1, 1)]
    pin = drum(0.005, 0.042, (0, -0.021, 0.04), 1, sides=14)
    lean = look.between(-0.03, 0.03)
    arm = rod([(0, 0, 0.03), (lean, 0, 0.12)], 0.006, 12)
    end = drum(0.013, 0.026, (lean, 0, 0.118), bevel=0.006)
    return put_down([(base, surfaces.speckles(look.rng, look.own_color("gray", "charcoal", "white"),
                                              4)), (join([*cheeks, pin, arm]), steel(look)),
                     (end, plain(color))], base, join(cheeks), arm, end, factor=k)  # fmt: skip
