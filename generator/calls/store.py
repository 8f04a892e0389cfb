"""Paid answers on disk, keyed by the content of their question.

An answer is published or absent: it is written beside and renamed, and carries a checksum of all it
holds, its key included. Of a question nothing but its key is kept; of an answer status, content
type and body.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import stat
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from filelock import FileLock, Timeout

from ..errors import BackendError, StorageError, require_number
from ..io.bounded import parse_object, read_regular
from ..io.files import make_private, remove_file

MOST_ANSWER_BYTES = 257 * 2**20
"""Size of one kept answer: more than the largest that a server is read for."""

_MOST_BYTES = 4 * 2**30  # of a store unless its owner says otherwise
_MAGIC = b"tabletopgen call 1"
_KEY = re.compile(r"[0-9a-f]{64}")
_PARTIAL = ".partial-"
_STALE = 3600.0  # seconds: an older unfinished file was left by a process that is gone
_MOST_HEAD = 2**16  # bytes of what is said of an answer
_SHARE = 32  # of its size is what a store is filled by between two looks at it
_POLL = 0.05  # seconds between two looks at a lock


@dataclass(frozen=True)
class StoredAnswer:
    """What a server answered: all that is kept of it."""

    status: int
    content_type: str
    body: bytes


class CallStore:
    """A folder of answers that several threads and processes may use at once."""

    def __init__(self, folder: str | Path, most_bytes: int = _MOST_BYTES) -> None:
        """Use ``folder``, which is made, for its owner alone, when the first answer is kept.

        ``most_bytes`` is what answers may take up; those not asked for the longest go first. Where
        several write, each may be off by a 32nd of it.

        Raises:
            InputError: ``most_bytes`` is no positive whole number.
        """
        require_number("CallStore needs most_bytes", most_bytes, minimum=1, integer=True)
        self.folder = Path(folder)
        self.most_bytes = most_bytes
        self._most_answer = min(most_bytes, MOST_ANSWER_BYTES)
        self._broken = False
        self._lock_room = threading.Lock()
        self._room = 0  # bytes that may be written before the folder is looked at again

    def get(self, key: str) -> StoredAnswer | None:
        """Return the answer to a question, or None. A damaged one is dropped."""
        path = self._path(key)
        if not os.path.lexists(path):
            return None
        answer = None
        with contextlib.suppress(StorageError):
            if not path.is_symlink():
                raw = read_regular(path, "An answer", StorageError, max_bytes=self._most_answer)
                answer = _decode(key, raw)
        with contextlib.suppress(OSError):
            if answer is None:
                remove_file(path.parent, key)
            else:
                os.utime(path, follow_symlinks=False)  # the order in which answers go
        return answer

    def put(self, key: str, answer: StoredAnswer) -> None:
        """Keep an answer, while ``holding`` the question; who reads sees it whole or not at all.

        Raises:
            StorageError: it is larger than the store, or than any answer. Or the disk refuses: that
                is said once, and from then on nothing is kept.
        """
        if self._broken:
            return
        path, raw = self._path(key), _encode(key, answer)
        if len(raw) > self._most_answer:
            raise StorageError(
                f"An answer of {len(raw)} bytes does not fit the call store {self.folder}, "
                f"which holds {self.most_bytes}, and {MOST_ANSWER_BYTES} an answer. Raise its "
                "most_bytes, or ask for less."
            )
        try:
            self._write(path, raw)
            self._make_room(path, len(raw))
        except OSError as error:
            self._broken = True
            raise StorageError(
                f"The call store {self.folder} cannot be written ({error.strerror or error}): "
                "answers of this run are used, but not kept. Free space or name another folder."
            ) from error

    def forget(self, key: str) -> None:
        """Drop an answer, if there is one."""
        with contextlib.suppress(OSError):
            remove_file(self._path(key).parent, key)

    @contextlib.contextmanager
    def holding(self, key: str, check: Callable[[], None] = lambda: None) -> Iterator[None]:
        """Hold a question, so that nobody else, in any process, asks it meanwhile.

        The system lets go of it when the process dies; what that left half written is removed.
        ``check`` is called now and then while another holds it, and may raise. Where no lock can be
        had, nothing is held.
        """
        path = self.folder / "locks" / f"{key[:3]}.lock"  # a few keys of 4096 share one
        lock = FileLock(path, mode=0o600)
        with contextlib.ExitStack() as held:
            try:
                make_private(path.parent)
                lockable = True
            except OSError:
                lockable = False
            while lockable:
                try:
                    held.enter_context(lock.acquire(timeout=_POLL, poll_interval=_POLL / 2))
                    self._clear(key)
                    break
                except Timeout:
                    pass
                except OSError:
                    break
                check()  # whatever it raises ends the wait
            yield

    def __len__(self) -> int:
        """Return how many answers are kept."""
        return len(self._list_kept())

    def is_empty(self) -> bool:
        """Return whether no answer is kept."""
        kept = (self.folder / "answers").glob("[0-9a-f][0-9a-f]/*")
        return not any(_KEY.fullmatch(path.name) for path in kept)

    def size(self) -> int:
        """Return how many bytes the answers take up."""
        return sum(size for _, size, _ in self._list_kept())

    def _path(self, key: str) -> Path:
        if not _KEY.fullmatch(key):
            raise StorageError(f"A key is a sha256 in 64 hexadecimal digits, got {key!r}.")
        return self.folder / "answers" / key[:2] / key

    def _write(self, path: Path, raw: bytes) -> None:
        make_private(path.parent)
        number, name = tempfile.mkstemp(prefix=f"{_PARTIAL}{path.name}-", dir=path.parent)
        try:
            with os.fdopen(number, "wb") as file:
                file.write(raw)
                file.flush()
                os.fsync(file.fileno())
            Path(name).replace(path)
        except BaseException:
            Path(name).unlink(missing_ok=True)
            raise

    def _clear(self, key: str) -> None:
        """Remove unfinished files of a question that is held: their writers are gone."""
        path = self._path(key)
        for left in path.parent.glob(f"{_PARTIAL}{path.name}-*"):
            remove_file(left.parent, left.name)

    def _make_room(self, newest: Path, size: int) -> None:
        """See to it that all answers fit; look only after so many bytes that it may be full."""
        with self._lock_room:
            self._room -= size
            if self._room < 0:
                kept, spare = self._evict(newest), self.most_bytes // _SHARE
                self._room = min(self.most_bytes - kept, spare)

    def _evict(self, newest: Path) -> int:
        """Drop what was not asked for the longest if all is too much; return the size of the rest.

        ``newest`` stays. More goes than has to, so that the next answers find room.
        """
        kept = sorted(self._list_kept(), key=lambda entry: entry[0])
        total = sum(size for _, size, _ in kept)
        wanted = total if total <= self.most_bytes else self.most_bytes - self.most_bytes // _SHARE
        for _, size, path in kept:
            if total <= wanted:
                break
            if path != newest:
                remove_file(path.parent, path.name)
                total -= size
        return total

    def _list_kept(self) -> list[tuple[float, int, Path]]:
        """Return when each answer was used last, its bytes and path; remove what dead writers left.

        What has no answer's name, or is a link or in a linked folder, is somebody else's.
        """
        kept = []
        for path in (self.folder / "answers").glob("[0-9a-f][0-9a-f]/*"):
            with contextlib.suppress(OSError):  # another process dropped it
                status = path.lstat()
                if not stat.S_ISREG(status.st_mode) or path.parent.is_symlink():
                    continue
                if _KEY.fullmatch(path.name):
                    kept.append((status.st_mtime, status.st_size, path))
                elif path.name.startswith(_PARTIAL) and time.time() - status.st_mtime > _STALE:
                    remove_file(path.parent, path.name)
        return kept


def _encode(key: str, answer: StoredAnswer) -> bytes:
    facts = json.dumps({"status": answer.status, "content_type": answer.content_type})
    content = facts.encode() + b"\n" + answer.body
    return b"%s %s\n%s" % (_MAGIC, _checksum(key, content), content)


def _decode(key: str, raw: bytes) -> StoredAnswer | None:
    """Return the answer that ``raw`` holds, or None if it is not whole or another key's."""
    first, _, content = raw.partition(b"\n")
    if first != b"%s %s" % (_MAGIC, _checksum(key, content)):
        return None
    head, _, body = content.partition(b"\n")
    facts = parse_object(head, "An answer's head", StorageError, max_bytes=_MOST_HEAD)
    status, kind = facts.get("status"), facts.get("content_type")
    if type(status) is not int or not 100 <= status <= 599:
        return None
    if not isinstance(kind, str) or not kind.isprintable():
        return None
    return StoredAnswer(status, kind, body)


def _checksum(key: str, content: bytes) -> bytes:
    return hashlib.sha256(key.encode() + b"\n" + content).hexdigest().encode()


KEY = "x-tabletopgen-key"
"""The header of a response that says under which key its answer is kept."""


@dataclass(frozen=True)
class Used:
    """The keys of the answers that a question has had so far; ``store`` is where they are kept.

    A question that goes well leaves them there, for a run that resumes. One that ends in an error
    for what they say must drop them, or it would end so for ever.
    """

    store: CallStore | None
    keys: list[str] = field(default_factory=list)

    def add(self, headers: Mapping[str, str]) -> None:
        """Take note of an answer by the headers of its response."""
        self.keys.append(headers[KEY])

    def drop(self, *, last: bool = False) -> None:
        """Drop the answers, or the last one, but not their cost: the next run asks for new ones."""
        if self.store is not None:
            for key in self.keys[-1:] if last else self.keys:
                self.store.forget(key)

    @contextlib.contextmanager
    def dropped_on(self, error: type[BackendError]) -> Iterator[None]:
        """Drop the answers if the work within ends in ``error``."""
        try:
            yield
        except error:
            self.drop()
            raise
