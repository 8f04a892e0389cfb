"""Objects of the ``coffee`` theme: cookies."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import lobe
from ...kit.shapes import Category, Shape, category, shape, vary
from ...kit.solids import Solid, block, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, speck, tint_color


def biscuit_slab(
    top: RGB,
    dots: RGB,
    count: int,
    side: int,
    palette: tuple[str, ...],
    form: tuple[float, float, float],
):
    """Return a bar or finger of baked dough with specks and holes."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        x, y, h = (v * k for v in form)
        body = block(x, y, h, 0.004, 0.0015)
        color = look.color(*palette) if palette else top
        tile = speck(skin(look, color, tint_color(color, 0.82), 0.8), look.rng, dots, count, side)
        return shape([(body, tile)], [box_part(x, y, h)])

    return make


@category("shortbread", size=(0.0797, 0.0259, 0.0152), mass=0.02, material="food",
          aliases=("shortbread finger", "shortbread biscuit", "shortbread cookie"),
          themes=("coffee", "tea"), roles=("edible",), colors=("cream",),
          state="lying flat")  # fmt: skip
def shortbread(look: Look) -> Shape:
    """A finger of shortbread with rows of holes, or a round petticoat tail."""
    k = look.between(0.92, 1.1)
    x, y, h = 0.08 * k, 0.026 * k, 0.015 * k
    body = block(x, y, h, 0.003, 0.0015)
    holes = [cylinder(0.0017, 0.0008, 8).move((n - 2.5) * 0.15 * x, s * 0.22 * y, h - 0.0005)
             for n in range(6) for s in (-1, 1)]  # fmt: skip
    pale = skin(look, tint_color(look.color("cream", "tan"), 0.97), (218, 168, 96), 0.7)
    return shape([(body, pale), (join(holes), surfaces.plain((170, 116, 60)))],
                 [box_part(x, y, h)])  # fmt: skip


@category("biscotti", size=(0.112, 0.0204, 0.0163), mass=0.025, material="food",
          aliases=("biscotto", "cantuccini", "biscottis"), themes=("coffee", "tea"),
          roles=("edible",), state="lying flat")  # fmt: skip
@vary()
def biscotti(look: Look) -> Shape:
    """A long, crisp biscuit with almonds."""
    k = look.between(0.9, 1.1)
    half = [(-0.055, 0), (-0.05, 0.012), (-0.02, 0.02), (0.02, 0.02), (0.05, 0.012), (0.055, 0)]
    outline = np.array([(x, y - 0.008) for x, y in half[::-1]]) * k
    body = prism(outline, 0, 0.016 * k, 0.001)
    face = speck(skin(look, (222, 170, 104), (186, 124, 62), 0.8), look.rng, (246, 226, 190), 16,
                 9)  # fmt: skip
    return shape([(body, face)], [hull_of(body)])


@category("stroopwafel", size=(0.0863, 0.0867, 0.00966), mass=0.035, material="food",
          aliases=("syrup waffle", "dutch waffle"), themes=("coffee", "tea"),
          roles=("edible", "flat", "round"), state="lying flat")  # fmt: skip
def stroopwafel(look: Look) -> Shape:
    """A stroopwafel: two thin waffles with syrup between them."""
    r, h = look.between(0.038, 0.046), look.between(0.009, 0.011)
    plates: list[Solid] = [cylinder(r, 0.38 * h, 34), cylinder(r, 0.38 * h, 34).move(z=0.6 * h)]
    syrup = cylinder(0.97 * r, 0.3 * h, 34).move(z=0.35 * h)
    net = surfaces.grid((150, 92, 44), (206, 146, 82), 10, 10, width=3)
    return shape([(join(plates), net), (syrup, surfaces.plain((112, 56, 20)))],
                 [cylinder_part(r, 0.98 * h)])  # fmt: skip


@category("gingerbread_man", size=(0.112, 0.155, 0.012), mass=0.04, material="food",
          aliases=("gingerbread", "gingerbread cookie", "gingerbread biscuit",
          "gingerbread man ornament"), themes=("coffee", "tea"), roles=("edible", "flat"),
          colors=("brown",), state="lying flat")  # fmt: skip
def gingerbread_man(look: Look) -> Shape:
    """A gingerbread man lying on his back, with eyes, a smile and buttons of icing."""
    k, t = look.between(0.9, 1.1), look.between(0.009, 0.012)
    head = prism(ellipse(0.052, 0.052, 24), 0, t, 0.002).move(y=0.046)
    trunk = prism(rectangle(0.044, 0.07, 0.016), 0, t, 0.002).move(y=-0.005)
    arms = prism(rectangle(0.112, 0.026, 0.0125), 0.0001, t - 0.0001, 0.002).move(y=0.012)
    legs = [prism(rectangle(0.028, 0.066, 0.0135), 0.0001, t - 0.0002, 0.002)
            .turn(2, s * 0.24).move(s * 0.02, -0.05) for s in (-1, 1)]  # fmt: skip
    parts = [head, trunk, arms, *legs]
    dot = cylinder(0.0028, 0.002, 10).move(z=t - 0.0008)
    eyes = [dot.move(s * 0.009, 0.053) for s in (-1, 1)]
    buttons = [dot.scale(1.3, 1.3, 1).move(0, y) for y in (0.012, -0.006, -0.024)]
    a = np.linspace(-2.5, -0.64, 8)
    lips = tube(np.column_stack([0.013 * np.cos(a), 0.048 + 0.013 * np.sin(a), np.full(8, t)]),
                0.0012, 5)  # fmt: skip
    cuffs = [tube([(s * 0.047, 0.001, t), (s * 0.044, 0.012, t), (s * 0.047, 0.023, t)], 0.0013, 5)
             for s in (-1, 1)]  # fmt: skip
    cuffs += [tube([(s * 0.02, -0.071, t), (s * 0.03, -0.068, t), (s * 0.038, -0.066, t)], 0.0013,
                   5) for s in (-1, 1)]  # fmt: skip
    icing = surfaces.plain((250, 248, 242))
    tone = surfaces.plain(look.own_color("red", "green", "blue"))
    brown = surfaces.speckles(look.rng, look.color("copper", "brown", "bronze"), 8)
    made = shape([(join(parts), brown), (join([*eyes, lips, *cuffs]), icing),
                  (join(buttons), tone)], [hull_of(p) for p in parts])  # fmt: skip
    return made.scale(k)


@category("macaron", size=(0.0482, 0.0482, 0.0261), mass=0.018, material="food",
          aliases=("macaroon", "french macaron"), themes=("coffee", "tea"),
          roles=("edible", "round"), colors=("pink", "mint"))  # fmt: skip
def macaron(look: Look) -> Shape:
    """A macaron: two smooth almond shells with ruffled edges and a cream filling."""
    r, h = look.between(0.021, 0.025), look.between(0.024, 0.028)
    color = look.color("pink", "mint", "yellow", "lavender", "brown", "coral", "sky", "green")
    shell = [(0, 0), (0.7 * r, 0.01 * h), (0.95 * r, 0.13 * h), (r, 0.24 * h), (r, 0.38 * h),
             (0, 0.38 * h)]  # fmt: skip
    lower = lathe(shell, 28)
    upper = lathe([(x, h - z) for x, z in shell[::-1]], 28)
    feet = [lobe(torus(r, 0.045 * h, 48, 6), 20, 0.05).move(z=z) for z in (0.36 * h, 0.64 * h)]
    cream = cylinder(0.96 * r, 0.26 * h, 26).move(z=0.37 * h)
    white = surfaces.plain(tint_color(color, 1.55))
    pieces = [(join([lower, upper, *feet]), surfaces.speckles(look.rng, color, 5)), (cream, white)]
    return shape(pieces, [hull_of(*(s for s, _ in pieces))])


CATEGORIES = (
    Category("flapjack", vary()(biscuit_slab((206, 150, 78), (238, 206, 140), 90, 5, (),
             (0.075, 0.05, 0.02))), size=(0.0755, 0.0504, 0.0201), mass=0.06, material="food",
             aliases=("oat flapjack", "nut bar"), themes=("coffee", "tea"), roles=("edible",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
