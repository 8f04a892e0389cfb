"""The torch version of the grasp network for training, and its loss."""

from __future__ import annotations

from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor, nn
from torch.nn import functional

from .network import LAYERS, MIDDLES, UNITS, Rated, rate_output

SHARPNESS = 0.12
"""Difference of planner scores that makes a grasp e times as good."""

_RARE = 50.0  # weight of the classification loss: positive cells are rare


class GraspNetwork(nn.Module):
    """The torch version of ``network`` for batches; ``network.rate`` accepts its ``weights``."""

    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.ModuleList(nn.Conv2d(*layer) for layer in LAYERS)

    def forward(self, seen: Float[Tensor, "b t 3 n n"]) -> Rated:
        """Return the grasp ratings for a batch of objects, each given as rotated views."""
        values = seen.flatten(0, 1)
        for number, layer in enumerate(self.layers):
            values = layer(values if number == 0 else values.relu())
        return rate_output(values.unflatten(0, seen.shape[:2]), torch.from_numpy(MIDDLES.copy()))

    def weights(self) -> dict[str, Tensor]:
        """Return the weights under the names that ``network`` uses."""
        named = self.layers.state_dict().items()
        return {key: value.detach().half().contiguous() for key, value in named}


class GraspBatch(NamedTuple):
    """A training batch: network inputs, with targets at p = TURNS * PLACES**2 places.

    ``share`` is the target probability that a place has the best grasp, ``possible`` tells whether
    it has any grasp, and ``grasp`` is its best one: along, across, height, width and room (metres).
    """

    seen: Float[Tensor, "b t 3 n n"]
    share: Float[Tensor, "b p"]
    possible: Float[Tensor, "b p"]
    grasp: Float[Tensor, "b p 5"]


def loss_of(rated: Rated, batch: GraspBatch) -> Float[Tensor, ""]:
    """Return the loss of predicted ratings with respect to a batch's targets."""
    best, possible, *grasp = (part.flatten(1) for part in rated)
    share = -(batch.share * functional.log_softmax(best, 1)).sum(1).mean()
    there = functional.binary_cross_entropy_with_logits(possible, batch.possible)
    off = ((torch.stack(grasp, 2) - batch.grasp).abs() / torch.tensor(UNITS)).sum(2)
    every = batch.possible / batch.possible.sum(1, keepdim=True).clamp(min=1)
    return share + _RARE * there + ((batch.share + every) / 2 * off).sum(1).mean()
