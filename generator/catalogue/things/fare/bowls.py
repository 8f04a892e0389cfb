"""Soft food in bowls: mash, rice, cereal, porridge, dips."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.settled import hull_above, limb, scatter, serve
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .dishes import filled_bowl, pool


def mashed_potatoes(look: Look) -> Shape:
    """A bowl of mashed potato in peaks, butter melting on it."""
    r, h, dish, tile = filled_bowl(look)
    peaks = [
        ellipsoid(1.0 * r, 0.9 * r, 0.5 * h, 16, 8).move(
            0.42 * r * np.cos(1.26 * n), 0.42 * r * np.sin(1.26 * n), 0.9 * h
        )
        for n in range(5)
    ]
    swirl = lathe([(0, 0.5 * h), (0.84 * r, 0.75 * h), (0.7 * r, 1.05 * h), (0.3 * r, 1.3 * h),
                   (0, 1.32 * h)], 26)  # fmt: skip
    pat = block(0.02, 0.017, 0.009, 0.002, 0.001).turn(2, 0.5).move(z=1.3 * h)
    melt = ellipsoid(0.044, 0.038, 0.006, 16, 6).move(z=1.31 * h)
    cream = textures.speckles(look.rng, look.pick([(246, 230, 168), (244, 224, 150)]), 8)
    herbs = scatter(look, 0.6 * r, 14, (0.004, 0.006), 1.02 * h, dome=0.26 * h,
                    stretch=(1, 0.6, 0.4))  # fmt: skip
    return serve(
        look,
        dish,
        tile,
        [
            (join([*peaks, swirl]), cream),
            (melt, textures.plain((252, 214, 90))),
            (pat, textures.plain((250, 226, 120))),
            (herbs, textures.plain((86, 146, 62))),
        ],
    )


def bowl_of_rice(look: Look) -> Shape:
    """A bowl heaped with steamed rice."""
    r, h, dish, tile = filled_bowl(look)
    k = look.between(0.7, 0.85)
    heap = lathe([(0, 0.5 * h), (0.86 * r, 0.78 * h), (0.7 * r, 1.12 * h), (0.36 * r, 1.34 * h),
                  (0, 1.4 * h)], 28)  # fmt: skip
    grains = scatter(look, 0.72 * r, 36, (0.006, 0.008), 0.98 * h, dome=0.38 * h,
                     stretch=(1, 0.45, 0.45))  # fmt: skip
    white = textures.spots(look.rng, (248, 246, 238), (228, 226, 216), 0.3)
    seeds = scatter(look, 0.3 * r, 8, (0.004, 0.005), 1.34 * h, stretch=(1, 0.7, 0.5))
    food = [(heap, white), (grains, textures.plain((252, 250, 244))),
            (seeds, textures.plain((46, 42, 42)))]  # fmt: skip
    made = serve(look, dish, tile, food)
    return made.scale(k)


def bowl_of_crisps(look: Look) -> Shape:
    """A bowl heaped with golden crisps."""
    r, h, dish, tile = filled_bowl(look)
    one = ellipsoid(0.046, 0.036, 0.004, 12, 5).bend(
        lambda p: p + np.outer(p[:, 0] ** 2, [0.0, 0.0, 9.0])
    )
    chips = []
    for n in range(28):
        out, a = 0.8 * r * np.sqrt((n + 0.5) / 28), 2.4 * n
        high = 0.72 * h + 0.7 * h * (1 - (out / r) ** 2) * look.between(0.75, 1.05)
        lying = one.turn(0, look.between(-0.6, 0.6)).turn(1, look.between(-0.6, 0.6)).turn(2, a)
        chips.append(lying.move(out * np.cos(a), out * np.sin(a), high))
    mound = lathe([(0, 0.4 * h), (0.86 * r, 0.7 * h), (0.5 * r, 1.1 * h), (0, 1.25 * h)], 24)
    gold = look.pick([(238, 190, 96), (232, 178, 84)])
    skin = textures.spots(look.rng, gold, tint_color(gold, 0.75), 0.06)
    return serve(look, dish, tile, [(mound, textures.plain(tint_color(gold, 0.8))),
                                    (join(chips), skin)])  # fmt: skip


def bowl_of_cereal(look: Look) -> Shape:
    """A bowl of cereal in milk with a spoon in it."""
    r, h, dish, tile = filled_bowl(look, "white", "sky", "pink", "yellow", "navy")
    milk = pool(r, 0.4 * h, 0.8 * h)
    kind = look.pick(["rings", "flakes", "balls"])
    tone = look.pick([(224, 164, 80), (206, 140, 66), (140, 86, 50)])
    if kind == "rings":
        one = torus(0.0052, 0.0024, 12, 6)
        bits = join([one.turn(0, look.between(-0.5, 0.5)).move(
            a * np.cos(2.4 * n), a * np.sin(2.4 * n), 0.81 * h) for n in range(22)
            for a in [0.74 * r * np.sqrt((n + 0.5) / 22)]])  # fmt: skip
    else:
        flat = (1, 0.8, 0.3) if kind == "flakes" else (1, 1, 1)
        bits = scatter(look, 0.76 * r, 34, (0.01, 0.014), 0.8 * h, dome=0.06 * h, stretch=flat)
    spoon = [limb([(0.35 * r, 0.2 * r, 0.86 * h), (0.9 * r, 0.4 * r, 1.2 * h),
                   (1.45 * r, 0.62 * r, 1.45 * h)], [0.003, 0.0028, 0.0042], 8)]  # fmt: skip
    steel = textures.brushed_metal(look.rng, (190, 193, 198))
    food = [
        (milk, textures.plain((250, 249, 244))),
        (bits, textures.spots(look.rng, tone, tint_color(tone, 0.75), 0.2)),
    ]
    made = serve(look, dish, tile, food)
    return shape([*((p.solid, p.tile) for p in made.pieces), (join(spoon), steel)],
                 [*made.parts, hull_of(*spoon)])  # fmt: skip


def oatmeal(look: Look) -> Shape:
    """A bowl of porridge with berries and banana slices."""
    r, h, dish, tile = filled_bowl(look)
    porridge = lathe([(0, 0.4 * h), (0.6 * r, 0.4 * h), (0.89 * r, 0.82 * h), (0.5 * r, 0.9 * h),
                      (0, 0.92 * h)], 30)  # fmt: skip
    oats = textures.spots(look.rng, (226, 204, 164), (196, 164, 116), 0.3)
    berries = scatter(look, 0.3 * r, 9, (0.011, 0.015), 0.93 * h)
    rounds = [cylinder(0.0115, 0.005, 18, bevel=0.001).turn(0, 0.2).move(
        -0.42 * r + 0.01 * n, (0.3 - 0.26 * n) * r, 0.88 * h) for n in range(4)]  # fmt: skip
    food = [(porridge, oats), (berries.move(0.3 * r, 0), textures.plain(
        look.own_color("navy", "crimson", "purple"))),
            (join(rounds), textures.plain((248, 232, 180)))]  # fmt: skip
    return serve(look, dish, tile, food)


def dip(look: Look) -> Shape:
    """A small bowl of dip, swirled, a few crisps stuck in it."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(146, 176, 84), (232, 206, 150), (196, 56, 38), (244, 238, 222)])
    body = lathe([(0, 0.4 * h), (0.6 * r, 0.4 * h), (0.88 * r, 0.8 * h), (0, 0.86 * h)], 30)
    t = np.linspace(0.6, 13, 50)
    swirl = tube(np.column_stack([0.06 * r * t * np.cos(t) * 0.9, 0.06 * r * t * np.sin(t) * 0.9,
                                  0.87 * h - 0.002 * t / 6]), 0.0034, 6)  # fmt: skip
    chips = [box(0.034, 0.034, 0.002).turn(2, np.pi / 4).turn(0, 1.2).turn(2, a).move(
        0.5 * r * np.cos(a + 1.2), 0.5 * r * np.sin(a + 1.2), 0.85 * h + 0.012)
        for a in (-0.3, 0.25)]  # fmt: skip
    smooth_ = textures.spots(look.rng, tone, tint_color(tone, 0.86), 0.1)
    food = [
        (body, smooth_),
        (swirl, smooth_),
        (join(chips), textures.spots(look.rng, (238, 196, 96), (206, 150, 60), 0.2)),
    ]
    made = serve(look, dish, tile, food[:2])
    return shape([*((p.solid, p.tile) for p in made.pieces), food[2]],
                 [*made.parts, hull_above(*chips)]).scale(0.75)  # fmt: skip


CATEGORIES = (
    Category("mashed_potatoes", mashed_potatoes, (0.155, 0.155, 0.0865), 0.6, ("mashed potato",
             "bowl of mash", "mash", "bowl of mashed potatoes", "potato mash", "potato puree"),
             ("dining",), ("edible", "round"), ("white",)),
    Category("bowl_of_rice", bowl_of_rice, (0.123, 0.123, 0.0669), 0.4, ("steamed rice",
             "cooked rice", "fried rice", "rice dish", "risotto", "plate of rice"),
             ("dining",), ("edible", "round"), ("white",)),
    Category("bowl_of_crisps", bowl_of_crisps, (0.17, 0.17, 0.09), 0.35, ("bowl of chips",
             "bowl of potato chips", "bowl of tortilla chips", "bowl of crisps"),
             ("dining",), ("edible", "round"), ("white",)),
    Category("bowl_of_cereal", bowl_of_cereal, (0.196, 0.158, 0.0904), 0.6, ("cereal with milk",
             "bowl of cornflakes", "cereal and milk", "bowl of muesli", "bowl of granola", "muesli",
             "granola", "cornflakes"), ("breakfast",), ("edible", "round"), ("white", "sky")),
    Category("oatmeal", oatmeal, (0.157, 0.157, 0.065), 0.6, ("porridge", "bowl of porridge",
             "bowl of oatmeal", "bowl of oats", "acai bowl", "smoothie bowl", "yogurt bowl",
             "bowl of yogurt"), ("breakfast",), ("edible", "round"), ("white",)),
    Category("dip", dip, (0.118, 0.118, 0.0659), 0.3, ("hummus", "guacamole", "salsa",
             "bowl of dip", "bowl of hummus", "tzatziki", "bowl of salsa", "bowl of guacamole"),
             ("dining",), ("edible", "round"), ("white",)),
)  # fmt: skip
"""The module's categories."""
