"""Pictures as PNG: what bundles hold and what servers are sent."""

from __future__ import annotations

import io

import numpy as np
from jaxtyping import Shaped


def encode_png(image: Shaped[np.ndarray, "h w *c"]) -> bytes:
    """Return an image as PNG, the same bytes for the same pixels."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(image)).save(buffer, "PNG", compress_level=6)
    return buffer.getvalue()
