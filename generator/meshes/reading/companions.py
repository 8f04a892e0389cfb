"""The files that an OBJ file names: its materials and their pictures, from its own folder."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import BackendError
from ...io.reading import read_regular
from .bounds import MOST_BYTES, MOST_LIBRARY, MOST_MATERIALS
from .inspection import check_lines, check_pictures

_LIBRARY = re.compile(rb"^[ \t]*+mtllib[ \t]++([^\n]+)$", re.MULTILINE)
_PICTURE = re.compile(rb"^[ \t]*+map_Kd[ \t]++([^\n]+)$", re.MULTILINE | re.IGNORECASE)
_MOST_LIBRARIES = 10


def companions(raw: bytes, what: str, folder: Path | None) -> Mapping[str, bytes]:
    """Return the material files of an OBJ, and the pictures they show, by the names it uses.

    ``folder`` is where it lies; an OBJ that lies nowhere (None) may name no files.

    Raises:
        BackendError: a file is missing, outside the folder, too large, or no picture.
    """
    found: dict[str, bytes] = {}
    shown: dict[str, bytes] = {}  # the pictures of these
    for library in _names(_LIBRARY, raw, what, _MOST_LIBRARIES):
        text = _read(library, what, folder, MOST_LIBRARY)
        check_lines(text, f"{what}: {library[:80]!r}")
        found[library] = text.decode("utf-8", "replace").encode()
        if text.count(b"newmtl") > MOST_MATERIALS:
            raise BackendError(f"{what} has more than {MOST_MATERIALS} materials.")
        for picture in _names(_PICTURE, found[library], what, MOST_MATERIALS):
            found[picture] = shown[picture] = _read(picture, what, folder, MOST_BYTES)
    if reason := check_pictures(shown.values()):
        raise BackendError(f"{what} {reason} It names {', '.join(shown):.300}.")
    return found


def _names(pattern: re.Pattern[bytes], raw: bytes, what: str, maximum: int) -> Iterator[str]:
    names = dict.fromkeys(name.strip(b" \t\r") for name in pattern.findall(raw))
    if len(names) > maximum:
        raise BackendError(f"{what} names {len(names)} files; at most {maximum} are read.")
    for name in filter(None, names):
        yield name.decode("utf-8", "replace").strip("'\"")


def _read(name: str, what: str, folder: Path | None, maximum: int) -> bytes:
    if folder is None:
        raise BackendError(f"{what} names a file outside itself, {name!r}. Use GLB with all in it.")
    home = folder.resolve()
    try:
        inside = "://" not in name and (home / name).resolve().is_relative_to(home)
        there = (home / name).is_file()
    except (OSError, ValueError, RuntimeError):  # no name of a file, or a link to itself
        inside = there = False
    if not inside:
        raise BackendError(
            f"{what} names a file outside its folder, {name[:80]!r}. Put it beside the OBJ file."
        )
    if not there:
        raise BackendError(f"{what} names {name[:80]!r}, which is not beside it. Put it there.")
    return read_regular(home / name, f"{what}:", BackendError, max_bytes=maximum)
