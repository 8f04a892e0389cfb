"""Files of the XML exports (textures, Wavefront OBJ meshes in metres), and number formatting.

A body's visual mesh has the body's name; other files are named by the digest of their content. All
are in one folder, since some readers reject files outside an OBJ's own. Files are used unscaled.
"""

from __future__ import annotations

import hashlib
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from pathlib import PurePosixPath

import numpy as np
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation

from ..io.pictures import encode_png
from ..physics.mjcf import row_lines
from .bodies import ExportBody, ExportPiece

_FOLDER = "meshes"


class ExportFiles:
    """Collects the files of an export, keyed by path in its folder; equal contents share a file."""

    def __init__(self) -> None:
        self.content: dict[str, bytes] = {}

    def visual(self, body: ExportBody) -> str:
        """Add a body's mesh, material and texture; return the path of the mesh."""
        mesh, picture = body.mesh, self.texture(body)
        alpha = f"d {mesh.opacity:.6g}\n"
        material = self._add(
            "mtl", f"newmtl surface\nKd 1 1 1\nKs 0.2 0.2 0.2\nNs 20\n{alpha}"
            f"map_Kd {PurePosixPath(picture).name}\n".encode(),
        )  # fmt: skip
        head = f"mtllib {PurePosixPath(material).name}\nusemtl surface\n"
        corners = np.repeat(mesh.faces + 1, 2, axis=1)
        rows = [
            row_lines("v %.7f %.7f %.7f\n", body.vertices), row_lines("vt %.5f %.5f\n", mesh.uv),
            row_lines("f %d/%d %d/%d %d/%d\n", corners),
        ]  # fmt: skip
        return self._put(f"{body.name}.obj", (head + "".join(rows)).encode())

    def texture(self, body: ExportBody) -> str:
        """Add a body's texture; return its path."""
        return self._add("png", encode_png(body.mesh.texture))

    def collision(self, piece: ExportPiece) -> str:
        """Add the surface of a collision piece; return the path of its file."""
        return self._add("obj", plain_obj(piece.vertices, piece.faces))

    def _add(self, suffix: str, content: bytes) -> str:
        return self._put(f"{hashlib.sha256(content).hexdigest()[:16]}.{suffix}", content)

    def _put(self, name: str, content: bytes) -> str:
        path = f"{_FOLDER}/{name}"
        self.content[path] = content
        return path


def plain_obj(vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]) -> bytes:
    """Return a surface as Wavefront OBJ without texture, rounded to a tenth of a micrometre."""
    text = row_lines("v %.7f %.7f %.7f\n", vertices) + row_lines("f %d %d %d\n", faces + 1)
    return text.encode()


INERTIA = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
"""Names of an inertia's entries in URDF and SDF, and their indices."""

_ALONG = np.array([[0, np.pi / 2, 0], [-np.pi / 2, 0, 0], [0, 0, 0]])


def number_text(numbers: Iterable[float]) -> str:
    """Return numbers as text: nine significant digits, no negative zero."""
    return " ".join(f"{float(x) + 0.0:.9g}" for x in numbers)


def roll_pitch_yaw(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3"]:
    """Return a unit wxyz quaternion as rotations about the fixed x, y and z axes, in this order."""
    return Rotation.from_quat(quaternion, scalar_first=True).as_euler("xyz")


def along(axis: int) -> Float[np.ndarray, "3"]:
    """Return the roll, pitch and yaw that rotate the z axis onto ``axis``."""
    return _ALONG[axis]


def document_text(root: ET.Element) -> bytes:
    """Return an XML element as an indented UTF-8 document with an XML declaration."""
    ET.indent(root)
    return b'<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(root, encoding="utf-8") + b"\n"
