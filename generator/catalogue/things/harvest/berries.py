"""Small fruit by the piece: berries, figs, dates, pomegranates."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import lobe, streaks
from ...build.settled import rod, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, prism
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin


def raspberry(look: Look) -> Shape:
    """A raspberry or blackberry of round drupelets, lying on its side."""
    k = look.between(0.9, 1.15)
    color = look.color("crimson", "red", "magenta")
    return _berry(look, color).scale(k)


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
    tile = textures.gradient(tint_color(color, 0.8), tint_color(color, 1.15), look.rng)
    return settle([(body, tile), (join(leaves).turn(1, 1.75), textures.plain((96, 150, 66)))],
                  0.1)  # fmt: skip


def blueberry(look: Look) -> Shape:
    """A blueberry, its crown up."""
    d = look.between(0.013, 0.017)
    color = look.color("navy", "indigo", "blue")
    body = ellipsoid(d, d, 0.88 * d, 20, 12)
    crown = lobe(lathe([(0.2 * d, 0.4 * d), (0.3 * d, 0.5 * d), (0.25 * d, 0.5 * d),
                        (0.16 * d, 0.42 * d)], 30, loop=True), 5, 0.25)  # fmt: skip
    dark = cylinder(0.18 * d, 0.02 * d, 12).move(z=0.425 * d)
    return settle(
        [
            (body, skin(look, tint_color(color, 0.9), tint_color(color, 1.4), 0.7)),
            (join([crown, dark]), textures.plain(tint_color(color, 0.6))),
        ],
        0.12,
    )


def fig(look: Look) -> Shape:
    """A fig sitting, its neck up."""
    r, h = look.between(0.023, 0.028), look.between(0.052, 0.062)
    color = look.color("purple", "maroon", "indigo", "sage")
    body = lathe([(0, 0), (0.5 * r, 0.0), (0.92 * r, 0.16 * h), (r, 0.36 * h), (0.8 * r, 0.6 * h),
                  (0.36 * r, 0.82 * h), (0.17 * r, h), (0, h)], 28)  # fmt: skip
    dark = tint_color(color, 0.72)
    return settle([(body, streaks(look.rng, dark, tint_color(color, 1.25), 16))], 0.02)


def pomegranate(look: Look) -> Shape:
    """A pomegranate with its crown."""
    r = look.between(0.04, 0.05)
    color = look.color("crimson", "red", "coral")
    body = lobe(ellipsoid(2 * r, 2 * r, 1.85 * r, 36, 16), 6, 0.04)
    crown = lobe(
        lathe(
            [
                (0.14 * r, 0.85 * r),
                (0.24 * r, 1.1 * r),
                (0.4 * r, 1.38 * r),
                (0.33 * r, 1.36 * r),
                (0.15 * r, 1.05 * r),
            ],
            36,
            loop=True,
        ),
        6,
        0.35,
    )
    core = cylinder(0.2 * r, 0.3 * r, 12).move(z=0.85 * r)
    return settle([(body, skin(look, color, tint_color(color, 0.7), 0.8)),
                   (crown, textures.plain(tint_color(color, 0.85))),
                   (core, textures.plain((214, 180, 90)))], 0.06)  # fmt: skip


def star_fruit(look: Look) -> Shape:
    """A thick star-shaped slice lying flat."""
    r, t = look.between(0.028, 0.036), look.between(0.008, 0.012)
    color = look.color("yellow", "lime", "golden")
    a = np.arange(10) * np.pi / 5 + np.pi / 2
    star = np.column_stack([np.cos(a), np.sin(a)]) * np.where(np.arange(10) % 2, 0.5, 1)[:, None]
    body = prism(r * star, 0, t)
    face = prism(0.84 * r * star, t - 0.0004, t + 0.0006)
    seeds = [ellipsoid(0.006, 0.003, 0.0014, 8, 4).move(x=0.3 * r).turn(2, b).move(z=t + 0.0006)
             for b in a[::2]]  # fmt: skip
    return shape([(body, textures.speckles(look.rng, color, 8)),
                  (face, textures.plain(tint_color(color, 1.3))),
                  (join(seeds), textures.plain((150, 110, 50)))], [hull_of(body)])  # fmt: skip


def passion_fruit(look: Look) -> Shape:
    """Half a passion fruit, yellow pulp and seeds in its dark shell."""
    d = look.between(0.052, 0.062)
    color = look.color("purple", "maroon", "purple", "yellow")
    half = lathe([(0, 0), (0.2, 0), (0.42, 0.14), (0.5, 0.38), (0.5, 0.46), (0.45, 0.46),
                  (0.4, 0.34), (0, 0.34)], 28).scale(d, d, d)  # fmt: skip
    pulp = lathe([(0, 0.3), (0.42, 0.34), (0.36, 0.4), (0, 0.44)], 24).scale(d, d, d)
    seeds = [
        ellipsoid(0.006, 0.0045, 0.004, 6, 5)
        .turn(2, n)
        .move(
            0.32 * d * np.sqrt((n + 0.5) / 12) * np.cos(2.4 * n),
            0.32 * d * np.sqrt((n + 0.5) / 12) * np.sin(2.4 * n),
            0.42 * d,
        )
        for n in range(12)
    ]
    return shape([(half, textures.spots(look.rng, tint_color(color, 0.7), color, 0.1)),
                  (pulp, textures.gradient((236, 150, 30), (248, 196, 60), look.rng)),
                  (join(seeds), textures.plain((44, 38, 34)))], [hull_of(half)])  # fmt: skip


def date(look: Look) -> Shape:
    """A wrinkled date lying."""
    long, r = look.between(0.036, 0.044), look.between(0.0095, 0.012)
    color = look.color("brown", "bronze", "maroon")
    body = rod(long, r, blunt=3, squash=0.9)
    wrinkled = textures.stripes([tint_color(color, 0.6), tint_color(color, 0.8)], 9, upright=True)
    cap = cylinder(0.3 * r, 0.003, 10).turn(1, np.pi / 2).move(x=0.48 * long)
    return settle([(body, wrinkled), (cap, textures.plain((196, 160, 100)))], 0.14)


_K = ("kitchen", "food")
CATEGORIES = (
    Category("raspberry", raspberry, (0.0255, 0.0203, 0.0186), 0.005, (), _K, ("edible",),
             ("crimson",)),
    Category("blackberry", blackberry, (0.0265, 0.0211, 0.0193), 0.006, ("mulberry", "boysenberry"),
             _K, ("edible",), ("black",)),
    Category("blueberry", blueberry, (0.0149, 0.0149, 0.0123), 0.002, ("bilberry",
                 "huckleberry", "cranberry"), _K, ("round", "edible"),
             ("navy",)),
    Category("fig", fig, (0.0511, 0.0511, 0.0562), 0.05, (), _K, ("round", "edible"), ("purple",)),
    Category("pomegranate", pomegranate, (0.0907, 0.0875, 0.0968), 0.28, ("granadilla",), _K,
             ("round", "edible"), ("crimson",)),
    Category("star_fruit", star_fruit, (0.0586, 0.0557, 0.0114), 0.02, ("starfruit", "carambola"),
             _K, ("edible", "flat"), ("yellow",), state="lying flat"),
    Category("passion_fruit", passion_fruit, (0.058, 0.058, 0.0267), 0.04, ("passionfruit",
             "maracuja"), _K, ("edible", "round"), ("purple",)),
    Category("date", date, (0.0412, 0.0211, 0.0159), 0.012, ("medjool date", "dried date", "prune"),
             _K, ("edible",), ("brown",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
