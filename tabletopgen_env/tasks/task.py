"""The base of all tasks: ordered goals, goal vectors, named reward terms, and a success test.

An episode is a tuple of goals. The *active* goal is the first unmet one; the state shows its target
and region. A task has *succeeded* while all its goals are met at once.

The reward's terms are all in [0, 1] and 1 on success:

=========  ========================================================================================
reach      tool centre point near the active target's centre: 1 / (1 + distance / 0.1 m)
grasp      1/2 for each finger that touches the active target
lift       height of the active target above its start, relative to the height required for the
           remaining path (at most 8 cm)
place      target near its region: 1 / (1 + distance / 0.15 m), averaged over the goals
met        the share of the goals that are met
success    all goals are met
=========  ========================================================================================

For reach, grasp and lift, a met goal counts as 1 and a future one as 0; the active goal also counts
as 1 while its target is in the region and only has to be released. The dense reward is a weighted
sum of the terms; the weights sum to 1, and the reward is 1 if and only if the task has succeeded.
The sparse reward is 0 on success and -1 otherwise. With goal-dict observations, the reward must
depend on the goal vectors alone: the sparse reward is as above, the dense one is 0.5 place + 0.5
met.

A goal vector has eight entries per goal: the centre x, y, z of its region in the base frame (m),
the semi-axes x', y' (m), yaw (rad), semi-axis z (m), and 1 for the required state. In an achieved
goal vector the first three are the target's centre and the last is 1 if it is in that state; the
others are copied, so that an achieved goal can replace a desired one (hindsight). Tasks with a
variable number of goals pad with zeros.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import ClassVar

import numpy as np
from jaxtyping import Float

from generator.language.distribution import Needs

from ..goals.goal import SPOT_RADIUS, Goal
from ..world.composition import MarkerShape
from ..world.world import World
from .names import TaskName

GOAL_WEIGHTS: Mapping[str, float] = MappingProxyType({"place": 0.5, "met": 0.5})
"""Weights of the reward from achieved and desired goal vectors only."""

Choice = str | tuple[float, ...] | None
"""Values of the ``reset`` option "goal": an object's name, "spot", a point, or None."""

ENTRIES = 8
"""Number of entries per goal in a goal vector."""

LIFT = 0.08
"""Height by which an object is lifted to be carried, in metres."""

REACH_SCALE, PLACE_SCALE = 0.1, 0.15
"""Distances, in metres, at which the reward terms "reach" and "place" are 1/2."""

FAR = 3.0
"""Maximum magnitude of positions in goal vectors, in metres."""

_HAND = ("reach", "grasp", "lift")


@dataclass(frozen=True, eq=False)
class Episode:
    """The goals of one episode.

    goals: in order of display; starts: heights of the targets' centres at the start, world frame,
    metres.
    """

    goals: tuple[Goal, ...]
    starts: tuple[float, ...]


@dataclass(frozen=True)
class Gap:
    """The remaining distance between a goal's target and its region.

    across, up: horizontal and vertical distance of the target from its region, metres; met: whether
    the goal is met.
    """

    across: float
    up: float
    met: bool


def episode(world: World, goals: tuple[Goal, ...]) -> Episode:
    """Return an episode that begins now, with the given ``goals``."""
    starts = tuple(0.0 if g.target is None else float(world.position(g.target)[2]) for g in goals)
    return Episode(goals, starts)


class Task(ABC):
    """A kind of task that can be played at any table.

    Class attributes: ``weights`` of the dense reward by term; ``most``, the maximum number of
    goals; ``aside``, indices of goals that count as met once another goal, given by index, is met;
    ``closed``, whether the gripper stays closed; ``marker_radius`` (metres) and ``marker_shape`` of
    a marked spot; ``scenes``, the default source of tables; ``needs``, the required objects of
    generated tables (see ``goals.needs``).
    """

    weights: ClassVar[Mapping[str, float]]
    most: ClassVar[int] = 1
    aside: Mapping[int, int] = MappingProxyType({})
    closed: ClassVar[bool] = False
    scenes: str = "starter"
    needs: Needs = ()
    marker_radius: ClassVar[float] = SPOT_RADIUS
    marker_shape: ClassVar[MarkerShape] = "disc"

    @abstractmethod
    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw an episode for a world at its start, with the given target and goal, if any.

        ``target`` is the name of an object; the valid values of ``goal`` depend on the task.

        Raises:
            SceneError: the scene has no valid instance; the message gives a reason per object.
            InputError: the target or goal does not exist.
        """

    def instruction(self, world: World, goals: tuple[Goal, ...]) -> str:
        """Return the instruction for ``goals``, naming the objects in the world unambiguously."""
        return ", then ".join(goal.words(world) for goal in goals)

    @property
    def listed_as(self) -> TaskName | None:
        """The name of the task in certificates, or None for custom tasks."""
        kind = type(self)
        own = kind.__module__.startswith(f"{__package__}.")
        return TaskName(kind.__name__) if own else None

    # -------------------------------------------------------------------------------- goal vectors

    def desired_goal(self, world: World, episode: Episode) -> Float[np.ndarray, "g"]:
        """Return the desired goal vector (``float32``; 8 entries for each of ``most`` goals)."""
        entries: list[float] = []
        for goal in episode.goals:
            region = goal.region(world)
            x, y, z = region.semi.tolist()
            entries += _near(world.to_base(region.center))
            entries += (x, y, region.yaw - world.mount.yaw, z, 1.0)
        return self._vector(entries)

    def achieved_goal(
        self, world: World, episode: Episode, desired: Float[np.ndarray, "g"]
    ) -> Float[np.ndarray, "g"]:
        """Return the achieved goal vector; see ``desired_goal``."""
        entries: list[float] = []
        wanted = desired.tolist()
        for k, goal in enumerate(episode.goals):
            entries += _near(world.to_base(center(world, goal)))
            entries += wanted[ENTRIES * k + 3 : ENTRIES * k + 7]
            entries.append(float(goal.settled(world)))
        return self._vector(entries)

    def _vector(self, entries: list[float]) -> Float[np.ndarray, "g"]:
        return np.array(entries + [0.0] * (ENTRIES * self.most - len(entries)), np.float32)

    def gaps(self, achieved: Float[np.ndarray, "g"], desired: Float[np.ndarray, "g"]) -> list[Gap]:
        """Return the gap of each goal in a goal vector."""
        a, d = achieved.tolist(), desired.tolist()
        ends = range(0, len(d), ENTRIES)
        found = [_gap(a[k : k + ENTRIES], d[k : k + ENTRIES]) for k in ends if d[k + 3] > 0]
        for first, second in self.aside.items():
            if found[second].met:
                found[first] = replace(found[first], met=True)
        return found

    # -------------------------------------------------------------------------------------- reward

    def goal_terms(self, gaps: list[Gap]) -> dict[str, float]:
        """Return the terms that the goal vectors determine: place, met and success."""
        count = len(gaps)
        place = [1 / (1 + math.sqrt(g.across * g.across + g.up * g.up) / PLACE_SCALE) for g in gaps]
        for first, second in self.aside.items():
            if gaps[second].met:
                place[first] = 1.0
        met = sum(gap.met for gap in gaps)
        return {"place": sum(place) / count, "met": met / count, "success": float(met == count)}

    def terms(self, world: World, episode: Episode, gaps: list[Gap]) -> dict[str, float]:
        """Return all reward terms by name, each in [0, 1]."""
        shared = self.goal_terms(gaps)
        if shared["success"]:
            return dict.fromkeys((*_HAND, *shared), 1.0)
        met, count = sum(gap.met for gap in gaps), len(gaps)
        k = first_open(gaps)
        hand = self._hand(world, episode.goals[k], episode.starts[k], gaps[k])
        return {name: (met + value) / count for name, value in hand.items()} | shared

    def _hand(self, world: World, goal: Goal, start: float, gap: Gap) -> dict[str, float]:
        """Return the reach, grasp and lift terms of an active goal, given its ``start`` height."""
        if goal.target is None or (goal.released and gap.across <= 0 and gap.up <= 0):
            return dict.fromkeys(_HAND, 1.0)
        at = world.state.positions[world.index(goal.target)]
        left, right, _ = world.touches(goal.target)
        offset = world.state.tool - at
        away = math.sqrt(offset @ offset)
        asked = LIFT * min(gap.across / LIFT, 1.0) if goal.released else LIFT
        risen = float(at[2]) - start
        lift = min(max(risen / asked, 0.0), 1.0) if asked > 0 else 1.0
        return {"reach": 1 / (1 + away / REACH_SCALE), "grasp": (left + right) / 2, "lift": lift}


def first_open(gaps: list[Gap]) -> int:
    """Return the index of the first unmet goal, or of the last goal if all are met."""
    return next((k for k, gap in enumerate(gaps) if not gap.met), len(gaps) - 1)


def center(world: World, goal: Goal) -> Float[np.ndarray, "3"]:
    """Return the point of a goal's target: an object's centre or the tool centre point."""
    if goal.target is None:
        return world.state.tool.copy()
    return world.position(goal.target)


def _gap(achieved: list[float], desired: list[float]) -> Gap:
    """Return the gap of one goal from its entries in an achieved and a desired goal vector."""
    x, y, z, semi_x, semi_y, yaw, semi_z, state = desired
    x, y, z = achieved[0] - x, achieved[1] - y, achieved[2] - z
    c, s = math.cos(yaw), math.sin(yaw)
    out = math.hypot((c * x + s * y) / semi_x, (c * y - s * x) / semi_y)  # 1 at the edge
    across = math.hypot(x, y) * (1 - 1 / out) if out > 1 else 0.0
    up = max(abs(z) - semi_z, 0.0)
    return Gap(across, up, across <= 0 and up <= 0 and achieved[7] >= state)


def _near(point: Float[np.ndarray, "3"]) -> list[float]:
    return [min(max(x, -FAR), FAR) for x in point.tolist()]
