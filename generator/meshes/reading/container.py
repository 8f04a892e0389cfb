"""The container of a GLB file: a JSON header and one binary chunk."""

from __future__ import annotations

import json
import struct

from ...errors import BackendError
from ...io.reading import parse_object
from . import bounds
from .flattening import JSON_CHUNK, Header

_BINARY_CHUNK = 0x004E4942


def split_glb(raw: bytes, what: str) -> tuple[Header, bytes]:
    """Return the JSON header and the binary chunk (empty where there is none) of a GLB file.

    ``what`` names it in messages.

    Raises:
        BackendError: no GLB, cut off, or too large.
    """
    check_size(raw, what, bounds.MOST_BYTES)
    if raw[:4] != b"glTF" or len(raw) < 20:
        raise BackendError(
            f"{what} is no GLB file: its {len(raw)} bytes begin with {raw[:12]!r}. "
            "Binary glTF 2.0 is read."
        )
    version, length, size, kind = struct.unpack("<4I", raw[4:20])
    if version != 2 or kind != JSON_CHUNK:
        raise BackendError(f"{what} is glTF version {version}; binary glTF 2.0 is read.")
    if length > len(raw) or size > length - 20:
        raise BackendError(f"{what} is cut off: {len(raw)} of {max(length, size)} bytes are there.")
    text, problem = raw[20 : 20 + size], f"{what} has a damaged header: it"
    header = parse_object(text, problem, BackendError, max_bytes=bounds.MOST_HEADER)
    return header, raw[28 + size :]


def join_glb(header: Header, data: bytes) -> bytes:
    """Return the GLB file of a header and a binary chunk."""
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    size = 28 + len(text) + len(data)
    head = struct.pack("<4s4I", b"glTF", 2, size, len(text), JSON_CHUNK)
    return head + text + struct.pack("<2I", len(data), _BINARY_CHUNK) + data


def check_size(raw: bytes, what: str, maximum: int) -> None:
    """Check the bytes of a file.

    Raises:
        BackendError: there are more than ``maximum``.
    """
    if len(raw) > maximum:
        raise BackendError(
            f"{what} takes {len(raw) / 2**20:.0f} MiB; at most {maximum // 2**20} are read."
        )
