"""Decoding of a picture's pixels with Pillow, in the sandbox child (see ``decoder``)."""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np
from PIL import (
    BmpImagePlugin,
    GifImagePlugin,
    Image,
    ImageOps,
    JpegImagePlugin,
    PngImagePlugin,
    TgaImagePlugin,
    TiffImagePlugin,
    UnidentifiedImageError,
    WebPImagePlugin,
)

from ..errors import InputError, TabletopError
from .limits import PictureLimits, damage, read_header
from .picture import DecodedPicture, Form

if TYPE_CHECKING:
    from jaxtyping import UInt8

PLUGINS = (
    BmpImagePlugin, GifImagePlugin, JpegImagePlugin, PngImagePlugin, TgaImagePlugin,
    TiffImagePlugin, WebPImagePlugin,
)  # fmt: skip
"""Pillow plugins for the supported formats, loaded before a child sets its limits."""

_ORIENTATION = 0x0112  # EXIF tag


def decode_pixels(
    raw: bytes, what: str, limits: PictureLimits, form: Form, max_side: int | None
) -> DecodedPicture:
    """Decode a picture, limiting the longer side of "upright" and "rgb" pixels to ``max_side``.

    Raises:
        InputError: The picture is damaged or exceeds a limit.
    """
    with open_picture(raw, what, limits) as picture:
        if form != "rgb":  # without loading, "rgb" JPEGs are decoded at low resolution
            picture.load()
        mode, (width, height), orientation = picture.mode, picture.size, 1
        if form == "upright":
            orientation = _orientation(picture)
            pixels = upright(picture, max_side)
        elif form == "rgb":
            pixels = shrink(picture, max_side)
        elif form == "rgba":
            pixels = np.asarray(picture.convert("RGBA"), np.uint8)
        else:
            pixels = np.asarray(picture)
        return DecodedPicture(pixels, mode, width, height, orientation)


@contextmanager
def open_picture(raw: bytes, what: str, limits: PictureLimits) -> Iterator[Image.Image]:
    """Open a picture whose header is within limits; its pixels are decoded when first used.

    Raises:
        InputError: The picture is damaged or exceeds a limit; this is also raised on use.
    """
    header = read_header(raw, what, InputError, limits)
    try:
        with warnings.catch_warnings():  # the limits apply to the pixels instead
            warnings.simplefilter("ignore")
            with Image.open(io.BytesIO(raw), formats=(header.format,)) as picture:
                limits.check_size(*picture.size, what, InputError)
                yield picture
    except (TabletopError, MemoryError):
        raise
    except UnidentifiedImageError as error:
        raise InputError(damage(what, f"the {header.format} header is not valid")) from error
    except Exception as error:  # for an invalid file, decoders may raise anything
        raise InputError(damage(what, error)) from error


def shrink(picture: Image.Image, max_side: int | None) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture as RGB with sides of at most ``max_side``; the original may be modified."""
    plain = picture if picture.mode == "RGB" else picture.convert("RGB")
    if max_side is not None:
        plain.thumbnail((max_side, max_side), Image.Resampling.LANCZOS)
    return np.array(plain, np.uint8)


def upright(picture: Image.Image, max_side: int | None) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture as sRGB on a white background, rotated by its EXIF orientation."""
    try:
        picture = ImageOps.exif_transpose(picture)
    except MemoryError:
        raise
    except Exception:  # EXIF data that cannot be read is ignored
        pass
    if picture.mode.startswith("I;16"):  # Pillow would clip these to white, so keep the upper byte
        picture = Image.fromarray((np.asarray(picture) >> 8).astype(np.uint8))
    if picture.mode in ("RGBA", "LA", "PA") or "transparency" in picture.info:
        picture = picture.convert("RGBA")
        white = Image.new("RGBA", picture.size, (255, 255, 255, 255))
        picture = Image.alpha_composite(white, picture)
    picture = picture.convert("RGB")
    if max_side is not None:
        picture.thumbnail((max_side, max_side), Image.Resampling.LANCZOS)
    return np.asarray(picture, np.uint8)


def _orientation(picture: Image.Image) -> int:
    try:
        found = picture.getexif().get(_ORIENTATION, 1)
    except MemoryError:
        raise
    except Exception:
        return 1
    return found if isinstance(found, int) else 1
