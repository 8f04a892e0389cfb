"""Shared code for the action modes: validation, control rate, gripper and servo commands."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, Protocol, get_args

import numpy as np
from gymnasium import spaces
from jaxtyping import Float
from numpy.typing import ArrayLike

from generator.errors import InputError, require_known

from ..robot.kinematics import LOWER, UPPER
from ..robot.panda import HOME_CTRL
from ..world.composition import TIMESTEP
from ..world.world import World

GripperMode = Literal["continuous", "binary"]

CONTROL_HZ = 20
"""Default number of actions per second."""

GRIPPER_CTRL = HOME_CTRL[-1]
"""The command that fully opens the gripper."""

SERVO_LEAD = 0.08
"""Time by which servo commands lead a moving reference, in seconds.

A servo with torque ``k (u - q) - d q'`` trails its command ``u`` by ``d / k`` = 0.1 s. A lead
slightly below ``d / k`` compensates most of the lag and keeps the servo well damped.
"""

_STEPS = round(1 / TIMESTEP)  # simulation steps per second

_NO_NUMBERS = "cmMSU"  # complex numbers, times, strings: NumPy would cast them to float


@dataclass(frozen=True)
class Servos:
    """Settings of the servo commands: their rate, and the meaning of an action's gripper entry."""

    hz: int = CONTROL_HZ
    gripper: GripperMode = "continuous"

    def __post_init__(self) -> None:
        whole = isinstance(self.hz, int | np.integer) and not isinstance(self.hz, bool)
        if not whole or self.hz < 1 or _STEPS % self.hz:
            rates = ", ".join(str(k) for k in range(1, _STEPS + 1) if _STEPS % k == 0)
            raise InputError(
                f"control_hz must divide the {_STEPS} simulation steps of a second, got "
                f"{self.hz!r}; use one of {rates}."
            )
        require_known(self.gripper, get_args(GripperMode), "Unknown gripper mode")

    @property
    def substeps(self) -> int:
        """The number of simulation steps per action."""
        return _STEPS // self.hz

    @property
    def period(self) -> float:
        """The duration of an action in seconds."""
        return 1 / self.hz

    @property
    def share(self) -> float:
        """The ratio of an action's duration to the duration at ``CONTROL_HZ``."""
        return CONTROL_HZ / self.hz

    @property
    def slack(self) -> float:
        """The maximum lead of a command over the robot, relative to the lead at ``CONTROL_HZ``."""
        return max(1.0, self.share)

    def command(
        self,
        world: World,
        before: Float[np.ndarray, "7"],
        joints: Float[np.ndarray, "7"],
        gripper: float,
    ) -> None:
        """Write the servo commands that move the joints from ``before`` to ``joints``.

        ``gripper`` is the last entry of the action.
        """
        lead = SERVO_LEAD / self.period * (joints - before)
        world.state.servos[:] = np.minimum(np.maximum(joints + lead, LOWER), UPPER)
        if self.gripper == "binary":
            gripper = 1.0 if gripper >= 0 else -1.0
        world.state.gripper[0] = GRIPPER_CTRL * (gripper + 1) / 2


class Controller(Protocol):
    """A controller that converts actions to servo commands."""

    space: spaces.Box
    servos: Servos

    def reset(self, world: World) -> None:
        """Start from the robot's current pose."""
        ...

    def apply(self, world: World, action: Float[np.ndarray, "a"]) -> None:
        """Write the servo commands for a validated action to ``world.data.ctrl``."""
        ...


def check_action(action: ArrayLike, space: spaces.Box) -> Float[np.ndarray, "a"]:
    """Return ``action`` as float64, clipped to ``space``.

    Raises:
        InputError: the shape is wrong, or an entry is not real or not finite.
    """
    try:
        array = np.asarray(action)
        if array.dtype.kind in _NO_NUMBERS:
            raise TypeError(f"of kind {array.dtype}")
        array = array.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"An action must have {space.shape[0]} real numbers, got {action!r}."
        ) from error
    if array.shape != space.shape:
        raise InputError(f"An action must have shape {space.shape}, got {array.shape}.")
    if not all(map(math.isfinite, array.tolist())):
        raise InputError(f"An action must be finite, got {array.tolist()}.")
    return np.minimum(np.maximum(array, space.low), space.high)


def box(size: int) -> spaces.Box:
    """Return a box space with ``size`` entries in [-1, 1]."""
    return spaces.Box(-1.0, 1.0, (size,), np.float32)
