"""Objects of the ``kitchen`` theme: fruit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.parts import (
    above,
    cylinder_part,
    flat_foot,
    hull_of,
    hull_part,
    resting_ball,
    ring_parts,
)
from ...kit.primitives import bent_rod, blade, lobe, press_flat
from ...kit.shapes import Category, Shape, category, settle, shape, vary
from ...kit.solids import Solid, cylinder, ellipsoid, join, lathe, loft, prism, sweep, tube
from ...kit.surfaces import RGB, Look, Tile, streaks, tint_color


@category("apple", size=(0.075, 0.075, 0.075), mass=0.2, material="food",
          themes=("kitchen", "dining", "office"), roles=("round", "edible"),
          colors=("red", "green"), common=True)  # fmt: skip
def apple(look: Look) -> Shape:
    """An apple with a stem."""
    d = look.between(0.07, 0.08)
    base = look.color("red", "red", "green", "lime", "crimson", "yellow", "maroon")
    tall = look.between(0.9, 1.08)
    blush = look.own_color("red", "amber", "lime", "crimson")
    a = np.linspace(-np.pi / 2, np.pi / 2, 13)
    r = d / 2 * np.cos(a) * (1 + 0.06 * np.sin(a))
    z = 0.44 * tall * d * np.sin(a) - 0.09 * d * np.exp(-((r / (0.22 * d)) ** 2)) * np.sign(
        np.sin(a)
    )
    r[[0, -1]] = 0
    body = press_flat(lathe(np.column_stack([r, z]), 26), 0.41 * tall * d)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    top = float(body.vertices[:, 2].max())
    stem = tube([(0, 0, 0.72 * top), (0.002, 0, 0.95 * top), (0.006, 0, 1.12 * top)], 0.0016, 6)
    brown = surfaces.plain((92, 66, 40))
    return shape([(body, skin(look, base, blush)), (stem, brown)], [resting_ball(d, d, 0.97 * top)])


@category("pear", size=(0.07, 0.07, 0.11), mass=0.19, material="food", themes=("kitchen", "dining"),
          roles=("round", "edible"), colors=("lime", "yellow"), common=True)  # fmt: skip
def pear(look: Look) -> Shape:
    """A pear, standing upright."""
    r, h = look.between(0.032, 0.037), look.between(0.088, 0.1)
    base = look.color("lime", "yellow", "olive", "amber")
    body = lathe(
        [(0, 0.004), (0.35 * r, 0.0), (0.6 * r, 0.002), (0.95 * r, 0.16 * h), (r, 0.3 * h),
         (0.88 * r, 0.46 * h), (0.58 * r, 0.64 * h), (0.45 * r, 0.82 * h), (0.3 * r, 0.95 * h),
         (0, h)],
        24,
    )  # fmt: skip
    stem = tube([(0, 0, 0.92 * h), (0.003, 0, 1.06 * h), (0.008, 0, 1.16 * h)], 0.0017, 6)
    return shape(
        [(body, skin(look, base, look.own_color("yellow", "olive", "terracotta"), 0.7)),
         (stem, surfaces.plain((92, 66, 40)))],
        [hull_of(body)],
    )  # fmt: skip


@category("banana", size=(0.18, 0.07, 0.035), mass=0.107, material="food",
          themes=("kitchen", "dining"), roles=("edible",), colors=("yellow",), state="lying flat",
          common=True)  # fmt: skip
def banana(look: Look) -> Shape:
    """A curved banana, lying on its side."""
    bow, r = look.between(0.085, 0.1), look.between(0.016, 0.018)
    color = look.color("yellow")
    angles = np.linspace(np.deg2rad(205), np.deg2rad(335), 13)
    path = np.column_stack(
        [bow * np.cos(angles), bow * np.sin(angles) + 0.8 * bow, np.full(13, 0.93 * r)]
    )
    radii = r * np.array([0.32, 0.36, 0.72, 0.9, 0.98, 1, 1, 1, 0.97, 0.88, 0.68, 0.4, 0.28])
    image = surfaces.speckles(look.rng, color, 5, 96).copy()
    for _ in range(26):
        i, j = look.rng.integers(0, 92, 2)
        image[i : i + 3, j : j + 2] = np.array(tint_color(color, 0.5), np.uint8)
    image[:7], image[-7:] = (86, 66, 38), (96, 84, 40)
    body = tube(path, radii, 8, squash=0.93)
    pieces = [flat_foot(np.concatenate([_slice(body, k) for k in range(a, b + 1)]))
              for a, b in ((1, 4), (4, 8), (8, 11))]  # fmt: skip
    return shape([(body, image)], pieces)


def _slice(body: Solid, ring: int) -> np.ndarray:
    """Return the vertices of a banana that lie near its cross-section ``ring`` (0 to 12)."""
    p = body.vertices
    center = p[:, :2].mean(0) + np.array([0, 0.1])
    away = np.arctan2(*(p[:, :2] - center).T[::-1])
    order = np.quantile(away, [max(0.0, (ring - 0.5) / 12), min(1.0, (ring + 0.5) / 12)])
    return p[(away >= order[0] - 1e-6) & (away <= order[1] + 1e-6)]


def _diamonds(look: Look, color: RGB) -> Tile:
    """Return a texture of pineapple skin: slanted rows of spots between dark seams."""
    y, x = np.mgrid[0:128, 0:128] / 128
    a, b = (8 * x + 7 * y) % 1 - 0.5, (8 * x - 7 * y) % 1 - 0.5
    eye = np.exp(-(a**2 + b**2) / 0.012)
    seam = np.maximum(np.abs(a), np.abs(b)) > 0.4
    shade = 1.08 - 0.5 * eye - 0.45 * seam + 0.1 * surfaces.noise(look.rng, 128, 128, (4, 4), 2)
    return np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)


@category("pineapple", size=(0.13, 0.13, 0.245), mass=1.1, material="food", aliases=("ananas",),
          themes=("kitchen", "food"), roles=("tall", "round", "edible"), colors=("amber",),
          common=True)  # fmt: skip
def pineapple(look: Look) -> Shape:
    """A pineapple with a crown of stiff leaves, standing upright."""
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
    green = surfaces.leaf(look.rng, look.own_color("sage", "green", "olive"))
    low = hull_of(body)
    return shape([(body, _diamonds(look, color)), (join(crown), green)],
                 [low, cylinder_part(0.45 * r, 0.9 * long, (0, 0, 0.94 * h))])  # fmt: skip


@category("grapes", size=(0.14, 0.09, 0.05), mass=0.3, material="food",
          aliases=("bunch of grapes", "grape"), themes=("kitchen", "food", "dining"),
          roles=("edible",), colors=("purple", "lime"), state="lying flat",
          common=True)  # fmt: skip
def grapes(look: Look) -> Shape:
    """A bunch of grapes with its stalk, lying flat."""
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
                balls.append(ellipsoid(1.06 * d, d, d, 11, 7).move(*(np.array([x, y, z]) + jitter)))
    end = 2.6 * d
    stalk = tube(smooth([(-d, 0, d), (end, 0, 1.3 * d), (end + 1.4 * d, 0.4 * d, 1.5 * d)], 3),
                 0.0024, 6)  # fmt: skip
    fruit = join(balls)
    bloom = skin(look, color, tint_color(color, 1.35), 0.8)
    return shape([(fruit, bloom), (stalk, surfaces.plain((108, 96, 56)))],
                 [flat_foot(fruit.vertices)])  # fmt: skip


def _crease(solid: Solid, deep: float) -> Solid:
    """Return the round fruit ``solid`` with a furrow from stalk to tip on the viewer's side."""

    def furrow(p: np.ndarray) -> np.ndarray:
        turn = np.arctan2(p[:, 1], p[:, 0]) + np.pi / 2 + 0.35
        factor = 1 - deep * np.exp(-((np.angle(np.exp(1j * turn)) / 0.3) ** 2))
        return p * np.column_stack([factor, factor, np.ones(len(p))])

    return solid.bend(furrow)


def _fruit(d: float, tall: float, dip: float = 0.12) -> Solid:
    """Return a round fruit of diameter ``d`` and height ``tall``, dented at its stalk."""
    t = np.linspace(-np.pi / 2, np.pi / 2, 17)
    r, z = 0.5 * d * np.cos(t), 0.5 * tall * (1 + np.sin(t))
    z = z - dip * tall * np.exp(-((r / (0.16 * d)) ** 2)) * (np.sin(t) > 0)
    r[[0, -1]] = 0
    return lathe(np.column_stack([r, z]), 28).move(z=-0.02 * tall)


def _furrow(skin: surfaces.Tile) -> surfaces.Tile:
    """Return a copy of a fruit's texture with a darker line where its furrow is."""
    made = skin.copy()
    wide = made.shape[1]
    at = int(0.444 * wide)
    made[:, at - 1 : at + 2] = (made[:, at - 1 : at + 2] * 0.85).astype(np.uint8)
    return made


@category("peach", size=(0.0758, 0.0683, 0.0671), mass=0.15, material="food",
          aliases=("nectarine", "apricot", "plastic peach"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("coral",))  # fmt: skip
def peach(look: Look) -> Shape:
    """A peach, nectarine or apricot with a furrow, a stalk and sometimes a leaf."""
    d = look.between(0.058, 0.078)
    color = look.color("coral", "orange", "golden", "coral", "amber")
    blush = look.pick([(206, 60, 60), (220, 90, 70), (186, 40, 60)])
    skin = _furrow(surfaces.gradient(color, blush, look.rng, 9))
    body = _crease(_fruit(d, 0.94 * d), 0.15).bend(above)
    stalk = tube([(0, 0, 0.76 * d), (0.002, 0, 0.9 * d)], 0.002, 7)
    pieces = [(body, skin), (stalk, surfaces.plain((96, 70, 44)))]
    if look.chance(0.5):
        leaf = blade([(0, 0, 0.86 * d), (0.02, 0.005, 0.96 * d), (0.045, 0.01, 0.9 * d)], 0.022)
        pieces.append((leaf, surfaces.leaf(look.rng, look.own_color("green", "green", "olive"))))
    return shape(pieces, [resting_ball(0.97 * d, 0.95 * d, 0.9 * d)])


@category("plum", size=(0.048, 0.047, 0.055), mass=0.07, material="food", aliases=("damson",),
          themes=("kitchen", "food"), roles=("round", "edible"), colors=("purple",))  # fmt: skip
def plum(look: Look) -> Shape:
    """A purple, red or yellow plum with a bloom on its skin."""
    d = look.between(0.042, 0.055)
    color = look.color("purple", "indigo", "maroon", "crimson", "mustard")
    skin = _furrow(
        surfaces.gradient(tint_color(color, 0.75), tint_color(color, 1.15), look.rng, 10)
    )
    body = _crease(_fruit(d, look.between(1.0, 1.15) * d, 0.08), 0.14).bend(above)
    stalk = tube([(0, 0, 0.9 * d), (0.004, 0, 1.14 * d)], 0.0013, 6)
    return shape([(body, skin), (stalk, surfaces.plain((110, 96, 50)))],
                 [resting_ball(0.96 * d, 0.94 * d, float(body.bounds[1, 2]))])  # fmt: skip


@category("mango", size=(0.118, 0.07, 0.07), mass=0.3, material="food", themes=("kitchen", "food"),
          roles=("edible",), colors=("golden",), state="lying flat")  # fmt: skip
def mango(look: Look) -> Shape:
    """A kidney-shaped green, yellow and red mango, lying on its side."""
    k = look.between(0.9, 1.12)
    color = look.color("golden", "yellow", "green", "orange", "olive")
    skin = surfaces.gradient(color, look.pick([(200, 70, 50), (220, 110, 50), (110, 140, 60)]),
                             look.rng, 10)  # fmt: skip
    t = np.linspace(-1, 1, 15)
    path = np.column_stack([0.055 * k * t, 0.012 * k * t**2, 0.035 * k + 0 * t])
    wide = 0.034 * k * np.sqrt(np.clip(1 - t**2, 0.0, 1)) * (1.04 - 0.16 * t)
    body = tube(path, np.maximum(wide, 0.002), 20, squash=0.98).bend(above)
    stalk = tube([(-0.054 * k, 0.012 * k, 0.035 * k), (-0.061 * k, 0.014 * k, 0.038 * k)], 0.003, 7)
    return shape([(body, skin), (stalk, surfaces.plain((96, 74, 46)))],
                 [flat_foot(body.vertices, 0.1)])  # fmt: skip


@category("kiwi", size=(0.0536, 0.0471, 0.0311), mass=0.06, material="food", assembled=True,
          aliases=("kiwi fruit", "kiwifruit", "kiwi half"), themes=("kitchen", "food"),
          roles=("edible",), colors=("brown",), state="lying flat")  # fmt: skip
def kiwi(look: Look) -> Shape:
    """A whole, furry kiwi fruit, or half of one with green flesh and seeds."""
    k = look.between(0.9, 1.1)
    brown = look.color("brown", "bronze", "olive")
    fur = surfaces.scratches(look.rng, brown, tint_color(brown, 1.25), 260)
    if look.chance(0.2):
        body = ellipsoid(0.062 * k, 0.046 * k, 0.044 * k, 24, 14).move(z=0.021 * k).bend(above)
        end = cylinder(0.004, 0.004, 10).turn(1, np.pi / 2).move(x=0.029 * k, z=0.021 * k)
        return shape([(body, fur), (end, surfaces.plain((70, 50, 34)))],
                     [resting_ball(0.06 * k, 0.045 * k, 0.042 * k)])  # fmt: skip
    r = 0.024 * k
    cup = lathe([(0, 0), (0.5 * r, 0), (0.85 * r, 0.3 * r), (r, 0.9 * r), (0.97 * r, 0.98 * r),
                 (0, 0.98 * r)], 26)  # fmt: skip
    v, u = np.mgrid[0:96, 0:96] / 96 - 0.5 + 0.5 / 96
    away, turn = np.hypot(u, v), np.arctan2(v, u)
    flesh = np.empty((96, 96, 3))
    flesh[:] = (132, 176, 54)
    flesh[away < 0.4] = (150, 194, 66)
    rays = (away < 0.4) & (away > 0.14) & (np.sin(26 * turn) > 0.55)
    flesh[rays] = (178, 212, 104)
    flesh[(away < 0.26) & (away > 0.17) & (np.sin(30 * turn) > 0.5)] = (34, 30, 24)
    flesh[away < 0.12] = (226, 232, 176)
    face = cylinder(0.96 * r, 0.001, 28).move(z=0.98 * r - 0.0004)
    return shape([(cup, fur), (face, flesh.astype(np.uint8))], [hull_of(cup)])


@category("cherries", size=(0.0686, 0.071, 0.0399), mass=0.02, material="food", assembled=True,
          aliases=("cherry", "pair of cherries", "bunch of cherries"), themes=("kitchen", "food"),
          roles=("edible",), colors=("crimson",), state="lying flat")  # fmt: skip
def cherries(look: Look) -> Shape:
    """Two or three cherries with joined stalks."""
    d = look.between(0.021, 0.025)
    color = look.color("crimson", "red", "maroon", "crimson", "golden")
    skin = surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.1), look.rng, 6)
    count = look.pick([2, 2, 3])
    fruits, stalks, parts = [], [], []
    knot = np.array([0.004, 0.03, 0.036])
    for k in range(count):
        x, y = (k - (count - 1) / 2) * 1.25 * d, -0.006 * (k % 2) - 0.01
        fruit = _fruit(d, 0.93 * d, 0.14).bend(above).move(x, y)
        fruits.append(fruit)
        top = np.array([x, y, 0.76 * d])
        stalks.append(
            tube(smooth([top, top + np.array([0.001, 0.004, 0.014]), knot], 4), 0.0009, 5)
        )
        ball = resting_ball(0.97 * d, 0.97 * d, 0.86 * d)
        parts.append(type(ball)(ball.vertices + np.array([x, y, 0])))
    leaf = blade([knot, knot + np.array([0.02, 0.012, 0.003]), knot
                  + np.array([0.045, 0.016, -0.008])], 0.022)  # fmt: skip
    pieces = [(join(fruits), skin), (join(stalks), surfaces.plain((104, 120, 52)))]
    if look.chance(0.6):
        pieces.append((leaf, surfaces.leaf(look.rng, (76, 134, 62))))
    return shape(pieces, parts)


def _ring(
    r: tuple[float, float], core: float, thick: float, palette: tuple[str, ...], rim: float
) -> Callable[[Look], Shape]:
    """Return the shape function of a ring cut from a fruit such as a pineapple."""

    def make(look: Look) -> Shape:
        size, color = look.between(*r), look.color(*palette)
        t = thick * look.between(0.85, 1.2)
        profile = [(core * size, 0), (size, 0), (size, t), (core * size, t)]
        body = lathe(profile, 30, v=[0, 0.3, 0.6, 0.95], loop=True)
        y, x = np.mgrid[0:64, 0:128]
        lines = 0.9 + 0.1 * np.sin(x * 2 * np.pi * 24 / 128)[..., None]
        tile = np.array(color) * lines * np.where((y < 34)[..., None], 1.0, rim)
        wall = ring_parts([(size, 0), (size, t)], [(core * size, t), (core * size, 0)], 12)
        return shape([(body, np.clip(tile, 0, 255).astype(np.uint8))], wall)

    return make


def _wedge(
    d: tuple[float, float], span: float, flesh: RGB, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a segment or slice of a round fruit, lying on its side."""

    def make(look: Look) -> Shape:
        r, color = look.between(*d) / 2, look.color(*palette)
        inner = surfaces.speckles(look.rng, flesh, 10)
        half = span * look.between(0.85, 1.15)
        t = np.linspace(-np.pi / 2, np.pi / 2, 13)
        rings = []
        for a in t:
            out = r * np.cos(a)
            rim = [(out * np.cos(b), out * np.sin(b)) for b in np.linspace(-half, half, 6)]
            rings.append([(x, r * np.sin(a) * 1.02, z) for x, z in ((0.0, 0.0), *rim)])
        points = np.array(rings)
        points[[0, -1]] = points[[0, -1]].mean(1, keepdims=True) + 1e-5 * (
            points[[0, -1]] - points[[0, -1]].mean(1, keepdims=True))  # fmt: skip
        flat = np.array(
            [(0.0, 0.0), *[(np.cos(b), np.sin(b)) for b in np.linspace(-half, half, 6)]]
        )
        body = loft(points, flat)
        body = body.turn(1, -half).move(x=-0.5 * r)
        low = float(body.bounds[0, 2])
        body = body.move(z=-low)
        skin_ = _crescent(r, half).turn(1, -half).move(x=-0.5 * r, z=-low)
        peel = surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.1)
        return shape([(body, inner), (skin_, peel)], [hull_part(above(body.vertices))])

    return make


def _crescent(r: float, half: float) -> Solid:
    """Return the peel of a fruit segment of radius ``r`` and half angle ``half``."""
    rings = []
    for a in np.linspace(-1.5, 1.5, 13):
        rim = [(r * k * np.cos(a) * np.cos(b), r * k * np.cos(a) * np.sin(b))
               for k, way in ((0.985, 1), (1.03, -1)) for b in np.linspace(-half, half,
                   6)[::-way]]  # fmt: skip
        rings.append([(x, 1.03 * r * np.sin(a), z) for x, z in rim])
    flat = np.array([(k * np.cos(b), k * np.sin(b))
                     for k, way in ((0.9, 1), (1.0, -1)) for b in np.linspace(-half, half,
                         6)[::-way]])  # fmt: skip
    return loft(np.array(rings), flat)


def peel_strip(palette: tuple[str, ...], sugar: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a curled strip of citrus peel."""

    def make(look: Look) -> Shape:
        color = look.color(*palette)
        turns, r = look.between(1.2, 1.9), look.between(0.014, 0.02)
        if sugar:
            a = np.linspace(-0.8, 0.8, 9)
            path = np.column_stack([0.05 * np.sin(a), 0.03 * np.cos(a), 0 * a])
            section = np.array([(-0.2, -0.35), (0.2, -0.35), (0.2, 0.35), (-0.2, 0.35)]) * 0.011
            body = sweep(path, section)
            tile = surfaces.spots(look.rng, color, (252, 248, 236), 0.3)
            return settle([(body, tile)], 0.05)
        a = np.linspace(0, 2 * np.pi * turns, 40)
        out = r * (1 + 0.35 * a / (2 * np.pi))
        path = np.column_stack([out * np.cos(a), out * np.sin(a), 0.004 + 0.011 * a / (2 * np.pi)])
        wide = np.interp(np.linspace(0, 1, 40), [0, 0.1, 0.9, 1], [0.2, 1, 1, 0.2])
        section = np.array([(-0.12, -0.5), (0.12, -0.5), (0.12, 0.5), (-0.12, 0.5)]) * 0.013
        body = sweep(path, section, wide)
        return settle(
            [(body, surfaces.spots(look.rng, color, tint_color(color, 0.88), 0.12))], 0.06
        )

    return make


GREEN: RGB = (92, 140, 62)
BROWN: RGB = (112, 84, 54)


@dataclass(frozen=True)
class Globe:
    """A round fruit: ``d`` is the range of its width in metres, and ``tall`` is height / width.

    ``skin`` names its surface, ``bumps`` is its number of warts, spikes or hairs, and ``top`` names
    what is on its top. ``pear`` narrows it towards the top; ``lying`` lays it on its side.
    """

    d: tuple[float, float]
    tall: float
    colors: tuple[str, ...]
    skin: str = "smooth"
    blush: RGB | None = None
    top: str = "stem"
    pear: float = 0.0
    bumps: int = 0
    lying: bool = False


def _ways(count: int, low: float = -0.72, high: float = 0.97) -> Float[np.ndarray, "n 2"]:
    """Return polar and azimuth angles of ``count`` points spread evenly over most of a sphere."""
    rise = np.linspace(high, low, count)
    return np.column_stack([np.arccos(rise), 2.4 * np.arange(count)])


def _over(kind: Globe, r: float, one: Callable[[], Solid], sink: float) -> Solid:
    """Spread copies of the solid ``one()`` (at z = 0) over a fruit, each sunk in by ``sink``."""
    made = []
    for polar, around in _ways(kind.bumps):
        solid = one().move(z=-sink).turn(1, polar).turn(2, around)
        narrow = 1 - kind.pear * np.cos(polar)
        at = r * np.sin(polar) * narrow
        made.append(solid.move(at * np.cos(around), at * np.sin(around),
                    kind.tall * r * np.cos(polar)))  # fmt: skip
    return join(made)


def _top(kind: Globe, r: float) -> list[tuple[Solid, surfaces.Tile]]:
    z = kind.tall * r
    green, brown = surfaces.plain(GREEN), surfaces.plain(BROWN)
    if kind.top == "stem":
        return [(tube([(0, 0, 0.95 * z), (0.05 * r, 0, 1.12 * z + 0.1 * r)], 0.07 * r, 7), brown)]
    if kind.top == "thick":
        return [(tube([(0, 0, 0.9 * z), (0.1 * r, 0, 1.3 * z)], [0.16 * r, 0.13 * r], 8), brown)]
    if kind.top == "calyx":
        leaves = [blade([(0, 0, 0.98 * z), (0.32 * r, 0, 1.05 * z), (0.62 * r, 0, 0.86 * z)],
                        0.5 * r, thick=0.2).turn(2, a)
                  for a in 2 * np.pi * np.arange(4) / 4 + 0.4]  # fmt: skip
        stub = cylinder(0.1 * r, 0.16 * r, 8).move(z=0.98 * z)
        return [(join([*leaves, stub]), surfaces.plain((124, 134, 74)))]
    if kind.top == "tuft":
        tuft = [blade([(0, 0, 0.95 * z), (0.1 * r, 0, 1.05 * z), (0.22 * r, 0, 1.22 * z)], 0.13 * r)
                .turn(2, 2 * np.pi * k / 5) for k in range(5)]  # fmt: skip
        return [(join(tuft), brown)]
    if kind.top == "leaf":
        leaf = blade([(0, 0, z), (0.5 * r, 0.1 * r, 1.25 * z), (1.3 * r, 0.2 * r, 1.2 * z)],
                     0.6 * r, thick=0.15)  # fmt: skip
        stub = tube([(0, 0, 0.95 * z), (0, 0, 1.1 * z)], 0.07 * r, 7)
        return [(join([leaf, stub]), green)]
    if kind.top == "stalks":
        stalks = []
        for k in range(6):
            a = 2 * np.pi * k / 6
            path = [(0.4 * r * np.cos(a), 0.4 * r * np.sin(a), 0.85 * z),
                    (0.7 * r * np.cos(a), 0.7 * r * np.sin(a), 1.5 * z),
                    (1.15 * r * np.cos(a), 1.15 * r * np.sin(a), 2.1 * z)]  # fmt: skip
            stalks.append(tube(path[:2], 0.07 * r, 6))
            stalks.append(blade(path[1:], 0.5 * r, thick=0.2))
        return [(join(stalks), green)]
    return []


def _peel(look: Look, kind: Globe, color: RGB) -> surfaces.Tile:
    if kind.skin == "streaks":
        return streaks(look.rng, color, tint_color(color, 1.35), 10)
    if kind.skin == "dark streaks":
        return streaks(look.rng, color, tint_color(color, 0.65), 14)
    if kind.skin in ("spots", "spiky", "warty"):
        return surfaces.spots(look.rng, color, tint_color(color, 0.78), 0.12)
    if kind.skin == "rings":
        return surfaces.stripes([color, color, tint_color(color, 0.72)], 8)
    return skin(look, color, kind.blush or tint_color(color, 0.82), 0.7)


def globe(kind: Globe) -> Callable[[Look], Shape]:
    """Return the shape function of the round fruit that ``kind`` describes."""

    def make(look: Look) -> Shape:
        d, color = look.between(*kind.d), look.color(*kind.colors)
        r, wobble = d / 2, look.between(0.94, 1.06)
        body = ellipsoid(d, d, kind.tall * d, 26, 16)
        if kind.pear:
            body = body.bend(lambda p: p * (
                1 - kind.pear * p[:, 2:] / (0.5 * kind.tall * d) * np.array([1, 1,
                    0])))  # fmt: skip
        pieces = [(body, _peel(look, kind, color)), *_top(kind, r)]
        deep = surfaces.plain(tint_color(color, 0.8))
        if kind.skin == "warty":
            s = 3.0 * r / np.sqrt(kind.bumps)
            pieces.append((_over(kind, r, lambda: ellipsoid(s, s, 0.5 * s, 6, 4), 0.0), deep))
        elif kind.skin == "spiky":
            s = 1.9 * r / np.sqrt(kind.bumps)
            spike = cylinder(s, 1.25 * s, 5, top=0.02 * s)
            pieces.append((_over(kind, r, lambda: spike, 0.25 * s), deep))
        elif kind.skin == "hairy":
            hair = tube([(0, 0, 0), (0.1 * r, 0, 0.24 * r), (0.3 * r, 0, 0.4 * r)],
                        [0.05 * r, 0.035 * r, 0.008 * r], 4)  # fmt: skip
            tips = surfaces.gradient(color, (168, 186, 84), look.rng)
            pieces.append((_over(kind, r, lambda: hair, 0.0), tips))
        made = [(s.scale(wobble, 1 / wobble, 1), t) for s, t in pieces]
        if kind.lying:
            way = look.between(0, 6.3)
            made = [(s.turn(1, np.pi / 2).turn(2, way), t) for s, t in made]
        return settle(made, 0.1 if kind.skin == "smooth" else 0.14, hulls=[[0]])

    return make


@category("fig", size=(0.0511, 0.0511, 0.0562), mass=0.05, material="food",
          themes=("kitchen", "food"), roles=("round", "edible"), colors=("purple",))  # fmt: skip
def fig(look: Look) -> Shape:
    """A fig resting with its neck up."""
    r, h = look.between(0.023, 0.028), look.between(0.052, 0.062)
    color = look.color("purple", "maroon", "indigo", "sage")
    body = lathe([(0, 0), (0.5 * r, 0.0), (0.92 * r, 0.16 * h), (r, 0.36 * h), (0.8 * r, 0.6 * h),
                  (0.36 * r, 0.82 * h), (0.17 * r, h), (0, h)], 28)  # fmt: skip
    dark = tint_color(color, 0.72)
    return settle([(body, streaks(look.rng, dark, tint_color(color, 1.25), 16))], 0.02)


@category("pomegranate", size=(0.0907, 0.0875, 0.0968), mass=0.28, material="food",
          aliases=("granadilla",), themes=("kitchen", "food"), roles=("round", "edible"),
          colors=("crimson",))  # fmt: skip
def pomegranate(look: Look) -> Shape:
    """A pomegranate with its crown."""
    r = look.between(0.04, 0.05)
    color = look.color("crimson", "red", "coral")
    body = lobe(ellipsoid(2 * r, 2 * r, 1.85 * r, 36, 16), 6, 0.04)
    crown = lobe(lathe([(0.14 * r, 0.85 * r), (0.24 * r, 1.1 * r), (0.4 * r, 1.38 * r),
                        (0.33 * r, 1.36 * r), (0.15 * r, 1.05 * r)], 36, loop=True), 6,
                 0.35)  # fmt: skip
    core = cylinder(0.2 * r, 0.3 * r, 12).move(z=0.85 * r)
    return settle([(body, skin(look, color, tint_color(color, 0.7), 0.8)),
                   (crown, surfaces.plain(tint_color(color, 0.85))),
                   (core, surfaces.plain((214, 180, 90)))], 0.06)  # fmt: skip


@category("star_fruit", size=(0.0586, 0.0557, 0.0114), mass=0.02, material="food",
          aliases=("starfruit", "carambola"), themes=("kitchen", "food"), roles=("edible", "flat"),
          colors=("yellow",), state="lying flat")  # fmt: skip
def star_fruit(look: Look) -> Shape:
    """A thick, star-shaped slice of star fruit, lying flat."""
    r, t = look.between(0.028, 0.036), look.between(0.008, 0.012)
    color = look.color("yellow", "lime", "golden")
    a = np.arange(10) * np.pi / 5 + np.pi / 2
    star = np.column_stack([np.cos(a), np.sin(a)]) * np.where(np.arange(10) % 2, 0.5, 1)[:, None]
    body = prism(r * star, 0, t)
    face = prism(0.84 * r * star, t - 0.0004, t + 0.0006)
    seeds = [ellipsoid(0.006, 0.003, 0.0014, 8, 4).move(x=0.3 * r).turn(2, b).move(z=t + 0.0006)
             for b in a[::2]]  # fmt: skip
    return shape([(body, surfaces.speckles(look.rng, color, 8)),
                  (face, surfaces.plain(tint_color(color, 1.3))),
                  (join(seeds), surfaces.plain((150, 110, 50)))], [hull_of(body)])  # fmt: skip


@category("passion_fruit", size=(0.058, 0.058, 0.0267), mass=0.04, material="food",
          aliases=("passionfruit", "maracuja"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("purple",))  # fmt: skip
def passion_fruit(look: Look) -> Shape:
    """Half a passion fruit with yellow pulp and seeds in its dark shell."""
    d = look.between(0.052, 0.062)
    color = look.color("purple", "maroon", "purple", "yellow")
    half = lathe([(0, 0), (0.2, 0), (0.42, 0.14), (0.5, 0.38), (0.5, 0.46), (0.45, 0.46),
                  (0.4, 0.34), (0, 0.34)], 28).scale(d, d, d)  # fmt: skip
    pulp = lathe([(0, 0.3), (0.42, 0.34), (0.36, 0.4), (0, 0.44)], 24).scale(d, d, d)
    seeds = [ellipsoid(0.006, 0.0045, 0.004, 6, 5).turn(2, n).move(0.32 * d
                                                                   * np.sqrt((n + 0.5) / 12)
                                                                   * np.cos(2.4 * n), 0.32 * d
                                                                   * np.sqrt((n + 0.5) / 12)
                                                                   * np.sin(2.4 * n), 0.42 * d)
             for n in range(12)]  # fmt: skip
    return shape([(half, surfaces.spots(look.rng, tint_color(color, 0.7), color, 0.1)),
                  (pulp, surfaces.gradient((236, 150, 30), (248, 196, 60), look.rng)),
                  (join(seeds), surfaces.plain((44, 38, 34)))], [hull_of(half)])  # fmt: skip


@category("papaya", size=(0.173, 0.0948, 0.062), mass=0.5, material="food", assembled=True,
          aliases=("pawpaw", "half papaya"), themes=("kitchen", "food"), roles=("edible",),
          colors=("yellow",), state="lying flat")  # fmt: skip
def papaya(look: Look) -> Shape:
    """A papaya half with black seeds in its orange flesh, or a whole papaya."""
    long, r = look.between(0.15, 0.19), look.between(0.042, 0.05)
    color = look.color("yellow", "green", "orange")
    whole = bent_rod(long, r, blunt=2.4, taper=-0.22)
    rind = skin(look, color, (120, 150, 60), 0.9)
    if look.chance(0.35):
        return settle([(whole, rind)], 0.08)
    half = whole.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0)]))
    flesh = bent_rod(0.93 * long, 0.92 * r, blunt=2.4, taper=-0.22, squash=0.03).move(z=0.001)
    hollow = bent_rod(0.6 * long, 0.42 * r, blunt=2.2, taper=-0.2, squash=0.08).move(z=0.0018)
    seeds = [ellipsoid(0.007, 0.0055, 0.005, 6, 5).move(u * 0.5 * long, v * r, 0.005)
             for u in np.linspace(-0.46, 0.46, 9) for v in (-0.2, 0, 0.2)]  # fmt: skip
    return settle([(half, rind), (flesh, surfaces.plain((242, 140, 66))),
                   (hollow, surfaces.plain((214, 96, 40))),
                   (join(seeds), surfaces.plain((40, 38, 36)))], 0.1)  # fmt: skip


@category("dragon_fruit", size=(0.14, 0.113, 0.0763), mass=0.35, material="food",
          aliases=("dragonfruit", "pitaya", "pitahaya"), themes=("kitchen", "food"),
          roles=("edible",), colors=("magenta",), state="lying flat")  # fmt: skip
@vary()
def dragon_fruit(look: Look) -> Shape:
    """A dragon fruit with pink skin and green-tipped scales, lying on its side."""
    k = look.between(0.9, 1.12)
    color = look.color("magenta", "magenta", "pink", "yellow")
    body = ellipsoid(0.115, 0.082, 0.08, 24, 14)
    scales = []
    for ring, u in enumerate((-0.72, -0.36, 0.0, 0.36, 0.7)):
        wide = np.sqrt(1 - u * u)
        for n in range(6):
            a = 2 * np.pi * (n + 0.5 * (ring % 2)) / 6
            y, z = 0.04 * wide * np.cos(a), 0.039 * wide * np.sin(a)
            if z < -0.028:
                continue
            scales.append(blade([(0.0575 * u, 0.97 * y, 0.97 * z),
                                 (0.0575 * u + 0.015, 1.14 * y, 1.14 * z),
                                 (0.0575 * u + 0.033, 1.42 * y, 1.42 * z)], 0.017, thick=0.4,
                                sides=5))  # fmt: skip
    crown = [blade([(0.05, 0, 0), (0.068, 0.006 * np.cos(a), 0.006 * np.sin(a)),
                    (0.084, 0.017 * np.cos(a), 0.017 * np.sin(a))], 0.012, thick=0.4, sides=5)
             for a in np.arange(5) * 1.257]  # fmt: skip
    tips = surfaces.gradient(tint_color(color, 0.95), (150, 190, 84), look.rng)
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.6)),
                   (join([*scales, *crown]), tips)], 0.16, hulls=[[0]]).scale(k)  # fmt: skip


@category("avocado", size=(0.104, 0.065, 0.045), mass=0.13, material="food",
          aliases=("avocado half", "half avocado"), themes=("kitchen", "food"), roles=("edible",),
          colors=("green",), state="lying flat", common=True)  # fmt: skip
def avocado(look: Look) -> Shape:
    """A whole avocado, or half of one with its stone, lying flat."""
    x, d = look.between(0.095, 0.115), look.between(0.06, 0.07)
    t = np.linspace(0, np.pi, 15)
    radius = d / 2 * np.sin(t) ** 0.85 * (1 - 0.3 * np.cos(t / 1.0) * (t < 2.2) * 0.9)
    radius[[0, -1]] = 0
    profile = np.column_stack([radius, -x / 2 * np.cos(t)])
    body = lathe(profile, 24).turn(1, -np.pi / 2)
    peel = look.color("green", "olive", "charcoal", "maroon", "olive")
    rough = surfaces.spots(look.rng, tint_color(peel, 0.55), tint_color(peel, 0.4), 0.2)
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
    pale = surfaces.speckles(look.rng, (214, 214, 128), 8)
    edge = prism(0.985 * rim, top - 0.001, top + 0.0008)
    flesh = prism(0.87 * rim, top, top + 0.0014)
    middle = 0.16 * x
    stone = ellipsoid(0.036, 0.036, 0.03, 18, 10).move(middle, 0, top)
    brown = skin(look, (126, 78, 42), (92, 54, 30))
    return shape(
        [(lower, rough), (edge, surfaces.plain((150, 176, 84))), (flesh, pale), (stone, brown)],
        [flat_foot(lower.vertices), hull_part(stone.vertices[stone.vertices[:, 2] >= top])],
    )


@category("coconut", size=(0.108, 0.108, 0.0862), mass=0.5, material="food", assembled=True,
          aliases=("coconut half", "half coconut"), themes=("kitchen", "food"),
          roles=("round", "edible"), colors=("brown",))  # fmt: skip
def coconut(look: Look) -> Shape:
    """A whole, hairy coconut, or half of one with white flesh."""
    d = look.between(0.1, 0.12)
    color = look.color("brown", "bronze", "brown")
    hair = surfaces.scratches(look.rng, color, tint_color(color, 0.6), 500)
    if look.chance(0.45):
        half = lathe([(0, 0), (0.22, 0), (0.42, 0.12), (0.5, 0.36), (0.5, 0.46), (0.46, 0.46),
                      (0.4, 0.24), (0, 0.14)], 30)  # fmt: skip
        flesh = lathe([(0, 0.13), (0.38, 0.23), (0.465, 0.463), (0.405, 0.463), (0.32, 0.28),
                       (0, 0.19)], 30)  # fmt: skip
        return shape([(half.scale(d, d, d), hair), (flesh.scale(d, d, d), surfaces.speckles(
            look.rng, (250, 248, 242), 4))], [hull_of(half.scale(d, d, d))])  # fmt: skip
    body = ellipsoid(d, d, 1.06 * d, 26, 16)
    eyes = [ellipsoid(0.016, 0.016, 0.008, 10, 6).move(0.02 * np.cos(a), 0.02 * np.sin(a),
            0.49 * d) for a in (0.3, 2.4, 4.5)]  # fmt: skip
    return settle([(body, hair), (join(eyes), surfaces.plain(tint_color(color, 0.4)))], 0.06)


CATEGORIES = (
    Category("pineapple_ring",
             _ring((0.036, 0.044), 0.32, 0.011, ("yellow", "gold", "amber"), 0.92),
             size=(0.077, 0.0774, 0.0105), mass=0.04, material="food",
             aliases=("ring of pineapple", "pineapple slice", "slice of pineapple"),
             themes=("kitchen", "food"), roles=("edible", "flat"), colors=("yellow",),
             state="lying flat"),
    Category("apple_slice",
             _wedge((0.068, 0.078), 0.3, (250, 240, 208), ("red", "green", "crimson", "lime")),
             size=(0.0365, 0.0729, 0.0199), mass=0.02, material="food",
             aliases=("slice of apple", "apple wedge", "cut apple", "pear slice"),
             themes=("kitchen", "food"), roles=("edible",), colors=("red",),
             state="lying on its side"),
    Category("lychee", globe(Globe((0.03, 0.037), 1.05, ("crimson", "coral", "maroon", "pink"),
             "warty", bumps=60)), size=(0.0376, 0.0372, 0.0345), mass=0.02, material="food",
             aliases=("litchi", "lichee"), themes=("kitchen", "food"), roles=("round", "edible"),
             colors=("crimson",)),
    Category("guava", globe(Globe((0.062, 0.078), 1.1, ("lime", "sage", "yellow", "green"), "spots",
             top="tuft", pear=0.12)), size=(0.0708, 0.074, 0.076), mass=0.12, material="food",
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("lime",)),
    Category("persimmon",
             globe(Globe((0.064, 0.078), 0.8, ("orange", "orange", "coral", "amber"), top="calyx")),
             size=(0.0712, 0.0712, 0.0561), mass=0.17, material="food", assembled=True,
             aliases=("sharon fruit", "kaki"), themes=("kitchen", "food"),
             roles=("round", "edible"), colors=("orange",)),
    Category("quince", globe(Globe((0.074, 0.088), 1.08, ("yellow", "gold", "lime"), "smooth",
             (150, 160, 80), "tuft", 0.2)), size=(0.0823, 0.0868, 0.0898), mass=0.22,
             material="food", themes=("kitchen", "food"), roles=("round", "edible"),
             colors=("yellow",)),
    Category("rambutan",
             globe(Globe((0.034, 0.041), 1.1, ("crimson", "red", "coral"), "hairy", bumps=70)),
             size=(0.0538, 0.0526, 0.0431), mass=0.03, material="food", assembled=True,
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("crimson",)),
    Category("durian", globe(Globe((0.16, 0.19), 1.2, ("olive", "tan", "sage", "mustard"), "spiky",
             top="thick", bumps=130, lying=True)), size=(0.215, 0.231, 0.169), mass=2.0,
             material="food", themes=("kitchen", "food"), roles=("edible", "big"),
             colors=("olive",)),
    Category("jackfruit", globe(Globe((0.17, 0.21), 1.5, ("olive", "green", "sage", "mustard"),
             "warty", top="thick", bumps=80, lying=True)), size=(0.271, 0.29, 0.169), mass=4.5,
             material="food", aliases=("jack fruit", "breadfruit"), themes=("kitchen", "food"),
             roles=("edible", "big"), colors=("olive",)),
    Category("soursop", globe(Globe((0.1, 0.125), 1.45, ("green", "sage", "green", "olive"),
             "spiky", top="thick", pear=0.2, bumps=90, lying=True)), size=(0.182, 0.154, 0.117),
             mass=0.7, material="food", aliases=("custard apple", "cherimoya", "graviola"),
             themes=("kitchen", "food"), roles=("edible", "big"), colors=("green",)),
    Category("longan", globe(Globe((0.022, 0.027), 0.98, ("tan", "wooden", "beige"), "spots")),
             size=(0.0253, 0.0253, 0.0239), mass=0.01, material="food", themes=("kitchen", "food"),
             roles=("round", "edible"), colors=("tan",)),
    Category("mangosteen",
             globe(Globe((0.056, 0.068), 0.9, ("maroon", "purple", "maroon"), top="calyx")),
             size=(0.0627, 0.0634, 0.0552), mass=0.1, material="food", themes=("kitchen", "food"),
             roles=("round", "edible"), colors=("maroon",)),
    Category("loquat", globe(Globe((0.032, 0.04), 1.2, ("orange", "amber", "yellow"), "smooth",
             None, "tuft", 0.14, lying=True)), size=(0.0415, 0.0426, 0.032), mass=0.03,
             material="food", themes=("kitchen", "food"), roles=("edible",), colors=("orange",)),
    Category("greengage", globe(Globe((0.035, 0.042), 1.04, ("lime", "olive", "lime", "sage"),
             "smooth", (170, 160, 60))), size=(0.0375, 0.0374, 0.0391), mass=0.04, material="food",
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("lime",)),
    Category("prickly_pear", globe(Globe((0.048, 0.058), 1.35, ("crimson", "green", "coral",
             "lime"), "warty", top="none", bumps=36, lying=True)), size=(0.0672, 0.066, 0.0515),
             mass=0.1, material="food", aliases=("cactus fruit", "cactus pear"),
             themes=("kitchen", "food"), roles=("edible",), colors=("crimson",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
