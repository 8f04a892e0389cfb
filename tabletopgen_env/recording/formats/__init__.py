"""The formats of datasets, each with a writer that receives episodes one by one."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

import gymnasium as gym

from generator.errors import InputError

from ..config import Format, LeRobotConfig, RecordConfig
from ..episodes import RecordedEpisode

__all__ = ["RESUMABLE", "Writer", "check_installed", "writer"]

RESUMABLE: tuple[Format, ...] = ("lerobot",)
"""Formats whose recordings can be resumed."""

_PACKAGES: Mapping[Format, tuple[str, ...]] = MappingProxyType(
    {
        "minari": ("minari", "h5py"),
        "hdf5": ("h5py",),
        "npz": (),
        "robomimic": ("h5py",),
        "lerobot": ("pyarrow", "av"),
    }
)


class Writer(Protocol):
    """A writer of episodes; the dataset is complete after ``finish``.

    Attributes:
        kept: Number of written episodes.
        resumed_at: Number of the first episode to be played.
    """

    kept: int
    resumed_at: int

    def add(self, episode: RecordedEpisode) -> None:
        """Write one more episode."""
        ...

    def finish(self) -> None:
        """Write the entries about the whole dataset, after the last episode."""
        ...

    def close(self) -> None:
        """Release open resources, whether or not the dataset is finished."""
        ...


def writer(
    format: Format,
    place: Path,
    config: RecordConfig,
    env: gym.Env[Any, Any],
    lerobot: LeRobotConfig,
) -> Writer:
    """Return the writer of a format for a dataset at ``place``, a path in a separate folder."""
    if format == "minari":
        from .minari_writer import MinariWriter

        return MinariWriter(place, config, env)
    if format == "hdf5":
        from .hdf5_writer import Hdf5Writer

        return Hdf5Writer(place, config, env)
    if format == "robomimic":
        from .robomimic_writer import RobomimicWriter

        return RobomimicWriter(place, config, env)
    if format == "lerobot":
        from ..lerobot.writer import LeRobotWriter

        return LeRobotWriter(place, config, env, lerobot)
    from .npz_writer import NpzWriter

    return NpzWriter(place, config, env)


def check_installed(format: Format, lerobot: LeRobotConfig) -> None:
    """Check that the packages and codecs of a format are installed.

    Raises:
        InputError: a package or codec is missing.
    """
    extra = "lerobot" if format == "lerobot" else "record"
    for needed in _PACKAGES[format]:
        if needed == "av" and lerobot.video == "none":
            continue
        try:
            __import__(needed)
        except ImportError as error:
            raise InputError(
                f"The format {format!r} needs the package {needed}, which is not installed: "
                f"pip install 'tabletopgen[{extra}]'. The format 'npz' needs no further "
                "package."
            ) from error
    if format == "lerobot" and lerobot.video != "none":
        from ..lerobot.videos import check_codec

        check_codec(lerobot.video)
