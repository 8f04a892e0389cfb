"""Mats that other things lie on: placemats, cutting mats."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.outlines import ellipse, rectangle
from ...build.shape import Shape, shape
from ...build.solids import prism
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile

WEAVES = ("woven", "braided", "bamboo", "checked", "bordered", "leafy", "striped", "plain")


def placemat(look: Look) -> Shape:
    """A placemat: woven, braided, of bamboo, checked, bordered or printed; mostly rectangular."""
    kind = look.pick(WEAVES)
    x, y = look.between(0.4, 0.46), look.between(0.29, 0.335)
    high = look.between(0.002, 0.004)
    color = look.color("tan", "beige", "navy", "gray", "sage", "red", "teal", "mustard", "white")
    other = look.own_color("white", "cream", "terracotta", "navy", "charcoal", "olive")
    if np.abs(np.array(other) - color).max() < 60:
        other = tint_color(color, 0.55 if sum(color) > 330 else 1.5)
    outline = look.pick([rectangle(x, y, 0.006), rectangle(x, y, 0.03), ellipse(x, y, 40)])
    if kind == "braided":
        outline = look.pick([ellipse(0.37, 0.37, 40), ellipse(x, y, 40)])
    elif kind == "bamboo":
        outline = rectangle(x, y, 0.004)
    mat = prism(outline, 0, high, 0.0008)
    return shape([(mat, _weave(look, kind, color, other))], [hull_of(mat)])


def _weave(look: Look, kind: str, color: RGB, other: RGB) -> Tile:
    side = 192
    v, u = (np.mgrid[0:side, 0:side] + 0.5) / side
    if kind == "woven":
        return textures.basketwork(look.rng, color, int(look.rng.integers(16, 30)))
    if kind == "braided":
        away, around = np.hypot(u - 0.5, v - 0.5), np.arctan2(v - 0.5, u - 0.5)
        turns = int(look.rng.integers(9, 16))
        shade = 0.72 + 0.28 * np.abs(np.sin(2 * np.pi * turns * away))
        shade = shade * (0.9 + 0.1 * np.sin(90 * around + 40 * away))
        ring = (np.floor(2 * turns * away) % look.pick([3, 5, 99]) == 2)[..., None]
        return np.clip(np.where(ring, other, color) * shade[..., None], 0, 255).astype(np.uint8)
    if kind == "bamboo":
        slats = int(look.rng.integers(40, 64))
        tone = look.rng.uniform(0.86, 1.06, slats)[np.minimum((v * slats).astype(int), slats - 1)]
        image = np.array(color) * (tone * (1 - 0.25 * ((v * slats) % 1 > 0.8)))[..., None]
        thread = np.abs((u * 6) % 1 - 0.5) < 0.018
        image[thread] = np.array(other)
        return np.clip(image, 0, 255).astype(np.uint8)
    if kind == "checked":
        count = int(look.rng.integers(5, 10))
        bands = (np.floor(u * 2 * count) % 2 + np.floor(v * 1.4 * count) % 2)[..., None] / 2
        image = np.array(other) * (1 - bands) + np.array(color) * bands
        return np.clip(image + look.rng.uniform(-5, 5, (side, side, 1)), 0, 255).astype(np.uint8)
    if kind == "striped":
        tones = [color] * 3 + [other] + [color] + [other]
        tile = textures.stripes(tones, int(look.rng.integers(1, 5)), upright=look.chance(0.5),
                                side=side)  # fmt: skip
        return np.clip(tile + look.rng.uniform(-6, 6, (side, side, 1)), 0, 255).astype(np.uint8)
    image = textures.fit(textures.fabric(look.rng, color), side, side).copy()
    if kind == "bordered":
        edge = np.maximum(np.abs(u - 0.5), np.abs(v - 0.5))
        for low, high in ((0.4, 0.43), (0.45, 0.46)):
            image[(edge > low) & (edge < high)] = np.array(other, np.uint8)
    elif kind == "leafy":
        for _ in range(34):
            x, y, turn = look.between(0, 1), look.between(0, 1), look.between(0, 6.28)
            c, s = np.cos(turn), np.sin(turn)
            lobe = ((0, 0), (0.045, 0.022), (0.09, 0), (0.045, -0.022))
            leaf = [(x + a * c - b * s, y + a * s + b * c) for a, b in lobe]
            prints.polygon(image, leaf, tint_color(other, look.between(0.85, 1.15)))
    return image


def cutting_mat(look: Look) -> Shape:
    """A self-healing mat with a ruled grid, figures along its edges and slanted guides."""
    x, y = look.pick([(0.3, 0.22), (0.45, 0.3), (0.45, 0.3), (0.36, 0.26)])
    x, y = x * look.between(0.97, 1.03), y * look.between(0.97, 1.03)
    color = look.color("green", "green", "green", "teal", "blue", "charcoal", "pink", "purple")
    line = readable_on(color) if look.chance(0.3) else tint_color(color, look.pick([1.55, 1.75]))
    if look.chance(0.2):
        line = look.pick([(240, 210, 90), (244, 244, 236)])
    mat = prism(rectangle(x, y, 0.008), 0, 0.003, 0.0005)
    return shape([(mat, _rule(look, x, y, color, line))], [box_part(x, y, 0.003)])


def _between(a: RGB, b: RGB) -> RGB:
    """Return the colour a little nearer to ``a`` than to ``b``."""
    red, green, blue = (0.55 * x + 0.45 * y for x, y in zip(a, b, strict=True))
    return red, green, blue


def _rule(look: Look, x: float, y: float, color: RGB, line: RGB) -> Tile:
    """Return a grid of centimetres, every fifth line strong, in a border with figures."""
    wide, tall = 400, round(400 * y / x)
    image = prints.canvas(wide, tall, color)
    left, top = 0.05, 0.05 * x / y
    across, down = int(x * 0.9 / 0.01), int(y * (1 - 2 * top) / 0.01)
    step = (1 - 2 * left) / across, (1 - 2 * top) / down
    faint = _between(color, line)
    for strong in (False, True):
        ink = line if strong else faint
        for k in range(across + 1):
            if (k % 5 == 0) == strong:
                prints.fill(image, left + k * step[0], top, 1 / wide, 1 - 2 * top, ink)
        for k in range(down + 1):
            if (k % 5 == 0) == strong:
                prints.fill(image, left, top + k * step[1], 1 - 2 * left, 1 / tall, ink)
    for k in range(0, across + 1, 5):
        for v in (0.5 * top, 1 - 0.5 * top):
            prints.write(image, str(k), left + k * step[0], v, 0.028, line)
    for k in range(0, down + 1, 5):
        prints.write(image, str(k), 0.5 * left, 1 - top - k * step[1], 0.028, line)
    if look.chance(0.7):
        for angle in np.deg2rad([30, 45, 60]):
            reach = min((1 - 2 * left) / np.cos(angle), (1 - 2 * top) * y / x / np.sin(angle))
            end = (left + reach * np.cos(angle), 1 - top - reach * np.sin(angle) * x / y)
            prints.stroke(image, [(left, 1 - top), end], 0.003, line)
    if look.chance(0.35):
        prints.disc(image, 0.62, 0.45, 0.26, line, 0.25)
        prints.disc(image, 0.62, 0.45, 0.16, line, 0.15)
    for _ in range(int(look.rng.integers(0, 9))):
        u, v, turn = look.between(0.1, 0.9), look.between(0.1, 0.9), look.between(0, 3)
        end = (u + 0.16 * np.cos(turn), v + 0.2 * np.sin(turn))
        prints.stroke(image, [(u, v), end], 0.002, tint_color(color, 0.78))
    return image


CATEGORIES = (
    Category("placemat", placemat, (0.42, 0.325, 0.003), 0.12,
             ("place mat", "table mat", "dinner mat", "dining mat"), ("dining", "breakfast"),
             ("flat", "support", "big"), ("beige", "navy"), state="lying flat"),
    Category("cutting_mat", cutting_mat, (0.39, 0.27, 0.003), 0.4,
             ("craft mat", "self healing mat", "self-healing mat", "self healing cutting mat",
              "self-healing cutting mat", "grid mat"), ("craft", "workbench"),
             ("flat", "support", "big"), ("green", "blue"), friction=0.8, state="lying flat"),
)  # fmt: skip
"""The module's categories."""
