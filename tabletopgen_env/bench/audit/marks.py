"""Marks of results that were played again: a file beside each.

Like a result, a mark is no signature: who keeps a leaderboard makes the marks themselves.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from generator.errors import InputError
from generator.io.bounded import printable
from generator.io.files import remove_file, write_whole

from ...files import check_type
from ..results import MOST_EPISODES
from ..suites import canonical_digest, read_payload

SUFFIX = ".replayed"
"""Ends the name of a mark, after its result's: "lift-test_expert.json.replayed"."""

SCHEMA = 1
"""Version of the files; others are refused."""


@dataclass(frozen=True)
class ReplayMark:
    """Which episodes of a result were played again and came out as it says.

    Attributes:
        result: the result's digest.
        seed: what they were drawn by.
        episodes: their places in the result, from 0.
        versions: of the packages that they were played with.
    """

    result: str
    seed: int
    episodes: tuple[int, ...]
    versions: Mapping[str, str]


def mark_path(result: Path) -> Path:
    """Return where the mark of a result is."""
    return result.with_name(result.name + SUFFIX)


def write_mark(result: Path, mark: ReplayMark) -> None:
    """Write the mark of a result, whole or not at all.

    Raises:
        StorageError: it cannot be written.
    """
    facts = json.loads(json.dumps({"schema": SCHEMA, **dataclasses.asdict(mark)}))
    text = json.dumps({**facts, "digest": canonical_digest(facts)}, indent=1, sort_keys=True) + "\n"
    write_whole(mark_path(result), text, "The mark", "Check a copy of the result.")


def remove_mark(result: Path) -> None:
    """Remove the mark of a result, if there is one.

    Raises:
        StorageError: it cannot be removed.
    """
    path = mark_path(result)
    if path.exists():
        remove_file(path.parent, path.name)


def read_mark(result: Path, digest: str) -> ReplayMark | None:
    """Return the mark of a result with a digest; None if it has none, or one of an older result.

    Raises:
        InputError: the mark is damaged, edited or of another schema.
    """
    path = mark_path(result)
    if not path.exists():
        return None
    payload = read_payload(path, "The mark", SCHEMA)
    own = payload.pop("digest", None)
    try:
        if own != canonical_digest(payload) or check_type(payload["schema"], int) != SCHEMA:
            raise ValueError("it was edited or cut off")
        numbers = tuple(check_type(k, int) for k in check_type(payload["episodes"], list))
        if not numbers or len({*numbers}) < len(numbers) or not _within(numbers):
            raise ValueError("its episodes are no places in a result")
        versions = {
            printable(k, "A package", InputError): printable(v, "A version", InputError)
            for k, v in check_type(payload["versions"], dict).items()
        }
        of, seed = check_type(payload["result"], str), check_type(payload["seed"], int)
    except (ValueError, TypeError, KeyError) as error:
        raise InputError(
            f"{path} is not a valid mark ({error!s:.300}). Remove it, or check the result again."
        ) from error
    return ReplayMark(of, seed, numbers, versions) if of == digest else None


def _within(numbers: tuple[int, ...]) -> bool:
    return min(numbers) >= 0 and max(numbers) < MOST_EPISODES
