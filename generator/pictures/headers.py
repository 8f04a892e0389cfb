"""Headers of picture files: format, size, frames and scans, parsed from the raw bytes.

Nothing is decompressed, and loops never iterate more often than for a valid file of the same size.
The header states the size that a decoder will produce; the size that the decoder reports is checked
against the limits again.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

Format = Literal["PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF", "TGA"]

_PNG = b"\x89PNG\r\n\x1a\n"
_PNG_HEAD = 33  # bytes of the signature and the first chunk
_SIGNATURES: tuple[tuple[Format, re.Pattern[bytes]], ...] = (
    ("PNG", re.compile(re.escape(_PNG))),
    ("JPEG", re.compile(rb"\xff\xd8\xff")),
    ("WEBP", re.compile(rb"RIFF....WEBP", re.DOTALL)),
    ("GIF", re.compile(rb"GIF8[79]a")),
    ("TIFF", re.compile(rb"II[*+]\0|MM\0[*+]")),
    ("BMP", re.compile(rb"BM")),
    # All that identifies a TGA: colour map, image type, eleven arbitrary bytes and bits per pixel.
    ("TGA", re.compile(rb".[\0\1][\1\2\3\t\n\x0b].{13}[\1\x08\x10\x18\x20]", re.DOTALL)),
)

_HEIC = (b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"hevm", b"hevs", b"mif1", b"msf1")

_SEGMENTS = 20_000  # maximum number of segments in a JPEG; valid files have hundreds
_CHUNKS = 1000, 256  # maximum number of chunks: a constant, plus one for this many bytes
_IN_SCAN = re.compile(rb"\xff[^\x00\xff\xd0-\xd7]")  # end of the data in a scan
_MARKER = re.compile(rb"\xff([^\x00\xff])")  # without "+", which would take quadratic time
_SOS, _EOI = 0xDA, 0xD9
_SIZED = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}  # markers that start a frame
_BARE = frozenset((0x01, 0xD8, *range(0xD0, 0xD8)))  # markers that have no length

_TIFF_TYPES = MappingProxyType({3: "H", 4: "I", 16: "Q"})  # numeric types that a size can have
_WIDTH, _HEIGHT = 256, 257
_IFDS = 100_000  # maximum number of linked frames


class DamagedHeader(ValueError):
    """Raised if a header cannot be read; the message gives the reason."""


@dataclass(frozen=True)
class PictureHeader:
    """The size of a file's first frame in pixels, and its numbers of frames and JPEG scans."""

    format: Format
    width: int
    height: int
    frames: int = 1
    scans: int = 1


def format_of(raw: bytes, formats: Iterable[Format]) -> Format | None:
    """Return the format in ``formats`` that matches the first bytes of a file, or None."""
    for name, signature in _SIGNATURES:
        if signature.match(raw):
            return name if name in formats else None
    return None


def refused_format(raw: bytes) -> str | None:
    """Return the name of a common but unsupported format, identified by its ``ftyp`` brand."""
    if raw[4:8] != b"ftyp":
        return None
    if raw[8:12] in _HEIC:
        return "HEIC"
    return "AVIF" if raw[8:12] in (b"avif", b"avis") else None


def parse_header(raw: bytes, kind: Format) -> PictureHeader:
    """Parse the header of a file whose format is known.

    Raises:
        DamagedHeader: The header is truncated, or has more segments than any valid file.
    """
    try:
        return _READERS[kind](raw)
    except (struct.error, IndexError) as error:
        raise DamagedHeader("the header is truncated") from error


def png_size(raw: bytes) -> tuple[int, int]:
    """Return the width and height of a PNG from its header.

    Raises:
        DamagedHeader: The file does not start with a PNG header.
    """
    if raw[:16] != _PNG + b"\0\0\0\rIHDR":
        raise DamagedHeader("the file does not start with a PNG header")
    if len(raw) < _PNG_HEAD:
        raise DamagedHeader("the header is truncated")
    return struct.unpack_from(">II", raw, 16)


def _png(raw: bytes) -> PictureHeader:
    width, height = png_size(raw)
    frames, profiles = 1, 0
    for name, at, size in _chunks(raw, 8, ">I4s", 4, 1):
        profiles += name == b"iCCP"
        if profiles > 1:  # decoders decompress every profile, but a valid PNG has at most one
            raise DamagedHeader("the picture has more than one colour profile")
        if name == b"acTL" and size >= 4:
            frames = max(1, struct.unpack_from(">I", raw, at)[0])
        if name == b"IEND":
            break
    return PictureHeader("PNG", width, height, frames)


def _webp(raw: bytes) -> PictureHeader:
    size, frames = None, 0
    for name, at, _ in _chunks(raw, 12, "<4sI", 0, 2):
        frames += name == b"ANMF"
        if size is None and name == b"VP8X":
            packed = int.from_bytes(raw[at + 4 : at + 10], "little")
            size = (packed & 0xFFFFFF) + 1, (packed >> 24) + 1
        elif size is None and name == b"VP8L":
            (packed,) = struct.unpack_from("<I", raw, at + 1)
            size = (packed & 0x3FFF) + 1, (packed >> 14 & 0x3FFF) + 1
        elif size is None and name == b"VP8 ":
            width, height = struct.unpack_from("<HH", raw, at + 6)
            size = width & 0x3FFF, height & 0x3FFF
    if size is None:
        raise DamagedHeader("the file contains no picture")
    return PictureHeader("WEBP", *size, max(1, frames))


def _chunks(
    raw: bytes, start: int, head: str, check: int, align: int
) -> Iterator[tuple[bytes, int, int]]:
    """Yield each chunk's name, offset and size; ``head`` is the struct format of chunk headers."""
    count, most = 0, _CHUNKS[0] + len(raw) // _CHUNKS[1]
    while start + 8 <= len(raw):
        first, second = struct.unpack_from(head, raw, start)
        name, size = (second, first) if isinstance(first, int) else (first, second)
        yield name, start + 8, size
        start += 8 + -(-size // align) * align + check
        count += 1
        if count > most:
            raise DamagedHeader(f"the picture has more than {most} chunks")


def _jpeg(raw: bytes) -> PictureHeader:
    size, scans, at = None, 0, 2
    for _ in range(_SEGMENTS):
        found = _MARKER.search(raw, at)
        if found is None or (kind := found[1][0]) == _EOI:
            break
        at = found.end()
        if kind in _BARE:
            continue
        (length,) = struct.unpack_from(">H", raw, at)
        if length < 2:
            raise DamagedHeader("a segment has an invalid length")
        if size is None and kind in _SIZED:
            height, width = struct.unpack_from(">HH", raw, at + 3)
            size = width, height
        at += length
        if kind == _SOS:
            scans += 1
            ending = _IN_SCAN.search(raw, at)
            at = ending.start() if ending else len(raw)
    else:
        raise DamagedHeader(
            f"the picture has more than {_SEGMENTS} segments, {scans} of which are scans"
        )
    if size is None:
        raise DamagedHeader("the size is missing")
    return PictureHeader("JPEG", *size, 1, max(1, scans))


def _gif(raw: bytes) -> PictureHeader:
    width, height, flags = struct.unpack_from("<HHB", raw, 6)
    at, frames = 13 + _palette(flags), 0
    most = left = _CHUNKS[0] + len(raw) // 64
    while at < len(raw) and (kind := raw[at]) != 0x3B:
        if kind == 0x2C:
            x, y, w, h, flags = struct.unpack_from("<HHHHB", raw, at + 1)
            if not frames:
                width, height = max(width, x + w), max(height, y + h)
            frames += 1
            at += 11 + _palette(flags)
        elif kind == 0x21:
            at += 2
        else:  # unknown bytes, which decoders skip
            at, left = at + 1, left - 1
            continue
        while at < len(raw) and left > 0 and (size := raw[at]):
            at, left = at + size + 1, left - 1
        at, left = at + 1, left - 1
        if left <= 0:
            raise DamagedHeader(f"the picture has more than {most} blocks")
    return PictureHeader("GIF", width, height, max(1, frames))


def _palette(flags: int) -> int:
    """Return the size, in bytes, of the palette that follows, or 0 if there is none."""
    return 3 * 2 ** ((flags & 7) + 1) if flags & 0x80 else 0


def _bmp(raw: bytes) -> PictureHeader:
    (size,) = struct.unpack_from("<I", raw, 14)
    width, height = struct.unpack_from("<HH" if size == 12 else "<ii", raw, 18)
    return PictureHeader("BMP", abs(width), abs(height))


def _tga(raw: bytes) -> PictureHeader:
    return PictureHeader("TGA", *struct.unpack_from("<HH", raw, 12))


def _tiff(raw: bytes) -> PictureHeader:
    order, big = ("<" if raw[:2] == b"II" else ">"), 0x2B in raw[2:4]
    at = struct.unpack_from(order + ("Q" if big else "I"), raw, 8 if big else 4)[0]
    size = _first_size(raw, at, order, big)
    seen: set[int] = set()
    head, entry, link = ("Q", 20, "Q") if big else ("H", 12, "I")
    while at and at not in seen and len(seen) < _IFDS:
        seen.add(at)
        try:
            (count,) = struct.unpack_from(order + head, raw, at)
            (at,) = struct.unpack_from(
                order + link, raw, at + struct.calcsize(order + head) + count * entry
            )
        except (struct.error, OverflowError):  # only the tag list of the first frame is needed
            break
    return PictureHeader("TIFF", *size, max(1, len(seen)))


def _first_size(raw: bytes, at: int, order: str, big: bool) -> tuple[int, int]:
    """Return the width and height of the first TIFF frame, whose directory is at offset ``at``."""
    if at >= len(raw):
        raise DamagedHeader("the first directory is outside the file")
    head, entry, value = (order + "Q", 20, 12) if big else (order + "H", 12, 8)
    (count,) = struct.unpack_from(head, raw, at)
    first = at + struct.calcsize(head)
    found: dict[int, int] = {}
    for k in range(min(count, 65536, (len(raw) - first) // entry)):
        place = first + k * entry
        tag, kind = struct.unpack_from(order + "HH", raw, place)
        if tag in (_WIDTH, _HEIGHT) and kind in _TIFF_TYPES:
            (found[tag],) = struct.unpack_from(order + _TIFF_TYPES[kind], raw, place + value)
    if len(found) < 2:
        raise DamagedHeader("the size is missing")
    return found[_WIDTH], found[_HEIGHT]


_READERS: Mapping[Format, Callable[[bytes], PictureHeader]] = MappingProxyType(
    {
        "PNG": _png, "JPEG": _jpeg, "WEBP": _webp, "BMP": _bmp, "TIFF": _tiff, "GIF": _gif,
        "TGA": _tga,
    }
)  # fmt: skip
