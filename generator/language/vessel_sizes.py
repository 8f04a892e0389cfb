"""Choice of open vessels, and of the sizes of vessels and carriers, to suit their contents.

A fruit bowl is larger than a cereal bowl, and a tray for a tea service is larger than one for two
cups. Carriers are therefore enlarged, within a plausible range, to hold their contents.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.values import Extent

from ..scene import PlannedObject
from . import relations

_GROWTH: Mapping[str, float] = {
    "bowl": 1.75, "basket": 1.6, "box": 1.8, "tray": 1.9, "plate": 1.35, "pot": 1.5, "pan": 1.3,
    "cutting_board": 1.6, "book": 1.35, "toolbox": 1.4, "cake_stand": 1.4, "generic": 1.6,
    "serving_bowl": 1.6, "mixing_bowl": 1.4, "serving_platter": 1.5, "crate": 1.5, "open_box": 1.8,
    "tool_caddy": 1.4, "lunch_box": 1.3, "cooling_rack": 1.4, "baking_dish": 1.3, "desk_tray": 1.3,
    "bucket": 1.6, "open_ice_bucket": 1.3,
}  # fmt: skip
"""Maximum growth of a carrier, relative to its usual size."""

_OTHERS = 1.25
_PLACES = ("egg_carton",)
"""Carriers that have a slot for each object, and are empty if the text fills them."""

_FILLED = 0.34  # fraction of a vessel's mouth that a layer of objects fills
_LAYERS = 1.6  # effective number of layers if there are more than three objects
_FLAT = 0.22  # maximum ratio of thickness to width of objects filed in a box
_MIN_WIDTH = 0.1  # minimum width of filed objects, metres
_LITTLE = 1.35
_FLOOR = 0.72  # width of a round vessel's floor, as a fraction of its box
_COVERED = 0.7  # maximum fraction of a tray that objects cover


def largest_size(category: str) -> Extent:
    """Return the extent of the largest variant of a category, in metres."""
    factor = _GROWTH.get(category, _OTHERS)
    x, y, z = CATEGORIES[category].size
    return factor * x, factor * y, factor * z


def grow_carriers(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Return the objects, with carriers enlarged to hold their contents.

    Closed or filled vessels that have contents become open ones; racks get as many slots as they
    need.
    """
    objects = _open(objects)
    names = {o.name: o for o in objects}
    held: dict[str, list[str]] = {}
    kinds: dict[str, set[str]] = {}
    for planned in objects:
        for relation in planned.relations:
            if relation.kind in ("on", "in") and relation.target in names:
                held.setdefault(relation.target, []).append(planned.name)
                kinds.setdefault(relation.target, set()).add(relation.kind)
    done: dict[str, PlannedObject] = {}
    while len(done) < len(objects):
        ready = [n for n in names if n not in done and done.keys() >= {*held.get(n, ())}]
        for name in ready or [n for n in names if n not in done]:  # for cycles
            carried = [done.get(other, names[other]) for other in held.get(name, ())]
            alike = [o for o in carried if o.category == names[name].category]
            others = [o for o in carried if o not in alike]
            done[name] = _grow(names[name], others, kinds.get(name, set()))
            if done[name] == names[name] and alike and alike[0].size is not None:
                done[name] = replace(names[name], size=names[name].size or alike[0].size)
    return [done[o.name] for o in objects]


def holds_things(category: str) -> bool:
    """Return whether a category is a vessel, possibly once its lid is removed."""
    return CATEGORIES[open_category(category)].container


def _open(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Return the objects, with vessels and racks that hold objects replaced by open, empty ones."""
    objects = _spread_cloths(_clear_cakes(_seat_candles(objects)))
    names = {o.name: o for o in objects}
    inside: dict[str, list[PlannedObject]] = {}
    for planned in objects:
        for relation in planned.relations:
            if relation.kind == "in" and relation.target in names:
                inside.setdefault(relation.target, []).append(planned)
    changed: dict[str, PlannedObject] = {}
    for name, held in inside.items():
        target = names[name]
        vessel = open_category(target.category, target.noun, held[0].category)
        for k, thing in enumerate(held):
            kind = cut_category(thing.category, vessel, k)
            changed[thing.name] = replace(thing, category=kind)
    for name, held in inside.items():
        kind = open_category(names[name].category, names[name].noun, held[0].category)
        changed[name] = replace(changed.get(name, names[name]), category=kind)
    return [changed.get(o.name, o) for o in objects]


def _seat_candles(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Return the objects; candles "on" candlesticks are put into the candlesticks' sockets."""
    kinds = {o.name: o.category for o in objects}
    return [
        replace(o, relations=tuple(
            replace(r, kind="in")
            if r.kind == "on" and is_lit(o.category, kinds.get(r.target, "")) else r
            for r in o.relations
        ))
        for o in objects
    ]  # fmt: skip


_CAKES = frozenset({"birthday_cake", "cake", "cupcake"})
"""Cakes that can carry small candles."""

_FOLDED = frozenset({"blanket", "folded_towel", "tablecloth"})
"""Cloths that are folded in the catalogue."""


def _spread_cloths(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Return the objects; cloths that carry several objects are spread out, unless "folded"."""
    held = Counter(r.target for o in objects for r in o.relations if r.kind == "on")

    def is_spread(planned: PlannedObject) -> bool:
        folded = "folded" in (planned.attributes.get("state"), *planned.noun.split())
        return planned.category in _FOLDED and held[planned.name] > 1 and not folded

    return [replace(o, category="cloth") if is_spread(o) else o for o in objects]


def _clear_cakes(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Return the objects, with bare cakes in place of those on which the text puts candles."""
    cakes = {o.name for o in objects if o.category in _CAKES}
    small = {o.name for o in objects if o.category in ("candle", "birthday_candle")
             and any(r.kind == "on" and r.target in cakes for r in o.relations)}  # fmt: skip
    lit = {r.target for o in objects if o.name in small for r in o.relations}

    def lit_by(planned: PlannedObject) -> PlannedObject:
        if planned.name in small:
            return replace(planned, category="birthday_candle")
        drawn = planned.category == "birthday_cake" and planned.name in lit
        return replace(planned, category="cake") if drawn else planned

    return [lit_by(o) for o in objects]


def _grow(
    planned: PlannedObject, held: Sequence[PlannedObject], kinds: Collection[str]
) -> PlannedObject:
    if planned.category in _PLACES and held:
        count = len(held)
    else:
        count = sum(relations.has_place(o, planned) for o in held) if _is_holder(planned) else 0
    if count:
        places = {"state": "empty", "places": str(count)}
        return replace(planned, attributes={**planned.attributes, **places})
    factor = _factor(planned, held, kinds)
    if factor <= 1.0 or planned.size is not None:
        return planned
    x, y, z = relations.size_of(planned)
    return replace(planned, size=(factor * x, factor * y, factor * z))


def _is_holder(planned: PlannedObject) -> bool:
    return planned.category in CATEGORIES and CATEGORIES[planned.category].holder is not None


def _across(sizes: Sequence[Extent], vessel: PlannedObject) -> float:
    """Return the width, in metres, that a vessel needs for objects to stand in it side by side.

    A circle of diameter 0.9 + 0.87 sqrt(n) holds about n unit circles; round vessels narrow
    downwards.
    """
    known = CATEGORIES.get(vessel.category)
    floor = _FLOOR if known is not None and "round" in known.roles else 0.95
    wide = float(np.mean([max(size[:2]) for size in sizes]))
    return 1.1 * wide * (0.9 + 0.87 * float(np.sqrt(len(sizes)))) / floor


def _factor(planned: PlannedObject, held: Sequence[PlannedObject], kinds: Collection[str]) -> float:
    """Return the growth factor that an object's contents require, up to its maximum."""
    if not held:
        return 1.0
    usual = relations.size_of(planned)
    container = relations.is_container(planned)
    most = _GROWTH.get(planned.category, _OTHERS)
    sizes = [relations.standing_size(thing) for thing in held]
    inside = container and not relations.is_shallow(usual) and "in" in kinds
    if inside:
        sizes = [relations.put_in_size(thing, usual) for thing in held]
        if len(sizes) > 2 and all(
            x > _MIN_WIDTH < y and z < _FLAT * min(x, y) for x, y, z in sizes
        ):
            sizes = [(z, max(x, y), min(x, y)) for x, y, z in sizes]  # filed on edge
    area = sum(float(size[0] * size[1]) for size in sizes)
    tall = all(size[2] > max(*size[:2], 0.6 * usual[2]) for size in sizes)  # cannot form layers
    filled = _FILLED * (_LAYERS if len(held) > 3 and not tall else 1.0)
    room = usual[0] * usual[1] * (filled if inside else _COVERED)
    needed = float(np.sqrt(area / room)) if len(held) > 1 else 1.0
    if inside and tall:  # the layout determines small growth
        needed = _across(sizes, planned) / min(usual[:2])
        needed = needed if needed > _LITTLE else 1.0
    for factor in np.linspace(1.0, most, 16):
        extent = (usual[0] * factor, usual[1] * factor, usual[2] * factor)
        fit = all(
            relations.fits("in" if inside else "on", size, extent, container) for size in sizes
        )
        if factor >= needed and fit:
            return float(factor)
    fitting = [
        factor
        for factor in np.linspace(1.0, most, 16)
        if any(
            relations.fits("in" if inside else "on", size, tuple(factor * s for s in usual),
                           container)
            for size in sizes
        )
    ]  # fmt: skip
    return float(most if fitting else 1.0)


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
"""The category that a bare word means, given the category of its contents."""


_POTTED = frozenset(
    ["cactus", "succulent", "herb_pot", "potted_plant", "fern", "ivy", "aloe", "lavender",
     "plant", "basil", "mint", "orchid", "snake_plant", "spider_plant"]
)  # fmt: skip
LOOSE: Mapping[str, str] = MappingProxyType({"chips_bag": "potato_crisp"})
"""Packages of food, and the category of their contents when in a bowl."""
_CANDLES = frozenset({"candle", "taper_candle", "long_candle"})
_SOCKETS = frozenset({"empty_candlestick", "empty_candelabra"})
_FLOWERS = ("rose", "tulip", "daisy", "carnation")


def cut_category(category: str, vessel: str, number: int) -> str:
    """Return the category that an object has in a vessel, such as cut flowers in a vase.

    ``number`` is the object's index among the vessel's contents.
    """
    if open_category(vessel) == "empty_vase":
        if category == "vase":  # "flowers" has this category too
            return _FLOWERS[number % len(_FLOWERS)]
        return "posy" if category == "bouquet" else category
    if category in _POTTED and open_category(vessel) == "plant_pot":
        return "bare_cactus" if category == "cactus" else "seedling"
    if is_lit(category, vessel):
        return "long_candle"
    return category


def is_lit(category: str, vessel: str) -> bool:
    """Return whether an object is a candle for which the vessel has a socket."""
    return category in _CANDLES and open_category(vessel) in _SOCKETS


def open_category(category: str, noun: str = "", contents: str = "") -> str:
    """Return a category's open form, given the object's ``noun`` and the category ``contents``."""
    known = CATEGORIES.get(category)
    usual = known.opened if known is not None and known.opened else category
    return _MEANT.get((noun, contents), usual)
