"""Refinement of object outlines in close-ups; those of partly detected objects are extended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8

from ....geometry import mask_box
from .detections import tensor
from .frames import Frame
from .judge import EyeDetection
from .network import STRIDE, Eye

_LOOK = 256  # crop size in pixels
_ROOM = 2.0  # crop size relative to the longer side of the mask's box
_LEAST = 32.0  # minimum size of a crop in picture pixels
_BATCH = 8  # crops per batch
_LOOKS = 2  # the second pass is for objects that the first one enlarged
_GREW = 1.12  # growth in length that triggers a second pass
_STABLE = 0.75  # minimum overlap of the outlines at the two thresholds
_CERTAINTIES = 0.3, 0.7


def outline_things(
    eye: Eye, image: UInt8[np.ndarray, "h w 3"], detections: Sequence[EyeDetection]
) -> list[EyeDetection]:
    """Return the detections with refined visible masks; unstable outlines are not used."""
    found = list(detections)
    open_ = list(range(len(found)))
    for _ in range(_LOOKS):
        drawn = {}
        for first in range(0, len(open_), _BATCH):
            some = open_[first : first + _BATCH]
            masks = draw_outlines(eye, image, [found[k].visible for k in some])
            drawn |= dict(zip(some, masks, strict=True))
        again = []
        for k, mask in drawn.items():
            if mask is None:
                continue
            if _length(mask) > _GREW * _length(found[k].visible):
                again.append(k)
            found[k] = replace(found[k], visible=mask, whole=found[k].whole | mask)
        open_ = again
    return found


def draw_outlines(
    eye: Eye, image: UInt8[np.ndarray, "h w 3"], rough: Sequence[Bool[np.ndarray, "h w"]]
) -> list[Bool[np.ndarray, "h w"] | None]:
    """Return refined outlines of rough masks, or None where an outline is unstable."""
    frames = [_frame(mask) for mask in rough]
    images = tensor(*[frame.cut(image) for frame in frames])
    prompts = np.stack(
        [f.carry(m.astype(np.float32), 1.0, 1, STRIDE) for f, m in zip(frames, rough, strict=True)]
    )
    maps = eye(images)
    logits = eye.outline(maps, images, torch.arange(len(frames)), torch.from_numpy(prompts))
    looks = torch.nn.functional.interpolate(
        logits[:, None].sigmoid(), size=(_LOOK, _LOOK), mode="bilinear"
    )[:, 0].numpy()
    return [
        frame.spread(look[None], image.shape[:2])[0] if _stable(look) else None
        for frame, look in zip(frames, looks, strict=True)
    ]


def _frame(mask: Bool[np.ndarray, "h w"]) -> Frame:
    low, high = mask_box(mask).reshape(2, 2)
    return Frame.around(low, high, _LOOK, _ROOM, _LEAST)


def _length(mask: Bool[np.ndarray, "h w"]) -> float:
    return float(np.ptp(mask_box(mask).reshape(2, 2), axis=0).max())


def _stable(look: Float[np.ndarray, "s s"]) -> bool:
    """Return whether an outline hardly depends on the threshold applied to the mask."""
    wide, narrow = (float((look > c).sum()) for c in _CERTAINTIES)
    return narrow > 12 and narrow / wide >= _STABLE
