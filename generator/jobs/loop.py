"""Dry runs of a batch, and its main loop, which survives worker crashes and concurrent batches."""

from __future__ import annotations

import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import replace
from pathlib import Path

from ..errors import require_number
from .pools import pool_of
from .prompts import Job, Maker, jobs_of
from .records import CRASH, Outcome, find_outcome, key_of, place_of, record_failure, work
from .summary import Summary, write_summary
from .task_pool import TaskPool
from .work import Generating
from .workers import WorkerDied

_PAUSE = 0.5  # seconds between checks of jobs that another batch has locked

_GRACE = 10.0  # grace period of interrupted workers in seconds, longer than a session's ``grace``


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
    progress: Callable[[Outcome, int, int], None] | None = None,
) -> Summary:
    """Make many scenes in one folder; existing scenes are not made again.

    A job that fails, or that exceeds a budget, does not stop the others. The same call resumes an
    interrupted batch.

    Args:
        prompts: texts, paths of pictures, or jobs with their own seeds.
        folder: folder for the bundles and ``summary.json``; created if missing.
        make: the maker of the scenes; None means ``Generating()``.
        workers: number of parallel jobs, each on one thread unless OMP_NUM_THREADS is set.
        ray: address of a Ray cluster; "local" starts one on this machine. None uses processes.
        seed: seed of each text.
        variants: number of consecutive seeds per text, from its own seed.
        retry: also retry jobs that failed because of their gate or their text. Other failures are
            always retried.
        progress: called after each job with its outcome, the number of finished jobs and the total
            number.

    Returns:
        The outcome of each job, in order, and statistics of the gates.

    Raises:
        InputError: no jobs, or a number out of range.
        BackendError: Ray is not available.
        StorageError: the folder is not writable, or the disk is full.
    """
    require_number("workers", workers, minimum=1, maximum=1024, integer=True)
    jobs, make, folder = jobs_of(prompts, seed, variants), make or Generating(), Path(folder)
    place_of(folder)
    done: dict[Job, Outcome] = {}

    def report(outcome: Outcome) -> None:
        done[outcome.job] = outcome
        if progress is not None:
            progress(outcome, len(done), len(jobs))

    missing = deque[Job]()
    for job in jobs:
        if (outcome := find_outcome(job, folder, key_of(job, make), retry)) is None:
            missing.append(job)
        else:
            report(outcome)
    if missing:
        pool, make = _pool(min(workers, len(missing)), ray, make)
        grace = _GRACE
        try:
            _run_all(missing, pool, folder, make, retry, report)
            grace = 0.0
        finally:
            pool.close(grace)
    summary = Summary(tuple(done[job] for job in jobs))
    write_summary(summary, folder)
    return summary


def try_out(
    prompts: Iterable[str | Job],
    folder: str | Path,
    make: Generating,
    *,
    workers: int = 1,
    retry: bool = False,
) -> Summary:
    """Return each scene's first server calls without sending them or writing to ``folder``.

    Unfinished scenes are started by local processes in a temporary folder. A scene that needs a
    call is "unpaid", with its calls as the error; a scene whose answers are all stored is "made".
    ``folder``, the batch's folder, need not exist. The arguments are those of ``run``.
    """
    jobs, folder = jobs_of(prompts), Path(folder)
    known = {job: find_outcome(job, folder, key_of(job, make), retry) for job in jobs}
    left = [job for job, outcome in known.items() if outcome is None]
    if left:
        dry = replace(make, dry=True, shared_budget=None, budget=None)
        with tempfile.TemporaryDirectory(prefix="tabletopgen-dry-") as elsewhere:
            known |= {o.job: o for o in run(left, elsewhere, dry, workers=workers).outcomes}
    return Summary(tuple(outcome for job in jobs if (outcome := known[job]) is not None))


def _pool(width: int, ray: str | None, make: Maker) -> tuple[TaskPool, Maker]:
    """Return the worker pool and the scene maker; on Ray, one process owns the maker's database."""
    if ray is None:
        return pool_of(width), make
    from .on_ray import RayPool

    pool = RayPool(ray, width)
    kept_by = getattr(make, "kept_by", None)
    return pool, make if kept_by is None else kept_by(pool.keeper)


def _run_all(
    waiting: deque[Job],
    pool: TaskPool,
    folder: Path,
    make: Maker,
    retry: bool,
    told: Callable[[Outcome], None],
) -> None:
    """Run all jobs, up to ``pool.width`` of them in parallel.

    If one of several workers dies, its job runs once more at the end, alone, because other jobs may
    have exhausted its memory. Jobs locked by other batches are checked repeatedly.
    """
    running: dict[Future[Outcome], Job] = {}
    crashed, busy = deque[Job](), deque[Job]()
    while waiting or crashed or busy or running:
        if not (waiting or crashed or running):
            time.sleep(_PAUSE)
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
            if alone and outcome.state == "there":  # it was published just before its process died
                outcome = replace(outcome, state="made")
            if outcome.state == "busy":
                busy.append(job)
            else:
                told(outcome)
