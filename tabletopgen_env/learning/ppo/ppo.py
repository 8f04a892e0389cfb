"""Proximal policy optimisation (Schulman et al. 2017): rollouts and updates."""

from __future__ import annotations

import copy
import io
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from ..algorithms.learner import Counts
from ..networks.actor import Actor, Inputs, Squash
from ..recipes import Network
from .actor_critic import ActorCritic, divergence
from .config import PPOConfig
from .rollout import Rollout, advantages
from .worlds import Seen, TensorWorlds

FILE = "learner.pt"
"""The file of a checkpoint."""

_RATES = 1e-5, 1e-2
"""Range of an adaptive learning rate."""


@dataclass(frozen=True)
class UpdateFigures:
    """Statistics of a rollout and its update.

    Losses and ``kl``, the divergence from the policy before the update, are means over the
    minibatches. ``success`` is the share of ended episodes that succeeded, NaN if none ended.
    """

    policy_loss: float
    value_loss: float
    kl: float
    success: float
    learning_rate: float
    std: float


class BatchPPO:
    """PPO on batches of worlds, on any device; on a CPU, equal seeds give equal results.

    Rewards are scaled by 1 - gamma, so that values have the scale of a reward for any discount.
    Observations are not normalised, since the extractors scale them.

    Args:
        network: architecture of actor and critic.
        inputs: size of each observation part by name.
        actions: number of entries of an action.
        config: the settings.
        seed: seed of the weights, the actions and the minibatches.
        device: device of the networks.
    """

    def __init__(
        self, network: Network, inputs: Inputs, actions: int, config: PPOConfig, seed: int,
        device: torch.device | str = "cpu",
    ) -> None:  # fmt: skip
        self.config, self.device = config, torch.device(device)
        self.nets = ActorCritic(network, inputs, actions, config.std, seed).to(self.device)
        self.optimiser = torch.optim.Adam(self.nets.parameters(), config.learning_rate, eps=1e-5)
        self.updates, self.episodes = 0, 0
        self._random = torch.Generator(self.device).manual_seed(seed)
        self._rollout: Rollout | None = None

    # -------------------------------------------------------------------------------------- learn

    @torch.no_grad()
    def collect(self, worlds: TensorWorlds, seen: Seen) -> tuple[Seen, Rollout]:
        """Collect a rollout in worlds whose current observations are ``seen``.

        Returns the next observations and the rollout; the next call overwrites the rollout.
        """
        config, nets = self.config, self.nets
        own = self._rollout or Rollout.like(seen, len(nets.log_std), config.rollout)
        self._rollout = own
        for k in range(config.rollout):
            means = nets.means(seen)
            noise = torch.randn(means.shape, generator=self._random, device=self.device)
            actions = means + nets.log_std.exp() * noise
            for name, part in seen.items():
                own.seen[name][k] = part
            own.actions[k], own.means[k] = actions, means
            own.log_probs[k], own.values[k] = nets.log_probs(actions, means), nets.values(seen)
            step = worlds.step(actions.clamp(-1, 1))
            own.rewards[k] = (1 - config.gamma) * step.rewards
            if len(step.cut):
                own.rewards[k, step.cut] += config.gamma * nets.values(step.last)
            own.over[k], own.solved[k] = step.over, step.over & step.success
            seen = step.seen
        own.after.copy_(nets.values(seen))
        self.episodes += int(own.over.sum())
        return seen, own

    def update(self, rollout: Rollout) -> UpdateFigures:
        """Update the actor and the critic on a rollout."""
        config = self.config
        gains = advantages(
            rollout.rewards, rollout.values, rollout.over, rollout.after, config.gamma,
            config.gae_lambda,
        )  # fmt: skip
        batch = _Batch(
            {name: part.flatten(0, 1) for name, part in rollout.seen.items()},
            rollout.actions.flatten(0, 1), rollout.means.flatten(0, 1),
            rollout.log_probs.flatten(), _standardize(gains).flatten(),
            (gains + rollout.values).flatten(), self.nets.log_std.detach().clone(),
        )  # fmt: skip
        losses = []
        for _ in range(config.epochs):
            order = torch.randperm(
                len(batch.actions), generator=self._random, device=self.device
            )  # fmt: skip
            losses += [self._step(batch, rows) for rows in order.tensor_split(config.minibatches)]
        policy_loss, value_loss, kl = torch.stack(losses).mean(0).tolist()
        self._adapt(float(torch.stack(losses[-config.minibatches :])[:, 2].mean()))
        count, solved = int(rollout.over.sum()), int(rollout.solved.sum())
        return UpdateFigures(
            policy_loss, value_loss, kl, solved / count if count else math.nan,
            self.learning_rate, float(self.nets.log_std.detach().exp().mean()),
        )  # fmt: skip

    @property
    def learning_rate(self) -> float:
        """The current learning rate of Adam."""
        return float(self.optimiser.param_groups[0]["lr"])

    def _step(self, batch: _Batch, rows: Int[Tensor, "b"]) -> Float[Tensor, "3"]:
        """Take a gradient step; return the policy loss, the value loss and the divergence."""
        config, nets = self.config, self.nets
        seen = {name: part[rows] for name, part in batch.seen.items()}
        means, gains = nets.means(seen), batch.gains[rows]
        kl = divergence(batch.means[rows], batch.log_std, means, nets.log_std).detach().mean()
        ratio = torch.exp(nets.log_probs(batch.actions[rows], means) - batch.log_probs[rows])
        clipped = ratio.clamp(1 - config.clip, 1 + config.clip)
        policy_loss = -torch.minimum(ratio * gains, clipped * gains).mean()
        value_loss = nn.functional.mse_loss(nets.values(seen), batch.returns[rows])
        loss = policy_loss + config.value * value_loss - config.entropy * nets.entropy()
        self.optimiser.zero_grad()
        loss.backward()
        for part in ([*nets.actor.parameters(), nets.log_std], nets.critic.parameters()):
            nn.utils.clip_grad_norm_(part, config.max_grad_norm)
        self.optimiser.step()
        self.updates += 1
        return torch.stack([policy_loss.detach(), value_loss.detach(), kl])

    def _adapt(self, kl: float) -> None:
        """Adapt the learning rate to the divergence of the last update."""
        target, (low, high) = self.config.target_kl, _RATES
        rate = self.learning_rate
        if not target:
            return
        if kl > 2 * target:
            rate = max(rate / 1.5, low)
        elif kl < target / 2:
            rate = min(rate * 1.5, high)
        for group in self.optimiser.param_groups:
            group["lr"] = rate

    # --------------------------------------------------------------------------------------- keep

    def export(self) -> tuple[Actor, Squash]:
        """Return a copy of the actor on the CPU, and how its actions are squashed."""
        actor = copy.deepcopy(self.nets.actor).cpu()
        actor.eval().requires_grad_(False)
        return actor, "clip"

    def write(self, folder: Path, replay: bool) -> None:
        """Write the weights, the optimiser and the random state into a checkpoint's folder."""
        content = io.BytesIO()  # so that a full disk raises OSError
        torch.save(self._state(), content)
        (folder / FILE).write_bytes(content.getvalue())

    def read(self, folder: Path, counts: Counts) -> bool:
        """Restore a checkpoint from any device; return False, since there is no replay buffer.

        Only tensors, numbers and names are read (``weights_only``).
        """
        state = torch.load(folder / FILE, map_location=self.device, weights_only=True)
        self.nets.load_state_dict(state["nets"])
        self.optimiser.load_state_dict(state["optimiser"])
        random = state["random"].cpu()
        if state["device"] == self.device.type:
            self._random.set_state(random)
        self.updates, self.episodes = counts.updates, counts.episodes
        return False

    def _state(self) -> dict[str, Any]:
        return {
            "nets": self.nets.state_dict(), "optimiser": self.optimiser.state_dict(),
            "random": self._random.get_state(), "device": self.device.type,
        }  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Batch:
    """The steps of a rollout, one per row, and the log standard deviations of the actions."""

    seen: Seen
    actions: Float[Tensor, "m a"]
    means: Float[Tensor, "m a"]
    log_probs: Float[Tensor, "m"]
    gains: Float[Tensor, "m"]
    returns: Float[Tensor, "m"]
    log_std: Float[Tensor, "a"]


def _standardize(values: Float[Tensor, "t n"]) -> Float[Tensor, "t n"]:
    return (values - values.mean()) / (values.std(correction=0) + 1e-8)
