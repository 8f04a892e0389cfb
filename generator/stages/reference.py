"""Reference (Sec. 3, Fig. 8): a text becomes a plan and a drawing; a picture passes through."""

from __future__ import annotations

import hashlib
import io
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from ..backends.protocols import Imager, Reasoner
from ..errors import InputError
from ..scene import Reference, ScenePlan

Source = str | Path | bytes | ScenePlan | np.ndarray
"""A text, a plan, or a picture: a path, encoded bytes, or an array (h, w, 3 or 4) of uint8."""

FORMATS = ("PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF")
"""What pictures may come as; nothing that starts another program to be read."""


@dataclass(frozen=True)
class ReferenceConfig:
    """Limits on pictures: sides in pixels, file size in bytes, longest side worked at.

    ``max_ratio`` is the longer side over the shorter.
    """

    min_side: int = 64
    max_ratio: float = 8.0
    max_pixels: int = 25_000_000
    max_bytes: int = 50_000_000
    work_side: int = 1280


def refer(
    source: Source,
    reasoner: Reasoner,
    imager: Imager,
    seed: int,
    config: ReferenceConfig | None = None,
) -> Reference:
    """Return the reference image I_ref of ``source``, with prompt and plan if it was a text.

    A string is a text unless it names an existing file or ends like a picture's name. Pictures
    are turned by their EXIF orientation, flattened onto white, and shrunk to ``work_side``.

    Raises:
        InputError: an empty text, a missing or broken picture, one too small or too large.
    """
    config = config or ReferenceConfig()
    if isinstance(source, str) and not is_picture_name(source):
        plan = reasoner.plan_scene(source, seed)
        return Reference(imager.draw(plan, seed), source, plan)
    if isinstance(source, ScenePlan):
        if not source.objects:
            raise InputError("The plan holds no object; a scene needs at least one.")
        return Reference(imager.draw(source, seed), source.prompt, source)
    return Reference(read_image(source, config))


def is_picture_name(text: str) -> bool:
    """Tell whether a string means a picture file rather than a description."""
    if "\n" in text or len(text) > 1024 or not text.strip():
        return False
    suffixes = {".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif", ".tiff", ".gif"}
    path = Path(text)
    try:
        return path.suffix.lower() in suffixes or (path.is_file() and " " not in text.strip())
    except OSError:
        return False


def read_image(
    source: str | Path | bytes | np.ndarray, config: ReferenceConfig | None = None
) -> UInt8[np.ndarray, "h w 3"]:
    """Decode a picture into sRGB on white, upright, at most ``config.work_side`` long."""
    config = config or ReferenceConfig()
    from PIL import Image, ImageOps, UnidentifiedImageError

    try:
        if isinstance(source, np.ndarray):
            picture = Image.fromarray(_as_uint8(source))
        else:
            with warnings.catch_warnings():  # our own limit on pixels comes next
                warnings.simplefilter("ignore", Image.DecompressionBombWarning)
                data = io.BytesIO(_read_bytes(source, config))
                picture = Image.open(data, formats=FORMATS)
        _check_size(picture.width, picture.height, config)
        picture.load()
    except UnidentifiedImageError as error:
        raise InputError("Not a picture in a known format. Use PNG, JPEG or WebP.") from error
    except Image.DecompressionBombError as error:
        raise InputError(f"The picture is too large: {error}") from error
    except (OSError, SyntaxError, EOFError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"The picture is damaged or truncated ({error}).") from error
    picture = ImageOps.exif_transpose(picture)
    if picture.mode.startswith("I;16"):  # Pillow would clip these to white; keep the upper byte
        picture = Image.fromarray((np.asarray(picture) >> 8).astype(np.uint8))
    if picture.mode in ("RGBA", "LA", "PA") or "transparency" in picture.info:
        picture = picture.convert("RGBA")
        white = Image.new("RGBA", picture.size, (255, 255, 255, 255))
        picture = Image.alpha_composite(white, picture)
    picture = picture.convert("RGB")
    picture.thumbnail((config.work_side, config.work_side), Image.Resampling.LANCZOS)
    return np.asarray(picture, np.uint8)


def fetch(source: Source, config: ReferenceConfig | None = None) -> Source:
    """Return a picture file's bytes, read once; any other source as it is.

    Raises:
        InputError: no such file, or one too large or unreadable.
    """
    if isinstance(source, Path) or (isinstance(source, str) and is_picture_name(source)):
        return _read_bytes(source, config or ReferenceConfig())
    return source


def source_digest(source: Source) -> str | None:
    """Return the sha256 of a fetched picture's bytes; None for a text or a plan."""
    if isinstance(source, np.ndarray):
        return hashlib.sha256(np.ascontiguousarray(source).tobytes()).hexdigest()
    return hashlib.sha256(source).hexdigest() if isinstance(source, bytes) else None


def _read_bytes(source: str | Path | bytes, config: ReferenceConfig) -> bytes:
    if isinstance(source, bytes):
        data = source
    elif not isinstance(source, str | Path):
        raise InputError(
            f"A text, a plan or a picture (path, bytes or array) is needed, got "
            f"{type(source).__name__}."
        )
    else:
        path = Path(source)
        if not path.is_file():
            raise InputError(f"No picture at {str(path)!r}. Pass a text, or a path to a file.")
        if path.stat().st_size > config.max_bytes:
            raise InputError(f"The picture file is larger than {config.max_bytes:,} bytes.")
        try:
            data = path.read_bytes()
        except OSError as error:
            raise InputError(f"Cannot read {str(path)!r}: {error.strerror}.") from error
    if not data or len(data) > config.max_bytes:
        raise InputError(f"A picture needs 1 to {config.max_bytes:,} bytes, got {len(data):,}.")
    return data


def _as_uint8(image: np.ndarray) -> np.ndarray:
    if image.dtype != np.uint8 or image.ndim not in (2, 3):
        raise InputError(
            f"An image array must be uint8 of shape (h, w), (h, w, 3) or (h, w, 4), "
            f"got {image.dtype} {image.shape}."
        )
    if image.ndim == 3 and image.shape[2] not in (3, 4):
        raise InputError(f"An image array needs 3 or 4 channels, got {image.shape[2]}.")
    return np.ascontiguousarray(image)


def _check_size(width: int, height: int, config: ReferenceConfig) -> None:
    if width * height > config.max_pixels:
        raise InputError(
            f"The picture has {width * height / 1e6:.0f} megapixels; the limit is "
            f"{config.max_pixels / 1e6:.0f}. Shrink it first."
        )
    if min(width, height) < config.min_side:
        raise InputError(
            f"The picture is {width}x{height}; it needs at least {config.min_side} pixels a side."
        )
    if max(width, height) > config.max_ratio * min(width, height):
        raise InputError(
            f"The picture is {width}x{height}; the longer side may be at most "
            f"{config.max_ratio:g} times the shorter. Crop it to the table."
        )
