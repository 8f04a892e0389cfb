"""Place of an object in its crop if something hides one side of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .objective import Candidates, Objective

if TYPE_CHECKING:
    from ...render.soft import CropFit

LEFT, TOP, RIGHT, BOTTOM = range(4)

_MOST = 0.3  # change of size, and of place over the crop's side, that is not tried


def reaching_past(objective: Objective, poses: Candidates, side: int) -> CropFit:
    """Return how candidates are drawn that agree with their boxes at all sides but one.

    The two opposite sides that are left tell the size, the third the place. A candidate that
    would end before its box does, or reach much farther, is drawn tightly instead.
    """
    import torch

    from ...render.crop import MARGIN
    from ...render.soft import CropFit, bounds

    owner = poses.owner
    low, high = bounds(objective.surface.corners[owner], *objective.place(poses))
    own, box = high - low, objective.span[owner]
    inner = 1 - 2 * MARGIN
    own = inner * own / own.amax(1, keepdim=True)  # shares of the crop's side
    box = inner * box / box.amax(1, keepdim=True)
    along, across = (1, 0) if side in (LEFT, RIGHT) else (0, 1)
    zoom = (box[:, along] / own[:, along]).log()
    past = own[:, across] * zoom.exp() - box[:, across]
    usable = (past > 0) & (past < _MOST) & (zoom.abs() < _MOST)
    past, zoom = (torch.where(usable, value, 0.0) for value in (past, zoom))
    shift = torch.zeros_like(own)
    shift[:, across] = past / 2 if side in (RIGHT, BOTTOM) else -past / 2
    return CropFit(shift, zoom)
