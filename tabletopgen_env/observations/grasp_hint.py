"""The grasp hint in the state: where to grasp the active target and where to release it.

A box and a pose do not show where a mug's handle is, or on which side of an object there is room
for a finger. ``grasp_hint`` adds eight entries that do. When a goal becomes active, a grasp is
planned, which then moves with the object; once both fingers have raised the object, a place is
planned.

=====  =============================================================================  ==========
entry  meaning                                                                        unit
=====  =============================================================================  ==========
0-2    target minus current position of the tool, base frame                          m
3      remaining rotation of the hand about the vertical, within the joint's range    rad
4      opening of the fingers before the descent, or for the release                  m
5      width of the object between the fingers                                        m
6      height that the tool still has to gain to pass over obstacles on its way       m
7      1 on the way to a grasp, -1 with the target in the hand, 0 (as are all others)
       if no grasp is known
=====  =============================================================================  ==========

The source of the hint:

==============  ================================================================================
``"detected"``  a small network trained to detect grasps (``detection``) in height maps like those
                of a depth camera above the table. The hint is the best-rated grasp that the arm
                can reach. The place is the centre of the goal's region, at the current yaw of
                the hand or half a turn from it, at a height that follows from the height map.
``"planned"``   (or True) the expert's planners, which know the collision shapes. They may also
                rotate the held object, or release it off the centre, where there is more room
==============  ================================================================================

``"detected"`` also uses information that a real robot would have to perceive: the maps have no
noise, exclude the arm, and show occluded surfaces. The centre, heading and box of each object are
exact, as in the rest of the state, and so are its lowest point, its pose in the hand, and whether
it is at rest. Objects without a planned grasp are not chosen as targets.

In both modes the hint gives a path, and the policy has to follow it.

Once the target is between both fingers, the path leads straight up and then, unless the goal only
requires lifting, to the place of release. That place is shown until the object is released and at
rest elsewhere; the grasp that lost it is not shown again if there are others. Entry 6 is 0 within 2
cm of the vertical through the end of the path.
"""

from __future__ import annotations

import math

import numpy as np
from jaxtyping import Float

from generator.errors import InputError, choices
from generator.geometry import rotation_yaw, rotation_z, wrap

from ..expert.arm import turn_left
from ..expert.driver import NEAR
from ..expert.path import ROOM, clear_height
from ..expert.planning.choice import Chooser, GraspPlan, choose, first_plan
from ..expert.planning.drop import Drop, breadth, hanging, let_go_at, lift_of, lost
from ..expert.planning.grasps import TIP, Grasp
from ..expert.planning.placement import Placer, middle_place, plan_place
from ..goals.goal import Goal, Pushed, Raised
from ..rendering.config import HintKind
from ..world.world import World

HINT_BOUNDS = np.array([3.0] * 3 + [7.0] + [0.1] * 2 + [3.0] + [1.0])
"""Largest magnitude of each entry."""

HINT_BOUNDS.setflags(write=False)

_MOVED, _TILTED, _STILL = 0.015, 0.97, 0.05  # metres, cosine, metres per second
_HIGHER = 0.3  # maximum of entry 6, metres
_OFF = 0.01  # height above its support at which a dropped object counts as lost, metres
_HIGH = 0.035  # height above its support at which its place is planned, metres


def _detectors() -> tuple[Chooser, Placer]:
    from ..detection.detector import read_detector

    return read_detector(), middle_place


_ANSWERS = {"planned": lambda: (choose, plan_place), "detected": _detectors}


def misread(
    entries: Float[np.ndarray, "8"],
    target: Float[np.ndarray, "3"],
    tool: Float[np.ndarray, "3"],
    yaw: float,
) -> Float[np.ndarray, "8"]:
    """Return hint entries with the sensor errors ``target`` (m), ``tool`` (m) and ``yaw`` added.

    These are errors of the two positions, base frame, and of the hand's yaw, radians.
    """
    if not entries[-1]:
        return entries
    read = entries.copy()
    if entries[-1] > 0:
        read[:3] += target - tool
    else:  # The place of release turns with the object in the hand.
        read[:3] -= rotation_z(float(entries[3])) @ (target - tool) + tool
    read[3] -= yaw
    read[6] = max(read[6] - tool[2], 0.0)
    return read


class GraspHint:
    """The planned grasp of the active target and, once the target is held, the place to release it.

    The grasp moves with the object. The grasp is planned again when the object has come to rest
    elsewhere, untouched by the robot, or has been lost. ``planned`` is the grasp as it was planned,
    ``drop`` is the current place, if any, ``choose`` plans grasps, and the optional ``place`` plans
    places.
    """

    def __init__(self, kind: HintKind = "planned", place: Placer | None = None) -> None:
        self.kind: HintKind = kind
        self.choose, self._place = _ANSWERS[kind]()
        self._given = place
        self._place = place or self._place
        self.planned: GraspPlan | None = None
        self.drop: Drop | None = None
        self._target: str | None = None
        self._lost: tuple[GraspPlan, ...] = ()
        self._raised = False
        # Pose of the target at the last call of ``_take``, and the height of its grasp.
        self._rotation: Float[np.ndarray, "3 3"] = np.eye(3)
        self._seen: Float[np.ndarray, "3"] = np.zeros(3)
        self._low = 0.0

    def __reduce__(self) -> tuple[type[GraspHint], tuple[HintKind, Placer | None]]:
        """Support copying and pickling; the copy is a hint of the same kind, without an episode."""
        return GraspHint, (self.kind, self._given)

    def begin(self, world: World, goal: Goal) -> None:
        """Plan a grasp for a newly active goal."""
        self._target, self.planned, self.drop, self._lost = goal.target, None, None, ()
        if goal.target is not None:
            self._take(world, goal.target)

    def plan(self, world: World, name: str) -> GraspPlan | None:
        """Return the grasp of an object at its current pose, or None if it is not the target."""
        if self.planned is None or self._target != name:
            return None
        return self._carry(world, name, self.planned)

    def entries(self, world: World, goal: Goal) -> Float[np.ndarray, "8"]:
        """Return the hint's current entries, after planning again if necessary."""
        name = self._target
        if name is None:
            return np.zeros(8)
        left, right, any_part = world.touches(name)
        if self._raised and lost(world, goal):
            self._take(world, name, blamed=True)
        elif not self._raised and not any_part and self._is_elsewhere(world, name):
            self._take(world, name)
        plan = self.plan(world, name)
        if plan is None:
            return np.zeros(8)
        grasp, held = plan.grasp, left and right and not isinstance(goal, Pushed)
        if held and self.drop is None:
            risen = float(world.position(name)[2] - self._seen[2])
            self._raised = self._raised or risen > _OFF
            if risen > _HIGH and not isinstance(goal, Raised):
                yaw = rotation_yaw(world.hand)
                self.drop = Drop(world, goal, yaw, let_go_at(grasp), self._place)
        if self.drop is None:
            end, opening, depth, broad = grasp.point, grasp.opening, TIP, 0.0
            turn = turn_left(world, plan.yaw, grasp.point)
            if held:
                tool = world.data.site_xpos[world.tcp]
                end, opening = np.array([*tool[:2], self._low + lift_of(goal)]), let_go_at(grasp)
        else:
            self.drop.follow(world)
            end, opening, turn = self.drop.tool, self.drop.opening, self.drop.turn(world)
            depth, broad = hanging(world, name), breadth(world, name)
        rise = _rise(world, name, end, depth, broad)
        left = world.base_rotation.T @ (end - world.data.site_xpos[world.tcp])
        kind = -1.0 if held or self.drop else 1.0
        return np.array([*left, turn, opening, grasp.width, rise, kind])

    def _take(self, world: World, name: str, blamed: bool = False) -> None:
        """Plan a grasp; grasps that lost the object rank last.

        If ``blamed``, the current grasp is one of them.
        """
        lost = (*self._lost, self.planned) if blamed and self.planned else self._lost
        self._lost = tuple(self._carry(world, name, plan) for plan in lost)
        if world.data.time > 0:
            failed = tuple(plan.grasp for plan in self._lost)
            self.planned = self.choose(world, name, failed)
        else:
            self.planned = first_plan(world, name, self.choose)
        self.drop, self._raised = None, False
        self._rotation, self._seen = world.rotation(name), world.position(name)
        self._low = 0.0 if self.planned is None else float(self.planned.grasp.point[2])

    def _carry(self, world: World, name: str, plan: GraspPlan) -> GraspPlan:
        """Return a grasp that has moved with the object since the last call of ``_take``."""
        turned = world.rotation(name) @ self._rotation.T
        at, turn, old = world.position(name), rotation_yaw(turned), plan.grasp
        point = at + turned @ (old.point - plan.seen)
        grasp = Grasp(point, old.angle + turn, old.opening, old.width, old.score)
        return GraspPlan(grasp, wrap(plan.yaw + turn), at)

    def _is_elsewhere(self, world: World, name: str) -> bool:
        """Return whether the object has settled elsewhere or at a new tilt since the last plan."""
        speed = world.velocity(name)[:3]
        if float(speed @ speed) > _STILL**2:
            return False
        moved = world.position(name) - self._seen
        tilt = (world.rotation(name) @ self._rotation.T)[2, 2]
        return bool(moved @ moved > _MOVED**2 or tilt < _TILTED)


def grasp_hint_of(asked: bool | HintKind) -> GraspHint | None:
    """Return the hint for a setting, or None if the setting requests no hint.

    Raises:
        InputError: the setting is unknown.
        StorageError: the detector's weights cannot be read.
    """
    if isinstance(asked, bool | np.bool_):
        return GraspHint() if asked else None
    if not isinstance(asked, str) or asked not in _ANSWERS:
        raise InputError(
            f"grasp_hint must be True, False, 'planned' or 'detected', got {asked!r}."
            + choices(str(asked), _ANSWERS)
        )
    return GraspHint(asked)


def _rise(
    world: World, name: str, end: Float[np.ndarray, "3"], depth: float, broad: float
) -> float:
    """Return hint entry 6 for a move to ``end`` with a load ``depth`` deep and ``broad`` wide."""
    tool = world.data.site_xpos[world.tcp]
    if math.hypot(*(end - tool)[:2]) <= NEAR:
        return 0.0
    high = clear_height(world, name, tool, end, max(ROOM, broad)) + depth
    return min(max(high - float(tool[2]), 0.0), _HIGHER)
