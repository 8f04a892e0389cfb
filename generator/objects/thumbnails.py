"""Thumbnails of objects, sprites of themes, and sheets with captions."""

from __future__ import annotations

import io
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
from jaxtyping import UInt8
from PIL import Image, ImageDraw, ImageFont

from tabletop_objects import Category, build

from ..errors import require_known
from .facts import select, themes
from .pictures import lay_out, portrait

SIDE = 112
"""Width and height of a thumbnail, in pixels."""

COLUMNS = 13
"""Number of thumbnails per row of a sprite or a sheet."""

Shown = Callable[[str, int, int], None]
"""Progress callback, called with the drawn item, its number and the total number."""

Thumbnails = Mapping[str, UInt8[np.ndarray, "h w 3"]]
"""Thumbnails by key."""

_CAPTION, _TITLE = 30, 40
_INK, _PALE = (40, 44, 52), (110, 116, 128)
_QUALITY = 80


def by_folder(chosen: Sequence[str] = ()) -> Mapping[str, tuple[Category, ...]]:
    """Group the categories of the ``chosen`` themes (by default, all) by first theme, then noun.

    Raises:
        InputError: A theme does not exist.
    """
    for theme in chosen:
        require_known(theme, themes(), "Unknown theme")
    groups: dict[str, list[Category]] = defaultdict(list)
    for category in select():
        if not chosen or category.themes[0] in chosen:
            groups[category.themes[0]].append(category)
    return {theme: tuple(sorted(groups[theme], key=lambda c: c.noun)) for theme in sorted(groups)}


def draw_thumbnails(
    keys: Sequence[str], *, workers: int = 1, shown: Shown | None = None
) -> dict[str, UInt8[np.ndarray, "h w 3"]]:
    """Draw a thumbnail of each object's first variant.

    Args:
        keys: keys of the objects.
        workers: number of processes that draw.
        shown: called after each thumbnail.
    """
    drawn = {}
    for number, (key, picture) in enumerate(zip(keys, _draw_all(keys, workers), strict=True), 1):
        drawn[key] = picture
        if shown is not None and number % 50 in (0, 1):
            shown(key, number, len(keys))
    return drawn


def _draw_all(keys: Sequence[str], workers: int) -> Iterator[UInt8[np.ndarray, "h w 3"]]:
    if workers == 1:
        yield from map(_draw, keys)
        return
    with ProcessPoolExecutor(workers, get_context("spawn")) as pool:
        yield from pool.map(_draw, keys, chunksize=16)


def _draw(key: str) -> UInt8[np.ndarray, "h w 3"]:
    return portrait(build(key, 0), side=SIDE)


def sprite(thumbnails: Sequence[UInt8[np.ndarray, "h w 3"]]) -> bytes:
    """Tile thumbnails, ``COLUMNS`` per row, into one WebP picture."""
    return encode_webp(lay_out(thumbnails, COLUMNS))


def sheet(theme: str, group: Sequence[Category], thumbnails: Thumbnails) -> bytes:
    """Draw a sheet of a theme's objects, with captions, as one WebP picture."""
    rows = -(-len(group) // COLUMNS)
    width, height = COLUMNS * SIDE, _TITLE + rows * (SIDE + _CAPTION)
    picture = Image.new("RGB", (width, height), "white")
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(12)
    pen.text((10, 10), theme, _INK, ImageFont.load_default(20))
    pen.text((width - 10, 14), f"{len(group)} objects", _PALE, ImageFont.load_default(14), "ra")
    for k, category in enumerate(group):
        x, y = k % COLUMNS * SIDE, _TITLE + k // COLUMNS * (SIDE + _CAPTION)
        picture.paste(Image.fromarray(thumbnails[category.key]), (x, y))
        for line, text in enumerate(_wrap(category.noun, pen, font)):
            at = x + SIDE / 2, y + SIDE + 13 * line - 2
            pen.text(at, text, _INK, font, anchor="mt")
    return encode_webp(np.asarray(picture, np.uint8))


def _wrap(text: str, pen: ImageDraw.ImageDraw, font: object) -> list[str]:
    """Wrap a text into at most two lines, each no wider than a thumbnail."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and pen.textlength(longer, font) > SIDE - 4:  # type: ignore[arg-type]
            lines.append(word)
        else:
            lines[-1] = longer
    return [lines[0], " ".join(lines[1:])] if len(lines) > 1 else lines


def encode_webp(picture: UInt8[np.ndarray, "h w 3"]) -> bytes:
    """Encode a picture as WebP."""
    buffer = io.BytesIO()
    Image.fromarray(picture).save(buffer, "WEBP", quality=_QUALITY, method=6)
    return buffer.getvalue()
