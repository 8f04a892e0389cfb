"""Objects of the ``coffee`` theme: cups."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.parts import bowl_parts, box_part, cylinder_part, hull_of, ring_parts
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color
from ..dining.plates import plate
from ..office.cups import drink, handle, handle_part


@category("milkshake", size=(0.0812, 0.0817, 0.23), mass=0.5, material="glass", aliases=("smoothie",
          "milk shake", "glass of milkshake", "frappe", "iced coffee", "root beer float",
          "ice cream float", "coke float"), themes=("coffee",), roles=("tall", "round"),
          colors=("pink",))  # fmt: skip
def milkshake(look: Look) -> Shape:
    """A tall glass of milkshake with cream, a cherry and a straw."""
    r, h = look.between(0.038, 0.044), look.between(0.15, 0.175)
    color = look.color("pink", "brown", "cream", "mint", "orange", "purple", "green")
    clear = surfaces.plain((222, 230, 234))
    body = lathe([(0, 0), (0.75 * r, 0), (0.6 * r, 0.06 * h), (0.68 * r, 0.14 * h),
                  (0.82 * r, 0.5 * h), (r, h), (0, h)], 30,
                 v=[0, 0.01, 0.06, 0.14, 0.5, 0.97, 1])  # fmt: skip
    tile = surfaces.stack((clear, 13), (surfaces.plain(color), 77), (clear, 10), side=128)
    cream = [ellipsoid(1.5 * r * k, 1.5 * r * k, 0.9 * r * k, 20, 10).move(z=h + z * r)
             for k, z in ((1.0, 0.05), (0.75, 0.4), (0.45, 0.7))]  # fmt: skip
    cherry = ellipsoid(0.018, 0.018, 0.018, 14, 8).move(z=h + 1.02 * r)
    pipe = tube([(0.4 * r, 0.1 * r, 0.6 * h), (0.75 * r, 0.25 * r, h + 0.065)], 0.0036, 8)
    stripes = surfaces.stripes([look.own_color("red", "sky", "pink"), (250, 248, 244)], 8)
    return shape([(body, tile), (join(cream), surfaces.plain((252, 248, 240))),
                  (cherry, surfaces.plain((196, 30, 44))), (pipe, stripes)],
                 [hull_of(body), hull_of(*cream, cherry), hull_of(pipe)])  # fmt: skip


@category("stirrer", size=(0.151, 0.00917, 0.0019), mass=0.002, material="wood",
          aliases=("coffee stirrer", "wooden stirrer", "stir stick", "drink stirrer",
          "cocktail stirrer", "swizzle stick", "popsicle stick", "craft stick", "ice pop stick"),
          themes=("coffee",), roles=("flat",), colors=("wooden",), state="lying flat")  # fmt: skip
def stirrer(look: Look) -> Shape:
    """A flat wooden stirring stick with round ends."""
    k = look.between(0.95, 1.2)
    color = look.color("wooden", "wooden", "white", "black")
    body = block(0.14 * k, 0.0085 * k, 0.0019, 0.004 * k)
    return shape([(body, look.surface(color, "wood"))], [box_part(0.14 * k, 0.0085 * k, 0.0019)])


@category("cup_sleeve", size=(0.0829, 0.0829, 0.0622), mass=0.005, material="paper", hollow=True,
          aliases=("coffee sleeve", "cardboard sleeve", "coffee cup sleeve", "cup cosy"),
          themes=("coffee",), colors=("tan",))  # fmt: skip
def cup_sleeve(look: Look) -> Shape:
    """A corrugated cardboard cup sleeve, standing upright."""
    k = look.between(0.94, 1.08)
    color = look.color("tan", "tan", "brown", "white")
    r, h, t = 0.035 * k, 0.062 * k, 0.0022
    ring = lathe([(r, 0), (1.18 * r, h), (1.18 * r - t, h), (r - t, 0)], 40, loop=True)
    ribs = surfaces.stripes([color, tint_color(color, 0.86)], 30, upright=True, side=180).copy()
    patch = ribs[:, 72:108]
    prints.disc(patch, 0.5, 0.5, 0.09, tint_color(color, 0.5))
    return shape(
        [(ring, ribs)], ring_parts([(r, 0), (1.18 * r, h)], [(1.18 * r - t, h), (r - t, 0)], 14)
    )


@category("sugar_bowl", size=(0.12, 0.096, 0.1), mass=0.35, material="ceramic", hollow=True,
          aliases=("sugar pot", "sugar", "sugar jar"), themes=("coffee", "dining"),
          roles=("round",), colors=("white", "cream"), common=True)  # fmt: skip
def sugar_bowl(look: Look) -> Shape:
    """A round sugar bowl with a lid and two small handles."""
    r, h = look.between(0.044, 0.05), look.between(0.06, 0.07)
    glaze = look.surface(look.color("white", "cream", "sky", "pink", "navy"), "ceramic")
    t = np.linspace(0, np.pi / 2, 7)
    rise = 0.004 + (h - 0.004) * t / t[-1]
    wall = np.column_stack([0.55 * r + 0.45 * r * np.sin(1.25 * t), rise])
    body = lathe([(0, 0), (0.55 * r, 0), *wall, (0, h)])
    rim = float(wall[-1, 0]) * 1.02
    lid = lathe(
        [(0, h), (rim, h), (rim, h + 0.004), (0.6 * rim, h + 0.014), (0.006, h + 0.018),
         (0.005, h + 0.022), (0.009, h + 0.028), (0.006, h + 0.034), (0, h + 0.035)], 28,
    )  # fmt: skip
    ears = [torus(0.011, 0.0032, 16, 8).turn(0, np.pi / 2).move(x=side * r * 0.98, z=0.62 * h)
            for side in (-1, 1)]  # fmt: skip
    return shape(
        [(body, glaze), (lid, glaze), *((ear, glaze) for ear in ears)],
        [hull_of(body), hull_of(lid),
         *[box_part(0.026, 0.006, 0.024, (side * r, 0, 0.62 * h - 0.012)) for side in (-1, 1)]],
    )  # fmt: skip


@category("cup_carrier", size=(0.211, 0.211, 0.0452), mass=0.04, material="paper", assembled=True,
          aliases=("cup tray", "drink carrier", "drinks carrier", "coffee cup carrier",
          "cup holder tray", "coffee carrier"), themes=("coffee",), roles=("flat",),
          colors=("gray",))  # fmt: skip
def cup_carrier(look: Look) -> Shape:
    """A moulded pulp tray with four round cup holders."""
    k = look.between(0.95, 1.06)
    color = look.color("gray", "beige", "tan")
    x, h = 0.21 * k, 0.045 * k
    base = block(x, x, 0.35 * h, 0.03, 0.003)
    rings = []
    for i in (-1, 1):
        for j in (-1, 1):
            ring = lathe(
                [(0.033, 0.3 * h), (0.046, 0.3 * h), (0.044, h), (0.037, h)], 26, loop=True
            )
            rings.append(ring.move(0.25 * x * i, 0.25 * x * j, 0))
    pulp = surfaces.spots(look.rng, color, tint_color(color, 0.86), 0.2)
    bars = [block(0.9 * x, 0.014, 0.7 * h, 0.004).turn(2, a) for a in (0, np.pi / 2)]
    parts = [box_part(x, x, 0.35 * h), *(hull_of(b) for b in bars)]
    return shape([(join([base, *rings, *bars]), pulp)],
                 [*parts, *(hull_of(r) for r in rings)])  # fmt: skip


@category("coaster", size=(0.095, 0.095, 0.007), mass=0.04, material="wood",
          aliases=("drink coaster", "cork tile", "mosaic tile", "tile", "tessera", "wall tile",
          "felt coaster", "pop socket", "coaster set"), themes=("coffee", "living", "dining"),
          roles=("support", "flat"), colors=("tan",), state="lying flat", common=True)  # fmt: skip
def coaster(look: Look) -> Shape:
    """A round or square coaster."""
    side, h = look.between(0.09, 0.1), look.between(0.005, 0.009)
    color = look.color("tan", "charcoal", "teal", "red", "wooden", "white")
    tile = look.surface(color, look.pick(["cork", "wood", "marble", "felt"]))
    if look.chance(0.6):
        return shape([(cylinder(side / 2, h, 32, bevel=0.001), tile)], [cylinder_part(side / 2, h)])
    return shape([(block(side, side, h, 0.008, 0.001), tile)], [box_part(side, side, h)])


EARS = ("ear", "square", "ring")


@category("teacup", size=(0.106, 0.09, 0.06), mass=0.16, material="ceramic", hollow=True,
          aliases=("tea cup", "espresso cup"), themes=("coffee", "dining"),
          roles=("container", "round"), colors=("white", "cream", "pink"), common=True)  # fmt: skip
def teacup(look: Look) -> Shape:
    """A wide, thin-walled cup with a handle and a foot: bowl-shaped, tulip-shaped or straight."""
    r, h, wall = look.between(0.04, 0.05), look.between(0.052, 0.07), 0.0035
    foot = look.between(0.46, 0.6) * r
    color = look.color(
        "white", "white", "cream", "pink", "sky", "mint", "navy", "black", "terracotta", "mustard"
    )
    power, flare = look.pick([0.8, 0.5, 1.1]), look.pick([0.0, 0.0, 0.06])
    t = np.linspace(0, np.pi / 2, 7)
    out = foot + (r - foot) * np.sin(t) ** power + flare * r * (t / t[-1]) ** 4
    outer = np.column_stack([out, 0.005 + (h - 0.005) * t / t[-1]])
    inner = np.column_stack([outer[:, 0] - wall, 0.011 + (h - 0.011) * t / t[-1]])[::-1]
    v = [0, 0, 0.03, *np.linspace(0.06, 0.95, 7), *np.linspace(0.97, 1, 7), 1]
    body = lathe([(0, 0), (foot, 0), (foot, 0.004), *outer, *inner, (0, 0.01)], v=v)
    inside = look.surface(look.pick([color, (244, 242, 236)]), "ceramic")
    trim = surfaces.plain(look.own_color("gold", "silver", "navy")) if look.chance(0.35) else inside
    tile = surfaces.stack((glaze_tile(look, color), 94), (trim, 2), (inside, 4), side=192)
    kind = look.pick(EARS)
    ends = np.interp([0.36 * h, 0.86 * h], outer[:, 1], outer[:, 0]) - 0.0016
    ear = handle((ends[0], ends[1]), 0.36 * h, 0.86 * h, look.between(0.017, 0.022), 0.0032, kind)
    wedges = bowl_parts(np.array([(foot, 0), *outer[1:]]), inner[::-1])
    level = float(np.interp(0.82 * h, inner[::-1, 1], inner[::-1, 0])) + 0.0005
    return shape([(body, tile), (ear, look.surface(color, "ceramic")),
                  *drink(look, level, 0.82 * h)], [*wedges, cylinder_part(foot, 0.01),
                                                   handle_part(ends[1], 0.42 * h, 0.84 * h, 0.011,
                                                               0.003)])  # fmt: skip


@category("saucer", size=(0.15, 0.15, 0.014), mass=0.16, material="ceramic", hollow=True,
          aliases=("dessert plate",), themes=("coffee", "dining"),
          roles=("support", "flat", "round"), colors=("white",), common=True)  # fmt: skip
def saucer(look: Look) -> Shape:
    """A small plate for a cup."""
    return plate(look).scale(0.6)
