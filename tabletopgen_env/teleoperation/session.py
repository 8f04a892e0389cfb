"""Episodes controlled by a person, or by a policy until a person takes over."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

import gymnasium as gym
import numpy as np

from generator.errors import InputError

from ..episodes import Held
from ..learning.evaluation import EpisodePlayer, Predicts
from ..observations.proprioception import feel
from ..rendering.config import CameraName
from .inputs import HumanInput, Operator

By = Literal["human", "policy"]


@dataclass(frozen=True)
class TeleopStatus:
    """Status of an episode.

    Attributes:
        instruction: the instruction.
        by: the last actor.
        step: number of steps so far.
        success: whether the task is solved now.
        over: "solved" once success has held, "time" at the time limit, None before.
        gripper: the last gripper command, "open" or "closed".
        kept: number of episodes kept so far.
    """

    instruction: str
    by: By
    step: int
    success: bool
    over: Literal["solved", "time"] | None
    gripper: Literal["open", "closed"]
    kept: int


@dataclass(frozen=True, eq=False)
class TeleopEpisode:
    """The data of an episode; ``by_human`` has an entry per action: whether a person chose it."""

    seed: int
    observations: list[Any]
    actions: list[np.ndarray]
    rewards: list[float]
    infos: list[dict[str, Any]]
    felt: list[np.ndarray]
    by_human: list[bool]
    digest: str
    solved: bool


class TeleopSession:
    """A player that drives "ee_delta" episodes with an operator's input.

    The policy, if any, acts until the person moves the arm or the gripper; then the person acts
    until the event "policy".

    Args:
        env: an environment with a time limit.
        view: the camera on display.
        policy: the policy that acts while the person does not.

    Raises:
        InputError: the environment has another action mode.
    """

    def __init__(
        self, env: gym.Env[Any, np.ndarray], view: CameraName, policy: Predicts | None = None
    ) -> None:
        mode = env.get_wrapper_attr("action_mode")
        if mode != "ee_delta":
            raise InputError(f"Teleoperation requires action='ee_delta', got {mode!r}.")
        self._env, self._policy, self._operator = env, policy, Operator(view)
        self._episode: TeleopEpisode | None = None
        self._held = Held()
        self._player: EpisodePlayer | None = None
        self._by: By = "human"
        self._over: Literal["solved", "time"] | None = None
        self.kept = 0

    @property
    def status(self) -> TeleopStatus:
        """The status of the episode."""
        episode = self._current()
        info = episode.infos[-1]
        gripper = "open" if self._operator.gripper > 0 else "closed"
        return TeleopStatus(
            str(info["instruction"]), self._by, len(episode.actions), bool(info["success"]),
            self._over, gripper, self.kept,
        )  # fmt: skip

    def begin(self, seed: int) -> None:
        """Begin an episode."""
        seen, info = self._env.reset(seed=seed)
        world = self._env.get_wrapper_attr("world")
        felt = [feel(world)]
        self._episode = TeleopEpisode(seed, [seen], [], [], [info], felt, [], world.digest, False)
        self._held, self._over = Held(), None
        self._player = None if self._policy is None else EpisodePlayer(self._policy)
        self._by = "human" if self._policy is None else "policy"
        self._operator.restart()

    def advance(self, given: HumanInput) -> TeleopEpisode | Literal["dropped"] | None:
        """Advance by a step; return a kept episode, "dropped" for a dropped one, or else None.

        A finished episode waits for either event. An episode without steps cannot be kept.
        """
        episode, command = self._current(), self._operator.read(given)
        if "drop" in command.events:
            return "dropped"
        if "keep" in command.events and episode.actions:
            self.kept += 1
            return replace(episode, solved=self._over == "solved")
        if self._over is None:
            if command.acts:
                self._by = "human"
            elif "policy" in command.events and self._policy is not None:
                self._by = "policy"
            self._step(command.action)
        return None

    def _step(self, asked: np.ndarray) -> None:
        """Step the environment with the person's action, or with the policy's."""
        episode, action = self._current(), asked
        if self._by == "policy":
            assert self._player is not None
            action = self._player.act(episode.observations[-1])
            self._operator.follow(float(action[-1]))
        seen, reward, ended, cut, info = self._env.step(action)
        episode.observations.append(seen)
        episode.actions.append(np.asarray(action, np.float32))
        episode.rewards.append(float(reward))
        episode.infos.append(info)
        episode.felt.append(feel(self._env.get_wrapper_attr("world")))
        episode.by_human.append(self._by == "human")
        if self._held.after(info):
            self._over = "solved"
        elif ended or cut:
            self._over = "time"

    def _current(self) -> TeleopEpisode:
        if self._episode is None:
            raise InputError("Call begin() before driving.")
        return self._episode
