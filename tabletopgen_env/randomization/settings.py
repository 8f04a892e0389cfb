"""Settings of the randomisation; see the table in the package docstring."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any

import numpy as np

from generator.errors import InputError, choices, require

Range = tuple[float, float]
"""Lower and upper bound of a factor; (1, 1) disables it."""

SWITCHES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "lights": ("light_turn", "light_color", "ambient"),
        "cameras": ("camera_move", "camera_turn", "camera_fov"),
        "colors": ("tint",),
        "mass": ("mass",),
        "friction": ("friction",),
        "gains": ("stiffness", "damping"),
        "delay": ("delay",),
        "noise": ("joint_noise", "position_noise", "rotation_noise"),
        "poses": ("move", "turn"),
        "table": ("table_height",),
        "distractors": ("distractors",),
        "start": ("start_joints", "start_move", "start_turn"),
    }
)
"""The settings of each switch; a switch is off if all of its settings have their default values."""

_RANGES = ("ambient", "mass", "friction", "stiffness", "damping")
_LATEST = 100


def _up_to(most: float) -> Any:
    """Return a field with default 0 and maximum ``most``."""
    return field(default=0.0, metadata={"most": most})


@dataclass(frozen=True)
class Randomization:
    """Ranges of the randomisation, all off by default. Draws are uniform.

    Args:
        light_turn: maximum rotation of the sun's direction about each axis, radians, up to pi/2.
        light_color: maximum relative change of the sun's red, green and blue, up to 1.
        ambient: factor of the ambient light.
        camera_move: maximum move of each camera along each axis, metres, up to 1.
        camera_turn: maximum rotation of each camera about each axis, radians, up to pi/4.
        camera_fov: maximum relative change of fields of view, up to 0.5.
        tint: maximum relative darkening of red, green and blue, up to 1.
        mass: factor of masses.
        friction: factor of sliding friction.
        stiffness: factor of the servos' stiffness.
        damping: factor of the servos' damping.
        delay: maximum delay of actions, steps, up to 100.
        joint_noise: standard deviation of joint readings, radians, up to 1.
        position_noise: standard deviation of object positions along each axis, metres, up to 1.
        rotation_noise: standard deviation of object rotations about each axis, radians, up to 1.
        move: maximum move of objects along x and y, metres, up to 0.2.
        turn: maximum rotation of objects about the vertical, radians, up to pi.
        table_height: maximum change of the table's height, metres, up to 0.08.
        distractors: minimum and maximum number of objects besides those of the task; None keeps
            all.
        start_joints: maximum offset of each arm joint, radians, up to 0.1.
        start_move: maximum move of objects along x and y at the start, as far as there is room,
            metres, up to 0.2.
        start_turn: maximum rotation of objects about the vertical at the start, radians, up to pi.

    Raises:
        InputError: a setting is unknown; a value is not a number, negative or above its limit; a
            factor is zero; or a range is reversed.
    """

    light_turn: float = _up_to(np.pi / 2)
    light_color: float = _up_to(1.0)
    ambient: Range = (1.0, 1.0)
    camera_move: float = _up_to(1.0)
    camera_turn: float = _up_to(np.pi / 4)
    camera_fov: float = _up_to(0.5)
    tint: float = _up_to(1.0)
    mass: Range = (1.0, 1.0)
    friction: Range = (1.0, 1.0)
    stiffness: Range = (1.0, 1.0)
    damping: Range = (1.0, 1.0)
    delay: int = 0
    joint_noise: float = _up_to(1.0)
    position_noise: float = _up_to(1.0)
    rotation_noise: float = _up_to(1.0)
    move: float = _up_to(0.2)
    turn: float = _up_to(np.pi)
    table_height: float = _up_to(0.08)
    distractors: tuple[int, int] | None = None
    start_joints: float = _up_to(0.1)
    start_move: float = _up_to(0.2)
    start_turn: float = _up_to(np.pi)

    def __new__(cls, *given: Any, **settings: Any) -> Randomization:
        """Reject unknown settings with a message that lists the known ones."""
        known = [setting.name for setting in fields(cls)]
        for name in settings:
            if name in SWITCHES and name not in known:
                own = " and ".join(SWITCHES[name])
                raise InputError(f"Randomization: set {own} to turn on the switch {name!r}.")
            if name not in known:
                raise InputError(f"Randomization has no setting {name!r}." + choices(name, known))
        return super().__new__(cls)

    def __post_init__(self) -> None:
        for setting in fields(self):
            if "most" in setting.metadata:
                require(self, setting.name, minimum=0, maximum=setting.metadata["most"])
        require(self, "delay", minimum=0, maximum=_LATEST, integer=True)
        for name in _RANGES:
            low, high = pair = self._pair(name, "two factors (low, high) above 0")
            kinds = (int, float, np.integer, np.floating)
            if not (all(_number(factor, *kinds) for factor in pair) and 0 < low <= high):
                raise InputError(
                    f"Randomization.{name} must be two factors (low, high) with "
                    f"0 < low <= high, got {(low, high)}."
                )
        if self.distractors is not None:
            low, high = pair = self._pair("distractors", "two whole numbers (min, max)")
            if not (all(_number(count, int, np.integer) for count in pair) and 0 <= low <= high):
                raise InputError(
                    "Randomization.distractors must be two whole numbers (min, max) with "
                    f"0 <= min <= max, got {(low, high)}."
                )

    def _pair(self, name: str, wanted: str) -> tuple[Any, Any]:
        """Store a setting as a tuple of its two values, and return the tuple."""
        value = getattr(self, name)
        if isinstance(value, str | Mapping) or not hasattr(value, "__len__") or len(value) != 2:
            raise InputError(f"Randomization.{name} must be {wanted}, got {value!r}.")
        object.__setattr__(self, name, tuple(value))
        return getattr(self, name)

    def is_on(self, switch: str) -> bool:
        """Return whether a switch of ``SWITCHES`` has any effect."""
        usual = {setting.name: setting.default for setting in fields(self)}
        return any(getattr(self, name) != usual[name] for name in SWITCHES[switch])


def _number(value: Any, *kinds: type) -> bool:
    """Return whether a value is a finite number of one of the given types."""
    return isinstance(value, kinds) and not isinstance(value, bool) and bool(abs(value) < np.inf)


PRESETS: Mapping[str, Randomization] = MappingProxyType(
    {
        "none": Randomization(),
        "starts": Randomization(
            start_joints=0.06, start_move=0.03, start_turn=float(np.deg2rad(15.0))
        ),
        "light": Randomization(
            light_turn=0.2, light_color=0.1, ambient=(0.85, 1.15),
            camera_move=0.01, camera_turn=0.02, camera_fov=0.02, tint=0.15,
            mass=(0.85, 1.15), friction=(0.9, 1.1), stiffness=(0.95, 1.05), damping=(0.95, 1.05),
            joint_noise=0.001, position_noise=0.002, rotation_noise=0.01,
            move=0.01, turn=0.1, table_height=0.01,
        ),
        "strong": Randomization(
            light_turn=0.6, light_color=0.3, ambient=(0.5, 1.4),
            camera_move=0.04, camera_turn=0.06, camera_fov=0.08, tint=0.5,
            mass=(0.6, 1.6), friction=(0.7, 1.3), stiffness=(0.8, 1.2), damping=(0.8, 1.2),
            delay=2, joint_noise=0.003, position_noise=0.005, rotation_noise=0.03,
            move=0.03, turn=0.5, table_height=0.03, distractors=(0, 8),
        ),
    }
)  # fmt: skip
"""Presets by name: "none" changes nothing (for recipes, where the setting must be a string);
"starts" is the randomisation of certificates; "light" slightly varies everything except
delays and distractors; "strong" varies everything by large amounts."""


def resolve(choice: Randomization | str | None) -> Randomization:
    """Return the settings given by a preset's name, a ``Randomization`` or None (off).

    Raises:
        InputError: the preset is unknown, or the value has another type.
    """
    if choice is None:
        return Randomization()
    if isinstance(choice, Randomization):
        return choice
    if isinstance(choice, str) and choice in PRESETS:
        return PRESETS[choice]
    raise InputError(
        f"Unknown randomization {choice!r}; pass a Randomization or a preset's name."
        + choices(str(choice), PRESETS)
    )
