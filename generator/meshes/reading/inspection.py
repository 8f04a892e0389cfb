"""Checks of a foreign mesh file, made before any part of it is decoded."""

from __future__ import annotations

import base64
import binascii
import hashlib
import re
from collections import Counter
from collections.abc import Iterable

from ...errors import BackendError, InputError
from ...pictures import read_header
from . import bounds
from .codecs import check_size, plain_glb, split_glb
from .flat_glb import FAN, STRIP, TRIANGLES, Crooked, Header, base_color, picture_of, shown_nodes
from .textures import TEXTURE_LIMITS

_LONG_LINE = re.compile(rb"^[^\n]{%d}" % (bounds.MOST_LINE + 1), re.MULTILINE)
_FACE = re.compile(rb"\nf[^\n]*+")
_MOST = {
    "nodes": bounds.MOST_NODES, "meshes": bounds.MOST_MESHES,
    **dict.fromkeys(("materials", "textures", "images", "scenes"), bounds.MOST_MATERIALS),
    **dict.fromkeys(("accessors", "bufferViews"), bounds.MOST_COLUMNS), "buffers": 100,
}  # fmt: skip

_COMPRESSED = {
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression",
    "KHR_texture_basisu",
}  # fmt: skip
_UNDERSTOOD = ("KHR_materials_", "KHR_lights_punctual", "EXT_texture_webp", "KHR_texture_transform")
_COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_WIDTHS = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_DAMAGE = (KeyError, IndexError, TypeError, AttributeError, ValueError, OverflowError)


def inspect_glb(
    raw: bytes,
    what: str,
    most_faces: int = bounds.MOST_FACES,
    most_texels: int = bounds.MOST_TEXELS_TOGETHER,
) -> Header:
    """Return the JSON header of a GLB file (glTF 2.0) after checking that it is safe to read.

    ``what`` names the file in messages. Files are rejected if their meshes have more than
    ``most_faces`` triangles in total, including repetitions, or if their distinct colour textures
    have more than ``most_texels`` pixels in total.

    Raises:
        BackendError: the file is not a GLB, is truncated, too large or compressed, refers to
            external files, has no triangles, or has a picture that is unreadable or too large.
    """
    header, data = split_glb(raw, what)
    try:
        reason = (
            _counts(header)
            or _extensions(header)
            or _links(header)
            or _amounts(header, len(raw))
            or _faces(header, most_faces)
            or _pictures(header, data, most_texels)
        )
    except Crooked as error:
        reason = f"is damaged: {error}. Export it again."
    except _DAMAGE as error:
        reason = f"is damaged ({type(error).__name__}: {error}). Export it again."
    if reason:
        raise BackendError(f"{what} {reason}")
    return header


def open_glb(raw: bytes, what: str, most_faces: int = bounds.MOST_FACES) -> tuple[bytes, Header]:
    """Return a GLB file without compression, and its header; see ``plain_glb`` and ``inspect_glb``.

    Raises:
        BackendError: the file cannot be read.
    """
    plain = plain_glb(raw, what)
    return plain, inspect_glb(plain, what, most_faces)


def inspect_obj(raw: bytes, what: str, most_faces: int = bounds.MOST_FACES) -> None:
    """Check that an OBJ file is a text that contains faces, but not too many triangles.

    Raises:
        BackendError: it is not such a file, or it is too large.
    """
    check_size(raw, what, bounds.MOST_OBJ_BYTES)
    if b"\0" in raw[:4096]:
        raise BackendError(f"{what} is not an OBJ file, since it is not text. Export it again.")
    text = b"\n" + raw.replace(b"\r\n", b"\n").replace(b"\\\n", b"")  # lines may be continued
    count = text.count(b"\nf")
    if not 0 < count <= most_faces:
        raise BackendError(f"{what} has {count} faces; 1 to {most_faces} are allowed.")
    for kind in (b"v", b"vt", b"vn"):
        count = text.count(b"\n" + kind + b" ") + text.count(b"\n" + kind + b"\t")
        if count > 3 * most_faces:
            name = "vertices" if kind == b"v" else f"lines {kind.decode()!r}"
            raise BackendError(f"{what} has {count} {name}; at most {3 * most_faces} are allowed.")
    count = text.count(b"usemtl") + text.count(b"\no") + text.count(b"\ng")
    if count > bounds.MOST_GROUPS:
        raise BackendError(
            f"{what} changes material, object or group {count} times; at most "
            f"{bounds.MOST_GROUPS} are allowed. Sort its faces by material."
        )
    check_lines(text, what)
    count = sum(max(len(face[0].split()) - 3, 0) for face in _FACE.finditer(text))
    if count > most_faces:
        raise BackendError(f"{what} has {count} triangles; 1 to {most_faces} are allowed.")


def check_lines(text: bytes, what: str) -> None:
    """Check that no line of a file is longer than the limit.

    Raises:
        BackendError: a line is too long.
    """
    if _LONG_LINE.search(text):
        raise BackendError(f"{what} has a line that exceeds the limit of {bounds.MOST_LINE} bytes.")


def check_pictures(
    pictures: Iterable[bytes], maximum: int = bounds.MOST_TEXELS_TOGETHER
) -> str | None:
    """Return the reason why pictures cannot be used, or None; only their headers are read.

    ``maximum`` limits the total number of pixels; identical pictures count once.
    """
    sizes: dict[bytes, int] = {}
    for raw in pictures:
        try:
            header = read_header(raw, "has a texture that", InputError, TEXTURE_LIMITS)
        except InputError as error:
            return str(error)
        sizes[hashlib.sha256(raw).digest()] = header.width * header.height
        if sum(sizes.values()) > maximum:
            return (
                f"has textures with more than {maximum} pixels in total. Use smaller or fewer "
                "textures."
            )
    return None


def _counts(header: Header) -> str | None:
    for name, most in _MOST.items():
        listed = header.get(name, [])
        if not isinstance(listed, list) or not all(isinstance(entry, dict) for entry in listed):
            return f"is damaged: its {name} are not a list of objects. Export it again."
        if len(listed) > most:
            return f"has {len(listed)} {name}; at most {most} are allowed. Merge some of them."
    return None


def _extensions(header: Header) -> str | None:
    required = set(header.get("extensionsRequired", ()))
    compressed = sorted(_COMPRESSED & (required | set(header.get("extensionsUsed", ()))))
    if compressed:
        return (
            f"is compressed with {', '.join(compressed)}, which is not supported. Export it "
            "uncompressed."
        )
    foreign = sorted(name for name in required if not name.startswith(_UNDERSTOOD))
    if foreign:
        return f"requires {', '.join(foreign)}, which is not supported. Export plain glTF 2.0."
    for material in header.get("materials", ()):
        color = base_color(material).get("baseColorTexture", {})
        if "KHR_texture_transform" in color.get("extensions", {}):
            return "uses KHR_texture_transform, which is not supported. Apply it to the UV map."
    return None


def _links(header: Header) -> str | None:
    for entry in (*header.get("buffers", ()), *header.get("images", ())):
        if not (uri := entry.get("uri", "data:")).startswith("data:"):
            return (
                f"refers to an external file, {uri[:80]!r}. Export one GLB that contains "
                "everything."
            )
    return None


def _amounts(header: Header, size: int) -> str | None:
    claimed = 0
    for accessor in header.get("accessors", ()):
        if "bufferView" not in accessor or "sparse" in accessor:
            return "has sparse or empty accessors, which are not supported. Export plain glTF 2.0."
        count = int(accessor["count"])
        if count < 0:
            return f"is damaged (an accessor of {count} elements). Export it again."
        claimed += count * _COLUMNS[accessor["type"]] * _WIDTHS[accessor["componentType"]]
    if claimed > bounds.CLAIMED * size:
        return f"is damaged: its accessors claim {claimed} bytes, but the file has {size}."
    lengths = [int(view["byteLength"]) for view in header.get("bufferViews", ())]
    if sum(lengths) > bounds.CLAIMED * size or min(lengths, default=0) < 0:
        return f"is damaged: its views claim {sum(lengths)} bytes, but the file has {size}."
    return None


def _faces(header: Header, maximum: int) -> str | None:
    """Count the triangles drawn in all scenes; a mesh at two nodes counts twice."""
    per_mesh = [_mesh_amounts(header, mesh) for mesh in header.get("meshes", ())]
    if sum(parts for *_, parts in per_mesh) > bounds.MOST_MESHES:
        return f"has more than {bounds.MOST_MESHES} primitives in its meshes. Merge some of them."
    drawn: Counter[int] = Counter()
    for count, node in enumerate(shown_nodes(header), 1):
        if count > bounds.MOST_NODES:
            return f"has more than {bounds.MOST_NODES} nodes in its scenes. Merge some of them."
        if "mesh" in node:
            drawn[int(node["mesh"])] += 1
    if drawn and not 0 <= min(drawn) <= max(drawn) < len(per_mesh):
        return "is damaged: a node refers to a missing mesh. Export it again."
    faces, vertices, parts = (
        sum(times * per_mesh[mesh][k] for mesh, times in drawn.items()) for k in range(3)
    )
    if not 0 < faces <= maximum:
        return f"has {faces} triangles; 1 to {maximum} are allowed."
    if vertices > 3 * maximum:
        return (
            f"has {vertices} vertices; at most {3 * maximum} are allowed. Remove unused vertices."
        )
    if parts > bounds.MOST_PARTS:
        return (
            f"has {parts} primitives; at most {bounds.MOST_PARTS} are allowed. Merge some of them."
        )
    return None


def _mesh_amounts(header: Header, mesh: Header) -> tuple[int, int, int]:
    """Return the numbers of triangles, vertices and primitives of a mesh."""
    faces = vertices = 0
    for primitive in mesh["primitives"]:
        place = primitive["attributes"].get("POSITION")
        index = primitive.get("indices", place)
        count = int(header["accessors"][index]["count"]) if index is not None else 0
        mode = primitive.get("mode", 4)
        if mode == TRIANGLES:
            faces += count // 3
        elif mode in (STRIP, FAN):
            faces += max(count - 2, 0)
        vertices += int(header["accessors"][place]["count"]) if place is not None else 0
    return faces, vertices, len(mesh["primitives"])


def _pictures(header: Header, data: bytes, maximum: int) -> str | None:
    """Check the pictures used for base colours; no others are decoded."""
    seen = {picture_of(header, material) for material in header.get("materials", ())}
    images = [header["images"][at] for at in seen if at is not None]
    shown = {image.get("bufferView", image.get("uri")): image for image in images}
    views = [header["bufferViews"][at] for at in shown if isinstance(at, int)]
    if any(view.get("buffer", 0) != 0 or "uri" in header["buffers"][0] for view in views):
        return (
            "has a texture outside its binary chunk, which is not supported. Export plain glTF 2.0."
        )
    try:
        return check_pictures((_file_of(header, image, data) for image in shown.values()), maximum)
    except binascii.Error as error:
        return f"has a damaged texture ({error}). Export it again."


def _file_of(header: Header, image: Header, data: bytes) -> bytes:
    if "bufferView" not in image:
        return base64.b64decode(image["uri"].partition("base64,")[2])
    view = header["bufferViews"][image["bufferView"]]
    start = view.get("byteOffset", 0)
    return data[start : start + view["byteLength"]]
