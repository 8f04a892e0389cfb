"""Objects of the ``kitchen`` theme: spices."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.parts import box_part
from ...kit.primitives import ball, bent_rod, blade, limb
from ...kit.shapes import Category, Shape, at_rest, category, keep_still, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe
from ...kit.surfaces import Look, tint_color
from .fruit import Globe, globe
from .nuts import Heap, heap
from .vegetables import Pod, pod_of


@category("cardamom_pod", size=(0.0258, 0.0107, 0.00916), mass=0.0003, material="food",
          aliases=("cardamom", "green cardamom", "cardamom seed"), themes=("kitchen",),
          colors=("olive",), state="lying flat")  # fmt: skip
def cardamom_pod(look: Look) -> Shape:
    """A green cardamom pod with three ribs."""
    k = look.between(0.9, 1.15)
    color = look.color("olive", "lime", "beige")
    body = bent_rod(0.022, 0.0052, blunt=2.4)
    ribs = [limb([(-0.009, 0.0022 * np.cos(a), 0.0022 * np.sin(a)), (0, 0.005 * np.cos(a), 0.005 *
                 np.sin(a)), (0.009, 0.0022 * np.cos(a), 0.0022 * np.sin(a))], [0.0006] * 3, 5)
            for a in (0.5, 2.6, 1.55)]  # fmt: skip
    stalk = limb([(0.01, 0, 0), (0.014, 0.001, 0)], [0.0008, 0.0005], 5)
    return settle([(body, surfaces.gradient(tint_color(color, 1.1), tint_color(color, 1.3),
                                            look.rng)),
                   (join([*ribs, stalk]), surfaces.plain(tint_color(color, 0.8)))],
                  0.16).scale(k)  # fmt: skip


@category("star_anise", size=(0.0424, 0.0424, 0.00593), mass=0.0015, material="food",
          aliases=("anise star", "star anise pod", "aniseed star"), themes=("kitchen",),
          roles=("flat",), colors=("brown",), state="lying flat")  # fmt: skip
def star_anise(look: Look) -> Shape:
    """A star of eight woody pods with shiny seeds."""
    k = look.between(0.9, 1.2)
    color = look.color("brown", "brown", "bronze")
    pods, seeds = [], []
    for n in range(8):
        a = n * np.pi / 4
        way = np.array([np.cos(a), np.sin(a)])
        pods.append(blade([(0, 0, 0.0035), (*(0.009 * way), 0.005), (*(0.019 * way), 0.004)],
                          0.0085, thick=0.5))  # fmt: skip
        seeds.append(ball(0.0042, 0.003, 0.003, (*(0.0085 * way), 0.0066), 8))
    return settle([(join(pods), surfaces.speckles(look.rng, tint_color(color, 0.95), 14)),
                   (join(seeds), surfaces.plain((150, 84, 40)))], 0.05).scale(k)  # fmt: skip


@category("clove", size=(0.0145, 0.00765, 0.00643), mass=0.0001, material="food",
          aliases=("whole clove", "clove spice"), themes=("kitchen", "food"), roles=("edible",),
          colors=("brown",), state="lying flat")  # fmt: skip
@at_rest
def clove(look: Look) -> Shape:
    """A clove lying flat, shaped like a small nail, with a four-cornered crown."""
    color = look.color("brown", "bronze", "maroon", "black")
    k = look.between(0.9, 1.25)
    stem = lathe([(0, 0), (0.0011, 0.0005), (0.0015, 0.006), (0.0021, 0.0095), (0, 0.0105)], 10)
    crown = [blade([(0, 0, 0.0085), (0.0016, 0, 0.0105), (0.0038, 0, 0.0118)], 0.0022).turn(2, a)
             for a in np.pi / 2 * np.arange(4) + 0.4]  # fmt: skip
    bud = ellipsoid(0.0032, 0.0032, 0.003, 10, 6).move(z=0.0118)
    dark, pale = surfaces.speckles(look.rng, color, 12, 32), surfaces.plain(tint_color(color, 1.3))
    laid = [(s.turn(1, np.pi / 2), t) for s, t in ((join([stem, *crown]), dark), (bud, pale))]
    return settle(laid, 0.16).scale(k)


@category("cinnamon_stick", size=(0.0855, 0.0242, 0.0113), mass=0.005, material="food",
          aliases=("cinnamon quill", "stick of cinnamon", "cinnamon bark"),
          themes=("kitchen", "food"), roles=("edible",), colors=("copper",),
          state="lying flat")  # fmt: skip
def cinnamon_stick(look: Look) -> Shape:
    """A cinnamon stick lying flat: rolled bark with two scrolls side by side."""
    long, r = look.between(0.07, 0.1), look.between(0.0055, 0.0075)
    color = look.color("copper", "brown", "terracotta", "bronze")
    scroll = lathe([(0.62 * r, 0), (r, 0), (r, long), (0.62 * r, long)], 18, loop=True)
    core = cylinder(0.3 * r, 0.98 * long, 10).move(z=0.01 * long)
    made = [s.turn(1, np.pi / 2).move(-0.5 * long, y, 0) for s in (scroll, core)
            for y in (-0.85 * r, 0.85 * r)]  # fmt: skip
    grain = surfaces.stripes([color, tint_color(color, 0.85), color], 8, upright=True)
    return settle([(join(made), grain)], 0.12)


@category("stock_cube", size=(0.0271, 0.0271, 0.0209), mass=0.01, material="plastic",
          aliases=("bouillon cube", "oxo cube", "gravy cube", "stock pot cube", "bouillon"),
          themes=("kitchen",), colors=("gold",))  # fmt: skip
def stock_cube(look: Look) -> Shape:
    """A stock cube in coloured foil, folded like a parcel."""
    k = look.between(0.95, 1.25)
    color = look.color("gold", "red", "green", "silver", "amber")
    x, h = 0.024 * k, 0.018 * k
    cube = block(x, x, h, 0.002, 0.0012)
    folds = [box(0.86 * x, 0.002 * k, 0.0012).turn(2, s * 0.6).move(z=h - 0.0006) for s in (-1, 1)]
    foil = surfaces.brushed_metal(look.rng, color)
    return shape([(cube, foil), (join(folds), surfaces.plain(tint_color(color, 0.7)))],
                 [box_part(x, x, h + 0.0004)])  # fmt: skip


CATEGORIES = (
    Category("nutmeg", globe(Globe((0.018, 0.022), 1.25, ("brown", "bronze", "copper"),
             "dark streaks", top="none", lying=True)), size=(0.0229, 0.0225, 0.0175), mass=0.006,
             material="food", aliases=("whole nutmeg",), themes=("kitchen", "food"),
             roles=("edible",), colors=("brown",)),
    Category("peppercorn", globe(Globe((0.0046, 0.006), 1.0, ("black", "charcoal", "red", "white",
             "brown"), "warty", top="none", bumps=30)), size=(0.00623, 0.00636, 0.00507),
             mass=8e-05, material="food",
             aliases=("black peppercorn", "allspice berry", "pimento berry"),
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("black",)),
    Category("peppercorn_heap",
             heap(Heap((0.018, 0.026), 0.005, "ball", ("black", "charcoal", "brown", "red"))),
             size=(0.0504, 0.051, 0.0151), mass=0.01, material="food",
             aliases=("heap of peppercorn", "pile of peppercorn", "mound of peppercorn"),
             themes=("kitchen", "food"), roles=("edible",), colors=("black",), state="heaped"),
    Category("sea_salt", heap(Heap((0.02, 0.03), 0.003, "cube", ("white", "pink", "ivory"))),
             size=(0.0564, 0.0561, 0.0158), mass=0.02, material="food", aliases=("coarse salt",
             "salt crystal", "rock salt", "himalayan salt", "bath salt", "heap of sea salt",
             "pile of sea salt", "mound of sea salt", "sea salt heap"), themes=("kitchen", "food"),
             roles=("edible",), colors=("white",), state="heaped"),
    Category("ground_spice", heap(Heap((0.02, 0.03), 0.003, "powder", ("terracotta", "mustard",
             "copper", "brown", "olive"))), size=(0.0463, 0.0432, 0.0115), mass=0.015,
             material="food", aliases=("ground cinnamon", "turmeric powder", "curry powder",
             "ground cumin", "chilli powder", "spice powder", "heap of ground spice",
             "pile of ground spice", "mound of ground spice", "ground spice heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("terracotta",), state="heaped"),
    Category("tamarind_pod", keep_still(pod_of(Pod((0.11, 0.15),
             (0.02, 0.07, 0.085, 0.06, 0.088, 0.06, 0.088, 0.07, 0.01), ("tan", "bronze", "copper",
             "brown"), 0.09, "speckles", "stem"))), size=(0.149, 0.0298, 0.0194), mass=0.02,
             material="food", aliases=("tamarind",), themes=("kitchen", "food"), roles=("edible",),
             colors=("tan",), state="lying flat"),
    Category("vanilla_pod", keep_still(pod_of(Pod((0.15, 0.19),
             (0.006, 0.014, 0.017, 0.016, 0.016, 0.01), ("black", "brown", "maroon", "charcoal"),
             0.06, "ribs", "stem"))), size=(0.192, 0.0185, 0.00489), mass=0.004, material="food",
             assembled=True, aliases=("vanilla bean", "vanilla stick"), themes=("kitchen", "food"),
             roles=("edible",), colors=("black",), state="lying flat"),
    Category("turmeric", keep_still(pod_of(Pod((0.06, 0.085), (0.06, 0.11, 0.09, 0.11, 0.06),
             ("orange", "amber", "mustard"), 0.09, "rings"))), size=(0.0749, 0.0184, 0.0133),
             mass=0.02, material="food", aliases=("turmeric root", "fresh turmeric"),
             themes=("kitchen", "food"), roles=("edible",), colors=("orange",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
