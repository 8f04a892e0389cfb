"""The part of a trained policy that acts, apart from the algorithm that trained it.

Deterministic actions of SAC, TD3 and PPO are the same thing: features, hidden layers, a last linear
layer, then a squashing by tanh (SAC, TD3) or a clipping (PPO).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
import torch
from gymnasium import spaces
from jaxtyping import Float
from stable_baselines3 import PPO, SAC, TD3
from stable_baselines3.common.base_class import BaseAlgorithm
from torch import Tensor, nn

from generator.errors import InputError

from ..making import ACTIVATIONS, extractor_of
from ..recipes import Network

Squash = Literal["tanh", "clip"]
Inputs = Mapping[str, int]
"""The observation's parts by name and size; one without a name where it is an array."""


class Actor(nn.Module):
    """Features, hidden layers and the action before it is squashed or clipped."""

    def __init__(self, network: Network, inputs: Inputs, actions: int) -> None:
        super().__init__()
        space = _space(inputs)
        kind, keywords = extractor_of(network, space)
        self.extractor = kind(space, **keywords)
        layers: list[nn.Module] = []
        size = self.extractor.features_dim
        for wide in network.layers:
            layers += [nn.Linear(size, wide), ACTIVATIONS[network.activation]()]
            size = wide
        self.hidden = nn.Sequential(*layers)
        self.last = nn.Linear(size, actions)

    def forward(self, observations: Any) -> Float[Tensor, "n a"]:
        """Return the actions of a batch of observations."""
        return self.last(self.hidden(self.extractor(observations)))


def actor_of(model: BaseAlgorithm, network: Network) -> tuple[Actor, Squash]:
    """Return a copy of the actor of an SAC, TD3 or PPO, and what becomes of its actions.

    ``network`` is what ``making.new_model`` made it with.
    """
    size = model.action_space.shape
    actor = Actor(network, inputs_of(model.observation_space), int(np.prod(size or (0,))))
    if isinstance(model, PPO):
        policy: Any = model.policy
        parts = (policy.pi_features_extractor, policy.mlp_extractor.policy_net, policy.action_net)
    elif isinstance(model, SAC):
        parts = (model.actor.features_extractor, model.actor.latent_pi, model.actor.mu)
    elif isinstance(model, TD3):
        parts = (model.actor.features_extractor, model.actor.mu)
    else:
        raise InputError(f"There are no policy files of {type(model).__name__}.")
    extractor, *rest = parts
    actor.extractor.load_state_dict(extractor.state_dict())
    linear = [m for part in rest for m in part.modules() if isinstance(m, nn.Linear)]
    own = [m for m in actor.hidden if isinstance(m, nn.Linear)] + [actor.last]
    for mine, other in zip(own, linear, strict=True):
        mine.load_state_dict(other.state_dict())
    actor.eval().requires_grad_(False)
    return actor, "clip" if isinstance(model, PPO) else "tanh"


def inputs_of(space: spaces.Space[Any]) -> dict[str, int]:
    """Return the parts of an observation space.

    Raises:
        InputError: one is no array of one axis, so the policy looks at pictures or points.
    """
    parts = space.spaces if isinstance(space, spaces.Dict) else {"": space}
    for name, part in parts.items():
        if part.shape is None or len(part.shape) != 1:
            raise InputError(
                f"Policy files hold policies of states and goals; {name or 'the observation'} is "
                f"{part}. Keep the zip of Stable-Baselines3 instead."
            )
    return {name: int(part.shape[0]) for name, part in parts.items() if part.shape}


def tensors_of(inputs: Inputs, observation: Any) -> tuple[Any, bool]:
    """Return an observation as the network takes it, and whether it was a batch.

    Raises:
        InputError: it lacks a part, or one has another shape.
    """
    several = "" not in inputs
    given = observation if several else {"": observation}
    if several != isinstance(observation, Mapping) or set(inputs) - set(given):
        raise InputError(f"The policy looks at {dict(inputs)}, got {_describe(observation)}.")
    made, batch = {}, False
    for name, size in inputs.items():
        part = np.asarray(given[name], np.float32)
        batch = part.ndim == 2
        if part.ndim not in (1, 2) or part.shape[-1] != size:
            raise InputError(
                f"The policy looks at {name or 'an observation'} of {size} entries, got "
                f"{_describe(part)}. Make the environment with the policy's own settings."
            )
        made[name] = torch.from_numpy(part if batch else part[None])
    return (made if several else made[""]), batch


def _describe(observation: Any) -> str:
    if isinstance(observation, Mapping):
        return f"a dict with {', '.join(map(str, observation)) or 'nothing'}"
    return f"an array of shape {np.shape(observation)}"


def _space(inputs: Inputs) -> spaces.Space[Any]:
    boxes = {name: spaces.Box(-np.inf, np.inf, (size,)) for name, size in inputs.items()}
    return boxes[""] if "" in boxes else spaces.Dict(list(boxes.items()))
