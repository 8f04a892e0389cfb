"""Objects of the ``kitchen`` theme: citrus fruit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.parts import hull_of, resting_ball
from ...kit.primitives import press_flat
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe
from ...kit.surfaces import RGB, Look, tint_color
from .fruit import Globe, _wedge, globe
from .nuts import Heap, heap


def _citrus(look: Look, size: tuple[float, float, float], color: RGB) -> Shape:
    x, y, z = size
    body = press_flat(ellipsoid(x, y, z, 26, 14), 0.46 * z)
    peel = surfaces.spots(look.rng, color, tint_color(color, 0.86), 0.12)
    nub = cylinder(0.0035, 0.002, 8).move(z=0.955 * z)
    green = surfaces.plain((94, 110, 58))
    return shape([(body, peel), (nub, green)], [resting_ball(x, y, 0.96 * z)])


@category("orange", size=(0.075, 0.075, 0.07), mass=0.2, material="food",
          aliases=("mandarin", "tangerine", "clementine", "satsuma"), themes=("kitchen", "dining"),
          roles=("round", "edible"), colors=("orange",), common=True)  # fmt: skip
def orange(look: Look) -> Shape:
    """An orange."""
    d = look.between(0.07, 0.08)
    return _citrus(look, (d, d, 0.97 * d), look.color("orange", "amber", "orange"))


@category("lemon", size=(0.085, 0.057, 0.055), mass=0.11, material="food", themes=("kitchen",),
          roles=("round", "edible"), colors=("yellow",), common=True)  # fmt: skip
def lemon(look: Look) -> Shape:
    """A lemon lying flat, pointed at both ends."""
    x, d = look.between(0.078, 0.09), look.between(0.054, 0.06)
    color = look.color("yellow")
    a = np.linspace(-np.pi / 2, np.pi / 2, 15)
    point = 0.16 * np.exp(-(((np.abs(a) - np.pi / 2) / 0.3) ** 2)) * np.sign(a)
    profile = np.column_stack([d / 2 * np.cos(a), (x / 2.3) * (np.sin(a) + point)])
    profile[[0, -1], 0] = 0
    body = press_flat(lathe(profile, 22).turn(1, np.pi / 2), 0.46 * d)
    peel = surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.12)
    return shape([(body, peel)], [resting_ball(float(np.ptp(body.vertices[:, 0])), d, 0.95 * d)])


def _half(
    d: tuple[float, float], flesh: RGB, palette: tuple[str, ...], count: int
) -> Callable[[Look], Shape]:
    """Return the shape function of a halved citrus fruit with its cut face up."""

    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*palette)
        tall = look.between(0.5, 0.62)
        half = lathe([(0, 0), (0.2, 0), (0.42, 0.12), (0.5, 0.36), (0.5, tall), (0, tall)], 30)
        half = half.scale(size, size * look.between(0.94, 1), size)
        face = cylinder(0.49 * size, 0.001, 30).move(z=tall * size - 0.0004)
        face = face.scale(1, float(np.ptp(half.vertices[:, 1])) / size, 1)
        peel = surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.12)
        return shape([(half, peel), (face, wheel(flesh, (250, 246, 222), count))], [hull_of(half)])

    return make


def wheel(color: RGB, pith: RGB, count: int = 9) -> surfaces.Tile:
    """Return the cut face of a citrus fruit with segments like spokes."""
    y, x = np.mgrid[0:128, 0:128] / 127 * 2 - 1
    away, turn = np.hypot(x, y), np.arctan2(y, x)
    gap = np.abs(np.sin(count * turn / 2)) * away < 0.07
    image = np.where((gap | (away < 0.1) | (away > 0.84))[..., None], np.array(pith),
                     np.array(color) * (0.92 + 0.12 * np.sin(40 * away)[..., None]))  # fmt: skip
    image = np.where((away > 0.95)[..., None], np.array(tint_color(color, 0.9)), image)
    return np.clip(image, 0, 255).astype(np.uint8)


def _lime_citrus(look: Look, d: tuple[float, float], flesh: RGB, palette: tuple[str, ...],
            nub: float) -> Shape:  # fmt: skip
    """Return a citrus fruit, whole or halved with its cut face up."""
    size, color = look.between(*d), look.color(*palette)
    peel = surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.12)
    if look.chance(0.3):
        half = lathe([(0, 0), (0.2, 0), (0.42, 0.12), (0.5, 0.36), (0.5, 0.5), (0, 0.5)], 30)
        half = half.scale(size, size, size)
        face = cylinder(0.49 * size, 0.001, 30).move(z=0.5 * size - 0.0004)
        return shape([(half, peel), (face, wheel(flesh, (246, 240, 214)))], [hull_of(half)])
    body = ellipsoid((1 + nub) * size, size, 0.97 * size, 26, 16)
    pieces = [(body, peel)]
    if nub > 0.05:
        tips = [ellipsoid(0.28 * size, 0.26 * size, 0.26 * size, 12, 8).move(
            s * 0.5 * (0.95 + nub) * size) for s in (-1, 1)]  # fmt: skip
        pieces.append((join(tips), peel))
    else:
        pieces.append((cylinder(0.07 * size, 0.02 * size, 10).move(z=0.47 * size),
                       surfaces.plain((120, 140, 70))))  # fmt: skip
    return settle(pieces, 0.07)


@category("lime", size=(0.066, 0.0489, 0.0441), mass=0.065, material="food", aliases=("half lime",),
          themes=("kitchen", "food"), roles=("round", "edible"), colors=("lime",))  # fmt: skip
def lime(look: Look) -> Shape:
    """A lime, whole or halved."""
    return _lime_citrus(look, (0.046, 0.053), (190, 214, 110), ("lime", "green", "lime"), 0.12)


@category("grapefruit", size=(0.105, 0.105, 0.0849), mass=0.35, material="food", assembled=True,
          aliases=("pomelo", "half grapefruit"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("amber",))  # fmt: skip
def grapefruit(look: Look) -> Shape:
    """A grapefruit, whole or halved with pink flesh."""
    return _lime_citrus(look, (0.098, 0.115), (236, 110, 96), ("amber", "coral", "yellow"), 0.0)


def _slice(look: Look, d: float, flesh: RGB, rind: RGB) -> Shape:
    t = look.between(0.004, 0.006)
    disc = cylinder(d / 2, t, 32, bevel=0.0005)
    face = cylinder(0.98 * d / 2, 0.0006, 32).move(z=t - 0.0003)
    return shape([(disc, surfaces.plain(rind)), (face, wheel(flesh, (250, 244, 214)))],
                 [hull_of(disc, face)])  # fmt: skip


@category("lemon_slice", size=(0.0586, 0.0586, 0.00511), mass=0.012, material="food",
          aliases=("slice of lemon", "lime slice", "orange slice", "slice of orange",
          "slice of lime", "lime wedge", "lemon wedge"), themes=("kitchen", "food"),
          roles=("edible", "flat", "round"), colors=("yellow",), state="lying flat")  # fmt: skip
def lemon_slice(look: Look) -> Shape:
    """A round slice of citrus fruit, lying flat."""
    color = look.color("yellow", "yellow", "lime", "orange")
    return _slice(look, look.between(0.05, 0.066), tint_color(color, 1.25), color)


CATEGORIES = (
    Category("orange_segment", _wedge((0.055, 0.07), 0.34, (248, 166, 60), ("orange", "amber")),
             size=(0.0322, 0.0642, 0.0197), mass=0.015, material="food",
             aliases=("segment of orange", "satsuma segment", "tangerine segment", "orange wedge",
             "grapefruit segment"), themes=("kitchen", "food"), roles=("edible",),
             colors=("orange",), state="lying on its side"),
    Category("kumquat", globe(Globe((0.022, 0.027), 1.4, ("orange", "orange", "amber"), "spots",
             top="leaf", lying=True)), size=(0.0306, 0.0339, 0.0243), mass=0.015, material="food",
             themes=("kitchen", "food"), roles=("edible",), colors=("orange",)),
    Category("lemon_half", _half((0.052, 0.062), (250, 228, 110), ("yellow", "yellow", "gold"), 9),
             size=(0.0576, 0.0567, 0.0335), mass=0.05, material="food", aliases=("half lemon",
             "half a lemon", "half of a lemon", "halved lemon", "cut lemon", "lemon cut in half"),
             themes=("kitchen", "food"), roles=("edible", "round"), colors=("yellow",)),
    Category("orange_half", _half((0.07, 0.082), (246, 160, 50), ("orange", "orange", "amber"), 10),
             size=(0.0789, 0.0763, 0.0459), mass=0.09, material="food", aliases=("half orange",
             "half an orange", "half of an orange", "halved orange", "cut orange"),
             themes=("kitchen", "food"), roles=("edible", "round"), colors=("orange",)),
    Category("lemon_zest",
             heap(Heap((0.018, 0.026), 0.006, "strand", ("yellow", "gold", "yellow"))),
             size=(0.0542, 0.0547, 0.0166), mass=0.005, material="food", aliases=("orange zest",
             "lime zest", "citrus zest", "grated lemon zest", "heap of lemon zest",
             "pile of lemon zest", "mound of lemon zest", "lemon zest heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("yellow",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
