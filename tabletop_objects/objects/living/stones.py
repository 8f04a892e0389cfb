"""Objects of the ``living`` theme: stones."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import above, flat_foot
from ...kit.primitives import at_box, ball, hull_solid, pad, plate
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, ellipsoid, join, lathe, tube
from ...kit.surfaces import Look, plain, tint_color
from ..office.minerals import lump
from .models import _stone


@category("agate_slice", size=(0.112, 0.086, 0.0072), mass=0.09, material="stone",
          aliases=("slice of agate", "agate coaster", "sliced agate"), themes=("living",),
          roles=("flat",), colors=("blue", "purple"))  # fmt: skip
@from_pieces(bodies=1)
def agate_slice(look: Look) -> Pieces:
    """A slice of agate with coloured rings, a crystalline centre and a brown rind."""
    color = look.color("blue", "purple", "teal", "orange", "pink", "brown")
    swell = look.rng.uniform(0, 6.28, 2)
    a = 2 * np.pi * np.arange(40) / 40
    wave = 1 + 0.08 * np.sin(2 * a + swell[0]) + 0.05 * np.sin(5 * a + swell[1])
    ring = np.column_stack([0.055 * wave * np.cos(a), 0.042 * wave * np.sin(a)])
    tones = [(92, 70, 54), tint_color(color, 0.7), tint_color(color, 1.5), color,
             tint_color(color, 1.25), tint_color(color, 0.8), tint_color(color, 1.75)]  # fmt: skip
    pieces: Pieces = []
    for k, tone in enumerate(tones):
        rings = np.concatenate([np.column_stack([ring * (1 - 0.12 * k), np.full(40, z)])
                                for z in (0.0, 0.006 + 0.0002 * k)])  # fmt: skip
        pieces.append((hull_solid(rings), surfaces.speckles(look.rng, tone, 8, 32)))
    return pieces


@category("geode", size=(0.0984, 0.083, 0.0512), mass=0.35, material="stone",
          aliases=("amethyst geode", "crystal geode", "half geode", "split geode"),
          themes=("living",), colors=("purple",))  # fmt: skip
@from_pieces(bodies=2)
def geode(look: Look) -> Pieces:
    """Half a geode: a grey rind around a hollow of crystals."""
    color = look.color("purple", "purple", "white", "blue", "amber")
    rind = lump(look, 0.1, 0.085, 0.075, 40)
    top = float(rind.bounds[1, 2])
    cut = 0.62 * top
    rind = rind.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], cut)]))
    pieces: Pieces = [(rind, surfaces.spots(look.rng, (128, 120, 112), (90, 84, 78), 0.2))]
    pale = ball(0.082, 0.068, 0.006, (0, 0, cut), 24)
    pieces.append((pale, surfaces.speckles(look.rng, tint_color(color, 1.7), 6)))
    for k in range(34):
        r, t = 0.03 * np.sqrt((k + 0.5) / 34), 2.4 * k
        h = look.between(0.008, 0.014)
        tip = [(0.0045 * np.cos(a), 0.0045 * np.sin(a), z) for a in np.arange(6) * np.pi / 3
               for z in (-0.001, 0.6 * h)] + [(0, 0, h)]  # fmt: skip
        one = hull_solid(tip).turn(1, look.between(-0.4, 0.4)).turn(0, look.between(-0.4, 0.4))
        tone = surfaces.plain(tint_color(color, 0.75 + 0.2 * (k % 4)))
        pieces.append((one.move(1.15 * r * np.cos(t), 0.95 * r * np.sin(t), cut), tone))
    return pieces


@category("slab", size=(0.214, 0.163, 0.0196), mass=1.6, material="stone", aliases=("stone slab",
          "marble slab", "slate slab", "granite slab", "slab of stone", "slab of marble",
          "slab of slate"), themes=("living",), roles=("support", "flat", "big"),
          colors=("gray",))  # fmt: skip
def slab(look: Look) -> Shape:
    """A rectangular slab of stone."""
    x, y = look.between(0.18, 0.26), look.between(0.13, 0.19)
    made = block(x, y, look.between(0.016, 0.026), 0.004, 0.0015)
    return put_down([(made, _stone(look, "gray", "charcoal", "white", "tan", "sage"))], made)


@category("clay_tablet", size=(0.0936, 0.129, 0.0204), mass=0.35, material="ceramic",
          aliases=("cuneiform tablet", "stone tablet", "inscribed tablet", "rosetta stone",
          "rosetta stone replica", "rune stone", "inscribed stone"), themes=("living",),
          roles=("flat",), colors=("tan",))  # fmt: skip
def clay_tablet(look: Look) -> Shape:
    """A clay tablet with rows of wedge-shaped characters."""
    color = look.color("tan", "terracotta", "brown", "gray", "charcoal", spread=14)
    x, y = look.between(0.08, 0.11), look.between(0.11, 0.14)
    made = pad(x, y, 0.02, 0.012, soft=0.6)
    image = surfaces.speckles(look.rng, color, 8, 128).copy()
    ink = tint_color(color, 0.5)
    for row in range(9):
        for n in range(9):
            a, b = 0.1 + 0.09 * n + look.between(-0.02, 0.02), 0.12 + 0.09 * row
            tip = (a + look.between(0.0, 0.05), b + look.between(0.02, 0.06))
            prints.polygon(image, [(a, b), (a + 0.03, b + 0.01), tip], ink)
    sheet = at_box(0.82 * x, 0.82 * y, 0.0008, (0, 0, 0.0196))
    return put_down([(made, surfaces.speckles(look.rng, color, 8)), (sheet, image)], made)


@category("pottery_shard", size=(0.0902, 0.0689, 0.00771), mass=0.03, material="ceramic",
          aliases=("potsherd", "pot sherd", "sherd", "shard", "pot shard", "ceramic shard",
          "shard of pottery", "broken pottery"), themes=("living",), roles=("flat",),
          colors=("terracotta",))  # fmt: skip
def pottery_shard(look: Look) -> Shape:
    """A broken, slightly curved piece of a painted pot, lying flat."""
    color = look.color("terracotta", "tan", "cream", "brown", "white")
    n, k = 9, look.between(0.75, 1.3)
    a = 2 * np.pi * (np.arange(n) + 0.35 * look.rng.uniform(-1, 1, n)) / n
    r = 0.034 * look.rng.uniform(0.72, 1.2, n)
    rim = np.column_stack([1.25 * r * np.cos(a), r * np.sin(a)])
    body = plate(rim, 0.0065)
    image = surfaces.speckles(look.rng, color, 8, 96).copy()
    ink = look.own_color("black", "brown", "navy", "crimson")
    for row in (0.2, 0.62):
        prints.fill(image, 0, row, 1, 0.06, ink)
    prints.stroke(image, [(0.1 * i, 0.36 + 0.12 * (i % 2)) for i in range(11)], 0.05, ink)
    skin = plate(0.97 * rim, 0.0008, at=(0, 0, 0.0062))
    return put_down([(body, plain(tint_color(color, 0.75))), (skin, image)], body, factor=k)


@category("fossil", size=(0.0823, 0.0726, 0.0174), mass=0.15, material="stone",
          aliases=("ammonite fossil", "fossil shell"), themes=("living",),
          colors=("tan", "gray"))  # fmt: skip
def fossil(look: Look) -> Shape:
    """An ammonite: a ribbed spiral on a slice of rock."""
    color = look.color("tan", "gray", "brown", "charcoal", "cream")
    k = look.between(0.75, 1.25)
    t = np.linspace(0, 5 * np.pi, 110)
    r = 0.003 + 0.029 * (t / t[-1]) ** 1.3
    path = np.column_stack([r * np.cos(t), r * np.sin(t), 0.013 + 0 * t])
    shell = tube(path, (0.0012 + 0.0056 * r / 0.032) * (1 + 0.16 * np.cos(14 * t)), 7)
    base = plate(rectangle(0.085, 0.075, 0.03, 3) * 1.0, 0.012, bevel=0.003)
    stone = surfaces.spots(look.rng, tint_color(color, 0.6), tint_color(color, 0.4), 0.2)
    return put_down([(base, stone), (shell, surfaces.speckles(look.rng, color, 10))],
                    base, shell, factor=k)  # fmt: skip


@category("pebble", size=(0.047, 0.037, 0.02), mass=0.05, material="stone", aliases=("stone",
          "small stone", "smooth stone", "river stone", "zen stone", "flat stone"),
          themes=("living",), colors=("gray", "beige"))  # fmt: skip
def pebble(look: Look) -> Shape:
    """A smooth pebble, sometimes with a vein."""
    color = look.color("gray", "charcoal", "beige", "white", "brown", "tan", "terracotta")
    x, y, h = look.between(0.035, 0.06), look.between(0.03, 0.045), look.between(0.016, 0.028)
    bumps = look.rng.uniform(0, 6.28, 3)

    def warp(p: np.ndarray) -> np.ndarray:
        a = np.arctan2(p[:, 1], p[:, 0])
        f = 1 + 0.06 * np.sin(2 * a + bumps[0]) + 0.03 * np.sin(3 * a + bumps[1])
        return p * np.column_stack([f, f, np.ones(len(p))])

    body = ellipsoid(x, y, h, 20, 12).bend(warp).move(z=0.42 * h)
    skin = (surfaces.marble(look.rng, color, tint_color(color, 1.7)) if look.chance(0.35)
            else surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.12))  # fmt: skip
    return shape([(body, skin)], [flat_foot(above(body.vertices), 0.03)])


@category("rock", size=(0.088, 0.068, 0.05), mass=0.4, material="stone",
          aliases=("big stone", "boulder", "rough stone", "piece of rock"), themes=("living",),
          colors=("gray",))  # fmt: skip
def rock(look: Look) -> Shape:
    """A rough, broken stone with sharp edges."""
    color = look.color("gray", "charcoal", "brown", "tan", "terracotta", "beige")
    x, y, h = look.between(0.07, 0.11), look.between(0.06, 0.08), look.between(0.045, 0.07)
    rough = look.rng.uniform(0.78, 1.12, (6, 9))

    def chip(p: np.ndarray) -> np.ndarray:
        a = np.arctan2(p[:, 1] / y, p[:, 0] / x)
        row = np.clip(((p[:, 2] / h + 0.5) * 5).round().astype(int), 0, 5)
        column = ((a + np.pi) / (2 * np.pi) * 9).round().astype(int) % 9
        away = np.hypot(p[:, 0], p[:, 1]) > 1e-6
        f = np.where(away, rough[row, column], 1.0)
        return p * np.column_stack([f, f, np.ones(len(p))])

    body = ellipsoid(x, y, h, 9, 5).bend(chip).move(z=0.38 * h)
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    return shape([(body, skin)], [flat_foot(above(body.vertices), 0.03)])


@category("crystal", size=(0.0756, 0.08, 0.106), mass=0.3, material="stone",
          aliases=("crystal cluster", "amethyst", "quartz", "healing crystal", "rose quartz",
          "smoky quartz", "calcite", "amethyst cluster", "selenite wand"), themes=("living",),
          colors=("purple", "pink"))  # fmt: skip
def crystal(look: Look) -> Shape:
    """A cluster of six-sided crystals on a rough base."""
    color = look.color("purple", "lavender", "pink", "white", "teal", "blue", "green")
    k = look.between(0.8, 1.2)
    points: list[Solid] = []
    for n in range(8):
        tall = look.between(0.04, 0.085) if n else 0.1
        r = 0.19 * tall * look.between(0.8, 1.1)
        one = lathe([(0, 0), (r, 0), (0.95 * r, 0.72 * tall), (0, tall)], 6)
        lean = 0.0 if n == 0 else look.between(0.25, 0.6)
        points.append(one.turn(1, lean).turn(2, 2.4 * n).move(0.012 * np.cos(2.4 * n) * (n > 0),
                                                              0.012 * np.sin(2.4 * n) * (n > 0),
                                                              0.008))  # fmt: skip
    foot = ball(0.075, 0.068, 0.036, (0, 0, 0.012), 9)
    return put_down([(join(points), surfaces.gradient(tint_color(color, 0.8),
                                                      tint_color(color, 1.5), look.rng)),
                     (foot, surfaces.spots(look.rng, (120, 112, 106), (90, 84, 80), 0.2))], foot,
                    join(points), factor=k)  # fmt: skip
