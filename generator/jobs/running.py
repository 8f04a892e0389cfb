"""The loop of a batch: survives worker crashes, waits for scenes locked by other runs."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

from ..errors import require_number
from .maker import Maker
from .making import Generating
from .place import place_of
from .prompts import Job, jobs_of
from .records import CRASH, Outcome, find_outcome, key_of, record_failure, work
from .summary import Summary, write_summary
from .workers import WorkerDied, WorkerPool

Progress = Callable[[Outcome, int, int], None]
"""Called as a job is done, with what came of it, how many are done, and how many there are."""

PAUSE = 0.5
"""Seconds between two looks at jobs that another batch is at."""

GRACE = 10.0
"""Seconds that interrupted workers have to end: more than a session's ``grace``."""


class Pool(Protocol):
    """Runs tasks elsewhere: a ``WorkerPool``, or Ray."""

    width: int
    """Number of tasks at a time."""

    def submit(self, function: Callable[..., Any], *args: Any) -> Future[Any]:
        """Have a function called; ``WorkerDied`` says that its process ended."""
        ...

    def close(self, grace: float = 0.0) -> None:
        """End, whatever is running; ``grace`` is for tasks to end by themselves, in seconds."""
        ...


def run(
    prompts: Iterable[str | Job],
    folder: str | Path,
    make: Maker | None = None,
    *,
    workers: int = 1,
    ray: str | None = None,
    seed: int = 0,
    variants: int = 1,
    retry: bool = False,
    progress: Progress | None = None,
) -> Summary:
    """Make many scenes into one folder; what is there already is not made again.

    A job that fails, or that a budget does not allow, does not stop the others. The same call
    resumes an interrupted batch.

    Args:
        prompts: texts, paths of pictures, or jobs with seeds of their own.
        folder: where the bundles go, made if missing; ``summary.json`` is written there, too.
        make: how scenes are made; None is ``Generating()``.
        workers: how many are made at a time, each on one thread unless OMP_NUM_THREADS is set.
        ray: address of a Ray cluster that makes them; "local" starts one here. None: processes.
        seed: of each text.
        variants: how many seeds each text is made with, from its own on.
        retry: try again what failed as its gate or its text had it. Other failures always are.
        progress: called as each job is done.

    Returns:
        What came of each job, in their order, and the figures of their gates.

    Raises:
        InputError: no jobs, or a number out of range.
        BackendError: no Ray.
        StorageError: the folder cannot be written, or the disk is full.
    """
    require_number("A batch needs workers", workers, minimum=1, maximum=1024, integer=True)
    jobs, make, folder = jobs_of(prompts, seed, variants), make or Generating(), Path(folder)
    place_of(folder)
    done: dict[Job, Outcome] = {}

    def report(outcome: Outcome) -> None:
        done[outcome.job] = outcome
        if progress is not None:
            progress(outcome, len(done), len(jobs))

    missing = [job for job in jobs if not _known(job, folder, make, retry, report)]
    if missing:
        pool, make = _pool(min(workers, len(missing)), ray, make)
        grace = GRACE
        try:
            _run_all(deque(missing), pool, folder, make, retry, report)
            grace = 0.0
        finally:
            pool.close(grace)
    summary = Summary(tuple(done[job] for job in jobs))
    write_summary(summary, folder)
    return summary


def _known(
    job: Job, folder: Path, make: Maker, retry: bool, told: Callable[[Outcome], None]
) -> bool:
    """Tell what came of a job before, if it is done; return whether it is."""
    outcome = find_outcome(job, folder, key_of(job, make), retry)
    if outcome is not None:
        told(outcome)
    return outcome is not None


def _pool(width: int, ray: str | None, make: Maker) -> tuple[Pool, Maker]:
    """Return who runs the tasks, and the maker, whose money one process of several keeps."""
    if ray is None:
        return WorkerPool(width), make
    from .on_ray import RayPool

    pool = RayPool(ray, width)
    kept_by = getattr(make, "kept_by", None)
    return pool, make if kept_by is None else kept_by(pool.keeper)


def _run_all(
    waiting: deque[Job],
    pool: Pool,
    folder: Path,
    make: Maker,
    retry: bool,
    told: Callable[[Outcome], None],
) -> None:
    """Run all jobs, at most as many as the pool is wide at a time.

    Where a worker of several dies, its job is run once more at the end, alone: another may have
    taken its memory. Jobs that other batches have locked are looked at again and again.
    """
    running: dict[Future[Outcome], Job] = {}
    crashed, busy = deque[Job](), deque[Job]()
    while waiting or crashed or busy or running:
        if not (waiting or crashed or running):
            time.sleep(PAUSE)
            waiting, busy = busy, deque()
        alone = not waiting and not running and bool(crashed)
        source = crashed if alone else waiting
        while source and len(running) < (1 if alone else pool.width):
            job = source.popleft()
            running[pool.submit(work, job, folder, make, retry)] = job
        for done in wait(running, return_when=FIRST_COMPLETED).done:
            job = running.pop(done)
            try:
                outcome = done.result()
            except WorkerDied as death:
                if alone or pool.width == 1:
                    told(record_failure(job, folder, key_of(job, make), str(death), CRASH, 0.0))
                else:
                    crashed.append(job)
                continue
            if alone and outcome.state == "there":  # published as its process died
                outcome = replace(outcome, state="made")
            if outcome.state == "busy":
                busy.append(job)
            else:
                told(outcome)
