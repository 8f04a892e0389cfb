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
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import ClassVar

import numpy as np
from jaxtyping import Bool, Float

from generator.language.distribution import Needs

from ..goals.goal import SPOT_RADIUS, Goal
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

_FAR = 3.0  # metres; positions in goal vectors are clipped to it
_LEAST = 1e-6  # metres; what semi-axes are at least taken for
_HAND = ("reach", "grasp", "lift")


@dataclass(frozen=True, eq=False)
class Episode:
    """What one episode asks for.

    goals: in the order in which they are shown; starts: heights of their targets' centres at the
    start, world frame.
    """

    goals: tuple[Goal, ...]
    starts: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Agreement:
    """How an achieved goal vector agrees with a desired one, goal by goal.

    across, up: how far outside its region each target is, horizontally and vertically, metres;
    met: whether each goal is met (padding is); used: which goals are no padding.
    """

    across: Float[np.ndarray, "*n most"]
    up: Float[np.ndarray, "*n most"]
    met: Bool[np.ndarray, "*n most"]
    used: Bool[np.ndarray, "*n most"]

    @cached_property
    def active(self) -> int:
        """The index of the first goal that is not met; of the last one, if all are."""
        first = int(self.met.argmin())
        last = int(np.count_nonzero(self.used)) - 1
        return last if self.met[first] else min(first, last)


def episode(world: World, goals: tuple[Goal, ...]) -> Episode:
    """Return the episode of ``goals``, which begins now."""
    starts = tuple(0.0 if g.target is None else float(world.position(g.target)[2]) for g in goals)
    return Episode(goals, starts)


class Task(ABC):
    """One kind of thing to do at any table.

    Class attributes: ``weights`` of the dense reward by term; ``most`` goals of an episode;
    ``aside``: goals, by index, that count as met once another, by index, is met; ``closed``:
    whether the gripper stays closed; ``marker_radius`` of the disc that marks a spot, metres;
    ``scenes`` where its tables come from unless others are given; ``needs`` what tables that are
    drawn for it hold besides others; see ``needs``.
    """

    weights: ClassVar[Mapping[str, float]]
    most: ClassVar[int] = 1
    aside: Mapping[int, int] = MappingProxyType({})
    closed: ClassVar[bool] = False
    scenes: str = "starter"
    needs: Needs = ()
    marker_radius: ClassVar[float] = SPOT_RADIUS

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
        vector = np.zeros((self.most, ENTRIES))
        for row, goal in zip(vector, episode.goals, strict=False):
            region = goal.region(world)
            row[:3] = _near(world.to_base(region.center))
            row[3:5] = region.semi[:2]
            row[5:] = region.yaw - world.mount.yaw, region.semi[2], 1.0
        return vector.ravel().astype(np.float32)

    def achieved_goal(
        self, world: World, episode: Episode, desired: Float[np.ndarray, "g"]
    ) -> Float[np.ndarray, "g"]:
        """Return what is achieved in the same form."""
        vector = desired.reshape(self.most, ENTRIES).copy()
        for row, goal in zip(vector, episode.goals, strict=False):
            row[:3] = _near(world.to_base(center(world, goal)))
            row[7] = goal.settled(world)
        return vector.ravel()

    def agreement(
        self, achieved: Float[np.ndarray, "*n g"], desired: Float[np.ndarray, "*n g"]
    ) -> Agreement:
        """Return how goal vectors agree; vectorised."""
        a, d = (np.asarray(v, np.float64) for v in (achieved, desired))
        a, d = (v.reshape(*v.shape[:-1], -1, ENTRIES) for v in (a, d))
        across, up = distance(a, d)
        used = d[..., 3] > 0
        met = (across <= 0) & (up <= 0) & (a[..., 7] >= d[..., 7]) | ~used
        for first, second in self.aside.items():
            met[..., first] |= met[..., second]
        return Agreement(across, up, met, used)

    # -------------------------------------------------------------------------------------- reward

    def goal_terms(self, agreement: Agreement) -> dict[str, float | Float[np.ndarray, "*n"]]:
        """Return the terms that follow from the goal vectors: place, met, success; vectorised."""
        across, up, met = agreement.across, agreement.up, agreement.met
        if met.shape == (1,):  # one goal at a time: the same sums, without arrays
            apart = math.sqrt(across[0] * across[0] + up[0] * up[0])
            done = np.asarray(met[0], np.float64)
            return {"place": np.asarray(1 / (1 + apart / 0.15)), "met": done, "success": done}
        place = 1 / (1 + np.sqrt(across * across + up * up) / 0.15)
        for first, second in self.aside.items():
            place[..., first] = np.where(met[..., second], 1.0, place[..., first])
        count = agreement.used.sum(-1)
        return {
            "place": (place * agreement.used).sum(-1) / count,
            "met": (met & agreement.used).sum(-1) / count,
            "success": np.asarray(met.all(-1), dtype=np.float64),
        }

    def terms(self, world: World, episode: Episode, agreement: Agreement) -> dict[str, float]:
        """Return every reward term by name, each in [0, 1]."""
        shared = {name: float(value) for name, value in self.goal_terms(agreement).items()}
        if shared["success"]:
            return dict.fromkeys((*_HAND, *shared), 1.0)
        count = len(episode.goals)
        met = int(np.count_nonzero(agreement.met[:count]))
        hand = self._hand(world, episode, agreement)
        return {name: (met + value) / count for name, value in hand.items()} | shared

    def _hand(self, world: World, episode: Episode, agreement: Agreement) -> dict[str, float]:
        """Return reach, grasp and lift of the active goal."""
        k = agreement.active
        goal = episode.goals[k]
        across, up = agreement.across[k], agreement.up[k]
        if goal.target is None or (goal.released and across <= 0 and up <= 0):
            return dict.fromkeys(_HAND, 1.0)
        at = world.position(goal.target)
        left, right, _ = world.touches(goal.target)
        offset = world.data.site_xpos[world.tcp] - at
        away = math.sqrt(offset @ offset)
        asked = LIFT * min(float(across) / LIFT, 1.0) if goal.released else LIFT
        risen = float(at[2]) - episode.starts[k]
        lift = min(max(risen / asked, 0.0), 1.0) if asked > 0 else 1.0
        return {"reach": 1 / (1 + away / 0.1), "grasp": (left + right) / 2, "lift": lift}


def center(world: World, goal: Goal) -> Float[np.ndarray, "3"]:
    """Return where what a goal is about is: an object's centre or the tool centre point."""
    if goal.target is None:
        return world.data.site_xpos[world.tcp].copy()
    return world.position(goal.target)


def distance(
    achieved: Float[np.ndarray, "*n 8"], desired: Float[np.ndarray, "*n 8"]
) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n"]]:
    """Return how far outside a goal's region a target is, horizontally and vertically, metres."""
    a, d = np.asarray(achieved, np.float64), np.asarray(desired, np.float64)
    away = a[..., :3] - d[..., :3]
    x, y, z = away[..., 0], away[..., 1], away[..., 2]
    c, s = np.cos(d[..., 5]), np.sin(d[..., 5])
    semi = np.maximum(d[..., 3:5], _LEAST)  # padding has none
    u, v = (c * x + s * y) / semi[..., 0], (c * y - s * x) / semi[..., 1]
    outside = np.hypot(x, y) * (1 - 1 / np.maximum(np.hypot(u, v), 1.0))
    return outside, np.maximum(np.abs(z) - d[..., 6], 0.0)


def _near(point: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3"]:
    return np.minimum(np.maximum(point, -_FAR), _FAR)
