"""A teacher with planned grasps, for policies that find grasps themselves.

The expert follows its own grasp hint, which is not part of the environment's observations.
Observations are reduced to the flat state (estimated from pictures by ``networks.perception``) and
the features of the way to the teacher's grasp (``networks.look_extractor``). Thus the part of a
policy that moves the arm is trained separately from its grasp head, and different good grasps are
never averaged into a bad one.
"""

from __future__ import annotations

import math
from typing import Any

import gymnasium as gym
import numpy as np
import torch
from jaxtyping import Float, Float32
from torch import Tensor

from generator.geometry import rotation_z

from ...actions.servos import Controller
from ...expert.planning.choice import GraspPlan
from ...expert.planning.placement import unturned_place
from ...goals.goal import Goal
from ...observations.bounds import ROBOT_BOUNDS
from ...observations.grasp_hint import GraspHint
from ...world.world import World
from ..networks.look_extractor import heading_of, lowest_of, ways
from ..networks.perception import perceive, recall_goal


class Teacher:
    """The expert's view of an environment during one episode, with an additional grasp hint."""

    def __init__(self, env: gym.Env[Any, np.ndarray]) -> None:
        self._env: Any = env.unwrapped
        self.action_mode: str = self._env.action_mode
        self.controller: Controller = self._env.controller
        self.hint = GraspHint("planned", unturned_place)
        self._goal: Goal | None = None
        self._marker = torch.zeros(1, 4)  # per episode, see perception.recall_goal

    @property
    def unwrapped(self) -> Teacher:
        """The teacher itself, which takes the place of the unwrapped environment."""
        return self

    @property
    def world(self) -> World:
        """The world of the current episode."""
        return self._env.world

    @property
    def goal(self) -> Goal:
        """The goal of the current episode."""
        return self._env.goal

    def see(self, observation: dict[str, Any]) -> Float32[np.ndarray, "n"]:
        """Update the plan, and reduce an observation to the flat state and motion features."""
        world, goal = self.world, self.goal
        if goal is not self._goal:
            self.hint.begin(world, goal)
            self._goal = goal
        self.hint.entries(world, goal)
        plan = None if goal.target is None else self.hint.plan(world, goal.target)
        parts = {name: torch.from_numpy(part)[None] for name, part in observation.items()}
        if "proprio" in parts:
            state, maps, shown = perceive(parts)
            state, self._marker = recall_goal(state, shown, self._marker)
        else:
            state, maps = parts["state"], parts["height_map"]
        if plan is None or goal.target is None:
            return np.append(state[0].numpy(), np.zeros(8, np.float32))
        found = torch.from_numpy(plan_in_heading(world, state[0], plan).astype(np.float32))
        return torch.cat([state[0], ways(state, maps, found[None])[0]]).numpy()


def plan_in_heading(
    world: World, state: Float[Tensor, "s"], plan: GraspPlan
) -> Float[np.ndarray, "6"]:
    """Convert a grasp plan to the policy's representation; see ``networks.grasp_head.PLAN``."""
    slot = state[len(ROBOT_BOUNDS) :]
    heading, low = float(heading_of(state[None])[0]), float(lowest_of(state[None])[0])
    point = world.to_base(plan.grasp.point) - np.array([float(slot[0]), float(slot[1]), low])
    x, y, z = rotation_z(-heading) @ point
    angle = plan.yaw - math.pi / 2 - heading
    return np.array([x, y, z, angle, plan.grasp.opening, plan.grasp.width])
