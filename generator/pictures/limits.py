"""Limits on pictures, which depend on the caller; headers are checked before decoding."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..errors import TabletopError
from .headers import DamagedHeader, Format, PictureHeader, format_of, parse_header, refused_format

_NAMES = {"WEBP": "WebP"}


@dataclass(frozen=True)
class PictureLimits:
    """Limits on a single picture.

    Attributes:
        formats: supported formats; none of their decoders starts another program.
        max_bytes: maximum file size.
        max_pixels: maximum number of pixels in the first frame, the only one that is decoded.
        min_side: minimum length of both sides, pixels.
        max_ratio: maximum ratio of the longer side to the shorter one.
        max_frames: maximum number of frames in an animation, or of pages.
        max_scans: maximum number of scans in a JPEG; each is a pass over the whole picture.
        cpu_seconds: processor time limit of the decoding child process.
        memory: memory limit of the child process, bytes.
    """

    formats: tuple[Format, ...] = ("PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF")
    max_bytes: int = 50_000_000
    max_pixels: int = 25_000_000
    min_side: int = 1
    max_ratio: float = math.inf
    max_frames: int = 1000
    max_scans: int = 100
    cpu_seconds: float = 10.0
    memory: int = 3 * 2**29

    def check(self, header: PictureHeader, what: str, error: type[TabletopError]) -> None:
        """Check a header against the limits.

        ``what`` is the subject of error messages, such as "The picture".

        Raises:
            TabletopError: ``error``, if the picture exceeds a limit.
        """
        width, height = header.width, header.height
        if width * height > self.max_pixels:
            raise error(
                f"{what} has {width} x {height} pixels ({width * height / 1e6:.0f} megapixels); at "
                f"most {self.max_pixels:,} are allowed. Shrink the picture first."
            )
        if min(width, height) < self.min_side:
            raise error(
                f"{what} is {width}x{height}; each side must be at least {self.min_side} pixels."
            )
        if max(width, height) > self.max_ratio * min(width, height):
            raise error(
                f"{what} is {width}x{height}; the longer side may be at most {self.max_ratio:g} "
                "times the shorter one. Crop it."
            )
        for count, limit, name in (
            (header.frames, self.max_frames, "frames"), (header.scans, self.max_scans, "scans"),
        ):  # fmt: skip
            if count > limit:
                raise error(
                    f"{what} has more than {limit} {name}. Save it again as a plain PNG or JPEG."
                )

    def check_size(self, width: int, height: int, what: str, error: type[TabletopError]) -> None:
        """Check the size of a picture that has been decoded or is already an array.

        Raises:
            TabletopError: ``error``, if the size exceeds a limit.
        """
        self.check(PictureHeader("PNG", width, height), what, error)


def read_header(
    raw: bytes, what: str, error: type[TabletopError], limits: PictureLimits
) -> PictureHeader:
    """Return the header of a picture that is within limits; error messages begin with ``what``.

    Raises:
        TabletopError: ``error``, if the format is unsupported, the header is damaged, or a limit is
            exceeded.
    """
    if len(raw) > limits.max_bytes:
        raise error(f"{what} has {len(raw):,} bytes; at most {limits.max_bytes:,} are allowed.")
    kind = format_of(raw, limits.formats)
    if kind is None and (name := refused_format(raw)):
        raise error(f"{what} cannot be read: {name} is not supported. Convert it to JPEG or PNG.")
    if kind is None:
        names = [_NAMES.get(name, name) for name in limits.formats]
        listed = ", ".join(names[:-1]) + f" or {names[-1]}" if len(names) > 1 else names[0]
        raise error(f"{what} cannot be read: its format is not supported (use {listed}).")
    try:
        header = parse_header(raw, kind)
    except DamagedHeader as failure:
        raise error(damage(what, failure)) from failure
    limits.check(header, what, error)
    return header


def damage(what: str, reason: object) -> str:
    """Format the error message for a picture that a decoder cannot read."""
    text = " ".join(str(reason).split())[:300] or type(reason).__name__
    return f"{what} cannot be read: it is damaged or truncated ({text})."
