"""A small network that rates, for each turn of the hand and each place, closing the fingers there.

The height maps are turned so that the fingers open along the first axis, once for each of
``TURNS`` turns, and all go through the same convolutions: a grasp looks the same however the object
lies (the rotated inputs of Zeng et al., Learning Synergies between Pushing and Grasping, 2018).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import torch
from jaxtyping import Float, UInt8
from torch import Tensor, nn
from torch.nn import functional

from .look import CELL, CELLS, STEP

TURNS = 12
"""Turns of the hand that are looked at, over half a turn."""

PLACES, PLACE = 24, 0.01
"""Places along a side of what is rated, and their size, metres."""

_SEEN, _FINE = 2 * PLACES, PLACE / 2  # cells that the network looks at, and their size
_HEIGHT, _ROOM, _WIDTH = 0.05, 0.02, 0.04  # metres that are 1 to the network
_DEEPEST = 2.0  # of these heights below the object's top that are told apart


class Rated(NamedTuple):
    """Logits and grasps by object b, turn t and place (i, j); places are metres, hand's frame.

    ``best`` is higher where a grasp is better, ``possible`` is positive where there is likely one.
    ``at[..., :2]`` is where the middle between the fingers is, from the object's centre, along the
    opening and across it; ``at[..., 2]`` the height of the tool above the table. ``room`` is how
    much further than ``width``, what is between them, the fingers open (metres).
    """

    best: Float[Tensor, "b t i j"]
    possible: Float[Tensor, "b t i j"]
    at: Float[Tensor, "b t i j 3"]
    width: Float[Tensor, "b t i j"]
    room: Float[Tensor, "b t i j"]


class GraspNetwork(nn.Module):
    """Rates grasps of objects seen as ``turned`` gives them."""

    def __init__(self, channels: int = 32) -> None:
        super().__init__()
        c = channels
        self.body = nn.Sequential(
            nn.Conv2d(3, c // 2, 5, stride=2, padding=2), nn.ReLU(),
            nn.Conv2d(c // 2, c, 3, padding=1), nn.ReLU(),
            nn.Conv2d(c, c, 3, padding=2, dilation=2), nn.ReLU(),
            nn.Conv2d(c, c, 3, padding=4, dilation=4), nn.ReLU(),
            nn.Conv2d(c, c, 3, padding=1), nn.ReLU(),
            nn.Conv2d(c, 7, 1),
        )  # fmt: skip

    def forward(self, seen: Float[Tensor, "b t 3 n n"]) -> Rated:
        """Return the ratings of a batch of objects, each seen at every turn."""
        out = self.body(seen.flatten(0, 1)).unflatten(0, seen.shape[:2]).movedim(2, -1)
        best, possible, du, dv, height, width, room = out.unbind(-1)
        middle = (torch.arange(PLACES) - (PLACES - 1) / 2) * PLACE
        at = torch.stack([
            middle[:, None] + du * PLACE, middle + dv * PLACE, height * _HEIGHT
        ], -1)  # fmt: skip
        return Rated(best, possible, at, width * _WIDTH, room * _ROOM)


def turned(
    heights: UInt8[Tensor, "b 2 64 64"], facing: Float[Tensor, "b"]
) -> Float[Tensor, "b t 3 n n"]:
    """Return height maps as the network sees them, at turns from ``facing`` (radians) on.

    Its channels are the object's height, that of all else, and how far the object is below its
    own top.
    """
    angles = facing[:, None] + torch.arange(TURNS) * math.pi / TURNS
    along = (torch.arange(_SEEN) - (_SEEN - 1) / 2) * _FINE
    u, v = torch.meshgrid(along, along, indexing="ij")
    c, s = (f(angles).flatten()[:, None, None] for f in (torch.cos, torch.sin))
    half = CELLS * CELL / 2
    grid = torch.stack([(u * s + v * c) / half, (u * c - v * s) / half], -1)  # columns first
    maps = heights.float() * (STEP / _HEIGHT)
    seen = functional.grid_sample(maps.repeat_interleave(TURNS, 0), grid, align_corners=False)
    top = maps[:, 0].amax((1, 2)).repeat_interleave(TURNS)[:, None, None, None]
    below = (seen[:, :1] - top).clamp(min=-_DEEPEST)
    return torch.cat([seen, 2 * below], 1).unflatten(0, (-1, TURNS))
