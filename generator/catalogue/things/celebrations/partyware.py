"""Blowers, horns, boards, props and pumps for parties."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part
from ...build.outlines import smooth
from ...build.recipes import Pieces, straight
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, prism, torus, tube
from ...build.variants import at_rest, keep_still
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def blower(look: Look) -> Shape:
    """A party blower: a mouthpiece and a curled paper tongue, lying."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "blue", "gold", "pink", "green", "purple")
    mouth = cylinder(0.0055, 0.04, 14, top=0.009).turn(1, np.pi / 2).move(-0.08, 0, 0.013)
    t = np.linspace(0, 1, 60)
    turn = 2.6 * 2 * np.pi * t
    away = 0.026 * (1 - 0.72 * t)
    coil = np.column_stack([0.05 + away * np.sin(turn), 0 * t, 0.03 - away * np.cos(turn)])
    path = np.concatenate([[(-0.042, 0, 0.013), (-0.01, 0, 0.008), (0.02, 0, 0.005)], coil])
    tongue = tube(path, 0.011, 8, squash=0.17)
    wide = textures.stripes([color, (250, 248, 240), tint_color(color, 0.7), (250, 214, 80)], 9)
    fringe = [tube([(-0.044, 0, 0.013), (-0.058, 0.017 * np.cos(a), 0.013 + 0.012 * np.sin(a))],
                   [0.0016, 0.0008], 5) for a in np.arange(12) * 0.524]  # fmt: skip
    return settle([(mouth, textures.plain((246, 246, 240))), (tongue, wide),
                   (join(fringe), textures.plain(tint_color(color, 1.3)))], 0.01,
                  hulls=[[0, 2], [1]]).scale(k)  # fmt: skip


def horn(look: Look) -> Shape:
    """A paper party horn with a fringe at its wide end, lying."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "gold", "blue", "pink", "silver", "green")
    cone = cylinder(0.006, 0.17, 24, top=0.031).turn(1, np.pi / 2).move(x=-0.09)
    mouth = cylinder(0.0045, 0.022, 12).turn(1, np.pi / 2).move(x=-0.11)
    dark = cylinder(0.028, 0.001, 22).turn(1, np.pi / 2).move(x=0.0796)
    fringe = [tube([(0.075, 0.031 * np.cos(a), 0.031 * np.sin(a)), (0.1, 0.036 * np.cos(a + 0.1),
                   0.036 * np.sin(a + 0.1))], [0.003, 0.0015], 4)
              for a in 2 * np.pi * np.arange(22) / 22]  # fmt: skip
    bands = textures.stripes([color, (250, 246, 236), color, (246, 206, 80)], 5)
    return settle(
        [
            (cone, bands),
            (join([mouth]), textures.plain((240, 240, 236))),
            (dark, textures.plain(tint_color(color, 0.4))),
            (join(fringe), textures.plain(tint_color(color, 1.2))),
        ],
        0.06,
    ).scale(k)


def board(look: Look) -> Shape:
    """A round board under a cake, covered in silver or gold foil."""
    r = look.between(0.11, 0.14)
    color = look.color("silver", "gold", "white", "silver")
    foil = textures.brushed_metal(look.rng, color)
    net = textures.grid(tint_color(color, 0.86), tint_color(color, 1.15), 16, 16, width=1)
    plate = cylinder(r, 0.01, 44, bevel=0.001)
    return shape([(plate, foil), (cylinder(0.97 * r, 0.0005, 44).move(z=0.0097), net)],
                 [cylinder_part(r, 0.01)])  # fmt: skip


def prop(look: Look) -> Shape:
    """A photo prop on a stick: a moustache, lips, glasses or a top hat of card."""
    k = look.between(0.9, 1.1)
    kind = look.pick(["moustache", "lips", "hat", "moustache"])
    color = look.color("black", "red", "black", "purple")
    if kind == "moustache":
        half = smooth([(0, 0.004), (0.02, 0.014), (0.045, 0.006), (0.06, 0.018), (0.056, -0.006),
                       (0.03, -0.016), (0, -0.006)], 4)  # fmt: skip
    elif kind == "lips":
        half = smooth([(0, 0.012), (0.012, 0.018), (0.034, 0.006), (0.045, 0), (0.03, -0.012),
                       (0, -0.02)], 4)  # fmt: skip
    else:
        half = np.array([(0, 0.07), (0.03, 0.07), (0.027, 0.008), (0.05, 0.006), (0.05, -0.006),
                         (0, -0.006)], float)  # fmt: skip
    outline = np.concatenate([half[::-1], (half * [-1, 1])[1:-1]])
    card = prism(outline, 0.0042, 0.0066)
    stick = tube([(0, -0.004, 0.0024), (0, -0.17, 0.0024)], 0.0024, 8)
    pieces: Pieces = [(card, textures.speckles(look.rng, color, 4)),
                      (stick, textures.wood(look.rng, (222, 188, 136)))]  # fmt: skip
    if kind == "hat":
        pieces.append((box(0.056, 0.012, 0.0005).move(0, 0.018, 0.0064), textures.plain(
            (206, 40, 50))))  # fmt: skip
    return settle(pieces, 0.02, hulls=[[0], [1]]).scale(k)


def pump(look: Look) -> Shape:
    """A balloon pump lying: a barrel with a nozzle and its T-shaped handle drawn out."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "red", "yellow", "green", "pink")
    barrel = cylinder(0.021, 0.15, 26, bevel=0.002).turn(1, np.pi / 2).move(x=-0.09)
    nozzle = cylinder(0.012, 0.035, 18, top=0.004).turn(1, -np.pi / 2).move(x=-0.088)
    shaft = cylinder(0.006, 0.06, 12).turn(1, np.pi / 2).move(x=0.058)
    bar = cylinder(0.0085, 0.062, 16).turn(0, np.pi / 2).move(0.12, 0.031, 0)
    ring = torus(0.021, 0.0028, 24, 8).turn(1, np.pi / 2)
    return settle([(join([barrel]), textures.speckles(look.rng, color, 4)),
                   (join([nozzle, bar, ring.move(x=0.056), ring.move(x=-0.086)]),
                    textures.plain(tint_color(color, 0.6))),
                   (shaft, textures.plain((236, 236, 232)))], 0.06,
                  hulls=[[0], [1, 2]]).scale(k)  # fmt: skip


def stick(look: Look) -> Shape:
    """A sparkler lying, burning at its tip."""
    k = look.between(0.9, 1.1)
    color = look.color("gray", "silver", "gold")
    wire = straight((-0.11, 0, 0.0025), (0.0, 0, 0.0025), 0.0011, 6)
    coat = straight((-0.005, 0, 0.0025), (0.11, 0, 0.0025), 0.0025, 7)
    sparks = [tube([(0.11, 0, 0.004), (0.11 + d * np.cos(a) * np.cos(b), d * np.sin(a) * np.cos(b),
                   0.004 + d * abs(np.sin(b)))], [0.0011, 0.0004], 4)
              for a, b, d in ((2.4 * n, 0.35 + 0.9 * ((n * 5) % 7) / 7, 0.016 + 0.012 * (n % 3) / 3)
                              for n in range(26))]  # fmt: skip
    return settle([(wire, textures.plain((180, 182, 186))),
                   (coat, textures.speckles(look.rng, tint_color(color, 0.8), 14)),
                   (join(sparks), textures.plain((255, 226, 120)))], 0.02,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("party_blower", blower, (0.162, 0.0363, 0.0554), 0.006, ("party blowout", "blowout",
             "party whistle", "noisemaker", "party noisemaker"), _L, (), ("red",), state=_D),
    at_rest(Category("party_horn", horn, (0.213, 0.0754, 0.0711), 0.015, ("paper horn", "toy horn",
             "party trumpet"), _L, (), ("red",), state=_D)),
    Category("cake_board", board, (0.252, 0.252, 0.0102), 0.15, ("cake drum", "cake base",
             "round cake board", "silver cake board", "cake circle"), ("kitchen",), ("flat",
             "support", "round"), ("silver",), state=_D),
    Category("photo_prop", prop, (0.114, 0.203, 0.00651), 0.006, ("photo booth prop",
             "moustache on a stick", "party prop", "fake moustache", "selfie prop",
             "fake moustaches"), _L, (), ("black",), state=_D),
    Category("balloon_pump", pump, (0.253, 0.0624, 0.0451), 0.12, ("hand pump", "inflator",
             "ball pump"), _L, (), ("blue",), state=_D),
    Category("sparkler", keep_still(stick), (0.235, 0.0364, 0.025), 0.006, ("lit sparkler",
             "party sparkler",
             "cake sparkler"), _L, (), ("gray",), state=_D),
)  # fmt: skip
"""The module's categories."""
