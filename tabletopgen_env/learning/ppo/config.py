"""Settings of PPO."""

from __future__ import annotations

from dataclasses import dataclass

from generator.errors import require


@dataclass(frozen=True)
class PPOConfig:
    """Settings of PPO (Schulman et al. 2017); the defaults suit 16 worlds.

    Attributes:
        rollout: steps of each world between updates.
        epochs: passes over the rollout per update.
        minibatches: minibatches per pass, each one gradient step.
        learning_rate: Adam's initial learning rate.
        target_kl: target of the mean KL divergence per update. The learning rate decreases if an
            update exceeds twice the target, and increases if it stays below half of it. 0 keeps it
            constant.
        gamma: discount factor per step.
        gae_lambda: lambda of generalised advantage estimation (Schulman et al. 2016).
        clip: clipping range of the probability ratio.
        entropy: weight of the entropy bonus.
        value: weight of the value loss.
        max_grad_norm: maximum gradient norm, separately for actor and critic.
        std: initial standard deviation of the actions, which are clipped to [-1, 1].

    Raises:
        InputError: a value is out of range.
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
