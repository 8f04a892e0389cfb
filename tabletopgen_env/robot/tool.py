"""The tool centre point, and the camera on the hand."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from . import franka

if TYPE_CHECKING:
    import mujoco

TCP_SITE = "tcp"
"""Name of the tool centre point's site."""

WRIST_CAMERA = "wrist"
"""Name of the camera on the hand."""


def add_tool(hand: mujoco.MjsBody) -> None:
    """Add the site of the tool centre point, and a camera that views it from beside the hand."""
    hand.add_site(name=TCP_SITE, pos=[0, 0, franka.TCP], size=[0.005] * 3, group=4)
    position, target = np.array([0.09, 0.0, 0.03]), np.array([0.0, 0.0, franka.TCP + 0.04])
    back = (position - target) / np.linalg.norm(position - target)
    right = np.array([0.0, 1.0, 0.0])
    hand.add_camera(
        name=WRIST_CAMERA,
        pos=position,
        xyaxes=[*right, *np.cross(back, right)],
        fovy=70,
    )
