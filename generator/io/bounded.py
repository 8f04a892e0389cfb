"""Bounded readers of untrusted input: JSON, URLs, regular files, printable text and npz files.

Everything from outside the process (a bundle, a server's answer, a record in a shared folder, a
file that the user names) is untrusted until one of these functions has checked it. Each takes the
error class to raise.
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
"""Maximum length of a name or a label, in characters."""

_MAX_DEPTH = 64  # nesting of lists and objects in a JSON text
_MAX_JSON_BYTES = 64 * 2**20  # default limit
# lists, objects and commas of a JSON text; each takes up to 72 bytes of memory
_MAX_VALUES = 4_000_000
# possessive quantifiers: linear time
_STRING = re.compile(rb'"[^"\\]*+(?:\\.[^"\\]*+)*+"?', re.DOTALL)
_PART = rb'(?:[\w-]++|"[^"\n]*+"|\'[^\'\n]*+\')[ \t]*+'  # one part of a dotted key
_DOTTED = re.compile(
    rb"(?m:^|[\[{,])[ \t]*+" + _PART + rb"(?:\.[ \t]*+" + _PART + rb"){%d}" % _MAX_DEPTH
)
_HOST = re.compile(r"[\w.:%-]+", re.ASCII)  # the colons belong to IPv6 addresses
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
    """Parse an untrusted JSON text; all numbers must be finite and all strings valid Unicode.

    ``what`` is the start of error messages, such as "The answer of the server". ``max_bytes``
    limits the length, ``max_depth`` the nesting of lists and objects.

    Raises:
        TabletopError: ``error``, if the text is too long, too deeply nested or invalid.
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
        if rb"\u" in data:  # an escape may encode half a surrogate pair, which is not valid Unicode
            json.dumps(payload, ensure_ascii=False).encode()
    except (ValueError, RecursionError) as failure:
        raise _not_json(what, error, failure) from failure
    return payload


def check_json_size(
    data: bytes, what: str, error: type[TabletopError], *, max_bytes: int, max_depth: int
) -> None:
    """Check the length, number of values and nesting of a JSON text before it is parsed.

    Raises:
        TabletopError: ``error``, if the text exceeds a limit; see :func:`parse_json`.
    """
    if len(data) > max_bytes:
        raise error(f"{what} has {len(data)} bytes of JSON; the limit is {max_bytes}.")
    bare = _STRING.sub(b"", data)
    if bare.count(b",") + bare.count(b"[") + bare.count(b"{") > _MAX_VALUES:
        raise error(f"{what} exceeds the limit of {_MAX_VALUES} values.")
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
    """Parse an untrusted JSON text that must be an object; see :func:`parse_json`.

    Raises:
        TabletopError: ``error``, if the text is invalid or not an object.
    """
    payload = parse_json(raw, what, error, max_bytes=max_bytes, max_depth=max_depth)
    if not isinstance(payload, dict):
        raise error(f"{what} must be a JSON object, not {type(payload).__name__}.")
    return payload


def parse_toml(raw: bytes, what: str, error: type[TabletopError]) -> dict[str, Any]:
    """Parse an untrusted TOML text (UTF-8); the caller limits its length.

    ``what`` is the start of error messages, such as "The price table".

    Raises:
        TabletopError: ``error``, if the text is invalid or nested too deeply, by brackets or by
            dotted keys.
    """
    if _depth(raw) > _MAX_DEPTH or _DOTTED.search(raw):
        raise error(f"{what} nests tables deeper than {_MAX_DEPTH} levels.")
    try:
        return tomllib.loads(raw.decode("utf-8-sig"))
    except (ValueError, RecursionError) as failure:
        raise error(f"{what} is not valid TOML ({str(failure)[:200]!r}).") from failure


def split_url(url: object, what: str, error: type[TabletopError]) -> SplitResult:
    """Split an untrusted http(s) URL; its ``hostname`` and ``port`` are then safe to read.

    ``what`` is the start of error messages, such as "The link to the model". Messages omit the URL,
    since it may contain a signature.

    Raises:
        TabletopError: ``error``, if it is not an http(s) URL with a host.
    """
    if not isinstance(url, str):
        raise error(f"{what} must be an http(s) URL, not {type(url).__name__}.")
    if len(url) > MAX_URL_LENGTH:
        raise error(f"{what} has {len(url)} characters; the limit is {MAX_URL_LENGTH}.")
    try:
        parts = urlsplit(url)
        fine = parts.scheme in ("http", "https") and _HOST.fullmatch(parts.hostname or "")
        fine = parts.port != 0 and fine
        fine = fine and url.isascii() and url.isprintable() and " " not in url
    except ValueError:
        fine = False
    if not fine:
        raise error(
            f"{what} must be a URL of the form https://host/path in ASCII. Write other letters "
            "of a host as punycode (xn--...) and of a path as %XX."
        )
    return parts


def read_regular(
    path: str | Path, what: str, error: type[TabletopError], *, max_bytes: int
) -> bytes:
    """Read a regular file named by the user or a record; reject pipes, devices and folders.

    Links to regular files are followed. ``what`` is the start of error messages, such as "The depth
    map".

    Raises:
        TabletopError: ``error``, if the file is missing, not a regular file, larger than
            ``max_bytes``, or unreadable.
    """
    try:
        # Opening a pipe without a writer would block.
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
        raise error(f"{what} {str(path)!r} is not a regular file. Pass the path of a file.")
    if large or len(content) > max_bytes:
        raise error(f"{what} {str(path)!r} is larger than the limit of {max_bytes} bytes.")
    return content


def printable(
    text: object, what: str, error: type[TabletopError], *, max_length: int = MAX_NAME_LENGTH
) -> str:
    """Return a name or label that is safe to print: a short line without control characters.

    Raises:
        TabletopError: ``error``, if it is not.
    """
    if not isinstance(text, str):
        raise error(f"{what} must be a string, not {type(text).__name__}.")
    if len(text) > max_length:
        raise error(f"{what} has {len(text)} characters; the limit is {max_length}.")
    if not text.isprintable():
        raise error(f"{what} {text!r} contains characters that cannot be printed.")
    return text


def is_number(value: object, *, minimum: float = 0.0, maximum: float = 1e12) -> bool:
    """Return whether a value of an untrusted JSON text is a number in a range; booleans are not."""
    return type(value) in (int, float) and minimum <= value <= maximum  # type: ignore[operator]


def is_count(value: object) -> bool:
    """Return whether a value of an untrusted JSON text is an integer from 0 to 1e12."""
    return type(value) is int and is_number(value)


def _not_json(what: str, error: type[TabletopError], failure: Exception) -> TabletopError:
    reason = str(failure)[:200] or type(failure).__name__
    return error(f"{what} is not valid JSON ({reason}).")


def _depth(bare: bytes) -> int:
    """Return the bracket nesting depth of a JSON text whose strings have been removed."""
    brackets = bare.translate(None, _NOT_BRACKETS)
    return max(itertools.accumulate(map(_STEP.__getitem__, brackets)), default=0)


def _finite(text: str) -> float:
    value = float(text)
    return value if math.isfinite(value) else _not_finite(text)


def _not_finite(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is not a finite number")


_MAX_ARRAYS = 4096  # limit per file
_COMPRESSIONS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}


def read_arrays(
    path: str | Path, what: str, error: type[TabletopError], *, max_bytes: int
) -> dict[str, np.ndarray]:
    """Read all arrays of an npz file written by ``numpy.savez`` or ``numpy.savez_compressed``.

    ``what`` is the start of error messages, such as "The replay buffer". ``max_bytes`` limits the
    size of the file and the total size of its arrays.

    Raises:
        TabletopError: ``error``, if the file is unreadable, damaged or too large, or contains
            pickles.
    """
    raw = read_regular(path, what, error, max_bytes=max_bytes)
    try:
        with zipfile.ZipFile(io.BytesIO(raw)) as packed:
            members = [m for m in packed.infolist() if m.filename.endswith(".npy")]
            if not {m.compress_type for m in members} <= _COMPRESSIONS:
                raise error(f"{what} {str(path)!r} uses a compression that NumPy never writes.")
            if len(members) > _MAX_ARRAYS or sum(m.file_size for m in members) > max_bytes:
                raise error(
                    f"{what} {str(path)!r} exceeds the limit of {max_bytes} bytes of arrays."
                )
            return {m.filename.removesuffix(".npy"): _array(packed.read(m)) for m in members}
    except (
        ValueError, KeyError, TypeError, EOFError, OverflowError, SyntaxError, RuntimeError,
        NotImplementedError, zipfile.BadZipFile, zlib.error,
    ) as failure:  # fmt: skip
        if isinstance(failure, TabletopError):
            raise
        reason = str(failure)[:200] or type(failure).__name__
        raise error(f"{what} {str(path)!r} is not a valid npz file ({reason!r}).") from failure


def _array(raw: bytes) -> np.ndarray:
    """Return the array of an npy file.

    Raises:
        ValueError: the file is damaged, contains pickles, or differs in size from what its header
            states.
    """
    file = io.BytesIO(raw)
    version = np.lib.format.read_magic(file)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"unknown format {version}")
    read = np.lib.format.read_array_header_1_0
    shape, _, kind = (read if version == (1, 0) else np.lib.format.read_array_header_2_0)(file)
    if min(shape, default=0) < 0 or kind.hasobject:
        raise ValueError("an array of pickles or of negative size")
    if math.prod(shape) * kind.itemsize != len(raw) - file.tell():
        raise ValueError(f"an array of shape {shape} in {len(raw)} bytes")
    file.seek(0)
    return np.lib.format.read_array(file, allow_pickle=False)
