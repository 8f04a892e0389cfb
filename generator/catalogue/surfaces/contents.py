"""What vessels hold, by the words of their "state": drinks as a surface, food as a heap."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from ..build.solids import Solid, cylinder, ellipsoid
from .colors import RGB, rgb, tint_color
from .look import Look
from .textures import Tile, plain, spots

DRINKS: Mapping[str, RGB] = MappingProxyType(
    {
        "coffee": (58, 34, 22), "espresso": (44, 26, 18), "tea": (166, 88, 32),
        "milk": (248, 246, 238), "cocoa": (96, 58, 38), "chocolate": (96, 58, 38),
        "juice": (242, 156, 40), "lemonade": (244, 226, 130), "wine": (112, 20, 42),
        "beer": (214, 146, 40), "cola": (48, 26, 20), "coke": (48, 26, 20),
        "soda": (200, 224, 232), "water": (196, 222, 234), "soup": (214, 124, 52),
        "sauce": (176, 44, 30), "oil": (206, 178, 60), "paint": (52, 110, 190),
        "ink": (28, 32, 80), "syrup": (150, 82, 26), "liquid": (120, 160, 190),
    }
)  # fmt: skip
"""Colours of liquids by word; a colour word beside it counts more ("blue liquid")."""

FOODS: Mapping[str, RGB] = MappingProxyType(
    {
        "cereal": (206, 152, 82), "crisps": (236, 196, 92), "chips": (236, 196, 92),
        "popcorn": (248, 238, 200), "rice": (244, 240, 228), "salad": (104, 156, 66),
        "sugar": (250, 250, 248), "salt": (248, 248, 246), "flour": (246, 242, 232),
        "nuts": (150, 98, 58), "candy": (226, 84, 110), "sweets": (226, 84, 110),
        "pasta": (238, 206, 118), "butter": (250, 226, 130), "soil": (84, 60, 44),
        "sand": (224, 200, 150), "pepper": (70, 62, 56),
    }
)  # fmt: skip
"""Colours of food and the like by word."""


def drink_color(look: Look) -> RGB | None:
    """Return the colour of the drink that a vessel is said to hold; None without one."""
    state = look.attributes.get("state", "")
    words = state.split()[1:] if state.startswith("with ") else []
    found = next((DRINKS[word] for word in words if word in DRINKS), None)
    return found and (rgb(" ".join(words)) or found)


def contents(look: Look, radius: float, height: float) -> list[tuple[Solid, Tile]] | None:
    """Return what a round vessel holds: a piece of ``radius`` at ``height``, metres.

    An empty list where it is said to be empty, None where nothing is said.
    """
    state = look.attributes.get("state", "")
    if state == "empty":
        return []
    if drink := drink_color(look):
        return [(cylinder(radius, 0.0016, 28).move(z=height), plain(drink))]
    for word in state.split()[1:] if state.startswith("with ") else []:
        if word in FOODS:
            color = rgb(state) or FOODS[word]
            heap = ellipsoid(2 * radius, 2 * radius, 0.5 * radius, 24, 12).move(z=height)
            return [(heap, spots(look.rng, color, tint_color(color, 0.8), 0.3))]
    return None
