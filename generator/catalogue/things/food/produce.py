"""More fruit and vegetables, whole, cut and bunched."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, hull_part
from ...build.forms import blade, lobe, streaks
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..tools.tools import lying
from .food import press_flat, skin

LEAF: RGB = (78, 130, 58)


def avocado(look: Look) -> Shape:
    """An avocado, whole or a half with its stone, lying."""
    x, d = look.between(0.095, 0.115), look.between(0.06, 0.07)
    t = np.linspace(0, np.pi, 15)
    radius = d / 2 * np.sin(t) ** 0.85 * (1 - 0.3 * np.cos(t / 1.0) * (t < 2.2) * 0.9)
    radius[[0, -1]] = 0
    profile = np.column_stack([radius, -x / 2 * np.cos(t)])
    body = lathe(profile, 24).turn(1, -np.pi / 2)
    peel = look.color("green", "olive", "charcoal", "maroon", "olive")
    rough = textures.spots(look.rng, tint_color(peel, 0.55), tint_color(peel, 0.4), 0.2)
    wide = float(np.ptp(body.vertices[:, 1])) / 2
    if look.chance(0.4):
        whole = press_flat(body, 0.88 * wide)
        return shape([(whole, rough)], [flat_foot(whole.vertices)])
    lower = body.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0)]))
    lower = press_flat(lower, 0.88 * wide)
    top = float(lower.vertices[:, 2].max())
    rim = np.concatenate([np.column_stack([-profile[:, 1], -profile[:, 0]])[::-1],
                          np.column_stack([-profile[:, 1], profile[:, 0]])[1:-1]])  # fmt: skip
    (ax, ay), (bx, by) = rim[1] - rim[0], rim[2] - rim[1]
    rim = rim if ax * by > ay * bx else rim[::-1]
    pale = textures.speckles(look.rng, (214, 214, 128), 8)
    edge = prism(0.985 * rim, top - 0.001, top + 0.0008)
    flesh = prism(0.87 * rim, top, top + 0.0014)
    middle = 0.16 * x
    stone = ellipsoid(0.036, 0.036, 0.03, 18, 10).move(middle, 0, top)
    brown = skin(look, (126, 78, 42), (92, 54, 30))
    return shape(
        [(lower, rough), (edge, textures.plain((150, 176, 84))), (flesh, pale), (stone, brown)],
        [flat_foot(lower.vertices), hull_part(stone.vertices[stone.vertices[:, 2] >= top])],
    )


def onion(look: Look) -> Shape:
    """An onion with its papery skin and dry neck."""
    r = look.between(0.032, 0.042)
    h = look.between(1.5, 1.85) * r
    color = look.color("amber", "maroon", "cream", "tan", "amber")
    body = lathe(
        [(0, 0), (0.35 * r, 0), (0.8 * r, 0.16 * h), (r, 0.42 * h), (0.9 * r, 0.66 * h),
         (0.5 * r, 0.88 * h), (0.16 * r, h), (0.07 * r, 1.16 * h), (0.1 * r, 1.28 * h),
         (0, 1.26 * h)],
        24,
    )  # fmt: skip
    paper = streaks(look.rng, color, tint_color(color, look.pick([0.66, 1.4])), 24)
    return shape([(body, paper)], [hull_of(body)])


def garlic(look: Look) -> Shape:
    """A bulb of garlic."""
    r = look.between(0.026, 0.032)
    h = 1.25 * r
    color = look.color("white", "cream", "ivory", "lavender")
    bulb = lathe(
        [(0, 0), (0.45 * r, 0), (0.9 * r, 0.2 * h), (r, 0.45 * h), (0.8 * r, 0.75 * h),
         (0.35 * r, 1.02 * h), (0.17 * r, 1.3 * h), (0.14 * r, 1.75 * h), (0, 1.77 * h)],
        40,
    )  # fmt: skip
    bulb = lobe(bulb, int(look.rng.integers(7, 10)), 0.2)
    paper = streaks(
        look.rng, color, tint_color(look.own_color("lavender", "beige", "pink"), 1.2), 12
    )
    return shape([(bulb, paper)], [hull_of(bulb)])


def corn(look: Look) -> Shape:
    """An ear of corn lying in its opened husk."""
    length, r = look.between(0.15, 0.19), look.between(0.02, 0.025)
    color = look.color("yellow", "golden", "yellow", "cream")
    y, x = np.mgrid[0:128, 0:128] / 128
    grain = np.abs(np.sin(14 * np.pi * x)) ** 0.5 * np.abs(np.sin(26 * np.pi * y)) ** 0.5
    shade = 0.62 + 0.45 * grain + 0.06 * textures.noise(look.rng, 128, 128, (16, 16), 1)
    kernels = np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)
    cob = lying(
        lathe([(0, 0), (0.8 * r, 0), (r, 0.15 * length), (0.97 * r, 0.6 * length),
               (0.7 * r, 0.88 * length), (0.2 * r, length), (0, length)], 22),
        -0.4 * length, r,
    )  # fmt: skip
    green = textures.leaf(look.rng, look.own_color("lime", "green", "sage"))
    start = -0.42 * length
    husk = [
        blade([(start, 0.3 * s * r, 0.9 * r), (start + 0.28 * length, 1.35 * s * r, 0.8 * r),
               (start + 0.7 * length, 1.9 * s * r, 0.35 * r)], 1.9 * r, thick=0.22)
        for s in (-1, 1)
    ]  # fmt: skip
    stalk = lying(cylinder(0.5 * r, 0.03, 12, top=0.6 * r), start - 0.024, 0.95 * r)
    keel = ellipsoid(0.55 * length, 1.9 * r, 0.7 * r, 16, 8).move(-0.18 * length, 0, 0.35 * r)
    return shape(
        [(cob, kernels), (join([*husk, keel]), green), (stalk, textures.plain((176, 190, 110)))],
        [flat_foot(cob.vertices), hull_part(husk[0].vertices.clip(min=(-1, -1, 0))),
         hull_part(husk[1].vertices.clip(min=(-1, -1, 0)))],
    )  # fmt: skip


def bell_pepper(look: Look) -> Shape:
    """A bell pepper standing, its stalk up."""
    r, h = look.between(0.035, 0.043), look.between(0.075, 0.1)
    color = look.color("red", "yellow", "green", "orange")
    body = lathe(
        [(0, 0.003), (0.35 * r, 0), (0.66 * r, 0.05 * h), (0.82 * r, 0.25 * h), (0.95 * r, 0.6 * h),
         (r, 0.82 * h), (0.86 * r, 0.96 * h), (0.5 * r, h), (0.2 * r, 0.93 * h), (0, 0.92 * h)],
        36,
    )  # fmt: skip
    body = lobe(body, int(look.rng.integers(3, 5)), 0.22)
    cap = lobe(cylinder(0.3 * r, 0.006, 20, bevel=0.001), 5, 0.4).move(z=0.925 * h)
    stalk = tube(smooth([(0, 0, 0.92 * h), (0.002, 0, 1.06 * h), (0.009, 0, 1.2 * h)], 3),
                 np.linspace(0.0055, 0.0042, 7), 8)  # fmt: skip
    shine = skin(look, color, tint_color(color, look.pick([0.8, 1.25])), 0.6)
    green = textures.plain(LEAF)
    return shape([(body, shine), (cap, green), (stalk, green)], [hull_of(body), hull_of(stalk)])


def broccoli(look: Look) -> Shape:
    """A head of broccoli standing on its cut stalk."""
    r, h = look.between(0.045, 0.058), look.between(0.075, 0.09)
    color = look.color("green", "green", "olive", "sage", "cream")
    pale = textures.speckles(look.rng, (168, 190, 110), 6)
    trunk = lathe([(0, 0), (0.36 * r, 0), (0.34 * r, 0.35 * h), (0.66 * r, 0.62 * h),
                   (0, 0.7 * h)], 16)  # fmt: skip
    tops = [ellipsoid(1.1 * r, 1.1 * r, 0.95 * r, 14, 8).move(z=h)]
    for ring, (count, away, z, d) in enumerate([(8, 0.72, 0.72, 0.66), (6, 0.46, 1.0, 0.66)]):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * ring) / count
            size = d * r * look.between(0.88, 1.1)
            at = away * r * np.array([np.cos(angle), np.sin(angle)])
            tops.append(ellipsoid(size, size, 0.88 * size, 12, 8).move(at[0], at[1], z * h))
    bud = textures.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.62), 0.3)
    return shape(
        [(trunk, pale), (join(tops), bud)],
        [cylinder_part(0.35 * r, 0.6 * h), hull_of(*tops)],
    )


def potato(look: Look) -> Shape:
    """A knobbly potato lying."""
    x, y, z = look.between(0.08, 0.105), look.between(0.055, 0.068), look.between(0.05, 0.058)
    color = look.color("tan", "beige", "terracotta", "mustard", "maroon")
    phase = look.rng.uniform(0, 6.3, 3)

    def bumps(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.05 * np.sin(p @ np.array([70, 40, 30]) + phase[0])
        return p * (wave + 0.04 * np.sin(p @ np.array([-60, 90, 50]) + phase[1]))[:, None]

    body = press_flat(ellipsoid(x, y, z, 26, 16).bend(bumps), 0.44 * z)
    peel = textures.spots(look.rng, color, tint_color(color, 0.55), 0.04)
    return shape([(body, peel)], [flat_foot(body.vertices)])


def mushroom(look: Look) -> Shape:
    """A mushroom standing on its stalk."""
    r, h = look.between(0.022, 0.034), look.between(0.045, 0.06)
    color = look.color("cream", "white", "brown", "tan", "beige")
    s = 0.42 * r
    stalk = lathe([(0, 0), (s, 0), (0.9 * s, 0.3 * h), (s, 0.66 * h), (0, 0.66 * h)], 18)
    cap = lathe([(0, 0.52 * h), (0.6 * r, 0.5 * h), (0.93 * r, 0.47 * h), (r, 0.55 * h),
                 (0.9 * r, 0.76 * h), (0.55 * r, 0.95 * h), (0, h)], 26)  # fmt: skip
    top = skin(look, color, tint_color(color, 0.75), 0.7)
    return shape(
        [(stalk, textures.speckles(look.rng, (238, 230, 212), 6)), (cap, top)],
        [cylinder_part(s, 0.55 * h), hull_of(cap)],
    )


CATEGORIES = (
    Category("mushroom", mushroom, (0.056, 0.056, 0.052), 0.021, ("champignon", "toadstool"),
             ("kitchen", "food"), ("round", "edible"), ("cream",)),
    Category("avocado", avocado, (0.104, 0.065, 0.045), 0.13, ("avocado half", "half avocado"),
             ("kitchen", "food"), ("edible",), ("green",), state="lying flat"),
    Category("onion", onion, (0.074, 0.074, 0.085), 0.16, ("red onion", "white onion", "shallot"),
             ("kitchen", "food"), ("round", "edible"), ("amber", "maroon")),
    Category("garlic", garlic, (0.058, 0.058, 0.064), 0.05, ("garlic bulb", "bulb of garlic"),
             ("kitchen", "food"), ("round", "edible"), ("white",)),
    Category("corn", corn, (0.19, 0.08, 0.046), 0.25,
             ("corn cob", "ear of corn", "corn on the cob", "maize", "sweetcorn",
                 "sweetcorn cob", "cob of corn"),
             ("kitchen", "food"), ("edible",), ("yellow",), state="lying flat"),
    Category("bell_pepper", bell_pepper, (0.08, 0.08, 0.105), 0.16,
             ("sweet pepper", "capsicum", "red pepper", "green pepper"),
             ("kitchen", "food"), ("round", "edible"), ("red", "yellow", "green")),
    Category("broccoli", broccoli, (0.11, 0.11, 0.105), 0.25, ("broccoli head",),
             ("kitchen", "food"), ("round", "edible"), ("green",)),
    Category("potato", potato, (0.092, 0.062, 0.05), 0.17, ("spud",),
             ("kitchen", "food"), ("edible",), ("tan",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
