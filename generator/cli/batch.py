"""The ``batch`` command, which makes many scenes."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tyro.conf import OmitArgPrefixes, Positional, arg

from ..backends.paid_run import calls_folder, roles_of
from ..errors import InputError, escape, require_number, require_seed
from ..io.files import check_folder
from ..jobs.pools import PoolOptions
from .output import emit
from .paid_options import NO_CALLS, USUAL, Calls, Chosen, lines_of

if TYPE_CHECKING:
    from ..backends import Backends
    from ..jobs import Generating, Maker, Outcome, Summary


_POOL = PoolOptions()


def batch(
    prompts: Annotated[Positional[Path], arg(metavar="PROMPTS")],
    /,
    *,
    out: Path,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
    route: Literal["generate", "compose"] = "generate",
    mix: Chosen = USUAL,
    seed: int = 0,
    variants: int = 1,
    retry: bool = False,
    calls: Calls = NO_CALLS,
    json: bool = False,
) -> int:
    """Make many scenes in one folder, in parallel; rerun the same command to resume.

    The same text and seed produce identical bytes, regardless of the number of workers. A failed
    text does not stop the others; the exit code is then 1. Several batches may share a folder.
    Scenes beyond the budget are skipped without counting as failures: run the command again with a
    larger budget. The exit code is 3 if only such scenes are missing.

    Args:
        prompts: File with one text or picture path per line (# starts a comment), or a .json array
            of texts or of objects with text and seed.
        out: Folder for the bundles and summary.json; shared by all machines of a Ray cluster.
        pool: Workers that make the scenes.
        route: Run all stages of the paper, or compose without drawing a picture first.
        mix: Backends for text and images, which can differ per role.
        seed: Seed of each text.
        variants: Number of consecutive seeds per text, from its own seed.
        retry: Also retry scenes that failed because of their text or their gate.
        calls: Cost limit of server requests, and the cache of their responses.
        json: Print a JSON object instead of a table.
    """
    from .. import jobs as batches

    require_seed(seed)
    check_folder(out)
    jobs = batches.jobs_of(batches.read_prompts(prompts, seed), variants=variants)
    make: Maker = batches.Composing()
    asks: Backends | None = None
    if route == "generate":
        asks = mix.select()  # fail before any work if a backend is unavailable
        folder = calls_folder(calls.calls).absolute()
        make = batches.Generating(mix, calls=str(folder), prices=calls.table())
    elif mix != USUAL or calls.budget is not None or calls.dry_run:
        raise InputError(
            "--route compose uses no backends; remove --backend, the options of single roles, "
            "--budget and --dry-run."
        )
    if calls.budget is not None:
        require_number("--budget", calls.budget, minimum=0)
    if calls.dry_run and isinstance(make, batches.Generating) and asks is not None:
        tried = partial(batches.try_out, jobs, out, make, workers=pool.workers, retry=retry)
        return _try(make, asks, tried, json)
    if isinstance(make, batches.Generating) and asks is not None and asks.asks_servers():
        shared = batches.shared_budget(out, make.prices)
        make = replace(make, shared_budget=shared, budget=calls.budget)
    try:
        with _progress(len(jobs), quiet=json) as shown:
            summary = batches.run(
                jobs, out, make, workers=pool.workers, ray=pool.ray, retry=retry, progress=shown
            )
    except KeyboardInterrupt:
        print(
            "interrupted; partial results are kept, rerun the same command to resume",
            file=sys.stderr,
        )
        return 130
    spent = _spending(make)
    if json:
        emit({"folder": str(out), **spent, **summary.facts()}, True, list)
    else:
        _print(summary, out, spent)
    if summary.failures:
        return 1
    return 3 if summary.unpaid else 0


def _spending(make: Maker) -> dict[str, Any]:
    """Return the spending of a maker's shared budget in all runs, or {} if it has none."""
    shared = getattr(make, "shared_budget", None)
    if shared is None:
        return {}
    total, budget = shared.total(), getattr(make, "budget", None)
    facts = {"currency": total.currency, "unpriced": total.unpriced, "budget": budget}
    return {"spent": {"money": round(total.money, 6), **facts}}


def _try(make: Generating, backends: Backends, tried: Callable[[], Summary], as_json: bool) -> int:
    """Print the backends and the first calls of each scene; return the exit code."""
    roles = roles_of(make.mix, backends)
    rows: list[dict[str, Any]] = []
    if backends.asks_servers():
        for o in tried().outcomes:
            shown = (o.error or "").splitlines() if o.state in ("unpaid", "failed") else []
            state = {"unpaid": "to ask", "made": "nothing to ask"}.get(o.state, o.state)
            rows.append({"text": o.job.text, "seed": o.job.seed, "state": state, "calls": shown})

    def lines() -> list[str]:
        shown = lines_of(roles)
        for r in rows:
            shown.append(f"{r['text'][:60]!r}, seed {r['seed']}: {r['state']}")
            shown += [f"  {call}" for call in r["calls"]]
        rest = "Nothing was sent; later calls depend on the answers."
        return [*shown, rest if rows else "No server is called."]

    emit({"backends": roles, "dry_run": rows}, as_json, lines)
    return 0


@contextmanager
def _progress(total: int, *, quiet: bool) -> Iterator[Callable[[Outcome, int, int], None] | None]:
    """Show progress on standard error, and a line for each failed scene."""
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
                console.print(escape(f"failed: {outcome.job.text[:60]!r}: {outcome.error}"))

        yield show


def _print(summary: Summary, out: Path, spent: Mapping[str, Any]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(file=sys.stdout, highlight=False, markup=False, emoji=False)
    counts = summary.counts()
    left = f", {counts['unpaid']} beyond the budget" if counts["unpaid"] else ""
    shown = f"{counts['made']} made, {counts['there']} already done, {counts['failed']} failed"
    console.print(escape(f"{out}: {shown}{left}"), soft_wrap=True)
    if spent:
        paid = spent["spent"]
        currency = escape(paid["currency"])
        most = "" if paid["budget"] is None else f" of {paid['budget']:g}"
        unknown = f", and {paid['unpriced']} calls of unknown price" if paid["unpriced"] else ""
        console.print(f"  spent in all runs: {paid['money']:.4f}{most} {currency}{unknown}")
    for kind, count in summary.kinds().items():
        console.print(escape(f"  {count} {kind}"))
    table = Table("gate", "mean", "most")
    for name, figures in summary.gate().items():
        table.add_row(escape(name), f"{figures['mean']:g}", f"{figures['most']:g}")
    if table.row_count:
        console.print(table)
    for outcome in (*summary.failures, *summary.unpaid):
        how = "failed" if outcome.state == "failed" else "not made"
        text = escape(f"  {how}: {outcome.job.text[:60]!r}: {outcome.error}")
        console.print(text, soft_wrap=True)
