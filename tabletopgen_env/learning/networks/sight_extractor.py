"""A policy that sees: what ``perception`` makes of pictures, looked at as height maps are.

From each place a hand sees other parts of a thing, so the head would change its mind on the way: a
rim can be grasped all around. A *memory* keeps its last grasp, where it is in the base frame. Once
the hand is over it, it is not asked again, unless the target has moved or time has passed. A marker
that the hand hides is remembered where it was seen best.
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
"""Entries of a memory: 1 if there is a grasp, for how many steps it was kept, the target's middle
when it was found, the tool's place in it (base frame, m), and the last three of
``grasp_head.PLAN``; then by how many points the marker was seen best, and where
(``perception.recall_goal``)."""

_GRASP = 11  # entries of the grasp

_TOOL, _TARGET = slice(15, 18), slice(len(ROBOT_BOUNDS), len(ROBOT_BOUNDS) + 3)
_MOVED = 0.015  # metres that the target's middle may seem to move, aside and up
_OVER = 0.05  # metres aside within which the hand is over a grasp
_LONGEST = 60  # steps for which a grasp is kept


class SightExtractor(LookExtractor):
    """Features of "pixels+proprio" with depth, masks of the target and calibrations.

    Colours are needed where the goal is a marked point (Reach).

    Raises:
        InputError: the observation lacks them.
    """

    def __init__(self, observation_space: spaces.Dict, width: int = 64) -> None:
        parts = getattr(observation_space, "spaces", {})
        if "proprio" not in parts or not cameras_of(parts):
            raise InputError(
                f"SightExtractor reads pictures, the observation is {observation_space}. Make the "
                "environment with observation='pixels+proprio', kinds=['depth'], "
                "target_mark='mask', calibration=True and instruction='none'."
            )
        looked = {
            "state": spaces.Box(-np.inf, np.inf, (STATE,), np.float32),
            "height_map": height_map_space(),
        }
        super().__init__(spaces.Dict(looked), width)
        self._observation_space = observation_space

    def forward(self, observations: dict[str, Any]) -> Float[Tensor, "n f"]:
        """Return the features of a batch of observations, with nothing remembered."""
        empty = torch.zeros(len(observations["proprio"]), MEMORY)
        return self.recall(observations, empty)[0]

    def recall(
        self, observations: dict[str, Any], memory: Float[Tensor, "n 15"]
    ) -> tuple[Float[Tensor, "n f"], Float[Tensor, "n 15"]]:
        """Return the features of a batch of observations, and the memories after it."""
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
    """Return whether a target is seen; without one there is no way to go (Reach)."""
    return state[:, len(ROBOT_BOUNDS) + 18] > 0.5


def _needs_grasp(state: Float[Tensor, "n s"]) -> Bool[Tensor, "n"]:
    """Return whether a target is seen that is neither held nor at its goal."""
    return _sees_target(state) & ~is_held(state) & ~at_goal(state)


def _fits(state: Float[Tensor, "n s"], memory: Float[Tensor, "n 15"]) -> Bool[Tensor, "n"]:
    """Return whether a memory's grasp is still the one to go for."""
    moved = state[:, _TARGET] - memory[:, 2:5]
    aside = (state[:, _TOOL] - memory[:, 5:8])[:, :2].norm(dim=1)
    still = (moved[:, :2].norm(dim=1) < _MOVED) & (moved[:, 2].abs() < _MOVED)
    known = (memory[:, 0] > 0.5) & (memory[:, 1] < _LONGEST)
    return known & still & (aside < _OVER) & _needs_grasp(state)


def _plan_of(state: Float[Tensor, "n s"], memory: Float[Tensor, "n 15"]) -> Float[Tensor, "n 6"]:
    """Return a memory's grasp as ``grasp_head.PLAN``; the estimate's heading is 0."""
    aside = memory[:, 5:7] - state[:, _TARGET][:, :2]
    up = memory[:, 7] - lowest_of(state)
    return torch.cat([aside, up[:, None], memory[:, 8:_GRASP]], 1)


def _memory_of(state: Float[Tensor, "n s"], plan: Float[Tensor, "n 6"]) -> Float[Tensor, "n 11"]:
    """Return the memory of a grasp."""
    middle = state[:, _TARGET]
    place = torch.cat([middle[:, :2] + plan[:, :2], (lowest_of(state) + plan[:, 2])[:, None]], 1)
    known = torch.tensor([1.0, 0.0]).expand(len(state), 2)
    return torch.cat([known, middle, place, plan[:, 3:]], 1)
