"""Objects of the ``lab`` theme: watch parts."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, shine
from ...kit.primitives import at_block, disc, pad, straight
from ...kit.shapes import Pieces, category, from_pieces
from ...kit.solids import tube
from ...kit.surfaces import Look


@category("watch_link", size=(0.0182, 0.0216, 0.003), mass=0.003, material="metal",
          aliases=("bracelet link", "chain links piece"), themes=("lab",),
          colors=("silver",))  # fmt: skip
@from_pieces()
def watch_link(look: Look) -> Pieces:
    """A watch link: three rounded metal bars side by side, joined by a thin pin."""
    steel = shine(look, "silver", "gold")
    bars = [at_block(0.0055, 0.02, 0.003, 0.001, (-0.0058 + 0.0058 * k, 0.0016 * (k % 2), 0))
            for k in range(3)]  # fmt: skip
    return [(b, steel) for b in bars] + [
        (straight((-0.009, -0.007, 0.0015), (0.009, -0.007, 0.0015), 0.0007, 6), steel)
    ]


@category("mainspring", size=(0.0281, 0.027, 0.00264), mass=0.002, material="metal",
          aliases=("clock spring", "spiral spring", "hairspring", "torsion spring"),
          themes=("lab",), colors=("silver",))  # fmt: skip
@from_pieces()
def mainspring(look: Look) -> Pieces:
    """A mainspring: a thin metal ribbon, wound flat in five turns."""
    a = np.linspace(0, 2 * np.pi * 5, 150)
    r = 0.003 + 0.0022 * a / (2 * np.pi)
    spiral = tube(
        np.column_stack([r * np.cos(a), r * np.sin(a), 0 * a + 0.0015]), 0.0007, 5, squash=2.0
    )
    return [(spiral, surfaces.brushed_metal(look.rng, look.color("silver", "gray", "blue")))]


@category("watch_winder", size=(0.15, 0.175, 0.13), mass=0.9, material="device",
          aliases=("watch winding box", "watch display", "watch stand", "watch box"),
          themes=("lab",), colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def watch_winder(look: Look) -> Pieces:
    """A watch winder: a box with a round metal plate that holds a watch on a cushion."""
    shell = plastic(look, "black", "brown", "white", "maroon")
    body = at_block(0.15, 0.14, 0.13, 0.012)
    cup = disc(0.05, 0.012).turn(0, np.pi / 2).move(0, -0.066, 0.068)
    cushion = pad(0.05, 0.06, 0.03, 0.014).turn(0, np.pi / 2).move(0, -0.066, 0.068)
    face = disc(0.019, 0.008).turn(0, np.pi / 2).move(0, -0.094, 0.068)
    dial = disc(0.016, 0.001).turn(0, np.pi / 2).move(0, -0.1018, 0.068)
    return [
        (body, shell),
        (cup, shine(look)),
        (cushion, dye(look, "cream", "gray")),
        (face, shine(look, "gold", "silver")),
        (dial, prints.clock_face(look.rng, (244, 240, 230), (40, 40, 44))),
    ]
