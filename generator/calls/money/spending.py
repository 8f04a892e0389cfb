"""What the calls of one scene cost, on disk, so that the next run of it knows.

A file of JSON lines. One is written before a call is sent, with the most that it can cost, and one
of the same ``call`` when it has ended, with what it did cost; the last counts. So a run that is
killed leaves what it has spent, and what it may have. ``key`` is that of the answer in the store.
"""

from __future__ import annotations

import dataclasses
import json
import os
import secrets
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, get_args

from filelock import FileLock

from ...errors import InputError, StorageError
from ...io.files import make_private
from ...io.reading import (
    is_count,
    is_number,
    parse_object,
    read_regular,
)
from ..http.redaction import redacted
from .entries import Entry, Outcome

FOLDER = "spending"
"""Where a call store's folder holds these files, one for each scene."""

_MOST_BYTES = 256 * 2**20  # of the file
_MOST_LINE = 2**20  # bytes
_PATIENCE = 30.0  # seconds: nobody holds the file for long


class Spending:
    """The file of one scene; threads and processes may write to it at once.

    A run knows of those that began before it, but not what others spend from then on.
    """

    def __init__(self, path: str | Path, currency: str) -> None:
        """Use the file at ``path``, which is made, for its owner alone, with the first call."""
        self.path = Path(path)
        self.currency = currency

    @classmethod
    def beside(cls, answers: str | Path, scene: str, currency: str = "USD") -> Spending:
        """Return the file of a scene in the folder of a call store; ``scene`` is file-safe."""
        return cls(Path(answers) / FOLDER / f"{scene}.jsonl", currency)

    def earlier(self) -> tuple[dict[str, Any], ...]:
        """Return what came of the calls of earlier runs, in the order they were sent.

        Raises:
            StorageError: there is a file, and it cannot be read. It is never taken for nothing.
            InputError: what was spent was in another currency.
        """
        try:
            raw = read_regular(self.path, "The file", StorageError, max_bytes=_MOST_BYTES)
        except StorageError as error:
            if isinstance(error.__cause__, FileNotFoundError | NotADirectoryError):
                return ()
            raise self._refused("read", error) from error
        calls: dict[str, dict[str, Any]] = {}
        for line in filter(None, raw.split(b"\n")):
            told = _told(line)
            if told is None:
                continue
            calls[told["call"]] = told
            if told["currency"] != self.currency:
                raise InputError(
                    f"{self.path} has what calls cost in {told['currency']!r:.80}, and "
                    f"the price table is in {self.currency}. Use one in that."
                )
        return tuple(calls.values())

    def write(self, call: str, key: str, entry: Entry) -> None:
        """Write down what a call costs; ``key`` is its question's.

        Raises:
            StorageError: the disk refuses.
        """
        told = {
            "call": call, "key": key, "at": round(time.time(), 3), "currency": self.currency,
            **dataclasses.asdict(entry),
        }  # fmt: skip
        line = redacted(json.dumps(told)).encode() + b"\n"
        try:
            make_private(self.path.parent)
            lock = FileLock(self.path.with_suffix(".lock"), timeout=_PATIENCE, mode=0o600)
            with lock, os.fdopen(_opened(self.path), "ab+") as file:
                if file.tell():
                    file.seek(-1, os.SEEK_END)
                    line = line if file.read(1) == b"\n" else b"\n" + line
                file.write(line)
                file.flush()
                os.fsync(file.fileno())
        except OSError as error:
            raise self._refused("written", error) from error

    def _refused(self, done: str, error: OSError) -> StorageError:
        return StorageError(
            f"What this scene's calls cost cannot be {done} ({self.path}: "
            f"{error.strerror or error}). Free space there, or name another folder of answers."
        )


def _told(line: bytes) -> dict[str, Any] | None:
    """Return what a line says; None for one that a process died at.

    What else is of the wrong kind is left out, so that the money counts.
    """
    try:
        told = parse_object(line, "The line", StorageError, max_bytes=_MOST_LINE)
    except StorageError:
        return None
    fine = {name: value for name, value in told.items() if name in _FITS and _FITS[name](value)}
    return fine if {"call", "currency", "server", "question", "money"} <= set(fine) else None


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


_FITS: Mapping[str, Callable[[Any], bool]] = MappingProxyType({
    **dict.fromkeys(("call", "key", "currency", "server", "question", "model", "at"), _is_text),
    **dict.fromkeys(("tokens_in", "tokens_out", "images"), is_count),
    "seconds": is_number,
    "money": lambda value: value is None or is_number(value),
    "outcome": lambda value: value in get_args(Outcome),
})  # fmt: skip
"""What the values of a line have to be."""


def new_call() -> str:
    """Return what tells a call from all others."""
    return secrets.token_hex(8)


def _opened(path: Path) -> int:
    """Open a file to append to it, made for its owner alone; links and pipes are not followed."""
    flags = os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
    return os.open(path, flags, 0o600)
