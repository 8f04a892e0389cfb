"""The built-in detector: a small network that finds the table, its objects, and the view.

Boxes come first and names second: every cell inside the visible middle of an object predicts the
whole object. A cell predicts its confidence, the boxes of the visible and of the whole object, and
the weights of its own tiny mask network (conditional convolutions: Tian et al., "Conditional
Convolutions for Instance Segmentation", ECCV 2020), which draws the visible and the whole mask from
shared mask features. The mask's quality is predicted from the features inside and around it. Names
come from the encoder alone, which processes a close-up of each object and pools the features under
its mask. The view is a map of each pixel's angle below the horizon (as in Jin et al., "Perspective
Fields", CVPR 2023), so that crops can be used for training.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import torch
from torch import Tensor, nn
from torch.nn import functional

from .lite0 import CHANNELS, SUMMARY, Lite0

STRIDE = 4
"""Picture pixels per cell of the dense maps."""

REGIONS = ("background", "top", "legs", "thing")
"""Class of each channel of ``Maps.region``; "legs" is the whole table except its top surface."""

CLOSEUP, CLOSE_ROOM = 128, 1.25
"""Size in pixels of the close-up for naming, and its width relative to the object's box."""

HINTS = 3
"""Number of additional inputs of the network that names objects; see :func:`hints`."""

IMPRESSION = SUMMARY + CHANNELS[2] + HINTS
"""Number of close-up features that are used to name an object."""

_WIDTH = 96
_OUTLINE = 48  # channels of the outliner
_MASK = 16  # channels of the mask features and of the intermediate layers
_LAYERS = ((_MASK + 2, _MASK), (_MASK, _MASK), (_MASK, 2))
_WEIGHTS = sum(i * o + o for i, o in _LAYERS)


@dataclass(frozen=True, eq=False)
class Maps:
    """The network's dense outputs for a batch, which are logits unless stated otherwise.

    ``heat`` (b, 1, h, w). ``box`` (b, 8, h, w): log distances in cells from the cell's centre to
    left, top, right and bottom of the visible box, then of the whole box. ``region`` (b, 4, h, w).
    ``top`` (b, 1, h, w): the whole top surface of the table, including the objects on it.
    ``latitude`` (b, 1, h/2, w/2): angle below the horizon in radians. ``mask`` and ``thing`` are
    the features for ``masks``, and ``surface`` those for ``outline``. h and w are the picture's
    size divided by ``STRIDE``.
    """

    heat: Tensor
    box: Tensor
    region: Tensor
    top: Tensor
    latitude: Tensor
    mask: Tensor
    thing: Tensor
    surface: Tensor


class _Separable(nn.Module):
    """A depthwise and a pointwise convolution, with a residual connection if the shapes match."""

    def __init__(self, inward: int, outward: int, kernel: int = 5) -> None:
        super().__init__()
        self.depthwise = nn.Conv2d(inward, inward, kernel, 1, kernel // 2, groups=inward)
        self.pointwise = nn.Conv2d(inward, outward, 1, bias=False)
        self.norm = nn.BatchNorm2d(outward, momentum=0.03)
        self.residual = inward == outward

    def forward(self, x: Tensor) -> Tensor:
        y = functional.relu(self.norm(self.pointwise(self.depthwise(x))))
        return x + y if self.residual else y


class Outliner(nn.Module):
    """A network that refines an object's outline, given the picture and a rough mask.

    The rough mask may show only a part of the object, or more than the object; the correct extent
    is learned, as in Sofiiuk et al., "Reviving Iterative Training with Mask Guidance for
    Interactive Segmentation", ICIP 2022. A small U-net processes the features and the mask at
    strides 4 to 16; the last step adds the picture itself at half its size.
    """

    def __init__(self, inward: int = _WIDTH) -> None:
        super().__init__()
        self.look = nn.Conv2d(inward, 32, 1)
        self.enter = nn.Conv2d(32 + 1, _OUTLINE, 3, 1, 1)
        self.near = _Separable(_OUTLINE, _OUTLINE)
        self.far = nn.Sequential(
            nn.MaxPool2d(2), _Separable(_OUTLINE, _OUTLINE), _Separable(_OUTLINE, _OUTLINE)
        )
        self.farther = nn.Sequential(
            nn.MaxPool2d(2), _Separable(_OUTLINE, _OUTLINE), _Separable(_OUTLINE, _OUTLINE)
        )
        self.join = nn.ModuleList(_Separable(_OUTLINE, _OUTLINE) for _ in range(2))
        self.few = nn.Conv2d(_OUTLINE, 12, 1)
        self.grain = nn.Conv2d(3, 12, 3, 1, 1)
        self.last = nn.Sequential(
            nn.Conv2d(12 + 12 + 1, 16, 3, 1, 1), nn.ReLU(),
            nn.Conv2d(16, 16, 3, 1, 1), nn.ReLU(), nn.Conv2d(16, 1, 1),
        )  # fmt: skip

    def forward(self, features: Tensor, images: Tensor, rough: Tensor) -> Tensor:
        """Return (n, 2h, 2w) logits of the refined masks.

        Args:
            features: (n, c, h, w) at ``STRIDE``.
            images: (n, 3, H, W) in [0, 1].
            rough: (n, h, w) probabilities.
        """
        prompt = 2 * rough[:, None].to(features.dtype) - 1
        near = self.near(functional.relu(self.enter(torch.cat([self.look(features), prompt], 1))))
        far = self.far(near)
        wide = self.farther(far)
        far = self.join[0](far + _resize(wide, far))
        near = self.join[1](near + _resize(far, near))
        size = 2 * near.shape[2], 2 * near.shape[3]
        half = functional.interpolate(images, size=size, mode="area")
        grain = self.grain(half - 0.5).relu()
        few = self.few(near)
        return self.last(torch.cat([_resize(few, half), grain, _resize(prompt, half)], 1))[:, 0]


def _resize(x: Tensor, like: Tensor) -> Tensor:
    return functional.interpolate(x, size=like.shape[2:], mode="bilinear")


class Eye(nn.Module):
    """The detection network; see the module docstring.

    ``categories`` is the number of names, including "unknown" (the last).
    """

    def __init__(self, categories: int) -> None:
        super().__init__()
        self.encoder = Lite0()
        self.lateral = nn.ModuleList(
            nn.Sequential(
                nn.Conv2d(c, _WIDTH, 1, bias=False), nn.BatchNorm2d(_WIDTH, momentum=0.03)
            )
            for c in CHANNELS
        )
        self.whole = nn.Linear(CHANNELS[-1], _WIDTH)
        self.merge = nn.ModuleList(_Separable(_WIDTH, _WIDTH) for _ in CHANNELS)
        self.things = nn.Sequential(_Separable(_WIDTH, _WIDTH), _Separable(_WIDTH, _WIDTH))
        self.surfaces = _Separable(_WIDTH, _WIDTH)
        self.shapes = nn.Sequential(_Separable(_WIDTH, _WIDTH), _Separable(_WIDTH, _WIDTH))
        self.level = _Separable(_WIDTH, _WIDTH)
        self.heat = nn.Conv2d(_WIDTH, 1, 1)
        self.box = nn.Conv2d(_WIDTH, 8, 1)
        self.region = nn.Conv2d(_WIDTH, len(REGIONS) + 1, 1)
        self.mask = nn.Conv2d(_WIDTH, _MASK, 1)
        self.latitude = nn.Conv2d(_WIDTH, 1, 1)
        self.controller = nn.Linear(_WIDTH, _WEIGHTS)
        self.judge = nn.Sequential(nn.Linear(3 * _WIDTH + 3, 64), nn.ReLU(), nn.Linear(64, 1))
        self.outliner = Outliner()
        nn.init.constant_(self.outliner.last[-1].bias, -3.0)  # type: ignore[arg-type]
        self.namer = nn.Sequential(nn.Dropout(0.15), nn.Linear(IMPRESSION, categories))
        for head in (self.heat, self.box, self.region, self.mask, self.latitude, self.controller):
            nn.init.normal_(head.weight, std=0.01)
        nn.init.constant_(self.heat.bias, -4.0)  # type: ignore[arg-type]
        nn.init.constant_(self.box.bias, 1.5)  # type: ignore[arg-type]
        nn.init.constant_(self.latitude.bias, 0.8)  # type: ignore[arg-type]

    def forward(self, images: Tensor) -> Maps:
        """Return the maps of (b, 3, h, w) pictures in [0, 1]; h and w are multiples of 32."""
        features = self.encoder(images)
        whole = self.whole(features[-1].mean((2, 3)).relu())[:, :, None, None]
        maps: list[Tensor] = []
        x = self.merge[3](self.lateral[3](features[3]) + whole)
        maps.append(x)
        for k in (2, 1, 0):
            lateral = self.lateral[k](features[k])
            up = functional.interpolate(x, size=lateral.shape[2:], mode="bilinear")
            x = self.merge[k](lateral + up)
            maps.append(x)
        thing, surface = self.things(x), self.surfaces(x)
        region = self.region(surface)
        return Maps(
            self.heat(thing),
            self.box(thing),
            region[:, :-1],
            region[:, -1:],
            self.latitude(self.level(maps[2])),
            self.mask(self.shapes(surface)),
            thing,
            surface,
        )

    def outline(self, maps: Maps, images: Tensor, image: Tensor, rough: Tensor) -> Tensor:
        """Return (n, 2h, 2w) logits of the visible masks of objects, given rough masks.

        Args:
            maps: of the batch.
            images: (b, 3, H, W), the batch.
            image: (n,) index of each object's picture.
            rough: (n, h, w) probabilities, at ``STRIDE``.
        """
        return self.outliner(maps.surface[image], images[image], rough)

    def masks(self, maps: Maps, image: Tensor, cells: Tensor, sizes: Tensor) -> Tensor:
        """Return (n, 2, h, w) logits of the visible and the whole mask of ``n`` cells.

        Args:
            maps: of the batch.
            image: (n,) index of each cell's picture.
            cells: (n, 2) column and row.
            sizes: (n,) longer side of each object's box in cells, the unit of the coordinates.
        """
        height, width = maps.mask.shape[2:]
        features = maps.thing[image, :, cells[:, 1], cells[:, 0]]
        weights = self.controller(features)
        column = torch.arange(width, device=cells.device)[None, None, :]
        row = torch.arange(height, device=cells.device)[None, :, None]
        unit = sizes.clamp(min=1.0)[:, None, None]
        x = ((column - cells[:, 0, None, None]) / unit).clamp(-3, 3).expand(-1, height, -1)
        y = ((row - cells[:, 1, None, None]) / unit).clamp(-3, 3).expand(-1, -1, width)
        z = torch.cat([maps.mask[image], torch.stack([x, y], 1).to(maps.mask.dtype)], 1)
        z = z.flatten(2)
        start = 0
        for k, (inward, outward) in enumerate(_LAYERS):
            end = start + inward * outward
            w = weights[:, start:end].reshape(-1, outward, inward)
            b = weights[:, end : end + outward, None]
            z = torch.baddbmm(b.to(z.dtype), w.to(z.dtype), z)
            z = functional.relu(z) if k + 1 < len(_LAYERS) else z
            start = end + outward
        return z.reshape(-1, 2, height, width)

    def quality(self, maps: Maps, image: Tensor, cells: Tensor, drawn: Tensor) -> Tensor:
        """Return (n,) logits of the overlap (IoU) of ``drawn`` with the true masks.

        As in Huang et al., "Mask Scoring R-CNN", CVPR 2019, but from pooled features. ``drawn`` (n,
        h, w) are probabilities of the visible masks of :meth:`masks`, which also documents the
        other arguments.
        """
        inside = (drawn > 0.5).to(drawn.dtype)
        around = functional.max_pool2d(inside[:, None], 7, 1, 3)[:, 0] - inside
        area = inside.sum((1, 2)).clamp(min=1)
        sure = (drawn * inside).sum((1, 2)) / area
        heat = maps.heat[image, 0, cells[:, 1], cells[:, 0]]
        inputs = torch.stack([area.log() / 3 - 1, 4 * sure - 3, heat / 3], 1).detach()
        point = maps.thing[image, :, cells[:, 1], cells[:, 0]]
        pooled = [_pool_by_picture(maps.thing, image, part) for part in (inside, around)]
        return self.judge(torch.cat([point, *pooled, inputs], 1))[:, 0]

    def names(self, closeups: Tensor, visible: Tensor, hints: Tensor) -> Tensor:
        """Return the (n, categories) logits of the names of the objects in close-ups.

        Args:
            closeups: (n, 3, s, s) in [0, 1], with the margin ``CLOSE_ROOM``.
            visible: (n, h, w) mask of the object in each, in [0, 1], at any resolution.
            hints: (n, HINTS), of :func:`hints`.
        """
        return self.namer(self.impression(closeups, visible, hints))

    def impression(self, closeups: Tensor, visible: Tensor, hints: Tensor) -> Tensor:
        """Return the naming features (n, ``IMPRESSION``); the arguments are as in :meth:`names`."""
        features = self.encoder(closeups)
        summary = _pool(self.encoder.summary(features[3]), visible)
        return torch.cat([summary, _pool(features[2], visible), hints], 1)


def hints(size: tuple[float, float], tabletop: float, picture: float) -> tuple[float, ...]:
    """Return properties that a close-up does not show: the aspect ratio and the size on the table.

    ``size`` is the width and height of the object's box. ``tabletop`` is the number of pixels that
    the tabletop covers, 0 if it is not visible; ``picture`` is the number of pixels of the whole
    picture.
    """
    wide, tall = (max(float(s), 1.0) for s in size)
    share = max(tabletop, 0.02 * picture)
    large = math.log(max(wide, tall) / math.sqrt(share))
    return (math.log(tall / wide), min(max(large, -4.0), 2.0) + 1.0, share / picture)


def _pool(features: Tensor, visible: Tensor) -> Tensor:
    """Return the mean (n, c) of features (n, c, h, w) under masks (n, h', w') in [0, 1]."""
    size = features.shape[2:]
    weight = functional.interpolate(visible[:, None].to(features.dtype), size=size, mode="area")
    weight = weight + 1e-3
    return (features * weight).sum((2, 3)) / weight.sum((2, 3))


def _pool_by_picture(features: Tensor, image: Tensor, masks: Tensor) -> Tensor:
    """Return means (n, c) of features (b, c, h, w) under masks (n, h, w), one picture per mask."""
    weight = masks.flatten(1).to(features.dtype)
    weight = weight / weight.sum(1, keepdim=True).clamp(min=1.0)
    pooled = features.new_zeros(len(image), features.shape[1])
    for picture in image.unique().tolist():
        own = image == picture
        pooled = pooled.index_put((own,), weight[own] @ features[picture].flatten(1).T)
    return pooled
