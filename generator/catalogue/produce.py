"""More fruit and vegetables, whole, cut and bunched."""

from __future__ import annotations

import numpy as np

from . import textures
from .category import Category
from .collision import cylinder_part, footed, hull_of, hull_part
from .colors import RGB, tinted
from .food import grounded, skin
from .forms import blade, lobed, speck, streaked
from .look import Look
from .outlines import arc, smooth
from .shape import Shape, shape
from .solids import Solid, cylinder, ellipsoid, joined, lathe, prism, tube
from .textures import Tile
from .tools import lying

LEAF: RGB = (78, 130, 58)
STEM: RGB = (112, 128, 64)


def _diamonds(look: Look, color: RGB) -> Tile:
    """A pineapple's skin: slanted rows of eyes with dark seams."""
    y, x = np.mgrid[0:128, 0:128] / 128
    a, b = (8 * x + 7 * y) % 1 - 0.5, (8 * x - 7 * y) % 1 - 0.5
    eye = np.exp(-(a**2 + b**2) / 0.012)
    seam = np.maximum(np.abs(a), np.abs(b)) > 0.4
    shade = 1.08 - 0.5 * eye - 0.45 * seam + 0.1 * textures.noise(look.rng, 128, 128, (4, 4), 2)
    return np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)


def pineapple(look: Look) -> Shape:
    """A pineapple standing, crowned with stiff leaves."""
    r, h = look.between(0.046, 0.058), look.between(0.13, 0.17)
    color = look.color("amber", "mustard", "golden", "olive")
    body = lathe(
        [(0, 0), (0.6 * r, 0), (0.85 * r, 0.08 * h), (r, 0.3 * h), (r, 0.6 * h),
         (0.86 * r, 0.84 * h), (0.5 * r, 0.98 * h), (0, h)],
        26,
    )  # fmt: skip
    crown, long = [], look.between(0.075, 0.1)
    for ring, (count, lean) in enumerate([(9, 0.75), (8, 0.45), (5, 0.16)]):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * ring) / count
            way = np.array([np.cos(angle), np.sin(angle), 0]) * lean * long
            foot = np.array([0, 0, 0.94 * h]) + 0.2 * r * way / np.linalg.norm(way)
            rise = np.array([0, 0, long * (0.55 + 0.22 * ring)])
            crown.append(blade([foot, foot + 0.35 * way + 0.6 * rise, foot + way + rise], 0.022))
    green = textures.leaf(look.rng, look.fixed("sage", "green", "olive"))
    low = hull_of(body)
    return shape(
        [(body, _diamonds(look, color)), (joined(crown), green)],
        [low, cylinder_part(0.45 * r, 0.9 * long, (0, 0, 0.94 * h))],
    )


def watermelon_slice(look: Look) -> Shape:
    """A slice of watermelon lying flat: flesh with seeds, pale and green rind."""
    r, thick = look.between(0.085, 0.12), look.between(0.018, 0.03)
    half = look.pick([np.pi / 2, np.pi / 2, 0.62, 0.75])
    color = look.color("red", "coral", "red", "crimson", "amber")
    side = textures.speckled(look.rng, color, 10, 96)
    flesh = speck(side, look.rng, (40, 28, 24), int(look.rng.integers(16, 30)))

    def band(inner: float, outer: float) -> Solid:
        out = arc((0, 0), outer * r, -half, half, 16)
        back = arc((0, 0), inner * r, half, -half, 16) if inner else np.zeros((1, 2))
        if inner == 0 and half > 1.5:
            return prism(out, 0, thick)
        return prism(np.concatenate([out, back]), 0, thick)

    rind = look.fixed("green", "lime", "green")
    dark = textures.stripes([rind, tinted(rind, 0.6)], 12, upright=True)
    solids = [band(0, 0.86), band(0.86, 0.92), band(0.92, 1.0)]
    tiles = [flesh, textures.plain((228, 234, 196)), dark]
    turned = [s.turned(2, -np.pi / 2) for s in solids]
    return shape(zip(turned, tiles, strict=True), [hull_of(*turned)])


def grapes(look: Look) -> Shape:
    """A bunch of grapes lying, with its stalk."""
    d = look.between(0.019, 0.024)
    color = look.color("purple", "lime", "crimson", "indigo", "sage")
    rows = [(1, 0), (2, 1), (3, 2), (4, 2), (4, 3), (3, 2)]
    balls = []
    for i, (low, high) in enumerate(rows):
        for level, count in enumerate((low, high)):
            for k in range(count):
                jitter = look.rng.uniform(-0.14, 0.14, 3) * d
                x, y = (i - 2.5 + 0.4 * level) * 0.84 * d, (k - (count - 1) / 2) * 0.92 * d
                z = (0.47 + 0.7 * level) * d
                balls.append(
                    ellipsoid(1.06 * d, d, d, 11, 7).moved(*(np.array([x, y, z]) + jitter))
                )
    end = 2.6 * d
    stalk = tube(smooth([(-d, 0, d), (end, 0, 1.3 * d), (end + 1.4 * d, 0.4 * d, 1.5 * d)], 3),
                 0.0024, 6)  # fmt: skip
    fruit = joined(balls)
    bloom = skin(look, color, tinted(color, 1.35), 0.8)
    return shape(
        [(fruit, bloom), (stalk, textures.plain((108, 96, 56)))],
        [footed(fruit.vertices, 0.35)],
    )


def avocado(look: Look) -> Shape:
    """An avocado, whole or a half with its stone, lying."""
    x, d = look.between(0.095, 0.115), look.between(0.06, 0.07)
    t = np.linspace(0, np.pi, 15)
    radius = d / 2 * np.sin(t) ** 0.85 * (1 - 0.3 * np.cos(t / 1.0) * (t < 2.2) * 0.9)
    radius[[0, -1]] = 0
    profile = np.column_stack([radius, -x / 2 * np.cos(t)])
    body = lathe(profile, 24).turned(1, -np.pi / 2)
    peel = look.color("green", "olive", "charcoal", "maroon", "olive")
    rough = textures.spotted(look.rng, tinted(peel, 0.55), tinted(peel, 0.4), 0.2)
    wide = float(np.ptp(body.vertices[:, 1])) / 2
    if look.chance(0.4):
        whole = grounded(body, 0.88 * wide)
        return shape([(whole, rough)], [footed(whole.vertices, 0.25)])
    lower = body.bent(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0)]))
    lower = grounded(lower, 0.88 * wide)
    top = float(lower.vertices[:, 2].max())
    rim = np.concatenate([np.column_stack([-profile[:, 1], -profile[:, 0]])[::-1],
                          np.column_stack([-profile[:, 1], profile[:, 0]])[1:-1]])  # fmt: skip
    rim = rim if np.cross(rim[1] - rim[0], rim[2] - rim[1]) > 0 else rim[::-1]
    pale = textures.speckled(look.rng, (214, 214, 128), 8)
    edge = prism(0.985 * rim, top - 0.001, top + 0.0008)
    flesh = prism(0.87 * rim, top, top + 0.0014)
    middle = 0.16 * x
    stone = ellipsoid(0.036, 0.036, 0.03, 18, 10).moved(middle, 0, top)
    brown = skin(look, (126, 78, 42), (92, 54, 30))
    return shape(
        [(lower, rough), (edge, textures.plain((150, 176, 84))), (flesh, pale), (stone, brown)],
        [footed(lower.vertices, 0.25), hull_part(stone.vertices[stone.vertices[:, 2] >= top])],
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
    paper = streaked(look.rng, color, tinted(color, look.pick([0.66, 1.4])), 24)
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
    bulb = lobed(bulb, int(look.rng.integers(7, 10)), 0.2)
    paper = streaked(look.rng, color, tinted(look.fixed("lavender", "beige", "pink"), 1.2), 12)
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
    green = textures.leaf(look.rng, look.fixed("lime", "green", "sage"))
    start = -0.42 * length
    husk = [
        blade([(start, 0.3 * s * r, 0.9 * r), (start + 0.28 * length, 1.35 * s * r, 0.8 * r),
               (start + 0.7 * length, 1.9 * s * r, 0.35 * r)], 1.9 * r, thick=0.22)
        for s in (-1, 1)
    ]  # fmt: skip
    stalk = lying(cylinder(0.5 * r, 0.03, 12, top=0.6 * r), start - 0.024, 0.95 * r)
    keel = ellipsoid(0.55 * length, 1.9 * r, 0.7 * r, 16, 8).moved(-0.18 * length, 0, 0.35 * r)
    return shape(
        [(cob, kernels), (joined([*husk, keel]), green), (stalk, textures.plain((176, 190, 110)))],
        [footed(cob.vertices, 0.35), hull_part(husk[0].vertices.clip(min=(-1, -1, 0))),
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
    body = lobed(body, int(look.rng.integers(3, 5)), 0.22)
    cap = lobed(cylinder(0.3 * r, 0.006, 20, bevel=0.001), 5, 0.4).moved(z=0.925 * h)
    stalk = tube(smooth([(0, 0, 0.92 * h), (0.002, 0, 1.06 * h), (0.009, 0, 1.2 * h)], 3),
                 np.linspace(0.0055, 0.0042, 7), 8)  # fmt: skip
    shine = skin(look, color, tinted(color, look.pick([0.8, 1.25])), 0.6)
    green = textures.plain(LEAF)
    return shape([(body, shine), (cap, green), (stalk, green)], [hull_of(body), hull_of(stalk)])


def broccoli(look: Look) -> Shape:
    """A head of broccoli standing on its cut stalk."""
    r, h = look.between(0.045, 0.058), look.between(0.075, 0.09)
    color = look.color("green", "green", "olive", "sage", "cream")
    pale = textures.speckled(look.rng, (168, 190, 110), 6)
    trunk = lathe([(0, 0), (0.36 * r, 0), (0.34 * r, 0.35 * h), (0.66 * r, 0.62 * h),
                   (0, 0.7 * h)], 16)  # fmt: skip
    tops = [ellipsoid(1.1 * r, 1.1 * r, 0.95 * r, 14, 8).moved(z=h)]
    for ring, (count, away, z, d) in enumerate([(8, 0.72, 0.72, 0.66), (6, 0.46, 1.0, 0.66)]):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * ring) / count
            size = d * r * look.between(0.88, 1.1)
            at = away * r * np.array([np.cos(angle), np.sin(angle)])
            tops.append(ellipsoid(size, size, 0.88 * size, 12, 8).moved(at[0], at[1], z * h))
    bud = textures.spotted(look.rng, tinted(color, 0.85), tinted(color, 0.62), 0.3)
    return shape(
        [(trunk, pale), (joined(tops), bud)],
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

    body = grounded(ellipsoid(x, y, z, 26, 16).bent(bumps), 0.44 * z)
    peel = textures.spotted(look.rng, color, tinted(color, 0.55), 0.04)
    return shape([(body, peel)], [footed(body.vertices, 0.3)])


def strawberry(look: Look) -> Shape:
    """A strawberry lying on its side, with its green star."""
    r, h = look.between(0.015, 0.019), look.between(0.036, 0.046)
    color = look.color("red", "crimson", "red", "coral")
    profile = [(0, 0), (0.2 * r, 0.03 * h), (0.62 * r, 0.3 * h), (0.95 * r, 0.66 * h),
               (r, 0.82 * h), (0.7 * r, 0.97 * h), (0, 0.94 * h)]  # fmt: skip
    body = grounded(lathe(profile, 22).turned(1, np.pi / 2).moved(x=-h / 2), 0.9 * r)
    seeds = speck(textures.speckled(look.rng, color, 5, 64), look.rng, (236, 206, 110), 70, 1)
    end, leaves = 0.44 * h, []
    for k in range(7):
        angle = 2 * np.pi * k / 7
        way = np.array([-0.25, np.cos(angle), np.sin(angle)]) * 1.15 * r
        foot = np.array([end, 0, 0.9 * r])
        leaves.append(blade([foot, foot + 0.6 * way + [0.002, 0, 0], foot + way], 0.009))
    stalk = tube([(end - 0.002, 0, 0.9 * r), (end + 0.01, 0, 1.1 * r)], 0.0014, 6)
    star = joined([*leaves, stalk])
    return shape([(body, seeds), (star, textures.plain(LEAF))], [footed(body.vertices, 0.3)])


CATEGORIES = (
    Category("pineapple", pineapple, (0.13, 0.13, 0.245), 1.1, ("ananas",),
             ("kitchen", "food"), ("tall", "round", "edible"), ("amber",)),
    Category("watermelon_slice", watermelon_slice, (0.18, 0.1, 0.024), 0.25,
             ("slice of watermelon", "watermelon", "melon slice", "melon"),
             ("kitchen", "food"), ("flat", "edible"), ("red",), state="lying flat"),
    Category("grapes", grapes, (0.14, 0.09, 0.05), 0.3, ("bunch of grapes", "grape"),
             ("kitchen", "food", "dining"), ("edible",), ("purple", "lime"), state="lying flat"),
    Category("avocado", avocado, (0.104, 0.065, 0.045), 0.13, ("avocado half", "half avocado"),
             ("kitchen", "food"), ("edible",), ("green",), state="lying flat"),
    Category("onion", onion, (0.074, 0.074, 0.085), 0.16, ("red onion", "white onion", "shallot"),
             ("kitchen", "food"), ("round", "edible"), ("amber", "maroon")),
    Category("garlic", garlic, (0.058, 0.058, 0.064), 0.05, ("garlic bulb", "bulb of garlic"),
             ("kitchen", "food"), ("round", "edible"), ("white",)),
    Category("corn", corn, (0.19, 0.08, 0.046), 0.25,
             ("corn cob", "ear of corn", "corn on the cob", "maize", "sweetcorn"),
             ("kitchen", "food"), ("edible",), ("yellow",), state="lying flat"),
    Category("bell_pepper", bell_pepper, (0.08, 0.08, 0.105), 0.17,
             ("sweet pepper", "capsicum", "paprika", "red pepper", "green pepper", "chili"),
             ("kitchen", "food"), ("round", "edible"), ("red", "yellow", "green")),
    Category("broccoli", broccoli, (0.11, 0.11, 0.105), 0.25, ("cauliflower", "broccoli head"),
             ("kitchen", "food"), ("round", "edible"), ("green",)),
    Category("potato", potato, (0.092, 0.062, 0.05), 0.17, ("sweet potato", "yam", "spud"),
             ("kitchen", "food"), ("edible",), ("tan",), state="lying flat"),
    Category("strawberry", strawberry, (0.05, 0.035, 0.033), 0.018, ("berry", "raspberry"),
             ("kitchen", "food"), ("edible",), ("red",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
