"""What the baselines look with: the flat state's parts, scaled, and a set of objects pooled.

A policy that is to work at tables it never saw must not care in which slot an object comes. Target
and goal object have slots of their own; all the others go through one small network each and are
pooled by their largest activations.
"""

from __future__ import annotations

from typing import Any

import gymnasium as gym
import numpy as np
import torch
from jaxtyping import Float
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from torch import Tensor, nn

from generator.errors import InputError

from ..observations import GOAL_BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS, SLOTS

_ROBOT, _SLOT, _GOAL = len(ROBOT_BOUNDS), len(SLOT_BOUNDS), len(GOAL_BOUNDS)
_TOOL = slice(15, 18)

_ROBOT_SCALE = np.array(
    [1.0] * 7 + [0.5] * 7 + [0.04] + [0.3] * 3 + [1.0] * 6 + [0.1] * 7 + [1.0] * 3 + [0.1] * 3
    + [0.3] * 3
)  # fmt: skip
_SLOT_SCALE = np.array([0.3] * 3 + [1.0] * 6 + [0.05] * 3 + [0.3] * 3 + [3.0] * 3 + [1.0])
_GOAL_SCALE = np.array([1.0] + [0.3] * 3 + [0.05] * 2 + [2.0] + [0.05] + [0.1] * 3)


class TableExtractor(BaseFeaturesExtractor):
    """Features of the flat state (279 entries; see ``observations``).

    Robot, target, goal object and goal are scaled to about 1 each and clipped at 8; the other
    objects are seen from the tool, by one network, and pooled to ``width`` features.

    Raises:
        InputError: the observation is not the flat state.
    """

    per_robot: Tensor
    per_slot: Tensor
    per_goal: Tensor

    def __init__(self, observation_space: gym.Space[Any], width: int = 64) -> None:
        size = _ROBOT + SLOTS * _SLOT + _GOAL
        if observation_space.shape != (size,):
            raise InputError(
                f"TableExtractor reads the flat state of {size} entries, the observation is "
                f"{observation_space}. Make the environment with observation='state'."
            )
        super().__init__(observation_space, _ROBOT + 2 * _SLOT + _GOAL + width)
        self.each = nn.Sequential(nn.Linear(_SLOT + 3, width), nn.ReLU(), nn.Linear(width, width))
        for name, scale in (("robot", _ROBOT_SCALE), ("slot", _SLOT_SCALE), ("goal", _GOAL_SCALE)):
            values = torch.as_tensor(1 / scale, dtype=torch.float32)
            self.register_buffer(f"per_{name}", values, persistent=False)

    def forward(self, observations: Float[Tensor, "n 279"]) -> Float[Tensor, "n f"]:
        """Return the features of a batch of states."""
        robot, slots, goal = observations.split([_ROBOT, SLOTS * _SLOT, _GOAL], 1)
        slots = slots.reshape(-1, SLOTS, _SLOT)
        there = slots[:, 2:, -1:]
        away = 10 * (slots[:, 2:, :3] - robot[:, None, _TOOL]) * there
        others = self.each(torch.cat([slots[:, 2:] * self.per_slot, away], 2).clamp(-8, 8))
        pooled = (others * there).max(1).values
        own = torch.cat([
            robot * self.per_robot, (slots[:, :2] * self.per_slot).flatten(1), goal * self.per_goal
        ], 1)  # fmt: skip
        return torch.cat([own.clamp(-8, 8), pooled], 1)
