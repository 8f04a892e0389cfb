"""The file in which a process that makes scenes says how a job ended."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

from generator.errors import StorageError
from generator.io.reading import parse_object, read_regular

ANSWER = "answer.json"
"""Its name in the job's folder; it is published by one rename."""

_MOST_BYTES = 2**20


def give(folder: Path, said: dict[str, Any]) -> None:
    """Publish the answer to a job."""
    folder.mkdir(parents=True, exist_ok=True)
    part = folder / f"{ANSWER}.part"
    part.write_text(json.dumps(said))
    part.replace(folder / ANSWER)


def given(folder: Path) -> dict[str, Any]:
    """Return the answer to a job.

    Raises:
        FileNotFoundError: there is none yet.
        StorageError: it cannot be read.
    """
    path = folder / ANSWER
    if not os.path.lexists(path):
        raise FileNotFoundError(path)
    raw = read_regular(path, "The answer", StorageError, max_bytes=_MOST_BYTES)
    return parse_object(raw, "The answer", StorageError)
