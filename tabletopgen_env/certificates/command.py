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
    """Run the scripted expert on the tasks that bundles support; write a certificate into each.

    Bundles with a certificate for the same terms are skipped, so an interrupted command can be
    resumed by running it again; a certificate for other terms is replaced. Bundles that cannot be
    certified are listed at the end.

    Args:
        bundles: Names, digests, globs or paths of bundles, or folders of them.
        tasks: Tasks; Sequence includes its presets.
        episodes: Maximum number of episodes per instance: the first from the scene's own state, the
            others from perturbed initial states, none after a failure. Fewer than 30 certify
            nothing.
        most: Maximum number of instances per task.
        seed: Random seed; equal seeds give equal certificates.
        pool: Worker processes that run the expert; the machines of a Ray cluster must share the
            bundles.
        again: Certify all bundles, including those with a certificate.
    """
    import assets_cache

    from .certify import certify_all, is_certified

    if not bundles:
        raise InputError("Specify at least one bundle to certify.")
    terms = Terms(tasks, episodes, most, seed)
    if episodes < STARTS:
        print(f"Fewer than {STARTS} episodes per instance certify nothing.", file=sys.stderr)
    found = dict.fromkeys(path for wanted in bundles for path in assets_cache.find(wanted))
    waiting = [path for path in found if again or not is_certified(path, terms)]
    if len(waiting) < len(found):
        print(f"{len(found) - len(waiting)} of {len(found)} bundles are already certified.")
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
    finally:  # also after an interruption
        for path, error in failed:
            told = escape(f"error: {path.name} is not certified: {error}")
            print(told, file=sys.stderr)
    return exit_code(failed[0][1]) if failed else 0
