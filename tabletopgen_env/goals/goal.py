"""The goals of tasks, each of which requires a target to reach a region and a state.

A goal requires its target (an object or the tool centre point) to be in a *region* (an upright
elliptic cylinder that may move with another object) and in a *state* (at rest, released, held ...).

==========  ==================================================  ===================================
goal        region for the centre of the target                 state
==========  ==================================================  ===================================
`Reached`   2 cm around a point (of the tool centre point)      none
`Raised`    8 to 24 cm above its start, within 25 cm            held by both fingers
`Pushed`    4 cm around its resting place on a spot             on the table, at rest, not toppled
`OnSpot`    4 cm around its resting place on a spot             at rest, untouched by the robot
`Into`      the clear opening of a container, from its floor    at rest, untouched, its lowest
            to the target's height above the rim                point below the rim, the container
                                                                upright
`OnTop`     the flat part of a support's top, at the height of  at rest, untouched, touching the
            the resting target                                  top within 5 mm, the support upright
==========  ==================================================  ===================================

*At rest* means below 2 cm/s and 0.3 rad/s.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np
from jaxtyping import Float

from generator.geometry import rotation_yaw

from ..affordance import Opening, Plateau
from ..world.world import World
from .instructions import refer

SPOT = "spot"
"""Goal name of a marked free spot."""

SPOT_RADIUS, SPOT_HEIGHT = 0.04, 0.03
"""Horizontal and vertical tolerance of the target at the marked spot, in metres."""

REST_SPEED, REST_SPIN = 0.02, 0.3
"""Speeds below which the target is at rest, in m/s and rad/s."""

INSIDE = 0.005
"""Minimum depth below the rim of the lowest point of an object in a container, in metres."""

REACHED = 0.02
"""Maximum distance of the tool centre point from its goal point, in metres."""

RAISED = (0.08, 0.24)
"""Range of heights above its start at which an object counts as lifted, in metres."""

ASTRAY = 0.25
"""Maximum horizontal distance of a lifted object from its start, in metres."""

UPRIGHT = float(np.cos(np.deg2rad(30.0)))
"""Minimum cosine between the world's up axis and an object's original up axis while it stands."""

GAP = 0.005
"""Maximum gap between a support's top and the object on it, in metres."""

LYING = 0.01
"""Maximum height above the table of a pushed object's lowest point, in metres."""

_ON_TOP = 0.015  # tolerance of a stacked object's height, metres


@dataclass(frozen=True, eq=False)
class Region:
    """A goal region in the world frame: an upright elliptic cylinder.

    ``semi`` are the semi-axes along x', y' (turned by ``yaw``) and z, metres.
    """

    center: Float[np.ndarray, "3"]
    semi: Float[np.ndarray, "3"]
    yaw: float = 0.0


class Goal(ABC):
    """A target that must reach a region and a state.

    Attributes:
        target: the object to move; None for the tool centre point.
        reference: the object that carries the region, if any.
        spot: the point to mark, world frame, if there is one.
        released: whether the target only has to be released once it is in the region.
        sentence: the instruction, with placeholders for the names of target and reference.
    """

    target: str | None
    reference: str | None
    spot: Float[np.ndarray, "3"] | None
    released: ClassVar[bool] = True
    sentence: ClassVar[str]

    @abstractmethod
    def region(self, world: World) -> Region:
        """Return the current region that the target's centre must reach."""

    def settled(self, world: World) -> bool:
        """Return whether the target is in the required state, regardless of its position."""
        return True

    def words(self, world: World) -> str:
        """Return the goal as an English instruction, with unambiguous names for the objects."""
        named = {"target": self.target, "reference": self.reference}
        return self.sentence.format(**{k: the(world, name) for k, name in named.items() if name})


@dataclass(frozen=True, eq=False)
class Reached(Goal):
    """A goal that requires the tool centre point to be at a given point in the world frame."""

    spot: Float[np.ndarray, "3"]
    target: None = None
    reference: None = None
    sentence = "move the hand to the marked point"

    def region(self, world: World) -> Region:
        """Return the region around the point."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return Region(self.spot, np.full(3, REACHED))


@dataclass(frozen=True, eq=False)
class Raised(Goal):
    """A goal that requires an object to be held above ``start``, its initial centre (world)."""

    target: str
    start: Float[np.ndarray, "3"]
    reference: None = None
    spot: None = None
    released = False
    sentence = "lift {target}"

    def region(self, world: World) -> Region:
        """Return the region above the object's initial position."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        low, high = RAISED
        center = self.start + np.array([0.0, 0.0, (low + high) / 2])
        return Region(center, np.array([ASTRAY, ASTRAY, (high - low) / 2]))

    def settled(self, world: World) -> bool:
        """Return whether both fingers hold the object."""
        left, right, _ = world.touches(self.target)
        return left and right


@dataclass(frozen=True, eq=False)
class Pushed(Goal):
    """A goal that requires an object to be pushed to a spot.

    ``rest`` is the height of the object's centre above the support when it stands there. ``up`` is
    the world's up axis in the object's frame at the start.
    """

    target: str
    spot: Float[np.ndarray, "3"]
    rest: float
    up: Float[np.ndarray, "3"]
    reference: None = None
    sentence = "push {target} to the marked spot"

    def region(self, world: World) -> Region:
        """Return the region for the object's centre when it rests on the spot."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return _standing(self.spot, self.rest)

    def settled(self, world: World) -> bool:
        """Return whether the object is at rest on the table, in its original orientation."""
        upright = world.rotation(self.target)[2] @ self.up >= UPRIGHT
        lying = world.lowest(self.target) <= world.scene.table.height + LYING
        return bool(upright and lying and at_rest(world, self.target))


@dataclass(frozen=True, eq=False)
class OnSpot(Goal):
    """A goal that requires an object to be placed on a spot; ``rest`` is as in `Pushed`.

    ``stead`` is the object whose start position is the spot, if any.
    """

    target: str
    spot: Float[np.ndarray, "3"]
    rest: float
    stead: str | None = None
    reference: None = None
    sentence = "move {target} to the marked spot"

    def region(self, world: World) -> Region:
        """Return the region for the object's centre when it rests on the spot."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return _standing(self.spot, self.rest)

    def settled(self, world: World) -> bool:
        """Return whether the object is at rest and released."""
        return at_rest(world, self.target) and not world.touches(self.target)[2]


@dataclass(frozen=True, eq=False)
class Into(Goal):
    """A goal that requires an object to be in a container.

    ``height`` is the height of the resting object in metres.
    """

    target: str
    reference: str
    opening: Opening
    height: float
    spot: None = None
    sentence = "put {target} into {reference}"

    def region(self, world: World) -> Region:
        """Return the region of the hollow, extended above the rim by the target's height."""
        hollow, name = self.opening, self.reference
        rotation, top = world.rotation(name), hollow.rim + self.height
        local = np.array([*hollow.center, (hollow.floor + top) / 2])
        semi = np.array([*hollow.semi, (top - hollow.floor) / 2])
        return Region(world.position(name) + rotation @ local, semi, rotation_yaw(rotation))

    def settled(self, world: World) -> bool:
        """Return whether the object is at rest, released, and inside the upright container."""
        if not at_rest(world, self.target) or world.touches(self.target)[2]:
            return False
        hollow, up = self.opening, world.rotation(self.reference)[:, 2]
        base = world.position(self.reference)[2]
        below = world.lowest(self.target)
        floor = base + up[2] * (hollow.floor - hollow.thickness / 2)
        return bool(up[2] >= UPRIGHT and floor <= below <= base + up[2] * hollow.rim - INSIDE)


@dataclass(frozen=True, eq=False)
class OnTop(Goal):
    """A goal that requires an object to stand on another's flat top; ``rest`` is as in `Pushed`.

    ``up`` is the world's up axis in the support's frame at the start.
    """

    target: str
    reference: str
    plateau: Plateau
    rest: float
    up: Float[np.ndarray, "3"]
    spot: None = None
    sentence = "put {target} on {reference}"

    def region(self, world: World) -> Region:
        """Return the region for the object's centre when it rests on the support's flat top."""
        rotation = world.rotation(self.reference)
        top = world.position(self.reference) + rotation @ self.plateau.center
        center = top + np.array([0.0, 0.0, self.rest])
        return Region(center, np.array([self.plateau.radius, self.plateau.radius, _ON_TOP]))

    def settled(self, world: World) -> bool:
        """Return whether the object is at rest and released on the support, which must be upright.

        An object at rest at that height over the flat part stands on it. Contacts are not checked,
        because MuJoCo lists none for sleeping bodies.
        """
        if not at_rest(world, self.target) or world.touches(self.target)[2]:
            return False
        if world.rotation(self.reference)[2] @ self.up < UPRIGHT:
            return False
        top = world.position(self.reference) + world.rotation(self.reference) @ self.plateau.center
        return abs(world.lowest(self.target) - float(top[2])) <= GAP


def named_by(goals: Iterable[Goal]) -> list[str]:
    """Return the names of the objects to which goals refer as targets or references."""
    names = (name for goal in goals for name in (goal.target, goal.reference))
    return list(dict.fromkeys(name for name in names if name is not None))


def begin_goals(world: World, goals: Iterable[Goal]) -> tuple[Goal, ...]:
    """Return a scene's goals, adapted to the positions of its objects at the start of an episode.

    Start positions become the current positions; marked spots are unchanged.
    """
    found: list[Goal] = []
    for goal in goals:
        if isinstance(goal, Raised):
            goal = replace(goal, start=world.position(goal.target))
        elif isinstance(goal, OnSpot) and goal.stead is not None:
            here = world.position(goal.stead)[:2]
            goal = replace(goal, spot=np.array([*here, world.scene.table.height]))
        found.append(goal)
    return tuple(found)


def the(world: World, name: str) -> str:
    """Return a name that distinguishes an object from the others present, such as "the red mug"."""
    return refer(world.scene, world.scene.object(name), world.mount.yaw, world.absent)


def at_rest(world: World, name: str) -> bool:
    """Return whether an object is at rest."""
    speed = world.state.velocities[world.index(name)]
    linear, angular = speed[:3], speed[3:]
    return bool(linear @ linear <= REST_SPEED**2 and angular @ angular <= REST_SPIN**2)


def _standing(spot: Float[np.ndarray, "3"], rest: float) -> Region:
    center = spot + np.array([0.0, 0.0, rest])
    return Region(center, np.array([SPOT_RADIUS, SPOT_RADIUS, SPOT_HEIGHT]))
