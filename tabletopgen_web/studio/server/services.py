"""Components of the studio that its endpoints share."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from starlette.requests import Request

from generator.errors import BackendError, StorageError
from generator.io.files import remove_tree

from ...study.page_data import StudyPage
from ..contracts import JobRow
from ..folder import StudioFolder
from ..library.answers import AnswerBook
from ..library.pictures import PictureShelf
from ..library.scenes import SceneLibrary
from ..queue.jobs import JobStore
from ..queue.process import JobProcess
from ..queue.runner import Runner
from ..specs import GenerateSpec, JobSpec, read_spec, scene_of
from ..work.order import JobOrder
from .changes import Changes

_MAX_ESTIMATE = 180.0  # seconds
_MAX_CLIENTS = 64  # maximum number of event listeners


@dataclass(eq=False)
class StudioServices:
    """The components of a running studio, which its endpoints share.

    Attributes:
        files: the files of the page by URL path.
        studies: the pages of served studies by study.
    """

    folder: StudioFolder
    workers: int
    files: Mapping[str, Path]
    store: JobStore
    changes: Changes = field(default_factory=Changes)
    studies: Mapping[str, StudyPage] = field(default_factory=dict)
    uploads: asyncio.Semaphore = field(default_factory=lambda: asyncio.Semaphore(2))
    writing: asyncio.Lock = field(default_factory=asyncio.Lock)
    estimates: asyncio.Semaphore = field(default_factory=lambda: asyncio.Semaphore(1))
    listeners: asyncio.Semaphore = field(default_factory=lambda: asyncio.Semaphore(_MAX_CLIENTS))

    def __post_init__(self) -> None:
        self.scenes = SceneLibrary(self.folder)
        self.pictures = PictureShelf(self.folder.pictures)
        self.answers = AnswerBook(self.folder.answers)
        self.runner = Runner(self.store, self.make_order, self.workers)
        self.store.changed = self._notify
        self.store.dropped = self._remove_files

    def sweep(self) -> None:
        """Remove files of deleted jobs, and outdated views; errors are ignored."""
        self.scenes.sweep()
        jobs = self.store.list_jobs()
        self.pictures.sweep({job.request["picture"] for job in jobs if "picture" in job.request})
        folders = (self.folder.figures, self.folder.files)
        kept = {path.name for folder in folders for path in folder.iterdir()}
        self._remove_files(kept - {job.id for job in jobs})

    def make_order(self, job: JobRow) -> Mapping[str, Any]:
        """Return the JSON values of the ``JobOrder`` for a job's process.

        Raises:
            TabletopError: the job's input scene or picture no longer exists.
        """
        return self._order(job.kind, job.request, job.id)

    def check_begins(self, spec: JobSpec) -> None:
        """Check that the job's input scene or picture exists.

        Raises:
            RefusedError: the input does not exist.
        """
        if (scene := scene_of(spec)) is not None:
            self.scenes.find(scene)
        if isinstance(spec, GenerateSpec) and spec.picture is not None:
            self.pictures.path(spec.picture)

    async def estimate(self, request: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the requests that a job would send to servers, from a dry run in another process.

        Raises:
            TabletopError: the job is invalid, or the dry run fails.
        """
        messages: dict[str, Any] = {}

        def hear(message: dict[str, Any]) -> None:
            messages[message["type"]] = message

        async with self.estimates:
            process = JobProcess(self._order("estimate", request, "estimate"), hear)
            ending = await process.run(_MAX_ESTIMATE)
        if "result" in messages:
            return {k: v for k, v in messages["result"].items() if k != "type"}
        reason = messages.get("error", {}).get("message")
        raise BackendError(reason or ending.describe())

    def _order(self, kind: str, request: Mapping[str, Any], job: str) -> Mapping[str, Any]:
        spec = read_spec(request)
        scene = scene_of(spec)
        picture = spec.picture if isinstance(spec, GenerateSpec) else None
        return JobOrder(
            kind, request, self.folder.scenes, self.folder.figures / job, self.folder.files / job,
            None if scene is None else self.scenes.find(scene)[0],
            None if picture is None else self.pictures.path(picture),
        ).plain()  # fmt: skip

    def _remove_files(self, jobs: Iterable[str]) -> None:
        """Remove figures and files of jobs; errors are ignored."""
        for job in jobs:
            for folder in (self.folder.figures, self.folder.files):
                with contextlib.suppress(StorageError):
                    remove_tree(folder, job)

    def _notify(self) -> None:
        self.changes.notify()
        self.runner.wake()


def services_of(request: Request) -> StudioServices:
    """Return the studio's shared components, given a request."""
    return request.app.state.services
