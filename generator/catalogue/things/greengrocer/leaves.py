"""Leafy things: pak choi, chard, radicchio, romanesco, bundles, single leaves, plumes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.forms import blade
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, torus
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..harvest.greens import head, leafy

GREEN: RGB = (70, 132, 62)


def _stalked_leaf(
    long: tuple[float, float], stalks: tuple[str, ...], thick: float, leaf: float, count: int
) -> Callable[[Look], Shape]:
    """Return the shape function of leaves on broad stalks that meet at a foot, lying."""

    def make(look: Look) -> Shape:
        size, stalk = look.between(*long), look.color(*stalks)
        green = look.own_color("green", "green", "olive", spread=12)
        low, tops = [], []
        for k in range(count):
            s = (k - (count - 1) / 2) / count
            z = 0.012 + 0.012 * (k % 2)
            mid = (-0.05 * size, 0.25 * size * s, z)
            low.append(limb([(-0.5 * size, 0.06 * size * s, 0.014), (-0.28 * size, 0.2 * size * s,
                z),
                             mid, (0.2 * size, 0.5 * size * s, z)],
                            [thick * size, 1.1 * thick * size, 0.5 * thick * size,
                             0.1 * thick * size], 8, 0.7))  # fmt: skip
            tops.append(blade([(-0.1 * size, 0.24 * size * s, z), (0.15 * size, 0.5 * size * s,
                z + 0.006),
                               (0.5 * size, 0.8 * size * s, 0.4 * z)], leaf * size,
                               thick=0.12))  # fmt: skip
        return settle([(join(low), textures.speckles(look.rng, stalk, 6)),
                       (join(tops), leafy(look, green))], 0.16)  # fmt: skip

    return make


def radicchio(look: Look) -> Shape:
    """A head of radicchio: dark red leaves with white ribs."""
    color = look.color("maroon", "crimson", "purple")
    return settle([(head(look, look.between(0.045, 0.056), 8, 0.12), leafy(look, color))], 0.07)


def brussels_sprout(look: Look) -> Shape:
    """A brussels sprout: a small tight head with a cut foot."""
    r = look.between(0.014, 0.019)
    color = look.color("lime", "green", "sage")
    ball = head(look, r, 6, 0.02)
    foot = cylinder(0.4 * r, 0.3 * r, 12).move(z=-0.16 * r)
    return settle([(ball, leafy(look, color)), (foot, textures.plain((240, 236, 200)))], 0.1,
                  hulls=[[0]])  # fmt: skip


def romanesco(look: Look) -> Shape:
    """A romanesco: spiralling cones of cones on a leafy foot."""
    r = look.between(0.055, 0.068)
    color = look.color("lime", "green", "lime")
    core = lathe(
        [(0, 0), (0.8 * r, 0.02), (0.86 * r, 0.5 * r), (0.4 * r, 1.2 * r), (0, 1.55 * r)], 20
    )
    buds = []
    for k in range(46):
        t = (k + 0.5) / 46
        out, z = r * (0.08 + 0.86 * t**0.8), 1.5 * r * (1 - t) + 0.28 * r
        a = 2.4 * k
        s = r * (0.12 + 0.18 * t)
        bud = cylinder(s, 1.7 * s, 7, top=0.05 * s).turn(1, 0.25 + 0.8 * t).turn(2, a)
        buds.append(bud.move(out * np.cos(a) * 0.82, out * np.sin(a) * 0.82, z - 0.3 * s))
    leaves = [blade([(0.5 * r, 0, 0.006), (1.05 * r, 0, 0.2 * r), (1.3 * r, 0, 0.75 * r)], 0.7 * r,
                    thick=0.15).turn(2, 2 * np.pi * k / 6) for k in range(6)]  # fmt: skip
    tile = textures.spots(look.rng, color, tint_color(color, 1.3), 0.2)
    return settle([(join([core, *buds]), tile), (join(leaves), leafy(look, GREEN))], 0.03)


def _bundle(palette: tuple[str, ...], fluff: float) -> Callable[[Look], Shape]:
    """Return the shape function of herbs tied in a bundle, lying."""

    def make(look: Look) -> Shape:
        long, color = look.between(0.12, 0.16), look.color(*palette)
        r = look.between(0.014, 0.018)
        stalks, leaves = [], []
        for k in range(9):
            a = 2.4 * k
            y, z = 0.7 * r * np.sin(a), 0.7 * r * np.cos(a) + r
            path = [(-0.5 * long, 1.2 * y, z), (-0.12 * long, 0.5 * y, r + 0.5 * (z - r)),
                    (0.46 * long, 1.5 * y, r + 0.9 * (z - r))]  # fmt: skip
            stalks.append(limb(path, [0.0014, 0.0016, 0.001], 5))
            for n in range(6):
                x = long * (-0.02 + 0.09 * n)
                leaves.append(ellipsoid(0.026, 0.011 * fluff, 0.008, 6, 4).turn(1,
                    0.25 * np.cos(a + n))
                              .turn(2, 0.4 * np.sin(a + 2 * n))
                              .move(x, y * (1 + 0.08 * n),
                                    r + (z - r) * (1 + 0.03 * n)))  # fmt: skip
        ties = [torus(0.7 * r, 0.0016, 14, 5).turn(1, np.pi / 2).move(x, 0, r)
                for x in (-0.16 * long, -0.13 * long, -0.1 * long)]  # fmt: skip
        dry = textures.speckles(look.rng, color, 18)
        return settle([(join(leaves), dry), (join(stalks), textures.plain(tint_color(color, 0.75))),
                       (join(ties), textures.plain((222, 200, 150)))], 0.16)  # fmt: skip

    return make


def _single(
    long: tuple[float, float], wide: float, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of one pointed leaf on its stalk, lying."""

    def make(look: Look) -> Shape:
        size, color = look.between(*long), look.color(*palette)
        w = wide * size * look.between(0.85, 1.15)
        leaf = blade([(-0.5 * size, 0, 0), (-0.2 * size, 0.01 * size, 0.05 * size),
                      (0.2 * size, 0, 0.06 * size), (0.5 * size, 0, 0.01 * size)], w,
                      thick=0.06)  # fmt: skip
        stalk = limb([(-0.62 * size, 0, 0), (-0.4 * size, 0, 0.01 * size)], [0.0009, 0.0008], 6)
        tile = textures.leaf(look.rng, color).transpose(1, 0, 2)
        return settle([(leaf, tile), (stalk, textures.plain(tint_color(color, 0.8)))], 0.1)

    return make


def four_leaf_clover(look: Look) -> Shape:
    """A four-leaf clover lying: heart-shaped leaflets on a stalk."""
    k = look.between(0.85, 1.2)
    color = look.color("green", "green", "lime")
    parts = []
    for n in range(4):
        for s in (-1, 1):
            leaf = ellipsoid(0.017, 0.011, 0.0016, 10, 5).turn(2, 0.42 * s)
            parts.append(leaf.move(0.0105, 0.003 * s, 0.0014).turn(2, np.pi / 2 * n + 0.5))
    stalk = limb([(0, 0, 0.001), (0.012, -0.014, 0.001), (0.014, -0.036, 0.001)],
                 [0.001, 0.0009, 0.0008], 6)  # fmt: skip
    veins = textures.spots(look.rng, color, tint_color(color, 1.4), 0.12)
    return settle(
        [(join(parts), veins), (stalk, textures.plain(tint_color(color, 0.8)))], 0.1
    ).scale(k)


def pampas_stem(look: Look) -> Shape:
    """A stem of pampas grass lying: a long fluffy plume on a dry stalk."""
    long = look.between(0.42, 0.5)
    color = look.color("cream", "beige", "tan", "pink", "ivory")
    stalk = limb([(-0.5 * long, 0, 0.004), (0, 0, 0.007), (0.44 * long, 0.01, 0.009)],
                 [0.0022, 0.002, 0.001], 6)  # fmt: skip
    wisps = []
    for k in range(56):
        x = long * (-0.02 + 0.46 * (k % 28) / 28)
        a = 2.4 * k
        out = 0.024 * np.sin(np.pi * (0.12 + 0.8 * (k % 28) / 28)) * look.between(0.7, 1.2)
        wisps.append(limb([(x, 0, 0.009), (x + 0.03, out * np.cos(a),
                                           0.009 + 0.7 * out * np.sin(a)),
                           (x + 0.075, 1.3 * out * np.cos(a), 0.007 + 0.8 * out * np.sin(a))],
                          [0.0012, 0.004, 0.0006], 4))  # fmt: skip
    fluff = textures.scratches(look.rng, color, tint_color(color, 0.85), 120)
    return settle([(join(wisps), fluff), (stalk, textures.plain((196, 174, 120)))], 0.18,
                  hulls=[[0], [1]])  # fmt: skip


def currants(palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """Return the shape function of a string of currants lying."""

    def make(look: Look) -> Shape:
        long, color = look.between(0.06, 0.08), look.color(*palette)
        stalk = limb([(-0.6 * long, 0, 0.006), (0, 0.004, 0.008), (0.5 * long, -0.004, 0.006)],
                     [0.0009, 0.0008, 0.0005], 5)  # fmt: skip
        balls, tips = [], []
        for k in range(13):
            x = long * (-0.36 + 0.84 * k / 13)
            a, d = 2.4 * k, 0.0095 - 0.0025 * k / 13
            at = (x, 0.0062 * np.cos(a), 0.007 + 0.004 * np.sin(a))
            balls.append(ellipsoid(d, d, d, 12, 8).move(*at))
            tips.append(
                ellipsoid(0.002, 0.002, 0.002, 6, 4).move(
                    at[0], at[1] + 0.5 * d * np.cos(a), at[2] + 0.5 * d * np.sin(a)
                )
            )
        tile = textures.speckles(look.rng, color, 8)
        return settle([(join(balls), tile), (join([stalk, *tips]), textures.plain((110, 120, 60)))],
                      0.14)  # fmt: skip

    return make


def lavender_sachet(look: Look) -> Shape:
    """A small cloth pouch tied with a ribbon, lavender peeping out."""
    r, h = look.between(0.03, 0.037), look.between(0.085, 0.1)
    color = look.color("lavender", "white", "violet", "beige", "pink")
    bag = lathe([(0, 0), (0.8 * r, 0), (r, 0.18 * h), (0.9 * r, 0.42 * h), (0.3 * r, 0.66 * h),
                 (0.26 * r, 0.7 * h), (0.7 * r, 0.94 * h), (0.66 * r, h), (0, 0.86 * h)],
                 26)  # fmt: skip
    tie = torus(0.3 * r, 0.0025, 18, 6).move(z=0.68 * h)
    loops = [ellipsoid(0.02, 0.005, 0.011, 10, 6).turn(1, 0.3 * s).move(s * 0.011, -0.34 * r,
        0.68 * h)
             for s in (-1, 1)]  # fmt: skip
    cloth = textures.fabric(look.rng, color)
    sprigs = [ellipsoid(0.006, 0.006, 0.014, 8, 5).move(0.3 * r * np.cos(a), 0.3 * r * np.sin(a), h)
              for a in np.arange(5) * 1.26]  # fmt: skip
    bow = textures.plain(look.own_color("purple", "violet", "indigo"))
    return shape([(bag.scale(1, 0.8, 1), cloth), (join([tie, *loops]), bow),
                  (join(sprigs), textures.plain((128, 96, 176)))],
                 settle([(bag.scale(1, 0.8, 1), cloth)], 0.0).parts)  # fmt: skip


_K = ("kitchen", "food")
_E = ("edible",)
CATEGORIES = (
    Category("pak_choi", _stalked_leaf((0.17, 0.2), ("white", "ivory", "sage"), 0.075, 0.3, 7),
             (0.188, 0.133, 0.0279), 0.15, ("bok choy", "pak choy", "bok choi",
                 "chinese cabbage", "napa cabbage", "chinese leaf"), _K, _E, ("green",),
             state="lying flat"),
    Category("chard", _stalked_leaf((0.26, 0.31), ("crimson", "yellow", "white", "pink"), 0.03,
             0.26, 5),
             (0.29, 0.192, 0.0238), 0.2, ("swiss chard", "rainbow chard", "silverbeet",
                                          "chard leaf"), _K, _E,
             ("crimson",), state="lying flat"),
    Category("spinach", _stalked_leaf((0.13, 0.16), ("lime", "sage", "pink"), 0.018, 0.3, 8),
             (0.141, 0.103, 0.0227),
             0.1, ("spinach bunch", "bunch of spinach", "spinach leaf", "baby spinach",
             "fresh spinach"), _K, _E, ("green",), state="lying flat"),
    Category("radicchio", radicchio, (0.115, 0.123, 0.0757), 0.3, (), _K, ("edible", "round"),
             ("maroon",)),
    Category("brussels_sprout", brussels_sprout, (0.046, 0.0428, 0.0272), 0.02,
             ("sprout", "brussel sprout"), _K,
             ("edible", "round"), ("lime",)),
    Category("romanesco", romanesco, (0.155, 0.136, 0.114), 0.5, ("romanesco broccoli",
             "romanesco cauliflower"), _K, ("edible", "round"), ("lime",)),
    Category("herb_bundle", _bundle(("olive", "sage", "green"), 1.0), (0.14, 0.0409, 0.0273), 0.03,
             ("dried herb bundle", "bundle of herbs", "bouquet garni", "bundle of thyme",
              "bundle of dried herbs", "tied herbs"), _K, _E, ("olive",), state="lying"),
    Category("sage_bundle", _bundle(("sage", "gray", "sage"), 1.5), (0.148, 0.046, 0.0279), 0.03,
             ("smudge stick", "bundle of sage", "white sage bundle", "sage stick"), ("living",), (),
             ("sage",), state="lying"),
    Category("bay_leaf", _single((0.06, 0.085), 0.36, ("olive", "green", "sage")),
             (0.0806, 0.0199, 0.00524),
             0.0005, ("dried bay leaf", "laurel leaf", "kaffir lime leaf", "curry leaf",
             "lime leaf"), _K, ("edible", "flat"), ("olive",), state="lying flat"),
    Category("sage_leaf", _single((0.05, 0.07), 0.42, ("sage", "gray", "sage")),
             (0.0611, 0.018, 0.00421), 0.0005,
             (), _K, ("edible", "flat"), ("sage",), state="lying flat"),
    Category("four_leaf_clover", four_leaf_clover, (0.0404, 0.0596, 0.00203), 0.0005,
             ("clover", "shamrock",
             "clover leaf", "lucky clover"), ("living",), ("flat",), ("green",),
             state="lying flat"),
    Category("pampas_stem", pampas_stem, (0.505, 0.0674, 0.0377), 0.015,
             ("pampas grass stem",
             "pampas", "stem of pampas grass", "pampas plume"), ("living",), (), ("cream",),
             state="lying"),
    Category("redcurrant", currants(("red", "crimson", "red")), (0.0783, 0.0234, 0.0158), 0.006,
             ("string of redcurrants", "bunch of redcurrants", "red currant",
              "sprig of redcurrants",
              "white currant"), _K, _E, ("red",), state="lying"),
    Category("blackcurrant", currants(("black", "indigo", "navy")), (0.0781, 0.0234, 0.0158), 0.006,
             ("black currant", "bunch of blackcurrants", "elderberry", "currant"), _K, _E,
             ("black",), state="lying"),
    Category("lavender_sachet", lavender_sachet, (0.0658, 0.053, 0.1), 0.03,
             ("scented sachet",
             "lavender bag", "potpourri sachet", "drawer sachet"), ("living",), (), ("lavender",)),
)  # fmt: skip
"""The module's categories."""
