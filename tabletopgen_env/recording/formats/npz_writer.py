"""Datasets stored as a folder of NumPy files."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np

from ..config import RecordConfig
from ..episodes import RecordedEpisode
from ..summaries import Summaries
from .about import describe_dataset


class NpzWriter:
    """A writer of a new folder of NumPy files; see the package docstring."""

    resumed_at = 0

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        place.mkdir()
        self._place, self._about = place, describe_dataset(config, env)
        self._facts: list[dict[str, Any]] = []
        self.kept = 0
        self._summaries = Summaries()

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        path = self._place / f"episode_{self.kept}.npz"
        try:
            np.savez_compressed(path, **dict(_flat(episode.arrays)))
        except BaseException:
            path.unlink(missing_ok=True)
            raise
        self._facts.append(dict(episode.facts))
        self.kept += 1
        self._summaries.add(episode.summaries())

    def finish(self) -> None:
        """Write the metadata of all episodes."""
        about = self._about | {"statistics": self._summaries.figures(), "episodes": self._facts}
        text = json.dumps(about, indent=1)
        (self._place / "dataset.json").write_text(text + "\n", encoding="utf-8")

    def close(self) -> None:
        """Do nothing, since no file stays open."""


def _flat(arrays: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield arrays with their nested names joined by slashes."""
    for name, value in arrays.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{before}{name}/")
        else:
            yield before + name, np.asarray(value)
