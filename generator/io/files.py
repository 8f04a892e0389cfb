"""Atomic writes, and removal of files and folders by plain name.

``remove_tree`` and ``remove_file`` are the only functions that remove paths read from a file. They
accept the name of an entry of a folder that the caller owns, never a path.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from ..errors import StorageError


def write_whole(
    path: Path, content: str | bytes, what: str, advice: str, mode: int = 0o644
) -> None:
    """Write bytes, or a string as UTF-8, to a file atomically, with permissions ``mode``.

    The folder must exist. ``what`` ("The policy") is the start of error messages and ``advice``
    ("Choose another folder.") the end.

    Raises:
        StorageError: the file cannot be written.
    """
    part = None
    try:
        try:
            with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
                part = Path(file.name)
                file.write(content.encode() if isinstance(content, str) else content)
            part.chmod(mode)
            part.replace(path)
        finally:  # also after an interrupt
            if part is not None:
                part.unlink(missing_ok=True)
    except OSError as error:
        raise StorageError(
            f"{what} cannot be written to {path}: {error.strerror or error}. {advice}"
        ) from error


def write_file(content: bytes, path: Path) -> Path:
    """Write a file, replacing an existing one; create its folder if necessary.

    Raises:
        StorageError: the file cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        raise StorageError(
            f"{path} cannot be written: {error.strerror or error}. Choose another folder."
        ) from error
    return path


def check_folder(folder: Path, option: str = "--out") -> None:
    """Check, before any work starts, that a folder is writable or can be created.

    The folder and its parents may be missing. ``option`` names the folder in error messages.

    Raises:
        StorageError: a file is in the way, or the folder is not writable.
    """
    there = folder
    while not os.path.lexists(there) and there != there.parent:
        there = there.parent
    if not there.is_dir():
        raise StorageError(
            f"{option} {str(folder)!r} cannot be written: {str(there)!r} is not a folder. Choose "
            "another folder."
        )
    if not os.access(there, os.W_OK | os.X_OK):
        raise StorageError(f"{option} {str(folder)!r} cannot be written. Choose another folder.")


def check_target(path: Path, option: str = "--out") -> None:
    """Check, before any work starts, that a file can be written or replaced.

    Raises:
        StorageError: the path is a folder, a pipe or a device, or its parent cannot be a folder.
    """
    if os.path.lexists(path) and not path.is_file():
        raise StorageError(f"{option} {str(path)!r} cannot be written: it is not a regular file.")
    check_folder(path.parent, option)


def make_private(folder: Path) -> None:
    """Create a folder and its missing parents, accessible only to their owner."""
    if folder.is_dir():
        return
    if not folder.parent.is_dir():
        make_private(folder.parent)
    folder.mkdir(mode=0o700, exist_ok=True)


def is_plain_name(name: object) -> bool:
    """Return whether a name read from a file is a plain entry name and not a path."""
    return (
        isinstance(name, str)
        and name.isprintable()
        and 0 < len(os.fsencode(name)) <= 255
        and name not in (".", "..")
        and not set(name) & {"/", "\\"}
    )


def remove_tree(parent: Path, name: str) -> None:
    """Remove a folder inside ``parent``; do nothing if it does not exist.

    Raises:
        StorageError: the name is not plain, is not a folder's, or the folder cannot be removed.
    """
    with _removing(parent, name) as place:
        try:
            shutil.rmtree(place)  # refuses links, and follows none inside the folder
        except FileNotFoundError:
            if os.path.lexists(place):  # another process may have removed it meanwhile
                shutil.rmtree(place, ignore_errors=True)


def remove_file(parent: Path, name: str) -> None:
    """Remove a file or a link inside ``parent``; do nothing if it does not exist.

    Raises:
        StorageError: the name is not plain, is a folder's, or the file cannot be removed.
    """
    with _removing(parent, name) as place:
        place.unlink(missing_ok=True)


@contextlib.contextmanager
def _removing(parent: Path, name: str) -> Iterator[Path]:
    if not is_plain_name(name):
        raise StorageError(
            f"{name!r} must be the name of an entry of {parent}, not a path; nothing was removed."
        )
    place = parent / name
    try:
        yield place
    except OSError as error:
        raise StorageError(
            f"{place} cannot be removed: {error.strerror or error}. Remove it manually."
        ) from error
