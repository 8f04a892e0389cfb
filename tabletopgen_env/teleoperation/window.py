"""Local window for teleoperation, with the keyboard or the first gamepad."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import UInt8

from generator.errors import BackendError

from ..rendering.window import has_display
from .inputs import HumanInput
from .session import TeleopStatus

_NAMES: Mapping[str, tuple[str, ...]] = MappingProxyType({
    "space": ("SPACE",), "shift": ("LEFT_SHIFT", "RIGHT_SHIFT"), "enter": ("ENTER", "KP_ENTER"),
    "backspace": ("BACKSPACE",), "up": ("UP",), "down": ("DOWN",), "left": ("LEFT",),
    "right": ("RIGHT",), **{letter: (letter.upper(),) for letter in "wasdrfqep"},
})  # fmt: skip
_STANDARD: Mapping[int, int] = MappingProxyType({0: 0, 3: 3, 4: 4, 5: 5, 6: 8, 7: 9})
"""Numbers of gamepad buttons in the standard layout, by their GLFW number."""


class TeleopWindow:
    """A window with the camera's picture. Close it after use.

    Args:
        height, width: size of the pictures, pixels.

    Raises:
        BackendError: no display is available, or no window can be opened.
    """

    def __init__(self, height: int, width: int) -> None:
        if not has_display():
            raise BackendError(
                "Teleoperation in a window needs a display, but DISPLAY is not set. Use --device "
                "page and a browser."
            )
        import glfw

        if not glfw.init():
            raise BackendError("No window can be opened. Use --device page and a browser.")
        glfw.window_hint(glfw.RESIZABLE, glfw.FALSE)
        self._glfw: Any = glfw
        self._window = glfw.create_window(width, height, "tabletopgen teleop", None, None)
        if not self._window:
            glfw.terminate()
            raise BackendError("No window can be opened. Use --device page and a browser.")
        self._size = height, width

    def read(self) -> HumanInput | None:
        """Return the current input, or None once the window is closed."""
        glfw, window = self._glfw, self._window
        glfw.poll_events()
        if glfw.window_should_close(window):
            return None
        keys = {
            name for name, codes in _NAMES.items()
            if any(glfw.get_key(window, getattr(glfw, f"KEY_{c}")) == glfw.PRESS for c in codes)
        }  # fmt: skip
        axes: tuple[float, ...] = (0.0, 0.0, 0.0, 0.0)
        buttons: frozenset[int] = frozenset()
        state = glfw.get_gamepad_state(glfw.JOYSTICK_1)
        if state:
            axes = tuple(float(np.clip(axis, -1, 1)) for axis in list(state.axes)[:4])
            pressed = [k for k, b in enumerate(state.buttons) if b]
            buttons = frozenset(_STANDARD[k] for k in pressed if k in _STANDARD)
        return HumanInput(frozenset(keys), axes, buttons)

    def show(self, picture: UInt8[np.ndarray, "h w 3"], status: TeleopStatus) -> None:
        """Draw a picture, and show the episode's status in the title."""
        from OpenGL import GL

        glfw = self._glfw
        glfw.make_context_current(self._window)
        height, width = self._size
        wide, high = glfw.get_framebuffer_size(self._window)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        GL.glPixelZoom(wide / width, high / height)
        GL.glRasterPos2f(-1, -1)
        upright = np.ascontiguousarray(picture[::-1])
        GL.glDrawPixels(width, height, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, upright)
        glfw.swap_buffers(self._window)
        done = {"solved": "done", "time": "time limit reached", None: status.by}[status.over]
        glfw.set_window_title(self._window, f"{status.instruction} · {status.step} · {done}")
        glfw.make_context_current(None)

    def close(self) -> None:
        """Close the window."""
        self._glfw.destroy_window(self._window)
        self._glfw.terminate()
