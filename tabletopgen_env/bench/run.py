"""Runs of a suite: episodes run in parallel and are saved as they end, so runs can be resumed.

A journal, ``RESULT.part`` beside the result, holds one line that identifies the run and then one
line per episode, in the suite's order. A repeated run reads it and plays the missing episodes; when
all episodes are complete, the result is written atomically and the journal is removed. The result
has identical bytes for any number of interruptions and processes.
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
"""The packages whose versions a result records."""

_MAX_BYTES = 2**24
_UNSAFE = re.compile(r"[^A-Za-z0-9._-]+")

Report = Callable[[str, int, int], None]
"""A progress callback; it gets the current work, the number completed, and the total number."""


@dataclass(frozen=True)
class BenchRun:
    """Settings of a run.

    Attributes:
        out: folder of the result.
        name: name of the policy in the result; None for its own name.
        tables: folder of the tables, where missing ones are generated; None for "bench" in the
            user's cache.
        pool: worker processes.
        pictures: pictures of failed episodes.
    """

    out: Path
    name: str | None = None
    tables: Path | None = None
    pool: PoolOptions = field(default_factory=PoolOptions)
    pictures: FailurePictures = field(default_factory=FailurePictures)


def run_suite(suite: Suite, player: str, run: BenchRun, report: Report | None = None) -> Path:
    """Run a suite and return the path of the result.

    An interrupted run is resumed; a complete one is not repeated.

    Raises:
        InputError: the player does not exist or does not fit, there are no workers, or the folder
            holds a different result of this name.
        SceneError: a table is generated differently here, or a process ended unexpectedly.
        BundleError: a table is damaged.
        StorageError: a file cannot be written, or another process writes the same result.
    """
    require_number("--workers", run.pool.workers, minimum=1, maximum=1024, integer=True)
    say = report or (lambda what, done, total: None)
    facts, _ = find_player(player, suite)
    if run.name is not None:
        facts = dataclasses.replace(facts, name=_check_name(run.name))
    if facts.is_disguised:
        raise InputError(
            f"{player} is a {facts.kind} and cannot be named {facts.name!r}, which is reserved "
            "for a player without a policy. Choose another --name."
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
    """Return the path of a player's result on a suite, such as "lift-test_lift-clone.json"."""
    name = _UNSAFE.sub("-", facts.name.removesuffix(".safetensors")).strip("-.") or "policy"
    return folder / f"{suite.name}_{name[:80]}.json"


def _check_name(name: str) -> str:
    """Return a name if it is printable; raise InputError otherwise."""
    if not (name.strip() and name.isprintable() and len(name) <= 80):
        raise InputError(f"--name must be a line of up to 80 characters, got {name!r:.100}.")
    return name


def _find_tables(suite: Suite, run: BenchRun, say: Report) -> dict[str, Path]:
    """Return the bundles of a suite's tables by digest, generating any that are missing."""
    tables, found = suite.tables, dict[str, Path]()
    with closing(make_tables(suite.of, tables, run.tables, run.pool)) as made:
        for table, path in zip(tables, made, strict=True):
            found[table.digest] = path.resolve()
            say("tables", len(found), len(tables))
    return found


def _play(
    playing: Playing, episodes: Iterable[SuiteEpisode], pool: PoolOptions
) -> Generator[SuiteOutcome, None, None]:
    """Yield the outcomes of episodes, in order."""
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
    """Yield the path of a result's journal while holding a lock on the result."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"{path.parent} cannot be created: {error.strerror or error}."
        ) from error
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
    """Return a journal's complete episodes and cut off the rest; create the journal if needed.

    Raises:
        InputError: the journal belongs to another run, or is damaged.
    """
    rows: list[EpisodeRow] = []
    if journal.exists():
        raw = read_regular(journal, "The journal", InputError, max_bytes=_MAX_BYTES)
        first, *lines = raw.decode(errors="replace").splitlines(keepends=True) or [""]
        if lines and first != _line(head):  # worthless without episodes
            raise InputError(
                f"{journal} was started with another policy, suite or package version. Remove "
                "it, or choose another --out."
            )
        whole = [line for line in lines if line.endswith("\n")]  # the last line may be truncated
        try:
            rows = [read_row(parse_object(line, "A line", InputError)) for line in whole]
        except (ValueError, TypeError, KeyError) as error:
            raise InputError(f"{journal} is damaged ({error!s:.200}). Remove it.") from error
        asked = [row_of(episode, _NOTHING).key for episode in episodes]
        if [row.key for row in rows] != asked[: len(rows)]:
            raise InputError(f"{journal} does not contain the suite's episodes. Remove it.")
    text = _line(head) + "".join(_line(dataclasses.asdict(row)) for row in rows)
    write_whole(journal, text, "The journal", "Choose another --out.")
    return rows


def _line(facts: dict[str, Any]) -> str:
    return json.dumps(facts, sort_keys=True, allow_nan=False) + "\n"


_NOTHING = SuiteOutcome(False, 0, 0.0)


def _check_same(path: Path, head: dict[str, Any]) -> None:
    """Check that an existing result is the one that a run would write.

    Raises:
        InputError: it differs.
    """
    read_result(path)
    payload = parse_object(path.read_bytes(), f"{path}", InputError)
    other = [key for key, value in head.items() if check_type(payload, dict)[key] != value]
    if other:
        raise InputError(
            f"{path} contains a different result (different {', '.join(other)}). Remove it, or "
            "choose another --out or --name."
        )
