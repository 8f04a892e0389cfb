"""Halved fruit."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.shape import Shape, shape
from ...build.solids import cylinder, lathe
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..harvest.exotic import wheel


def _half(
    d: tuple[float, float], flesh: RGB, palette: tuple[str, ...], count: int
) -> Callable[[Look], Shape]:
    """Return the shape function of a halved citrus fruit, its cut face up."""

    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*palette)
        tall = look.between(0.5, 0.62)
        half = lathe([(0, 0), (0.2, 0), (0.42, 0.12), (0.5, 0.36), (0.5, tall), (0, tall)], 30)
        half = half.scale(size, size * look.between(0.94, 1), size)
        face = cylinder(0.49 * size, 0.001, 30).move(z=tall * size - 0.0004)
        face = face.scale(1, float(np.ptp(half.vertices[:, 1])) / size, 1)
        peel = textures.spots(look.rng, color, tint_color(color, 0.88), 0.12)
        return shape([(half, peel), (face, wheel(flesh, (250, 246, 222), count))], [hull_of(half)])

    return make


def watermelon_half(look: Look) -> Shape:
    """Half a watermelon, its red cut face up, seeds in it."""
    r, h = look.between(0.09, 0.11), look.between(0.085, 0.1)
    color = look.color("green", "green", "olive")
    a = np.linspace(0.25, np.pi / 2, 8)
    side = [(0.0, 0.0), *[(r * np.sin(t), h * (1 - np.cos(t)) / (1 - np.cos(np.pi / 2)) - 0.003)
            for t in a]]  # fmt: skip
    side[1] = (side[1][0], 0.0)
    body = lathe([*side, (0, h - 0.003)], 32)
    bands = textures.stripes([tint_color(color, 0.6), tint_color(color, 1.4)], 9, upright=True)
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


_K = ("kitchen", "food")

CATEGORIES = (
    Category("lemon_half", _half((0.052, 0.062), (250, 228, 110), ("yellow", "yellow", "gold"), 9),
             (0.0576, 0.0567, 0.0335), 0.05, ("half lemon", "half a lemon", "half of a lemon",
                                              "halved lemon",
             "cut lemon", "lemon cut in half"), _K, ("edible", "round"), ("yellow",)),
    Category("orange_half", _half((0.07, 0.082), (246, 160, 50), ("orange", "orange", "amber"), 10),
             (0.0789, 0.0763, 0.0459), 0.09, ("half orange", "half an orange", "half of an orange",
             "halved orange", "cut orange"), _K, ("edible", "round"), ("orange",)),
    Category("watermelon_half", watermelon_half, (0.194, 0.194, 0.09), 1.6, ("half watermelon",
             "half a watermelon", "watermelon cut in half", "cut watermelon"), _K,
             ("edible", "round", "big"), ("green",)),
)  # fmt: skip
"""The module's categories."""
