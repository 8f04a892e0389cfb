"""Objects of the ``workbench`` theme: materials."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel, tool_steel
from ...kit.outlines import arc, rectangle
from ...kit.parts import box_part, flat_foot, hull_of, hull_part, ring_parts
from ...kit.primitives import at_box, lay_down, plate, side_view
from ...kit.shapes import Category, Shape, category, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, sweep, tube
from ...kit.surfaces import Look, tint_color


@category("scrap", size=(0.0983, 0.0813, 0.00334), mass=0.01, material="paper",
          aliases=("cardboard scrap", "metal scrap", "scrap of card", "scrap metal",
          "scrap of cardboard", "piece of cardboard", "torn card"), themes=("workbench",),
          roles=("flat",), colors=("tan", "gray"))  # fmt: skip
def scrap(look: Look) -> Shape:
    """A torn piece of card or metal, lying flat."""
    color = look.color("tan", "gray", "silver", "brown")
    n = 11
    a = 2 * np.pi * (np.arange(n) + 0.3 * look.rng.uniform(-1, 1, n)) / n
    r = look.between(0.035, 0.05) * look.rng.uniform(0.78, 1.15, n)
    made = plate(np.column_stack([1.2 * r * np.cos(a), r * np.sin(a)]), look.between(0.0025, 0.004))
    flat = "silver" if min(color) > 120 and max(color) - min(color) < 20 else "card"
    tile = steel(look, color) if flat == "silver" else surfaces.cardboard(look.rng, color)
    return put_down([(made, tile)], made)


@category("house_brick", size=(0.212, 0.101, 0.064), mass=2.6, material="stone",
          aliases=("house brick", "clay brick", "fired brick", "brick of clay", "masonry brick"),
          themes=("workbench",), roles=("support",), colors=("terracotta",))  # fmt: skip
def house_brick(look: Look) -> Shape:
    """A house brick with an indentation on top."""
    color = look.color("terracotta", "brown", "red", "cream", spread=14)
    k = look.between(0.92, 1.06)
    body = block(0.215, 0.1025, 0.06, 0.002)
    frame = [at_box(0.215, 0.02, 0.006, (0, s * 0.041, 0.059)) for s in (-1, 1)]
    frame += [at_box(0.035, 0.1025, 0.006, (s * 0.09, 0, 0.059)) for s in (-1, 1)]
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.12)
    whole = box(0.215, 0.1025, 0.065)
    return put_down([(body, surfaces.spots(look.rng, tint_color(color, 0.9), tint_color(color, 0.5),
                                           0.2)), (join(frame), tile)], whole,
                    factor=k)  # fmt: skip


@category("rope", size=(0.185, 0.135, 0.045), mass=0.15, material="fabric", assembled=True,
          friction=0.6, aliases=("coil of rope", "rope coil", "coiled rope", "cord",
          "nautical rope", "climbing rope", "paracord bundle", "loop of rope", "paracord",
          "leash rope"), themes=("workbench",), colors=("tan",))  # fmt: skip
def rope(look: Look) -> Shape:
    """A coil of rope lying flat, with one end wound around the coil."""
    k = look.between(0.85, 1.1)
    color = look.color("tan", "beige", "white", "blue", "tan", "orange", "green")
    strands = surfaces.stripes([color, tint_color(color, 0.78), tint_color(color, 1.15)], 24,
                               side=192)  # fmt: skip
    r, tilt = 0.006 * k, 1.0
    t = np.linspace(0, 1, 150)
    a = 2 * np.pi * 6 * t
    away = (0.056 + 0.012 * np.sin(2.7 * a * tilt)) * k
    z = r + (0.026 * k) * (0.5 - 0.5 * np.cos(1.31 * a)) * (0.35 + 0.65 * t)
    coil = tube(np.column_stack([1.2 * away * np.cos(a), away * np.sin(a), z]), r, 7)
    b = 2 * np.pi * np.linspace(0, 2.6, 40)
    wind = np.column_stack([0.024 * np.cos(b) * k, (0.021 - 0.009 * b / 2 / np.pi) * k,
                            (0.021 + 0.02 * np.sin(b)) * k])  # fmt: skip
    wind = tube(wind @ np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]]) + [0.066 * k, 0, 0], r, 7)
    high = float(coil.bounds[1, 2])
    return shape([(coil, strands), (wind, strands)],
                 ring_parts([(0.068 * k, 0.0005), (0.068 * k, 0.9 * high)],
                            [(0.042 * k, 0.9 * high), (0.042 * k, 0.0005)], 10,
                            stretch=(1.2, 1.0)))  # fmt: skip


@category("horseshoe_magnet", size=(0.061, 0.066, 0.0124), mass=0.08, material="metal",
          aliases=("magnet", "u magnet", "toy magnet"), themes=("workbench",), roles=("flat",),
          colors=("red",))  # fmt: skip
def horseshoe_magnet(look: Look) -> Shape:
    """A horseshoe magnet lying flat: a painted, U-shaped bar with bare metal poles."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "crimson", "blue")
    h = 0.012 * k
    curve = arc((0, 0), 0.024, 0, np.pi, 14)
    bow = np.concatenate([[(0.024, -0.022)], curve, [(-0.024, -0.022)]]) * k
    path = np.column_stack([bow, np.full(len(bow), h / 2)])
    body = sweep(path, rectangle(0.013 * k, h))
    tips = [box(0.0134 * k, 0.014 * k, h + 0.0004).move(s * 0.024 * k, -0.028 * k) for s in (-1, 1)]
    n = len(path)
    hulls = [hull_of(sweep(path[a:b], rectangle(0.013 * k, h))) for a, b in
             ((0, 4), (3, 7), (6, 11), (10, 14), (13, n))]  # fmt: skip
    return shape([(body, surfaces.speckles(look.rng, color, 4, 32)),
                  (join(tips), tool_steel(look))],
                 [*hulls, *(hull_of(s) for s in tips)])  # fmt: skip


@category("bar_magnet", size=(0.08, 0.018, 0.0104), mass=0.07, material="metal",
          aliases=("magnetic bar", "magnet bar", "rod magnet"), themes=("workbench",),
          roles=("flat",), colors=("red",))  # fmt: skip
def bar_magnet(look: Look) -> Shape:
    """A bar magnet with one red and one blue half."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "crimson")
    x, y, h = 0.08 * k, 0.018 * k, 0.01 * k
    halves = [box(x / 2, y, h).move(x=s * x / 4) for s in (-1, 1)]
    other = look.own_color("blue", "navy", "white", "silver")
    marks = [box(0.004 * k, 0.01 * k, 0.0006).move(s * 0.4 * x, 0, h - 0.0002) for s in (-1, 1)]
    return shape([(halves[0], surfaces.speckles(look.rng, color, 3, 32)),
                  (halves[1], surfaces.speckles(look.rng, other, 3, 32)),
                  (join(marks), surfaces.plain((246, 246, 242)))], [box_part(x, y, h)])  # fmt: skip


@category("sandpaper", size=(0.137, 0.107, 0.008), mass=0.02, material="paper", assembled=True,
          friction=0.7, aliases=("sand paper", "sandpaper sheet", "sheet of sandpaper",
          "emery paper", "abrasive paper", "glass paper"), themes=("workbench",), roles=("flat",),
          colors=("brown", "tan"), state="lying flat")  # fmt: skip
def sandpaper(look: Look) -> Shape:
    """Sheets of sandpaper lying flat, with one corner turned up."""
    k = look.between(0.85, 1.1)
    x, y, h = 0.14 * k, 0.11 * k, look.between(0.0012, 0.003)
    color = look.color("brown", "tan", "orange", "charcoal", "terracotta", "maroon")
    grit = surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.25)
    grit = np.clip(grit.astype(int) + look.rng.integers(-14, 14, grit.shape[:2])[..., None], 0, 255)
    sheet = box(x, y, h)
    curl = side_view(np.array([(0, 0), (0.02, 0.006), (0.021, 0.0072), (0, 0.0014)]) * k, 0.03 * k)
    curl = curl.turn(2, np.pi / 4).move(0.4 * x, 0.36 * y, h - 0.0004)
    back = prints.canvas(64, 64, (226, 214, 190))
    prints.write(back, look.pick(["P120", "P240", "P80", "P400"]), 0.5, 0.5, 0.24, (150, 110, 80))
    return shape([(sheet, grit.astype(np.uint8)), (curl, back)], [box_part(x, y, h)])


WOODEN = ("wooden", "tan", "beige", "brown", "wooden")


def _board(x: float, y: float, h: float) -> Callable[[Look], Shape]:
    """A sawn piece of wood, lying flat."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.1)
        body = box(x * k, y * k, h * k)
        tile = look.surface(look.color(*WOODEN), "wood")
        return shape([(body, tile)], [hull_of(body)])

    return make


def _rod(radius: float, long: float, palette: tuple[str, ...], material: str) -> Callable:
    """A round rod lying flat, slightly flattened at the bottom so that it does not roll."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.1)
        r = radius * k
        body = lay_down(cylinder(r, long * k, 24, bevel=0.1 * r), -long * k / 2, r)
        tile = look.surface(look.color(*palette), material)
        return shape([(body, tile)], [flat_foot(body.vertices, 0.08)])

    return make


@category("pipe", size=(0.198, 0.0277, 0.0277), mass=0.15, material="metal", aliases=("metal pipe",
          "copper pipe", "pvc pipe", "steel pipe", "plastic pipe", "pipe section", "pipe segment"),
          themes=("workbench",), colors=("copper", "silver"), state="lying flat")  # fmt: skip
def pipe(look: Look) -> Shape:
    """A length of pipe, lying flat."""
    k = look.between(0.88, 1.1)
    color = look.color("silver", "copper", "white", "gray", "copper", "charcoal")
    r, long = 0.014 * k, 0.2 * k
    body = lathe([(0.82 * r, 0), (r, 0), (r, long), (0.82 * r, long)], 24, loop=True)
    body = lay_down(body, -long / 2, r)
    outer = lay_down(cylinder(r, long, 24), -long / 2, r)
    return shape([(body, look.surface(color, "metal"))], [flat_foot(outer.vertices, 0.08)])


@category("tape_roll", size=(0.086, 0.086, 0.028), mass=0.08, material="plastic",
          aliases=("roll of tape", "tape", "duct tape", "masking tape", "sticky tape",
          "reel of tape", "toilet roll holder", "scotch tape roll", "washi tape",
          "double sided tape", "double-sided tape", "parafilm roll", "sellotape", "electrical tape",
          "insulating tape", "parcel tape", "packing tape"),
          themes=("workbench", "craft", "office"), roles=("round", "flat"),
          colors=("beige", "gray"), state="lying flat", common=True)  # fmt: skip
def tape_roll(look: Look) -> Shape:
    """A roll of adhesive tape, lying flat."""
    r, h = look.between(0.038, 0.048), look.between(0.022, 0.034)
    color = look.color("beige", "gray", "blue", "green", "yellow", "black")
    wound = surfaces.stripes([color, tint_color(color, 0.93)], 20, upright=True)
    tape = lathe([(0.6 * r, 0), (r, 0), (r, h), (0.6 * r, h)], 32, loop=True)
    core = lathe(
        [(0.55 * r, 0.001), (0.61 * r, 0.001), (0.61 * r, h - 0.001), (0.55 * r, h - 0.001)],
        32, loop=True,
    )  # fmt: skip
    wedges = []
    for k in range(8):
        a, b = 2 * np.pi * k / 8, 2 * np.pi * (k + 1) / 8
        points = [
            (rad * np.cos(t), rad * np.sin(t), z)
            for t in (a, (a + b) / 2, b) for rad in (0.57 * r, 0.99 * r) for z in (0, h)
        ]  # fmt: skip
        wedges.append(hull_part(points))
    return shape([(tape, wound), (core, surfaces.cardboard(look.rng))], wedges)


CATEGORIES = (
    Category("plank", _board(0.3, 0.08, 0.018), size=(0.297, 0.079, 0.0178), mass=0.27,
             material="wood", aliases=("wooden plank", "wood plank", "wood board", "piece of wood",
             "lumber", "timber", "floorboard", "scrap wood", "balsa wood sheet"),
             themes=("workbench",), roles=("flat", "support"), colors=("wooden",)),
    Category("wood_block", _board(0.09, 0.06, 0.045), size=(0.089, 0.0594, 0.0446), mass=0.15,
             material="wood", aliases=("block of wood", "wooden brick", "sanding block",
             "rectangular wooden block", "balsa wood block"), themes=("workbench",),
             colors=("wooden",)),
    Category("metal_rod", _rod(0.006, 0.2, ("silver", "gray", "brass", "copper"), "metal"),
             size=(0.198, 0.0119, 0.0119), mass=0.15, material="metal", aliases=("steel rod",
             "metal bar", "rod", "iron rod", "steel bar", "seat post", "handlebar stem"),
             themes=("workbench",), colors=("silver",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
