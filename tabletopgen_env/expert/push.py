"""Pushing along the table: behind the object, down, forward in a straight stroke, and again.

=========  =====================================================================================
approach   rise over what is in the way, go behind the object, turn the hand as planned
descend    straight down beside it
stroke     forward, steering the object's centre of mass towards the goal
back       up and away from the object; begin again if it is not there yet
retreat    up, and stay
stuck      stand still: no stroke can be made from where the object is
=========  =====================================================================================
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ..tasks.goals import Pushed
from .driver import Expert, up
from .grasps import TIP
from .strokes import HOVER, mass_center, plan_stroke

Phase = Literal["approach", "descend", "stroke", "back", "retreat", "stuck"]

_THERE = 0.012  # metres from the goal's middle at which a stroke ends
_ENOUGH = 0.03  # metres from the goal's middle at which no other stroke is begun
_ASIDE = 0.03  # metres off the way at which a stroke is begun anew
_FURTHER = 0.07  # metres by which a stroke may be longer than the way
_FAST, _STEADY, _SLOW = 0.02, 0.012, 0.008  # metres a step: flat things, tall ones, at the end
_TALL = 0.04  # metres from the tool in a stroke down to the table
_NEAR = 0.025 * np.column_stack(
    [np.cos(np.arange(8) * np.pi / 4), np.sin(np.arange(8) * np.pi / 4)]
)
_PATIENCE: dict[Phase, int] = {
    "approach": 60, "descend": 20, "stroke": 50, "back": 5, "retreat": 1000, "stuck": 30
}  # fmt: skip


class Pusher(Expert):
    """Slides the target of a goal to its spot with closed fingers.

    ``phase`` says what it is doing, ``attempts`` how many strokes it has begun.
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
            SceneError: the arm cannot reach behind the object, or its way is not free.
        """
        self.attempts = 0
        self._begin()
        if self.phase == "stuck":
            raise SceneError(
                f"The expert finds no way to push {self._goal.target!r} in scene "
                f"{self._env.world.scene.name!r}; choose another target or goal."
            )

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        self._steps += 1
        late = self._steps > self._patience * _PATIENCE[self.phase]
        phases = {
            "approach": self._approach,
            "descend": self._descend,
            "stroke": self._push,
            "back": self._back,
            "retreat": self._retreat,
            "stuck": self._stuck,
        }
        return phases[self.phase](late)

    def _approach(self, late: bool) -> Float[np.ndarray, "5"]:
        above = self._stroke.start + up(HOVER)
        near = np.linalg.norm((self._tool - above)[:2]) < 0.008
        turned = abs(self._turn_to(self._stroke.yaw, above)) < 0.08
        if late or (near and turned and self._tool[2] < above[2] + 0.03):
            return self._enter("descend")
        return self._to(self._over(above, TIP, None))

    def _descend(self, late: bool) -> Float[np.ndarray, "5"]:
        low = self._stroke.start
        if late or self._tool[2] < low[2] + 0.004:
            return self._enter("stroke")
        return self._to(low, slow=0.7)

    def _push(self, late: bool) -> Float[np.ndarray, "5"]:
        way = self._way
        left = float(np.linalg.norm(way))
        ahead = way / max(left, 1e-9)
        to_mass = (mass_center(self._env.world, self._goal.target) - self._tool)[:2]
        side = to_mass - ahead * (ahead @ to_mass)
        gone = float((self._tool - self._stroke.start)[:2] @ self._stroke.ahead)
        astray = np.linalg.norm(side) > _ASIDE or gone > self._length
        if late or left < _THERE or ahead @ self._stroke.ahead < 0.3 or astray:
            return self._enter("back")
        # What is pushed turns away from the line: the hand keeps to its far side.
        speed = float(np.clip(0.25 * left, _SLOW, self._fast))
        speed *= float(np.clip(1.3 - np.linalg.norm(side) / 0.02, 0.3, 1.0))
        rise = self._stroke.start[2] - self._tool[2]
        move = np.array([*(speed * ahead + 0.8 * side), 0.3 * rise])
        return self._act(move / 0.3, self._turn_to(self._stroke.yaw, self._tool), 0.0, slow=0.6)

    def _back(self, late: bool) -> Float[np.ndarray, "5"]:
        if not late:
            return self._act(np.array([*(-0.03 * self._stroke.ahead), 0.06]), 0.0, 0.0)
        if self._is_there():
            return self._enter("retreat")
        return self._begin()

    def _retreat(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._steps > 10 and not self._is_there():
            return self._begin()
        rise = self._stroke.start[2] + 0.15 - self._tool[2]
        return self._act(up(max(rise, 0.0)), 0.0, 0.0)

    def _stuck(self, late: bool) -> Float[np.ndarray, "5"]:
        return self._begin() if late else self._act(np.zeros(3), 0.0, 0.0)

    # ---------------------------------------------------------------------------------- planning

    def _begin(self) -> Float[np.ndarray, "5"]:
        """Choose the next stroke, a bold one or to beside the spot if there is no other."""
        world, name, spot = self._env.world, self._goal.target, self._goal.spot[:2]
        aims = [(spot, False)]
        if self.attempts > 0:
            aims += [(spot, True), *((spot + near, True) for near in _NEAR)]
        found = None
        for self._aim, bold in aims:
            found = plan_stroke(world, name, self._aim, bold=bold)
            if found is not None:
                break
        self.attempts += 1
        if found is None:
            return self._enter("stuck")
        self._stroke = found
        self._length = float(np.linalg.norm(self._way)) + _FURTHER
        return self._enter("approach")

    def _is_there(self) -> bool:
        away = self._goal.spot - self._env.world.position(self._goal.target)
        return bool(np.linalg.norm(away[:2]) < _ENOUGH)

    @property
    def _fast(self) -> float:
        """The pace, metres a step: what is pushed high up might topple."""
        high = self._stroke.start[2] - self._env.world.scene.table.height
        return _STEADY if high > _TALL else _FAST

    @property
    def _way(self) -> Float[np.ndarray, "2"]:
        return self._aim - self._env.world.position(self._goal.target)[:2]

    def _to(self, point: Float[np.ndarray, "3"], slow: float = 1.0) -> Float[np.ndarray, "5"]:
        turn = self._turn_to(self._stroke.yaw, self._stroke.start)
        return self._act(point - self._tool, turn, 0.0, slow)

    def _enter(self, phase: Phase) -> Float[np.ndarray, "5"]:
        """Change to ``phase`` and stand still for this step."""
        self.phase, self._steps = phase, 0
        return self._act(np.zeros(3), 0.0, 0.0)
