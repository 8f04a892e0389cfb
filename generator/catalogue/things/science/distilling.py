"""Glass for distilling and drying, and things to study nature with."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    dye,
    plastic,
    spindle,
    standing,
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


GLASS = textures.plain((210, 228, 232))


WHITE = textures.plain((242, 242, 240))


def _torso(look: Look) -> Pieces:
    """A torso with coloured organs in its open front."""
    skin = dye(look, "beige", "tan")
    foot = at_block(0.11, 0.09, 0.014, 0.02)
    body = standing(
        (0.05, 0.014),
        (0.052, 0.05),
        (0.042, 0.1),
        (0.06, 0.16),
        (0.058, 0.185),
        (0.018, 0.205),
        (0.016, 0.22),
    ).scale(1, 0.66, 1)
    head = ball(0.05, 0.056, 0.066, (0, 0, 0.25), 18)
    arms = [ball(0.04, 0.036, 0.05, (s * 0.064, 0, 0.17), 12) for s in (-1, 1)]
    cavity = ball(0.076, 0.02, 0.15, (0, -0.026, 0.11), 18)
    lungs = [ball(0.03, 0.018, 0.055, (s * 0.019, -0.034, 0.15), 14) for s in (-1, 1)]
    heart = ball(0.022, 0.016, 0.026, (0.004, -0.042, 0.143), 12)
    liver = ball(0.05, 0.018, 0.024, (-0.008, -0.036, 0.112), 14)
    gut = tube(
        [(0.022 * np.sin(k * 1.6), -0.038, 0.095 - 0.0036 * k) for k in range(16)], 0.0055, 8
    )
    return [
        (foot, BLACK),
        (body, skin),
        (head, skin),
        (join(arms), skin),
        (cavity, dye(look, "maroon")),
        (join(lungs), textures.plain((230, 140, 150))),
        (heart, textures.plain((196, 36, 44))),
        (liver, textures.plain((130, 56, 44))),
        (gut, textures.plain((226, 168, 110))),
    ]


def _press(look: Look) -> Pieces:
    tile = wood(look, "wooden", "beige")
    boards = [at_box(0.22, 0.16, 0.01, (0, 0, z)) for z in (0, 0.045)]
    paper = at_box(0.21, 0.15, 0.036, (0, 0, 0.0095))
    slats = [at_box(0.014, 0.16, 0.006, (x, 0, 0.0545)) for x in np.linspace(-0.09, 0.09, 6)]
    straps = [at_box(0.02, 0.164, 0.066, (x, 0, 0)) for x in (-0.05, 0.05)]
    return [
        (boards[0], tile),
        (paper, prints.pages(look.rng)),
        (boards[1], tile),
        (join(slats), tile),
        (straps[0], s := dye(look, "brown", "black", "green")),
        (straps[1], s),
    ]


def _ants(look: Look) -> Pieces:
    """A flat glass nest with tunnels in sand."""
    image = textures.spots(look.rng, (206, 168, 112), (170, 130, 80), 0.2).copy()
    image = textures.fit(image, 128, 176).copy()
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
    return [
        (foot, frame),
        (body, frame),
        (top, frame),
        (at_box(0.175, 0.002, 0.14, (0, -0.0155, 0.023)), image),
    ]


def _condenser(look: Look) -> Pieces:
    """A glass condenser lying: a jacket round a tube, two side pipes."""
    z = 0.02
    jacket = spindle((-0.1, 0.008), (-0.09, 0.018), (0.09, 0.018), (0.1, 0.008), z=z)
    inner = spindle((-0.16, 0.007), (0.16, 0.007), z=z)
    bell = spindle((-0.19, 0.012), (-0.165, 0.011), (-0.155, 0.007), z=z)
    pipes = [
        rod([(x, 0, z), (x, s * 0.03, z), (x, s * 0.05, z)], 0.005, 8)
        for x, s in ((-0.07, 1), (0.07, -1))
    ]
    blue = tint_color(look.color("clear", "sky"), 1.1)
    return [
        (jacket, textures.stripes([blue, tint_color(blue, 1.4), blue], 3)),
        (inner, GLASS),
        (bell, GLASS),
        (join(pipes[:1]), GLASS),
        (join(pipes[1:]), GLASS),
    ]


def _column(look: Look) -> Pieces:
    """A tower of glass bulbs with taps on a stand: Kipp's apparatus."""
    foot = standing((0.05, 0), (0.055, 0.01), (0.06, 0.05), (0.03, 0.085))
    middle = ball(0.09, 0.09, 0.08, (0, 0, 0.12), 22)
    upper = ball(0.1, 0.1, 0.085, (0, 0, 0.205), 22)
    neck = standing((0.012, 0.24), (0.018, 0.27))
    tap = [
        straight((0.04, 0, 0.12), (0.08, 0, 0.12), 0.006, 8),
        at_block(0.008, 0.03, 0.012, 0.003, (0.065, 0, 0.118)),
    ]
    color = look.color("clear", "sky", "mint")
    return [
        (foot, textures.gradient(color, (226, 236, 238), look.rng)),
        (middle, GLASS),
        (upper, textures.gradient(color, (226, 236, 238), look.rng)),
        (neck, GLASS),
        (join(tap), dye(look, "brown", "gray")),
    ]


def _dry(look: Look) -> Pieces:
    """A desiccator: a heavy glass bowl with a domed lid and a knob."""
    low = standing(
        (0.05, 0), (0.052, 0.01), (0.075, 0.05), (0.08, 0.085), (0.09, 0.09), (0.09, 0.098)
    )
    lid = standing(
        (0.09, 0.099),
        (0.09, 0.106),
        (0.075, 0.125),
        (0.04, 0.15),
        (0.012, 0.156),
        (0.018, 0.172),
        (0.012, 0.182),
    )
    beads = torus(0.06, 0.002, 40, 5).move(z=0.085)
    color = look.color("clear", "sky", "amber")
    return [
        (low, textures.gradient(tint_color(color, 0.85), tint_color(color, 1.2), look.rng)),
        (lid, textures.gradient(tint_color(color, 1.2), tint_color(color, 1.5), look.rng)),
        (beads, WHITE),
    ]


def _pellet(look: Look) -> Pieces:
    color = look.color("gray", "charcoal", "brown")
    body = ball(0.055, 0.028, 0.026, (0, 0, 0.011), 18)
    bits = [
        rod([(x, y, 0.019), (x + 0.01, y + 0.006, 0.0235)], 0.0009, 5)
        for x, y in ((-0.016, -0.004), (-0.004, 0.003), (0.008, -0.006), (0.012, 0.002))
    ]
    return [
        (body, textures.scratches(look.rng, color, tint_color(color, 1.4), 160)),
        (join(bits), WHITE),
    ]


def _frame(look: Look) -> Pieces:
    """A square frame with a grid of strings, lying."""
    tile = plastic(look, "white", "red", "wooden", "yellow")
    s = 0.24
    sides = [at_box(s, 0.01, 0.01, (0, t * s / 2, 0)) for t in (-1, 1)] + [
        at_box(0.01, s, 0.01, (t * s / 2, 0, 0)) for t in (-1, 1)
    ]
    lines = [
        straight((-s / 2, y, 0.006), (s / 2, y, 0.006), 0.001, 5) for y in (-0.06, 0, 0.06)
    ] + [straight((x, -s / 2, 0.006), (x, s / 2, 0.006), 0.001, 5) for x in (-0.06, 0, 0.06)]
    return [*((p, tile) for p in sides), (join(lines), textures.plain((60, 60, 64)))]


def _trough(look: Look) -> Pieces:
    tile = plastic(look, "white", "clear")
    sides = [at_box(0.13, 0.004, 0.025, (0, s * 0.02, 0)) for s in (-1, 1)] + [
        at_box(0.004, 0.044, 0.025, (s * 0.063, 0, 0)) for s in (-1, 1)
    ]
    floor = at_box(0.13, 0.044, 0.004)
    return [(floor, tile), *((s, tile) for s in sides)]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    _row("anatomical_model", _torso, (0.165, 0.09, 0.283), 0.9, ("anatomy model", "torso model",
             "human torso", "anatomical torso", "human body model"), bodies=4, roles=("tall",)),
    _row("plant_press", _press, (0.22, 0.164, 0.066), 0.9, ("flower press", "herbarium press"),
             ("wooden",), roles=("support", "big")),
    _row("ant_farm", _ants, (0.2, 0.08, 0.181), 0.7, ("formicarium", "ant nest", "insect house"),
             ("green",), bodies=3, roles=("tall",)),
    _row("condenser", _condenser, (0.336, 0.096, 0.0346), 0.2, ("liebig condenser",
             "glass condenser",
             "fractionating column", "distillation column", "cooling condenser"), ("clear",),
             0.08, 3, ("big",)),
    _row("kipps_apparatus", _column, (0.138, 0.118, 0.266), 0.9, ("kipp apparatus", "gas generator",
             "distillation apparatus", "alchemist apparatus"), ("clear",), roles=("tall",)),
    _row("desiccator", _dry, (0.18, 0.18, 0.182), 1.5, ("glass desiccator", "vacuum desiccator",
             "bell jar"), ("clear",), bodies=2),
    _row("owl_pellet", _pellet, (0.055, 0.028, 0.024), 0.01, ("pellet",), ("gray",), 0.08, 1),
    _row("quadrat", _frame, (0.25, 0.25, 0.01), 0.15, ("sampling frame", "grid frame"),
             roles=("flat", "big")),
    _row("reagent_reservoir", _trough, (0.13, 0.044, 0.025), 0.03, ("pipette trough",
             "reagent trough", "reservoir"), roles=("container",)),
)  # fmt: skip
"""The module's categories."""
