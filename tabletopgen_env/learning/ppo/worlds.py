"""Vector environments with torch tensors, converted from NumPy arrays if necessary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from gymnasium.vector import AutoresetMode, VectorEnv
from jaxtyping import Bool, Float, Int
from torch import Tensor

from generator.errors import InputError

Seen = dict[str, Tensor]
"""Observations by part, one row per world; an observation without parts has the name ""."""


@dataclass(frozen=True, eq=False)
class WorldsStep:
    """The result of a step of ``n`` worlds, on the worlds' device.

    Attributes:
        seen: current observations; for worlds whose episode ended, those of the new episode.
        rewards: rewards of the step.
        terminated: whether the episode terminated.
        truncated: whether the episode was cut, by its time limit or because its world failed,
            without terminating.
        cut: indices of the truncated worlds.
        last: the final observations of the truncated worlds, one row each.
        success: whether the world reached its goal in this step.
    """

    seen: Seen
    rewards: Float[Tensor, "n"]
    terminated: Bool[Tensor, "n"]
    truncated: Bool[Tensor, "n"]
    cut: Int[Tensor, "k"]
    last: Seen
    success: Bool[Tensor, "n"]

    @property
    def over(self) -> Bool[Tensor, "n"]:
        """Whether each episode ended."""
        return self.terminated | self.truncated


class TensorWorlds:
    """A vector environment with tensor observations and actions.

    Arrays in CPU memory become tensors without a copy; tensors are passed through.

    Args:
        env: any vector environment that resets itself within a step. An environment with tensors
            must have an attribute ``device``, and its ``infos["final_obs"]`` must have a row for
            each world.

    Raises:
        InputError: the environment has a different autoreset mode.
    """

    def __init__(self, env: VectorEnv[Any, Any, Any]) -> None:
        mode = env.metadata.get("autoreset_mode")
        if mode is not AutoresetMode.SAME_STEP:
            raise InputError(
                "PPO needs worlds that reset in the step that ends an episode: create the "
                "vector environment with autoreset_mode='SameStep', not "
                f"{getattr(mode, 'value', mode)!r}."
            )
        self.env, self.count = env, env.num_envs
        given = getattr(env, "device", None)
        self.device = torch.device("cpu" if given is None else given)
        self._tensors = given is not None

    def reset(self, seed: int | Sequence[int] | None = None) -> Seen:
        """Reset all worlds; seeds are as in ``VectorEnv.reset``."""
        return self._observe(self.env.reset(seed=seed)[0])  # pyright: ignore[reportArgumentType]

    def step(self, actions: Float[Tensor, "n a"]) -> WorldsStep:
        """Step all worlds."""
        given = actions if self._tensors else actions.numpy()
        seen, rewards, terminated, truncated, infos = self.env.step(given)
        terminated, truncated = self._tensor(terminated), self._tensor(truncated)
        truncated = truncated & ~terminated
        cut = truncated.nonzero()[:, 0]
        last = self._last(infos["final_obs"], cut) if len(cut) else {}
        success = self._successes(infos, terminated | truncated)
        rewards = self._tensor(rewards).float()
        return WorldsStep(
            self._observe(seen), rewards, terminated, truncated, cut, last, success
        )  # fmt: skip

    def close(self) -> None:
        """Close the environment."""
        self.env.close()

    def _observe(self, seen: Any) -> Seen:
        parts = seen if isinstance(seen, Mapping) else {"": seen}
        return {name: self._tensor(part).float() for name, part in parts.items()}

    def _last(self, final: Any, cut: Int[Tensor, "k"]) -> Seen:
        """Return the final observations of truncated worlds, whatever their input format."""
        if isinstance(final, Mapping):
            return {name: self._tensor(part)[cut].float() for name, part in final.items()}
        if isinstance(final, np.ndarray) and final.dtype == object:
            own = [final[k] for k in cut.tolist()]
            if isinstance(own[0], Mapping):
                return self._observe({k: np.stack([o[k] for o in own]) for k in own[0]})
            return self._observe(np.stack(own))
        return {"": self._tensor(final)[cut].float()}

    def _successes(self, infos: Mapping[str, Any], over: Bool[Tensor, "n"]) -> Bool[Tensor, "n"]:
        """Return which worlds reached their goal; without an info "success", all are False."""
        found = infos.get("success")
        now = torch.zeros_like(over) if found is None else self._tensor(found).bool()
        final = infos.get("final_info", {}).get("success")
        return now if final is None else torch.where(over, self._tensor(final).bool(), now)

    def _tensor(self, array: Any) -> Tensor:
        return torch.as_tensor(array, device=self.device)
