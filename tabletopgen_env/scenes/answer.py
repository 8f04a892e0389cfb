"""The file in which a process that makes scenes says how a job ended."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

ANSWER = "answer.json"
"""Its name in the job's folder; it is published by one rename."""


def give(folder: Path, said: dict[str, Any]) -> None:
    """Publish the answer to a job."""
    folder.mkdir(parents=True, exist_ok=True)
    part = folder / f"{ANSWER}.part"
    part.write_text(json.dumps(said))
    part.replace(folder / ANSWER)


def given(folder: Path) -> Any:
    """Return the answer to a job.

    Raises:
        FileNotFoundError: there is none yet.
        OSError, ValueError: it cannot be read.
    """
    return json.loads((folder / ANSWER).read_bytes())
