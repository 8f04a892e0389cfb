"""A folder of GLB and OBJ files with ``poses.json``, which lists the files and their poses.

    {
      "table": {"file": "table.glb"},
      "objects": [
        {"name": "mug_1", "file": "mug.glb", "position": [0.2, 0.1, 0.78],
         "quaternion": [1, 0, 0, 0], "mass": 0.3, "category": "mug", "scale": 1.0}
      ]
    }

Positions are in metres, z up; quaternions are wxyz. Both refer to the file's own frame after it is
made upright (GLB is y up unless the entry has ``"up": "z"``) and scaled. Instead of a file, the
table may have a ``"size"``: length, width and height in metres of a plain table at the world's
origin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import Any, cast

import numpy as np
from jaxtyping import Float

from ..errors import BackendError, InputError
from ..geometry import quaternion_matrix
from ..io.bounded import is_number, parse_object, printable
from ..meshes.reading.bounds import LIMITS, MOST_BYTES, MOST_FACES
from ..meshes.reading.companions import companions, total_bytes
from ..meshes.reading.surface import Axis, ColoredSurface, Kind, read_surface
from ..sandbox import CpuBudget, SandboxError, SandboxLimits, call
from ..scene import TABLE, ConvexPart, Mesh, Model, PlannedTable
from ..tables import build_table
from .foreign import ForeignBody, ForeignScene, Refusals, check_count, read_source

POSES = "poses.json"
"""Name of the file that lists files and poses."""

_MOST_POSES, _MOST_SCALE = 2**20, 1e4
_APART = SandboxLimits(cpu_seconds=4.0)  # of a single file, once all together reached their limit
_MOST_EXHAUSTED = 3  # number of files that may reach it before the remaining ones are skipped
_MOST_TOGETHER = 384 * 2**20  # bytes of all files, each counted once
_PLAIN = (1.2, 0.8, 0.74)  # metres, the minimum size of a plain table
_OBJECT = {"name", "file", "position", "quaternion", "mass", "category", "scale", "friction", "up"}
_TABLE = {"file", "position", "quaternion", "scale", "friction", "up", "size"}


def read_folder(folder: Path, scale: float = 1.0, apart: bool = False) -> ForeignScene:
    """Read a folder of files with ``poses.json``; objects that cannot be read are refused.

    ``scale`` applies to objects without a scale of their own. ``apart`` reads each file in its own
    child process, so that only a file that reaches a limit is refused.

    Raises:
        InputError: ``poses.json`` is missing or damaged, or no object can be read.
        BackendError: the table's file cannot be read; see ``meshes.reading``.
    """
    reader = _FolderReader(folder, scale, apart)
    payload = parse_object(reader.read(POSES, _MOST_POSES), POSES, InputError)
    table, objects = payload.get("table"), payload.get("objects")
    if isinstance(table, dict) and "quaternion_wxyz" in table:
        raise InputError(
            f"{folder / POSES} belongs to a URDF export, which cannot be imported. Export the "
            "scene as GLB or MJCF and import that."
        )
    _check_keys(payload, {"table", "objects", "name"}, POSES)
    if not isinstance(table, dict):
        raise InputError(f'{POSES} has no table: {{"file": …}} or {{"size": [x, y, z]}}.')
    if not isinstance(objects, list) or not objects:
        raise InputError(f"{POSES} must have a list 'objects' of at least one object.")
    check_count(len(objects))
    refusals, bodies = Refusals(), list[ForeignBody]()
    for k, entry in enumerate(cast("list[Any]", objects)):
        with refusals.catching(_name_of(entry, k)):
            bodies.append(reader.object(entry, k))
    refusals.check_left(bodies)
    name = payload.get("name", folder.resolve().name)
    return ForeignScene(
        printable(name, f"The name in {POSES}", InputError), reader.table(table), tuple(bodies),
        refused=tuple(refusals.outcomes),
    )  # fmt: skip


def read_file(path: Path) -> ForeignScene:
    """Read a GLB or OBJ file as a single object without a table.

    Raises:
        InputError: the file's name has unprintable characters.
        BackendError: the file cannot be read; see ``meshes.reading``.
    """
    entry = {"name": path.stem, "file": path.name, "position": [0.0, 0.0, 0.0]}
    return ForeignScene(path.stem, None, (_FolderReader(path.parent).object(entry, 0),))


def on_plain_table(foreign: ForeignScene) -> ForeignScene:
    """Return a scene of a single object, placed in the middle of a plain table."""
    (body,) = foreign.objects
    world = body.surface.vertices @ body.rotation.T
    low, high = world.min(0), world.max(0)
    length, width, height = (float(v) for v in np.maximum(_PLAIN, [*2 * (high - low)[:2], 0.0]))
    table = body_of(build_table(PlannedTable(size=(length, width, height)), 0))
    position = np.array([*-(low + high)[:2] / 2, height - low[2]])
    return replace(foreign, table=table, objects=(replace(body, position=position),))


def _name_of(entry: object, number: int) -> str:
    """Return the name that messages use for the object of a ``poses.json`` entry."""
    name = cast("dict[str, Any]", entry).get("name") if isinstance(entry, dict) else None
    return name[:100] if isinstance(name, str) and name else f"thing_{number + 1}"


class _FolderReader:
    """Reads the files of a folder, each once."""

    def __init__(self, folder: Path, scale: float = 1.0, apart: bool = False) -> None:
        self._folder = folder
        self._scale = scale
        self._apart = apart
        self._decoded: dict[PurePosixPath, ColoredSurface | BackendError | InputError] = {}
        self._surfaces: dict[tuple[PurePosixPath, Axis], ColoredSurface] = {}
        self._faces = 0  # triangles of all bodies
        self._texture_bytes = 0
        self._left = _MOST_TOGETHER  # remaining bytes of files
        self._budget = CpuBudget(LIMITS.cpu_seconds)  # of files read separately
        self._exhausted = 0  # number of files that reached a limit

    def read(self, name: str, limit: int) -> bytes:
        """Return the content of a file inside the folder."""
        return read_source(self._folder, name, limit)

    def object(self, entry: Any, number: int) -> ForeignBody:
        """Return the object that an entry of ``poses.json`` describes."""
        what = f"{POSES}, objects[{number}]"
        if not isinstance(entry, dict):
            raise InputError(f"{what} must be a JSON object.")
        _check_keys(entry, _OBJECT, what)
        name = printable(
            entry.get("name", f"thing_{number + 1}"), f"The name in {what}", InputError
        )
        category = printable(entry.get("category", ""), f"The category in {what}", InputError)
        if "position" not in entry:
            raise InputError(f"{what} has no position.")
        mass = None if "mass" not in entry else _number(entry["mass"], f"{what}.mass", 1e3)
        return self._body(entry, name, what, category, mass)

    def table(self, entry: Mapping[str, Any]) -> ForeignBody:
        """Return the table that the table entry of ``poses.json`` describes."""
        what = f"{POSES}, table"
        _check_keys(entry, _TABLE, what)
        if ("size" in entry) == ("file" in entry):
            raise InputError(f"{what} needs either a file or a size.")
        if "file" in entry:
            return self._body({"position": [0, 0, 0], **entry}, TABLE, what, TABLE, None)
        length, width, height = _vector(entry["size"], 3, f"{what}.size").tolist()
        return body_of(build_table(PlannedTable(size=(length, width, height)), 0))

    def _body(
        self, entry: Mapping[str, Any], name: str, what: str, category: str, mass: float | None
    ) -> ForeignBody:
        up = entry.get("up", "")
        if up not in ("", "y", "z"):
            raise InputError(f'{what}.up must be "y" or "z", got {str(up)[:20]!r}.')
        surface = self._surface(entry.get("file"), what, up or "y")
        scale = entry.get("scale", self._scale)
        factor = (
            np.full(3, _number(scale, f"{what}.scale", _MOST_SCALE))
            if not isinstance(scale, list)
            else _vector(scale, 3, f"{what}.scale")
        )
        if (factor <= 0).any():
            raise InputError(f"{what}.scale must be positive.")
        quaternion = _vector(entry.get("quaternion", [1, 0, 0, 0]), 4, f"{what}.quaternion")
        if abs(np.linalg.norm(quaternion) - 1) > 1e-2:
            raise InputError(f"{what}.quaternion must have length 1 (wxyz).")
        friction = entry.get("friction")
        return ForeignBody(
            name, _vector(entry["position"], 3, f"{what}.position"),
            quaternion_matrix(quaternion), replace(surface, vertices=surface.vertices * factor),
            friction=None if friction is None else _number(friction, f"{what}.friction", 5.0),
            category=category, weight=mass,
        )  # fmt: skip

    def _surface(self, file: object, what: str, up: Axis) -> ColoredSurface:
        if not isinstance(file, str) or not file:
            raise InputError(f"{what} has no file.")
        path = PurePosixPath(file)  # "./a.glb" is the same file as "a.glb"
        if path.suffix.lower() not in (".glb", ".obj"):
            raise InputError(
                f"{what} refers to {file[:80]!r}; only GLB and OBJ files can be imported."
            )
        if (path, up) not in self._surfaces:
            self._surfaces[path, up] = self._decode(path, what).upright(up)
        surface = self._surfaces[path, up]
        faces = self._faces + len(surface.faces)
        if faces > MOST_FACES:
            raise InputError(
                f"The files of {POSES} have more than {MOST_FACES} triangles in total, including "
                "repeated uses of a file. Simplify the meshes."
            )
        self._faces = faces
        return surface

    def _decode(self, path: PurePosixPath, what: str) -> ColoredSurface:
        """Return a file's surface in its own frame; a file is read once, even if reading fails."""
        if path not in self._decoded:
            try:
                self._decoded[path] = self._load(path, what)
            except (BackendError, InputError) as error:
                self._decoded[path] = error
        found = self._decoded[path]
        if isinstance(found, Exception):
            raise found
        return found

    def _load(self, path: PurePosixPath, what: str) -> ColoredSurface:
        kind: Kind = "glb" if path.suffix.lower() == ".glb" else "obj"
        if self._left <= 0:
            raise InputError(
                f"The files of {POSES} have more than {_MOST_TOGETHER} bytes in total."
            )
        raw = self.read(str(path), min(MOST_BYTES, self._left))
        self._left -= len(raw)
        beside: Mapping[str, bytes] = {}
        if kind == "obj":
            place = self._folder.joinpath(*path.parent.parts)
            beside = companions(raw, what, place, min(MOST_BYTES, self._left))
            self._left -= total_bytes(beside)
        surface = self._parse(raw, f"{what}: {path}", kind, beside)
        self._texture_bytes += sum(texture.nbytes for texture in surface.pictures)
        if self._texture_bytes > LIMITS.output:
            raise InputError(
                f"The files of {POSES} have more than {LIMITS.output >> 20} MiB of textures in "
                "total. Use smaller or fewer textures."
            )
        return surface

    def _parse(
        self, raw: bytes, what: str, kind: Kind, beside: Mapping[str, bytes]
    ) -> ColoredSurface:
        if not self._apart:
            return read_surface(raw, what, kind, beside)
        if self._exhausted == _MOST_EXHAUSTED or not self._budget.left:
            raise BackendError(
                f"{what} was skipped: {_MOST_EXHAUSTED} files of {POSES} reached a limit, or all "
                f"together took {LIMITS.cpu_seconds:g} s of CPU time."
            )
        try:
            return call(
                read_surface, raw, what, kind, {**beside}, limits=_APART,
                returns=(ColoredSurface,), budget=self._budget,
            )  # fmt: skip
        except SandboxError as error:
            self._exhausted += error.breach != "parser"
            raise BackendError(f"{what} {error}. Use a simpler mesh.") from error


def body_of(model: Model) -> ForeignBody:
    """Return a model as a body that stands at the world's origin."""
    size = np.asarray(model.size, np.float64)
    parts = tuple(ConvexPart(p.vertices * size, p.kind, p.axis) for p in model.parts)
    return ForeignBody(
        model.name, np.array([0.0, 0.0, size[2] / 2]), np.eye(3), _surface_of(model.mesh, size),
        parts, friction=model.physics.friction,
    )  # fmt: skip


def _surface_of(mesh: Mesh, size: Float[np.ndarray, "3"]) -> ColoredSurface:
    count = len(mesh.vertices)
    return ColoredSurface(
        mesh.vertices * size, mesh.faces.astype(np.int64), mesh.uv.astype(np.float64),
        np.full((count, 3), 190, np.uint8), np.zeros(len(mesh.faces), np.int64),
        (np.asarray(mesh.texture),), mesh.opacity,
    )  # fmt: skip


def _check_keys(entry: Mapping[str, Any], known: set[str], what: str) -> None:
    if unknown := sorted(entry.keys() - known):
        raise InputError(
            f"{what} has an unknown key {unknown[0][:40]!r}; valid keys are "
            f"{', '.join(sorted(known))}."
        )


def _vector(value: object, count: int, what: str) -> Float[np.ndarray, "k"]:
    if not isinstance(value, list) or len(value) != count:
        raise InputError(f"{what} must be a list of {count} numbers.")
    return np.array([_number(v, what, np.inf, signed=True) for v in value])


def _number(value: object, what: str, most: float, *, signed: bool = False) -> float:
    fine = is_number(value, minimum=-1e9, maximum=1e9)
    number = float(cast("float", value)) if fine else 0.0
    if not fine or (not signed and not 0 < number < most):
        raise InputError(f"{what} must be a number" + ("." if signed else f" in (0, {most:g})."))
    return number
