"""The benchmark: one task of vla-eval for each task of TabletopGen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from vla_eval.benchmarks.base import StepBenchmark, StepResult
from vla_eval.render import configure_mujoco_render
from vla_eval.specs import IMAGE_RGB, LANGUAGE, POSITION_DELTA, DimSpec
from vla_eval.types import Action, EpisodeResult, Observation, Task

import tabletopgen_env  # registers the environments
from tabletopgen_env.episodes import EndOnSuccess

assert tabletopgen_env


class TabletopGenBenchmark(StepBenchmark):
    """Generated tables for vision-language-action models.

    Args:
        tasks: some of "Reach", "Lift", "Push", "PickPlace", "Stack", "Swap", "Sequence", "Tidy".
        scenes: scene source; None uses each task's own.
        cameras: cameras of the pictures.
        image_size: height and width of the pictures, pixels.
        seed: seed of the first episode.
        randomization: randomisation between episodes; None for none.
        max_episode_steps: maximum steps per episode; None uses the task's own.
    """

    render_backends = frozenset({"gpu", "cpu"})

    @classmethod
    def configure_render(cls, mode: str) -> dict[str, str]:
        """Choose MuJoCo's rendering backend."""
        return configure_mujoco_render(mode)

    def __init__(
        self,
        tasks: Sequence[str] = ("Lift",),
        scenes: str | Sequence[str] | None = None,
        cameras: Sequence[str] = ("front", "wrist"),
        image_size: int = 224,
        seed: int = 0,
        randomization: str | None = "starts",
        max_episode_steps: int | None = None,
    ) -> None:
        super().__init__()
        self._tasks, self._seed = tuple(tasks), seed
        limit = {} if max_episode_steps is None else {"max_episode_steps": max_episode_steps}
        chosen = list(scenes) if isinstance(scenes, list | tuple) else scenes
        self._settings: dict[str, Any] = {
            "scenes": chosen, "observation": "pixels+proprio", "cameras": list(cameras),
            "image_size": image_size, "randomization": randomization, **limit,
        }  # fmt: skip
        self._cameras = tuple(cameras)
        self._name, self._env = "", None

    def get_tasks(self) -> list[Task]:
        """Return the tasks."""
        return [{"name": name, "suite": "tabletopgen"} for name in self._tasks]

    def reset(self, task: Task) -> Any:
        """Begin the task's episode with the index ``episode_idx``."""
        name = str(task["name"])
        if self._env is None or name != self._name:
            self.cleanup()
            self._name = name
            self._env = EndOnSuccess(gym.make(f"TabletopGen/{name}-v0", **self._settings))
        seen, _ = self._env.reset(seed=self._seed + int(task.get("episode_idx", 0)))
        return seen

    def step(self, action: Action) -> StepResult:
        """Perform one step."""
        assert self._env is not None
        given = np.asarray(action.get("actions", action.get("action")), np.float64).ravel()
        seen, reward, ended, cut, info = self._env.step(five_of(given))
        done = bool(ended or cut)
        self._recorder.record_step(reward=float(reward), done=done, success=bool(ended))
        return StepResult(seen, float(reward), done, {**info, "held": bool(ended)})

    def make_obs(self, raw_obs: Any, task: Task) -> Observation:
        """Return pictures, instruction and proprioception."""
        return {
            "images": {name: raw_obs[name] for name in self._cameras},
            "task_description": raw_obs["instruction"],
            "state": raw_obs["proprio"],
        }

    def get_step_result(self, step_result: StepResult) -> EpisodeResult:
        """Return whether success has held."""
        return {"success": bool(step_result.info.get("held", False))}

    def get_action_spec(self) -> dict[str, DimSpec]:
        """Return the specification of actions."""
        turn = DimSpec("rotation", 1, "delta_yaw", (-1, 1), frozenset({"delta_yaw", "euler_xyz"}))
        grip = DimSpec(
            "gripper", 1, "binary_close_negative", (-1, 1),
            frozenset({"binary_close_negative", "binary_close_positive"}),
        )  # fmt: skip
        return {"position": POSITION_DELTA, "rotation": turn, "gripper": grip}

    def get_observation_spec(self) -> dict[str, DimSpec]:
        """Return the specification of observations."""
        state = DimSpec("state", 33, "tabletopgen_proprio33")
        return {"image": IMAGE_RGB, "language": LANGUAGE, "state": state}

    def get_hold_action(self, last_action: Action | None) -> Action:
        """Return an action that holds still, with the gripper at its last command."""
        held = np.zeros(5, np.float32)
        held[4] = 1.0
        if last_action is not None:
            held[4] = five_of(np.asarray(last_action["actions"], np.float64).ravel())[4]
        return {"actions": held}

    def get_metadata(self) -> dict[str, Any]:
        """Return the benchmark's settings."""
        return {"seed": self._seed, **self._settings}

    def render(self) -> np.ndarray | None:
        """Return the first camera's picture."""
        seen = self._last_result.obs
        return None if seen is None else seen[self._cameras[0]]

    def cleanup(self) -> None:
        """Free the environment."""
        if self._env is not None:
            self._env.close()
        self._env = None


def five_of(action: np.ndarray) -> np.ndarray:
    """Return an action of dx, dy, dz, dyaw and gripper (1 open), within [-1, 1].

    Of seven entries, roll and pitch are ignored, and the gripper closes at positive values.

    Raises:
        ValueError: there are neither five nor seven entries, or one is not finite.
    """
    if action.shape not in ((5,), (7,)) or not np.isfinite(action).all():
        raise ValueError(f"An action must have 5 or 7 finite entries, got {action.tolist()}.")
    if len(action) == 7:
        action = np.array([*action[:3], action[5], -action[6]])
    return np.clip(action, -1.0, 1.0).astype(np.float32)
