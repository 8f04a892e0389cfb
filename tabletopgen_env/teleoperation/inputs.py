"""Keyboard and gamepad input, and its conversion to actions and events.

=====================  =============================  ===========================================
keyboard               gamepad (standard layout)      effect
=====================  =============================  ===========================================
w, s (or up, down)     left stick, up and down        move away from, towards the viewer
a, d (left, right)     left stick, left and right     move left, right in the picture
r, f                   right stick, up and down       move up, down
q, e                   right stick, left and right    turn the hand left, right
shift                  shoulder buttons (4, 5)        slow motion
space                  A (0)                          open or close the gripper
enter                  start (9)                      end the episode and keep it
backspace              back (8)                       end it and discard it
p                      Y (3)                          return control to the policy
=====================  =============================  ===========================================
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np
from jaxtyping import Float

from ..rendering.config import CameraName

Event = Literal["keep", "drop", "policy"]
"""Events that an operator can trigger."""

VIEWS: Mapping[CameraName, tuple[tuple[float, float], tuple[float, float]]] = MappingProxyType({
    "front": ((0.0, 1.0), (-1.0, 0.0)),
    "side": ((-1.0, 0.0), (0.0, -1.0)),
    "top": ((0.0, -1.0), (1.0, 0.0)),
    "wrist": ((0.0, -1.0), (1.0, 0.0)),
})  # fmt: skip
"""Directions of a camera's right and forward axes in the base frame, x and y."""

SLOWLY = 0.3
"""Fraction of full speed while shift is pressed."""

_DEAD = 0.15  # dead zone of a stick
_KEYS: Mapping[str, tuple[int, float]] = MappingProxyType({
    "d": (0, 1.0), "right": (0, 1.0), "a": (0, -1.0), "left": (0, -1.0),
    "w": (1, 1.0), "up": (1, 1.0), "s": (1, -1.0), "down": (1, -1.0),
    "r": (2, 1.0), "f": (2, -1.0), "q": (3, 1.0), "e": (3, -1.0),
})  # fmt: skip
_STICKS = ((0, 1.0), (1, -1.0), (3, -1.0), (2, -1.0))  # axis and sign: right, away, up, turn
_GRIP_KEY, _SLOW_KEY = "space", "shift"
_EVENT_KEYS: Mapping[str, Event] = MappingProxyType(
    {"enter": "keep", "backspace": "drop", "p": "policy"}
)
_GRIP_BUTTON, _SLOW_BUTTONS = 0, frozenset({4, 5})
_EVENT_BUTTONS: Mapping[int, Event] = MappingProxyType({9: "keep", 8: "drop", 3: "policy"})

KEYS = frozenset({*_KEYS, *_EVENT_KEYS, _GRIP_KEY, _SLOW_KEY})
"""The keys with a function."""


@dataclass(frozen=True)
class HumanInput:
    """The current keyboard and gamepad input of the operator.

    Attributes:
        keys: pressed keys, a subset of ``KEYS``.
        axes: axes of a gamepad's sticks, in [-1, 1]: left x, left y, right x, right y; down is 1.
        buttons: pressed buttons of a gamepad, by number in the standard layout.
    """

    keys: frozenset[str] = frozenset()
    axes: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0)
    buttons: frozenset[int] = frozenset()


@dataclass(frozen=True, eq=False)
class Command:
    """The command for an input: an "ee_delta" action, whether it causes motion, and events."""

    action: Float[np.ndarray, "5"]
    acts: bool
    events: frozenset[Event]


class Operator:
    """A converter of successive inputs to commands, which tracks the gripper command.

    Args:
        view: the camera on display.
    """

    def __init__(self, view: CameraName) -> None:
        self._right, self._away = (np.array(axis) for axis in VIEWS[view])
        self._before = HumanInput()
        self.gripper = 1.0

    def read(self, given: HumanInput) -> Command:
        """Return the command for an input; event keys and buttons count once per press."""
        before, self._before = self._before, given
        right, away, up, turn = _motion(given)
        grips = _goes_down(_GRIP_KEY, _GRIP_BUTTON, before, given)
        if grips:
            self.gripper = -self.gripper
        across = right * self._right + away * self._away
        action = np.array([*across, up, turn, self.gripper], np.float32)
        pressed, clicked = given.keys - before.keys, given.buttons - before.buttons
        events: set[Event] = {event for key, event in _EVENT_KEYS.items() if key in pressed}
        events |= {event for button, event in _EVENT_BUTTONS.items() if button in clicked}
        return Command(action, bool(grips or action[:4].any()), frozenset(events))

    def follow(self, gripper: float) -> None:
        """Adopt a policy's gripper command, from -1 (closed) to 1 (open)."""
        self.gripper = 1.0 if gripper > 0 else -1.0

    def restart(self) -> None:
        """Start another episode, with the gripper open."""
        self.gripper = 1.0


def _motion(given: HumanInput) -> Float[np.ndarray, "4"]:
    """Return the motion right, away from the viewer and up, and the turn, each in [-1, 1]."""
    found = np.zeros(4)
    for key in given.keys & _KEYS.keys():
        entry, sign = _KEYS[key]
        found[entry] += sign
    for entry, (axis, sign) in enumerate(_STICKS):
        value = given.axes[axis] if axis < len(given.axes) else 0.0
        found[entry] += sign * value if abs(value) > _DEAD else 0.0
    slow = _SLOW_KEY in given.keys or bool(_SLOW_BUTTONS & given.buttons)
    return (SLOWLY if slow else 1.0) * np.clip(found, -1.0, 1.0)


def _goes_down(key: str, button: int, before: HumanInput, given: HumanInput) -> bool:
    def held(one: HumanInput) -> bool:
        return key in one.keys or button in one.buttons

    return held(given) and not held(before)


def known_keys(keys: Collection[str]) -> frozenset[str]:
    """Return the keys that have a function."""
    return KEYS & set(keys)
