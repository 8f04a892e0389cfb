"""The protocol of a trainable model, independent of its library."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ..networks.actor import Actor, Squash


@dataclass(frozen=True)
class Counts:
    """Progress of a run: environment and gradient steps, episodes, seconds and best success rate.

    ``best`` is -1 before the first evaluation; ``cloned`` is true once the actor has been cloned
    from the expert.
    """

    steps: int = 0
    updates: int = 0
    episodes: int = 0
    seconds: float = 0.0
    best: float = -1.0
    cloned: bool = False


class Learner(Protocol):
    """A trainable model, with its progress, actor and checkpoints."""

    @property
    def updates(self) -> int:
        """The number of gradient steps, or the algorithm's equivalent."""
        ...

    @property
    def episodes(self) -> int:
        """The number of episodes completed in training."""
        ...

    def export(self) -> tuple[Actor, Squash]:
        """Return a copy of the actor, and how its actions are squashed ("tanh" or "clip")."""
        ...

    def write(self, folder: Path, replay: bool) -> None:
        """Write a checkpoint into a folder, including the replay buffer if ``replay`` is true."""
        ...

    def read(self, folder: Path, counts: Counts) -> bool:
        """Restore a checkpoint; return whether it contained a replay buffer.

        Raises:
            Exception: any exception, if a file is damaged or belongs to another network.
        """
        ...
