"""Decoding of the detector's output cells into object confidences and masks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import UInt8
from torch import Tensor
from torch.nn import functional

from .network import STRIDE, Eye, Maps

FAINT = 0.1
"""Minimum confidence of decoded cells."""

_KEPT = 72  # maximum number of detections per crop, by confidence
_MOST = 200  # default number of decoded cells
_SAME = 0.6  # overlap (IoU) above which two masks of a crop show the same object


@dataclass(frozen=True, eq=False)
class Detections:
    """Detections in a crop by descending confidence: scores and mask probabilities (n, 2, h, w)."""

    score: Tensor
    masks: Tensor

    def __getitem__(self, kept: list[int]) -> Detections:
        return Detections(self.score[kept], self.masks[kept])


def tensor(*images: UInt8[np.ndarray, "h w 3"]) -> Tensor:
    """Return uint8 pictures of equal size as a batch (b, 3, h, w) in [0, 1]."""
    batch = torch.from_numpy(np.stack(images)).permute(0, 3, 1, 2).float() / 255
    return batch.contiguous(memory_format=torch.channels_last)


def ask(
    eye: Eye, maps: Maps, seen: tuple[int, ...], owner: int = 0, maximum: int = _MOST
) -> Detections:
    """Decode the most confident cells of crop ``owner``, at most ``maximum``, into detections."""
    heat = maps.heat[owner : owner + 1].sigmoid()
    peaks = heat * (functional.max_pool2d(heat, 3, 1, 1) == heat)
    peaks[..., -(-seen[0] // STRIDE) :, :] = 0
    peaks[..., -(-seen[1] // STRIDE) :] = 0
    score, place = peaks[0, 0].flatten().topk(min(maximum, peaks.numel()))
    place = place[score > FAINT]
    cells = torch.stack([place % heat.shape[3], place // heat.shape[3]], 1)
    detections = answers(eye, maps, torch.full((len(cells),), owner), cells)
    clash = overlaps(detections.masks[:, 0] > 0.5) > _SAME
    return detections[apart(detections.score, clash)[:_KEPT]]


def answers(eye: Eye, maps: Maps, owner: Tensor, cells: Tensor) -> Detections:
    """Decode cells; a confidence combines an object's presence with the quality of its mask."""
    box = maps.box[owner, :, cells[:, 1], cells[:, 0]].exp()
    masks = eye.masks(maps, owner, cells, (box[:, :2] + box[:, 2:4]).amax(1)).sigmoid()
    heat = maps.heat[owner, 0, cells[:, 1], cells[:, 0]].sigmoid()
    quality = eye.quality(maps, owner, cells, masks[:, 0]).sigmoid()
    shows = (masks[:, 0] > 0.5).sum((1, 2)) > 1
    return Detections(heat.sqrt() * quality * shows, masks)


def overlaps(masks: Tensor) -> Tensor:
    """Return the pairwise overlaps (IoU) of masks (n, h, w)."""
    flat = masks.flatten(1).float()
    area = flat.sum(1).clamp(min=1)[:, None]
    both = flat @ flat.T
    return both / (area + area.T - both)


def apart(score: Tensor, clash: Tensor) -> list[int]:
    """Return the indices of detections by confidence, omitting those that clash with a kept one."""
    kept: list[int] = []
    for k in score.argsort(descending=True).tolist():
        if score[k] > 0 and not clash[k, kept].any():
            kept.append(k)
    return kept
