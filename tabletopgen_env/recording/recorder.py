"""Recording: play, keep what was solved, and publish the dataset by one rename."""

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
_DECISIVE = ("tabletopgen", "mujoco", "numpy", "pyarrow")  # versions that decide the bytes

MOST_MISSES = 50
"""How many episodes in a row may give nothing to keep."""


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
    """Record the expert's demonstrations; return where the dataset is.

    It is there once it is whole: whatever goes wrong before leaves nothing behind, but for the
    format "lerobot" the episodes that are done, in ``.<name>.part`` beside ``out``. ``resume``
    continues after these, if there are any, with the same settings (``episodes`` may differ, but
    not be less than there are), to the same bytes as without the interruption. ``lerobot`` says how
    that format keeps pictures.

    ``out`` is the dataset's own folder, or file ("hdf5", "robomimic"), which must not be there yet.
    The name of a Minari dataset is its id and ends with a version ("data/lift-v0"); None is
    ``TabletopGen-<task>-v0`` in the user's Minari store. ``workers`` are processes that play; they
    change what is recorded only where the clock renews the scenes ("refreshing"). They are of this
    machine or, with its address, of a ``ray`` cluster, whose machines have to share the folders of
    scenes that are paths; ``out`` is written here alone. ``report`` is called with how many
    episodes are kept and how many were played: once nothing is found wrong, and after each.

    Raises:
        InputError: a setting is wrong, a package or a codec is missing, ``out`` is there already,
            or what is to be resumed is another recording, or has more episodes already.
        BackendError: no Ray.
        BundleError: no bundle fits the scenes, or one is damaged.
        SceneError: the expert solved none of 50 episodes in a row, or a process that played has
            ended abruptly.
        StorageError: the disk refused.
    """
    require_number("record needs workers", workers, minimum=1, integer=True)
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
    """Write episodes that are played elsewhere, as ``record`` does those of the expert.

    ``episodes`` returns them, and all are kept, whatever ``config.episodes`` says; it is called
    with the number of the first, 0 unless an interrupted recording is resumed. ``env`` is where
    they are played, and stays open.

    Ctrl-C ends the recording, and those kept until then are the dataset. So they are if something
    goes wrong later, which is raised then; of the format "lerobot" they wait to be resumed.

    Raises:
        InputError: as ``record``, or there was not one episode.
        StorageError: the disk refused.
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
            raise InputError("No episode was kept, so there is no dataset.")
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
    """Check what can be checked before anything is played; return where the dataset goes."""
    if format not in FORMATS:
        raise InputError(f"Unknown format {format!r}." + choices(str(format), FORMATS))
    config.check()
    lerobot.check()
    check_installed(format, lerobot)
    if resume and format not in RESUMABLE:
        raise InputError(f"The format {format!r} cannot be resumed; {', '.join(RESUMABLE)} can.")
    return _target(config, out, format)


def _publish(
    target: Path, config: RecordConfig, format: Format, resume: bool, lerobot: LeRobotConfig
) -> AbstractContextManager[Path]:
    """Return what gives the place to write to."""
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
    """Play what the dataset lacks, and write it."""
    missing = config.episodes - dataset.kept
    if missing < 0:
        raise InputError(
            f"The interrupted recording has {dataset.kept} episodes already, more than the "
            f"{config.episodes} asked for. Resume it with episodes={dataset.kept} or more."
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
    """Write as many episodes as are asked for."""
    missed = 0
    for number, episode in enumerate(episodes, dataset.resumed_at + 1):
        if isinstance(episode, SceneError):
            missed += 1
            if missed == MOST_MISSES:
                raise SceneError(
                    f"{missed} episodes in a row gave nothing to keep. Use other scenes, another "
                    f"task or less noise. Of the last: {episode}"
                )
        else:
            missed = 0
            dataset.add(episode)
        report(dataset.kept, number)
        if dataset.kept == config.episodes:
            return


def _target(config: RecordConfig, out: str | Path | None, format: Format) -> Path:
    """Return where the dataset goes: a place that is free, and has a dataset's name."""
    if out is None and format != "minari":
        raise InputError(f"Say where the {format} dataset goes, with 'out'.")
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
                f"{target.name!r} is no name of a Minari dataset: letters, digits, '-' and '_', "
                f"with a version at the end, such as '{config.name.lower()}-v0'."
            ) from error
    if os.path.lexists(target):
        raise InputError(f"{target} is there already. Remove it, or choose another place.")
    check_folder(target.parent)
    return target
