"""Pictures without a table: plain grounds, noise, patterns, pages, scattered shapes."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Float, UInt8


def nothing(size: int, rng: np.random.Generator) -> UInt8[np.ndarray, "s s 3"]:
    """Draw a square picture without a table, reproducibly from the generator's state."""
    ground = _gradient(size, rng)
    kind = rng.integers(5)
    if kind == 1:
        ground = _noise(size, rng)
    elif kind == 2:
        ground = _pattern(size, rng)
    elif kind == 3:
        _page(ground, rng)
    elif kind == 4:
        _shapes(ground, rng)
    if rng.random() < 0.5:
        ground = cv2.GaussianBlur(ground, (0, 0), rng.uniform(0.5, 4.0))
    return np.clip(ground, 0, 255).astype(np.uint8)


def _color(rng: np.random.Generator) -> list[float]:
    return rng.uniform(0, 255, 3).tolist()


def _gradient(size: int, rng: np.random.Generator) -> Float[np.ndarray, "s s 3"]:
    corners = np.array([_color(rng)] * 4) + rng.normal(0, rng.choice([0, 5, 60]), (4, 3))
    small = corners.reshape(2, 2, 3).astype(np.float32)
    return np.ascontiguousarray(cv2.resize(small, (size, size), interpolation=cv2.INTER_LINEAR))


def _noise(size: int, rng: np.random.Generator) -> Float[np.ndarray, "s s 3"]:
    grid = int(rng.choice([4, 16, 64, size]))
    small = rng.uniform(0, 255, (grid, grid, 3)).astype(np.float32)
    way = int(rng.choice([cv2.INTER_NEAREST, cv2.INTER_CUBIC]))
    return np.ascontiguousarray(cv2.resize(small, (size, size), interpolation=way))


def _pattern(size: int, rng: np.random.Generator) -> Float[np.ndarray, "s s 3"]:
    y, x = np.mgrid[0:size, 0:size] // int(rng.integers(6, 50))
    which = [(x + y) % 2, x % 2, (x * y) % 3 == 0][int(rng.integers(3))]
    pair = np.array([_color(rng), _color(rng)], np.float32)
    return np.ascontiguousarray(pair[np.asarray(which, int)])


def _page(ground: Float[np.ndarray, "s s 3"], rng: np.random.Generator) -> None:
    """Draw what a screen or a page shows: bars, blocks and lines of text."""
    size = len(ground)
    ink, bar = _color(rng), _color(rng)
    cv2.rectangle(ground, (0, 0), (size, int(rng.integers(5, 40))), bar, -1)
    for y in range(45, size, int(rng.integers(8, 20))):
        x = int(rng.integers(4, 40))
        while x < size * rng.uniform(0.5, 1.0):
            word = int(rng.integers(4, 30))
            cv2.rectangle(ground, (x, y), (x + word, y + 4), ink, -1)
            x += word + 5
    for _ in range(int(rng.integers(4))):
        x, y = (int(v) for v in rng.integers(0, size, 2))
        cv2.rectangle(ground, (x, y), (x + size // 4, y + size // 5), _color(rng), -1)


def _shapes(ground: Float[np.ndarray, "s s 3"], rng: np.random.Generator) -> None:
    """Scatter blobs and elliptical surfaces that stand on nothing."""
    size = len(ground)
    for _ in range(int(rng.integers(1, 14))):
        middle = tuple(int(v) for v in rng.integers(0, size, 2))
        axes = tuple(int(v) for v in rng.integers(size // 40 + 1, size // 3, 2))
        turn = float(rng.uniform(0, 180))
        cv2.ellipse(ground, middle, axes, turn, 0, 360, _color(rng), -1)
        if rng.random() < 0.4:
            for side in (-1, 1):
                eye = (middle[0] + side * axes[0] // 3, middle[1] - axes[1] // 4)
                cv2.circle(ground, eye, max(axes[0] // 8, 1), _color(rng), -1)
