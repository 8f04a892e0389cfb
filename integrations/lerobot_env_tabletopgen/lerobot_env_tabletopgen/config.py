"""The configuration from which LeRobot makes the environments."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import partial
from typing import Any

import gymnasium as gym
from gymnasium.vector import AutoresetMode
from lerobot.configs import FeatureType, PolicyFeature
from lerobot.envs.configs import EnvConfig
from lerobot.utils.constants import ACTION, OBS_IMAGES, OBS_STATE

from .view import PROPRIO, make_lerobot_env

_ACTION = 5


@EnvConfig.register_subclass("tabletopgen")
@dataclass
class TabletopGenEnvConfig(EnvConfig):
    """Settings of a policy's evaluation.

    Attributes:
        task: "Reach", "Lift", "Push", "PickPlace", "Stack", "Swap", "Sequence" or "Tidy".
        fps: actions per second; a divisor of 500.
        scenes: scene sources, separated by commas; "" uses the task's own.
        cameras: cameras of the pictures, separated by commas.
        image_size: height and width of the pictures, pixels.
        randomization: "starts", "light", "strong" or "none".
        episode_length: maximum steps per episode; 0 uses the task's own.
    """

    task: str | None = "Lift"
    fps: int = 20
    scenes: str = "starter:held_out"
    cameras: str = "front,wrist"
    image_size: int = 224
    randomization: str = "starts"
    episode_length: int = 0
    features: dict[str, PolicyFeature] = field(default_factory=dict)
    features_map: dict[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        shape = (self.image_size, self.image_size, 3)
        self.features = {
            ACTION: PolicyFeature(type=FeatureType.ACTION, shape=(_ACTION,)),
            "agent_pos": PolicyFeature(type=FeatureType.STATE, shape=(PROPRIO,)),
            **{
                f"pixels/{name}": PolicyFeature(type=FeatureType.VISUAL, shape=shape)
                for name in self.names
            },
        }
        self.features_map = {
            ACTION: ACTION,
            "agent_pos": OBS_STATE,
            **{f"pixels/{name}": f"{OBS_IMAGES}.{name}" for name in self.names},
        }

    @property
    def names(self) -> list[str]:
        """The cameras' names."""
        return [name.strip() for name in self.cameras.split(",") if name.strip()]

    @property
    def gym_kwargs(self) -> dict[str, Any]:
        """The keyword arguments of ``make_lerobot_env``."""
        scenes = [name.strip() for name in self.scenes.split(",") if name.strip()]
        return {
            "task": self.task or "Lift", "scenes": scenes or None, "cameras": self.names,
            "image_size": self.image_size, "control_hz": self.fps,
            "randomization": None if self.randomization == "none" else self.randomization,
            "max_episode_steps": self.episode_length or None,
        }  # fmt: skip

    def create_envs(
        self, n_envs: int, use_async_envs: bool = False
    ) -> dict[str, dict[int, gym.vector.VectorEnv]]:
        """Return ``n_envs`` environments that are stepped together, as the suite's only task."""
        make = [partial(make_lerobot_env, **self.gym_kwargs)] * n_envs
        mode = AutoresetMode.SAME_STEP
        if use_async_envs and n_envs > 1:
            vector: gym.vector.VectorEnv = gym.vector.AsyncVectorEnv(
                make, autoreset_mode=mode, context="spawn"
            )
        else:
            vector = gym.vector.SyncVectorEnv(make, autoreset_mode=mode)
        return {self.type: {0: vector}}
