"""How often a policy succeeds, on episodes that the seed alone decides."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any, Protocol

import gymnasium as gym
import numpy as np

from ..episodes import Held, episode_seeds
from ..statistics import wilson

SEED = 10_000
"""Of evaluations during training: each run, and each time, sees the same episodes."""

FRAME_EVERY = 4
"""Steps between the pictures of an episode."""


class Predicts(Protocol):
    """A policy of this package, or a model of Stable-Baselines3."""

    def predict(self, observation: Any, *, deterministic: bool) -> tuple[Any, Any]:
        """Return the action, and what it remembers; if that is not None it is given ``state``."""
        ...


class EpisodePlayer:
    """Asks a policy for actions through one episode, and hands on what it remembers."""

    def __init__(self, policy: Predicts) -> None:
        self._policy: Any = policy
        self._memory: Any = None

    def act(self, observation: Any) -> Any:
        """Return the action."""
        told = {} if self._memory is None else {"state": self._memory}
        action, self._memory = self._policy.predict(observation, deterministic=True, **told)
        return action


@dataclass(frozen=True)
class EpisodeResult:
    """One episode: ``reward`` is the mean of a step, ``table`` the table's and objects' digest."""

    solved: bool
    steps: int
    reward: float
    instruction: str
    table: str


@dataclass(frozen=True)
class PolicyEvaluation:
    """What episodes at ``tables`` different tables came to; ``reward`` and ``steps`` are means."""

    episodes: int
    solved: int
    reward: float
    steps: float
    tables: int

    @property
    def share(self) -> float:
        """The share that was solved."""
        return self.solved / self.episodes

    @property
    def interval(self) -> tuple[float, float]:
        """Wilson's 95 % interval of the share."""
        return wilson(self.solved, self.episodes)

    def __str__(self) -> str:
        low, high = self.interval
        return (
            f"{self.solved} of {self.episodes} solved at {self.tables} "
            f"{'table' if self.tables == 1 else 'tables'}, {100 * self.share:.0f} % "
            f"({100 * low:.0f} to {100 * high:.0f} %)"
        )


def play(
    env: gym.Env[Any, np.ndarray], policy: Predicts, seed: int, frames: list[Any] | None = None
) -> EpisodeResult:
    """Play one episode until success has held (``episodes.Held``), or to the time limit.

    ``frames`` gets what ``env.render`` returns at the start, every few steps and at the end.
    """
    seen, info = env.reset(seed=seed)
    if frames is not None:
        frames.append(env.render())
    rewards: list[float] = []
    held, over, solved = Held(), False, False
    player = EpisodePlayer(policy)
    while not (over or solved):
        action = player.act(seen)
        seen, reward, ended, cut, info = env.step(action)
        rewards.append(float(reward))
        over, solved = ended or cut, held.after(info)
        if frames is not None and (len(rewards) % FRAME_EVERY == 0 or over or solved):
            frames.append(env.render())
    table = env.get_wrapper_attr("world").digest
    return EpisodeResult(
        solved, len(rewards), float(np.mean(rewards)), str(info["instruction"]), table
    )


def evaluate(
    env: gym.Env[Any, np.ndarray], policy: Predicts, episodes: int, seed: int = SEED
) -> PolicyEvaluation:
    """Play ``episodes`` episodes, those that ``seed`` means."""
    return summarize([play(env, policy, own) for own in seeds(seed, episodes)])


def summarize(played: list[EpisodeResult]) -> PolicyEvaluation:
    """Return what episodes, one or more, came to."""
    return PolicyEvaluation(
        len(played), sum(p.solved for p in played),
        float(np.mean([p.reward for p in played])), float(np.mean([p.steps for p in played])),
        len({p.table for p in played}),
    )  # fmt: skip


def seeds(seed: int, count: int) -> Iterator[int]:
    """Return the seeds of ``count`` episodes; a longer evaluation begins with a shorter one's."""
    return islice(episode_seeds(seed, 3), count)
