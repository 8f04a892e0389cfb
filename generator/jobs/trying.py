"""Dry run of a batch."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from .making import Generating
from .prompts import Job, jobs_of
from .records import find_outcome, key_of
from .running import run
from .summary import Summary


def try_out(
    prompts: Iterable[str | Job],
    folder: str | Path,
    make: Generating,
    *,
    workers: int = 1,
    retry: bool = False,
) -> Summary:
    """Return what each scene would ask of servers first; nothing is sent, nor put into the folder.

    Those that are still to be made are begun by processes of this machine, elsewhere: one that
    would ask is "unpaid", with its calls as the error; one whose answers are all kept is "made".

    Args:
        prompts: texts, paths of pictures, or jobs, as ``run`` takes them.
        folder: where the bundles would go; need not be there.
        make: how they would be made.
        workers: how many are tried at a time.
        retry: also what failed before.
    """
    jobs, folder = jobs_of(prompts), Path(folder)
    known = {job: find_outcome(job, folder, key_of(job, make), retry) for job in jobs}
    left = [job for job, outcome in known.items() if outcome is None]
    if left:
        dry = replace(make, dry=True, shared_budget=None, budget=None)
        with tempfile.TemporaryDirectory(prefix="tabletopgen-dry-") as elsewhere:
            known |= {o.job: o for o in run(left, elsewhere, dry, workers=workers).outcomes}
    return Summary(tuple(outcome for job in jobs if (outcome := known[job]) is not None))
