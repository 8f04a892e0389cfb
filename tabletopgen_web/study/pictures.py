"""Pictures of a study: read within bounds, written as JPEG without anything but pixels."""

from __future__ import annotations

import hashlib
import io
from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from generator.errors import InputError
from generator.io.bounded import read_regular
from generator.method.reference import ReferenceConfig, read_image

ENDINGS = (".png", ".jpg", ".jpeg", ".webp")
"""Of files that are taken for pictures."""

_QUALITY = 90


def read_picture(path: Path) -> UInt8[np.ndarray, "h w 3"]:
    """Read a picture file as a scene's reference is read: upright, sRGB on white, bounded.

    Raises:
        InputError: it is no picture, or out of bounds; the message names it.
    """
    raw = read_regular(path, "The picture", InputError, max_bytes=ReferenceConfig().max_bytes)
    return decode(raw, str(path))


def decode(raw: bytes, what: str) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture's pixels, as ``read_picture`` does.

    Raises:
        InputError: it is no picture, or out of bounds; the message begins with ``what``.
    """
    try:
        return read_image(raw)
    except InputError as error:
        raise InputError(f"{what}: {error}") from error


def digest_of(picture: UInt8[np.ndarray, "h w 3"]) -> str:
    """Return the SHA-256 of a picture's size and pixels: the same for a photo and its copies."""
    size = np.array(picture.shape, "<i8").tobytes()
    return hashlib.sha256(size + np.ascontiguousarray(picture).tobytes()).hexdigest()


def encode(picture: UInt8[np.ndarray, "h w 3"], side: int) -> bytes:
    """Return a picture as JPEG, its longer side at most ``side`` pixels; no metadata."""
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(picture))
    image.thumbnail((side, side), Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=_QUALITY, subsampling=0, optimize=True)
    return buffer.getvalue()
