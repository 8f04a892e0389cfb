"""A decoded picture, and the forms that its pixels can have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

if TYPE_CHECKING:
    from jaxtyping import Shaped  # importing it takes as long as importing NumPy

Form = Literal["upright", "rgb", "rgba", "stored"]
"""Form of the returned pixels: "upright" is sRGB on white, rotated by the EXIF orientation; "rgb"
and "rgba" are pixels converted to that mode; "stored" means the file's own values, such as palette
indices or 16-bit greys."""


@dataclass(frozen=True, eq=False)
class DecodedPicture:
    """A decoded picture.

    Attributes:
        pixels: the array, uint8 unless the form is "stored".
        mode: Pillow mode of the file, such as "RGB", "P" or "I;16".
        width: width of the picture in the file, before rotation or shrinking, pixels.
        height: height of the picture in the file, pixels.
        orientation: EXIF orientation; 1 if the picture is upright or has none, or for forms other
            than "upright".
    """

    pixels: Shaped[np.ndarray, "h w *c"]
    mode: str
    width: int
    height: int
    orientation: int = 1
