"""Meshes and pictures of a bundle: the counts in their headers, and their decoding."""

from __future__ import annotations

import re

import numpy as np
from jaxtyping import Float, Int, UInt8

from .. import pictures
from ..errors import BundleError
from ..pictures import DecodedPicture, Form, PictureLimits
from ..scene.triangles import areas
from .bounds import BOUNDS

_OBJ = re.compile(
    rb"(?:v(?: -?[0-9]\.[0-9]{6}){3}\n)++"
    rb"(?:vt(?: -?[0-9]{1,12}\.[0-9]{5}){2}\n)++"
    rb"(?:f(?: ([0-9]{1,9})/\1){3}\n)++"
)

_LIMITS = PictureLimits(
    formats=("PNG",), max_bytes=BOUNDS.file_bytes, max_pixels=BOUNDS.texels, max_frames=1
)
_LEAST_AREA = 1e-3  # relative to twice the surface of a mesh whose box is the unit box


def picture_size(raw: bytes, name: str) -> tuple[int, int]:
    """Return the width and height of the PNG ``name``, from its header alone.

    Raises:
        BundleError: the file is not a PNG, or is out of bounds.
    """
    try:
        width, height = pictures.png_size(raw)
    except pictures.DamagedHeader as error:
        raise BundleError(f"{name} is not a PNG picture.") from error
    BOUNDS.check("texels", width * height, f"{name} has {{}} pixels")
    if not width * height:
        raise BundleError(f"{name} has no pixels.")
    return width, height


def decode_png(raw: bytes, name: str) -> UInt8[np.ndarray, "h w 3"]:
    """Return the colours of the PNG ``name``.

    It is decoded in this process, since a bundle has many pictures, whose cost the bounds limit.

    Raises:
        BundleError: the file is not a PNG, or is out of bounds.
    """
    return _decode(raw, name, "rgb").pixels


def decode_indices(raw: bytes, name: str) -> UInt8[np.ndarray, "h w"]:
    """Return the palette indices of the PNG ``name``, decoded like ``decode_png``.

    Raises:
        BundleError: the file is not a PNG with a palette, or is out of bounds.
    """
    picture = _decode(raw, name, "stored")
    if picture.mode != "P":
        raise BundleError(f"{name} is not a PNG with a palette.")
    return picture.pixels


def _decode(raw: bytes, name: str, form: Form) -> DecodedPicture:
    size = picture_size(raw, name)
    picture = pictures.decode_png(raw, name, BundleError, _LIMITS, form)
    if (picture.width, picture.height) != size:
        raise BundleError(f"{name} has headers with two different picture sizes.")
    return picture


def mesh_counts(raw: bytes) -> tuple[int, int]:
    """Return the numbers of vertices and triangles of a mesh file, by counting its lines."""
    return raw.count(b"\nv ") + raw.startswith(b"v "), raw.count(b"\nf ")


def decode_obj(
    raw: bytes, name: str
) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"], Float[np.ndarray, "n 2"]]:
    """Return the vertices, triangles and texture coordinates of the mesh ``name``.

    Only the format written by ``mjcf.encode_obj`` is supported.

    Raises:
        BundleError: the file has another format, or no visible surface.
    """
    found = _OBJ.fullmatch(raw)
    if found is None:
        raise BundleError(f"{name} is not in the OBJ format that bundles use.")
    start, end = raw.index(b"\nvt "), raw.index(b"\nf ")
    vertices = _numbers(raw[:start], b"v").reshape(-1, 3)
    uv = _numbers(raw[start:end], b"vt").reshape(-1, 2)
    faces = _numbers(raw[end:].replace(b"/", b" "), b"f").reshape(-1, 6)[:, ::2].astype(np.int64)
    faces -= 1
    inside = faces.min() >= 0 and faces.max() < len(vertices)
    if len(vertices) < 4 or len(uv) != len(vertices) or not inside:
        raise BundleError(
            f"{name} is not a mesh: it must have at least 4 vertices, each with texture "
            "coordinates, and faces that refer to these vertices."
        )
    if areas(vertices, faces).sum() < _LEAST_AREA:
        raise BundleError(f"{name} has no surface: its triangles have almost no area.")
    return vertices, faces, uv


def _numbers(text: bytes, kind: bytes) -> Float[np.ndarray, " n"]:
    return np.fromstring(text.replace(kind, b" ").decode("ascii"), sep=" ")
