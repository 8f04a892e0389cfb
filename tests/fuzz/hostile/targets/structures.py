"""Pictures with valid parts in invalid combinations: tags, segments, chunks, frames."""

import functools
import random
from pathlib import Path

from hostile_pictures import (
    chained_tiff,
    encoded,
    mutated_gif,
    mutated_jpeg,
    mutated_png,
    mutated_tiff,
    mutated_webp,
    noise,
    overlapping_exif,
    repeated_scans,
)
from PIL import Image

from ..judging import accepts_any
from ..streams import spoiled
from . import Run
from .pictures import readers

_APART = 0.1  # share of cases decoded in children
_COMPRESSIONS = (None, "tiff_lzw", "tiff_adobe_deflate", "packbits", "jpeg", "zstd", "lzma", "webp")
_MODES = ("RGB", "L", "P", "RGBA", "CMYK", "1", "F")


def structures(rng: random.Random, folder: Path) -> Run:
    """Pictures assembled from parts of valid ones, for all readers of pictures."""
    raw = rng.choice((_tiff, _tiff, _jpeg, _png, _gif, _webp, _repeated))(rng)
    if rng.random() < 0.05:
        raw = spoiled(raw, rng)
    apart = rng.random() < _APART
    return lambda: accepts_any(*readers(raw, apart))


@functools.cache
def _sound(kind: str, mode: str, large: bool, **options: object) -> bytes:
    side = 1500 if large else 64
    picture = noise(side, side).convert(mode)
    exif = Image.Exif()
    exif[0x0112], exif[0x010F], exif[0x0132], exif[0x011A] = 6, "maker", "2020", 72.0
    return encoded(picture, kind, exif=exif, **options)


def _tiff(rng: random.Random) -> bytes:
    mode, compression = rng.choice(_MODES), rng.choice(_COMPRESSIONS)
    try:
        sound = _sound("TIFF", mode, rng.random() < 0.1, compression=compression)
    except (OSError, ValueError, RuntimeError):  # no such compression for this mode
        sound = _sound("TIFF", "RGB", False)
    return mutated_tiff(rng, sound)


def _jpeg(rng: random.Random) -> bytes:
    mode = rng.choice(("RGB", "L", "CMYK"))
    return mutated_jpeg(rng, _sound("JPEG", mode, rng.random() < 0.1, progressive=_coin(rng)))


def _png(rng: random.Random) -> bytes:
    mode = rng.choice(("RGB", "L", "P", "RGBA", "1"))
    return mutated_png(rng, _sound("PNG", mode, rng.random() < 0.1))


def _gif(rng: random.Random) -> bytes:
    return mutated_gif(rng, rng.choice((1, 3)))


def _webp(rng: random.Random) -> bytes:
    return mutated_webp(rng, rng.choice((2, 5)))


def _repeated(rng: random.Random) -> bytes:
    """The same scan, frame or tag, repeated."""
    kind = rng.randrange(3)
    if kind == 0:
        side = rng.choice((64, 640, 3000))
        return repeated_scans(rng.choice((50, 90, 3000, 50_000)), side, side)
    if kind == 1:
        return chained_tiff(rng.choice((2, 900, 60_000)))
    return overlapping_exif(rng.choice((10, 60_000)), rng.choice((100, 1_000_000, 20_000_000)))


def _coin(rng: random.Random) -> bool:
    return rng.random() < 0.5
