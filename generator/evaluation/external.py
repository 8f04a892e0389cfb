"""Reading of another method's result: one GLB per object, and a JSON file with transforms.

A folder contains ``transforms.json`` and the GLB files named in it. All lengths are in metres::

    {"name": "scene-3", "method": "other", "up": "y",
     "table": {"glb": "table.glb", "matrix": [[1, 0, 0, 0], ...]},
     "objects": [{"name": "mug_1", "label": "mug", "glb": "mug.glb",
                  "matrix": [[1, 0, 0, 0.1], ...], "on": "table", "inside": false}]}

``up`` is the axis that points up in the GLB files: "y" (as in glTF, the default) or "z". A mesh is
first rotated so that z points up (x stays x, y becomes z, z becomes -y). Then ``matrix`` (4 x 4,
row-major, acting on column vectors) maps it to the world: +x right and +y away in the reference
picture, +z up. The matrix may rotate, scale along the mesh's own axes, and translate; mirroring and
shearing are invalid. The origin of the world is arbitrary, since the scene is translated so that
the table stands on the floor, centred over the new origin. For a method without a table, "table" is
``{"size": [x, y, z]}``: a block of that extent, with the centre of its top at ``"top": [x, y, z]``
in the method's world. ``label`` (default: the name without its number), ``on`` ("table") and
``inside`` (false) are optional.

The top of a table is its highest large, level surface. In simulation, the top is a slab without the
rim.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, Int, UInt8
from scipy.spatial.transform import Rotation

from tabletop_objects.values import to_unit_box

from ..bundle import BOUNDS, read_inside
from ..errors import BackendError, BundleError, InputError, choices
from ..geometry import convex_outline, hull_points, quaternion_yaw
from ..io.bounded import parse_object, printable
from ..meshes.reading.loader import load_surface
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import body_mass
from ..physics.parts import model_parts
from ..scene import (
    TABLE,
    ConvexPart,
    Mesh,
    Model,
    Object,
    Placement,
    Pose,
    Provenance,
    Scene,
    Table,
)
from ..scene.triangles import scaled_normals

TRANSFORMS = "transforms.json"
"""Name of the file that must be in a result's folder."""

MOST_OBJECTS = 256
_MAX_LENGTH = 100.0  # metres: larger values mean that the unit is wrong
_SHEAR = 1e-3
_TOP = 0.01  # metres; parts of the table this close to its level belong to the top
_EVEN = 0.003  # metres; maximum unevenness of a top
_LEVEL = 0.97  # minimum cosine of a level surface's slope
_MIN_TOP = 0.03  # square metres
_RIM = 0.04  # metres; maximum height of a rim above the top
_Z_UP = {"y": np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), "z": np.eye(3)}


def load_external(folder: str | Path, *, decompose: bool = True) -> Scene:
    """Read another method's result as a scene, with objects at the given poses.

    Objects are not moved, so overlapping or floating objects remain so. Mass and friction are this
    project's defaults. With ``decompose``, convex parts are computed for simulation (in seconds to
    a minute per object; results are cached). Otherwise each object's only part is its convex hull,
    which suffices for measurements of meshes and pictures; a warning in the provenance records
    this.

    Raises:
        InputError: A file is missing, damaged, too large or outside the folder, or a value is not a
            number, not a valid pose, or not in metres.
        SceneError: A mesh cannot be decomposed.
    """
    place = Path(folder)
    payload = parse_object(_read(place, TRANSFORMS), f"{place}: {TRANSFORMS}", InputError)
    up = payload.get("up", "y")
    if not isinstance(up, str) or up not in _Z_UP:
        raise InputError(f'{place}: \'up\' must be "y" or "z", got {up!r:.80}.')
    name = printable(payload.get("name", place.name), f"{place}: 'name'", InputError)
    method = printable(payload.get("method", "unknown"), f"{place}: 'method'", InputError)
    entries = payload.get("objects")
    if not isinstance(entries, list) or len(entries) > MOST_OBJECTS:
        raise InputError(f"{place}: 'objects' must be a list of at most {MOST_OBJECTS} objects.")
    meshes = _Meshes(place, _Z_UP[up])
    mesh, shift = _table_mesh(place, payload.get("table"), meshes)
    table = _table(mesh, f"{place}: the table")
    bodies = [_object(place, entry, meshes, shift, decompose) for entry in entries]
    _check_supports(bodies)
    warnings = () if decompose else ("collision parts are convex hulls, unsuitable for simulation",)
    provenance = Provenance("manual", 0, prompt=f"method: {method}", warnings=warnings)
    return Scene(name, table, tuple(bodies), provenance)


def _read(place: Path, name: str) -> bytes:
    try:
        return read_inside(place, name, BOUNDS.file_bytes)
    except BundleError as error:
        raise InputError(str(error)) from error


class _Meshes:
    """The meshes in a result's folder, with z up; each file is read only once."""

    def __init__(self, place: Path, turn: Float[np.ndarray, "3 3"]) -> None:
        self._place, self._turn = place, turn
        self._known: dict[str, Mesh] = {}

    def of(self, entry: Mapping[str, Any]) -> Mesh:
        """Return the mesh in the file named by an entry."""
        place, name = self._place, entry.get("glb")
        if not isinstance(name, str):
            raise InputError(f"{place}: the name of a file must be a string, got {name!r}.")
        if name not in self._known:
            mesh = read_glb(_read(place, name), f"{place}: {name}")
            upright = mesh.vertices @ self._turn.T
            self._known[name] = Mesh(upright, mesh.faces, mesh.uv, mesh.texture)
        return self._known[name]


def _table_mesh(place: Path, entry: Any, meshes: _Meshes) -> tuple[Mesh, Float[np.ndarray, "3"]]:
    """Return the table in metres, and the translation that moves it under the origin."""
    if not isinstance(entry, dict):
        raise InputError(
            f"{place}: 'table' must have a 'glb' and a 'matrix', or a 'size'. See "
            "generator.evaluation.external."
        )
    if "size" in entry:
        size = _numbers(entry["size"], (3,), f"{place}: the table's size")
        if size.min() <= 0:
            raise InputError(f"{place}: the table's size must be positive, in metres, got {size}.")
        top = _numbers(entry.get("top", [0, 0, size[2]]), (3,), f"{place}: the table's top")
        return _block(size), np.array([0.0, 0.0, size[2]]) - top
    mesh = meshes.of(entry)
    scale, rotation, shift = _pose(entry, f"{place}: the table")
    vertices = (mesh.vertices * scale) @ rotation.T + shift
    low, high = vertices.min(0), vertices.max(0)
    move = -np.array([*(low + high)[:2] / 2, low[2]])
    return Mesh(vertices, mesh.faces, mesh.uv, mesh.texture), move


def _table(mesh: Mesh, what: str) -> Table:
    """Return the table; its collision shape is a slab under the tabletop that excludes the rim."""
    unit, _, extent = to_unit_box(mesh)
    model = Model(TABLE, TABLE, unit, extent)
    vertices = unit.vertices * extent
    high = _top(vertices[unit.faces], what)
    if (above := float(vertices[:, 2].max()) - high) > _RIM:
        raise InputError(
            f"{what} extends {100 * above:.0f} cm above its largest level surface. Remove the "
            "objects on the table from the table's mesh."
        )
    outline = convex_outline(vertices[np.abs(vertices[:, 2] - high) < _TOP][:, :2])
    slab = np.array([[x, y, z] for x, y in outline for z in (high - 3 * _TOP, high)])
    return Table(model, extent, (ConvexPart(slab),), outline, model.physics.friction)


def _top(triangles: Float[np.ndarray, "m 3 3"], what: str) -> float:
    """Return the tabletop's height: the highest level with at least half the maximum level area."""
    normals = scaled_normals(triangles) / 2
    areas = np.linalg.norm(normals, axis=1)
    level = np.abs(normals[:, 2]) > _LEVEL * areas  # faces may be oriented in either direction
    order = np.argsort(triangles[level].mean(1)[:, 2], kind="stable")
    heights, areas = triangles[level].mean(1)[order, 2], areas[level][order]
    sums = np.append(0.0, np.cumsum(areas))
    first = np.searchsorted(heights, heights - _EVEN)
    near = sums[1:] - sums[first]  # area between just below each triangle and the triangle
    if near.max(initial=0.0) < _MIN_TOP:
        raise InputError(
            f"{what} has no level surface of at least {1e4 * _MIN_TOP:.0f} square centimetres."
        )
    last = int(np.flatnonzero(near >= near.max() / 2)[-1])
    middle = np.searchsorted(sums, (sums[first[last]] + sums[last + 1]) / 2, side="right") - 1
    return float(heights[min(int(middle), last)])


def _object(
    place: Path, entry: Any, meshes: _Meshes, shift: Float[np.ndarray, "3"], decompose: bool
) -> Object:
    if not isinstance(entry, dict) or not isinstance(entry.get("name"), str):
        raise InputError(f"{place}: each object needs a 'name', a 'glb' and a 'matrix'.")
    name = printable(entry["name"], f"{place}: the name of an object", InputError)
    scale, rotation, translation = _pose(entry, f"{place}: {name}")
    unit, center, extent = to_unit_box(meshes.of(entry))
    extent = extent * scale
    if not 1e-4 <= extent.max() <= _MAX_LENGTH:
        raise InputError(
            f"{place}: {name} is {extent.max():.3g} m long; lengths must be in metres."
        )
    label = entry.get("label", name.rstrip("0123456789").rstrip("_ ") or name)
    label = printable(label, f"{place}: the label of {name}", InputError)
    on, inside = entry.get("on", TABLE), entry.get("inside", False)
    if not isinstance(on, str) or not isinstance(inside, bool):
        raise InputError(
            f"{place}: for {name}, 'on' must be a name, and 'inside' must be true or false."
        )
    position = rotation @ (center * scale) + translation + shift
    quaternion = Rotation.from_matrix(rotation).as_quat(scalar_first=True)
    placement = Placement(name, quaternion_yaw(quaternion), position, extent, on, inside)
    hull = () if decompose else (ConvexPart(hull_points(unit.vertices.astype(float))),)
    model = Model(name, label, unit, extent, parts=hull)
    parts = model_parts(model, extent)
    weighed = body_mass(unit, extent, model.physics, parts)
    return Object(
        name, model, placement, parts, weighed.mass, weighed.com, weighed.inertia,
        model.physics.friction, Pose(position, quaternion),
    )  # fmt: skip


def _pose(
    entry: Mapping[str, Any], what: str
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]]:
    """Split an entry's matrix into scale (along the mesh's axes), rotation and translation."""
    matrix = _numbers(entry.get("matrix"), (4, 4), f"{what}: the matrix")
    linear, translation = matrix[:3, :3], matrix[:3, 3]
    scale = np.linalg.norm(linear, axis=0)
    if not np.allclose(matrix[3], [0, 0, 0, 1]) or scale.min() < 1e-9:
        raise InputError(
            f"{what}: the matrix must be affine, with last row 0 0 0 1, and not singular."
        )
    rotation = linear / scale
    if np.abs(rotation.T @ rotation - np.eye(3)).max() > _SHEAR or np.linalg.det(rotation) < 0:
        raise InputError(f"{what}: the matrix mirrors or shears; apply this to the mesh instead.")
    if np.abs(translation).max() > _MAX_LENGTH:
        raise InputError(
            f"{what}: the translation is {np.abs(translation).max():.3g} m; lengths must be in "
            "metres."
        )
    return scale, rotation, translation


def _numbers(value: Any, shape: tuple[int, ...], what: str) -> Float[np.ndarray, "..."]:
    try:
        array = np.array(value, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{what} must contain only numbers.") from error
    if array.shape != shape or not np.isfinite(array).all():
        raise InputError(f"{what} must be {' x '.join(map(str, shape))} finite numbers.")
    return array


def _check_supports(bodies: list[Object]) -> None:
    for name, on in ((o.name, o.placement.on) for o in bodies):
        others = {TABLE, *(o.name for o in bodies)} - {name}
        if on not in others:
            raise InputError(f"{name!r} stands on an unknown object." + choices(on, others))


def _block(size: Float[np.ndarray, "3"]) -> Mesh:
    import trimesh

    box = trimesh.creation.box(extents=size)
    texture = np.full((2, 2, 3), 200, np.uint8)
    return Mesh(box.vertices, box.faces, np.zeros((len(box.vertices), 2)), texture)


MOST_FACES = 400_000
"""Maximum size of a mesh; larger meshes are rejected."""


def read_glb(raw: bytes, what: str) -> Mesh:
    """Return all meshes in a GLB file as one mesh, with node transforms applied.

    ``what`` is the subject of error messages. Only the materials' base colours are used: a texture
    if all faces share it, otherwise one colour per face. Files outside the GLB are not opened.

    Raises:
        InputError: The file is not a GLB, is damaged, is too large, has no triangles or has NaN.
    """
    if raw[:4] != b"glTF":
        raise InputError(f"{what} is not a GLB file. Save each object as binary glTF.")
    try:
        surface = load_surface(raw, what, "glb", most_faces=MOST_FACES)
    except BackendError as error:
        raise InputError(str(error)) from error
    if len(surface.pictures) != 1 or (surface.picture != 0).any():
        return _color(surface)
    uv = np.where((surface.uv < 0) | (surface.uv > 1), surface.uv % 1.0, surface.uv)
    return Mesh(surface.vertices, surface.faces, uv, surface.pictures[0])


def _color(surface: ColoredSurface) -> Mesh:
    """Return a mesh whose texture is a palette with one texel per face."""
    corners = surface.vertices[surface.faces].reshape(-1, 3)
    count = len(surface.faces)
    colors = surface.colors_at(np.arange(count), np.full((count, 3), 1 / 3))
    texture, index = _palette(np.clip(np.round(colors), 0, 255).astype(np.uint8))
    width = texture.shape[1]
    uv = np.column_stack([(index + 0.5) / width, np.full(len(index), 0.5)]).repeat(3, axis=0)
    return Mesh(corners, np.arange(len(corners)).reshape(-1, 3), uv, texture)


def _palette(
    colors: UInt8[np.ndarray, "m 3"],
) -> tuple[UInt8[np.ndarray, "1 k 3"], Int[np.ndarray, "m"]]:
    """Return up to 512 colours as a one-row texture, and the column of each face's colour."""
    coarse = (colors >> 5).astype(np.int64) @ [64, 8, 1]
    cells, index = np.unique(coarse, return_inverse=True)
    sums: Float[np.ndarray, "k 3"] = np.zeros((len(cells), 3))
    np.add.at(sums, index, colors)
    mean = sums / np.bincount(index)[:, None]
    return mean.round().astype(np.uint8)[None], index
