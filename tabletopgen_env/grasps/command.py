"""The ``grasps`` command: grasp labels of bundles, with a progress display."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

from tyro import conf

from generator.errors import InputError, escape
from generator.io.files import check_target
from generator.jobs.pools import PoolOptions

from .labels import FILE, GraspTerms, read_grasps

Reporter = Callable[[int, int, str], None]
"""Callback with the number of finished objects, the total, and the name of the last one."""

_USUAL, _POOL = GraspTerms(), PoolOptions()


def grasps(
    bundles: Annotated[conf.Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    count: int = _USUAL.count,
    trials: int = _USUAL.trials,
    directions: int = _USUAL.directions,
    seed: int = _USUAL.seed,
    pool: conf.OmitArgPrefixes[PoolOptions] = _POOL,
    again: bool = False,
    picture: Path | None = None,
) -> int:
    """Find grasps of every object, try them in simulation, and write labels into bundles.

    The labels of a bundle, `grasps.json`, are poses of the hand in each object's frame with width
    and quality, the share of trials in which a Panda's hand held the object. Bundles that already
    have labels with the same settings are skipped, and an interrupted command resumes with the
    remaining objects. Shipped bundles are read-only: copy the folder and name the copy.

    Args:
        bundles: Names, digests, globs or paths of bundles, or folders of them.
        count: Maximum number of labels per object.
        trials: Trials per label.
        directions: Approach directions in addition to the six along an object's axes.
        seed: The same seed gives the same labels.
        pool: Worker processes.
        again: Label again, skipping no bundle.
        picture: Draw the labels of the bundle into this PNG, a fork for each.
    """
    import assets_cache

    from .sampling import is_labelled, label_bundle

    if not bundles:
        raise InputError("Specify at least one bundle to label.")
    terms = GraspTerms(count, trials, directions, seed)
    found = [*dict.fromkeys(path for wanted in bundles for path in assets_cache.find(wanted))]
    if picture is not None:
        check_target(picture, "--picture")
        if len(found) > 1:
            raise InputError(f"--picture requires exactly one bundle, got {len(found)}.")
    waiting = [path for path in found if again or not is_labelled(path, terms)]
    if len(waiting) < len(found):
        print(f"{len(found) - len(waiting)} of {len(found)} bundles are already labelled.")
    for path in waiting:
        assets_cache.check_own(path)
    with _showing(waiting) as report:
        for path in waiting:
            made = label_bundle(path, terms, pool, report)
            for name, labels in made.labels.items():
                best = f", best {labels.quality.max():.2f}" if len(labels) else ""
                print(escape(f"{path.name}: {name}: {len(labels)} grasps{best}"), flush=True)
            print(escape(str(path / FILE)), flush=True)
    if picture is not None:
        from generator.bundle import load
        from generator.io.pictures import write_picture

        from .picture import draw_labels

        write_picture(draw_labels(load(found[0]), read_grasps(found[0])), picture)
        print(escape(str(picture)))
    return 0


@contextmanager
def _showing(paths: Sequence[Path]) -> Generator[Reporter, None, None]:
    """Yield a callback that shows the number of finished objects on standard error."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(),
               TimeElapsedColumn(), TextColumn("{task.fields[note]}"))  # fmt: skip
    with Progress(*columns, console=Console(stderr=True), disable=not paths) as progress:
        shown = progress.add_task("objects", total=None, note="")

        def report(done: int, total: int, name: str) -> None:
            progress.update(shown, completed=done, total=total, note=escape(name))

        yield report
