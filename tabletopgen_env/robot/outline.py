"""Where the arm is, all over: what a camera has to show to have the whole robot in the picture."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from .kinematics import HOME, link_frames
from .shells import arm_shells


def arm_points(joints: Float[np.ndarray, "7"] = HOME) -> Float[np.ndarray, "n 3"]:
    """Return points all over the arm's links and the tool centre point, in the base frame."""
    frames = [np.eye(4), *link_frames(joints)]
    points = [frames[-1][None, :3, 3]]
    for number, frame in enumerate(frames[:-1]):
        shells = np.concatenate([shell.vertices for shell in arm_shells()[f"link{number}"]])
        points.append(shells @ frame[:3, :3].T + frame[:3, 3])
    return np.concatenate(points)
