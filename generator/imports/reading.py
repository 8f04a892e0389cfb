"""A foreign scene read in a child process with limits, which hands back finished arrays.

Whatever a file holds is parsed and compiled there, and nowhere else: a file that makes a parser
loop, crash or fill the memory costs a child process, and ends as one error.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from ..errors import InputError
from ..meshes.reading.bounds import LIMITS
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import MassProperties
from ..sandbox import SandboxError, call
from ..scene import ConvexPart
from .foreign import ForeignBody, ForeignScene

SourceKind = Literal["mjcf", "glb", "folder"]
"""What a foreign scene is: a MJCF file, a GLB file, or a folder of files with ``poses.json``."""

_VALUES = (ForeignScene, ForeignBody, ColoredSurface, ConvexPart, MassProperties)


def read_scene(
    kind: SourceKind, path: Path, root: Path | None = None, table: str | None = None
) -> ForeignScene:
    """Return a foreign scene, read in a child process; its arrays are read-only.

    ``root`` is the folder that a MJCF and all its files are inside of, ``table`` the name of the
    fixed thing that is the table; see the reader of each kind.

    Raises:
        InputError: the file cannot be read, or its reader reaches a limit.
        BackendError: a mesh cannot be read; see ``meshes.reading``.
    """
    folder = None if root is None else root.absolute()
    try:
        return call(
            read_source_file, kind, path.absolute(), folder, table, limits=LIMITS, returns=_VALUES
        )
    except SandboxError as error:
        raise InputError(f"The scene {path.name!r} {error}. {_advice(error)}") from error


def read_source_file(
    kind: SourceKind, path: Path, root: Path | None, table: str | None
) -> ForeignScene:
    """Return a foreign scene, read in this process."""
    if kind == "folder":
        from .folder import read_folder

        return read_folder(path)
    if kind == "glb":
        from .glb import read_glb

        return read_glb(path, table)
    from .mjcf import read_mjcf

    return read_mjcf(path, root, table)


def _advice(error: SandboxError) -> str:
    if error.breach in ("parser", "crash"):
        return "Export it again, or check it with the program that made it."
    return "Use fewer or smaller meshes and textures."
