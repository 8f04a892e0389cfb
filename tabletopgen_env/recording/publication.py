"""Where a dataset is made, and how it appears: whole, by one rename."""

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
_PLACE = "dataset"  # whatever the target is called: no name of what lies beside it
_MOST_BYTES = 1 << 20  # of the key


@contextmanager
def publish(target: Path) -> Iterator[Path]:
    """Give a place beside ``target``, and move what was made there to it if nothing goes wrong.

    Raises:
        InputError: something has come to be at ``target`` meanwhile.
        StorageError: the disk refused.
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
    """Give a place beside ``target`` as ``publish`` does, in a folder that outlives a failure.

    The folder, ``.<name>.part``, is found again by the next call with the same ``key`` if it is to
    ``resume``; what its owner keeps beside the place is still there. It goes once the dataset is
    published, and where the failed call left nothing in it.

    Raises:
        InputError: such a folder is there but is not to be resumed, is of another key, or is in
            use; something has come to be at ``target`` meanwhile.
        StorageError: the disk refused.
    """
    from filelock import FileLock, Timeout

    part = target.with_name(f".{target.name}.part")
    with storing(target):
        target.parent.mkdir(parents=True, exist_ok=True)
        if part.is_symlink():
            raise InputError(f"{part} leads elsewhere. Remove it, or choose another place.")
        if part.is_dir() and not resume:
            raise InputError(
                f"An interrupted recording to {target} is there. Continue it by --resume, or "
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
                f"Another process is recording to {target}. Wait for it, or choose another place."
            ) from error


def _claim(part: Path, key: Mapping[str, Any]) -> None:
    """Write down whose the folder is, or check that it is of the same key."""
    wanted = json.loads(json.dumps(key))
    path = part / _KEY
    if not path.is_file():
        write_whole(path, json.dumps(wanted, indent=1), "The recording", "Choose another place.")
        return
    raw = read_regular(path, "The interrupted recording", StorageError, max_bytes=_MOST_BYTES)
    found = parse_object(raw, f"The interrupted recording {str(path)!r}", StorageError)
    other = [
        f"{name} was {found.get(name)!r} and is {wanted.get(name)!r}"
        for name in sorted({*found, *wanted})
        if found.get(name) != wanted.get(name)
    ]
    if other:
        raise InputError(
            f"The interrupted recording in {part} is another one: {'; '.join(other)}. Give the "
            "same settings, or remove it."
        )


def _drop_if_empty(part: Path) -> None:
    """Remove what is half done, and the folder if nothing is kept in it."""
    if (part / _PLACE).is_dir():
        shutil.rmtree(part / _PLACE, ignore_errors=True)
    kept = [p for p in part.iterdir() if p.name not in (_KEY, _LOCK)]
    if not any(p.is_file() or any(p.iterdir()) for p in kept):
        remove_tree(part.parent, part.name)


def _appear(made: Path, target: Path) -> None:
    if os.path.lexists(target):
        raise InputError(f"{target} has come to be there meanwhile. Choose another place.")
    made.rename(target)


@contextmanager
def storing(target: Path) -> Iterator[None]:
    """Raise StorageError where the disk refuses what is written for ``target``."""
    try:
        yield
    except OSError as error:
        if isinstance(error, TabletopError):
            raise
        raise StorageError(
            f"The dataset cannot be written to {target}: {error.strerror or error}."
        ) from error
