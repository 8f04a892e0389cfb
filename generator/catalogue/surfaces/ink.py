"""Drawing on texture tiles: rectangles, discs, letters, small print. Fractions of the picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import UInt8

from .colors import RGB

Canvas = UInt8[np.ndarray, "_ _ 3"]


def canvas(width: int, height: int, color: RGB) -> Canvas:
    """Return a blank picture to draw on."""
    return np.broadcast_to(np.array(color).round().astype(np.uint8), (height, width, 3)).copy()


def fill(image: Canvas, x: float, y: float, width: float, height: float, color: RGB) -> None:
    """Fill a rectangle given in fractions of the picture, (x, y) its upper left corner."""
    h, w = image.shape[:2]
    rows = slice(max(round(y * h), 0), max(round((y + height) * h), round(y * h) + 1))
    columns = slice(max(round(x * w), 0), max(round((x + width) * w), round(x * w) + 1))
    image[rows, columns] = np.array(color).round().astype(np.uint8)


def disc(image: Canvas, x: float, y: float, radius: float, color: RGB, inner: float = 0.0) -> None:
    """Fill a disc, or a ring from ``inner``, in fractions of the picture's height."""
    h, w = image.shape[:2]
    rows, columns = np.mgrid[0:h, 0:w] + 0.5
    away = np.hypot(columns - x * w, rows - y * h) / h
    image[(away <= radius) & (away >= inner)] = np.array(color).round().astype(np.uint8)


def write(
    image: Canvas, text: str, x: float, y: float, height: float, color: RGB, bold: bool = False
) -> None:
    """Write ``text`` centred at (x, y), ``height`` tall, shrunk to fit the picture's width."""
    import cv2

    h, w = image.shape[:2]
    scale = height * h / 22.0
    thickness = 2 if bold else 1
    font = cv2.FONT_HERSHEY_SIMPLEX
    (width, tall), _ = cv2.getTextSize(text, font, scale, thickness)
    if width > 0.92 * w:
        scale *= 0.92 * w / width
        (width, tall), _ = cv2.getTextSize(text, font, scale, thickness)
    corner = (round(x * w - width / 2), round(y * h + tall / 2))
    ink = tuple(float(c) for c in color)
    cv2.putText(image, text, corner, font, scale, ink, thickness, cv2.LINE_AA)


def lines(
    image: Canvas,
    rng: np.random.Generator,
    box: tuple[float, float, float, float],
    count: int,
    color: RGB,
    weight: float = 0.4,
) -> None:
    """Draw ``count`` lines of small print as bars within box (x, y, width, height)."""
    x, y, width, height = box
    for k in range(count):
        long = width * (rng.uniform(0.75, 1.0) if k % 5 < 4 else rng.uniform(0.3, 0.6))
        fill(image, x, y + height * k / count, long, height * weight / count, color)


def barcode(image: Canvas, rng: np.random.Generator, x: float, y: float, width: float) -> None:
    """Draw a barcode, a third as tall as it is wide."""
    tall = width / 3 * image.shape[1] / image.shape[0]
    fill(image, x, y, width, tall, (250, 250, 250))
    at = x + 0.06 * width
    while at < x + 0.9 * width:
        step = width * rng.uniform(0.02, 0.05)
        fill(image, at, y + 0.1 * tall, step * 0.6, 0.8 * tall, (20, 20, 20))
        at += step + width * 0.015


def polygon(image: Canvas, points: Sequence[tuple[float, float]], color: RGB) -> None:
    """Fill a polygon given by its corners in fractions of the picture."""
    import cv2

    h, w = image.shape[:2]
    corners = np.round(np.array(points) * [w, h]).astype(np.int32)
    cv2.fillPoly(image, [corners], tuple(float(c) for c in color), cv2.LINE_AA)


def stroke(image: Canvas, points: Sequence[tuple[float, float]], width: float, color: RGB) -> None:
    """Draw a line through points, ``width`` a fraction of the picture's height."""
    import cv2

    h, w = image.shape[:2]
    corners = np.round(np.array(points) * [w, h]).astype(np.int32)
    thick = max(1, round(width * h))
    cv2.polylines(image, [corners], False, tuple(float(c) for c in color), thick, cv2.LINE_AA)
