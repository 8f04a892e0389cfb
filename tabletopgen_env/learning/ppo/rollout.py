"""What a batch of worlds went through between two updates, and what it was worth."""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from .worlds import Seen


@dataclass(frozen=True, eq=False)
class Rollout:
    """``t`` steps of ``n`` worlds.

    Attributes:
        seen: what was seen before each step, by parts.
        actions: as they were drawn, before any clipping.
        means: of the distributions they were drawn from.
        log_probs: log densities of the actions.
        values: the critic's estimates of what was seen.
        rewards: of the steps, scaled as the critic's values are. Where a time limit cut an episode,
            the discounted value of what was seen last is part of them.
        over: where an episode ended with the step.
        solved: where it ended with success.
        after: the critic's estimates of what is seen after the last step.
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
        """Return one of ``steps`` steps to be filled, for worlds that show ``seen``."""
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
    """Return generalised advantage estimates (Schulman et al. 2016, eq. 16), cut where ``over``.

    ``last`` is the value of what is seen after the last step. The advantage of step k is
    delta_k + gamma * lambda * advantage_(k + 1), with delta_k = r_k + gamma * V_(k + 1) - V_k;
    nothing follows a step that ended an episode.
    """
    found = torch.empty_like(rewards)
    ahead, value = torch.zeros_like(last), last
    goes_on = (~over).to(rewards.dtype)
    for k in range(len(rewards) - 1, -1, -1):
        delta = rewards[k] + gamma * value * goes_on[k] - values[k]
        ahead = delta + gamma * gae_lambda * goes_on[k] * ahead
        found[k], value = ahead, values[k]
    return found
