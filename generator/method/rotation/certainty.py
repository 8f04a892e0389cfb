"""Certainty of an estimated yaw, from the losses at other candidates and at nearby yaws."""

from __future__ import annotations

import numpy as np

from ...geometry import wrap
from .objective import Candidates, Objective
from .results import RotationCandidate, Rows

OTHER = float(np.deg2rad(20.0))
"""Minimum angle between two different answers; closer yaws count as the same answer."""

RISE = 0.02
"""Relative increase of the loss that defines the width of a minimum."""

_SAME = float(np.deg2rad(8.0))  # a candidate is unchanged if refinement moved it by less than this
_LEAST = 1e-9  # loss of a perfect match; avoids division by zero
_STEP = float(np.deg2rad(2.0))  # step of the second difference


def margin(rounds: Rows, order: int = 1) -> float:
    """Return the relative increase in loss from the best yaw to the best clearly different yaw.

    Yaws that differ by a multiple of 2 pi / ``order`` are the same answer. ``rounds`` are one
    object's candidates, highest resolution first. Each rival is compared, at its highest
    resolution, with the best candidate at that resolution. Returns 0 if there is no rival.
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
    """Return the change in yaw, in (0, pi] radians, that raises each loss by the fraction ``RISE``.

    It is computed from the second difference at the best pose of each object of the objective, and
    is pi if the loss has no minimum there.
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
