"""Tight crops: an object alone, its bounds fitted into a square picture."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, UInt8

MARGIN = 0.05
"""Empty border of a tight crop, as a share of its side, so that contours lie inside."""

_SAMPLES = 4  # per pixel and axis


def tight_crop(
    rgba: UInt8[np.ndarray, "h w 4"],
    box: Float[np.ndarray, "4"],
    resolution: int,
    keep_aspect: bool = True,
) -> Float[np.ndarray, "r r 4"]:
    """Fit ``box`` (pixels of ``rgba``) into a square crop of side ``resolution``.

    Args:
        rgba: the picture; what is transparent stays so.
        box: the object's tight bounds.
        resolution: side of the crop, pixels.
        keep_aspect: fit the longer side and pad the other; False stretches both to the crop.

    Returns:
        float32 RGBA in [0, 1], colours multiplied by alpha.
    """
    import cv2

    picture = rgba.astype(np.float32) / 255.0
    picture[..., :3] *= picture[..., 3:]
    side = resolution * _SAMPLES
    span = box[2:] - box[:2]
    if keep_aspect:
        span = np.full(2, span.max())
    scale = side * (1 - 2 * MARGIN) / span
    shift = side / 2 - (box[:2] + box[2:]) / 2 * scale + scale / 2 - 0.5
    matrix = np.column_stack([np.diag(scale), shift])
    large = cv2.warpAffine(picture, matrix, (side, side), flags=cv2.INTER_LINEAR)
    return cv2.resize(large, (resolution, resolution), interpolation=cv2.INTER_AREA)
