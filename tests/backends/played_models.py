"""Grounding DINO, SAM 2 and SAM 3 simulated from the ground truth of a picture.

Their inputs and outputs are those of the classes of transformers; which part of the picture they
are shown is told from its pixels. What is checked is what the backend makes of right answers.
"""

from collections.abc import Mapping, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
import tiny_models
import torch
import transformers
from torch.nn import functional

from generator.backends.huggingface.detection.detections import HALVES, IMAGENET, Norm, to_batch
from generator.backends.huggingface.detection.grounding_dino import GroundingDino
from generator.backends.huggingface.detection.sam2 import Sam2
from generator.backends.huggingface.detection.sam3 import Sam3
from generator.backends.huggingface.detection.tiles import Tile, tiles_of
from generator.backends.huggingface.segmenter import HuggingFaceSegmenter
from generator.backends.requirements import Once
from generator.geometry import mask_box

SIDE = 96
"""Pixels a side that the players see."""

Truth = Sequence[tuple[str, np.ndarray]]
"""What the picture shows: words and masks; of a thing with two words, both."""


def tokenizer() -> transformers.PreTrainedTokenizerFast:
    return transformers.PreTrainedTokenizerFast(tokenizer_object=tiny_models.letters_tokenizer())


class Player:
    """Knows the ground truth, and identifies tiles by their pixels."""

    device = torch.device("cpu")

    def __init__(
        self, image: np.ndarray, truth: Truth, segmenter: HuggingFaceSegmenter, norm: Norm
    ) -> None:
        height, width = image.shape[:2]
        self.truth, self.norm, self.image = truth, norm, image
        self.tiles = tiles_of(width, height, segmenter.tiles, segmenter.overlap)
        self.looked: list[Tile] = []

    def tile(self, pixels: torch.Tensor) -> Tile:
        wide, high = pixels.shape[-1], pixels.shape[-2]
        for tile in self.tiles:
            if torch.equal(to_batch(tile.cut(self.image), wide, high, self.norm), pixels):
                self.looked.append(tile)
                return tile
        raise AssertionError("the picture shown is none of the tiles")

    def part(self, tile: Tile, mask: np.ndarray) -> np.ndarray:
        return mask[tile.y0 : tile.y1, tile.x0 : tile.x1]

    def there(self, tile: Tile) -> list[tuple[str, np.ndarray, np.ndarray]]:
        """Return words, boxes (shares of the tile's sides) and masks in a tile."""
        parts = [(word, self.part(tile, mask)) for word, mask in self.truth]
        size = [*tile.size, *tile.size]
        return [(word, mask_box(part) / size, part) for word, part in parts if part.any()]


class PlayedGroundingDino(Player):
    config = SimpleNamespace(max_text_len=64)

    def __call__(
        self, pixel_values: torch.Tensor, input_ids: torch.Tensor, **others: torch.Tensor
    ) -> Any:
        assert {k: v.tolist() for k, v in others.items()} == {
            "token_type_ids": [[0] * input_ids.shape[1]],
            "attention_mask": [[1] * input_ids.shape[1]],
        }
        tile = self.tile(pixel_values)
        ids = input_ids[0].tolist()
        logits, boxes = torch.full((40, 64), -6.0), torch.zeros(40, 4)
        for row, (word, box, _) in enumerate(self.there(tile)):
            spelt = tokenizer()(word, add_special_tokens=False)["input_ids"]
            wanted = [*spelt, tiny_models.MARKS["."]]
            for k in range(len(ids) - len(spelt)):
                if ids[k : k + len(wanted)] == wanted:
                    logits[row, k : k + len(spelt)] = 1.5 + 0.1 * (tile == self.tiles[0])
            x0, y0, x1, y1 = box
            boxes[row] = torch.tensor([(x0 + x1) / 2, (y0 + y1) / 2, x1 - x0, y1 - y0])
        return SimpleNamespace(logits=logits[None], pred_boxes=boxes[None])


class PlayedSam2(Player):
    config = SimpleNamespace(prompt_encoder_config=SimpleNamespace(image_size=SIDE))

    def get_image_embeddings(self, pixels: torch.Tensor) -> list[Tile]:
        return [self.tile(pixels)]

    def __call__(
        self, image_embeddings: list[Tile], input_boxes: torch.Tensor, multimask_output: bool
    ) -> Any:
        assert not multimask_output
        tile = image_embeddings[0]
        known = self.there(tile)
        masks = []
        for box in input_boxes[0].numpy() / SIDE:
            errors = [np.abs(box - right).max() for _, right, _ in known]
            assert min(errors) < 0.02, "no thing of the picture is in this box"
            masks.append(logits_of(known[int(np.argmin(errors))][2]))
        return SimpleNamespace(pred_masks=torch.stack(masks)[None, :, None])


class PlayedSam3(Player):
    config = SimpleNamespace(
        vision_config=SimpleNamespace(backbone_config=SimpleNamespace(image_size=SIDE))
    )

    def get_vision_features(self, pixels: torch.Tensor) -> Tile:
        return self.tile(pixels)

    def __call__(
        self, vision_embeds: Tile, input_ids: torch.Tensor, attention_mask: torch.Tensor
    ) -> Any:
        assert attention_mask.tolist() == [[1] * input_ids.shape[1]]
        known = self.there(vision_embeds)
        ids = input_ids[0].tolist()
        right = [tokenizer()(word)["input_ids"] == ids for word, _, _ in known]
        sure = right if any(right) else [True] * len(right)  # of nothing: "presence" says so
        return SimpleNamespace(
            pred_logits=torch.where(torch.tensor([sure]), 2.0, -6.0),
            presence_logits=torch.tensor([[3.0 if any(right) else -6.0]]),
            pred_boxes=torch.tensor(np.stack([box for _, box, _ in known]))[None].float(),
            pred_masks=torch.stack([logits_of(mask) for _, _, mask in known])[None],
        )


def logits_of(mask: np.ndarray) -> torch.Tensor:
    """Return a mask in the models' format: a map of SIDE x SIDE logits."""
    shown = torch.from_numpy(mask.astype(np.float32))[None, None]
    small = functional.interpolate(shown, (SIDE, SIDE), mode="bilinear", antialias=True)
    return 20 * (small[0, 0] - 0.5)


def play(segmenter: HuggingFaceSegmenter, image: np.ndarray, truth: Truth) -> Mapping[str, Player]:
    """Replace a segmenter's models by players; return them by "finder" and "masker"."""
    set_field = object.__setattr__
    if segmenter.detector == "sam3":
        three = PlayedSam3(image, truth, segmenter, HALVES)
        finder = Sam3(three, tokenizer(), segmenter.threshold)
        set_field(segmenter, "_finder", Once(lambda: finder))
        set_field(segmenter, "_masker", Once(lambda: finder))
        return {"finder": three, "masker": three}
    dino = PlayedGroundingDino(image, truth, segmenter, IMAGENET)
    sam = PlayedSam2(image, truth, segmenter, IMAGENET)
    asked = GroundingDino(dino, tokenizer(), segmenter.threshold, segmenter.side, segmenter.words)
    set_field(segmenter, "_finder", Once(lambda: asked))
    set_field(segmenter, "_masker", Once(lambda: Sam2(sam)))
    return {"finder": dino, "masker": sam}
