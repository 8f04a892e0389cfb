"""How the scenes of a batch are made: what runs in its processes. All of it can be pickled."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from ..backends import Mix
from .jobs import Job

if TYPE_CHECKING:
    from ..pipeline import Config


class Maker(Protocol):
    """Makes scenes in whatever process; has to be picklable, and to repeat itself to the byte."""

    def identity(self) -> dict[str, Any]:
        """Return what decides its scenes, as JSON values."""
        ...

    def __call__(self, job: Job, folder: Path) -> Path:
        """Publish a job's scene as a bundle in ``folder``; return the bundle's path.

        Raises:
            TabletopError: it cannot be made.
        """
        ...


@dataclass(frozen=True)
class Composing:
    """Composes texts (``generator.compose``)."""

    def identity(self) -> dict[str, Any]:
        """Return that it composes."""
        return {"route": "compose"}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Compose a job's text."""
        from ..bundle import save
        from ..compose import compose
        from ..figures import preview

        scene = compose(job.text, job.seed)
        return save(scene, folder, images={"preview": preview(scene)})


@dataclass(frozen=True)
class Generating:
    """Generates scenes from texts or pictures by all stages (``generator.pipeline``).

    ``mix`` says who answers the stages' questions. What it asks of servers is kept in the folder
    ``calls``, if that is given, so that nothing is paid for twice.
    """

    mix: Mix = field(default_factory=Mix)
    config: Config | None = None
    calls: str | None = None

    def identity(self) -> dict[str, Any]:
        """Return backends and settings."""
        from ..pipeline import Config
        from ..provenance import plain

        settings = plain(self.config or Config())
        return {"route": "generate", **self.mix.identity(), "config": settings}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Generate a job's scene."""
        from ..pipeline import generate
        from ..running import Session
        from ..running.store import CallStore

        _alone()
        session = Session(store=None if self.calls is None else CallStore(self.calls))
        generation = generate(job.text, self.mix.select(session), self.config, job.seed)
        path = generation.save(folder)
        if any(entry.outcome != "cached" for entry in session.account.entries):
            session.account.save(path, session.prices)
        return path


def _alone() -> None:
    """Have this process compute on one thread: the others belong to other processes."""
    import cv2
    import torch

    torch.set_num_threads(1)
    cv2.setNumThreads(1)
