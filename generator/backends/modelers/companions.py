"""The files that an OBJ file names: its materials and their pictures, from its own folder."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import BackendError
from .inspection import MOST_BYTES, check_pictures

_LIBRARY = re.compile(rb"^[ \t]*mtllib[ \t]+(.+?)[ \t\r]*$", re.MULTILINE)
_PICTURE = re.compile(rb"^[ \t]*map_Kd[ \t]+(.+?)[ \t\r]*$", re.MULTILINE | re.IGNORECASE)


def companions(raw: bytes, what: str, folder: Path | None) -> Mapping[str, bytes]:
    """Return the material files of an OBJ, and the pictures they show, by the names it uses.

    Args:
        raw: the OBJ file's content.
        what: how messages call it.
        folder: where it lies; None: nowhere, so that it may name no files.

    Raises:
        BackendError: a file is missing, outside the folder, too large, or no picture.
    """
    found: dict[str, bytes] = {}
    shown: dict[str, bytes] = {}
    for library in _names(_LIBRARY, raw):
        found[library] = _read(library, what, folder)
        for picture in _names(_PICTURE, found[library]):
            found[picture] = _read(picture, what, folder)
            shown[picture] = found[picture]
    reason = check_pictures(shown.values())
    if reason:
        raise BackendError(f"{what} {reason} It names {', '.join(shown)}.")
    return found


def _names(pattern: re.Pattern[bytes], raw: bytes) -> Iterator[str]:
    for name in dict.fromkeys(pattern.findall(raw)):
        yield name.decode("utf-8", "replace").strip("'\"")


def _read(name: str, what: str, folder: Path | None) -> bytes:
    if folder is None:
        raise BackendError(f"{what} names a file outside itself, {name!r}. Use GLB with all in it.")
    home = folder.resolve()
    if "://" in name or not (home / name).resolve().is_relative_to(home):
        raise BackendError(
            f"{what} names a file outside its folder, {name!r}. Put it beside the OBJ file."
        )
    path = home / name
    if not path.is_file():
        raise BackendError(f"{what} names {name!r}, which is not beside it. Put it there.")
    if path.stat().st_size > MOST_BYTES:
        raise BackendError(f"{what}: {name!r} takes more than {MOST_BYTES // 2**20} MiB.")
    return path.read_bytes()
