"""The expert for any task: it solves one goal at a time with the expert for that kind of goal."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ..goals.goal import Goal, Pushed, Reached
from .driver import Expert
from .pick import Picker
from .push import Pusher
from .reach import Reacher


class TaskExpert(Expert):
    """An expert that solves every ``TabletopGen`` environment in the action mode "ee_delta".

    When its hand is free, it works on the goal that the environment marks as active. For
    ``patience`` see ``Expert``.
    """

    def reset(self) -> None:
        """Plan for the episode that has just started; see ``Expert.reset``."""
        self._turn_to_goal()
        self._now.reset()

    @property
    def phase(self) -> str:
        """The current phase."""
        return self._now.phase

    @property
    def attempts(self) -> int:
        """The number of grasps or strokes attempted for the current goal."""
        return self._now.attempts

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        if self._env.goal is not self._goal and self._now.finished:
            self._turn_to_goal()
            with suppress(SceneError):  # a goal that is out of reach now is tried again later
                self._now.reset()
        return self._now.act()

    def _turn_to_goal(self) -> None:
        self._goal: Goal = self._env.goal
        self._now = specialist(self._env, self._goal, self._patience)


def specialist(env: Any, goal: Goal, patience: float = 1.0) -> Picker | Pusher | Reacher:
    """Return an expert for the given kind of goal."""
    if isinstance(goal, Reached):
        return Reacher(env, goal, patience)
    if isinstance(goal, Pushed):
        return Pusher(env, goal, patience)
    return Picker(env, goal, patience)
