"""What makes the scenes of a batch."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

from .prompts import Job


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
