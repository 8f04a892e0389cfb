"""Appearance of one variant of a category: seeded choices, overridden by requested attributes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from .colors import RGB, rgb, tint_color
from .textures import Tile, brushed_metal, fabric, marble, speckles, spots, wood

T = TypeVar("T")

SIZE_FACTORS: Mapping[str, float] = {
    "tiny": 0.65,
    "mini": 0.7,
    "small": 0.8,
    "little": 0.8,
    "medium": 1.0,
    "big": 1.25,
    "large": 1.25,
    "huge": 1.45,
    "giant": 1.45,
}
"""What a size word does to an object's extent."""

WOODS: Mapping[str, RGB] = {
    "oak": (196, 154, 104),
    "walnut": (112, 76, 50),
    "pine": (222, 186, 132),
    "beech": (214, 172, 124),
    "maple": (226, 194, 148),
    "cherry": (156, 88, 56),
    "mahogany": (116, 58, 40),
    "birch": (230, 206, 166),
    "bamboo": (220, 190, 124),
    "teak": (166, 112, 66),
    "ebony": (58, 46, 42),
    "wood": (190, 144, 94),
    "wooden": (190, 144, 94),
}
"""Ground colours of woods."""

METALS: Mapping[str, RGB] = {
    "steel": (176, 180, 186),
    "stainless": (186, 190, 194),
    "metal": (172, 176, 182),
    "metallic": (172, 176, 182),
    "aluminum": (196, 198, 202),
    "iron": (74, 76, 80),
    "brass": (196, 160, 84),
    "copper": (188, 116, 76),
    "bronze": (150, 110, 62),
    "gold": (212, 172, 82),
    "silver": (200, 202, 206),
    "chrome": (206, 210, 214),
}
"""Ground colours of metals."""


@dataclass(frozen=True, eq=False)
class Look:
    """The random generator of one variant and the attributes asked for.

    Draw numbers first and in a fixed order, so that a seed always gives the same variant.
    """

    rng: np.random.Generator
    attributes: Mapping[str, str]

    def between(self, low: float, high: float) -> float:
        """Return a uniform number."""
        return float(self.rng.uniform(low, high))

    def pick(self, options: Sequence[T]) -> T:
        """Return one of ``options``, all equally likely."""
        return options[int(self.rng.integers(len(options)))]

    def chance(self, probability: float) -> bool:
        """Return True with the given probability."""
        return bool(self.rng.random() < probability)

    @property
    def material(self) -> str:
        """The material word asked for, lower case, or an empty string."""
        return self.attributes.get("material", "").lower()

    def color(self, *palette: str, spread: float = 8.0) -> RGB:
        """Return the colour asked for, else one named in ``palette``, slightly varied."""
        choice = self.pick(palette)
        drift = self.rng.uniform(-spread, spread, 3)
        asked = rgb(self.attributes.get("color", ""))
        base = asked if asked is not None else rgb(choice)
        if base is None:
            raise ValueError(f"{choice!r} is no colour word.")
        r, g, b = np.clip(np.array(base) + drift, 6, 250)
        return float(r), float(g), float(b)

    def own_color(self, *palette: str, spread: float = 6.0) -> RGB:
        """Return a colour of ``palette``, whatever colour was asked for (details, screws)."""
        return Look(self.rng, {}).color(*palette, spread=spread)

    def surface(self, color: RGB, default: str = "plastic") -> Tile:
        """Return a tile of the material asked for (else ``default``) in ``color``.

        A wood or metal word brings its own colour unless one was asked for as well.
        """
        asked = self.material
        word = asked or default
        own = "color" not in self.attributes and asked != ""
        for key, ground in WOODS.items():
            if key in word.split():
                return wood(self.rng, ground if own else color)
        for key, ground in METALS.items():
            if key in word.split():
                return brushed_metal(self.rng, ground if own else color)
        if "marble" in word or "stone" in word:
            ground = (232, 230, 226) if own else color
            return marble(self.rng, ground, tint_color(ground, 0.6))
        if word in ("fabric", "cloth", "linen", "cotton", "felt", "wool"):
            return fabric(self.rng, color)
        if word in ("stoneware", "clay", "granite"):
            return spots(self.rng, color, tint_color(color, 0.55))
        return speckles(self.rng, color, 3.0, 32)
