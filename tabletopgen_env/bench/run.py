"""A run of a suite: episodes in parallel, kept as they end, so that a run that was killed resumes.

Beside the result grows its journal, ``RESULT.part``: a line that says what is run, then one for
each episode, in the suite's order. The same run reads it and plays what is missing; the result is
written in one go when all episodes are there, and the journal is removed. However often a run was
interrupted, and however many processes played, the result has the same bytes.
"""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import cloudpickle
from filelock import FileLock, Timeout

from generator.errors import InputError, StorageError, require_number
from generator.io.bounded import parse_object, read_regular
from generator.io.files import check_folder, remove_file, write_whole
from generator.jobs.pools import PoolOptions, pool_of
from generator.jobs.task_pool import call_once
from generator.scene.provenance import versions

from ..files import check_type
from .episode import FailurePictures, Playing, SuiteOutcome, stage_of
from .instances import Suite, SuiteEpisode
from .players import PlayerFacts, find_player
from .results import EpisodeRow, head_of, read_result, read_row, row_of, write_result
from .tables import make_tables

PACKAGES = ("tabletopgen", "gymnasium", "mujoco", "numpy", "scipy", "shapely", "torch")
"""Those whose versions a result names."""

_MAX_BYTES = 2**24
_UNSAFE = re.compile(r"[^A-Za-z0-9._-]+")

Report = Callable[[str, int, int], None]
"""Is told what is done, how many are done, and of how many."""


@dataclass(frozen=True)
class BenchRun:
    """How a suite is run.

    Attributes:
        out: the folder of the result.
        name: what the policy is called in the result; None for its own name.
        tables: the folder of the tables, made there if they are missing; None for "bench" in the
            user's cache.
        pool: who plays.
        pictures: what is kept of episodes that fail.
    """

    out: Path
    name: str | None = None
    tables: Path | None = None
    pool: PoolOptions = field(default_factory=PoolOptions)
    pictures: FailurePictures = field(default_factory=FailurePictures)


def run_suite(suite: Suite, player: str, run: BenchRun, report: Report | None = None) -> Path:
    """Play a suite and return the path of the result.

    A run that was interrupted resumes, and of one that is complete nothing is played again.

    Raises:
        InputError: no such player, or one that does not fit; no worker; the folder holds the result
            of something else under this name.
        SceneError: a table is made here as another one, or a process has ended abruptly.
        BundleError: a table is damaged.
        StorageError: something cannot be written, or another process writes the same result.
    """
    require_number(
        "TabletopBench needs --workers", run.pool.workers, minimum=1, maximum=1024, integer=True
    )
    say = report or (lambda what, done, total: None)
    facts, _ = find_player(player, suite)
    if run.name is not None:
        facts = dataclasses.replace(facts, name=_check_name(run.name))
    if facts.is_disguised:
        raise InputError(
            f"{player} is a {facts.kind} and cannot be called {facts.name!r}, the name of a player "
            "without a policy. Choose another --name."
        )
    episodes = suite.episodes()
    if not episodes:
        raise InputError(f"{suite.name} lists no episodes.")
    head = head_of(suite, facts, versions(PACKAGES))
    check_folder(run.out)
    path = result_path(run.out, suite, facts)
    if path.exists():
        _check_same(path, head)
        return path
    with _writing(path) as journal:
        rows = _resume(journal, head, episodes)
        bundles = _find_tables(suite, run, say)
        playing = Playing(suite, player, bundles, run.pictures)
        left = episodes[len(rows) :]
        say("episodes", len(rows), len(episodes))
        with closing(_play(playing, left, run.pool)) as outcomes, journal.open("a") as file:
            for episode, outcome in zip(left, outcomes, strict=True):
                rows.append(row_of(episode, outcome))
                file.write(_line(dataclasses.asdict(rows[-1])))
                file.flush()
                say("episodes", len(rows), len(episodes))
        write_result(path, head, rows)
        remove_file(journal.parent, journal.name)
    return path


def result_path(folder: Path, suite: Suite, facts: PlayerFacts) -> Path:
    """Return where the result of a player at a suite is: "lift-test_lift-clone.json"."""
    name = _UNSAFE.sub("-", facts.name.removesuffix(".safetensors")).strip("-.") or "policy"
    return folder / f"{suite.name}_{name[:80]}.json"


def _check_name(name: str) -> str:
    """Return a name that can be shown (InputError: it cannot)."""
    if not (name.strip() and name.isprintable() and len(name) <= 80):
        raise InputError(f"--name is a line of up to 80 letters, got {name!r:.100}.")
    return name


def _find_tables(suite: Suite, run: BenchRun, say: Report) -> dict[str, Path]:
    """Return the bundles of a suite's tables by digest; those that are missing are made."""
    tables, found = suite.tables, dict[str, Path]()
    with closing(make_tables(suite.of, tables, run.tables, run.pool)) as made:
        for table, path in zip(tables, made, strict=True):
            found[table.digest] = path.resolve()
            say("tables", len(found), len(tables))
    return found


def _play(
    playing: Playing, episodes: Iterable[SuiteEpisode], pool: PoolOptions
) -> Generator[SuiteOutcome, None, None]:
    """Yield how episodes end, in their order."""
    if pool.workers == 1 and pool.ray is None:
        stage = stage_of(playing)
        with closing(stage.env):
            yield from map(stage.play, episodes)
        return
    packed = cloudpickle.dumps(partial(stage_of, playing))
    with closing(pool_of(pool.workers, pool.ray)) as workers:
        yield from workers.map(partial(_play_one, packed), episodes)


def _play_one(packed: bytes, episode: SuiteEpisode) -> SuiteOutcome:
    return call_once(packed).play(episode)


# ------------------------------------------------------------------------------------- the journal


@contextmanager
def _writing(path: Path) -> Iterator[Path]:
    """Yield the path of a result's journal, for this process alone."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{path.parent} cannot be made: {error.strerror or error}.") from error
    lock = FileLock(path.with_name(f"{path.name}.lock"), timeout=0)
    try:
        lock.acquire()
    except Timeout as error:
        raise StorageError(
            f"Another process is writing {path}. Wait for it, or choose another --out."
        ) from error
    try:
        yield path.with_name(f"{path.name}.part")
    finally:
        remove_file(path.parent, Path(lock.lock_file).name)
        lock.release()


def _resume(
    journal: Path, head: dict[str, Any], episodes: tuple[SuiteEpisode, ...]
) -> list[EpisodeRow]:
    """Return the episodes that a journal holds, and leave just these in it; begin one if need be.

    Raises:
        InputError: it is another run's, or damaged.
    """
    rows: list[EpisodeRow] = []
    if journal.exists():
        raw = read_regular(journal, "The journal", InputError, max_bytes=_MAX_BYTES)
        first, *lines = raw.decode(errors="replace").splitlines(keepends=True) or [""]
        if lines and first != _line(head):  # without episodes it is worth nothing
            raise InputError(
                f"{journal} was begun by another policy, suite or version of a package. Remove it, "
                "or choose another --out."
            )
        whole = [line for line in lines if line.endswith("\n")]  # the last may be cut off
        try:
            rows = [read_row(parse_object(line, "A line", InputError)) for line in whole]
        except (ValueError, TypeError, KeyError) as error:
            raise InputError(f"{journal} is damaged ({error!s:.200}). Remove it.") from error
        asked = [row_of(episode, _NOTHING).key for episode in episodes]
        if [row.key for row in rows] != asked[: len(rows)]:
            raise InputError(f"{journal} holds other episodes than the suite. Remove it.")
    text = _line(head) + "".join(_line(dataclasses.asdict(row)) for row in rows)
    write_whole(journal, text, "The journal", "Choose another --out.")
    return rows


def _line(facts: dict[str, Any]) -> str:
    return json.dumps(facts, sort_keys=True, allow_nan=False) + "\n"


_NOTHING = SuiteOutcome(False, 0, 0.0)


def _check_same(path: Path, head: dict[str, Any]) -> None:
    """Check that a result that is there is the one that a run would write.

    Raises:
        InputError: it is not.
    """
    read_result(path)
    payload = parse_object(path.read_bytes(), f"{path}", InputError)
    other = [key for key, value in head.items() if check_type(payload, dict)[key] != value]
    if other:
        raise InputError(
            f"{path} is the result of something else (other {', '.join(other)}). Remove it, or "
            "choose another --out or --name."
        )
