"""Fits of a shape's projection to a mask: scale and shift, optimisation, and proportions."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import cv2
import numpy as np
from jaxtyping import Float
from scipy.optimize import minimize

from ....geometry import mask_box, proportion_gap
from ....meshes.pixels import Mask
from ....meshes.projection import Projection
from ....scene import Instance


def _image_box(pixels: Float[np.ndarray, "n 2"]) -> tuple[np.ndarray, np.ndarray]:
    low, high = pixels.min(0), pixels.max(0)
    return (low + high) / 2, high - low


def frame_to_mask(
    vertices: Float[np.ndarray, "n 3"], projection: Projection, mask: Mask
) -> tuple[float, Float[np.ndarray, "3"]]:
    """Return the scale and shift for which a shape's projection best fills a mask's bounding box.

    The shift is parallel to the image plane; the scale makes the areas of the boxes equal.
    """
    wanted, size = _image_box(mask_box(mask).reshape(2, 2))
    scale = float(np.sqrt(mask.sum())) / max(float(np.ptp(vertices, axis=0).max()), 1e-9)
    shift = np.zeros(3)
    for _ in range(4):
        center, have = _image_box(projection.project(vertices * scale + shift))
        scale *= float(np.sqrt(np.prod(size) / max(np.prod(have), 1e-9)))
        center, have = _image_box(projection.project(vertices * scale + shift))
        depth = float(np.linalg.norm(projection.position)) / projection.focal
        step = (wanted - center) * depth
        shift = shift + step[0] * projection.rotation[0] + step[1] * projection.rotation[1]
    return scale, shift


def small_mask(instance: Instance, small: Projection) -> Mask:
    """Return the crop's silhouette at the resolution of ``small``."""
    size = small.width, small.height
    return cv2.resize(instance.crop[..., 3], size, interpolation=cv2.INTER_AREA) > 127


def descend(
    cost: Callable[[np.ndarray], float],
    start: np.ndarray,
    steps: Sequence[float] | np.ndarray,
    tries: int,
    near: float = 1e-4,
) -> np.ndarray:
    """Minimise ``cost`` by Nelder-Mead, with at most ``tries`` evaluations and tolerance ``near``.

    The initial simplex has one step along each axis.
    """
    simplex = np.concatenate([start[None], start + np.diag(steps)])
    options = {"initial_simplex": simplex, "maxfev": tries, "xatol": near}
    return np.asarray(minimize(cost, start, method="Nelder-Mead", options=options).x)


def bounded_gap(a: Float[np.ndarray, "3"], b: Float[np.ndarray, "3"]) -> float:
    """Return the ``proportion_gap`` of two extents, limited to at most 1.5."""
    return min(proportion_gap(a, b), 1.5)
