"""Pushing along the table: moving behind the object, descending, and moving straight forward.

=========  =====================================================================================
approach   rise above obstacles, move behind the object, turn the hand as planned
descend    straight down beside it
stroke     forward to the goal, staying behind the object's centre of mass
back       up and away from the object; start again if it is not at the goal yet
retreat    up, then stay
stuck      stand still: no stroke is possible from the object's position
=========  =====================================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ..goals.goal import Pushed
from .arm import turn_left, up
from .driver import Expert
from .path import clear_height
from .planning.grasps import TIP
from .planning.strokes import HOVER, PAD, Care, beside, mass_center, plan_stroke

Phase = Literal["approach", "descend", "stroke", "back", "retreat", "stuck"]

_THERE = 0.008  # a stroke ends this far before the goal's centre, along the way, metres
_ENOUGH = 0.03  # no new stroke is started within this distance of the goal's centre, metres
_ASIDE = 0.03  # a stroke is restarted this far off the way, metres
_FURTHER = 0.07  # maximum excess of a stroke's length over the way, metres
_PAST = 0.06  # the object is lost once the hand has come this much closer to it, metres
_FAST, _STEADY, _SLOW = 0.02, 0.012, 0.008  # metres per step: flat objects, tall ones, near the end
# an object counts as tall if the tool is this high above the table in a stroke, metres
_TALL = 0.04
_ASLANT = 0.75  # cosine of the largest change of direction before a stroke is restarted
# a stroke no longer turns within this distance of the goal's centre, metres
_STRAIGHT = 0.03
_LAG = 2.0  # lag of the tool behind its command, steps
_STEER = 2.0  # turn of the hand's direction per angle at which it sees the centre of mass
_SMALL = 0.008  # minimum distance from the fingers to a centre of mass, metres
_BLOCKED = 0.012  # height above a stroke's start at which the hand stands on something, metres
_ASIDES = 0.025 * np.column_stack(
    [np.cos(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4)]
)
_LEAST = 0.025  # length of the shortest stroke, metres
_LESS_ROOM: tuple[Care, ...] = ("tight", "bold")
_PATIENCE: dict[Phase, int] = {
    "approach": 60, "descend": 22, "stroke": 50, "back": 4, "retreat": 1000, "stuck": 30
}  # fmt: skip


class Pusher(Expert):
    """An expert that slides a goal's target to its spot with closed fingers.

    ``phase`` is the current phase, ``attempts`` the number of started strokes.
    """

    def __init__(self, env: Any, goal: Pushed, patience: float = 1.0) -> None:
        super().__init__(env, patience)
        self._goal = goal
        self.phase: Phase = "approach"
        self.attempts = 0

    @property
    def finished(self) -> bool:
        """Whether the hand is out of the way."""
        return self.phase in ("retreat", "stuck")

    def reset(self) -> None:
        """Plan the first stroke.

        Raises:
            SceneError: the arm cannot reach behind the object, or its path is not free.
        """
        self.attempts = 0
        self._barred: set[int] = set()
        self._before, self._speed = self._tool, np.zeros(3)
        self._begin()
        if self.phase == "stuck":
            raise SceneError(
                f"The expert finds no way to push {self._goal.target!r} in scene "
                f"{self._env.world.scene.name!r}; choose another target or goal."
            )

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        self._steps += 1
        self._speed = self._tool - self._before
        self._before = self._tool
        late = self._steps > self._patience * _PATIENCE[self.phase]
        phases: dict[Phase, Callable[[bool], Float[np.ndarray, "5"]]] = {
            "approach": self._approach, "descend": self._descend, "stroke": self._stroke,
            "back": self._back, "retreat": self._retreat, "stuck": self._recover,
        }  # fmt: skip
        return phases[self.phase](late)

    def _approach(self, late: bool) -> Float[np.ndarray, "5"]:
        above = self._plan.start + up(HOVER)
        near = np.linalg.norm((self._tool - above)[:2]) < 0.008
        turned = abs(turn_left(self._env.world, self._plan.yaw, above)) < 0.08
        if near and turned and self._tool[2] < above[2] + 0.03:
            return self._enter("descend")
        if late:
            return self._bar()
        if not turned:  # the palm sweeps over surrounding objects
            clear = clear_height(self._env.world, None, above, above)
            above[2] = max(above[2], clear + TIP)
        return self._to(self._over(above, TIP, None))

    def _descend(self, late: bool) -> Float[np.ndarray, "5"]:
        low = self._plan.start
        if late and self._tool[2] > low[2] + _BLOCKED:
            return self._bar()
        if late or self._tool[2] < low[2] + 0.007:
            return self._enter("stroke")
        return self._to(low - self._speed, slow=0.7)  # the tool lags behind its command

    def _stroke(self, late: bool) -> Float[np.ndarray, "5"]:
        world, name, stroke = self._env.world, self._goal.target, self._plan
        way = self._way
        left = float(np.linalg.norm(way))
        if left > _STRAIGHT or self._steps == 1:
            self._ahead = way / max(left, 1e-9)
        ahead = self._ahead
        slid = world.velocity(name)[:2] * self._env.controller.servos.period
        to_mass = (mass_center(world, name) - self._tool)[:2]
        side, soon = (
            v - stroke.ahead * (stroke.ahead @ v)
            for v in (to_mass, to_mass + _LAG * (slid - self._speed[:2]))
        )
        off = float(np.linalg.norm(side))
        gone = float((self._tool - stroke.start)[:2] @ stroke.ahead)
        there = ahead @ (way - slid) < _THERE
        passed = stroke.ahead @ to_mass < self._behind - _PAST
        astray = passed or off > _ASIDE or ahead @ stroke.ahead < _ASLANT
        if late or there or astray or gone > self._length:
            return self._enter("back")
        # An object touched at one point turns away from the hand's direction, the more the closer
        # its centre of mass is: the hand turns beyond that centre. An object touched at a flat side
        # keeps its position relative to the hand, so the line of the stroke counts, not the
        # remaining way.
        high = stroke.start[2] - world.scene.table.height > _TALL  # it might topple
        speed = float(np.clip(0.25 * left, _SLOW, _STEADY if high else _FAST))
        speed *= float(np.clip(1.3 - off / 0.02, 0.3, 1.0))
        behind = max(float(ahead @ to_mass) - PAD, _SMALL)
        steer = _STEER * speed * soon / behind
        steer *= min(1.0, speed / max(float(np.linalg.norm(steer)), 1e-9))
        rise = stroke.start[2] - self._tool[2] - _LAG * self._speed[2]
        move = np.array([*(speed * ahead + steer), 0.5 * rise])
        return self._act(move / 0.3, turn_left(world, stroke.yaw, self._tool), 0.0, slow=0.6)

    def _back(self, late: bool) -> Float[np.ndarray, "5"]:
        if not late:
            return self._act(np.array([*(-0.03 * self._plan.ahead), 0.06]), 0.0, 0.0)
        if self._is_there():
            return self._enter("retreat")
        return self._begin()

    def _retreat(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._steps > 10 and not self._is_there():
            return self._begin()
        rise = self._plan.start[2] + 0.15 - self._tool[2]
        return self._act(up(max(rise, 0.0)), 0.0, 0.0)

    def _recover(self, late: bool) -> Float[np.ndarray, "5"]:
        return self._begin() if late else self._act(np.zeros(3), 0.0, 0.0)

    # ---------------------------------------------------------------------------------- planning

    def _begin(self) -> Float[np.ndarray, "5"]:
        """Plan the next stroke to the spot or near it, with less clearance if necessary."""
        world, name, spot = self._env.world, self._goal.target, self._goal.spot[:2]
        spots = (spot, *(spot + _ASIDES))
        aims: list[tuple[Float[np.ndarray, "2"], Care]] = [(spot, "free")]
        aims.extend((at, care) for care in _LESS_ROOM for at in spots)
        self.attempts += 1
        others = beside(world, name)
        for self._choice, (self._aim, care) in enumerate(aims):
            length = float(np.linalg.norm(self._way))
            if self._choice in self._barred or (care != "free" and length < _LEAST):
                continue
            found = plan_stroke(world, name, self._aim, others, care)
            if found is not None:
                self._plan, self._length = found, length + _FURTHER
                self._behind = found.ahead @ (mass_center(world, name) - found.start)[:2]
                return self._enter("approach")
        return self._enter("stuck")

    def _bar(self) -> Float[np.ndarray, "5"]:
        """Abandon this stroke because an obstacle blocks the hand, and choose another."""
        self._barred.add(self._choice)
        return self._begin()

    def _is_there(self) -> bool:
        away = self._goal.spot - self._env.world.position(self._goal.target)
        return bool(np.linalg.norm(away[:2]) < _ENOUGH)

    @property
    def _way(self) -> Float[np.ndarray, "2"]:
        return self._aim - self._env.world.position(self._goal.target)[:2]

    def _to(self, point: Float[np.ndarray, "3"], slow: float = 1.0) -> Float[np.ndarray, "5"]:
        turn = turn_left(self._env.world, self._plan.yaw, self._plan.start)
        return self._act(point - self._tool, turn, 0.0, slow)

    def _enter(self, phase: Phase) -> Float[np.ndarray, "5"]:
        """Change to ``phase``; return an action that does not move the hand."""
        self.phase, self._steps = phase, 0
        return self._act(np.zeros(3), 0.0, 0.0)
