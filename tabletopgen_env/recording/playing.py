"""The expert's episodes, as they are written: one after the other, or by several processes."""

from __future__ import annotations

import atexit
from collections import deque
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import closing
from contextvars import ContextVar
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import Any

import gymnasium as gym
import numpy as np
from jaxtyping import Float, Shaped

from generator.errors import SceneError
from generator.jobs.workers import WorkerPool

from ..learning.demonstrations.recorded import demonstrate
from .config import RecordConfig

CHUNK = 4
"""Most episodes that a process plays before it hands them over."""

Columns = dict[str, "Shaped[np.ndarray, 't1'] | list[str] | Columns"]
"""Arrays or texts of one row a step, by name, nested."""


@dataclass(frozen=True, eq=False)
class RecordedEpisode:
    """One episode of ``t`` steps; see the package's page."""

    observations: Shaped[np.ndarray, "t1 ..."] | dict[str, Shaped[np.ndarray, "t1 ..."]]
    actions: Float[np.ndarray, "t a"]
    rewards: Float[np.ndarray, "t"]
    infos: Columns
    facts: Mapping[str, str | int | bool]

    @property
    def arrays(self) -> dict[str, Any]:
        """Everything that has a row for each step, by name."""
        steps = len(self.rewards)
        return {
            "observations": self.observations,
            "actions": self.actions,
            "rewards": self.rewards,
            "terminations": np.zeros(steps, bool),
            "truncations": np.arange(1, steps + 1) == steps,
            "infos": self.infos,
        }


def play_episodes(
    config: RecordConfig, env: gym.Env[Any, Any], workers: int
) -> Generator[RecordedEpisode | SceneError, None, None]:
    """Yield one episode after the other without end, or why there is none to keep.

    They do not depend on the number of ``workers``; a single one plays in ``env``. Close it in the
    end.

    Raises:
        SceneError: a process has ended abruptly.
    """
    if workers == 1:
        yield from (_attempt(config, env, number) for number in count())
    few = min(CHUNK, -(-config.episodes // workers))
    with closing(WorkerPool(workers, begin=partial(_begin, config))) as pool:
        numbers, begun = count(0, few), count(0, few)
        ahead: deque[Future[list[RecordedEpisode | SceneError]]] = deque()
        for done in numbers:
            wanted = max(-(-(config.episodes - done) // few), 1)  # if all of them are kept
            while len(ahead) < min(2 * workers, wanted):
                ahead.append(pool.submit(_chunk, config, next(begun), few))
            yield from ahead.popleft().result()


_environment: ContextVar[gym.Env[Any, Any]] = ContextVar("_environment")  # of this process


def _begin(config: RecordConfig) -> None:
    """Make the environment of a process, kept until the process ends."""
    env = config.environment()
    atexit.register(env.close)
    _environment.set(env)


def _chunk(config: RecordConfig, first: int, few: int) -> list[RecordedEpisode | SceneError]:
    """Play the episodes of a process's turn."""
    return [_attempt(config, _environment.get(), first + k) for k in range(few)]


def _attempt(
    config: RecordConfig, env: gym.Env[Any, Any], number: int
) -> RecordedEpisode | SceneError:
    """Play one episode; return it, or why it is not kept."""
    seed = int(np.random.default_rng((config.seed, number)).integers(2**31))
    infos: list[dict[str, Any]] = []
    try:
        shown = demonstrate(env, seed, noise=config.noise, report=infos.append)
    except SceneError as error:
        return error
    if shown is None:
        return SceneError(f"the expert knows no way to {infos[0]['instruction']!r}")
    if not (shown.solved or config.keep_failures):
        return SceneError(f"the expert did not {shown.instruction!r}")
    world = env.get_wrapper_attr("world")
    facts = {
        "seed": seed,
        "instruction": shown.instruction,
        "scene": infos[0]["scene"],
        "digest": world.digest,
        "target": infos[0]["target"] or "",
        "goal": infos[0]["goal"] or "",
        "certified": infos[0]["certified"],
        "success": shown.solved,
        "steps": len(shown.actions),
    }
    return RecordedEpisode(shown.observations, shown.actions, shown.rewards, _columns(infos), facts)


def _columns(infos: Sequence[Mapping[str, Any]]) -> Columns:
    """Return what is kept of the infos of an episode."""
    terms = {
        name: np.array([info["reward_terms"][name] for info in infos], np.float32)
        for name in infos[0]["reward_terms"]
    }
    return {
        "success": np.array([info["success"] for info in infos], bool),
        "goal_index": np.array([info["goals"][0] for info in infos], np.int64),
        "target": [info["target"] or "" for info in infos],
        "goal": [info["goal"] or "" for info in infos],
        "instruction": [info["instruction"] for info in infos],
        "reward_terms": {**terms},
    }
