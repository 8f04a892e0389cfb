"""Export of a scene, or of one object, to a format that other programs read."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from ..bundle.publication import publish
from ..errors import StorageError, require_known
from ..io.files import write_whole
from ..scene import Object, Scene
from .bodies import ExportWorld, object_world, scene_world
from .glb import glb_files
from .mjcf import mjcf_files
from .sdf import sdf_files
from .urdf import urdf_files
from .usd import usd_files, usdz_files

WRITERS: Mapping[str, Callable[[ExportWorld], Mapping[str, bytes]]] = MappingProxyType(
    {
        "mjcf": mjcf_files,
        "urdf": urdf_files,
        "sdf": sdf_files,
        "glb": glb_files,
        "usd": usd_files,
        "usdz": usdz_files,
    }
)
"""Functions that make the files of each format, by path in the export's folder."""

ALONE = ("glb", "usdz")
"""Formats whose export is a single file."""

_ADVICE = "Free disk space, or choose another folder."


def export(scene: Scene, to: str, folder: str | Path, name: str | None = None) -> Path:
    """Write a scene to ``folder``; return the path of the export.

    The export is ``NAME.glb`` or ``NAME.usdz``, or else a folder ``NAME-FORMAT`` with the document
    (``scene.xml``, ``scene.urdf``, ``scene.sdf``, ``scene.usdc``) and the files it refers to. It is
    written completely or not at all, and replaces an existing export. The same scene gives the same
    bytes.

    Args:
        scene: scene to write.
        to: a key of ``WRITERS``.
        folder: created if missing.
        name: name of the file or folder; None uses the scene's.

    Raises:
        InputError: there is no such format, or its library is not installed.
        StorageError: the folder cannot be written, or the disk is full.
    """
    require_known(to, WRITERS, "No export to")
    return _write(scene_world(scene), to, Path(folder), name or scene.name)


def export_object(thing: Object, to: str, folder: str | Path) -> Path:
    """Write one object, free to move, above a floor and without a table; see also ``export``.

    Raises:
        InputError: there is no such format, or its library is not installed.
        StorageError: the folder cannot be written, or the disk is full.
    """
    require_known(to, WRITERS, "No export to")
    return _write(object_world(thing), to, Path(folder), thing.name)


def _write(world: ExportWorld, to: str, folder: Path, stem: str) -> Path:
    files = WRITERS[to](world)
    try:
        if to not in ALONE:
            return publish(folder, f"{stem}-{to}", files)
        (content,) = files.values()
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"The export cannot be written to {folder}: {error.strerror or error}. {_ADVICE}"
        ) from error
    target = folder / f"{stem}.{to}"
    write_whole(target, content, "The export", _ADVICE)
    return target
