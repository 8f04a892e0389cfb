"""A small network that rates a grasp for each rotation of the hand and each position.

The height maps are rotated for each of the ``TURNS`` turns so that the fingers open along the first
axis, and all of them pass through the same convolutions. A grasp therefore looks the same in every
orientation of the object (after the rotated inputs of Zeng et al., Learning Synergies between
Pushing and Grasping, 2018).

The network runs on NumPy, so environments need no torch, can be forked and stepped from several
threads, and get bitwise identical results on any number of cores. ``model`` is its torch version
for training.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from jaxtyping import Float, Float32, UInt8

from .look import CELL, CELLS, STEP

TURNS = 12
"""Number of turns of the hand, over half a revolution."""

PLACES, PLACE = 24, 0.01
"""Number of places along a side of the rated grid, and the size of a place in metres."""

SEEN = 2 * PLACES
"""Number of input cells along a side, two per place."""

MIDDLES = ((np.arange(PLACES) - (PLACES - 1) / 2) * PLACE).astype(np.float32)
"""Centres of the places along an axis, relative to the object's centre, in metres."""

MIDDLES.setflags(write=False)


class Layer(NamedTuple):
    """The parameters of a convolution: its channels, kernel size, stride, padding and dilation."""

    inputs: int
    outputs: int
    side: int
    stride: int = 1
    padding: int = 0
    dilation: int = 1


LAYERS = (
    Layer(3, 16, 6, 2, 2),  # even: its kernel is centred on a place
    Layer(16, 32, 3, 1, 1),
    Layer(32, 32, 3, 1, 2, 2),
    Layer(32, 32, 3, 1, 4, 4),
    Layer(32, 32, 3, 1, 1),
    Layer(32, 7, 1),
)
"""The layers of the network, with a ReLU between them; see ``rate_output`` for the channels of the
last one."""

HEIGHT = 0.05  # input unit of height, metres
UNITS = (PLACE, PLACE, HEIGHT, 0.04, 0.02)
"""Metres per unit of network output for along, across, height, width and room of ``Rated``."""

DEEPEST = 2.0  # depths below the object's top are clipped to this, in units of HEIGHT


class Rated(NamedTuple):
    """Predictions for each rotation and position of the hand: two logits, and a grasp in metres.

    ``best`` is higher for better grasps, and ``possible`` is positive where a grasp is likely.
    ``along`` and ``across`` are the offsets of the midpoint between the fingers from the object's
    centre, along the opening direction and across it; ``height`` is the height of the tool above
    the table. ``width`` is the width between the closed fingers, and ``room`` the additional
    opening before the approach.
    """

    best: Any
    possible: Any
    along: Any
    across: Any
    height: Any
    width: Any
    room: Any


def rate_output(out: Any, middles: Any) -> Rated:
    """Convert the last layer's output (..., 7, i, j), an array or a tensor, to ratings."""
    best, possible, *answers = (out[..., k, :, :] for k in range(7))
    along, across, *rest = (part * unit for part, unit in zip(answers, UNITS, strict=True))
    return Rated(best, possible, middles[:, None] + along, middles + across, *rest)


def turn_views(
    heights: UInt8[np.ndarray, "2 64 64"], facing: float
) -> Float32[np.ndarray, "t 3 48 48"]:
    """Return the network input: the height maps at each rotation, starting at ``facing`` (radians).

    Channels: the height of the object, the height of everything else, and the object's depth below
    its top.
    """
    angles = facing + np.arange(TURNS)[:, None, None] * np.pi / TURNS
    axis = (np.arange(SEEN) - (SEEN - 1) / 2) * PLACE / 2
    u, v = axis[:, None], axis
    x, y = u * np.cos(angles) - v * np.sin(angles), u * np.sin(angles) + v * np.cos(angles)
    maps = np.pad(heights.astype(np.float32) * (STEP / HEIGHT), ((0, 0), (1, 1), (1, 1)))
    i, j = (np.clip(at / CELL + (CELLS + 1) / 2, 0, CELLS + 0.999) for at in (x, y))
    seen = _between(maps, i, j)
    below = np.maximum(seen[0] - maps[0].max(), -DEEPEST)
    return np.stack([seen[0], seen[1], 2 * below], 1).astype(np.float32)


def _between(
    maps: Float[np.ndarray, "m a b"], i: Float[np.ndarray, "*n"], j: Float[np.ndarray, "*n"]
) -> Float[np.ndarray, "m *n"]:
    """Return the values of ``maps`` at fractional cell indices, by bilinear interpolation."""
    low_i, low_j = i.astype(int), j.astype(int)
    di, dj = i - low_i, j - low_j
    upper = maps[:, low_i, low_j] * (1 - dj) + maps[:, low_i, low_j + 1] * dj
    lower = maps[:, low_i + 1, low_j] * (1 - dj) + maps[:, low_i + 1, low_j + 1] * dj
    return upper * (1 - di) + lower * di


def rate(
    weights: Mapping[str, Float32[np.ndarray, "..."]], seen: Float32[np.ndarray, "t 3 48 48"]
) -> Rated:
    """Return the grasp ratings for an object's rotated views ``seen``; see ``turn_views``.

    ``weights`` has the entries ``"0.weight"`` (out, in, side, side), ``"0.bias"`` and so on, per
    layer.
    """
    values = np.ascontiguousarray(np.moveaxis(seen, 1, -1))
    for k, layer in enumerate(LAYERS):
        values = _convolve(values, layer, weights[f"{k}.weight"], weights[f"{k}.bias"])
        if k < len(LAYERS) - 1:
            np.maximum(values, 0.0, out=values)
    return rate_output(np.moveaxis(values, -1, 1), MIDDLES)


def _convolve(
    values: Float32[np.ndarray, "t a b c"],
    layer: Layer,
    weight: Float32[np.ndarray, "o c s s"],
    bias: Float32[np.ndarray, "o"],
) -> Float32[np.ndarray, "t i j o"]:
    """Apply a convolution layer with matrix products small enough to keep BLAS single-threaded."""
    edge, gap, step = layer.padding, layer.dilation, layer.stride
    padded = np.pad(values, ((0, 0), (edge, edge), (edge, edge), (0, 0)))
    count = (padded.shape[1] - gap * (layer.side - 1) - 1) // step + 1
    out = np.broadcast_to(bias, (len(values), count, count, layer.outputs)).copy()
    for k in np.ndindex(layer.side, layer.side):
        i, j = (slice(gap * first, gap * first + step * count, step) for first in k)
        out += padded[:, i, j] @ np.ascontiguousarray(weight[:, :, *k].T)
    return out
