"""The goals that tasks are made of: a thing, a region and a state.

A goal asks for one thing, an object or the tool centre point, in one *region*, an upright elliptic
cylinder that may move with another object, and for a *state* there (at rest, let go, held ...).

==========  ==================================================  ===================================
goal        region of the target's centre                       state
==========  ==================================================  ===================================
`Reached`   2 cm around a point (of the tool centre point)      none
`Raised`    8 to 24 cm above where it stood, within 25 cm       held by both fingers
`Pushed`    4 cm around where it would stand on a spot          on the table, at rest, not toppled
`OnSpot`    4 cm around where it would stand on a spot          at rest, untouched by the robot
`Into`      the clear opening of a container, from its floor    at rest, untouched, its lowest
            to the target's height above the rim                point below the rim, the container
                                                                upright
`OnTop`     the flat part of a support's top, where it would    at rest, untouched, touching the
            stand on it                                         top within 5 mm, the support upright
==========  ==================================================  ===================================

At rest is below 2 cm/s and 0.3 rad/s.
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
"""Name of the goal that is a marked free spot."""

SPOT_RADIUS, SPOT_HEIGHT = 0.04, 0.03
"""How far from the marked spot the target may stand, along the table and in height, metres."""

REST_SPEED, REST_SPIN = 0.02, 0.3
"""Below these speeds (m/s, rad/s) the target is at rest."""

INSIDE = 0.005
"""How far below the rim the lowest point of what is in a container lies at least, metres."""

REACHED = 0.02
"""How near the tool centre point has to come to a point, metres."""

RAISED = (0.08, 0.24)
"""Between which heights above where it stood a thing counts as lifted, metres."""

ASTRAY = 0.25
"""How far aside of where it stood a lifted thing may be, metres."""

UPRIGHT = float(np.cos(np.deg2rad(30.0)))
"""Least cosine between the world's up and what was up at the start of things that stand."""

GAP = 0.005
"""Most between a support's top and what stands on it, metres."""

LYING = 0.01
"""Height above the table up to which a pushed thing lies on it, metres."""

_ON_TOP = 0.015  # metres by which the height of a stacked thing may differ


@dataclass(frozen=True, eq=False)
class Region:
    """A goal region in the world frame: an upright elliptic cylinder.

    ``semi`` are the semi-axes along x', y' (turned by ``yaw``) and z, metres.
    """

    center: Float[np.ndarray, "3"]
    semi: Float[np.ndarray, "3"]
    yaw: float = 0.0


class Goal(ABC):
    """One thing that has to be somewhere.

    Attributes:
        target: the object to bring there; None for the tool centre point.
        reference: the object that carries the region, if one does.
        spot: the point to mark, world frame, if there is one.
        released: whether the hand has nothing left to do once the target is in the region.
        sentence: what to do, with places for what target and reference are called.
    """

    target: str | None
    reference: str | None
    spot: Float[np.ndarray, "3"] | None
    released: ClassVar[bool] = True
    sentence: ClassVar[str]

    @abstractmethod
    def region(self, world: World) -> Region:
        """Return where the target's centre has to be now."""

    def settled(self, world: World) -> bool:
        """Return whether the target is in the state asked for, wherever it is."""
        return True

    def words(self, world: World) -> str:
        """Return what to do, in words that fit what is on the table now."""
        named = {"target": self.target, "reference": self.reference}
        return self.sentence.format(**{k: the(world, name) for k, name in named.items() if name})


@dataclass(frozen=True, eq=False)
class Reached(Goal):
    """The tool centre point at a point of the world frame."""

    spot: Float[np.ndarray, "3"]
    target: None = None
    reference: None = None
    sentence = "move the hand to the marked point"

    def region(self, world: World) -> Region:
        """Return the point's surroundings."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return Region(self.spot, np.full(3, REACHED))


@dataclass(frozen=True, eq=False)
class Raised(Goal):
    """An object held in the air above where it stood; ``start`` was its centre, world frame."""

    target: str
    start: Float[np.ndarray, "3"]
    reference: None = None
    spot: None = None
    released = False
    sentence = "lift {target}"

    def region(self, world: World) -> Region:
        """Return the space above where it stood."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        low, high = RAISED
        center = self.start + np.array([0.0, 0.0, (low + high) / 2])
        return Region(center, np.array([ASTRAY, ASTRAY, (high - low) / 2]))

    def settled(self, world: World) -> bool:
        """Return whether both fingers hold it."""
        left, right, _ = world.touches(self.target)
        return left and right


@dataclass(frozen=True, eq=False)
class Pushed(Goal):
    """An object slid to a spot; ``rest`` is the height of its centre above what it stands on.

    ``up`` is the world's up in the object's frame at the start.
    """

    target: str
    spot: Float[np.ndarray, "3"]
    rest: float
    up: Float[np.ndarray, "3"]
    reference: None = None
    sentence = "push {target} to the marked spot"

    def region(self, world: World) -> Region:
        """Return where its centre is when it stands on the spot."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return _standing(self.spot, self.rest)

    def settled(self, world: World) -> bool:
        """Return whether it lies on the table as it stood, at rest."""
        upright = world.rotation(self.target)[2] @ self.up >= UPRIGHT
        lying = world.lowest(self.target) <= world.scene.table.height + LYING
        return bool(upright and lying and at_rest(world, self.target))


@dataclass(frozen=True, eq=False)
class OnSpot(Goal):
    """An object put down on a spot; ``rest`` as in `Pushed`.

    ``stead`` is the object whose place at the start the spot is, if it is one's.
    """

    target: str
    spot: Float[np.ndarray, "3"]
    rest: float
    stead: str | None = None
    reference: None = None
    sentence = "move {target} to the marked spot"

    def region(self, world: World) -> Region:
        """Return where its centre is when it stands on the spot."""
        return self._region

    @cached_property
    def _region(self) -> Region:
        return _standing(self.spot, self.rest)

    def settled(self, world: World) -> bool:
        """Return whether it rests, let go."""
        return at_rest(world, self.target) and not world.touches(self.target)[2]


@dataclass(frozen=True, eq=False)
class Into(Goal):
    """An object in the hollow of a container; ``height`` is the target's as it stood, metres."""

    target: str
    reference: str
    opening: Opening
    height: float
    spot: None = None
    sentence = "put {target} into {reference}"

    def region(self, world: World) -> Region:
        """Return the clear opening, from the hollow's floor to a target's height over the rim."""
        hollow, name = self.opening, self.reference
        rotation, top = world.rotation(name), hollow.rim + self.height
        local = np.array([*hollow.center, (hollow.floor + top) / 2])
        semi = np.array([*hollow.semi, (top - hollow.floor) / 2])
        return Region(world.position(name) + rotation @ local, semi, rotation_yaw(rotation))

    def settled(self, world: World) -> bool:
        """Return whether it rests, let go, wholly in the hollow of the upright container."""
        if not at_rest(world, self.target) or world.touches(self.target)[2]:
            return False
        hollow, up = self.opening, world.rotation(self.reference)[:, 2]
        base = world.position(self.reference)[2]
        below = world.lowest(self.target)
        floor = base + up[2] * (hollow.floor - hollow.thickness / 2)
        return bool(up[2] >= UPRIGHT and floor <= below <= base + up[2] * hollow.rim - INSIDE)


@dataclass(frozen=True, eq=False)
class OnTop(Goal):
    """An object standing on another's flat top; ``rest`` as in `Pushed`.

    ``up`` is the world's up in the support's frame at the start.
    """

    target: str
    reference: str
    plateau: Plateau
    rest: float
    up: Float[np.ndarray, "3"]
    spot: None = None
    sentence = "put {target} on {reference}"

    def region(self, world: World) -> Region:
        """Return where its centre is when it stands on the flat part."""
        rotation = world.rotation(self.reference)
        top = world.position(self.reference) + rotation @ self.plateau.center
        center = top + np.array([0.0, 0.0, self.rest])
        return Region(center, np.array([self.plateau.radius, self.plateau.radius, _ON_TOP]))

    def settled(self, world: World) -> bool:
        """Return whether it rests, let go, on the support, which still stands.

        What rests at that height over the flat part stands on it: contacts of things asleep are
        not listed.
        """
        if not at_rest(world, self.target) or world.touches(self.target)[2]:
            return False
        if world.rotation(self.reference)[2] @ self.up < UPRIGHT:
            return False
        top = world.position(self.reference) + world.rotation(self.reference) @ self.plateau.center
        return abs(world.lowest(self.target) - float(top[2])) <= GAP


def named_by(goals: Iterable[Goal]) -> list[str]:
    """Return the objects that goals need: what is to be moved, and what carries their regions."""
    names = (name for goal in goals for name in (goal.target, goal.reference))
    return list(dict.fromkeys(name for name in names if name is not None))


def begin_goals(world: World, goals: Iterable[Goal]) -> tuple[Goal, ...]:
    """Return goals drawn for a scene, adapted to a start at which its things stand elsewhere.

    Where a thing stood is where it stands now; marked spots stay where they are.
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
    """Return what an object is called among those on the table now, such as "the red mug"."""
    return refer(world.scene, world.scene.object(name), world.mount.yaw, world.absent)


def at_rest(world: World, name: str) -> bool:
    """Return whether an object is at rest."""
    speed = world.state.velocities[world.index(name)]
    linear, angular = speed[:3], speed[3:]
    return bool(linear @ linear <= REST_SPEED**2 and angular @ angular <= REST_SPIN**2)


def _standing(spot: Float[np.ndarray, "3"], rest: float) -> Region:
    center = spot + np.array([0.0, 0.0, rest])
    return Region(center, np.array([SPOT_RADIUS, SPOT_RADIUS, SPOT_HEIGHT]))
