"""The part of a policy that says where to grasp, learned from what the expert chooses.

The maps of the observation are turned to twelve directions of the fingers, and one small network,
of the layers that the grasp detector has (``detection.network``), rates each square centimetre in
each: how good a grasp there is, how high, how wide. Beside the maps it sees from where the arm
comes, since the best grasp is of no use where the arm cannot reach it. That is added to the
activations after the second layer.
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
"""A grasp as a policy has it: the tool in the target's heading frame, from the centre of its box
and for z from the box's lowest corner (m); the bearing of the hand's x axis less a quarter turn, in
that frame (radians); how far to open, and what will be between the fingers (m)."""

STANDS = 4
"""Entries of what the head sees beside the maps: where the robot's base is from the target (x, y,
heading frame), the target's lowest corner above the table, the table above the base, metres."""

_AFTER, _FAR = 1, 0.6  # the layer after which the arm's side is added; metres that are 1 to it
_CONTEXT = 6
_WIDEST = 0.08
_ANGLES = torch.arange(TURNS) * (math.pi / TURNS)


class GraspHead(nn.Module):
    """Rates grasps of a target; ``plan`` is the best one."""

    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.ModuleList(nn.Conv2d(*layer) for layer in LAYERS)
        self.side = nn.Linear(_CONTEXT, LAYERS[_AFTER].outputs)
        nn.init.zeros_(self.side.weight)
        nn.init.zeros_(self.side.bias)

    def start_from(self, weights: Mapping[str, Float[np.ndarray, "..."]]) -> None:
        """Take over the weights of a grasp detector, which does not know where the arm is."""
        self.layers.load_state_dict({
            key: torch.from_numpy(np.asarray(value, np.float32)) for key, value in weights.items()
        })  # fmt: skip

    def forward(self, views: Float[Tensor, "b t 3 n n"], sides: Float[Tensor, "b t 6"]) -> Rated:
        """Return the ratings of targets seen as ``turn_maps`` gives them."""
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
        """Return the grasp rated best of each target, as ``PLAN``."""
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
    """Return ``angle`` or its opposite: for which the arm's last joint is nearer to its home."""
    bearing = torch.atan2(y - stands[:, 1], x - stands[:, 0])
    off = wrap(angle + math.pi / 2 - bearing - ROLL)
    return torch.where(off.abs() > math.pi / 2, angle + math.pi, angle)


def turn_maps(
    maps: Real[Tensor, "b m 48 48"], stands: Float[Tensor, "b 4"]
) -> tuple[Float[Tensor, "b t 3 n n"], Float[Tensor, "b t 6"]]:
    """Return the first two maps of an observation as the head sees them, at each turn.

    Heights are above the target's lowest corner. Channels: the target's, that of all else, and how
    far the target is below its top. With each turn comes from where the arm reaches: the cosine and
    sine of the base's bearing from the direction of opening, of its double, its distance, and how
    high the target's lowest corner is above the base.
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
    """Return where the cells of each turn's view are in a map, as ``grid_sample`` counts."""
    axis = (torch.arange(SEEN) - (SEEN - 1) / 2) * (CELL / ((CELLS - 1) * CELL / 2))
    u, v = axis[:, None], axis[None]
    c, s = (f(_ANGLES)[:, None, None] for f in (torch.cos, torch.sin))
    return torch.stack([u * s + v * c, u * c - v * s], -1)
