"""Jobs and their events, kept through whatever ends the server."""

from __future__ import annotations

import contextlib
import json
import secrets
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from generator.errors import StorageError

from ..contracts import (
    EventType,
    FigureRow,
    JobResult,
    JobRow,
    JobState,
    StageRow,
    encode,
)
from ..refusals import RefusedError
from ..specs import read_spec, title_of
from .database import REMOVAL, storing, transaction
from .history import JobHistory

QUEUE_LIMIT = 200
"""Jobs that wait or run at most."""

MOST_LOG = 64 * 2**10
"""Characters of a job's log that are kept, its end."""

MOST_INTERRUPTED = 3
"""After so many runs that ended with the server, a job is not begun again by itself."""

_MOST_JOBS = 5000  # kept; the oldest that are over make way
_MOST_DELETED = 1000  # removals that clients can still hear of
_RESERVED = 256 * 2**10  # bytes
_OVER = ("done", "failed", "cancelled", "interrupted")
_RESUMABLE = ("failed", "cancelled", "interrupted")


class JobStore(JobHistory):
    """The queue, and the history of what happened; for one thread.

    What the disk refuses is a StorageError.

    Attributes:
        changed: called after each change.
        dropped: called with the jobs that made way for a new one.

    Raises:
        StorageError: the database cannot be used.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.changed: Callable[[], None] = lambda: None
        self.dropped: Callable[[Sequence[str]], None] = lambda jobs: None
        self._reserve = path.with_name("reserve")

    def add(self, request: Mapping[str, Any]) -> JobRow:
        """Queue a job, as ``specs.read_spec`` reads it.

        Raises:
            InputError: it is no such job.
            RefusedError: the queue is full.
        """
        spec = read_spec(request)
        job, now = secrets.token_hex(6), time.time()
        self._check_room()
        with self._changing():
            self._database.execute(
                "INSERT INTO jobs (id, kind, title, request, state, created, queued) "
                "VALUES (?, ?, ?, ?, 'queued', ?, ?)",
                (job, request["kind"], title_of(spec), json.dumps(request), now, now),
            )
            self._tell(job, "state", {"state": "queued", "kind": request["kind"]})
            old = self._drop_old()
        self.dropped(old)
        return self.get(job)

    def take(self) -> JobRow | None:
        """Begin the job that has waited longest; None if none waits."""
        self._keep_reserve()
        if not (rows := self._select(
            "SELECT id FROM jobs WHERE state = 'queued' ORDER BY queued, number LIMIT 1"
        )):  # fmt: skip
            return None
        job = rows[0]["id"]
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET state = 'running', started = ?, finished = NULL, stage = NULL, "
                "error = NULL, result = NULL, log = '', runs = runs + 1 WHERE id = ?",
                (time.time(), job),
            )
            self._tell(job, "state", {"state": "running"})
        return self.get(job)

    def note_stage(self, job: str, stage: StageRow) -> None:
        """Write down that a stage has begun."""
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET stage = ? WHERE id = ?", (json.dumps(encode(stage)), job)
            )
            self._tell(job, "stage", encode(stage))

    def note_figure(self, job: str, figure: FigureRow) -> None:
        """Write down that a picture can be fetched."""
        with self._changing():
            self._tell(job, "figure", encode(figure))

    def note_log(self, job: str, text: str) -> None:
        """Add to what the job's process wrote."""
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET log = substr(log || ?, -?) WHERE id = ?", (text, MOST_LOG, job)
            )
            self._tell(job, "log", {"text": text})

    def finish(
        self, job: str, state: JobState, error: str | None = None, result: JobResult | None = None
    ) -> None:
        """Write down how a job ended; on a full disk in the place that is reserved for that."""
        try:
            self._finish(job, state, error, result)
        except StorageError:
            with contextlib.suppress(OSError):
                self._reserve.unlink()
            self._finish(job, state, error, result)

    def resume(self, job: str) -> JobRow:
        """Queue a job again that failed, was cancelled or interrupted, just as it was asked for.

        Raises:
            RefusedError: there is none, it is in another state, or the queue is full.
        """
        state = self.get(job).state
        if state not in _RESUMABLE:
            raise RefusedError(409, f"The job is {state}; only jobs that ended without a result "
                                    "are resumed.")  # fmt: skip
        self._check_room()
        self._requeue(job, runs=0)
        return self.get(job)

    def delete(self, job: str) -> None:
        """Remove a job that is over, and its events.

        Raises:
            RefusedError: there is none, or it is not over.
        """
        state = self.get(job).state
        if state not in _OVER:
            raise RefusedError(409, f"The job is {state}; cancel it first.")
        with self._changing():
            self._remove(job)

    def recover(self) -> list[str]:
        """Queue the jobs again that were running when the server ended; return their ids.

        A job with which the server ended again and again stays interrupted.
        """
        rows = self._select("SELECT id, runs FROM jobs WHERE state IN ('running', 'interrupted') "
                            "AND (state = 'running' OR error IS NULL)")  # fmt: skip
        queued = []
        for row in rows:
            job, often = row["id"], row["runs"] >= MOST_INTERRUPTED
            error = None
            if often:
                error = (
                    f"The studio ended {row['runs']} times while this job ran; it is not begun "
                    "again by itself."
                )
            self.finish(job, "interrupted", error)
            if not often:
                self._requeue(job, row["runs"])
                queued.append(job)
        return queued

    # ------------------------------------------------------------------------------------ helpers

    def _finish(
        self, job: str, state: JobState, error: str | None, result: JobResult | None
    ) -> None:
        told = None if result is None else encode(result)
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET state = ?, finished = ?, error = ?, result = ? WHERE id = ?",
                (state, time.time(), error, None if told is None else json.dumps(told), job),
            )
            if told is not None:
                self._tell(job, "result", told)
            self._tell(job, "state", {"state": state, **({"error": error} if error else {})})

    def _check_room(self) -> None:
        """Refuse a job more than the queue takes."""
        ((busy,),) = self._select("SELECT count(*) FROM jobs WHERE state IN ('queued', 'running')")
        if busy >= QUEUE_LIMIT:
            raise RefusedError(
                429, f"{busy} jobs wait or run, which is the limit. Wait for one to end."
            )

    def _keep_reserve(self) -> None:
        """Take up the place in which endings can be written on a full disk."""
        with contextlib.suppress(OSError):
            if not self._reserve.exists():
                try:
                    self._reserve.write_bytes(bytes(_RESERVED))
                except OSError:
                    self._reserve.unlink(missing_ok=True)

    def _requeue(self, job: str, runs: int) -> None:
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET state = 'queued', queued = ?, runs = ?, error = NULL, "
                "stage = NULL WHERE id = ?", (time.time(), runs, job),
            )  # fmt: skip
            self._tell(job, "state", {"state": "queued"})

    def _remove(self, job: str) -> None:
        self._database.execute("DELETE FROM events WHERE job = ?", (job,))
        self._database.execute("DELETE FROM jobs WHERE id = ?", (job,))
        self._tell(job, "state", {"state": "deleted"})
        self._database.execute(
            f"DELETE FROM events WHERE {REMOVAL} AND seq NOT IN (SELECT seq FROM events "
            f"WHERE {REMOVAL} ORDER BY seq DESC LIMIT ?)", (_MOST_DELETED,),
        )  # fmt: skip

    def _drop_old(self) -> list[str]:
        (count,) = self._database.execute("SELECT count(*) FROM jobs").fetchone()
        rows = self._select(
            f"SELECT id FROM jobs WHERE state IN {_OVER} ORDER BY number LIMIT ?",
            max(count - _MOST_JOBS, 0),
        )
        old = [row["id"] for row in rows]
        for job in old:
            self._remove(job)
        return old

    def _tell(self, job: str, kind: EventType, data: Mapping[str, Any]) -> None:
        self._database.execute(
            "INSERT INTO events (job, type, time, data) VALUES (?, ?, ?, ?)",
            (job, kind, time.time(), json.dumps(data)),
        )

    @contextlib.contextmanager
    def _changing(self) -> Iterator[None]:
        """Make the changes of a block one transaction, and say so afterwards."""
        with storing(self._path), transaction(self._database):
            yield
        self.changed()
