"""Procedural pictures: floors, walls, cloths, prints, and clutter that looks like a photograph."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Float, UInt8

from tabletop_objects.kit import surfaces
from tabletop_objects.kit.surfaces import COLORS, WOODS, tint_color

Picture = UInt8[np.ndarray, "h w 3"]


def any_color(rng: np.random.Generator) -> tuple[float, float, float]:
    """Return a named colour, or any colour."""
    if rng.random() < 0.5:
        return COLORS[str(rng.choice(sorted(COLORS)))]
    r, g, b = rng.uniform(10, 245, 3)
    return float(r), float(g), float(b)


def muted_color(rng: np.random.Generator) -> tuple[float, float, float]:
    """Return a colour typical of rooms: mostly greyish, from dark to light."""
    grey, color = rng.uniform(30, 240), np.array(any_color(rng))
    r, g, b = grey + (color - color.mean()) * rng.beta(1.0, 3.0)
    return float(np.clip(r, 4, 252)), float(np.clip(g, 4, 252)), float(np.clip(b, 4, 252))


def surface(rng: np.random.Generator) -> Picture:
    """Return a floor or wall: boards, tiles, carpet, plaster, stone."""
    kind = int(rng.integers(6))
    if kind == 0:
        wood = WOODS[str(rng.choice(sorted(WOODS)))]
        return surfaces.wood(rng, wood, side=256, planks=int(rng.integers(3, 8)))
    if kind == 1:
        ground = muted_color(rng)
        return surfaces.grid(tint_color(ground, 0.75), ground, 4, 4, 128, int(rng.integers(1, 4)))
    if kind == 2:
        return carpet(rng)
    if kind == 3:
        return stone(rng)
    color = tint_color(muted_color(rng), 1.5) if kind == 4 else muted_color(rng)
    return surfaces.speckles(rng, color, float(rng.uniform(2, 14)), 128)


def stone(rng: np.random.Generator) -> Picture:
    """Return veined stone, from faint grey veins in white to strong ones of any colour."""
    if rng.random() < 0.4:
        return surfaces.marble(rng, (225, 222, 216), (150, 145, 140), 128)
    ground = muted_color(rng) if rng.random() < 0.5 else tint_color(muted_color(rng), 1.6)
    return surfaces.marble(rng, ground, muted_color(rng), 128)


def carpet(rng: np.random.Generator) -> Picture:
    """Return a carpet of many thin strokes of related colours."""
    side = 128
    base = np.array(muted_color(rng)) * rng.uniform(0.4, 1)
    strokes = rng.normal(0, 1, (side, side // 8)).repeat(8, 1)
    image = base + strokes[..., None] * rng.uniform(3, 22) + rng.normal(0, 6, (side, side, 1))
    return np.clip(image, 0, 255).astype(np.uint8)


def cloth(rng: np.random.Generator) -> Picture:
    """Return a tablecloth or placemat."""
    kind = int(rng.integers(4))
    if kind == 0:
        return surfaces.fabric(rng, any_color(rng), any_color(rng))
    if kind == 1:
        return surfaces.fabric(rng, any_color(rng))
    if kind == 2:
        return surfaces.basketwork(rng, any_color(rng))
    return surfaces.stripes([any_color(rng), any_color(rng)], int(rng.integers(2, 9)))


def clutter(rng: np.random.Generator, side: int = 256, shapes: int = 60) -> Picture:
    """Return noise and random shapes at every scale, like a busy photograph out of focus."""
    vivid = rng.random() ** 2
    small = rng.uniform(0, 255, (int(rng.integers(2, 9)), int(rng.integers(2, 9)), 1))
    small = small + rng.normal(0, 40, (*small.shape[:2], 3))
    image = cv2.resize(small.astype(np.float32), (side, side), interpolation=cv2.INTER_CUBIC)
    image = np.clip(image * 0.6 + np.array(muted_color(rng)) * 0.4, 0, 255).astype(np.uint8)
    for k in range(int(rng.integers(shapes // 4, shapes))):
        color = any_color(rng) if rng.random() < vivid else muted_color(rng)
        scale = side * float(rng.uniform(0.02, 0.25))
        at = rng.uniform(0, side, 2)
        angle, aspect = float(rng.uniform(0, 180)), float(rng.uniform(0.1, 1))
        if k % 3 == 0:
            axes = (max(1, int(scale)), max(1, int(scale * aspect)))
            middle = (int(at[0]), int(at[1]))
            cv2.ellipse(image, middle, axes, angle, 0, 360, color, -1, cv2.LINE_AA)
        else:
            box = ((float(at[0]), float(at[1])), (2 * scale, 2 * scale * aspect), angle)
            cv2.fillPoly(image, [cv2.boxPoints(box).astype(np.int32)], color, cv2.LINE_AA)
    image = image + rng.normal(0, rng.uniform(1, 14), image.shape)
    return np.clip(image, 0, 255).astype(np.uint8)


def gradient(rng: np.random.Generator, side: int = 512) -> Picture:
    """Return a studio background: a gradient of two shades, upwards or outwards."""
    first = np.array(tint_color(any_color(rng), 1.6) if rng.random() < 0.4 else muted_color(rng))
    second = np.clip(first * rng.uniform(0.4, 1.25), 0, 255)
    y, x = np.mgrid[0 : 1 : side * 1j, 0 : 1 : side * 1j]
    if rng.random() < 0.5:
        t: Float[np.ndarray, "h w"] = y
    else:
        t = np.clip(np.hypot(x - 0.5, y - rng.uniform(0.3, 0.7)) * 1.3, 0, 1)
    t = t ** rng.uniform(0.6, 2)
    image = first + (second - first) * t[..., None] + rng.normal(0, 1, (side, side, 1))
    return np.clip(image, 0, 255).astype(np.uint8)


def blurred_clutter(rng: np.random.Generator, side: int = 512) -> Picture:
    """Return clutter as a background, from sharp to strongly out of focus."""
    image = cv2.resize(clutter(rng, 256, 90), (side, side), interpolation=cv2.INTER_LINEAR)
    sigma = float(rng.uniform(0.3, 14))
    return cv2.GaussianBlur(image, (0, 0), sigma)
