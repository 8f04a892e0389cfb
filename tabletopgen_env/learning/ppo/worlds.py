"""A vector environment as torch sees it, whether its arrays are NumPy's or tensors on a device."""

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
"""Observations by the names of their parts, a row a world; "" names one that has no parts."""


@dataclass(frozen=True, eq=False)
class WorldsStep:
    """What a step of ``n`` worlds gave; all of it lies on the worlds' device.

    Attributes:
        seen: what the worlds show now, those whose episode ended their new one.
        rewards: of the step.
        terminated: whose episode ended by itself.
        truncated: whose episode was cut by its time limit or since its world had failed, and did
            not end by itself.
        cut: the numbers of the truncated worlds.
        last: what those showed last, a row each.
        success: which worlds reached their goal with this step.
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
        """Whose episode is over."""
        return self.terminated | self.truncated


class TensorWorlds:
    """Steps a vector environment with tensors.

    Arrays become tensors without a copy where they lie in the CPU's memory or are tensors already.

    Args:
        env: any vector environment that resets itself within a step. With tensors, it says on which
            ``device`` they are, and its ``infos["final_obs"]`` has a row for each world.

    Raises:
        InputError: the environment resets itself otherwise.
    """

    def __init__(self, env: VectorEnv[Any, Any, Any]) -> None:
        mode = env.metadata.get("autoreset_mode")
        if mode is not AutoresetMode.SAME_STEP:
            raise InputError(
                "PPO needs worlds that reset within the step that ends an episode: make them with "
                f"autoreset_mode='SameStep', not {getattr(mode, 'value', mode)!r}."
            )
        self.env, self.count = env, env.num_envs
        given = getattr(env, "device", None)
        self.device = torch.device("cpu" if given is None else given)
        self._tensors = given is not None

    def reset(self, seed: int | Sequence[int] | None = None) -> Seen:
        """Begin an episode in every world; seeds are as ``VectorEnv.reset`` has them."""
        return self._observe(self.env.reset(seed=seed)[0])  # pyright: ignore[reportArgumentType]

    def step(self, actions: Float[Tensor, "n a"]) -> WorldsStep:
        """Step every world."""
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
        """Return what cut worlds saw last, of rows, of parts with rows, or of one object each."""
        if isinstance(final, Mapping):
            return {name: self._tensor(part)[cut].float() for name, part in final.items()}
        if isinstance(final, np.ndarray) and final.dtype == object:
            own = [final[k] for k in cut.tolist()]
            if isinstance(own[0], Mapping):
                return self._observe({k: np.stack([o[k] for o in own]) for k in own[0]})
            return self._observe(np.stack(own))
        return {"": self._tensor(final)[cut].float()}

    def _successes(self, infos: Mapping[str, Any], over: Bool[Tensor, "n"]) -> Bool[Tensor, "n"]:
        """Return which worlds reached their goal; without a word of it, none."""
        found = infos.get("success")
        now = torch.zeros_like(over) if found is None else self._tensor(found).bool()
        final = infos.get("final_info", {}).get("success")
        return now if final is None else torch.where(over, self._tensor(final).bool(), now)

    def _tensor(self, array: Any) -> Tensor:
        return torch.as_tensor(array, device=self.device)
