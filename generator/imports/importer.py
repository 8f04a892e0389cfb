"""Import of a foreign scene: read, rebuilt, settled and judged."""

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
from .building import build_scene
from .folder import POSES
from .options import ImportOptions
from .reader import SourceKind, read_scene

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
    """Return a foreign scene, settled and judged; its report may have failed.

    ``source`` is a MJCF, GLB or OBJ file, a folder with ``poses.json`` and the files it names, or a
    folder with ``scene.xml``, as ``export`` writes it. A single object without a table stands on a
    plain one. Objects that cannot be used are refused and the others stay; ``list_outcomes`` says
    what was done with each. The same source gives the same scene.

    ``config`` replaces the settings of the assembly, the gate's lean with them; by default that is
    the lean of the options.

    Raises:
        InputError: it cannot be read, or has no object that can be used, no table or too many
            objects.
        SceneError: nothing comes to rest.
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


def _digest(path: Path) -> str:
    """Return the sha256 of the file that says what is where."""
    file = path / POSES if path.is_dir() else path
    return hashlib.sha256(file.read_bytes()).hexdigest()
