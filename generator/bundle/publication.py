"""Folders that are either complete or absent, even with concurrent writers, removers and readers.

A bundle is built in a staging folder next to its destination and moved there by a single rename. It
is also removed by a single rename, and deleted afterwards. Writers and removers therefore need no
lock. Each process locks its staging folder; processes that later write or remove bundles in the
same place delete the staging folders of dead processes.
"""

from __future__ import annotations

import contextlib
import errno
import fcntl
import functools
import os
import re
import tempfile
import time
from collections.abc import Callable, Collection, Generator, Mapping
from pathlib import Path
from typing import Concatenate, ParamSpec, TypeVar

from ..errors import BundleError, MissingError, StorageError
from ..io.files import remove_file, remove_tree

_STAGING = ".staging-"
_RANDOM = re.compile(re.escape(_STAGING) + r"[a-z0-9_]{8}")  # as named by ``tempfile.mkdtemp``
_MARKER = ".tabletopgen-staging"  # marks staging folders; others are not touched
_INNER = "new"  # the folder inside that is finally renamed
_STALE = 60.0  # age, in seconds, at which an unlocked staging folder is removed
_TRIES = 200  # exceeds any number of processes that use one bundle
_OCCUPIED = frozenset({errno.ENOTEMPTY, errno.EEXIST, errno.ENOTDIR})
_ABSENT = frozenset({errno.ENOENT, errno.ENOTDIR})

P = ParamSpec("P")
R = TypeVar("R")
Reader = Callable[Concatenate[str | Path, P], R]


def publish(
    folder: Path, name: str, files: Mapping[str, bytes], *, beside: Collection[str] = ()
) -> Path:
    """Publish files (paths of at most two parts) as ``folder / name``; return that path.

    An existing folder is kept if it has the same content, and possibly the files ``beside``;
    otherwise it is replaced.

    Raises:
        OSError: the folder cannot be written, or the disk is full.
    """
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / name
    if _holds(target, files, beside):
        return target
    with staging_in(folder) as staging:
        for path, content in files.items():
            place = staging / path
            place.parent.mkdir(exist_ok=True)
            place.write_bytes(content)
        staging.chmod(0o755)
        put_in_place(staging, target, lambda: _holds(target, files, beside))
    return target


def put_in_place(source: Path, target: Path, is_fine: Callable[[], bool]) -> None:
    """Rename a folder to ``target``; an existing target is kept if ``is_fine`` accepts it.

    Otherwise the target is replaced. If it is a link, the link itself is replaced, not what it
    points to.

    Raises:
        OSError: the folder cannot be written.
    """
    for _ in range(_TRIES):
        try:
            source.replace(target)
            return
        except OSError as error:
            if error.errno not in _OCCUPIED:
                raise
        if is_fine():  # another process published it first
            return
        discard(target)
    raise StorageError(errno.EBUSY, "Another process keeps replacing it")


def discard(path: Path) -> bool:
    """Remove a bundle so that no reader sees only part of it; return False if it does not exist.

    Raises:
        OSError: it cannot be removed.
    """
    with staging_in(path.parent) as grave:
        try:
            path.rename(grave / path.name)
        except FileNotFoundError:
            return False
    return True


@contextlib.contextmanager
def staging_in(folder: Path) -> Generator[Path, None, None]:
    """Yield a new folder in a staging folder of ``folder``; it is removed later unless renamed.

    Raises:
        OSError: the folder cannot be created or removed.
    """
    sweep(folder)
    staging, lock = _make_staging(folder)
    try:
        (staging / _MARKER).touch()
        inner = staging / _INNER
        inner.mkdir()
        yield inner
    finally:
        try:
            if _is_at(staging, lock):
                _remove(staging)
        finally:
            os.close(lock)


def sweep(folder: Path) -> None:
    """Remove staging folders that dead processes left in ``folder``, as far as possible."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        left = [entry.name for entry in entries if _RANDOM.fullmatch(entry.name)]
        for name in left:
            with contextlib.suppress(OSError):
                _remove_if_stale(folder, name)


def steady(read: Reader[P, R]) -> Reader[P, R]:
    """Wrap a reader of bundles so that it retries if a bundle was replaced while it was read.

    ``read`` takes the bundle's path as its first argument, and raises BundleError or OSError if
    something in it is missing. If the bundle was removed in the meantime, that becomes a
    MissingError.
    """

    @functools.wraps(read)
    def reading(path: str | Path, *args: P.args, **kwargs: P.kwargs) -> R:
        for _ in range(_TRIES):
            with _open(Path(path)) as opened:
                try:
                    return read(path, *args, **kwargs)
                except (BundleError, OSError):
                    if opened is None or _is_at(Path(path), opened):
                        raise
        raise BundleError(f"{path} was replaced repeatedly while it was read. Try again.")

    return reading


def _holds(target: Path, files: Mapping[str, bytes], beside: Collection[str]) -> bool:
    """Return whether a folder has exactly these regular files, and possibly some of ``beside``."""
    found: set[str] = set()
    try:
        for place, folders, names in os.walk(target):
            if any(Path(place, folder).is_symlink() for folder in folders):
                return False
            found |= {Path(place, name).relative_to(target).as_posix() for name in names}
        if found - set(beside) != set(files):
            return False
        return all(_content(target / path, len(files[path])) == files[path] for path in files)
    except OSError:  # the folder is being removed
        return False


def _content(path: Path, size: int) -> bytes | None:
    """Return the content of a regular file of the given size, or None for anything else."""
    descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    with os.fdopen(descriptor, "rb") as file:
        return file.read() if os.fstat(descriptor).st_size == size else None


def _make_staging(folder: Path) -> tuple[Path, int]:
    """Return a new staging folder and the file descriptor of its lock."""
    for _ in range(_TRIES):
        staging = Path(tempfile.mkdtemp(prefix=_STAGING, dir=folder))
        try:
            lock = os.open(staging, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        except FileNotFoundError:  # it was removed by a process whose clock is far ahead
            continue
        if _lock(lock) and _is_at(staging, lock):
            return staging, lock
        os.close(lock)
    raise StorageError(
        errno.EBUSY, f"Staging folders in {folder} disappear; check which program removes them"
    )


def _lock(descriptor: int) -> bool:
    """Lock a new folder; return False if a process whose clock is far ahead is removing it."""
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # file systems without locks: folders there never count as stale
        return True
    return True


def _remove_if_stale(folder: Path, name: str) -> None:
    flags = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC
    lock = os.open(folder / name, flags)
    try:
        if time.time() - os.fstat(lock).st_mtime > _STALE:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            held = os.listdir(lock)  # noqa: PTH208 - a descriptor
            if _MARKER in held or not held:  # not marked, because its process died first
                _remove(folder / name)
    finally:
        os.close(lock)


def _remove(staging: Path) -> None:
    """Remove a staging folder; its marker goes last, so that an interruption leaves it marked."""
    remove_tree(staging, _INNER)
    remove_file(staging, _MARKER)
    staging.rmdir()


@contextlib.contextmanager
def _open(path: Path) -> Generator[int | None, None, None]:
    """Yield a descriptor of an existing folder, or None if it cannot be opened.

    While it is open, no other folder can have the same inode number.
    """
    try:
        descriptor = os.open(path, os.O_PATH | os.O_DIRECTORY | os.O_CLOEXEC)
    except (OSError, ValueError) as error:
        if isinstance(error, ValueError) or error.errno in _ABSENT:
            raise MissingError(f"There is no bundle at {path}.") from error
        descriptor = None
    try:
        yield descriptor
    finally:
        if descriptor is not None:
            os.close(descriptor)


def _is_at(path: Path, descriptor: int) -> bool:
    """Return whether an open folder is still the one at ``path``."""
    try:
        return os.path.samestat(path.stat(), os.fstat(descriptor))
    except OSError:
        return False
