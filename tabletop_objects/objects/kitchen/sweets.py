"""Objects of the ``kitchen`` theme: sweets."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, hull_of, hull_part
from ...kit.primitives import bent_rod, lobe, scatter
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus
from ...kit.surfaces import Look, tint_color
from .nuts import Heap, heap
from .snacks import rough_ball


@category("quince_paste", size=(0.0726, 0.0519, 0.0228), mass=0.09, material="food",
          aliases=("membrillo", "quince jelly", "fruit paste", "quince cheese"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("crimson",))  # fmt: skip
def quince_paste(look: Look) -> Shape:
    """A slab of dark red quince paste."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.07 * k, 0.05 * k, 0.022 * k
    tone = look.color("crimson", "maroon")
    return shape([(block(x, y, h, 0.003, 0.0015), surfaces.gradient(tint_color(tone, 0.8),
                  tint_color(tone, 1.1), look.rng))], [box_part(x, y, h)])  # fmt: skip


@category("turkish_delight", size=(0.026, 0.026, 0.0227), mass=0.015, material="food",
          aliases=("lokum", "piece of turkish delight", "cube of turkish delight"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("pink",))  # fmt: skip
def turkish_delight(look: Look) -> Shape:
    """A soft cube of Turkish delight, dusted with sugar."""
    x, h = look.between(0.023, 0.028), look.between(0.02, 0.024)
    color = look.color("pink", "yellow", "coral", "mint", "orange")
    body = block(x, x, h, 0.003, 0.002)
    return shape([(body, surfaces.spots(look.rng, tint_color(color, 1.3), (252, 250, 248), 0.4))],
                 [box_part(x, x, h)])  # fmt: skip


@category("barfi", size=(0.0352, 0.0352, 0.0174), mass=0.025, material="food", aliases=("burfi",
          "kaju katli", "milk sweet", "indian sweet", "fudge square", "barfis", "burfis"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("cream",))  # fmt: skip
def barfi(look: Look) -> Shape:
    """A square of milk fudge with silver leaf and pistachio."""
    x, h = look.between(0.032, 0.04), look.between(0.014, 0.018)
    color = look.color("cream", "ivory", "mint", "pink", "tan")
    body = block(x, x, h, 0.001, 0.0008)
    leaf = box(0.75 * x, 0.75 * x, 0.0006).turn(2, 0.3).move(z=h - 0.0003)
    nuts = scatter(look, 0.25 * x, 7, (0.004, 0.006), h, stretch=(1, 0.5, 0.4))
    return shape([(body, surfaces.speckles(look.rng, tint_color(color, 1.05), 7)),
                  (leaf, surfaces.brushed_metal(look.rng, (206, 210, 214))),
                  (nuts, surfaces.plain((124, 158, 70)))], [box_part(x, x, h)])  # fmt: skip


@category("ice_pop", size=(0.133, 0.0461, 0.0235), mass=0.08, material="food", aliases=("popsicle",
          "ice lolly", "ice cream bar", "ice cream stick", "frozen pop", "kulfi"),
          themes=("kitchen",), roles=("edible", "flat"), colors=("red", "orange"),
          state="lying flat")  # fmt: skip
def ice_pop(look: Look) -> Shape:
    """An ice lolly lying on its side with its flat stick on the right."""
    x, y, h = look.between(0.085, 0.1), look.between(0.042, 0.05), look.between(0.018, 0.022)
    color = look.color("red", "orange", "pink", "brown", "lime", "sky", "yellow")
    side = rectangle(x, y, 0.46 * y, 6)
    side[:, 0] = np.where(side[:, 0] > 0, np.minimum(side[:, 0], 0.42 * x), side[:, 0])
    keep = np.append(np.abs(np.diff(side, axis=0)).sum(1) > 1e-9, True)
    body = prism(side[keep], 0, h, 0.28 * h)
    grooves = [bent_rod(0.62 * x, 0.0035, sides=8).move(-0.08 * x, s * 0.2 * y, h) for s in (-1, 1)]
    other = tint_color(look.own_color("white", "yellow", "brown", "pink"), 1.1)
    tile = surfaces.gradient(color, tint_color(color, 1.2), look.rng)
    if look.chance(0.4):
        tile = surfaces.stripes([color, other, tint_color(color, 0.7)], 1, upright=True)
    stick = block(0.06, 0.011, 0.0025, 0.005).move(x=0.42 * x + 0.018, z=0.001)
    return shape([(body, tile), (join(grooves), surfaces.plain(tint_color(color, 0.75))),
                  (stick, surfaces.wood(look.rng, (226, 196, 148)))],
                 [hull_of(body), hull_of(stick)])  # fmt: skip


@category("ice_cream_cone", size=(0.164, 0.0683, 0.0673), mass=0.11, material="food",
          aliases=("ice cream cornet", "cone of ice cream", "waffle cone", "gelato cone"),
          themes=("kitchen",), roles=("edible",), colors=("pink", "cream"),
          state="lying down")  # fmt: skip
def ice_cream_cone(look: Look) -> Shape:
    """An ice cream cone lying on its side: a waffle cone with one or two scoops."""
    r, long = look.between(0.026, 0.031), look.between(0.1, 0.12)
    color = look.color("pink", "brown", "cream", "mint", "yellow", "lavender")
    cone = lathe([(0, 0), (0.1 * r, 0), (0.92 * r, long), (0, long)], 28)
    rows, columns = np.mgrid[0:128, 0:128]
    net = (((rows + columns) % 16) < 3) | (((rows - columns) % 16) < 3)
    wafer = np.where(net[..., None], np.array((166, 108, 52)), np.array((220, 166, 96)))
    band = cylinder(r, 0.22 * long, 28).move(z=0.8 * long)
    ball = ellipsoid(2.2 * r, 2.2 * r, 2.1 * r, 24, 14).move(z=1.12 * long)
    frill = lobe(torus(0.95 * r, 0.2 * r, 40, 8), 11, 0.1).move(z=1.01 * long)
    scoop = [ball, frill]
    if look.chance(0.4):
        scoop.append(ellipsoid(1.9 * r, 1.9 * r, 1.8 * r, 22, 12).move(z=1.12 * long + 1.4 * r))
    pieces = [(cone, wafer.astype(np.uint8)), (band, surfaces.plain((214, 158, 88))),
              (join(scoop), surfaces.spots(look.rng, color, tint_color(color, 0.8),
                                           0.08))]  # fmt: skip
    lean = np.arcsin(r / (1.12 * long))
    laid = [(s.turn(1, lean - np.pi / 2).move(x=0.5 * long), tile) for s, tile in pieces]
    return settle(laid, 0.05, hulls=[[0, 1], [2]])


@category("pie", size=(0.235, 0.235, 0.044), mass=0.8, material="metal", aliases=("apple pie",
          "cherry pie", "pumpkin pie", "quiche", "fruit pie", "kunafa", "knafeh"),
          themes=("kitchen", "dining"), roles=("edible", "round", "big"),
          colors=("tan",))  # fmt: skip
def pie(look: Look) -> Shape:
    """A round pie in its tin, with a pastry lattice or a closed, slitted crust."""
    r, h = look.between(0.105, 0.125), look.between(0.035, 0.045)
    crust = surfaces.spots(look.rng, (216, 164, 96), (168, 112, 58), 0.2)
    tin = look.surface(look.color("silver", "silver", "white", "charcoal", "terracotta"), "metal")
    dish = lathe([(0, 0), (0.78 * r, 0), (r, 0.8 * h), (0.96 * r, 0.82 * h), (0, 0.82 * h)], 32)
    edge = lobe(torus(0.93 * r, 0.0085, 48, 8), 24, 0.04).move(z=0.86 * h)
    tone = look.pick([(150, 28, 40), (206, 140, 50), (70, 40, 80), (190, 60, 40), (200, 110, 40)])
    fill = surfaces.spots(look.rng, tone, tint_color(tone, 1.5), 0.15)
    inner = cylinder(0.9 * r, 0.03 * h, 30).move(z=0.84 * h)
    pieces = [(dish, tin), (edge, crust)]
    if look.chance(0.65):
        strips = []
        for k in range(-2, 3):
            long = 2 * np.sqrt(max(0.9**2 - (0.36 * k) ** 2, 0.05)) * r
            for turn, lift in ((0.0, 0.0), (np.pi / 2, 0.0016)):
                strips.append(box(long, 0.15 * r, 0.005).move(y=0.36 * k * r).turn(2, turn)
                              .move(z=0.87 * h + lift))  # fmt: skip
        pieces += [(inner, fill), (join(strips), crust)]
    else:
        dome = lathe([(0, 0.83 * h), (0.92 * r, 0.83 * h), (0.7 * r, 1.08 * h), (0, 1.16 * h)], 30)
        slits = [box(0.05, 0.006, 0.003).move(x=0.05, z=1.085 * h).turn(2, k * np.pi / 2)
                 for k in range(4)]  # fmt: skip
        pieces += [(dome, crust), (join(slits), surfaces.plain(tone))]
    return shape(pieces, [hull_of(dish), hull_part(np.concatenate(
        [s.vertices for s, _ in pieces[1:]]))])  # fmt: skip


CATEGORIES = (
    Category("gulab_jamun", rough_ball((0.034, 0.034, 0.032), ("brown", "copper"), 0.72, 0.0, 0.05,
             (150, 180, 90)), size=(0.0339, 0.0339, 0.0291), mass=0.03, material="food",
             aliases=("gulab jaman", "rasgulla"), themes=("kitchen", "dining"),
             roles=("edible", "round"), colors=("brown",)),
    Category("laddu", rough_ball((0.042, 0.042, 0.038), ("orange", "amber", "yellow"), 1.0, 0.02,
             0.4, (226, 206, 150)), size=(0.0414, 0.0416, 0.0343), mass=0.045, material="food",
             aliases=("ladoo", "laddoo", "besan laddu", "motichoor laddu", "laddus"),
             themes=("kitchen", "dining"), roles=("edible", "round"), colors=("orange",)),
    Category("chocolate_chips",
             heap(Heap((0.026, 0.036), 0.008, "ball", ("brown", "maroon", "cream"))),
             size=(0.0697, 0.0691, 0.021), mass=0.03, material="food", aliases=("chocolate chip",
             "choc chip", "cocoa nib", "heap of chocolate chips", "pile of chocolate chips",
             "mound of chocolate chips", "chocolate chips heap"), themes=("kitchen", "food"),
             roles=("edible",), colors=("brown",), state="heaped"),
    Category("sprinkles",
             heap(Heap((0.016, 0.024), 0.004, "strand", ("pink", "sky", "yellow", "red"))),
             size=(0.0472, 0.0465, 0.0132), mass=0.01, material="food", aliases=("sprinkle",
             "hundreds and thousands", "cake sprinkle", "heap of sprinkles", "pile of sprinkles",
             "mound of sprinkles", "sprinkles heap"), themes=("kitchen", "food"), roles=("edible",),
             colors=("pink",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
