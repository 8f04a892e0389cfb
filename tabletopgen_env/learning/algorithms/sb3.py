"""A Stable-Baselines3 model as a ``Learner``."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.off_policy_algorithm import OffPolicyAlgorithm
from stable_baselines3.common.save_util import load_from_zip_file, recursive_setattr

from ..demonstrations.replay import read_buffer, write_buffer
from ..networks.actor import Actor, Squash, actor_of
from ..recipes import Network
from .learner import Counts

MODEL, REPLAY = "model.zip", "replay.npz"
"""The files of a checkpoint."""


@dataclass(frozen=True, eq=False)
class Sb3Learner:
    """A Stable-Baselines3 model made by ``setup.new_model``, with its network settings."""

    model: BaseAlgorithm
    network: Network

    @property
    def updates(self) -> int:
        """The number of gradient steps, or the number of epochs for PPO."""
        return getattr(self.model, "_n_updates", 0)

    @property
    def episodes(self) -> int:
        """The number of episodes completed in training."""
        return self.model._episode_num

    def export(self) -> tuple[Actor, Squash]:
        """Return a copy of the model's actor, and how its actions are squashed."""
        return actor_of(self.model, self.network)

    def write(self, folder: Path, replay: bool) -> None:
        """Write the model and, if ``replay`` is true and it has one, its replay buffer."""
        self.model.save(folder / MODEL)
        buffer = getattr(self.model, "replay_buffer", None)
        if replay and buffer is not None:
            write_buffer(buffer, folder / REPLAY)

    def read(self, folder: Path, counts: Counts) -> bool:
        """Restore a checkpoint; return whether it contained a replay buffer.

        Raises:
            Exception: any exception, if a file is damaged or belongs to another model.
        """
        if not (folder / MODEL).is_file():
            raise FileNotFoundError(f"{MODEL} is missing, or is not a file")
        _, weights, variables = load_from_zip_file(folder / MODEL, device="cpu", load_data=False)
        self.model.set_parameters(weights, device="cpu")
        for name, value in (variables or {}).items():
            recursive_setattr(self.model, f"{name}.data", value.data)
        own: Any = self.model
        own.num_timesteps, own._episode_num = counts.steps, counts.episodes
        own._n_updates = counts.updates
        if not (isinstance(own, OffPolicyAlgorithm) and (folder / REPLAY).is_file()):
            return False
        assert own.replay_buffer is not None
        read_buffer(own.replay_buffer, folder / REPLAY)
        return True
