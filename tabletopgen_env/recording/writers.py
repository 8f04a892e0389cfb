"""The formats of a dataset: what writes episodes into a folder, one after the other."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import gymnasium as gym
import numpy as np

from generator.errors import InputError
from generator.scene.provenance import versions

from .config import Format, RecordConfig
from .playing import RecordedEpisode

if TYPE_CHECKING:
    import h5py
    from minari import MinariDataset

_EXPERT = "tabletopgen_env.expert.run.TaskExpert"
_VERSIONS = ("tabletopgen", "mujoco", "gymnasium", "numpy")


class Writer(Protocol):
    """Writes episodes; the dataset is whole once it is closed."""

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more."""
        ...

    def close(self) -> None:
        """Finish."""
        ...


class MinariWriter:
    """A Minari dataset in a folder of its id's name, which is not there yet."""

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        self._place, self._config, self._env = place, config, env
        self._dataset: MinariDataset | None = None

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        from minari.data_collector import EpisodeBuffer

        buffer = EpisodeBuffer(seed=int(episode.facts["seed"]), **episode.arrays)
        if self._dataset is None:
            self._dataset = self._begin(buffer)
        else:
            self._dataset.update_dataset_from_buffer([buffer])
        number = self._dataset.total_episodes - 1
        self._dataset.storage.update_episode_metadata([dict(episode.facts)], [number])

    def close(self) -> None:
        """Nothing is left to do: every episode is written when it is added."""

    def _begin(self, first: Any) -> MinariDataset:
        """Return the dataset of the first episode."""
        import minari

        about = _about(self._config, self._env)
        used = about["versions"]
        with _minari_root(self._place.parent), warnings.catch_warnings():
            # Authors, a link to code and the like are for who publishes the dataset.
            warnings.filterwarnings("ignore", category=UserWarning, module="minari")
            dataset = minari.create_dataset_from_buffers(
                dataset_id=self._place.name,
                buffer=[first],
                env=self._env,
                algorithm_name=_EXPERT,
                description=f"The scripted expert of {about['environment']['id']} at work.",
                requirements=[f"{name}=={used[name]}" for name in ("tabletopgen", "mujoco")],
                data_format="hdf5",
                jpeg_encoding=False,  # it is lossy
            )
        dataset.storage.update_metadata({"tabletopgen": about})
        return dataset


@contextmanager
def _minari_root(folder: Path) -> Iterator[None]:
    """Have Minari make datasets in a folder: it takes the place from the environment alone."""
    before = os.environ.get("MINARI_DATASETS_PATH")
    os.environ["MINARI_DATASETS_PATH"] = str(folder)
    try:
        yield
    finally:
        if before is None:
            del os.environ["MINARI_DATASETS_PATH"]
        else:
            os.environ["MINARI_DATASETS_PATH"] = before


class Hdf5Writer:
    """One HDF5 file, which is not there yet; see the package's page."""

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        import h5py

        self._file = h5py.File(place, "x")
        self._file.attrs.update({n: json.dumps(v) for n, v in _about(config, env).items()})
        self._count = 0

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        group = self._file.create_group(f"episode_{self._count}")
        group.attrs.update(episode.facts)
        _fill(group, episode.arrays)
        self._count += 1

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _fill(group: h5py.Group, arrays: Mapping[str, Any]) -> None:
    """Write arrays, texts and what is nested into a group."""
    import h5py

    for name, value in arrays.items():
        if isinstance(value, Mapping):
            _fill(group.create_group(name), value)
            continue
        how: dict[str, Any] = {}
        if isinstance(value, list):
            how = {"dtype": h5py.string_dtype()}
        elif value.ndim > 2:  # pictures, to be read one by one
            how = {"chunks": (1, *value.shape[1:]), "compression": "gzip"}
        group.create_dataset(name, data=value, **how)


class NpzWriter:
    """A folder of NumPy files, which is not there yet; see the package's page."""

    def __init__(self, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> None:
        place.mkdir()
        self._place, self._about = place, _about(config, env)
        self._facts: list[dict[str, Any]] = []

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        path = self._place / f"episode_{len(self._facts)}.npz"
        np.savez_compressed(path, **dict(_flat(episode.arrays)))
        self._facts.append(dict(episode.facts))

    def close(self) -> None:
        """Write what is known of all episodes."""
        text = json.dumps(self._about | {"episodes": self._facts}, indent=1)
        (self._place / "dataset.json").write_text(text + "\n", encoding="utf-8")


def _flat(arrays: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    """Yield arrays by their nested names joined with slashes."""
    for name, value in arrays.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{before}{name}/")
        else:
            yield before + name, np.asarray(value)


def writer(format: Format, place: Path, config: RecordConfig, env: gym.Env[Any, Any]) -> Writer:
    """Return what writes a dataset of a format to ``place``."""
    kinds = {"minari": MinariWriter, "hdf5": Hdf5Writer, "npz": NpzWriter}
    return kinds[format](place, config, env)


def check_installed(format: Format) -> None:
    """Check that the packages of a format are there.

    Raises:
        InputError: one is missing.
    """
    for needed in {"minari": ("minari", "h5py"), "hdf5": ("h5py",), "npz": ()}[format]:
        try:
            __import__(needed)
        except ImportError as error:
            raise InputError(
                f"The format {format!r} needs the package {needed}, which is not installed: "
                "pip install 'tabletopgen[record]'. The format 'npz' needs none."
            ) from error


def _about(config: RecordConfig, env: gym.Env[Any, Any]) -> dict[str, Any]:
    """Return what a dataset says of itself, as JSON values."""
    assert env.spec is not None
    return {
        "environment": json.loads(env.spec.to_json()),
        "expert": _EXPERT,
        "settings": asdict(config),
        "versions": versions(_VERSIONS),
    }
