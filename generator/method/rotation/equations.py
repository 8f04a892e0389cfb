"""Eqs. 1 to 4: the loss between an object rendered at some yaw and the picture.

``weight`` is the weight of each pixel; a weight of 1 everywhere gives the paper's equations.
"""

from __future__ import annotations

from functools import reduce
from operator import add
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from .config import RotationConfig

if TYPE_CHECKING:
    from torch import Tensor

_EPSILON = 1e-6


def silhouette_loss(
    soft: Float[Tensor, "b h w"],
    mask: Float[Tensor, "*b h w"],
    weight: Float[Tensor, "*b h w"] | float = 1.0,
) -> Float[Tensor, "b"]:
    """Return Eq. 2: one minus the soft intersection over union of the silhouette and the mask."""
    from ...render.soft import soft_iou

    return 1 - soft_iou(soft, mask, weight)


def edge_loss(
    edges: Float[Tensor, "b h w"],
    distance: Float[Tensor, "*b h w"],
    weight: Float[Tensor, "*b h w"] | float = 1.0,
) -> Float[Tensor, "b"]:
    """Return Eq. 3: the edge-weighted mean of D_S, the distance to the mask's contour."""
    counted = weight * edges
    return (counted * distance).sum((-2, -1)) / (counted.sum((-2, -1)) + _EPSILON)


def appearance_loss(
    rendered: tuple[Float[Tensor, "b _c _h _w"], ...],
    target: tuple[Float[Tensor, "*_t _c _h _w"], ...],
    weight: tuple[Float[Tensor, "*_t _h _w"], ...] | None = None,
) -> Float[Tensor, "b"]:
    """Return Eq. 4: the squared distance between features Phi, averaged over positions and maps.

    The paper prints a sum; the average makes lambda_a independent of the resolution. ``weight`` has
    one map for each feature map.
    """
    squares = [(a - b).square().sum(1) for a, b in zip(rendered, target, strict=True)]
    if weight is not None:
        squares = [s * w for s, w in zip(squares, weight, strict=True)]
    return reduce(add, [s.mean((-2, -1)) for s in squares]) / len(squares)


def rotation_loss(
    silhouette: Float[Tensor, "b"],
    edge: Float[Tensor, "b"],
    appearance: Float[Tensor, "b"],
    config: RotationConfig,
) -> Float[Tensor, "b"]:
    """Return Eq. 1: the weighted sum of the three terms."""
    return config.lambda_s * silhouette + config.lambda_e * edge + config.lambda_a * appearance


def contour_distance(mask: Bool[np.ndarray, "h w"]) -> Float[np.ndarray, "h w"]:
    """Return D_S of Eq. 3: each pixel's distance in pixels to the nearest Canny edge of ``mask``.

    SciPy's distance transform is used because OpenCV's exact one is not reproducible bit for bit.
    """
    import cv2
    from scipy import ndimage

    edges = cv2.Canny(mask.astype(np.uint8) * 255, 100, 200)
    return np.asarray(ndimage.distance_transform_edt(edges == 0), np.float32)
