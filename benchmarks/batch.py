"""Scenes per minute with ``generator.jobs``, one worker against several; checks for equal bytes.

    python benchmarks/batch.py --cases 40
    python benchmarks/batch.py --cases 40 --route compose --ray local

Generates the first texts of ``benchmarks/table78.json`` with one worker, then with ``--workers``,
each time into a new folder, and measures wall-clock time including process startup. A worker
computes on one thread; the last row is one worker on all processors, like ``generate`` without a
batch. Writes the table to ``batch_<route>.md``. If the folders do not contain the same bundles, the
exit code is 1. Run it alone on the machine; ``--note`` is added to the table's head, for instance
if it was not.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from posing import tables

from generator import jobs as batch
from generator.threads import cores

HERE = Path(__file__).parent


class BatchRun(NamedTuple):
    """One batch: its workers, its duration, and its bundles."""

    who: str
    workers: int
    threads: int
    seconds: float
    made: int
    bundles: frozenset[str]


def time_batch(
    texts: Sequence[str], make: batch.Maker, workers: int, ray: str | None = None, threads: int = 1
) -> BatchRun:
    """Make a batch in a new folder, which is removed afterwards; return its measurements."""
    os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = str(threads)
    with tempfile.TemporaryDirectory(prefix="tabletopgen-batch-") as folder:
        start = time.perf_counter()
        summary = batch.run(texts, folder, make, workers=workers, ray=ray)
        seconds = time.perf_counter() - start
    bundles = frozenset(o.bundle for o in summary.outcomes if o.bundle)
    who = "processes" if ray is None else f"Ray ({ray})"
    return BatchRun(who, workers, threads, seconds, summary.counts()["made"], bundles)


def table(runs: Sequence[BatchRun], head: str) -> str:
    """Return the runs as Markdown, each compared with the first."""
    rows = [
        f"| {r.who} | {r.workers} | {r.threads} | {r.made} | {r.seconds:.1f} | "
        f"{60 * r.made / r.seconds:.1f} | {runs[0].seconds / r.seconds:.2f} | "
        f"{'yes' if r.bundles == runs[0].bundles else 'NO'} |"
        for r in runs
    ]
    titles = (
        "| by | workers | threads each | scenes | seconds | scenes per minute | speedup | same "
        "bytes |"
    )
    return "\n".join([head, "", titles, "|---|---|---|---|---|---|---|---|", *rows, ""])


def main() -> int:
    """Time the batches, print and write the table; return 1 if the bundles differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--texts", type=Path, default=HERE / "table78.json")
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--route", choices=("generate", "compose"), default="generate")
    parser.add_argument("--ray", help="also run on Ray at this address")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    parser.add_argument("--note", default="")
    args = parser.parse_args()

    texts = tables.texts_in(args.texts)[: args.cases]
    make = batch.Composing() if args.route == "compose" else batch.Generating()
    runs = [time_batch(texts, make, 1), time_batch(texts, make, args.workers)]
    if args.ray is not None:
        runs.append(time_batch(texts, make, args.workers, args.ray))
    runs.append(time_batch(texts, make, 1, threads=cores()))
    head = f"`{tables.command_line('--out', '--note')}`, {tables.where()}. {args.note}".rstrip()
    text = table(runs, head)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / f"batch_{args.route}.md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if len({r.bundles for r in runs}) == 1 else 1


if __name__ == "__main__":
    raise SystemExit(main())
