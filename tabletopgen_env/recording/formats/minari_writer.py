"""Minari datasets."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import gymnasium as gym

from ..config import RecordConfig
from ..episodes import RecordedEpisode
from ..summaries import Summaries
from .about import describe_dataset

if TYPE_CHECKING:
    from minari import MinariDataset


class MinariWriter:
    """A writer of a new Minari dataset, in a folder named after its id."""

    resumed_at = 0

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        self._place, self._config, self._env = place, config, env
        self._dataset: MinariDataset | None = None
        self._summaries = Summaries()
        self.kept = 0

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        from minari.data_collector import EpisodeBuffer

        buffer = EpisodeBuffer(seed=int(episode.facts["seed"]), **episode.arrays)
        if self._dataset is None:
            self._dataset = self._begin(buffer)
        else:
            self._dataset.update_dataset_from_buffer([buffer])
        self._dataset.storage.update_episode_metadata([dict(episode.facts)], [self.kept])
        self.kept += 1
        self._summaries.add(episode.summaries())

    def finish(self) -> None:
        """Write the metadata of all episodes."""
        assert self._dataset is not None
        about = describe_dataset(self._config, self._env)
        about["statistics"] = self._summaries.figures()
        self._dataset.storage.update_metadata({"tabletopgen": about})

    def close(self) -> None:
        """Do nothing, since every episode is complete when it is added."""

    def _begin(self, first: Any) -> MinariDataset:
        """Create the dataset with the first episode."""
        import minari

        about = describe_dataset(self._config, self._env)
        used = about["versions"]
        with _minari_root(self._place.parent), warnings.catch_warnings():
            # The publisher of the dataset adds authors, a link to code and the like.
            warnings.filterwarnings("ignore", category=UserWarning, module="minari")
            return minari.create_dataset_from_buffers(
                dataset_id=self._place.name,
                buffer=[first],
                env=self._env,
                algorithm_name=self._config.player,
                description=f"{self._config.player} in {about['environment']['id']}.",
                requirements=[f"{name}=={used[name]}" for name in ("tabletopgen", "mujoco")],
                data_format="hdf5",
                jpeg_encoding=False,  # lossy otherwise
            )


@contextmanager
def _minari_root(folder: Path) -> Iterator[None]:
    """Make Minari create datasets in a folder, by setting an environment variable."""
    before = os.environ.get("MINARI_DATASETS_PATH")
    os.environ["MINARI_DATASETS_PATH"] = str(folder)
    try:
        yield
    finally:
        if before is None:
            del os.environ["MINARI_DATASETS_PATH"]
        else:
            os.environ["MINARI_DATASETS_PATH"] = before
