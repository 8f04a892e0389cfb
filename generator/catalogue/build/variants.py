"""Shape functions made of others: things that keep still, and things of more sizes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..surfaces.look import Look
from .collision import box_part
from .shape import Shape


def keep_still(made: Callable[[Look], Shape]) -> Callable[[Look], Shape]:
    """Return a shape function whose things lie on a thin flat part under most of their length."""

    def make(look: Look) -> Shape:
        thing = made(look)
        points = np.concatenate([part.vertices for part in thing.parts])
        low, high = points.min(0), points.max(0)
        x, y = 0.7 * (high - low)[0], 0.9 * (high - low)[1]
        at = float(low[0] + high[0]) / 2, float(low[1] + high[1]) / 2, float(low[2])
        return replace(thing, parts=(*thing.parts, box_part(float(x), float(y), 0.003, at)))

    return make


def in_sizes(made: Callable[[Look], Shape], spread: float) -> Callable[[Look], Shape]:
    """Return a shape function whose things are larger and smaller by up to ``spread``."""

    def make(look: Look) -> Shape:
        thing = made(look)
        return thing.scale(look.between(1 - spread, 1 + spread))

    return make
