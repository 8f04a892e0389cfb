"""Objects of the ``tea`` theme: teaware."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_above, hull_of, hull_part, ring_parts
from ...kit.primitives import limb, lobe
from ...kit.shapes import Shape, category, settle, shape
from ...kit.solids import box, cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import Look, speck, tint_color


@category("tea_strainer", size=(0.146, 0.0599, 0.0303), mass=0.03, material="metal", assembled=True,
          aliases=("tea infuser", "tea ball", "tea filter", "tea sieve", "loose leaf strainer"),
          themes=("tea",), colors=("silver",), state="lying flat")  # fmt: skip
def tea_strainer(look: Look) -> Shape:
    """A small mesh tea strainer with a handle, lying flat, or a tea ball on a chain."""
    steel = look.surface(look.color("silver", "silver", "gold", "copper"), "metal")
    mesh = surfaces.grid((120, 124, 128), (206, 209, 213), 30, 44, 96)
    if look.chance(0.4):
        d = look.between(0.042, 0.05)
        ball = ellipsoid(d, d, d, 26, 16)
        seam = torus(0.5 * d, 0.0022, 30, 6)
        links = [
            torus(0.004, 0.0011, 10, 5)
            .turn(0, np.pi / 2 * (k % 2))
            .move(0.55 * d + 0.0062 * k, 0.3 * d * np.sin(0.35 * k), -0.42 * d + 0.0035)
            for k in range(12)
        ]
        return settle([(ball, mesh), (join([seam, *links]), steel)], 0.07, hulls=[[0], [1]])
    r, h = look.between(0.027, 0.033), look.between(0.022, 0.028)
    t = np.linspace(0.3, np.pi / 2, 5)
    outer = [(r * np.sin(a), h * (1 - np.cos(a))) for a in t]
    low = outer[0][1]
    outer = [(x, z - low) for x, z in outer]
    inner = [(x - 0.0014, max(z, 0.0016)) for x, z in outer]
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.0016)], 28)
    rim = torus(r, 0.0022, 30, 6).move(z=h - low)
    bar = limb([(r, 0, h - low), (r + 0.03, 0, h - low), (r + 0.085, 0, 0.002),
                (r + 0.09, 0, 0.002)], [0.003, 0.004, 0.0045, 0.002], 10, 0.5)  # fmt: skip
    walls = ring_parts([outer[0], outer[2], outer[4]], [inner[4], inner[0]], 12)
    return shape([(cup, mesh), (join([rim, bar]), steel)],
                 [*walls, cylinder_part(outer[0][0], 0.002), hull_above(bar)])  # fmt: skip


@category("tea_bag", size=(0.0893, 0.0759, 0.00882), mass=0.003, material="paper", assembled=True,
          aliases=("teabag", "bag of tea", "tea sachet", "used tea bag"), themes=("tea",),
          roles=("flat",), colors=("cream",), state="lying flat")  # fmt: skip
def tea_bag(look: Look) -> Shape:
    """A tea bag lying flat with its string and paper tag beside it."""
    x, y, h = look.between(0.048, 0.056), look.between(0.058, 0.066), look.between(0.008, 0.011)
    color = look.color("cream", "beige", "tan")
    bag = ellipsoid(x, y, h, 20, 10).bend(lambda p: np.column_stack([
        np.sign(p[:, 0]) * np.abs(p[:, 0] / (x / 2)) ** 0.4 * x / 2,
        np.sign(p[:, 1]) * np.abs(p[:, 1] / (y / 2)) ** 0.4 * y / 2, p[:, 2]]))  # fmt: skip
    leaf = surfaces.spots(look.rng, tint_color(color, 0.85), (120, 78, 40), 0.3)
    hem = box(x, 0.003, 0.0016).move(y=0.49 * y, z=-0.0008)
    string = tube(smooth([(0, 0.5 * y, 0), (0.3 * x, 0.7 * y, -0.3 * h),
                          (0.9 * x, 0.6 * y, -0.42 * h),
                          (1.0 * x, 0.2 * y, -0.42 * h)], 5), 0.0006, 5)  # fmt: skip
    tag = box(0.024, 0.026, 0.0012).move(1.0 * x, 0.02 * y, -0.44 * h)
    print_ = prints.canvas(64, 64, look.own_color("green", "red", "yellow", "orange", "purple"))
    prints.write(print_, "TEA", 0.5, 0.5, 0.34, (250, 250, 244), bold=True)
    return settle([(bag, leaf), (join([hem, string]), surfaces.plain((244, 240, 230))),
                   (tag, print_)], 0.06, hulls=[[0], [2]])  # fmt: skip


@category("tea_cosy", size=(0.221, 0.132, 0.217), mass=0.1, material="fabric", hollow=True,
          aliases=("tea cozy", "teapot cosy", "teapot cozy", "teapot cover"), themes=("tea",),
          roles=("big",), colors=("red", "teal"))  # fmt: skip
def tea_cosy(look: Look) -> Shape:
    """A quilted or knitted tea cosy with a bobble on top."""
    x, h = look.between(0.2, 0.24), look.between(0.17, 0.2)
    color = look.color("red", "teal", "pink", "cream", "navy", "mustard", "sage")
    t = np.linspace(0, np.pi / 2, 8)
    arch = np.column_stack([0.5 * np.cos(t) ** 0.6, 0.05 + 0.95 * np.sin(t)])[:-1]
    body = lathe([(0, 0), (0.5, 0), *arch, (0, 1)], 36).scale(x, 0.6 * x, h)
    bobble = ellipsoid(0.04, 0.04, 0.036, 16, 10).move(z=h + 0.012)
    band = lathe([(0.49, 0.0), (0.515, 0.0), (0.515, 0.08), (0.49, 0.08)], 36, loop=True)
    knit = look.pick([surfaces.knitting(look.rng, color), surfaces.fabric(
        look.rng, color, look.own_color("white", "cream"))])  # fmt: skip
    other = surfaces.knitting(look.rng, look.own_color("white", "cream", "navy", "red"))
    return shape([(body, knit), (band.scale(x, 0.6 * x, h), other), (bobble, other)],
                 [hull_of(body), hull_of(bobble)])  # fmt: skip


@category("cookie", size=(0.07, 0.07, 0.018), mass=0.022, material="food",
          aliases=("biscuit", "chocolate chip cookie", "rusk"), themes=("tea", "coffee", "food"),
          roles=("round", "flat", "edible"), colors=("tan", "brown"), state="lying flat",
          common=True)  # fmt: skip
def cookie(look: Look) -> Shape:
    """A round biscuit with chips, a sandwich biscuit, or an iced biscuit."""
    r, h = look.between(0.028, 0.042), look.between(0.008, 0.012)
    kind = int(look.rng.integers(3))
    dough = look.color("tan", "amber", "wooden", "brown", "beige")
    if kind == 1:
        dark = surfaces.spots(look.rng, tint_color(look.own_color("brown", "charcoal"), 0.7),
                                (30, 22, 18), 0.1)  # fmt: skip
        disc = cylinder(r, h, 30, bevel=0.001)
        cream = cylinder(0.95 * r, 0.006, 28).move(z=h)
        teeth = [box(0.003, 0.005, 0.0012).move(0.9 * r, 0, 2 * h + 0.0055)
                 .turn(2, 2 * np.pi * k / 20) for k in range(20)]  # fmt: skip
        return shape(
            [(join([disc, disc.move(z=h + 0.006), *teeth]), dark),
             (cream, surfaces.plain((246, 242, 230)))],
            [cylinder_part(r, 2 * h + 0.006)],
        )  # fmt: skip
    crumb = speck(surfaces.spots(look.rng, dough, tint_color(dough, 0.8), 0.2), look.rng,
                  tint_color(dough, 0.7), 30, 2)  # fmt: skip
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.35 * h), (0.92 * r, 0.8 * h), (0.6 * r, h), (0, h)],
                 28)  # fmt: skip
    pieces = [(body, crumb)]
    if kind == 0:
        chips = []
        for k in range(12):
            away, a = r * 0.82 * np.sqrt((k + 0.5) / 12), 2.4 * k
            size = look.between(0.006, 0.009)
            chips.append(ellipsoid(size, size, 0.006, 8, 5).move(away * np.cos(a), away * np.sin(a),
                                                                 0.95 * h if away < 0.6 * r
                                                                 else 0.84 * h))  # fmt: skip
        pieces.append((join(chips), surfaces.plain((70, 40, 26))))
    else:
        icing = look.own_color("pink", "white", "sky", "mint", "lavender")
        tile = speck(surfaces.plain(icing).repeat(8, 0).repeat(8, 1), look.rng,
                     look.own_color("red", "yellow", "blue"), 22, 3)  # fmt: skip
        pieces.append((lobe(cylinder(0.8 * r, 0.003, 36, bevel=0.001), 9, 0.1)
                       .move(z=h - 0.001), tile))  # fmt: skip
    return shape(pieces, [cylinder_part(0.95 * r, h)])


@category("cake_stand", size=(0.25, 0.25, 0.105), mass=0.9, material="ceramic", hollow=True,
          aliases=("cake plate", "pedestal plate", "cupcake stand", "dessert stand"),
          themes=("tea", "dining"), roles=("round", "support", "big"), colors=("white", "pink"),
          common=True)  # fmt: skip
def cake_stand(look: Look) -> Shape:
    """A footed cake stand."""
    r, h = look.between(0.1, 0.15), look.between(0.08, 0.13)
    color = look.color("white", "pink", "mint", "sky", "cream", "wooden", "teal")
    glaze = look.surface(color, "ceramic")
    top = lathe([(0, 0), (0.9 * r, 0), (r, 0.006), (r, 0.014), (0.96 * r, 0.014), (0.94 * r, 0.008),
                 (0, 0.008)], 44).move(z=h - 0.014)  # fmt: skip
    post = lathe([(0, 0), (0.5 * r, 0), (0.48 * r, 0.006), (0.16 * r, 0.2 * h), (0.1 * r, 0.5 * h),
                  (0.18 * r, h - 0.012), (0, h - 0.012)], 28)  # fmt: skip
    scallops = lobe(torus(0.99 * r, 0.0035, 60, 6), 20, 0.05).move(z=h - 0.003)
    pieces = [(join([top, post]), glaze)]
    if look.chance(0.6):
        trim = look.own_color("gold", "white", "pink", "teal")
        pieces.append((scallops, surfaces.plain(trim)))
    parts = [hull_part(post.vertices[post.vertices[:, 2] < 0.25 * h]),
             cylinder_part(0.14 * r, h - 0.012), cylinder_part(0.98 * r, 0.008,
                                                               (0, 0, h - 0.014))]  # fmt: skip
    return shape(pieces, parts)
