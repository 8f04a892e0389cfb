"""Play fixed suites of held-out tables, compare results, make the leaderboard."""

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
    """List the suites, with their tables, what is to be done there, and episodes."""
    from .suites import VERSION, find_suite, names, tasks

    rows = [("suite", "tables", "instances", "episodes")]
    for suite in map(find_suite, names()):
        things = sum(len(table.solvable) for table in suite.tables)
        rows.append((suite.name, f"{len(suite.tables)}", f"{things}", f"{len(suite.episodes())}"))
    _show(rows)
    print(f"Version {VERSION}. To train at: {', '.join(f'{t.lower()}-train' for t in tasks())}.")
    return 0


@app.command(name="make")
def make_tables(
    suites: Annotated[Positional[tuple[str, ...]], arg(metavar="SUITE [SUITE ...]")],
    /,
    *,
    out: Path | None = None,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
) -> int:
    """Make the tables of suites again, bit for bit, with their certificates.

    Tables that are there are kept, so an interrupted command resumes. A table that is made as
    another one than the suite says is an error: other versions of some packages make other tables.

    Args:
        suites: Names of suites; "all" for those of all tasks.
        out: Folder the bundles go into; if left out, bench in the user cache, where "run" looks for
            them and no search by name does.
        pool: Who makes them.
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
    """Play suites and write a result file for each.

    The policy's own settings decide what it sees and how it moves the robot; tables, targets,
    goals, randomisation, control rate, time limit and seeds are the suite's. A killed run resumes
    when it is run again. Two runs write the same bytes.

    Args:
        policy: "random", "zero", "expert", the name of a shipped policy, a policy file, a training
            run's folder, or module:function, a function that returns an object with
            predict(observation, deterministic=True).
        suite: Names of suites: lift-test, lift-test-random, lift-validation ...; of a file of your
            own FILE:test.
        out: Folder the results go into.
        name: What the policy is called in the results; its own name if left out.
        tables: Folder of the tables, made there if they are missing; if left out, bench in the user
            cache.
        pool: Who plays.
        pictures: What is kept of episodes that fail.
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
                f"{path}: {result.player.name} solved {result.solved} of {len(result.episodes)} at "
                f"{result.suite}, {100 * result.share:.1f} % ({low:.1f} to {high:.1f} %)"
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
    """Check results: their figures, and some of their episodes, which are played again.

    A result with impossible figures is not played. If its episodes end as it says, to the step and
    within 0.0001 of the reward, it gets a mark, RESULT.replayed beside it, which the leaderboard
    shows; a mark of more episodes is kept. If one differs, it loses the mark. Other versions of
    packages, and other kinds of processors, may play an episode differently. The exit code is 1 if
    a result fails.

    Args:
        results: Files that "run" wrote.
        episodes: How many of each result's episodes are played, drawn at random.
        seed: What draws them; another one each time if left out.
        policy: Who plays, if the result's policy is a file or a function; see "run".
        suite: The suite of results of a file of your own, FILE:test.
        tables: Folder of the tables, made there if they are missing; if left out, bench in the user
            cache.
        pool: Who makes missing tables.
    """
    from .audit.command import Check, check_result

    if not results:
        raise InputError("Name at least one result to check.")
    check = Check(episodes, seed, policy, suite, tables, pool)
    passed = [check_result(path, check) for path in results]
    return 0 if all(passed) else 1


@app.command(name="compare")
def compare_results(
    results: Annotated[Positional[tuple[Path, ...]], arg(metavar="RESULT [RESULT ...]")], /
) -> int:
    """Compare results of one suite with the first, on the same episodes.

    The difference is in points of per cent, with the 95 % interval of paired shares; gained are
    episodes that the first did not solve, lost those that only it did.

    Args:
        results: Files that "run" wrote.
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
    """Make the leaderboard of the results in a folder, as Markdown.

    Args:
        folder: Folder of files that "run" wrote, of test suites.
        out: The page to write; it is printed if left out.
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
    """Return the suites of names, each once."""
    from .suites import find_suite
    from .suites import names as known

    wanted = list(names)
    if not wanted:
        raise InputError("Name at least one suite; `tabletopgen bench list` shows what there is.")
    every = [name for given in wanted for name in (known() if given == "all" else [given])]
    return [find_suite(name) for name in dict.fromkeys(every)]


def _show(rows: Sequence[tuple[str, ...]]) -> None:
    """Print rows as a table, their head first."""
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
    """Show what is done on standard error."""
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
