"""Queries of jobs and events in the database."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from ..contracts import FigureRow, JobEvent, JobKind, JobResult, JobRow, JobState, StageRow
from ..refusals import RefusedError
from .database import open_database, storing


class JobHistory:
    """A reader of jobs and their events.

    Raises:
        StorageError: the database cannot be used.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._database = open_database(path)

    def close(self) -> None:
        """Close the database."""
        self._database.close()

    def get(self, job: str) -> JobRow:
        """Return a job with its log; raise RefusedError if the job does not exist."""
        rows = self._select("SELECT * FROM jobs WHERE id = ?", job)
        if not rows:
            raise RefusedError(404, f"There is no job {job[:80]!r}.")
        return self._row(rows[0], whole=True)

    def list_jobs(self) -> list[JobRow]:
        """Return all jobs without their logs, newest first."""
        rows = self._select("SELECT * FROM jobs ORDER BY number DESC")
        figures: dict[str, dict[str, FigureRow]] = {}
        for job, data in self._select("SELECT job, data FROM events WHERE type = 'figure'"):
            shown = FigureRow(**json.loads(data))
            figures.setdefault(job, {})[shown.name] = shown
        return [self._row(row, figures=figures.get(row["id"], {})) for row in rows]

    def events(self, since: int, limit: int = 200) -> list[JobEvent]:
        """Return the events after number ``since``, in order."""
        rows = self._select("SELECT * FROM events WHERE seq > ? ORDER BY seq LIMIT ?", since, limit)
        return [
            JobEvent(r["seq"], r["job"], r["type"], r["time"], json.loads(r["data"])) for r in rows
        ]

    @property
    def last_event(self) -> int:
        """The number of the newest event so far, or 0 before the first event."""
        rows = self._select("SELECT seq FROM sqlite_sequence WHERE name = 'events'")
        return rows[0][0] if rows else 0

    def _select(self, query: str, *values: Any) -> list[sqlite3.Row]:
        with storing(self._path):
            cursor = self._database.cursor()
            cursor.row_factory = sqlite3.Row
            return cursor.execute(query, values).fetchall()

    def _row(
        self, row: sqlite3.Row, figures: Mapping[str, FigureRow] | None = None, whole: bool = False
    ) -> JobRow:
        if figures is None:
            events_of_job = self._select(
                "SELECT data FROM events WHERE job = ? AND type = 'figure' ORDER BY seq", row["id"]
            )
            shown = [FigureRow(**json.loads(data)) for (data,) in events_of_job]
            figures = {each.name: each for each in shown}
        stage, result = row["stage"], row["result"]
        return JobRow(
            row["id"], cast("JobKind", row["kind"]), cast("JobState", row["state"]), row["title"],
            json.loads(row["request"]), row["created"], row["started"], row["finished"],
            row["runs"], StageRow(**json.loads(stage)) if stage else None,
            tuple(figures.values()), row["error"],
            JobResult(**json.loads(result)) if result else None, row["log"] if whole else "",
        )  # fmt: skip
