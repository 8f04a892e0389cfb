"""The actor of a trained policy, independent of the training algorithm.

SAC, TD3 and PPO compute deterministic actions in the same way: features, hidden layers, a linear
output layer, then tanh (SAC, TD3) or clipping (PPO).
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

from ...observations.height_map import height_map_space
from ..recipes import Network
from ..setup import ACTIVATIONS, extractor_of
from .perception import cameras_of
from .sight_extractor import MEMORY, SightExtractor

Squash = Literal["tanh", "clip"]
Shape = int | tuple[int, ...]
Inputs = Mapping[str, Shape]
"""Shape of each part of an observation, by name. An observation that is a single array has the
empty name.

The shape of a one-dimensional part is its size.
"""


class Actor(nn.Module):
    """A policy's network: extractor, hidden layers and output, without squashing or clipping."""

    def __init__(self, network: Network, inputs: Inputs, actions: int) -> None:
        super().__init__()
        self.inputs = dict(inputs)
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
        """Compute the actions for a batch of observations."""
        return self.last(self.hidden(self.extractor(observations)))

    @property
    def memory_size(self) -> int:
        """The size of the memory carried between steps, or 0 for policies without memory."""
        return MEMORY if isinstance(self.extractor, SightExtractor) else 0

    def recall(
        self, observations: Any, memory: Float[Tensor, "n m"]
    ) -> tuple[Float[Tensor, "n a"], Float[Tensor, "n m"]]:
        """Compute the actions for a batch of observations, and the updated memory."""
        if not isinstance(self.extractor, SightExtractor):
            return self(observations), memory
        features, after = self.extractor.recall(observations, memory)
        return self.last(self.hidden(features)), after


def actor_of(model: BaseAlgorithm, network: Network) -> tuple[Actor, Squash]:
    """Return a copy of the actor of an SAC, TD3 or PPO model, and how its actions are squashed.

    ``network`` is the argument with which ``setup.new_model`` created the model.
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
        raise InputError(
            f"{type(model).__name__} cannot be exported as a policy file; use SAC, TD3 or PPO."
        )
    extractor, *rest = parts
    actor.extractor.load_state_dict(extractor.state_dict())
    linear = [m for part in rest for m in part.modules() if isinstance(m, nn.Linear)]
    own = [m for m in actor.hidden if isinstance(m, nn.Linear)] + [actor.last]
    for mine, other in zip(own, linear, strict=True):
        mine.load_state_dict(other.state_dict())
    actor.eval().requires_grad_(False)
    return actor, "clip" if isinstance(model, PPO) else "tanh"


def inputs_of(space: spaces.Space[Any]) -> dict[str, Shape]:
    """Return the shape of each part of an observation space.

    Raises:
        InputError: a part is neither one-dimensional, nor a height map, nor a picture with
            calibration; policy files do not support point clouds or other picture inputs.
    """
    parts = space.spaces if isinstance(space, spaces.Dict) else {"": space}
    pictures = {
        part for c in cameras_of(parts) for part in (c, f"{c}_depth", f"{c}_target")
    }  # fmt: skip
    for name, part in parts.items():
        flat = part.shape is not None and len(part.shape) == 1
        if not (flat or name == "height_map" or name in pictures):
            raise InputError(
                "Policy files support states, goals, height maps and pictures with "
                f"calibrations; {name or 'the observation'} is {part}. Keep the "
                "Stable-Baselines3 zip file instead."
            )
    shapes = {name: _channels_last(part.shape) for name, part in parts.items() if part.shape}
    return {name: shape[0] if len(shape) == 1 else shape for name, shape in shapes.items()}


def _channels_last(shape: tuple[int, ...]) -> tuple[int, ...]:
    """Return a shape with the channel axis moved from first (as in Stable-Baselines3) to last."""
    colors = len(shape) == 3 and shape[0] == 3 and shape != height_map_space().shape
    return (*shape[1:], shape[0]) if colors else shape


def shape_of(shape: Shape) -> tuple[int, ...]:
    """Return the shape of an observation part as a tuple."""
    return (shape,) if isinstance(shape, int) else shape


def tensors_of(inputs: Inputs, observation: Any) -> tuple[Any, bool]:
    """Convert an observation to tensors with a batch axis, and return whether it already had one.

    Raises:
        InputError: a part is missing or has the wrong shape.
    """
    several = "" not in inputs
    given = observation if several else {"": observation}
    if several != isinstance(observation, Mapping) or set(inputs) - set(given):
        raise InputError(
            f"The policy requires an observation of {dict(inputs)}, got {_describe(observation)}."
        )
    made, batch = {}, False
    for name, size in inputs.items():
        part, shape = np.asarray(given[name], np.float32), shape_of(size)
        batch = part.ndim == len(shape) + 1
        if part.ndim not in (len(shape), len(shape) + 1) or part.shape[-len(shape) :] != shape:
            raise InputError(
                f"The policy requires {name or 'an observation'} of {_entries(size)}, got "
                f"{_describe(part)}. Create the environment with the policy's settings."
            )
        made[name] = torch.from_numpy(part if batch else part[None])
    return (made if several else made[""]), batch


def _entries(size: Shape) -> str:
    return f"{size} entries" if isinstance(size, int) else f"shape {size}"


def _describe(observation: Any) -> str:
    if isinstance(observation, Mapping):
        return f"a dict of {', '.join(map(str, observation)) or 'nothing'}"
    return f"an array of shape {np.shape(observation)}"


def _space(inputs: Inputs) -> spaces.Space[Any]:
    boxes = {name: spaces.Box(-np.inf, np.inf, shape_of(size)) for name, size in inputs.items()}
    return boxes[""] if "" in boxes else spaces.Dict(list(boxes.items()))
