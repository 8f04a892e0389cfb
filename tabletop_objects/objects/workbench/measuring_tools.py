"""Objects of the ``workbench`` theme: measuring tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, DARK, plastic, shine, steel, tool_steel
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import at_box, disc, drum, plate, rod, spindle, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape, vary
from ...kit.solids import block, box, cylinder, join, prism, torus, tube
from ...kit.surfaces import Look, plain, readable_on, tint_color

BLACK = surfaces.plain((34, 34, 37))


@category("tyre_gauge", size=(0.138, 0.0664, 0.0201), mass=0.1, material="metal",
          aliases=("tyre pressure gauge", "tire gauge", "tire pressure gauge", "pressure gauge"),
          themes=("workbench",), colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def tyre_gauge(look: Look) -> Pieces:
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
    return [(dial, plastic(look, "black", "red", "charcoal")),
            (stem, shine(look, "silver", "brass")), (rim, BLACK), (face, image)]  # fmt: skip


CALIPER_DARK = (40, 40, 43)


@category("caliper", size=(0.215, 0.069, 0.0094), mass=0.15, material="metal", assembled=True,
          aliases=("calliper", "vernier caliper", "digital caliper", "calipers", "callipers",
          "vernier calliper", "sewing gauge"), themes=("workbench",), roles=("flat",),
          colors=("silver",), state="lying flat")  # fmt: skip
@vary()
def caliper(look: Look) -> Shape:
    """A vernier calliper lying flat, with a scale, a fixed jaw and a sliding jaw."""
    k = look.between(0.9, 1.05)
    color = look.color("silver", "silver", "black", "charcoal")
    metal = look.surface(color, "metal")
    at = look.between(-0.05, -0.02) * k
    scale = np.repeat(prints.rule(15, (206, 208, 212), (40, 40, 44)), 2, axis=0)
    beam = box(0.22 * k, 0.015 * k, 0.0035).move(x=0.01 * k, z=0.0012)
    face = box(0.19 * k, 0.0145 * k, 0.0004).move(x=0.02 * k, z=0.0046)
    jaw = np.array([(0, 0.0075), (0, -0.045), (-0.006, -0.045), (-0.018, -0.0075), (-0.018, 0.0075),
                    (-0.008, 0.024), (0, 0.026)])[::-1] * k  # fmt: skip
    fixed = prism(np.add(jaw, (-0.082 * k, 0)), 0, 0.0045)
    moving = prism(np.add((jaw * [-1, 1])[::-1], (at - 0.02 * k, 0)), 0, 0.0055)
    slide = block(0.055 * k, 0.026 * k, 0.009, 0.003, 0.001).move(x=at + 0.02 * k)
    shown = prints.canvas(64, 28, (176, 190, 176))
    prints.write(shown, f"{look.between(10, 90):.2f}", 0.5, 0.5, 0.6, (24, 26, 24))
    display = box(0.038 * k, 0.015 * k, 0.0006).move(x=at + 0.02 * k, z=0.0088)
    wheel = cylinder(0.005 * k, 0.004, 14).move(at + 0.04 * k, -0.013 * k, 0.002)
    black = surfaces.plain(CALIPER_DARK)
    return shape([(join([beam, fixed, moving]), metal), (face, scale), (slide, black),
                  (display, shown), (wheel, tool_steel(look))],
                 [hull_of(beam), hull_of(fixed), hull_of(moving), hull_of(slide)])  # fmt: skip


SPIRIT_LEVEL_DARK = (44, 46, 50)


@category("spirit_level", size=(0.34, 0.025, 0.053), mass=0.35, material="metal",
          aliases=("level", "bubble level", "builder's level", "mini level"), themes=("workbench",),
          colors=("yellow", "red"), common=True)  # fmt: skip
def spirit_level(look: Look) -> Shape:
    """A spirit level standing on its edge, with one vial in the middle and one at an end."""
    x, z, y = look.between(0.25, 0.42), look.between(0.045, 0.058), look.between(0.02, 0.026)
    color = look.color("yellow", "red", "blue", "orange", "silver")
    face = prints.canvas(320, 48, color)
    prints.fill(face, 0, 0, 1, 0.1, tint_color(color, 0.7))
    prints.fill(face, 0, 0.9, 1, 0.1, tint_color(color, 0.7))
    prints.write(face[:, 210:260], "LEVEL", 0.5, 0.5, 0.35, readable_on(color), bold=True)
    prints.fill(face, 0.41, 0, 0.18, 0.62, SPIRIT_LEVEL_DARK)
    for u in (0.1, 0.9):
        prints.disc(face, u, 0.5, 0.4, SPIRIT_LEVEL_DARK)
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
    return shape([(bar, face), (join(ends), surfaces.plain(SPIRIT_LEVEL_DARK)),
                  (window, surfaces.plain(vial))], [box_part(x, y, z)])  # fmt: skip


@category("multimeter", size=(0.115, 0.185, 0.051), mass=0.38, material="device",
          aliases=("voltmeter", "tester", "digital multimeter", "volt meter", "ammeter",
          "stud finder", "light meter", "water meter", "ph meter", "conductivity meter",
          "glucose meter", "hygrometer meter"), themes=("workbench", "lab"),
          colors=("yellow", "red"), state="lying flat", common=True)  # fmt: skip
def multimeter(look: Look) -> Shape:
    """A multimeter with its test leads, lying on its back."""
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
        (body, surfaces.speckles(look.rng, color, 4)), (panel, face),
        (knob, surfaces.plain((30, 32, 36))), (pointer, surfaces.plain((230, 230, 226))),
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
        pieces += [(join([tube(lead, 0.0018, 6), probe]), surfaces.plain(ink)),
                   (tip, tool_steel(look))]  # fmt: skip
        parts.append(box_part(0.009, 0.075, 0.01, (side, -0.16 * y + 0.0375, 0)))
    return shape(pieces, parts)


@category("tape_measure", size=(0.1, 0.037, 0.067), mass=0.2, material="plastic",
          aliases=("measuring tape",), themes=("workbench",), colors=("yellow",),
          common=True)  # fmt: skip
def tape_measure(look: Look) -> Shape:
    """A tape measure standing on its base with a bit of its blade pulled out."""
    side = look.between(0.062, 0.072)
    color = look.color("yellow", "orange", "red", "blue", "black", "silver", "lime", "white")
    word, ink = (look.pick(["5m", "3m", "8m", "PRO", "25ft"]),
                 look.pick([(40, 40, 44), (236, 236, 232)]))  # fmt: skip
    case = surfaces.speckles(look.rng, color, 4)
    face = prints.canvas(96, 96, color)
    if look.chance(0.5):
        prints.disc(face, 0.5, 0.5, 0.36, ink)
        prints.disc(face, 0.5, 0.5, 0.3, tint_color(color, 1.15))
        prints.write(face, word, 0.5, 0.5, 0.22, tint_color(color, 0.2), bold=True)
    else:
        prints.fill(face, 0, 0.3, 1, 0.4, ink)
        prints.write(face, word, 0.5, 0.5, 0.24, color, bold=True)
    body = (
        prism(rectangle(side, side, 0.02), 0, 0.036, 0.003)
        .turn(0, np.pi / 2)
        .move(y=0.018, z=side / 2)
    )
    badge = box(0.8 * side, 0.001, 0.8 * side).move(y=-0.0183, z=0.1 * side)
    blade = box(0.04, 0.02, 0.0014).move(x=side / 2 + 0.016, z=0.003)
    return shape(
        [
            (body, case),
            (badge, face),
            (
                blade,
                surfaces.stripes(
                    [look.pick([(244, 214, 70), (240, 240, 236)]), (40, 40, 40)], 8, upright=True
                ),
            ),
        ],
        [box_part(side, 0.036, side), box_part(0.036, 0.02, 0.0014, (side / 2 + 0.018, 0, 0.003))],
    )


@category("try_square", size=(0.117, 0.216, 0.017), mass=0.25, material="metal",
          aliases=("combination square", "carpenter's square", "engineer's square", "speed square"),
          themes=("workbench",), roles=("flat",), colors=("wooden",))  # fmt: skip
def try_square(look: Look) -> Shape:
    """A try square lying flat: a steel blade in a thick wooden stock."""
    color = look.color("wooden", "brown", "maroon", "black", "blue")
    k = look.between(0.85, 1.15)
    blade = at_box(0.03, 0.2, 0.002, (-0.035, 0.045, 0.0075))
    stock = block(0.12, 0.034, 0.017, 0.003, 0.002).move(0.01, -0.06, 0)
    face = [at_box(0.118, 0.002, 0.0155, (0.01, -0.0435, 0.0006))]
    pins = [drum(0.0028, 0.0006, (x, y, 0.0168), sides=10) for x,
            y in ((-0.045, -0.06), (-0.028, -0.052), (-0.028, -0.068))]  # fmt: skip
    return put_down([(blade, prints.rule(20, (200, 204, 208), (50, 52, 56))),
                     (stock, look.surface(color, "wood")),
                     (join([*face, *pins]), steel(look, BRASS_TONE))], stock, blade,
                    factor=k)  # fmt: skip


@category("bevel_gauge", size=(0.154, 0.154, 0.0252), mass=0.2, material="metal",
          aliases=("sliding bevel", "bevel square", "t-bevel"), themes=("workbench",),
          roles=("flat",), colors=("wooden",))  # fmt: skip
def bevel_gauge(look: Look) -> Shape:
    """A sliding bevel lying flat with its blade at an angle."""
    color = look.color("wooden", "brown", "black", "maroon")
    k = look.between(0.85, 1.15)
    stock = block(0.13, 0.026, 0.017, 0.006, 0.002)
    blade = (
        plate(rectangle(0.17, 0.022, 0.004), 0.0022, at=(0.04, 0, 0.0075))
        .move(-0.055)
        .turn(2, look.between(0.6, 2.2))
    )
    blade = blade.move(0.055)
    nut = [drum(0.009, 0.006, (0.055, 0, 0.016)), at_box(0.022, 0.005, 0.008, (0.055, 0, 0.018))]
    return put_down([(stock, look.surface(color, "wood")), (blade, steel(look)),
                     (join(nut), steel(look, BRASS_TONE))], stock, blade, nut[1],
                    factor=k)  # fmt: skip


@category("marking_gauge", size=(0.205, 0.0645, 0.0743), mass=0.18, material="wood",
          aliases=("mortise gauge", "scribing gauge"), themes=("workbench",),
          colors=("wooden",))  # fmt: skip
def marking_gauge(look: Look) -> Shape:
    """A marking gauge lying flat: a square beam that passes through a head with a thumbscrew."""
    color = look.color("wooden", "tan", "brown", "maroon")
    k = look.between(0.85, 1.15)
    beam = at_box(0.21, 0.017, 0.017)
    head = block(0.028, 0.066, 0.054, 0.008, 0.003).move(0.03)
    screw = [drum(0.004, 0.016, (0.03, 0, 0.053)), at_box(0.02, 0.005, 0.014, (0.03, 0, 0.062))]
    pin = straight((-0.098, 0, 0.016), (-0.098, 0, 0.024), [0.0014, 0.0004], 6)
    wood = look.surface(color, "wood")
    return put_down([(join([beam, head]), wood), (join([*screw, pin]), steel(look, BRASS_TONE))],
                    beam, head, factor=k)  # fmt: skip


@category("micrometer", size=(0.154, 0.0481, 0.0158), mass=0.25, material="metal",
          aliases=("micrometre gauge", "screw gauge"), themes=("workbench",), roles=("flat",),
          colors=("green", "gray"))  # fmt: skip
def micrometer(look: Look) -> Shape:
    """A micrometer lying flat: a horseshoe frame, a spindle and a ribbed thimble."""
    color = look.color("green", "gray", "black", "silver", "blue")
    k = look.between(0.85, 1.2)
    a = np.linspace(0.5 * np.pi, 1.5 * np.pi, 14) + np.pi / 2
    frame = tube(
        np.column_stack([0.034 * np.cos(a), 0.03 * np.sin(a) + 0.006, 0.0065 + 0 * a]), 0.007, 8
    )
    anvil = straight((-0.036, 0.008, 0.0065), (-0.008, 0.008, 0.0065), 0.0035, 12)
    spindle = straight((0.002, 0.008, 0.0065), (0.05, 0.008, 0.0065), 0.0033, 12)
    sleeve = drum(0.0062, 0.03, (0.034, 0.008, 0.0068), 0, sides=18)
    thimble = drum(0.0078, 0.038, (0.056, 0.008, 0.0076), 0, sides=18)
    knob = drum(0.005, 0.014, (0.094, 0.008, 0.0076), 0, sides=14)
    grip = surfaces.grid((90, 92, 96), (190, 194, 200), 16, 16, 64, 2)
    return put_down([(frame, plain(color)), (join([anvil, spindle]), steel(look)),
                     (sleeve, prints.rule(5, (206, 208, 212), (40, 40, 44))),
                     (join([thimble, knob]), grip)], frame, sleeve, thimble, knob, factor=k,
                    foot=0.3)  # fmt: skip


@category("feeler_gauge", size=(0.0958, 0.0944, 0.0117), mass=0.07, material="metal",
          aliases=("needle gauge", "thread gauge"), themes=("workbench",), roles=("flat",),
          colors=("silver",))  # fmt: skip
def feeler_gauge(look: Look) -> Shape:
    """A feeler gauge lying flat: a set of thin blades fanned out of a holder."""
    color = look.color("silver", "red", "black")
    k = look.between(0.85, 1.15)
    blades = [plate(rectangle(0.09, 0.012, 0.0059), 0.001,
                    at=(0.04, 0, 0.001 + 0.0009 * n)).turn(2, 0.16 * n - 0.35)
              for n in range(7)]  # fmt: skip
    holder = [plate(rectangle(0.1, 0.017, 0.008), 0.0012, at=(0.036, 0, z)).turn(2, -0.5)
              for z in (0.0, 0.008)]  # fmt: skip
    nut = drum(0.006, 0.012, (0, 0, 0))
    return put_down([(join(blades), steel(look)), (join(holder), look.surface(color, "steel")),
                     (nut, steel(look, BRASS_TONE))], join(blades), *holder, factor=k,
                    foot=0.3)  # fmt: skip


@category("folding_rule", size=(0.33, 0.0995, 0.00719), mass=0.1, material="wood",
          aliases=("folding ruler", "carpenter's rule", "zigzag rule"), themes=("workbench",),
          roles=("flat", "big"), colors=("yellow",))  # fmt: skip
def folding_rule(look: Look) -> Shape:
    """A folding rule, lying in a zigzag."""
    color = look.color("yellow", "wooden", "white", "tan")
    k = look.between(0.8, 1.1)
    legs, pins = [], []
    x, y, side = -0.11, 0.0, 1
    for n in range(4):
        a = 0.8 * side
        leg = (at_box(0.13, 0.015, 0.0034, (0.058, 0, 0.0006 + 0.0026
                                            * (n % 2))).turn(2, a).move(x, y, 0))  # fmt: skip
        legs.append(leg)
        x, y = x + 0.116 * np.cos(a), y + 0.116 * np.sin(a)
        pins.append(drum(0.005, 0.0075, (x, y, 0), sides=12))
        side = -side
    scale = prints.rule(12, color, (40, 38, 36))
    low = [legs[0], legs[2]]
    return put_down([(join(legs), scale), (join(pins[:3]), steel(look, BRASS_TONE))], *low,
                    *legs[1::2], *pins[:3], factor=k)  # fmt: skip


@category("chalk_line", size=(0.167, 0.0709, 0.0482), mass=0.18, material="plastic",
          aliases=("chalk reel", "chalk line reel"), themes=("workbench",),
          colors=("red", "blue"))  # fmt: skip
def chalk_line(look: Look) -> Shape:
    """A chalk line reel lying flat: a pear-shaped case with a crank and a cord with a hook."""
    color = look.color("red", "blue", "yellow", "orange", "silver")
    k = look.between(0.85, 1.15)
    rim = smooth([(-0.055, 0), (-0.045, 0.03), (0, 0.034), (0.045, 0.015), (0.058, 0),
                  (0.045, -0.015), (0, -0.034), (-0.045, -0.03), (-0.055, 0)], 3)[:-1]  # fmt: skip
    case = plate(rim, 0.03, bevel=0.006)
    slab = drum(0.02, 0.004, (-0.012, 0, 0.029))
    crank = [at_box(0.034, 0.008, 0.004, (0.0, 0, 0.032)), drum(0.005, 0.014, (0.012, 0, 0.034))]
    cord = rod([(0.056, 0, 0.014), (0.085, 0.006, 0.003), (0.1, -0.004, 0.002)], 0.0012, 6)
    hook = at_box(0.014, 0.01, 0.002, (0.104, -0.004, 0.0))
    return put_down([(case, look.surface(color, "plastic")), (join([slab, *crank]), plain(DARK)),
                     (cord, plain((90, 130, 200))), (hook, steel(look))], case, join(crank), hook,
                    factor=k)  # fmt: skip
