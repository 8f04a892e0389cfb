"""Reading of foreign scenes in a child process with limits on time and memory."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from ..errors import InputError
from ..meshes.reading.bounds import LIMITS
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import MassProperties
from ..sandbox import SandboxError, call
from ..scene import ConvexPart
from .foreign import ForeignBody, ForeignScene, ImportOutcome

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
