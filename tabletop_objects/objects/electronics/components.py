"""Objects of the ``electronics`` theme: components."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, DARK, STEEL_TONE, steel
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...kit.primitives import at_box, drum, facing, lay_down, lies, plate, rod, standing, straight
from ...kit.shapes import Category, Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color


@category("servo", size=(0.062, 0.017, 0.034), mass=0.015, material="plastic", assembled=True,
          aliases=("servo motor", "micro servo"), themes=("electronics",),
          colors=("blue",))  # fmt: skip
def servo(look: Look) -> Shape:
    """A small servo motor with mounting lugs and a horn on its shaft, standing upright."""
    k = look.between(0.95, 1.4)
    color = look.color("blue", "black", "charcoal", "blue")
    x, y, h = 0.023 * k, 0.0125 * k, 0.022 * k
    tile = surfaces.speckles(look.rng, color, 4, 32)
    lugs = box(0.0325 * k, y, 0.0025 * k).move(z=0.0155 * k)
    tower = cylinder(0.0058 * k, 0.004 * k, 20).move(x=-0.0056 * k, z=h)
    horn = prism(np.array([(-0.004, -0.0028), (0.016, -0.0016), (0.0175, 0), (0.016, 0.0016),
                           (-0.004, 0.0028), (-0.0055, 0)]) * k, 0, 0.0016 * k)  # fmt: skip
    horn = horn.turn(2, look.between(-0.5, 0.5)).move(x=-0.0056 * k, z=h + 0.0048 * k)
    pin = cylinder(0.0024 * k, 0.004 * k, 12).move(x=-0.0056 * k, z=h + 0.0035 * k)
    wire = [tube(smooth(np.array([(-0.0115, (n - 1) * 0.0013, 0.004), (-0.02, (n - 1) * 0.0013,
                 0.0025), (-0.034, 0.004 + (n - 1) * 0.0013, 0.0009)]) * k, 4), 0.00065 * k, 5)
            for n in range(3)]  # fmt: skip
    label = prints.canvas(64, 40, (240, 238, 230))
    prints.write(label, "SERVO 9G", 0.5, 0.5, 0.3, CAPACITOR_DARK, bold=True)
    sign = box(0.8 * x, 0.0006, 0.4 * h).move(y=-y / 2, z=0.15 * h)
    return shape([(join([box(x, y, h), lugs, tower]), tile), (sign, label),
                  (join([horn, pin]), surfaces.plain((244, 244, 242))),
                  *[(w, surfaces.plain(c)) for w, c in zip(wire, ((200, 50, 40), (230, 140, 40),
                                                                  (90, 60, 40)), strict=True)]],
                 [box_part(x, y, h), hull_of(lugs), hull_of(horn, tower)])  # fmt: skip


@category("electric_motor", size=(0.057, 0.03, 0.0228), mass=0.06, material="metal",
          aliases=("motor", "dc motor", "small motor", "stepper motor", "toy motor", "dynamo",
          "hand generator", "electric motor kit", "stirling engine"), themes=("electronics",),
          colors=("silver",))  # fmt: skip
def electric_motor(look: Look) -> Shape:
    """A small electric motor on its side: a flattened metal can with a shaft and two terminals."""
    k = look.between(0.9, 1.5)
    color = look.color("silver", "silver", "black", "gray", "red", "gold")
    r, long = 0.0125 * k, 0.032 * k
    outline = ellipse(2 * r, 2 * r, 32)
    outline[:, 1] = np.clip(outline[:, 1], -0.76 * r, 0.76 * r)
    can = prism(outline, 0, long, 0.001 * k).turn(2, np.pi / 2)
    can = lay_down(can, -long / 2, 0.76 * r)
    shaft = lay_down(cylinder(0.0012 * k, 0.014 * k, 12), long / 2 - 0.001, 0.76 * r)
    boss = lay_down(cylinder(0.004 * k, 0.003 * k, 16), long / 2 - 0.0005, 0.76 * r)
    back = lay_down(cylinder(0.7 * r, 0.0015 * k, 24), -long / 2 - 0.001 * k, 0.76 * r)
    tabs = [box(0.006 * k, 0.0004 + 0.0006 * k, 0.0025 * k).move(
        -long / 2 - 0.003 * k, s * 0.4 * r, 0.7 * r) for s in (-1, 1)]  # fmt: skip
    return shape([(can, look.surface(color, "metal")),
                  (join([shaft, boss]), surfaces.brushed_metal(look.rng, STEEL)),
                  (back, surfaces.plain((240, 240, 236))), (join(tabs), surfaces.plain(GOLD))],
                 [hull_of(can), hull_of(shaft)])  # fmt: skip


@category("propeller", size=(0.124, 0.0333, 0.0113), mass=0.006, material="plastic", assembled=True,
          aliases=("drone propeller", "rotor", "airscrew"), themes=("electronics",),
          roles=("flat",), colors=("orange", "black"))  # fmt: skip
def propeller(look: Look) -> Shape:
    """A propeller with two twisted blades, lying flat."""
    k = look.between(0.85, 1.15)
    color = look.color("orange", "black", "white", "red", "blue", "lime", "gray")
    count = 2
    blades = []
    for n in range(count):
        t = np.linspace(0, 1, 9)
        wide = 0.0035 + 0.009 * np.sin(np.pi * np.clip(t * 0.92 + 0.06, 0, 1)) ** 0.8
        way = np.column_stack([0.004 + 0.058 * t, -0.004 * np.sin(np.pi * t), 0.0045 + 0 * t])
        wing = tube(way * k, wide * k, 10, squash=0.14)
        lift = np.deg2rad(22)
        blades.append(wing.turn(0, lift).turn(2, n * 2 * np.pi / count))
    low = min(float(s.bounds[0, 2]) for s in blades)
    blades = [s.move(z=-low) for s in blades]
    high = max(float(s.bounds[1, 2]) for s in blades)
    hub = lathe([(0.0022 * k, 0), (0.0075 * k, 0), (0.0075 * k, high), (0.006 * k, high + 0.002),
                 (0.0022 * k, high + 0.002)], 22, loop=True)  # fmt: skip
    return shape([(join([*blades, hub]), surfaces.speckles(look.rng, color, 3, 32))],
                 [*(hull_of(s) for s in blades), cylinder_part(0.0075 * k,
                     high + 0.0015)])  # fmt: skip


@category("solder_spool", size=(0.061, 0.061, 0.0465), mass=0.25, material="plastic",
          aliases=("solder", "spool of solder", "solder wire", "solder roll", "roll of solder",
          "solder reel", "desoldering braid", "spool of wire", "wire spool", "reel of wire"),
          themes=("electronics",), roles=("round",), colors=("blue",))  # fmt: skip
def solder_spool(look: Look) -> Shape:
    """A spool of solder wire, standing on its flange."""
    k = look.between(0.9, 1.15)
    color = look.color("blue", "red", "black", "green", "yellow", "white")
    r, h, core = 0.03 * k, 0.045 * k, 0.009 * k
    ends = [lathe([(core, z), (r, z), (r, z + 0.003), (core, z + 0.003)], 32, loop=True)
            for z in (0, h - 0.003)]  # fmt: skip
    wire = surfaces.stripes([(204, 206, 210), (150, 152, 158)], 18)
    coil = lathe([(core, 0.002), (0.86 * r, 0.002), (0.86 * r, h - 0.002), (core, h - 0.002)], 32,
                 loop=True)  # fmt: skip
    label = prints.canvas(64, 64, (240, 236, 226))
    prints.disc(label, 0.5, 0.5, 0.48, color)
    prints.write(label, "SOLDER", 0.5, 0.25, 0.13, readable_on(color), bold=True)
    prints.write(label, "0.8 MM", 0.5, 0.78, 0.12, readable_on(color))
    face = lathe([(core, h - 0.0004), (0.9 * r, h - 0.0004), (0.9 * r, h + 0.0003),
                  (core, h + 0.0003)], 32, loop=True)  # fmt: skip
    uv = np.clip(face.vertices[:, :2] / (1.8 * r) + 0.5, 0, 1)
    return shape([(join(ends), surfaces.plain(color)), (coil, wire),
                  (Solid(face.vertices, face.faces, uv), label)],
                 ring_parts([(r, 0), (r, h)], [(core, h), (core, 0)], 10))  # fmt: skip


STEEL: RGB = (196, 198, 202)
GOLD: RGB = (214, 178, 92)
CAPACITOR_DARK: RGB = (32, 32, 35)
BRIGHT = ("red", "green", "blue", "yellow", "white", "orange")


@category("resistor", size=(0.078, 0.0078, 0.0078), mass=0.001, material="metal", assembled=True,
          aliases=("carbon resistor", "electrical resistor"), themes=("electronics",),
          colors=("beige",))  # fmt: skip
def resistor(look: Look) -> Shape:
    """A resistor lying flat: a beige body with colour bands and two wires."""
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
    return shape([(body, image), (wire, surfaces.plain(STEEL))],
                 [flat_foot(body.vertices, 0.15), hull_of(wire)])  # fmt: skip


@category("led", size=(0.049, 0.0093, 0.0093), mass=0.001, material="plastic", assembled=True,
          aliases=("led light", "light emitting diode", "led diode", "diode"),
          themes=("electronics",), colors=("red", "green"))  # fmt: skip
def led(look: Look) -> Shape:
    """A coloured light-emitting diode lying flat with its two legs on the right."""
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
    glow = surfaces.gradient(tint_color(color, 0.9), tint_color(color, 1.4), look.rng)
    return shape([(body, glow), (join(legs), surfaces.plain(STEEL))],
                 [flat_foot(body.vertices, 0.15), hull_of(*legs)])  # fmt: skip


@category("capacitor", size=(0.0138, 0.0138, 0.0195), mass=0.003, material="plastic",
          aliases=("electrolytic capacitor",), themes=("electronics",), roles=("round",),
          colors=("black",))  # fmt: skip
def capacitor(look: Look) -> Shape:
    """An electrolytic capacitor, standing upright."""
    k = look.between(0.9, 1.4)
    color = look.color("black", "navy", "blue", "charcoal", "purple")
    r, h = 0.006 * k, 0.0165 * k
    image = prints.canvas(96, 48, color)
    prints.fill(image, 0.44, 0, 0.12, 1, (206, 208, 212))
    for n in range(3):
        prints.fill(image, 0.48, 0.15 + 0.28 * n, 0.04, 0.14, CAPACITOR_DARK)
    body = lathe([(0, 0), (0.92 * r, 0), (r, 0.0006), (r, 0.0018), (0.95 * r, 0.0026),
                  (r, 0.0034), (r, h - 0.0005), (0.95 * r, h), (0, h)], 24)  # fmt: skip
    top = cylinder(0.86 * r, 0.0005, 22).move(z=h - 0.0001)
    cross = [box(1.3 * r, 0.0005, 0.0003).turn(2, t).move(z=h + 0.0004) for t in (0.6, 2.17)]
    return shape([(body, image), (top, surfaces.plain(STEEL)),
                  (join(cross), surfaces.plain(CAPACITOR_DARK))],
                 [cylinder_part(r, h)])  # fmt: skip


def _chip(x: float, y: float, pins: int) -> Callable[[Look], Shape]:
    """A black chip with a row of bent legs on each side."""

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
        return shape([(body, surfaces.plain(color)), (join(legs), surfaces.plain(STEEL)),
                      (sign, image)], [box_part(a, b + 0.0016, h + 0.002 * k)])  # fmt: skip

    return make


@category("jumper_wire", size=(0.145, 0.028, 0.0027), mass=0.002, material="plastic",
          assembled=True, aliases=("dupont wire", "wire", "jumper cable", "electric wire",
          "hookup wire", "coil of wire"), themes=("electronics",), roles=("flat",),
          colors=("red", "black"))  # fmt: skip
def jumper_wire(look: Look) -> Shape:
    """One bent jumper wire with a plug at each end."""
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
    return shape([(wire, surfaces.plain(color)), (join(plugs), surfaces.plain(CAPACITOR_DARK)),
                  (join(pins), surfaces.plain(STEEL))],
                 [*(hull_of(s) for s in (*plugs, *pins)), hull_of(wire)])  # fmt: skip


@category("sensor", size=(0.05, 0.028, 0.022), mass=0.01, material="plastic", assembled=True,
          aliases=("ultrasonic sensor", "distance sensor", "sensor module", "motion sensor"),
          themes=("electronics",), colors=("blue",))  # fmt: skip
def sensor(look: Look) -> Shape:
    """A distance sensor: two metal cylinders on a small circuit board, standing on its edge."""
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
    return shape([(board, surfaces.speckles(look.rng, color, 5, 32)),
                  (join(eyes), surfaces.brushed_metal(look.rng, STEEL)), (join(nets), mesh),
                  (base, surfaces.plain(CAPACITOR_DARK)), (join(pins), surfaces.plain(GOLD))],
                 [hull_of(board), box_part(0.042 * k, 0.0115 * k, 0.0178 * k, (0, 0, 0.0)),
                  hull_of(base), hull_of(*pins)])  # fmt: skip


def pins_at(places: list[tuple[float, float]], deep: float = 0.006, thick: float = 0.0012) -> Solid:
    """Return pins that extend from the height ``deep`` down to the table."""
    return join([at_box(thick, thick, deep, (x, y, 0)) for x, y in places])


@category("relay", size=(0.0215, 0.0175, 0.0211), mass=0.012, material="plastic",
          aliases=("power relay", "relay module"), themes=("electronics",),
          colors=("blue",))  # fmt: skip
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


@category("transformer", size=(0.0933, 0.073, 0.0521), mass=0.25, material="metal",
          aliases=("mains transformer", "electric transformer"), themes=("electronics",),
          colors=("yellow",))  # fmt: skip
def transformer(look: Look) -> Shape:
    """A small transformer: a laminated iron core around a taped coil, with mounting lugs."""
    color = look.color("yellow", "amber", "red", "blue")
    k = look.between(0.85, 1.25)
    core = [at_box(0.056, 0.022, 0.01, (0, 0, z)) for z in (0.0, 0.038)]
    core += [at_box(0.01, 0.022, 0.048, (x, 0, 0)) for x in (-0.023, 0.023)]
    coil = block(0.034, 0.042, 0.029, 0.008, 0.002).move(z=0.0095)
    ears = [at_box(0.016, 0.022, 0.0016, (s * 0.035, 0, 0)) for s in (-1, 1)]
    wires = [rod([(x, -0.02, 0.03), (1.4 * x, -0.034, 0.03), (1.6 * x, -0.045, 0.003)], 0.0014, 6)
             for x in (-0.012, 0.0, 0.012)]  # fmt: skip
    iron = surfaces.stripes([(86, 84, 82), (110, 108, 106)], 12)
    return put_down([(join(core), iron), (coil, surfaces.speckles(look.rng, color, 4)),
                     (join(ears), steel(look)), (join(wires), plain(look.own_color("red", "black",
                                                                                   "blue")))],
                    join(core), coil, *ears, factor=k)  # fmt: skip


@category("inductor", size=(0.0637, 0.0451, 0.0156), mass=0.012, material="metal",
          aliases=("copper coil", "choke coil", "toroidal coil", "wire coil"),
          themes=("electronics",), colors=("copper",))  # fmt: skip
def inductor(look: Look) -> Shape:
    """An inductor lying flat: a ring-shaped core wound with copper wire, with two free ends."""
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
    ends = [rod([(0.013, s * 0.006, 0.004), (0.024, s * 0.008, 0.001), (0.036, s * 0.007, 0.0008)],
                0.0008, 6) for s in (-1, 1)]  # fmt: skip
    tone = look.own_color("yellow", "green", "gray", "sky")
    return put_down([(core, plain(tone)), (join([*turns, *ends]), steel(look, color))], core,
                    join(turns), *ends, factor=k)  # fmt: skip


@category("transistor", size=(0.027, 0.0088, 0.00573), mass=0.002, material="plastic",
          aliases=("mosfet", "power transistor", "voltage regulator"), themes=("electronics",),
          colors=("black",))  # fmt: skip
def transistor(look: Look) -> Shape:
    """A transistor lying flat: a half-round body with three legs."""
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
        legs = [straight((-0.0022, 0, 0.002), (-0.016, y, 0.0005), 0.0004, 5)
                for y in (-0.0025, 0, 0.0025)]  # fmt: skip
    image = surfaces.speckles(look.rng, color, 4)
    return put_down([(body, image), (tab, steel(look) if big else image), (join(legs), steel(look)),
                     (hole, plain(DARK))], join([body, tab]), join(legs), factor=k)  # fmt: skip


@category("fuse", size=(0.0258, 0.00738, 0.00738), mass=0.002, material="glass",
          aliases=("glass fuse", "fuse holder"), themes=("electronics",),
          colors=("clear",))  # fmt: skip
def fuse(look: Look) -> Shape:
    """A glass fuse lying flat: a fine wire between two metal caps."""
    color = look.color("clear", "white", "sky", "amber")
    k = look.between(0.9, 1.6)
    glass = drum(0.0026, 0.014, (-0.007, 0, 0.003), 0, sides=16)
    wire = straight((-0.007, -0.0004, 0.0056), (0.007, 0.0004, 0.0056), 0.0002, 5)
    caps = [drum(0.003, 0.0055, (x, 0, 0.003), 0, sides=16) for x in (-0.0105, 0.005)]
    return put_down([(glass, plain(color)), (wire, plain((110, 90, 60))),
                     (join(caps), steel(look, look.pick([STEEL_TONE, BRASS_TONE])))],
                    join([glass, *caps]), factor=k, foot=0.4)  # fmt: skip


@category("vacuum_tube", size=(0.0321, 0.0346, 0.0942), mass=0.035, material="glass",
          aliases=("radio valve", "electron tube", "valve tube", "radio tube"),
          themes=("electronics",), roles=("tall",), colors=("black",))  # fmt: skip
def vacuum_tube(look: Look) -> Shape:
    """A vacuum tube standing upright: a glass bulb with metal plates on a base with pins."""
    color = look.color("black", "brown", "cream", "silver")
    k = look.between(0.9, 1.25)
    base = drum(0.0145, 0.016, (0, 0, 0.008), sides=24, bevel=0.001)
    pins = [drum(0.0014, 0.009, (0.009 * np.cos(a), 0.009 * np.sin(a), 0), sides=8)
            for a in np.arange(8) * np.pi / 4]  # fmt: skip
    bulb = standing((0.013, 0), (0.0145, 0.01), (0.0145, 0.042), (0.011, 0.054), (0.003, 0.059),
                    at=(0, 0, 0.023), sides=26)  # fmt: skip
    bands = surfaces.stack((plain((196, 212, 214)), 0.24), (plain((96, 98, 102)), 0.4),
                           (plain((188, 204, 208)), 0.1), (steel(look, (206, 208, 214)),
                                                           0.26))  # fmt: skip
    plates = [
        at_box(0.012, 0.003, 0.026, (0, -0.0135, 0.034)),
        at_box(0.003, 0.006, 0.034, (0, -0.0137, 0.03)),
    ]
    tip = drum(0.0015, 0.004, (0, 0, 0.081), top=0.0004, sides=8)
    return put_down([(base, look.surface(color, "plastic")), (join(pins), steel(look)),
                     (bulb, bands), (join(plates), plain((70, 72, 78))),
                     (tip, plain((200, 214, 216)))], base, join(pins), bulb, factor=k)  # fmt: skip


@category("coin_cell", size=(0.0161, 0.0161, 0.0029), mass=0.003, material="metal",
          aliases=("button cell", "button battery", "coin battery", "watch battery"),
          themes=("electronics",), roles=("flat",), colors=("silver",))  # fmt: skip
def coin_cell(look: Look) -> Shape:
    """A coin cell lying with its positive side up."""
    color = look.color("silver", "gray", "gold")
    r = look.between(0.0055, 0.0115)
    h = look.between(0.2, 0.42) * r
    body = drum(r, h, sides=28, bevel=0.12 * h)
    face = drum(0.86 * r, 0.0004, (0, 0, h - 0.00015), sides=28)
    image = prints.canvas(96, 96, color)
    ink = tint_color(color, 0.6)
    prints.write(
        image, look.pick(["CR2032", "LR44", "CR2025", "SR626"]), 0.5, 0.62, 0.16, ink, bold=True
    )
    prints.write(image, "+", 0.5, 0.32, 0.3, ink, bold=True)
    return put_down([(body, steel(look, color)), (face, image)], body)


@category("crocodile_clip", size=(0.0754, 0.0104, 0.00986), mass=0.006, material="plastic",
          aliases=("alligator clip", "croc clip", "crocodile lead", "test clip",
          "oscilloscope probe"), themes=("electronics",), colors=("red", "black"))  # fmt: skip
def crocodile_clip(look: Look) -> Shape:
    """A crocodile clip lying flat, with toothed jaws, a coloured sleeve and a lead."""
    color = look.color("red", "black", "green", "yellow", "blue", "white")
    k = look.between(0.9, 1.5)
    teeth = [(0.016 - 0.002 * n, 0.0002 + 0.0009 * (n % 2)) for n in range(7)]
    rim = np.array([(0, 0), (0.004, 0.0028), (0.018, 0.0022), (0.021, 0), (0.018, 0.0005), *teeth])
    upper, lower = (plate(rim * [1, s] + [0, s * 0.0003], 0.0045) for s in (1, -1))
    sleeve = rod(
        [(-0.026, 0, 0.0042), (-0.012, 0, 0.0045), (0.004, 0, 0.0045)], [0.0032, 0.0046, 0.0048], 10
    )
    tail = rod([(-0.025, 0, 0.0038), (-0.036, 0.003, 0.0016), (-0.048, 0, 0.0013)], 0.0013, 8)
    return put_down([(join([upper.move(z=0.002), lower.move(z=0.002)]), steel(look)),
                     (join([sleeve, tail]), plain(color))], sleeve, join([upper.move(z=0.002),
                                                                          lower.move(z=0.002)]),
                    tail, factor=k, foot=0.3)  # fmt: skip


@category("banana_plug", size=(0.051, 0.0127, 0.0126), mass=0.008, material="plastic",
          aliases=("banana connector", "4 mm plug"), themes=("electronics",),
          colors=("red", "black"))  # fmt: skip
def banana_plug(look: Look) -> Shape:
    """A banana plug lying flat: a coloured grip and a sprung tip."""
    color = look.color("red", "black", "yellow", "green", "blue")
    k = look.between(0.9, 1.4)
    grip = drum(0.0048, 0.026, (-0.026, 0, 0.0055), 0, sides=16, bevel=0.001)
    ribs = [torus(0.0048, 0.0006, 16, 5).turn(1, np.pi / 2).move(-0.022 + 0.004 * n, 0, 0.0055)
            for n in range(4)]  # fmt: skip
    collar = drum(0.0056, 0.004, (-0.002, 0, 0.0055), 0, sides=16)
    tip = lies(standing((0.002, 0), (0.0024, 0.004), (0.003, 0.01), (0.0022, 0.017), (0.001, 0.019),
                        sides=14), 0.0, 0, 0.0055)  # fmt: skip
    return put_down([(join([grip, *ribs, collar]), plain(color)), (tip, steel(look))], grip, collar,
                    tip, factor=k, foot=0.3)  # fmt: skip


@category("battery_holder", size=(0.0979, 0.0345, 0.0142), mass=0.015, material="plastic",
          aliases=("battery tray", "battery case", "battery slot", "cell holder"),
          themes=("electronics",), colors=("black",))  # fmt: skip
def battery_holder(look: Look) -> Shape:
    """A plastic holder for round cells, with springs and two wires."""
    color = look.color("black", "charcoal", "white")
    k = look.between(0.9, 1.1)
    base = at_box(0.062, 0.034, 0.002)
    walls = [at_box(0.062, 0.002, 0.013, (0, s * 0.016, 0)) for s in (-1, 1)] + [
        at_box(0.002, 0.034, 0.014, (s * 0.03, 0, 0)) for s in (-1, 1)
    ]
    rib = at_box(0.058, 0.0015, 0.006, (0, 0, 0.0015))
    coils = [drum(0.004, 0.006, (-0.029, 0.008, 0.0075), 0, top=0.002, sides=12),
             drum(0.004, 0.006, (0.023, -0.008, 0.0075), 0, sides=12)]  # fmt: skip
    wires = [rod([(0.03, y, 0.006), (0.045, y + 0.002, 0.003), (0.065, y - 0.006, 0.0013)], 0.0012,
                 6) for y in (-0.008, 0.008)]  # fmt: skip
    return put_down([(join([base, *walls, rib]), plain(color)), (join(coils), steel(look)),
                     (wires[0], plain((206, 40, 40))), (wires[1], plain((30, 30, 34)))], base,
                    *walls, *wires, factor=k)  # fmt: skip


@category("solar_panel", size=(0.153, 0.0831, 0.0045), mass=0.06, material="plastic",
          aliases=("solar cell", "mini solar panel", "photovoltaic panel"), themes=("electronics",),
          roles=("flat",), colors=("navy",))  # fmt: skip
def solar_panel(look: Look) -> Shape:
    """A small solar panel with two wires, lying flat."""
    color = look.color("navy", "black", "blue")
    x, y = look.between(0.09, 0.15), look.between(0.07, 0.1)
    base, face = (block(x, y, 0.004, 0.003, 0.0008), at_box(0.95 * x, 0.94 * y, 0.0008,
                                                            (0, 0, 0.0037)))  # fmt: skip
    cells = surfaces.grid((196, 204, 214), color, 4, int(look.pick([4, 6])), 160, 3)
    fine = cells.copy()
    fine[::10] = np.clip(fine[::10].astype(int) + 26, 0, 255)
    wires = [rod([(x / 2 - 0.004, s * 0.006, 0.002), (x / 2 + 0.015, s * 0.01, 0.002),
                  (x / 2 + 0.035, s * 0.004 - 0.012, 0.0013)], 0.0012, 6)
             for s in (-1, 1)]  # fmt: skip
    return put_down([(base, plain((226, 228, 230) if look.chance(0.5) else (50, 52, 58))),
                     (face, fine), (wires[0], plain((200, 40, 40))),
                     (wires[1], plain((34, 34, 38)))], base, *wires)  # fmt: skip


@category("segment_display", size=(0.0373, 0.0245, 0.0136), mass=0.012, material="plastic",
          assembled=True, aliases=("seven-segment display", "seven segment display",
          "digit display", "led display", "7-segment display"), themes=("electronics",),
          colors=("red",))  # fmt: skip
def segment_display(look: Look) -> Shape:
    """A seven-segment display module with lit digits."""
    color = look.color("red", "green", "blue", "yellow")
    k = look.between(0.85, 1.2)
    n = look.pick([1, 2, 4])
    x = 0.016 * n + 0.004
    body = block(x, 0.024, 0.01, 0.001, 0.0005).move(z=0.003)
    image = prints.canvas(64 * n, 96, (40, 36, 36))
    dim = tint_color(color, 0.28)
    shapes = {0: "abcdef", 1: "bc", 2: "abged", 3: "abgcd", 4: "fgbc", 5: "afgcd", 6: "afgedc",
              7: "abc", 8: "abcdefg", 9: "abcdfg"}  # fmt: skip
    places = {"a": (0.2, 0.12, 0.5, 0.08), "d": (0.2, 0.8, 0.5, 0.08), "g": (0.2, 0.46, 0.5, 0.08),
              "f": (0.16, 0.18, 0.12, 0.3), "b": (0.64, 0.18, 0.12, 0.3),
              "e": (0.16, 0.52, 0.12, 0.3), "c": (0.64, 0.52, 0.12, 0.3)}  # fmt: skip
    for d in range(n):
        lit = shapes[int(look.rng.integers(10))]
        for name, (u, v, w, h) in places.items():
            prints.fill(
                image, (d + u) / n, v, w / n, h, tint_color(color, 1.25) if name in lit else dim
            )
        prints.disc(image, (d + 0.88) / n, 0.85, 0.05, dim)
    face = at_box(0.98 * x, 0.0235, 0.0006, (0, 0, 0.0127))
    pins = pins_at(
        [(u, s * 0.009) for u in np.linspace(-0.4 * x, 0.4 * x, 5) for s in (-1, 1)], 0.004, 0.0008
    )
    return put_down([(body, plain((232, 230, 224) if look.chance(0.4) else (50, 50, 54))),
                     (face, image), (pins, steel(look))], body, pins, factor=k)  # fmt: skip


@category("lcd_module", size=(0.0846, 0.0381, 0.0132), mass=0.035, material="plastic",
          aliases=("lcd display", "lcd", "character display", "lcd screen", "oled display",
          "display module"), themes=("electronics",), roles=("flat",),
          colors=("blue", "green"))  # fmt: skip
def lcd_module(look: Look) -> Shape:
    """A character display on its board: two lines of text in a metal frame."""
    color = look.color("blue", "lime", "green")
    k = look.between(0.9, 1.15)
    board, frame = (
        block(0.08, 0.036, 0.0016, 0.001).move(z=0.004),
        at_box(0.071, 0.026, 0.007, (0, 0, 0.0052)),
    )
    glass = at_box(0.064, 0.0155, 0.0006, (0, 0, 0.0119))
    image = prints.canvas(192, 48, color)
    ink = (240, 246, 255) if sum(color) < 340 else (40, 56, 30)
    prints.write(
        image, look.pick(["HELLO WORLD", "TEMP 21.5 C", "READY", "TIME 12:04"]), 0.5, 0.3, 0.34, ink
    )
    prints.write(
        image, look.pick(["TABLETOP", "VOLTS 4.97", "> START", "OK"]), 0.5, 0.72, 0.34, ink
    )
    pads = [drum(0.0009, 0.0004, (-0.036 + 0.0025 * n, 0.0158, 0.0055), sides=8) for n in range(16)]
    posts = [drum(0.003, 0.0045, (sx * 0.036, sy * 0.0145, 0), sides=10) for sx in (-1, 1)
             for sy in (-1, 1)]  # fmt: skip
    return put_down([(join([board, *posts]), plain((40, 110, 70))), (frame, plain(DARK)),
                     (glass, image), (join(pads), plain(BRASS_TONE))], board, frame, *posts,
                    factor=k)  # fmt: skip


@category("potentiometer", size=(0.0278, 0.0373, 0.0366), mass=0.015, material="plastic",
          aliases=("rotary encoder", "encoder", "trimmer potentiometer", "variable resistor"),
          themes=("electronics",), colors=("silver",))  # fmt: skip
def potentiometer(look: Look) -> Shape:
    """A potentiometer: a round can with three terminals and a shaft, with or without a knob."""
    color = look.color("silver", "blue", "green", "black")
    k = look.between(0.9, 1.35)
    can = drum(0.0125, 0.011, sides=24, bevel=0.001)
    lugs = [plate([(x - 0.0014, -0.012), (x + 0.0014, -0.012), (x + 0.0014, -0.021),
                   (x - 0.0014, -0.021)], 0.001, at=(0, 0, 0.003))
            for x in (-0.005, 0, 0.005)]  # fmt: skip
    bush, nut = (drum(0.0045, 0.009, (0, 0, 0.011), sides=16), drum(0.0075, 0.002, (0, 0, 0.013),
                                                                    sides=6))  # fmt: skip
    shaft = drum(0.003, 0.014, (0, 0, 0.018), sides=14)
    pieces = [(can, look.surface(color, "metal")), (join([*lugs, bush, nut, shaft]), steel(look))]
    if look.chance(0.5):
        pieces += [
            (drum(0.0095, 0.012, (0, 0, 0.023), top=0.008, sides=20), plain(DARK)),
            (at_box(0.0014, 0.008, 0.0008, (0, 0.003, 0.0347)), plain((240, 240, 240))),
        ]
    return put_down(pieces, can, shaft, *(p[0] for p in pieces[2:3]), factor=k)


CATEGORIES = (
    Category("ic_chip", _chip(0.02, 0.0066, 8), size=(0.025, 0.0105, 0.007), mass=0.002,
             material="plastic", aliases=("microchip", "chip", "integrated circuit", "ic",
             "computer chip", "crystal oscillator", "optocoupler"), themes=("electronics",),
             roles=("flat",), colors=("black",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
