"""Objects of the ``office`` theme: instruments."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, plastic, shine, wood
from ...kit.outlines import arc, smooth
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    hull_solid,
    plate,
    rod,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Category, Drawing, Pieces, category, from_pieces, vary
from ...kit.solids import join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color


@category("weather_vane", size=(0.2, 0.13, 0.265), mass=0.6, material="metal", assembled=True,
          aliases=("weathervane", "wind vane", "weathercock"), themes=("office",), roles=("tall",),
          colors=("black",))  # fmt: skip
@from_pieces()
def weather_vane(look: Look) -> Pieces:
    """A weather vane on a base: a cockerel and an arrow above compass letters."""
    tile = metal(look, "black", "copper", "charcoal", "bronze")
    foot, post = (standing((0.05, 0), (0.048, 0.008), (0.012, 0.016)),
                  straight((0, 0, 0.01), (0, 0, 0.2), 0.004, 10))  # fmt: skip
    cross = [
        straight((-0.06, 0, 0.11), (0.06, 0, 0.11), 0.0026, 8),
        straight((0, -0.06, 0.11), (0, 0.06, 0.11), 0.0026, 8),
    ]
    ends = [
        ball(0.014, 0.014, 0.014, p, 8)
        for p in ((-0.06, 0, 0.11), (0.06, 0, 0.11), (0, -0.06, 0.11), (0, 0.06, 0.11))
    ]
    arrow = [
        straight((-0.09, 0, 0.17), (0.07, 0, 0.17), 0.003, 8),
        hull_solid(
            [
                (0.07, 0, 0.185),
                (0.07, 0, 0.155),
                (0.1, 0, 0.17),
                (0.07, 0.002, 0.17),
                (0.07, -0.002, 0.17),
            ]
        ),
    ]
    bird = smooth([(-0.075, 0.245), (-0.08, 0.215), (-0.05, 0.2), (-0.03, 0.185), (0.02, 0.185),
                   (0.035, 0.21), (0.035, 0.24), (0.05, 0.245), (0.035, 0.262), (0.02, 0.255),
                   (0.01, 0.225), (-0.02, 0.215), (-0.045, 0.235), (-0.055, 0.262)], 4)  # fmt: skip
    cock = plate(bird, 0.003).turn(0, np.pi / 2).move(y=0.0015)
    return [(foot, tile), (post, tile), *((c, tile) for c in cross), (join(ends), tile),
            (join(arrow), tile), (cock, tile)]  # fmt: skip


@category("sundial", size=(0.16, 0.16, 0.11), mass=0.9, material="metal",
          aliases=("sun dial", "brass sundial"), themes=("office",),
          colors=("bronze",))  # fmt: skip
@from_pieces(bodies=2)
def sundial(look: Look) -> Pieces:
    """A sundial on a turned base: a round dial with hour lines, numbers and a triangular fin."""
    color = look.color("bronze", "gray", "brass", "beige", "copper")
    image = prints.canvas(128, 128, color)
    dark = tint_color(color, 0.45)
    prints.disc(image, 0.5, 0.5, 0.47, dark, 0.45)
    for k in range(13):
        a = np.pi * (k / 12)
        prints.stroke(image, [(0.5 + 0.16 * np.cos(a), 0.55 - 0.16 * np.sin(a)),
                              (0.5 + 0.36 * np.cos(a), 0.55 - 0.36 * np.sin(a))], 0.01,
                      dark)  # fmt: skip
        prints.write(image, str((k + 5) % 12 + 1), 0.5 - 0.41 * np.cos(a), 0.55 - 0.41 * np.sin(a),
                     0.07, dark)  # fmt: skip
    tile = look.surface(color, "metal")
    foot = standing((0.06, 0), (0.05, 0.014), (0.04, 0.03), (0.075, 0.046), (0.08, 0.056), sides=36)
    face = disc(0.076, 0.001, (0, 0, 0.0556), sides=36)
    fin = hull_solid([(x, y, z) for x in (-0.002, 0.002) for y, z in ((-0.02, 0.056), (0.05, 0.056),
                                                                      (0.05, 0.11))])  # fmt: skip
    return [(foot, tile), (fin, tile), (face, image)]


@category("planisphere", size=(0.2, 0.2, 0.0041), mass=0.06, material="paper",
          aliases=("star wheel", "star finder", "colour wheel", "color wheel"), themes=("office",),
          colors=("navy",))  # fmt: skip
@from_pieces()
def planisphere(look: Look) -> Pieces:
    """A planisphere: a star disc in a card sleeve with an oval window."""
    image = prints.canvas(128, 128, (24, 34, 78))
    for _ in range(90):
        prints.disc(image, look.between(0.1, 0.9), look.between(0.1, 0.9),
                    look.between(0.004, 0.01), (232, 236, 246))  # fmt: skip
    card = prints.canvas(128, 128, look.color("navy", "teal", "purple", "black"))
    base = at_block(0.2, 0.2, 0.003, 0.02)
    rim = disc(0.095, 0.0008, (0, 0, 0.0028), sides=44)
    ringed = prints.canvas(96, 96, (240, 236, 220))
    for k in range(36):
        a = k * np.pi / 18
        prints.disc(ringed, 0.5 + 0.46 * np.cos(a), 0.5 + 0.46 * np.sin(a), 0.012, (60, 60, 70))
    window = disc(0.08, 0.0008, (0, 0, 0.0033), sides=44)
    return [(base, card), (rim, ringed), (window, image)]


BLACK = surfaces.plain((34, 34, 37))


@category("theodolite", size=(0.13, 0.18, 0.21), mass=3.0, material="plastic",
          aliases=("surveyor level", "surveying instrument", "total station", "surveyor transit",
          "dumpy level"), themes=("office",), colors=("yellow",))  # fmt: skip
@from_pieces(bodies=7)
def theodolite(look: Look) -> Pieces:
    """A theodolite: a telescope in a yoke on a round base."""
    tile = plastic(look, "yellow", "green", "orange")
    base = [disc(0.06, 0.012), disc(0.045, 0.03, (0, 0, 0.018))]
    screws = [disc(0.011, 0.014, (0.045 * np.cos(a), 0.045 * np.sin(a), 0.01)) for a in np.arange(3)
              * 2.0944]  # fmt: skip
    yoke = [at_block(0.026, 0.06, 0.13, 0.01, (s * 0.05, 0, 0.046)) for s in (-1, 1)]
    bridge = at_block(0.13, 0.07, 0.02, 0.012, (0, 0, 0.045))
    scope = (spindle((-0.09, 0.018), (-0.05, 0.018), (-0.03, 0.024), (0.05, 0.024), (0.07, 0.03),
                     (0.09, 0.03), z=0).turn(2, np.pi / 2).move(0, 0, 0.13))  # fmt: skip
    lens = disc(0.025, 0.001).turn(0, np.pi / 2).move(0, -0.0905, 0.13)
    grip = rod([(-0.05, 0, 0.17), (-0.04, 0, 0.2), (0.04, 0, 0.2), (0.05, 0, 0.17)], 0.008, 8)
    return [(base[0], BLACK), (base[1], tile), (yoke[0], tile), (yoke[1], tile), (bridge, tile),
            (scope, dye(look, "charcoal", "white")), (grip, BLACK), (join(screws), BLACK),
            (lens, surfaces.plain((90, 120, 170)))]  # fmt: skip


SEXTANT_BLACK = surfaces.plain((34, 34, 37))
BRASS = ("brass", "gold", "bronze")


def _dial(look: Look, title: str, hands: int = 1) -> surfaces.Tile:
    """Return the face of a meter with marks, a title and needles."""
    image = prints.canvas(96, 96, (246, 242, 228))
    for k in range(25):
        a = np.pi * 1.25 - k * np.pi * 1.5 / 24
        prints.disc(image, 0.5 + 0.42 * np.cos(a), 0.5 - 0.42 * np.sin(a), 0.016 if k % 4 else 0.03,
                    (40, 40, 44))  # fmt: skip
    prints.write(image, title, 0.5, 0.7, 0.1, (60, 50, 40), True)
    for _ in range(hands):
        a = look.between(0.2, 2.9)
        prints.stroke(image, [(0.5 - 0.08 * np.cos(a), 0.5 + 0.08 * np.sin(a)),
                              (0.5 + 0.34 * np.cos(a), 0.5 - 0.34 * np.sin(a))], 0.03,
                      (170, 40, 34))  # fmt: skip
    prints.disc(image, 0.5, 0.5, 0.04, (60, 60, 64))
    return image


def _meter(title: str) -> Drawing:
    """Return the drawing function of a round meter in a brass ring on a wooden base."""

    def draw(look: Look) -> Pieces:
        tile, case = metal(look, *BRASS), wood(look, "brown", "wooden", "maroon")
        foot = at_block(0.13, 0.06, 0.022, 0.01)
        body = disc(0.055, 0.03).turn(0, np.pi / 2).move(0, 0.015, 0.072)
        rim = torus(0.054, 0.005, 36, 8).turn(0, np.pi / 2).move(0, -0.015, 0.072)
        face = disc(0.051, 0.001).turn(0, np.pi / 2).move(0, -0.0146, 0.072)
        return [(foot, case), (body, tile), (rim, tile), (face, _dial(look, title))]

    return draw


@category("sextant", size=(0.179, 0.18, 0.0481), mass=0.9, material="metal", assembled=True,
          aliases=("brass sextant", "octant", "marine sextant"), themes=("office",),
          colors=("brass",))  # fmt: skip
@from_pieces(bodies=9)
def sextant(look: Look) -> Pieces:
    """A sextant lying flat: a frame with a scale, an arm, a telescope and mirrors."""
    tile = metal(look, *BRASS)
    curve = tube([(*p, 0.012) for p in arc((0, 0.09), 0.17, -np.pi / 2 - 0.55, -np.pi / 2 + 0.55,
                                           18)], 0.008, 8)  # fmt: skip
    spokes = [straight((0, 0.09, 0.012), (0.17 * np.cos(a), 0.09 + 0.17 * np.sin(a), 0.012), 0.005,
                       8) for a in (-np.pi / 2 - 0.53, -np.pi / 2 + 0.53)]  # fmt: skip
    cross = straight((-0.05, 0.0, 0.012), (0.05, 0.0, 0.012), 0.004, 8)
    arm = at_block(0.014, 0.19, 0.006, 0.005, (0, -0.09, 0.018)).turn(2, 0.22).move(0, 0.09, 0)
    scope = straight((-0.06, 0.045, 0.035), (0.06, 0.03, 0.035), 0.012, 14)
    stand = [disc(0.006, 0.03, (x, 0.036, 0.005), sides=10) for x in (-0.02, 0.02)]
    mirrors = [
        at_box(0.03, 0.004, 0.03, (0, 0.09, 0.02)),
        at_box(0.024, 0.004, 0.026, (0.05, 0.04, 0.02)).turn(2, 0.1),
    ]
    feet = [disc(0.006, 0.012, (x, y, 0)) for x, y in ((-0.08, -0.05), (0.08, -0.05), (0, 0.09))]
    return [(curve, tile), *((s, tile) for s in spokes), (cross, tile), (arm, tile),
            (join(feet), tile), (scope, SEXTANT_BLACK), (join(stand), tile),
            (join(mirrors), surfaces.plain((206, 222, 230)))]  # fmt: skip


@category("anemometer", size=(0.16, 0.16, 0.2), mass=0.3, material="plastic", assembled=True,
          aliases=("wind meter", "wind gauge", "wind speed meter"), themes=("office",),
          roles=("tall",), colors=("black",))  # fmt: skip
@from_pieces()
def anemometer(look: Look) -> Pieces:
    """An anemometer: three cups on a rotor above a post with a base."""
    foot, post = disc(0.05, 0.014), standing((0.008, 0.014), (0.007, 0.17), sides=12)
    arms, bowls = [], []
    for a in np.arange(3) * 2.0944 + 0.4:
        arms.append(straight((0, 0, 0.178), (0.06 * np.cos(a), 0.06 * np.sin(a), 0.178), 0.003, 6))
        cup = lathe(
            [(0, 0), (0.014, 0.003), (0.022, 0.016), (0.02, 0.016), (0.012, 0.006), (0, 0.004)], 18
        ).turn(0, np.pi / 2)
        bowls.append(cup.turn(2, a).move(0.07 * np.cos(a), 0.07 * np.sin(a), 0.178))
    hub = disc(0.013, 0.018, (0, 0, 0.17))
    return [(foot, dye(look, "charcoal", "white", "black")), (post, shine(look)),
            (hub, SEXTANT_BLACK), (join(arms), shine(look)), *((b, plastic(look, "black", "red",
                                                                           "white"))
                                                               for b in bowls)]  # fmt: skip


@category("rain_gauge", size=(0.084, 0.084, 0.182), mass=0.15, material="plastic",
          aliases=("rain meter",), themes=("office",), roles=("tall",),
          colors=("green",))  # fmt: skip
@from_pieces()
def rain_gauge(look: Look) -> Pieces:
    """A rain gauge: a marked clear tube with some water and a funnel rim."""
    tubes = surfaces.stack(
        (surfaces.plain((120, 178, 220)), 3),
        (surfaces.grid((90, 100, 110), (222, 232, 236), 12, 0), 7),
    )
    body = standing((0.024, 0.006), (0.03, 0.16))
    rim = lathe(
        [(0.026, 0), (0.042, 0.025), (0.042, 0.032), (0.038, 0.032), (0.024, 0.006)], 28, loop=True
    ).move(z=0.15)
    foot = disc(0.042, 0.008)
    return [(foot, plastic(look, "green", "yellow", "black")), (body, tubes),
            (rim, plastic(look, "green", "yellow", "black"))]  # fmt: skip


VAN_DE_GRAAFF_GENERATOR_BLACK = surfaces.plain((34, 34, 37))


@category("newton_meter", size=(0.239, 0.0343, 0.0272), mass=0.06, material="plastic",
          aliases=("force meter", "spring balance", "spring scale", "luggage scale", "dynamometer"),
          themes=("office",), colors=("red",))  # fmt: skip
@from_pieces(foot=0.06, bodies=3)
def newton_meter(look: Look) -> Pieces:
    """A spring balance lying flat: a clear tube with a scale, a ring and a hook."""
    z = 0.013
    scale = surfaces.grid((60, 60, 66), (232, 238, 240), 0, 20)
    body = spindle((-0.09, 0.0125), (0.07, 0.0125), z=z)
    caps = [spindle((x, 0.0134), (x + 0.014, 0.0134), z=z + 0.0004) for x in (-0.095, 0.065)]
    ring = torus(0.012, 0.002, 22, 6).move(-0.108, 0, 0.0022)
    hook = tube([(*p, 0.006) for p in smooth([(0.078, 0), (0.1, 0), (0.112, 0.009), (0.104, 0.018),
                                              (0.094, 0.013)], 5)], 0.0018, 6)  # fmt: skip
    return [(body, scale), (caps[0], plastic(look, *PAINTS)), (caps[1], plastic(look, *PAINTS)),
            (ring, shine(look)), (hook, shine(look))]  # fmt: skip


@category("van_de_graaff_generator", size=(0.16, 0.16, 0.38), mass=2.5, material="plastic",
          aliases=("van de graaff", "static generator", "tesla coil", "wimshurst machine",
          "plasma ball"), themes=("office",), roles=("tall",), colors=("navy",))  # fmt: skip
@from_pieces()
def van_de_graaff_generator(look: Look) -> Pieces:
    """A Van de Graaff generator: a shiny dome on a pale column above a box with a black knob."""
    dome = ball(0.16, 0.16, 0.14, (0, 0, 0.31), 28)
    column = standing((0.026, 0.06), (0.026, 0.25))
    base = at_block(0.14, 0.12, 0.06, 0.012)
    knob = disc(0.012, 0.012).turn(0, np.pi / 2).move(0.04, -0.058, 0.03)
    belt = at_box(0.03, 0.054, 0.19, (0, 0, 0.06))
    return [(base, plastic(look, "navy", "black", "red", "gray")),
            (column, surfaces.plain((206, 222, 226))), (dome, shine(look)),
            (belt, dye(look, "charcoal", "orange")),
            (knob, VAN_DE_GRAAFF_GENERATOR_BLACK)]  # fmt: skip


@category("radiometer", size=(0.082, 0.082, 0.135), mass=0.1, material="glass",
          aliases=("light mill", "crookes radiometer", "solar radiometer"), themes=("office",),
          colors=("clear",))  # fmt: skip
@vary(0.08)
@from_pieces()
def radiometer(look: Look) -> Pieces:
    """A light mill on a base: four vanes in a glass bulb, which is modelled as a wire cage."""
    foot = standing((0.035, 0), (0.034, 0.006), (0.012, 0.014), (0.01, 0.035), (0.016, 0.045))
    glass = surfaces.plain((206, 224, 232))
    hoops = [torus(0.04, 0.0012, 32, 5).turn(0, np.pi / 2).turn(2, a).move(z=0.085)
             for a in np.arange(5) * 0.6283]  # fmt: skip
    belt = torus(0.04, 0.0012, 32, 5).move(z=0.085)
    needle = straight((0, 0, 0.045), (0, 0, 0.09), 0.001, 6)
    vanes = [at_box(0.018, 0.0012, 0.018, (0.018, 0, 0.078)).turn(2, a + 0.3) for a in np.arange(4)
             * np.pi / 2]  # fmt: skip
    tip = standing((0.008, 0.124), (0.003, 0.135), sides=12)
    return [(foot, glass), (join([*hoops, belt]), glass), (join([needle]), shine(look)),
            (join(vanes), surfaces.stripes([(30, 30, 32), (240, 240, 238)], 1)),
            (tip, glass)]  # fmt: skip


@category("seismograph", size=(0.22, 0.13, 0.17), mass=1.5, material="wood",
          aliases=("seismometer", "earthquake recorder"), themes=("office",),
          colors=("brown",))  # fmt: skip
@from_pieces(bodies=5)
def seismograph(look: Look) -> Pieces:
    """A seismograph with a paper drum, a pen on a weighted arm and a base."""
    image = prints.canvas(160, 64, (246, 244, 232))
    x = np.linspace(0, 1, 120)
    wave = (
        0.5 + 0.36 * np.sin(260 * x) * np.exp(-(((x - 0.55) / 0.12) ** 2)) + 0.02 * np.sin(90 * x)
    )
    prints.stroke(image, list(zip(x, wave, strict=True)), 0.02, (170, 30, 34))
    base = at_block(0.22, 0.13, 0.022, 0.008)
    drum = spindle((-0.055, 0.035), (0.055, 0.035), sides=28, z=0.065).move(x=-0.03)
    ends = [spindle((x, 0.038), (x + 0.004, 0.038), z=0.065) for x in (-0.089, 0.025)]
    posts = [at_box(0.012, 0.03, 0.065, (x, 0, 0.02)) for x in (-0.1, 0.04)]
    tower = at_box(0.02, 0.02, 0.15, (0.09, 0.03, 0.02))
    arm = straight((0.09, 0.03, 0.12), (-0.02, -0.01, 0.101), 0.0026, 8)
    weight = spindle((0.03, 0.016), (0.06, 0.016), z=0.11).move(y=0.015)
    return [(base, wood(look, "brown", "wooden", "black")), (drum, image),
            (join(posts), shine(look, "brass")), (tower, shine(look, "brass")),
            (weight, shine(look, "brass")), (join(ends), shine(look, "brass")),
            (arm, shine(look))]  # fmt: skip


@category("trundle_wheel", size=(0.48, 0.24, 0.04), mass=0.7, material="plastic", assembled=True,
          aliases=("measuring wheel", "odometer wheel", "surveyor wheel"), themes=("office",),
          colors=("yellow",))  # fmt: skip
@from_pieces()
def trundle_wheel(look: Look) -> Pieces:
    """A measuring wheel lying flat: a spoked wheel, a long stick to the right and a black grip."""
    wheel = torus(0.11, 0.008, 40, 8).move(z=0.008)
    spokes = [straight((0.11 * np.cos(a), 0.11 * np.sin(a), 0.008),
                       (-0.11 * np.cos(a), -0.11 * np.sin(a), 0.008), 0.004, 6)
              for a in np.arange(3) * 1.0472]  # fmt: skip
    hub, stick = (disc(0.02, 0.024), rod([(0, 0, 0.03), (0.12, 0.03, 0.03), (0.34, 0.08, 0.012)],
                                         0.009, 10))  # fmt: skip
    grip = straight((0.3, 0.07, 0.016), (0.37, 0.087, 0.013), 0.0125, 10)
    return [(wheel, plastic(look, "yellow", "red", "orange")),
            (join(spokes), VAN_DE_GRAAFF_GENERATOR_BLACK), (hub, VAN_DE_GRAAFF_GENERATOR_BLACK),
            (stick, plastic(look, "yellow", "red", "orange")),
            (grip, VAN_DE_GRAAFF_GENERATOR_BLACK)]  # fmt: skip


@category("pantograph", size=(0.27, 0.17, 0.018), mass=0.12, material="wood",
          aliases=("drawing pantograph",), themes=("office",), colors=("wooden",))  # fmt: skip
@from_pieces()
def pantograph(look: Look) -> Pieces:
    """A pantograph lying flat: two long and two short wooden bars joined by metal pins."""
    tile = wood(look, "wooden", "tan", "beige")
    a, b, c, d, e = (-0.14, -0.06), (0.0, 0.09), (0.12, -0.06), (-0.07, 0.015), (0.06, 0.015)
    bars = [straight((*p, 0.006), (*q, 0.006), 0.006, 4) for p,
            q in ((a, b), (b, c), (d, (-0.01, -0.06)), (e, (-0.01, -0.06)))]  # fmt: skip
    pins = [disc(0.006, 0.018, (*p, 0), sides=12) for p in (a, b, c, d, e, (-0.01, -0.06))]
    return [*((s, tile) for s in bars), (join(pins), shine(look, "brass", "silver"))]


@category("slide_rule", size=(0.3, 0.042, 0.0098), mass=0.08, material="wood",
          aliases=("sliding ruler", "calculating ruler"), themes=("office",),
          colors=("cream",))  # fmt: skip
@vary(0.08)
@from_pieces(bodies=4)
def slide_rule(look: Look) -> Pieces:
    """A slide rule: a body with scales, a slightly extended slide and a cursor."""
    scale = prints.rule(25, (246, 242, 226), (40, 40, 46))
    body = [at_box(0.28, 0.013, 0.007, (0, s * 0.0125, 0)) for s in (-1, 1)]
    out = look.between(0.01, 0.04)
    slide = at_box(0.28, 0.0118, 0.0065, (out, 0, 0))
    cursor = at_box(0.026, 0.042, 0.003, (-0.03, 0, 0.0065))
    line = at_box(0.0008, 0.04, 0.0006, (-0.03, 0, 0.0092))
    return [(body[0], scale), (body[1], scale[::-1]), (slide, scale),
            (cursor, surfaces.plain((206, 226, 232))),
            (line, surfaces.plain((200, 40, 40)))]  # fmt: skip


CATEGORIES = (
    Category("barometer", from_pieces(bodies=2)(_meter("RAIN  FAIR")), size=(0.13, 0.06, 0.131),
             mass=0.6, material="wood",
             aliases=("aneroid barometer", "weather station", "brass barometer"),
             themes=("office",), colors=("brass",)),
    Category("hygrometer", from_pieces(bodies=2)(_meter("HUMIDITY")), size=(0.13, 0.06, 0.131),
             mass=0.5, material="wood", aliases=("humidity meter", "humidity gauge",
             "analog thermometer", "dial thermometer", "thermo hygrometer"), themes=("office",),
             colors=("brass",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
