"""Files that are written in one go, and files and folders that are removed by a plain name.

``remove_tree`` and ``remove_file`` are the only ways in which what is named by a file's content is
removed: by the name of an entry of a folder that the caller owns, never by a path.
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
    """Write bytes, or a text as UTF-8, whole or not at all, to a file that ``mode`` lets be read.

    Its folder must be there. The message of an error names it by ``what`` ("The policy") and ends
    with ``advice`` ("Choose another folder.").

    Raises:
        StorageError: it cannot be written.
    """
    part = None
    try:
        try:
            with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
                part = Path(file.name)
                file.write(content.encode() if isinstance(content, str) else content)
            part.chmod(mode)
            part.replace(path)
        finally:  # also when it is interrupted
            if part is not None:
                part.unlink(missing_ok=True)
    except OSError as error:
        raise StorageError(
            f"{what} cannot be written to {path}: {error.strerror or error}. {advice}"
        ) from error


def write_file(content: bytes, path: Path) -> Path:
    """Write a file that may be there already, making its folder if it is missing.

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
    """Check, before any work is done for it, that files can be put into a folder.

    It and those above may be missing; ``option`` names it in the message of an error.

    Raises:
        StorageError: a file is in the way, or the folder may not be written.
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
    """Check, before any work is done for it, that a file can be written, or written anew.

    Raises:
        StorageError: a folder, a pipe or a device is there, or the file's folder cannot be one.
    """
    if os.path.lexists(path) and not path.is_file():
        raise StorageError(f"{option} {str(path)!r} cannot be written: it is not a file.")
    check_folder(path.parent, option)


def make_private(folder: Path) -> None:
    """Make a folder and those above that are missing, for their owner alone."""
    if folder.is_dir():
        return
    if not folder.parent.is_dir():
        make_private(folder.parent)
    folder.mkdir(mode=0o700, exist_ok=True)


def is_plain_name(name: object) -> bool:
    """Return whether a name, as read from a file, is that of an entry of one folder."""
    return (
        isinstance(name, str)
        and name.isprintable()
        and 0 < len(os.fsencode(name)) <= 255
        and name not in (".", "..")
        and not set(name) & {"/", "\\"}
    )


def remove_tree(parent: Path, name: str) -> None:
    """Remove a folder inside ``parent``; nothing happens if there is none.

    Raises:
        StorageError: the name is not plain, is that of no folder, or the folder cannot be removed.
    """
    with _removing(parent, name) as place:
        try:
            shutil.rmtree(place)  # refuses links, and follows none inside
        except FileNotFoundError:
            if os.path.lexists(place):  # somebody else was removing it, too
                shutil.rmtree(place, ignore_errors=True)


def remove_file(parent: Path, name: str) -> None:
    """Remove a file or a link inside ``parent``; nothing happens if there is none.

    Raises:
        StorageError: the name is not plain, is that of a folder, or the file cannot be removed.
    """
    with _removing(parent, name) as place:
        place.unlink(missing_ok=True)


@contextlib.contextmanager
def _removing(parent: Path, name: str) -> Iterator[Path]:
    if not is_plain_name(name):
        raise StorageError(
            f"{name!r} is not the plain name of an entry of {parent}; nothing was removed."
        )
    place = parent / name
    try:
        yield place
    except OSError as error:
        raise StorageError(
            f"{place} cannot be removed: {error.strerror or error}. Remove it by hand."
        ) from error
