"""Objects of the ``vanity`` theme: towels."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc
from ...kit.parts import box_part
from ...kit.primitives import pad, rod, side_view
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import box, cylinder, join
from ...kit.surfaces import Look, tint_color

SOFT = ("white", "sky", "pink", "mint", "lavender", "cream", "sage")


def _roll(look: Look, long: float, r: float, words: tuple[str, ...]) -> Shape:
    """A rolled towel lying flat, with spiral ends and a band near each end."""
    color = look.color(*words)
    roll = cylinder(r, long, 26).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.97 * r)
    spiral = prints.canvas(96, 96, tint_color(color, 0.95))
    for n in range(5):
        prints.disc(spiral, 0.5, 0.5, 0.48 - 0.1 * n, tint_color(color, 0.72), 0.45 - 0.1 * n)
    ends = [cylinder(0.96 * r, 0.0016, 26).turn(1, s * np.pi / 2).move(s * (long / 2 - 0.0008), 0,
                                                                       0.97 * r)
            for s in (-1, 1)]  # fmt: skip
    bands = [cylinder(r + 0.0006, 0.012, 26).move(z=-0.006).turn(1, np.pi / 2).move(x, 0, 0.97 * r)
             for x in (-0.36 * long, 0.36 * long)]  # fmt: skip
    flap = box(long, 0.8 * r, 0.008).move(0, -0.55 * r, 0)
    terry = surfaces.spots(look.rng, color, tint_color(color, 0.9), 0.4)
    pieces: Pieces = [(join([roll, flap]), terry), (ends[0], spiral), (ends[1], spiral),
                      (join(bands), surfaces.plain(tint_color(color, 0.82)))]  # fmt: skip
    return put_down(pieces, roll, flap)


@category("rolled_towel", size=(0.25, 0.092, 0.09), mass=0.35, material="fabric",
          aliases=("rolled up towel", "towel roll", "rolled bath towel", "rolled hand towel",
          "bolt of fabric", "roll of fabric"), themes=("vanity",), colors=("white", "teal"),
          state="lying")  # fmt: skip
def rolled_towel(look: Look) -> Shape:
    """A rolled towel, lying flat."""
    return _roll(look, look.between(0.22, 0.28), look.between(0.04, 0.052),
                 ("white", "teal", "pink", "gray", "sage", "navy", "mustard"))  # fmt: skip


@category("washcloth", size=(0.145, 0.145, 0.0245), mass=0.04, material="fabric",
          aliases=("wash cloth", "face cloth", "flannel", "facecloth", "face towel", "wash rag",
          "folded cloth", "rag", "chamois leather", "lens wipe", "screen wipe", "baby wipe",
          "antibacterial wipe", "wet wipe", "hanky"), themes=("vanity",), roles=("flat", "support"),
          colors=("white", "teal"), state="lying folded")  # fmt: skip
def washcloth(look: Look) -> Shape:
    """A small square washcloth, folded in four, with a loop."""
    side = look.between(0.11, 0.15)
    color = look.color(*SOFT, "teal", "mustard", "navy")
    terry = surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.4)
    layers = [pad(side - 0.003 * n, side - 0.002 * n, 0.006, 0.006, soft=0.45, steps=3)
              .move(z=0.006 * n) for n in range(4)]  # fmt: skip
    stripe = box(side - 0.012, 0.01, 0.0008).move(0, -0.32 * side, 0.0236)
    loop = rod([(side / 2 - 0.008, side / 2 - 0.012, 0.016),
                (side / 2 + 0.01, side / 2 + 0.006, 0.008),
                (side / 2 - 0.012, side / 2 - 0.006, 0.014)], 0.0016, 6)  # fmt: skip
    return put_down(
        [(join(layers), terry), (join([stripe, loop]), surfaces.plain(tint_color(color, 0.75)))],
        join(layers),
    )


@category("folded_towel", size=(0.27, 0.19, 0.065), mass=0.4, material="fabric", friction=0.8,
          aliases=("towel", "hand towel", "bath towel", "towels", "pile of laundry", "folded sheet",
          "pillowcase", "pile of washing"), themes=("vanity", "kitchen"), roles=("support", "big"),
          colors=("white", "teal"), state="lying folded", common=True)  # fmt: skip
def folded_towel(look: Look) -> Shape:
    """A towel folded into layers, or a stack of two folded towels."""
    x, y = look.between(0.22, 0.32), look.between(0.16, 0.22)
    pieces, z = [], 0.0
    for _ in range(2 if look.chance(0.4) else 1):
        color = look.color("white", "teal", "pink", "beige", "navy", "sage", "gray")
        pile = surfaces.fabric(look.rng, color, None, 40)
        band = surfaces.plain(tint_color(color, look.pick([0.7, 1.4])))
        layers, h = int(look.rng.integers(2, 4)), look.between(0.016, 0.022)
        for k in range(layers):
            bow = arc((-y / 2 + h / 2, z + h / 2), h / 2, np.pi / 2, 1.5 * np.pi, 6)
            fold = side_view([*bow, (y / 2, z), (y / 2, z + h)], x * (1 - 0.008 * k))
            pieces.append((fold.turn(2, np.pi / 2), pile))
            z += 0.96 * h
        stripe = box(0.97 * x, 0.018, 0.0012).move(y=-0.28 * y, z=z + 0.035 * h)
        pieces.append((stripe, band))
    return shape(pieces, [box_part(x, y, z)])
