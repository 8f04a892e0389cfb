"""``python -m tabletopgen_env``: the commands that need the robot."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import tyro
from tyro import conf

import assets_cache
from generator.errors import InputError, TabletopError, escaped, exit_code
from generator.io.terminal import piped

from .certificates.certificate import STARTS, Terms
from .certificates.certify import DEFAULT, certify_all, is_certified
from .learning.commands import enjoy, plot, train
from .recording import Format, RecordConfig
from .recording.command import record as recorded


def certify(
    bundles: conf.Positional[tuple[str, ...]],
    /,
    *,
    tasks: tuple[str, ...] = DEFAULT.tasks,
    episodes: int = DEFAULT.episodes,
    most: int = DEFAULT.most,
    seed: int = DEFAULT.seed,
    workers: int = 1,
    again: bool = False,
) -> int:
    """Let the scripted expert play what bundles offer, and write a certificate beside each.

    A bundle whose certificate was made on the same terms is passed over, so that the same command
    goes on where it was interrupted; one made on other terms is replaced, not extended. Those that
    cannot be certified are named at the end.

    Args:
        bundles: Names, digests, globs or paths of bundles, or folders of them.
        tasks: Which tasks; Sequence with its presets.
        episodes: How many of each instance at most: the first from where the scene has things,
            the others from perturbed starts, and none after a failure. Fewer than 30 certify
            nothing.
        most: How many instances of each task at most.
        seed: The same seed gives the same certificate.
        workers: Processes; they do not change what is written.
        again: Pass over none.
    """
    if not bundles:
        raise InputError("Name at least one bundle to certify.")
    terms = Terms(tasks, episodes, most, seed)
    if episodes < STARTS:
        print(f"Fewer than {STARTS} episodes of an instance certify nothing.", file=sys.stderr)
    found = dict.fromkeys(path for wanted in bundles for path in assets_cache.find(wanted))
    waiting = [path for path in found if again or not is_certified(path, terms)]
    if len(waiting) < len(found):
        print(f"{len(found) - len(waiting)} of {len(found)} bundles are certified already.")
    failed: list[tuple[Path, TabletopError]] = []
    try:
        for path, certificate in certify_all(waiting, terms, workers):
            if isinstance(certificate, TabletopError):
                failed.append((path, certificate))
                continue
            for seen in certificate.instances:
                asked = {"preset": seen.preset} if seen.preset else seen.options
                told = ", ".join(f"{name} {value}" for name, value in asked.items())
                print(escaped(f"{path.name}: {seen.task} ({told or 'as drawn'}): "
                      f"{seen.successes} of {seen.episodes}"), flush=True)  # fmt: skip
    finally:  # also when it is interrupted
        for path, error in failed:
            told = escaped(f"error: {path.name} is not certified: {error}")
            print(told, file=sys.stderr)
    return exit_code(failed[0][1]) if failed else 0


def record(
    config: Annotated[RecordConfig, conf.OmitArgPrefixes],
    *,
    out: Path | None = None,
    format: Format = "minari",
    workers: int = 1,
) -> None:
    """Record the scripted expert's demonstrations of a task as a dataset.

    Args:
        config: What to record.
        out: The dataset's own folder, or file (hdf5). A Minari dataset's name ends with its
            version: data/lift-v0. Left out, it goes into your Minari store.
        format: Its format.
        workers: Processes; they do not change what is recorded.
    """
    recorded(config, out, format, workers)


app = tyro.extras.SubcommandApp()
for _command in (certify, record, train, enjoy, plot):
    app.command(_command)


def run(arguments: list[str]) -> int:
    """Run the command line; every expected error becomes one line, and an exit code is returned."""
    try:
        code = app.cli(
            prog="python -m tabletopgen_env",
            description="Commands that need the robot.",
            args=arguments,
            use_underscores=False,
        )
    except TabletopError as error:
        print(escaped(f"error: {error}"), file=sys.stderr)
        return exit_code(error)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    return code or 0


if __name__ == "__main__":
    raise SystemExit(piped(lambda: run(sys.argv[1:])))
