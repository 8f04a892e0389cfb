"""Sweet things: pancakes, biscuits, chocolate."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .food import skin


def pancakes(look: Look) -> Shape:
    """A stack of pancakes with syrup and butter."""
    r, count = look.between(0.055, 0.07), int(look.rng.integers(3, 6))
    cakes, z = [], 0.0
    edge, brown = (238, 204, 140), look.own_color("copper", "brown", "amber")
    for _ in range(count):
        k = look.between(0.94, 1.04)
        dx, dy = look.rng.uniform(-0.003, 0.003, 2)
        cakes.append(cylinder(k * r, 0.0125, 30, bevel=0.0035).move(dx, dy, z))
        z += 0.012
    tile = textures.gradient(edge, tint_color(edge, 0.9), look.rng)
    faces = [cylinder(0.86 * r, 0.0009, 28).move(z=0.012 * (k + 1)) for k in range(count)]
    syrup = lobe(cylinder(0.62 * r, 0.003, 36, bevel=0.001), 5, 0.6).move(z=z)
    drips = [
        ellipsoid(0.013, 0.008, long, 10, 6).move(0, -r, z - long / 2).turn(2, 2.1 * k + 0.3)
        for k, long in enumerate(look.rng.uniform(0.016, 0.036, 3))
    ]
    amber = textures.plain(look.own_color("brown", "maroon", "copper", "crimson"))
    butter = block(0.019, 0.019, 0.009, 0.003, 0.001).turn(2, 0.5).move(z=z + 0.002)
    return shape(
        [(join(cakes), tile), (join(faces), skin(look, brown, tint_color(brown, 1.2))),
         (join([syrup, *drips]), amber), (butter, textures.plain((250, 228, 132)))],
        [cylinder_part(0.96 * r, z), hull_of(butter)],
    )  # fmt: skip


def cookie(look: Look) -> Shape:
    """A round biscuit with chips, a sandwich biscuit, or one with icing."""
    r, h = look.between(0.028, 0.042), look.between(0.008, 0.012)
    kind = int(look.rng.integers(3))
    dough = look.color("tan", "amber", "wooden", "brown", "beige")
    if kind == 1:
        dark = textures.spots(look.rng, tint_color(look.own_color("brown", "charcoal"), 0.7),
                                (30, 22, 18), 0.1)  # fmt: skip
        disc = cylinder(r, h, 30, bevel=0.001)
        cream = cylinder(0.95 * r, 0.006, 28).move(z=h)
        teeth = [box(0.003, 0.005, 0.0012).move(0.9 * r, 0, 2 * h + 0.0055)
                 .turn(2, 2 * np.pi * k / 20) for k in range(20)]  # fmt: skip
        return shape(
            [(join([disc, disc.move(z=h + 0.006), *teeth]), dark),
             (cream, textures.plain((246, 242, 230)))],
            [cylinder_part(r, 2 * h + 0.006)],
        )  # fmt: skip
    crumb = speck(textures.spots(look.rng, dough, tint_color(dough, 0.8), 0.2), look.rng,
                  tint_color(dough, 0.7), 30, 2)  # fmt: skip
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.35 * h), (0.92 * r, 0.8 * h), (0.6 * r, h), (0, h)],
                 28)  # fmt: skip
    pieces = [(body, crumb)]
    if kind == 0:
        chips = []
        for k in range(12):
            away, a = r * 0.82 * np.sqrt((k + 0.5) / 12), 2.4 * k
            size = look.between(0.006, 0.009)
            chips.append(
                ellipsoid(size, size, 0.006, 8, 5).move(
                    away * np.cos(a), away * np.sin(a), 0.95 * h if away < 0.6 * r else 0.84 * h
                )
            )
        pieces.append((join(chips), textures.plain((70, 40, 26))))
    else:
        icing = look.own_color("pink", "white", "sky", "mint", "lavender")
        tile = speck(textures.plain(icing).repeat(8, 0).repeat(8, 1), look.rng,
                     look.own_color("red", "yellow", "blue"), 22, 3)  # fmt: skip
        pieces.append((lobe(cylinder(0.8 * r, 0.003, 36, bevel=0.001), 9, 0.1)
                       .move(z=h - 0.001), tile))  # fmt: skip
    return shape(pieces, [cylinder_part(0.95 * r, h)])


def chocolate_bar(look: Look) -> Shape:
    """A bar of chocolate, half out of its wrapper."""
    x, y = look.between(0.14, 0.17), look.between(0.068, 0.08)
    brown = look.pick([(78, 46, 30), (112, 68, 42), (56, 34, 26), (238, 222, 186)])
    color = look.color("purple", "red", "blue", "gold", "green", "orange")
    slab = box(x, y, 0.005)
    lumps = [
        prism(rectangle(x / 8 - 0.001, y / 4 - 0.001), 0, 0.0045, 0.0015)
        .move((i - 3.5) * x / 8, (j - 1.5) * y / 4, 0.005)
        for i in range(8) for j in range(4)
    ]  # fmt: skip
    share = look.between(0.45, 0.62)
    paper = prints.canvas(128, 96, color)
    prints.fill(paper, 0, 0.08, 1, 0.04, (236, 210, 140))
    prints.fill(paper, 0, 0.88, 1, 0.04, (236, 210, 140))
    prints.write(paper, look.pick(["CHOCO", "COCOA", "MILK", "DARK"]), 0.5, 0.5, 0.26,
                 (250, 244, 224), bold=True)  # fmt: skip
    sleeve = box(share * x, y + 0.002, 0.011).move(x=-(1 - share) * x / 2 - 0.001)
    foil = box(0.01, y + 0.001, 0.0104).move(x=(share - 0.5) * x + 0.002)
    crimp = box(0.004, y + 0.002, 0.002).move(x=-x / 2 - 0.002, z=0.004)
    tile = textures.gradient(tint_color(brown, 0.9), brown, look.rng)
    return shape(
        [(join([slab, *lumps]), tile), (sleeve, paper),
         (join([foil, crimp]), textures.brushed_metal(look.rng, (206, 206, 210)))],
        [box_part(x, y, 0.0095), hull_of(sleeve)],
    )  # fmt: skip


CATEGORIES = (
    Category("pancakes", pancakes, (0.13, 0.13, 0.06), 0.35,
             ("pancake stack", "stack of pancakes", "pancake", "hotcake", "plate of pancakes"),
             ("breakfast", "food"), ("round", "edible")),
    Category("cookie", cookie, (0.07, 0.07, 0.018), 0.022,
             ("biscuit", "chocolate chip cookie", "rusk"), ("tea", "coffee", "food"),
             ("round", "flat", "edible"), ("tan", "brown"), state="lying flat"),
    Category("chocolate_bar", chocolate_bar, (0.16, 0.076, 0.011), 0.1,
             ("chocolate", "bar of chocolate", "candy bar"),
             ("coffee", "food"), ("flat", "edible"), ("purple", "red"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
