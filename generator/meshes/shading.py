"""Take the light out of an object's colours: estimate its shading, divide by it.

A picture shows colour times light; a texture must hold colour alone, or the next light falls on
top of the first. Light is taken to be the same all over one object and smooth in the surface's
direction: ``1 + up * (n_z - 1) + side * n_x + ahead * n_y``, which is 1 for what faces up. Most
light comes from above, so that is the prior; the picture's own brightness corrects it wherever
one hue is seen from several directions.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

Rows = Float[np.ndarray, "t 3"]

_PRIOR = np.array([0.0, -0.04, 0.26])  # side, ahead, up: from above and a little from the front
_SPREAD = np.array([0.12, 0.12, 0.1])
_DARKEST = 0.5  # shading is not taken to be deeper than that
_NOISE = 0.1  # relative brightness by which places of one hue and direction differ anyway
_LEAST = 15  # points of one hue and direction that say something
_LEVELS = 24  # of a colour's share of red, and of green


@dataclass(frozen=True, eq=False)
class Shading:
    """How bright a surface looks by its direction; ``slope`` is the share per unit of n."""

    slope: Float[np.ndarray, "3"]

    def at(self, normal: Rows) -> Float[np.ndarray, "t"]:
        """Return the factor that light puts on the colours of a surface with these normals."""
        return np.clip(1.0 + (normal - [0.0, 0.0, 1.0]) @ self.slope, _DARKEST, 1.25)

    def remove(self, colors: Rows, normal: Rows) -> Rows:
        """Return colours as an even light from above would show them."""
        return np.minimum(colors / self.at(normal)[:, None], 255.0)


def estimate_shading(colors: Rows, normal: Rows, seen: Bool[np.ndarray, "t"]) -> Shading:
    """Return the shading that explains the brightness of the ``seen`` points' ``colors``.

    Points are gathered by hue and direction; the middle brightness of each gathering is compared
    with that of the others of its hue, so that prints and patterns count for little.
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
    # Brightness is relative to a hue's mean, not to what faces up: one shrinking factor between.
    mean = 1.0 - 0.5 * _PRIOR[2]
    a, w = a / mean, w / _NOISE**2
    prior = np.diag(1.0 / _SPREAD**2)
    slope = np.linalg.solve((a.T * w) @ a + prior / 3, (a.T * w) @ b + prior / 3 @ _PRIOR)
    return Shading(np.clip(slope, [-0.3, -0.3, 0.0], [0.3, 0.3, 0.42]))


def _hues(colors: Rows) -> Int[np.ndarray, "t"]:
    """Number colours by their shares of red and green; what is nearly black is apart."""
    total = np.maximum(colors.sum(1), 30.0)
    share = np.minimum((colors[:, :2] / total[:, None] * _LEVELS).astype(int), _LEVELS - 1)
    dark = np.digitize(total / 3, [25.0])
    return (share[:, 0] * _LEVELS + share[:, 1]) * 2 + dark


def _directions(normal: Rows) -> Int[np.ndarray, "t"]:
    """Number directions: each axis negative, near zero, or positive."""
    thirds = np.digitize(normal, [-0.4, 0.4])
    return thirds @ np.array([9, 3, 1])
