"""An environment as LeRobot's evaluation sees it; needs nothing of LeRobot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium import spaces

import tabletopgen_env  # registers the environments
from tabletopgen_env.episodes import EndOnSuccess

PROPRIO = 33
"""Entries of what the robot feels of itself."""

assert tabletopgen_env


class LeRobotView(gym.ObservationWrapper):
    """Shows "pixels+proprio" by LeRobot's names: ``pixels`` by camera, and ``agent_pos``.

    ``task_description`` is what is to be done in the episode.
    """

    def __init__(self, env: gym.Env[Any, Any]) -> None:
        super().__init__(env)
        assert isinstance(env.observation_space, spaces.Dict)
        parts = dict(env.observation_space.spaces)
        parts.pop("instruction")
        agent = parts.pop("proprio")
        self._cameras = tuple(parts)
        self.observation_space = spaces.Dict({"pixels": spaces.Dict(parts), "agent_pos": agent})
        self.task_description = ""
        self.task = ""

    def observation(self, observation: dict[str, Any]) -> dict[str, Any]:
        """Return an observation by LeRobot's names."""
        self.task_description = self.task = str(observation["instruction"])
        pixels = {name: observation[name] for name in self._cameras}
        return {"pixels": pixels, "agent_pos": np.asarray(observation["proprio"])}


def make_lerobot_env(
    task: str,
    scenes: Sequence[str] | None,
    cameras: Sequence[str],
    image_size: int,
    control_hz: int,
    randomization: str | None,
    max_episode_steps: int | None,
) -> LeRobotView:
    """Return an environment for LeRobot; arguments are those of the configuration."""
    limit: dict[str, Any] = (
        {} if max_episode_steps is None else {"max_episode_steps": max_episode_steps}
    )
    env = gym.make(
        f"TabletopGen/{task}-v0", scenes=None if scenes is None else list(scenes),
        observation="pixels+proprio", cameras=list(cameras), image_size=image_size,
        control_hz=control_hz, randomization=randomization, render_mode="rgb_array",
        render_size=240, **limit,
    )  # fmt: skip
    return LeRobotView(EndOnSuccess(env))
