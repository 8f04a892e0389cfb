"""Perturbations of a case's input: camera, mask, light, blur, size; by stated amounts."""

from __future__ import annotations

from dataclasses import dataclass, fields

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from generator.errors import InputError

HOLE = 0.015
"""Area of one hole, as a share of the mask."""

Mask = Bool[np.ndarray, "h w"]


@dataclass(frozen=True)
class Spoiling:
    """Perturbations of the input; every amount is the maximum of a uniform distribution.

    Attributes:
        elevation, azimuth: error of the camera's angles, degrees, in both directions.
        erode: pixels removed around the mask (exactly this many).
        holes: number of round holes in the mask (exactly this many), each with ``HOLE`` of its
            area.
        occlude: share of the object that an occluder hides, in [0, 0.9].
        light: variation of the sun's strength between cases.
        tint: deviation of the light's colour from white, per channel, in [0, 1).
        blur: standard deviation of the picture's blur, pixels (exactly this value).
        size_error: error of the size prior, per axis and overall, as a share in [0, 0.9].
    """

    elevation: float = 0.0
    azimuth: float = 0.0
    erode: int = 0
    holes: int = 0
    occlude: float = 0.0
    light: float = 0.3
    tint: float = 0.1
    blur: float = 0.0
    size_error: float = 0.0

    def __post_init__(self) -> None:
        values = {f.name: getattr(self, f.name) for f in fields(self)}
        most = {"elevation": 25, "azimuth": 180, "occlude": 0.9, "tint": 0.95, "size_error": 0.9,
                "light": 0.6, "erode": 100, "holes": 40, "blur": 50}  # fmt: skip
        for name, value in values.items():
            if not 0 <= value <= most[name]:
                raise InputError(f"{name} must be in [0, {most[name]}], got {value}.")

    def label(self) -> str:
        """Return the differences from the defaults, as part of a file name."""
        changed = [f for f in fields(self) if getattr(self, f.name) != f.default]
        return "".join(f"_{f.name}{getattr(self, f.name):g}" for f in changed)


def erode(mask: Mask, pixels: int) -> Mask:
    """Return a mask without its outer ``pixels``."""
    if pixels <= 0:
        return mask
    brush = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * pixels + 1, 2 * pixels + 1))
    return cv2.erode(mask.astype(np.uint8), brush, borderValue=0) > 0


def punch(mask: Mask, holes: int, rng: np.random.Generator) -> Mask:
    """Return a mask with round holes of ``HOLE`` of its area each; they may touch or leave it."""
    out = mask.copy()
    ys, xs = np.nonzero(mask)
    if not len(xs):
        return out
    radius = float(np.sqrt(HOLE * len(xs) / np.pi))
    rows, columns = np.ogrid[: mask.shape[0], : mask.shape[1]]
    for k in rng.integers(len(xs), size=holes):
        out &= np.hypot(rows - ys[k], columns - xs[k]) > radius
    return out


def occluder(mask: Mask, share: float, rng: np.random.Generator) -> Mask:
    """Return a disc that hides ``share`` of a mask, mostly from below like an occluder in front."""
    if not 0 <= share < 1:
        raise InputError(f"The share to hide must be in [0, 1), got {share}.")
    if share == 0 or not mask.any():
        return np.zeros_like(mask)
    ys, xs = np.nonzero(mask)
    reach = float(np.hypot(np.ptp(ys) + 1, np.ptp(xs) + 1))
    angle = np.pi / 2 + rng.normal(0, 0.9)
    y = ys.mean() + reach * np.sin(angle)
    x = xs.mean() + reach * np.cos(angle)
    apart = np.sort(np.hypot(ys - y, xs - x))
    radius = float(apart[min(round(share * len(apart)), len(apart) - 1)])
    rows, columns = np.ogrid[: mask.shape[0], : mask.shape[1]]
    return np.hypot(rows - y, columns - x) < radius


def blur(image: UInt8[np.ndarray, "h w 3"], sigma: float) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture blurred by a Gaussian of ``sigma`` pixels."""
    return image if sigma <= 0 else cv2.GaussianBlur(image, (0, 0), sigma)


def wrong_size(
    size: Float[np.ndarray, "3"], error: float, rng: np.random.Generator
) -> Float[np.ndarray, "3"]:
    """Return a size with an error of up to ``error`` along each axis and once more overall."""
    return size * (1 + rng.uniform(-error, error, 3)) * (1 + rng.uniform(-error, error))
