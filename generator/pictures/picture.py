"""A decoded picture, and the forms in which its pixels are returned."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

if TYPE_CHECKING:
    from jaxtyping import Shaped  # which a child takes as long to import as NumPy

Form = Literal["upright", "rgb", "rgba", "stored"]
"""How pixels are returned: "upright" is sRGB on white, turned by the EXIF orientation; "rgb" and
"rgba" are converted; "stored" are the file's own values, such as palette indices or 16-bit greys.
"""


@dataclass(frozen=True, eq=False)
class DecodedPicture:
    """A decoded picture.

    Attributes:
        pixels: the array, uint8 unless the form is "stored".
        mode: Pillow's name of how the file stores pixels: "RGB", "P", "I;16".
        width: pixels of the file's picture, before it is turned or shrunk.
        height: likewise.
        orientation: its EXIF orientation, 1 if it is upright, has none, or the form is another
            than "upright".
    """

    pixels: Shaped[np.ndarray, "h w *c"]
    mode: str
    width: int
    height: int
    orientation: int = 1
