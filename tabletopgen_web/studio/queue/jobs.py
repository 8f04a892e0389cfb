"""Jobs and their events, stored persistently."""

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
"""Maximum number of waiting and running jobs."""

MOST_LOG = 64 * 2**10
"""Number of characters at the end of a job's log that are stored."""

MOST_INTERRUPTED = 3
"""Number of interrupted runs after which a job is no longer restarted automatically."""

_MAX_JOBS = 5000  # stored jobs; the oldest finished ones are dropped
_MAX_DELETED = 1000  # stored removal events, for clients that reconnect
_RESERVED = 256 * 2**10  # bytes
_OVER = ("done", "failed", "cancelled", "interrupted")
_RESUMABLE = ("failed", "cancelled", "interrupted")


class JobStore(JobHistory):
    """The queue and the event history, for use by a single thread.

    Errors of the disk raise a StorageError.

    Attributes:
        changed: called after each change.
        dropped: called with the old jobs removed in favour of a new one.

    Raises:
        StorageError: the database cannot be used.
    """

    def __init__(self, path: Path) -> None:
        super().__init__(path)
        self.changed: Callable[[], None] = lambda: None
        self.dropped: Callable[[Sequence[str]], None] = lambda jobs: None
        self._reserve = path.with_name("reserve")

    def add(self, request: Mapping[str, Any]) -> JobRow:
        """Add a job to the queue; see ``specs.read_spec`` for its fields.

        Raises:
            InputError: the job is invalid.
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
        """Start and return the longest-waiting job; return None if none waits."""
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
        """Record the start of a stage."""
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET stage = ? WHERE id = ?", (json.dumps(encode(stage)), job)
            )
            self._tell(job, "stage", encode(stage))

    def note_figure(self, job: str, figure: FigureRow) -> None:
        """Record that a picture is available."""
        with self._changing():
            self._tell(job, "figure", encode(figure))

    def note_log(self, job: str, text: str) -> None:
        """Append to the log of the job."""
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET log = substr(log || ?, -?) WHERE id = ?", (text, MOST_LOG, job)
            )
            self._tell(job, "log", {"text": text})

    def finish(
        self, job: str, state: JobState, error: str | None = None, result: JobResult | None = None
    ) -> None:
        """Record the result of a job, in the reserved space if the disk is full."""
        try:
            self._finish(job, state, error, result)
        except StorageError:
            with contextlib.suppress(OSError):
                self._reserve.unlink()
            self._finish(job, state, error, result)

    def resume(self, job: str) -> JobRow:
        """Requeue a failed, cancelled or interrupted job with the same request.

        Raises:
            RefusedError: the job does not exist, is in another state, or the queue is full.
        """
        state = self.get(job).state
        if state not in _RESUMABLE:
            raise RefusedError(409, f"The job is {state}; only jobs that ended without a result "
            f"can be resumed.")  # fmt: skip
        self._check_room()
        self._requeue(job, runs=0)
        return self.get(job)

    def delete(self, job: str) -> None:
        """Remove a finished job and its events.

        Raises:
            RefusedError: the job does not exist, or is not finished.
        """
        state = self.get(job).state
        if state not in _OVER:
            raise RefusedError(409, f"The job is {state}; cancel it first.")
        with self._changing():
            self._remove(job)

    def recover(self) -> list[str]:
        """Requeue the jobs that were running when the server ended; return their ids.

        A job stays interrupted if the server ended during several of its runs.
        """
        rows = self._select("SELECT id, runs FROM jobs WHERE state IN ('running', 'interrupted') "
                            "AND (state = 'running' OR error IS NULL)")  # fmt: skip
        queued = []
        for row in rows:
            job, often = row["id"], row["runs"] >= MOST_INTERRUPTED
            error = None
            if often:
                error = (
                    f"The studio stopped {row['runs']} times while this job was running, so the "
                    "job is not restarted automatically."
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
        encoded = None if result is None else encode(result)
        with self._changing():
            self._database.execute(
                "UPDATE jobs SET state = ?, finished = ?, error = ?, result = ? WHERE id = ?",
                (state, time.time(), error, None if encoded is None else json.dumps(encoded), job),
            )
            if encoded is not None:
                self._tell(job, "result", encoded)
            self._tell(job, "state", {"state": state, **({"error": error} if error else {})})

    def _check_room(self) -> None:
        """Reject a job if the queue is full."""
        ((busy,),) = self._select("SELECT count(*) FROM jobs WHERE state IN ('queued', 'running')")
        if busy >= QUEUE_LIMIT:
            raise RefusedError(
                429,
                f"{busy} jobs are waiting or running, which is the maximum. Wait for one to end.",
            )

    def _keep_reserve(self) -> None:
        """Reserve disk space, so that results can be recorded even if the disk is full."""
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
            f"WHERE {REMOVAL} ORDER BY seq DESC LIMIT ?)", (_MAX_DELETED,),
        )  # fmt: skip

    def _drop_old(self) -> list[str]:
        (count,) = self._database.execute("SELECT count(*) FROM jobs").fetchone()
        rows = self._select(
            f"SELECT id FROM jobs WHERE state IN {_OVER} ORDER BY number LIMIT ?",
            max(count - _MAX_JOBS, 0),
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
        """Execute the block as one transaction, then notify listeners."""
        with storing(self._path), transaction(self._database):
            yield
        self.changed()
