"""Pushing along the table: behind the object, down, forward in a straight stroke, and again.

=========  =====================================================================================
approach   rise over what is in the way, go behind the object, turn the hand across the way
descend    straight down beside it
stroke     forward, steering the object towards the goal
retreat    back a little, up, and stay; begin again if the object is not there yet
=========  =====================================================================================
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from generator.errors import SceneError
from generator.geometry import wrap

from ..robot.kinematics import LOWER, UPPER, solve_ik
from ..tasks.goals import Pushed
from .driver import Expert, up
from .grasps import TIP

Phase = Literal["approach", "descend", "stroke", "back", "retreat"]

_BEHIND = 0.035  # metres between the fingers and the object before a stroke
_THICK = 0.012  # half the fingers' thickness along the stroke, metres
_HOVER = 0.06
_THERE = 0.012  # metres from the goal's middle at which a stroke ends
_ASTRAY = 0.5  # radians off the way at which a stroke is begun anew
_PATIENCE: dict[Phase, int] = {
    "approach": 70, "descend": 30, "stroke": 70, "back": 8, "retreat": 1000
}  # fmt: skip


class Pusher(Expert):
    """Slides the target of a goal to its spot with closed fingers.

    ``phase`` says what it is doing, ``attempts`` how many strokes it has begun.
    """

    def __init__(self, env: Any, goal: Pushed) -> None:
        super().__init__(env)
        self._goal = goal
        self.phase: Phase = "approach"
        self.attempts = 0

    @property
    def finished(self) -> bool:
        """Whether the hand is out of the way."""
        return self.phase == "retreat"

    def reset(self) -> None:
        """Plan the first stroke.

        Raises:
            SceneError: the arm cannot reach behind the object.
        """
        self.attempts = 0
        self._begin()
        world = self._env.world
        c, s = np.cos(self._yaw), np.sin(self._yaw)
        down = np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]])
        found = solve_ik(world.to_base(self._start()), down)
        if not found.solved or np.minimum(found.joints - LOWER, UPPER - found.joints).min() < 0.0:
            raise SceneError(
                f"The expert cannot reach behind {self._goal.target!r} in scene "
                f"{world.scene.name!r}; choose another target or goal."
            )

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        self._steps += 1
        late = self._steps > _PATIENCE[self.phase]
        phases = {
            "approach": self._approach,
            "descend": self._descend,
            "stroke": self._stroke,
            "back": self._back,
            "retreat": self._retreat,
        }
        return phases[self.phase](late)

    def _approach(self, late: bool) -> Float[np.ndarray, "5"]:
        above = self._start() + up(_HOVER)
        near = np.linalg.norm((self._tool - above)[:2]) < 0.006
        turned = abs(self._turn_to(self._yaw)) < 0.06
        if late or (near and turned and self._tool[2] < above[2] + 0.02):
            return self._enter("descend")
        return self._to(self._over(above, TIP, self._goal.target))

    def _descend(self, late: bool) -> Float[np.ndarray, "5"]:
        low = self._start()
        if late or self._tool[2] < low[2] + 0.004:
            return self._enter("stroke")
        return self._to(low, slow=0.7)

    def _stroke(self, late: bool) -> Float[np.ndarray, "5"]:
        way = self._way
        left = float(np.linalg.norm(way))
        ahead = way / max(left, 1e-9)
        to_object = (self._object - self._tool)[:2]
        off = np.arccos(np.clip(ahead @ to_object / max(np.linalg.norm(to_object), 1e-9), -1, 1))
        if left < _THERE or ahead @ self._ahead < 0.2:
            return self._enter("back")
        if late or off > _ASTRAY:
            return self._enter("back")
        # What is pushed turns away from the line: the hand keeps to its far side.
        side = to_object - ahead * (ahead @ to_object)
        speed = 0.02 if left > 0.06 else 0.01
        move = np.array([*(speed * ahead + 0.6 * side), 0.0])
        move[2] = self._height() - self._tool[2]
        return self._act(move / 0.3, self._turn_to(self._yaw), 0.0, slow=0.6)

    def _back(self, late: bool) -> Float[np.ndarray, "5"]:
        if late:
            return self._enter("retreat")
        return self._act(np.array([*(-0.05 * self._ahead), 0.0]), 0.0, 0.0)

    def _retreat(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._steps > 6 and np.linalg.norm(self._way) > 0.03:
            self._begin()
        return self._act(up(max(self._height() + 0.15 - self._tool[2], 0.0)), 0.0, 0.0)

    # ---------------------------------------------------------------------------------- planning

    def _begin(self) -> None:
        """Choose the next stroke."""
        self.attempts += 1
        self._ahead = self._way / max(float(np.linalg.norm(self._way)), 1e-9)
        bearing = float(np.arctan2(self._ahead[1], self._ahead[0])) - self._env.world.mount.yaw
        turns = [wrap(bearing + k * np.pi) for k in (0, 1)]  # the fingers side by side
        self._yaw = min(turns, key=lambda yaw: abs(self._turn_to(yaw)))
        self._enter("approach")

    def _start(self) -> Float[np.ndarray, "3"]:
        """Return where the tool begins a stroke: behind the object, world frame."""
        world = self._env.world
        outline = world.scene.object(self._goal.target)
        corners = np.concatenate([part.vertices for part in outline.parts])
        flat = (corners @ world.rotation(self._goal.target).T)[:, :2]
        behind = float((flat @ self._ahead).min()) - _BEHIND - _THICK
        xy = self._object[:2] + behind * self._ahead
        return np.array([*xy, self._height()])

    def _height(self) -> float:
        """Return the tool's height in a stroke: low, but off the table."""
        world = self._env.world
        top = world.scene.table.height
        tall = 2 * (self._object[2] - world.lowest(self._goal.target))
        return top + float(np.clip(0.4 * tall, 0.014, 0.04))

    @property
    def _object(self) -> Float[np.ndarray, "3"]:
        return self._env.world.position(self._goal.target)

    @property
    def _way(self) -> Float[np.ndarray, "2"]:
        return (self._goal.spot - self._object)[:2]

    def _to(self, point: Float[np.ndarray, "3"], slow: float = 1.0) -> Float[np.ndarray, "5"]:
        return self._act(point - self._tool, self._turn_to(self._yaw), 0.0, slow)

    def _enter(self, phase: Phase) -> Float[np.ndarray, "5"]:
        """Change to ``phase`` and stand still for this step."""
        self.phase, self._steps = phase, 0
        return self._act(np.zeros(3), 0.0, 0.0)
