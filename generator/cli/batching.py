"""The command that makes many scenes: ``batch``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from tyro.conf import Positional

from ..errors import InputError
from .choosing import USUAL, Chosen
from .printing import emit

if TYPE_CHECKING:
    from ..batch import Maker, Outcome, Summary


def batch(
    prompts: Positional[Path],
    /,
    *,
    out: Path,
    workers: int = 1,
    ray: str | None = None,
    route: Literal["generate", "compose"] = "generate",
    mix: Chosen = USUAL,
    seed: int = 0,
    variants: int = 1,
    retry: bool = False,
    calls: Path | None = None,
    json: bool = False,
) -> int:
    """Make many scenes into one folder, some at a time; the same command goes on where it ended.

    The same text and seed give the same bytes, however many workers there are. A text that cannot
    be made does not stop the others; the exit code is then 1. Several batches may share a folder.

    Args:
        prompts: A text or the path of a picture a line, # for remarks; or a .json array of texts,
            or of objects with text and seed.
        out: Folder the bundles go into, and summary.json.
        workers: How many scenes are made at a time, each by a process.
        ray: Address of a Ray cluster to make them instead, which shares the folder; "local" starts
            Ray here (pip install 'tabletopgen[ray]').
        route: All stages of the paper, or composed without drawing a picture first.
        mix: Who answers the questions about text and image; roles can differ from the rest.
        seed: Of each text.
        variants: How many seeds each text is made with, from its own on.
        retry: Try again what failed before by its text or its gate.
        calls: Folder where answers of servers are kept; as for generate.
        json: Print one JSON object instead of a table.
    """
    from .. import batch as batches
    from .paying import calls_folder

    make: Maker = batches.Composing()
    if route == "generate":
        mix.select()  # one that cannot answer is refused before anything is made
        make = batches.Generating(mix, calls=str(calls_folder(calls)))
    elif mix != USUAL:
        raise InputError("--route compose asks nobody; leave out --backend and the roles.")
    jobs = batches.jobs_of(batches.read_prompts(prompts, seed), variants=variants)
    try:
        with _progress(len(jobs), quiet=json) as shown:
            summary = batches.run(
                jobs, out, make, workers=workers, ray=ray, retry=retry, progress=shown
            )
    except KeyboardInterrupt:
        print("interrupted; what is made is kept, the same command goes on", file=sys.stderr)
        return 130
    if json:
        emit({"folder": str(out), **summary.facts()}, True, list)
    else:
        _print(summary, out)
    return 1 if summary.failures else 0


@contextmanager
def _progress(total: int, *, quiet: bool) -> Iterator[Callable[[Outcome, int, int], None] | None]:
    """Show how many are done on standard error, and each that failed."""
    if quiet:
        yield None
        return
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeElapsedColumn, TimeRemainingColumn

    console = Console(stderr=True, highlight=False, markup=False)
    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeElapsedColumn(),
               TimeRemainingColumn())  # fmt: skip
    with Progress(*columns, console=console) as bar:
        task = bar.add_task("scenes", total=total)

        def show(outcome: Outcome, done: int, _: int) -> None:
            bar.update(task, completed=done)
            if outcome.state == "failed":
                console.print(f"failed: {outcome.job.text[:60]!r}: {outcome.error}")

        yield show


def _print(summary: Summary, out: Path) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(file=sys.stdout, highlight=False, markup=False, emoji=False)
    counts = summary.counts()
    console.print(
        f"{out}: {counts['made']} made, {counts['there']} there already, {counts['failed']} failed",
        soft_wrap=True,
    )
    for kind, count in summary.kinds().items():
        console.print(f"  {count} {kind}")
    table = Table("gate", "mean", "most")
    for name, figures in summary.gate().items():
        table.add_row(name, f"{figures['mean']:g}", f"{figures['most']:g}")
    if table.row_count:
        console.print(table)
    for outcome in summary.failures:
        console.print(f"  failed: {outcome.job.text[:60]!r}: {outcome.error}", soft_wrap=True)
