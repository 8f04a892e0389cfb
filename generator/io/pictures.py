"""Encoding of images as PNG, and writing of PNG files."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from jaxtyping import Shaped, UInt8

from .files import write_file


def write_picture(image: UInt8[np.ndarray, "h w c"], path: Path) -> Path:
    """Write an image as PNG regardless of the file name's suffix; create the folder if necessary.

    Raises:
        StorageError: the file cannot be written.
    """
    return write_file(encode_png(image), path)


def encode_png(image: Shaped[np.ndarray, "h w *c"]) -> bytes:
    """Encode an image as PNG; the same pixels always give the same bytes."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(image)).save(buffer, "PNG", compress_level=6)
    return buffer.getvalue()
