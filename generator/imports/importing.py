"""Import of a foreign scene: read, rebuilt, settled and judged."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Literal

import numpy as np

from ..errors import BackendError, InputError
from ..meshes.reading.surface import ColoredSurface
from ..method.assembly import AssemblyConfig
from ..physics.gate import GateLimits
from ..physics.inertia import MassProperties
from ..sandbox import SandboxError, call
from ..scene import ConvexPart, Provenance, Scene
from ..scene.provenance import scene_name, versions
from .building import build_scene
from .folder import POSES, on_plain_table, read_file, read_folder
from .foreign import ForeignBody, ForeignScene, Outcome
from .options import ImportOptions

SourceKind = Literal["mjcf", "glb", "obj", "folder"]
"""What a foreign scene is: a MJCF, GLB or OBJ file, or a folder of files with ``poses.json``."""

_SCENE = "scene.xml"
_KINDS: Mapping[str, SourceKind] = MappingProxyType(
    {".xml": "mjcf", ".mjcf": "mjcf", ".glb": "glb", ".obj": "obj"}
)
_USUAL = ImportOptions()
_VALUES = (ForeignScene, ForeignBody, ColoredSurface, ConvexPart, MassProperties, Outcome)


def import_scene(
    source: str | Path,
    options: ImportOptions = _USUAL,
    config: AssemblyConfig | None = None,
) -> Scene:
    """Return a foreign scene, settled and judged; its report may have failed.

    ``source`` is a MJCF, GLB or OBJ file, a folder with ``poses.json`` and the files it names, or a
    folder with ``scene.xml``, as ``export`` writes it. A single object without a table stands on a
    plain one. Objects that cannot be used are refused and the others stay; ``list_outcomes`` says
    what was done with each. The same source gives the same scene.

    ``config`` replaces the settings of the assembly; by default the gate's lean is that of the
    options.

    Raises:
        InputError: it cannot be read, or has no object that can be used, no table or too many
            objects.
        SceneError: nothing comes to rest.
    """
    kind, path = find_source(Path(source))
    try:
        foreign = _read(kind, path, options)
        name = options.name or scene_name(foreign.name)
        settings = {
            "import": kind, "table": options.table, "drop_failing": options.drop_failing,
            "scale": options.scale, "lean": options.lean,
        }  # fmt: skip
        config = config or AssemblyConfig(limits=GateLimits(lean=float(np.deg2rad(options.lean))))
        provenance = Provenance(
            "manual", 0, source_sha256=_digest(path), config=settings, versions=versions()
        )
        return build_scene(foreign, provenance, name, config, options.drop_failing)
    except BackendError as error:  # a mesh that cannot be read is no backend's fault here
        raise InputError(str(error)) from error


def find_source(path: Path) -> tuple[SourceKind, Path]:
    """Return what a path is, and the file or folder to read.

    Raises:
        InputError: there is nothing to import.
    """
    if path.is_dir():
        if (path / POSES).is_file() and not (path / _SCENE).is_file():
            return "folder", path
        if (path / _SCENE).is_file():
            return "mjcf", path / _SCENE
        raise InputError(f"{path} has neither {_SCENE} nor {POSES}; see the page on importing.")
    suffix = path.suffix.lower()
    if suffix not in _KINDS:
        raise InputError(
            f"{path} cannot be imported: MJCF (.xml), GLB, OBJ and folders with {POSES} can."
        )
    if not path.is_file():
        raise InputError(f"There is no file {path}.")
    return _KINDS[suffix], path


def _read(kind: SourceKind, path: Path, options: ImportOptions) -> ForeignScene:
    """Return what a source holds, scaled, with a table."""
    if kind == "folder":
        return _read_folder(path, options.scale)
    if kind == "obj":
        foreign = read_file(path)
    elif kind == "glb":
        from .glb import read_glb

        foreign = read_glb(path, options.table)
    else:
        from .mjcf import read_mjcf

        foreign = read_mjcf(path, options.root, options.table)
    foreign = foreign.scaled(options.scale)
    return on_plain_table(foreign) if foreign.table is None else foreign


def _read_folder(path: Path, scale: float) -> ForeignScene:
    """Read a folder in one child process; if that reaches a limit, in one for each file."""
    try:
        return call(read_folder, path.absolute(), scale, returns=_VALUES)
    except SandboxError:
        return read_folder(path, scale, apart=True)


def _digest(path: Path) -> str:
    """Return the sha256 of the file that says what is where."""
    file = path / POSES if path.is_dir() else path
    return hashlib.sha256(file.read_bytes()).hexdigest()
