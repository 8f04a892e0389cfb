"""Quantisation of depth to 12 bits, with finer steps near the camera.

``q = 4095 (ln(d + s) - ln(a + s)) / (ln(b + s) - ln(a + s))`` for a depth of ``d`` metres from ``a
= 0.01`` to ``b = 10`` with ``s = 3.5``, which are LeRobot's values. A step of ``q`` is 1.2 mm at
0.1 m, 1.5 mm at 1 m and 4.4 mm at 10 m.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from jaxtyping import Float32, UInt16

DEPTH_MIN, DEPTH_MAX, DEPTH_SHIFT = 0.01, 10.0, 3.5
"""Depths of the smallest and the largest number, and the offset inside the logarithm, in metres."""

_LARGEST = 4095
_LOW = math.log(DEPTH_MIN + DEPTH_SHIFT)
_RANGE = math.log(DEPTH_MAX + DEPTH_SHIFT) - _LOW

DEPTH_INFO: Mapping[str, object] = MappingProxyType(
    {
        "video.depth_min": DEPTH_MIN,
        "video.depth_max": DEPTH_MAX,
        "video.shift": DEPTH_SHIFT,
        "video.use_log": True,
        "depth_unit": "m",
    }
)
"""The quantisation parameters as stored in a dataset."""


def quantize(depth: Float32[np.ndarray, "*t h w"]) -> UInt16[np.ndarray, "*t h w"]:
    """Quantise depth in metres to 12 bits; values out of range are clipped."""
    seen = np.clip(depth, DEPTH_MIN, DEPTH_MAX)
    share = (np.log(seen + np.float32(DEPTH_SHIFT)) - np.float32(_LOW)) / np.float32(_RANGE)
    return np.rint(share * _LARGEST).astype(np.uint16)


def restore(numbers: UInt16[np.ndarray, "*t h w"]) -> Float32[np.ndarray, "*t h w"]:
    """Convert 12-bit numbers back to depth in metres."""
    share = numbers.astype(np.float32) / _LARGEST
    return np.exp(share * np.float32(_RANGE) + np.float32(_LOW)) - np.float32(DEPTH_SHIFT)
