"""Decode a foreign picture in a child process within limits."""

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
    """Decode a picture in a child process; within a child of a sandbox, in that one.

    The header is checked first, so that a child starts only for a picture whose header is within
    the limits.

    Args:
        raw: the file.
        what: begins the message of an error: "The picture".
        error: the error to raise.
        limits: limits on the picture and on the child.
        form: how the pixels are returned.
        max_side: the longer side of the pixels, if they are "upright" or "rgb".
        cancelled: kills the child when another thread sets it.

    Raises:
        TabletopError: ``error``, if the picture cannot be read or is over a limit.
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
    """Decode a PNG in this process, as "rgb", "rgba" or "stored".

    For files that come by the hundred, such as the textures of bundles, which no child each could
    read in time. Of a PNG within limits the cost is linear in its bytes and pixels: it has one
    stream of pixels, its chunks are counted, and its metadata, EXIF included, is not looked at.

    Raises:
        TabletopError: ``error``, if it is no PNG, cannot be read or is over a limit.
    """
    from .pixels import decode_pixels

    if form == "upright" or limits.formats != ("PNG",):
        raise ValueError("only plain PNGs are decoded outside a child")
    try:
        return decode_pixels(raw, what, limits, form, None)
    except InputError as failure:
        raise error(str(failure)) from failure
