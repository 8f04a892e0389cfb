"""Bounded readers of foreign input: JSON, URLs, regular files, printable text, npz.

What comes from outside the process (a bundle, a server's answer, a record in a shared folder, a
file the user names) is hostile until it has passed one of these. Each takes the error to raise.
"""

from __future__ import annotations

import io
import itertools
import json
import math
import os
import re
import stat
import tomllib
import zipfile
import zlib
from pathlib import Path
from typing import Any, NoReturn
from urllib.parse import SplitResult, urlsplit

import numpy as np

from ..errors import TabletopError

MAX_URL_LENGTH = 8192

MAX_NAME_LENGTH = 200
"""Characters of a name or a label."""

_MAX_DEPTH = 64  # of lists and objects in a JSON text
_MAX_JSON_BYTES = 64 * 2**20  # unless the caller says otherwise
_MAX_VALUES = 4_000_000  # lists, objects and commas of a JSON text; each takes up to 72 bytes
_STRING = re.compile(rb'"[^"\\]*+(?:\\.[^"\\]*+)*+"?', re.DOTALL)  # possessive: linear in time
_PART = rb'(?:[\w-]++|"[^"\n]*+"|\'[^\'\n]*+\')[ \t]*+'  # of a dotted key
_DOTTED = re.compile(
    rb"(?m:^|[\[{,])[ \t]*+" + _PART + rb"(?:\.[ \t]*+" + _PART + rb"){%d}" % _MAX_DEPTH
)
_HOST = re.compile(r"[\w.:%-]+", re.ASCII)  # of an IPv6 address the colons, too
_NOT_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))
_STEP = {ord("["): 1, ord("{"): 1, ord("]"): -1, ord("}"): -1}


def parse_json(
    raw: bytes | str,
    what: str,
    error: type[TabletopError],
    *,
    max_bytes: int = _MAX_JSON_BYTES,
    max_depth: int = _MAX_DEPTH,
) -> Any:
    """Parse a foreign JSON text; every number in it is finite, every string is valid Unicode.

    ``what`` begins the message of an error: "The answer of the server". ``max_bytes`` bounds the
    text, ``max_depth`` the nesting of lists and objects.

    Raises:
        TabletopError: ``error``, if the text is too long, too deep, or not such JSON.
    """
    try:
        data = raw.encode() if isinstance(raw, str) else bytes(raw)
    except ValueError as failure:
        raise _not_json(what, error, failure) from failure
    check_json_size(data, what, error, max_bytes=max_bytes, max_depth=max_depth)
    try:
        payload = json.loads(
            data.decode("utf-8-sig"), parse_constant=_not_finite, parse_float=_finite
        )
        if rb"\u" in data:  # an escape may spell half a surrogate pair, which is no text
            json.dumps(payload, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as failure:
        raise _not_json(what, error, failure) from failure
    return payload


def check_json_size(
    data: bytes, what: str, error: type[TabletopError], *, max_bytes: int, max_depth: int
) -> None:
    """Check the length, number of values and nesting of a JSON text before it is parsed.

    Raises:
        TabletopError: ``error``, if it has too many; see :func:`parse_json`.
    """
    if len(data) > max_bytes:
        raise error(f"{what} has {len(data)} bytes of JSON; at most {max_bytes} are read.")
    bare = _STRING.sub(b"", data)
    if bare.count(b",") + bare.count(b"[") + bare.count(b"{") > _MAX_VALUES:
        raise error(f"{what} holds more than the {_MAX_VALUES} values that are read.")
    if _depth(bare) > max_depth:
        raise error(f"{what} nests lists or objects deeper than {max_depth} levels.")


def parse_object(
    raw: bytes | str,
    what: str,
    error: type[TabletopError],
    *,
    max_bytes: int = _MAX_JSON_BYTES,
    max_depth: int = _MAX_DEPTH,
) -> dict[str, Any]:
    """Parse a foreign JSON text that is one object; see :func:`parse_json`.

    Raises:
        TabletopError: ``error``, if it is not.
    """
    payload = parse_json(raw, what, error, max_bytes=max_bytes, max_depth=max_depth)
    if not isinstance(payload, dict):
        raise error(f"{what} must be one JSON object, not {type(payload).__name__}.")
    return payload


def parse_toml(raw: bytes, what: str, error: type[TabletopError]) -> dict[str, Any]:
    """Parse a foreign TOML text (UTF-8); the caller bounds its length.

    ``what`` begins the message of an error: "The price table".

    Raises:
        TabletopError: ``error``, if it is too deep, by brackets or by dotted keys, or no TOML.
    """
    if _depth(raw) > _MAX_DEPTH or _DOTTED.search(raw):
        raise error(f"{what} nests tables deeper than {_MAX_DEPTH} levels.")
    try:
        return tomllib.loads(raw.decode("utf-8-sig"))
    except (ValueError, RecursionError) as failure:
        raise error(f"{what} is no TOML ({str(failure)[:200]!r}).") from failure


def split_url(url: object, what: str, error: type[TabletopError]) -> SplitResult:
    """Split a foreign http(s) URL; its ``hostname`` and ``port`` can be read without an error.

    ``what`` begins the message of an error: "The link to the model". The URL is not repeated: it
    may hold a signature.

    Raises:
        TabletopError: ``error``, if it is no http(s) URL with a host.
    """
    if not isinstance(url, str):
        raise error(f"{what} must be an http(s) URL, not {type(url).__name__}.")
    if len(url) > MAX_URL_LENGTH:
        raise error(f"{what} has {len(url)} characters; at most {MAX_URL_LENGTH} are read.")
    try:
        parts = urlsplit(url)
        fine = parts.scheme in ("http", "https") and _HOST.fullmatch(parts.hostname or "")
        fine = parts.port != 0 and fine
        fine = fine and url.isascii() and url.isprintable() and " " not in url
    except ValueError:
        fine = False
    if not fine:
        raise error(
            f"{what} is no URL of the form https://host/path in ASCII, with other letters of a "
            "host as punycode (xn--...) and of a path as %XX."
        )
    return parts


def read_regular(
    path: str | Path, what: str, error: type[TabletopError], *, max_bytes: int
) -> bytes:
    """Read a regular file the user or a record names; never a pipe, a device or a folder.

    Links to regular files are followed. ``what`` begins the message of an error: "The depth map".

    Raises:
        TabletopError: ``error``, if it is missing, no regular file, larger than ``max_bytes``, or
            unreadable.
    """
    try:
        # A pipe without a writer would block the opening of it.
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        try:
            status = os.fstat(descriptor)
            regular, large = stat.S_ISREG(status.st_mode), status.st_size > max_bytes
            content = b""
            if regular and not large:
                with open(descriptor, "rb", closefd=False) as file:
                    content = file.read(max_bytes + 1)
        finally:
            os.close(descriptor)
    except (OSError, ValueError) as failure:
        reason = getattr(failure, "strerror", None) or failure
        raise error(f"{what} {str(path)!r} cannot be read: {reason}.") from failure
    if not regular:
        raise error(f"{what} {str(path)!r} is not a regular file. Name a file.")
    if large or len(content) > max_bytes:
        raise error(f"{what} {str(path)!r} is larger than {max_bytes} bytes, which is the limit.")
    return content


def printable(
    text: object, what: str, error: type[TabletopError], *, max_length: int = MAX_NAME_LENGTH
) -> str:
    """Return a name or a label that can be shown on a terminal: no controls, one line, bounded.

    Raises:
        TabletopError: ``error``, if it is not.
    """
    if not isinstance(text, str):
        raise error(f"{what} must be a text, not {type(text).__name__}.")
    if len(text) > max_length:
        raise error(f"{what} has {len(text)} characters; at most {max_length} are read.")
    if not text.isprintable():
        raise error(f"{what} {text!r} holds characters that cannot be printed.")
    return text


def is_number(value: object, *, minimum: float = 0.0, maximum: float = 1e12) -> bool:
    """Return whether a value of a foreign JSON text is a number in a range; ``true`` is none."""
    return type(value) in (int, float) and minimum <= value <= maximum  # type: ignore[operator]


def is_count(value: object) -> bool:
    """Return whether a value of a foreign JSON text is an integer from 0 to 1e12."""
    return type(value) is int and is_number(value)


def _not_json(what: str, error: type[TabletopError], failure: Exception) -> TabletopError:
    reason = str(failure)[:200] or type(failure).__name__
    return error(f"{what} is not valid JSON ({reason}).")


def _depth(bare: bytes) -> int:
    """Return how deep the brackets of a JSON text without its strings are nested."""
    brackets = bare.translate(None, _NOT_BRACKETS)
    return max(itertools.accumulate(map(_STEP.__getitem__, brackets)), default=0)


def _finite(text: str) -> float:
    value = float(text)
    return value if math.isfinite(value) else _not_finite(text)


def _not_finite(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a finite number")


_MAX_ARRAYS = 4096  # of a file
_COMPRESSIONS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}


def read_arrays(
    path: str | Path, what: str, error: type[TabletopError], *, max_bytes: int
) -> dict[str, np.ndarray]:
    """Read every array of a file, as ``numpy.savez`` writes it, compressed or not.

    ``what`` begins the message of an error: "The replay buffer". ``max_bytes`` is the most that the
    file, and all its arrays together, may have.

    Raises:
        TabletopError: ``error``, if it cannot be read, is damaged or too large, or holds pickles.
    """
    raw = read_regular(path, what, error, max_bytes=max_bytes)
    try:
        with zipfile.ZipFile(io.BytesIO(raw)) as packed:
            members = [m for m in packed.infolist() if m.filename.endswith(".npy")]
            if not {m.compress_type for m in members} <= _COMPRESSIONS:
                raise error(f"{what} {str(path)!r} is compressed in a way that NumPy never does.")
            if len(members) > _MAX_ARRAYS or sum(m.file_size for m in members) > max_bytes:
                raise error(f"{what} {str(path)!r} holds more than {max_bytes} bytes of arrays.")
            return {m.filename.removesuffix(".npy"): _array(packed.read(m)) for m in members}
    except (
        ValueError, KeyError, TypeError, EOFError, OverflowError, SyntaxError, RuntimeError,
        NotImplementedError, zipfile.BadZipFile, zlib.error,
    ) as failure:  # fmt: skip
        if isinstance(failure, TabletopError):
            raise
        reason = str(failure)[:200] or type(failure).__name__
        raise error(f"{what} {str(path)!r} holds no sound arrays ({reason!r}).") from failure


def _array(raw: bytes) -> np.ndarray:
    """Return the array of an npy file.

    Raises:
        ValueError: it is damaged, holds pickles, or has another size than its header claims.
    """
    file = io.BytesIO(raw)
    version = np.lib.format.read_magic(file)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"format {version} is not known")
    read = np.lib.format.read_array_header_1_0
    shape, _, kind = (read if version == (1, 0) else np.lib.format.read_array_header_2_0)(file)
    if min(shape, default=0) < 0 or kind.hasobject:
        raise ValueError("an array of pickles, or of a negative size")
    if math.prod(shape) * kind.itemsize != len(raw) - file.tell():
        raise ValueError(f"an array of shape {shape} in {len(raw)} bytes")
    file.seek(0)
    return np.lib.format.read_array(file, allow_pickle=False)
