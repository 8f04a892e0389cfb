"""Ornaments: hourglass, trophy, gourd."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck, streaks
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def hourglass(look: Look) -> Shape:
    """An hourglass: two bulbs with sand between wooden or metal ends."""
    r, h = look.between(0.03, 0.042), look.between(0.11, 0.17)
    color = look.color("brown", "black", "wooden", "gold", "copper", "white")
    frame = look.surface(color, "oak" if color[0] > color[2] + 30 else "plastic")
    ends = [cylinder(1.3 * r, 0.011, 32, bevel=0.003).move(z=z) for z in (0, h - 0.011)]
    posts = [
        cylinder(0.0042, h - 0.012, 10).move(1.1 * r * np.cos(a), 1.1 * r * np.sin(a), 0.006)
        for a in 2 * np.pi * np.arange(3) / 3 + np.pi / 2 + 0.45
    ]
    low, up, mid = 0.011, h - 0.011, h / 2
    glass = lathe(
        [(0, low), (0.6 * r, low), (0.92 * r, low + 0.12 * h), (0.88 * r, low + 0.22 * h),
         (0.35 * r, mid - 0.05 * h), (0.1 * r, mid), (0.35 * r, mid + 0.05 * h),
         (0.88 * r, up - 0.22 * h), (0.92 * r, up - 0.12 * h), (0.6 * r, up), (0, up)],
        26, v=[0, 0, 0.14, 0.25, 0.44, 0.5, 0.56, 0.75, 0.86, 1, 1],
    )  # fmt: skip
    sand = look.own_color("beige", "coral", "sky", "white", "gold", "black", "pink")
    level = look.between(0.14, 0.3)
    clear = textures.plain((206, 222, 226))
    grain = textures.speckles(look.rng, sand, 8)
    tile = textures.stack((grain, level), (clear, 0.52 - level), (grain, 0.36 - level),
                            (clear, 0.12 + level))  # fmt: skip
    return shape(
        [(join([*ends, *posts]), frame), (glass, tile)],
        [cylinder_part(1.3 * r, 0.011), cylinder_part(1.3 * r, 0.011, (0, 0, h - 0.011)),
         cylinder_part(0.95 * r, h - 0.02, (0, 0, 0.01))],
    )  # fmt: skip


def trophy(look: Look) -> Shape:
    """A prize cup with two handles on a plinth with a plate."""
    r, h = look.between(0.045, 0.06), look.between(0.2, 0.27)
    metal = textures.brushed_metal(look.rng, look.color("gold", "gold", "silver", "bronze"))
    base = look.between(0.24, 0.32) * h
    plinth = block(1.5 * r, 1.5 * r, base, 0.004, 0.003)
    dark = textures.marble(
        look.rng, look.own_color("black", "brown", "maroon", "navy"), (120, 112, 106)
    )
    plate = prints.canvas(64, 32, (212, 178, 96))
    prints.write(
        plate, look.pick(["1st", "WINNER", "BEST", "No 1", "2nd"]), 0.5, 0.5, 0.5, (60, 44, 20)
    )
    label = box(0.9 * r, 0.002, 0.4 * base).move(y=-0.75 * r - 0.0006, z=0.3 * base)
    top = h - base
    bowl = lathe(
        [(0, 0), (0.6 * r, 0), (0.55 * r, 0.04 * top), (0.14 * r, 0.12 * top),
         (0.12 * r, 0.26 * top), (0.3 * r, 0.33 * top), (0.66 * r, 0.45 * top),
         (0.86 * r, 0.66 * top), (r, top),
         (0.93 * r, top), (0.78 * r, 0.66 * top), (0.5 * r, 0.5 * top), (0, 0.46 * top)],
        30,
    ).move(z=base)  # fmt: skip
    bows = [
        tube(smooth([(s * 0.9 * r, 0, base + 0.9 * top), (s * 1.35 * r, 0, base + 0.94 * top),
                     (s * 1.45 * r, 0, base + 0.7 * top), (s * 0.68 * r, 0, base + 0.48 * top)], 4),
             0.0042, 8)
        for s in (-1, 1)
    ]  # fmt: skip
    stem = cylinder_part(0.5 * r, 0.4 * top, (0, 0, base))
    cup = hull_of(bowl.bend(lambda p: np.maximum(p, [-1, -1, base + 0.33 * top])))
    return shape(
        [(plinth, dark), (label, plate), (join([bowl, *bows]), metal)],
        [box_part(1.5 * r, 1.5 * r, base), stem, cup, *(hull_of(b) for b in bows)],
    )


def gourd(look: Look) -> Shape:
    """A gourd to look at: a ribbed pumpkin, or a bottle gourd of two bulbs."""
    color = look.color("orange", "amber", "white", "green", "teal", "tan", "terracotta")
    other = tint_color(color, look.pick([0.72, 1.3]))
    stem_tile = textures.speckles(look.rng, (118, 112, 66), 10)
    if look.chance(0.6):
        r, h = look.between(0.045, 0.085), look.between(0.068, 0.1)
        body = lathe([(0, 0.08 * h), (0.3 * r, 0), (0.55 * r, 0), (0.9 * r, 0.22 * h), (r, 0.5 * h),
                      (0.88 * r, 0.8 * h), (0.5 * r, h), (0.16 * r, 0.93 * h), (0, 0.92 * h)],
                     48)  # fmt: skip
        body = lobe(body, int(look.rng.integers(8, 12)), 0.22)
        path = smooth([(0, 0, 0.9 * h), (0.004, 0, 1.08 * h), (0.02, 0, 1.24 * h)], 3)
        stem = tube(path, np.linspace(0.16, 0.1, 7) * r, 8)
    else:
        r, h = look.between(0.035, 0.05), look.between(0.11, 0.16)
        body = lathe([(0, 0.004), (0.4 * r, 0), (0.85 * r, 0.1 * h), (r, 0.27 * h),
                      (0.8 * r, 0.45 * h), (0.42 * r, 0.58 * h), (0.45 * r, 0.66 * h),
                      (0.6 * r, 0.78 * h),
                      (0.5 * r, 0.9 * h), (0.2 * r, 0.98 * h), (0, h)], 28)  # fmt: skip
        path = smooth([(0, 0, 0.97 * h), (0.002, 0, 1.06 * h), (0.012, 0, 1.14 * h)], 3)
        stem = tube(path, 0.004, 7)
    rind = streaks(look.rng, color, other, 20)
    if look.chance(0.3):
        rind = speck(rind, look.rng, tint_color(color, 1.6), 40, 4)
    return shape([(body, rind), (stem, stem_tile)], [hull_of(body), hull_of(stem)])


CATEGORIES = (
    Category("hourglass", hourglass, (0.094, 0.094, 0.14), 0.22,
             ("sand timer", "sandglass", "sand clock"), ("office", "living", "games"),
             ("tall", "round"), ("brown", "gold")),
    Category("trophy", trophy, (0.15, 0.105, 0.235), 0.9,
             ("prize cup", "cup trophy", "award", "trophy cup"), ("office", "living"),
             ("tall",), ("gold", "silver")),
    Category("gourd", gourd, (0.12, 0.12, 0.12), 0.4,
             ("gourd ornament", "squash", "calabash", "ornamental gourd", "butternut squash"),
             ("kitchen", "living"), ("round",), ("orange", "amber")),
)  # fmt: skip
"""The module's categories."""
