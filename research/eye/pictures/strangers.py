"""Objects without a category: random lathe profiles, extrusions, and joined boxes."""

from __future__ import annotations

import numpy as np

from generator.scene import Model
from tabletop_objects.kit import surfaces
from tabletop_objects.kit.outlines import ellipse, smooth
from tabletop_objects.kit.shapes import Shape, mesh_of, shape
from tabletop_objects.kit.solids import Solid, block, cylinder, ellipsoid, lathe, prism
from tabletop_objects.values import to_unit_box

from . import patterns


def stranger(seed: int) -> Model:
    """Return a random solid object of 3 to 35 cm with any texture; it has no collision parts."""
    rng = np.random.default_rng([seed, 41])
    kinds = (_lathe, _lathe, _extrusion, _composite, _composite, _pebble)
    solids = kinds[int(rng.integers(len(kinds)))](rng)
    tiles = [_tile(rng) for _ in range(int(rng.integers(1, 4)))]
    pieces = [(solid, tiles[k % len(tiles)]) for k, solid in enumerate(solids)]
    made: Shape = shape(pieces, ())
    unit, _, extent = to_unit_box(mesh_of(made))
    size = extent / extent.max() * np.exp(rng.uniform(np.log(0.03), np.log(0.35)))
    return Model("thing", "thing", unit, np.maximum(size, 0.004))


def _tile(rng: np.random.Generator) -> surfaces.Tile:
    kind = int(rng.integers(7))
    color = patterns.any_color(rng)
    if kind <= 2:
        return surfaces.speckles(rng, color, float(rng.uniform(0, 8)))
    if kind == 3:
        return surfaces.brushed_metal(rng, color)
    if kind == 4:
        return patterns.cloth(rng)
    return patterns.clutter(rng, 128, 24) if kind == 5 else surfaces.wood(rng, color)


def _lathe(rng: np.random.Generator) -> list[Solid]:
    count = int(rng.integers(3, 7))
    heights = np.linspace(0, rng.uniform(0.3, 3), count)
    radii = rng.uniform(0.12, 0.6, count)
    curve = np.column_stack([radii, heights])
    if rng.random() < 0.6:
        curve = smooth(curve, 5)
    curve[:, 0] = np.maximum(curve[:, 0], 0.03)
    if rng.random() < 0.4:  # hollow
        inner = np.column_stack([np.maximum(curve[::-1, 0] - 0.04, 0.02), curve[::-1, 1]])
        floor = 0.06 * heights[-1]
        inner = inner[inner[:, 1] > floor]
        tail = [[0, floor]]
        profile = np.concatenate([[[0, 0]], curve, inner, tail])
    else:
        profile = np.concatenate([[[0, 0]], curve, [[0, heights[-1]]]])
    return [lathe(profile, 24)]


def _extrusion(rng: np.random.Generator) -> list[Solid]:
    count = int(rng.integers(3, 16))
    radii = rng.uniform(0.45, 1, count) if rng.random() < 0.7 else np.ones(count)
    outline = ellipse(2, 2, count) * radii[:, None] * [1, rng.uniform(0.3, 1)]
    solid = prism(outline, 0, float(np.exp(rng.uniform(np.log(0.05), np.log(2)))))
    return [solid.turn(0, np.pi / 2)] if rng.random() < 0.3 else [solid]


def _composite(rng: np.random.Generator) -> list[Solid]:
    first = rng.uniform(0.3, 1, 3)
    solids = [block(*first, radius=0.1 * float(rng.random()))]
    for _ in range(int(rng.integers(1, 5))):
        x, y, z = rng.uniform(0.15, 0.8, 3)
        part = block(x, y, z, 0.02) if rng.random() < 0.6 else cylinder(x / 2, z, 16)
        at = (rng.uniform(-0.5, 0.5, 3) * first) + [0, 0, 0.3 * first[2]]
        solids.append(part.move(at[0], at[1], max(0.0, at[2])))
    return solids


def _pebble(rng: np.random.Generator) -> list[Solid]:
    x, y, z = rng.uniform(0.4, 1, 3)
    return [ellipsoid(x, y, z, 20, 10).move(z=z / 2)]
