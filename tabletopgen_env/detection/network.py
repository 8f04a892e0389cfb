"""A small network that rates, for each turn of the hand and each place, closing the fingers there.

The height maps are turned so that the fingers open along the first axis, once for each of
``TURNS`` turns, and all go through the same convolutions: a grasp looks the same however the object
lies (the rotated inputs of Zeng et al., Learning Synergies between Pushing and Grasping, 2018).

It runs on NumPy, so that environments need no torch, may be forked and stepped by several threads,
and see the same bits on any number of cores; ``model`` has it in torch, for training.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from jaxtyping import Float, Float32, UInt8

from .look import CELL, CELLS, STEP

TURNS = 12
"""Turns of the hand that are looked at, over half a turn."""

PLACES, PLACE = 24, 0.01
"""Places along a side of what is rated, and their size, metres."""

SEEN = 2 * PLACES
"""Cells along a side of what the network looks at, two a place."""

MIDDLES = ((np.arange(PLACES) - (PLACES - 1) / 2) * PLACE).astype(np.float32)
"""Where the places' middles are along an axis, from the object's centre, metres."""

MIDDLES.setflags(write=False)


class Layer(NamedTuple):
    """A convolution: channels in and out, the kernel's side, stride, padding, dilation."""

    inputs: int
    outputs: int
    side: int
    stride: int = 1
    padding: int = 0
    dilation: int = 1


LAYERS = (
    Layer(3, 16, 6, 2, 2),  # even: its kernel is about a place's middle
    Layer(16, 32, 3, 1, 1),
    Layer(32, 32, 3, 1, 2, 2),
    Layer(32, 32, 3, 1, 4, 4),
    Layer(32, 32, 3, 1, 1),
    Layer(32, 7, 1),
)
"""The network, a rectifier between each two. What its last channels mean: ``rate_output``."""

HEIGHT = 0.05  # metres that are 1 to the network
UNITS = (PLACE, PLACE, HEIGHT, 0.04, 0.02)
"""Metres that are 1 in its answers: along, across, height, width and room of ``Rated``."""

DEEPEST = 2.0  # of these heights below the object's top that are told apart


class Rated(NamedTuple):
    """Logits and grasps, each by turn and place (metres, the hand's frame).

    ``best`` is higher where a grasp is better, ``possible`` is positive where there is likely one.
    ``along`` the opening and ``across`` it are where the middle between the fingers is, from the
    object's centre; ``height`` is the tool's above the table. ``room`` is how much further than
    ``width``, what is between them, the fingers open.
    """

    best: Any
    possible: Any
    along: Any
    across: Any
    height: Any
    width: Any
    room: Any


def rate_output(out: Any, middles: Any) -> Rated:
    """Return what the network's last layer (..., 7, i, j) says; of arrays or of tensors."""
    best, possible, *answers = (out[..., k, :, :] for k in range(7))
    along, across, *rest = (part * unit for part, unit in zip(answers, UNITS, strict=True))
    return Rated(best, possible, middles[:, None] + along, middles + across, *rest)


def turn_views(
    heights: UInt8[np.ndarray, "2 64 64"], facing: float
) -> Float32[np.ndarray, "t 3 48 48"]:
    """Return height maps as the network sees them, at turns from ``facing`` (radians) on.

    Channels: the object's height, that of all else, and how far the object is below its top.
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
    """Return the values of maps at fractional cells, bilinear."""
    low_i, low_j = i.astype(int), j.astype(int)
    di, dj = i - low_i, j - low_j
    upper = maps[:, low_i, low_j] * (1 - dj) + maps[:, low_i, low_j + 1] * dj
    lower = maps[:, low_i + 1, low_j] * (1 - dj) + maps[:, low_i + 1, low_j + 1] * dj
    return upper * (1 - di) + lower * di


def rate(
    weights: Mapping[str, Float32[np.ndarray, "..."]], seen: Float32[np.ndarray, "t 3 48 48"]
) -> Rated:
    """Return the ratings of an object seen at every turn, as ``turn_views`` gives it.

    Weights are of each layer, ``"0.weight"`` (out, in, side, side), ``"0.bias"`` and so on.
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
    """Convolve, a line of the output at a time: products so small that BLAS wakes no threads."""
    edge, gap, step = layer.padding, layer.dilation, layer.stride
    padded = np.pad(values, ((0, 0), (edge, edge), (edge, edge), (0, 0)))
    count = (padded.shape[1] - gap * (layer.side - 1) - 1) // step + 1
    out = np.broadcast_to(bias, (len(values), count, count, layer.outputs)).copy()
    for k in np.ndindex(layer.side, layer.side):
        i, j = (slice(gap * first, gap * first + step * count, step) for first in k)
        out += padded[:, i, j] @ np.ascontiguousarray(weight[:, :, *k].T)
    return out
