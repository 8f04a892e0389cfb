"""Commonsense sizes and proportions of objects (Sec. 3.4, Fig. 22)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from tabletop_objects.values import OUTLINE, VECTOR, freeze

from ..errors import InputError


@dataclass(frozen=True, eq=False)
class Proportions:
    """Proportions of an object's upright box, estimated from a picture, with their uncertainty.

    ``logs`` are the natural logarithms of width over length and of height over length, where length
    is the longer horizontal side; ``spread`` is their expected mean absolute error.
    """

    logs: Float[np.ndarray, "2"]
    spread: Float[np.ndarray, "2"]

    def __post_init__(self) -> None:
        freeze(self, logs=(np.float64, (2,)), spread=(np.float64, (2,)))
        if not (np.isfinite(self.logs).all() and (self.spread > 0).all()):
            raise InputError(
                f"Proportions must have finite logs and a positive, finite spread, got {self}."
            )

    @property
    def extent(self) -> Float[np.ndarray, "3"]:
        """The box (length, width, height), scaled to a length of 1."""
        return np.array([1.0, *np.exp(self.logs)])

    def gap(self, extent: Float[np.ndarray, "3"]) -> float:
        """Return the mean deviation of an extent from these proportions, in units of ``spread``."""
        length, width = max(extent[:2]), min(extent[:2])
        off = np.abs(np.log(np.array([width, extent[2]]) / length) - self.logs)
        return float((off / self.spread).mean())


@dataclass(frozen=True, eq=False)
class SizePrior:
    """A commonsense size (Fig. 22): an extent (length, width, height) in metres and a placement.

    ``placement`` is for example "lying flat"; ``axes`` names x, y and z, for example "thickness".
    ``outline`` is the outline of a tabletop seen from above, in metres about the middle of its
    extent, convex and counter-clockwise; None leaves the shape open. ``measured`` means that the
    extent was measured for this object in a depth map, and is not that of its category. ``seen``
    are proportions estimated from the object's appearance; None if there is no estimate.
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
            raise InputError(f"SizePrior.extent must be positive, in metres, got {self.extent}.")
        if self.outline is not None:
            freeze(self, outline=OUTLINE)
