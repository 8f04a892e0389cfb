"""Boxes and masks from words with a single model: SAM 3 (2025)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import UInt8

from .detections import HALVES, BoxDetection, to_batch
from .phrases import plain
from .sam2 import enlarge
from .tiles import Tile

_TOKENS = 32  # maximum phrase length in SAM 3's training


@dataclass(frozen=True, eq=False)
class Sam3:
    """SAM 3's network and tokenizer, applied to one word and one tile at a time.

    ``threshold`` is the minimum score of a detection.
    """

    network: Any
    tokenizer: Any
    threshold: float

    def find(
        self, image: UInt8[np.ndarray, "h w 3"], words: Sequence[str], tiles: Sequence[Tile]
    ) -> list[BoxDetection]:
        """Return the detections of ``words`` in each tile, with masks."""
        import torch

        found: list[BoxDetection] = []
        with torch.inference_mode():
            for tile in tiles:
                side = int(self.network.config.vision_config.backbone_config.image_size)
                pixels = to_batch(tile.cut(image), side, side, HALVES).to(self.network.device)
                encoded = self.network.get_vision_features(pixels)
                for word in words:
                    found += self._ask(encoded, tile, word)
        return found

    def mask(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        detections: Sequence[BoxDetection],
        tiles: Sequence[Tile],
    ) -> list[BoxDetection]:
        """Return the detections with non-empty masks, which ``find`` has already computed."""
        return [detection for detection in detections if detection.mask.any()]

    def _ask(self, encoded: Any, tile: Tile, word: str) -> list[BoxDetection]:
        import torch

        coded = self.tokenizer(plain(word))["input_ids"]
        kept = coded if len(coded) <= _TOKENS else [*coded[: _TOKENS - 1], coded[-1]]
        ids = torch.tensor([kept], device=self.network.device)
        answer = self.network(
            vision_embeds=encoded, input_ids=ids, attention_mask=torch.ones_like(ids)
        )
        there = answer.presence_logits[0].float().sigmoid()
        scores = (answer.pred_logits[0].float().sigmoid() * there).cpu().numpy().astype(float)
        boxes = tile.to_picture(answer.pred_boxes[0].double().cpu().numpy())
        rows = np.flatnonzero(tile.told_by(boxes, scores, self.threshold))
        masks = enlarge(answer.pred_masks[0][rows].sigmoid(), tile.size, 0.5)
        return [
            BoxDetection(word, float(scores[k]), boxes[k], tile.whole(mask))
            for k, mask in zip(rows, masks, strict=True)
        ]
