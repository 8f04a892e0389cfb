"""What a model found, on its way to a Detection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from jaxtyping import Bool, Float, UInt8

from .tiles import Tile


@dataclass(frozen=True, eq=False)
class BoxDetection:
    """A box (x0, y0, x1, y1) in the picture's pixels, called by a word that was asked for.

    ``score`` is in [0, 1]; ``mask`` is there once it was made.
    """

    label: str
    score: float
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"] = field(default_factory=lambda: np.zeros((0, 0), bool))


class Finder(Protocol):
    """A model that finds things by words."""

    def find(
        self, image: UInt8[np.ndarray, "h w 3"], words: Sequence[str], tiles: Sequence[Tile]
    ) -> list[BoxDetection]:
        """Return what each part of the picture shows of ``words``, but for what its border cuts."""
        ...


class Masker(Protocol):
    """A model that masks the thing in a box."""

    def mask(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        detections: Sequence[BoxDetection],
        tiles: Sequence[Tile],
    ) -> list[BoxDetection]:
        """Return the finds with masks, in their order; without those whose mask is empty."""
        ...
