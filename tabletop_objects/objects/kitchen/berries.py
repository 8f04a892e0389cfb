"""Objects of the ``kitchen`` theme: berries."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.parts import flat_foot
from ...kit.primitives import blade, limb, lobe, press_flat
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from .fruit import Globe, globe

LEAF: RGB = (78, 130, 58)


@category("strawberry", size=(0.05, 0.035, 0.033), mass=0.018, material="food", aliases=("berry",),
          themes=("kitchen", "food"), roles=("edible",), colors=("red",), state="lying flat",
          common=True)  # fmt: skip
def strawberry(look: Look) -> Shape:
    """A strawberry with its green leaves, lying on its side."""
    r, h = look.between(0.015, 0.019), look.between(0.036, 0.046)
    color = look.color("red", "crimson", "red", "coral")
    profile = [(0, 0), (0.2 * r, 0.03 * h), (0.62 * r, 0.3 * h), (0.95 * r, 0.66 * h),
               (r, 0.82 * h), (0.7 * r, 0.97 * h), (0, 0.94 * h)]  # fmt: skip
    body = press_flat(lathe(profile, 22).turn(1, np.pi / 2).move(x=-h / 2), 0.9 * r)
    seeds = speck(surfaces.speckles(look.rng, color, 5, 64), look.rng, (236, 206, 110), 70, 1)
    end, leaves = 0.44 * h, []
    for k in range(7):
        angle = 2 * np.pi * k / 7
        way = np.array([-0.25, np.cos(angle), np.sin(angle)]) * 1.15 * r
        foot = np.array([end, 0, 0.9 * r])
        leaves.append(blade([foot, foot + 0.6 * way + [0.002, 0, 0], foot + way], 0.009))
    stalk = tube([(end - 0.002, 0, 0.9 * r), (end + 0.01, 0, 1.1 * r)], 0.0014, 6)
    star = join([*leaves, stalk])
    return shape([(body, seeds), (star, surfaces.plain(LEAF))], [flat_foot(body.vertices, 0.18)])


def currants(palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """Return the shape function of a string of currants, lying flat."""

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
            tips.append(ellipsoid(0.002, 0.002, 0.002, 6, 4).move(at[0], at[1] + 0.5 * d
                                                                  * np.cos(a), at[2] + 0.5 * d
                                                                  * np.sin(a)))  # fmt: skip
        tile = surfaces.speckles(look.rng, color, 8)
        return settle([(join(balls), tile), (join([stalk, *tips]), surfaces.plain((110, 120, 60)))],
                      0.14)  # fmt: skip

    return make


@category("raspberry", size=(0.0255, 0.0203, 0.0186), mass=0.005, material="food",
          themes=("kitchen", "food"), roles=("edible",), colors=("crimson",))  # fmt: skip
def raspberry(look: Look) -> Shape:
    """A raspberry or blackberry of round drupelets, lying on its side."""
    k = look.between(0.9, 1.15)
    color = look.color("crimson", "red", "magenta")
    return _berry(look, color).scale(k)


@category("blackberry", size=(0.0265, 0.0211, 0.0193), mass=0.006, material="food",
          aliases=("mulberry", "boysenberry"), themes=("kitchen", "food"), roles=("edible",),
          colors=("black",))  # fmt: skip
def blackberry(look: Look) -> Shape:
    """A blackberry of dark drupelets."""
    return _berry(look, look.color("indigo", "black", "purple")).scale(look.between(0.9, 1.15))


def _berry(look: Look, color: RGB) -> Shape:
    balls = []
    for ring, (count, away, z) in enumerate(
        [(9, 0.0068, 0.0), (9, 0.0075, 0.004), (9, 0.0068, 0.008), (7, 0.0052, 0.0118),
         (4, 0.003, 0.0146), (1, 0, 0.0158)]
    ):  # fmt: skip
        for n in range(count):
            a = 2 * np.pi * (n + 0.5 * ring) / count
            balls.append(ellipsoid(0.0058, 0.0058, 0.0058, 7, 5).move(
                away * np.cos(a), away * np.sin(a), z))  # fmt: skip
    core = ellipsoid(0.013, 0.013, 0.019, 12, 8).move(z=0.005)
    leaves = [ellipsoid(0.009, 0.003, 0.0012, 6, 4).turn(1, 0.5).move(x=0.005, z=-0.0035)
              .turn(2, a) for a in np.arange(5) * 1.257]  # fmt: skip
    body = join([core, *balls]).turn(1, 1.75)
    tile = surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.15), look.rng)
    return settle([(body, tile), (join(leaves).turn(1, 1.75), surfaces.plain((96, 150, 66)))],
                  0.1)  # fmt: skip


@category("blueberry", size=(0.0149, 0.0149, 0.0123), mass=0.002, material="food",
          aliases=("bilberry", "huckleberry", "cranberry"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("navy",))  # fmt: skip
def blueberry(look: Look) -> Shape:
    """A blueberry with its crown up."""
    d = look.between(0.013, 0.017)
    color = look.color("navy", "indigo", "blue")
    body = ellipsoid(d, d, 0.88 * d, 20, 12)
    crown = lobe(lathe([(0.2 * d, 0.4 * d), (0.3 * d, 0.5 * d), (0.25 * d, 0.5 * d),
                        (0.16 * d, 0.42 * d)], 30, loop=True), 5, 0.25)  # fmt: skip
    dark = cylinder(0.18 * d, 0.02 * d, 12).move(z=0.425 * d)
    return settle([(body, skin(look, tint_color(color, 0.9), tint_color(color, 1.4), 0.7)),
                   (join([crown, dark]), surfaces.plain(tint_color(color, 0.6)))],
                  0.12)  # fmt: skip


CATEGORIES = (
    Category("gooseberry", globe(Globe((0.016, 0.021), 1.12, ("lime", "sage", "lime", "maroon"),
             "streaks", top="tuft")), size=(0.0182, 0.0179, 0.0193), mass=0.005, material="food",
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("lime",)),
    Category("physalis", globe(Globe((0.03, 0.036), 1.3, ("tan", "beige", "amber"), "dark streaks",
             top="stem", pear=0.35)), size=(0.0338, 0.0345, 0.0403), mass=0.006, material="food",
             aliases=("cape gooseberry", "ground cherry"), themes=("kitchen", "food"),
             roles=("round", "edible"), colors=("tan",)),
    Category("juniper_berry",
             globe(Globe((0.007, 0.009), 1.0, ("navy", "indigo", "navy", "purple"), top="tuft")),
             size=(0.00814, 0.00819, 0.00819), mass=0.0003, material="food", aliases=("juniper",),
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("navy",)),
    Category("redcurrant", currants(("red", "crimson", "red")), size=(0.0783, 0.0234, 0.0158),
             mass=0.006, material="food", assembled=True, aliases=("string of redcurrants",
             "bunch of redcurrants", "red currant", "sprig of redcurrants", "white currant"),
             themes=("kitchen", "food"), roles=("edible",), colors=("red",), state="lying"),
    Category("blackcurrant", currants(("black", "indigo", "navy")), size=(0.0781, 0.0234, 0.0158),
             mass=0.006, material="food", assembled=True,
             aliases=("black currant", "bunch of blackcurrants", "elderberry", "currant"),
             themes=("kitchen", "food"), roles=("edible",), colors=("black",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
