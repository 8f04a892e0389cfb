"""Import of a foreign scene: reading, conversion, settling and the gate."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Literal

import numpy as np

from ..errors import BackendError, InputError
from ..meshes.reading.bounds import LIMITS
from ..meshes.reading.surface import ColoredSurface
from ..method.assembly import AssemblyConfig
from ..physics.gate import GateLimits
from ..physics.inertia import MassProperties
from ..sandbox import SandboxError, call
from ..scene import ConvexPart, Provenance, Scene
from ..scene.provenance import scene_name, versions
from .folder import POSES
from .foreign import ForeignBody, ForeignScene, ImportOutcome
from .options import ImportOptions
from .scene import build_scene

_SCENE = "scene.xml"
_KINDS: Mapping[str, SourceKind] = MappingProxyType(
    {".xml": "mjcf", ".mjcf": "mjcf", ".glb": "glb", ".obj": "obj"}
)
_USUAL = ImportOptions()


def import_scene(
    source: str | Path,
    options: ImportOptions = _USUAL,
    config: AssemblyConfig | None = None,
) -> Scene:
    """Return a foreign scene, settled, with its report; the gate may have failed.

    ``source`` is an MJCF, GLB or OBJ file, a folder with ``poses.json`` and the files it lists, or
    a folder with ``scene.xml``, as written by ``export``. A single object without a table is placed
    on a plain one. Objects that cannot be imported are refused without affecting the others;
    ``list_outcomes`` gives the outcome of each. The same source gives the same scene.

    ``config`` replaces the settings of the assembly, including the gate's lean, which otherwise
    comes from the options.

    Raises:
        InputError: the source cannot be read, or has no usable object, no table or too many
            objects.
        SceneError: no object comes to rest.
    """
    kind, path = find_source(Path(source))
    try:
        foreign = read_scene(kind, path, options.root, options.table, options.scale)
        name = options.name or scene_name(foreign.name)
        lean = options.lean if config is None else float(np.rad2deg(config.limits.lean))
        settings = {
            "import": kind, "table": options.table, "drop_failing": options.drop_failing,
            "scale": options.scale, "lean": lean,
        }  # fmt: skip
        config = config or AssemblyConfig(limits=GateLimits(lean=float(np.deg2rad(lean))))
        provenance = Provenance(
            "manual", 0, source_sha256=_digest(path), config=settings, versions=versions()
        )
        return build_scene(foreign, provenance, name, config, options.drop_failing)
    except BackendError as error:  # here an unreadable mesh is an error of the input
        raise InputError(str(error)) from error


def find_source(path: Path) -> tuple[SourceKind, Path]:
    """Return the kind of a source, and the file or folder to read.

    Raises:
        InputError: there is nothing to import.
    """
    if path.is_dir():
        if (path / POSES).is_file() and not (path / _SCENE).is_file():
            return "folder", path
        if (path / _SCENE).is_file():
            return "mjcf", path / _SCENE
        raise InputError(f"{path} has neither {_SCENE} nor {POSES}. See the guide on importing.")
    suffix = path.suffix.lower()
    if suffix not in _KINDS:
        raise InputError(
            f"{path} cannot be imported. Pass an MJCF (.xml), GLB or OBJ file, or a folder with "
            f"{POSES}."
        )
    if not path.is_file():
        raise InputError(f"There is no file {path}.")
    return _KINDS[suffix], path


def _digest(path: Path) -> str:
    """Return the sha256 of a source's main file."""
    file = path / POSES if path.is_dir() else path
    return hashlib.sha256(file.read_bytes()).hexdigest()


SourceKind = Literal["mjcf", "glb", "obj", "folder"]
"""Kinds of foreign scenes: an MJCF, GLB or OBJ file, or a folder of files with ``poses.json``."""

_VALUES = (ForeignScene, ForeignBody, ColoredSurface, ConvexPart, MassProperties, ImportOutcome)


def read_scene(
    kind: SourceKind,
    path: Path,
    root: Path | None = None,
    table: str | None = None,
    scale: float = 1.0,
) -> ForeignScene:
    """Return a foreign scene with a table, read in a child process; its arrays are read-only.

    ``root`` is the folder that contains an MJCF and all its files, ``table`` is the name of the
    fixed body or geom that is the table, and ``scale`` multiplies all lengths; see the reader of
    each kind. If the files of a folder reach a limit together, each is read in its own child
    process, so that only a file that reaches it alone is refused.

    Raises:
        InputError: the file cannot be read, or its reader reaches a limit.
        BackendError: a mesh cannot be read; see ``meshes.reading``.
    """
    folder = None if root is None else root.absolute()
    source = (kind, path.absolute(), folder, table, scale)
    try:
        return call(read_source_file, *source, limits=LIMITS, returns=_VALUES)
    except SandboxError as error:
        if kind == "folder":
            from .folder import read_folder

            return read_folder(path, scale, apart=True)
        raise InputError(f"The scene {path.name!r} {error}. {_advice(error)}") from error


def read_source_file(
    kind: SourceKind, path: Path, root: Path | None, table: str | None, scale: float
) -> ForeignScene:
    """Return a foreign scene with a table, read in this process."""
    from .folder import on_plain_table, read_file, read_folder

    if kind == "folder":
        return read_folder(path, scale)
    if kind == "obj":
        foreign = read_file(path)
    elif kind == "glb":
        from .glb import read_glb

        foreign = read_glb(path, table)
    else:
        from .mjcf import read_mjcf

        foreign = read_mjcf(path, root, table)
    foreign = foreign.scale(scale)
    return on_plain_table(foreign) if foreign.table is None else foreign


def _advice(error: SandboxError) -> str:
    if error.breach in ("parser", "crash"):
        return "Export it again, or check it with the program that made it."
    return "Use fewer or smaller meshes and textures."
