"""Jobs of a batch: prompts and seeds from a file or a list, and the interface of scene makers."""

from __future__ import annotations

import hashlib
import itertools
import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from ..errors import InputError, require_number, require_seed
from ..io.bounded import parse_json, read_regular

_MOST = 100_000  # scenes per batch
_MOST_TEXT = 20_000  # characters per prompt
_MOST_BYTES = 64 * 2**20  # bytes of a prompt file


@dataclass(frozen=True)
class Job:
    """One scene to make: a text or the path of a picture, and a seed."""

    text: str
    seed: int = 0

    def __post_init__(self) -> None:
        if not isinstance(self.text, str):
            raise InputError(f"A prompt must be a string, got {self.text!r:.80}.")
        if len(self.text) > _MOST_TEXT:
            raise InputError(
                f"A prompt may have at most {_MOST_TEXT} characters, got {len(self.text)}."
            )
        try:
            self.text.encode()
        except UnicodeEncodeError as error:  # such as file names with invalid characters
            raise InputError(f"A prompt must be valid Unicode, got {self.text!r:.80}.") from error
        require_seed(self.seed)
        object.__setattr__(self, "seed", int(self.seed))  # accepts NumPy integers too


class Maker(Protocol):
    """Interface of scene makers, which can be pickled and give the same bytes in every process."""

    def identity(self) -> dict[str, Any]:
        """Return the settings that determine the scenes, as JSON values."""
        ...

    def __call__(self, job: Job, folder: Path) -> Path:
        """Publish a job's scene as a bundle in ``folder`` and return the bundle's path.

        Raises:
            TabletopError: the scene cannot be made.
        """
        ...


def jobs_of(prompts: Iterable[str | Job], seed: int = 0, variants: int = 1) -> tuple[Job, ...]:
    """Return jobs with ``variants`` consecutive seeds per prompt; a job's seed overrides ``seed``.

    Duplicates are removed.

    Raises:
        InputError: there are no jobs or too many, or a number is out of range.
    """
    require_number("variants", variants, minimum=1, maximum=_MOST, integer=True)
    first = dict.fromkeys(p if isinstance(p, Job) else Job(p, seed) for p in prompts)
    seeds: dict[str, list[int]] = {}
    for job in first:
        seeds.setdefault(job.text, []).append(job.seed)
    count = sum(_count_seeds(sorted(firsts), variants) for firsts in seeds.values())
    if not 0 < count <= _MOST:
        raise InputError(f"A batch must have 1 to {_MOST:,} scenes, got {count:,}.")
    jobs: dict[Job, None] = {}
    for job in first:
        for k in range(variants):
            following = Job(job.text, job.seed + k)
            if k and following in first:  # the variants of the following seed cover the rest
                break
            jobs[following] = None
    return tuple(jobs)


def _count_seeds(firsts: Sequence[int], variants: int) -> int:
    """Count the distinct seeds in the runs of ``variants`` seeds that start at ``firsts``."""
    steps = (min(b - a, variants) for a, b in itertools.pairwise(firsts))
    return sum(steps) + variants


def read_prompts(path: str | Path, seed: int = 0) -> list[Job]:
    """Read prompts from a file.

    A ``.json`` file is an array of texts, or of objects with a ``text`` and an optional ``seed``.
    Other files have one text per line; empty lines and lines that begin with ``#`` are skipped.

    Raises:
        InputError: the file does not exist or is invalid.
    """
    path = Path(path)
    raw = read_regular(path, "The prompt file", InputError, max_bytes=_MOST_BYTES)
    if path.suffix.lower() == ".json":
        entries = parse_json(raw, f"The prompt file {path}", InputError, max_bytes=_MOST_BYTES)
        if not isinstance(entries, list):
            raise InputError(
                f"{path} must be a JSON array of strings, or of objects with the key 'text'."
            )
        return [_job(entry, seed, path) for entry in entries]
    try:
        lines = (line.strip() for line in raw.decode("utf-8-sig").splitlines())
    except UnicodeDecodeError as error:
        raise InputError(f"{path} cannot be read as text: {error}.") from error
    return [Job(line, seed) for line in lines if line and not line.startswith("#")]


def key(job: Job, maker: dict[str, Any], picture: bytes | None) -> str:
    """Return 24 hexadecimal digits that identify a job and the settings of its maker.

    ``picture`` is the content of the file if the job's text is the path of a picture.
    """
    seen = None if picture is None else hashlib.sha256(picture).hexdigest()
    told = {"text": job.text, "seed": job.seed, "maker": maker, "picture": seen}
    return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()[:24]


def _job(entry: Any, seed: int, path: Path) -> Job:
    if isinstance(entry, str):
        return Job(entry, seed)
    if not isinstance(entry, dict) or "text" not in entry:
        raise InputError(
            f"{path} contains {entry!r:.80}, which is neither a string nor an object with the key "
            "'text'."
        )
    return Job(entry["text"], entry.get("seed", seed))
