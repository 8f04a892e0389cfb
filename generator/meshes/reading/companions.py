"""The materials and pictures to which an OBJ file refers, read from the file's own folder."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ...errors import BackendError
from ...io.bounded import read_regular
from .bounds import MOST_BYTES, MOST_LIBRARY, MOST_MATERIALS
from .inspection import check_lines, check_pictures

_LIBRARY = re.compile(rb"^[ \t]*+mtllib[ \t]++([^\n]+)$", re.MULTILINE)
_PICTURE = re.compile(rb"^[ \t]*+map_Kd[ \t]++([^\n]+)$", re.MULTILINE | re.IGNORECASE)
_MOST_LIBRARIES = 10


def companions(
    raw: bytes, what: str, folder: Path | None, max_bytes: int = MOST_BYTES
) -> Mapping[str, bytes]:
    """Return an OBJ's material libraries and their pictures, keyed by the names in the file.

    ``folder`` is the folder of the OBJ; if it is None, the OBJ must not refer to files. A file with
    several names ("a.png", "./a.png") is read once; ``max_bytes`` limits all files together.

    Raises:
        BackendError: a file is missing, outside the folder, too large, or not a picture.
    """
    beside = _Beside(what, folder, max_bytes)
    found: dict[str, bytes] = {}
    shown: dict[str, bytes] = {}  # these maps are pictures
    for library in _names(_LIBRARY, raw, what, _MOST_LIBRARIES):
        text = beside.library(library)
        found[library] = text
        if text.count(b"newmtl") > MOST_MATERIALS:
            raise BackendError(f"{what} has more than {MOST_MATERIALS} materials.")
        for picture in _names(_PICTURE, text, what, MOST_MATERIALS):
            found[picture] = shown[picture] = beside.read(picture, MOST_BYTES)
    pictures = {id(content): content for content in shown.values()}
    if reason := check_pictures(pictures.values()):
        raise BackendError(f"{what} {reason} It refers to {', '.join(shown):.300}.")
    return found


def total_bytes(beside: Mapping[str, bytes]) -> int:
    """Return the total size in bytes of an OBJ's files, counting a file with several names once."""
    return sum({id(content): len(content) for content in beside.values()}.values())


def _names(pattern: re.Pattern[bytes], raw: bytes, what: str, maximum: int) -> Iterator[str]:
    names = dict.fromkeys(name.strip(b" \t\r") for name in pattern.findall(raw))
    if len(names) > maximum:
        raise BackendError(f"{what} refers to {len(names)} files; at most {maximum} are allowed.")
    for name in filter(None, names):
        yield name.decode("utf-8", "replace").strip("'\"")


@dataclass
class _Beside:
    """Reads files from an OBJ file's folder, each once and at most ``left`` bytes in total."""

    what: str
    folder: Path | None
    left: int
    _files: dict[Path, bytes] = field(default_factory=dict[Path, bytes])
    _libraries: dict[int, bytes] = field(default_factory=dict[int, bytes])

    def library(self, name: str) -> bytes:
        """Return a material library in UTF-8."""
        raw = self.read(name, MOST_LIBRARY)
        if id(raw) not in self._libraries:
            check_lines(raw, f"{self.what}: {name[:80]!r}")
            self._libraries[id(raw)] = raw.decode("utf-8", "replace").encode()
        return self._libraries[id(raw)]

    def read(self, name: str, maximum: int) -> bytes:
        """Return the content of a file."""
        path = self._find(name)
        if path not in self._files:
            most = min(maximum, self.left)
            self._files[path] = read_regular(path, f"{self.what}:", BackendError, max_bytes=most)
            self.left -= len(self._files[path])
        return self._files[path]

    def _find(self, name: str) -> Path:
        if self.folder is None:
            raise BackendError(
                f"{self.what} refers to an external file, {name!r}. Use a GLB that contains "
                "everything."
            )
        home = self.folder.resolve()
        try:
            path = (home / name).resolve()
            inside = "://" not in name and path.is_relative_to(home)
            there = path.is_file()
        except (OSError, ValueError, RuntimeError):  # invalid file name, or a circular link
            path, inside, there = home, False, False
        if not inside:
            raise BackendError(
                f"{self.what} refers to a file outside its folder, {name[:80]!r}. Move the file "
                "next to the OBJ file."
            )
        if not there:
            raise BackendError(
                f"{self.what} refers to {name[:80]!r}, which is not in its folder. Add the file to "
                "that folder."
            )
        return path
