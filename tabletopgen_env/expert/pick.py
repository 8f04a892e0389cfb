"""Picking up and putting down objects, planned from the current state.

Each phase ends when its aim is achieved:

=========  =====================================================================================
wait       open the hand and rise until the object is at rest
approach   rise above obstacles, move above the grasp, turn the hand
descend    straight down, with the fingers opened as far as the space allows
close      until the fingers stop
lift       straight up; if the object stays behind, plan another grasp
hold       stay up, if the goal requires nothing else
carry      above obstacles to the goal, and turn
lower      until the object stands, or hangs as deep in the container as the fingers allow
release    open
retreat    straight up, then stay
unwind     rise and turn the hand back until the elbow leaves a dead end, then try again
stuck      stand still: no grasp can reach the object at its current pose
=========  =====================================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ..goals.goal import Goal, Raised
from ..robot import franka
from .arm import elbow_swing, is_wound, turn_left, turn_to_middle, up
from .driver import NEAR, Expert
from .planning.choice import HOVER, GraspPlan, choose
from .planning.drop import ABOVE, Drop, hanging, let_go_at, lift_of, load, lost, met
from .planning.grasps import TIP, Grasp

Phase = Literal[
    "wait", "approach", "descend", "close", "lift", "hold", "carry", "lower", "release", "retreat",
    "unwind", "stuck",
]  # fmt: skip

_FINE, _TURNED = (0.0015, 0.005), 0.05
_CARRY = 0.7  # share of the hand's speed used with a held object, since round ones slip
_SHORT = 0.012  # fingers that stop this far above the grasp have failed, metres
# metres above the grasp at which the fingers close, and below it at which the hand aims
_DOWN = 0.004
_EMPTY = 0.004  # fingers this much closer than the expected width hold nothing, metres
_FUNNEL = 0.004  # horizontal error beyond the tolerance at which the hand stays at HOVER, metres
_CLOSING = 0.002  # excess of the real opening over the commanded one while closing, metres
_SLIP = 0.03
_MOVED = 0.015
_MOVING = 0.05  # metres per second
_TOLD = 0.004  # excess of the commanded opening over the real one while opening, metres
_FREE = 0.6  # share of the opening motion after which the fingers are free
_NARROWER = 0.1  # scale of the assumed hand width when a waypoint above obstacles is out of reach
_ON, _STALLED = 0.005, 8  # minimum progress while carrying, metres, and maximum steps without it
_FOLLOWED = 3  # failures of a hinted grasp before another one is tried
_RISE = 0.15  # height of the retreat, metres
# steps in a dead end before unwinding, and the elbow swing that ends it, radians
_WOUND, _UNWOUND = 24, 0.4
_MOVING_FREELY: tuple[Phase, ...] = ("approach", "descend", "carry")
_UNWINDS = 2  # maximum number of times that the arm unwinds per goal
_PATIENCE: dict[Phase, int] = {
    "wait": 20, "approach": 55, "descend": 30, "close": 14, "lift": 30, "hold": 1000, "carry": 80,
    "lower": 45, "release": 8, "retreat": 60, "unwind": 45, "stuck": 60,
}  # fmt: skip


class Picker(Expert):
    """An expert that picks up a goal's target and places it as required, or holds it up.

    ``phase`` is the current phase, ``attempts`` the number of started grasps.
    """

    def __init__(self, env: Any, goal: Goal, patience: float = 1.0) -> None:
        super().__init__(env, patience)
        assert goal.target is not None
        self._goal = goal
        self._target: str = goal.target
        self.phase: Phase = "approach"
        self.attempts = 0

    def reset(self) -> None:
        """Plan for the goal in the current state.

        Raises:
            SceneError: no grasp of the target is reachable.
        """
        self.attempts = self._unwinds = self._wound = 0
        self._failed: tuple[Grasp, ...] = ()
        self._followed: GraspPlan | None = None
        if not self._begin():
            raise SceneError(
                f"The expert finds no grasp of {self._target!r} in scene "
                f"{self._env.world.scene.name!r} that the arm can reach; choose another target."
            )

    @property
    def finished(self) -> bool:
        """Whether the hand is empty and out of the way."""
        risen = self.phase == "retreat" and self._tool[2] > self._placed[2] + _RISE / 2
        return risen or self.phase == "stuck"

    # ------------------------------------------------------------------------------------ acting

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        self._steps += 1
        late = self._steps > self._patience * _PATIENCE[self.phase]
        phases: dict[Phase, Callable[[bool], Float[np.ndarray, "5"]]] = {
            "wait": self._wait, "approach": self._approach, "descend": self._descend,
            "close": self._close, "lift": self._lift, "hold": self._hold, "carry": self._carry,
            "lower": self._lower, "release": self._release, "retreat": self._retreat,
            "unwind": self._unwind, "stuck": self._recover,
        }  # fmt: skip
        if self._is_in_dead_end():
            return self._enter("unwind")
        return phases[self.phase](late)

    def _wait(self, late: bool) -> Float[np.ndarray, "5"]:
        if late or (self._steps > 4 and not self._is_moving()):
            return self._retry(failed=False)
        return self._act(up(0.02), 0.0, 2 * franka.FINGER_STROKE)

    def _approach(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._is_moving():
            return self._enter("wait")
        if late or self._has_moved():
            return self._retry(failed=late)
        hover = self._hover()
        if hover == 0 and self._tool[2] < self._plan.grasp.point[2] + HOVER + NEAR:
            self._enter("descend")
            return self._descend(False)
        return self._come_down(hover)

    def _descend(self, late: bool) -> Float[np.ndarray, "5"]:
        grasp = self._plan.grasp
        if self._has_moved():
            return self._retry(failed=False)
        above = self._tool[2] - grasp.point[2]
        if late and above > _SHORT:
            return self._retry()
        if late or above < _DOWN:
            self._enter("close")
            return self._close(False)
        if above > _SHORT and np.linalg.norm((self._tool - grasp.point)[:2]) > NEAR:
            return self._enter("approach")
        return self._come_down(self._hover())

    def _hover(self) -> float:
        """Return the height above the grasp that the hand keeps until it is aligned."""
        grasp = self._plan.grasp
        spare = (grasp.opening - grasp.width) / 2
        fine = float(np.clip(spare - 0.002, *_FINE))
        aside = float(np.linalg.norm((self._tool - grasp.point)[:2])) - fine
        turn = abs(self._turn_left()) - _TURNED
        return HOVER * float(np.clip(max(aside / _FUNNEL, turn / _TURNED), 0.0, 1.0))

    def _come_down(self, hover: float) -> Float[np.ndarray, "5"]:
        grasp = self._plan.grasp
        over = self._over(grasp.point + up(hover or -_DOWN), TIP, self._target)
        aside = np.linalg.norm((self._tool - grasp.point)[:2])
        return self._go(over, grasp.opening, slow=0.7 if aside < NEAR else 1.0)

    def _close(self, late: bool) -> Float[np.ndarray, "5"]:
        gap, grasp = self._gap, self._plan.grasp
        commanded = self._commanded_gap < gap - _CLOSING  # otherwise a policy controls the hand
        left, right, _ = self._env.world.touches(self._target)
        still = abs(gap - self._last_gap) < 2e-4
        self._last_gap = gap
        if (commanded and ((left and right) or still)) or late:
            self._held = self._in_object()
            waiting = self._enter("lift")
            # The hint already shows the object as held, so waiting would contradict it.
            return waiting if self._env.hint is None else self._lift(False)
        if np.linalg.norm(self._tool - grasp.point) > NEAR:
            return self._enter("approach")
        if gap < grasp.width - _EMPTY and not (left or right):
            return self._retry()
        return self._go(grasp.point, 0.0)

    def _lift(self, late: bool) -> Float[np.ndarray, "5"]:
        raised = isinstance(self._goal, Raised)
        target = self._plan.grasp.point + up(lift_of(self._goal))
        if self._has_slipped():
            return self._retry()
        high = self._tool[2] > target[2] - NEAR or late
        if raised and high:
            return self._enter("hold")
        hint = self._env.hint
        drop = None if hint is None else hint.drop
        if drop is not None or (high and not raised and (hint is None or late)):
            self._plan_drop(drop)
            waiting = self._enter("carry")
            return waiting if hint is None else self._carry(False)
        return self._go(target, 0.0, slow=0.7)

    def _hold(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._has_slipped():
            return self._retry()
        return self._act(np.zeros(3), 0.0, 0.0)

    def _carry(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._has_slipped():
            return self._retry()
        world, drop = self._env.world, self._drop
        drop.follow(world)
        hover = drop.hover(world)
        above = self._tool[2] - drop.tool[2] - ABOVE
        if (hover == 0 and above < NEAR) or (late and above < 2 * NEAR):
            self._enter("lower")
            return self._lower(False)
        held = load(world, self._target, drop.turn(world))
        over = self._over(
            drop.tool + up(hover), hanging(world, self._target), self._target, held, self._narrow
        )
        if late or self._stalls(over):  # the arm may not reach that far at this height
            self._narrow *= _NARROWER
            self._steps = self._still = 0
        return self._go(over, 0.0, slow=_CARRY)

    def _lower(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._has_slipped():
            return self._retry()
        self._drop.follow(self._env.world)
        goal = self._drop.tool
        if late or self._tool[2] < goal[2] + _DOWN:
            self._enter("release")
            return self._release(False)
        if self._tool[2] > goal[2] + ABOVE + 2 * NEAR:
            return self._enter("carry")
        return self._go(goal + up(self._drop.hover(self._env.world) or -_DOWN), 0.0, slow=0.4)

    def _release(self, late: bool) -> Float[np.ndarray, "5"]:
        gap, opening = self._gap, self._drop.opening
        commanded = self._commanded_gap > gap + _TOLD  # otherwise a policy controls the hand
        width = self._plan.grasp.width
        if gap > width + _FREE * (opening - width) or (late and commanded):
            return self._enter("retreat")
        if self._tool[2] > self._drop.tool[2] + NEAR and self._steps > 2 and not commanded:
            return self._enter("carry")
        return self._act(np.zeros(3), 0.0, opening)

    def _retreat(self, late: bool) -> Float[np.ndarray, "5"]:
        undone = late and not self._goal.settled(self._env.world)
        if undone or lost(self._env.world, self._goal):
            return self._retry()
        rise = self._placed[2] + _RISE - self._tool[2]
        return self._act(np.array([0, 0, max(rise, 0.0)]), 0.0, let_go_at(self._plan.grasp))

    def _unwind(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._carries and self._has_slipped():
            return self._retry()
        if late or elbow_swing(self._env.world) < _UNWOUND:
            self._unwinds += 1
            if not self._carries:
                return self._retry()
            self._plan_drop()
            return self._enter("carry")
        opening = 0.0 if self._carries else self._plan.grasp.opening
        rise = self._placed + up(_RISE) - self._tool
        turn = turn_to_middle(self._env.world)
        return self._act(rise, turn, opening, _CARRY if self._carries else 1.0)

    def _recover(self, late: bool) -> Float[np.ndarray, "5"]:
        if late:
            return self._retry(failed=False)
        return self._act(np.zeros(3), 0.0, 2 * franka.FINGER_STROKE)

    # ---------------------------------------------------------------------------------- planning

    def _begin(self, failed: bool = False) -> bool:
        """Choose the best reachable grasp and approach it, or enter the phase "stuck"."""
        if failed:
            self._failed = (*self._failed, self._plan.grasp)
        self.attempts += 1
        plan, hint = None, self._env.hint
        if hint is not None:
            if hint.planned is not self._followed:
                self._followed, self._failed = hint.planned, ()
            if len(self._failed) < _FOLLOWED:
                plan = hint.plan(self._env.world, self._target)
        chooser = choose if hint is None else hint.choose
        plan = plan or chooser(self._env.world, self._target, self._failed)
        if plan is not None:
            self._plan = plan
            self._enter("approach")
            return True
        self.phase, self._steps = "stuck", 0
        return False

    def _retry(self, failed: bool = True) -> Float[np.ndarray, "5"]:
        """Plan a new grasp and open the hand; if ``failed``, the old grasp counts as failed."""
        if self._goal.released and met(self._env.world, self._goal):  # a policy controls the hand
            return self._enter("retreat")
        self._begin(failed)
        return self._act(np.zeros(3), 0.0, 2 * franka.FINGER_STROKE)

    def _plan_drop(self, drop: Drop | None = None) -> None:
        """Set the release path to ``drop`` or, by default, to the best one for the hand's pose."""
        opening = let_go_at(self._plan.grasp)
        self._drop = drop or Drop(self._env.world, self._goal, self._yaw, opening)
        self._narrow, self._left, self._still = 1.0, np.inf, 0

    # ----------------------------------------------------------------------------------- sensing

    @property
    def _object(self) -> Float[np.ndarray, "3"]:
        return self._env.world.position(self._target)

    def _turn_left(self) -> float:
        """Return the remaining turn of the hand, in radians."""
        if self.phase in ("carry", "lower"):
            return self._drop.turn(self._env.world)
        return turn_left(self._env.world, self._plan.yaw, self._plan.grasp.point)

    def _has_moved(self) -> bool:
        return bool(np.linalg.norm(self._object - self._plan.seen) > _MOVED)

    def _is_moving(self) -> bool:
        return bool(np.linalg.norm(self._env.world.velocity(self._target)[:3]) > _MOVING)

    def _in_object(self) -> Float[np.ndarray, "3"]:
        """Return the tool's position in the object's frame, in metres."""
        return (self._tool - self._object) @ self._env.world.rotation(self._target)

    def _stalls(self, over: Float[np.ndarray, "3"]) -> bool:
        """Return whether a hand moving to ``over`` no longer approaches the release position."""
        left = float(np.linalg.norm((self._drop.tool - self._tool)[:2]))
        if left < self._left - _ON:
            self._left, self._still = left, 0
        elif left > NEAR and np.linalg.norm((over - self._tool)[:2]) > _ON:
            self._still += 1
        return self._still > _STALLED

    def _is_in_dead_end(self) -> bool:
        """Return whether the arm has to unwind; must be called once per step.

        With hints it is always False, since hints do not support unwinding.
        """
        free = self.phase in _MOVING_FREELY and self._env.hint is None
        self._wound = self._wound + 1 if free and is_wound(self._env.world) else 0
        return self._wound > _WOUND and self._unwinds < _UNWINDS

    def _has_slipped(self) -> bool:
        """Return whether the object has moved in the fingers since they closed."""
        return bool(np.linalg.norm(self._in_object() - self._held) > _SLIP)

    # ------------------------------------------------------------------------------------ moving

    def _enter(self, phase: Phase) -> Float[np.ndarray, "5"]:
        """Change to ``phase``; return an action that does not move the hand."""
        self._carries = phase == "unwind" and self.phase == "carry"
        self.phase, self._steps = phase, 0
        self._last_gap, self._placed = self._gap, self._tool
        closed = self._carries or phase in ("close", "lift", "hold", "carry", "lower")
        return self._act(np.zeros(3), 0.0, 0.0 if closed else self._plan.grasp.opening)

    def _go(
        self, point: Float[np.ndarray, "3"], opening: float, slow: float = 1.0
    ) -> Float[np.ndarray, "5"]:
        return self._act(point - self._tool, self._turn_left(), opening, slow)
