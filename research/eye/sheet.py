"""A contact sheet of samples: each picture next to its masks."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence

import cv2
import numpy as np
from jaxtyping import UInt8

from generator.render.sheet import grid

from .sample import TABLE_REST, TOP, Sample


def overlay(sample: Sample) -> UInt8[np.ndarray, "h w 3"]:
    """Return the picture with coloured top, table and instances, and outlined whole masks."""
    picture = sample.image.astype(np.float32) * 0.45
    paint = np.zeros_like(picture)
    paint[sample.region == TOP] = (60, 90, 140)
    paint[sample.region == TABLE_REST] = (110, 60, 40)
    for k in range(len(sample.full)):
        paint[sample.visible == k + 1] = _color(k)
    out = np.clip(picture + 0.55 * paint, 0, 255).astype(np.uint8)
    for k, mask in enumerate(sample.full):
        lines, _ = cv2.findContours(
            mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE
        )
        cv2.drawContours(out, lines, -1, _color(k), 1)
    if len(sample.outline):
        corners = np.clip(sample.outline, -5000, 5000).round().astype(np.int32)
        cv2.polylines(out, [corners], True, (255, 255, 255), 1, cv2.LINE_AA)
    return out


def contact_sheet(samples: Sequence[Sample], cell: int = 256) -> UInt8[np.ndarray, "h w 3"]:
    """Return pictures and overlays side by side, three pairs per row."""
    cells = [picture for s in samples for picture in (s.image, overlay(s))]
    return grid(cells, columns=6, cell=cell)


def _color(k: int) -> tuple[int, int, int]:
    r, g, b = colorsys.hsv_to_rgb(k * 0.381966 % 1, 0.75, 1)
    return int(255 * r), int(255 * g), int(255 * b)
