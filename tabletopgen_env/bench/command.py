"""Run fixed suites, compare and check results, and write the leaderboard."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro
from tyro.conf import OmitArgPrefixes, Positional, arg

from generator.errors import InputError, escape
from generator.io.files import check_target, write_whole
from generator.jobs.pools import PoolOptions

from .episode import FailurePictures

if TYPE_CHECKING:
    from .instances import Suite
    from .run import Report

app = tyro.extras.SubcommandApp()

_POOL, _PICTURES = PoolOptions(), FailurePictures()
_SUITES = "[SUITE ...]"


@app.command(name="list")
def list_suites() -> int:
    """List the suites with their tables, instances and episodes."""
    from .suites import VERSION, find_suite, names, tasks

    rows = [("suite", "tables", "instances", "episodes")]
    for suite in map(find_suite, names()):
        things = sum(len(table.solvable) for table in suite.tables)
        rows.append((suite.name, f"{len(suite.tables)}", f"{things}", f"{len(suite.episodes())}"))
    _show(rows)
    print(
        f"Version {VERSION}. Training tables: {', '.join(f'{t.lower()}-train' for t in tasks())}."
    )
    return 0


@app.command(name="make")
def make_tables(
    suites: Annotated[Positional[tuple[str, ...]], arg(metavar="SUITE [SUITE ...]")],
    /,
    *,
    out: Path | None = None,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
) -> int:
    """Generate the tables of suites, bit for bit, with their certificates.

    Existing tables are kept, so an interrupted command can be resumed. It is an error if a
    generated table differs from the suite's: other versions of some packages generate other tables.

    Args:
        suites: Names of suites; "all" for the suites of all tasks.
        out: Folder for the bundles; by default bench in the user cache, where "run" looks for them.
            Searches for bundles by name do not include this folder.
        pool: Worker processes that generate the tables.
    """
    from .tables import make_tables as make

    chosen = [suite for suite in _find(suites) if suite.condition == "plain"]
    with _progress() as report:
        for suite in chosen:
            with closing(make(suite.of, suite.tables, out, pool)) as made:
                for number, path in enumerate(made, start=1):
                    report(f"tables of {suite.name}", number, len(suite.tables))
                    print(escape(f"{path}"), flush=True)
    return 0


@app.command(name="run")
def run_policy(
    policy: Annotated[Positional[str], arg(metavar="POLICY")],
    /,
    *,
    suite: tuple[str, ...],
    out: Path = Path("bench"),
    name: str | None = None,
    tables: Path | None = None,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
    pictures: OmitArgPrefixes[FailurePictures] = _PICTURES,
) -> int:
    """Evaluate a policy on suites and write a result file for each.

    The policy's own settings determine its observations and actions. The suite determines tables,
    targets, goals, randomisation, control rate, time limit and seeds. Run the command again to
    resume an interrupted run. Repeated runs write identical files.

    Args:
        policy: "random", "zero", "expert", the name of a shipped policy, a policy file, a training
            run's folder, or module:function, a function that returns an object with
            predict(observation, deterministic=True).
        suite: Names of suites: lift-test, lift-test-random, lift-validation ...; for your own file,
            FILE:test.
        out: Folder for the results.
        name: Name of the policy in the results; its own name by default.
        tables: Folder of the tables, where missing ones are generated; by default bench in the user
            cache.
        pool: Worker processes that run the episodes.
        pictures: Pictures of failed episodes.
    """
    from .results import read_result
    from .run import BenchRun, run_suite

    run = BenchRun(out, name, tables, pool, pictures)
    for chosen in _find(suite):
        with _progress() as report:
            path = run_suite(chosen, policy, run, report)
        result = read_result(path)
        low, high = (100 * bound for bound in result.interval)
        print(
            escape(
                f"{path}: {result.player.name} solved {result.solved} of "
                f"{len(result.episodes)} on {result.suite},  {100 * result.share:.1f} % "
                f"({low:.1f} to {high:.1f} %)"
            ),
            flush=True,
        )
    return 0


@app.command(name="check")
def check_results(
    results: Annotated[Positional[tuple[Path, ...]], arg(metavar="RESULT [RESULT ...]")],
    /,
    *,
    episodes: int = 5,
    seed: int | None = None,
    policy: str | None = None,
    suite: str | None = None,
    tables: Path | None = None,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
) -> int:
    """Check results: their figures, and a replay of some of their episodes.

    A result with impossible figures is not replayed. If all replayed episodes end as listed, with
    the same number of steps and a reward within 0.0001, the result gets a mark, RESULT.replayed
    beside it, which the leaderboard shows; an existing mark for more episodes is kept. If an
    episode differs, the mark is removed. Other package versions and other processors can cause
    differences. The exit code is 1 if a result fails.

    Args:
        results: Files written by "run".
        episodes: Number of episodes to replay per result, chosen at random.
        seed: Seed of this choice; a different choice each time by default.
        policy: Player of the replay, if the result's policy is a file or a function; see "run".
        suite: Suite of results from your own file, FILE:test.
        tables: Folder of the tables, where missing ones are generated; by default bench in the user
            cache.
        pool: Worker processes that generate missing tables.
    """
    from .audit.command import Check, check_result

    if not results:
        raise InputError("Specify at least one result to check.")
    check = Check(episodes, seed, policy, suite, tables, pool)
    passed = [check_result(path, check) for path in results]
    return 0 if all(passed) else 1


@app.command(name="compare")
def compare_results(
    results: Annotated[Positional[tuple[Path, ...]], arg(metavar="RESULT [RESULT ...]")], /
) -> int:
    """Compare results of one suite with the first result, on the same episodes.

    The difference is in percentage points, with the 95 % interval for paired shares. Gained
    episodes are solved by the result but not by the first one, lost episodes only by the first one.

    Args:
        results: Files written by "run".
    """
    from .comparison import compare
    from .results import read_result

    read = [read_result(path) for path in results]
    _show(compare(read))
    return 0


@app.command(name="leaderboard")
def make_leaderboard(
    folder: Annotated[Positional[Path], arg(metavar="DIR")], /, *, out: Path | None = None
) -> int:
    """Write the leaderboard of the results in a folder, as Markdown.

    Args:
        folder: Folder of result files written by "run", on test suites.
        out: Page to write; printed by default.
    """
    from .leaderboard import page, read_results

    if out is not None:
        check_target(out)
    text = page(read_results(folder))
    if out is None:
        print(text, end="")
    else:
        write_whole(out, text, "The leaderboard", "Choose another --out.")
    return 0


def _find(names: Iterable[str]) -> list[Suite]:
    """Return the suites with these names, without duplicates."""
    from .suites import find_suite
    from .suites import names as known

    wanted = list(names)
    if not wanted:
        raise InputError("Specify at least one suite; `tabletopgen bench list` lists them.")
    every = [name for given in wanted for name in (known() if given == "all" else [given])]
    return [find_suite(name) for name in dict.fromkeys(every)]


def _show(rows: Sequence[tuple[str, ...]]) -> None:
    """Print rows as a table; the first row is the header."""
    from rich.console import Console
    from rich.table import Table

    head, *others = rows
    shown = Table(*head, box=None, pad_edge=False)
    for row in others:
        shown.add_row(*map(escape, row))
    wide = sum(max(len(row[k]) for row in rows) + 2 for k in range(len(head)))
    Console(file=sys.stdout, highlight=False, markup=False, width=max(wide, 80)).print(shown)


@contextmanager
def _progress() -> Iterator[Report]:
    """Report progress on standard error."""
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeElapsedColumn, TimeRemainingColumn

    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeElapsedColumn(),
               TimeRemainingColumn())  # fmt: skip
    with Progress(*columns, console=Console(stderr=True, highlight=False, markup=False)) as bar:
        known: dict[str, Any] = {}

        def report(what: str, done: int, total: int) -> None:
            if what not in known:
                known[what] = bar.add_task(what, total=total)
            bar.update(known[what], completed=done)

        yield report
