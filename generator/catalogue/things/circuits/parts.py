"""Electronic parts: chips, resistors, lights, wires, cards, motors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.forms import facing, lay_down
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (196, 198, 202)
GOLD: RGB = (214, 178, 92)
DARK: RGB = (32, 32, 35)
BRIGHT = ("red", "green", "blue", "yellow", "white", "orange")


def resistor(look: Look) -> Shape:
    """A resistor lying: a beige body with colour rings, two wires."""
    k = look.between(1.2, 1.8)
    color = look.color("beige", "sky", "tan", "beige", "mint")
    rings = [look.own_color("brown", "red", "orange", "yellow", "green", "violet", "black")
             for _ in range(3)] + [GOLD]  # fmt: skip
    image = prints.canvas(32, 96, color)
    for tone, v in zip(rings, (0.18, 0.32, 0.46, 0.74), strict=True):
        prints.fill(image, 0, v, 1, 0.07, tone)
    body = lathe(np.array([(0, 0), (0.0022, 0.0004), (0.0026, 0.002), (0.0021, 0.0034),
                           (0.0021, 0.0076), (0.0026, 0.009), (0.0022, 0.0106), (0, 0.011)]) * k,
                 16)  # fmt: skip
    body = lay_down(body, -0.0055 * k, 0.0026 * k)
    wire = lay_down(cylinder(0.00055 * k, 0.052 * k, 8), -0.026 * k, 0.0026 * k)
    return shape([(body, image), (wire, textures.plain(STEEL))],
                 [flat_foot(body.vertices, 0.15), hull_of(wire)])  # fmt: skip


def led_lamp(look: Look) -> Shape:
    """A coloured light-emitting diode lying, its two legs to the right."""
    k = look.between(1.3, 1.9)
    color = look.color(*BRIGHT)
    a = np.linspace(0, np.pi / 2, 6)
    dome = [(0.0025 * np.cos(t), 0.0062 + 0.0025 * np.sin(t)) for t in a[:-1]]
    body = lathe(np.array([(0, 0), (0.0029, 0), (0.0029, 0.001), (0.0025, 0.0011), *dome,
                           (0, 0.0087)]) * k, 20)  # fmt: skip
    body = body.turn(1, -np.pi / 2).move(x=0.0, z=0.0029 * k)
    legs = [tube(smooth(np.array([(0, s * 0.0008, 0.0029), (0.008, s * 0.0012, 0.0027),
                                  (0.022 if s > 0 else 0.019, s * 0.0022, 0.0006)]) * k, 3),
                 0.00045 * k, 6) for s in (-1, 1)]  # fmt: skip
    glow = textures.gradient(tint_color(color, 0.9), tint_color(color, 1.4), look.rng)
    return shape([(body, glow), (join(legs), textures.plain(STEEL))],
                 [flat_foot(body.vertices, 0.15), hull_of(*legs)])  # fmt: skip


def capacitor(look: Look) -> Shape:
    """An electrolytic capacitor standing."""
    k = look.between(0.9, 1.4)
    color = look.color("black", "navy", "blue", "charcoal", "purple")
    r, h = 0.006 * k, 0.0165 * k
    image = prints.canvas(96, 48, color)
    prints.fill(image, 0.44, 0, 0.12, 1, (206, 208, 212))
    for n in range(3):
        prints.fill(image, 0.48, 0.15 + 0.28 * n, 0.04, 0.14, DARK)
    body = lathe([(0, 0), (0.92 * r, 0), (r, 0.0006), (r, 0.0018), (0.95 * r, 0.0026),
                  (r, 0.0034), (r, h - 0.0005), (0.95 * r, h), (0, h)], 24)  # fmt: skip
    top = cylinder(0.86 * r, 0.0005, 22).move(z=h - 0.0001)
    cross = [box(1.3 * r, 0.0005, 0.0003).turn(2, t).move(z=h + 0.0004) for t in (0.6, 2.17)]
    return shape([(body, image), (top, textures.plain(STEEL)), (join(cross), textures.plain(DARK))],
                 [cylinder_part(r, h)])  # fmt: skip


def _chip(x: float, y: float, pins: int) -> Callable[[Look], Shape]:
    """A black chip with a row of bent legs on either side."""

    def make(look: Look) -> Shape:
        k = look.between(1.0, 1.5)
        color = look.color("black", "charcoal", "black")
        a, b, h = x * k, y * k, 0.0035 * k
        body = block(a, b, h, 0.0004, 0.0003).move(z=0.002 * k)
        legs = []
        for n in range(pins):
            u = ((n + 0.5) / pins - 0.5) * 0.94 * a
            for s in (-1, 1):
                legs.append(box(0.0011 * k, 0.0012 * k, 0.0009 * k).move(
                    u, s * (0.5 * b + 0.0004), 0.0032 * k))  # fmt: skip
                legs.append(box(0.0009 * k, 0.0006 * k, 0.0037 * k).move(
                    u, s * (0.5 * b + 0.0008)))  # fmt: skip
        image = prints.canvas(96, 48, color)
        prints.write(image, look.pick(["NE 555", "LM 358", "AT 328", "74HC"]), 0.55, 0.45, 0.3,
                     (200, 200, 200))  # fmt: skip
        prints.disc(image, 0.08, 0.5, 0.12, tint_color(color, 0.5))
        sign = box(0.94 * a, 0.9 * b, 0.0003).move(z=h + 0.002 * k - 0.0001)
        return shape([(body, textures.plain(color)), (join(legs), textures.plain(STEEL)),
                      (sign, image)], [box_part(a, b + 0.0016, h + 0.002 * k)])  # fmt: skip

    return make


def jumper_wire(look: Look) -> Shape:
    """One bent jumper wire with a plug at either end."""
    k = look.between(0.9, 1.2)
    color = look.color("red", "black", "yellow", "green", "blue", "orange", "white", "purple")
    bow = look.between(0.015, 0.03)
    z = 0.0014
    way = smooth([(-0.05, 0.0, z), (-0.02, bow, z), (0.02, -0.5 * bow, z), (0.05, 0.01, z)], 6) * k
    wire = tube(way, 0.0009 * k, 6)
    plugs, pins = [], []
    for s, y in ((-1, 0.0), (1, 0.01)):
        plugs.append(box(0.014 * k, 0.0026 * k, 0.0026 * k).move(s * 0.056 * k, y * k, 0))
        pins.append(box(0.006 * k, 0.0007 * k, 0.0007 * k).move(s * 0.066 * k, y * k, 0.0009 * k))
    return shape([(wire, textures.plain(color)), (join(plugs), textures.plain(DARK)),
                  (join(pins), textures.plain(STEEL))],
                 [*(hull_of(s) for s in (*plugs, *pins)), hull_of(wire)])  # fmt: skip


def cpu(look: Look) -> Shape:
    """A processor: a metal lid on a green board with gold contacts."""
    k = look.between(0.95, 1.1)
    color = look.color("green", "green", "teal", "blue")
    side, h = 0.04 * k, 0.0015
    board = textures.fit(textures.speckles(look.rng, color, 4, 32), 96, 96).copy()
    for n in range(20):
        for v in (0.03, 0.94):
            prints.fill(board, 0.04 + 0.047 * n, v, 0.02, 0.03, GOLD)
            prints.fill(board, v, 0.04 + 0.047 * n, 0.03, 0.02, GOLD)
    prints.polygon(board, [(0, 1), (0.06, 1), (0, 0.94)], GOLD)
    lid_print = prints.canvas(96, 96, (198, 200, 204))
    for n, text in enumerate((look.pick(["CORE X7", "R9 5900", "i7-12K"]), "3.60 GHZ", "MALAY")):
        prints.write(lid_print, text, 0.5, 0.3 + 0.18 * n, 0.12, (110, 112, 116))
    lid = block(0.78 * side, 0.78 * side, 0.0026, 0.003, 0.0006).move(z=h - 0.0001)
    return shape([(box(side, side, h), board), (lid, textures.brushed_metal(look.rng, STEEL)),
                  (box(0.7 * side, 0.7 * side, 0.0003).move(z=h + 0.0023), lid_print)],
                 [box_part(side, side, h), hull_of(lid)])  # fmt: skip


def sensor(look: Look) -> Shape:
    """A distance sensor: two metal eyes on a little blue board, standing on its edge."""
    k = look.between(0.95, 1.25)
    color = look.color("blue", "blue", "green", "red", "black")
    x, h = 0.045 * k, 0.02 * k
    board = box(x, 0.0018 * k, h).move(y=0.006 * k)
    eyes = [facing(lathe(np.array([(0, 0), (0.008, 0), (0.008, 0.012), (0.0068, 0.012),
                                   (0.0064, 0.009), (0, 0.009)]) * k, 26))
            .move(s * 0.0128 * k, 0.0055 * k, 0.0098 * k) for s in (-1, 1)]  # fmt: skip
    mesh = prints.mesh_holes((120, 122, 126), (40, 40, 42), 8, 8)
    nets = [facing(prism(ellipse(0.0134 * k, 0.0134 * k, 22), 0, 0.0003)).move(
        s * 0.0128 * k, (0.0055 - 0.0091) * k, 0.0098 * k) for s in (-1, 1)]  # fmt: skip
    base = box(0.012 * k, 0.006 * k, 0.0025 * k).move(y=0.009 * k)
    pins = [box(0.0008 * k, 0.01 * k, 0.0008 * k).move((n - 1.5) * 0.0026 * k, 0.014 * k, 0.0008)
            for n in range(4)]  # fmt: skip
    return shape([(board, textures.speckles(look.rng, color, 5, 32)),
                  (join(eyes), textures.brushed_metal(look.rng, STEEL)), (join(nets), mesh),
                  (base, textures.plain(DARK)), (join(pins), textures.plain(GOLD))],
                 [hull_of(board), box_part(0.042 * k, 0.0115 * k, 0.0178 * k, (0, 0, 0.0)),
                  hull_of(base), hull_of(*pins)])  # fmt: skip


def push_button(look: Look) -> Shape:
    """A big round push button on a square or round base."""
    k = look.between(0.75, 1.15)
    color = look.color("red", "red", "green", "blue", "yellow")
    base_tone = look.own_color("black", "charcoal", "white", "yellow", "gray")
    r = 0.045 * k
    base = block(2.1 * r, 2.1 * r, 0.45 * r, 0.2 * r, 0.05 * r) if look.chance(0.5) else cylinder(
        1.1 * r, 0.45 * r, 36, bevel=0.05 * r)  # fmt: skip
    ring = lathe([(0.86 * r, 0.44 * r), (0.98 * r, 0.44 * r), (0.92 * r, 0.56 * r),
                  (0.86 * r, 0.56 * r)], 36, loop=True)  # fmt: skip
    dome = ellipsoid(1.66 * r, 1.66 * r, 0.66 * r, 32, 14).move(z=0.5 * r)
    dome = dome.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.4 * r)]))
    return shape([(base, textures.speckles(look.rng, base_tone, 3, 32)),
                  (ring, textures.brushed_metal(look.rng, STEEL)),
                  (dome, textures.speckles(look.rng, color, 3, 32))],
                 [hull_of(base), hull_of(dome)])  # fmt: skip


CATEGORIES = (
    Category("resistor", resistor, (0.078, 0.0078, 0.0078), 0.001, ("carbon resistor",
             "electrical resistor"), ("electronics",), (), ("beige",)),
    Category("led", led_lamp, (0.049, 0.0093, 0.0093), 0.001, ("led light", "light emitting diode",
             "led diode", "diode"), ("electronics",), (), ("red", "green")),
    Category("capacitor", capacitor, (0.0138, 0.0138, 0.0195), 0.003, ("electrolytic capacitor",),
             ("electronics",), ("round",), ("black",)),
    Category("ic_chip", _chip(0.02, 0.0066, 8), (0.025, 0.0105, 0.007), 0.002, ("microchip",
             "chip", "integrated circuit", "ic", "computer chip", "crystal oscillator",
             "optocoupler"), ("electronics",), ("flat",),
             ("black",)),
    Category("jumper_wire", jumper_wire, (0.145, 0.028, 0.0027), 0.002, ("dupont wire", "wire",
             "jumper cable", "electric wire", "hookup wire",
             "coil of wire"), ("electronics",), ("flat",),
             ("red", "black")),
    Category("cpu", cpu, (0.041, 0.041, 0.0041), 0.03, ("processor", "computer processor",
             "microprocessor"), ("electronics",), ("flat",), ("green",)),
    Category("sensor", sensor, (0.05, 0.028, 0.022), 0.01, ("ultrasonic sensor",
             "distance sensor", "sensor module", "motion sensor"), ("electronics",), (),
             ("blue",)),
    Category("push_button", push_button, (0.093, 0.093, 0.036), 0.15, ("button switch",
             "red button", "emergency button", "buzzer", "arcade button", "quiz buzzer",
             "emergency stop", "emergency stop button", "keycap", "door bell button"),
             ("electronics",), ("round",), ("red",)),
)  # fmt: skip
"""The module's categories."""
