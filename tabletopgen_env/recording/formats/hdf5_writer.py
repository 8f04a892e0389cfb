"""Datasets stored in a single HDF5 file."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import gymnasium as gym

from ..config import RecordConfig
from ..episodes import RecordedEpisode
from ..summaries import Summaries
from .about import describe_dataset

if TYPE_CHECKING:
    import h5py

_PICTURE_BYTES = 1024  # rows of at least this size form their own compressed chunks


class Hdf5Writer:
    """A writer of one new HDF5 file; see the package docstring."""

    resumed_at = 0

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        import h5py

        self._file = h5py.File(place, "x")
        about = describe_dataset(config, env)
        self._file.attrs.update({n: v if n == "fps" else json.dumps(v) for n, v in about.items()})
        self.kept = 0
        self._summaries = Summaries()

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        with whole_group(self._file, f"episode_{self.kept}") as group:
            group.attrs.update(episode.facts)
            fill_group(group, episode.arrays)
        self.kept += 1
        self._summaries.add(episode.summaries())

    def finish(self) -> None:
        """Write the statistics."""
        fill_group(self._file.create_group("statistics"), self._summaries.figures())

    def close(self) -> None:
        """Close the file."""
        self._file.close()


@contextmanager
def whole_group(parent: h5py.Group, name: str) -> Iterator[h5py.Group]:
    """Yield a new group, which is deleted again if it cannot be filled."""
    try:
        yield parent.create_group(name)
    except BaseException:
        del parent[name]
        raise


def fill_group(group: h5py.Group, arrays: Mapping[str, Any]) -> None:
    """Write arrays, lists of strings or numbers, and nested groups into a group."""
    import h5py

    for name, value in arrays.items():
        if isinstance(value, Mapping):
            fill_group(group.create_group(name), value)
            continue
        how: dict[str, Any] = {}
        if isinstance(value, list):
            if isinstance(value[0], str):
                how = {"dtype": h5py.string_dtype()}
        # so that they can be read one by one
        elif value.ndim > 2 and value[0].nbytes >= _PICTURE_BYTES:
            how = {"chunks": (1, *value.shape[1:]), "compression": "gzip"}
        group.create_dataset(name, data=value, **how)
