"""Decoding of an untrusted picture in a child process, within limits."""

from __future__ import annotations

import threading

from ..errors import InputError, TabletopError
from ..sandbox import SandboxError, SandboxLimits, call
from .limits import PictureLimits, read_header
from .picture import DecodedPicture, Form


def decode(
    raw: bytes,
    what: str,
    error: type[TabletopError],
    limits: PictureLimits,
    form: Form,
    max_side: int | None = None,
    cancelled: threading.Event | None = None,
) -> DecodedPicture:
    """Decode a picture in a child process, or in this process if this is already a sandbox child.

    The header is checked first, so that a child starts only for a picture whose header is within
    the limits.

    Args:
        raw: bytes of the file.
        what: subject of error messages, such as "The picture".
        error: exception type to raise.
        limits: limits on the picture and on the child.
        form: form of the returned pixels.
        max_side: maximum length of the longer side of "upright" and "rgb" pixels.
        cancelled: event that another thread sets to kill the child.

    Raises:
        TabletopError: ``error``, if the picture cannot be read or exceeds a limit.
    """
    from .pixels import decode_pixels

    read_header(raw, what, error, limits)
    try:
        return call(
            decode_pixels, raw, what, limits, form, max_side,
            limits=SandboxLimits(limits.cpu_seconds, limits.memory), returns=(DecodedPicture,),
            cancelled=cancelled,
        )  # fmt: skip
    except SandboxError as failure:
        raise error(f"{what} {failure}.") from failure
    except InputError as failure:
        raise error(str(failure)) from failure


def decode_png(
    raw: bytes, what: str, error: type[TabletopError], limits: PictureLimits, form: Form
) -> DecodedPicture:
    """Decode a PNG in this process, in the form "rgb", "rgba" or "stored".

    This is meant for files that come in hundreds, such as the textures of bundles, for which one
    child process per file would be too slow. For a PNG within the limits, the cost is linear in the
    numbers of bytes and pixels: it has one stream of pixels, its chunks are counted, and its
    metadata, including EXIF, is ignored.

    Raises:
        TabletopError: ``error``, if the file is not a PNG, cannot be read, or exceeds a limit.
    """
    from .pixels import decode_pixels

    if form == "upright" or limits.formats != ("PNG",):
        raise ValueError("only plain PNGs are decoded outside a child process")
    try:
        return decode_pixels(raw, what, limits, form, None)
    except InputError as failure:
        raise error(str(failure)) from failure
