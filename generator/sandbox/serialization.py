"""Serialization without pickle, for the pipes of a sandbox.

A packed value is a JSON document followed by the buffers that it refers to. Values are None, bool,
int, float, str, bytes, paths, NumPy arrays of numbers, lists, tuples, dicts with string keys, and
enum members and dataclasses of those. An array or bytes object that occurs twice is packed once and
unpacked as one object.
"""

from __future__ import annotations

import dataclasses
import enum
import json
import math
import re
import struct
from collections.abc import Callable, Mapping
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from ..errors import InputError, TabletopError
from ..io.bounded import check_json_size

_HEAD = struct.Struct("<4sQ")
_MAGIC = b"ttg1"
_ALIGN = 64  # bytes
_MAX_HEAD = 64 * 2**20  # bytes of the JSON document
_MAX_DEPTH = 64  # nesting of its lists and objects
_DTYPE = re.compile(r"[<>|=][biufc][0-9]{1,2}")


def pack(value: object) -> bytes:
    """Return a value as bytes; see ``packed_parts``."""
    return b"".join(packed_parts(value))


def packed_parts(value: object) -> list[bytes | memoryview]:
    """Return a value as chunks of bytes, without copying its arrays.

    Raises:
        TypeError: the value contains an object of an unsupported type.
    """
    packer = _Packer()
    tree = packer.tree(value)
    sizes = [len(buffer) for buffer in packer.buffers]
    head = json.dumps({"tree": tree, "sizes": sizes}).encode()
    parts: list[bytes | memoryview] = [_HEAD.pack(_MAGIC, len(head)), head]
    for buffer in packer.buffers:
        parts += [buffer, bytes(-len(buffer) % _ALIGN)]
    return parts


def unpack(raw: bytes | memoryview, find_class: Callable[[str], type]) -> Any:
    """Return the value packed in ``raw``; its arrays are read-only views of ``raw``.

    ``find_class`` returns the class with a name such as "tabletop_objects.values:Mesh", or raises
    ``ValueError`` if the class is not expected.

    Raises:
        ValueError: the bytes are not a packed value.
        TabletopError: the constructor of a class rejects its values.
    """
    try:
        magic, length = _HEAD.unpack_from(raw)
        if magic != _MAGIC or length > len(raw) - _HEAD.size:
            raise ValueError("not a packed value")
        text = bytes(raw[_HEAD.size : _HEAD.size + min(length, _MAX_HEAD + 1)])
        document = _parse(text)
        start, buffers = _HEAD.size + length, []
        for size in document["sizes"]:
            if not 0 <= size <= len(raw) - start:
                raise ValueError("a truncated buffer")
            buffers.append(memoryview(raw)[start : start + size])
            start += size + -size % _ALIGN
        return _Unpacker(buffers, find_class).value(document["tree"])
    except TabletopError:
        raise
    except Exception as error:  # any exception caused by damaged bytes
        raise ValueError(f"not a packed value ({type(error).__name__}: {error})") from error


def _parse(text: bytes) -> Any:
    try:
        check_json_size(text, "the document", InputError, max_bytes=_MAX_HEAD, max_depth=_MAX_DEPTH)
    except InputError as error:
        raise ValueError(str(error)) from error
    return json.loads(text)


def class_name(kind: type) -> str:
    """Return the name by which packed values refer to a class."""
    return f"{kind.__module__}:{kind.__qualname__}"


class _Packer:
    def __init__(self) -> None:
        self.buffers: list[bytes | memoryview] = []
        self._places: dict[int, int] = {}
        self._held: list[object] = []  # keeps the objects alive, so that their ids stay unique

    def tree(self, value: object) -> object:
        """Return the JSON representation of a value."""
        if isinstance(value, enum.Enum):
            return {"enum": class_name(type(value)), "name": value.name}
        if value is None or isinstance(value, bool | str):
            return value
        if isinstance(value, int | np.integer):
            return int(value)
        if isinstance(value, float | np.floating):
            return float(value)
        if isinstance(value, bytes):
            return {"bytes": self._place(value, value)}
        if isinstance(value, PurePath):
            return {"path": str(value)}
        if isinstance(value, np.ndarray):
            return self._array(value)
        if isinstance(value, list):
            return [self.tree(v) for v in value]
        if isinstance(value, tuple):
            return {"tuple": [self.tree(v) for v in value]}
        if isinstance(value, Mapping):
            if not all(isinstance(key, str) for key in value):
                raise TypeError("keys of a packed dict must be strings")
            return {"dict": {key: self.tree(v) for key, v in value.items()}}
        if dataclasses.is_dataclass(value) and not isinstance(value, type):
            fields = [f.name for f in dataclasses.fields(value) if f.init]
            values = {name: self.tree(getattr(value, name)) for name in fields}
            return {"class": class_name(type(value)), "fields": values}
        raise TypeError(f"{type(value).__name__} cannot be packed")

    def _array(self, array: np.ndarray) -> object:
        if array.dtype.kind not in "biufc":
            raise TypeError(f"an array of {array.dtype} cannot be packed")
        flat = np.ascontiguousarray(array).reshape(-1).view(np.uint8)
        place = self._place(array, flat.data)
        return {"array": place, "dtype": array.dtype.str, "shape": list(array.shape)}

    def _place(self, source: object, buffer: bytes | memoryview) -> int:
        if id(source) not in self._places:
            self._held.append(source)
            self._places[id(source)] = len(self.buffers)
            self.buffers.append(buffer)
        return self._places[id(source)]


class _Unpacker:
    def __init__(self, buffers: list[memoryview], find_class: Callable[[str], type]) -> None:
        self._buffers = buffers
        self._find_class = find_class
        self._arrays: dict[tuple[int, str, tuple[int, ...]], np.ndarray] = {}
        self._copies: dict[int, bytes] = {}

    def value(self, tree: Any) -> Any:
        """Return the value represented by a JSON tree."""
        if isinstance(tree, list):
            return [self.value(v) for v in tree]
        if not isinstance(tree, dict):
            return tree
        if "array" in tree:
            return self._array(tree["array"], str(tree["dtype"]), tuple(map(int, tree["shape"])))
        if "bytes" in tree:
            return self._bytes(tree["bytes"])
        if "tuple" in tree:
            return tuple(self.value(v) for v in tree["tuple"])
        if "dict" in tree:
            return {str(key): self.value(v) for key, v in tree["dict"].items()}
        if "path" in tree:
            return Path(tree["path"])
        if "enum" in tree:
            return self._find_class(tree["enum"])[tree["name"]]  # type: ignore[index]
        kind = self._find_class(tree["class"])
        return kind(**{name: self.value(v) for name, v in tree["fields"].items()})

    def _bytes(self, place: int) -> bytes:
        if place not in self._copies:
            self._copies[place] = bytes(self._buffers[place])
        return self._copies[place]

    def _array(self, place: int, kind: str, shape: tuple[int, ...]) -> np.ndarray:
        key = place, kind, shape
        if key not in self._arrays:
            if not _DTYPE.fullmatch(kind):
                raise ValueError(f"an array of {kind[:20]!r}")
            dtype = np.dtype(kind)
            buffer = self._buffers[place]
            size = math.prod(shape) * dtype.itemsize
            if min(shape, default=0) < 0 or size != len(buffer):
                raise ValueError(f"an array of shape {shape} and {kind} in {len(buffer)} bytes")
            self._arrays[key] = np.frombuffer(buffer, dtype).reshape(shape)
        return self._arrays[key]
