"""Tight crops: square pictures of one object, fitted to its bounds."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool, Float, UInt8

from ..errors import InputError
from ..geometry import mask_box
from ..scene import Instance

MARGIN = 0.05
"""Width of the empty border around the object in a tight crop, as a fraction of the crop's side."""

_SAMPLES = 4  # samples per pixel along each axis


def tight_crop(
    rgba: UInt8[np.ndarray, "h w 4"],
    box: Float[np.ndarray, "4"],
    resolution: int,
    keep_aspect: bool = True,
) -> Float[np.ndarray, "r r 4"]:
    """Fit ``box``, the object's tight bounds in pixels of ``rgba``, into a square crop.

    Returns float32 RGBA in [0, 1] of side ``resolution``, with colours premultiplied by alpha. With
    ``keep_aspect``, the longer side is fitted and the shorter one is padded; otherwise both are
    stretched.
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


def tight_box(instance: Instance) -> Float[np.ndarray, "4"]:
    """Return the bounds of the visible object in an instance's crop, in pixels of the crop.

    Raises:
        InputError: The crop is fully transparent.
    """
    alpha = instance.crop[..., 3] > 127
    if not alpha.any():
        raise InputError(f"Instance {instance.name!r} has a fully transparent crop.")
    return mask_box(alpha)


def in_reference(instance: Instance, box: Float[np.ndarray, "4"]) -> Float[np.ndarray, "4"]:
    """Convert a box from pixels of an instance's crop to pixels of the reference image."""
    low, high = instance.crop_box[:2], instance.crop_box[2:]
    height, width = instance.crop.shape[:2]
    pixel = (high - low) / np.array([width, height])
    return np.concatenate([low + box[:2] * pixel, low + box[2:] * pixel])


def mask_in_crop(mask: Bool[np.ndarray, "h w"], instance: Instance) -> UInt8[np.ndarray, "ch cw 4"]:
    """Crop a mask of the reference image to an instance; return RGBA with the mask as alpha."""
    import cv2

    height, width = instance.crop.shape[:2]
    low, high = instance.crop_box[:2], instance.crop_box[2:]
    scale = np.array([width, height]) / (high - low)
    matrix = np.column_stack([np.diag(scale), -low * scale + scale / 2 - 0.5])
    alpha = cv2.warpAffine(
        mask.astype(np.uint8) * 255, matrix, (width, height), flags=cv2.INTER_LINEAR
    )
    return np.repeat(alpha[..., None], 4, axis=2)


def hiders(instance: Instance, things: Sequence[Instance]) -> Bool[np.ndarray, "h w"] | None:
    """Return the mask of other objects that may occlude an instance, or None if there are none."""
    if not instance.occluded:
        return None
    others = [np.asarray(t.mask) for t in things if t.name != instance.name]
    return np.logical_or.reduce(others) if others else None
