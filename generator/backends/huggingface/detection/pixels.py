"""Preprocessing of pictures for the models: resizing and normalisation in torch.

It replicates the processors of transformers, which use Pillow; most of them need torchvision.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image

if TYPE_CHECKING:
    from torch import Tensor

IMAGENET = ((0.485, 0.456, 0.406), (0.229, 0.224, 0.225))
"""Mean and standard deviation of RGB for Grounding DINO, SAM 2 and DINOv2."""

HALVES = ((0.5, 0.5, 0.5), (0.5, 0.5, 0.5))
"""Mean and standard deviation of RGB for SAM 3."""

Norm = tuple[tuple[float, float, float], tuple[float, float, float]]


def normalise(images: Float[Tensor, "b 3 h w"], norm: Norm) -> Float[Tensor, "b 3 h w"]:
    """Normalise images in [0, 1] with a model's mean and deviation; differentiable."""
    mean, deviation = (images.new_tensor(v).view(1, 3, 1, 1) for v in norm)
    return (images - mean) / deviation


def to_batch(
    image: UInt8[np.ndarray, "h w 3"], width: int, height: int, norm: Norm
) -> Float[Tensor, "1 3 b a"]:
    """Return a picture resized to ``width`` x ``height`` and normalised, as a batch of one."""
    import torch

    small = Image.fromarray(image).resize((width, height), Image.Resampling.BILINEAR)
    pixels = torch.from_numpy(np.asarray(small, np.float32) / 255).permute(2, 0, 1)[None]
    return normalise(pixels, norm)


def bound_size(width: int, height: int, shorter: int, longer: int) -> tuple[int, int]:
    """Return a size of the same aspect ratio with the given shorter side, and a limited longer one.

    The rounding is that of Grounding DINO's processor.
    """
    low, high = sorted((width, height))
    near = longer * low / high if high / low * shorter > longer else float(shorter)
    close, far = round(near), int(near * high / low)
    return (far, close) if width >= height else (close, far)
