"""Normalisation of foreign meshes: upright, repaired, simplified, and with a single texture."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
import trimesh
from jaxtyping import Float

from tabletop_objects import Category
from tabletop_objects.values import to_unit_box

from ..errors import require
from ..language.names import known_category
from ..scene import Instance, Mesh, Model, Physics, SizePrior
from .decimation import reduce, volume
from .reading.loader import load_surface
from .reading.surface import Axis, ColoredSurface, Kind, surface_of
from .reading.textures import MOST_TEXTURE
from .repair import check_surface, clean, fill_holes, inside_out, tidy, welded_shape
from .texture import best_size, own_texture, painted_faces, painted_shape

_FILLED = 0.4  # assumed ratio between the volumes of an open mesh and of its box


@dataclass(frozen=True)
class Normal:
    """The target numbers of triangles and texels of foreign meshes.

    Attributes:
        faces: maximum number of triangles, 50 to 25,000; up to four times as many where the shape
            needs them.
        texture: side of a regenerated texture, texels, at most 2048; larger if many faces need it.
    """

    faces: int = 6000
    texture: int = 1024

    def __post_init__(self) -> None:
        require(self, "faces", minimum=50, maximum=25_000, integer=True)
        require(self, "texture", minimum=16, maximum=MOST_TEXTURE, integer=True)


def normal_mesh(
    raw: bytes,
    what: str,
    *,
    kind: Kind = "glb",
    up: Axis = "y",
    to: Normal | None = None,
    beside: Mapping[str, bytes] = MappingProxyType({}),
) -> Mesh:
    """Return a GLB or OBJ file as one textured mesh with +z up, in the file's units.

    Faces look outwards as far as this can be determined. At least 99 % of the edges, joined across
    texture seams, belong to two faces (or two pairs, where objects touch) or run around an opening
    (``repair``). Small holes are closed. Cups, tubes and leaves stay open; only their convex parts
    make them solid. The mesh has at most four times the requested number of triangles. A texture
    with sides of at most 2048 texels is kept if all parts share it, it does not repeat, and the
    mesh is not simplified.

    ``what`` names the file in messages: backend, query, name. ``up`` is the file's upward axis, and
    ``to`` is the target size. ``beside`` contains the files to which an OBJ refers (see
    ``companions``).

    Raises:
        BackendError: the file cannot be read (``inspection``), repaired (``repair``) or simplified.
    """
    return normal_surface(load_surface(raw, what, kind, beside), what, up=up, to=to)


def normal_trimesh(mesh: trimesh.Trimesh, what: str, *, up: Axis, to: Normal | None = None) -> Mesh:
    """Return a mesh of the ``trimesh`` library, normalised as by ``normal_mesh``."""
    return normal_surface(surface_of([mesh], what), what, up=up, to=to)


def normal_surface(
    surface: ColoredSurface, what: str, *, up: Axis, to: Normal | None = None
) -> Mesh:
    """Return a surface as one textured mesh with +z up; see ``normal_mesh``."""
    return repair_surface(surface.upright(up), what, to)[0]


def repair_surface(
    surface: ColoredSurface, what: str, to: Normal | None = None
) -> tuple[Mesh, tuple[str, ...]]:
    """Return an upright surface as one textured mesh, and the repairs made; see ``normal_mesh``.

    Raises:
        BackendError: it cannot be repaired (``repair``) or simplified.
    """
    to, given = to or Normal(), len(surface.faces)
    surface = clean(surface, what)
    repairs = _list_repairs({"faulty triangles removed": given - len(surface.faces)})
    vertices, faces = welded_shape(surface.vertices, surface.faces)
    if len(faces) > to.faces:
        vertices, faces = reduce(vertices, faces, to.faces, what)
        faces = tidy(vertices, faces)
        repairs += (f"reduced from {len(surface.faces)} to {len(faces)} triangles",)
    own = len(faces) == len(surface.faces)
    over = inside_out(vertices, faces)
    faces = np.where(over[:, None], faces[:, ::-1], faces)
    before = len(faces)
    vertices, faces = fill_holes(vertices, faces)
    repairs += _list_repairs(
        {
            "triangles added to close holes": int(over.sum()),
            "triangles close holes": len(faces) - before,
        }
    )
    check_surface(faces, what)
    size = best_size(surface, to.texture, len(faces))
    if not own or len(faces) > len(surface.faces):
        return painted_shape(vertices, faces, surface, size), repairs
    surface = surface.flip(over)
    return own_texture(surface) or painted_faces(surface, size), repairs


def _list_repairs(counts: Mapping[str, int]) -> tuple[str, ...]:
    return tuple(f"{count} {what}" for what, count in counts.items() if count)


def foreign_model(mesh: Mesh, instance: Instance, size: SizePrior) -> Model:
    """Return a normalised mesh as an instance's raw model of the usual size; proportions are kept.

    For a known category, mass and friction are those of the catalogue; otherwise the density is
    that of light wood.
    """
    unit, _, extent = to_unit_box(mesh)
    kind = known_category(instance, size)
    return Model(
        instance.name,
        instance.label,
        unit,
        metric(extent, size),
        foreign_physics(mesh, extent, kind),
        category=kind.key if kind else "generic",
        container=bool(kind and kind.container),
    )


def foreign_physics(mesh: Mesh, extent: Float[np.ndarray, "3"], kind: Category | None) -> Physics:
    """Return physical properties that give a mesh of the usual size the mass of its category."""
    if kind is None:
        return Physics(density=500.0, friction=0.6)
    share = volume(*welded_shape(mesh.vertices, mesh.faces)) / float(np.prod(extent)) or _FILLED
    density = kind.mass / (share * float(np.prod(kind.size)))
    return Physics(float(np.clip(density, 20.0, 8000.0)), kind.sliding_friction)


def metric(extent: Float[np.ndarray, "3"], size: SizePrior) -> Float[np.ndarray, "3"]:
    """Scale measured proportions to metres so that the two longest sides agree with the prior."""
    have, want = np.sort(extent)[1:], np.sort(size.extent)[1:]
    return extent * float(np.sqrt(np.prod(want) / np.prod(have)))
