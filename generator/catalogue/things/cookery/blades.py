"""Knives and servers lying flat: chef's, bread, steak, butter and cheese knives, cleavers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder, join, prism, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GRIPS = ("black", "wooden", "charcoal", "brown", "white", "red", "teal")
Outline = list[tuple[float, float]]


def _knife(look: Look, long: float, wide: float, share: float, outline: Outline, *,
           metal: float = 0.2, teeth: int = 0, thick: float = 0.016) -> Shape:  # fmt: skip
    """Return a knife, its blade to the left.

    ``outline`` runs from the blade's tip along its edge and back along its spine, as shares of the
    blade's length (from the tip) and of ``wide`` (below the middle negative).
    """
    steel = look.surface(look.own_color("silver", "silver", "gray"), "metal")
    all_metal = look.chance(metal)
    color = look.color("silver", "gold") if all_metal else look.color(*GRIPS)
    tile = look.surface(color, "metal" if all_metal else look.pick(["plastic", "wood"]))
    tip, cut = -0.5 * long, -0.5 * long + share * long
    points = [(tip + u * share * long, v * wide) for u, v in outline]
    if teeth:
        low = [p for p in points if p[1] < 0]
        start, end = low[0][0], low[-1][0]
        saw = [(start + (end - start) * n / (2 * teeth), low[-1][1] + (0.05 * wide if n % 2 else 0))
               for n in range(2 * teeth + 1)]  # fmt: skip
        points = [p for p in points if p not in low[:-1]][:1] + saw + [
            p for p in points if p[1] >= 0][1 if points[0][1] >= 0 else 0 :]  # fmt: skip
    blade = prism(np.array(points), 0.0005, 0.0025)
    width = min(0.62 * wide, 0.026) if wide > 0.024 else 0.8 * wide
    grip = block(0.5 * long - cut, max(width, 0.012), thick, 0.4 * width, 0.22 * thick)
    grip = grip.move(x=cut + (0.5 * long - cut) / 2)
    pieces = [(blade, steel), (grip, tile)]
    if not all_metal:
        rivets = [cylinder(0.0026, thick + 0.0005, 10).move(x=cut + u * (0.5 * long - cut))
                  for u in (0.25, 0.5, 0.75)]  # fmt: skip
        pieces.append((join(rivets), textures.plain((206, 200, 184))))
    return settle(pieces, 0.02, hulls=[[0], [1]])


def chef_knife(look: Look) -> Shape:
    """A broad kitchen knife with a curved edge."""
    outline = [(0, 0.3), (0.12, 0.02), (0.35, -0.32), (0.65, -0.5), (1, -0.5), (1, 0.5), (0.3, 0.5)]
    return _knife(look, look.between(0.29, 0.33), look.between(0.042, 0.048), 0.6, outline)


def bread_knife(look: Look) -> Shape:
    """A long knife with a toothed edge."""
    outline = [(0, 0.2), (0.04, -0.4), (1, -0.5), (1, 0.5), (0.08, 0.5)]
    return _knife(look, look.between(0.31, 0.35), look.between(0.027, 0.032), 0.62, outline,
                  teeth=18)  # fmt: skip


def steak_knife(look: Look) -> Shape:
    """A slim pointed table knife with a handle of wood or plastic."""
    outline = [(0, 0.45), (0.15, -0.1), (0.35, -0.45), (1, -0.5), (1, 0.4), (0.4, 0.5)]
    return _knife(look, look.between(0.21, 0.235), 0.02, 0.52, outline, metal=0.1, thick=0.013)


def paring_knife(look: Look) -> Shape:
    """A small pointed kitchen knife."""
    outline = [(0, 0.4), (0.2, -0.1), (0.5, -0.45), (1, -0.5), (1, 0.5), (0.3, 0.5)]
    return _knife(look, look.between(0.17, 0.2), 0.021, 0.45, outline, metal=0.05, thick=0.013)


def butter_knife(look: Look) -> Shape:
    """A short blunt knife with a round broad blade."""
    outline = [(0, 0.1), (0.03, -0.3), (0.14, -0.5), (0.6, -0.45), (1, -0.2), (1, 0.2), (0.7, 0.3),
               (0.3, 0.5), (0.06, 0.42)]  # fmt: skip
    return _knife(look, look.between(0.15, 0.18), 0.024, 0.48, outline, metal=0.8, thick=0.008)


def cleaver(look: Look) -> Shape:
    """A heavy rectangular chopping knife with a hole in its corner."""
    long, wide = look.between(0.28, 0.31), look.between(0.075, 0.09)
    steel = look.surface(look.own_color("silver", "gray"), "metal")
    tile = look.surface(look.color("wooden", "black", "brown", "wooden"), "wood")
    cut = 0.1 * long
    blade = prism(
        np.array(
            [
                (-0.5, -0.5),
                (0.08, -0.5),
                (0.1, -0.2),
                (0.1, 0.42),
                (0.06, 0.5),
                (-0.48, 0.5),
                (-0.5, 0.46),
            ]
        )
        * [long, wide],
        0.001,
        0.0045,
    )
    hole = cylinder(0.005, 0.0055, 14).move(-0.45 * long, 0.36 * wide)
    x = 0.5 * long - cut
    grip = block(x, 0.026, 0.02, 0.008, 0.004).move(x=cut + x / 2, y=0.2 * wide)
    grip = grip.move(z=-0.0078)
    rivets = join([cylinder(0.003, 0.0206, 10).move(cut + u * x, 0.2 * wide, -0.0081)
                   for u in (0.25, 0.5, 0.75)])  # fmt: skip
    return settle(
        [
            (blade, steel),
            (hole, textures.plain((70, 66, 60))),
            (grip, tile),
            (rivets, textures.plain((206, 200, 184))),
        ],
        0.36,
        hulls=[[0], [2]],
    )


def cake_server(look: Look) -> Shape:
    """A triangular server, its blade to the left, its handle raised."""
    long, wide = look.between(0.23, 0.27), look.between(0.055, 0.068)
    color = look.color("silver", "gold", "silver", "copper")
    steel = look.surface(color, "metal")
    cut = -0.04 * long
    plate = prism(np.array([(-0.5 * long, -0.004), (cut, -wide / 2), (cut + 0.012, -0.3 * wide),
                            (cut + 0.012, 0.3 * wide), (cut, wide / 2), (-0.5 * long, 0.004)]), 0,
                  0.002)  # fmt: skip
    neck = tube([(cut, 0, 0.002), (cut + 0.022, 0, 0.009), (cut + 0.05, 0, 0.011)], 0.004, 8)
    x = 0.5 * long - cut - 0.04
    grip = block(x, 0.018, 0.011, 0.008, 0.003).turn(1, 0.04).move(cut + 0.04 + x / 2, 0, 0.0055)
    sleeve = steel if look.chance(0.4) else look.surface(
        look.own_color("white", "black", "wooden", "sky"), "wood")  # fmt: skip
    end = min(float(grip.bounds[0, 2]), 0.0055)
    grip = grip.move(z=-end + 0.0002).turn(1, 0.0)
    return shape([(plate, steel), (neck, steel), (grip, sleeve)],
                 [hull_of(plate), hull_of(grip)])  # fmt: skip


def cheese_knife(look: Look) -> Shape:
    """A forked cheese knife with holes in its blade."""
    outline = [(0, 0.5), (0.1, 0.2), (0.02, 0.0), (0.16, -0.3), (0.4, -0.5), (1, -0.4), (1, 0.35),
               (0.4, 0.3), (0.12, 0.52)]  # fmt: skip
    long = look.between(0.2, 0.235)
    made = _knife(look, long, 0.03, 0.55, outline, metal=0.3, thick=0.013)
    hole = cylinder(0.0045, 0.0024, 14)
    holes = [hole.scale(1.4, 1, 1).move((-0.5 + u) * long, -0.001, 0.0005) for u in (0.2, 0.3, 0.4)]
    return shape(
        [
            *((p.solid, p.tile) for p in made.pieces),
            (join(holes), textures.plain(tint_color((120, 116, 110), 0.9))),
        ],
        made.parts,
    )


_K = ("kitchen",)
CATEGORIES = (
    Category("chef_knife", chef_knife, (0.314, 0.0454, 0.016), 0.2, ("chef's knife", "chefs knife",
             "kitchen knife", "santoku", "cooking knife", "carving knife", "chopping knife",
             "santoku knife", "sashimi knife", "bloody knife", "bloody knife prop", "prop knife",
             "fake knife"), _K, ("flat",), ("black", "wooden"),
             state="lying flat"),
    Category("bread_knife", bread_knife, (0.327, 0.0299, 0.016), 0.15, ("serrated knife",
             "cake knife"), _K, ("flat",), ("black", "wooden"), state="lying flat"),
    Category("steak_knife", steak_knife, (0.226, 0.02, 0.0132), 0.07, (), ("dining",), ("flat",),
             ("black", "wooden"), state="lying flat"),
    Category("paring_knife", paring_knife, (0.185, 0.021, 0.0132), 0.06, ("fruit knife",
             "vegetable knife"), _K, ("flat",), ("black",), state="lying flat"),
    Category("butter_knife", butter_knife, (0.165, 0.024, 0.0079), 0.05, ("butter spreader",
             "spreader", "cheese spreader"), ("dining", "breakfast"), ("flat",), ("silver",),
             state="lying flat"),
    Category("cleaver", cleaver, (0.299, 0.0808, 0.0132), 0.4, ("meat cleaver", "butcher knife",
             "butcher's knife", "chinese cleaver"), _K, ("flat",), ("wooden",), state="lying flat"),
    Category("cake_server", cake_server, (0.255, 0.062, 0.015), 0.09, ("pie server", "cake slicer",
             "cake lifter", "pie slice server", "pizza server", "cake spatula"), ("dining",),
             ("flat",), ("silver", "gold"), state="lying flat"),
    Category("cheese_knife", cheese_knife, (0.217, 0.0306, 0.013), 0.07, ("cheese cutter",),
             ("dining",), ("flat",), ("silver",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
