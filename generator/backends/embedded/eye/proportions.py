"""How wide and tall things are for their length, as the eye has learned it from renders.

A mask leaves open how deep a thing is: a spoon that lies and one that stands may have the same. A
small network tells it from what the thing looks like close up, its mask, and how steeply the camera
looks down on it, and says how sure it is.
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
"""Cells a side of the mask that is looked at besides."""

_SPREADS = -3.0, 2.0  # least and most logarithm of a spread


class ProportionNetwork(nn.Module):
    """Tells proportions from ``clues``; ``unsure`` is by how much it underrates its errors."""

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
        """Return logarithms (n, 2) and those of their spreads for clues (n, c)."""
        logs, spread = self.layers((clues - self.mean) / self.scale).chunk(2, 1)
        return logs, spread.clamp(*_SPREADS)

    @torch.inference_mode()
    def tell(self, clues: Float[np.ndarray, "n c"]) -> list[Proportions]:
        """Return the proportions of things by their clues."""
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
    """Return what is known of the things visible under ``masks``, none of them empty.

    ``elevations`` are how many radians below the horizon each foot is, ``tabletop`` the pixels that
    the tabletop covers, things on it included.
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
