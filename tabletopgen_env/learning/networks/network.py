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
"""What ways still to go, metres or radians, are divided by to be seen closely."""

_ROBOT_SCALE = np.array(
    [1.0] * 7 + [0.5] * 7 + [0.04] + [0.3] * 3 + [1.0] * 6 + [0.1] * 7 + [1.0] * 3 + [0.1] * 3
    + [0.3] * 3
)  # fmt: skip
_SLOT_SCALE = np.array([0.3] * 3 + [1.0] * 6 + [0.05] * 3 + [0.3] * 3 + [3.0] * 3 + [1.0])
_GOAL_SCALE = np.array([1.0] + [0.3] * 3 + [0.05] * 2 + [2.0] + [0.05] + [0.1] * 3)
_HINT_SCALE = np.array([0.1] * 3 + [1.0] + [0.04] * 2 + [0.1] + [1.0])


class TableExtractor(BaseFeaturesExtractor):
    """Features of the flat state, with the grasp hint or without (see ``observations``).

    Robot, target, goal object, goal and hint are scaled to about 1 each and clipped at 8. The ways
    still to go (tool to target, target to goal, tool and turn to the hinted grasp) come again,
    squashed, so that millimetres count when they are short. The other objects are seen from
    the tool, by one network, and pooled to ``width`` features.

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
                f"TableExtractor reads the flat state of {_FLAT} entries ({_FLAT + _HINT} with the "
                f"grasp hint), the observation is {observation_space}. Make the environment with "
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
        """Return the features of a batch of states."""
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
