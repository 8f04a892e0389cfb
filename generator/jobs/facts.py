"""What came of a job; its record is read as something that anyone may have written."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from ..errors import StorageError
from ..io.files import is_plain_name
from ..io.reading import is_number, parse_object, read_regular
from .prompts import Job

_MOST_BYTES = 2**20  # of a record; the error in it may be long
_BUNDLE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*-[0-9a-f]{12}")  # as ``bundle.save`` names them
_RECORDED = ("bundle", "kind", "error", "seconds", "gate")

State = Literal["made", "there", "failed", "unpaid", "busy"]


@dataclass(frozen=True)
class Outcome:
    """What came of a job.

    Attributes:
        job: the job.
        state: "made" now, "there" already, "failed", "unpaid": a call that it needs was not sent,
            for want of money or in a dry run, or "busy": someone else is at it.
        bundle: the name of its bundle, if there is one.
        kind: the class of the error, if it failed or is unpaid.
        error: what it says.
        seconds: how long it took whoever made it.
        gate: figures of the recorded gate: see ``summary``.
    """

    job: Job
    state: State
    bundle: str | None = None
    kind: str | None = None
    error: str | None = None
    seconds: float = 0.0
    gate: Mapping[str, float] = field(default_factory=dict)


def read(job: Job, place: Path, name: str) -> Outcome | None:
    """Return what the record ``name`` says of a job; None if there is none that can be read.

    ``bundle`` is then the plain name of a bundle's folder. ``gate`` is empty if what is recorded
    is no figures.
    """
    path = place / f"{name}.json"
    try:
        raw = read_regular(path, "The record", StorageError, max_bytes=_MOST_BYTES)
        told = parse_object(raw, f"The record {path}", StorageError)
    except StorageError:
        return None
    facts = {key: told[key] for key in _RECORDED if key in told}
    found = Outcome(job, "failed" if facts.get("bundle") is None else "there", **facts)
    texts = all(text is None or isinstance(text, str) for text in (found.kind, found.error))
    named = found.bundle is None or (
        is_plain_name(found.bundle) and _BUNDLE.fullmatch(found.bundle)
    )
    if not (texts and named and is_number(found.seconds)):
        return None
    figures = isinstance(found.gate, dict) and all(
        is_number(value, minimum=-1e12) for value in found.gate.values()
    )
    return found if figures else replace(found, gate={})
