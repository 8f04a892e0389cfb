"""Relighting of soft renders with the light of a picture, which makes the two comparable.

A lamp shades a surface according to its orientation; a linear function of the normal approximates
this well. Its four coefficients and one gain per colour channel are fitted to the picture where the
render and the picture's mask overlap. Since they are fitted to thousands of pixels, they cannot
reproduce texture that the render lacks.
"""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

from ..errors import InputError
from .soft import SoftImages

_RIDGE = 0.02  # regularisation towards uniform light, as a fraction of the pixels' weight
_SHADE = (0.3, 2.0)  # minimum and maximum of the fitted light
_GAIN = (0.75, 1.3333)  # range of each colour channel's gain relative to the others
_TINY = 1e-6


def relit(
    images: SoftImages, picture: Float[Tensor, "b 3 h w"], weight: Float[Tensor, "b h w"]
) -> Float[Tensor, "b 3 h w"]:
    """Return renders (on grey, with normals), relit with the light of their target pictures.

    ``picture`` has the same grey background. ``weight`` is the weight of each of its pixels in the
    fit: at least 0, and 0 outside the mask. The light is fitted without gradients, so gradients of
    the returned images treat it as constant.

    Raises:
        InputError: The renders have no normals.
    """
    if images.normal is None:
        raise InputError("relit needs renders with normals: pass normals=True to soft.render.")
    cover = images.silhouette[:, None]
    own = images.image - 0.5 * (1 - cover)
    with torch.no_grad():
        counted = (weight * images.silhouette.square())[:, None]
        grey, target = own.mean(1, keepdim=True), picture.mean(1, keepdim=True)
        terms = torch.cat([grey, grey * images.normal], 1)
        light = _fit(terms, target, counted)
        shade = light[:, :, None, None] * torch.cat([torch.ones_like(grey), images.normal], 1)
        shade = shade.sum(1, keepdim=True).clamp(*_SHADE)
        lit = own * shade
        both = (counted * lit * picture).sum((-2, -1), keepdim=True)
        gain = both / ((counted * lit.square()).sum((-2, -1), keepdim=True) + _TINY)
        gain = torch.where(both.sum(1, keepdim=True) > _TINY, gain, 1.0)
        gain = (gain / gain.mean(1, keepdim=True).clamp_min(_TINY)).clamp(*_GAIN)
    return own * (shade * gain) + 0.5 * (1 - cover)


def _fit(
    terms: Float[Tensor, "b 4 h w"],
    target: Float[Tensor, "b 1 h w"],
    counted: Float[Tensor, "b 1 h w"],
) -> Float[Tensor, "b 4"]:
    """Return the least-squares coefficients of ``terms``, regularised towards uniform light."""
    weighted = counted * terms  # summed term by term: a matrix product's order depends on memory
    rows = [(weighted[:, k : k + 1] * terms).sum((-2, -1)) for k in range(4)]
    moments = torch.stack(rows, 1).double()
    sums = (weighted * target).sum((-2, -1)).double()
    weighted_any = moments[:, 0, 0] > _TINY
    even = torch.where(weighted_any, sums[:, 0] / (moments[:, 0, 0] + _TINY), 1.0)
    ridge = _RIDGE * moments[:, 0, 0] + _TINY
    start = torch.zeros_like(sums)
    start[:, 0] = even
    matrix = moments + ridge[:, None, None] * torch.eye(4, dtype=moments.dtype, device=sums.device)
    return torch.linalg.solve(matrix, sums + ridge[:, None] * start).to(target.dtype)
