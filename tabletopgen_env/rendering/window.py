"""The window of ``render_mode="human"``: MuJoCo's viewer in real time."""

from __future__ import annotations

import os
import sys
import time
from typing import TYPE_CHECKING, Any

import gymnasium

if TYPE_CHECKING:
    from ..world.world import World


class Window:
    """A viewer that follows an environment from world to world, drawing every ``frame`` seconds.

    Without a display it shows nothing and warns once through Gymnasium's logger.
    """

    def __init__(self, frame: float) -> None:
        self._frame = frame
        self._viewer: Any = None
        self._world: World | None = None
        self._warned = False
        self._shown = 0.0

    def show(self, world: World) -> None:
        """Show the current state of ``world``, no faster than real time."""
        if not has_display():
            if not self._warned:
                gymnasium.logger.warn(
                    "render_mode='human' needs a display, but DISPLAY is not set; nothing is "
                    "shown. Use render_mode='rgb_array' for pictures."
                )
            self._warned = True
            return
        if world is not self._world:
            self._open(world)
        if self._viewer.is_running():
            self._viewer.sync()
        time.sleep(max(0.0, self._shown + self._frame - time.monotonic()))
        self._shown = time.monotonic()

    def close(self) -> None:
        """Close the window."""
        if self._viewer is not None:
            self._viewer.close()
        self._viewer = self._world = None

    def _open(self, world: World) -> None:
        import mujoco.viewer

        self.close()
        self._viewer = mujoco.viewer.launch_passive(
            world.model, world.data, show_left_ui=False, show_right_ui=False
        )
        self._world = world


def has_display() -> bool:
    """Return whether a window can be opened on this machine."""
    if not sys.platform.startswith("linux"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
