"""A store of paid answers on disk, keyed by the content of their questions.

An answer is either complete or absent: it is written to a temporary file and renamed, and it
contains a checksum of its content and its key. Only a question's key is stored, and only an
answer's status, content type and body.
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
"""Maximum size in bytes of a stored answer, which is larger than any response that is read."""

_MOST_BYTES = 4 * 2**30  # default size of a store
_MAGIC = b"tabletopgen call 1"
_KEY = re.compile(r"[0-9a-f]{64}")
_PARTIAL = ".partial-"
_STALE = 3600.0  # seconds; an older unfinished file belongs to a process that has ended
_MOST_HEAD = 2**16  # bytes of an answer's header
_SHARE = 32  # the size is checked after each 1/32 of the store's capacity is written
_POLL = 0.05  # seconds between attempts to lock


@dataclass(frozen=True)
class StoredAnswer:
    """The stored parts of a server's answer."""

    status: int
    content_type: str
    body: bytes


class CallStore:
    """A folder of answers that threads and processes may use concurrently."""

    def __init__(self, folder: str | Path, most_bytes: int = _MOST_BYTES) -> None:
        """Use ``folder``, which is created with the first answer and accessible only to its owner.

        ``most_bytes`` is the capacity; the least recently used answers are evicted first. Each
        concurrent writer may exceed it by 1/32.

        Raises:
            InputError: ``most_bytes`` is not a positive whole number.
        """
        require_number("CallStore.most_bytes", most_bytes, minimum=1, integer=True)
        self.folder = Path(folder)
        self.most_bytes = most_bytes
        self._most_answer = min(most_bytes, MOST_ANSWER_BYTES)
        self._broken = False
        self._lock_room = threading.Lock()
        self._room = 0  # bytes left to write before the folder's size is checked again

    def get(self, key: str) -> StoredAnswer | None:
        """Return the answer to a question, or None. Damaged answers are removed."""
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
                os.utime(path, follow_symlinks=False)  # for the eviction of the least recently used
        return answer

    def put(self, key: str, answer: StoredAnswer) -> None:
        """Store an answer atomically; the caller must be ``holding`` the lock of its question.

        Raises:
            StorageError: the answer is larger than the store or the maximum size, or the disk
                fails. A disk failure is reported once; from then on nothing is stored.
        """
        if self._broken:
            return
        path, raw = self._path(key), _encode(key, answer)
        if len(raw) > self._most_answer:
            raise StorageError(
                f"An answer of {len(raw)} bytes does not fit into the call store {self.folder}, "
                f"whose capacity is {self.most_bytes} bytes, with at most {MOST_ANSWER_BYTES} "
                "bytes per answer. Raise the store's most_bytes, or request smaller answers."
            )
        try:
            self._write(path, raw)
            self._make_room(path, len(raw))
        except OSError as error:
            self._broken = True
            raise StorageError(
                f"The call store {self.folder} cannot be written ({error.strerror or error}): "
                "this run uses its answers without storing them. Free disk space or choose "
                "another folder."
            ) from error

    def forget(self, key: str) -> None:
        """Remove an answer, if it exists."""
        with contextlib.suppress(OSError):
            remove_file(self._path(key).parent, key)

    @contextlib.contextmanager
    def holding(self, key: str, check: Callable[[], None] = lambda: None) -> Iterator[None]:
        """Lock a question, so that no other thread or process sends it at the same time.

        The operating system releases the lock if the process dies; unfinished files of dead
        processes are removed. ``check`` is called periodically during the wait and may raise. If
        locks are not available, nothing is locked.
        """
        # the 4096 locks are shared by several keys each
        path = self.folder / "locks" / f"{key[:3]}.lock"
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
                check()  # an exception ends the wait
            yield

    def __len__(self) -> int:
        """Return the number of stored answers."""
        return len(self._list_kept())

    def is_empty(self) -> bool:
        """Return whether the store contains no answers."""
        kept = (self.folder / "answers").glob("[0-9a-f][0-9a-f]/*")
        return not any(_KEY.fullmatch(path.name) for path in kept)

    def size(self) -> int:
        """Return the total size of the answers in bytes."""
        return sum(size for _, size, _ in self._list_kept())

    def _path(self, key: str) -> Path:
        if not _KEY.fullmatch(key):
            raise StorageError(
                f"A key must be a SHA-256 digest of 64 hexadecimal digits, got {key!r}."
            )
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
        """Remove the unfinished files of a locked question; their writers have ended."""
        path = self._path(key)
        for left in path.parent.glob(f"{_PARTIAL}{path.name}-*"):
            remove_file(left.parent, left.name)

    def _make_room(self, newest: Path, size: int) -> None:
        """Evict answers if necessary; scan the folder only after enough bytes have been written."""
        with self._lock_room:
            self._room -= size
            if self._room < 0:
                kept, spare = self._evict(newest), self.most_bytes // _SHARE
                self._room = min(self.most_bytes - kept, spare)

    def _evict(self, newest: Path) -> int:
        """Remove the least recently used answers if the store is full; return the remaining size.

        ``newest`` is never removed. More answers than necessary are removed, to make room for the
        next ones.
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
        """Return each answer's last use, size and path; remove files left by dead writers.

        Files with other names, links, and files in linked folders are ignored.
        """
        kept = []
        for path in (self.folder / "answers").glob("[0-9a-f][0-9a-f]/*"):
            with contextlib.suppress(OSError):  # another process removed it
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
    """Return the answer in ``raw``, or None if it is damaged or has another key."""
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
"""Response header with the key under which the answer is stored."""


@dataclass(frozen=True)
class Used:
    """The keys of the answers to one question that are stored in ``store`` so far.

    After a success the answers stay in the store for a run that resumes. After an error caused by
    their content they must be removed, or every later run would fail in the same way.
    """

    store: CallStore | None
    keys: list[str] = field(default_factory=list)

    def add(self, headers: Mapping[str, str]) -> None:
        """Record an answer, given the headers of its response."""
        self.keys.append(headers[KEY])

    def drop(self, *, last: bool = False) -> None:
        """Remove all answers, or the last one, but keep their costs on record."""
        if self.store is not None:
            for key in self.keys[-1:] if last else self.keys:
                self.store.forget(key)

    @contextlib.contextmanager
    def dropped_on(self, error: type[BackendError]) -> Iterator[None]:
        """Remove the answers if the block raises ``error``."""
        try:
            yield
        except error:
            self.drop()
            raise
