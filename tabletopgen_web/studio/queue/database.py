"""The database of a studio: jobs and their events in one SQLite file.

Each change is one transaction. Only one process opens the file, the holder of the folder's lock.
"""

from __future__ import annotations

import contextlib
import sqlite3
import stat
from collections.abc import Iterator
from pathlib import Path

from generator.errors import StorageError

SCHEMA = 1
"""Version of the tables; other versions are rejected."""

REMOVAL = """type = 'state' AND data = '{"state": "deleted"}'"""
"""Condition for events that record the removal of a job."""

_TABLES = (
    """CREATE TABLE jobs (
        number INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE, kind TEXT NOT NULL,
        title TEXT NOT NULL, request TEXT NOT NULL, state TEXT NOT NULL, created REAL NOT NULL,
        started REAL, finished REAL, runs INTEGER NOT NULL DEFAULT 0, stage TEXT, error TEXT,
        result TEXT, log TEXT NOT NULL DEFAULT '', queued REAL NOT NULL)""",
    "CREATE INDEX jobs_by_state ON jobs (state, queued, number)",
    """CREATE TABLE events (
        seq INTEGER PRIMARY KEY AUTOINCREMENT, job TEXT NOT NULL, type TEXT NOT NULL,
        time REAL NOT NULL, data TEXT NOT NULL)""",
    "CREATE INDEX events_of_jobs ON events (job, seq)",
    f"CREATE INDEX removals ON events (seq) WHERE {REMOVAL}",
)
_MAX_VALUE_BYTES = 4 * 2**20


def open_database(path: Path) -> sqlite3.Connection:
    """Open or create the database; callers start transactions explicitly.

    Raises:
        StorageError: the database has another schema, is damaged, not a regular file, or not
            writable.
    """
    with storing(path):
        if path.is_symlink() or (path.exists() and not stat.S_ISREG(path.stat().st_mode)):
            raise StorageError(f"{path} is not a regular file. Choose another --folder.")
        path.touch(0o600)  # SQLite's auxiliary files must be private, too
        path.chmod(0o600)
        database = sqlite3.connect(path, timeout=10, isolation_level=None, check_same_thread=False)
        try:
            database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _MAX_VALUE_BYTES)
            database.execute("PRAGMA trusted_schema = OFF")
            database.execute("PRAGMA journal_mode = WAL")
            database.execute("PRAGMA synchronous = NORMAL")
            _check_schema(database, path)
        except BaseException:
            database.close()
            raise
        return database


def _check_schema(database: sqlite3.Connection, path: Path) -> None:
    (version,) = database.execute("PRAGMA user_version").fetchone()
    (tables,) = database.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if not version and not tables:
        with transaction(database):
            for table in _TABLES:
                database.execute(table)
            database.execute(f"PRAGMA user_version = {SCHEMA}")
    elif version != SCHEMA:
        raise StorageError(
            f"{path} has schema {version}; this version requires schema {SCHEMA}. Install a "
            "matching tabletopgen, or choose another --folder."
        )


@contextlib.contextmanager
def transaction(database: sqlite3.Connection) -> Iterator[None]:
    """Execute the block as one transaction, which applies all of its changes or none."""
    database.execute("BEGIN IMMEDIATE")
    try:
        yield
        database.execute("COMMIT")
    except BaseException:
        with contextlib.suppress(sqlite3.Error):
            database.execute("ROLLBACK")
        raise


@contextlib.contextmanager
def storing(path: Path) -> Iterator[None]:
    """Convert errors of SQLite and the disk to a StorageError that names the file."""
    try:
        yield
    except sqlite3.OperationalError as error:
        raise StorageError(
            f"{path} cannot be read or written: {error}. Free disk space, or choose another "
            "--folder."
        ) from error
    except sqlite3.DatabaseError as error:
        raise StorageError(
            f"{path} is damaged: {error}. The file is unchanged; choose another --folder."
        ) from error
    except StorageError:
        raise
    except OSError as error:
        raise StorageError(
            f"{path} cannot be used: {error.strerror or error}. Choose another --folder."
        ) from error
