"""The base class of the scripted experts, with methods that sense the hand and move it.

The experts use the environment's normalised actions, computed by proportional control from the
tool's current pose, so that demonstrations depend only on what a learner can observe.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.errors import InputError
from generator.geometry import rotation_yaw

from ..actions import EE_STEP, EE_TURN, Servos
from ..robot import franka
from ..robot.panda import HOME_CTRL
from .arm import around
from .path import ROOM, clear_height
from .plant import Plant

NEAR = 0.02
"""Distance at which a waypoint counts as reached, in metres."""

_GAIN, _TURN_GAIN = 0.3, 0.4


class Expert(ABC):
    """An expert that solves one kind of goal in the action mode "ee_delta".

    Call ``reset()`` after resetting the environment, then ``act()`` before each step. ``phase`` is
    the current phase. ``patience`` scales the time limits of the phases; use a value above 1 if a
    policy acts and the expert only advises.

    Raises:
        InputError: the environment has an unsupported action mode, control rate or gripper.
    """

    phase: str = ""

    def __init__(self, env: Any, patience: float = 1.0) -> None:
        self._env: Plant = env.unwrapped
        self._patience = patience
        if self._env.action_mode != "ee_delta" or self._env.controller.servos != Servos():
            raise InputError(
                "The expert acts in 'ee_delta' at 20 Hz with a continuous gripper; create the "
                "environment with these settings."
            )

    @abstractmethod
    def reset(self) -> None:
        """Plan for the active goal.

        Raises:
            SceneError: the goal cannot be reached.
        """

    @abstractmethod
    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""

    @property
    def _tool(self) -> Float[np.ndarray, "3"]:
        world = self._env.world
        return world.data.site_xpos[world.tcp].copy()

    @property
    def _yaw(self) -> float:
        """The hand's yaw in the base frame, in radians."""
        return rotation_yaw(self._env.world.hand)

    @property
    def _gap(self) -> float:
        world = self._env.world
        return float(world.data.qpos[world.finger_qpos].sum())

    @property
    def _commanded_gap(self) -> float:
        """The commanded opening of the fingers, in metres."""
        world = self._env.world
        share = float(world.data.ctrl[world.actuators[7]]) / HOME_CTRL[7]
        return 2 * franka.FINGER_STROKE * share

    def _over(
        self,
        point: Float[np.ndarray, "3"],
        depth: float,
        but: str | None,
        load: tuple[Float[np.ndarray, "3"], float] | None = None,
        narrow: float = 1.0,
    ) -> Float[np.ndarray, "3"]:
        """Return the next waypoint towards ``point``, above all objects on the way except ``but``.

        ``depth`` is the extent below the tool, metres; ``load`` is the centre of the held object
        relative to the tool (m, world frame) and its horizontal extent. A value of ``narrow`` below
        1 scales down the assumed width of the hand and the load.
        """
        tool, world = self._tool, self._env.world
        if np.linalg.norm((point - tool)[:2]) < NEAR:
            return point
        aim = np.array([*around(world, tool, point), point[2]])
        ways = [(tool, aim)] if np.array_equal(aim, point) else [(tool, aim), (aim, point)]
        discs = [(np.zeros(3), ROOM), *([load] if load else [])]
        high = max(
            clear_height(world, but, start + away, end + away, narrow * broad)
            for start, end in ways
            for away, broad in discs
        )
        high = max(high + depth, float(point[2]))
        if tool[2] < high - 0.02:
            return np.array([*tool[:2], high + 0.02])
        return np.array([*aim[:2], high])

    def _act(
        self, move: Float[np.ndarray, "3"], turn: float, opening: float, slow: float = 1.0
    ) -> Float[np.ndarray, "5"]:
        """Return the action that moves (m, world frame), turns (rad) and opens (m) the hand."""
        step = self._env.world.base_rotation.T @ move * (_GAIN / EE_STEP)
        step /= max(1.0, float(np.abs(step).max()) / slow)
        spin = np.clip(turn * _TURN_GAIN / EE_TURN, -1.0, 1.0)
        wide = opening / franka.FINGER_STROKE - 1 if opening > 0 else -1.0
        return np.array([*step, spin, np.clip(wide, -1.0, 1.0)], np.float32)
