"""Training of a recipe with PPO on a batch of worlds."""

from __future__ import annotations

import math
from contextlib import closing, suppress
from dataclasses import asdict, fields
from typing import Any

import numpy as np
from gymnasium import spaces

from generator.errors import InputError, require_known

from ...parallel.batch.env import TabletopBatchEnv
from ...scenes import SceneSource
from ..interrupt import StopAsked
from ..networks.actor import inputs_of
from ..progress import Pauses, Tracker
from ..recipes import Recipe
from ..setup import vector_env
from .batches import batch_config, batch_env
from .config import PPOConfig
from .ppo import BatchPPO, UpdateFigures
from .worlds import Seen, TensorWorlds


def learn_in_batches(tracker: Tracker, scenes: SceneSource) -> int:
    """Train on a batch of worlds; return the total number of steps.

    All worlds are reset after each evaluation, with seeds that depend only on the number of steps,
    so that a resumed run equals an uninterrupted one.
    """
    run, seed = tracker.run, tracker.plan.seed
    config = batch_config(run.recipe)
    made = (
        vector_env(run.recipe, scenes) if config is None
        else batch_env(run.recipe, config, scenes, seed)
    )  # fmt: skip
    with closing(TensorWorlds(made)) as worlds:
        learner = new_ppo(run.recipe, worlds.env, seed, worlds)
        tracker.counts, _ = run.restore(learner)
        steps = tracker.counts.steps
        if tracker.is_finished():
            return steps
        with suppress(StopAsked), closing(Pauses(tracker)) as pauses:
            seen = _reset(worlds, seed, steps)
            while steps < run.recipe.steps:
                if pauses.pause(learner, steps):
                    seen = _reset(worlds, seed, steps)
                seen, rollout = learner.collect(worlds, seen)
                figures = learner.update(rollout)
                steps += rollout.over.numel()
                tracker.learned = True
                _log(tracker, figures, steps)
        tracker.end(learner, steps)
        return steps


def ppo_config(recipe: Recipe) -> PPOConfig:
    """Return a recipe's PPO settings.

    Raises:
        InputError: a setting is unknown or out of range.
    """
    known = {f.name for f in fields(PPOConfig)}
    for key in recipe.options:
        require_known(key, known, f"{recipe.name}: {recipe.algorithm} has no option")
    config = PPOConfig(**recipe.options)
    if recipe.envs * config.rollout < config.minibatches:
        raise InputError(
            f"{recipe.name}: {recipe.envs * config.rollout} steps per rollout cannot be split "
            f"into {config.minibatches} minibatches."
        )
    return config


def new_ppo(recipe: Recipe, like: Any, seed: int, worlds: TensorWorlds | None = None) -> BatchPPO:
    """Create an untrained learner for the spaces of a single or vector environment.

    It trains on the device of ``worlds``, or on the CPU if that is None.

    Raises:
        InputError: the recipe has an unknown option, or the observations are pictures or point
            clouds.
    """
    seen = getattr(like, "single_observation_space", like.observation_space)
    acts = getattr(like, "single_action_space", like.action_space)
    assert isinstance(acts, spaces.Box)
    device = "cpu" if worlds is None else worlds.device
    return BatchPPO(
        recipe.network, inputs_of(seen), int(np.prod(acts.shape)), ppo_config(recipe), seed, device
    )  # fmt: skip


def _reset(worlds: TensorWorlds, seed: int, steps: int) -> Seen:
    """Reset the worlds with seeds derived from the run's seed and the number of steps so far."""
    state = np.random.SeedSequence((seed, steps, 6)).generate_state(worlds.count)
    seeds = [int(s) % 2**31 for s in state]
    return worlds.reset(seeds[0] if isinstance(worlds.env, TabletopBatchEnv) else seeds)


def _log(tracker: Tracker, figures: UpdateFigures, steps: int) -> None:
    for name, value in asdict(figures).items():
        if not math.isnan(value):
            tracker.logger.record(f"train/{name}", value)
    tracker.logger.dump(steps)
