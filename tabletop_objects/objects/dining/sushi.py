"""Objects of the ``dining`` theme: sushi."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import rounded_polygon
from ...kit.parts import cylinder_part, hull_above, hull_of, hull_part
from ...kit.primitives import blade, side_view
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe
from ...kit.surfaces import RGB, Look, tint_color

NORI: RGB = (36, 46, 38)
RICE: RGB = (246, 244, 236)


def _rice(look: Look) -> surfaces.Tile:
    return surfaces.spots(look.rng, RICE, (222, 218, 206), 0.3)


@category("nigiri", size=(0.0682, 0.0316, 0.027), mass=0.035, material="food",
          aliases=("nigiri sushi", "salmon nigiri", "tuna nigiri", "piece of sushi",
          "piece of nigiri", "sushi piece"), themes=("dining",), roles=("edible",),
          colors=("coral",), state="lying flat")  # fmt: skip
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
        pieces.append((box(0.008, 0.0335, 0.0285).move(z=0.0002), surfaces.plain(NORI)))
    return shape(pieces, [hull_of(rice), hull_above(top)])


@category("sashimi", size=(0.119, 0.0719, 0.0135), mass=0.06, material="food",
          aliases=("salmon sashimi", "tuna sashimi"), themes=("dining",), roles=("edible", "flat"),
          colors=("coral",), state="lying flat")  # fmt: skip
def sashimi(look: Look) -> Shape:
    """A few overlapping slices of raw fish on a leaf."""
    color = look.color("coral", "coral", "crimson", "pink", "white")
    rows = np.linspace(0, 1, 96)
    line = np.abs(np.sin(np.pi * (6 * rows[:, None] + 1.5 * rows[None]))) < 0.2
    tile = np.where(line[..., None], np.array(tint_color(color, 1.45)), np.array(color))
    one = block(0.03, look.between(0.046, 0.055), 0.007, 0.006, 0.002).turn(1, -0.26)
    cuts = [one.move(0.019 * (n - 1.5), 0, 0.0034) for n in range(4)]
    leaf = blade([(-0.055, 0.02, 0.0014), (0, 0.028, 0.0016), (0.062, 0.03, 0.001)], 0.05,
                 thick=0.1)  # fmt: skip
    return shape([(leaf, surfaces.leaf(look.rng, (70, 132, 66))),
                  (join(cuts), tile.astype(np.uint8))], [hull_above(*cuts)])  # fmt: skip


@category("sushi_roll", size=(0.0402, 0.0405, 0.0246), mass=0.025, material="food",
          aliases=("maki", "maki roll", "maki sushi", "california roll", "sushi maki", "futomaki"),
          themes=("dining",), roles=("edible", "round"))  # fmt: skip
def sushi_roll(look: Look) -> Shape:
    """One piece of a sushi roll standing upright: a filling in rice and seaweed."""
    r, h = look.between(0.018, 0.022), look.between(0.02, 0.026)
    nori = cylinder(r, h, 26)
    rice = cylinder(0.93 * r, h + 0.0012, 26)
    color = look.color("coral", "orange", "green", "yellow", "crimson")
    core = block(0.6 * r, 0.5 * r, h + 0.002, 0.12 * r).move(-0.1 * r, 0.05 * r)
    other = cylinder(0.2 * r, h + 0.002, 12).move(0.42 * r, -0.18 * r)
    green = surfaces.plain(look.own_color("green", "lime"))
    return shape([(nori, surfaces.speckles(look.rng, NORI, 8)), (rice, _rice(look)),
                  (core, surfaces.plain(color)), (other, green)],
                 [hull_of(nori, core)])  # fmt: skip


@category("onigiri", size=(0.0595, 0.0339, 0.055), mass=0.1, material="food",
          aliases=("rice ball", "rice triangle"), themes=("dining",),
          roles=("edible",))  # fmt: skip
def onigiri(look: Look) -> Shape:
    """A triangular rice ball standing upright, with a strip of seaweed around its base."""
    k, t = look.between(0.036, 0.042), look.between(0.03, 0.036)
    corners = np.array([(-1, 0), (1, 0), (0, 1.75)]) * k
    outline = rounded_polygon(corners, 0.32 * k, 5)
    body = side_view(outline, t, 0.2 * t)
    nori = box(0.86 * k, t + 0.0016, 0.85 * k)
    return shape([(body, _rice(look)), (nori, surfaces.speckles(look.rng, NORI, 8))],
                 [hull_part(body.vertices), hull_of(nori)])  # fmt: skip


@category("sushi_rolls", size=(0.151, 0.0458, 0.0288), mass=0.1, material="food", assembled=True,
          aliases=("maki rolls", "row of sushi"), themes=("dining", "food"), roles=("edible",),
          colors=("orange",))  # fmt: skip
def sushi_rolls(look: Look) -> Shape:
    """Three to five sushi rolls standing in a row, each with a filling in rice and seaweed."""
    r, h = look.between(0.017, 0.022), look.between(0.022, 0.028)
    color = look.color("orange", "coral", "green", "crimson", "yellow", "lime")
    rice = surfaces.spots(look.rng, (248, 246, 238), (226, 222, 208), 0.3)
    nori = surfaces.speckles(look.rng, (34, 46, 38), 8)
    inside_out = look.chance(0.3)
    pieces: list[tuple[Solid, surfaces.Tile]] = []
    parts = []
    count = int(look.rng.integers(3, 6))
    for k in range(count):
        x, y = (k - (count - 1) / 2) * 2.25 * r, 0.003 * (-1) ** k
        band = lathe([(0.88 * r, 0), (r, 0.001), (r, h - 0.001), (0.88 * r, h)], 24, loop=True)
        core = lathe([(0, 0), (0.89 * r, 0), (0.89 * r, h), (0, h + 0.001)], 22)
        fill = cylinder(0.4 * r, 0.003, 14).move(z=h)
        other = cylinder(0.17 * r, 0.0034, 10).move(0.24 * r, 0.1 * r, h)
        outer = surfaces.spots(look.rng, (248, 246, 238), (232, 120, 50), 0.2)
        pieces += [(band.move(x, y), outer if inside_out else nori), (core.move(x, y), rice),
                   (fill.move(x, y), surfaces.speckles(look.rng, color, 8, 32)),
                   (other.move(x, y), surfaces.plain((120, 170, 70)))]  # fmt: skip
        parts.append(cylinder_part(r, h, (x, y, 0)))
    return shape(pieces, parts)


@category("wasabi", size=(0.0287, 0.0282, 0.0198), mass=0.008, material="food",
          aliases=("wasabi paste", "lump of wasabi", "ball of wasabi"), themes=("dining",),
          roles=("edible",))  # fmt: skip
def wasabi(look: Look) -> Shape:
    """A small pressed cone of green wasabi paste."""
    r = look.between(0.013, 0.017)
    color = look.color("lime", "olive", "green")
    tone = tint_color((170.0, 196.0, 100.0), 1.0) if "color" not in look.attributes else color
    body = lathe([(0, 0), (r, 0), (0.95 * r, 0.35 * r), (0.5 * r, 1.0 * r), (0.2 * r, 1.35 * r),
                  (0, 1.4 * r)], 18)  # fmt: skip
    rough = body.bend(lambda p: p * (1 + 0.05 * np.sin(900 * p[:, :1] + 700 * p[:, 1:2])))
    return shape([(rough, surfaces.speckles(look.rng, tone, 14)),
                  (cylinder(0.5 * r, 0.0004, 10), surfaces.plain(tone))],
                 [cylinder_part(0.95 * r, 0.3 * r), hull_of(body)])  # fmt: skip
