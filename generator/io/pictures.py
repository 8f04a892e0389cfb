"""Pictures that people look at, as files."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from .files import write_file
from .png import encode_png


def write_picture(image: UInt8[np.ndarray, "h w c"], path: Path) -> Path:
    """Write an image as PNG, whatever the name's ending, making the folder if it is missing.

    Raises:
        StorageError: the file cannot be written.
    """
    return write_file(encode_png(image), path)
