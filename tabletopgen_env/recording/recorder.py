"""Recording: play episodes, keep the solved ones, and publish the dataset by one rename."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager, closing
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import gymnasium as gym

from generator.errors import InputError, SceneError, choices, require_number
from generator.io.files import check_folder
from generator.scene.provenance import versions

from .config import FORMATS, Format, LeRobotConfig, RecordConfig
from .episodes import RecordedEpisode, play_episodes
from .formats import RESUMABLE, Writer, check_installed, writer
from .interrupts import deferring
from .publication import publish, publish_in_parts, storing

_LEROBOT = LeRobotConfig()
# packages whose versions influence the bytes
_DECISIVE = ("tabletopgen", "mujoco", "numpy", "pyarrow")

MOST_MISSES = 50
"""Maximum number of consecutive episodes that are not kept."""


def record(
    config: RecordConfig,
    out: str | Path | None = None,
    format: Format = "minari",
    workers: int = 1,
    report: Callable[[int, int], None] | None = None,
    ray: str | None = None,
    resume: bool = False,
    lerobot: LeRobotConfig = _LEROBOT,
) -> Path:
    """Record the expert's demonstrations; return the path of the dataset.

    The dataset appears only when it is complete. A failure leaves nothing behind, except in the
    format "lerobot", which stores completed episodes in ``.<name>.part`` beside ``out``. ``resume``
    continues after these, if there are any, with the same settings (``episodes`` may differ, but
    must not be less than the number already stored), and the result has the same bytes as an
    uninterrupted recording. ``lerobot`` holds the settings of that format.

    ``out`` is the dataset's own folder, or file ("hdf5", "robomimic"), and must not exist. The name
    of a Minari dataset is its id and ends with a version ("data/lift-v0"); None stands for
    ``TabletopGen-<task>-v0`` in the user's Minari store. ``workers`` is the number of processes
    that play; it influences the result only if the scenes are renewed by the clock ("refreshing").
    The processes run on this machine or, if ``ray`` is the address of a Ray cluster, on the
    cluster, whose machines must have access to the folders of scenes given by path; ``out`` is
    written on this machine. ``report`` is called with the number of kept and of played episodes,
    first after all checks have passed, then after each episode.

    Raises:
        InputError: a setting is invalid, a package or a codec is missing, ``out`` exists already,
            or the recording to be resumed has other settings or more episodes.
        BackendError: Ray is not available.
        BundleError: no bundle matches the scenes, or one is damaged.
        SceneError: the expert solved none of 50 episodes in a row, or a process that played ended
            unexpectedly.
        StorageError: a file cannot be written.
    """
    require_number("workers", workers, minimum=1, integer=True)
    target = _check(config, out, format, resume, lerobot)
    env = config.environment()
    try:
        with (
            _publish(target, config, format, resume, lerobot) as place,
            closing(writer(format, place, config, env, lerobot)) as dataset,
        ):
            _play(config, env, dataset, workers, ray, report or (lambda kept, played: None))
            dataset.finish()
    finally:
        env.close()
    return target


def write_dataset(
    config: RecordConfig,
    env: gym.Env[Any, Any],
    episodes: Callable[[int], Iterable[RecordedEpisode]],
    out: str | Path | None = None,
    format: Format = "minari",
    resume: bool = False,
    lerobot: LeRobotConfig = _LEROBOT,
) -> Path:
    """Write a dataset like ``record``, but from episodes that were played elsewhere.

    ``episodes`` returns the episodes, all of which are kept, regardless of ``config.episodes``. It
    is called with the number of the first one, 0 unless an interrupted recording is resumed.
    ``env`` is the environment in which they are played; it is not closed.

    Ctrl-C ends the recording, and the dataset consists of the episodes so far. The same holds for
    an error, which is raised afterwards; in the format "lerobot" the episodes are stored until the
    recording is resumed instead.

    Raises:
        InputError: as for ``record``, or there was no episode.
        StorageError: a file cannot be written.
    """
    target = _check(config, out, format, resume, lerobot)
    failure: BaseException | None = None
    with (
        deferring() as playing,
        _publish(target, config, format, resume, lerobot) as place,
        closing(writer(format, place, config, env, lerobot)) as dataset,
    ):
        try:
            for episode in playing(episodes(dataset.resumed_at)):
                dataset.add(episode)
        except BaseException as error:
            if dataset.kept == 0 or format in RESUMABLE:
                raise
            failure = error
        if dataset.kept == 0:
            raise InputError("No episode was kept, so no dataset is written.")
        dataset.finish()
    if failure is not None:
        with storing(target):
            raise failure
    return target


def _check(
    config: RecordConfig,
    out: str | Path | None,
    format: Format,
    resume: bool,
    lerobot: LeRobotConfig,
) -> Path:
    """Check the settings before anything is played; return the path of the dataset."""
    if format not in FORMATS:
        raise InputError(f"Unknown format {format!r}." + choices(str(format), FORMATS))
    config.check()
    lerobot.check()
    check_installed(format, lerobot)
    if resume and format not in RESUMABLE:
        raise InputError(
            f"A recording in the format {format!r} cannot be resumed; only "
            f"{', '.join(RESUMABLE)} can."
        )
    return _target(config, out, format)


def _publish(
    target: Path, config: RecordConfig, format: Format, resume: bool, lerobot: LeRobotConfig
) -> AbstractContextManager[Path]:
    """Return the context manager that yields the temporary path of the dataset."""
    if format not in RESUMABLE:
        return publish(target)
    settings = {n: v for n, v in asdict(config).items() if n != "episodes"}
    used = [*_DECISIVE, *(["av"] if lerobot.video != "none" else [])]
    key = {**settings, **asdict(lerobot), "format": format, "versions": versions(used)}
    return publish_in_parts(target, key, resume)


def _play(
    config: RecordConfig,
    env: gym.Env[Any, Any],
    dataset: Writer,
    workers: int,
    ray: str | None,
    report: Callable[[int, int], None],
) -> None:
    """Play the missing episodes, and write them."""
    missing = config.episodes - dataset.kept
    if missing < 0:
        raise InputError(
            f"The interrupted recording already has {dataset.kept} episodes, more than the "
            f"requested {config.episodes}. Resume it with episodes={dataset.kept} or more."
        )
    report(dataset.kept, dataset.resumed_at)
    if missing > 0:
        rest = replace(config, episodes=missing)
        with closing(play_episodes(rest, env, workers, ray, dataset.resumed_at)) as episodes:
            _write(config, episodes, dataset, report)


def _write(
    config: RecordConfig,
    episodes: Iterable[RecordedEpisode | SceneError],
    dataset: Writer,
    report: Callable[[int, int], None],
) -> None:
    """Write episodes until the requested number is reached."""
    missed = 0
    for number, episode in enumerate(episodes, dataset.resumed_at + 1):
        if isinstance(episode, SceneError):
            missed += 1
            if missed == MOST_MISSES:
                raise SceneError(
                    f"None of {missed} consecutive episodes was kept. Use other scenes, another "
                    f"task or less noise. Reason for the last episode: {episode}"
                )
        else:
            missed = 0
            dataset.add(episode)
        report(dataset.kept, number)
        if dataset.kept == config.episodes:
            return


def _target(config: RecordConfig, out: str | Path | None, format: Format) -> Path:
    """Check that the dataset's path does not exist and has a valid name; return the path."""
    if out is None and format != "minari":
        raise InputError(f"Set 'out' to the path of the {format} dataset.")
    if out is None:
        from minari.storage import get_dataset_path

        target = get_dataset_path(f"TabletopGen-{config.name}-v0")
    else:
        target = Path(os.path.abspath(out))  # noqa: PTH100  links stay as they are
    if format == "minari":
        from minari.dataset.minari_dataset import parse_dataset_id

        try:
            parse_dataset_id(target.name)
        except (ValueError, TypeError) as error:
            raise InputError(
                f"{target.name!r} is not a valid name of a Minari dataset: use letters, "
                "digits, '-' and '_', with a version at the end, such as "
                f"'{config.name.lower()}-v0'."
            ) from error
    if os.path.lexists(target):
        raise InputError(f"{target} already exists. Remove it, or choose another path.")
    check_folder(target.parent)
    return target
