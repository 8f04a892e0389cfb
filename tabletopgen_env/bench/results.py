"""Result files: the outcome of each episode of a suite, with a digest of the content.

A file is JSON. Its ``digest`` is the sha256 of everything else in it, so that edited, truncated or
merged files are refused by all commands. It is not a signature: a forger can recompute it, but
anyone can run the suite again and obtain identical bytes.
"""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.errors import InputError
from generator.io.bounded import is_number, printable
from generator.io.files import write_whole

from ..files import check_type
from ..statistics import wilson
from .episode import SuiteOutcome
from .instances import Suite, SuiteEpisode
from .players import KINDS, SIMPLE, PlayerFacts
from .suites import canonical_digest, digest_of, read_payload

SCHEMA = 1
"""Version of the file format; other versions are rejected."""

MOST_EPISODES = 50_000
"""Maximum number of episodes of a result."""

_SHA256 = re.compile(r"[0-9a-f]{64}")
_TABLE = re.compile(r"[0-9a-f]{12}")


@dataclass(frozen=True)
class EpisodeRow:
    """One episode of a result, with its table, instance and outcome."""

    table: str
    level: str
    target: str | None
    goal: str | None
    number: int
    seed: int
    solved: bool
    steps: int
    reward: float

    @property
    def key(self) -> tuple[Any, ...]:
        """The key that identifies the episode within its suite."""
        return (self.table, self.target, self.goal, self.number, self.seed)


@dataclass(frozen=True)
class BenchResult:
    """The result of a player on a suite.

    Attributes:
        suite: name of the suite.
        version: version of the suites.
        suites: sha256 of the content of the suites' file.
        task: the task.
        player: the player.
        versions: versions of the packages that influence the result.
        episodes: all episodes of the suite, in its order.
        digest: digest of the file; empty if it was not read from one.
        replayed: number of replayed episodes according to its mark, see ``audit.marks``.
    """

    suite: str
    version: str
    suites: str
    task: str
    player: PlayerFacts
    versions: Mapping[str, str]
    episodes: tuple[EpisodeRow, ...]
    digest: str = ""
    replayed: int = 0

    @property
    def solved(self) -> int:
        """The number of solved episodes."""
        return sum(row.solved for row in self.episodes)

    @property
    def share(self) -> float:
        """The fraction of episodes solved."""
        return self.solved / len(self.episodes)

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % Wilson interval of the success rate, assuming that episodes are independent."""
        return wilson(self.solved, len(self.episodes))

    def of_level(self, level: str) -> tuple[int, int]:
        """Return how many episodes on tables of a level were solved, and how many there are."""
        own = [row.solved for row in self.episodes if row.level == level]
        return sum(own), len(own)


def row_of(episode: SuiteEpisode, outcome: SuiteOutcome) -> EpisodeRow:
    """Return the row of a result file that describes a completed episode."""
    return EpisodeRow(
        episode.table.digest, episode.level, episode.instance.target, episode.instance.goal,
        episode.number, episode.seed, outcome.solved, outcome.steps, outcome.reward,
    )  # fmt: skip


def head_of(suite: Suite, player: PlayerFacts, versions: Mapping[str, str]) -> dict[str, Any]:
    """Return the header of a result file: all entries before the episodes, as JSON values."""
    head = {
        "schema": SCHEMA,
        "suite": suite.name,
        "version": suite.of.version,
        "suites": digest_of(suite.of),
        "task": suite.of.task,
        "player": dataclasses.asdict(player),
        "versions": dict(versions),
    }
    return json.loads(json.dumps(head, allow_nan=False))


def text_of(head: Mapping[str, Any], rows: Iterable[EpisodeRow]) -> str:
    """Return the content of a result file with the given header and episode rows."""
    listed = [dataclasses.asdict(row) for row in rows]
    solved, played = sum(row["solved"] for row in listed), len(listed)
    low, high = wilson(solved, played)
    facts = {
        **head,
        "solved": solved,
        "played": played,
        "interval": [round(low, 4), round(high, 4)],
        "episodes": listed,
    }
    whole = {**facts, "digest": canonical_digest(facts)}
    return json.dumps(whole, indent=1, sort_keys=True, allow_nan=False) + "\n"


def write_result(path: Path, head: Mapping[str, Any], rows: Iterable[EpisodeRow]) -> None:
    """Write a result atomically.

    Raises:
        StorageError: the result cannot be written.
    """
    write_whole(path, text_of(head, rows), "The result", "Choose another --out.")


def read_result(path: str | Path) -> BenchResult:
    """Read and validate a result.

    Raises:
        InputError: the file is missing, too large, damaged or edited, or has an unsupported schema.
    """
    payload = read_payload(path, "The result", SCHEMA)
    digest = payload.pop("digest", None)
    if digest != canonical_digest(payload):
        raise InputError(
            f"{path} is not a valid result file: its digest does not match its content, so it "
            "was edited or truncated. Run the suite again."
        )
    try:
        return dataclasses.replace(_result(payload), digest=digest)
    except (ValueError, TypeError, KeyError) as error:
        raise InputError(f"{path} is not a valid result file ({error!s:.300}).") from error


def read_row(entry: dict[str, Any]) -> EpisodeRow:
    """Parse an episode row; raise ValueError, TypeError or KeyError if it is invalid."""
    if {*entry} != {field.name for field in dataclasses.fields(EpisodeRow)}:
        raise ValueError(
            f"an episode has missing or unexpected keys: {', '.join(sorted(entry))!s:.200}"
        )
    for name in ("target", "goal"):
        if entry[name] is not None:
            printable(entry[name], "A name", InputError)
    if not _TABLE.fullmatch(check_type(entry["table"], str)):
        raise ValueError(f"a table has an invalid name: {entry['table']!r:.40}")
    printable(entry["level"], "A level", InputError)
    for name in ("number", "seed", "steps"):
        if not 0 <= check_type(entry[name], int) < 2**31:
            raise ValueError(f"{name} is out of range: {entry[name]}")
    check_type(entry["solved"], bool)
    if not is_number(entry["reward"], minimum=-1.0, maximum=1.0):
        raise ValueError(f"a reward is not in [-1, 1]: {entry['reward']!r:.40}")
    return EpisodeRow(**entry)


def _result(payload: dict[str, Any]) -> BenchResult:
    """Parse the result in a JSON object; raise ValueError, TypeError or KeyError if invalid."""
    if check_type(payload["schema"], int) != SCHEMA:
        raise ValueError(f"the schema is {payload['schema']!r}, not {SCHEMA}")
    listed = check_type(payload["episodes"], list)
    if not 0 < len(listed) <= MOST_EPISODES:
        raise ValueError(f"the result lists {len(listed)} episodes")
    rows = tuple(read_row(check_type(entry, dict)) for entry in listed)
    if (payload["solved"], payload["played"]) != (sum(r.solved for r in rows), len(rows)):
        raise ValueError("the totals do not match the episodes")
    if len({row.key for row in rows}) < len(rows):
        raise ValueError("the result lists an episode twice")
    told = {
        name: printable(payload[name], f"Its {name}", InputError)
        for name in ("suite", "version", "suites", "task")
    }
    versions = {
        printable(k, "A package", InputError): printable(v, "A version", InputError)
        for k, v in check_type(payload["versions"], dict).items()
    }
    player = _player(check_type(payload["player"], dict))
    return BenchResult(
        told["suite"], told["version"], told["suites"], told["task"], player, versions, rows
    )


def _player(entry: dict[str, Any]) -> PlayerFacts:
    if {*entry} != {field.name for field in dataclasses.fields(PlayerFacts)}:
        raise ValueError(
            f"the player has missing or unexpected keys: {', '.join(sorted(entry))!s:.200}"
        )
    name, kind = (printable(entry[key], f"A {key}", InputError) for key in ("name", "kind"))
    digest = check_type(entry["digest"], str)
    if digest and not _SHA256.fullmatch(digest):
        raise ValueError(f"a policy has an invalid digest: {digest!r:.80}")
    settings = check_type(entry["settings"], dict)
    _check_setting(settings)
    if kind not in KINDS:
        raise ValueError(f"the player's kind must be one of {', '.join(KINDS)}, got {kind!r:.40}")
    if kind in SIMPLE and (digest or settings):
        raise ValueError(f"the player is {kind!r}, which cannot have a digest or settings")
    player = PlayerFacts(name, kind, digest, settings)
    if player.is_disguised:
        raise ValueError(
            f"the player is a {kind} called {name!r}, a name reserved for players without a policy"
        )
    return player


def _check_setting(value: Any) -> None:
    """Check that a setting is a printable string, a number, or a list or dict of these."""
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, list):
        for part in value:
            _check_setting(part)
    elif isinstance(value, str):
        printable(value, "A setting", InputError)
    elif type(value) not in (bool, int, float):
        raise ValueError(f"a setting has an unsupported value: {value!r:.80}")
