"""The grasp network in torch, to be trained."""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor, nn

from .network import LAYERS, MIDDLES, Rated, rate_output


class GraspNetwork(nn.Module):
    """The network of ``network`` on batches; its ``weights`` are what that takes."""

    def __init__(self) -> None:
        super().__init__()
        self.layers = nn.ModuleList(nn.Conv2d(*layer) for layer in LAYERS)

    def forward(self, seen: Float[Tensor, "b t 3 n n"]) -> Rated:
        """Return the ratings of a batch of objects, each seen at every turn."""
        values = seen.flatten(0, 1)
        for number, layer in enumerate(self.layers):
            values = layer(values if number == 0 else values.relu())
        return rate_output(values.unflatten(0, seen.shape[:2]), torch.from_numpy(MIDDLES.copy()))

    def weights(self) -> dict[str, Tensor]:
        """Return the weights by the names that the network has them by."""
        named = self.layers.state_dict().items()
        return {key: value.detach().half().contiguous() for key, value in named}
