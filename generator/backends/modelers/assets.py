"""Look-up of meshes by object in a folder that has single files or one subfolder per object."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import BackendError

FORMATS = (".glb", ".obj")
"""Supported file formats; the first is preferred if an object has files in both formats."""

_DEPTH = 4  # maximum folder depth
_MOST = 20_000  # maximum number of files and folders

_MODEL_WORDS = frozenset(
    ["textured", "nontextured", "model", "mesh", "base", "visual", "object", "scene", "poisson",
     "google_16k", "google_64k", "google_512k", "tsdf", "meshes", "visuals", "mesh_simplified"]
)  # fmt: skip
"""Names of files and folders that describe the kind of mesh, not the object."""

_WORSE = ("nontextured", "collision", "poisson", "simplified")
"""Words in the path of a mesh that mark it as a last resort."""

_NUMBER = re.compile(r"^\d+[-_ ]+(?=\D)")  # "025_mug"


def plain(word: str) -> str:
    """Return a word as a key: lower case, with underscores."""
    return "_".join(word.lower().replace("-", " ").replace("_", " ").split())


def find_assets(home: Path) -> Mapping[str, Path]:
    """Return the meshes of a folder by object name, such as "mug" for "025_mug/textured.obj".

    An object is named after its file, or after the closest parent folder if the file's name is
    generic ("textured.obj"); leading numbers are ignored. Links are not followed.

    Raises:
        BackendError: the folder has too many files or is not readable.
    """
    ranked: dict[str, tuple[tuple[bool, int, int, str], Path]] = {}
    for file in _walk(home):
        inside = file.relative_to(home)
        name = _name(inside)
        worse = any(word in inside.as_posix().lower() for word in _WORSE)
        rank = (worse, FORMATS.index(file.suffix.lower()), len(inside.parts), inside.as_posix())
        if name and (name not in ranked or rank < ranked[name][0]):
            ranked[name] = rank, file
    return {name: file for name, (_, file) in sorted(ranked.items())}


def _walk(home: Path) -> Iterator[Path]:
    """Yield the meshes of a folder in sorted order, within limits."""
    left, count = [home], 0
    while left:
        folder = left.pop()
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
        except OSError as error:
            raise BackendError(
                f"folder, model: {folder} cannot be read: {error.strerror or error}."
            ) from error
        count += len(entries)
        if count > _MOST:
            raise BackendError(
                f"folder, model: {home} contains more than {_MOST:,} files. Choose a folder "
                "that contains only your meshes."
            )
        for entry in entries:
            path = Path(entry.path)
            if entry.is_dir(follow_symlinks=False):
                if len(path.relative_to(home).parts) <= _DEPTH:
                    left.append(path)
            elif path.suffix.lower() in FORMATS and entry.is_file(follow_symlinks=False):
                yield path


def _name(inside: Path) -> str:
    """Return an object's name from its mesh's path within the folder, or "" if it is unknown."""
    for part in (inside.stem, *reversed(inside.parts[:-1])):
        word = plain(_NUMBER.sub("", part))
        if word and word not in _MODEL_WORDS:
            return word
    return ""
