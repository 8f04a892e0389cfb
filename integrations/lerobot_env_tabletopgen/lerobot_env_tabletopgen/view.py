"""An environment in the form that LeRobot's evaluation expects; does not import LeRobot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium import spaces

import tabletopgen_env  # registers the environments
from tabletopgen_env.env import OPTIONS
from tabletopgen_env.episodes import EndOnSuccess

PROPRIO = 33
"""Number of proprioception entries."""

assert tabletopgen_env


class LeRobotView(gym.ObservationWrapper):
    """Renames "pixels+proprio" for LeRobot: ``pixels`` by camera, and ``agent_pos``.

    ``task_description`` is the episode's instruction. ``info["is_success"]``, of which LeRobot
    checks whether it was ever true, is only true in the step that ends the episode because success
    has held.
    """

    def __init__(self, env: EndOnSuccess) -> None:
        super().__init__(env)
        assert isinstance(env.observation_space, spaces.Dict)
        parts = dict(env.observation_space.spaces)
        parts.pop("instruction")
        agent = parts.pop("proprio")
        self._cameras = tuple(parts)
        self.observation_space = spaces.Dict({"pixels": spaces.Dict(parts), "agent_pos": agent})
        self.task_description = ""
        self.task = ""

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, Any]]:
        """Begin an episode; LeRobot's own options are ignored."""
        known = {name: value for name, value in (options or {}).items() if name in OPTIONS}
        seen, info = super().reset(seed=seed, options=known)
        return seen, {**info, "is_success": False}

    def step(self, action: np.ndarray) -> tuple[dict[str, Any], float, bool, bool, dict[str, Any]]:
        """Perform one step."""
        seen, reward, ended, cut, info = super().step(action)
        return seen, float(reward), ended, cut, {**info, "is_success": ended}

    def observation(self, observation: dict[str, Any]) -> dict[str, Any]:
        """Return an observation with LeRobot's names."""
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
    """Return an environment for LeRobot; the arguments are those of the configuration."""
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
