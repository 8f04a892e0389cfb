"""Large fruit by the piece: citrus, melons, pumpkins, coconuts, papayas."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade, lobe
from ...build.settled import limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, tube
from ...build.variants import in_sizes, vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

STEM: RGB = (110, 90, 52)


def wheel(color: RGB, pith: RGB, count: int = 9) -> textures.Tile:
    """Return the cut face of a citrus fruit: its segments like spokes."""
    y, x = np.mgrid[0:128, 0:128] / 127 * 2 - 1
    away, turn = np.hypot(x, y), np.arctan2(y, x)
    gap = np.abs(np.sin(count * turn / 2)) * away < 0.07
    image = np.where((gap | (away < 0.1) | (away > 0.84))[..., None], np.array(pith),
                     np.array(color) * (0.92 + 0.12 * np.sin(40 * away)[..., None]))  # fmt: skip
    image = np.where((away > 0.95)[..., None], np.array(tint_color(color, 0.9)), image)
    return np.clip(image, 0, 255).astype(np.uint8)


def _citrus(look: Look, d: tuple[float, float], flesh: RGB, palette: tuple[str, ...],
            nub: float) -> Shape:  # fmt: skip
    """Return a citrus fruit, whole or a half with its cut face up."""
    size, color = look.between(*d), look.color(*palette)
    peel = textures.spots(look.rng, color, tint_color(color, 0.88), 0.12)
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
                       textures.plain((120, 140, 70))))  # fmt: skip
    return settle(pieces, 0.07)


def lime(look: Look) -> Shape:
    """A lime, whole or halved."""
    return _citrus(look, (0.046, 0.053), (190, 214, 110), ("lime", "green", "lime"), 0.12)


def grapefruit(look: Look) -> Shape:
    """A grapefruit, whole or halved, pink inside."""
    return _citrus(look, (0.098, 0.115), (236, 110, 96), ("amber", "coral", "yellow"), 0.0)


def _slice(look: Look, d: float, flesh: RGB, rind: RGB) -> Shape:
    t = look.between(0.004, 0.006)
    disc = cylinder(d / 2, t, 32, bevel=0.0005)
    face = cylinder(0.98 * d / 2, 0.0006, 32).move(z=t - 0.0003)
    return shape([(disc, textures.plain(rind)), (face, wheel(flesh, (250, 244, 214)))],
                 [hull_of(disc, face)])  # fmt: skip


def lemon_slice(look: Look) -> Shape:
    """A round slice of a citrus fruit lying flat."""
    color = look.color("yellow", "yellow", "lime", "orange")
    return _slice(look, look.between(0.05, 0.066), tint_color(color, 1.25), color)


def melon(look: Look) -> Shape:
    """A netted or smooth melon, whole."""
    d = look.between(0.13, 0.155)
    color = look.color("tan", "yellow", "sage", "beige")
    body = lobe(ellipsoid(1.08 * d, d, 0.98 * d, 40, 20), 10, 0.03)
    net = textures.noise(look.rng, 128, 128, (14, 14), 2)
    lines = (np.abs(net) < 0.1)[..., None]
    base = textures.stripes([color, tint_color(color, 0.86)], 10, upright=True, side=128)
    tile = np.where(lines, np.array(tint_color(color, 1.45)), base).astype(np.uint8)
    stub = tube([(0, 0, 0.47 * d), (0.004, 0, 0.53 * d)], 0.006, 8)
    return settle([(body, tile), (stub, textures.plain((140, 130, 80)))], 0.05)


def watermelon(look: Look) -> Shape:
    """A whole striped watermelon lying."""
    x, d = look.between(0.21, 0.25), look.between(0.165, 0.19)
    color = look.color("green", "green", "olive")
    _, u = np.mgrid[0:128, 0:160]
    wave = textures.noise(look.rng, 128, 160, (8, 4), 3) * 0.35
    dark = np.sin(2 * np.pi * (9 * u / 160) + 3 * wave) > 0.1
    tile = np.where(dark[..., None], np.array(tint_color(color, 0.62)),
                    np.array(tint_color(color, 1.4))).astype(np.uint8)  # fmt: skip
    body = ellipsoid(d, d, x, 30, 18).turn(1, np.pi / 2)
    stub = tube([(0.48 * x, 0, 0), (0.54 * x, 0.004, 0.004)], 0.004, 8)
    return settle([(body, tile), (stub, textures.plain(STEM))], 0.06)


def coconut(look: Look) -> Shape:
    """A hairy coconut, whole, or a half with white flesh."""
    d = look.between(0.1, 0.12)
    color = look.color("brown", "bronze", "brown")
    hair = textures.scratches(look.rng, color, tint_color(color, 0.6), 500)
    if look.chance(0.45):
        half = lathe([(0, 0), (0.22, 0), (0.42, 0.12), (0.5, 0.36), (0.5, 0.46), (0.46, 0.46),
                      (0.4, 0.24), (0, 0.14)], 30)  # fmt: skip
        flesh = lathe([(0, 0.13), (0.38, 0.23), (0.465, 0.463), (0.405, 0.463), (0.32, 0.28),
                       (0, 0.19)], 30)  # fmt: skip
        return shape([(half.scale(d, d, d), hair), (flesh.scale(d, d, d), textures.speckles(
            look.rng, (250, 248, 242), 4))], [hull_of(half.scale(d, d, d))])  # fmt: skip
    body = ellipsoid(d, d, 1.06 * d, 26, 16)
    eyes = [ellipsoid(0.016, 0.016, 0.008, 10, 6).move(0.02 * np.cos(a), 0.02 * np.sin(a),
            0.49 * d) for a in (0.3, 2.4, 4.5)]  # fmt: skip
    return settle([(body, hair), (join(eyes), textures.plain(tint_color(color, 0.4)))], 0.06)


def pumpkin(look: Look) -> Shape:
    """A ribbed pumpkin with its stalk."""
    r, h = look.between(0.085, 0.11), look.between(0.12, 0.15)
    color = look.color("orange", "orange", "terracotta", "ivory", "amber")
    t = np.linspace(-np.pi / 2, np.pi / 2, 15)
    radius = np.maximum(r * np.cos(t) ** 0.6, 0)
    z = 0.5 * h * (1 + np.sin(t)) - 0.14 * h * np.exp(-((radius / (0.35 * r)) ** 2)) * np.sign(
        np.sin(t)) * (np.abs(np.sin(t)) > 0.5)  # fmt: skip
    radius[[0, -1]] = 0
    body = lobe(lathe(np.column_stack([radius, z]), 60), 10, 0.2)
    rind = textures.stripes([tint_color(color, 0.85), color, tint_color(color, 1.08), color], 10,
                            upright=True, side=80)  # fmt: skip
    stalk = limb([(0, 0, 0.82 * h), (0.004, 0, 1.0 * h), (0.022, 0.004, 1.14 * h)],
                 [0.018, 0.011, 0.009], 8)  # fmt: skip
    return settle([(body, rind), (stalk, textures.speckles(look.rng, (116, 122, 66), 12))], 0.04)


def papaya(look: Look) -> Shape:
    """A papaya half lying, black seeds in its orange flesh, or a whole one."""
    long, r = look.between(0.15, 0.19), look.between(0.042, 0.05)
    color = look.color("yellow", "green", "orange")
    whole = rod(long, r, blunt=2.4, taper=-0.22)
    rind = skin(look, color, (120, 150, 60), 0.9)
    if look.chance(0.35):
        return settle([(whole, rind)], 0.08)
    half = whole.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0)]))
    flesh = rod(0.93 * long, 0.92 * r, blunt=2.4, taper=-0.22, squash=0.03).move(z=0.001)
    hollow = rod(0.6 * long, 0.42 * r, blunt=2.2, taper=-0.2, squash=0.08).move(z=0.0018)
    seeds = [
        ellipsoid(0.007, 0.0055, 0.005, 6, 5).move(u * 0.5 * long, v * r, 0.005)
        for u in np.linspace(-0.46, 0.46, 9)
        for v in (-0.2, 0, 0.2)
    ]
    return settle([(half, rind), (flesh, textures.plain((242, 140, 66))),
                   (hollow, textures.plain((214, 96, 40))),
                   (join(seeds), textures.plain((40, 38, 36)))], 0.1)  # fmt: skip


def dragon_fruit(look: Look) -> Shape:
    """A dragon fruit lying, its pink skin with green-tipped scales."""
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
    tips = textures.gradient(tint_color(color, 0.95), (150, 190, 84), look.rng)
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.6)),
                   (join([*scales, *crown]), tips)], 0.16, hulls=[[0]]).scale(k)  # fmt: skip


_K = ("kitchen", "food")
CATEGORIES = (
    Category("lime", lime, (0.066, 0.0489, 0.0441), 0.065, ("half lime",), _K, ("round", "edible"),
             ("lime",)),
    Category("grapefruit", grapefruit, (0.105, 0.105, 0.0849), 0.35, ("pomelo", "half grapefruit"),
             _K, ("round", "edible"), ("amber",)),
    Category("lemon_slice", lemon_slice, (0.0586, 0.0586, 0.00511), 0.012, ("slice of lemon",
             "lime slice", "orange slice", "slice of orange", "slice of lime", "lime wedge",
             "lemon wedge"), _K, ("edible", "flat", "round"), ("yellow",), state="lying flat"),
    Category("melon", melon, (0.154, 0.14, 0.139), 1.2, ("cantaloupe", "honeydew",
                 "galia melon", "whole melon", "rockmelon", "honeydew melon"),
             _K, ("round", "edible", "big"), ("tan",)),
    Category("watermelon", in_sizes(watermelon, 0.12), (0.238, 0.181, 0.169), 3.5,
             ("whole watermelon",
             "water melon"), _K, ("edible", "big"), ("green",)),
    Category("coconut", coconut, (0.108, 0.108, 0.0862), 0.5, ("coconut half", "half coconut"), _K,
             ("round", "edible"), ("brown",)),
    Category("pumpkin", pumpkin, (0.219, 0.209, 0.151), 1.2, ("halloween pumpkin",
             ), _K, ("round", "edible", "big"), ("orange",)),
    Category("papaya", papaya, (0.173, 0.0948, 0.062), 0.5, ("pawpaw", "half papaya"), _K,
             ("edible",), ("yellow",), state="lying flat"),
    vary(Category("dragon_fruit", dragon_fruit, (0.14, 0.113, 0.0763), 0.35, ("dragonfruit",
             "pitaya",
             "pitahaya"), _K, ("edible",), ("magenta",), state="lying flat")),
)  # fmt: skip
"""The module's categories."""
