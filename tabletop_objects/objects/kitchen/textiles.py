"""Objects of the ``kitchen`` theme: textiles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import hull_of, hull_part
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, box, join, loft, prism, torus, tube
from ...kit.surfaces import Look, tint_color

CLOTH = ("red", "navy", "sage", "mustard", "white", "teal", "gray", "pink")


@category("oven_mitt", size=(0.313, 0.179, 0.0282), mass=0.09, material="fabric",
          aliases=("oven glove", "kitchen glove", "oven mitten", "baking glove", "baking mitt"),
          themes=("kitchen",), roles=("flat", "big"), colors=("red",),
          state="lying flat")  # fmt: skip
def oven_mitt(look: Look) -> Shape:
    """A quilted oven mitt lying flat with its thumb in front."""
    color = look.color(*CLOTH)
    k, h = look.between(0.92, 1.1), look.between(0.024, 0.03)
    hand = smooth(np.array([(-0.14, -0.065), (-0.05, -0.07), (0.01, -0.075), (0.05, -0.105),
                            (0.09, -0.1), (0.085, -0.07), (0.06, -0.045), (0.1, -0.04),
                            (0.135, -0.02), (0.14, 0.02), (0.12, 0.055), (0.07, 0.072),
                            (-0.04, 0.07), (-0.14, 0.065)]), 3) * k  # fmt: skip
    mid = np.array([0.0, -0.005])
    rings = np.stack([np.column_stack([(hand - mid) * f + mid, np.full(len(hand), z)]) for f,
                      z in ((0.92, 0), (1.0, 0.3 * h), (1.0, 0.6 * h), (0.9, h))])  # fmt: skip
    body = loft(rings, hand)
    quilt = surfaces.grid(tint_color(color, 0.7), color, 12, 12, 128)
    cuff = box(0.024, 0.15 * k, 1.06 * h).move(x=-0.14 * k)
    loop = torus(0.014, 0.003, 16, 6).move(-0.14 * k - 0.018, 0.05 * k, 0.4 * h)
    other = surfaces.fabric(look.rng, look.own_color("white", "charcoal", "cream", "navy"))
    return shape([(body, quilt), (join([cuff, loop]), other)],
                 [hull_part(body.vertices[body.vertices[:, 1] > -0.078 * k]), hull_of(cuff),
                  hull_part(body.vertices[(body.vertices[:, 1] < -0.04 * k) & (
                      body.vertices[:, 0] > 0)])])  # fmt: skip


@category("pot_holder", size=(0.208, 0.208, 0.0101), mass=0.05, material="fabric",
          aliases=("potholder", "quilted pot holder"), themes=("kitchen",),
          roles=("flat", "support"), colors=("red",), state="lying flat")  # fmt: skip
def pot_holder(look: Look) -> Shape:
    """A square quilted pot holder with a loop."""
    x, h = look.between(0.17, 0.2), look.between(0.009, 0.013)
    color = look.color(*CLOTH)
    quilt = surfaces.grid(tint_color(color, 0.72), color, 7, 7, 128)
    body = block(0.95 * x, 0.95 * x, h, 0.014, 0.004)
    hem = block(x, x, 0.6 * h, 0.018, 0.002).move(z=0.2 * h)
    loop = torus(0.016, 0.003, 16, 6).move(0.53 * x, 0.53 * x, 0.5 * h)
    other = surfaces.fabric(look.rng, look.own_color("white", "charcoal", "cream", "red"))
    return shape([(hem, other), (body, quilt), (loop, other)], [hull_of(body, hem)])


@category("tea_towel", size=(0.242, 0.183, 0.0177), mass=0.08, material="fabric",
          aliases=("dish towel", "kitchen towel", "dishcloth", "dish cloth", "kitchen cloth",
          "dish rag", "folded tea towel", "cheesecloth"), themes=("kitchen",),
          roles=("flat", "support"), colors=("red", "navy"), state="lying flat")  # fmt: skip
def tea_towel(look: Look) -> Shape:
    """A folded striped or checked tea towel, lying flat."""
    x, y, h = look.between(0.21, 0.26), look.between(0.15, 0.18), look.between(0.014, 0.02)
    color = look.color("red", "navy", "sage", "teal", "mustard", "gray", "white")
    if look.chance(0.5):
        cloth = surfaces.fabric(look.rng, (244, 242, 234), color)
    else:
        cloth = np.asarray(surfaces.fabric(look.rng, (244, 242, 234))).copy()
        for u in (0.1, 0.15, 0.8, 0.85):
            prints.fill(cloth, u, 0, 0.03, 1, color)
    folds = [block(x, y * (1 - 0.012 * k), h / 4 * 0.98, 0.006, 0.0012).move(y=0.004 * k,
             z=h / 4 * k) for k in range(4)]  # fmt: skip
    roll = tube([(-0.49 * x, -0.5 * y, h / 2), (0.49 * x, -0.5 * y, h / 2)], h / 2, 10)
    return shape([(join([*folds, roll]), cloth)], [hull_of(*folds)])


@category("apron", size=(0.33, 0.329, 0.0201), mass=0.2, material="fabric",
          aliases=("kitchen apron", "cooking apron", "chef apron"), themes=("kitchen",),
          roles=("flat", "big"), colors=("navy", "red"), state="lying flat")  # fmt: skip
def apron(look: Look) -> Shape:
    """A folded apron lying flat, with its pocket up and its strings beside it."""
    x, y, h = look.between(0.24, 0.28), look.between(0.26, 0.3), look.between(0.014, 0.02)
    color = look.color("navy", "red", "black", "tan", "sage", "white", "gray")
    cloth = surfaces.fabric(look.rng, color)
    bib = prism(np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.08), (0.3, 0.26), (0.26, 0.5),
                          (-0.26, 0.5), (-0.3, 0.26), (-0.5, 0.08)]) * [x, y], 0, h, 0)  # fmt: skip
    pocket = box(0.55 * x, 0.3 * y, 0.003).move(y=-0.2 * y, z=h - 0.0008)
    seam = [box(0.0025, 0.3 * y, 0.0006).move(y=-0.2 * y, z=h + 0.002)]
    neck = tube(smooth([(-0.2 * x, 0.5 * y, h - 0.003), (-0.2 * x, 0.6 * y, 0.004), (0, 0.66 * y,
                 0.003), (0.2 * x, 0.6 * y, 0.004), (0.2 * x, 0.5 * y, h - 0.003)], 5), 0.004, 6,
                squash=0.5)  # fmt: skip
    ties = [tube(smooth([(s * 0.5 * x, 0.06 * y, 0.5 * h), (s * 0.62 * x, -0.02 * y, 0.002),
                         (s * 0.6 * x, -0.25 * y, 0.002)], 5), 0.0035, 6, squash=0.5)
            for s in (-1, 1)]  # fmt: skip
    dark = surfaces.fabric(look.rng, tint_color(color, 0.72))
    pale = surfaces.plain(tint_color(color, 1.4))
    return shape([(bib, cloth), (join([pocket, neck, *ties]), dark), (join(seam), pale)],
                 [hull_of(bib)])  # fmt: skip
