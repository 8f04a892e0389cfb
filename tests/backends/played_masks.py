"""A prompted model with ground-truth masks, for the contract suite without weights."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from generator.backends.embedded.eye.frames import Frame
from generator.backends.embedded.minisam.network import CELLS, SIDE, Drawn
from generator.geometry import mask_box


class PlayedModel:
    """Returns the true masks of one picture."""

    def __init__(self, masks: Sequence[np.ndarray]) -> None:
        self.masks = [np.asarray(mask, bool) for mask in masks]
        self.asked = 0

    def look(self, image: np.ndarray, frame: Frame | None = None) -> PlayedModel:
        assert image.shape[:2] == self.masks[0].shape
        assert frame is None or frame.side == SIDE
        return self

    def at_point(self, point: np.ndarray) -> Drawn:
        x, y = (int(v) for v in point)
        there = [k for k, mask in enumerate(self.masks) if mask[y, x]]
        return self._draw(min(there, key=lambda k: self.masks[k].sum(), default=-1))

    def in_box(self, box: np.ndarray) -> Drawn:
        def off(k: int) -> float:
            return float(np.abs(mask_box(self.masks[k]) - box).max())

        return self._draw(min(range(len(self.masks)), key=off))

    def spread(self, drawn: Drawn) -> np.ndarray:
        return self.masks[int(drawn.logits[0, 0]) - 100].copy()

    def _draw(self, number: int) -> Drawn:
        self.asked += 1
        logits = np.full((CELLS, CELLS), 9.0)  # the first cell numbers the mask
        logits[0, 0] = 100 + max(number, 0)
        return Drawn(logits, 0.99 if number >= 0 else 0.0)
