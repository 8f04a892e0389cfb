"""The SQLite database of a folder that records the costs of calls: ``spending.sqlite3``.

Each change is one transaction, so a process may be killed at any point. SQLite's locks work on one
machine only: the file must not be on a network disk that several machines write to. In a cluster,
one process owns the file and accesses it on behalf of the others; see ``Keeper`` and
``jobs.on_ray``.

The file is untrusted: it is opened only if it is a regular file of bounded size with exactly these
tables. Its content is checked, and it is never deleted or replaced.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import sqlite3
import stat
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Protocol, TypeVar

from filelock import FileLock, Timeout

from ...errors import StorageError
from ...io.files import make_private, remove_file

T = TypeVar("T")

FILE = "spending.sqlite3"
"""File name of the database in its folder."""

TABLES = (
    "CREATE TABLE calls (call INTEGER PRIMARY KEY, scene TEXT, facts TEXT)",
    "CREATE INDEX calls_of_scenes ON calls (scene)",
    "CREATE TABLE held (call INTEGER PRIMARY KEY, owner TEXT, money REAL)",
    "CREATE TABLE spent (mark TEXT, currency TEXT, money REAL, unpriced INTEGER)",
)
"""Tables: the calls of scenes; the owners and maximum costs of calls in flight; the totals."""
_OLD = ("spent.json", "spending")  # files of older versions
_OWNERS = "spenders"  # folder with one locked file per live owner
_NAME = re.compile(r"[0-9a-f]{16,64}")  # name of an owner
_MAX_BYTES = 256 * 2**20  # maximum file size
_MAX_VALUE_BYTES = 2**20
_WAIT = 60.0  # seconds; locks on the file are always short
_SUPER_JOURNAL = b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7"
"""Last bytes of a journal that refers to a super-journal, which SQLite would delete; the journals
of spending databases never do."""


class NoDatabaseError(StorageError):
    """The folder has no spending database."""


class Keeper(Protocol):
    """Access to databases, by this process or by one process on behalf of several machines."""

    def create(self, folder: Path) -> None:
        """Create a folder's database if it does not exist."""
        ...

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, run in one transaction.

        The operation is a module-level function, so that it can be pickled.
        """
        ...

    def owning(self, folder: Path) -> contextlib.AbstractContextManager[str]:
        """Yield the name of a new owner of reservations; the owner is alive inside the block."""
        ...


class LocalKeeper:
    """Access by this process to databases on this machine."""

    def create(self, folder: Path) -> None:
        """Create an empty database in a folder, accessible only to its owner, if none exists.

        Raises:
            StorageError: the folder is not writable, or contains files of an older version.
        """
        _refuse_old(folder)
        if os.path.lexists(folder / FILE):
            return
        new = folder / f"{secrets.token_hex(8)}.part"
        try:
            make_private(folder)
            new.touch(0o600)
            try:
                with contextlib.closing(sqlite3.connect(new)) as database:
                    for table in TABLES:
                        database.execute(table)
                with contextlib.suppress(FileExistsError):  # another process created it meanwhile
                    os.link(new, folder / FILE)
            finally:
                remove_file(folder, new.name)
        except (OSError, sqlite3.Error) as error:
            raise _refusal(folder / FILE, str(error)) from error

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, run in one transaction.

        Raises:
            StorageError: the database is foreign, damaged or missing, or the disk fails. Such a
                database never counts as empty.
        """
        path = folder / FILE
        try:
            with _transaction(path) as database:
                result = operation(database, *args)
                database.execute("COMMIT")
                return result
        except (FileNotFoundError, NotADirectoryError) as error:
            raise NoDatabaseError(f"The spending database {path} does not exist.") from error
        except StorageError:
            raise
        except sqlite3.DatabaseError as error:
            if not isinstance(error, sqlite3.OperationalError) or "decode" in str(error):
                raise damage_error(path, f"{error}.") from error
            raise _refusal(path, str(error)) from error
        except OSError as error:
            raise _refusal(path, error.strerror or str(error)) from error

    @contextlib.contextmanager
    def owning(self, folder: Path, name: str | None = None) -> Iterator[str]:
        """Yield the name of an owner of reservations, alive until the block or the process ends."""
        name, owners = name or secrets.token_hex(8), _owners_of(folder)
        owners.mkdir(exist_ok=True)
        try:
            with FileLock(owners / f"{name}.lock", thread_local=False):
                yield name
        finally:
            remove_file(owners, f"{name}.lock")


LOCAL = LocalKeeper()
"""The default access to spending databases, for processes on this machine only."""


def is_alive(folder: Path, name: str) -> bool:
    """Return whether an owner's process holds its lock; remove the lock file of a dead owner.

    Raises:
        StorageError: the name, read from a database, is not a valid owner name.
    """
    if not _NAME.fullmatch(name):
        raise damage_error(
            folder / FILE,
            f"{name!r:.80} is not a valid owner name, which has at least 16 hex digits.",
        )
    lock = _owners_of(folder) / f"{name}.lock"
    with contextlib.suppress(Timeout):
        if lock.exists():
            with FileLock(lock, timeout=0):
                pass
            remove_file(lock.parent, lock.name)
        return False
    return True


def _refuse_old(folder: Path) -> None:
    for old in _OLD:
        if os.path.lexists(folder / old):
            raise StorageError(
                f"{folder / old} was written by an older version and is no longer supported. "
                "Choose another folder, or remove the file, which discards its record of "
                "spending."
            )


def damage_error(path: Path, why: str) -> StorageError:
    """Return the error for a database with invalid content, including the reason."""
    return StorageError(
        f"{path} is not a valid spending database: {why} The file was not changed. Restore the "
        "file, choose another folder, or remove the file, which discards its record of spending."
    )


def _refusal(path: Path, why: str) -> StorageError:
    return StorageError(
        f"The spending database cannot be read or written ({path}: {why}). Free disk space, "
        "check which processes use it, or choose another folder."
    )


def _owners_of(folder: Path) -> Path:
    owners = folder / _OWNERS
    if owners.is_symlink():
        raise StorageError(
            f"{owners} is a link; the lock files must be in a real folder next to the database."
        )
    return owners


@contextlib.contextmanager
def _transaction(path: Path) -> Iterator[sqlite3.Connection]:
    """Begin a transaction on a database; it is rolled back unless it is committed.

    No other code may open and close the file, because that would drop SQLite's locks on it.
    """
    _refuse_old(path.parent)
    _check_file(path)
    _check_journal(path.with_name(f"{FILE}-journal"))
    with contextlib.closing(
        sqlite3.connect(
            f"{path.absolute().as_uri()}?mode=rw", uri=True, timeout=_WAIT, isolation_level=None
        )
    ) as database:
        database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _MAX_VALUE_BYTES)
        database.execute("PRAGMA trusted_schema = OFF")
        database.execute("PRAGMA cell_size_check = ON")
        database.execute("BEGIN IMMEDIATE")
        tables = [sql for (sql,) in database.execute("SELECT sql FROM sqlite_master LIMIT 9")]
        if sorted(map(str, tables)) != sorted(TABLES):
            raise damage_error(path, f"The file has unexpected tables: {tables!r:.200}.")
        yield database


def _check_file(path: Path) -> None:
    status = path.lstat()
    if not stat.S_ISREG(status.st_mode):
        raise StorageError(f"{path} is not a regular file. Choose another folder.")
    if status.st_size > _MAX_BYTES:
        raise damage_error(path, f"The file has {status.st_size} bytes; the limit is {_MAX_BYTES}.")


def _check_journal(path: Path) -> None:
    """Raise an error for a journal that an interrupted transaction cannot have left."""
    with contextlib.suppress(FileNotFoundError):
        _check_file(path)
        with path.open("rb") as file:
            file.seek(max(0, path.lstat().st_size - len(_SUPER_JOURNAL)))
            if file.read() == _SUPER_JOURNAL:
                raise damage_error(path, "It refers to another file.")
