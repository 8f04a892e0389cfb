"""Objects of the ``office`` theme: laundry supplies."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, plastic, shine, wood
from ...kit.primitives import at_block, at_box, ball, disc, pad, plate, rod, spindle, straight
from ...kit.shapes import Category, Drawing, Pieces, category, from_pieces
from ...kit.solids import join, torus
from ...kit.surfaces import Look


@category("laundry_pod", size=(0.0459, 0.046, 0.0209), mass=0.025, material="plastic",
          aliases=("detergent pod", "washing pod", "laundry capsule", "dishwasher tablet",
          "washing capsule", "washing tablet", "detergent capsule", "dishwasher pod"),
          themes=("office",), colors=("blue",))  # fmt: skip
@from_pieces(bodies=(0, 1, 2, 3))
def laundry_pod(look: Look) -> Pieces:
    """A soft laundry pod in two or three colours."""
    tones = [look.color("blue", "purple", "green", "orange"), look.own_color("white", "sky",
                                                                             "green"),
             look.own_color("orange", "blue", "purple")]  # fmt: skip
    base = pad(0.045, 0.042, 0.012, 0.01)
    lobes = [ball(0.028, 0.018, 0.02, (0.008 * (k - 1), 0.011 * (k - 1), 0.0105), 14).turn(2, 0.35)
             for k in range(3)]  # fmt: skip
    return [
        (base, surfaces.plain((224, 234, 242))),
        *((b, surfaces.plain(t)) for b, t in zip(lobes, tones, strict=True)),
    ]


def _ironing(wide: float, long: float) -> Drawing:
    """Return the drawing function of a low ironing board: a padded, pointed top on folding legs."""

    def draw(look: Look) -> Pieces:
        t = np.linspace(0, np.pi, 16)
        nose = np.column_stack(
            [0.5 * long - 0.45 * long + 0.45 * long * np.sin(t), -0.5 * wide * np.cos(t)]
        )
        outline = np.concatenate([[(-0.5 * long, 0.45 * wide), (-0.5 * long, -0.45 * wide)], nose])
        cover = surfaces.fabric(look.rng, look.color("sky", "beige", "gray", "mint", "pink"),
                                look.own_color("white", "cream"))  # fmt: skip
        top = plate(outline, 0.022, 0.1)
        legs = [straight((x, -0.4 * wide, 0.0065), (-0.6 * x, -0.3 * wide, 0.1), 0.006, 8)
                for x in (-0.3 * long, 0.3 * long)]  # fmt: skip
        legs += [straight((x, 0.4 * wide, 0.0065), (-0.6 * x, 0.3 * wide, 0.1), 0.006, 8)
                 for x in (-0.3 * long, 0.3 * long)]  # fmt: skip
        feet = [straight((x, -0.45 * wide, 0.006), (x, 0.45 * wide, 0.006), 0.0065, 8)
                for x in (-0.3 * long, 0.3 * long)]  # fmt: skip
        steel = shine(look, "silver", "gray")
        return [(top, cover), (feet[0], steel), (feet[1], steel), (join(legs[::2]), steel),
                (join(legs[1::2]), steel)]  # fmt: skip

    return draw


@category("washboard", size=(0.22, 0.42, 0.022), mass=0.9, material="wood", assembled=True,
          aliases=("wash board", "laundry board", "scrub board"), themes=("office",),
          roles=("flat", "big"), colors=("wooden",))  # fmt: skip
@from_pieces()
def washboard(look: Look) -> Pieces:
    """A washboard lying flat: a wooden frame around a ribbed metal sheet."""
    tile = wood(look, "wooden", "tan", "brown")
    sides = [at_box(0.018, 0.42, 0.022, (s * 0.1, 0, 0)) for s in (-1, 1)]
    bars = [at_box(0.2, 0.06, 0.018, (0, 0.14, 0.002)), at_box(0.2, 0.02, 0.018, (0, -0.13, 0.002))]
    sheet = at_box(0.185, 0.25, 0.008, (0, -0.002, 0.002))
    ribs = [spindle((-0.09, 0.004), (0.09, 0.004), z=0.0105, sides=8).move(y=-0.11 + 0.0125 * k)
            for k in range(18)]  # fmt: skip
    return [(sides[0], tile), (sides[1], tile), (bars[0], tile), (bars[1], tile),
            (sheet, s := shine(look, "silver", "gray")), (join(ribs), s)]  # fmt: skip


@category("washing_line_reel", size=(0.214, 0.113, 0.135), mass=0.5, material="plastic",
          assembled=True, aliases=("washing line", "clothes line reel", "clothesline",
          "retractable washing line", "hose reel", "washing line reel retractable"),
          themes=("office",), colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def washing_line_reel(look: Look) -> Pieces:
    """An upright round reel on a base, with its line and an end ring pulled out to the right."""
    tile = plastic(look, "white", "gray", "green", "blue")
    body = disc(0.07, 0.05).turn(0, np.pi / 2).move(0, 0.025, 0.07)
    base = at_block(0.07, 0.06, 0.012, 0.006)
    line = rod(
        [(0.06, 0, 0.04), (0.11, 0, 0.02), (0.15, 0.03, 0.003), (0.1, 0.07, 0.003)], 0.002, 6, 6
    )
    hook = torus(0.01, 0.002, 18, 6).move(0.09, 0.075, 0.0025)
    face = disc(0.04, 0.002).turn(0, np.pi / 2).move(0, -0.0255, 0.07)
    return [(body, tile), (base, tile), (line, surfaces.plain((230, 230, 226))),
            (hook, shine(look)), (face, dye(look, "gray", "navy"))]  # fmt: skip


@category("collar_stiffener", size=(0.066, 0.011, 0.001), mass=0.001, material="plastic",
          aliases=("collar stay", "collar bone", "shirt collar stiffener"), themes=("office",),
          roles=("flat",), colors=("white",))  # fmt: skip
@from_pieces()
def collar_stiffener(look: Look) -> Pieces:
    """A thin collar stiffener lying flat, square on the left and pointed on the right."""
    return [(plate([(-0.032, -0.0055), (0.024, -0.0055), (0.034, 0), (0.024, 0.0055),
                    (-0.032, 0.0055)], 0.001), plastic(look, "white", "clear",
                                                       "silver"))]  # fmt: skip


CATEGORIES = (
    Category("ironing_board", from_pieces()(_ironing(0.2, 0.5)), size=(0.5, 0.2, 0.122), mass=1.5,
             material="fabric", assembled=True,
             aliases=("tabletop ironing board", "mini ironing board", "small ironing board"),
             themes=("office",), roles=("big", "support"), colors=("sky",)),
    Category("sleeve_board", from_pieces()(_ironing(0.1, 0.45)), size=(0.45, 0.1, 0.122), mass=0.8,
             material="fabric", assembled=True, aliases=("sleeve ironing board",),
             themes=("office",), roles=("big",), colors=("sky",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
