"""Behaviour cloning of the expert by DAgger (Ross et al. 2011).

In the first round the expert acts, with noise added so that the data covers recovery from errors.
In later rounds the learner acts and the expert labels the visited states. After each round the
actor is fitted to the labels of all rounds.
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
"""Initial weights of the grasp head."""


@dataclass(frozen=True)
class CloningConfig:
    """Settings of cloning.

    Attributes:
        rounds: number of rounds; in the first one the expert acts.
        episodes: episodes per round.
        expert_share: share of a later round's episodes in which the expert acts.
        noise: standard deviation of the noise added to the expert's actions.
        steps: gradient steps after each round; the last round uses ``last_steps``.
        batch: states per gradient step.
        learning_rate: maximum learning rate of Adam; each round runs one warm-up and decay cycle.
        tables: number of tables with grasp demonstrations for the grasp head, if the policy has
            one. They differ from the tables of the rounds if the scenes are generated on demand.
        head_steps: gradient steps of the grasp head.
        head_start: initial weights of the grasp head: "nothing" for random weights, "detector" for
            the weights of the shipped grasp detector.
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
        require_known(self.head_start, get_args(HeadStart), "Unknown CloningConfig.head_start")
        require(self, "expert_share", minimum=0, maximum=1)
        require(self, "noise", minimum=0)
        require(self, "learning_rate", above=0)


@dataclass(frozen=True)
class Round:
    """The outcome of a cloning round: the count of states so far, the success rate and the loss."""

    number: int
    states: int
    solved: float
    loss: float


@torch_threads(1)  # faster for small networks
def clone(
    model: SAC,
    env: gym.Env[Any, np.ndarray],
    config: CloningConfig,
    seed: int,
    report: Callable[[Round], None] | None = None,
    kept: RoundsFolder | None = None,
) -> list[Demonstration]:
    """Train a model's actor in place to imitate the expert in ``env``; return all episodes.

    ``seed`` determines the episodes and the batches. ``report`` is called after each round. Each
    round is saved in ``kept``; rounds already there are not repeated.

    An actor with a grasp head (``networks.look_extractor``) is trained on motion features computed
    from the teacher's grasps; the head itself is not changed.
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
    """An iterator over seeds that counts how many were drawn."""

    def __init__(self, seeds: Iterator[int]) -> None:
        self._seeds, self.drawn = seeds, 0

    def __next__(self) -> int:
        self.drawn += 1
        return next(self._seeds)

    def skip(self, count: int) -> None:
        """Draw and discard ``count`` seeds."""
        for _ in range(count):
            next(self)


def looks(model: SAC) -> bool:
    """Return whether a model's actor has a grasp head."""
    return isinstance(model.actor.features_extractor, LookExtractor)


def moves_of(model: SAC) -> Callable[[Tensor], Tensor]:
    """Return a function that computes the actor's mean actions from states.

    For an actor with a grasp head, the states are those of a ``Teacher``, which include the
    features of the way to the grasp (``look_extractor``).
    """
    actor = model.actor
    extractor = actor.features_extractor
    if not isinstance(extractor, LookExtractor):
        return lambda states: actor(states, deterministic=True)
    return lambda states: torch.tanh(actor.mu(actor.latent_pi(extractor.table(states))))


def _acting(act: Callable[[Tensor], Tensor]) -> Policy:
    """Return a policy for single observations, based on an action function for batches."""

    def policy(state: Float[np.ndarray, "n"]) -> Float[np.ndarray, "a"]:
        with torch.no_grad():
            return act(torch.from_numpy(state)[None])[0].numpy()

    return policy


def policy_of(model: SAC) -> Policy:
    """Return a deterministic policy that runs the model on single observations."""
    return lambda state: model.predict(state, deterministic=True)[0]


def fit(
    model: SAC,
    seen: Sequence[Demonstration],
    steps: int,
    config: CloningConfig,
    generator: torch.Generator,
) -> float:
    """Fit an actor to the expert's actions in ``seen``; return the mean loss of the last steps."""
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
