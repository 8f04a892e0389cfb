"""Stand-ins: plain objects of roughly the right shape and size for unknown categories.

Each stand-in belongs to a family ("appliance", "garment", "rod"). Many families use a similar
category of the catalogue; the others are plain solids.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.catalogue import model_of
from tabletop_objects.kit import surfaces
from tabletop_objects.kit.parts import box_part, cylinder_part, hull_of, resting_ball
from tabletop_objects.kit.shapes import Category, Shape, shape
from tabletop_objects.kit.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from tabletop_objects.kit.surfaces import Look, size_factor, tint_color
from tabletop_objects.values import Extent

from .scene import Model

GENERIC = "generic"
"""The category of a stand-in."""

_DENSITY = 400.0  # kg/m^3


@dataclass(frozen=True)
class Family:
    """A kind of stand-in.

    Attributes:
        size: typical extent (length x, depth y, height z) in metres, for families with a plain
            solid.
        make: builds the plain solid, in metres.
        like: the catalogue category that is used instead.
    """

    size: Extent = (0.1, 0.08, 0.09)
    make: Callable[[Look], Shape] | None = None
    like: str | None = None

    @property
    def extent(self) -> Extent:
        """The usual extent of a stand-in of this family, in metres."""
        return self.size if self.like is None else CATEGORIES[self.like].size

    @property
    def container(self) -> bool:
        """Whether other objects can be placed inside the stand-in."""
        return self.like is not None and CATEGORIES[self.like].container


def build_stand_in(
    family: str,
    label: str,
    seed: int,
    attributes: Mapping[str, str] = MappingProxyType({}),
    size: Extent | None = None,
) -> Model:
    """Return a model of a stand-in family, marked as a stand-in.

    An empty or unknown ``family`` gives a plain block. ``size`` is the extent in metres; None uses
    the family's extent and the attribute "size".
    """
    kind = FAMILIES.get(family, FAMILIES["block"])
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 5])
    look = Look(rng, attributes)
    if kind.make is None:
        model = model_of(CATEGORIES[str(kind.like)], look)
        if size is not None:
            model = replace(model, size=model.size * (max(size) / float(model.size.max())))
    else:
        mass = float(np.clip(_DENSITY * np.prod(size or kind.size), 0.005, 5.0))
        category = Category(GENERIC, kind.make, size=size or kind.size, mass=mass, friction=0.7)
        model = model_of(category, look, size)
    return replace(model, name=GENERIC, label=label, category=GENERIC, stand_in=True)


def stand_in_size(family: str, attributes: Mapping[str, str] = MappingProxyType({})) -> Extent:
    """Return the expected extent, in metres, of a stand-in of a family."""
    x, y, z = FAMILIES.get(family, FAMILIES["block"]).extent
    factor = size_factor(attributes)
    return x * factor, y * factor, z * factor


# ------------------------------------------------------------------------------------- solids


def _block(look: Look) -> Shape:
    tile = look.surface(look.color("gray", "tan", "teal", "navy", "terracotta", "olive", "mustard"))
    x, y, z = FAMILIES["block"].size
    return shape([(block(x, y, z, 0.006, 0.003), tile)], [box_part(x, y, z)])


def _appliance(look: Look) -> Shape:
    """A cabinet on feet with a door, a handle and two knobs."""
    x, y, z = FAMILIES["appliance"].size
    color = look.color("white", "silver", "charcoal", "cream")
    case = block(x, y, z - 0.01, 0.015, 0.008).move(z=0.01)
    feet = join([cylinder(0.014, 0.012, 12).move(a * 0.4 * x, b * 0.38 * y)
                 for a in (-1, 1) for b in (-1, 1)])  # fmt: skip
    door = box(0.68 * x, 0.006, 0.7 * z).move(-0.12 * x, -y / 2, 0.15 * z)
    handle = box(0.5 * x, 0.016, 0.018).move(-0.12 * x, -y / 2 - 0.006, 0.72 * z)
    knobs = join([cylinder(0.018, 0.018, 16).turn(0, np.pi / 2).move(0.36 * x, -y / 2, k * z)
                  for k in (0.42, 0.66)])  # fmt: skip
    dark = surfaces.plain((46, 48, 52))
    return shape(
        [(case, look.surface(color)), (feet, dark), (door, dark),
         (handle, look.surface(tint_color(color, 0.8))), (knobs, dark)],
        [box_part(x, y, z)],
    )  # fmt: skip


def _device(look: Look) -> Shape:
    """A flat case with a dark panel and a row of buttons."""
    x, y, z = FAMILIES["device"].size
    color = look.color("charcoal", "gray", "white", "navy")
    case = block(x, y, z, 0.008, 0.005)
    panel = box(0.55 * x, 0.003, 0.5 * z).move(-0.15 * x, -y / 2, 0.28 * z)
    buttons = join([cylinder(0.007, 0.006, 12).turn(0, np.pi / 2).move(0.3 * x, -y / 2, k * z)
                    for k in (0.3, 0.5, 0.7)])  # fmt: skip
    return shape(
        [(case, look.surface(color)), (panel, surfaces.plain((40, 96, 110))),
         (buttons, surfaces.plain(tint_color(color, 1.5)))],
        [box_part(x, y, z)],
    )  # fmt: skip


def _rod(look: Look) -> Shape:
    """A rod lying on its side."""
    x, y, _ = FAMILIES["rod"].size
    stick = cylinder(y / 2, x, 20, bevel=0.002).turn(1, np.pi / 2).move(-x / 2, 0, y / 2)
    return shape(
        [(stick, look.surface(look.color("brown", "tan", "charcoal"), "wood"))],
        [box_part(x, 0.8 * y, y)],
    )


def _drum(look: Look) -> Shape:
    """An upright cylinder with two rims."""
    x, _, z = FAMILIES["drum"].size
    color = look.color("crimson", "navy", "teal", "tan")
    rims = join([torus(x / 2 - 0.006, 0.006).move(z=k) for k in (0.006, z - 0.006)])
    skin = surfaces.plain((236, 228, 208))
    return shape(
        [(cylinder(x / 2 - 0.004, z - 0.004, 32), look.surface(color)), (rims, skin)],
        [cylinder_part(x / 2, z)],
    )


def _keys(look: Look) -> Shape:
    """A case with black and white keys."""
    x, y, z = FAMILIES["keyed"].size
    case = block(x, y, 0.7 * z, 0.008, 0.004)
    whites = [box(0.9 * x / 15 - 0.002, 0.55 * y, 0.3 * z)
              .move(0.9 * x * (k - 7) / 15, -0.18 * y, 0.7 * z) for k in range(15)]  # fmt: skip
    blacks = [box(0.03 * x, 0.3 * y, 0.2 * z).move(0.9 * x * (k - 6.5) / 15, -0.05 * y, 0.95 * z)
              for k in range(14) if k % 7 not in (2, 6)]  # fmt: skip
    return shape(
        [(case, look.surface(look.color("charcoal", "walnut", "navy"))),
         (join(whites), surfaces.plain((244, 242, 236))),
         (join(blacks), surfaces.plain((30, 30, 32)))],
        [box_part(x, y, z)],
    )  # fmt: skip


def _furniture(look: Look) -> Shape:
    """A small stool."""
    x, y, z = FAMILIES["furniture"].size
    seat = block(x, y, 0.14 * z, 0.01, 0.004).move(z=0.86 * z)
    legs = join([box(0.1 * x, 0.1 * y, 0.88 * z).move(a * 0.4 * x, b * 0.4 * y)
                 for a in (-1, 1) for b in (-1, 1)])  # fmt: skip
    tile = look.surface(look.color("brown", "tan"), "wood")
    return shape([(seat, tile), (legs, tile)], [box_part(x, y, z)])


def _food(palette: tuple[str, ...], family: str) -> Callable[[Look], Shape]:
    """Return a builder for a rounded piece of food with a flat base."""

    def make(look: Look) -> Shape:
        x, y, z = FAMILIES[family].size
        color = look.color(*palette)
        lump = ellipsoid(x, y, 1.3 * z, 28, 16).move(z=0.35 * z)
        skin = surfaces.spots(look.rng, color, tint_color(color, 0.82), 0.15)
        return shape([(lump, skin)], [hull_of(shape([(lump, skin)], []).pieces[0].solid)])

    return make


def _fruit(look: Look) -> Shape:
    x, y, z = FAMILIES["fruit"].size
    color = look.color("green", "orange", "crimson", "purple", "yellow")
    body = ellipsoid(x, y, z, 28, 18).move(z=z / 2)
    stalk = tube([(0, 0, 0.95 * z), (0.004, 0, 1.12 * z)], 0.003, 8)
    brown = surfaces.plain((98, 74, 48))
    return shape(
        [(body, surfaces.speckles(look.rng, color, 3)), (stalk, brown)], [resting_ball(x, y, z)]
    )


def _slab(look: Look) -> Shape:
    """A slice or a block of food."""
    x, y, z = FAMILIES["slab"].size
    color = look.color("cream", "salmon", "brown", "crimson")
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.85), 0.2)
    return shape([(block(x, y, z, 0.02, 0.005), tile)], [box_part(x, y, z)])


def _lump(look: Look) -> Shape:
    """An uneven stone."""
    x, y, z = FAMILIES["lump"].size
    color = look.color("gray", "tan", "charcoal")
    waves = look.rng.uniform(0, 2 * np.pi, 3)

    def dent(points: np.ndarray) -> np.ndarray:
        angle = np.arctan2(points[:, 1], points[:, 0])
        factor = 1 + 0.08 * np.sin(3 * angle + waves[0]) + 0.05 * np.sin(5 * angle + waves[1])
        return points * np.column_stack([factor, factor, np.ones(len(points))])

    stone = ellipsoid(x, y, 1.25 * z, 30, 16).bend(dent).move(z=0.375 * z)
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.3)
    pressed = shape([(stone, tile)], []).pieces[0].solid
    return shape([(pressed, tile)], [hull_of(pressed)])


def _part(look: Look) -> Shape:
    """A small metal piece: a disc with a hub."""
    x, _, z = FAMILIES["part"].size
    wheel = cylinder(x / 2, 0.5 * z, 24, bevel=0.001)
    hub = cylinder(0.22 * x, z, 20, bevel=0.001)
    tile = look.surface(look.color("silver", "brass", "gray"), "steel")
    return shape([(wheel, tile), (hub, tile)], [cylinder_part(x / 2, z)])


def _coil(look: Look) -> Shape:
    """A coiled rope."""
    x, _, z = FAMILIES["coil"].size
    r = z / 4
    rings = join([torus(x / 2 - r, r).move(z=r), torus(x / 2 - 1.15 * r, r).move(0.002, 0, 3 * r)])
    tile = look.surface(look.color("tan", "charcoal", "orange", "navy"), "fabric")
    return shape([(rings, tile)], [cylinder_part(x / 2, z)])


def _bag(look: Look) -> Shape:
    """A soft bag with two handles."""
    x, y, z = FAMILIES["bag"].size
    color = look.color("brown", "navy", "olive", "crimson", "charcoal")
    body = lathe([(0, 0), (0.5, 0), (0.52, 0.35), (0.4, 0.72), (0, 0.74)], 28).scale(x, y, z)
    angles = np.linspace(0, np.pi, 12)
    bow = np.column_stack([0.2 * x * np.cos(angles), 0 * angles, (0.7 + 0.27 * np.sin(angles)) * z])
    handles = join([tube(bow, 0.006, 8).move(y=k * 0.1 * y) for k in (-1, 1)])
    tile = look.surface(color, "fabric")
    return shape([(body, tile), (handles, tile)], [hull_of(body)])


def _sweet(look: Look) -> Shape:
    x, y, z = FAMILIES["sweet"].size
    color = look.color("pink", "crimson", "brown", "yellow", "teal")
    drop = ellipsoid(x, y, z, 24, 14).move(z=z / 2)
    return shape([(drop, surfaces.plain(color))], [resting_ball(x, y, z)])


FAMILIES: Mapping[str, Family] = MappingProxyType(
    {
        "appliance": Family((0.34, 0.28, 0.28), _appliance),
        "bag": Family((0.26, 0.14, 0.24), _bag),
        "ball": Family(like="ball"),
        "basket": Family(like="basket"),
        "block": Family(make=_block),
        "board": Family(like="cutting_board"),
        "book": Family(like="book"),
        "bottle": Family(like="bottle"),
        "bowl": Family(like="bowl"),
        "box": Family(like="box"),
        "bread": Family((0.11, 0.1, 0.06), _food(("tan", "mustard", "brown"), "bread")),
        "cloth": Family(like="folded_towel"),
        "coil": Family((0.16, 0.16, 0.04), _coil),
        "coin": Family(like="coins"),
        "condiment": Family(like="sauce_bottle"),
        "cup": Family(like="mug"),
        "device": Family((0.22, 0.16, 0.09), _device),
        "drink": Family(like="glass"),
        "drum": Family((0.22, 0.22, 0.16), _drum),
        "figurine": Family(like="figurine"),
        "flower": Family(like="vase"),
        "frame": Family(like="picture_frame"),
        "fruit": Family((0.075, 0.075, 0.07), _fruit),
        "furniture": Family((0.24, 0.24, 0.22), _furniture),
        "hat": Family(like="hat"),
        "jar": Family(like="jar"),
        "keyed": Family((0.6, 0.22, 0.07), _keys),
        "lamp": Family(like="desk_lamp"),
        "lump": Family((0.09, 0.07, 0.05), _lump),
        "meal": Family(like="soup"),
        "medicine": Family(like="pill_bottle"),
        "packet": Family(like="flour_bag"),
        "part": Family((0.04, 0.04, 0.018), _part),
        "plant": Family(like="potted_plant"),
        "plate": Family(like="plate"),
        "pot": Family(like="pot"),
        "ring": Family(like="ring"),
        "rod": Family((0.26, 0.022, 0.022), _rod),
        "screen": Family(like="monitor"),
        "sheet": Family(like="paper_stack"),
        "shoe": Family(like="shoe"),
        "slab": Family((0.12, 0.08, 0.035), _slab),
        "spice": Family(like="pepper_shaker"),
        "stringed": Family(like="violin"),
        "sweet": Family((0.035, 0.03, 0.022), _sweet),
        "tin": Family(like="can"),
        "tool": Family(like="screwdriver"),
        "toy": Family(like="puzzle_cube"),
        "vehicle": Family(like="toy_car"),
    }
)
"""All families by name, including those of ``generator/language/words/nouns.tsv``."""
