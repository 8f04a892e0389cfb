"""Objects of the ``kitchen`` theme: dried fruit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.primitives import bent_rod
from ...kit.shapes import Category, Shape, category, settle
from ...kit.solids import cylinder, ellipsoid
from ...kit.surfaces import Look, tint_color
from .fruit import Globe, _ring, globe, peel_strip
from .nuts import Heap, heap


def _dried_fruit(palette: tuple[str, ...], d: tuple[float, float]) -> Callable[[Look], Shape]:
    """Return the shape function of a dried fruit half: a dented, wrinkled disc."""

    def make(look: Look) -> Shape:
        size, color, lumps = look.between(*d), look.color(*palette), look.between(0, 6)
        body = ellipsoid(size, size * look.between(0.8, 0.95), 0.34 * size, 24, 12)

        def wrinkle(p: np.ndarray) -> np.ndarray:
            r = np.hypot(p[:, 0], p[:, 1]) / size
            z = p[:, 2] - 0.1 * size * np.exp(-((r / 0.22) ** 2)) * (p[:, 2] > 0)
            wave = 1 + 0.05 * np.sin(5 * np.arctan2(p[:, 1], p[:, 0]) + lumps)
            return np.column_stack([p[:, 0] * wave, p[:, 1] * wave, z])

        tile = surfaces.spots(look.rng, color, tint_color(color, 0.78), 0.2)
        return settle([(body.bend(wrinkle), tile)], 0.14)

    return make


@category("date", size=(0.0412, 0.0211, 0.0159), mass=0.012, material="food",
          aliases=("medjool date", "dried date", "prune"), themes=("kitchen", "food"),
          roles=("edible",), colors=("brown",), state="lying flat")  # fmt: skip
def date(look: Look) -> Shape:
    """A wrinkled date, lying flat."""
    long, r = look.between(0.036, 0.044), look.between(0.0095, 0.012)
    color = look.color("brown", "bronze", "maroon")
    body = bent_rod(long, r, blunt=3, squash=0.9)
    wrinkled = surfaces.stripes([tint_color(color, 0.6), tint_color(color, 0.8)], 9, upright=True)
    cap = cylinder(0.3 * r, 0.003, 10).turn(1, np.pi / 2).move(x=0.48 * long)
    return settle([(body, wrinkled), (cap, surfaces.plain((196, 160, 100)))], 0.14)


CATEGORIES = (
    Category("apple_ring", _ring((0.028, 0.036), 0.28, 0.006, ("cream", "ivory", "beige"), 0.8),
             size=(0.0658, 0.0661, 0.00615), mass=0.01, material="food",
             aliases=("dried apple ring", "dried apple"), themes=("kitchen", "food"),
             roles=("edible", "flat"), colors=("cream",), state="lying flat"),
    Category("candied_peel", peel_strip(("orange", "yellow", "amber"), True),
             size=(0.0737, 0.0133, 0.00732), mass=0.006, material="food",
             aliases=("candied orange peel", "candied orange", "candied lemon peel", "orangette"),
             themes=("kitchen", "food"), roles=("edible",), colors=("orange",), state="lying flat"),
    Category("dried_apricot",
             _dried_fruit(("orange", "amber", "terracotta", "copper"), (0.03, 0.04)),
             size=(0.0358, 0.0321, 0.00883), mass=0.008, material="food",
             aliases=("dried peach", "dried mango", "dried pear", "dried fig", "dried prune"),
             themes=("kitchen", "food"), roles=("edible",), colors=("orange",), state="lying flat"),
    Category("raisin", globe(Globe((0.008, 0.011), 1.5, ("maroon", "brown", "black"),
             "dark streaks", top="none", lying=True)), size=(0.0114, 0.0125, 0.0079), mass=0.0006,
             material="food", aliases=("sultana", "dried grape"), themes=("kitchen", "food"),
             roles=("edible",), colors=("maroon",)),
    Category("raisin_heap", heap(Heap((0.026, 0.036), 0.008, "ball", ("maroon", "brown", "black"))),
             size=(0.0725, 0.0729, 0.0211), mass=0.03, material="food", aliases=("heap of sultana",
             "handful of raisin", "heap of raisin", "pile of raisin", "mound of raisin"),
             themes=("kitchen", "food"), roles=("edible",), colors=("maroon",), state="heaped"),
    Category("desiccated_coconut",
             heap(Heap((0.024, 0.034), 0.006, "strand", ("white", "ivory", "white"))),
             size=(0.0674, 0.0682, 0.02), mass=0.01, material="food", aliases=("coconut flake",
             "shredded coconut", "grated coconut", "heap of desiccated coconut",
             "pile of desiccated coconut", "mound of desiccated coconut",
             "desiccated coconut heap"), themes=("kitchen", "food"), roles=("edible",),
             colors=("white",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
