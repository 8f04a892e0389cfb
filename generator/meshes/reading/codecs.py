"""Reading and writing of GLB containers; compressed or quantised meshes become plain glTF 2.0.

Draco (``KHR_draco_mesh_compression``) is decoded by DracoPy, meshopt (``EXT_meshopt_compression``)
by meshoptimizer. Quantised attributes (``KHR_mesh_quantization``) become floats, and their texture
coordinates are transformed as ``KHR_texture_transform`` specifies (files with rotated textures are
still rejected). Like all mesh readers, this code runs in the caller's child process.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from jaxtyping import Float

from ...backends.requirements import module
from ...errors import BackendError
from ...io.bounded import parse_object
from . import bounds
from .flat_glb import FAN, JSON_CHUNK, STRIP, TRIANGLES, Header, base_color

DRACO = "KHR_draco_mesh_compression"
MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
QUANTIZED = "KHR_mesh_quantization"

_DECODED = frozenset({DRACO, *MESHOPT, QUANTIZED})
_TRANSFORM = "KHR_texture_transform"
_INSTALL = "Install tabletopgen[gltf], or export the file uncompressed."
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_SHOWN = ("POSITION", "TEXCOORD_0", "COLOR_0")


def plain_glb(raw: bytes, what: str) -> bytes:
    """Return a GLB file without the extensions that this module decodes; other files are unchanged.

    The positions, texture coordinates and colours of the meshes' triangles are kept.

    Raises:
        BackendError: the compressed data is damaged, or the decoder is not installed.
    """
    try:
        header, data = split_glb(raw, what)
    except BackendError:  # inspection of the returned file raises the error
        return raw
    used = {*_names(header, "extensionsUsed"), *_names(header, "extensionsRequired")} & _DECODED
    if not used:
        return raw
    if DRACO in used:
        module("DracoPy", f"{what} is compressed with {DRACO}: reading it", _INSTALL)
    if used & {*MESHOPT}:
        module("meshoptimizer", f"{what} is compressed with meshopt: reading it", _INSTALL)
    try:
        return _Rewriter(header, data).run()
    except MemoryError:  # handled by the sandbox
        raise
    except Exception as error:  # for malformed files, decoders raise many types of errors
        raise BackendError(
            f"{what} cannot be decompressed ({type(error).__name__}: {error}). Export it "
            "uncompressed."
        ) from error


def _names(header: Header, key: str) -> Sequence[str]:
    listed = header.get(key)
    return [n for n in listed if isinstance(n, str)] if isinstance(listed, list) else []


class _Rewriter:
    """Writes a new binary chunk with plain attributes, and a header that refers to it."""

    def __init__(self, header: Header, data: bytes) -> None:
        self._header, self._data = header, data
        self._views: dict[int, bytes] = {}
        self._written = bytearray()
        self._new: dict[str, list[Any]] = {"bufferViews": [], "accessors": []}
        self._kept: dict[tuple[Any, ...], int] = {}

    def run(self) -> bytes:
        """Return the rewritten file."""
        header = self._header
        meshes = [
            {**mesh, "primitives": [self._primitive(p) for p in mesh["primitives"] if _fits(p)]}
            for mesh in header.get("meshes", ())
        ]
        images = [
            {**image, "bufferView": self._view(self._view_bytes(image["bufferView"]))}
            if "bufferView" in image else image for image in header.get("images", ())
        ]  # fmt: skip
        dropped = {"bufferViews", "accessors", "animations", "skins"}
        plain = {key: value for key, value in header.items() if key not in dropped}
        for key in ("extensionsUsed", "extensionsRequired"):
            plain[key] = [name for name in header.get(key, ()) if name not in _DECODED]
        plain |= {"meshes": meshes, **self._new, "buffers": [{"byteLength": len(self._written)}]}
        if images:
            plain["images"] = images
        if "materials" in header:
            plain["materials"] = [_drop_transform(material) for material in header["materials"]]
        return join_glb(plain, bytes(self._written))

    def _primitive(self, given: Header) -> dict[str, Any]:
        attributes, indices = self._columns(given)
        transform = _transform_of(self._header, given)
        if transform is not None and "TEXCOORD_0" in attributes:
            attributes["TEXCOORD_0"] = _move_texture(attributes["TEXCOORD_0"], transform)
        plain = {key: given[key] for key in ("mode", "material") if key in given}
        plain["attributes"] = {name: self._accessor(a) for name, a in attributes.items()}
        if indices is not None:
            plain["indices"] = self._accessor(indices.reshape(-1, 1).astype(np.uint32))
        return plain

    def _columns(self, given: Header) -> tuple[dict[str, np.ndarray], np.ndarray | None]:
        """Return the attributes of a primitive by name, and its indices."""
        named: Mapping[str, int] = given["attributes"]
        packed = given.get("extensions", {}).get(DRACO)
        if packed is None:
            columns = {n: self._column(k) for n, k in named.items() if n in _SHOWN}
            indices = self._raw(given["indices"]) if "indices" in given else None
            return columns, indices
        import DracoPy

        mesh = DracoPy.decode(self._view_bytes(packed["bufferView"]))
        columns = {}
        for name, unique in packed["attributes"].items():
            if name in _SHOWN:
                accessor = self._header["accessors"][named[name]]
                values = mesh.get_attribute_by_unique_id(unique)["data"]
                columns[name] = _floats(np.asarray(values), accessor)
        return columns, np.asarray(mesh.faces)

    def _column(self, index: int) -> Float[np.ndarray, "n k"]:
        return _floats(self._raw(index), self._header["accessors"][index])

    def _raw(self, index: int) -> np.ndarray:
        """Return the stored numbers of an accessor, in the shape (count, columns)."""
        accessor = self._header["accessors"][index]
        if "sparse" in accessor:
            raise ValueError("sparse accessors are not supported")
        view = self._header["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(_TYPES[accessor["componentType"]]), _COLUMNS[accessor["type"]]
        content = self._view_bytes(accessor["bufferView"])
        step = view.get("byteStride") or kind.itemsize * width
        start, count = accessor.get("byteOffset", 0), accessor["count"]
        end = start + step * (count - 1) + kind.itemsize * width
        if count < 1 or start < 0 or step < kind.itemsize * width or end > len(content):
            raise ValueError(f"accessor {index} is larger than its buffer view")
        return np.ndarray((count, width), kind, content, start, (step, kind.itemsize)).copy()

    def _view_bytes(self, index: int) -> bytes:
        """Return the content of a buffer view, decompressed."""
        if index not in self._views:
            view = self._header["bufferViews"][index]
            packed = view.get("extensions", {})
            coded = next((packed[name] for name in MESHOPT if name in packed), None)
            content = self._slice(view if coded is None else coded)
            self._views[index] = content if coded is None else _meshopt(coded, content)
        return self._views[index]

    def _slice(self, place: Header) -> bytes:
        start, size = place.get("byteOffset", 0), place["byteLength"]
        if place["buffer"] != 0 or not 0 <= start <= start + size <= len(self._data):
            raise ValueError("a buffer view is outside the binary chunk")
        return self._data[start : start + size]

    def _accessor(self, column: np.ndarray) -> int:
        """Write an attribute and return its accessor; equal attributes share an accessor."""
        column = np.ascontiguousarray(column)
        key = (column.dtype.str, column.shape, column.tobytes())
        if key not in self._kept:
            kinds = {width: name for name, width in _COLUMNS.items()}
            self._kept[key] = len(self._new["accessors"])
            self._new["accessors"].append({
                "bufferView": self._view(column.tobytes()), "count": len(column),
                "componentType": 5125 if column.dtype == np.uint32 else 5126,
                "type": kinds[column.shape[1]],
            })  # fmt: skip
        return self._kept[key]

    def _view(self, content: bytes) -> int:
        self._written += b"\0" * (-len(self._written) % 4)
        place = {"buffer": 0, "byteOffset": len(self._written), "byteLength": len(content)}
        self._written += content
        self._new["bufferViews"].append(place)
        return len(self._new["bufferViews"]) - 1


def _fits(primitive: Header) -> bool:
    mode = primitive.get("mode", TRIANGLES)
    return mode in (TRIANGLES, STRIP, FAN) and "POSITION" in primitive["attributes"]


def _floats(values: np.ndarray, accessor: Header) -> Float[np.ndarray, "n k"]:
    """Return quantised numbers as floats; normalised ones are in [-1, 1], as glTF specifies."""
    floats = values.astype(np.float32)
    if accessor.get("normalized") and values.dtype.kind in "iu":
        return np.maximum(floats / np.float32(np.iinfo(values.dtype).max), np.float32(-1.0))
    return floats


def _meshopt(coded: Header, content: bytes) -> bytes:
    """Return a buffer view decompressed with meshopt."""
    import meshoptimizer

    count, stride = int(coded["count"]), int(coded["byteStride"])
    mode, filtered = coded["mode"], coded.get("filter", "NONE")
    if mode == "ATTRIBUTES":
        items = meshoptimizer.decode_vertex_buffer(
            count, stride, content, dtype=np.dtype((np.void, stride))
        )
        values = np.frombuffer(items.tobytes(), np.uint8).copy()
        if filtered != "NONE":
            kinds = {"OCTAHEDRAL": "oct", "QUATERNION": "quat", "EXPONENTIAL": "exp"}
            decode = getattr(meshoptimizer, f"decode_filter_{kinds[filtered]}")
            values = decode(values, count, stride)
        return np.asarray(values).tobytes()[: count * stride]
    if mode == "TRIANGLES":
        found = meshoptimizer.decode_index_buffer(count, 4, content)
    elif mode == "INDICES":
        found = meshoptimizer.decode_index_sequence(count, 4, content)
    else:
        raise ValueError(f"unknown meshopt mode {mode!r}")
    return np.asarray(found, np.uint32).astype({2: "<u2", 4: "<u4"}[stride]).tobytes()


def _transform_of(header: Header, primitive: Header) -> Header | None:
    """Return the texture transform of a primitive's base colour, or None if it has none."""
    if "material" not in primitive:
        return None
    return _transform(header["materials"][primitive["material"]])


def _transform(material: Header) -> Header | None:
    """Return the transform of a material's colour texture, or None if it is absent or rotated."""
    color = base_color(material).get("baseColorTexture", {})
    transform = color.get("extensions", {}).get(_TRANSFORM)
    return None if transform is None or transform.get("rotation") else transform


def _move_texture(uv: Float[np.ndarray, "n 2"], transform: Header) -> Float[np.ndarray, "n 2"]:
    scale = np.array(transform.get("scale", (1, 1)), np.float64).reshape(2)
    offset = np.array(transform.get("offset", (0, 0)), np.float64).reshape(2)
    return (uv[:, :2] * scale + offset).astype(np.float32)


def _drop_transform(material: Header) -> Header:
    """Return a material without the texture transform, which the coordinates now include."""
    if _transform(material) is None:
        return material
    plain = dict(base_color(material))
    color = dict(plain["baseColorTexture"])
    color["extensions"] = {k: v for k, v in color["extensions"].items() if k != _TRANSFORM}
    return {**material, "pbrMetallicRoughness": {**plain, "baseColorTexture": color}}


_BINARY_CHUNK = 0x004E4942


def split_glb(raw: bytes, what: str) -> tuple[Header, bytes]:
    """Return the JSON header and the binary chunk (empty if absent) of a GLB file.

    ``what`` names the file in messages.

    Raises:
        BackendError: the file is not a GLB, is truncated, or is too large.
    """
    check_size(raw, what, bounds.MOST_BYTES)
    if raw[:4] != b"glTF" or len(raw) < 20:
        raise BackendError(
            f"{what} is not a GLB file: its {len(raw)} bytes begin with {raw[:12]!r}. Binary glTF "
            "2.0 is supported."
        )
    version, length, size, kind = struct.unpack("<4I", raw[4:20])
    if version != 2 or kind != JSON_CHUNK:
        raise BackendError(f"{what} is glTF version {version}; binary glTF 2.0 is supported.")
    if length > len(raw) or size > length - 20:
        raise BackendError(f"{what} is truncated: it has {len(raw)} of {max(length, size)} bytes.")
    text, problem = raw[20 : 20 + size], f"{what} has a damaged header: it"
    header = parse_object(text, problem, BackendError, max_bytes=bounds.MOST_HEADER)
    return header, raw[28 + size :]


def join_glb(header: Header, data: bytes) -> bytes:
    """Return the GLB file made of a header and a binary chunk."""
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    size = 28 + len(text) + len(data)
    head = struct.pack("<4s4I", b"glTF", 2, size, len(text), JSON_CHUNK)
    return head + text + struct.pack("<2I", len(data), _BINARY_CHUNK) + data


def check_size(raw: bytes, what: str, maximum: int) -> None:
    """Check that a file is not too large.

    Raises:
        BackendError: the file has more than ``maximum`` bytes.
    """
    if len(raw) > maximum:
        raise BackendError(
            f"{what} has {len(raw) / 2**20:.0f} MiB; at most {maximum // 2**20} are allowed."
        )
