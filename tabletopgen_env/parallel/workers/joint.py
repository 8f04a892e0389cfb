"""The environments of some slots, stepped together in one pass of the batched core."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.vector import AutoresetMode
from jaxtyping import Float, Int

from generator.errors import InputError

from ...env import TabletopEnv
from ...rendering.views import SLOTS
from ...settings import EnvConfig
from ...settings.core_limits import check_core
from ..core import rewards
from ..core.controls import Commands, RobotPose, advance, restart, start_commands
from ..core.flat_states import flat_states
from ..core.goal_rows import GoalRows, goal_vectors
from ..core.readings import Readings, WorldRows
from ..core.vectors import agreement
from .arrays import SlotArrays
from .slots import SlotSet, attempt

Slots = Int[np.ndarray, "k"]

_OBJECTS = 12  # initial capacity


def check_joint(config: EnvConfig) -> None:
    """Check that a config's environments can be stepped together.

    Raises:
        InputError: the observation or action mode is not supported by the batched core.
    """
    check_core(config, "An environment that is stepped together with others")
    if config.render.mode == "human":
        raise InputError("Slots that are stepped together do not support render_mode='human'.")


class JointSlots(SlotSet):
    """Slots whose control, observations and rewards are computed in one pass.

    Results agree with those of ``SlotSet`` up to rounding, but not bit for bit.

    Args:
        envs: unwrapped environments of one task and one config.
        mode: the autoreset mode.
        rows: their rows.
        limit: the time limit in steps; None for no limit.
    """

    def __init__(
        self, envs: Sequence[gym.Env], mode: AutoresetMode, rows: SlotArrays, limit: int | None
    ) -> None:
        super().__init__(envs, mode, rows)
        self._inner = [env for env in envs if isinstance(env, TabletopEnv)]
        assert len(self._inner) == len(envs)
        count, one = len(envs), self._inner[0]
        self._task, self._limit = one.task, limit
        self._goals = GoalRows.blank(count, self._task.most)
        self._active = np.zeros(count, int)
        self._steps = np.zeros(count, int)
        self._order = np.full((count, SLOTS), -1)
        self._reserve(_OBJECTS)
        self._commands: Commands = start_commands(np.zeros((count, 7)))
        self._begun = np.zeros(count, bool)  # since the last step

    def step_all(self, first: int) -> list[Any]:
        """Step or reset every slot; return the info or the error of each slot."""
        over = np.flatnonzero(self._rows.over).tolist()
        playing = np.flatnonzero(~self._rows.over)
        answers: list[Any] = [None] * len(self.envs)
        for k, info in self._advance(playing).items():
            answers[k] = attempt(lambda k, info=info: self._finish(k, info), k, first)
        for k in over:
            answers[k] = attempt(self.step, k, first)
        return answers

    def reset(self, k: int, **given: Any) -> dict[str, Any]:
        """Reset slot ``k``; return its info."""
        info = super().reset(k, **given)
        env = self._inner[k]
        if len(env.world.names) > self._half.shape[1]:
            self._reserve(len(env.world.names))
        self._goals.write(k, env.world, env.episode)
        self._take_order(k)
        self._steps[k] = 0
        self._begun[k] = True
        return info

    def _reserve(self, objects: int) -> None:
        """Reserve rows for worlds with up to ``objects`` objects."""
        self._gathered = WorldRows(len(self.envs), objects, self._task.most)
        self._half: Float[np.ndarray, "n k 3"] = np.zeros((len(self.envs), objects, 3))
        for k, env in enumerate(self._inner):
            if self._rows.playing[k]:
                self._take_order(k)
                self._gathered.copy(k, env.world, env.episode.goals)
        self._seen = self._gathered.read()

    def _take_order(self, k: int) -> None:
        """Store the object order, half extents and active goal of a slot."""
        env = self._inner[k]
        order = [env.world.index(name) for name in env.order]
        self._order[k], self._order[k, : len(order)] = -1, order
        self._half[k, : len(env.world.names)] = env.world.half_extent
        self._active[k] = env.active

    def _advance(self, playing: Slots) -> dict[int, dict[str, Any]]:
        """Step some slots; write their observations, and return their infos by slot."""
        one, task = self._inner[0], self._task
        self._steer(playing)
        for k in playing:
            self._inner[k].world.step(one.controller.servos.substeps)
        self._steps[playing] += 1
        self._seen = seen = self._read(playing)
        self._vectors = achieved, desired = goal_vectors(self._goals, seen)
        found = agreement(achieved.astype(float), desired.astype(float), task.aside)
        terms = rewards.terms(self._goals, seen, found, task.aside)
        paid = rewards.weigh(terms, one.weights, one.reward == "sparse")
        active, columns = found.active, {name: v.tolist() for name, v in terms.items()}
        infos: dict[int, dict[str, Any]] = {}
        for k in map(int, playing):
            own = {name: column[k] for name, column in columns.items()}
            infos[k] = self._inner[k].follow(int(active[k]), own)
            if active[k] != self._active[k]:
                self._take_order(k)
            self._rows.rewards[k] = paid[k]
        self._states = flat_states(
            self._goals, seen, self._active, self._order, self._half, one.shows_goals
        )
        return infos

    def _steer(self, playing: Slots) -> None:
        """Compute the servo commands for the current actions, and write them to the worlds."""
        one = self._inner[0]
        if self._begun.any():
            self._seen = self._read(np.flatnonzero(self._begun))
            self._commands = restart(self._commands, self._seen.joints, self._begun)
            self._begun[:] = False
        seen = self._seen
        wanted = self._rows.actions.copy()
        if self._task.closed:
            wanted[:, -1] = -1.0
        pose = RobotPose(seen.joints, seen.tool, seen.hand)
        mode, servos = one.action_mode, one.controller.servos
        self._commands, ctrl = advance(mode, servos, self._commands, pose, wanted)
        for k in playing:
            state = self._inner[k].world.state
            state.servos[:], state.gripper[0] = ctrl[k, :7], ctrl[k, 7]

    def _finish(self, k: int, info: dict[str, Any]) -> dict[str, Any]:
        """Write slot ``k``'s observation, or reset the slot after its episode; return its info."""
        rows, ended = self._rows, self._limit is not None and self._steps[k] >= self._limit
        seen, reward = self._observe(k), float(rows.rewards[k])
        rows.over[k] = ended
        if ended and self._mode == AutoresetMode.SAME_STEP:
            info = {"final_obs": seen, "final_info": info, **self.reset(k)}
        else:
            rows.show(k, seen)
        self._end(k, reward, False, bool(ended))
        return info

    def _observe(self, k: int) -> Any:
        if not self._inner[0].shows_goals:
            return self._states[k]
        achieved, desired = self._vectors
        return {"observation": self._states[k], "achieved_goal": achieved[k],
                "desired_goal": desired[k]}  # fmt: skip

    def _read(self, slots: Slots) -> Readings:
        """Refresh the readings of some slots; return the readings of all slots."""
        for k in slots:
            env = self._inner[k]
            self._gathered.copy(int(k), env.world, env.episode.goals)
        return self._gathered.read()
