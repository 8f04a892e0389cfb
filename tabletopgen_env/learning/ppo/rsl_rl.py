"""A vector environment as ``rsl_rl`` (rsl-rl-lib 5) steps it.

    from rsl_rl.runners import OnPolicyRunner

    runner = OnPolicyRunner(RslRlWorlds(env, limit), settings, log_dir)
    runner.learn(1000)

Of observations with parts each part is a group of its name, without parts the group is "policy";
``obs_groups`` of the runner's settings says which of them actor and critic see.
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
"""The group of observations without parts."""


class RslRlWorlds:
    """Worlds with what ``rsl_rl.env.VecEnv`` has; its runners ask for no more.

    Actions are clipped to [-1, 1]. ``rsl_rl`` bootstraps at time limits with the value of what was
    seen before the last step, so what was seen last is not passed on.

    Args:
        env: any vector environment ``TensorWorlds`` takes.
        limit: its time limit, in steps. The worlds count for themselves: ``learn`` is to be called
            with ``init_at_random_ep_len=False``.
        seed: of the first episodes.

    Raises:
        InputError: tensordict is not installed, or the environment resets itself otherwise.
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
        """Steps of each world's episode so far."""
        return self._lengths

    @episode_length_buf.setter
    def episode_length_buf(self, lengths: Tensor) -> None:
        raise InputError("Worlds count their steps themselves; pass init_at_random_ep_len=False.")

    def get_observations(self) -> Any:
        """Return what the worlds show now, a ``TensorDict``."""
        return _groups(self._seen, self.num_envs)

    def step(
        self, actions: Float[Tensor, "n a"]
    ) -> tuple[Any, Float[Tensor, "n"], Bool[Tensor, "n"], dict[str, Any]]:
        """Step every world; return what they show, their rewards, whose episode is over, and more.

        "time_outs" are the worlds cut by the time limit, "log" has the share of the episodes over
        that ended with success.
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
