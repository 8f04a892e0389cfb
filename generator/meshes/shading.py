"""Removal of lighting from an object's colours: the shading is estimated and divided out.

A picture shows colour times light; a texture must contain colour alone, or the scene's light would
be applied on top of the picture's. Light is assumed constant over an object and smooth in the
surface normal: ``1 + up * (n_z - 1) + side * n_x + ahead * n_y``, which is 1 for surfaces that face
up. Since most light comes from above, this is the initial assumption. The picture's brightness
corrects it where one hue is visible with several normals.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

Rows = Float[np.ndarray, "t 3"]

_PRIOR = np.array([0.0, -0.04, 0.26])  # side, ahead, up: light from above, slightly from the front
_SPREAD = np.array([0.12, 0.12, 0.1])
_DARKEST = 0.5  # lower limit of the shading factor
_NOISE = 0.1  # typical variation of relative brightness for one hue and direction
_LEAST = 15  # minimum number of points for one hue and direction
_LEVELS = 24  # number of steps of a colour's fractions of red and of green


@dataclass(frozen=True, eq=False)
class Shading:
    """A surface's brightness as a function of its normal; ``slope`` is the gradient."""

    slope: Float[np.ndarray, "3"]

    def at(self, normal: Rows) -> Float[np.ndarray, "t"]:
        """Return the factor by which light scales the colours of a surface with these normals."""
        return np.clip(1.0 + (normal - [0.0, 0.0, 1.0]) @ self.slope, _DARKEST, 1.25)

    def remove(self, colors: Rows, normal: Rows) -> Rows:
        """Return the colours as they would appear under uniform light."""
        return np.minimum(colors / self.at(normal)[:, None], 255.0)


def estimate_shading(colors: Rows, normal: Rows, seen: Bool[np.ndarray, "t"]) -> Shading:
    """Estimate the shading that explains the brightness of the ``seen`` points' ``colors``.

    Points are grouped by hue and direction. The median brightness of each group is compared with
    that of other groups of the same hue, so that prints and patterns have little influence.
    """
    colors, normal = colors[seen], normal[seen]
    if len(colors) < 4 * _LEAST:
        return Shading(_PRIOR)
    hue, towards = _hues(colors), _directions(normal)
    brightness = np.log(np.maximum(colors.mean(1), 8.0))
    lines, values, weights = [], [], []
    for k in np.unique(hue):
        ways = np.unique(towards[hue == k])
        own = [np.flatnonzero((hue == k) & (towards == w)) for w in ways]
        own = [o for o in own if len(o) >= _LEAST]
        if len(own) < 2:
            continue
        share = np.array([len(o) for o in own]) / len(colors)
        level = np.array([np.median(brightness[o]) for o in own])
        facing = np.array([normal[o].mean(0) for o in own])
        part = share / share.sum()
        lines.append(facing - part @ facing)
        values.append(np.exp(level - part @ level) - 1.0)
        weights.append(share)
    if not lines:
        return Shading(_PRIOR)
    a, b, w = np.concatenate(lines), np.concatenate(values), np.concatenate(weights)
    # Brightness is relative to the mean of a hue, not to surfaces that face up: a damped fixed
    # point.
    mean = 1.0 - 0.5 * _PRIOR[2]
    a, w = a / mean, w / _NOISE**2
    prior = np.diag(1.0 / _SPREAD**2)
    slope = np.linalg.solve((a.T * w) @ a + prior / 3, (a.T * w) @ b + prior / 3 @ _PRIOR)
    return Shading(np.clip(slope, [-0.3, -0.3, 0.0], [0.3, 0.3, 0.42]))


def _hues(colors: Rows) -> Int[np.ndarray, "t"]:
    """Group colours by their fractions of red and green; nearly black colours form one group."""
    total = np.maximum(colors.sum(1), 30.0)
    share = np.minimum((colors[:, :2] / total[:, None] * _LEVELS).astype(int), _LEVELS - 1)
    dark = np.digitize(total / 3, [25.0])
    return (share[:, 0] * _LEVELS + share[:, 1]) * 2 + dark


def _directions(normal: Rows) -> Int[np.ndarray, "t"]:
    """Group directions by whether they are negative, near zero or positive along each axis."""
    thirds = np.digitize(normal, [-0.4, 0.4])
    return thirds @ np.array([9, 3, 1])
