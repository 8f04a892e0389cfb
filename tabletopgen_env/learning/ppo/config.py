"""What can be set of PPO."""

from __future__ import annotations

from dataclasses import dataclass

from generator.errors import require


@dataclass(frozen=True)
class PPOConfig:
    """Settings of PPO (Schulman et al. 2017); the defaults suit 16 worlds.

    Attributes:
        rollout: steps of each world between updates.
        epochs: times an update goes over the rollout.
        minibatches: parts of a rollout, each a gradient step.
        learning_rate: Adam's at the start.
        target_kl: the mean KL divergence that the learning rate aims at: it falls where an update
            moves the policy twice as far, and rises where it moves it half as far. 0 keeps it.
        gamma: discount of a step.
        gae_lambda: discount of advantage estimates (Schulman et al. 2016).
        clip: how far the probability ratio counts.
        entropy: weight of the entropy bonus.
        value: weight of the value loss.
        max_grad_norm: gradients of actor and of critic are clipped to this norm.
        std: standard deviation of the actions at the start; they are clipped to [-1, 1].

    Raises:
        InputError: a value out of range.
    """

    rollout: int = 64
    epochs: int = 8
    minibatches: int = 4
    learning_rate: float = 5e-4
    target_kl: float = 0.015
    gamma: float = 0.97
    gae_lambda: float = 0.95
    clip: float = 0.2
    entropy: float = 0.0
    value: float = 1.0
    max_grad_norm: float = 1.0
    std: float = 0.6

    def __post_init__(self) -> None:
        require(self, "rollout", "epochs", "minibatches", minimum=1, integer=True)
        require(self, "learning_rate", "clip", "max_grad_norm", "std", above=0)
        require(self, "target_kl", "entropy", "value", minimum=0)
        require(self, "gae_lambda", minimum=0, maximum=1)
        require(self, "gamma", minimum=0, maximum=0.9999)
