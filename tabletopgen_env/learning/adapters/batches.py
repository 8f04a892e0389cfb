"""Adapter that presents a ``TabletopBatchEnv`` to Stable-Baselines3 with NumPy arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import torch
from stable_baselines3.common.vec_env import VecEnv
from torch import Tensor

from generator.errors import InputError, require_seed

from ...parallel.batch.env import TabletopBatchEnv


class BatchVecEnv(VecEnv):
    """A ``VecEnv`` of Stable-Baselines3 that wraps a ``TabletopBatchEnv``.

    Each info holds "success" and "is_success". The info of an episode's last step also holds
    "terminal_observation", "TimeLimit.truncated" and "failed" (whether the world has failed).

    Args:
        batch: the batch; ``close`` closes it.
    """

    def __init__(self, batch: TabletopBatchEnv) -> None:
        self.batch = batch
        self._actions: Any = None
        super().__init__(batch.num_envs, batch.single_observation_space, batch.single_action_space)

    def reset(self) -> Any:
        """Reset all worlds with the stored seed and return their observations."""
        seen, _ = self.batch.reset(seed=self._seeds[0])
        self._reset_seeds()
        return as_numpy(seen)

    def seed(self, seed: int | None = None) -> Sequence[int | None]:
        """Set the seed of the next reset, shared by all worlds."""
        if seed is not None:
            require_seed(seed)
        self._seeds = [seed] * self.num_envs
        return self._seeds

    def step_async(self, actions: np.ndarray) -> None:
        """Store the actions for ``step_wait``."""
        self._actions = actions

    def step_wait(self) -> Any:
        """Step all worlds; return observations, rewards, done flags and infos."""
        seen, rewards, terminated, truncated, infos = self.batch.step(self._actions)
        done = (terminated | truncated).cpu().numpy()
        answers = [_success(s) for s in infos["success"].cpu().tolist()]
        if done.any():
            last, final = as_numpy(infos["final_obs"]), infos["final_info"]
            success, failed = (final[name].cpu().tolist() for name in ("success", "failed"))
            for k in np.flatnonzero(done).tolist():
                answers[k] = {
                    **_success(success[k]),
                    "terminal_observation": _pick(last, k),
                    "TimeLimit.truncated": True,
                    "failed": failed[k],
                }
        return as_numpy(seen), rewards.cpu().numpy().astype(np.float32), done, answers

    def close(self) -> None:
        """Close the batch."""
        self.batch.close()

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Return an attribute of the batch, repeated for each selected world."""
        return [getattr(self.batch, attr_name)] * len([*self._get_indices(indices)])

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Raise an error, since the worlds of a batch have no attributes of their own."""
        raise InputError(
            f"The worlds of a batch have no attributes of their own, so {attr_name!r} is unknown."
        )

    def env_method(
        self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any
    ) -> list[Any]:
        """Raise an error, since the worlds of a batch have no methods of their own."""
        raise InputError(
            f"The worlds of a batch have no methods of their own, so {method_name!r} is unknown."
        )

    def env_is_wrapped(self, wrapper_class: type[Any], indices: Any = None) -> list[bool]:
        """Return False for each selected world, since worlds are never wrapped."""
        return [False] * len([*self._get_indices(indices)])


def as_numpy(seen: Tensor | dict[str, Tensor]) -> Any:
    """Copy observations to NumPy arrays."""
    if isinstance(seen, dict):
        return {key: as_numpy(value) for key, value in seen.items()}
    return torch.clone(seen).cpu().numpy()


def _success(success: bool) -> dict[str, Any]:
    return {"success": success, "is_success": success}


def _pick(seen: Any, k: int) -> Any:
    return {key: value[k] for key, value in seen.items()} if isinstance(seen, dict) else seen[k]
