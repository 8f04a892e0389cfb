"""Width and height of objects relative to their length, learned from renders.

A mask does not determine the depth of an object: a lying and a standing spoon may have the same
mask. A small network estimates it from the object's close-up, its mask, and the camera's elevation,
together with an uncertainty.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8
from torch import Tensor, nn
from torch.nn import functional

from ....geometry import mask_box
from ....scene import Proportions
from ....threads import single_thread
from .closeups import closeup, impressions
from .network import IMPRESSION, Eye

MASK = 16
"""Side length in cells of the mask that the network uses as input."""

_SPREADS = -3.0, 2.0  # minimum and maximum logarithm of a spread


class ProportionNetwork(nn.Module):
    """A network that predicts proportions from ``clues``; ``unsure`` scales its error estimates."""

    mean: Tensor
    scale: Tensor
    unsure: Tensor

    def __init__(self) -> None:
        super().__init__()
        inward = IMPRESSION + MASK**2 + 2
        self.register_buffer("mean", torch.zeros(inward))
        self.register_buffer("scale", torch.ones(inward))
        self.register_buffer("unsure", torch.ones(2))
        self.layers = nn.Sequential(
            nn.Dropout(0.3), nn.Linear(inward, 128), nn.ReLU(),
            nn.Dropout(0.3), nn.Linear(128, 64), nn.ReLU(), nn.Linear(64, 4),
        )  # fmt: skip

    def forward(self, clues: Tensor) -> tuple[Tensor, Tensor]:
        """Return the logarithms (n, 2) of proportions and of their spreads, for features (n, c)."""
        logs, spread = self.layers((clues - self.mean) / self.scale).chunk(2, 1)
        return logs, spread.clamp(*_SPREADS)

    @torch.inference_mode()
    def tell(self, clues: Float[np.ndarray, "n c"]) -> list[Proportions]:
        """Return the proportions of objects, with error estimates, from their features."""
        logs, spread = self(torch.from_numpy(clues))
        errors = spread.exp() * self.unsure
        return [Proportions(*pair) for pair in zip(logs.numpy(), errors.numpy(), strict=True)]


def proportion_clues(
    eye: Eye,
    image: UInt8[np.ndarray, "h w 3"],
    masks: Sequence[Bool[np.ndarray, "h w"]],
    elevations: Sequence[float],
    tabletop: float,
) -> Float[np.ndarray, "n c"]:
    """Return the inputs of ``ProportionNetwork`` for the objects under non-empty ``masks``.

    ``elevations`` are the angles of the objects' feet below the horizon in radians. ``tabletop`` is
    the number of pixels that the tabletop covers, including the objects on it.
    """
    if not masks:
        return np.zeros((0, IMPRESSION + MASK**2 + 2), np.float32)
    boxes = np.stack([mask_box(mask) for mask in masks])
    wide, tall = (boxes[:, 2:] - boxes[:, :2]).T
    with single_thread(), torch.inference_mode():
        looks = [closeup(image, mask, tabletop) for mask in masks]
        shape = torch.from_numpy(np.stack([look.visible for look in looks]))
        small = functional.interpolate(shape[:, None], size=(MASK, MASK), mode="area")
        seen = torch.cat([impressions(eye, looks).mean(0), small.flatten(1)], 1).numpy()
    return np.column_stack([seen, elevations, np.log(tall / wide)]).astype(np.float32)
