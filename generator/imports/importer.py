"""Import of a foreign scene: reading, conversion, settling and the gate."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np

from ..errors import BackendError, InputError
from ..method.assembly import AssemblyConfig
from ..physics.gate import GateLimits
from ..scene import Provenance, Scene
from ..scene.provenance import scene_name, versions
from .folder import POSES
from .options import ImportOptions
from .reader import SourceKind, read_scene
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
    """Return the imported and settled scene with its report, whether or not it passes the gate.

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
        raise InputError(
            f"{path} contains neither {_SCENE} nor {POSES}. See docs/guides/importing.md."
        )
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
