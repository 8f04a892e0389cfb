"""Hostile bytes: flipped, cut, doubled, and with false lengths."""

import functools
import random
import struct
import zlib

MOST = 4 * 2**20
"""Bytes that a spoiled file has at most."""

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def spoiled(raw: bytes, rng: random.Random) -> bytes:
    """Return bytes with one to four changes."""
    for _ in range(rng.choice((1, 1, 2, 4))):
        raw = _changed(raw, rng)
    return raw[:MOST]


def _changed(raw: bytes, rng: random.Random) -> bytes:
    at = rng.randrange(len(raw) + 1)
    to = min(len(raw), at + rng.choice((1, 4, 16, 200, 5000)))
    kind = rng.randrange(9)
    if kind == 0:
        return raw[:at]
    if kind == 1:
        return raw[at:]
    if kind == 2:
        return raw[:at] + raw[at:to] * rng.choice((2, 3, 100)) + raw[to:]
    if kind == 3:
        return raw[:at] + raw[to:]
    if kind == 4:
        return raw[:at] + rng.randbytes(to - at) + raw[to:]
    if kind == 5 and len(raw) > 4:
        at = min(at, len(raw) - 4)
        length = rng.choice((0, 1, 2**31 - 1, 2**31, 2**32 - 1, len(raw), len(raw) * 2))
        return raw[:at] + struct.pack(rng.choice("<>") + "I", length) + raw[at + 4 :]
    if kind == 6:
        return raw[:at] + bytes(rng.choice((1, 100, 10_000))) + raw[at:]
    if kind == 7:
        return rng.choice(
            (b"", b"\x00", b"\xff" * 64, b"<html>", b"{}", b"PK\x03\x04", b"\x1f\x8b")
        )
    if not raw:
        return rng.randbytes(16)
    at = min(at, len(raw) - 1)
    return raw[:at] + bytes([raw[at] ^ 1 << rng.randrange(8)]) + raw[at + 1 :]


@functools.cache
def bomb(size: int) -> bytes:
    """Return ``size`` zeros, compressed as zlib does."""
    packer = zlib.compressobj(9)
    parts = [packer.compress(bytes(min(2**20, size - at))) for at in range(0, size, 2**20)]
    return b"".join(parts) + packer.flush()


def chunk(kind: bytes, data: bytes, wrong: bool = False) -> bytes:
    """Return a chunk of a PNG, with a wrong checksum if ``wrong``."""
    check = zlib.crc32(kind + data) ^ wrong
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)


def png(
    width: int,
    height: int,
    depth: int = 8,
    color: int = 2,
    interlace: int = 0,
    data: bytes = b"",
    before: bytes = b"",
    wrong: bool = False,
) -> bytes:
    """Return a PNG from a header and compressed pixels that may not match."""
    head = struct.pack(">IIBBBBB", width, height, depth, color, 0, 0, interlace)
    return b"".join((
        _SIGNATURE, chunk(b"IHDR", head, wrong), before, chunk(b"IDAT", data), chunk(b"IEND", b""),
    ))  # fmt: skip


def hostile_png(rng: random.Random, good: bytes) -> bytes:
    """Return a PNG with a false size, format or content, or a damaged one."""
    kind = rng.randrange(9)
    if kind == 0:
        side = rng.choice((4096, 4097, 8192, 20_000, 65_535, 2**31 - 1, 2**32 - 1, 0))
        return png(side, rng.choice((side, 1)), data=zlib.compress(bytes(1000), 9))
    if kind == 1:  # whole, small on disk, and large: one byte a texel, all zero
        side = rng.choice((1024, 2048, 4096))
        return png(side, side, color=0, data=bomb(side * (side + 1)))
    if kind == 2:
        return _odd(rng)
    if kind == 3:
        palette = chunk(b"PLTE", rng.randbytes(rng.choice((0, 3, 5, 768, 900))))
        side = rng.choice((2, 8, 64))
        rows = b"".join(b"\x00" + rng.randbytes(side) for _ in range(side))
        return png(side, side, color=3, data=zlib.compress(rows), before=palette)
    if kind == 4:
        kinds = (b"iCCP", b"zTXt", b"iTXt", b"tEXt", b"eXIf", b"tRNS", b"acTL", b"fcTL", b"gAMA")
        packed = rng.choice((bomb(64 * 2**20), rng.randbytes(40), b"", bytes(4)))
        more = chunk(rng.choice(kinds), b"name\x00\x00" + packed)
        return good[:33] + more * rng.choice((1, 1, 50)) + good[33:]
    if kind == 5:
        return png(64, 64, data=rng.choice((b"", zlib.compress(b""), bomb(64 * 2**20))))
    if kind == 6:
        return png(64, 64, data=zlib.compress(bytes(64 * 193)), wrong=True)
    return spoiled(good, rng)


def _odd(rng: random.Random) -> bytes:
    """Return a PNG of another depth, colour type or row order."""
    depth, color = rng.choice((1, 2, 4, 8, 16, 3)), rng.choice((0, 2, 3, 4, 6, 1, 7))
    side = rng.choice((1, 7, 64, 300))
    content = rng.randbytes(rng.choice((10, side * (side * 8 + 1))))
    if rng.random() < 0.5:
        content = bytes(len(content))
    return png(side, side, depth, color, rng.choice((0, 1, 2)), zlib.compress(content))
