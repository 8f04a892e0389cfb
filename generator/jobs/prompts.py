"""Which scenes are asked for, by texts and seeds from a file or a list, and what makes them."""

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

_MOST = 100_000  # scenes of a batch
_MOST_TEXT = 20_000  # letters of a prompt
_MOST_BYTES = 64 * 2**20  # of a file of prompts


@dataclass(frozen=True)
class Job:
    """One scene to make: a text, or the path of a picture, and a seed."""

    text: str
    seed: int = 0

    def __post_init__(self) -> None:
        if not isinstance(self.text, str):
            raise InputError(f"A prompt is a text, got {self.text!r:.80}.")
        if len(self.text) > _MOST_TEXT:
            raise InputError(f"A prompt has at most {_MOST_TEXT} letters, got {len(self.text)}.")
        try:
            self.text.encode()
        except UnicodeEncodeError as error:  # as of file names that are no text
            raise InputError(f"A prompt is a text in Unicode, got {self.text!r:.80}.") from error
        require_seed(self.seed)
        object.__setattr__(self, "seed", int(self.seed))  # also of NumPy's


class Maker(Protocol):
    """Makes scenes in any process; must be picklable and reproducible to the byte."""

    def identity(self) -> dict[str, Any]:
        """Return what decides its scenes, as JSON values."""
        ...

    def __call__(self, job: Job, folder: Path) -> Path:
        """Publish a job's scene as a bundle in ``folder``; return the bundle's path.

        Raises:
            TabletopError: it cannot be made.
        """
        ...


def jobs_of(prompts: Iterable[str | Job], seed: int = 0, variants: int = 1) -> tuple[Job, ...]:
    """Return the jobs of texts, each with ``variants`` seeds from ``seed``, or its own, on.

    What is asked for twice is one job.

    Raises:
        InputError: none, too many, or a number out of range.
    """
    require_number("A batch needs variants", variants, minimum=1, maximum=_MOST, integer=True)
    first = dict.fromkeys(p if isinstance(p, Job) else Job(p, seed) for p in prompts)
    seeds: dict[str, list[int]] = {}
    for job in first:
        seeds.setdefault(job.text, []).append(job.seed)
    count = sum(_count_seeds(sorted(firsts), variants) for firsts in seeds.values())
    if not 0 < count <= _MOST:
        raise InputError(f"A batch needs 1 to {_MOST:,} scenes, got {count:,}.")
    jobs: dict[Job, None] = {}
    for job in first:
        for k in range(variants):
            following = Job(job.text, job.seed + k)
            if k and following in first:  # its own variants cover the rest, in their turn
                break
            jobs[following] = None
    return tuple(jobs)


def _count_seeds(firsts: Sequence[int], variants: int) -> int:
    """Return how many seeds the runs of ``variants`` from sorted first ones cover together."""
    steps = (min(b - a, variants) for a, b in itertools.pairwise(firsts))
    return sum(steps) + variants


def read_prompts(path: str | Path, seed: int = 0) -> list[Job]:
    """Read texts from a file.

    A ``.json`` file is an array of texts, or of objects with a ``text`` and maybe a ``seed``; any
    other has a text a line, those that are empty or begin with ``#`` left out.

    Raises:
        InputError: there is no such file, or it holds something else.
    """
    path = Path(path)
    raw = read_regular(path, "The file of prompts", InputError, max_bytes=_MOST_BYTES)
    if path.suffix.lower() == ".json":
        entries = parse_json(raw, f"The file of prompts {path}", InputError, max_bytes=_MOST_BYTES)
        if not isinstance(entries, list):
            raise InputError(f"{path} must be an array of texts, or of objects with a text.")
        return [_job(entry, seed, path) for entry in entries]
    try:
        lines = (line.strip() for line in raw.decode("utf-8-sig").splitlines())
    except UnicodeDecodeError as error:
        raise InputError(f"{path} cannot be read as text: {error}.") from error
    return [Job(line, seed) for line in lines if line and not line.startswith("#")]


def key(job: Job, maker: dict[str, Any], picture: bytes | None) -> str:
    """Return 24 hexadecimal digits that tell a job, and how it is made, from all others.

    ``picture`` is the content of the file that the job's text names, if it names one.
    """
    seen = None if picture is None else hashlib.sha256(picture).hexdigest()
    told = {"text": job.text, "seed": job.seed, "maker": maker, "picture": seen}
    return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()[:24]


def _job(entry: Any, seed: int, path: Path) -> Job:
    if isinstance(entry, str):
        return Job(entry, seed)
    if not isinstance(entry, dict) or "text" not in entry:
        raise InputError(f"{path} holds {entry!r:.80}, which is no text and no object with a text.")
    return Job(entry["text"], entry.get("seed", seed))
