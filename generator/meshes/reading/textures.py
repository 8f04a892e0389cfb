"""The textures of a foreign mesh, each decoded and stored once even if several parts share it."""

from __future__ import annotations

import hashlib
import io
from collections.abc import Hashable

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image

from ...errors import BackendError
from ...pictures import PictureLimits, decode
from .bounds import MOST_BYTES, MOST_TEXELS, MOST_TEXELS_TOGETHER

MOST_TEXTURE = 2048
"""Maximum side of a stored texture, in texels."""

TEXTURE_LIMITS = PictureLimits(
    formats=("PNG", "JPEG", "WEBP", "BMP", "TGA"), max_bytes=MOST_BYTES, max_pixels=MOST_TEXELS,
    cpu_seconds=20.0,
)  # fmt: skip
"""Limits on a single texture."""

Texels = UInt8[np.ndarray, "_ _ 3"]

_LINEAR = np.arange(256) / 255.0


class Pictures:
    """Collects textures; ``kept`` contains each of them once per tint.

    The textures are read-only, so that meshes can share them.
    """

    def __init__(self, what: str, maximum: int = MOST_TEXELS_TOGETHER) -> None:
        """Start empty; ``what`` names the mesh in messages; ``maximum`` limits stored texels."""
        self.kept: list[Texels] = []
        self._what = what
        self._room = maximum
        self._sources: list[object] = []  # kept alive so that their ids stay unique
        self._keys: dict[int, Hashable] = {}
        self._plain: dict[Hashable, Texels] = {}
        self._places: dict[Hashable, int] = {}

    def place(self, image: Image.Image, tint: Float[np.ndarray, "3"]) -> int:
        """Return the index in ``kept`` of a picture with its linear colours multiplied by ``tint``.

        Raises:
            BackendError: the picture cannot be read, or the limit of stored texels is exceeded.
        """
        file = _file(image)
        key = self._key(image if file is None else file)
        at = (key, tint.tobytes())
        if at not in self._places:
            if key not in self._plain:
                self._plain[key] = _small(image) if file is None else self._decode(file)
            plain = self._plain[key]
            self._room -= plain.shape[0] * plain.shape[1]
            if self._room < 0:
                raise BackendError(
                    f"{self._what} uses its textures with too many colour factors. Bake the "
                    "factors into the textures, or use fewer factors."
                )
            self._places[at] = len(self.kept)
            self.kept.append(plain if (tint == 1).all() else _tint(plain, tint))
            self.kept[-1].setflags(write=False)
        return self._places[at]

    def _decode(self, file: bytes) -> Texels:
        what = f"{self._what} has a texture that"
        return decode(file, what, BackendError, TEXTURE_LIMITS, "rgb", MOST_TEXTURE).pixels

    def _key(self, source: Image.Image | bytes) -> Hashable:
        """Return a key that is equal for equal files, and for identical pictures without a file."""
        if id(source) not in self._keys:
            self._sources.append(source)
            self._keys[id(source)] = (
                hashlib.sha256(source).digest() if isinstance(source, bytes) else id(source)
            )
        return self._keys[id(source)]


def to_srgb(light: np.ndarray) -> np.ndarray:
    """Convert linear light in [0, 1] to sRGB."""
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def light(shown: np.ndarray) -> np.ndarray:
    """Convert sRGB colours in [0, 1] to linear light."""
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def _file(image: Image.Image) -> bytes | None:
    """Return the file of a picture that has not been decoded yet, if it is in memory."""
    file = getattr(image, "fp", None)
    return file.getvalue() if isinstance(file, io.BytesIO) else None


def _small(image: Image.Image) -> Texels:
    """Return the colours of a picture in memory, reduced to at most ``MOST_TEXTURE`` per side."""
    from ...pictures.pixels import shrink

    return shrink(image.copy(), MOST_TEXTURE)


def _tint(picture: Texels, tint: Float[np.ndarray, "3"]) -> Texels:
    table = np.round(255 * to_srgb(light(_LINEAR)[:, None] * tint)).astype(np.uint8)
    return np.stack([table[picture[..., c], c] for c in range(3)], axis=-1)
