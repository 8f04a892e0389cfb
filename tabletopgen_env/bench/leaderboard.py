"""The leaderboard page, made from committed results; the same results give the same page."""

from __future__ import annotations

import dataclasses
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from generator.errors import InputError

from .audit.figures import check_suite, doubts
from .audit.marks import read_mark
from .comparison import percent, span
from .instances import RANDOM, Suite
from .players import PlayerFacts
from .results import BenchResult, read_result
from .suites import VERSION, find_suite, shipped_suites, tasks

HEAD = f"""\
# TabletopBench {VERSION}
`tabletopgen bench leaderboard benchmarks/results/bench --out benchmarks/results/leaderboard.md`

Success rates on each test suite in per cent, with Wilson's 95 % interval (which treats episodes as
independent) and the number of episodes. *Plain* episodes start from the table as generated,
*random* ones with randomisation; *easy*, *medium* and *hard* are the suite's tables by difficulty.
Policies are sorted by *random*, then by *plain*. The expert has access to the full state, and the
suites only contain instances that the expert solved from 30 initial states. *Replayed* is the
number of random episodes that `tabletopgen bench check` has replayed with the same outcome."""

_MARKUP = {ord(letter): f"&#{ord(letter)};" for letter in "&<>|\\`*_~[]{}$"}


def read_results(folder: Path) -> list[BenchResult]:
    """Return the validated results in a folder, sorted by file name, with their replay counts.

    Raises:
        InputError: there are no results, or one of them is invalid.
    """
    paths = sorted(folder.glob("*.json"))
    if not paths:
        raise InputError(f"{folder} contains no results. `tabletopgen bench run` writes them.")
    return [_read_with_mark(path) for path in paths]


def _read_with_mark(path: Path) -> BenchResult:
    """Read a result, and the number of its replayed episodes from its replay mark."""
    result = read_result(path)
    mark = read_mark(path, result.digest)
    return dataclasses.replace(result, replayed=len(mark.episodes) if mark else 0)


def page(results: Iterable[BenchResult]) -> str:
    """Return the leaderboard of results as Markdown.

    Raises:
        InputError: a result does not belong to a current test suite of the package, has impossible
            figures, or is a duplicate.
    """
    found: dict[tuple[str, str], dict[str, BenchResult]] = defaultdict(dict)
    players: dict[str, PlayerFacts] = {}
    for result in results:
        suite = _suite(result)
        key = f"{result.player}"
        players[key] = result.player
        place = found[suite.of.task, key]
        if suite.condition in place:
            raise InputError(
                f"There are two results of {result.player.name} on {result.suite}. Remove one."
            )
        place[suite.condition] = result
    parts = [HEAD]
    for task in tasks():
        entries = [(players[key], own) for (of, key), own in found.items() if of == task]
        if entries:
            parts.append(_section(task, sorted(entries, key=_order)))
    return "\n\n".join(parts) + "\n"


def _suite(result: BenchResult) -> Suite:
    """Check that a result's episodes match those of its suite, and return the suite."""
    if not result.suite.removesuffix(RANDOM).endswith("-test"):
        raise InputError(
            "The leaderboard only accepts test suites; remove the result of "
            f"{result.player.name} on {result.suite!r}."
        )
    suite = find_suite(result.suite)
    check_suite(result, suite)
    if found := doubts(result, suite):
        raise InputError(
            f"The result of {result.player.name} on {result.suite} has impossible values: "
            f"{'; '.join(map(str, found))}. Remove it; `tabletopgen bench check` gives details."
        )
    return suite


def _order(entry: tuple[PlayerFacts, Mapping[str, BenchResult]]) -> tuple[float, float, str]:
    """Return the sort key of a leaderboard entry; entries are sorted from best to worst."""
    player, results = entry
    random, plain = (results[c].share if c in results else -1.0 for c in ("random", "plain"))
    return -random, -plain, player.name


def _section(task: str, entries: Sequence[tuple[PlayerFacts, Mapping[str, BenchResult]]]) -> str:
    """Return the leaderboard's section for a task, as Markdown."""
    suites = shipped_suites(task)
    levels = [level.name for level in suites.levels]
    head = ["policy", "sees", "plain", "random", *levels, "steps", "replayed"]
    tables = sum(table.split == "test" for table in suites.tables)
    lines = [
        f"## {task}",
        f"{tables} tables, {suites.time_limit} steps at {suites.control_hz} Hz.",
        "",
        f"| {' | '.join(head)} |",
        "|" + "---|" * len(head),
    ]
    for player, results in entries:
        random = results.get("random")
        by_level = ["–" if random is None else _level(random, level) for level in levels]
        cells = [
            _plain(player.title), _plain(_sight(player)),
            *(_cell(results.get(c)) for c in ("plain", "random")),
            *by_level, _steps(random or results["plain"]), _replay_count(results.values()),
        ]  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _plain(text: str) -> str:
    """Escape text for a table cell, so that Markdown and HTML show it literally."""
    return text.translate(_MARKUP)


def _cell(result: BenchResult | None) -> str:
    if result is None:
        return "–"
    count = len(result.episodes)
    return f"**{percent(result.share)}** ({span(result.interval)}), {count}"


def _level(result: BenchResult, level: str) -> str:
    solved, count = result.of_level(level)
    return percent(solved / count) if count else "–"


def _steps(result: BenchResult) -> str:
    """Return the median number of steps of the solved episodes."""
    steps = sorted(row.steps for row in result.episodes if row.solved)
    return str(steps[len(steps) // 2]) if steps else "–"


def _replay_count(results: Iterable[BenchResult]) -> str:
    """Format the number of replayed episodes, such as "6 of 147"."""
    own = list(results)
    count = sum(result.replayed for result in own)
    return f"{count} of {sum(len(result.episodes) for result in own)}" if count else "–"


def _sight(player: PlayerFacts) -> str:
    """Describe a player's observations in a few words."""
    if player.kind in ("random", "zero"):
        return "nothing"
    if player.kind == "expert":
        return "the world"
    parts = [str(player.settings.get("observation", "state"))]
    if player.settings.get("geometry", "none") != "none":
        parts.append(str(player.settings["geometry"]).replace("_", " "))
    if hint := player.settings.get("grasp_hint"):
        parts.append(f"{'planned' if hint is True else hint} grasps")
    return ", ".join(parts)
