"""Features of pictures: height maps estimated by ``perception``, with a memory of the grasp.

The hand camera sees a different part of an object from each position, so the head's choice would
change on the way; a rim, for example, can be grasped anywhere. A *memory* keeps the last grasp in
the base frame. Once the hand is over the grasp, the head is not evaluated again unless the target
has moved or a time limit has passed. A marker hidden by the hand keeps its best-seen position.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import torch
from gymnasium import spaces
from jaxtyping import Bool, Float
from torch import Tensor

from generator.errors import InputError

from ...observations.bounds import ROBOT_BOUNDS
from ...observations.height_map import height_map_space
from .look_extractor import LookExtractor, at_goal, is_held, lowest_of, ways
from .perception import STATE, cameras_of, perceive, recall_goal

MEMORY = 15
"""Number of entries of the policy's memory. The entries are 1 if a grasp was found, the age of the
grasp in steps, the target's centre when the grasp was found, the tool's position in the grasp (base
frame, in metres), the last three entries of ``grasp_head.PLAN``, the largest number of marker
points seen so far, and the marker's position at that time (``perception.recall_goal``).
"""

_GRASP = 11  # entries of the grasp

_TOOL, _TARGET = slice(15, 18), slice(len(ROBOT_BOUNDS), len(ROBOT_BOUNDS) + 3)
# tolerated apparent motion of the target's centre, horizontally and vertically, metres
_MOVED = 0.015
_OVER = 0.05  # horizontal distance within which the hand is over a grasp, metres
_LONGEST = 60  # maximum age of a grasp, steps


class SightExtractor(LookExtractor):
    """Features of "pixels+proprio" observations with depth, target masks and calibrations.

    Colours are needed if the goal is a marked point (Reach).

    Raises:
        InputError: the observation lacks them.
    """

    def __init__(self, observation_space: spaces.Dict, width: int = 64) -> None:
        parts = getattr(observation_space, "spaces", {})
        if "proprio" not in parts or not cameras_of(parts):
            raise InputError(
                f"SightExtractor requires pictures with depth, got {observation_space}. Create "
                "the environment with observation='pixels+proprio', kinds=['depth'], "
                "target_mark='mask', calibration=True and instruction='none'."
            )
        looked = {
            "state": spaces.Box(-np.inf, np.inf, (STATE,), np.float32),
            "height_map": height_map_space(),
        }
        super().__init__(spaces.Dict(looked), width)
        self._observation_space = observation_space

    def forward(self, observations: dict[str, Any]) -> Float[Tensor, "n f"]:
        """Compute the features of a batch of observations, with empty memories."""
        empty = torch.zeros(len(observations["proprio"]), MEMORY)
        return self.recall(observations, empty)[0]

    def recall(
        self, observations: dict[str, Any], memory: Float[Tensor, "n 15"]
    ) -> tuple[Float[Tensor, "n f"], Float[Tensor, "n 15"]]:
        """Compute the features of a batch of observations, and the updated memories."""
        state, maps, shown = perceive(observations)
        state, goal = recall_goal(state, shown, memory[:, _GRASP:])
        kept = _fits(state, memory)
        plan, anew = _plan_of(state, memory), ~kept & _needs_grasp(state)
        if anew.any():
            plan[anew] = self.plans(state[anew], maps[anew])
        after = memory.clone()
        after[:, 1] += 1
        after[anew, :_GRASP] = _memory_of(state[anew], plan[anew])
        after[:, _GRASP:] = goal
        plan = torch.where((kept | anew)[:, None], plan, 0.0)
        way = torch.where(_sees_target(state)[:, None], ways(state, maps, plan), 0.0)
        return self.features(state, way), after


def _sees_target(state: Float[Tensor, "n s"]) -> Bool[Tensor, "n"]:
    """Return whether a target is visible; Reach has no target, so there is nothing to grasp."""
    return state[:, len(ROBOT_BOUNDS) + 18] > 0.5


def _needs_grasp(state: Float[Tensor, "n s"]) -> Bool[Tensor, "n"]:
    """Return whether a target is visible that is neither held nor at its goal."""
    return _sees_target(state) & ~is_held(state) & ~at_goal(state)


def _fits(state: Float[Tensor, "n s"], memory: Float[Tensor, "n 15"]) -> Bool[Tensor, "n"]:
    """Return whether the grasp in a policy's memory is still valid."""
    moved = state[:, _TARGET] - memory[:, 2:5]
    aside = (state[:, _TOOL] - memory[:, 5:8])[:, :2].norm(dim=1)
    still = (moved[:, :2].norm(dim=1) < _MOVED) & (moved[:, 2].abs() < _MOVED)
    known = (memory[:, 0] > 0.5) & (memory[:, 1] < _LONGEST)
    return known & still & (aside < _OVER) & _needs_grasp(state)


def _plan_of(state: Float[Tensor, "n s"], memory: Float[Tensor, "n 15"]) -> Float[Tensor, "n 6"]:
    """Return the grasp in a policy's memory in the format ``grasp_head.PLAN``, with heading 0."""
    aside = memory[:, 5:7] - state[:, _TARGET][:, :2]
    up = memory[:, 7] - lowest_of(state)
    return torch.cat([aside, up[:, None], memory[:, 8:_GRASP]], 1)


def _memory_of(state: Float[Tensor, "n s"], plan: Float[Tensor, "n 6"]) -> Float[Tensor, "n 11"]:
    """Return the memory entries that store a grasp."""
    middle = state[:, _TARGET]
    place = torch.cat([middle[:, :2] + plan[:, :2], (lowest_of(state) + plan[:, 2])[:, None]], 1)
    known = torch.tensor([1.0, 0.0]).expand(len(state), 2)
    return torch.cat([known, middle, place, plan[:, 3:]], 1)
