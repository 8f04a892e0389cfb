"""The loop of a batch: jobs to a crew, one death survived, what others are at waited for."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from ..errors import require_number
from .crews import (
    Crew,
    Died,
    OnRay,
    Processes,
)
from .maker import Maker
from .making import Generating
from .place import place_of
from .prompts import Job, jobs_of
from .records import (
    CRASH,
    Outcome,
    failed,
    key_of,
    recorded,
    work,
)
from .summary import Summary, write_summary

Progress = Callable[[Outcome, int, int], None]
"""Called as a job is done, with what came of it, how many are done, and how many there are."""

PAUSE = 0.5
"""Seconds between two looks at jobs that another batch is at."""


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

    A job that fails, or that a budget does not allow, does not stop the others. An interrupted
    batch is gone on with by the same call. Processes are spawned, so a script calls this under
    ``if __name__ == "__main__":``.

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
    require_number("A batch needs workers", workers, least=1, most=1024, whole=True)
    jobs, make, folder = jobs_of(prompts, seed, variants), make or Generating(), Path(folder)
    place_of(folder)
    done: dict[Job, Outcome] = {}

    def told(outcome: Outcome) -> None:
        done[outcome.job] = outcome
        if progress is not None:
            progress(outcome, len(done), len(jobs))

    missing = [job for job in jobs if not _known(job, folder, make, retry, told)]
    if missing:
        width = min(workers, len(missing))
        crew: Crew = Processes(width) if ray is None else OnRay(ray, width)
        whole = False
        try:
            _work_off(deque(missing), crew, folder, make, retry, told)
            whole = True
        finally:
            crew.close(now=not whole)
    summary = Summary(tuple(done[job] for job in jobs))
    write_summary(summary, folder)
    return summary


def _known(
    job: Job, folder: Path, make: Maker, retry: bool, told: Callable[[Outcome], None]
) -> bool:
    """Tell what came of a job before, if it is done; return whether it is."""
    outcome = recorded(job, folder, key_of(job, make), retry)
    if outcome is not None:
        told(outcome)
    return outcome is not None


def _work_off(
    waiting: deque[Job],
    crew: Crew,
    folder: Path,
    make: Maker,
    retry: bool,
    told: Callable[[Outcome], None],
) -> None:
    """Have all jobs done.

    No more are given than are done at a time. So, where a process dies, it died of one of those;
    they are then done one by one, until it is known which.
    """
    given: dict[Any, Job] = {}
    suspects: deque[Job] = deque()
    busy: deque[Job] = deque()
    alone = False
    while waiting or suspects or busy or given:
        if not (waiting or suspects or given):
            time.sleep(PAUSE)
            waiting, busy = busy, deque()
        if not given:
            alone = bool(suspects)
        source, width = (suspects, 1) if alone else (waiting, crew.width)
        while source and len(given) < width:
            try:
                given[crew.give(partial(work, source[0], folder, make, retry))] = source[0]
            except Died:
                if given:  # of which one says so, too
                    break
                crew.renew()
            else:
                source.popleft()
        finished = crew.first(list(given))
        job = given.pop(finished)
        try:
            outcome = crew.result(finished)
        except Died as death:
            if death.certain or alone or crew.width == 1:
                told(failed(job, folder, key_of(job, make), str(death), CRASH, 0.0))
            else:
                suspects.extend((job, *given.values()))
            if not death.certain:
                given.clear()
                crew.renew()
            continue
        if alone and outcome.state == "there":  # it was made as another took its process along
            outcome = replace(outcome, state="made")
        if outcome.state == "busy":
            busy.append(job)
        else:
            told(outcome)
