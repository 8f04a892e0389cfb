"""Parallel execution of queued jobs, and recording of results."""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import Callable, Mapping
from typing import Any

from generator.errors import StorageError, TabletopError

from ..contracts import FigureRow, JobResult, JobRow, JobState, StageRow
from ..refusals import RefusedError
from .jobs import JobStore
from .process import JobProcess

Order = Callable[[JobRow], Mapping[str, Any]]
"""A function that creates the order for a job's process, or raises a TabletopError."""

_LOG = logging.getLogger(__name__)
_AGAIN = 2.0  # seconds between attempts to take a job, or to record a result
_MAX_ERROR = 2000  # maximum length of a message, characters


class Runner:
    """A runner of a store's jobs, in up to ``workers`` concurrent processes."""

    def __init__(self, store: JobStore, order: Order, workers: int) -> None:
        self._store, self._order, self._workers = store, order, workers
        self._running: dict[str, JobProcess] = {}
        self._unsaved: dict[str, tuple[JobState, str | None, JobResult | None]] = {}
        self._work = asyncio.Event()

    def wake(self) -> None:
        """Check for waiting jobs."""
        self._work.set()

    async def run(self) -> None:
        """Run jobs until cancelled; running jobs are then interrupted."""
        async with asyncio.TaskGroup() as group:
            for _ in range(self._workers):
                group.create_task(self._serve())

    def cancel(self, job: str) -> JobRow:
        """Cancel a waiting or running job.

        Raises:
            RefusedError: the job does not exist, or is finished.
        """
        row = self._store.get(job)
        if row.state == "queued":
            self._store.finish(job, "cancelled")
        elif row.state == "running":
            if job in self._running:
                self._running[job].cancel()
        else:
            raise RefusedError(409, f"The job is {row.state}; there is nothing to cancel.")
        return self._store.get(job)

    async def _serve(self) -> None:
        while True:
            try:
                self._save_endings()
                job = self._store.take()
            except StorageError:  # the disk is full: try again later
                await asyncio.sleep(_AGAIN)
                continue
            except Exception:  # an internal error must not stop other jobs
                _LOG.exception("Taking a job failed.")
                await asyncio.sleep(_AGAIN)
                continue
            if job is not None:
                await self._do(job)
                continue
            self._work.clear()
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(self._work.wait(), _AGAIN)

    async def _do(self, job: JobRow) -> None:
        """Run one job and record its result, whatever happens."""
        latest: dict[str, Any] = {}
        try:
            work = JobProcess(
                self._order(job), lambda message: self._hear(job.id, message, latest),
                lambda text: self._store.note_log(job.id, text),
            )  # fmt: skip
            self._running[job.id] = work
            try:
                ending = await work.run()
            except asyncio.CancelledError:
                self._finish(job.id, "interrupted")
                raise
            finally:
                self._running.pop(job.id, None)
        except TabletopError as error:
            self._finish(job.id, "failed", str(error))
            return
        except Exception:  # an internal error fails the job, not the server
            _LOG.exception("The job %s failed internally.", job.id)
            self._finish(job.id, "failed", "Internal error of the studio; see its terminal.")
            return
        if "result" in latest and ending.code == 0:
            self._finish(job.id, "done", result=latest["result"])
        elif work.cancelled:
            self._finish(job.id, "cancelled")
        else:
            facts = latest.get("facts")
            result = JobResult(facts=facts) if facts else None
            self._finish(job.id, "failed", latest.get("error") or ending.describe(), result)

    def _hear(self, job: str, message: Mapping[str, Any], latest: dict[str, Any]) -> None:
        """Record a message from the process; keep the last result or error in ``latest``."""
        kind = message.get("type")
        if kind == "stage":
            stage = StageRow(message["name"], message["number"], message["total"])
            self._store.note_stage(job, stage)
        elif kind == "figure":
            url = f"/api/jobs/{job}/figures/{message['name']}"
            self._store.note_figure(job, FigureRow(message["name"], message["stage"], url))
        elif kind == "result":
            latest["result"] = _as_result(job, message)
        elif kind == "error":
            latest["error"] = str(message["message"])[:_MAX_ERROR]
            latest["facts"] = message.get("facts")

    def _finish(
        self, job: str, state: JobState, error: str | None = None, result: JobResult | None = None
    ) -> None:
        self._unsaved[job] = state, error, result
        self._save_endings()

    def _save_endings(self) -> None:
        """Record results that could not be saved before; after disk errors, keep them for later."""
        for job, (state, error, result) in list(self._unsaved.items()):
            with contextlib.suppress(StorageError):
                self._store.finish(job, state, error, result)
                del self._unsaved[job]


def _as_result(job: str, message: Mapping[str, Any]) -> JobResult:
    file = message.get("file")
    return JobResult(
        scene=message.get("scene"), file=file,
        url=f"/api/jobs/{job}/files/{file}" if file else None,
        bytes=message.get("bytes"), facts=message.get("facts", {}),
    )  # fmt: skip
