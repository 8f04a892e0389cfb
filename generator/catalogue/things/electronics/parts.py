"""Electronic parts: chips, resistors, lights, wires, cards, motors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...build.forms import facing
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

STEEL: RGB = (196, 198, 202)
GOLD: RGB = (214, 178, 92)
DARK: RGB = (32, 32, 35)
BRIGHT = ("red", "green", "blue", "yellow", "white", "orange")


def _lay(solid: Solid, x: float = 0.0, z: float = 0.0) -> Solid:
    return solid.turn(1, np.pi / 2).move(x=x, z=z)


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
    body = _lay(body, -0.0055 * k, 0.0026 * k)
    wire = _lay(cylinder(0.00055 * k, 0.052 * k, 8), -0.026 * k, 0.0026 * k)
    return shape([(body, image), (wire, textures.plain(STEEL))],
                 [flat_foot(body.vertices, 0.15), hull_of(wire)])  # fmt: skip


def led(look: Look) -> Shape:
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

    def made(look: Look) -> Shape:
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

    return made


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


def heatsink(look: Look) -> Shape:
    """A block of metal fins."""
    k = look.between(0.85, 1.2)
    metal = look.surface(look.color("silver", "black", "silver", "blue", "copper", "gold"), "metal")
    side, h = 0.05 * k, 0.028 * k
    fins = [box(0.0016 * k, side, h).move(x=(n - 6) * side / 12.9) for n in range(13)]
    return shape([(join([box(side, side, 0.006 * k), *fins]), metal)],
                 [box_part(side, side, h)])  # fmt: skip


def case_fan(look: Look) -> Shape:
    """A square computer fan lying: frame, hub and seven blades."""
    k = look.between(0.85, 1.15)
    color = look.color("black", "black", "white", "charcoal", "brown")
    side, h = 0.08 * k, 0.025 * k
    r = 0.46 * side
    frame = [lathe([(r, 0), (1.08 * r, 0), (1.08 * r, h), (r, h)], 32, loop=True)]
    for s in (-1, 1):
        for t in (-1, 1):
            corner = block(0.19 * side, 0.19 * side, 0.004, 0.003)
            at = (s * 0.4 * side, t * 0.4 * side)
            frame += [corner.move(*at, z) for z in (0.0, h - 0.004)]
    rims = [box(side, 0.06 * side, h).move(y=s * 0.47 * side) for s in (-1, 1)]
    rims += [box(0.06 * side, side, h).move(x=s * 0.47 * side) for s in (-1, 1)]
    blades = []
    for n in range(7):
        wing = box(0.3 * side, 0.2 * side, 0.0016).turn(0, 0.5).move(x=0.27 * side, z=0.5 * h)
        blades.append(wing.turn(2, n * 2 * np.pi / 7))
    hub = cylinder(0.17 * side, 0.8 * h, 24).move(z=0.1 * h)
    sign = prints.canvas(48, 48, tint_color(color, 1.15))
    prints.disc(sign, 0.5, 0.5, 0.3, look.own_color("red", "blue", "white", "orange"))
    badge = prism(ellipse(0.28 * side, 0.28 * side, 24), 0.9 * h, 0.92 * h)
    tone = look.own_color("charcoal", "gray", "white", "red", "cyan")
    return shape([(join([*frame, *rims]), textures.speckles(look.rng, color, 3, 32)),
                  (join([*blades, hub]), textures.plain(tone)), (badge, sign)],
                 [box_part(side, side, h)])  # fmt: skip


def graphics_card(look: Look) -> Shape:
    """A graphics card lying, its fans up, bracket to the left."""
    k = look.between(0.88, 1.04)
    x, y, h = 0.25 * k, 0.11 * k, 0.04 * k
    color = look.color("black", "charcoal", "white", "gray", "red")
    board = box(x, y, 0.003).move(z=0.002)
    cover = block(0.97 * x, 0.94 * y, h - 0.005, 0.012, 0.004).move(z=0.005)
    pieces = [(board, textures.plain((34, 82, 58))), (cover, look.surface(color, "plastic"))]
    count = look.pick([2, 2, 3])
    for n in range(count):
        u = ((n + 0.5) / count - 0.5) * 0.94 * x
        r = min(0.42 * y, 0.43 * x / count)
        image = prints.canvas(96, 96, tint_color(color, 0.6))
        for m in range(11):
            t = m * 2 * np.pi / 11
            prints.polygon(image, [(0.5, 0.5), (0.5 + 0.46 * np.cos(t), 0.5 + 0.46 * np.sin(t)),
                                   (0.5 + 0.46 * np.cos(t + 0.3), 0.5 + 0.46 * np.sin(t + 0.3))],
                           (96, 98, 102))  # fmt: skip
        prints.disc(image, 0.5, 0.5, 0.16, (30, 30, 32))
        prints.disc(image, 0.5, 0.5, 0.06, look.own_color("red", "lime", "silver", "cyan"))
        pieces.append((prism(ellipse(2 * r, 2 * r, 30), h - 0.0005, h + 0.0006).move(x=u), image))
    bracket = box(0.002, 1.1 * y, h).move(x=-x / 2 - 0.001)
    edge = prints.canvas(64, 8, GOLD)
    for n in range(16):
        prints.fill(edge, n / 16, 0, 0.015, 1, (40, 80, 60))
    fingers = box(0.36 * x, 0.008, 0.0032).move(x=-0.12 * x, y=-y / 2 - 0.003, z=0.0019)
    return shape([*pieces, (bracket, textures.brushed_metal(look.rng, STEEL)), (fingers, edge)],
                 [box_part(x, y, h, (0, 0, 0)), hull_of(bracket)])  # fmt: skip


def _stick(
    x: float, y: float, chips: int, palette: tuple[str, ...], label: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """A little card lying: black chips on it or a label, gold contacts at its edge."""

    def made(look: Look) -> Shape:
        k = look.between(0.97, 1.05)
        color = look.color(*palette)
        a, b = x * k, y * k
        image = prints.canvas(128, max(int(128 * y / x), 24), color)
        for n in range(24 if chips else 8):
            prints.fill(image, 0.05 + (0.9 * n / 24 if chips else 0.115 * n), 0.9 if chips else 0.0,
                        0.02 if chips else 0.06, 0.1 if chips else 0.12, GOLD)  # fmt: skip
        if label:
            tone = look.own_color("red", "navy", "orange", "teal", "gold")
            prints.fill(image, 0.1, 0.24, 0.8, 0.62, (246, 244, 240))
            prints.fill(image, 0.1, 0.24, 0.8, 0.3, tone)
            prints.write(image, look.pick(label), 0.5, 0.7, 0.2, DARK, bold=True)
        pieces = [(box(a, b, 0.0021), textures.plain(tint_color(color, 0.85))),
                  (box(0.99 * a, 0.99 * b, 0.0003).move(z=0.002), image)]  # fmt: skip
        parts = [box_part(a, b, 0.0022)]
        for n in range(chips):
            u = ((n + 0.5) / chips - 0.5) * 0.95 * a
            pieces.append((box(0.8 * a / chips, 0.5 * b, 0.0016).move(u, 0.1 * b, 0.0021),
                           textures.plain(DARK)))  # fmt: skip
        if chips:
            parts.append(box_part(0.93 * a, 0.5 * b, 0.0015, (0, 0.1 * b, 0.0022)))
        return shape(pieces, parts)

    return made


def servo(look: Look) -> Shape:
    """A small servo motor standing: lugs, horn on its shaft."""
    k = look.between(0.95, 1.4)
    color = look.color("blue", "black", "charcoal", "blue")
    x, y, h = 0.023 * k, 0.0125 * k, 0.022 * k
    tile = textures.speckles(look.rng, color, 4, 32)
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
    prints.write(label, "SERVO 9G", 0.5, 0.5, 0.3, DARK, bold=True)
    sign = box(0.8 * x, 0.0006, 0.4 * h).move(y=-y / 2, z=0.15 * h)
    return shape([(join([box(x, y, h), lugs, tower]), tile), (sign, label),
                  (join([horn, pin]), textures.plain((244, 244, 242))),
                  *[(w, textures.plain(c)) for w, c in zip(wire, ((200, 50, 40), (230, 140, 40),
                                                                  (90, 60, 40)), strict=True)]],
                 [box_part(x, y, h), hull_of(lugs), hull_of(horn, tower)])  # fmt: skip


def electric_motor(look: Look) -> Shape:
    """A small electric motor lying: a metal can with flats, shaft, two terminals."""
    k = look.between(0.9, 1.5)
    color = look.color("silver", "silver", "black", "gray", "red", "gold")
    r, long = 0.0125 * k, 0.032 * k
    outline = ellipse(2 * r, 2 * r, 32)
    outline[:, 1] = np.clip(outline[:, 1], -0.76 * r, 0.76 * r)
    can = prism(outline, 0, long, 0.001 * k).turn(2, np.pi / 2)
    can = _lay(can, -long / 2, 0.76 * r)
    shaft = _lay(cylinder(0.0012 * k, 0.014 * k, 12), long / 2 - 0.001, 0.76 * r)
    boss = _lay(cylinder(0.004 * k, 0.003 * k, 16), long / 2 - 0.0005, 0.76 * r)
    back = _lay(cylinder(0.7 * r, 0.0015 * k, 24), -long / 2 - 0.001 * k, 0.76 * r)
    tabs = [box(0.006 * k, 0.0004 + 0.0006 * k, 0.0025 * k).move(
        -long / 2 - 0.003 * k, s * 0.4 * r, 0.7 * r) for s in (-1, 1)]  # fmt: skip
    return shape([(can, look.surface(color, "metal")),
                  (join([shaft, boss]), textures.brushed_metal(look.rng, STEEL)),
                  (back, textures.plain((240, 240, 236))), (join(tabs), textures.plain(GOLD))],
                 [hull_of(can), hull_of(shaft)])  # fmt: skip


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
    return shape([(join([*blades, hub]), textures.speckles(look.rng, color, 3, 32))],
                 [*(hull_of(s) for s in blades), cylinder_part(0.0075 * k,
                     high + 0.0015)])  # fmt: skip


def solder_spool(look: Look) -> Shape:
    """A spool of solder wire standing on its flange."""
    k = look.between(0.9, 1.15)
    color = look.color("blue", "red", "black", "green", "yellow", "white")
    r, h, core = 0.03 * k, 0.045 * k, 0.009 * k
    ends = [lathe([(core, z), (r, z), (r, z + 0.003), (core, z + 0.003)], 32, loop=True)
            for z in (0, h - 0.003)]  # fmt: skip
    wire = textures.stripes([(204, 206, 210), (150, 152, 158)], 18)
    coil = lathe([(core, 0.002), (0.86 * r, 0.002), (0.86 * r, h - 0.002), (core, h - 0.002)], 32,
                 loop=True)  # fmt: skip
    label = prints.canvas(64, 64, (240, 236, 226))
    prints.disc(label, 0.5, 0.5, 0.48, color)
    prints.write(label, "SOLDER", 0.5, 0.25, 0.13, readable_on(color), bold=True)
    prints.write(label, "0.8 MM", 0.5, 0.78, 0.12, readable_on(color))
    face = lathe([(core, h - 0.0004), (0.9 * r, h - 0.0004), (0.9 * r, h + 0.0003),
                  (core, h + 0.0003)], 32, loop=True)  # fmt: skip
    uv = np.clip(face.vertices[:, :2] / (1.8 * r) + 0.5, 0, 1)
    return shape([(join(ends), textures.plain(color)), (coil, wire),
                  (Solid(face.vertices, face.faces, uv), label)],
                 ring_parts([(r, 0), (r, h)], [(core, h), (core, 0)], 10))  # fmt: skip


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
    Category("led", led, (0.049, 0.0093, 0.0093), 0.001, ("led light", "light emitting diode",
             "led diode", "diode"), ("electronics",), (), ("red", "green")),
    Category("capacitor", capacitor, (0.0138, 0.0138, 0.0195), 0.003, ("electrolytic capacitor",),
             ("electronics",), ("round",), ("black",)),
    Category("ic_chip", _chip(0.02, 0.0066, 8), (0.025, 0.0105, 0.007), 0.002, ("microchip",
             "chip", "integrated circuit", "ic", "computer chip"), ("electronics",), ("flat",),
             ("black",)),
    Category("jumper_wire", jumper_wire, (0.145, 0.028, 0.0027), 0.002, ("dupont wire", "wire",
             "jumper cable", "electric wire", "hookup wire"), ("electronics",), ("flat",),
             ("red", "black")),
    Category("cpu", cpu, (0.041, 0.041, 0.0041), 0.03, ("processor", "computer processor",
             "microprocessor"), ("electronics",), ("flat",), ("green",)),
    Category("heatsink", heatsink, (0.051, 0.051, 0.0286), 0.07, ("heat sink", "cooler block",
             "cpu cooler"), ("electronics",), (), ("silver",)),
    Category("case_fan", case_fan, (0.08, 0.08, 0.025), 0.1, ("computer fan", "pc fan",
             "cooling fan", "cpu fan"), ("electronics",), ("flat",), ("black",)),
    Category("graphics_card", graphics_card, (0.242, 0.122, 0.0392), 0.9, ("gpu", "video card",
             "graphic card"), ("electronics",), ("flat", "big"), ("black",)),
    Category("ram_stick", _stick(0.133, 0.03, 8, ("green", "black", "green", "blue"), ()),
             (0.134, 0.0303, 0.0037), 0.03, ("ram", "memory module", "ram module", "ram memory",
             "memory chip", "ram card"), ("electronics",), ("flat",), ("green",)),
    Category("memory_card", _stick(0.024, 0.032, 0, ("black", "blue", "charcoal"), ("32 GB",
             "64 GB", "128 GB", "16 GB")), (0.0243, 0.0323, 0.0023), 0.003, ("sd card",
             "micro sd card", "memory sd card", "camera card"), ("electronics",),
             ("flat",), ("black", "blue")),
    Category("servo", servo, (0.062, 0.017, 0.034), 0.015, ("servo motor", "micro servo"),
             ("electronics",), (), ("blue",)),
    Category("electric_motor", electric_motor, (0.057, 0.03, 0.0228), 0.06, ("motor", "dc motor",
             "small motor", "stepper motor", "toy motor"), ("electronics",), (), ("silver",)),
    Category("propeller", propeller, (0.124, 0.0333, 0.0113), 0.006, ("drone propeller", "rotor",
             "airscrew"), ("electronics",), ("flat",), ("orange", "black")),
    Category("solder_spool", solder_spool, (0.061, 0.061, 0.0465), 0.25, ("solder",
             "spool of solder", "solder wire", "solder roll", "roll of solder", "solder reel"),
             ("electronics",), ("round",), ("blue",)),
    Category("sensor", sensor, (0.05, 0.028, 0.022), 0.01, ("ultrasonic sensor",
             "distance sensor", "sensor module", "motion sensor"), ("electronics",), (),
             ("blue",)),
    Category("push_button", push_button, (0.093, 0.093, 0.036), 0.15, ("button switch",
             "red button", "emergency button", "buzzer", "arcade button", "quiz buzzer",
             "emergency stop", "emergency stop button"), ("electronics",), ("round",), ("red",)),
)  # fmt: skip
"""The module's categories."""
