"""Objects of the ``kitchen`` theme: knives."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import arc
from ...kit.parts import hull_of
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, settle, shape
from ...kit.solids import block, cylinder, join, lathe, prism
from ...kit.surfaces import RGB, Look, tint_color
from ...values import Holder
from ..dining.cutlery import _knife
from .appliances import metal
from .racks import PLAY, _boards, centres, choose_slots, read_request
from .utensils import steel, with_handle


@category("chef_knife", size=(0.314, 0.0454, 0.016), mass=0.2, material="metal",
          aliases=("chef's knife", "chefs knife", "kitchen knife", "santoku", "cooking knife",
          "carving knife", "chopping knife", "santoku knife", "sashimi knife", "bloody knife",
          "bloody knife prop", "prop knife", "fake knife"), themes=("kitchen",), roles=("flat",),
          colors=("black", "wooden"), state="lying flat")  # fmt: skip
def chef_knife(look: Look) -> Shape:
    """A broad kitchen knife with a curved edge."""
    outline = [(0, 0.3), (0.12, 0.02), (0.35, -0.32), (0.65, -0.5), (1, -0.5), (1, 0.5), (0.3, 0.5)]
    return _knife(look, look.between(0.29, 0.33), look.between(0.042, 0.048), 0.6, outline)


@category("bread_knife", size=(0.327, 0.0299, 0.016), mass=0.15, material="metal",
          aliases=("serrated knife", "cake knife"), themes=("kitchen",), roles=("flat",),
          colors=("black", "wooden"), state="lying flat")  # fmt: skip
def bread_knife(look: Look) -> Shape:
    """A long knife with a toothed edge."""
    outline = [(0, 0.2), (0.04, -0.4), (1, -0.5), (1, 0.5), (0.08, 0.5)]
    return _knife(look, look.between(0.31, 0.35), look.between(0.027, 0.032), 0.62, outline,
                  teeth=18)  # fmt: skip


@category("paring_knife", size=(0.185, 0.021, 0.0132), mass=0.06, material="metal",
          aliases=("fruit knife", "vegetable knife"), themes=("kitchen",), roles=("flat",),
          colors=("black",), state="lying flat")  # fmt: skip
def paring_knife(look: Look) -> Shape:
    """A small pointed kitchen knife."""
    outline = [(0, 0.4), (0.2, -0.1), (0.5, -0.45), (1, -0.5), (1, 0.5), (0.3, 0.5)]
    return _knife(look, look.between(0.17, 0.2), 0.021, 0.45, outline, metal=0.05, thick=0.013)


@category("cleaver", size=(0.299, 0.0808, 0.0132), mass=0.4, material="metal",
          aliases=("meat cleaver", "butcher knife", "butcher's knife", "chinese cleaver"),
          themes=("kitchen",), roles=("flat",), colors=("wooden",), state="lying flat")  # fmt: skip
def cleaver(look: Look) -> Shape:
    """A heavy, rectangular cleaver with a hole in its corner."""
    long, wide = look.between(0.28, 0.31), look.between(0.075, 0.09)
    steel = look.surface(look.own_color("silver", "gray"), "metal")
    tile = look.surface(look.color("wooden", "black", "brown", "wooden"), "wood")
    cut = 0.1 * long
    blade = prism(np.array([(-0.5, -0.5), (0.08, -0.5), (0.1, -0.2), (0.1, 0.42), (0.06, 0.5),
                            (-0.48, 0.5), (-0.5, 0.46)]) * [long, wide], 0.001, 0.0045)  # fmt: skip
    hole = cylinder(0.005, 0.0055, 14).move(-0.45 * long, 0.36 * wide)
    x = 0.5 * long - cut
    grip = block(x, 0.026, 0.02, 0.008, 0.004).move(x=cut + x / 2, y=0.2 * wide)
    grip = grip.move(z=-0.0078)
    rivets = join([cylinder(0.003, 0.0206, 10).move(cut + u * x, 0.2 * wide, -0.0081)
                   for u in (0.25, 0.5, 0.75)])  # fmt: skip
    return settle([(blade, steel), (hole, surfaces.plain((70, 66, 60))), (grip, tile),
                   (rivets, surfaces.plain((206, 200, 184)))], 0.36, hulls=[[0], [2]])  # fmt: skip


STEEL: RGB = (188, 192, 198)


def _long_rod(look: Look, color: RGB, z: float) -> Pieces:
    rod = (lathe([(0, 0), (0.006, 0), (0.006, 0.2), (0.002, 0.215), (0, 0.215)],
                 16).turn(1, -np.pi / 2).move(0, 0, z))  # fmt: skip
    guard = cylinder(0.013, 0.005, 16).turn(1, -np.pi / 2).move(0.004, 0, z)
    return [(rod, surfaces.stripes([STEEL, tint_color(STEEL, 0.7)], 10, upright=True)),
            (guard, steel(look))]  # fmt: skip


@category("mezzaluna", size=(0.203, 0.126, 0.0241), mass=0.25, material="metal",
          aliases=("herb chopper", "rocking knife", "herb cutter", "half moon knife"),
          themes=("kitchen",), colors=("wooden",), state="lying flat")  # fmt: skip
@keep_still
def mezzaluna(look: Look) -> Shape:
    """A mezzaluna lying flat: a half-moon blade with a knob at each end."""
    k, color = look.between(0.88, 1.1), look.color("wooden", "black", "brown", "red")
    outer, inner = (arc((0, 0), 0.1, np.pi + 0.35, 2 * np.pi - 0.35, 16),
                    arc((0, 0.02), 0.088, 2 * np.pi - 0.42, np.pi + 0.42, 16))  # fmt: skip
    blade = prism(np.concatenate([outer, inner]), 0, 0.002).move(z=0.012)
    knobs = [lathe([(0, 0), (0.006, 0.002), (0.011, 0.02), (0.013, 0.05), (0.008, 0.062),
                    (0, 0.064)], 16).turn(0, -np.pi / 2).move(s * 0.09, -0.036, 0.013)
             for s in (-1, 1)]  # fmt: skip
    made = [(blade, metal(look, (206, 210, 214))), (join(knobs), look.surface(color, "wood"))]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.06, hulls=[[0], [1]])


def _twin_blade(look: Look, color: RGB, z: float) -> Pieces:
    blade = prism(
        [(0.01, -0.012), (0.01, 0.012), (-0.19, 0.008), (-0.2, 0.0), (-0.19, -0.01)], 0, 0.003
    )
    return [(blade.move(z=z - 0.0015), steel(look))]


@category("empty_knife_block", size=(0.127, 0.057, 0.155), mass=1.2, material="wood",
          aliases=("empty knife holder",), themes=("kitchen",), roles=("tall",), colors=("wooden",),
          holder=Holder("end", (0.04, 0.09, 0.38)))  # fmt: skip
def empty_knife_block(look: Look) -> Shape:
    """An empty wooden knife block with slots."""
    count, (a, b, c) = read_request(look, 5, (0.014, 0.04, 0.25))
    skin = look.surface(look.color("wooden", "brown", "black", "tan", "white"), "wood")
    wall, floor, h = 0.007, 0.012, 0.62 * c
    cells, pitch = max(count, 3), a + PLAY + wall
    x, y = cells * pitch + wall, b + PLAY
    boards = [(x, y + 2 * wall, floor, 0.0, 0.0, 0.0)]
    boards += [(wall, y, h - floor, u, 0.0, floor) for u in centres(cells + 1, pitch)]
    boards += [(x, wall, h - floor, 0.0, s * (y + wall) / 2, floor) for s in (-1, 1)]
    solids, parts = _boards(boards)
    slots = choose_slots(centres(cells, pitch), count, floor)
    return shape([(join(solids), skin)], parts, slots=slots)


@category("knife_block", size=(0.108, 0.188, 0.278), mass=2.2, material="wood", assembled=True,
          aliases=("knife holder", "block of knives", "knife set", "knife stand"),
          themes=("kitchen",), roles=("tall", "big"), colors=("wooden",),
          opened="empty_knife_block")  # fmt: skip
def knife_block(look: Look) -> Shape:
    """A slanted wooden knife block with knife handles sticking out."""
    x, y, h = look.between(0.1, 0.12), look.between(0.13, 0.15), look.between(0.2, 0.23)
    color = look.color("wooden", "brown", "black", "tan", "white")
    skin = look.surface(color, "wood")
    side = np.array([(-0.5 * y, 0), (0.5 * y, 0), (0.62 * y, 0.62 * h), (0.02 * y, h),
                     (-0.28 * y, 0.86 * h)])  # fmt: skip
    body = prism(side, -x / 2, x / 2).turn(0, np.pi / 2).turn(2, np.pi / 2)
    dark = look.surface(look.own_color("black", "black", "charcoal", "brown", "silver"), "plastic")
    grips, studs = [], []
    for u, long in ((0.24, 0.11), (0.5, 0.1), (0.76, 0.09)):
        for j in (-1, 0, 1):
            at = np.array([0.02, 1.0]) * (1 - u) + np.array([0.62, 0.62]) * u
            grip = block(0.019, 0.014, long, 0.006, 0.003).turn(0, -0.55)
            spot = (j * 0.3 * x, at[0] * y, at[1] * h - 0.012)
            grips.append(grip.move(*spot))
            stud = cylinder(0.0025, 0.02, 8).turn(1, np.pi / 2).move(x=-0.01)
            studs.append(stud.move(spot[0], spot[1] + 0.03, spot[2] + 0.045))
    sharp = [hull_of(*grips[3 * k : 3 * k + 3]) for k in range(3)]
    return shape(
        [(body, skin), (join(grips), dark), (join(studs), surfaces.plain((200, 196, 186)))],
        [hull_of(body), *sharp],
    )


CATEGORIES = (
    Category("sharpening_steel", keep_still(with_handle(_long_rod, (0.1, 0.12), 0.0, r=0.011)),
             size=(0.322, 0.0262, 0.0256), mass=0.2, material="plastic",
             aliases=("honing steel", "knife steel", "sharpening rod", "honing rod"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("electric_knife", keep_still(with_handle(_twin_blade, (0.16, 0.19), 0.0, ("white",
             "black", "gray", "red"), 0.02)), size=(0.383, 0.046, 0.0451), mass=0.7,
             material="device", aliases=("electric carving knife", "cordless carving knife"),
             themes=("kitchen",), colors=("white",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
