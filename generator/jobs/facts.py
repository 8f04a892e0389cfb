"""What a record of a batch says, read as something that anyone may have written."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..errors import StorageError
from ..io.files import is_plain_name
from ..io.reading import is_number, parse_object, read_regular

_MOST_BYTES = 2**20  # of a record; the error in it may be long
_BUNDLE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*-[0-9a-f]{12}")  # as ``bundle.save`` names them


@dataclass(frozen=True)
class Facts:
    """What came of a job, as its record has it: fields of ``Outcome``, checked.

    ``bundle`` is the plain name of a bundle's folder. ``gate`` is empty if the record has figures
    that are none.
    """

    bundle: str | None = None
    kind: str | None = None
    error: str | None = None
    seconds: float = 0.0
    gate: Mapping[str, float] = field(default_factory=dict)


def read(place: Path, name: str) -> Facts | None:
    """Return what the record ``name`` says; None if there is none, or none that can be read."""
    path = place / f"{name}.json"
    try:
        raw = read_regular(path, "The record", StorageError, max_bytes=_MOST_BYTES)
        told = parse_object(raw, f"The record {path}", StorageError)
    except StorageError:
        return None
    known = {f.name for f in dataclasses.fields(Facts)}
    facts = Facts(**{key: value for key, value in told.items() if key in known})
    if not _is_sound(facts):
        return None
    return facts if _are_figures(facts.gate) else dataclasses.replace(facts, gate={})


def _is_sound(facts: Facts) -> bool:
    texts = all(text is None or isinstance(text, str) for text in (facts.kind, facts.error))
    named = facts.bundle is None or (
        is_plain_name(facts.bundle) and _BUNDLE.fullmatch(facts.bundle) is not None
    )
    return texts and named and is_number(facts.seconds)


def _are_figures(gate: Any) -> bool:
    return isinstance(gate, dict) and all(is_number(v, minimum=-1e12) for v in gate.values())
