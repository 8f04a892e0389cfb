"""Features of goal observations, in the layout of the flat state."""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from gymnasium import spaces
from jaxtyping import Float
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from torch import Tensor

from generator.errors import InputError

from ...observations.bounds import GOAL_BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS
from ...rendering.views import SLOTS
from ...tasks.task import ENTRIES
from .network import TableExtractor

_BARE = len(ROBOT_BOUNDS) + SLOTS * len(SLOT_BOUNDS)


class GoalExtractor(BaseFeaturesExtractor):
    """A feature extractor for observations with a single goal, based on ``TableExtractor``.

    The state's goal entries are computed from the desired and the achieved goal, so that they
    follow hindsight relabelling. Entry 268 (whether an object carries the goal) is 0. Slot 1 of the
    observation and the grasp hint are not relabelled: if an object carries the true goal, slot 1
    remains that object for relabelled goals.

    Raises:
        InputError: the observation is not a goal observation with one goal.
    """

    def __init__(self, observation_space: spaces.Dict, width: int = 64) -> None:
        parts = getattr(observation_space, "spaces", {})
        shapes = [parts[k].shape for k in ("achieved_goal", "desired_goal") if k in parts]
        if shapes != [(ENTRIES,)] * 2:
            raise InputError(
                "GoalExtractor requires goal observations with one goal, got "
                f"{observation_space}. Use the extractor 'flat'."
            )
        size = parts["observation"].shape[0] + len(GOAL_BOUNDS)
        extractor = TableExtractor(spaces.Box(-np.inf, np.inf, (size,), np.float32), width)
        super().__init__(observation_space, extractor.features_dim)
        self.extractor = extractor

    def forward(self, observations: dict[str, Any]) -> Float[Tensor, "n f"]:
        """Compute the features of a batch of goal observations."""
        seen, desired = observations["observation"], observations["desired_goal"]
        away = desired[:, :3] - observations["achieved_goal"][:, :3]
        carried = torch.zeros_like(away[:, :1])
        bare, hint = seen[:, :_BARE], seen[:, _BARE:]
        return self.extractor(torch.cat([bare, carried, desired[:, :7], away, hint], 1))
