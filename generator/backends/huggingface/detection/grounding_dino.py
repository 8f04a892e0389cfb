"""Boxes from words: Grounding DINO (S. Liu et al., ECCV 2024)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import UInt8

from .detections import IMAGENET, BoxDetection, bound_size, to_batch
from .phrases import PhraseQuestion, best_words, questions
from .tiles import Tile

_LONGEST = 1333 / 800  # maximum ratio of the longer to the shorter side


@dataclass(frozen=True, eq=False)
class GroundingDino:
    """Grounding DINO's network and tokenizer, applied tile by tile.

    ``threshold`` is the minimum score of a detection, ``side`` the shorter side of a resized tile
    in pixels, and ``words`` the maximum number of words in one text.
    """

    network: Any
    tokenizer: Any
    threshold: float
    side: int
    words: int

    def find(
        self, image: UInt8[np.ndarray, "h w 3"], words: Sequence[str], tiles: Sequence[Tile]
    ) -> list[BoxDetection]:
        """Return the detections of ``words`` in each tile."""
        asked = questions(words, self.tokenizer, self.words, self.network.config.max_text_len)
        return [f for tile in tiles for question in asked for f in self._ask(image, tile, question)]

    def _ask(
        self, image: UInt8[np.ndarray, "h w 3"], tile: Tile, question: PhraseQuestion
    ) -> list[BoxDetection]:
        import torch

        size = bound_size(*tile.size, self.side, round(self.side * _LONGEST))
        device = self.network.device
        ids = torch.tensor([question.ids], device=device)
        with torch.inference_mode():
            answer = self.network(
                pixel_values=to_batch(tile.cut(image), *size, IMAGENET).to(device),
                input_ids=ids,
                token_type_ids=torch.zeros_like(ids),
                attention_mask=torch.ones_like(ids),
            )
        scores, best = best_words(answer.logits[0], question)
        middles, sides = np.split(answer.pred_boxes[0].double().cpu().numpy(), 2, axis=1)
        boxes = tile.to_picture(np.hstack([middles - sides / 2, middles + sides / 2]))
        kept = tile.told_by(boxes, scores, self.threshold)
        return [
            BoxDetection(question.words[best[k]], float(scores[k]), boxes[k])
            for k in np.flatnonzero(kept)
        ]
