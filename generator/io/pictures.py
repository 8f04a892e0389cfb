"""Encode pictures as files: PNG for bundles and servers, PNG or JPEG for people."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from jaxtyping import Shaped, UInt8

from .files import write_file


def write_picture(image: UInt8[np.ndarray, "h w c"], path: Path) -> Path:
    """Write an image as PNG, whatever the name's ending, making the folder if it is missing.

    Raises:
        StorageError: the file cannot be written.
    """
    return write_file(encode_png(image), path)


def encode_png(image: Shaped[np.ndarray, "h w *c"]) -> bytes:
    """Return an image as PNG, the same bytes for the same pixels."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(image)).save(buffer, "PNG", compress_level=6)
    return buffer.getvalue()
