"""The command ``certify``."""

from __future__ import annotations

import sys
from pathlib import Path

from tyro import conf

from generator.errors import InputError, TabletopError, exit_code
from generator.io.terminal import escaped

from .certificate import STARTS, Terms

_USUAL = Terms()


def certify(
    bundles: conf.Positional[tuple[str, ...]],
    /,
    *,
    tasks: tuple[str, ...] = _USUAL.tasks,
    episodes: int = _USUAL.episodes,
    most: int = _USUAL.most,
    seed: int = _USUAL.seed,
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
    import assets_cache

    from .certify import certify_all, is_certified

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
