"""Cloning the expert with its advice on the learner's own states (DAgger, Ross et al. 2011).

The first round shows the expert at work, shaken so that it shows how to come back; in the others
the learner acts and the expert says what it would do. Everything said so far is fitted anew.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import gymnasium as gym
import numpy as np
import torch
from stable_baselines3 import SAC
from torch import nn

from generator.errors import require
from generator.threads import torch_threads

from ...episodes import episode_seeds
from .recorded import Demonstration, Policy, demonstrations


@dataclass(frozen=True)
class CloningConfig:
    """Settings of cloning.

    Attributes:
        rounds: rounds of advice; the first is the expert's own.
        episodes: episodes a round.
        expert_share: share of a later round's episodes in which the expert acts.
        noise: standard deviation of what shakes the expert.
        steps: gradient steps after each round; the last has ``last_steps``.
        batch: states a gradient step.
        learning_rate: Adam's highest; it rises and falls once a round.
    """

    rounds: int = 12
    episodes: int = 100
    expert_share: float = 0.2
    noise: float = 0.15
    steps: int = 2000
    last_steps: int = 8000
    batch: int = 512
    learning_rate: float = 1e-3

    def __post_init__(self) -> None:
        counts = ("rounds", "episodes", "steps", "last_steps", "batch")
        require(self, *counts, minimum=1, integer=True)
        require(self, "expert_share", minimum=0, maximum=1)
        require(self, "noise", minimum=0)
        require(self, "learning_rate", above=0)


@dataclass(frozen=True)
class Round:
    """How a round went: states so far, the share of its episodes solved, and the loss."""

    number: int
    states: int
    solved: float
    loss: float


@torch_threads(1)  # small networks are faster so
def clone(
    model: SAC,
    env: gym.Env[Any, np.ndarray],
    config: CloningConfig,
    seed: int,
    report: Callable[[Round], None] | None = None,
) -> list[Demonstration]:
    """Fit a model's actor, in place, to the expert's advice in ``env``; return every episode seen.

    ``seed`` is of the episodes and the batches; ``report`` is called after each round.
    """
    seeds = episode_seeds(seed, 2)
    generator = torch.Generator().manual_seed(seed)
    seen: list[Demonstration] = []
    for number in range(config.rounds):
        own = 0 if number == 0 else round(config.episodes * (1 - config.expert_share))
        shown = list(demonstrations(env, seeds, config.episodes - own, None, config.noise))
        tried = list(demonstrations(env, seeds, own, policy_of(model)))
        seen += shown + tried
        steps = config.last_steps if number == config.rounds - 1 else config.steps
        loss = fit(model, seen, steps, config, generator)
        judged = tried or shown
        if report:
            share = float(np.mean([d.solved for d in judged]))
            report(Round(number, sum(len(d.advice) for d in seen), share, loss))
    return seen


def policy_of(model: SAC) -> Policy:
    """Return what a model does in a state, without noise."""
    return lambda state: model.predict(state, deterministic=True)[0]


def fit(
    model: SAC,
    seen: Sequence[Demonstration],
    steps: int,
    config: CloningConfig,
    generator: torch.Generator,
) -> float:
    """Fit a model's actor to the advice in ``seen``; return the mean loss of the last tenth."""
    states = torch.from_numpy(np.concatenate([d.observations[:-1] for d in seen]))
    advice = torch.from_numpy(np.concatenate([d.advice for d in seen]))
    actor = model.actor
    optimiser = torch.optim.AdamW(actor.parameters(), config.learning_rate, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(
        optimiser, config.learning_rate, total_steps=steps
    )
    losses = []
    actor.set_training_mode(True)
    for _ in range(steps):
        rows = torch.randint(len(states), (config.batch,), generator=generator)
        loss = nn.functional.l1_loss(actor(states[rows], deterministic=True), advice[rows])
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(actor.parameters(), 1.0)
        optimiser.step()
        schedule.step()
        losses.append(float(loss.detach()))
    actor.set_training_mode(False)
    return float(np.mean(losses[-max(steps // 10, 1) :]))
