"""Inputs of the naming network: a close-up of an object, a mask of the object, and hints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8
from torch import Tensor

from ....geometry import mask_box
from .detections import tensor
from .frames import Frame
from .network import CLOSE_ROOM, CLOSEUP, Eye, hints

CELL = 4
"""Pixels of the close-up per cell of ``Closeup.visible``."""

_LEAST = 12.0  # minimum size of a close-up in pixels of the picture


@dataclass(frozen=True, eq=False)
class Closeup:
    """A close-up of one object, its ``visible`` mask in [0, 1], and its ``network.hints``."""

    image: UInt8[np.ndarray, "s s 3"]
    visible: Float[np.ndarray, "c c"]
    hints: tuple[float, ...]


def closeup(
    image: UInt8[np.ndarray, "h w 3"],
    mask: Bool[np.ndarray, "h w"],
    tabletop: float,
    slip: Float[np.ndarray, "4"] | None = None,
) -> Closeup:
    """Return the close-up of the object under ``mask``, or the whole picture if the mask is empty.

    ``tabletop`` is the number of pixels that the tabletop covers. ``slip`` moves the sides of the
    object's box (left, top, right, bottom) outwards, in fractions of its longer side; training
    varies it.
    """
    low, high = mask_box(mask if mask.any() else np.ones_like(mask)).reshape(2, 2)
    wide, tall = high - low
    clues = hints((float(wide), float(tall)), tabletop, mask.size)
    if slip is not None:
        longer = float(max(wide, tall))
        low, high = low - slip[:2] * longer, high + slip[2:] * longer
    frame = Frame.around(low, high, CLOSEUP, CLOSE_ROOM, _LEAST)
    visible = frame.carry(mask.astype(np.float32), 1.0, 1, CELL)
    return Closeup(frame.cut(image), visible, clues)


def impressions(eye: Eye, looks: Sequence[Closeup]) -> Float[Tensor, "2 n f"]:
    """Return the naming network's features of the original and of the mirrored close-ups."""
    pictures = tensor(*[look.image for look in looks])
    visible = torch.from_numpy(np.stack([look.visible for look in looks]))
    clues = torch.tensor([look.hints for look in looks])
    return torch.stack(
        [
            eye.impression(pictures, visible, clues),
            eye.impression(pictures.flip(3), visible.flip(2), clues),
        ]
    )
