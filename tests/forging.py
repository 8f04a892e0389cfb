"""Forged bundles: well-formed, with matching digests, in a folder without one."""

import hashlib
import json
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from generator import bundle
from generator.bundle.decoder import decode_scene
from generator.bundle.encoder import dumps
from generator.errors import BundleError
from generator.physics.mjcf import document, mesh_path, texture_path


def rewrite(path: Path, change: Callable[[dict[str, Any]], None]) -> Path:
    """Change ``scene.json`` of a bundle, and its folder's name to "forged"."""
    payload = json.loads((path / "scene.json").read_text())
    change(payload)
    (path / "scene.json").write_bytes(dumps(payload))
    return path.rename(path.parent / "forged")


def put(path: Path, name: str, content: bytes) -> Path:
    """Add a file to a bundle with its entry; the folder's name becomes "forged"."""
    (path / name).write_bytes(content)
    entry = {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()}
    return rewrite(path, lambda payload: payload["files"].update({name: entry}))


def put_mesh(path: Path, content: bytes) -> Path:
    """Replace every model's mesh in a bundle by this file."""
    return _give(path, "mesh", mesh_path(content), content)


def put_texture(path: Path, content: bytes) -> Path:
    """Replace every model's texture in a bundle by this file."""
    return _give(path, "texture", texture_path(content), content)


def derive(path: Path) -> Path:
    """Write the ``scene.xml`` that matches the values of a forged bundle."""
    payload = json.loads((path / "scene.json").read_text())
    made = decode_scene(payload, lambda name: (path / name).read_bytes())
    return put(path, "scene.xml", document(made.scene, paths=made.paths).xml.encode())


def png(width: int, height: int, packed: bytes = b"", mode: int = 0) -> bytes:
    """Return a PNG that claims this size, with grey pixels (mode 0) in this zlib stream."""
    header = struct.pack(">IIBBBBB", width, height, 8, mode, 0, 0, 0)
    chunks = {b"IHDR": header, b"IDAT": packed, b"IEND": b""}
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks.items()
    )


def _give(path: Path, what: str, name: str, content: bytes) -> Path:
    def change(payload: dict[str, Any]) -> None:
        for model in payload["models"].values():
            model[what] = name

    return rewrite(put(path, name, content), change)


def refused(path: Path, match: str) -> None:
    """Check that a bundle is rejected for a reason, and that verification reports it."""
    with pytest.raises(BundleError, match=match):
        bundle.load(path)
    assert bundle.verify(path)
