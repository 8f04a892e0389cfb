"""Objects of the ``kitchen`` theme: melons."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import arc
from ...kit.parts import hull_of
from ...kit.primitives import lobe
from ...kit.shapes import Category, Shape, category, in_sizes, settle, shape
from ...kit.solids import Solid, cylinder, ellipsoid, lathe, prism, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from .fruit import _wedge


@category("watermelon_slice", size=(0.18, 0.1, 0.024), mass=0.25, material="food",
          aliases=("slice of watermelon", "melon slice"), themes=("kitchen", "food"),
          roles=("flat", "edible"), colors=("red",), state="lying flat", common=True)  # fmt: skip
def watermelon_slice(look: Look) -> Shape:
    """A slice of watermelon lying flat: flesh with seeds, and a rind with a pale inner layer."""
    r, thick = look.between(0.085, 0.12), look.between(0.018, 0.03)
    half = look.pick([np.pi / 2, np.pi / 2, 0.62, 0.75])
    color = look.color("red", "coral", "red", "crimson", "amber")
    side = surfaces.speckles(look.rng, color, 10, 96)
    flesh = speck(side, look.rng, (40, 28, 24), int(look.rng.integers(16, 30)))

    def band(inner: float, outer: float) -> Solid:
        out = arc((0, 0), outer * r, -half, half, 16)
        back = arc((0, 0), inner * r, half, -half, 16) if inner else np.zeros((1, 2))
        if inner == 0 and half > 1.5:
            return prism(out, 0, thick)
        return prism(np.concatenate([out, back]), 0, thick)

    rind = look.own_color("green", "lime", "green")
    dark = surfaces.stripes([rind, tint_color(rind, 0.6)], 12, upright=True)
    solids = [band(0, 0.86), band(0.86, 0.92), band(0.92, 1.0)]
    tiles = [flesh, surfaces.plain((228, 234, 196)), dark]
    turned = [s.turn(2, -np.pi / 2) for s in solids]
    return shape(zip(turned, tiles, strict=True), [hull_of(*turned)])


@category("watermelon_half", size=(0.194, 0.194, 0.09), mass=1.6, material="food",
          aliases=("half watermelon", "half a watermelon", "watermelon cut in half",
          "cut watermelon"), themes=("kitchen", "food"), roles=("edible", "round", "big"),
          colors=("green",))  # fmt: skip
def watermelon_half(look: Look) -> Shape:
    """Half a watermelon with its red, seeded cut face up."""
    r, h = look.between(0.09, 0.11), look.between(0.085, 0.1)
    color = look.color("green", "green", "olive")
    a = np.linspace(0.25, np.pi / 2, 8)
    side = [(0.0, 0.0), *[(r * np.sin(t), h * (1 - np.cos(t)) / (1 - np.cos(np.pi / 2)) - 0.003)
            for t in a]]  # fmt: skip
    side[1] = (side[1][0], 0.0)
    body = lathe([*side, (0, h - 0.003)], 32)
    bands = surfaces.stripes([tint_color(color, 0.6), tint_color(color, 1.4)], 9, upright=True)
    rows, columns = np.mgrid[0:192, 0:192] / 191 * 2 - 1
    away = np.hypot(rows, columns)
    face = np.where((away < 0.9)[..., None], np.array((226, 62, 58)), np.array((232, 240, 200)))
    face = np.where((away > 0.96)[..., None], np.array(tint_color(color, 0.9)), face)
    for k in range(26):
        reach, turn = 0.35 + 0.45 * (k % 3) / 2, 2.4 * k
        at = np.hypot(rows - reach * np.sin(turn), columns - reach * np.cos(turn)) < 0.032
        face = np.where(at[..., None], np.array((40, 30, 30)), face)
    top = cylinder(0.992 * r, 0.0012, 32).move(z=h - 0.0036)
    return shape([(body, bands), (top, face.astype(np.uint8))], [hull_of(body)])


STEM: RGB = (110, 90, 52)


@category("melon", size=(0.154, 0.14, 0.139), mass=1.2, material="food", aliases=("cantaloupe",
          "honeydew", "galia melon", "whole melon", "rockmelon", "honeydew melon"),
          themes=("kitchen", "food"), roles=("round", "edible", "big"),
          colors=("tan",))  # fmt: skip
def melon(look: Look) -> Shape:
    """A whole melon with netted or smooth skin."""
    d = look.between(0.13, 0.155)
    color = look.color("tan", "yellow", "sage", "beige")
    body = lobe(ellipsoid(1.08 * d, d, 0.98 * d, 40, 20), 10, 0.03)
    net = surfaces.noise(look.rng, 128, 128, (14, 14), 2)
    lines = (np.abs(net) < 0.1)[..., None]
    base = surfaces.stripes([color, tint_color(color, 0.86)], 10, upright=True, side=128)
    tile = np.where(lines, np.array(tint_color(color, 1.45)), base).astype(np.uint8)
    stub = tube([(0, 0, 0.47 * d), (0.004, 0, 0.53 * d)], 0.006, 8)
    return settle([(body, tile), (stub, surfaces.plain((140, 130, 80)))], 0.05)


@category("watermelon", size=(0.238, 0.181, 0.169), mass=3.5, material="food",
          aliases=("whole watermelon", "water melon"), themes=("kitchen", "food"),
          roles=("edible", "big"), colors=("green",))  # fmt: skip
@in_sizes(0.12)
def watermelon(look: Look) -> Shape:
    """A whole striped watermelon, lying on its side."""
    x, d = look.between(0.21, 0.25), look.between(0.165, 0.19)
    color = look.color("green", "green", "olive")
    _, u = np.mgrid[0:128, 0:160]
    wave = surfaces.noise(look.rng, 128, 160, (8, 4), 3) * 0.35
    dark = np.sin(2 * np.pi * (9 * u / 160) + 3 * wave) > 0.1
    tile = np.where(dark[..., None], np.array(tint_color(color, 0.62)),
                    np.array(tint_color(color, 1.4))).astype(np.uint8)  # fmt: skip
    body = ellipsoid(d, d, x, 30, 18).turn(1, np.pi / 2)
    stub = tube([(0.48 * x, 0, 0), (0.54 * x, 0.004, 0.004)], 0.004, 8)
    return settle([(body, tile), (stub, surfaces.plain(STEM))], 0.06)


CATEGORIES = (
    Category("melon_wedge", _wedge((0.14, 0.16), 0.36, (246, 180, 110), ("sage", "tan", "yellow")),
             size=(0.0783, 0.156, 0.0513), mass=0.2, material="food",
             aliases=("wedge of melon", "slice of melon", "cantaloupe slice", "honeydew slice"),
             themes=("kitchen", "food"), roles=("edible",), colors=("sage",),
             state="lying on its side"),
)  # fmt: skip
"""Objects that share their drawing functions."""
