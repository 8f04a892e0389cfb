"""A rollout of a batch of worlds, and its advantages."""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from .worlds import Seen


@dataclass(frozen=True, eq=False)
class Rollout:
    """A rollout of ``t`` steps of ``n`` worlds.

    Attributes:
        seen: observations before each step, by part.
        actions: sampled actions, before clipping.
        means: means of the action distributions.
        log_probs: log densities of the actions.
        values: the critic's estimates for ``seen``.
        rewards: rewards of the steps, scaled like the critic's values. At a time limit they include
            the discounted value of the episode's last observation.
        over: whether the step ended an episode.
        solved: whether the step ended an episode with success.
        after: the critic's estimates after the last step.
    """

    seen: Seen
    actions: Float[Tensor, "t n a"]
    means: Float[Tensor, "t n a"]
    log_probs: Float[Tensor, "t n"]
    values: Float[Tensor, "t n"]
    rewards: Float[Tensor, "t n"]
    over: Bool[Tensor, "t n"]
    solved: Bool[Tensor, "t n"]
    after: Float[Tensor, "n"]

    @classmethod
    def like(cls, seen: Seen, actions: int, steps: int) -> Rollout:
        """Allocate a rollout of ``steps`` steps for worlds with observations like ``seen``."""
        first = next(iter(seen.values()))
        n = len(first)

        def zeros(*shape: int, kind: torch.dtype = torch.float32) -> Tensor:
            return torch.zeros(shape, dtype=kind, device=first.device)

        return cls(
            {name: zeros(steps, *part.shape) for name, part in seen.items()},
            zeros(steps, n, actions), zeros(steps, n, actions),
            zeros(steps, n), zeros(steps, n), zeros(steps, n),
            zeros(steps, n, kind=torch.bool), zeros(steps, n, kind=torch.bool), zeros(n),
        )  # fmt: skip


def advantages(
    rewards: Float[Tensor, "t n"],
    values: Float[Tensor, "t n"],
    over: Bool[Tensor, "t n"],
    last: Float[Tensor, "n"],
    gamma: float,
    gae_lambda: float,
) -> Float[Tensor, "t n"]:
    """Compute generalised advantage estimates; episodes end where ``over`` is true.

    See eq. 16 of Schulman et al. (2016). ``last`` is the value after the last step. The advantage
    of step k is delta_k + gamma * lambda * advantage_(k + 1), with delta_k = r_k + gamma * V_(k +
    1) - V_k; after the last step of an episode the following terms are 0.
    """
    found = torch.empty_like(rewards)
    ahead, value = torch.zeros_like(last), last
    goes_on = (~over).to(rewards.dtype)
    for k in range(len(rewards) - 1, -1, -1):
        delta = rewards[k] + gamma * value * goes_on[k] - values[k]
        ahead = delta + gamma * gae_lambda * goes_on[k] * ahead
        found[k], value = ahead, values[k]
    return found
