"""Sushi by the piece: nigiri, sashimi, rolls, rice balls."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.forms import blade, side_view
from ...build.outlines import rounded_polygon
from ...build.settled import hull_above
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

NORI: RGB = (36, 46, 38)
RICE: RGB = (246, 244, 236)


def _rice(look: Look) -> textures.Tile:
    return textures.spots(look.rng, RICE, (222, 218, 206), 0.3)


def nigiri(look: Look) -> Shape:
    """A piece of nigiri: rice under a slice of salmon, tuna, prawn or egg."""
    x = look.between(0.05, 0.058)
    rice = block(x, 0.026, 0.02, 0.01, 0.006)
    top = ellipsoid(1.28 * x, 0.031, 0.011, 20, 10).move(z=0.021)
    top = top.bend(lambda p: p - p[:, :1] ** 2 * [0, 0, 7.0])
    color = look.color("coral", "coral", "crimson", "pink", "yellow", "white")
    rows = np.linspace(0, 1, 96)
    line = np.abs(np.sin(np.pi * (7 * rows[None] + 2 * rows[:, None]))) < 0.22
    tile = np.where(line[..., None], np.array(tint_color(color, 1.45)), np.array(color))
    pieces = [(rice, _rice(look)), (top, tile.astype(np.uint8))]
    if look.chance(0.25):
        pieces.append((box(0.008, 0.0335, 0.0285).move(z=0.0002), textures.plain(NORI)))
    return shape(pieces, [hull_of(rice), hull_above(top)])


def sashimi(look: Look) -> Shape:
    """A few overlapping slices of raw fish lying on a leaf."""
    color = look.color("coral", "coral", "crimson", "pink", "white")
    rows = np.linspace(0, 1, 96)
    line = np.abs(np.sin(np.pi * (6 * rows[:, None] + 1.5 * rows[None]))) < 0.2
    tile = np.where(line[..., None], np.array(tint_color(color, 1.45)), np.array(color))
    one = block(0.03, look.between(0.046, 0.055), 0.007, 0.006, 0.002).turn(1, -0.26)
    cuts = [one.move(0.019 * (n - 1.5), 0, 0.0034) for n in range(4)]
    leaf = blade([(-0.055, 0.02, 0.0014), (0, 0.028, 0.0016), (0.062, 0.03, 0.001)], 0.05,
                 thick=0.1)  # fmt: skip
    return shape([(leaf, textures.leaf(look.rng, (70, 132, 66))),
                  (join(cuts), tile.astype(np.uint8))], [hull_above(*cuts)])  # fmt: skip


def sushi_roll(look: Look) -> Shape:
    """One cut piece of a sushi roll standing: seaweed, rice, a filling."""
    r, h = look.between(0.018, 0.022), look.between(0.02, 0.026)
    nori = cylinder(r, h, 26)
    rice = cylinder(0.93 * r, h + 0.0012, 26)
    color = look.color("coral", "orange", "green", "yellow", "crimson")
    core = block(0.6 * r, 0.5 * r, h + 0.002, 0.12 * r).move(-0.1 * r, 0.05 * r)
    other = cylinder(0.2 * r, h + 0.002, 12).move(0.42 * r, -0.18 * r)
    green = textures.plain(look.own_color("green", "lime"))
    return shape(
        [
            (nori, textures.speckles(look.rng, NORI, 8)),
            (rice, _rice(look)),
            (core, textures.plain(color)),
            (other, green),
        ],
        [hull_of(nori, core)],
    )


def onigiri(look: Look) -> Shape:
    """A triangular rice ball standing, a strip of seaweed round its foot."""
    k, t = look.between(0.036, 0.042), look.between(0.03, 0.036)
    corners = np.array([(-1, 0), (1, 0), (0, 1.75)]) * k
    outline = rounded_polygon(corners, 0.32 * k, 5)
    body = side_view(outline, t, 0.2 * t)
    nori = box(0.86 * k, t + 0.0016, 0.85 * k)
    return shape([(body, _rice(look)), (nori, textures.speckles(look.rng, NORI, 8))],
                 [hull_part(body.vertices), hull_of(nori)])  # fmt: skip


CATEGORIES = (
    Category("nigiri", nigiri, (0.0682, 0.0316, 0.027), 0.035, ("nigiri sushi", "salmon nigiri",
             "tuna nigiri", "piece of sushi", "piece of nigiri", "sushi piece"), ("dining",),
             ("edible",), ("coral",), state="lying flat"),
    Category("sashimi", sashimi, (0.119, 0.0719, 0.0135), 0.06, ("salmon sashimi", "tuna sashimi"),
             ("dining",), ("edible", "flat"), ("coral",), state="lying flat"),
    Category("sushi_roll", sushi_roll, (0.0402, 0.0405, 0.0246), 0.025, ("maki", "maki roll",
             "maki sushi", "california roll", "sushi maki", "futomaki"), ("dining",), ("edible",
             "round"), ()),
    Category("onigiri", onigiri, (0.0595, 0.0339, 0.055), 0.1, ("rice ball", "rice triangle"),
             ("dining",), ("edible",), ()),
)  # fmt: skip
"""The module's categories."""
