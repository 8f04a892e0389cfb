"""Recording: play, keep what was solved, and publish the dataset by one rename."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from generator.errors import (
    InputError,
    SceneError,
    StorageError,
    TabletopError,
    choices,
    require_number,
)
from generator.io.files import check_folder

from .config import FORMATS, Format, RecordConfig
from .playing import RecordedEpisode, play_episodes
from .writers import Writer, check_installed, writer

_MOST_MISSES = 50  # episodes in a row that may give nothing to keep


def record(
    config: RecordConfig,
    out: str | Path | None = None,
    format: Format = "minari",
    workers: int = 1,
    report: Callable[[int, int], None] | None = None,
) -> Path:
    """Record the expert's demonstrations; return where the dataset is.

    It is there once it is whole: whatever goes wrong before leaves nothing behind. ``out`` is its
    own folder, or file ("hdf5"), which must not be there yet. The name of a Minari dataset is its
    id and ends with a version ("data/lift-v0"); None is ``TabletopGen-<task>-v0`` in the user's
    Minari store. ``workers`` are processes that play; they change what is recorded only where the
    clock renews the scenes ("refreshing"). ``report`` is called with how many episodes are kept and
    how many were played: before any is, once nothing is found wrong, and after each.

    Raises:
        InputError: a setting is wrong, a package is missing, or ``out`` is there already.
        BundleError: no bundle fits the scenes, or one is damaged.
        SceneError: the expert solved none of 50 episodes in a row, or a process that played has
            ended abruptly.
        StorageError: the disk refused.
    """
    if format not in FORMATS:
        raise InputError(f"Unknown format {format!r}." + choices(str(format), FORMATS))
    require_number("record needs workers", workers, minimum=1, integer=True)
    config.check()
    check_installed(format)
    target = _target(config, out, format)
    env = config.environment()
    try:
        with (
            _publish(target) as part,
            closing(writer(format, part, config, env)) as dataset,
            closing(play_episodes(config, env, workers)) as episodes,
        ):
            _write(config, episodes, dataset, report or (lambda kept, played: None))
    finally:
        env.close()
    return target


def _write(
    config: RecordConfig,
    episodes: Iterable[RecordedEpisode | SceneError],
    dataset: Writer,
    report: Callable[[int, int], None],
) -> None:
    """Write as many episodes as are asked for."""
    kept = missed = 0
    report(0, 0)
    for number, episode in enumerate(episodes, 1):
        if isinstance(episode, SceneError):
            missed += 1
            if missed == _MOST_MISSES:
                raise SceneError(
                    f"{missed} episodes in a row gave nothing to keep. Use other scenes, another "
                    f"task or less noise. Of the last: {episode}"
                )
        else:
            missed = 0
            kept += 1
            dataset.add(episode)
        report(kept, number)
        if kept == config.episodes:
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


@contextmanager
def _publish(target: Path) -> Iterator[Path]:
    """Give a place beside ``target``, and move what was made there to it if nothing goes wrong."""
    part = None
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        part = Path(tempfile.mkdtemp(".part", f".{target.name}-", target.parent))
        yield part / target.name
        if os.path.lexists(target):
            raise InputError(f"{target} has come to be there meanwhile. Choose another place.")
        (part / target.name).rename(target)
    except OSError as error:
        if isinstance(error, TabletopError):
            raise
        raise StorageError(
            f"The dataset cannot be written to {target}: {error.strerror or error}."
        ) from error
    finally:
        if part is not None:
            shutil.rmtree(part, ignore_errors=True)
