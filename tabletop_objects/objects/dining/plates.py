"""Objects of the ``dining`` theme: plates."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import SIDE, glaze_tile
from ...kit.parts import (
    box_part,
    cylinder_part,
    frame_parts,
    hull_of,
    hull_part,
    ring_parts,
    stretch_parts,
)
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, open_box, tube
from ...kit.surfaces import RGB, Look, Tile, tint_color


@category("paper_plate", size=(0.223, 0.223, 0.0163), mass=0.012, material="paper", hollow=True,
          aliases=("disposable plate", "plastic plate", "party plate"), themes=("dining",),
          roles=("support", "flat", "round"), colors=("white",), state="lying flat")  # fmt: skip
def paper_plate(look: Look) -> Shape:
    """A disposable plate with a crimped rim."""
    r, h = look.between(0.1, 0.12), look.between(0.014, 0.019)
    color = look.color("white", "white", "red", "sky", "yellow", "pink", "tan")
    body = lathe([(0, 0), (0.66 * r, 0), (0.78 * r, 0.7 * h), (r, h), (0.99 * r, h),
                  (0.77 * r, 0.7 * h + 0.0015), (0.65 * r, 0.0016), (0, 0.0016)], 48)  # fmt: skip
    ribs = surfaces.stripes([color, tint_color(color, 0.93)], 48, upright=True, side=192)
    plain = surfaces.fit(surfaces.speckles(look.rng, color, 3), 64, 64)
    tile = surfaces.stack((plain, 26), (ribs, 24), (ribs, 24), (plain, 26), side=192)
    rim = [hull_part([(q * r * np.cos(a), q * r * np.sin(a), z) for a in np.linspace(
        k * np.pi / 6, (k + 1) * np.pi / 6, 3) for q, z in ((0.65, 0), (0.78, 0.7 * h), (1.0, h),
        (0.66, 0.002))]) for k in range(12)]  # fmt: skip
    return shape([(body, tile)], [cylinder_part(0.65 * r, 0.0018), *rim])


CHINA = ("white", "white", "cream", "sky", "navy", "sage", "terracotta", "black", "teal")


@category("serving_platter", size=(0.355, 0.243, 0.0267), mass=0.9, material="ceramic", hollow=True,
          aliases=("platter", "oval platter", "oval plate", "serving plate", "serving dish",
          "oval dish", "epergne"), themes=("dining",), roles=("support", "flat", "big"),
          colors=("white",))  # fmt: skip
def serving_platter(look: Look) -> Shape:
    """A flat oval dish with a broad rim."""
    x, y, h = look.between(0.32, 0.38), look.between(0.22, 0.26), look.between(0.024, 0.03)
    color = look.color(*CHINA)
    plain = look.surface(color, "ceramic")
    dish = lathe([(0, 0), (0.36, 0), (0.38, 0.2), (0.5, 0.94), (0.495, 1), (0.36, 0.5),
                  (0, 0.42)], 44).scale(x, y, h)  # fmt: skip
    band = look.chance(0.5)
    line = lathe([(0.44, 0.78), (0.462, 0.86), (0.462, 0.9), (0.44, 0.82)], 44, loop=True)
    tone = look.own_color("navy", "gold", "teal") if band else tint_color(color, 0.8)
    well = lathe([(0.355, 0.46), (0.372, 0.56), (0.372, 0.6), (0.355, 0.52)], 44, loop=True)
    shade = surfaces.plain(tint_color(color, 0.72))
    pieces = [(dish, plain), (line.scale(x, y, h), surfaces.plain(tone)),
              (well.scale(x, y, h), shade)]  # fmt: skip
    inner = stretch_parts([cylinder_part(0.37, 0.44 * h)], x, y)
    wall = ring_parts([(0.37, 0.02 * h), (0.5, 0.94 * h)], [(0.495, h), (0.36, 0.5 * h)],
                      stretch=(x, y))  # fmt: skip
    return shape(pieces, [*inner, *wall])


@category("cloche", size=(0.287, 0.287, 0.161), mass=0.9, material="ceramic", hollow=True,
          aliases=("food cover", "cake dome", "dome cover", "serving dome", "food dome",
          "cheese dome"), themes=("dining",), roles=("big", "round", "tall"),
          colors=("silver",))  # fmt: skip
def cloche(look: Look) -> Shape:
    """A steel or glass dome with a knob, covering a plate."""
    r, h = look.between(0.115, 0.14), look.between(0.1, 0.13)
    plate = lathe([(0, 0), (0.8 * r, 0), (1.12 * r, 0.012), (1.12 * r, 0.015), (0.8 * r, 0.006),
                   (0, 0.006)], 36)  # fmt: skip
    t = np.linspace(0, np.pi / 2, 9)
    arch = np.column_stack([r * np.cos(t) ** 0.8, 0.012 + h * np.sin(t)])[:-1]
    dome = lathe([(0, 0.0055), (r, 0.0055), *arch, (0, 0.012 + h)], 36)
    knob = lathe([(0, 0), (0.006, 0), (0.006, 0.012), (0.016, 0.02), (0.012, 0.03), (0, 0.031)],
                 20).move(z=h + 0.011)  # fmt: skip
    color = look.color("silver", "silver", "copper", "gold", "clear")
    skin = look.surface(color, "metal")
    tone = look.surface(look.own_color("black", "wooden", "gold"), "wood")
    china = surfaces.plain(look.own_color("white", "cream", "charcoal"))
    return shape([(plate, china), (dome, skin), (knob, tone)],
                 [hull_of(plate), hull_of(dome), hull_of(knob)])  # fmt: skip


@category("lazy_susan", size=(0.375, 0.375, 0.0403), mass=1.2, material="wood",
          aliases=("turntable tray", "rotating tray"), themes=("dining",),
          roles=("support", "flat", "round", "big"), colors=("wooden",))  # fmt: skip
def lazy_susan(look: Look) -> Shape:
    """A lazy Susan: a round turntable for dishes, on a low base."""
    r, h = look.between(0.17, 0.2), look.between(0.03, 0.04)
    color = look.color("wooden", "tan", "white", "black", "brown")
    skin = look.surface(color, "wood")
    foot = cylinder(0.55 * r, 0.5 * h, 32)
    disc = cylinder(r, 0.5 * h, 44, bevel=0.003).move(z=0.48 * h)
    ring = lathe([(0.96 * r, 0.97 * h), (r, 0.97 * h), (r, 1.12 * h), (0.96 * r, 1.12 * h)], 44,
                 loop=True)  # fmt: skip
    return shape([(foot, surfaces.plain(tint_color(color, 0.5))), (disc, skin),
                  (ring, surfaces.plain(tint_color(color, 0.75)))],
                 [cylinder_part(0.55 * r, 0.5 * h),
                  cylinder_part(r, 0.5 * h, (0, 0, 0.48 * h))])  # fmt: skip


def plate(look: Look) -> Shape:
    """A glazed dinner plate with a low or wide rim, or a coupe plate, often with painted rings."""
    r, h, t = look.between(0.11, 0.14), look.between(0.017, 0.028), 0.0045
    color = look.color(*("white", "white", "cream", "blue", "sage", "terracotta", "gray", "black",
                         "teal"), *("pink", "mustard", "navy"))  # fmt: skip
    well = look.pick([0.58, 0.66, 0.66, 0.78]) * r
    body = lathe([(0, 0), (well, 0), (well * 1.06, 0.003), (r, h - t * 0.6), (r, h),
                  (0.5 * (r + well * 1.08), 0.5 * (h + 0.009) - 0.001), (well * 1.08, 0.009),
                  (well, t + 0.002), (0.5 * well, t + 0.002), (0, t + 0.002)],
                 v=[0, 0, 0.05, 0.3, 0.32, 0.46, 0.6, 0.66, 0.84, 1])  # fmt: skip
    return shape([(body, _plate_glaze(look, color))], [
        cylinder_part(well, t + 0.002),
        *ring_parts([(well, 0), (r, h - t * 0.6), (r, h)], [(well, t + 0.002)], 16),
    ])  # fmt: skip


def _plate_glaze(look: Look, color: RGB) -> Tile:
    """Return a plate's glaze: the underside up to v = 0.3, the rim, and the well above v = 0.66."""
    glaze = look.surface(color, "ceramic")
    rim = look.own_color("navy", "gold", "teal", "white", "terracotta", "crimson", "black")
    kind = int(look.rng.integers(7))
    if look.material or kind == 0:
        return glaze
    if kind <= 2:
        wide = look.between(2, 14)
        return surfaces.stack((glaze, 31), (surfaces.plain(rim), wide), (glaze, 69 - wide))
    if kind == 3:
        line = surfaces.plain(rim)
        return surfaces.stack(
            (glaze, 31), (line, 3), (glaze, 4), (line, 1.5), (glaze, 24), (line, 1.5), (glaze, 35)
        )
    if kind == 4:
        pale = look.surface(look.pick([(244, 242, 236), tint_color(color, 1.4)]), "ceramic")
        return surfaces.stack((glaze, 31), (glaze_tile(look, color), 30), (pale, 39), side=192)
    if kind == 5:
        rings = surfaces.stripes([color, tint_color(color, 0.86)], 16, side=SIDE)
        return rings if look.chance(0.4) else surfaces.spots(
            look.rng, color, tint_color(color, 0.55), 0.05)  # fmt: skip
    return surfaces.gradient(tint_color(color, 0.45), tint_color(color, 1.3), look.rng, 9)


@category("tray", size=(0.42, 0.27, 0.053), mass=0.8, material="wood", hollow=True,
          aliases=("serving tray",), themes=("dining", "coffee", "kitchen"),
          roles=("container", "support", "big", "flat"), colors=("wooden", "white", "black"),
          common=True)  # fmt: skip
def tray(look: Look) -> Shape:
    """A serving tray with a low rim and two handles."""
    x, y, h = look.between(0.36, 0.42), look.between(0.25, 0.29), 0.035
    wall = 0.009
    color = look.color("wooden", "white", "black", "teal", "brown")
    tile = look.surface(color, "wood")
    grip = [
        tube([(side * x / 2, -0.06, h - 0.006), (side * (x / 2 + 0.012), -0.05, h + 0.016),
              (side * (x / 2 + 0.012), 0.05, h + 0.016), (side * x / 2, 0.06, h - 0.006)], 0.005, 8)
        for side in (-1, 1)
    ]  # fmt: skip
    dark = surfaces.plain(tint_color(color, 0.6))
    return shape(
        [*((solid, tile) for solid in open_box(x, y, h, wall, 0.008)), *((g, dark) for g in grip)],
        [*frame_parts(x, y, h, wall, 0.008), *map(hull_of, grip)],
    )


@category("sushi_plate", size=(0.22, 0.11, 0.046), mass=0.6, material="ceramic",
          aliases=("sushi", "sushi board", "sushi set"), themes=("dining", "food"),
          roles=("edible",), state="lying flat", common=True)  # fmt: skip
def sushi_plate(look: Look) -> Shape:
    """A board of sushi: rolls, and rice topped with fish or shrimp."""
    x, y = look.between(0.2, 0.24), look.between(0.1, 0.12)
    board = look.pick([
        surfaces.wood(look.rng, look.own_color("tan", "wooden", "brown")),
        surfaces.speckles(look.rng, look.own_color("black", "charcoal", "teal"), 4),
    ])  # fmt: skip
    plate = box(x, y, 0.008).move(z=0.01)
    feet = [box(0.012, 0.94 * y, 0.011).move(x=s * 0.36 * x) for s in (-1, 1)]
    rice_tile = surfaces.spots(look.rng, (244, 242, 232), (222, 218, 204), 0.25)
    fish, rice, rolls, dots = [], [], [], []
    for k in range(4):
        px = (k - 1.5) * 0.23 * x
        rice.append(block(0.022, 0.046, 0.02, 0.009, 0.005).move(px, 0.23 * y, 0.0175))
        top = ellipsoid(0.028, 0.064, 0.014, 14, 8).move(px, 0.23 * y, 0.04)
        fish.append(top.bend(lambda p: p - (p[:, 1:2] - 0.23 * y) ** 2 * [0, 0, 7.2]))
    for k in range(5):
        at = ((k - 2) * 0.185 * x, -0.2 * y, 0.0175)
        rolls.append(cylinder(0.0165, 0.025, 20).move(*at))
        rice.append(cylinder(0.0145, 0.0262, 18).move(*at))
        dots.append(cylinder(0.0065, 0.0275, 12).move(*at))
    stripes = [look.own_color("coral", "orange", "red"), look.own_color("coral", "pink", "cream")]
    salmon = surfaces.stripes([stripes[0]] * 3 + [tint_color(stripes[1], 1.5)], 7, side=96)
    filling = surfaces.plain(look.own_color("coral", "lime", "yellow", "orange"))
    return shape(
        [(join([plate, *feet]), board), (join(rice), rice_tile), (join(fish), salmon),
         (join(rolls), surfaces.speckles(look.rng, (30, 40, 34), 5)), (join(dots), filling)],
        [box_part(x, y, 0.018), hull_of(*fish, *rice[:4]), hull_of(*rolls)],
    )  # fmt: skip


CATEGORIES = (
    Category("plate", plate, size=(0.25, 0.25, 0.023), mass=0.5, material="ceramic", hollow=True,
             aliases=("dinner plate", "charger plate", "seder plate"), themes=("dining", "kitchen"),
             roles=("support", "flat", "round"), colors=("white", "cream", "blue"), common=True),
)  # fmt: skip
"""Objects that share their drawing functions."""
