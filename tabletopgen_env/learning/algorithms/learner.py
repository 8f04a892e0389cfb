"""What a training needs of an algorithm's model, whoever wrote it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ..networks.actor import Actor, Squash


@dataclass(frozen=True)
class Counts:
    """How far a run is: environment steps, gradient steps, episodes, seconds, and its best share.

    ``best`` is -1 before the first evaluation; ``cloned`` says whether the actor's cloned start is
    done.
    """

    steps: int = 0
    updates: int = 0
    episodes: int = 0
    seconds: float = 0.0
    best: float = -1.0
    cloned: bool = False


class Learner(Protocol):
    """A model that learns: how far it is, what acts of it, and what it needs to go on."""

    @property
    def updates(self) -> int:
        """Gradient steps, or what the algorithm counts in their place."""
        ...

    @property
    def episodes(self) -> int:
        """Episodes that ended while it learned."""
        ...

    def export(self) -> tuple[Actor, Squash]:
        """Return a copy of what acts, and what becomes of its actions."""
        ...

    def write(self, folder: Path, replay: bool) -> None:
        """Write what is needed to go on into a folder; ``replay``: a replay buffer, too."""
        ...

    def read(self, folder: Path, counts: Counts) -> bool:
        """Become what was written; return whether a replay buffer was there.

        Raises:
            Exception: of any kind, where a file is damaged or of another network.
        """
        ...
