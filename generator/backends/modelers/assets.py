"""What a folder of meshes holds, by what the files model: flat, or a folder for each thing."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import BackendError

FORMATS = (".glb", ".obj")
"""Files that are read; the first is taken where a thing has both."""

_DEPTH = 4  # folders within each other
_MOST = 20_000  # files and folders that are looked at

_MODEL_WORDS = frozenset(
    ["textured", "nontextured", "model", "mesh", "base", "visual", "object", "scene", "poisson",
     "google_16k", "google_64k", "google_512k", "tsdf", "meshes", "visuals", "mesh_simplified"]
)  # fmt: skip
"""Names of files and folders that say how a mesh was made, and nothing of what it shows."""

_WORSE = ("nontextured", "collision", "poisson", "simplified")
"""Words in a path of a mesh that is taken only if there is no other."""

_NUMBER = re.compile(r"^\d+[-_ ]+(?=\D)")  # "025_mug"


def plain(word: str) -> str:
    """Return a word as things are called: lower case, underscores."""
    return "_".join(word.lower().replace("-", " ").replace("_", " ").split())


def find_assets(home: Path) -> Mapping[str, Path]:
    """Return the meshes of a folder by what they model: "mug" of "025_mug/textured.obj".

    A file is called after itself, or after the nearest folder around it where its own name says
    nothing ("textured.obj"); numbers in front do not count. Links are not followed.

    Raises:
        BackendError: the folder holds too much to look at, or cannot be read.
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
    """Yield the meshes of a folder, sorted, within bounds."""
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
                f"folder, model: {home} holds more than {_MOST:,} files. Name a folder with your "
                "meshes alone."
            )
        for entry in entries:
            path = Path(entry.path)
            if entry.is_dir(follow_symlinks=False):
                if len(path.relative_to(home).parts) <= _DEPTH:
                    left.append(path)
            elif path.suffix.lower() in FORMATS and entry.is_file(follow_symlinks=False):
                yield path


def _name(inside: Path) -> str:
    """Return what a mesh models by its path within the folder; "" if nothing tells it."""
    for part in (inside.stem, *reversed(inside.parts[:-1])):
        word = plain(_NUMBER.sub("", part))
        if word and word not in _MODEL_WORDS:
            return word
    return ""
