"""Commonsense sizes and proportions of objects (Sec. 3.4, Fig. 22)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from tabletop_objects.values import OUTLINE, VECTOR, freeze

from ..errors import InputError


@dataclass(frozen=True, eq=False)
class Proportions:
    """The shape of a thing's upright box, as its look suggests, and how sure that is.

    ``logs`` are the natural logarithms of width over length and of height over length, the length
    being the longer horizontal side; ``spread`` is the mean absolute error to expect of each.
    """

    logs: Float[np.ndarray, "2"]
    spread: Float[np.ndarray, "2"]

    def __post_init__(self) -> None:
        freeze(self, logs=(np.float64, (2,)), spread=(np.float64, (2,)))
        if not (np.isfinite(self.logs).all() and (self.spread > 0).all()):
            raise InputError(f"Proportions must be finite and spread, got {self}.")

    @property
    def extent(self) -> Float[np.ndarray, "3"]:
        """The box (length, width, height) with a length of 1."""
        return np.array([1.0, *np.exp(self.logs)])

    def gap(self, extent: Float[np.ndarray, "3"]) -> float:
        """Return how far an extent's proportions are off, in expected errors, the mean of both."""
        length, width = max(extent[:2]), min(extent[:2])
        off = np.abs(np.log(np.array([width, extent[2]]) / length) - self.logs)
        return float((off / self.spread).mean())


@dataclass(frozen=True, eq=False)
class SizePrior:
    """A commonsense size (Fig. 22): extent (length, width, height) in metres, and its state.

    ``placement`` is e.g. "lying flat"; ``axes`` says what x, y and z are, e.g. "thickness".
    ``outline`` is a table's top seen from above, in metres about the middle of its extent, convex
    and counter-clockwise; None leaves its shape open.
    ``measured`` says that the extent is this very thing's, read from a depth map, not its kind's.
    ``seen`` are the proportions that this very thing looks to have; None where nobody looked.
    """

    name: str
    extent: Float[np.ndarray, "3"]
    placement: str = "as shown"
    axes: tuple[str, str, str] = ("length", "width", "height")
    outline: Float[np.ndarray, "k 2"] | None = None
    measured: bool = False
    seen: Proportions | None = None

    def __post_init__(self) -> None:
        freeze(self, extent=VECTOR)
        if (self.extent <= 0).any():
            raise InputError(f"SizePrior.extent must be positive metres, got {self.extent}.")
        if self.outline is not None:
            freeze(self, outline=OUTLINE)
