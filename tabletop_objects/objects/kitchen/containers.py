"""Objects of the ``kitchen`` theme: containers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.materials import steel
from ...kit.outlines import rectangle
from ...kit.parts import cylinder_part, frame_parts, hull_of, open_vessel, ring_parts
from ...kit.primitives import drum, standing
from ...kit.shapes import Category, Shape, category, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, open_box, torus
from ...kit.surfaces import RGB, Look, tint_color
from .bags import panel


@category("crate", size=(0.31, 0.225, 0.125), mass=0.9, material="wood", hollow=True,
          aliases=("wooden crate", "fruit crate", "apple crate", "vegetable crate", "produce crate",
          "wine crate", "milk crate"), themes=("kitchen",), roles=("container", "big"),
          colors=("wooden",))  # fmt: skip
def crate(look: Look) -> Shape:
    """An open crate: wood with slats, or plastic with holes."""
    x, y, h = look.between(0.28, 0.34), look.between(0.2, 0.24), look.between(0.11, 0.14)
    color = look.color("wooden", "tan", "brown", "beige", "wooden")
    skin = look.surface(color, "wood")
    t = 0.008
    slats = [box(x, t, 0.25 * h).move(y=s * (y / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
             for s in (-1, 1) for k in range(3)]  # fmt: skip
    slats += [box(t, y - 2 * t, 0.25 * h).move(x=s * (x / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
              for s in (-1, 1) for k in range(3)]  # fmt: skip
    floor = [box(x - 2 * t, 0.17 * y, t).move(y=(k - 2) * 0.185 * y) for k in range(5)]
    posts = [box(0.016, 0.016, h).move(a * (x / 2 - t - 0.008), b * (y / 2 - t - 0.008))
             for a in (-1, 1) for b in (-1, 1)]  # fmt: skip
    return shape([(join([*slats, *floor]), skin),
                  (join(posts), surfaces.plain(tint_color(color, 0.7)))],
                 frame_parts(x, y, 0.95 * h, t, t))  # fmt: skip


@category("butter_churn", size=(0.129, 0.129, 0.284), mass=0.9, material="wood",
          aliases=("churn", "milk churn"), themes=("kitchen",), roles=("tall",),
          colors=("wooden",))  # fmt: skip
def butter_churn(look: Look) -> Shape:
    """A butter churn: a wooden tub with hoops and a plunger through its lid."""
    color = look.color("wooden", "tan", "brown")
    k = look.between(0.8, 1.05)
    tub = standing((0.07, 0), (0.056, 0.18), (0.054, 0.18), sides=20)
    hoops = [standing((r, 0), (r - 0.0012, 0.014), at=(0, 0, z), sides=20) for r,
             z in ((0.0705, 0.02), (0.0645, 0.09), (0.0595, 0.15))]  # fmt: skip
    lid, stick = drum(0.058, 0.014, (0, 0, 0.178)), drum(0.008, 0.12, (0, 0, 0.19), sides=12)
    staves = surfaces.stripes(
        [color, tint_color(color, 0.82), tint_color(color, 1.12)], 6, upright=True
    )
    return put_down([(tub, staves), (join(hoops), steel(look, (120, 110, 100))),
                     (join([lid, stick]), surfaces.wood(look.rng, color))], tub, lid, stick,
                    factor=k)  # fmt: skip


@category("basket", size=(0.24, 0.19, 0.095), mass=0.35, material="wood", hollow=True,
          assembled=True, aliases=("fruit basket", "bread basket", "wicker basket",
          "storage basket", "bin", "creel", "hanging basket", "trug", "waste-paper basket",
          "tub of maggots"), themes=("kitchen", "dining", "craft"), roles=("container", "big"),
          colors=("tan", "brown"), common=True)  # fmt: skip
def basket(look: Look) -> Shape:
    """A woven basket that is open at the top and holds other objects."""
    color = look.color("tan", "brown", "beige", "wooden", "white")
    weave = surfaces.basketwork(look.rng, color)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.75), 6, 32)
    if look.chance(0.5):
        r, h, wall = look.between(0.1, 0.12), look.between(0.08, 0.1), 0.007
        low = 0.82 * r
        body = lathe([(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.008), (0, 0.008)],
                     v=[0, 0, 0.48, 0.52, 1, 1])  # fmt: skip
        rim = torus(r - wall / 2, 0.0065, 32, 8).move(z=h)
        return shape(
            [(body, weave), (rim, dark)],
            [*ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.008)]),
             cylinder_part(low, 0.008)],
        )  # fmt: skip
    x, y, h, wall = look.between(0.22, 0.27), look.between(0.15, 0.18), 0.09, 0.008
    rails = [block(x + 0.006, 0.012, 0.012, 0.003).move(y=side * (y - 0.008) / 2, z=h - 0.006)
             for side in (-1, 1)] + [block(0.012, y + 0.006, 0.012, 0.003).move(x=side * (x - 0.008)
                                                                                / 2, z=h - 0.006)
                                     for side in (-1, 1)]  # fmt: skip
    return shape([*((s, weave) for s in open_box(x, y, h, wall, wall)),
                  *((s, dark) for s in rails)], frame_parts(x, y, h, wall, wall))  # fmt: skip


@category("cup_lid", size=(0.0874, 0.0878, 0.0168), mass=0.004, material="plastic", hollow=True,
          aliases=("coffee cup lid", "coffee lid", "takeaway cup lid", "lid of a coffee cup",
          "travel cup lid"), themes=("kitchen",), roles=("round", "flat"), colors=("white",),
          state="lying flat")  # fmt: skip
def cup_lid(look: Look) -> Shape:
    """A plastic lid lying flat: a coffee cup lid with a sip hole, or a plain jar lid."""
    r = look.between(0.04, 0.046)
    color = look.color("white", "black", "white", "brown")
    low = lathe([(0, 0), (r, 0), (1.0 * r, 0.004), (0.93 * r, 0.006), (0.88 * r, 0.016),
                 (0.8 * r, 0.0165), (0.76 * r, 0.012), (0, 0.012)], 34)  # fmt: skip
    hole = block(0.012, 0.004, 0.0008, 0.0018).move(0, -0.84 * r, 0.016)
    tone = surfaces.plain(tint_color(color, 0.5))
    rib = lathe([(0, 0.0118), (0.34 * r, 0.0118), (0.32 * r, 0.0128), (0, 0.0128)], 24)
    return shape([(join([low, rib]), surfaces.speckles(look.rng, color, 3, 32)), (hole, tone)],
                 [hull_of(low)])  # fmt: skip


PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def tub(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float, float],
        oval: bool = False) -> Make:  # fmt: skip
    """Return a plastic tub with a printed lid, round or rectangular with rounded corners."""

    def make(look: Look) -> Shape:
        k = look.between(0.93, 1.07)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        ground = look.pick([PALE, PALE, tint_color(color, 1.6)])
        word = look.pick(words)
        band = surfaces.fit(panel(look, word, color, 128, 96), 96, 128)
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
            pieces = [(body, surfaces.plain(ground)), (lid, surfaces.plain(color)),
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
                (join([lid, neck]), surfaces.plain(ground)),
                (sign, panel(look, word, color)),
            ],
            [hull_of(body), cylinder_part(r, 0.16 * h, (0, 0, 0.84 * h - 0.0002))],
        )

    return make


@category("open_ice_bucket", size=(0.2, 0.185, 0.185), mass=1.0, material="metal",
          aliases=("empty ice bucket",), themes=("kitchen", "dining"),
          roles=("container", "round", "big"), colors=("silver",))  # fmt: skip
def open_ice_bucket(look: Look) -> Shape:
    """An empty ice bucket for bottles, with two ring handles."""
    r, h = look.between(0.085, 0.1), look.between(0.17, 0.2)
    color = look.color("silver", "silver", "copper", "gold", "black", "white")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.76 * r, 0), (r, h)], 0.004, 0.008)
    ring = torus(0.022, 0.0035, 20, 6).turn(1, np.pi / 2)
    ears = [ring.move(s * (0.93 * r + 0.003), 0, 0.74 * h) for s in (-1, 1)]
    return shape([(body, skin), (join(ears), skin)], [*parts, *(hull_of(e) for e in ears)])


@category("food_container", size=(0.186, 0.149, 0.0883), mass=0.45, material="plastic", hollow=True,
          aliases=("tupperware", "plastic container", "storage container", "plastic box",
          "food box", "food storage container"), themes=("kitchen", "office"),
          colors=("blue", "green"), opened="open_lunch_box")  # fmt: skip
def food_container(look: Look) -> Shape:
    """A plastic box for food with a coloured lid and clips."""
    x, y, h = look.between(0.15, 0.2), look.between(0.11, 0.14), look.between(0.06, 0.09)
    color = look.color("red", "blue", "green", "teal", "orange", "pink", "gray", "yellow")
    food = look.pick([(214, 222, 224), (214, 222, 224), (220, 120, 60), (120, 160, 70),
                      (230, 210, 160)])  # fmt: skip
    clear = surfaces.plain((208, 218, 222))
    tile = surfaces.stack((surfaces.speckles(look.rng, food, 16, 32), 70), (clear, 30))
    outline = rectangle(1, 1, 0.12, 5)
    rings = np.stack([np.column_stack([outline * [x * k, y * k], np.full(len(outline), z)])
                      for k, z in ((0.9, 0), (0.93, 0.006), (1.0, h))])  # fmt: skip
    body = loft(rings, outline)
    lid = block(x + 0.008, y + 0.008, 0.014, 0.024, 0.003).move(z=h - 0.004)
    inset = block(0.8 * x, 0.76 * y, 0.002, 0.018).move(z=h + 0.0095)
    skin = look.surface(color, "plastic")
    clips = [box(0.05, 0.006, 0.022).move(y=s * (y / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    clips += [box(0.006, 0.04, 0.022).move(x=s * (x / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    return shape([(body, tile), (join([lid, *clips]), skin),
                  (inset, surfaces.plain(tint_color(color, 1.25)))],
                 [hull_of(body), hull_of(lid)], opacity=0.9)  # fmt: skip


CATEGORIES = (
    Category("cream_tub", tub(("CREAM", "RICOTTA", "COTTAGE", "LABNEH", "HUMMUS", "CREME"), ("sky",
             "green", "blue", "red", "teal"), (0.095, 0.095, 0.075)), size=(0.093, 0.0934, 0.0739),
             mass=0.28, material="plastic", aliases=("sour cream tub", "tub of cream",
             "cottage cheese tub", "ricotta tub", "mascarpone tub", "labneh tub", "cottage cheese",
             "ricotta", "mascarpone", "tub of hummus", "sour cream", "tub of sour cream",
             "cream pot", "creme fraiche", "pot of cream", "labneh", "bicarb tub",
             "bicarbonate of soda", "plastic tub", "food tub", "tub of yogurt", "yogurt tub",
             "protein tub"), themes=("kitchen",), roles=("round",), colors=("sky",)),
    Category("margarine_tub", tub(("SPREAD", "SUNNY", "LIGHT", "BUTTER"), ("yellow", "gold",
             "green", "blue"), (0.15, 0.105, 0.06), True), size=(0.147, 0.103, 0.059), mass=0.5,
             material="plastic", aliases=("margarine", "tub of margarine", "butter tub",
             "tub of butter", "spreadable butter", "spread tub", "tub of spread"),
             themes=("kitchen",), colors=("yellow",)),
    Category("ice_cream_tub", tub(("ICE CREAM", "VANILLA", "GELATO", "COOKIE"), ("brown", "pink",
             "sky", "cream", "purple"), (0.098, 0.098, 0.105)), size=(0.1, 0.101, 0.108), mass=0.45,
             material="plastic", aliases=("ice cream carton", "tub of ice cream", "ice cream pot",
             "carton of ice cream", "ice cream container", "gelato tub", "sorbet tub",
             "pint of ice cream"), themes=("kitchen",), roles=("round",), colors=("brown", "pink")),
)  # fmt: skip
"""Objects that share their drawing functions."""
