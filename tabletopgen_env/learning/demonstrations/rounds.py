"""Rounds of cloning, saved on disk so that an interrupted run resumes with identical results.

==================================  ================================================================
``round-NN.npz``                    the episodes of a round
``actor-NN.safetensors``            the actor after the round, and the state of the random
                                    generators; written last, so a round without it is ignored
``head.safetensors``                the actor's trained grasp head (``networks.grasp_head``)
``showings-NNN.npz``                training data of the grasp head; see ``demos``
==================================  ================================================================
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path

import numpy as np
import torch
from safetensors import SafetensorError
from safetensors.torch import load, save
from torch import Tensor, nn

from generator.errors import BundleError, InputError
from generator.io.bounded import read_arrays
from generator.io.files import write_file, write_whole

from .recorded import Demonstration

_MAX_BYTES = 2**31  # per round
_ADVICE = "Start a new run."


@dataclass(frozen=True)
class RoundsFolder:
    """The folder of a run's cloning rounds."""

    path: Path

    @property
    def done(self) -> int:
        """The number of completed rounds."""
        return len(list(self.path.glob("actor-*.safetensors")))

    def keep(
        self,
        number: int,
        episodes: Sequence[Demonstration],
        actor: nn.Module,
        generator: torch.Generator,
        drawn: int,
    ) -> None:
        """Save a round: its episodes, the actor, the random state and the number of seeds drawn.

        Raises:
            StorageError: a file cannot be written.
        """
        self.path.mkdir(parents=True, exist_ok=True)
        content = BytesIO()
        np.savez(
            content,
            observations=np.concatenate([d.observations for d in episodes]),
            advice=np.concatenate([d.advice for d in episodes]),
            actions=np.concatenate([d.actions for d in episodes]),
            rewards=np.concatenate([d.rewards for d in episodes]),
            lengths=np.array([len(d.advice) for d in episodes]),
            solved=np.array([d.solved for d in episodes]),
            drawn=np.array(drawn),
        )
        write_file(content.getvalue(), self._episodes(number))
        weights = {**_weights(actor), "random": generator.get_state()}
        write_whole(self._actor(number), save(weights), "The round", _ADVICE)

    def read(self, actor: nn.Module, generator: torch.Generator) -> tuple[list[Demonstration], int]:
        """Restore the actor and random state; return all episodes and the number of drawn seeds.

        Raises:
            BundleError: a file is damaged.
        """
        seen: list[Demonstration] = []
        drawn = 0
        for number in range(self.done):
            kept = self._read(number)
            ends = np.cumsum(kept["lengths"])[:-1]
            parts = [np.split(kept[key], ends) for key in ("advice", "actions", "rewards")]
            shown = np.split(kept["observations"], ends + 1 + np.arange(len(ends)))
            seen += [
                Demonstration(*row, solved=bool(good), instruction="")
                for *row, good in zip(shown, *parts, kept["solved"], strict=True)
            ]
            drawn = int(kept["drawn"])
        if seen:
            weights = self._load(self._actor(self.done - 1))
            generator.set_state(weights.pop("random"))
            _fill(actor, weights, self.path)
        return seen, drawn

    def keep_head(self, head: nn.Module) -> None:
        """Save the grasp head; raise StorageError if the file cannot be written."""
        self.path.mkdir(parents=True, exist_ok=True)
        write_whole(self._head, save(_weights(head)), "The head", _ADVICE)

    def read_head(self, head: nn.Module) -> bool:
        """Restore the grasp head; return whether it exists; raise BundleError if it is damaged."""
        if not self._head.is_file():
            return False
        _fill(head, self._load(self._head), self.path)
        return True

    def remove(self) -> None:
        """Delete the folder."""
        shutil.rmtree(self.path, ignore_errors=True)

    @property
    def _head(self) -> Path:
        return self.path / "head.safetensors"

    def _episodes(self, number: int) -> Path:
        return self.path / f"round-{number:02d}.npz"

    def _actor(self, number: int) -> Path:
        return self.path / f"actor-{number:02d}.safetensors"

    def _read(self, number: int) -> dict[str, np.ndarray]:
        path = self._episodes(number)
        try:
            kept = read_arrays(path, "The round", InputError, max_bytes=_MAX_BYTES)
            lengths = kept["lengths"]
            rows = {key: len(kept[key]) for key in ("observations", "advice", "actions", "rewards")}
            steps = int(lengths.sum())
            if rows.pop("observations") != steps + len(lengths) or set(rows.values()) != {steps}:
                raise ValueError("array lengths differ")
            if len(kept["solved"]) != len(lengths) or kept["drawn"].shape != ():
                raise ValueError("the outcomes of the episodes are missing")
            return kept
        except (InputError, ValueError, KeyError, TypeError) as error:
            raise BundleError(
                f"{path} is not a valid cloning round ({error}). {_ADVICE}"
            ) from error

    def _load(self, path: Path) -> dict[str, Tensor]:
        try:
            return load(path.read_bytes())
        except (SafetensorError, ValueError, OSError) as error:
            raise BundleError(f"{path} is damaged ({error}). {_ADVICE}") from error


def _weights(module: nn.Module) -> dict[str, Tensor]:
    return {key: value.detach().contiguous() for key, value in module.state_dict().items()}


def _fill(module: nn.Module, weights: dict[str, Tensor], path: Path) -> None:
    try:
        module.load_state_dict(weights)
    except RuntimeError as error:
        raise BundleError(f"{path} belongs to another network. {_ADVICE}") from error
