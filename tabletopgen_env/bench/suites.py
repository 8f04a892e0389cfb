"""JSON files of suites, read with size limits and fully validated."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from generator.errors import InputError, choices
from generator.io.bounded import is_number, parse_object, printable, read_regular
from generator.io.files import write_whole
from generator.language.distribution import SceneDistribution

from ..certificates.certificate import MOST_EPISODES, TaskInstance, Terms
from ..files import check_type
from ..randomization import Randomization
from ..tasks.names import NAMES
from .instances import LISTED, RANDOM, Suite, SuiteLevel, SuiteTable, TaskSuites, suite_of

VERSION = "v1"
"""The version of the suites that names refer to."""

SCHEMA = 1
"""Version of the file format; other versions are rejected."""

PLACE = Path(__file__).with_name("data")
"""Folder of the shipped suites, with a subfolder per version."""

SPLITS = ("train", *LISTED)

MOST_TABLES, MOST_INSTANCES = 1024, 64
"""Maximum number of tables per file, and of instances per table."""

_MAX_BYTES, _MAX_DEPTH = 2**24, 6
_DIGEST = re.compile(r"[0-9a-f]{12}")
_CONDITIONS = ("plain", "random")
_KEYS = frozenset({"schema", *(field.name for field in dataclasses.fields(TaskSuites))})


def names() -> tuple[str, ...]:
    """Return the names of all runnable suites of the package."""
    return tuple(suite.name for task in tasks() for suite in shipped_suites(task).suites())


def tasks() -> tuple[str, ...]:
    """Return the tasks with shipped suites."""
    return tuple(name for name in NAMES if path_of(name).is_file())


def path_of(task: str) -> Path:
    """Return the path of the file with the shipped suites for a task."""
    return PLACE / VERSION / f"{task.lower()}.json"


@cache
def shipped_suites(task: str) -> TaskSuites:
    """Return the shipped suites for a task."""
    return read_suites(path_of(task))


def find_suite(name: str) -> Suite:
    """Return a suite by its name, such as "lift-test" or "lift-test-random".

    For your own file, give its path and the rest of the name: "my.json:test-random".

    Raises:
        InputError: the name is unknown, or the file is not a valid suite file.
    """
    path, colon, split = name.rpartition(":")
    if colon:
        return suite_of(read_suites(path), *_part(split))
    task, _, split = name.partition("-")
    own = next((known for known in tasks() if known.lower() == task), None)
    if own is None or _part(split)[0] not in SPLITS:
        raise InputError(f"Unknown suite {name!r}." + choices(name, names()))
    return suite_of(shipped_suites(own), *_part(split))


def read_suites(path: str | Path) -> TaskSuites:
    """Read and validate a suite file.

    Raises:
        InputError: the file is missing, too large or damaged, or has an unsupported schema.
    """
    payload = read_payload(path, "The suites", SCHEMA)
    try:
        return _suites(payload)
    except (ValueError, TypeError, KeyError) as error:
        raise InputError(f"{path} is not a valid suite file ({error!s:.300}).") from error


def read_payload(path: str | Path, what: str, newest: int) -> dict[str, Any]:
    """Return the JSON object in a file; its schema version must be at most ``newest``.

    Raises:
        InputError: the file is missing, too large, damaged, or of a newer schema.
    """
    raw = read_regular(path, what, InputError, max_bytes=_MAX_BYTES)
    payload = parse_object(raw, f"{path}", InputError, max_bytes=_MAX_BYTES, max_depth=_MAX_DEPTH)
    schema = payload.get("schema")
    if type(schema) is int and schema > newest:
        raise InputError(
            f"{path} has schema {schema}, but this version of the package reads up to "
            f"{newest}. Install a newer version."
        )
    return payload


def write_suites(suites: TaskSuites, path: Path) -> None:
    """Write a suite file atomically.

    Raises:
        StorageError: the file cannot be written.
    """
    text = json.dumps(facts_of(suites), indent=1, sort_keys=True, allow_nan=False) + "\n"
    write_whole(path, text, "The suites", "Choose another file.")


def facts_of(suites: TaskSuites) -> dict[str, Any]:
    """Return suites as JSON values."""
    default = Randomization()
    facts = {
        "schema": SCHEMA,
        **{field.name: getattr(suites, field.name) for field in dataclasses.fields(suites)},
        "randomization": {
            name: value
            for name, value in dataclasses.asdict(suites.randomization).items()
            if value != getattr(default, name)
        },
        "episodes": dict(suites.episodes),
        "distribution": dataclasses.asdict(suites.distribution),
        "levels": [list(level) for level in suites.levels],
        "terms": {k: v for k, v in dataclasses.asdict(suites.terms).items() if k != "tasks"},
        "versions": dict(suites.versions),
        "tables": [_table_facts(table) for table in suites.tables],
    }
    return json.loads(json.dumps(facts, allow_nan=False))


def digest_of(suites: TaskSuites) -> str:
    """Return the sha256 of the suites' content, independent of the file's formatting."""
    return canonical_digest(facts_of(suites))


def canonical_digest(facts: Mapping[str, Any]) -> str:
    """Return the sha256 of JSON values in canonical form."""
    text = json.dumps(facts, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _part(text: str) -> tuple[str, bool]:
    """Return the split named by the suffix of a suite name, and whether the suite is randomised."""
    return text.removesuffix(RANDOM), text.endswith(RANDOM)


def _table_facts(table: SuiteTable) -> dict[str, Any]:
    """Return a table as JSON values, omitting instance entries with the value None."""
    instances = [
        {k: v for k, v in dataclasses.asdict(i).items() if k != "task" and v is not None}
        for i in table.instances
    ]
    return {**dataclasses.asdict(table), "instances": instances}


def _suites(payload: dict[str, Any]) -> TaskSuites:
    """Parse the suites in a JSON object; raise ValueError, TypeError or KeyError if invalid."""
    _check_keys(payload, _KEYS, "it")
    if check_type(payload["schema"], int) != SCHEMA:
        raise ValueError(f"the schema is {payload['schema']!r}, not {SCHEMA}")
    task = check_type(payload["task"], str)
    if task not in NAMES:
        raise ValueError(f"unknown task {task!r}")
    terms = check_type(payload["terms"], dict)
    listed = check_type(payload["tables"], list)
    if len(listed) > MOST_TABLES:
        raise ValueError(f"the suite lists more than {MOST_TABLES} tables")
    episodes = check_type(payload["episodes"], dict)
    _check_keys(episodes, _CONDITIONS, "episodes")
    tables = tuple(_table(check_type(entry, dict), task) for entry in listed)
    if len({table.digest for table in tables}) < len(tables):
        raise ValueError("the suite lists a table twice")
    return TaskSuites(
        version=printable(payload["version"], "A version", InputError, max_length=40),
        task=task,
        control_hz=_count(payload["control_hz"], 500),
        time_limit=_count(payload["time_limit"], 10_000),
        hold=_count(payload["hold"], 1000),
        randomization=_randomization(check_type(payload["randomization"], dict)),
        episodes={name: _count(episodes[name], MOST_EPISODES) for name in _CONDITIONS},
        distribution=_distribution(check_type(payload["distribution"], dict)),
        levels=_levels(check_type(payload["levels"], list)),
        training=_count(payload["training"], 2**30),
        share=_share(payload["share"]),
        terms=Terms((task,), *(check_type(terms[k], int) for k in ("episodes", "most", "seed"))),
        versions={
            printable(k, "A package", InputError): printable(v, "A version", InputError)
            for k, v in check_type(payload["versions"], dict).items()
        },
        tables=tables,
    )


def _table(entry: dict[str, Any], task: str) -> SuiteTable:
    _check_keys(entry, [field.name for field in dataclasses.fields(SuiteTable)], "a table")
    listed = check_type(entry["instances"], list)
    if len(listed) > MOST_INSTANCES:
        raise ValueError(f"a table lists more than {MOST_INSTANCES} instances")
    if entry["split"] not in LISTED:
        raise ValueError(f"a table has the unknown split {entry['split']!r}")
    digest = check_type(entry["digest"], str)
    if not _DIGEST.fullmatch(digest):
        raise ValueError(f"a table has an invalid digest: {digest!r}")
    return SuiteTable(
        entry["split"], _seed(entry["seed"]), digest, _share(entry["difficulty"]),
        tuple(_instance(check_type(instance, dict), task) for instance in listed),
    )  # fmt: skip


def _instance(entry: dict[str, Any], task: str) -> TaskInstance:
    names = {"target", "goal", "preset"}
    if odd := {*entry} - names - {"successes", "episodes"}:
        raise ValueError(f"an instance has unexpected keys: {', '.join(sorted(odd))}")
    told = {name: printable(entry[name], "A name", InputError) for name in names if name in entry}
    solved, played = check_type(entry["successes"], int), check_type(entry["episodes"], int)
    if not 0 <= solved <= played <= MOST_EPISODES:
        raise ValueError(f"invalid counts: {solved} of {played} episodes")
    given = {"target": None, "goal": None, **told}
    return TaskInstance(task, successes=solved, episodes=played, **given)


def _randomization(entry: dict[str, Any]) -> Randomization:
    given: dict[str, Any] = {k: tuple(v) if isinstance(v, list) else v for k, v in entry.items()}
    return Randomization(**given)


def _distribution(entry: dict[str, Any]) -> SceneDistribution:
    known = [field.name for field in dataclasses.fields(SceneDistribution)]
    _check_keys(entry, known, "the distribution")
    lists: dict[str, Any] = {name: tuple(check_type(value, list)) for name, value in entry.items()}
    lists["needs"] = tuple(tuple(check_type(need, list)) for need in lists["needs"])
    return SceneDistribution(**lists)


def _levels(entries: list[Any]) -> tuple[SuiteLevel, ...]:
    levels: list[SuiteLevel] = []
    for entry in entries:
        name, low, high = check_type(entry, list)
        levels.append(SuiteLevel(printable(name, "A level", InputError), _share(low), _share(high)))
    if not levels or not all(level.low < level.high for level in levels):
        raise ValueError("the levels are not valid ranges")
    return tuple(levels)


def _check_keys(entry: Mapping[str, Any], known: Any, what: str) -> None:
    if {*entry} != {*known}:
        raise ValueError(f"{what} has unexpected keys: {', '.join(sorted(entry))!s:.200}")


def _count(value: Any, maximum: int) -> int:
    if not 0 < check_type(value, int) <= maximum:
        raise ValueError(f"{value} is not an integer from 1 to {maximum}")
    return value


def _seed(value: Any) -> int:
    if not 0 <= check_type(value, int) < 2**30:
        raise ValueError(f"a table has an invalid seed: {value}")
    return value


def _share(value: Any) -> float:
    if not is_number(value, maximum=1.0):
        raise ValueError(f"{value!r} is not a number in [0, 1]")
    return float(value)
