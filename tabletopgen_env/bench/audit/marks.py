"""Marks that record which results have been replayed; each mark is a file beside its result.

Like a result, a mark is not signed: the maintainer of a leaderboard creates the marks.
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
"""Suffix of the file name of a result's mark, as in "lift-test_expert.json.replayed"."""

SCHEMA = 1
"""Version of the file format; other versions are rejected."""


@dataclass(frozen=True)
class ReplayMark:
    """A record of the episodes of a result that were replayed with identical outcomes.

    Attributes:
        result: digest of the result.
        seed: seed of the random choice of episodes.
        episodes: indices of the episodes in the result, from 0.
        versions: versions of the packages used for the replay.
    """

    result: str
    seed: int
    episodes: tuple[int, ...]
    versions: Mapping[str, str]


def mark_path(result: Path) -> Path:
    """Return the path of a result's replay mark."""
    return result.with_name(result.name + SUFFIX)


def write_mark(result: Path, mark: ReplayMark) -> None:
    """Write the replay mark of a result atomically.

    Raises:
        StorageError: the mark cannot be written.
    """
    facts = json.loads(json.dumps({"schema": SCHEMA, **dataclasses.asdict(mark)}))
    text = json.dumps({**facts, "digest": canonical_digest(facts)}, indent=1, sort_keys=True) + "\n"
    write_whole(
        mark_path(result), text, "The mark", "Check a copy of the result in a writable folder."
    )


def remove_mark(result: Path) -> None:
    """Remove the replay mark of a result, if there is one.

    Raises:
        StorageError: the mark cannot be removed.
    """
    path = mark_path(result)
    if path.exists():
        remove_file(path.parent, path.name)


def read_mark(result: Path, digest: str) -> ReplayMark | None:
    """Return a result's replay mark, or None if there is none for the result's ``digest``.

    Raises:
        InputError: the mark is damaged or edited, or has an unsupported schema.
    """
    path = mark_path(result)
    if not path.exists():
        return None
    payload = read_payload(path, "The mark", SCHEMA)
    own = payload.pop("digest", None)
    try:
        if own != canonical_digest(payload) or check_type(payload["schema"], int) != SCHEMA:
            raise ValueError("the file was edited or truncated")
        numbers = tuple(check_type(k, int) for k in check_type(payload["episodes"], list))
        if not numbers or len({*numbers}) < len(numbers) or not _within(numbers):
            raise ValueError(
                "the replayed episodes must be distinct indices of the result's episodes"
            )
        versions = {
            printable(k, "A package", InputError): printable(v, "A version", InputError)
            for k, v in check_type(payload["versions"], dict).items()
        }
        of, seed = check_type(payload["result"], str), check_type(payload["seed"], int)
    except (ValueError, TypeError, KeyError) as error:
        raise InputError(
            f"{path} is not a valid replay mark ({error!s:.300}). Remove it, or run `tabletopgen "
            "bench check` again."
        ) from error
    return ReplayMark(of, seed, numbers, versions) if of == digest else None


def _within(numbers: tuple[int, ...]) -> bool:
    return min(numbers) >= 0 and max(numbers) < MOST_EPISODES
