"""A folder of foreign textured meshes (OBJ, GLB, PLY; metres) as canonical models."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

import cv2
import numpy as np
import trimesh
from jaxtyping import Float, UInt8
from trimesh.resolvers import Resolver

from generator.errors import InputError
from generator.method.models import turn
from generator.scene import Mesh, Model
from tabletop_objects.values import to_unit_box

ENDINGS = (".obj", ".glb", ".ply")
MOST_BYTES, MOST_FACES = 100_000_000, 400_000
SMALLEST, LARGEST = 0.004, 2.0
"""Range of an object's longest side, metres."""

Up = Literal["auto", "y", "z"]
_TILE = 512  # maximum longer side of a texture, pixels
_GREY = np.full((2, 2, 3), 170, np.uint8)


def mesh_files(folder: Path) -> list[Path]:
    """Return the mesh files of a folder and its subfolders, sorted.

    Links that leave the folder are ignored.

    Raises:
        InputError: there is no such folder, or no mesh in it.
    """
    if not folder.is_dir():
        raise InputError(
            f"No folder {str(folder)!r}. Pass one that contains OBJ, GLB or PLY files."
        )
    root = folder.resolve()
    found = sorted(p for p in folder.rglob("*") if p.suffix.lower() in ENDINGS and p.is_file())
    inside = [p for p in found if p.resolve().is_relative_to(root)]
    if not inside:
        raise InputError(
            f"{str(folder)!r} contains no mesh. Supported formats: {', '.join(ENDINGS)}."
        )
    return inside


def load_model(path: Path, up: Up = "auto") -> Model:
    """Read an OBJ, GLB or PLY file as a canonical model with the file's size, in metres.

    Textures and materials must be in the same folder or below it. ``up`` is the file's upward axis;
    "auto" is y for GLB, as that format specifies, and z for others.

    Raises:
        InputError: the file is missing, too large, damaged, empty, refers to files elsewhere, or
            its size is implausible for a tabletop object in metres.
    """
    if not path.is_file() or path.suffix.lower() not in ENDINGS:
        raise InputError(f"No mesh file {path.name!r}. Supported formats: {', '.join(ENDINGS)}.")
    if not 0 < path.stat().st_size <= MOST_BYTES:
        raise InputError(
            f"{path.name} has {path.stat().st_size:,} bytes; 1 to {MOST_BYTES:,} are allowed."
        )
    folder = _Folder(path.parent)
    try:
        kind = path.suffix[1:].lower()
        with path.open("rb") as file:
            loaded = trimesh.load_scene(file, file_type=kind, resolver=folder, process=False)
        pieces = [_piece(g) for g in loaded.dump() if isinstance(g, trimesh.Trimesh)]
    except Exception as error:  # readers raise many types of errors for damaged files
        raise InputError(f"{path.name} cannot be read as a mesh ({error}).") from error
    if folder.refused:
        raise InputError(
            f"{path.name} refers to files outside its folder, or to files that are too large: "
            f"{folder.refused}. Move its materials and pictures to its folder."
        )
    pieces = [piece for piece in pieces if len(piece[1])]
    if not pieces:
        raise InputError(f"{path.name} has no triangle.")
    if sum(len(faces) for _, faces, _, _ in pieces) > MOST_FACES:
        raise InputError(f"{path.name} has more than {MOST_FACES:,} triangles. Simplify it first.")
    mesh = _join(path.name, pieces)
    unit, _, extent = to_unit_box(mesh)
    longest = float(extent.max())
    if not SMALLEST <= longest <= LARGEST:
        raise InputError(
            f"{path.name} is {longest:.4g} across; a tabletop object has {SMALLEST} to {LARGEST} "
            "m. Scale it to metres."
        )
    model = Model(path.stem, path.stem, unit, extent)
    upright = up == "z" or (up == "auto" and path.suffix.lower() != ".glb")
    return model if upright else turn(model, (("x", 90),))


class _Folder(Resolver):
    """Provides a mesh with files from its folder, and records other files that it requests."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()
        self.refused: list[str] = []

    def get(self, key: str) -> bytes:
        path = (self.root / key.strip()).resolve()
        if not path.is_relative_to(self.root):
            self.refused.append(key)
            raise FileNotFoundError(key)
        if path.is_file() and path.stat().st_size > MOST_BYTES:
            self.refused.append(key)
            raise FileNotFoundError(key)
        return path.read_bytes()

    def keys(self) -> list[str]:
        return []

    def namespaced(self, namespace: str) -> _Folder:
        raise FileNotFoundError(namespace)

    def write(self, name: str, data: bytes) -> None:
        raise PermissionError(name)


Piece = tuple[Float[np.ndarray, "n 3"], np.ndarray, Float[np.ndarray, "n 2"], np.ndarray]


def _piece(geometry: Any) -> Piece:
    """Return vertices, faces, uv and texture of one part; plain colours become a texture."""
    vertices = np.asarray(geometry.vertices, float)
    faces = np.asarray(geometry.faces, int)
    if not len(faces):
        return vertices, faces, np.zeros((len(vertices), 2)), _GREY
    if not np.isfinite(vertices).all():
        raise InputError("a vertex is NaN or infinite")
    visual = geometry.visual
    uv = getattr(visual, "uv", None)
    if uv is not None and len(uv) == len(vertices) and np.isfinite(uv).all():
        corner = np.asarray(uv, float)[faces]
        corner -= np.floor(corner.mean(1, keepdims=True) + 1e-9)  # tiles repeat
        corner = np.clip(corner, 0, 1).reshape(-1, 2)
        return vertices[faces].reshape(-1, 3), _own(faces), corner, _texture(visual.material)
    if visual.kind in ("face", "vertex"):
        colors = np.asarray(visual.face_colors)[:, :3]
    else:
        colors = np.broadcast_to(_GREY[0, 0], (len(faces), 3))
    side = int(np.ceil(np.sqrt(len(faces))))
    palette = np.zeros((side * side, 3), np.uint8)
    palette[: len(faces)] = colors
    index = np.arange(len(faces))
    middle = np.stack([(index % side + 0.5) / side, 1 - (index // side + 0.5) / side], 1)
    texture = palette.reshape(side, side, 3)
    return vertices[faces].reshape(-1, 3), _own(faces), middle.repeat(3, 0), texture


def _own(faces: np.ndarray) -> np.ndarray:
    """Return faces that do not share vertices."""
    return np.arange(3 * len(faces)).reshape(-1, 3)


def _texture(material: Any) -> UInt8[np.ndarray, "h w 3"]:
    """Return a material's picture times its colour, or only its colour."""
    picture = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    factor = getattr(material, "baseColorFactor", None)
    if picture is None:
        color = factor if factor is not None else material.main_color
        return np.broadcast_to(np.asarray(color)[:3].astype(np.uint8), (2, 2, 3))
    picture = picture.convert("RGB")
    picture.thumbnail((_TILE, _TILE))
    pixels = np.asarray(picture, float)
    if factor is not None:
        pixels = pixels * np.asarray(factor, float)[:3] / 255
    return np.clip(pixels, 0, 255).astype(np.uint8)


def _join(name: str, pieces: list[Piece]) -> Mesh:
    """Return one mesh, with the pieces' textures stacked into one."""
    width = max(texture.shape[1] for *_, texture in pieces)
    rows, tiles, heights = 0, [], []
    for *_, texture in pieces:
        how = cv2.INTER_NEAREST if texture.shape[1] <= 2 else cv2.INTER_LINEAR
        scaled = cv2.resize(texture, (width, texture.shape[0]), interpolation=how)
        tiles.append(scaled if texture.shape[1] < width else texture)
        heights.append((rows, texture.shape[0]))
        rows += texture.shape[0]
    all_uv, all_faces, start = [], [], 0
    for (vertices, faces, uv, _), (top, high) in zip(pieces, heights, strict=True):
        half = 0.5 / high
        v = np.clip(uv[:, 1], half, 1 - half)  # avoids colours of the next tile
        all_uv.append(np.column_stack([uv[:, 0], 1 - (top + (1 - v) * high) / rows]))
        all_faces.append(faces + start)
        start += len(vertices)
    try:
        points = np.concatenate([piece[0] for piece in pieces])
        return Mesh(points, np.concatenate(all_faces), np.concatenate(all_uv), np.vstack(tiles))
    except InputError as error:
        raise InputError(f"{name} cannot be used: {error}") from error
