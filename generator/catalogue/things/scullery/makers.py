"""Electric makers: dehydrators, yoghurt, eggs, popcorn, ice cream, soda."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import facing
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .electrics import turn_knob

STEEL: RGB = (190, 194, 200)


INK: RGB = (34, 36, 40)


def _stack(trays: int, r: float) -> tuple[list[Solid], list[Solid]]:
    rings = [
        lathe(
            [(0, 0), (0.97 * r, 0), (r, 0.006), (r, 0.03), (0.96 * r, 0.034), (0, 0.034)], 24
        ).move(z=0.06 + 0.036 * n)
        for n in range(trays)
    ]
    slots = [torus(1.0 * r, 0.002, 28, 4).move(z=0.06 + 0.036 * n + 0.017) for n in range(trays)]
    return rings, slots


def food_dehydrator(look: Look) -> Shape:
    """A food dehydrator: a round base with a dial under a stack of vented trays and a lid."""
    k, color = look.between(0.9, 1.05), look.color("white", "black", "gray", "cream")
    r, count = 0.14 * k, look.pick([4, 5, 5])
    base = lathe([(0, 0), (1.02 * r, 0), (1.06 * r, 0.02), (r, 0.06), (0, 0.06)], 32)
    rings, slots = _stack(count, r)
    top = 0.06 + 0.036 * count
    lid = lathe([(0, 0), (r, 0), (0.9 * r, 0.014), (0.3 * r, 0.018), (0, 0.018)], 32).move(z=top)
    vents = [
        box(0.36 * r, 0.006, 0.002).move(x=0.62 * r).turn(2, a).move(z=top + 0.0145)
        for a in np.arange(12) * np.pi / 6
    ]
    tile = look.surface(color, "plastic")
    return shape([(join([base, lid]), tile), (join(rings), textures.speckles(look.rng,
        tint_color(color, 0.85 if sum(color) > 400 else 1.25), 4)),
                  (join([*slots, *vents, turn_knob(0.016, 0, -1.03 * r, 0.032)]),
                   textures.plain((60, 62, 66)))],
                   [hull_of(base), hull_of(*rings, lid)])  # fmt: skip


def yoghurt_maker(look: Look) -> Shape:
    """A yoghurt maker: a round base full of small jars with coloured lids under a clear cover."""
    k, color = look.between(0.9, 1.1), look.color("white", "gray", "mint", "sky", "pink")
    r = 0.115 * k
    base = lathe([(0, 0), (0.96 * r, 0), (r, 0.01), (r, 0.055), (0.94 * r, 0.06), (0, 0.06)], 36)
    places = [
        (0.0, 0.0),
        *[(0.63 * r * np.cos(a), 0.63 * r * np.sin(a)) for a in np.pi / 3 * np.arange(6)],
    ]
    jars = [cylinder(0.25 * r, 0.05, 16).move(x, y, 0.058) for x, y in places]
    lids = [cylinder(0.27 * r, 0.014, 16).move(x, y, 0.104) for x, y in places]
    rim = torus(0.98 * r, 0.004, 36, 6).move(z=0.06)
    hue = look.own_color("sky", "pink", "lime", "red", "purple")
    return shape([(base, look.surface(color, "plastic")),
                  (join(jars), textures.plain((246, 244, 238))), (join(lids), textures.plain(hue)),
                  (rim, textures.plain(tint_color(color, 0.8))),
                  (turn_knob(0.012, 0, -0.99 * r, 0.03),
                      textures.plain((90, 94, 100)))],
                 [hull_of(base), hull_of(*jars, *lids)])  # fmt: skip


def egg_cooker(look: Look) -> Shape:
    """An egg boiler: a round heated base, eggs on a tray, a clear dome with a knob."""
    k, color = (
        look.between(0.9, 1.1),
        look.color("white", "silver", "red", "yellow", "mint", "black"),
    )
    r = 0.085 * k
    base = lathe(
        [(0, 0), (0.85 * r, 0), (r, 0.012), (0.98 * r, 0.045), (0.9 * r, 0.05), (0, 0.05)], 32
    )
    eggs = [
        ellipsoid(0.042 * k, 0.042 * k, 0.055 * k, 14, 10).move(
            0.58 * r * np.cos(a), 0.58 * r * np.sin(a), 0.07 * k
        )
        for a in np.pi / 3 * np.arange(6)
    ]
    eggs.append(ellipsoid(0.042 * k, 0.042 * k, 0.055 * k, 14, 10).move(z=0.07 * k))
    tray = cylinder(0.92 * r, 0.003, 28).move(z=0.05)
    hoop = [tube([(0.93 * r * np.cos(a), 0.93 * r * np.sin(a), 0.05), (0.8 * r * np.cos(a),
        0.8 * r * np.sin(a), 0.1 * k),
                  (0.04 * r * np.cos(a), 0.04 * r * np.sin(a), 0.12 * k)], 0.0022,
                  5) for a in np.pi / 3 * np.arange(6) + 0.5]  # fmt: skip
    knob = lathe([(0, 0.115 * k), (0.016, 0.118 * k), (0.012, 0.135 * k), (0, 0.138 * k)], 14)
    return shape([(base, look.surface(color, "plastic")),
                  (join(eggs), textures.speckles(look.rng, (236, 208, 176), 6)),
                  (tray, textures.plain(STEEL)),
                  (join(hoop), textures.plain((206, 216, 220))), (knob, textures.plain(INK)),
                  (turn_knob(0.011, 0, -0.99 * r, 0.026), textures.plain((220, 70, 50)))],
                 [hull_of(base), hull_of(*eggs, knob)])  # fmt: skip


def popcorn_maker(look: Look) -> Shape:
    """A popcorn cart's kettle case: windows with popcorn, a peaked roof with stripes."""
    k, color = look.between(0.85, 1.05), look.color("red", "red", "crimson", "navy", "yellow")
    x, y, h = 0.2 * k, 0.17 * k, 0.22 * k
    base = block(x, y, 0.05 * k, 0.008, 0.002)
    posts = [
        box(0.01, 0.01, h).move(i * (x / 2 - 0.006), j * (y / 2 - 0.006), 0.05 * k)
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    roof = block(1.04 * x, 1.04 * y, 0.014, 0.008).move(z=h + 0.05 * k)
    peak = (
        prism(
            np.array([(-0.5 * x, 0), (0.5 * x, 0), (0.3 * x, 0.045 * k), (-0.3 * x, 0.045 * k)]),
            -0.45 * y,
            0.45 * y,
        )
        .turn(0, np.pi / 2)
        .move(z=h + 0.05 * k + 0.012)
    )
    image = textures.stack(
        (textures.spots(look.rng, (250, 240, 200), (226, 190, 110), 0.2), 0.4),
        (textures.plain((206, 222, 228)), 0.6),
    )
    glass = box(0.95 * x, 0.95 * y, h).move(z=0.05 * k)
    heap = [
        ellipsoid(0.02, 0.019, 0.018, 6, 4).move(
            0.35 * x * np.cos(2.4 * n) * np.sqrt(n / 20),
            -y / 2 + 0.002,
            0.08 * k + 0.0035 * k * (20 - n),
        )
        for n in range(20)
    ]
    sign = prints.canvas(160, 48, (250, 240, 210))
    prints.write(sign, "POPCORN", 0.5, 0.5, 0.5, color, bold=True)
    board = box(0.8 * x, 0.002, 0.04 * k).move(y=-0.505 * y, z=0.005 * k)
    front = box(0.62 * x, 0.002, 0.034 * k).move(y=-0.47 * y, z=h + 0.066 * k)
    tile = look.surface(color, "plastic")
    return shape([(join([base, *posts, roof, peak]), tile), (glass, image),
                  (join(heap), textures.plain((250, 236, 190))), (board, sign), (front, sign)],
                 [hull_of(base), hull_of(glass), hull_of(roof, peak)])  # fmt: skip


def ice_cream_maker(look: Look) -> Shape:
    """An ice cream maker: a round tub with a clear lid and a motor on top."""
    k, color = (
        look.between(0.9, 1.08),
        look.color("white", "cream", "pink", "mint", "silver", "red"),
    )
    r, h = 0.1 * k, 0.17 * k
    tub = lathe([(0, 0), (0.9 * r, 0), (r, 0.02), (r, h), (0, h)], 34)
    lid = lathe([(0, 0), (0.97 * r, 0), (0.86 * r, 0.035 * k), (0, 0.04 * k)], 34).move(z=h)
    motor = block(0.1 * k, 0.07 * k, 0.05 * k, 0.02 * k, 0.008).move(z=h + 0.036 * k)
    arms = box(2.1 * r, 0.03 * k, 0.02 * k).move(z=h + 0.038 * k)
    cone = [
        prism([(0, -0.03), (0.014, 0), (-0.014, 0)], 0, 0.0012),
        cylinder(0.014, 0.0013, 16).move(0, 0.006),
    ]
    marks = [facing(s).scale(k, 1, k).move(y=-1.0 * r, z=0.55 * h) for s in cone]
    return shape([(tub, look.surface(color, "plastic")), (lid, textures.plain((214, 226, 232))),
                  (join([motor, arms]), textures.speckles(look.rng, tint_color(color, 0.75), 3)),
                  (marks[0], textures.plain((206, 150, 84))), (marks[1],
                      textures.plain((236, 150, 170))),
                      (turn_knob(0.01, 0, -0.034 * k, h + 0.06 * k),
                                                         textures.plain((90, 94, 98)))],
                 [hull_of(tub), hull_of(lid), hull_of(motor, arms)])  # fmt: skip


def soda_maker(look: Look) -> Shape:
    """A soda maker: a tall arched body, a clear bottle under its head, a lever."""
    k, color = look.between(0.9, 1.06), look.color("black", "white", "red", "silver", "sky")
    h = 0.4 * k
    foot = block(0.12 * k, 0.2 * k, 0.02, 0.05 * k, 0.004)
    spine = block(0.1 * k, 0.07 * k, 0.92 * h, 0.03 * k, 0.008).move(y=0.055 * k, z=0.015)
    head = block(0.11 * k, 0.17 * k, 0.11 * h * 1.6, 0.04 * k, 0.012).move(y=0.005 * k, z=0.82 * h)
    r = 0.036 * k
    bottle = lathe(
        [(0, 0), (r, 0), (r, 0.18 * k), (0.4 * r, 0.26 * k), (0.4 * r, 0.31 * k), (0, 0.31 * k)], 24
    ).move(y=-0.045 * k, z=0.02)
    lever = block(0.03 * k, 0.06 * k, 0.012, 0.006).move(0, -0.04 * k, 0.82 * h + 0.176 * h)
    return shape([(join([foot, spine, head]), look.surface(color, "plastic")),
                  (bottle, textures.gradient((176, 214, 232), (222, 236, 242), look.rng)),
                  (lever, textures.brushed_metal(look.rng, STEEL))], [hull_of(foot),
                      hull_of(spine), hull_of(head, lever), hull_of(bottle)])  # fmt: skip


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("food_dehydrator", food_dehydrator, (0.286, 0.294, 0.24), 2.0,
             ("dehydrator", "fruit dryer", "food dryer"), _K, ("big", "round"), ("white",)),
    Category("yoghurt_maker", yoghurt_maker, (0.245, 0.254, 0.118), 1.3,
             ("yogurt maker", "yoghurt machine", "yogurt machine"), _K, ("round",), ("white",)),
    Category("egg_cooker", egg_cooker, (0.171, 0.182, 0.138), 0.6, ("egg boiler", "egg steamer",
        "electric egg cooker"), _K, ("round",), ("white",)),
    Category("popcorn_maker", popcorn_maker, (0.199, 0.173, 0.313), 1.8,
             ("popcorn machine", "popcorn popper"), _K, _B, ("red",)),
    Category("ice_cream_maker", ice_cream_maker, (0.212, 0.203, 0.259), 2.2,
             ("ice cream machine", "gelato maker", "sorbet maker", "frozen yogurt maker"), _K,
             ("big", "round"), ("white",)),
    Category("soda_maker", soda_maker, (0.115, 0.192, 0.395), 1.3, ("sodastream", "soda stream",
        "soda machine", "carbonator", "sparkling water maker"), _K, ("tall", "big"), ("black",)),
)  # fmt: skip
"""The module's categories."""
