"""Scenes, environments and models of a recipe."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import gymnasium as gym
import numpy as np
from gymnasium import spaces
from gymnasium.envs.registration import EnvSpec
from stable_baselines3 import PPO, SAC, TD3, HerReplayBuffer
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.noise import NormalActionNoise
from stable_baselines3.common.torch_layers import (
    BaseFeaturesExtractor,
    CombinedExtractor,
    FlattenExtractor,
)
from stable_baselines3.common.vec_env import DummyVecEnv, VecEnv, VecMonitor
from torch import nn

from generator.errors import InputError, require_known, require_number

from ..parallel.vector import TabletopVectorEnv
from ..scenes import STARTER, CurriculumScenes, FreshScenes, SceneSource, resolve, split
from ..scenes.lookup import on_demand
from ..scenes.splits import Side, digest_of
from ..tasks.task import Task
from .adapters.slots import SlotVecEnv
from .networks.goal_extractor import GoalExtractor
from .networks.look_extractor import LookExtractor
from .networks.network import TableExtractor
from .networks.sight_extractor import SightExtractor
from .recipes import Network, Recipe

_CLASSES: dict[str, type[BaseAlgorithm]] = {"sac": SAC, "td3": TD3, "ppo": PPO, "clone": SAC}
_OURS = {
    "policy", "env", "seed", "policy_kwargs", "replay_buffer_class", "replay_buffer_kwargs",
    "tensorboard_log", "verbose", "device", "_init_setup_model", "rollout_buffer_class",
    "rollout_buffer_kwargs",
}  # fmt: skip

KEPT, MOST_KEPT = 16, 300
"""Number of compiled worlds that an environment caches, by default and at most for a source with
few scenes.
"""

ACTIVATIONS: dict[str, type[nn.Module]] = {"relu": nn.ReLU, "tanh": nn.Tanh}


def spec_of(task: str) -> EnvSpec:
    """Return the Gymnasium spec of a task."""
    import tabletopgen_env  # noqa: F401  (registers)

    return gym.spec(f"TabletopGen/{task}-v0")


def source_of(
    scenes: str | tuple[str, ...], side: Side, variants: int | None = None, task: Task | None = None
) -> SceneSource:
    """Return the source of a recipe's scenes; those generated on demand are limited to one split.

    ``variants`` is the total number of "fresh" tables on both sides, None for the default number;
    ``task`` is the task that scenes generated on demand must support, None for any.

    Raises:
        BundleError: no bundle matches.
        InputError: the source name is unknown.
    """
    chosen = list(scenes) if isinstance(scenes, tuple) else scenes
    needs, start = ((), STARTER) if task is None else (task.needs, task.scenes)
    made = on_demand(chosen)
    source = split(chosen, side, needs=needs, start=start) if made else resolve(chosen)
    return source if variants is None else _vary(source, variants)


def _vary(source: SceneSource, variants: int) -> SceneSource:
    """Return a source with ``variants`` fresh tables, or the source itself if it generates none."""
    if isinstance(source, CurriculumScenes) and isinstance(source.source, FreshScenes):
        return replace(source, source=_vary(source.source, variants))
    return replace(source, variants=variants) if isinstance(source, FreshScenes) else source


def worlds_kept(source: SceneSource) -> int:
    """Return the number of compiled worlds to cache for a source: all of them if there are few."""
    if isinstance(source, CurriculumScenes):
        inner = source.source
        return max(worlds_kept(inner) if isinstance(inner, SceneSource) else KEPT, source.size)
    if isinstance(source, FreshScenes) and source.variants <= MOST_KEPT:
        return source.variants
    return KEPT


def count_shared(source: SceneSource, other: SceneSource) -> int:
    """Count the available tables that have the same digest in both sources; draw no new ones.

    The initial tables of a refreshing pool are counted, too.

    Raises:
        BundleError: a bundle is missing or damaged.
    """

    def at_hand(source: SceneSource) -> set[str]:
        held = (source, getattr(source, "initial", None))
        return {digest_of(ref) for each in held for ref in getattr(each, "refs", ())}

    return len(at_hand(source) & at_hand(other))


def single_env(
    task: str, keywords: Mapping[str, Any], source: SceneSource, **more: Any
) -> gym.Env[Any, np.ndarray]:
    """Create one environment of a task with a recipe's settings and the registered time limit."""
    own = {"cache": worlds_kept(source), **keywords, **more}
    return gym.make(spec_of(task), scenes=source, **own)


def vector_env(recipe: Recipe, source: SceneSource) -> TabletopVectorEnv:
    """Create a recipe's training environments; closing them does not close the scene source."""
    limit = spec_of(recipe.task).max_episode_steps
    return TabletopVectorEnv(
        recipe.envs, processes=recipe.processes, autoreset_mode="SameStep",
        max_episode_steps=limit, task=recipe.task, scenes=source, cache=worlds_kept(source),
        **recipe.env,
    )  # fmt: skip


def many_envs(recipe: Recipe, source: SceneSource, seed: int) -> VecEnv:
    """Create a recipe's environments as a seeded ``VecEnv``."""
    made = VecMonitor(SlotVecEnv(vector_env(recipe, source)))
    made.seed(seed)
    return made


def new_model(recipe: Recipe, env: Any, seed: int) -> BaseAlgorithm:
    """Create an untrained model on the CPU for one environment or for those of ``many_envs``.

    ``seed`` determines its weights and exploration.

    Raises:
        InputError: the algorithm has no such option, or an option is invalid.
    """
    kind: Any = _CLASSES[recipe.algorithm]
    options = dict(recipe.options)
    known = set(inspect.signature(kind.__init__).parameters) - _OURS - {"self"}
    for key in options:
        require_known(key, known, f"{recipe.name}: {kind.__name__} has no option")
    noise = options.pop("action_noise", None)
    if noise is not None:
        require_number(f"{recipe.name}: options.action_noise", noise, minimum=0)
        size = env.action_space.shape
        options["action_noise"] = NormalActionNoise(np.zeros(size), np.full(size, float(noise)))
    if recipe.algorithm == "clone":
        options["buffer_size"] = 1  # no replay buffer needed
    if recipe.hindsight:
        _check_start(recipe)
        options["replay_buffer_class"] = HerReplayBuffer
        options["replay_buffer_kwargs"] = {"n_sampled_goal": recipe.hindsight}
    policy = "MultiInputPolicy" if isinstance(env.observation_space, spaces.Dict) else "MlpPolicy"
    try:
        return kind(
            policy, env, seed=seed, device="cpu",
            policy_kwargs=policy_keywords(recipe.network, env.observation_space), **options,
        )  # fmt: skip
    except (TypeError, ValueError, AssertionError) as error:
        raise InputError(f"{recipe.name}: {kind.__name__} rejects its options: {error}") from error


def blank_model(recipe: Recipe, like: gym.Env[Any, Any]) -> BaseAlgorithm:
    """Create a recipe's model for placeholder environments, with a one-step replay buffer for each.

    ``like`` provides the spaces of the environments; it is not changed.

    Raises:
        InputError: as for ``new_model``.
    """
    count = 1 if recipe.algorithm == "clone" else recipe.envs
    if recipe.algorithm in ("sac", "td3"):
        size = recipe.options.get("buffer_size", count)
        require_number(f"{recipe.name}: options.buffer_size", size, minimum=count, integer=True)
        recipe = replace(recipe, options={**recipe.options, "buffer_size": count})
    blanks = [lambda: _Blank(like)] * count
    return new_model(recipe, DummyVecEnv(blanks), 0)  # pyright: ignore[reportArgumentType]


class _Blank(gym.Env):
    """A placeholder environment that does nothing, with the spaces of another environment."""

    def __init__(self, like: gym.Env[Any, Any]) -> None:
        self.observation_space, self.action_space = like.observation_space, like.action_space


def load_zip(path: Path, recipe: Recipe) -> BaseAlgorithm:
    """Load a Stable-Baselines3 zip file; loading can execute arbitrary code in the file.

    Raises:
        InputError: the file is invalid, or belongs to a different algorithm.
    """
    if recipe.algorithm not in _CLASSES:
        raise InputError(
            f"{recipe.name}: {recipe.algorithm} does not write zip files. Use a policy file."
        )
    kind = _CLASSES[recipe.algorithm]
    try:
        return kind.load(path, device="cpu")
    except Exception as error:  # damaged files can raise any exception
        raise InputError(
            f"{path} cannot be loaded as {kind.__name__} ({type(error).__name__}: {error})."
        ) from error


def policy_keywords(network: Network, space: spaces.Space[Any]) -> dict[str, Any]:
    """Return a network's settings as ``policy_kwargs`` of Stable-Baselines3."""
    kind, keywords = extractor_of(network, space)
    own = {"normalize_images": False} if network.finds_grasps else {}  # the extractor scales it
    return {
        **own,
        "features_extractor_class": kind,
        "features_extractor_kwargs": keywords,
        "net_arch": list(network.layers),
        "activation_fn": ACTIVATIONS[network.activation],
    }


def extractor_of(
    network: Network, space: spaces.Space[Any]
) -> tuple[type[BaseFeaturesExtractor], dict[str, Any]]:
    """Return the class and keyword arguments of a network's features extractor."""
    if network.extractor == "flat":
        flat = CombinedExtractor if isinstance(space, spaces.Dict) else FlattenExtractor
        return cast("type[BaseFeaturesExtractor]", flat), {}
    kinds = {
        "table": TableExtractor, "goal": GoalExtractor, "look": LookExtractor,
        "sight": SightExtractor,
    }  # fmt: skip
    return kinds[network.extractor], {"width": network.width}


def _check_start(recipe: Recipe) -> None:
    """Check that hindsight learning does not start before an episode is complete."""
    limit = spec_of(recipe.task).max_episode_steps or 0
    first = limit * recipe.envs
    starts = recipe.options.get("learning_starts", 100)
    require_number(f"{recipe.name}: options.learning_starts", starts, minimum=0, integer=True)
    if not recipe.demonstrations and starts <= first:
        raise InputError(
            f"{recipe.name}: with hindsight, learning_starts must exceed {first}, the number of "
            f"steps of {recipe.envs} episodes of {recipe.task}, got {starts}."
        )
