"""Cloning the expert with its advice on the learner's own states (DAgger, Ross et al. 2011).

The first round shows the expert at work, shaken so that it shows how to come back; in the others
the learner acts and the expert says what it would do. Everything said so far is fitted anew.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import gymnasium as gym
import numpy as np
import torch
from jaxtyping import Float
from stable_baselines3 import SAC
from torch import Tensor, nn

from generator.errors import require, require_known
from generator.threads import torch_threads

from ...episodes import episode_seeds
from ..networks.look_extractor import LookExtractor
from .recorded import Demonstration, Policy, demonstrations
from .rounds import RoundsFolder

HeadStart = Literal["nothing", "detector"]
"""What the head of a policy that looks starts from."""


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
        tables: tables at which the expert shows its grasps first, to a policy that looks; they are
            others than those of the rounds where ever new ones can be made.
        head_steps: gradient steps by which its head learns from them.
        head_start: what the head starts from: "nothing", or "detector" for the weights of the
            shipped grasp detector.
    """

    rounds: int = 12
    episodes: int = 100
    expert_share: float = 0.2
    noise: float = 0.15
    steps: int = 2000
    last_steps: int = 8000
    batch: int = 512
    learning_rate: float = 1e-3
    tables: int = 1000
    head_steps: int = 4000
    head_start: HeadStart = "nothing"

    def __post_init__(self) -> None:
        counts = ("rounds", "episodes", "steps", "last_steps", "batch")
        require(self, *counts, "tables", minimum=1, integer=True)
        require(self, "head_steps", minimum=0, integer=True)
        require_known(self.head_start, get_args(HeadStart), "CloningConfig has no head_start")
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
    kept: RoundsFolder | None = None,
) -> list[Demonstration]:
    """Fit a model's actor, in place, to the expert's advice in ``env``; return every episode seen.

    ``seed`` is of the episodes and the batches; ``report`` is called after each round. Rounds go to
    ``kept``, and those that are there already are not done again.

    An actor that looks (``networks.look_extractor``) is taught on the ways of the teacher's grasps;
    its head, which finds its own, is left as it is.
    """
    seeds = CountedSeeds(episode_seeds(seed, 2))
    generator = torch.Generator().manual_seed(seed)
    seen: list[Demonstration] = []
    taught = looks(model)
    policy = _acting(moves_of(model)) if taught else policy_of(model)
    if kept is not None:
        seen, drawn = kept.read(model.actor, generator)
        seeds.skip(drawn)
    for number in range(0 if kept is None else kept.done, config.rounds):
        own = 0 if number == 0 else round(config.episodes * (1 - config.expert_share))
        shown = list(demonstrations(env, seeds, config.episodes - own, None, config.noise, taught))
        tried = list(demonstrations(env, seeds, own, policy, taught=taught))
        seen += shown + tried
        steps = config.last_steps if number == config.rounds - 1 else config.steps
        loss = fit(model, seen, steps, config, generator)
        if kept is not None:
            kept.keep(number, shown + tried, model.actor, generator, seeds.drawn)
        judged = tried or shown
        if report:
            share = float(np.mean([d.solved for d in judged]))
            report(Round(number, sum(len(d.advice) for d in seen), share, loss))
    return seen


class CountedSeeds(Iterator[int]):
    """Seeds, and how many were drawn."""

    def __init__(self, seeds: Iterator[int]) -> None:
        self._seeds, self.drawn = seeds, 0

    def __next__(self) -> int:
        self.drawn += 1
        return next(self._seeds)

    def skip(self, count: int) -> None:
        """Draw ``count`` seeds."""
        for _ in range(count):
            next(self)


def looks(model: SAC) -> bool:
    """Return whether a model's actor finds grasps by itself."""
    return isinstance(model.actor.features_extractor, LookExtractor)


def moves_of(model: SAC) -> Callable[[Tensor], Tensor]:
    """Return what a model's actor does in states, as a ``Teacher`` shows them if it looks."""
    actor = model.actor
    extractor = actor.features_extractor
    if not isinstance(extractor, LookExtractor):
        return lambda states: actor(states, deterministic=True)
    return lambda states: torch.tanh(actor.mu(actor.latent_pi(extractor.table(states))))


def _acting(act: Callable[[Tensor], Tensor]) -> Policy:
    """Return a policy that does what ``act`` says."""

    def policy(state: Float[np.ndarray, "n"]) -> Float[np.ndarray, "a"]:
        with torch.no_grad():
            return act(torch.from_numpy(state)[None])[0].numpy()

    return policy


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
    actor, act = model.actor, moves_of(model)
    learned = [p for p in actor.parameters() if p.requires_grad]
    optimiser = torch.optim.AdamW(learned, config.learning_rate, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(
        optimiser, config.learning_rate, total_steps=steps
    )
    losses = []
    actor.set_training_mode(True)
    for _ in range(steps):
        rows = torch.randint(len(states), (config.batch,), generator=generator)
        loss = nn.functional.l1_loss(act(states[rows]), advice[rows])
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(learned, 1.0)
        optimiser.step()
        schedule.step()
        losses.append(float(loss.detach()))
    actor.set_training_mode(False)
    return float(np.mean(losses[-max(steps // 10, 1) :]))
