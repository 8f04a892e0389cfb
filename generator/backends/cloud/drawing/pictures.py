"""Safe decoding of pictures from image models, and separation of objects from backgrounds."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from numpy.typing import ArrayLike

from ....errors import UnusableError
from ....meshes.pixels import main_parts
from ....pictures import PictureLimits, decode
from ..server.json_text import Wrong

LIMITS = PictureLimits(
    formats=("PNG", "JPEG", "WEBP"), max_bytes=128 * 2**20, max_pixels=40_000_000, min_side=64
)
"""Limits on the picture in an answer."""

_NEAR = 30  # grey levels by which a flat background may vary
_FLAT = 0.7  # minimum fraction of the picture's border that a flat background fills
_LEAST, _MOST = 0.004, 0.97  # fraction of the picture that an object drawn alone may fill

RGBA = UInt8[np.ndarray, "_ _ 4"]


def decode_answer(data: bytes) -> RGBA:
    """Decode the picture of an answer in a child process.

    Raises:
        UnusableError: it is not a PNG, JPEG or WebP, is damaged, or exceeds a limit.
    """
    if data.lstrip()[:1] == b"<":
        raise UnusableError(f"the picture is HTML ({len(data)} bytes).")
    return decode(data, "the picture", UnusableError, LIMITS, "rgba").pixels


def on_white(picture: RGBA) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture composited on white."""
    alpha = picture[..., 3:].astype(np.float32) / 255
    return np.round(picture[..., :3] * alpha + 255 * (1 - alpha)).astype(np.uint8)


def shrink(picture: UInt8[np.ndarray, "h w c"], maximum: int) -> UInt8[np.ndarray, "a b c"]:
    """Return a picture scaled down to at most ``maximum`` pixels per side."""
    height, width = picture.shape[:2]
    factor = maximum / max(width, height)
    if factor >= 1:
        return picture
    size = max(1, round(width * factor)), max(1, round(height * factor))
    return cv2.resize(picture, size, interpolation=cv2.INTER_AREA)


def pad(
    picture: UInt8[np.ndarray, "h w 3"], minimum: float, maximum: float
) -> UInt8[np.ndarray, "a b 3"]:
    """Return a picture padded with white until its aspect ratio is within limits."""
    height, width = picture.shape[:2]
    across = max(width, int(np.ceil(height * minimum)))
    down = max(height, int(np.ceil(width / maximum)))
    x, y = (across - width) // 2, (down - height) // 2
    canvas = np.full((down, across, 3), 255, np.uint8)
    canvas[y : y + height, x : x + width] = picture
    return canvas


def thing_in(picture: RGBA) -> Bool[np.ndarray, "h w"]:
    """Return the mask of an object drawn alone on a transparent or flat background.

    Raises:
        Wrong: the background is not flat, or the object fills too little or too much of it.
    """
    alpha = picture[..., 3]
    clear = _border(alpha < 128).mean()
    mask = alpha > 127 if clear > _FLAT else ~_flat_ground(picture[..., :3])
    mask = main_parts(mask, 0.02)
    share = float(mask.mean())
    if not _LEAST <= share <= _MOST:
        raise Wrong(f"the object fills {share:.1%} of the picture; draw it as large as it was.")
    return mask


def apart(colors: UInt8[np.ndarray, "*n 3"], color: ArrayLike) -> Float[np.ndarray, "*n"]:
    """Return each colour's largest channel difference from ``color``, in grey levels."""
    off = np.abs(colors.astype(np.float32) - np.asarray(color, np.float32))
    return np.maximum(np.maximum(off[..., 0], off[..., 1]), off[..., 2])


def _border(picture: np.ndarray) -> np.ndarray:
    return np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])


def _flat_ground(picture: UInt8[np.ndarray, "h w 3"]) -> Bool[np.ndarray, "h w"]:
    """Return the region of the border's flat colour that is connected to the border."""
    border = _border(picture)
    usual = np.median(border, axis=0)
    if (apart(border, usual) <= _NEAR).mean() < _FLAT:
        raise Wrong("the background must be one flat colour up to the edges of the picture.")
    near = (apart(picture, usual) <= _NEAR).astype(np.uint8)
    count, found = cv2.connectedComponents(near, connectivity=4)
    numbers = np.asarray(found, np.intp)
    reached = np.zeros(count, bool)
    reached[_border(numbers)] = True
    reached[0] = False  # the label of the pixels with other colours
    return reached[numbers]
