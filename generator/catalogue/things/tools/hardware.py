"""Power tools, saws, clamps and measuring tools of a workshop."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...build.forms import side_view, wrap
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    sweep,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from .tools import lying, steel

DARK = (44, 46, 50)


def power_drill(look: Look) -> Shape:
    """A cordless drill standing on its battery, chuck towards +x."""
    k = look.between(0.92, 1.1)
    color = look.color("yellow", "teal", "red", "blue", "green", "orange")
    shell, dark = textures.speckles(look.rng, color, 4, 32), textures.speckles(look.rng, DARK, 4)
    axis, r = 0.185 * k, 0.032 * k
    print_ = prints.canvas(128, 64, color)
    prints.fill(print_, 0, 0.72, 1, 0.1, DARK)
    name = look.pick(["18V", "20V", "12V"])
    prints.write(print_, name, 0.5, 0.3, 0.3, readable_on(color), bold=True)
    motor = lathe([(0, 0), (0.7 * r, 0), (0.97 * r, 0.012 * k), (r, 0.04 * k), (r, 0.1 * k),
                   (0.8 * r, 0.125 * k), (0, 0.125 * k)], 26)  # fmt: skip
    body = lying(motor, -0.085 * k, axis)
    vent = lying(cylinder(0.9 * r, 0.016 * k, 24, bevel=0.003), -0.092 * k, axis)
    collar = lying(cylinder(0.76 * r, 0.026 * k, 24, top=0.72 * r), 0.038 * k, axis)
    chuck = lying(cylinder(0.6 * r, 0.042 * k, 18, top=0.36 * r, bevel=0.002), 0.062 * k, axis)
    bit = lying(cylinder(0.003, 0.055 * k, 10, top=0.002), 0.102 * k, axis)
    grip = side_view([(-0.05 * k, 0.05 * k), (-0.008 * k, 0.05 * k), (0.012 * k, 0.165 * k),
                      (-0.04 * k, 0.165 * k)], 0.036 * k, 0.007)  # fmt: skip
    foot = side_view([(-0.062 * k, 0.034 * k), (0.03 * k, 0.034 * k), (0.012 * k, 0.062 * k),
                      (-0.056 * k, 0.062 * k)], 0.05 * k, 0.004)  # fmt: skip
    battery = block(0.11 * k, 0.07 * k, 0.038 * k, 0.012, 0.004).move(x=-0.012 * k)
    trigger = side_view([(0.002 * k, 0.12 * k), (0.02 * k, 0.116 * k), (0.026 * k, 0.15 * k),
                         (0.008 * k, 0.152 * k)], 0.016 * k, 0.002)  # fmt: skip
    plates = [box(0.07 * k, 0.001, 0.03 * k).move(-0.03 * k, s * (r + 0.0003), axis - 0.016 * k)
              for s in (-1, 1)]  # fmt: skip
    return shape(
        [(join([body, foot]), shell), (join([vent, grip, battery, collar]), dark),
         (chuck, textures.plain((70, 72, 78))), (bit, steel(look)),
         (trigger, textures.plain(look.own_color("red", "black", "orange"))),
         (join(plates), print_)],
        [hull_of(battery), hull_of(foot, grip), hull_of(body, vent), hull_of(collar, chuck),
         box_part(0.055 * k, 0.005, 0.005, (0.13 * k, 0, axis - 0.0025))],
    )  # fmt: skip


def hand_saw(look: Look) -> Shape:
    """A hand saw lying flat: toothed blade, closed grip."""
    length, tall = look.between(0.27, 0.34), look.between(0.085, 0.1)
    wood = look.surface(look.color("wooden", "red", "orange", "black", "yellow"), "plastic")
    n = 36
    x = np.linspace(-0.02, length, n)
    edge = np.column_stack([x, -0.5 * tall + 0.0045 * (np.arange(n) % 2)])
    outline = np.concatenate([edge, [(length, -0.12 * tall), (-0.02, 0.5 * tall)]])
    blade = prism(outline, 0.010, 0.0118)
    corners = [(-0.006, 0.5 * tall, 0), (-0.03, 0.62 * tall, 0), (-0.085, 0.42 * tall, 0),
               (-0.1, 0.1 * tall, 0), (-0.09, -0.42 * tall, 0), (-0.04, -0.62 * tall, 0),
               (-0.012, -0.45 * tall, 0), (-0.006, 0, 0), (-0.006, 0.45 * tall, 0)]  # fmt: skip
    grip = tube(smooth(corners, 3)[:-1], 0.0125, 10, squash=0.86, loop=True).move(z=0.011)
    cheek = block(0.03, 0.8 * tall, 0.021, 0.006, 0.004).move(x=0.004)
    bolts = [cylinder(0.005, 0.023, 12).move(0.006, s * 0.24 * tall) for s in (-1, 1)]
    keel = box(length - 0.06, 0.006, 0.01).move(x=length / 2, y=0.02 * tall)
    return shape(
        [(blade, steel(look)), (join([grip, cheek]), wood),
         (join([*bolts, keel]), textures.brushed_metal(look.rng, (196, 170, 100)))],
        [hull_of(blade), hull_part(grip.vertices), box_part(length - 0.06, 0.006, 0.01,
         (length / 2, 0.02 * tall, 0))],
    )  # fmt: skip


def clamp(look: Look) -> Shape:
    """A C-clamp lying flat: frame, screw, sliding handle."""
    x, y = look.between(0.08, 0.11), look.between(0.11, 0.16)
    frame_tile = textures.speckles(
        look.rng, look.color("red", "blue", "gray", "orange", "black"), 5
    )
    path = smooth([(x, 0.47 * y, 0), (0.45 * x, 0.5 * y, 0), (0, 0.36 * y, 0), (0, -0.36 * y, 0),
                   (0.45 * x, -0.5 * y, 0), (x, -0.47 * y, 0)], 4)  # fmt: skip
    frame = sweep(path, rectangle(0.016, 0.018, 0.003, 2)).move(z=0.0095)
    pad = cylinder(0.011, 0.012, 16).turn(0, np.pi / 2).move(x - 0.004, 0.45 * y, 0.011)
    nut = cylinder(0.0095, 0.03, 14).turn(0, np.pi / 2).move(x - 0.004, -0.4 * y, 0.0095)
    screw = cylinder(0.0055, 0.95 * y, 12).turn(0, -np.pi / 2).move(x - 0.004, -0.82 * y, 0.0095)
    disc = cylinder(0.012, 0.01, 18, bevel=0.002).turn(0, np.pi / 2)
    disc = disc.move(x - 0.004, 0.14 * y, 0.012)
    bar = lying(cylinder(0.0035, 0.07, 10), x - 0.039, 0.0095).move(y=-0.79 * y)
    metal = textures.stripes([(150, 152, 156), (110, 112, 116)], 24, side=96)
    corners = np.array([(dx, dy, z) for dx in (-0.007, 0.007) for dy in (-0.007, 0.007)
                        for z in (0.0006, 0.018)])  # fmt: skip
    arms = [hull_part((path[a : b + 1, None] + corners).reshape(-1, 3))
            for a, b in ((0, 8), (8, 12), (12, 20))]  # fmt: skip
    return shape(
        [(join([frame, nut]), frame_tile), (screw, metal),
         (join([pad, disc, bar]), steel(look))],
        [*arms, box_part(0.012, 0.95 * y, 0.012, (x - 0.004, -0.34 * y, 0.0035)),
         box_part(0.07, 0.007, 0.012, (x - 0.004, -0.79 * y, 0.0005)),
         box_part(0.024, 0.01, 0.022, (x - 0.004, 0.135 * y, 0.0005))],
    )  # fmt: skip


def spirit_level(look: Look) -> Shape:
    """A spirit level standing on its edge, with a middle and an end vial."""
    x, z, y = look.between(0.25, 0.42), look.between(0.045, 0.058), look.between(0.02, 0.026)
    color = look.color("yellow", "red", "blue", "orange", "silver")
    face = prints.canvas(320, 48, color)
    prints.fill(face, 0, 0, 1, 0.1, tint_color(color, 0.7))
    prints.fill(face, 0, 0.9, 1, 0.1, tint_color(color, 0.7))
    prints.write(face[:, 210:260], "LEVEL", 0.5, 0.5, 0.35, readable_on(color), bold=True)
    prints.fill(face, 0.41, 0, 0.18, 0.62, DARK)
    for u in (0.1, 0.9):
        prints.disc(face, u, 0.5, 0.4, DARK)
    vial, mark = (186, 226, 70), (30, 60, 20)
    prints.fill(face, 0.425, 0.16, 0.15, 0.3, vial)
    prints.fill(face, 0.488, 0.18, 0.024, 0.26, (232, 248, 190))
    for u in (0.48, 0.518):
        prints.fill(face, u, 0.16, 0.004, 0.3, mark)
    for u in (0.1, 0.9):
        prints.fill(face, u - 0.013, 0.2, 0.026, 0.6, vial)
        prints.fill(face, u - 0.01, 0.42, 0.02, 0.16, (232, 248, 190))
    bar = box(x, y, z)
    ends = [box(0.008, y + 0.002, z).move(x=s * (x / 2)) for s in (-1, 1)]
    window = box(0.15 * x, y * 0.7, 0.002).move(z=z - 0.001)
    return shape(
        [(bar, face), (join(ends), textures.plain(DARK)), (window, textures.plain(vial))],
        [box_part(x, y, z)],
    )


def multimeter(look: Look) -> Shape:
    """A multimeter lying on its back with its test leads."""
    x, y, h = look.between(0.072, 0.085), look.between(0.14, 0.165), look.between(0.032, 0.04)
    color = look.color("yellow", "red", "orange", "green", "blue")
    face = prints.canvas(96, 176, (54, 57, 62))
    prints.fill(face, 0.1, 0.06, 0.8, 0.24, (176, 192, 168))
    prints.write(face[10:54, 12:84], f"{look.rng.uniform(1, 240):.1f}", 0.5, 0.5, 0.6, (30, 36, 30),
                 bold=True)  # fmt: skip
    prints.disc(face, 0.5, 0.58, 0.17, (220, 220, 214), 0.155)
    for k in range(16):
        a = np.pi * k / 8
        tick = (230, 90, 60) if k % 4 == 0 else (225, 225, 220)
        prints.disc(face, 0.5 + 0.385 * np.sin(a), 0.58 - 0.21 * np.cos(a), 0.009, tick)
    for k, ink in enumerate([(200, 40, 40), (20, 20, 22), (200, 40, 40)]):
        prints.disc(face, 0.24 + 0.26 * k, 0.92, 0.032, ink)
    body = block(x, y, h, 0.014, 0.006)
    panel = block(0.84 * x, 0.9 * y, 0.002, 0.008).move(z=h - 0.0008)
    knob = cylinder(0.015, 0.009, 22, bevel=0.002).move(y=-0.075 * y, z=h)
    pointer = box(0.005, 0.026, 0.004).move(y=-0.075 * y, z=h + 0.008)
    pieces = [
        (body, textures.speckles(look.rng, color, 4)), (panel, face),
        (knob, textures.plain((30, 32, 36))), (pointer, textures.plain((230, 230, 226))),
    ]  # fmt: skip
    parts = [box_part(x, y, h), cylinder_part(0.015, 0.009, (0, -0.075 * y, h))]
    for s, ink in ((-1, (24, 24, 28)), (1, (196, 36, 34))):
        foot = 0.22 * x * s
        side = x / 2 + 0.022 + 0.009 * s
        lead = smooth(
            [(foot, -0.41 * y, h), (foot, -0.46 * y, h + 0.012), (foot + 0.01, -0.6 * y, 0.012),
             (side - 0.02, -0.66 * y, 0.003), (side, -0.5 * y, 0.003), (side, -0.16 * y, 0.005)], 3,
        )  # fmt: skip
        probe = cylinder(0.0045, 0.075, 10, top=0.0055).turn(0, -np.pi / 2)
        tip = cylinder(0.0012, 0.018, 8).turn(0, -np.pi / 2).move(side, 0.074 - 0.16 * y, 0.0055)
        probe = probe.move(side, -0.16 * y, 0.0055)
        pieces += [(join([tube(lead, 0.0018, 6), probe]), textures.plain(ink)),
                   (tip, steel(look))]  # fmt: skip
        parts.append(box_part(0.009, 0.075, 0.01, (side, -0.16 * y + 0.0375, 0)))
    return shape(pieces, parts)


def soldering_iron(look: Look) -> Shape:
    """A soldering iron in its coil stand, with a sponge."""
    x, y = look.between(0.15, 0.17), look.between(0.075, 0.085)
    color = look.color("blue", "red", "yellow", "orange", "green")
    base = block(x, y, 0.014, 0.008, 0.003)
    sponge = block(0.055, 0.05, 0.01, 0.005, 0.002).move(x=-0.28 * x, z=0.012)
    t = np.linspace(0, 2 * np.pi * 9, 91)
    coil = np.column_stack([0.012 * np.cos(t), 0.012 * np.sin(t), np.linspace(0.0, 0.07, 91)])
    tilt, place = 0.72, (0.1 * x, 0, 0.03)
    spring = tube(coil, 0.0014, 5).turn(1, tilt).move(*place)
    rod = cylinder(0.004, 0.1, 10, top=0.0045).move(z=-0.012).turn(1, tilt).move(*place)
    handle = lathe([(0, 0.082), (0.012, 0.082), (0.014, 0.09), (0.0085, 0.1), (0.0105, 0.125),
                    (0.0095, 0.2), (0.005, 0.21), (0, 0.21)], 18)  # fmt: skip
    handle = handle.turn(1, tilt).move(*place)
    post = side_view([(0.02 * x, 0.012), (0.3 * x, 0.012), (0.26 * x, 0.05), (0.1 * x, 0.045)],
                     0.012, 0.002)  # fmt: skip
    return shape(
        [(join([base, post]), textures.speckles(look.rng, look.own_color("charcoal", "gray"), 4)),
         (sponge, textures.spots(look.rng, (226, 200, 96), (180, 150, 60), 0.1)),
         (join([spring, rod]), steel(look)), (handle, textures.speckles(look.rng, color, 4))],
        [box_part(x, y, 0.014), hull_of(post), hull_of(spring), hull_of(handle)],
    )  # fmt: skip


def tool_kit(look: Look) -> Shape:
    """An open case of sockets, bits and a ratchet."""
    x, y, h = look.between(0.26, 0.34), look.between(0.17, 0.21), look.between(0.034, 0.042)
    color = look.color("red", "black", "blue", "orange", "green")
    shell, metal = textures.speckles(look.rng, color, 4), steel(look)
    inlay = textures.speckles(look.rng, look.own_color("charcoal", "black"), 4)
    tray = block(x, y, h, 0.012, 0.003)
    bed = box(0.92 * x, 0.88 * y, 0.002).move(z=h - 0.0012)
    sockets = []
    for row in range(2):
        for k in range(8):
            r = x / 22 * (0.55 + 0.06 * k + 0.1 * row)
            at = ((k - 3.5) * x / 9.2, -0.3 * y + 0.24 * y * row, h)
            sockets.append(cylinder(r, 0.012, 12, bevel=0.001).move(*at))
    ratchet = [lying(cylinder(0.007, 0.5 * x, 12), -0.42 * x, h + 0.007).move(y=0.22 * y),
               cylinder(0.017, 0.016, 18, bevel=0.002).move(0.1 * x, 0.22 * y, h)]  # fmt: skip
    bits = [box(0.006, 0.026, 0.007).move(0.22 * x + 0.012 * k, 0.22 * y, h)
            for k in range(5)]  # fmt: skip
    lid = block(x, y, 0.02, 0.012, 0.003)
    inner = box(0.92 * x, 0.88 * y, 0.002).move(z=0.019)
    paper = prints.canvas(160, 96, (60, 62, 66))
    for k in range(6):
        prints.fill(paper, 0.08 + 0.15 * k, 0.2, 0.07, 0.55, (86, 88, 94))
    lean = np.pi / 2 - 0.22

    def tilt(solid: Solid) -> Solid:
        return solid.move(y=y / 2 + 0.002, z=-0.02).turn(0, lean).move(y=y / 2 + 0.016, z=0.02)

    bow = tube([(-0.04, -y / 2, h / 2), (-0.036, -y / 2 - 0.018, h / 2),
                (0.036, -y / 2 - 0.018, h / 2), (0.04, -y / 2, h / 2)], 0.006, 8)  # fmt: skip
    return shape(
        [(join([tray, tilt(lid)]), shell), (bed, inlay), (tilt(inner), paper),
         (join([*sockets, *ratchet, *bits]), metal), (bow, textures.plain(DARK))],
        [box_part(x, y, h), hull_of(tilt(lid)),
         box_part(0.92 * x, 0.5 * y, 0.01, (0, -0.2 * y, h))],
    )  # fmt: skip


def paint_can(look: Look) -> Shape:
    """A can of paint with its wire bow: closed, or open and full."""
    r, h = look.between(0.046, 0.062), look.between(0.1, 0.135)
    color = look.color("red", "blue", "yellow", "green", "teal", "orange", "purple", "white")
    label = wrap(look, look.pick(["PAINT", "COLOR", "LATEX", "GLOSS"]), color, (242, 241, 236))
    tin = textures.brushed_metal(look.rng, (184, 186, 190))
    rims = [torus(r, 0.0018, 32, 6).move(z=z) for z in (0.002, h)]
    ears = [ellipsoid(0.012, 0.014, 0.014, 10, 6).move(s * r, 0, 0.84 * h) for s in (-1, 1)]
    a = np.linspace(0, np.pi, 13)
    bow = tube(np.column_stack([1.04 * r * np.cos(a), -0.9 * r * np.sin(a) - 0.12 * r * np.sin(a),
                                0.84 * h - 0.34 * h * np.sin(a)]), 0.0016, 6)  # fmt: skip
    drip = join(
        [
            ellipsoid(0.012, 0.004, long, 8, 6).move(0, -r, h - long / 2).turn(2, angle)
            for angle, long in look.rng.uniform((-0.9, 0.02), (0.9, 0.06), (3, 2))
        ]
    )
    pieces = [(join([*rims, *ears, bow]), tin), (drip, textures.plain(color))]
    if look.chance(0.5):
        groove = torus(0.78 * r, 0.0016, 28, 6).move(z=h + 0.0008)
        lid = join([cylinder(0.97 * r, 0.003, 28, bevel=0.001).move(z=h - 0.002), groove])
        pieces += [(cylinder(r, h, 30), label), (lid, tin)]
        return shape(pieces, [cylinder_part(r, h)])
    body = lathe([(0, 0), (r, 0), (r, h), (0.94 * r, h), (0.94 * r, 0.8 * h), (0, 0.8 * h)], 30,
                 v=[0, 0, 0.97, 0.98, 0.99, 1])  # fmt: skip
    wet = cylinder(0.94 * r, 0.003, 28).move(z=0.8 * h)
    pieces += [(body, label), (wet, textures.gradient(color, tint_color(color, 1.15), look.rng))]
    ring = ring_parts([(r, 0.8 * h), (r, h)], [(0.94 * r, h), (0.94 * r, 0.8 * h)], 10)
    return shape(pieces, [cylinder_part(r, 0.8 * h), *ring])


CATEGORIES = (
    Category("power_drill", power_drill, (0.255, 0.07, 0.217), 1.2,
             ("drill", "cordless drill", "electric drill", "hand drill", "drill driver",
             "hot air gun", "impact driver", "electric screwdriver", "hammer drill"),
             ("workbench",), ("tall",), ("yellow", "teal")),
    Category("hand_saw", hand_saw, (0.415, 0.12, 0.024), 0.45, ("saw", "handsaw", "wood saw",
             "jeweller saw", "coping saw"),
             ("workbench",), ("flat",), ("wooden", "red"), state="lying flat"),
    Category("clamp", clamp, (0.115, 0.2, 0.023), 0.6,
             ("c-clamp", "c clamp", "g-clamp", "g clamp"),
             ("workbench",), ("flat",), ("red", "blue"), state="lying flat"),
    Category("spirit_level", spirit_level, (0.34, 0.025, 0.053), 0.35,
             ("level", "bubble level", "builder's level", "mini level"), ("workbench",), (),
             ("yellow", "red")),
    Category("multimeter", multimeter, (0.115, 0.185, 0.051), 0.38,
             ("voltmeter", "tester", "digital multimeter", "volt meter", "ammeter", "stud finder",
             "light meter", "water meter", "ph meter", "conductivity meter", "glucose meter",
             "hygrometer meter"),
             ("workbench", "lab"), (), ("yellow", "red"), state="lying flat"),
    Category("soldering_iron", soldering_iron, (0.23, 0.08, 0.185), 0.45,
             ("solder iron", "soldering station", "soldering stand", "wood burning pen"),
             ("workbench", "lab"), ("tall",), ("blue", "red")),
    Category("tool_kit", tool_kit, (0.3, 0.29, 0.2), 2.2,
             ("toolkit", "socket set", "open tool case", "open toolbox", "tool set", "wrench set"),
             ("workbench",), ("big",), ("red", "black"), state="standing open"),
    Category("paint_can", paint_can, (0.117, 0.117, 0.12), 0.9,
             ("can of paint", "tin of paint", "paint tin", "paint bucket", "tub of filler",
             "contact adhesive tin", "tub of grease", "filler tub", "varnish tin", "car wax tin",
             "paint tin lid", "tin of varnish",),
             ("workbench", "craft"), ("round",), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
