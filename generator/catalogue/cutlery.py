"""Forks, spoons and knives, lying flat."""

from __future__ import annotations

import itertools

import numpy as np

from ..scene import ConvexPart
from . import textures
from .category import Category
from .collision import hull_of, hull_part
from .look import Look
from .shape import Shape, shape
from .solids import Solid, block, cylinder, joined, prism, refined
from .textures import Tile


def _bent(solid: Solid, length: float, dip: float) -> Solid:
    """Return flat cutlery with its neck raised, lying on its two ends."""
    return solid.bent(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + dip * np.clip(np.cos(np.pi * p[:, 0] / length), 0, 1)]
        )
    )


def _sliced(solid: Solid, edges: list[float]) -> list[ConvexPart]:
    x = solid.vertices[:, 0]
    return [
        hull_part(solid.vertices[(x >= a - 1e-6) & (x <= b + 1e-6)])
        for a, b in itertools.pairwise(edges)
    ]


def _mirrored(half: list[tuple[float, float]]) -> np.ndarray:
    """Return a closed outline from its lower half, listed from left to right."""
    lower = np.array(half, float)
    upper = lower[::-1] * [1, -1]
    return np.concatenate([lower, upper[np.abs(upper[:, 1]) > 1e-9]])


def _metal(look: Look) -> Tile:
    return look.surface(look.color("silver", "silver", "gold", "black", spread=4), "metal")


def fork(look: Look) -> Shape:
    """A fork lying flat, four tines to the left."""
    long = look.between(0.185, 0.205)
    steel = _metal(look)
    grip = [
        (-0.046, 0.0),
        (-0.044, -0.006),
        (-0.03, -0.011),
        (-0.02, -0.0035),
        (0.02, -0.003),
        (0.5 * long - 0.01, -0.0095),
        (0.5 * long, -0.006),
    ]
    body = prism(_mirrored([(x, y) for x, y in grip if y < 0 or x < -0.045]), 0, 0.0024)
    tine = prism(np.array([(-0.5 * long, -0.0009), (-0.03, -0.0019), (-0.03, 0.0019),
                           (-0.5 * long, 0.0009)]), 0, 0.0022)  # fmt: skip
    tines = [tine.moved(y=(k - 1.5) * 0.0058) for k in range(4)]
    whole = joined([body, *tines])
    fine = _bent(refined(whole), long, 0.008)
    return shape([(fine, steel)], _sliced(fine, [-0.5 * long, -0.04, 0.0, 0.5 * long]))


def spoon(look: Look) -> Shape:
    """A spoon lying flat, its bowl to the left."""
    long = look.between(0.165, 0.195)
    steel = _metal(look)
    width = look.between(0.019, 0.021)
    head = cylinder(1, 0.0022, 24).scaled(0.031, width, 1).moved(x=-0.5 * long + 0.031)
    hollow = cylinder(1, 0.0006, 24).scaled(0.026, width - 0.0045, 1)
    hollow = hollow.moved(x=-0.5 * long + 0.031, z=0.0021)
    grip = prism(
        _mirrored([(-0.5 * long + 0.055, -0.005), (0.0, -0.0028), (0.5 * long - 0.02, -0.0085),
                   (0.5 * long - 0.004, -0.007), (0.5 * long, -0.003)]), 0, 0.0022,
    )  # fmt: skip

    def lifted(solid: Solid) -> Solid:
        return _bent(refined(solid), long, 0.009)

    whole = lifted(joined([head, grip]))
    dark = textures.gradient((120, 122, 128), (176, 178, 184), look.rng)
    return shape(
        [(whole, steel), (lifted(hollow), dark)],
        _sliced(whole, [-0.5 * long, -0.5 * long + 0.06, 0.02, 0.5 * long]),
    )


def knife(look: Look) -> Shape:
    """A table knife lying flat, or a kitchen knife with a dark handle."""
    table = look.chance(0.5)
    long, width = (look.between(0.21, 0.225), 0.019) if table else (look.between(0.27, 0.3), 0.036)
    steel = textures.brushed(look.rng, (196, 199, 204))
    cut = 0.02 if table else 0.0
    blade = prism(
        np.array([(-0.5 * long, 0.3 * width), (-0.44 * long, -0.35 * width),
                  (-0.3 * long, -0.5 * width), (cut, -0.5 * width), (cut, 0.5 * width),
                  (-0.36 * long, 0.5 * width)]), 0.0012, 0.0032,
    )  # fmt: skip
    color = look.color("silver") if table else look.color("black", "wooden", "red", "charcoal")
    grip = block(
        0.5 * long - cut, 0.8 * min(width, 0.028), 0.0075 if table else 0.016, 0.006, 0.002
    )
    grip = grip.moved(x=cut + (0.5 * long - cut) / 2)
    blade = blade.moved(z=-0.0012 if table else 0.0)
    low = 0.0 if table else 0.0012
    under = blade.moved(z=-low)
    return shape(
        [(under, steel), (grip, look.surface(color, "metal" if table else "plastic"))],
        [hull_of(under), hull_of(grip)],
    )


CATEGORIES = (
    Category(
        "fork",
        fork,
        (0.195, 0.023, 0.0104),
        0.04,
        ("salad fork",),
        ("dining", "kitchen"),
        ("flat",),
        ("silver", "gold"),
        state="lying flat",
    ),
    Category(
        "spoon",
        spoon,
        (0.18, 0.04, 0.0115),
        0.04,
        ("teaspoon", "tablespoon", "soup spoon"),
        ("dining", "kitchen", "coffee"),
        ("flat",),
        ("silver", "gold"),
        state="lying flat",
    ),
    Category(
        "knife",
        knife,
        (0.25, 0.028, 0.012),
        0.09,
        ("table knife", "kitchen knife", "butter knife", "chef knife", "steak knife"),
        ("dining", "kitchen"),
        ("flat",),
        ("silver", "black"),
        state="lying flat",
    ),
)
