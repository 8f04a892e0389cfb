"""Pictures of a study, read within limits and written as JPEG without metadata."""

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
"""File suffixes of pictures."""

_QUALITY = 90


def read_picture(path: Path) -> UInt8[np.ndarray, "h w 3"]:
    """Read a picture file with the limits and format of reference images: upright, sRGB on white.

    Raises:
        InputError: the file is not a picture, or exceeds a limit; the message names the file.
    """
    raw = read_regular(path, "The picture", InputError, max_bytes=ReferenceConfig().max_bytes)
    return decode(raw, str(path))


def decode(raw: bytes, what: str) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture's pixels, as ``read_picture`` does.

    Raises:
        InputError: the data is not a picture, or exceeds a limit; the message begins with ``what``.
    """
    try:
        return read_image(raw)
    except InputError as error:
        raise InputError(f"{what}: {error}") from error


def digest_of(picture: UInt8[np.ndarray, "h w 3"]) -> str:
    """Return the SHA-256 of a picture's size and pixels; it is equal for copies of a photo."""
    size = np.array(picture.shape, "<i8").tobytes()
    return hashlib.sha256(size + np.ascontiguousarray(picture).tobytes()).hexdigest()


def encode(picture: UInt8[np.ndarray, "h w 3"], side: int) -> bytes:
    """Return a picture as JPEG without metadata; its longer side is at most ``side`` pixels."""
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(picture))
    image.thumbnail((side, side), Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=_QUALITY, subsampling=0, optimize=True)
    return buffer.getvalue()
