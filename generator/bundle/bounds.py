"""Limits on the size of a bundle, applied to counts and headers before anything is decoded.

The shipped tables have at most 7 models, 253 convex parts and 20,000 triangles per mesh. The limits
allow 20 foreign models of 24,000 triangles, the modelers' default maximum, with textures of 2048
texels per side. A bundle that reaches all limits at once was verified in 10 s on one core with 1.3
GB, and loaded in 8 s with 0.8 GB.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from ..errors import BundleError


@dataclass(frozen=True)
class Bounds:
    """Maximum sizes and counts; ``all_`` fields apply to the whole bundle.

    Attributes:
        files: listed files.
        truth_bytes, file_bytes, all_bytes: bytes of ``scene.json``, of one listed file, and of all
            listed files.
        models, objects: counts in the scene.
        parts, all_parts: convex parts of a model, an object or the table.
        part_vertices, all_part_vertices: points of a convex part.
        vertices, all_vertices: vertices of a mesh; ``all`` counts a mesh once per body that shows
            it.
        faces, all_faces: triangles, counted in the same way.
        texels, all_texels: texels of a picture; ``all`` counts the textures of different models.
    """

    files: int = 4096
    truth_bytes: int = 16 * 2**20
    file_bytes: int = 128 * 2**20
    all_bytes: int = 192 * 2**20
    models: int = 201
    objects: int = 200
    parts: int = 1024
    all_parts: int = 4096
    part_vertices: int = 4096
    all_part_vertices: int = 100_000
    vertices: int = 200_000
    all_vertices: int = 500_000
    faces: int = 200_000
    all_faces: int = 500_000
    texels: int = 4096 * 4096
    all_texels: int = 96 * 2**20

    def check(self, name: str, count: int, what: str) -> None:
        """Check a count of the bundle against the limit in the field ``name``.

        ``what`` is a sentence with a placeholder for the count: "scene.json has {} models".

        Raises:
            BundleError: the count is out of bounds.
        """
        most = getattr(self, name)
        if not 0 <= count <= most:
            raise BundleError(f"{what.format(count)}; at most {most} are allowed.")


BOUNDS = Bounds()
"""The limits on every bundle."""


def check_counts(payload: dict[str, Any], bounds: Bounds = BOUNDS) -> None:
    """Check the counts in ``scene.json`` before its values are converted to arrays.

    Raises:
        BundleError: a count is out of bounds, or a value has the wrong type.
    """
    models = _of(payload, "models", dict, "scene.json")
    objects = _of(payload, "objects", list, "scene.json")
    table = _of(payload, "table", dict, "scene.json")
    bounds.check("models", len(models), "scene.json has {} models")
    bounds.check("objects", len(objects), "scene.json has {} objects")
    parts: list[Any] = []
    for body in (table, *objects, *models.values()):
        own = _of(body, "parts", list, "a body of scene.json")
        bounds.check("parts", len(own), "a body of scene.json has {} convex parts")
        parts += own
    bounds.check("all_parts", len(parts), "scene.json has {} convex parts")
    counts = [len(_of(part, "vertices", list, "a convex part")) for part in parts]
    bounds.check("part_vertices", max(counts, default=0), "a convex part has {} vertices")
    bounds.check("all_part_vertices", sum(counts), "the convex parts have {} vertices")


def check_listed(files: object) -> None:
    """Check the list of a bundle's files: their number and their stated sizes.

    Raises:
        BundleError: there are too many files, a file is too large, or the list is malformed.
    """
    if not isinstance(files, dict):
        raise BundleError("scene.json must list the bundle's files.")
    listed = cast("dict[str, object]", files)
    BOUNDS.check("files", len(listed), "scene.json lists {} files")
    total = 0
    for name, entry in listed.items():
        size = cast("dict[str, object]", entry).get("bytes") if isinstance(entry, dict) else None
        if type(size) is not int:
            raise BundleError(f"scene.json lists {name[:200]!r} without size and sha256.")
        BOUNDS.check("file_bytes", size, "a listed file has {} bytes")
        total += size
    BOUNDS.check("all_bytes", total, "the files together have {} bytes")


def check_drawn(
    meshes: Sequence[tuple[int, int]], shown: Sequence[tuple[int, int]], texels: Sequence[int]
) -> None:
    """Check the counts in the headers of meshes and textures against the limits.

    ``meshes`` are the numbers of vertices and triangles of each stored mesh, ``shown`` are those of
    each body's mesh, and ``texels`` are the numbers of texels of each stored texture.

    Raises:
        BundleError: they exceed the limits.
    """
    for name, at in (("vertices", 0), ("faces", 1)):
        BOUNDS.check(name, max((k[at] for k in meshes), default=0), f"a mesh has {{}} {name}")
        for counts in (meshes, shown):
            total = sum(count[at] for count in counts)
            BOUNDS.check(f"all_{name}", total, f"the meshes together have {{}} {name}")
    BOUNDS.check("texels", max(texels, default=0), "a texture has {} pixels")
    BOUNDS.check("all_texels", sum(texels), "the textures together have {} pixels")


def _of(entry: object, key: str, kind: type, who: str) -> Any:
    """Return a field of a JSON object after checking that its value is a ``kind``."""
    value = cast("dict[str, Any]", entry).get(key) if isinstance(entry, dict) else None
    if type(value) is not kind:
        raise BundleError(
            f"{key!r} of {who} must be a JSON {'list' if kind is list else 'object'}."
        )
    return value
