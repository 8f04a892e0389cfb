"""Biscuits, bars and small cakes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck
from ...build.settled import scatter
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, prism
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin
from .loaves import crust


def biscuit_slab(
    top: RGB,
    dots: RGB,
    count: int,
    side: int,
    palette: tuple[str, ...],
    form: tuple[float, float, float],
):
    """Return a bar or finger: a baked slab with specks and holes."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        x, y, h = (v * k for v in form)
        body = block(x, y, h, 0.004, 0.0015)
        color = look.color(*palette) if palette else top
        tile = speck(skin(look, color, tint_color(color, 0.82), 0.8), look.rng, dots, count, side)
        return shape([(body, tile)], [box_part(x, y, h)])

    return make


def shortbread(look: Look) -> Shape:
    """A finger of shortbread with rows of pricks, or a round petticoat tail."""
    k = look.between(0.92, 1.1)
    x, y, h = 0.08 * k, 0.026 * k, 0.015 * k
    body = block(x, y, h, 0.003, 0.0015)
    holes = [cylinder(0.0017, 0.0008, 8).move((n - 2.5) * 0.15 * x, s * 0.22 * y, h - 0.0005)
             for n in range(6) for s in (-1, 1)]  # fmt: skip
    pale = skin(look, tint_color(look.color("cream", "tan"), 0.97), (218, 168, 96), 0.7)
    return shape([(body, pale), (join(holes), textures.plain((170, 116, 60)))],
                 [box_part(x, y, h)])  # fmt: skip


def biscotti(look: Look) -> Shape:
    """A long crisp slice with almonds."""
    k = look.between(0.9, 1.1)
    half = [(-0.055, 0), (-0.05, 0.012), (-0.02, 0.02), (0.02, 0.02), (0.05, 0.012), (0.055, 0)]
    outline = np.array([(x, y - 0.008) for x, y in half[::-1]]) * k
    body = prism(outline, 0, 0.016 * k, 0.001)
    face = speck(skin(look, (222, 170, 104), (186, 124, 62), 0.8), look.rng, (246, 226, 190), 16,
                 9)  # fmt: skip
    return shape([(body, face)], [hull_of(body)])


def madeleine(look: Look) -> Shape:
    """A shell-shaped little sponge, its ribs up."""
    k = look.between(0.9, 1.1)
    shell = lobe(lathe([(0, 0), (0.026, 0), (0.024, 0.006), (0.014, 0.015), (0, 0.018)], 64), 22,
                 0.06)  # fmt: skip
    body = shell.scale(1.4, 0.92, 1).bend(lambda p: p * np.column_stack(
        [np.ones(len(p)), 1 - 5.0 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    return shape([(body, skin(look, (232, 184, 104), (176, 108, 48), 0.9))],
                 [hull_of(body)]).scale(k)  # fmt: skip


def stroopwafel(look: Look) -> Shape:
    """Two thin waffles with syrup between."""
    r, h = look.between(0.038, 0.046), look.between(0.009, 0.011)
    plates: list[Solid] = [cylinder(r, 0.38 * h, 34), cylinder(r, 0.38 * h, 34).move(z=0.6 * h)]
    syrup = cylinder(0.97 * r, 0.3 * h, 34).move(z=0.35 * h)
    net = textures.grid((150, 92, 44), (206, 146, 82), 10, 10, width=3)
    return shape([(join(plates), net), (syrup, textures.plain((112, 56, 20)))],
                 [cylinder_part(r, 0.98 * h)])  # fmt: skip


def teacake(look: Look) -> Shape:
    """A chocolate-covered dome of marshmallow on a biscuit."""
    r = look.between(0.027, 0.032)
    dome = lathe([(0, 0), (r, 0), (r, 0.2 * r), (0.92 * r, 0.6 * r), (0.6 * r, 1.05 * r),
                  (0, 1.2 * r)], 26)  # fmt: skip
    dark = textures.speckles(look.rng, tint_color(look.color("brown", "brown", "white"), 0.6), 5)
    foot = cylinder(1.04 * r, 0.14 * r, 26)
    return shape([(join([dome, foot]), dark)], [hull_of(dome, foot)])


def eccles(look: Look) -> Shape:
    """A round flat currant cake with three cuts and sugar."""
    r, h = look.between(0.038, 0.044), look.between(0.022, 0.027)
    body = lathe([(0, 0), (0.85 * r, 0), (r, 0.4 * h), (0.85 * r, 0.85 * h), (0.4 * r, h), (0, h)],
                 26)  # fmt: skip
    cuts = [ellipsoid(0.03, 0.0035, 0.003, 8, 4).move(0, 0.011 * n, 0.99 * h) for n in (-1, 0, 1)]
    crumbs = scatter(look, 0.6 * r, 22, (0.0018, 0.0028), 0.96 * h)
    return shape([(body, crust(look)), (join(cuts), textures.plain((60, 32, 24))),
                  (crumbs, textures.plain((252, 250, 246)))], [hull_of(body)])  # fmt: skip


_T = ("coffee", "tea")
_E = ("edible",)
_L = "lying flat"


CATEGORIES = (
    vary(Category("flapjack", biscuit_slab((206, 150, 78), (238, 206, 140), 90, 5, (), (0.075,
             0.05,
             0.02)), (0.0755, 0.0504, 0.0201), 0.06, ("oat flapjack", "nut bar"), _T, _E, ())),
    Category("blondie", biscuit_slab((228, 184, 116), (112, 66, 38), 16, 7, (), (0.062, 0.062,
             0.03)), (0.0636, 0.0636, 0.0308), 0.07, ("blondie square", "traybake square",
             "blondies"), _T, _E, ()),
    vary(Category("crispy_square", biscuit_slab((240, 214, 156), (252, 238, 206), 90, 7, (),
             (0.062,
             0.062, 0.034)), (0.0616, 0.0616, 0.0338), 0.03, ("rice crispy square",
             "rice krispie treat", "rice crispy treat", "rice krispie square", "crispy cake"), _T,
             _E, ())),
    Category("shortbread", shortbread, (0.0797, 0.0259, 0.0152), 0.02, ("shortbread finger",
             "shortbread biscuit", "shortbread cookie"), _T, _E, ("cream",), state=_L),
    vary(Category("biscotti", biscotti, (0.112, 0.0204, 0.0163), 0.025, ("biscotto", "cantuccini",
             "biscottis"), _T, _E, (), state=_L)),
    vary(Category("madeleine", madeleine, (0.071, 0.0469, 0.0172), 0.025, ("madeleine cake",
             "maamoul"), _T, _E, (), state=_L)),
    Category("stroopwafel", stroopwafel, (0.0863, 0.0867, 0.00966), 0.035, ("syrup waffle",
             "dutch waffle"), _T, ("edible", "flat", "round"), (), state=_L),
    vary(Category("teacake", teacake, (0.0604, 0.0608, 0.0351), 0.03, ("tea cake",
             "chocolate teacake",
             "marshmallow teacake", "chocolate kiss"), _T, ("edible", "round"), ("brown",))),
    Category("eccles_cake", eccles, (0.0798, 0.0804, 0.0266), 0.06, ("welsh cake", "chorley cake",
             "banbury cake", "mince pie"), _T, ("edible", "round", "flat"), ("amber",)),
)  # fmt: skip
"""The module's categories."""
