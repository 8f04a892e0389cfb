"""The grasp head of a policy, trained on the expert's grasps.

The observation's height maps are rotated to twelve finger directions. A small network with the
layers of the grasp detector (``detection.network``) predicts, for each square centimetre and
direction, the quality, height and width of a grasp. A further input is the position of the robot's
base, since a grasp beyond the arm's reach is useless; it is added to the activations after the
second layer.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import torch
from jaxtyping import Float, Real
from torch import Tensor, nn
from torch.nn import functional

from ...detection.network import (
    DEEPEST,
    HEIGHT,
    LAYERS,
    MIDDLES,
    PLACES,
    SEEN,
    TURNS,
    Rated,
    rate_output,
)
from ...expert.arm import ROLL
from ...observations.height_map import CELL, CELLS, STEP
from ...parallel.core.arrays import wrap

PLAN = ("x", "y", "z", "angle", "opening", "width")
"""Entries of a grasp as a policy represents it, in metres and radians. The tool's position is in
the target's heading frame, relative to the centre of the target's box (x, y) and the box's lowest
corner (z). "angle" is the bearing of the hand's x axis in that frame, minus a quarter turn.
"opening" is the opening of the fingers; "width" is the opening of the fingers when they are closed
on the target."""

STANDS = 4
"""Number of the head's inputs besides the maps, all in metres: the position of the robot's base
relative to the target (x and y in the heading frame), the height of the target's lowest corner
above the table, and the height of the table above the base.
"""

_AFTER, _FAR = 1, 0.6  # layer after which the base's position is added; its unit in metres
_CONTEXT = 6
_WIDEST = 0.08
_ANGLES = torch.arange(TURNS) * (math.pi / TURNS)


class GraspHead(nn.Module):
    """A network that predicts the quality of grasps of a target; ``plan`` returns the best one."""

    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.ModuleList(nn.Conv2d(*layer) for layer in LAYERS)
        self.side = nn.Linear(_CONTEXT, LAYERS[_AFTER].outputs)
        nn.init.zeros_(self.side.weight)
        nn.init.zeros_(self.side.bias)

    def start_from(self, weights: Mapping[str, Float[np.ndarray, "..."]]) -> None:
        """Load the weights of a grasp detector, which has no input for the base's position."""
        self.layers.load_state_dict({
            key: torch.from_numpy(np.asarray(value, np.float32)) for key, value in weights.items()
        })  # fmt: skip

    def forward(self, views: Float[Tensor, "b t 3 n n"], sides: Float[Tensor, "b t 6"]) -> Rated:
        """Compute the predictions for inputs from ``turn_maps``."""
        values, side = views.flatten(0, 1), self.side(sides.flatten(0, 1))[..., None, None]
        for number, layer in enumerate(self.layers):
            values = layer(values if number == 0 else values.relu())
            if number == _AFTER:
                values = values + side
        out = values.unflatten(0, views.shape[:2])
        return rate_output(out, torch.from_numpy(MIDDLES.copy()))

    @torch.no_grad()
    def plan(
        self, maps: Real[Tensor, "b m 48 48"], stands: Float[Tensor, "b 4"]
    ) -> Float[Tensor, "b 6"]:
        """Return the best grasp of each target in the format ``PLAN``."""
        rated = self(*turn_maps(maps, stands))
        best = rated.best.flatten(1).argmax(1)
        rows = torch.arange(len(best))
        along, across, z, width, room = (part.flatten(1)[rows, best] for part in rated[2:])
        angle = _ANGLES[best // PLACES**2]
        c, s = angle.cos(), angle.sin()
        x, y = along * c - across * s, along * s + across * c
        width = width.clamp(0.0, _WIDEST)
        opening = (width + room.clamp(min=0.0)).clamp(max=_WIDEST)
        return torch.stack([x, y, z, turn_easily(x, y, angle, stands), opening, width], 1)


def turn_easily(
    x: Float[Tensor, "b"],
    y: Float[Tensor, "b"],
    angle: Float[Tensor, "b"],
    stands: Float[Tensor, "b 4"],
) -> Float[Tensor, "b"]:
    """Return ``angle`` or its opposite, whichever keeps the last joint nearer to its home angle."""
    bearing = torch.atan2(y - stands[:, 1], x - stands[:, 0])
    off = wrap(angle + math.pi / 2 - bearing - ROLL)
    return torch.where(off.abs() > math.pi / 2, angle + math.pi, angle)


def turn_maps(
    maps: Real[Tensor, "b m 48 48"], stands: Float[Tensor, "b 4"]
) -> tuple[Float[Tensor, "b t 3 n n"], Float[Tensor, "b t 6"]]:
    """Rotate the first two height maps of an observation to each finger direction.

    Heights are relative to the target's lowest corner. Channels: the target's heights, the heights
    of everything else, and the target's depth below its top. The second array holds for each turn
    the cosine and sine of the base's bearing relative to the finger direction, those of twice the
    bearing, the distance of the base, and the height of the target's lowest corner above the base.
    """
    count = len(maps)
    low = (stands[:, 2] / HEIGHT)[:, None, None, None]
    heights = (maps[:, :2].float() * (STEP / HEIGHT) - low).clamp(min=0.0)
    grid = _grid().repeat(count, 1, 1, 1)
    seen = functional.grid_sample(
        heights.repeat_interleave(TURNS, 0), grid, align_corners=True
    ).unflatten(0, (count, TURNS))
    own = seen[:, :, 0]
    top = heights[:, 0].amax((1, 2))[:, None, None, None]
    views = torch.stack([own, seen[:, :, 1], 2 * (own - top).clamp(min=-DEEPEST)], 2)
    away = torch.atan2(stands[:, 1], stands[:, 0])[:, None] - _ANGLES
    far = stands[:, :2].norm(dim=1, keepdim=True) / _FAR
    high = (stands[:, 2:3] + stands[:, 3:4]) / _FAR
    sides = torch.stack([
        away.cos(), away.sin(), (2 * away).cos(), (2 * away).sin(),
        far.expand_as(away), high.expand_as(away),
    ], 2)  # fmt: skip
    return views, sides


def _grid() -> Float[Tensor, "t n n 2"]:
    """Return the positions of the cells of each rotated view, in ``grid_sample`` coordinates."""
    axis = (torch.arange(SEEN) - (SEEN - 1) / 2) * (CELL / ((CELLS - 1) * CELL / 2))
    u, v = axis[:, None], axis[None]
    c, s = (f(_ANGLES)[:, None, None] for f in (torch.cos, torch.sin))
    return torch.stack([u * s + v * c, u * c - v * s], -1)
