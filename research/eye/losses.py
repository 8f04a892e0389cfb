"""Training losses: one function per term, and their weighted sum."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import torch
from torch import Tensor
from torch.nn import functional

from generator.backends.embedded.eye.network import Eye, Maps

WEIGHTS: Mapping[str, float] = {
    "heat": 1.0, "box": 0.5, "mask": 2.0, "whole": 1.0, "quality": 1.0, "name": 0.6,
    "region": 1.0, "top": 1.0, "latitude": 4.0, "outline": 2.0,
}  # fmt: skip
_OUTLINED = 20  # objects per batch whose outlines are trained
_LARGE = 0.18  # minimum longer side of their boxes, relative to the picture's side
_ASKED, _JUDGED = 0.1, 64  # minimum certainty of evaluated cells, and their number per batch


@dataclass(frozen=True, eq=False)
class CropBatch:
    """Stacked crops; fields as in ``targets.Crop``, ``owner`` (k,) is the picture of each cell."""

    image: Tensor
    heat: Tensor
    weight: Tensor
    things: Tensor
    region: Tensor
    top: Tensor
    latitude: Tensor
    owner: Tensor
    cells: Tensor
    boxes: Tensor
    masks: Tensor
    looks: Tensor
    shown: Tensor
    hints: Tensor
    category: Tensor

    def to(self, device: str) -> CropBatch:
        """Return the batch on another device."""
        return CropBatch(**{name: value.to(device) for name, value in vars(self).items()})


def heat_loss(logits: Tensor, wished: Tensor, weight: Tensor) -> Tensor:
    """Quality focal loss (Li et al., "Generalized Focal Loss", NeurIPS 2020), per object."""
    certainty = logits.sigmoid()
    cross = functional.binary_cross_entropy_with_logits(logits, wished, reduction="none")
    things = (wished > 0.99).sum().clamp(min=1)
    return ((wished - certainty).abs().square() * cross * weight).sum() / things


def overlap_loss(logits: Tensor, wished: Tensor) -> Tensor:
    """Cross entropy plus one minus the Dice overlap, per mask (k, h, w)."""
    cross = functional.binary_cross_entropy_with_logits(logits, wished, reduction="none")
    inside, area = logits.sigmoid(), wished.sum((1, 2))
    size = (logits.shape[1] * logits.shape[2]) ** 0.5
    cross = cross.sum((1, 2)) / (area + size)
    both = (inside * wished).sum((1, 2))
    dice = 1 - (2 * both + 1) / (inside.square().sum((1, 2)) + area + 1)
    return (dice + 0.3 * cross).mean()


def terms(eye: Eye, batch: CropBatch) -> dict[str, Tensor]:
    """Return all terms for a batch; their names are the keys of ``WEIGHTS``."""
    maps = eye(batch.image)
    wished_top = batch.top.float()[:, None]
    found = {
        "heat": heat_loss(maps.heat[:, 0].float(), batch.heat, batch.weight),
        "region": functional.cross_entropy(maps.region.float(), batch.region.long()),
        "top": overlap_loss(maps.top[:, 0].float(), wished_top[:, 0]),
        "latitude": (maps.latitude[:, 0].float() - batch.latitude).abs().mean(),
    }
    found["quality"] = _quality_loss(eye, maps, batch)
    found["name"] = _name_loss(eye, batch) if len(batch.looks) else maps.box.sum() * 0
    if not len(batch.cells):
        zero = maps.box.sum() * 0
        return found | {"box": zero, "mask": zero, "whole": zero, "outline": zero}
    column, row = batch.cells[:, 0], batch.cells[:, 1]
    box = maps.box[batch.owner, :, row, column].float()
    found["box"] = functional.smooth_l1_loss(box, batch.boxes.log(), beta=0.2)
    size = (batch.boxes[:, :2] + batch.boxes[:, 2:4]).amax(1)
    drawn = eye.masks(maps, batch.owner, batch.cells, size)
    wished = batch.masks.float()
    fine = functional.interpolate(drawn.float(), size=wished.shape[2:], mode="bilinear")
    found["mask"] = overlap_loss(fine[:, 0], wished[:, 0])
    found["whole"] = overlap_loss(fine[:, 1], wished[:, 1])
    found["outline"] = _outline_loss(eye, maps, batch, drawn[:, 0].detach().float(), size)
    return found


def outline_terms(eye: Eye, batch: CropBatch) -> dict[str, Tensor]:
    """Return only the outliner's term, for training the outliner alone."""
    with torch.no_grad():
        maps = eye(batch.image)
        size = (batch.boxes[:, :2] + batch.boxes[:, 2:4]).amax(1)
        drawn = eye.masks(maps, batch.owner, batch.cells, size)[:, 0].float()
    return {"outline": _outline_loss(eye, maps, batch, drawn, size)}


def _outline_loss(eye: Eye, maps: Maps, batch: CropBatch, drawn: Tensor, size: Tensor) -> Tensor:
    """Loss of the outlines of large objects, from the eye's own masks or roughened ones."""
    large = (size > _LARGE * drawn.shape[1]).nonzero()[:, 0]
    chosen = large[torch.randperm(len(large))[:_OUTLINED].to(large.device)]
    if not len(chosen):
        return maps.surface.sum() * 0
    wished = batch.masks[chosen, 0].float()
    rough = roughen(wished, drawn[chosen].sigmoid())
    logits = eye.outline(maps, batch.image, batch.owner[chosen], rough).float()
    return overlap_loss(logits, wished)


def roughen(wished: Tensor, drawn: Tensor) -> Tensor:
    """Return rough versions of masks (n, h, w): the eye's own, partial, or distorted ones.

    ``wished`` (n, 2h, 2w) are the true masks, ``drawn`` (n, h, w) the eye's. True ones are halved
    along a line, lose thin parts, or have their rim moved.
    """
    n = len(drawn)
    true = functional.avg_pool2d(wished[:, None], 2)
    kind = torch.rand(n, device=drawn.device)
    kernel = 1 + 2 * int(torch.randint(1, 5, ()))
    grown = functional.max_pool2d(true, kernel, 1, kernel // 2)
    shrunk = 1 - functional.max_pool2d(1 - true, kernel, 1, kernel // 2)
    opened = functional.max_pool2d(shrunk, kernel, 1, kernel // 2)
    part = true[:, 0] * _half_planes(true[:, 0])
    choices = [drawn, part, opened[:, 0], grown[:, 0], shrunk[:, 0]]
    rough = torch.zeros_like(drawn)
    for low, high, mask in zip((0, 0.45, 0.7, 0.82, 0.92), (0.45, 0.7, 0.82, 0.92, 1), choices,
                               strict=True):  # fmt: skip
        rough = torch.where(((kind >= low) & (kind < high))[:, None, None], mask, rough)
    empty = (rough > 0.5).sum((1, 2)) < 4
    return torch.where(empty[:, None, None], true[:, 0], rough)


def _half_planes(masks: Tensor) -> Tensor:
    """Return half planes (n, h, w) that cut masks into parts: a line near the middle of each."""
    n, height, width = masks.shape
    y = torch.arange(height, device=masks.device, dtype=masks.dtype)[None, :, None]
    x = torch.arange(width, device=masks.device, dtype=masks.dtype)[None, None, :]
    area = masks.sum((1, 2)).clamp(min=1)[:, None, None]
    middle = [(masks * axis).sum((1, 2), keepdim=True) / area for axis in (x, y)]
    spread = ((masks * ((x - middle[0]) ** 2 + (y - middle[1]) ** 2)).sum((1, 2), keepdim=True)
              / area).sqrt()  # fmt: skip
    turn = 2 * torch.pi * torch.rand(n, 1, 1, device=masks.device)
    shift = (torch.rand(n, 1, 1, device=masks.device) * 1.6 - 0.6) * spread
    along = (x - middle[0]) * turn.cos() + (y - middle[1]) * turn.sin()
    return (along < shift).to(masks.dtype)


def _quality_loss(eye: Eye, maps: Maps, batch: CropBatch) -> Tensor:
    """Loss of the estimated mask quality at likely cells, good and bad ones."""
    with torch.no_grad():
        asked = ((maps.heat[:, 0].sigmoid() > _ASKED) | (batch.heat > 0.5)) & (batch.weight > 0)
        owner, row, column = asked.nonzero(as_tuple=True)
        chosen = torch.randperm(len(owner))[:_JUDGED].to(owner.device)
        if not len(chosen):
            return maps.heat.sum() * 0
        owner, cells = owner[chosen], torch.stack([column, row], 1)[chosen]
        box = maps.box[owner, :, cells[:, 1], cells[:, 0]].float().exp()
        size = (box[:, :2] + box[:, 2:4]).amax(1)
        drawn = eye.masks(maps, owner, cells, size)[:, 0].float().sigmoid()
        overlap = best_overlap(drawn > 0.5, batch.things[owner])
    logits = eye.quality(maps, owner, cells, drawn).float()
    return functional.binary_cross_entropy_with_logits(logits, overlap)


def best_overlap(drawn: Tensor, things: Tensor) -> Tensor:
    """Return the maximum IoU of masks (n, h, w) with the objects of index maps (n, h, w)."""
    most = int(things.max())
    best = torch.zeros(len(drawn), device=drawn.device)
    for number in range(1, most + 1):
        thing = things == number
        either = (drawn | thing).sum((1, 2))
        best = torch.maximum(best, (drawn & thing).sum((1, 2)) / either.clamp(min=1))
    return best


def _name_loss(eye: Eye, batch: CropBatch) -> Tensor:
    looks = batch.looks.contiguous(memory_format=torch.channels_last)
    names = eye.names(looks, batch.shown, batch.hints)
    category = torch.where(batch.category < 0, names.shape[1] - 1, batch.category)
    return functional.cross_entropy(names.float(), category, label_smoothing=0.05)


def total(found: Mapping[str, Tensor]) -> Tensor:
    """Return the weighted sum of the terms."""
    return torch.stack([WEIGHTS[name] * value for name, value in found.items()]).sum()
