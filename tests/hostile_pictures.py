"""Pictures with false or repeated data, assembled from parts of valid ones."""

import io
import random
import re
import struct
import zlib
from typing import Any

import numpy as np
from PIL import Image

_MARKER = re.compile(rb"\xff[^\x00\xff\xd0-\xd7]")
_TIFF_HEAD, _TIFF_ENTRY = 8, 12
_TIFF_SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 7: 1, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4, 16: 8}


def noise(width: int, height: int, seed: int = 0) -> Image.Image:
    """A picture of coarse noise."""
    rng = np.random.default_rng(seed)
    small = rng.integers(0, 255, (-(-height // 8), -(-width // 8), 3), np.uint8)
    return Image.fromarray(np.kron(small, np.ones((8, 8, 1), np.uint8))[:height, :width])


def encoded(picture: Image.Image, kind: str, **options: Any) -> bytes:
    stream = io.BytesIO()
    picture.save(stream, kind, **options)
    return stream.getvalue()


# ----------------------------------------------------------------------------------------- JPEG
def jpeg_segments(raw: bytes) -> list[bytes]:
    """Split a JPEG into its segments with their markers; a scan's segment includes its data."""
    found, at = [raw[:2]], 2
    while at < len(raw):
        kind = raw[at + 1]
        if kind == 0xD9:
            found.append(raw[at:])
            break
        end = at + 2 + struct.unpack_from(">H", raw, at + 2)[0]
        if kind == 0xDA:
            data = _MARKER.search(raw, end)
            end = data.start() if data else len(raw)
        found.append(raw[at:end])
        at = end
    return found


def repeated_scans(times: int, width: int = 64, height: int = 64) -> bytes:
    """Return a progressive JPEG whose last scan is repeated ``times`` times."""
    parts = jpeg_segments(encoded(noise(width, height), "JPEG", progressive=True))
    last = max(k for k, part in enumerate(parts) if part[1] == 0xDA)
    parts[last:last] = [parts[last]] * (times - 1)
    return b"".join(parts)


def mutated_jpeg(rng: random.Random, raw: bytes) -> bytes:
    """Return a JPEG with segments repeated, swapped, dropped, or with a false length."""
    parts = jpeg_segments(raw)
    at = rng.randrange(1, len(parts))
    kind = rng.randrange(6)
    if kind == 0:
        parts[at:at] = [parts[at]] * rng.choice((2, 60, 300, 5000, 60_000))
    elif kind == 1:
        other = rng.randrange(1, len(parts))
        parts[at], parts[other] = parts[other], parts[at]
    elif kind == 2:
        del parts[at]
    elif kind == 3 and len(parts[at]) > 4:
        length = struct.pack(">H", rng.choice((0, 1, 2, 3, 255, 65535)))
        parts[at] = parts[at][:2] + length + parts[at][4:]
    elif kind == 4:
        made = bytes([0xFF, rng.choice((0xC0, 0xC2, 0xC4, 0xDB, 0xDA, 0xDD, 0xDC, 0xE1, 0xEE))])
        body = rng.randbytes(rng.choice((0, 3, 20, 400)))
        parts[at:at] = [made + struct.pack(">H", len(body) + 2) + body]
    else:
        exif = b"Exif\0\0" + mutated_tiff(rng, encoded(noise(8, 8), "TIFF"))[:60_000]
        parts[1:1] = [b"\xff\xe1" + struct.pack(">H", len(exif) + 2) + exif]
    return b"".join(parts)


# ----------------------------------------------------------------------------------------- TIFF
def tiff_entries(raw: bytes) -> list[int]:
    """Return the offsets of the tags of a little-endian TIFF's first frame."""
    (at,) = struct.unpack_from("<I", raw, 4)
    (count,) = struct.unpack_from("<H", raw, at)
    return [at + 2 + k * _TIFF_ENTRY for k in range(count)]


def mutated_tiff(rng: random.Random, raw: bytes) -> bytes:
    """Return a TIFF with tags of other types, counts, values or names."""
    changed = bytearray(raw)
    for _ in range(rng.choice((1, 1, 2, 3))):
        place = rng.choice(tiff_entries(raw))
        kind = rng.randrange(5)
        if kind in (0, 4):
            struct.pack_into("<H", changed, place + 2, rng.choice((*_TIFF_SIZES, 0, 6, 14, 99)))
        if kind in (1, 4):
            counts = (0, 1, 2, 3, 1000, 65535, 2**31 - 1, 2**32 - 1)
            struct.pack_into("<I", changed, place + 4, rng.choice(counts))
        if kind == 2:
            values = (0, 1, 8, 255, len(raw), 65536, 2**31 - 1, 2**32 - 1, rng.randrange(2**32))
            struct.pack_into("<I", changed, place + 8, rng.choice(values))
        if kind == 3:
            tags = (254, 256, 257, 258, 259, 262, 273, 274, 277, 278, 279, 284, 317, 320, 322, 323,
                    324, 325, 330, 338, 339, 347, 34665, 34675, 33723)  # fmt: skip
            struct.pack_into("<H", changed, place, rng.choice(tags))
    return bytes(changed)


def chained_tiff(frames: int) -> bytes:
    """Return a TIFF of many frames with shared pixels; the last links to the first."""
    raw = bytearray(encoded(noise(64, 64), "TIFF"))
    (at,) = struct.unpack_from("<I", raw, 4)
    entries = tiff_entries(bytes(raw))
    tags = bytes(raw[at : entries[-1] + _TIFF_ENTRY])
    first = len(raw) + len(raw) % 2
    raw += bytes(first - len(raw))
    step = len(tags) + 4
    for k in range(frames):
        raw += tags + struct.pack("<I", first + (k + 1) % frames * step)
    struct.pack_into("<I", raw, 4, first)
    return bytes(raw)


def overlapping_exif(entries: int, size: int) -> bytes:
    """Return a PNG whose EXIF tags all refer to the same ``size`` bytes."""
    tags = b"".join(struct.pack("<HHII", k, 7, size, 8) for k in range(1, entries + 1))
    start = 8 + size
    exif = (b"II*\0" + struct.pack("<I", start) + bytes(size)
            + struct.pack("<H", entries) + tags + bytes(4))  # fmt: skip
    raw = encoded(noise(64, 64), "PNG")
    return raw[:33] + png_chunk(b"eXIf", exif) + raw[33:]


# ------------------------------------------------------------------------------------------ PNG
def png_chunk(kind: bytes, data: bytes) -> bytes:
    return (struct.pack(">I", len(data)) + kind + data
            + struct.pack(">I", zlib.crc32(kind + data)))  # fmt: skip


def png_chunks(raw: bytes) -> list[bytes]:
    found, at = [raw[:8]], 8
    while at < len(raw):
        end = at + 12 + struct.unpack_from(">I", raw, at)[0]
        found.append(raw[at:end])
        at = end
    return found


def mutated_png(rng: random.Random, raw: bytes) -> bytes:
    """Return a PNG with chunks repeated, swapped, dropped, emptied, or of other kinds."""
    parts = png_chunks(raw)
    at = rng.randrange(1, len(parts))
    kind = rng.randrange(5)
    if kind == 0:
        parts[at:at] = [parts[at]] * rng.choice((1, 2, 300, 20_000))
    elif kind == 1:
        other = rng.randrange(1, len(parts))
        parts[at], parts[other] = parts[other], parts[at]
    elif kind == 2:
        del parts[at]
    elif kind == 3:
        names = (b"tEXt", b"IDAT", b"fdAT", b"fcTL", b"acTL", b"PLTE", b"tRNS", b"IHDR", b"xxxx")
        made = png_chunk(rng.choice(names), rng.randbytes(rng.choice((0, 1, 8, 26))))
        parts[at:at] = [made] * rng.choice((1, 100, 100_000))
    else:
        exif = mutated_tiff(rng, encoded(noise(8, 8), "TIFF"))
        parts[2:2] = [png_chunk(b"eXIf", exif)]
    return b"".join(parts)


# ------------------------------------------------------------------------------------ GIF, WebP
def mutated_gif(rng: random.Random, frames: int = 3) -> bytes:
    """Return a GIF with frames outside the screen, an endless one, or with ten thousand frames."""
    raw = animated("GIF", frames)
    start = raw.index(b"\x21\xff") if b"\x21\xff" in raw else raw.index(b"\x2c")
    body = raw[start:-1]
    kind = rng.randrange(5)
    if kind == 0:
        return raw[:start] + body * rng.choice((2, 400, 3000)) + raw[-1:]
    if kind == 1:
        return raw[:start] + b"\x21\xfe" + b"\x01x" * rng.choice((10, 200_000)) + b"\0" + body
    if kind == 2:
        return raw[:start] + bytes(rng.choice((10, 500_000))) + body
    changed = bytearray(raw)
    at = changed.index(b"\x2c", start)
    edge = rng.choice((0, 1, 64, 4000, 65535))
    struct.pack_into("<H", changed, at + 1 + 2 * rng.randrange(4), edge)
    if kind == 3:
        struct.pack_into("<H", changed, 6 + 2 * rng.randrange(2), edge)
    return bytes(changed)


def mutated_webp(rng: random.Random, frames: int = 3) -> bytes:
    """Return a WebP with chunks repeated or resized, or a canvas that does not fit its frames."""
    raw = bytearray(animated("WEBP", frames))
    kind = rng.randrange(4)
    at = raw.index(b"ANMF")
    if kind == 0:
        size = 8 + struct.unpack_from("<I", raw, at + 4)[0]
        raw[at:at] = bytes(raw[at : at + size]) * rng.choice((1, 400, 3000))
    elif kind == 1:
        struct.pack_into("<I", raw, at + 4, rng.choice((0, 16, 2**31, 2**32 - 1)))
    elif kind == 2:
        raw[24:30] = rng.choice((b"\xff" * 6, bytes(6), b"\xff\x3f\0\xff\x3f\0", rng.randbytes(6)))
    else:
        raw[at + 8 : at + 24] = rng.randbytes(16)
    struct.pack_into("<I", raw, 4, len(raw) - 8)
    return bytes(raw)


def animated(kind: str, frames: int) -> bytes:
    shown = [noise(64, 64, k) for k in range(frames)]
    return encoded(shown[0], kind, save_all=True, append_images=shown[1:])
