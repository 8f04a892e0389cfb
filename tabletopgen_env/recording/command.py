"""The command ``record``, with a progress bar."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

from tyro.conf import OmitArgPrefixes

from generator.jobs.pools import PoolOptions

from .config import Format, LeRobotConfig, RecordConfig

_POOL = PoolOptions()
_LEROBOT = LeRobotConfig()


def record(
    config: Annotated[RecordConfig, OmitArgPrefixes],
    *,
    out: Path | None = None,
    format: Format = "minari",
    resume: bool = False,
    lerobot: OmitArgPrefixes[LeRobotConfig] = _LEROBOT,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
) -> None:
    """Record the scripted expert's demonstrations of a task as a dataset.

    Args:
        config: Settings of the recording.
        out: The dataset's own folder, or file (hdf5, robomimic). The name of a Minari dataset ends
            with its version: data/lift-v0. By default it goes into your Minari store.
        format: Format of the dataset.
        resume: Resume after the episodes that an interrupted recording left beside OUT (lerobot).
        lerobot: Settings of a LeRobot dataset.
        pool: Worker processes that run the episodes.
    """
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    from .recorder import record as run

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(),
               TimeElapsedColumn(), TextColumn("{task.fields[note]}"))  # fmt: skip
    played: int | None = None
    progress = Progress(*columns, console=Console(stderr=True))
    shown = progress.add_task(config.name, total=config.episodes, note="")
    with ExitStack() as running:

        def report(kept: int, tried: int) -> None:
            nonlocal played
            if played is None:  # errors are reported before the bar appears
                running.enter_context(progress)
            played = tried
            note = f"of {tried} played" if tried > kept else ""
            progress.update(shown, completed=kept, note=note)

        path = run(config, out, format, pool.workers, report, pool.ray, resume, lerobot)
    print(f"{path}: {config.episodes} of {played} episodes recorded")
    if format == "minari":
        print(f'  MINARI_DATASETS_PATH={path.parent}  minari.load_dataset("{path.name}")')
