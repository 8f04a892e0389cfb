"""Files that people look at, written whole or with a clear error."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from .errors import StorageError
from .mjcf import encode_png


def write_picture(image: UInt8[np.ndarray, "h w c"], path: Path) -> Path:
    """Write an image as PNG, whatever the name's ending, making the folder if it is missing.

    Raises:
        StorageError: the file cannot be written.
    """
    return write_file(encode_png(image), path)


def write_file(content: bytes, path: Path) -> Path:
    """Write a file, making its folder if it is missing.

    Raises:
        StorageError: the file cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        raise StorageError(
            f"{path} cannot be written: {error.strerror or error}. Choose another folder."
        ) from error
    return path
