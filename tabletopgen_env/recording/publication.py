"""Atomic publication of datasets, which are written to a temporary path and then renamed."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from generator.errors import InputError, StorageError, TabletopError
from generator.io.bounded import parse_object, read_regular
from generator.io.files import remove_tree, write_whole

_KEY = "recording.json"
_LOCK = "lock"
_PLACE = "dataset"  # a fixed name, so that it differs from its neighbours' names
_MOST_BYTES = 1 << 20  # maximum size of the key's file, bytes


@contextmanager
def publish(target: Path) -> Iterator[Path]:
    """Yield a temporary path beside ``target``, and move its content to ``target`` on success.

    Raises:
        InputError: ``target`` was created by another program meanwhile.
        StorageError: a file cannot be written.
    """
    part = None
    try:
        with storing(target):
            target.parent.mkdir(parents=True, exist_ok=True)
            part = Path(tempfile.mkdtemp(".part", f".{target.name}-", target.parent))
            yield part / target.name
            _appear(part / target.name, target)
    finally:
        if part is not None:
            shutil.rmtree(part, ignore_errors=True)


@contextmanager
def publish_in_parts(target: Path, key: Mapping[str, Any], resume: bool) -> Iterator[Path]:
    """Yield a temporary path, as ``publish`` does, but in a folder that survives a failure.

    The next call with the same ``key`` and ``resume`` continues with the folder, ``.<name>.part``,
    and all files in it. The folder is removed once the dataset is published, or if a failed call
    left nothing in it.

    Raises:
        InputError: the folder exists and ``resume`` is false, it has a different key, or it is in
            use; or ``target`` was created by another program meanwhile.
        StorageError: a file cannot be written.
    """
    from filelock import FileLock, Timeout

    part = target.with_name(f".{target.name}.part")
    with storing(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        if part.is_symlink():
            raise InputError(f"{part} is a symbolic link. Remove the link, or choose another path.")
        if part.is_dir() and not resume:
            raise InputError(
                f"An interrupted recording to {target} exists. Continue it with --resume, or "
                f"remove {part}."
            )
        part.mkdir(exist_ok=True)
        try:
            with FileLock(part / _LOCK, timeout=0):
                _claim(part, key)
                try:
                    yield part / _PLACE
                    _appear(part / _PLACE, target)
                except BaseException:
                    _drop_if_empty(part)
                    raise
                shutil.rmtree(part, ignore_errors=True)
        except Timeout as error:
            raise InputError(
                f"Another process is recording to {target}. Wait for it, or choose another path."
            ) from error


def _claim(part: Path, key: Mapping[str, Any]) -> None:
    """Store the key in the folder, or check that an existing key is the same."""
    wanted = json.loads(json.dumps(key))
    path = part / _KEY
    if not path.is_file():
        write_whole(path, json.dumps(wanted, indent=1), "The recording", "Choose another path.")
        return
    raw = read_regular(path, "The interrupted recording", StorageError, max_bytes=_MOST_BYTES)
    found = parse_object(raw, f"The interrupted recording {str(path)!r}", StorageError)
    other = [
        f"{name} was {found.get(name)!r} and is now {wanted.get(name)!r}"
        for name in sorted({*found, *wanted})
        if found.get(name) != wanted.get(name)
    ]
    if other:
        raise InputError(
            f"The interrupted recording in {part} has different settings: {'; '.join(other)}. Use "
            "the original settings, or remove the recording."
        )


def _drop_if_empty(part: Path) -> None:
    """Remove an incomplete dataset, and its folder if nothing else is stored in it."""
    if (part / _PLACE).is_dir():
        shutil.rmtree(part / _PLACE, ignore_errors=True)
    kept = [p for p in part.iterdir() if p.name not in (_KEY, _LOCK)]
    if not any(p.is_file() or any(p.iterdir()) for p in kept):
        remove_tree(part.parent, part.name)


def _appear(made: Path, target: Path) -> None:
    if os.path.lexists(target):
        raise InputError(f"{target} was created by another process meanwhile. Choose another path.")
    made.rename(target)


@contextmanager
def storing(target: Path) -> Iterator[None]:
    """Convert OSError to StorageError for files of ``target``."""
    try:
        yield
    except OSError as error:
        if isinstance(error, TabletopError):
            raise
        raise StorageError(
            f"The dataset cannot be written to {target}: {error.strerror or error}."
        ) from error
