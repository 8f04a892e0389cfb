"""Collection of the files of a foreign MJCF model, within limits, before MuJoCo reads any of them.

Includes are expanded in place; files are renamed and passed to MuJoCo in memory, so that it opens
none itself. Elements that could run code, create files or grow without bounds are rejected.
"""

from __future__ import annotations

import os
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from ..errors import InputError
from .foreign import read_source
from .mjcf_budget import check_assets, check_copies, drop_unused, merge_textures

MOST_XML, MOST_FILE, MOST_TOGETHER = 32 * 2**20, 128 * 2**20, 384 * 2**20
"""Maximum size in bytes of an XML file, of a mesh or picture, and of all files together."""

MOST_ELEMENTS, MOST_DEPTH, MOST_INCLUDES = 200_000, 100, 200
"""Maximum number of elements in all files, of nesting levels, and of files."""

_REFUSED = {
    "extension": "plugins run code", "plugin": "plugins run code",
    "model": "attached models are not supported", "attach": "attached models are not supported",
    "flexcomp": "soft bodies are not supported", "flex": "soft bodies are not supported",
    "composite": "soft bodies are not supported", "deformable": "soft bodies are not supported",
    "skin": "skins are not supported", "hfield": "height fields are not supported",
}  # fmt: skip
_FILES = {"mesh": "meshdir", "texture": "texturedir"}
SIDES = ("fileright", "fileleft", "fileup", "filedown", "filefront", "fileback")
"""Attributes that refer to the six files of a cube texture."""
_SUFFIXES = {"mesh": (".obj", ".stl", ".msh"), "texture": (".png",)}


@dataclass(frozen=True)
class GatheredModel:
    """An MJCF model as a single XML string, with the content of its files by name."""

    xml: str
    files: dict[str, bytes]


def gather(path: Path, folder: Path | None = None) -> GatheredModel:
    """Read an MJCF file and the files that it refers to inside ``folder`` (by default, its own).

    Raises:
        InputError: the file is not a valid MJCF, refers to files outside the folder, is too large,
            or has rejected elements.
    """
    home = (folder or path.parent).resolve()
    place = path.parent.resolve() / path.name
    if not place.is_relative_to(home):
        raise InputError(f"{path} is not inside {home}. Pass a folder that contains the file.")
    inside = PurePosixPath(place.relative_to(home).as_posix())
    reader = _Reader(home, inside.parent)
    root = reader.parse(inside, 0)
    if root.tag != "mujoco":
        raise InputError(f"{path} is not an MJCF: its root is {root.tag[:40]!r}, not 'mujoco'.")
    reader.include(root, inside.parent, 1)
    for element in root.iter():
        reader.check(element)
    drop_unused(root)
    check_copies(root, MOST_ELEMENTS)
    reader.hand_over(root)
    merge_textures(root)
    check_assets(root, reader.files, SIDES)
    return GatheredModel(ET.tostring(root, encoding="unicode"), reader.files)


@dataclass
class _Reader:
    """Reads files inside ``folder``; ``base`` is the model's folder; MuJoCo receives ``files``."""

    folder: Path
    base: PurePosixPath
    files: dict[str, bytes] = field(default_factory=dict)
    _included: set[PurePosixPath] = field(default_factory=set)
    _names: dict[PurePosixPath, str] = field(default_factory=dict)
    _total: int = 0
    _elements: int = 0

    def parse(self, path: PurePosixPath, above: int) -> ET.Element:
        """Parse an XML file whose root is at nesting depth ``above``; return the root."""
        self._included.add(path)
        if len(self._included) > MOST_INCLUDES:
            raise InputError(f"The model includes more than {MOST_INCLUDES} files.")
        left = MOST_ELEMENTS - self._elements
        root = _parse(self._read(path, MOST_XML), str(path), above, left)
        self._elements += sum(1 for _ in root.iter())
        return root

    def include(self, parent: ET.Element, where: PurePosixPath, depth: int) -> None:
        """Replace the ``include`` elements below ``parent`` with the content of their files.

        ``where`` is the folder of its file, ``depth`` its nesting depth.
        """
        for at, child in reversed([*enumerate(parent)]):
            if child.tag != "include":
                self.include(child, where, depth + 1)
                continue
            path = self._find(child.get("file", ""), self.base, where)
            if path in self._included:
                raise InputError(f"The model includes {str(path)!r} twice, or within itself.")
            root = self.parse(path, depth - 1)  # its children become children of ``parent``
            self.include(root, path.parent, depth)
            parent[at : at + 1] = [*root]

    def check(self, element: ET.Element) -> None:
        """Raise an error if an element is not supported."""
        tag = element.tag
        if tag in _REFUSED:
            raise InputError(f"The model has a <{tag}>, which is not allowed: {_REFUSED[tag]}.")
        named = element.get("file"), *(element.get(side) for side in SIDES)
        if tag not in _FILES and any(named):
            raise InputError(
                f"The model refers to a file in <{tag[:40]}>; only meshes and textures may refer "
                "to files."
            )

    def hand_over(self, root: ET.Element) -> None:
        """Read each mesh and texture file, and change its name to the one that MuJoCo receives."""
        folders, strip = _folders(root)
        for compiler in root.iter("compiler"):
            for name in ("meshdir", "texturedir", "assetdir", "strippath"):
                compiler.attrib.pop(name, None)
        for element in root.iter():
            if element.tag not in _FILES:
                continue
            element.attrib.pop("content_type", None)
            for name in ("file", *SIDES):
                if given := element.get(name):
                    if "name" not in element.attrib and name == "file":
                        element.set("name", PurePosixPath(given.replace("\\", "/")).stem)
                    path = PurePosixPath(given.replace("\\", "/"))
                    path = PurePosixPath(path.name) if strip else path
                    inside = self._find(str(path), self.base / folders[element.tag])
                    element.set(name, self._hand(inside, element.tag))

    def _hand(self, path: PurePosixPath, tag: str) -> str:
        suffix = path.suffix.lower()
        if suffix not in _SUFFIXES[tag]:
            raise InputError(
                f"The {tag} {str(path)!r} is not supported; use {', '.join(_SUFFIXES[tag])} files."
            )
        if path not in self._names:
            self._names[path] = f"file_{len(self._names)}{suffix}"
            self.files[self._names[path]] = self._read(path, MOST_FILE)
        return self._names[path]

    def _find(self, given: str, *places: PurePosixPath) -> PurePosixPath:
        """Return a referenced file's path in the first folder that has it, or else the last one.

        For an include, the folders are the model's and the referring file's, in MuJoCo's order.
        """
        path = PurePosixPath(given.replace("\\", "/"))
        if path.is_absolute() or not given or ":" in given:
            raise InputError(
                f"The model refers to the file {given[:200]!r}; paths must be relative and must "
                "not leave the model's folder."
            )
        found = [_plain(place / path) for place in places]
        for inside in found:
            if inside is not None and os.path.lexists(self.folder / inside):
                return inside
        if found[-1] is None:
            raise InputError(
                f"The model refers to the file {given[:200]!r}, which is outside its folder. Pass "
                "a folder that contains the model and the file (--root)."
            )
        return found[-1]

    def _read(self, path: PurePosixPath, limit: int) -> bytes:
        raw = read_source(self.folder, str(path), limit)
        self._total += len(raw)
        if self._total > MOST_TOGETHER:
            raise InputError(f"The model's files have more than {MOST_TOGETHER} bytes in total.")
        return raw


def _plain(path: PurePosixPath) -> PurePosixPath | None:
    """Return a path with ``..`` resolved, or None if it leaves the folder."""
    parts: list[str] = []
    for part in path.parts:
        if part == "..":
            if not parts:
                return None
            parts.pop()
        else:
            parts.append(part)
    return PurePosixPath(*parts)


def _folders(root: ET.Element) -> tuple[dict[str, str], bool]:
    """Return the folders of meshes and textures, and whether folders in file names are ignored."""
    folders, strip = {"mesh": "", "texture": ""}, False
    for compiler in root.iter("compiler"):
        both = compiler.get("assetdir")
        for tag, name in _FILES.items():
            folders[tag] = compiler.get(name) or both or folders[tag]
        strip = compiler.get("strippath", "true" if strip else "false") == "true"
    return {tag: folder.replace("\\", "/") for tag, folder in folders.items()}, strip


def _parse(raw: bytes, what: str, above: int, most: int) -> ET.Element:
    """Parse XML of at most ``most`` elements, rejecting entity declarations; return its root.

    ``above`` is the nesting depth of its root, which counts towards the maximum depth.
    """
    if b"<!DOCTYPE" in raw or b"<!ENTITY" in raw or b"\0" in raw:
        raise InputError(f"{what} must be text, without a document type or entity declarations.")
    head = raw[:200].lower()
    if b"encoding" in head.split(b"?>")[0] and not any(
        name in head for name in (b"utf-8", b"utf8", b"ascii")
    ):
        raise InputError(f"{what} is not UTF-8. Save it as UTF-8.")
    parser = ET.XMLPullParser(("start", "end"))
    depth, count = above, 0
    root: ET.Element | None = None
    try:
        for piece in _pieces(raw):
            parser.feed(piece)
            for found in parser.read_events():
                event, element = found[0], found[-1]
                if event == "end":
                    depth -= 1
                    continue
                assert isinstance(element, ET.Element)
                root = element if root is None else root
                depth, count = depth + 1, count + 1
                if depth > MOST_DEPTH or count > most:
                    raise InputError(
                        f"{what} is nested too deeply, or the model has too many elements: the "
                        f"limits are {MOST_DEPTH} levels, and {MOST_ELEMENTS} elements in all "
                        "files."
                    )
        parser.close()
    except (ET.ParseError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{what} is not valid XML ({error}).") from error
    assert root is not None
    return root


def _pieces(raw: bytes) -> Iterator[bytes]:
    for first in range(0, len(raw), 2**16):
        yield raw[first : first + 2**16]
