"""An actor with Gaussian actions, and a separate critic."""

from __future__ import annotations

import math

import torch
from jaxtyping import Float
from torch import Tensor, nn

from ..networks.actor import Actor, Inputs
from ..recipes import Network
from .worlds import Seen

_CALM = 0.01
"""Initial gain of the actor's last layer; it makes the initial actions nearly 0."""


class ActorCritic(nn.Module):
    """Separate actor and critic networks, and the log standard deviations of the actions.

    Args:
        network: architecture of both networks.
        inputs: size of each observation part by name.
        actions: number of entries of an action.
        std: initial standard deviation of the actions.
        seed: seed of the initial weights.
    """

    def __init__(
        self, network: Network, inputs: Inputs, actions: int, std: float, seed: int
    ) -> None:
        super().__init__()
        with torch.random.fork_rng(devices=[]):
            torch.manual_seed(seed)
            self.actor, self.critic = Actor(network, inputs, actions), Actor(network, inputs, 1)
            for net, gain in ((self.actor, _CALM), (self.critic, 1.0)):
                _start(net, gain)
        self.log_std = nn.Parameter(torch.full((actions,), math.log(std)))

    def means(self, seen: Seen) -> Float[Tensor, "n a"]:
        """Return the means of the actions."""
        return self.actor(_whole(seen))

    def values(self, seen: Seen) -> Float[Tensor, "n"]:
        """Return the critic's value estimates."""
        return self.critic(_whole(seen))[:, 0]

    def log_probs(
        self, actions: Float[Tensor, "*b a"], means: Float[Tensor, "*b a"]
    ) -> Float[Tensor, "*b"]:
        """Return the log densities of actions."""
        away = (actions - means) * torch.exp(-self.log_std)
        constant = 0.5 * math.log(2 * math.pi)
        return -(0.5 * away**2 + self.log_std + constant).sum(-1)

    def entropy(self) -> Float[Tensor, ""]:
        """Return the entropy of the actions, which does not depend on the observation."""
        return (self.log_std + 0.5 * math.log(2 * math.pi * math.e)).sum()


def divergence(
    means: Float[Tensor, "n a"], log_std: Float[Tensor, "a"],
    other: Float[Tensor, "n a"], other_log_std: Float[Tensor, "a"],
) -> Float[Tensor, "n"]:  # fmt: skip
    """Compute the Kullback-Leibler divergences KL(own||other) between normal distributions.

    log(s'/s) + (s^2 + (m - m')^2) / (2 s'^2) - 1/2, summed over the entries.
    """
    spread = (log_std.exp() ** 2 + (means - other) ** 2) / (2 * other_log_std.exp() ** 2)
    return (other_log_std - log_std + spread - 0.5).sum(-1)


def _start(net: Actor, gain: float) -> None:
    """Initialise a network with orthogonal weights, scaled by ``gain`` in the last layer."""
    for layer in (*net.hidden, net.last):
        if isinstance(layer, nn.Linear):
            own = gain if layer is net.last else math.sqrt(2)
            nn.init.orthogonal_(layer.weight, own)
            nn.init.zeros_(layer.bias)


def _whole(seen: Seen) -> Seen | Tensor:
    """Convert observations to the form that the networks expect."""
    return seen.get("", seen)
