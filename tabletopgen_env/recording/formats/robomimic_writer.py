"""Datasets in robomimic's layout: one HDF5 file with a group per demonstration.

The layout is described at https://robomimic.github.io/docs/datasets/overview.html.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np

from generator.scene.provenance import versions

from ..config import RecordConfig
from ..episodes import RecordedEpisode
from ..summaries import Summaries
from .about import describe_dataset
from .hdf5_writer import fill_group, whole_group

_GYM_TYPE = 2  # value of robomimic's EnvType
_VALID_EVERY = 10  # every tenth demonstration is for validation


class RobomimicWriter:
    """A writer of one new HDF5 file; see the package docstring."""

    resumed_at = 0

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        import h5py

        assert env.spec is not None
        self._file = h5py.File(place, "x")
        self._data = self._file.create_group("data")
        about = describe_dataset(config, env)
        arguments = {
            "env_name": env.spec.id,
            "env_version": versions(["mujoco"])["mujoco"],
            "type": _GYM_TYPE,
            "env_kwargs": about["environment"]["kwargs"],
        }
        self._data.attrs["env_args"] = json.dumps(arguments)
        self._data.attrs["tabletopgen"] = json.dumps(about)
        self.kept = self._total = 0
        self._summaries = Summaries()

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        steps = len(episode.rewards)
        arrays = {
            "actions": episode.actions,
            "rewards": episode.rewards,
            "dones": (np.arange(1, steps + 1) == steps).astype(np.int64),
            "obs": {name: rows[:-1] for name, rows in _observations(episode).items()},
        }
        with whole_group(self._data, f"demo_{self.kept}") as group:
            group.attrs.update({**episode.facts, "num_samples": steps})
            fill_group(group, arrays)
        self.kept += 1
        self._total += steps
        self._summaries.add(episode.summaries())

    def finish(self) -> None:
        """Write the number of steps, the training and validation split, and the statistics."""
        self._data.attrs["total"] = self._total
        names = np.array([f"demo_{k}" for k in range(self.kept)], np.bytes_)
        valid = np.arange(1, len(names) + 1) % _VALID_EVERY == 0
        if len(names) > 1 and not valid.any():
            valid[-1] = True
        fill_group(
            self._file, {"mask": {"train": names[~valid], "valid": names[valid]},
                         "statistics": self._summaries.figures()},
        )  # fmt: skip

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _observations(episode: RecordedEpisode) -> dict[str, np.ndarray]:
    """Return the observations for robomimic, with one row more than there are steps."""
    found = {"proprio": episode.proprio}
    if episode.state is not None:
        found["state"] = episode.state
    for name, pictures in episode.pictures.items():
        if pictures.ndim == 3:  # depth or labels: robomimic needs a channel axis
            found[name] = pictures[..., None]
        else:
            found[f"{name}_image"] = pictures
    for name, views in episode.cameras.items():
        found[f"{name}_intrinsics"] = views["intrinsics"]
        found[f"{name}_extrinsics"] = views["extrinsics"]
    return found
