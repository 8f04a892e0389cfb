"""The SQLite database in which a folder keeps what calls cost: ``spending.sqlite3``.

Each change is one transaction, so that a process may be killed at any point. SQLite's locks hold on
one machine: the file must never lie on a network disk that several machines write to. Over several
machines one process owns it and works for the others: see ``Keeper`` and ``jobs.on_ray``.

The file may be anybody's: it is opened only if it is a regular file of bounded size with exactly
these tables, what it holds is checked, and it is never deleted or replaced.
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
"""The database's name in its folder."""

TABLES = (
    "CREATE TABLE calls (call INTEGER PRIMARY KEY, scene TEXT, facts TEXT)",
    "CREATE INDEX calls_of_scenes ON calls (scene)",
    "CREATE TABLE held (call INTEGER PRIMARY KEY, owner TEXT, money REAL)",
    "CREATE TABLE spent (mark TEXT, currency TEXT, money REAL, unpriced INTEGER)",
)
"""Calls of scenes; what calls under way may cost at most, by who makes them; what was spent."""
_OLD = ("spent.json", "spending")  # where older versions kept it
_OWNERS = "spenders"  # the folder with a locked file for each living owner
_NAME = re.compile(r"[0-9a-f]{16,64}")  # of an owner
_MAX_BYTES = 256 * 2**20  # of the file
_MAX_VALUE_BYTES = 2**20
_WAIT = 60.0  # seconds: nobody locks the file for long
_SUPER_JOURNAL = b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7"
"""Ends a journal that names another file, which SQLite would delete; ours name none."""


class NoDatabaseError(StorageError):
    """A folder has no database of what was spent."""


class Keeper(Protocol):
    """Works on databases: this process, or one that does so for several machines."""

    def create(self, folder: Path) -> None:
        """Make a folder's database, unless there is one."""
        ...

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, done in one transaction.

        The operation is a function of a module, so that it can be pickled.
        """
        ...

    def owning(self, folder: Path) -> contextlib.AbstractContextManager[str]:
        """Name an owner of reservations, who is alive meanwhile."""
        ...


class LocalKeeper:
    """This process, on databases of this machine."""

    def create(self, folder: Path) -> None:
        """Publish an empty database in a folder, for its owner alone, unless there is one.

        Raises:
            StorageError: the folder cannot be written, or has what an older version kept.
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
                with contextlib.suppress(FileExistsError):  # another process was faster
                    os.link(new, folder / FILE)
            finally:
                remove_file(folder, new.name)
        except (OSError, sqlite3.Error) as error:
            raise _refusal(folder / FILE, str(error)) from error

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, done in one transaction.

        Raises:
            StorageError: the database is foreign, damaged or missing, or the disk refuses. It is
                never taken for an empty one.
        """
        path = folder / FILE
        try:
            with _transaction(path) as database:
                result = operation(database, *args)
                database.execute("COMMIT")
                return result
        except (FileNotFoundError, NotADirectoryError) as error:
            raise NoDatabaseError(f"There is no {path}, which says what was spent.") from error
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
        """Name an owner of reservations, alive until the block or this process ends."""
        name, owners = name or secrets.token_hex(8), _owners_of(folder)
        owners.mkdir(exist_ok=True)
        try:
            with FileLock(owners / f"{name}.lock", thread_local=False):
                yield name
        finally:
            remove_file(owners, f"{name}.lock")


LOCAL = LocalKeeper()
"""The keeper of who asks no other."""


def is_alive(folder: Path, name: str) -> bool:
    """Return whether an owner's process holds its lock; the file of a dead one is removed.

    Raises:
        StorageError: the name, which a database holds, is no owner's.
    """
    if not _NAME.fullmatch(name):
        raise damage_error(folder / FILE, f"{name!r:.80} is no spender: they have 16 hex digits.")
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
                f"{folder / old} is from an older version: what was spent is no longer read from "
                "there. Choose another folder, or remove it for that to count as nothing."
            )


def damage_error(path: Path, why: str) -> StorageError:
    """Return the error of a database that does not say what was spent, and why."""
    return StorageError(
        f"{path} does not say what was spent: {why} It is left as it is. Restore it, choose "
        "another folder, or remove it for what was spent to count as nothing."
    )


def _refusal(path: Path, why: str) -> StorageError:
    return StorageError(
        f"What was spent cannot be read or written ({path}: {why}). Free space there, see who uses "
        "it, or choose another folder."
    )


def _owners_of(folder: Path) -> Path:
    owners = folder / _OWNERS
    if owners.is_symlink():
        raise StorageError(f"{owners} is a link; spenders are kept beside their database.")
    return owners


@contextlib.contextmanager
def _transaction(path: Path) -> Iterator[sqlite3.Connection]:
    """Begin a transaction on a database; it is rolled back unless it is committed.

    Nothing else may open and close the file: that would drop the locks that SQLite holds on it.
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
            raise damage_error(path, f"It has other tables: {tables!r:.200}.")
        yield database


def _check_file(path: Path) -> None:
    status = path.lstat()
    if not stat.S_ISREG(status.st_mode):
        raise StorageError(f"{path} is not a regular file. Choose another folder.")
    if status.st_size > _MAX_BYTES:
        raise damage_error(path, f"It has {status.st_size} bytes; at most {_MAX_BYTES} are read.")


def _check_journal(path: Path) -> None:
    """Refuse what a killed transaction cannot have left."""
    with contextlib.suppress(FileNotFoundError):
        _check_file(path)
        with path.open("rb") as file:
            file.seek(max(0, path.lstat().st_size - len(_SUPER_JOURNAL)))
            if file.read() == _SUPER_JOURNAL:
                raise damage_error(path, "It names another file.")
