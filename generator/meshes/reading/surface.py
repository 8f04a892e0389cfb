"""A foreign mesh as read from a file: its parts in one frame, and each face with its colours."""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
import trimesh
from jaxtyping import Bool, Float, Int, UInt8
from trimesh.resolvers import ZipResolver

from ...errors import BackendError
from ...render.shading import sample_texture
from .bounds import MOST_FACES
from .flat_glb import Header, flatten
from .inspection import inspect_obj, open_glb
from .textures import Pictures, light, to_srgb

Kind = Literal["glb", "obj"]
Axis = Literal["y", "z"]

_GREY = (190, 190, 190, 255)
_LINEAR = np.arange(256) / 255.0


@dataclass(frozen=True, eq=False)
class ColoredSurface:
    """Triangles with colours; ``picture`` is each face's index into ``pictures``, or -1.

    A face with a picture is textured at its vertices' ``uv`` (v upwards, repeating); other faces
    have their vertices' ``colors``. An ``opacity`` below 1 makes the whole surface translucent.
    """

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    colors: UInt8[np.ndarray, "n 3"]
    picture: Int[np.ndarray, "m"]
    pictures: tuple[UInt8[np.ndarray, "h w 3"], ...]
    opacity: float = 1.0

    def keep(self, which: Bool[np.ndarray, "m"]) -> ColoredSurface:
        """Return the surface with only the selected faces."""
        return replace(self, faces=self.faces[which], picture=self.picture[which])

    def compact(self) -> ColoredSurface:
        """Return the surface without unused vertices."""
        used = np.zeros(len(self.vertices), bool)
        used[self.faces] = True
        if used.all():
            return self
        return replace(
            self, vertices=self.vertices[used], faces=(np.cumsum(used) - 1)[self.faces],
            uv=self.uv[used], colors=self.colors[used],
        )  # fmt: skip

    def flip(self, which: Bool[np.ndarray, "m"]) -> ColoredSurface:
        """Return the surface with the selected faces flipped."""
        faces = np.where(which[:, None], self.faces[:, ::-1], self.faces)
        return replace(self, faces=faces)

    def upright(self, up: Axis) -> ColoredSurface:
        """Return the surface with +z up, given the upward axis of the file."""
        if up == "z":
            return self
        x, y, z = self.vertices.T
        return replace(self, vertices=np.column_stack([x, -z, y]))

    def colors_at(
        self, face: Int[np.ndarray, "t"], weights: Float[np.ndarray, "t 3"]
    ) -> Float[np.ndarray, "t 3"]:
        """Return the colours, 0 to 255, at positions given by face and barycentric weights."""
        corner = self.faces[face]
        found = (self.colors[corner] * weights[:, :, None]).sum(1)
        uv = (self.uv[corner] * weights[:, :, None]).sum(1)
        uv = np.where((uv < 0) | (uv > 1), uv % 1.0, uv)
        for k, picture in enumerate(self.pictures):
            own = np.flatnonzero(self.picture[face] == k)
            found[own] = 255.0 * sample_texture(picture, uv[own])
        return found


def read_surface(
    raw: bytes,
    what: str,
    kind: Kind,
    beside: Mapping[str, bytes] = MappingProxyType({}),
    most_faces: int = MOST_FACES,
) -> ColoredSurface:
    """Return the whole content of a GLB or OBJ file as one surface, with node transforms applied.

    Only the base colour of a material is used: its factor, its texture and, if the material blends,
    its alpha. ``what`` names the file in messages; ``beside`` contains the files to which an OBJ
    refers, by name (see ``companions``).

    Raises:
        BackendError: the file does not pass ``inspection``, has more than ``most_faces`` faces, or
            contains numbers that are not finite.
    """
    header: Header = {}
    if kind == "glb":
        raw, header = open_glb(raw, what, most_faces)
    else:
        inspect_obj(raw, what, most_faces)
    files = ZipResolver({name: io.BytesIO(b) for name, b in beside.items()})
    try:
        # An OBJ is converted to UTF-8 first, since guessing its encoding is slow.
        plain = raw.decode("utf-8", "replace").encode() if kind == "obj" else flatten(raw, header)
        loaded = trimesh.load_scene(
            io.BytesIO(plain), file_type=kind, resolver=files, process=False
        )
        parts = _place_meshes(loaded)
        asset = header.get("asset")
        maker = str(asset.get("generator", "")) if isinstance(asset, dict) else ""
        return surface_of(parts, what, kind == "glb" and "trimesh" not in maker, most_faces)
    except (BackendError, MemoryError):  # the latter error is handled by the sandbox
        raise
    except Exception as error:  # for malformed files, parsers raise many types of errors
        raise BackendError(
            f"{what} cannot be read ({type(error).__name__}: {error}). Export it again."
        ) from error


def surface_of(
    parts: list[trimesh.Trimesh],
    what: str,
    linear: bool = False,
    most_faces: int = MOST_FACES,
    pictures: Pictures | None = None,
) -> ColoredSurface:
    """Return meshes in one frame as a single surface without unused vertices.

    ``what`` names the meshes in messages. Plain colours are ``linear``, as in glTF, or sRGB, as in
    trimesh. ``pictures`` are shared by all surfaces of a file.

    Raises:
        BackendError: no mesh has faces, there are more than ``most_faces``, or a vertex is missing,
            NaN or infinite.
    """
    count = sum(len(part.faces) for part in parts)
    if not count:
        raise BackendError(f"{what} has no triangles. Export a mesh with faces.")
    if count > most_faces:
        raise BackendError(f"{what} has {count} triangles; 1 to {most_faces} are allowed.")
    for part in parts:
        faces = np.asarray(part.faces)
        if part.vertices.shape[1:] != (3,) or faces.shape[1:] != (3,):
            raise BackendError(f"{what} is damaged: its vertices are not 3D points.")
        if not np.isfinite(np.asarray(part.vertices, np.float32)).all():
            raise BackendError(f"{what} contains NaN or infinity; all vertices must be finite.")
        if len(faces) and not 0 <= faces.min() <= faces.max() < len(part.vertices):
            raise BackendError(f"{what} is damaged: faces refer to missing vertices.")
    pictures = Pictures(what) if pictures is None else pictures
    pieces = [_piece(part, pictures, linear) for part in parts]
    shown = sorted({k for _, _, k, _ in pieces if k >= 0})
    places = {-1: -1, **{k: at for at, k in enumerate(shown)}}
    shift = np.cumsum([0, *(len(part.vertices) for part in parts[:-1])])
    alphas = [alpha for *_, alpha in pieces]
    surface = ColoredSurface(
        np.concatenate([np.asarray(p.vertices, np.float64) for p in parts]),
        np.concatenate([np.asarray(p.faces) + s for p, s in zip(parts, shift, strict=True)]),
        np.concatenate([uv for uv, *_ in pieces]),
        np.concatenate([colors for _, colors, *_ in pieces]),
        np.repeat([places[k] for _, _, k, _ in pieces], [len(p.faces) for p in parts]),
        tuple(pictures.kept[k] for k in shown),
        float(np.clip(np.mean(alphas), 0.05, 1.0)) if max(alphas) < 1 else 1.0,
    )
    return surface.compact()


def _place_meshes(scene: trimesh.Scene) -> list[trimesh.Trimesh]:
    """Return the meshes of a scene in world coordinates, with shared materials."""
    # trimesh's own ``dump`` copies, and thus decodes, the pictures of each mesh.
    placed = []
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        geometry = scene.geometry[name]
        if isinstance(geometry, trimesh.Trimesh) and len(geometry.faces):
            part = geometry.copy(include_visual=False)
            part.apply_transform(transform)
            part.visual = geometry.visual
            placed.append(part)
    return placed


def _piece(
    part: trimesh.Trimesh, pictures: Pictures, linear: bool
) -> tuple[np.ndarray, np.ndarray, int, float]:
    """Return a mesh's uv, vertex colours, index into ``pictures`` (or -1) and alpha."""
    visual: Any = part.visual
    material: Any = getattr(visual, "material", None)
    count = len(part.vertices)
    uv = np.zeros((count, 2))
    given = getattr(visual, "uv", None)
    if given is not None and len(given) == count and given.ndim == 2 and given.shape[1] >= 2:
        uv = np.nan_to_num(given)[:, :2]
    factor, alpha = _factor(material), _dissolve(material)
    if str(getattr(material, "alphaMode", "")) == "BLEND":
        alpha = float(factor[3]) / 255
    image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    flat = _to_srgb(factor, linear)
    if image is not None and getattr(visual, "uv", None) is not None:
        tint = factor[:3] / 255 if linear else light(factor[:3] / 255)
        if hasattr(material, "image"):  # in an OBJ: many programs write grey as well as the picture
            tint = np.ones(3)
        return uv, np.tile(flat, (count, 1)), pictures.place(image, tint), alpha
    colors = getattr(visual, "vertex_attributes", {}).get("color", None)
    if colors is None and material is None and visual.kind is not None:
        colors = visual.vertex_colors
    if colors is None or len(colors) != count:
        return uv, np.tile(flat, (count, 1)), -1, alpha
    return uv, _to_srgb(_bytes(np.asarray(colors)), linear), -1, alpha


def _factor(material: Any) -> UInt8[np.ndarray, "4"]:
    """Return a material's uniform colour, or grey if there is no material."""
    if material is None:
        return np.array(_GREY, np.uint8)
    given = (getattr(material, name, None) for name in ("baseColorFactor", "diffuse"))
    plain = next((color for color in given if color is not None), None)
    found = np.full(4, 255, np.uint8)
    if plain is not None:
        channels = _bytes(np.asarray(plain))[:4]
        found[: len(channels)] = channels
    return found


def _dissolve(material: Any) -> float:
    """Return the opacity ``d`` of an OBJ material, or 1 if it is 0 or not given."""
    words = getattr(material, "kwargs", {}).get("d", ())
    try:
        value = float(words[0])
    except (IndexError, ValueError):
        return 1.0
    return value if 0 < value < 1 else 1.0  # also false for NaN


def _bytes(values: np.ndarray) -> UInt8[np.ndarray, "*k"]:
    """Return colours as bytes, converted from bytes, 16-bit integers or fractions in [0, 1]."""
    if values.dtype == np.uint8:
        return values
    if values.dtype == np.uint16:
        return (values >> 8).astype(np.uint8)
    if not np.issubdtype(values.dtype, np.floating):
        return np.clip(values, 0, 255).astype(np.uint8)
    return np.round(255 * np.clip(np.nan_to_num(values), 0, 1)).astype(np.uint8)


def _to_srgb(colors: UInt8[np.ndarray, "*k c"], linear: bool) -> UInt8[np.ndarray, "*k 3"]:
    """Return colours in sRGB, converted if they are ``linear``, and without alpha."""
    table = to_srgb(_LINEAR) if linear else _LINEAR
    return np.round(255 * table).astype(np.uint8)[colors[..., :3]]
