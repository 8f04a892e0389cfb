"""Toothpicks, cocktail picks, squeezed tubes of paste, electric knives."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part
from ...build.recipes import Pieces
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, lathe, prism
from ...build.variants import keep_still
from ...surfaces import textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look
from .implements import steel, with_handle


def toothpick(look: Look) -> Shape:
    """A thin wooden pick with two points, lying."""
    long, r = look.between(0.06, 0.07), look.between(0.0009, 0.0012)
    color = look.color("tan", "wooden", "beige", "amber", "cream", "brown")
    pick = lathe(
        [
            (0, 0),
            (0.7 * r, 0.12 * long),
            (r, 0.25 * long),
            (r, 0.75 * long),
            (0.7 * r, 0.88 * long),
            (0, long),
        ],
        8,
    )
    pick = pick.turn(1, np.pi / 2).move(-long / 2, 0, r)
    return shape([(pick, look.surface(color, "wood"))], [box_part(0.9 * long, 2 * r, 2 * r)])


def cocktail_pick(look: Look) -> Shape:
    """A cocktail pick lying, a bead or a little flag at one end."""
    long, r = look.between(0.08, 0.11), look.between(0.0009, 0.0012)
    color = look.color("red", "green", "gold", "blue", "white", "pink")
    pick = (
        lathe([(0, 0), (r, 0.2 * long), (r, long), (0, long)], 8)
        .turn(1, np.pi / 2)
        .move(-long / 2, 0, r + 0.002)
    )
    pieces: Pieces = [(pick, textures.plain((226, 196, 146)))]
    if look.chance(0.5):
        pieces.append(
            (
                ellipsoid(0.008, 0.008, 0.008, 12, 8).move(long / 2 - 0.002, 0, 0.003),
                look.surface(color, "plastic"),
            )
        )
    else:
        flag = prism(
            [(-0.016, 0.0), (0.0, 0.0), (0.0, 0.014), (-0.016, 0.014), (-0.011, 0.007)], 0, 0.001
        )
        pieces.append((flag.move(long / 2 - 0.004, 0, r + 0.0015), look.surface(color, "paper")))
    made = settle(pieces, 0.02)
    points = np.concatenate([p.solid.vertices for p in made.pieces])
    x, y, z = (float(side) for side in np.ptp(points, axis=0) * [0.9, 0.9, 0.8])
    middle = float(points[:, 1].min() + points[:, 1].max()) / 2
    return Shape(made.pieces, (box_part(x, y, z, (0, middle, 0)),))


def _twin_blade(look: Look, color: RGB, z: float) -> Pieces:
    blade = prism(
        [(0.01, -0.012), (0.01, 0.012), (-0.19, 0.008), (-0.2, 0.0), (-0.19, -0.01)], 0, 0.003
    )
    return [(blade.move(z=z - 0.0015), steel(look))]


_K = ("kitchen",)
CATEGORIES = (
    Category("toothpick", toothpick, (0.0656, 0.00214, 0.00214), 0.0002,
             ("wooden toothpick",), _K, (), ("tan",), state="lying"),
    Category("cocktail_pick", cocktail_pick, (0.0936, 0.0124, 0.00407), 0.0006,
             ("cocktail stick", "party pick", "olive pick", "sandwich pick", "food pick",
              "flag pick"), _K, (), ("red",), state="lying"),
    Category("electric_knife", keep_still(with_handle(_twin_blade, (0.16, 0.19), 0.0,
                                                  ("white", "black", "gray", "red"), 0.02)),
                                                  (0.383, 0.046, 0.0451), 0.7,
                                                  ("electric carving knife",
                                                   "cordless carving knife"), _K, (), ("white",),
             state="lying"),
)  # fmt: skip
"""The module's categories."""
