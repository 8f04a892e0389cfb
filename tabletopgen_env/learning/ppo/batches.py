"""A recipe's environments as one batch on MuJoCo Warp, instead of environments on the CPU."""

from __future__ import annotations

from dataclasses import dataclass, fields

from generator.errors import InputError, require, require_known

from ...parallel.batch.bank import MOST_OBJECTS
from ...parallel.batch.decks import DeckConfig
from ...parallel.batch.engine import find_device
from ...parallel.batch.env import TabletopBatchEnv
from ...scenes import SceneSource
from ...tasks.registry import task_named
from ..recipes import Recipe
from ..setup import spec_of


@dataclass(frozen=True)
class BatchConfig:
    """Settings of a batch, from the TOML table ``batch`` of a recipe; see ``TabletopBatchEnv``.

    Attributes:
        device: "cuda", "cuda:<number>" or "cpu" (slow, for tests), for simulation and training.
        scenes: number of scenes, drawn once per run; None for the default number, or for all scenes
            of a fixed source.
        episodes: number of episodes drawn in advance per scene.
        max_objects: scenes with more objects are left out.

    Raises:
        InputError: a value is out of range, or the device does not exist.
    """

    device: str = "cuda"
    scenes: int | None = None
    episodes: int = 8
    max_objects: int = MOST_OBJECTS

    def __post_init__(self) -> None:
        DeckConfig(self.scenes, self.episodes)
        require(self, "max_objects", minimum=1, integer=True)
        find_device(self.device)


def batch_config(recipe: Recipe) -> BatchConfig | None:
    """Return the settings of a recipe's batch, or None if it has none.

    Raises:
        InputError: a setting is unknown or out of range, or the device does not exist.
    """
    if recipe.batch is None:
        return None
    known = {f.name for f in fields(BatchConfig)}
    for key in recipe.batch:
        require_known(key, known, f"{recipe.name}: a batch has no setting")
    try:
        return BatchConfig(**recipe.batch)
    except InputError as error:
        raise InputError(f"{recipe.name}: batch: {error}") from error


def batch_env(
    recipe: Recipe, config: BatchConfig, source: SceneSource, seed: int
) -> TabletopBatchEnv:
    """Create a recipe's batch; ``seed`` determines its scenes and episodes.

    Raises:
        InputError: a setting is not available for batches, memory is insufficient, or no scene is
            left.
    """
    settings = {key: value for key, value in recipe.env.items() if key != "preset"}
    return TabletopBatchEnv(
        recipe.envs, source, task_named(recipe.task, recipe.env.get("preset")), config.device,
        max_objects=config.max_objects, deck=DeckConfig(config.scenes, config.episodes, seed=seed),
        max_episode_steps=spec_of(recipe.task).max_episode_steps, **settings,
    )  # fmt: skip
