"""Objects of the ``coffee`` theme: sweets."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, hull_of
from ...kit.primitives import bent_rod, lobe
from ...kit.shapes import Category, Shape, category, settle, shape, vary
from ...kit.solids import block, box, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, tint_color
from .cookies import biscuit_slab


@category("meringue", size=(0.0619, 0.0576, 0.053), mass=0.015, material="food",
          aliases=("meringue nest", "meringue kiss", "pavlova"), themes=("coffee", "tea"),
          roles=("edible", "round"), colors=("white",))  # fmt: skip
def meringue(look: Look) -> Shape:
    """A piped swirl of meringue with a peak."""
    r = look.between(0.028, 0.036)
    t = np.linspace(0, 6.6 * np.pi, 70)
    s = t / t[-1]
    away = 0.66 * r * (1 - s) ** 0.8
    path = np.column_stack([away * np.cos(t), away * np.sin(t), 0.3 * r + 1.25 * r * s])
    swirl = tube(path, 0.36 * r * (1 - 0.75 * s), 8)
    core = lathe([(0, 0), (0.8 * r, 0), (0.8 * r, 0.4 * r), (0.2 * r, 1.3 * r), (0, 1.4 * r)], 20)
    color = look.color("white", "white", "pink", "cream")
    return settle([(join([swirl, core]), surfaces.speckles(look.rng, color, 5))], 0.03)


@category("sugar_cube", size=(0.0155, 0.0155, 0.0134), mass=0.004, material="food",
          aliases=("cube of sugar", "lump of sugar", "sugar lump"), themes=("coffee", "tea"),
          roles=("edible",), colors=("white",))  # fmt: skip
def sugar_cube(look: Look) -> Shape:
    """A white or brown sugar cube."""
    x = look.between(0.014, 0.017)
    color = look.color("white", "white", "tan", "brown")
    grain = surfaces.spots(look.rng, color, tint_color(color, 0.9), 0.3)
    z = x * look.between(0.75, 1.0)
    return shape([(block(x, x, z, 0.0014, 0.0008), grain)], [box_part(x, x, z)])


BRIGHT = ("red", "orange", "yellow", "green", "pink", "purple", "sky", "crimson", "lime")


@category("candy", size=(0.0499, 0.0239, 0.0179), mass=0.008, material="food", aliases=("sweets",
          "wrapped candy", "wrapped sweet", "caramel", "candy wrapper", "boiled sweet", "bonbon",
          "hard candy"), themes=("coffee", "living"), roles=("edible",),
          colors=("red", "yellow", "green"), state="lying flat")  # fmt: skip
def candy(look: Look) -> Shape:
    """A sweet in a twisted wrapper with fanned ends."""
    r, long = look.between(0.0095, 0.012), look.between(0.022, 0.027)
    color = look.color(*BRIGHT)
    stripes = surfaces.stripes([color, color, (250, 246, 240)], look.pick([3, 5]), upright=True)
    body = bent_rod(long, r, blunt=4)
    ends = []
    for s in (-1, 1):
        fan = lathe([(0, 0), (0.22 * r, 0), (1.05 * r, 1.3 * r), (0, 0.9 * r)], 40)
        fan = lobe(fan, 12, 0.25).turn(1, s * np.pi / 2).move(x=s * 0.47 * long)
        ends.append(fan.scale(1, 1, 0.8))
    skin = stripes if look.chance(0.6) else surfaces.speckles(look.rng, color, 5)
    return settle([(body, skin), (join(ends), surfaces.plain(tint_color(color, 1.15)))], 0.12)


@category("marshmallow", size=(0.0284, 0.0284, 0.0264), mass=0.007, material="food",
          aliases=("marshmallow ghost",), themes=("coffee",), roles=("edible", "round"),
          colors=("white", "pink"))  # fmt: skip
def marshmallow(look: Look) -> Shape:
    """A soft white or pink cylinder of marshmallow, standing upright."""
    r, h = look.between(0.012, 0.016), look.between(0.022, 0.03)
    color = look.color("white", "white", "pink", "cream", "sky")
    body = lathe([(0, 0), (0.75 * r, 0), (0.96 * r, 0.1 * h), (r, 0.3 * h), (r, 0.7 * h),
                  (0.96 * r, 0.9 * h), (0.75 * r, h), (0, 1.01 * h)], 24)  # fmt: skip
    return shape([(body, surfaces.speckles(look.rng, color, 4))], [hull_of(body)])


@category("truffle", size=(0.0385, 0.0377, 0.0257), mass=0.014, material="food",
          aliases=("chocolate truffle", "chocolate praline", "praline"), themes=("coffee",),
          roles=("edible", "round"), colors=("brown",))  # fmt: skip
def truffle(look: Look) -> Shape:
    """A chocolate praline in a pleated paper case."""
    r = look.between(0.013, 0.017)
    tone: RGB = look.color("brown", "maroon", "cream", "brown")
    dark = tint_color(tone, 0.62) if sum(tone) < 500 else tone
    case = lobe(lathe([(0, 0), (0.85 * r, 0), (1.18 * r, 0.75 * r), (1.1 * r, 0.75 * r),
                       (0.8 * r, 0.08 * r), (0, 0.08 * r)], 56), 18, 0.1)  # fmt: skip
    ball = lathe([(0, 0.1 * r), (0.75 * r, 0.1 * r), (r, 0.6 * r), (0.86 * r, 1.15 * r),
                  (0.4 * r, 1.5 * r), (0, 1.55 * r)], 22)  # fmt: skip
    swirl = tube([(-0.6 * r, 0.2 * r, 1.38 * r), (-0.2 * r, -0.25 * r, 1.55 * r),
                  (0.2 * r, 0.25 * r, 1.55 * r), (0.6 * r, -0.2 * r, 1.38 * r)], 0.09 * r,
                 6)  # fmt: skip
    gold = surfaces.plain(look.own_color("gold", "brown", "red", "white"))
    line = surfaces.plain((244, 232, 206) if sum(dark) < 400 else (92, 54, 36))
    return shape([(case, gold), (ball, surfaces.speckles(look.rng, dark, 5)), (swirl, line)],
                 [hull_of(case, ball, swirl)])  # fmt: skip


@category("chocolate_bar", size=(0.16, 0.076, 0.011), mass=0.1, material="food",
          aliases=("chocolate", "bar of chocolate", "candy bar"), themes=("coffee", "food"),
          roles=("flat", "edible"), colors=("purple", "red"), state="lying flat",
          common=True)  # fmt: skip
def chocolate_bar(look: Look) -> Shape:
    """A bar of chocolate, half unwrapped."""
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
    tile = surfaces.gradient(tint_color(brown, 0.9), brown, look.rng)
    return shape(
        [(join([slab, *lumps]), tile), (sleeve, paper),
         (join([foil, crimp]), surfaces.brushed_metal(look.rng, (206, 206, 210)))],
        [box_part(x, y, 0.0095), hull_of(sleeve)],
    )  # fmt: skip


CATEGORIES = (
    Category("crispy_square", vary()(biscuit_slab((240, 214, 156), (252, 238, 206), 90, 7, (),
             (0.062, 0.062, 0.034))), size=(0.0616, 0.0616, 0.0338), mass=0.03, material="food",
             aliases=("rice crispy square", "rice krispie treat", "rice crispy treat",
             "rice krispie square", "crispy cake"), themes=("coffee", "tea"), roles=("edible",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
