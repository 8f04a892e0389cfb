"""Groceries in tins and tubs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .packets import panel

STEEL: RGB = (196, 199, 204)
PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def tin(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float], lid: str
        ) -> Make:  # fmt: skip
    """Return a round labelled tin: ``form`` is its radius and height; "push" or "ring" lid."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        r, h = form[0] * k, form[1] * look.between(0.94, 1.08)
        color = look.color(*palette)
        ground = look.pick([PALE, (250, 232, 170), tint_color(color, 0.5)])
        label = prints.label(look.rng, look.pick(words), color, ground)
        metal = textures.brushed_metal(look.rng, STEEL if lid == "ring" else (206, 180, 110))
        body = cylinder(0.985 * r, 0.94 * h, 36).move(z=0.03 * h)
        rims = [cylinder(r, 0.035 * h, 36, bevel=0.0006), cylinder(r, 0.035 * h, 36, bevel=0.0006)
                .move(z=0.965 * h)]  # fmt: skip
        pieces: list[tuple[Solid, textures.Tile]] = [(body, label), (join(rims), metal)]
        if lid == "push":
            cap = cylinder(0.86 * r, 0.004, 32, bevel=0.001).move(z=h - 0.0004)
            pieces.append((cap, metal))
            return shape(pieces, [cylinder_part(r, h + 0.0034)])
        top = cylinder(0.9 * r, 0.0006, 32).move(z=h - 0.0003)
        tab = box(0.012, 0.02, 0.0012).move(0, -0.3 * r, h)
        pieces += [(top, textures.brushed_metal(look.rng, tint_color(STEEL, 0.92))), (tab, metal)]
        return shape(pieces, [cylinder_part(r, h), hull_of(tab)])

    return make


def tub(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float, float],
        oval: bool = False) -> Make:  # fmt: skip
    """Return a plastic tub with a printed lid, round or rectangular with round corners."""

    def make(look: Look) -> Shape:
        k = look.between(0.93, 1.07)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        ground = look.pick([PALE, PALE, tint_color(color, 1.6)])
        word = look.pick(words)
        band = textures.fit(panel(look, word, color, 128, 96), 96, 128)
        wrap = np.concatenate([band, band, band], axis=1)
        if oval:
            ring = rectangle(x, y, 0.24 * y, 5)
            levels = [(0.86, 0.0), (0.97, 0.86 * h)]
            body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)])
                                  for f, z in levels]), ring)  # fmt: skip
            lid = block(x, y, 0.16 * h, 0.24 * y, 0.002).move(z=0.84 * h)
            sign = block(0.9 * x, 0.86 * y, 0.0006, 0.2 * y).move(z=h - 0.0003)
            parts = [hull_of(body), hull_of(lid)]
            front = box(0.6 * x, 0.0006, 0.6 * h).turn(0, -0.1).move(y=-0.465 * y, z=0.14 * h)
            pieces = [(body, textures.plain(ground)), (lid, textures.plain(color)),
                      (sign, panel(look, word, color, 150, 104)), (front, band)]  # fmt: skip
            return shape(pieces, parts)
        r = x / 2
        body = lathe([(0, 0), (0.84 * r, 0), (0.97 * r, 0.82 * h), (0, 0.82 * h)], 34,
                     v=[0, 0, 1, 1])  # fmt: skip
        lid = cylinder(r, 0.16 * h, 34, bevel=0.0015).move(z=0.84 * h - 0.0002)
        neck = cylinder(0.96 * r, 0.04 * h, 34).move(z=0.81 * h)
        sign = cylinder(0.9 * r, 0.0006, 34).move(z=h - 0.0004)
        return shape(
            [
                (body, wrap),
                (join([lid, neck]), textures.plain(ground)),
                (sign, panel(look, word, color)),
            ],
            [hull_of(body), cylinder_part(r, 0.16 * h, (0, 0, 0.84 * h - 0.0002))],
        )

    return make


_K = ("kitchen",)
_R = ("round",)


CATEGORIES = (
    Category("cocoa_tin", tin(("COCOA", "BAKING", "CUSTARD", "CHOCOLATE", "MUSTARD"), ("brown",
             "red", "yellow", "navy", "green"), (0.042, 0.115), "push"), (0.0853, 0.0853, 0.118),
             0.3, ("tin of cocoa", "baking powder tin", "baking powder", "custard powder tin",
             "custard powder", "drinking chocolate tin", "cocoa powder", "tin of custard powder",
             "hot chocolate tin", "mustard powder tin", "powder tin"), _K, _R,
             ("brown",)),
    Category("syrup_tin", tin(("SYRUP", "TREACLE", "MILK", "GOLDEN"), ("green", "gold", "red",
             "blue", "navy"), (0.038, 0.085), "push"), (0.0752, 0.0752, 0.0885), 0.5,
             ("golden syrup tin", "treacle tin", "condensed milk tin", "golden syrup", "treacle",
             "tin of treacle", "condensed milk", "tin of golden syrup", "evaporated milk",
             "tin of condensed milk", "molasses tin"), _K, _R, ("green", "gold")),
    Category("fruit_tin", tin(("PEACHES", "PINEAPPLE", "BEANS", "CHICKPEAS", "PEAS", "SPAGHETTI"),
             ("yellow", "teal", "orange", "green", "blue"), (0.037, 0.108), "ring"),
             (0.073, 0.073, 0.109), 0.45, ("can of pineapple", "tin of peaches", "can of peaches",
             "baked bean tin", "tin of pineapple", "can of chickpeas", "tinned fruit",
             "canned fruit", "tin of peas", "fruit can", "food tin", "can of fruit", "canned peas",
             "tin of chickpeas", "pineapple tin", "peach tin", "fruit cocktail tin"), _K, _R,
             ("yellow",)),
    Category("caviar_tin", tin(("CAVIAR", "SAFFRON", "PATE", "BALM"), ("navy", "black", "gold",
             "red"), (0.034, 0.024), "push"), (0.0683, 0.0683, 0.0277), 0.09, ("saffron tin",
             "tin of caviar", "caviar", "snuff tin", "pate tin", "salve tin",
             "pastille tin"), _K, ("round", "flat"), ("navy",)),
    Category("cream_tub", tub(("CREAM", "RICOTTA", "COTTAGE", "LABNEH", "HUMMUS", "CREME"), ("sky",
             "green", "blue", "red", "teal"), (0.095, 0.095, 0.075)), (0.093, 0.0934, 0.0739), 0.28,
             ("sour cream tub", "tub of cream", "cottage cheese tub", "ricotta tub",
              "mascarpone tub", "labneh tub", "cottage cheese", "ricotta", "mascarpone",
              "tub of hummus", "sour cream", "tub of sour cream", "cream pot",
              "creme fraiche", "pot of cream", "labneh", "bicarb tub", "bicarbonate of soda",
              "plastic tub", "food tub", "tub of yogurt", "yogurt tub",
              "protein tub"), _K, _R, ("sky",)),
    Category("margarine_tub", tub(("SPREAD", "SUNNY", "LIGHT", "BUTTER"), ("yellow", "gold",
             "green", "blue"), (0.15, 0.105, 0.06), True), (0.147, 0.103, 0.059), 0.5, ("margarine",
             "tub of margarine", "butter tub", "tub of butter", "spreadable butter", "spread tub",
             "tub of spread"), _K, (), ("yellow",)),
    Category("ice_cream_tub", tub(("ICE CREAM", "VANILLA", "GELATO", "COOKIE"), ("brown", "pink",
             "sky", "cream", "purple"), (0.098, 0.098, 0.105)), (0.1, 0.101, 0.108), 0.45,
             ("ice cream carton", "tub of ice cream", "ice cream pot", "carton of ice cream",
              "ice cream container", "gelato tub", "sorbet tub", "pint of ice cream"), _K, _R,
             ("brown", "pink")),
)  # fmt: skip
"""The module's categories."""
