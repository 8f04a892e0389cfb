"""Stacking: a body is lowered onto the real surface of what is below it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from ..geometry import rotation_z
from ..scene import Model, Placement

_GRID = 15


def placed_triangles(model: Model, placement: Placement) -> Float[np.ndarray, "m 3 3"]:
    """Return the model's triangles in the world frame."""
    points = model.mesh.vertices * placement.scale @ rotation_z(placement.yaw).T
    return (points + placement.translation)[model.mesh.faces]


def surface(
    corners: Float[np.ndarray, "m 3 3"], points: Float[np.ndarray, "p 2"], *, upper: bool
) -> Float[np.ndarray, "p"]:
    """Return the highest (or lowest) z of the triangles at each point; -inf (inf) where none is."""
    none = -np.inf if upper else np.inf
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    low, high = points.min(0), points.max(0)
    flat = corners[..., :2]
    near = (flat.max(1) >= low).all(1) & (flat.min(1) <= high).all(1) & (np.abs(area) > 1e-12)
    a, b, c, area = a[near], b[near], c[near], area[near]
    x, y = points[:, :1], points[:, 1:]
    w0 = ((b[:, 0] - x) * (c[:, 1] - y) - (b[:, 1] - y) * (c[:, 0] - x)) / area
    w1 = ((c[:, 0] - x) * (a[:, 1] - y) - (c[:, 1] - y) * (a[:, 0] - x)) / area
    w2 = 1 - w0 - w1
    inside = (w0 >= -1e-9) & (w1 >= -1e-9) & (w2 >= -1e-9)
    z = np.where(inside, w0 * a[:, 2] + w1 * b[:, 2] + w2 * c[:, 2], none)
    if not z.shape[1]:
        return np.full(len(points), none)
    return z.max(1) if upper else z.min(1)


def lower(
    model: Model, placement: Placement, below: Sequence[Float[np.ndarray, "_m 3 3"]]
) -> Placement:
    """Return the placement lowered (or raised) until the model touches what is below it.

    Where nothing is below, the height is kept. Surfaces are compared on a grid of points under
    the model, so contact is met to within a fraction of a millimetre for smooth shapes.
    """
    own = placed_triangles(model, placement)
    low, high = own[..., :2].min((0, 1)), own[..., :2].max((0, 1))
    steps = (np.arange(_GRID) + 0.5) / _GRID
    grid = np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2) * (high - low) + low
    bottom = surface(own, grid, upper=False)
    top = np.max([surface(other, grid, upper=True) for other in below], axis=0)
    both = np.isfinite(bottom) & np.isfinite(top)
    if not both.any():
        return placement
    lift = float((top[both] - bottom[both]).max())
    return Placement(
        placement.name,
        placement.yaw,
        placement.translation + np.array([0.0, 0.0, lift]),
        placement.scale,
        placement.on,
        placement.inside,
    )
