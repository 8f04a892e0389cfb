"""Objects of the ``kitchen`` theme: spoons."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import hull_above, hull_of, hull_part, open_vessel
from ...kit.primitives import limb
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, shape
from ...kit.solids import ellipsoid, join, lathe, loft, prism, sweep, torus
from ...kit.surfaces import RGB, Look, tint_color
from ..dining.cutlery import _spoon, hollow
from .utensils import bright_steel, with_handle

GRIPS = ("black", "red", "teal", "wooden", "white", "navy", "sage", "silver")


@category("wooden_spoon", size=(0.296, 0.052, 0.0221), mass=0.05, material="wood",
          aliases=("cooking spoon", "mixing spoon", "stirring spoon"), themes=("kitchen",),
          colors=("wooden",), state="lying flat")  # fmt: skip
def wooden_spoon(look: Look) -> Shape:
    """A wooden cooking spoon."""
    wood = look.surface(look.color("wooden", "tan", "beige", "brown"), "wood")
    return _spoon(look, look.between(0.26, 0.32), look.between(0.032, 0.038), 0.026, 0.014, wood,
                  thick=0.0055)  # fmt: skip


@category("slotted_spoon", size=(0.304, 0.068, 0.0199), mass=0.11, material="metal",
          aliases=("skimmer", "slotted ladle", "straining spoon", "skimming spoon"),
          themes=("kitchen",), colors=("silver",), state="lying flat")  # fmt: skip
def slotted_spoon(look: Look) -> Shape:
    """A kitchen spoon with slots in its bowl."""
    color = look.color("silver", "silver", "black", "red", "teal")
    tile = look.surface(color, "metal" if look.chance(0.6) else "plastic")
    return _spoon(look, look.between(0.28, 0.33), 0.046, 0.034, 0.014, tile, slots=True)


@category("rice_paddle", size=(0.205, 0.0696, 0.0095), mass=0.04, material="plastic",
          aliases=("rice spoon", "rice scoop", "shamoji"), themes=("kitchen",), roles=("flat",),
          colors=("white", "wooden"), state="lying flat")  # fmt: skip
def rice_paddle(look: Look) -> Shape:
    """A flat, round paddle for rice."""
    long = look.between(0.19, 0.22)
    tile = look.surface(look.color("white", "wooden", "cream", "red"), look.pick(
        ["wood", "plastic"]))  # fmt: skip
    head = prism(ellipse(0.42 * long, 0.34 * long, 28), 0, 0.006, 0.002).move(x=-0.29 * long)
    grip = sweep([(-0.12 * long, 0, 0.0035), (0.1 * long, 0, 0.0045), (0.5 * long, 0, 0.005)],
                 rectangle(0.024, 0.009, 0.004, 3), [1.3, 0.85, 1.0])  # fmt: skip
    return shape([(head, tile), (grip, tile)], [hull_of(head), hull_above(grip)])


@category("ice_cream_scoop", size=(0.202, 0.0528, 0.0264), mass=0.14, material="metal",
          aliases=("ice cream spoon",), themes=("kitchen",), colors=("silver", "red"),
          state="lying flat")  # fmt: skip
def ice_cream_scoop(look: Look) -> Shape:
    """A round ice cream scoop with a thick handle, lying flat."""
    long, r = look.between(0.18, 0.21), look.between(0.024, 0.028)
    color = look.color(*GRIPS)
    t = np.linspace(0.1, np.pi / 2, 7)
    outer = [(r * np.sin(a), r * (1 - np.cos(a))) for a in t]
    inner = [(max(x - 0.002, 0.001), z + 0.002 * (1 - i / 6)) for i, (x, z) in enumerate(outer)]
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.002)], 26).move(x=-0.5 * long + r)
    steel = surfaces.brushed_metal(look.rng, (196, 199, 204))
    neck = limb([(-0.5 * long + 1.95 * r, 0, 0.8 * r), (-0.1 * long, 0, 0.62 * r),
                 (0.02 * long, 0, 0.5 * r)], [0.005, 0.0052, 0.006], 10)  # fmt: skip
    grip = limb([(-0.02 * long, 0, 0.5 * r), (0.2 * long, 0, 0.42 * r), (0.45 * long, 0, 0.38 * r),
                 (0.5 * long, 0, 0.36 * r)], [0.0085, 0.0115, 0.0115, 0.006], 14)  # fmt: skip
    return shape([(join([cup, neck]), steel), (grip, look.surface(color, "plastic"))],
                 [hull_of(cup), hull_above(grip), hull_of(neck)])  # fmt: skip


@category("scoop", size=(0.224, 0.0682, 0.0342), mass=0.13, material="metal",
          aliases=("flour scoop", "ice scoop", "sugar scoop", "coffee scoop"), themes=("kitchen",),
          colors=("silver",), state="lying flat")  # fmt: skip
def scoop(look: Look) -> Shape:
    """A flour or ice scoop: an open half-round shovel with a handle."""
    long, r = look.between(0.2, 0.24), look.between(0.032, 0.038)
    steel = look.surface(look.color("silver", "silver", "copper", "white", "red"), "metal")
    a = np.linspace(np.pi, 2 * np.pi, 13)
    arc = np.column_stack([r * np.cos(a), r + r * np.sin(a)])
    ring = np.concatenate([arc, 0.93 * (arc - [0, r])[::-1] + [0, r]])
    levels = [(-0.5 * long, 0.82, 1.0), (-0.2 * long, 1.0, 1.0), (0.02 * long, 1.0, 1.0)]
    body = loft(np.stack([np.column_stack([np.full(len(ring), x), ring[:, 0] * k, ring[:, 1] * k2])
                          for x, k, k2 in levels]), ring)  # fmt: skip
    back = prism(np.array([*arc]), 0, 0.003).turn(0, np.pi / 2).turn(2, np.pi / 2)
    back = back.move(x=0.02 * long - float(back.bounds[0, 0]) - 0.002)
    grip = limb([(0.02 * long, 0, 0.8 * r), (0.12 * long, 0, 0.75 * r), (0.45 * long, 0, 0.0105),
                 (0.5 * long, 0, 0.0075)], [0.006, 0.0075, 0.0095, 0.006], 12)  # fmt: skip
    body = body.move(z=-0.0035)
    parts = [hull_part(np.maximum(body.vertices, (-1, -1, 0))[np.abs(np.arctan2(body.vertices[:, 1],
                                                                                r
                                                                                - body.vertices[:,
                                                                                                2])
                                                                     - w) < 0.45])
             for w in (-1.2, -0.6, 0.0, 0.6, 1.2)]  # fmt: skip
    return shape([(body, steel), (back, steel), (grip, steel)], [*parts, hull_of(back),
                                                                  hull_of(grip)])  # fmt: skip


@category("measuring_spoon", size=(0.136, 0.151, 0.0156), mass=0.06, material="metal",
          assembled=True, aliases=("measuring spoons", "set of measuring spoons"),
          themes=("kitchen",), colors=("silver",), state="lying flat")  # fmt: skip
def measuring_spoon(look: Look) -> Shape:
    """Measuring spoons on a ring, fanned out."""
    color = look.color("silver", "silver", "copper", "red", "teal", "white")
    tile = look.surface(color, "metal" if look.chance(0.6) else "plastic")
    solids, parts = [], []
    for k, (r, a) in enumerate(((0.021, 0.62), (0.018, 0.2), (0.0145, -0.2), (0.011, -0.6))):
        cup = hollow(0, r, r, 0.75 * r, 0.0016).move(x=-0.105)
        arm = sweep([(-0.105 + 0.9 * r, 0, 0.75 * r - 0.001), (-0.05, 0, 0.004 + 0.0014 * k),
                     (0.006, 0, 0.001 + 0.0016 * k)],
                    rectangle(0.011, 0.0016, 0.0006, 1))  # fmt: skip
        cup, arm = cup.turn(2, a), arm.turn(2, a)
        solids += [cup, arm]
        parts += [hull_of(cup), hull_above(arm)]
    ring = torus(0.011, 0.0012, 20, 6).turn(0, 0.25).move(x=0.004, z=0.0042)
    scale = look.between(0.92, 1.08)
    made = shape([(join(solids), tile), (ring, surfaces.plain(tint_color((190, 192, 196), 0.9)))],
                 parts)  # fmt: skip
    return made.scale(scale)


@category("ladle", size=(0.331, 0.082, 0.0593), mass=0.14, material="plastic", assembled=True,
          aliases=("soup ladle", "serving ladle", "dipper"), themes=("kitchen", "dining"),
          colors=("silver", "black"), state="lying down")  # fmt: skip
def ladle(look: Look) -> Shape:
    """A soup ladle resting on the side of its bowl and the end of its handle."""
    r, long = look.between(0.036, 0.044), look.between(0.24, 0.29)
    color = look.color("silver", "silver", *GRIPS)
    steel = bright_steel(look) if look.chance(0.7) else look.surface(color, "plastic")
    t = np.linspace(0.06, np.pi / 2, 7)
    outer = [(r * np.sin(a), r * (1 - np.cos(a)) * 0.86) for a in t]
    inner = [(max(x - 0.002, 0.001), z + 0.002 * (1 - i / 6)) for i, (x, z) in enumerate(outer)]
    bowl = lathe([(0, 0), *outer, *inner[::-1], (0, 0.002)], 26)
    h = 0.86 * r
    stem = sweep(smooth([(0.97 * r, 0, h - 0.003), (r + 0.03, 0, h + 0.022),
                         (0.6 * long, 0, 0.5 * h + 0.016), (long, 0, 0.006)], 4),
                 rectangle(0.012, 0.004, 0.0015, 2))  # fmt: skip
    grip = sweep([(0.55 * long, 0, 0.5 * h + 0.0185), (long + 0.02, 0, 0.006)],
                 rectangle(0.02, 0.011, 0.004, 3))  # fmt: skip
    wedges = [hull_part(bowl.vertices[bowl.vertices[:, 2] < 0.55 * h])]
    around = np.arctan2(bowl.vertices[:, 1], bowl.vertices[:, 0])
    for k in range(10):
        low = -np.pi + k * 2 * np.pi / 10
        inside = (around >= low - 0.02) & (around <= low + 2 * np.pi / 10 + 0.02)
        high = bowl.vertices[:, 2] > 0.45 * h
        wedges.append(hull_part(bowl.vertices[inside & high]))
    skin = look.surface(color, "plastic")
    return shape([(bowl, steel), (stem, steel), (grip, skin)],
                 [*wedges, hull_part(stem.vertices[stem.vertices[:, 0] < r + 0.05]),
                  hull_of(grip)])  # fmt: skip


def _fork_head(look: Look, color: RGB, z: float) -> Pieces:
    bowl = ellipsoid(0.085, 0.06, 0.026, 22, 10).bend(
        lambda p: np.column_stack([p[:, :2], np.where(p[:, 2] > 0, -0.55 * p[:, 2], p[:, 2])])
    )
    teeth = [limb([(-0.05 + 0.03 * np.cos(a) * 1.1, 0.03 * np.sin(a), z - 0.002),
                   (-0.05 + 0.045 * np.cos(a), 0.034 * np.sin(a), z + 0.02)],
                  [0.0042, 0.0032], 7) for a in np.linspace(0.7, 2 * np.pi - 0.7, 9)]  # fmt: skip
    hole = ellipsoid(0.022, 0.022, 0.002, 14, 5).move(-0.046, 0, z - 0.0075)
    tile = surfaces.speckles(look.rng, tint_color(color, 0.85), 4)
    return [(join([bowl.move(-0.045, 0, z + 0.002), *teeth]), tile),
            (hole, surfaces.plain((30, 30, 32)))]  # fmt: skip


def _spork(look: Look, color: RGB, z: float) -> Pieces:
    outline = np.array([(0.012, -0.004), (0.012, 0.004), (-0.012, 0.018), (-0.034, 0.02),
                        (-0.052, 0.016), (-0.041, 0.0105), (-0.056, 0.0055), (-0.043, 0),
                        (-0.056, -0.0055), (-0.041, -0.0105), (-0.052, -0.016), (-0.034, -0.02),
                        (-0.012, -0.018)])  # fmt: skip
    head = prism(outline, 0, 0.002).bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + 9 * p[:, 1] ** 2 + 2.5 * (p[:, 0] + 0.02) ** 2]
        )
    )
    return [(head.move(z=z - 0.006), surfaces.plain(color))]


@category("spoon_rest", size=(0.162, 0.0946, 0.0162), mass=0.2, material="ceramic",
          aliases=("ladle rest",), themes=("kitchen",), roles=("flat",),
          colors=("white",))  # fmt: skip
def spoon_rest(look: Look) -> Shape:
    """A spoon rest: a shallow, glazed dish in the shape of a big spoon."""
    k, color = (look.between(0.88, 1.1), look.color("white", "sky", "red", "yellow", "teal",
                                                    "cream", "gray"))  # fmt: skip
    a = np.linspace(0.32, 2 * np.pi - 0.32, 26)
    outline = np.concatenate([[(0.115, 0.022)], np.column_stack([0.056 * np.cos(a), 0.05
                                                                 * np.sin(a)]),
                              [(0.115, -0.022)]]) - [0.02, 0]  # fmt: skip

    def ring(s: float, z: float) -> np.ndarray:
        c = np.array([0.02, 0])
        return np.column_stack([c + (outline - c) * s, np.full(len(outline), z)])

    body = loft(
        np.stack([ring(0.86, 0), ring(1.0, 0.016), ring(0.94, 0.017), ring(0.8, 0.006)]), outline
    )
    tile = (surfaces.spots(look.rng, color, tint_color(color, 0.7 if sum(color) > 380 else 1.4),
                           0.03) if look.chance(0.5)
            else look.surface(color, "ceramic"))  # fmt: skip
    return shape([(body.scale(k, k, k), tile)], [hull_of(body.scale(k, k, 0.4 * k))])


@category("spoon_dish", size=(0.13, 0.107, 0.0183), mass=0.08, material="ceramic", hollow=True,
          aliases=("teaspoon dish", "tea bag tidy", "teabag tidy", "tea bag holder", "tea bag rest",
          "teaspoon rest", "teabag dish", "tea bag dish"), themes=("kitchen",),
          roles=("container",), colors=("white",))  # fmt: skip
def spoon_dish(look: Look) -> Shape:
    """A tiny, shallow dish for a teaspoon or a used tea bag, sometimes shaped like a teapot."""
    k, color = (look.between(0.88, 1.12), look.color("white", "sky", "pink", "mint", "yellow",
                                                     "teal"))  # fmt: skip
    body, parts = open_vessel(
        [(0.034 * k, 0), (0.044 * k, 0.006 * k), (0.052 * k, 0.016 * k)], 0.003, 0.003
    )
    tile = look.surface(color, "ceramic")
    pieces = [(body, tile)]
    if look.chance(0.6):
        grip = torus(0.014 * k, 0.0035 * k, 18, 7).move(0.06 * k, 0, 0.012 * k)
        spout = limb([(-0.046 * k, 0, 0.008 * k), (-0.062 * k, 0, 0.012 * k),
                      (-0.072 * k, 0, 0.016 * k)], [0.008 * k, 0.006 * k, 0.004 * k],
                     8)  # fmt: skip
        pieces.append((join([grip, spout]), tile))
    return shape(pieces, parts)


CATEGORIES = (
    Category("pasta_server", keep_still(with_handle(_fork_head, (0.15, 0.18), 0.05)),
             size=(0.307, 0.0713, 0.0316), mass=0.08, material="plastic",
             aliases=("spaghetti server", "pasta fork", "pasta spoon", "spaghetti spoon"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("spork", keep_still(with_handle(_spork, (0.08, 0.1), 0.0, ("red", "blue", "green",
             "orange", "gray", "black"), 0.0055)), size=(0.149, 0.0405, 0.013), mass=0.015,
             material="plastic", aliases=("camping spork", "plastic spork", "titanium spork"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
