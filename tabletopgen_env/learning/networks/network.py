"""The feature extractor of the baselines: scaled parts of the flat state, and pooled objects.

A policy for unseen tables must not depend on the order of the objects. The target and the goal
object have fixed slots; the other objects each pass through a shared small network and are
max-pooled.
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

from ...observations.bounds import GOAL_BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS
from ...observations.grasp_hint import HINT_BOUNDS
from ...rendering.views import SLOTS

_ROBOT, _SLOT, _GOAL = len(ROBOT_BOUNDS), len(SLOT_BOUNDS), len(GOAL_BOUNDS)
_HINT = len(HINT_BOUNDS)
_FLAT = _ROBOT + SLOTS * _SLOT + _GOAL
_TOOL = slice(15, 18)
_WAYS = (34, 35, 36, 276, 277, 278)
_HINTED_WAYS = (*_WAYS, *range(_FLAT, _FLAT + 4))
_FINE = (0.02, 0.005)
"""Divisors of the remaining distances (m) and angles (rad), for fine resolution near zero."""

_ROBOT_SCALE = np.array(
    [1.0] * 7 + [0.5] * 7 + [0.04] + [0.3] * 3 + [1.0] * 6 + [0.1] * 7 + [1.0] * 3 + [0.1] * 3
    + [0.3] * 3
)  # fmt: skip
_SLOT_SCALE = np.array([0.3] * 3 + [1.0] * 6 + [0.05] * 3 + [0.3] * 3 + [3.0] * 3 + [1.0])
_GOAL_SCALE = np.array([1.0] + [0.3] * 3 + [0.05] * 2 + [2.0] + [0.05] + [0.1] * 3)
_HINT_SCALE = np.array([0.1] * 3 + [1.0] + [0.04] * 2 + [0.1] + [1.0])


class TableExtractor(BaseFeaturesExtractor):
    """Features of the flat state, with or without the grasp hint (see ``observations``).

    Robot, target, goal object, goal and hint are scaled to about 1 and clipped at 8. Remaining
    distances and angles (tool to target, target to goal, tool and turn to the hinted grasp) are
    repeated through tanh, so that millimetres matter near zero. The other objects are expressed
    relative to the tool, pass through one shared network and are max-pooled to ``width`` features.

    Raises:
        InputError: the observation is not the flat state.
    """

    per_robot: Tensor
    per_slot: Tensor
    per_rest: Tensor

    def __init__(self, observation_space: gym.Space[Any], width: int = 64) -> None:
        hinted = observation_space.shape == (_FLAT + _HINT,)
        if not hinted and observation_space.shape != (_FLAT,):
            raise InputError(
                f"TableExtractor requires the flat state of {_FLAT} entries ({_FLAT + _HINT} with "
                f"the grasp hint), got {observation_space}. Create the environment with "
                "observation='state'."
            )
        self.ways = list(_HINTED_WAYS if hinted else _WAYS)
        rest = np.concatenate([_GOAL_SCALE, _HINT_SCALE]) if hinted else _GOAL_SCALE
        super().__init__(
            observation_space, _ROBOT + 2 * _SLOT + len(rest) + len(_FINE) * len(self.ways) + width
        )
        self.each = nn.Sequential(nn.Linear(_SLOT + 3, width), nn.ReLU(), nn.Linear(width, width))
        for name, scale in (("robot", _ROBOT_SCALE), ("slot", _SLOT_SCALE), ("rest", rest)):
            values = torch.as_tensor(1 / scale, dtype=torch.float32)
            self.register_buffer(f"per_{name}", values, persistent=False)

    def forward(self, observations: Float[Tensor, "n o"]) -> Float[Tensor, "n f"]:
        """Compute the features of a batch of states."""
        robot, slots = observations[:, :_ROBOT], observations[:, _ROBOT : _FLAT - _GOAL]
        rest = observations[:, _FLAT - _GOAL :]
        slots = slots.reshape(-1, SLOTS, _SLOT)
        there = slots[:, 2:, -1:]
        away = 10 * (slots[:, 2:, :3] - robot[:, None, _TOOL]) * there
        others = self.each(torch.cat([slots[:, 2:] * self.per_slot, away], 2).clamp(-8, 8))
        pooled = (others * there).max(1).values
        own = torch.cat([
            robot * self.per_robot, (slots[:, :2] * self.per_slot).flatten(1), rest * self.per_rest
        ], 1)  # fmt: skip
        near = [torch.tanh(observations[:, self.ways] / scale) for scale in _FINE]
        return torch.cat([own.clamp(-8, 8), *near, pooled], 1)
