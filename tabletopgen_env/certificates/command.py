"""The command ``certify``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from tyro import conf

from generator.errors import InputError, TabletopError, escape, exit_code
from generator.jobs.pools import PoolOptions

from .certificate import STARTS, Terms

_USUAL, _POOL = Terms(), PoolOptions()


def certify(
    bundles: Annotated[conf.Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    tasks: tuple[str, ...] = _USUAL.tasks,
    episodes: int = _USUAL.episodes,
    most: int = _USUAL.most,
    seed: int = _USUAL.seed,
    pool: conf.OmitArgPrefixes[PoolOptions] = _POOL,
    again: bool = False,
) -> int:
    """Run the scripted expert on the tasks that bundles offer; write a certificate into each.

    Bundles with a certificate for the same terms are skipped, so an interrupted command resumes
    when it is run again; a certificate for other terms is replaced, not extended. Bundles that
    cannot be certified are listed at the end.

    Args:
        bundles: Names, digests, globs or paths of bundles, or folders of them.
        tasks: The tasks; Sequence includes its presets.
        episodes: Episodes of each instance at most: the first from the scene's own start, the
            others from perturbed starts, none after a failure. Fewer than 30 certify nothing.
        most: Instances of each task at most.
        seed: The same seed gives the same certificate.
        pool: Who plays; the machines of a Ray cluster share the bundles.
        again: Skip none.
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
        for path, certificate in certify_all(waiting, terms, pool.workers, pool.ray):
            if isinstance(certificate, TabletopError):
                failed.append((path, certificate))
                continue
            for seen in certificate.instances:
                asked = {"preset": seen.preset} if seen.preset else seen.options
                told = ", ".join(f"{name} {value}" for name, value in asked.items())
                print(escape(f"{path.name}: {seen.task} ({told or 'as drawn'}): "
                      f"{seen.successes} of {seen.episodes}"), flush=True)  # fmt: skip
    finally:  # also when it is interrupted
        for path, error in failed:
            told = escape(f"error: {path.name} is not certified: {error}")
            print(told, file=sys.stderr)
    return exit_code(failed[0][1]) if failed else 0
