"""Limits on pictures: one value for each kind of caller, checked on headers before decoding."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..errors import TabletopError
from .headers import DamagedHeader, Format, PictureHeader, format_of, parse_header, refused_format

_NAMES = {"WEBP": "WebP"}


@dataclass(frozen=True)
class PictureLimits:
    """Limits on one picture.

    Attributes:
        formats: the formats that are read; none starts another program.
        max_bytes: of the file.
        max_pixels: of the first frame, the only one that is decoded.
        min_side: pixels.
        max_ratio: the longer side over the shorter.
        max_frames: of an animation, or pages.
        max_scans: of a JPEG; a decoder goes over the whole picture for each.
        cpu_seconds: processor time of the child that decodes it.
        memory: bytes that the child may allocate.
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
        """Check a header; ``what`` begins the message: "The picture".

        Raises:
            TabletopError: ``error``, if the picture is over a limit.
        """
        width, height = header.width, header.height
        if width * height > self.max_pixels:
            raise error(
                f"{what} has {width} x {height} pixels ({width * height / 1e6:.0f} megapixels), "
                f"more than {self.max_pixels:,} pixels. Shrink it first."
            )
        if min(width, height) < self.min_side:
            raise error(
                f"{what} is {width}x{height}; it needs at least {self.min_side} pixels a side."
            )
        if max(width, height) > self.max_ratio * min(width, height):
            raise error(
                f"{what} is {width}x{height}; the longer side may be at most "
                f"{self.max_ratio:g} times the shorter. Crop it."
            )
        for count, limit, name in (
            (header.frames, self.max_frames, "frames"), (header.scans, self.max_scans, "scans"),
        ):  # fmt: skip
            if count > limit:
                raise error(
                    f"{what} has more than the {limit} {name} that are read. Save it again as a "
                    "plain PNG or JPEG."
                )

    def check_size(self, width: int, height: int, what: str, error: type[TabletopError]) -> None:
        """Check the size of a picture, as a decoder finds it or as an array has it.

        Raises:
            TabletopError: ``error``, if it is over a limit.
        """
        self.check(PictureHeader("PNG", width, height), what, error)


def read_header(
    raw: bytes, what: str, error: type[TabletopError], limits: PictureLimits
) -> PictureHeader:
    """Return the header of a picture within limits; ``what`` begins the message of an error.

    Raises:
        TabletopError: ``error``, if it is in another format, damaged, or over a limit.
    """
    if len(raw) > limits.max_bytes:
        raise error(f"{what} has {len(raw):,} bytes; at most {limits.max_bytes:,} are read.")
    kind = format_of(raw, limits.formats)
    if kind is None and (name := refused_format(raw)):
        raise error(f"{what} cannot be read: {name} pictures are not. Convert it to JPEG or PNG.")
    if kind is None:
        names = [_NAMES.get(name, name) for name in limits.formats]
        listed = ", ".join(names[:-1]) + f" or {names[-1]}" if len(names) > 1 else names[0]
        raise error(f"{what} cannot be read: it is not in a known format (no {listed}).")
    try:
        header = parse_header(raw, kind)
    except DamagedHeader as failure:
        raise error(damage(what, failure)) from failure
    limits.check(header, what, error)
    return header


def damage(what: str, reason: object) -> str:
    """Return the message about a picture that a decoder cannot read."""
    text = " ".join(str(reason).split())[:300] or type(reason).__name__
    return f"{what} cannot be read: it is damaged or truncated ({text})."
