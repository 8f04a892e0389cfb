"""Certainty of a yaw: against other sides, and against small turns."""

from __future__ import annotations

import numpy as np

from ...geometry import wrap
from .objective import Candidates, Objective
from .results import RotationCandidate, Rows

OTHER = float(np.deg2rad(20.0))
"""Angle from which a yaw is another answer, not the same one found less exactly."""

RISE = 0.02
"""Share of the loss whose addition marks a minimum's width."""

_SAME = float(np.deg2rad(8.0))  # a candidate that a refinement moved by less is the same one
_LEAST = 1e-9  # loss of a render that is the picture itself
_STEP = float(np.deg2rad(2.0))  # of the second difference


def margin(rounds: Rows, order: int = 1) -> float:
    """Return by how much the best other yaw's loss exceeds the found one's, as a share of it.

    Yaws a whole turn over ``order`` apart are the same answer. ``rounds`` are one object's
    candidates, the closest look first. Every rival counts by the closest look it was given,
    against the best of that look. 0 without any.
    """
    answer, least, judged = rounds[0][0].yaw, float("inf"), list[float]()

    def apart(a: float, b: float) -> float:
        return abs(wrap(order * (a - b))) / order

    for found in rounds:
        near = [f.loss for f in found if apart(f.yaw, answer) < OTHER]
        best = min(near, default=min(f.loss for f in found))
        for f in found:
            known = any(apart(f.yaw, yaw) < _SAME for yaw in judged)
            if apart(f.yaw, answer) >= OTHER and not known:
                least = min(least, f.loss / max(best, _LEAST) - 1)
        judged += [f.yaw for f in found]
    return max(least, 0.0) if np.isfinite(least) else 0.0


def widths(objective: Objective, found: list[RotationCandidate]) -> list[float]:
    """Return the change of yaw, radians in (0, pi], that adds ``RISE`` to each object's loss.

    By the second difference at the found pose of each of the objective's objects; pi where the
    loss has no minimum there.
    """
    import torch

    from ...render.soft import CropFit

    device = objective.middle.device
    rows = torch.tensor(
        [[f.yaw + turn, f.tilt, *f.place] for f in found for turn in (-_STEP, 0.0, _STEP)],
        device=device,
    )
    owner = torch.arange(len(found), device=device).repeat_interleave(3)
    poses = Candidates(owner, rows[:, 0], rows[:, 1], CropFit(rows[:, 2:4], rows[:, 4]))
    with torch.no_grad():
        losses = objective(poses).view(-1, 3).double().cpu().numpy()
    curvature = (losses[:, 0] - 2 * losses[:, 1] + losses[:, 2]) / _STEP**2
    wide = np.sqrt(2 * RISE * losses[:, 1] / np.maximum(curvature, 1e-9))
    return [float(w) for w in np.clip(wide, 1e-6, np.pi)]
