"""Motors, fans, cards and other larger electronic parts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.forms import lay_down
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from .parts import DARK, GOLD, STEEL


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

    def make(look: Look) -> Shape:
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

    return make


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
    can = lay_down(can, -long / 2, 0.76 * r)
    shaft = lay_down(cylinder(0.0012 * k, 0.014 * k, 12), long / 2 - 0.001, 0.76 * r)
    boss = lay_down(cylinder(0.004 * k, 0.003 * k, 16), long / 2 - 0.0005, 0.76 * r)
    back = lay_down(cylinder(0.7 * r, 0.0015 * k, 24), -long / 2 - 0.001 * k, 0.76 * r)
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


CATEGORIES = (
    Category("heatsink", heatsink, (0.051, 0.051, 0.0286), 0.07, ("heat sink", "cooler block",
             "cpu cooler"), ("electronics",), (), ("silver",)),
    Category("case_fan", case_fan, (0.08, 0.08, 0.025), 0.1, ("computer fan", "pc fan",
             "cooling fan", "cpu fan"), ("electronics",), ("flat",), ("black",)),
    Category("graphics_card", graphics_card, (0.242, 0.122, 0.0392), 0.9, ("gpu", "video card",
             "graphic card"), ("electronics",), ("flat", "big"), ("black",)),
    vary(Category("ram_stick", _stick(0.133, 0.03, 8, ("green", "black", "green", "blue"), ()),
             (0.134, 0.0303, 0.0037), 0.03, ("ram", "memory module", "ram module", "ram memory",
             "memory chip", "ram card"), ("electronics",), ("flat",), ("green",)), 0.04),
    Category("memory_card", _stick(0.024, 0.032, 0, ("black", "blue", "charcoal"), ("32 GB",
             "64 GB", "128 GB", "16 GB")), (0.0243, 0.0323, 0.0023), 0.003, ("sd card",
             "micro sd card", "memory sd card", "camera card", "microsd card", "sim card",
             "micro sd"), ("electronics",),
             ("flat",), ("black", "blue")),
    Category("servo", servo, (0.062, 0.017, 0.034), 0.015, ("servo motor", "micro servo"),
             ("electronics",), (), ("blue",)),
    Category("electric_motor", electric_motor, (0.057, 0.03, 0.0228), 0.06, ("motor", "dc motor",
             "small motor",
             "stepper motor", "toy motor", "dynamo", "hand generator",
             "electric motor kit", "stirling engine"), ("electronics",), (), ("silver",)),
    Category("propeller", propeller, (0.124, 0.0333, 0.0113), 0.006, ("drone propeller", "rotor",
             "airscrew"), ("electronics",), ("flat",), ("orange", "black")),
    Category("solder_spool", solder_spool, (0.061, 0.061, 0.0465), 0.25, ("solder",
             "spool of solder", "solder wire", "solder roll", "roll of solder", "solder reel",
             "desoldering braid", "spool of wire", "wire spool", "reel of wire"),
             ("electronics",), ("round",), ("blue",)),
)  # fmt: skip
"""The module's categories."""
