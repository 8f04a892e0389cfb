"""Objects of the ``lab`` theme: teeth and dental casts."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import plastic, shine
from ...kit.primitives import at_block, at_box, ball, disc, plate, rod
from ...kit.shapes import Category, Drawing, Pieces, category, from_pieces
from ...kit.solids import join, torus, tube
from ...kit.surfaces import Look, tint_color

WHITE = surfaces.plain((244, 243, 240))


def _tooth(gold: bool, long: float) -> Drawing:
    """Return the drawing function of a molar with cusps on its crown, standing on its roots."""

    def draw(look: Look) -> Pieces:
        color = look.color(*(("gold",) if gold else ("white", "ivory", "cream")))
        tile = (look.surface(color, "metal") if gold else surfaces.gradient(tint_color(color, 0.86),
                                                                            tint_color(color, 1.2),
                                                                            look.rng))  # fmt: skip
        k = long / 0.02
        crown = at_block(0.0105, 0.0105, 0.008, 0.004, (0, 0, 0.0105))
        cusps = [ball(0.0058, 0.0058, 0.005, (x * 0.0026, y * 0.0026, 0.018), 10) for x in (-1, 1)
                 for y in (-1, 1)]  # fmt: skip
        roots = [rod([(x * 0.0026, y * 0.0022, 0.012), (x * 0.0034, y * 0.003, 0.006),
                      (x * 0.0028, y * 0.0026, 0.0)], [0.0034, 0.0026, 0.0016], 10) for x in (-1, 1)
                 for y in (-1, 1)]  # fmt: skip
        return [(s.scale(k, k, k), tile) for s in (crown, join(roots), join(cusps))]

    return draw


def _denture(full: bool) -> Drawing:
    """Return the drawing function of a single denture, or of an open pair if ``full`` is set."""

    def draw(look: Look) -> Pieces:
        pieces: Pieces = []
        gum = plastic(look, "pink", "coral")
        for level in range(2 if full else 1):
            a = np.linspace(0.15, np.pi - 0.15, 18)
            way = np.column_stack([0.026 * np.cos(a), 0.032 * np.sin(a) - 0.01, 0 * a + 0.007])
            base = tube(way, 0.0068, 10)
            teeth = [
                at_box(0.0058, 0.0052, 0.009, (0.026 * np.cos(t), 0.032 * np.sin(t) - 0.01, 0.01))
                for t in np.linspace(0.2, np.pi - 0.2, 14)
            ]
            palate = disc(0.022, 0.004, (0, -0.002, 0.0))
            group = [(base, gum), (join(teeth), WHITE), (palate, gum)]
            if level:
                group = [(s.turn(1, np.pi).turn(0, -0.35).move(z=0.047), t) for s, t in group]
            pieces += group
        return [(s.turn(2, np.pi), t) for s, t in pieces]

    return draw


def _retainer(wire: bool) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A horseshoe-shaped mouth guard, or a dental plate with a wire."""
        a = np.linspace(0.1, np.pi - 0.1, 26)
        color = look.color("sky", "pink", "clear", "purple", "green")
        if not wire:
            inner, outer = (
                np.column_stack([r * np.cos(a), 1.2 * r * np.sin(a)]) for r in (0.021, 0.034)
            )
            floor = plate(np.concatenate([outer, inner[::-1]]) - [0, 0.018], 0.003)
            rims = [tube(np.column_stack([r * np.cos(a), 1.2 * r * np.sin(a) - 0.018, 0 * a
                                          + 0.0065]), 0.0052, 6, squash=1.2)
                    for r in (0.0335, 0.0215)]  # fmt: skip
            tile = surfaces.plain(color)
            return [(floor, tile), (rims[0], tile), (rims[1], tile)]
        body = ball(0.05, 0.046, 0.02, (0, -0.004, 0.004), 20)
        wires = tube(
            np.column_stack([0.027 * np.cos(a), 0.03 * np.sin(a) - 0.006, 0 * a + 0.008]), 0.0009, 6
        )
        loops = [torus(0.005, 0.0008, 14, 5).move(s * 0.027, -0.004, 0.008) for s in (-1, 1)]
        return [(body, surfaces.spots(look.rng, color, tint_color(color, 1.5), 0.1)),
                (join([wires, *loops]), shine(look))]  # fmt: skip

    return draw


@category("dental_mould", size=(0.0739, 0.046, 0.0318), mass=0.08, material="ceramic",
          aliases=("dental mold", "dental cast", "plaster teeth", "dental impression", "jaw cast"),
          themes=("lab",), colors=("white",))  # fmt: skip
@from_pieces()
def dental_mould(look: Look) -> Pieces:
    """A plaster cast of a jaw on a base."""
    color = look.color("white", "cream", "yellow", "beige")
    tile = surfaces.speckles(look.rng, color, 5)
    a = np.linspace(0, np.pi, 20)
    base = plate(
        np.concatenate([np.column_stack([0.036 * np.cos(a), 0.045 * np.sin(a)])]) - [0, 0.02], 0.018
    )
    ridge = tube(np.column_stack([0.027 * np.cos(a[1:-1]), 0.034 * np.sin(a[1:-1]) - 0.016, 0
                                  * a[1:-1] + 0.018]), 0.007, 8)  # fmt: skip
    teeth = [
        at_block(0.0062, 0.006, 0.01, 0.002, (0.027 * np.cos(t), 0.034 * np.sin(t) - 0.016, 0.021))
        for t in np.linspace(0.2, np.pi - 0.2, 14)
    ]
    return [(base, tile), (ridge, tile), (join(teeth), surfaces.plain(tint_color(color, 1.2)))]


CATEGORIES = (
    Category("tooth", from_pieces()(_tooth(False, 0.02)), size=(0.0117, 0.0107, 0.0198), mass=0.002,
             material="plastic", aliases=("molar", "human tooth", "milk tooth", "baby tooth",
             "false tooth", "wisdom tooth", "canine tooth", "dental crown"), themes=("lab",),
             colors=("white",)),
    Category("gold_tooth", from_pieces()(_tooth(True, 0.02)), size=(0.0116, 0.0105, 0.0195),
             mass=0.006, material="metal", aliases=("golden tooth",), themes=("lab",),
             colors=("gold",)),
    Category("denture", from_pieces(bodies=(0, 2))(_denture(False)), size=(0.066, 0.05, 0.019),
             mass=0.02, material="plastic",
             aliases=("dental plate", "upper denture", "dental bridge"), themes=("lab",),
             colors=("pink",)),
    Category("false_teeth", from_pieces()(_denture(True)), size=(0.0628, 0.051, 0.0534), mass=0.04,
             material="plastic", aliases=("set of false teeth", "dentures", "jaw model",
             "set of dentures", "articulator", "chattering teeth", "wind up teeth", "model teeth",
             "teeth model"), themes=("lab",), colors=("pink",)),
    Category("mouth_guard", from_pieces(bodies=1)(_retainer(False)), size=(0.0788, 0.0444, 0.0122),
             mass=0.015, material="rubber", aliases=("mouthguard", "gum shield", "aligner",
             "dental aligner", "bite guard", "night guard", "clear aligner"), themes=("lab",),
             colors=("sky",)),
    Category("retainer", from_pieces(bodies=1)(_retainer(True)), size=(0.066, 0.05, 0.014),
             mass=0.012, material="plastic", aliases=("dental retainer", "dental brace",
             "braces retainer", "orthodontic retainer", "orthodontic brace"), themes=("lab",),
             colors=("sky", "pink")),
)  # fmt: skip
"""Objects that share their drawing functions."""
