"""Evaluation of policies on seeded episodes."""

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
"""Seed of evaluations during training: all runs and all evaluations use the same episodes."""

FRAME_EVERY = 4
"""Steps between two pictures of an episode."""


class Predicts(Protocol):
    """An object with ``predict``, such as a policy of this package or of Stable-Baselines3."""

    def predict(self, observation: Any, *, deterministic: bool) -> tuple[Any, Any]:
        """Return the action, and the policy's memory to pass as ``state`` to the next call."""
        ...


class EpisodePlayer:
    """A player that queries a policy during one episode and keeps the policy's memory."""

    def __init__(self, policy: Predicts) -> None:
        self._policy: Any = policy
        self._memory: Any = None

    def act(self, observation: Any) -> Any:
        """Return the action for an observation."""
        told = {} if self._memory is None else {"state": self._memory}
        action, self._memory = self._policy.predict(observation, deterministic=True, **told)
        return action


@dataclass(frozen=True)
class EpisodeResult:
    """The result of an episode.

    ``reward`` is the mean per step, and ``table`` is a digest of the table and its objects.
    """

    solved: bool
    steps: int
    reward: float
    instruction: str
    table: str


@dataclass(frozen=True)
class PolicyEvaluation:
    """Results of episodes on ``tables`` different tables; ``reward`` and ``steps`` are means."""

    episodes: int
    solved: int
    reward: float
    steps: float
    tables: int

    @property
    def share(self) -> float:
        """The fraction of episodes solved."""
        return self.solved / self.episodes

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % Wilson interval of the fraction of solved episodes."""
        return wilson(self.solved, self.episodes)

    def __str__(self) -> str:
        low, high = self.interval
        return (
            f"{self.solved} of {self.episodes} solved on {self.tables} "
            f"{'table' if self.tables == 1 else 'tables'}, {100 * self.share:.0f} % "
            f"({100 * low:.0f} to {100 * high:.0f} %)"
        )


def play(
    env: gym.Env[Any, np.ndarray], policy: Predicts, seed: int, frames: list[Any] | None = None
) -> EpisodeResult:
    """Run one episode until success is sustained (``episodes.Held``) or the time limit is reached.

    ``frames`` receives the return value of ``env.render`` at the start, every few steps and at the
    end.
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
    """Evaluate a policy on ``episodes`` episodes, determined by ``seed``."""
    return summarize([play(env, policy, own) for own in seeds(seed, episodes)])


def summarize(played: list[EpisodeResult]) -> PolicyEvaluation:
    """Summarise one or more episodes."""
    return PolicyEvaluation(
        len(played), sum(p.solved for p in played),
        float(np.mean([p.reward for p in played])), float(np.mean([p.steps for p in played])),
        len({p.table for p in played}),
    )  # fmt: skip


def seeds(seed: int, count: int) -> Iterator[int]:
    """Return the seeds of ``count`` episodes; shorter evaluations use the first of these seeds."""
    return islice(episode_seeds(seed, 3), count)
