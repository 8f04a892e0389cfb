"""What every task shares: goals in order, goal vectors, named reward terms, exact success.

An episode is a tuple of goals. The *active* goal is the first that is not met; the state shows its
target and region. A task has *succeeded* while all its goals are met at once.

The reward's terms are all in [0, 1] and 1 on success:

=========  ========================================================================================
reach      tool centre point near the active target's centre: 1 / (1 + distance / 0.1 m)
grasp      half for each finger that touches the active target
lift       the active target's height above where it stood over what the way still to go asks for
           (at most 8 cm)
place      target near its region, the mean over the goals: 1 / (1 + distance / 0.15 m)
met        the share of the goals that are met
success    all goals are met
=========  ========================================================================================

Of reach, grasp and lift a goal that is met counts 1 and one still to come 0; they count in full
too while the active target is in its region and only has to be let go. A dense reward is a task's
weighted sum of them; the weights sum to 1 and the sum is 1 if and only if the task has succeeded.
Sparse reward: 0 on success, -1 otherwise. With goal-dict observations the reward must follow from
goal vectors alone: sparse as above, dense 0.5 place + 0.5 met.

A goal vector has eight entries a goal: its region's centre x, y, z in the base frame (m), the
semi-axes x', y' (m), yaw (rad), semi-axis z (m), and 1 for the state asked for. Of an achieved goal
the first three are the target's centre and the last says whether it is in that state; the others
are copied, so that what was achieved can stand in for what was desired (hindsight). A task for
which the number of goals varies pads with zeros.
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
"""Weights when only the achieved and the desired goal are known."""

Choice = str | tuple[float, ...] | None
"""What the option "goal" of ``reset`` may be: an object's name, "spot", a point, or nothing."""

ENTRIES = 8
"""Entries of one goal in a goal vector."""

LIFT = 0.08
"""Height to carry things at, metres."""

REACH_SCALE, PLACE_SCALE = 0.1, 0.15
"""Distances at which the terms reach and place are a half, metres."""

FAR = 3.0
"""Positions in goal vectors are clipped to it, metres."""

_HAND = ("reach", "grasp", "lift")


@dataclass(frozen=True, eq=False)
class Episode:
    """What one episode asks for.

    goals: in the order in which they are shown; starts: heights of their targets' centres at the
    start, world frame.
    """

    goals: tuple[Goal, ...]
    starts: tuple[float, ...]


@dataclass(frozen=True)
class Gap:
    """How far from being met one goal is.

    across, up: how far outside its region the target is, horizontally and vertically, metres;
    met: whether the goal is met.
    """

    across: float
    up: float
    met: bool


def episode(world: World, goals: tuple[Goal, ...]) -> Episode:
    """Return the episode of ``goals``, which begins now."""
    starts = tuple(0.0 if g.target is None else float(world.position(g.target)[2]) for g in goals)
    return Episode(goals, starts)


class Task(ABC):
    """One kind of thing to do at any table.

    Class attributes: ``weights`` of the dense reward by term; ``most`` goals of an episode;
    ``aside``: goals, by index, that count as met once another, by index, is met; ``closed``:
    whether the gripper stays closed; ``marker_radius``, metres, and ``marker_shape`` of what marks
    a spot; ``scenes`` where its tables come from unless others are given; ``needs`` what tables
    that are drawn for it hold besides others; see ``needs``.
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
        """Draw an episode of a world at its start, or take what is given.

        ``target`` is an object's name, ``goal`` what the task takes as one; see its page.

        Raises:
            SceneError: the scene offers nothing to do; says why for each object.
            InputError: what was asked for does not exist.
        """

    def instruction(self, world: World, goals: tuple[Goal, ...]) -> str:
        """Return what ``goals`` ask for, in words that fit what is on the table now."""
        return ", then ".join(goal.words(world) for goal in goals)

    @property
    def listed_as(self) -> TaskName | None:
        """The name under which certificates list it; None for a task of one's own."""
        kind = type(self)
        own = kind.__module__.startswith(f"{__package__}.")
        return TaskName(kind.__name__) if own else None

    # -------------------------------------------------------------------------------- goal vectors

    def desired_goal(self, world: World, episode: Episode) -> Float[np.ndarray, "g"]:
        """Return the desired goal vector, ``float32``, 8 entries for each of ``most`` goals."""
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
        """Return what is achieved in the same form."""
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
        """Return how far from being met each goal of a goal vector is."""
        a, d = achieved.tolist(), desired.tolist()
        ends = range(0, len(d), ENTRIES)
        found = [_gap(a[k : k + ENTRIES], d[k : k + ENTRIES]) for k in ends if d[k + 3] > 0]
        for first, second in self.aside.items():
            if found[second].met:
                found[first] = replace(found[first], met=True)
        return found

    # -------------------------------------------------------------------------------------- reward

    def goal_terms(self, gaps: list[Gap]) -> dict[str, float]:
        """Return the terms that follow from the goal vectors: place, met, success."""
        count = len(gaps)
        place = [1 / (1 + math.sqrt(g.across * g.across + g.up * g.up) / PLACE_SCALE) for g in gaps]
        for first, second in self.aside.items():
            if gaps[second].met:
                place[first] = 1.0
        met = sum(gap.met for gap in gaps)
        return {"place": sum(place) / count, "met": met / count, "success": float(met == count)}

    def terms(self, world: World, episode: Episode, gaps: list[Gap]) -> dict[str, float]:
        """Return every reward term by name, each in [0, 1]."""
        shared = self.goal_terms(gaps)
        if shared["success"]:
            return dict.fromkeys((*_HAND, *shared), 1.0)
        met, count = sum(gap.met for gap in gaps), len(gaps)
        k = first_open(gaps)
        hand = self._hand(world, episode.goals[k], episode.starts[k], gaps[k])
        return {name: (met + value) / count for name, value in hand.items()} | shared

    def _hand(self, world: World, goal: Goal, start: float, gap: Gap) -> dict[str, float]:
        """Return reach, grasp and lift of an active goal whose target stood at height ``start``."""
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
    """Return the index of the first goal that is not met; of the last one, if all are."""
    return next((k for k, gap in enumerate(gaps) if not gap.met), len(gaps) - 1)


def center(world: World, goal: Goal) -> Float[np.ndarray, "3"]:
    """Return where what a goal is about is: an object's centre or the tool centre point."""
    if goal.target is None:
        return world.state.tool.copy()
    return world.position(goal.target)


def _gap(achieved: list[float], desired: list[float]) -> Gap:
    """Return the gap of one goal's entries in an achieved and a desired goal vector."""
    x, y, z, semi_x, semi_y, yaw, semi_z, state = desired
    x, y, z = achieved[0] - x, achieved[1] - y, achieved[2] - z
    c, s = math.cos(yaw), math.sin(yaw)
    out = math.hypot((c * x + s * y) / semi_x, (c * y - s * x) / semi_y)  # 1 is the edge
    across = math.hypot(x, y) * (1 - 1 / out) if out > 1 else 0.0
    up = max(abs(z) - semi_z, 0.0)
    return Gap(across, up, across <= 0 and up <= 0 and achieved[7] >= state)


def _near(point: Float[np.ndarray, "3"]) -> list[float]:
    return [min(max(x, -FAR), FAR) for x in point.tolist()]
