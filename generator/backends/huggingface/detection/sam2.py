"""Masks from boxes: SAM 2 (N. Ravi et al., 2024)."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float, UInt8

from .detections import IMAGENET, BoxDetection, to_batch
from .tiles import Tile, closest

if TYPE_CHECKING:
    from torch import Tensor

_BATCH = 32  # boxes per batch
_MARGIN = 0.25  # required margin around a box, relative to its sides


@dataclass(frozen=True, eq=False)
class Sam2:
    """SAM 2's network (a ``Sam2Model``), applied to each box in the smallest tile around it."""

    network: Any

    def mask(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        detections: Sequence[BoxDetection],
        tiles: Sequence[Tile],
    ) -> list[BoxDetection]:
        """Return the detections with masks."""
        chosen = [closest(tiles, detection.box, _MARGIN) for detection in detections]
        made: dict[int, BoxDetection] = {}
        for tile in dict.fromkeys(chosen):
            held = [k for k, t in enumerate(chosen) if t == tile]
            masks = self._masks(image, tile, np.stack([detections[k].box for k in held]))
            for k, mask in zip(held, masks, strict=True):
                made[k] = dataclasses.replace(detections[k], mask=tile.whole(mask))
        return [made[k] for k in range(len(detections)) if made[k].mask.any()]

    def _masks(
        self, image: UInt8[np.ndarray, "h w 3"], tile: Tile, boxes: Float[np.ndarray, "n 4"]
    ) -> list[Bool[np.ndarray, "th tw"]]:
        """Return the masks of boxes in a tile, at the tile's size; the tile is encoded once."""
        import torch

        side = int(self.network.config.prompt_encoder_config.image_size)
        device = self.network.device
        at = torch.as_tensor(tile.to_part(boxes) * side, dtype=torch.float32, device=device)
        found: list[np.ndarray] = []
        with torch.inference_mode():
            pixels = to_batch(tile.cut(image), side, side, IMAGENET).to(device)
            encoded = self.network.get_image_embeddings(pixels)
            for part in at.split(_BATCH):
                answer = self.network(
                    image_embeddings=encoded, input_boxes=part[None], multimask_output=False
                )
                found += enlarge(answer.pred_masks[0, :, 0], tile.size, 0.0)
        return found


def enlarge(
    logits: Float[Tensor, "n a b"], size: tuple[int, int], threshold: float
) -> list[Bool[np.ndarray, "h w"]]:
    """Resize maps to (width, height), and return the masks of values above a threshold."""
    from torch.nn import functional

    shape = size[::-1]
    maps = (functional.interpolate(m[None, None].float(), shape, mode="bilinear") for m in logits)
    return [(stretched[0, 0] > threshold).cpu().numpy() for stretched in maps]
