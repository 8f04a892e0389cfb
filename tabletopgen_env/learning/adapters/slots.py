"""Adapter from ``TabletopVectorEnv`` to Stable-Baselines3.

All slots share one scene source and its compiled scenes. Separate environments in subprocesses
would each compile and renew scenes of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.vector import AutoresetMode
from jaxtyping import Bool, Float
from stable_baselines3.common.env_util import is_wrapped
from stable_baselines3.common.vec_env import VecEnv

from generator.errors import InputError, require_seed

from ...parallel.vector import TabletopVectorEnv
from ...parallel.workers import pickling
from ...parallel.workers.slots import Job

_FINAL = ("final_obs", "final_info")


class SlotVecEnv(VecEnv):
    """A ``VecEnv`` of Stable-Baselines3 that wraps a ``TabletopVectorEnv``.

    The info of an episode's last step holds "terminal_observation" and "TimeLimit.truncated".

    Args:
        slots: the vector environment, created with ``autoreset_mode="SameStep"``.

    Raises:
        InputError: the vector environment has a different autoreset mode.
    """

    def __init__(self, slots: TabletopVectorEnv) -> None:
        mode = slots.autoreset_mode
        if mode is not AutoresetMode.SAME_STEP:
            raise InputError(
                "SlotVecEnv needs slots that reset in the step that ends an episode: create "
                f"the vector environment with autoreset_mode='SameStep', not {mode.value!r}."
            )
        self.slots = slots
        self._actions: Any = None
        super().__init__(slots.num_envs, slots.single_observation_space, slots.single_action_space)

    def reset(self) -> Any:
        """Reset all slots with the stored seeds and options; return their observations.

        Raises:
            InputError: the options differ between slots.
        """
        options = self._options[0]
        if any(other != options for other in self._options):
            raise InputError(
                "All slots must be reset with the same options: pass one dict to set_options, "
                f"got {self._options}."
            )
        seen, infos = self.slots.reset(seed=self._seeds, options=options or None)
        self.reset_infos = [row(infos, k) for k in range(self.num_envs)]
        self._reset_seeds()
        self._reset_options()
        return seen

    def seed(self, seed: int | None = None) -> Sequence[int | None]:
        """Derive one seed per slot from ``seed`` for the next reset."""
        if seed is None:
            return super().seed()
        require_seed(seed)
        self._seeds = [
            int(s) for s in np.random.SeedSequence((seed, 5)).generate_state(self.num_envs)
        ]
        return self._seeds

    def step_async(self, actions: np.ndarray) -> None:
        """Store the actions for ``step_wait``."""
        self._actions = actions

    def step_wait(
        self,
    ) -> tuple[Any, Float[np.ndarray, "n"], Bool[np.ndarray, "n"], list[dict[str, Any]]]:
        """Step all slots; return observations, rewards, done flags and infos."""
        seen, rewards, terminated, truncated, infos = self.slots.step(self._actions)
        done = terminated | truncated
        answers = []
        for k in range(self.num_envs):
            if done[k]:
                own = row(infos["final_info"], k)
                own["terminal_observation"] = infos["final_obs"][k]
                own["TimeLimit.truncated"] = bool(truncated[k] and not terminated[k])
                began = row(infos, k)
                self.reset_infos[k] = {n: v for n, v in began.items() if n not in _FINAL}
            else:
                own = row(infos, k)
            answers.append(own)
        return seen, rewards.astype(np.float32), done, answers

    def close(self) -> None:
        """Close the slots."""
        self.slots.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Return an attribute of the selected environments."""
        return self._visit(partial(pickling.get, name=attr_name), indices)

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Set an attribute of the selected environments."""
        self._visit(partial(pickling.put, name=attr_name, value=value), indices)

    def env_method(
        self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any
    ) -> list[Any]:
        """Call a method of each selected environment, in the process that runs it."""
        given = {"name": method_name, "args": method_args, "kwargs": method_kwargs}
        return self._visit(partial(pickling.call, **given), indices)

    def env_is_wrapped(self, wrapper_class: type[gym.Wrapper], indices: Any = None) -> list[bool]:
        """Return which of the selected environments are wrapped in ``wrapper_class``."""
        return self._visit(partial(is_wrapped, wrapper_class=wrapper_class), indices)

    def get_images(self) -> Sequence[np.ndarray | None]:
        """Return the rendered picture of each slot."""
        return self.slots.render()

    def _visit(self, work: Job, indices: Any) -> list[Any]:
        return self.slots.visit(work, self._get_indices(indices))


def row(infos: dict[str, Any], k: int) -> dict[str, Any]:
    """Extract the info of one slot from the infos of a Gymnasium vector environment."""
    own = {}
    for key, value in infos.items():
        mask = infos.get(f"_{key}")
        if mask is None or not mask[k]:
            continue
        picked = row(value, k) if isinstance(value, dict) else value[k]
        own[key] = picked.item() if isinstance(picked, np.generic) else picked
    return own
