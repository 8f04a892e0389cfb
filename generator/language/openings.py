"""The variant of an object that takes contents: an open box for a box, an empty vase for a vase."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tabletop_objects import CATEGORIES

_PLANTS = (
    "seedling cactus succulent rose tulip daisy sunflower lily herb_pot potted_plant fern ivy "
    "lavender orchid"
)
_MEANT: Mapping[tuple[str, str], str] = MappingProxyType(
    {
        (word, kind): holder
        for word, holder, kinds in (
            ("rack", "empty_tube_rack", "test_tube"),
            ("rack", "empty_toast_rack", "toast bread_slice"),
            ("rack", "empty_wine_rack", "wine_bottle"),
            ("rack", "letter_rack", "letter envelope magazine newspaper postcard vinyl_record"),
            ("flower pot", "plant_pot", _PLANTS),
            ("pot", "plant_pot", _PLANTS),
        )
        for kind in kinds.split()
    }
)
"""A bare word and what is put there, and the category that the word then means."""


_POTTED = frozenset(
    ["cactus", "succulent", "herb_pot", "potted_plant", "fern", "ivy", "aloe", "lavender",
     "plant", "basil", "mint", "orchid", "snake_plant", "spider_plant"]
)  # fmt: skip
LOOSE: Mapping[str, str] = MappingProxyType({"chips_bag": "potato_crisp"})
"""Packages of food, and what of it is put into a bowl."""
_CANDLES = frozenset({"candle", "taper_candle", "long_candle"})
_SOCKETS = frozenset({"empty_candlestick", "empty_candelabra"})
_FLOWERS = ("rose", "tulip", "daisy", "carnation")


def cut_category(category: str, vessel: str, number: int) -> str:
    """Return the category of what is put into a vessel: of flowers in a vase, cut ones.

    ``number`` counts what is put there.
    """
    if open_category(vessel) == "empty_vase":
        if category == "vase":  # the catalogue's word for flowers
            return _FLOWERS[number % len(_FLOWERS)]
        return "posy" if category == "bouquet" else category
    if category in _POTTED and open_category(vessel) == "plant_pot":
        return "bare_cactus" if category == "cactus" else "seedling"
    if is_lit(category, vessel):
        return "long_candle"
    return category


def is_lit(category: str, vessel: str) -> bool:
    """Tell whether a thing is a candle, and the other one has a socket for it."""
    return category in _CANDLES and open_category(vessel) in _SOCKETS


def open_category(category: str, noun: str = "", contents: str = "") -> str:
    """Return the category of a thing called ``noun`` where ``contents`` (a category) goes in it."""
    known = CATEGORIES.get(category)
    usual = known.opened if known is not None and known.opened else category
    return _MEANT.get((noun, contents), usual)
