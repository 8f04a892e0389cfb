"""The picture of one instance as input for image-to-3D models: isolated, centred and square."""

from __future__ import annotations

import numpy as np
from jaxtyping import UInt8
from PIL import Image

from ...errors import BackendError
from ...geometry import mask_box
from ...scene import Instance

_SHARE = 0.85  # fraction of the square's side that the object fills
_LEAST, _MOST = 256, 1024  # minimum and maximum side of the square in pixels

Cutout = UInt8[np.ndarray, "_ _ 4"]


def cutout(instance: Instance, backend: str) -> Cutout:
    """Return an instance's crop as a square of 256 to 1024 pixels, with transparent surroundings.

    Raises:
        BackendError: the crop is empty.
    """
    crop = instance.crop
    if not (crop[..., 3] > 127).any():
        raise BackendError(f"{backend}, model of {instance.name!r}: the crop is fully transparent.")
    x0, y0, x1, y1 = mask_box(crop[..., 3] > 0).astype(int)
    thing = np.where(crop[..., 3:] > 0, crop, 0).astype(np.uint8)[y0:y1, x0:x1]
    side = int(np.ceil(max(thing.shape[:2]) / _SHARE))
    square = np.zeros((side, side, 4), np.uint8)
    top, left = (side - thing.shape[0]) // 2, (side - thing.shape[1]) // 2
    square[top : top + thing.shape[0], left : left + thing.shape[1]] = thing
    wanted = int(np.clip(side, _LEAST, _MOST))
    if wanted == side:
        return square
    resized = Image.fromarray(square).resize((wanted, wanted), Image.Resampling.LANCZOS)
    return np.asarray(resized, np.uint8)


def on_grey(picture: Cutout) -> UInt8[np.ndarray, "s s 3"]:
    """Return a cut-out composited on middle grey."""
    share = picture[..., 3:] / 255.0
    return np.round(picture[..., :3] * share + 127.5 * (1 - share)).astype(np.uint8)
