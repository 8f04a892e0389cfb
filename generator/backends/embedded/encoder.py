"""Image features without learned weights: colour, and oriented edges at several scales."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from jaxtyping import Float

if TYPE_CHECKING:
    from torch import Tensor


@dataclass(frozen=True)
class EmbeddedEncoder:
    """A fixed filter bank that computes the features Phi of Eq. 4.

    At each scale (stride 2, 4 and 8), a map has two chroma channels and the derivatives of
    luminance along ``orientations`` directions. The channels of each position are divided by their
    norm, softened by ``floor``, so that brightness and contrast have no effect and flat grey
    regions stay near zero. The maps are spatial; nothing is pooled.

    Attributes:
        scales: number of maps; their strides are 2, 4, 8, ...
        orientations: directions of the derivative filters over half a turn.
        chroma: weight of the colour channels relative to the edges.
        floor: norm below which a position counts as featureless.
    """

    scales: int = 3
    orientations: int = 4
    chroma: float = 1.0
    floor: float = 0.15

    def features(self, images: Tensor) -> tuple[Tensor, ...]:
        """Map (b, 3, h, w) images in [0, 1] to (b, 2 + orientations, h/s, w/s) maps at scales s.

        The result is differentiable in ``images``; the norm of every position's channels is below
        1.
        """
        from torch.nn import functional

        level, maps = _opponent(images), []
        for _ in range(self.scales):
            level = functional.avg_pool2d(level, 2, ceil_mode=True)
            maps.append(self._describe(level))
        return tuple(maps)

    def _describe(self, level: Float[Tensor, "b 3 h w"]) -> Float[Tensor, "b c h w"]:
        """Convert one scale's luminance and chroma to normalised feature channels."""
        import torch
        from torch.nn import functional

        from ...render.soft import sobel

        x, y = sobel(functional.pad(level[:, :1], (1, 1, 1, 1), mode="replicate")[:, 0])
        angles = torch.arange(self.orientations) * (torch.pi / self.orientations)
        gain = 2 * (2 / self.orientations) ** 0.5
        edges = [gain * (float(a.cos()) * x + float(a.sin()) * y) for a in angles]
        channels = torch.cat([self.chroma * level[:, 1:], torch.stack(edges, 1)], 1)
        length = (channels.square().sum(1, keepdim=True) + self.floor**2).sqrt()
        return channels / length


def _opponent(images: Float[Tensor, "b 3 h w"]) -> Float[Tensor, "b 3 h w"]:
    """Convert RGB to luminance and two chroma channels that are invariant to brightness."""
    import torch

    r, g, b = images.unbind(1)
    light = (r + g + b) / 3
    strength = light + 0.1
    return torch.stack([light, (r - g) / strength, (r + g - 2 * b) / (2 * strength)], 1)
