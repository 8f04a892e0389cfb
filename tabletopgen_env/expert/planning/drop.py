"""The tool's path to the place where the held object is released."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from generator.geometry import rotation_z

from ...goals.goal import RAISED, Goal, Raised, at_rest
from ...world.world import World
from ..arm import least_turn, turn_left
from .grasps import TIP, Grasp
from .placement import Placer, plan_place

ABOVE = 0.04
"""Height above the goal, in metres, at which the held object is aligned with it."""

# tolerated horizontal error, and the additional error at which it stays at ABOVE, metres
_FINE, _FUNNEL = 0.006, 0.008
_TURNED = 0.05  # radians, both
_LIFT = 0.06
_LET_GO = 0.024  # additional opening of the fingers to release, metres
_TURNING = 0.35  # remaining turn beyond which the held object sweeps a circle, radians
_BESIDE = 0.015  # clearance beside the held object, metres
# height above the place below which a moving goal is being pushed by the hand, metres
_PUSHED = 0.02


class Drop:
    """The path of a held object to the release position that ``plan`` chooses in the goal's region.

    ``yaw`` is the hand's current yaw (base frame, radians); ``opening`` is the opening for release,
    metres.
    """

    def __init__(
        self, world: World, goal: Goal, yaw: float, opening: float, plan: Placer = plan_place
    ) -> None:
        assert goal.target is not None
        self._target, self._goal = goal.target, goal
        self._place = plan(world, goal, yaw, opening)
        self._shift = np.zeros(3)
        self.opening = opening
        self.tool = self._place.tool
        """World position of the tool at release, in metres, as of the last ``follow``."""
        self.follow(world)

    def follow(self, world: World) -> None:
        """Update the release position if the object shifted in the hand or the goal moved."""
        left, right, _ = world.touches(self._target)
        if not (left and right):  # a released object no longer counts
            return
        place, tool = self._place, world.data.site_xpos[world.tcp]
        if tool[2] > self.tool[2] + _PUSHED:  # otherwise the hand is at the goal and moves it
            self._shift = self._goal.region(world).center - place.seen
        offset = rotation_z(self.turn(world))[:2, :2] @ (world.position(self._target) - tool)[:2]
        sunk = tool[2] - world.lowest(self._target) - place.hanging
        self.tool = np.array([*(place.target - offset), place.tool[2] + sunk]) + self._shift

    def turn(self, world: World) -> float:
        """Return the remaining turn of the hand, in radians."""
        if self._place.yaw is None:
            tool = world.data.site_xpos[world.tcp]
            offset = (world.position(self._target) - tool)[:2]
            return least_turn(world, np.array([*(self._place.target - offset), tool[2]]))
        return turn_left(world, self._place.yaw, self._place.tool)

    def hover(self, world: World) -> float:
        """Return the height above the release position that the hand keeps until it is aligned."""
        aside = float(np.linalg.norm((world.data.site_xpos[world.tcp] - self.tool)[:2])) - _FINE
        turn = abs(self.turn(world)) - _TURNED
        return ABOVE * float(np.clip(max(aside / _FUNNEL, turn / _TURNED), 0.0, 1.0))


def let_go_at(grasp: Grasp) -> float:
    """Return how far (m) the fingers open to release an object, limited by its neighbours."""
    return min(grasp.opening, grasp.width + _LET_GO)


def lift_of(goal: Goal) -> float:
    """Return the height in metres by which an object is lifted before it is transported."""
    return sum(RAISED) / 2 if isinstance(goal, Raised) else _LIFT


def hanging(world: World, target: str) -> float:
    """Return how far the held object or the fingertips extend below the tool, in metres."""
    return max(float(world.data.site_xpos[world.tcp][2] - world.lowest(target)), TIP)


def load(world: World, target: str, turn: float) -> tuple[Float[np.ndarray, "3"], float]:
    """Return the centre of a held object relative to the tool, and the object's extent.

    Both are horizontal, in metres, world frame. If a large ``turn`` (radians) remains, the extent
    covers all directions.
    """
    if abs(turn) > _TURNING:
        return np.zeros(3), breadth(world, target)
    size = np.abs(world.rotation(target)) @ world.scene.object(target).scale / 2
    away = world.position(target) - world.data.site_xpos[world.tcp]
    return np.array([away[0], away[1], 0.0]), float(size[:2].max()) + _BESIDE


def breadth(world: World, target: str) -> float:
    """Return how far the held object extends horizontally from the tool, in metres."""
    size = np.abs(world.rotation(target)) @ world.scene.object(target).scale / 2
    away = (world.position(target) - world.data.site_xpos[world.tcp])[:2]
    return float(np.linalg.norm(away) + size[:2].max())


def met(world: World, goal: Goal) -> bool:
    """Return whether the goal's target is in the required place and state."""
    assert goal.target is not None
    if not goal.settled(world):
        return False
    region = goal.region(world)
    away = rotation_z(region.yaw).T @ (world.position(goal.target) - region.center) / region.semi
    return bool(np.linalg.norm(away[:2]) <= 1.0 and abs(away[2]) <= 1.0)


def lost(world: World, goal: Goal) -> bool:
    """Return whether the goal's target is at rest and released, but does not meet the goal."""
    assert goal.target is not None
    still = not world.touches(goal.target)[2] and at_rest(world, goal.target)
    return still and not met(world, goal)
