"""The table of all categories, and how to build from it."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import numpy as np

from ..errors import InputError, choices
from ..scene import Model
from .build.category import Category, model_of
from .surfaces.look import Look
from .things.archive import charts, documents, money
from .things.bakehouse import biscuits, buns, cakes, loaves
from .things.bar import barista, glassware, mixing, openers
from .things.blossoms import sprigs, stems
from .things.cafe import fireside, gear, levant, morsels, service
from .things.celebrations import (
    cardtable,
    dressup,
    garlands,
    hangings,
    headwear,
    partyware,
    yuletide,
)
from .things.chapel import altar, statues, tomes
from .things.chapel import relics as chapel_relics
from .things.circuits import circuits, components, parts
from .things.closet import hats, satchels, shoecare, underwear, vests
from .things.collection import (
    amusements,
    curios,
    dwellings,
    novelties,
    shopfigures,
    showpieces,
    signage,
)
from .things.collection import contraptions as collection_contraptions
from .things.conservatory import foliage
from .things.cookery import (
    blades,
    gadgetry,
    holders,
    machines,
    ovenware,
    paperware,
    serving,
    spoons,
    storage,
    teatime,
)
from .things.creatures import insects
from .things.delicatessen import catch, cheeses, hot, shore, sweetmeats
from .things.electronics import (
    counter,
    desktop,
    devices,
    electronics,
    gadgets,
    handhelds,
    media,
    peripherals,
    players,
    portables,
    stands,
    telephones,
)
from .things.equipment import broadcast, oddments, robots
from .things.fantasy import armoury, sorcery, stationer, studio, washday
from .things.fare import bowls, confections, dishes, meats, pastries, seafood, snacks, sushi
from .things.feast import candies, desserts, fiesta, gums, japanese, mexican, savouries, tubs
from .things.festive import candlelight, characters, christmas, party, seasons
from .things.fixtures import lamps, supports, switches
from .things.food import bakery, food, fruit, groceries, meals, orchard, pantry, produce, sweets
from .things.gaming import boards, casino, chessmen, luck, polyhedra, tabletop
from .things.garage import car, cockpit, engine, gearing
from .things.greengrocer import cuts, globes, halves, heaps, leaves, pods
from .things.grocer import packets, shopfront, slips, tins
from .things.grooming import bath, hair, makeup, shaving, toiletries
from .things.harvest import berries, exotic, greens, nuts, roots
from .things.home import (
    decor,
    dressing,
    figurines,
    garden,
    household,
    keepsakes,
    lights,
    mats,
    open_vessels,
    ornaments,
    plants,
    vanity,
)
from .things.homestead import cleaning, fixtures, plumbing
from .things.ironware import catches, fixings, grinders, plugs, powertools, sawblades
from .things.kitchen import (
    appliances,
    bakeware,
    bottles,
    brewing,
    cooking,
    cups,
    cutlery,
    dining,
    racks,
    utensils,
)
from .things.lab import apparatus, checkup, clinic, firstaid, glass, lab, surgery
from .things.larder import boxes, condiments, jars, packs, preserves
from .things.leftovers import rubbish
from .things.leisure import (
    blocks,
    boardgames,
    gamepieces,
    games,
    leisure,
    maps,
    optics,
    playthings,
    toys,
)
from .things.minerals import fossils, gems, specimens
from .things.museum import relics, stones
from .things.music import instruments, music, percussion
from .things.nature import finds, flowers, gardening, greenery, posies
from .things.nursery import animals, baby, dinosaurs, play, vehicles
from .things.occasions import barware, ceremony, eastertide, refreshment, stationery
from .things.office import (
    cards,
    clips,
    desk,
    deskware,
    office,
    organizers,
    paper,
    printed,
    school,
    supplies,
    writing,
)
from .things.orchestra import beats, bellows, stagegear, strings, winds
from .things.parlour import candleholders, keepers, slotted, smoking
from .things.pastimes import (
    bicycle,
    cycling,
    exercise,
    fishing,
    papercraft,
    pitch,
    skates,
    skill,
    space,
    trimmings,
)
from .things.petshop import aquarium, critters, petcare, petfood, pettoys, reptiles
from .things.science import anatomy, classroom, distilling, labware, observatory, skymodels
from .things.science import gauges as science_gauges
from .things.scullery import (
    contraptions,
    electrics,
    fountains,
    implements,
    makers,
    moulders,
    picks,
    scrapers,
    teaware,
    urns,
)
from .things.sewing import cloths, notions, spreads
from .things.shapes import polyhedra as shapes_polyhedra
from .things.spooky import creatures, graveyard, props, remains
from .things.sports import balls, sports, sportsgear
from .things.tools import (
    benchwork,
    craft,
    cutters,
    fasteners,
    fittings,
    handtools,
    hardware,
    hardware_parts,
    tools,
    workbench,
)
from .things.travel import papers
from .things.upkeep import chores, pets
from .things.ward import aids, dentistry, sickroom
from .things.wardrobe import bags, bathroom, clothes, footwear, garments, gifts, jewelry, trinkets
from .things.workshop import coils, connectors, controls, edges, gauges, panels

_DRAWN_BY_THEME = (
    *(cups, dining, cutlery, brewing, cooking, bottles, pantry, food, bakery),
    *(fruit, produce, groceries, meals, sweets, hardware),
    *(devices, portables, deskware, leisure, ornaments, household),
    *(office, writing, electronics, handhelds, gadgets, decor, plants, keepsakes, lights),
    *(tools, workbench, toys, games, craft, vanity, lab),
    *(paper, maps, mats, clinic, figurines),
)
_ON_REQUEST = (
    appliances, barista, glassware, utensils, openers, bakeware, racks, preserves, condiments,
    packs, boxes, orchard, supplies, clips, organizers, desk, circuits, peripherals, counter,
    telephones, sports, instruments, optics, gifts, clothes, jewelry, garden, dressing, bathroom,
    checkup, fasteners, benchwork, printed, blocks, boardgames, playthings, sportsgear, music,
    media, parts, handtools, hardware_parts, glass, firstaid, school, pastries, confections, meats,
    seafood, sushi, snacks, dishes, bowls, greens, exotic, berries, roots, nuts, serving, blades,
    spoons, gadgetry, ovenware, teatime, storage, paperware, bags, footwear, garments, trinkets,
    finds, flowers, gardening, greenery, posies, candlelight, characters, christmas, party, seasons,
    cloths, notions, bath, hair, makeup, shaving, toiletries, animals, baby, dinosaurs, play,
    vehicles, chores, pets, open_vessels, slotted, candleholders, spreads, machines, mixing, jars,
    gamepieces, balls, percussion, players, components, desktop, stands, cutters, fittings,
    apparatus, surgery, cards, papers, keepers, smoking, holders, stems, sprigs, loaves, buns,
    cakes, cheeses, shore, hot, packets, shopfront, creatures, props, garlands, yuletide, cardtable,
    gear, morsels, fireside, lamps, biscuits, catch, sweetmeats, tins, slips, remains, graveyard,
    hangings, partyware, levant, switches, service, headwear, dressup, globes, pods, cuts, halves,
    leaves, heaps, chessmen, polyhedra, boards, tabletop, casino, luck, critters, reptiles, petcare,
    pettoys, aquarium, petfood, foliage, implements, scrapers, electrics, makers, fountains,
    contraptions, moulders, urns, teaware, candies, gums, desserts, savouries, mexican, japanese,
    tubs, fiesta, ceremony, stationery, eastertide, refreshment, barware, picks, relics, stones,
    insects, bicycle, cycling, fishing, papercraft, trimmings, skates, exercise, pitch, space,
    skill, rubbish, hats, satchels, shoecare, underwear, vests, controls, coils, panels, supports,
    connectors, gauges, edges, cleaning, fixtures, plumbing, robots, broadcast, oddments,
    shapes_polyhedra,
    fossils, gems, specimens, altar, statues, tomes, beats, strings, winds, car, engine, documents,
    money, curios, novelties, fixings, labware, observatory, aids, armoury, studio, powertools,
    cockpit, gearing, charts, amusements, dwellings, shopfigures, showpieces, signage, catches,
    sawblades, anatomy, classroom, science_gauges, dentistry, sickroom, sorcery, stationer, washday,
    chapel_relics, bellows, stagegear, collection_contraptions, grinders, plugs, distilling,
    skymodels,
)  # fmt: skip

FURNISHING = frozenset(c.key for module in _DRAWN_BY_THEME for c in module.CATEGORIES)
"""What a table drawn by theme alone may hold; another one here changes what every seed draws."""

CATEGORIES: Mapping[str, Category] = MappingProxyType(
    {c.key: c for module in (*_DRAWN_BY_THEME, *_ON_REQUEST) for c in module.CATEGORIES}
)
"""Every category by key."""


def category(word: str) -> Category:
    """Return the category with this key, noun or alias (singular, any case).

    Raises:
        InputError: no category has that name.
    """
    found = _words().get(word.lower().replace("_", " ").strip())
    if found is None:
        raise InputError(f"The catalogue has no {word!r}." + choices(word, CATEGORIES))
    return CATEGORIES[found]


@cache
def _words() -> Mapping[str, str]:
    """Return every known word and the key it means; keys win over aliases."""
    words = {alias: c.key for c in reversed(tuple(CATEGORIES.values())) for alias in c.aliases}
    words |= {
        word: c.key for c in CATEGORIES.values() for word in (c.key.replace("_", " "), c.noun)
    }
    return MappingProxyType(words)


def build(
    key: str,
    seed: int,
    *,
    attributes: Mapping[str, str] = MappingProxyType({}),
    size: tuple[float, float, float] | None = None,
) -> Model:
    """Build one variant of a category as a canonical model.

    Args:
        key: a category's key, noun or alias.
        seed: chooses proportions, colours and prints; the same seed gives the same bytes.
        attributes: "color", "material" and "size" words that override the seed's choices, and
            "style": "cartoon" or "low-poly" instead of the plain look.
        size: the extent in metres, if fixed.

    Raises:
        InputError: no category has that name, or the style is unknown.
    """
    found = category(key)
    digest = hashlib.sha256(found.key.encode()).digest()
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, int.from_bytes(digest[:4], "big")])
    return model_of(found, Look(rng, attributes), size)
