"""Evaluation episodes of a policy, run in this process or in a pool of processes."""

from __future__ import annotations

import atexit
from collections.abc import Generator, Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import cloudpickle
import gymnasium as gym

from generator.jobs.pools import PoolOptions, pool_of
from generator.jobs.task_pool import call_once

from ..scenes.source import SceneSource, close
from ..tasks.registry import task_named
from .evaluation import EpisodeResult, Predicts, play
from .setup import single_env, source_of

STRIP = 6
"""Pictures in a film strip."""

Results = Generator[EpisodeResult, None, None]


@dataclass(frozen=True, eq=False)
class PolicyTrial:
    """A policy and its evaluation environment.

    Attributes:
        task: the policy's task.
        env: keyword arguments of its environment.
        scenes: names of scenes; only the held-out part of scenes generated on demand is used.
        policy: the policy.
    """

    task: str
    env: Mapping[str, Any]
    scenes: str | tuple[str, ...]
    policy: Predicts

    def source(self) -> SceneSource:
        """Open the scene source; the caller closes it.

        Raises:
            BundleError: no bundle matches.
            InputError: the source name is unknown.
        """
        return source_of(
            self.scenes, "held_out", task=task_named(self.task, self.env.get("preset"))
        )

    def play_here(
        self,
        seeds: Iterable[int],
        source: SceneSource,
        render: bool = False,
        strip: Path | None = None,
    ) -> Results:
        """Yield the results of episodes; show them, or save pictures of the first to ``strip``."""
        drawn: dict[str, Any] = {"render_mode": "human"} if render else {}
        if strip:
            drawn = {"render_mode": "rgb_array", "render_size": (240, 320)}
        with closing(single_env(self.task, self.env, source, **drawn)) as env:
            for number, seed in enumerate(seeds):
                frames: list[Any] | None = [] if strip and not number else None
                yield play(env, self.policy, seed, frames)
                if strip and frames:
                    _write_strip(frames, strip)

    def play_apart(self, seeds: Iterable[int], pool: PoolOptions) -> Results:
        """Yield the results of ``play_here`` in the same order, computed by processes of a pool.

        The policy is pickled; each process resolves the scenes itself.

        Raises:
            BackendError: Ray is not available.
            SceneError: a process ended unexpectedly.
        """
        packed = cloudpickle.dumps(partial(_set_up, self))
        with closing(pool_of(pool.workers, pool.ray)) as workers:
            yield from workers.map(partial(_play, packed), seeds)


def _set_up(trial: PolicyTrial) -> tuple[gym.Env[Any, Any], Predicts]:
    """Open an environment that stays open until this process ends; return it with the policy."""
    source = trial.source()
    env = single_env(trial.task, trial.env, source)
    atexit.register(close, source)
    atexit.register(env.close)
    return env, trial.policy


def _play(packed: bytes, seed: int) -> EpisodeResult:
    env, policy = call_once(packed)
    return play(env, policy, seed)


def _write_strip(frames: list[Any], path: Path) -> None:
    import numpy as np

    from generator.io.pictures import write_picture
    from generator.render.sheet import grid

    picks = np.linspace(0, len(frames) - 1, STRIP).round().astype(int)
    write_picture(grid([frames[k] for k in picks], columns=STRIP, cell=320), path)
