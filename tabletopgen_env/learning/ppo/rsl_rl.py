"""Adapter from vector environments to ``rsl_rl`` (rsl-rl-lib 5).

    from rsl_rl.runners import OnPolicyRunner

    runner = OnPolicyRunner(RslRlWorlds(env, limit), settings, log_dir)
    runner.learn(1000)

Each part of a dict observation becomes an observation group of the same name; other observations
become the group "policy". The runner's setting ``obs_groups`` selects the groups for actor and
critic.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from gymnasium.vector import VectorEnv
from jaxtyping import Bool, Float
from torch import Tensor

from generator.errors import InputError

from ..extra import need
from .worlds import Seen, TensorWorlds

GROUP = "policy"
"""The group for observations without parts."""


class RslRlWorlds:
    """A vector environment with the members of ``rsl_rl.env.VecEnv`` that ``rsl_rl`` runners use.

    Actions are clipped to [-1, 1]. ``rsl_rl`` bootstraps at time limits with the value of the
    observation before the last step, so final observations are not passed on.

    Args:
        env: any vector environment that ``TensorWorlds`` accepts.
        limit: its time limit, in steps. The adapter counts the steps itself: call ``learn`` with
            ``init_at_random_ep_len=False``.
        seed: seed of the first episodes.

    Raises:
        InputError: tensordict is not installed, or the environment has a different autoreset mode.
    """

    def __init__(self, env: VectorEnv[Any, Any, Any], limit: int, seed: int = 0) -> None:
        need("tensordict", "rsl_rl needs tensordict", "rsl")
        self.worlds = TensorWorlds(env)
        self.num_envs, self.device = self.worlds.count, self.worlds.device
        self.num_actions = int(np.prod(env.single_action_space.shape or (0,)))
        self.max_episode_length, self.cfg = limit, {}
        self._lengths = torch.zeros(self.num_envs, dtype=torch.long, device=self.device)
        self._seen = self.worlds.reset(seed)

    @property
    def episode_length_buf(self) -> Tensor:
        """The number of steps in each world's current episode."""
        return self._lengths

    @episode_length_buf.setter
    def episode_length_buf(self, lengths: Tensor) -> None:
        raise InputError(
            "The step counter is read-only; call learn() with init_at_random_ep_len=False."
        )

    def get_observations(self) -> Any:
        """Return the current observations as a ``TensorDict``."""
        return _groups(self._seen, self.num_envs)

    def step(
        self, actions: Float[Tensor, "n a"]
    ) -> tuple[Any, Float[Tensor, "n"], Bool[Tensor, "n"], dict[str, Any]]:
        """Step all worlds; return observations, rewards, done flags and extras.

        The extra "time_outs" marks the worlds truncated by the time limit; "log" holds the success
        rate of the ended episodes.
        """
        step = self.worlds.step(actions.clamp(-1, 1))
        self._lengths = (self._lengths + 1) * ~step.over
        self._seen = step.seen
        more: dict[str, Any] = {"time_outs": step.truncated}
        if step.over.any():
            more["log"] = {"/success": step.success[step.over].float().mean()}
        return self.get_observations(), step.rewards, step.over, more

    def close(self) -> None:
        """Close the worlds."""
        self.worlds.close()


def _groups(seen: Seen, count: int) -> Any:
    from tensordict import TensorDict  # pyright: ignore[reportMissingImports]

    return TensorDict({name or GROUP: part for name, part in seen.items()}, batch_size=[count])
