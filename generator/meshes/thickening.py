"""Sheets of a foreign mesh, too thin to be simulated, given a thickness."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float, Int

from ..physics.parts import THINNEST
from ..scene.triangles import weld_index
from .reading.surface import ColoredSurface

_SHARE = 1.5e-3  # of its longest side that a sheet is made thick; repair refuses a third less
_THIN_SHARE = 0.05  # share of its longest side below which a thin thing is a sheet
_SAME = 1e-6  # share of its longest side up to which both sides of a sheet are one


def thicken(surface: ColoredSurface) -> tuple[ColoredSurface, float]:
    """Return a sheet with a thickness, and the thickness; other surfaces unchanged, and 0.

    A sheet is thinner than ``physics.parts.THINNEST`` or than 0.15 % of its longest side, along any
    direction. If it has two sides, they move apart along that direction; a single layer becomes two
    layers with a rim.
    """
    used = surface.vertices[np.unique(surface.faces)]
    middle = used.mean(0)
    normal = _normal(used - middle)
    along = (surface.vertices - middle) @ normal
    low, high = float(((used - middle) @ normal).min()), float(((used - middle) @ normal).max())
    longest = float(np.ptp(used, axis=0).max())
    wanted = max(THINNEST, _SHARE * longest)
    if high - low >= min(wanted, _THIN_SHARE * longest):
        return surface, 0.0
    if high - low > _SAME * longest:
        shift = (along - (low + high) / 2) * (wanted / (high - low) - 1)
        return replace(surface, vertices=surface.vertices + shift[:, None] * normal), wanted
    return _extrude(surface, normal * wanted / 2), wanted


def _normal(points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "3"]:
    """Return the direction in which points extend least; along an axis if nearly so."""
    normal = np.linalg.eigh(points.T @ points)[1][:, 0]
    axis = int(np.abs(normal).argmax())
    return np.eye(3)[axis] if abs(normal[axis]) > 1 - 1e-6 else normal


def _extrude(surface: ColoredSurface, half: Float[np.ndarray, "3"]) -> ColoredSurface:
    """Return a layer as two, ``half`` above and below it, joined by a rim."""
    count, faces = len(surface.vertices), surface.faces
    sides, owner = _rim(surface)
    if len(faces) and np.cross(*np.diff(surface.vertices[faces[0]], axis=0)) @ half < 0:
        half = -half  # the first layer looks outwards
    a, b = sides.T
    rim = np.concatenate([
        np.column_stack([b, a, a + count]), np.column_stack([b, a + count, b + count]),
    ])  # fmt: skip
    return replace(
        surface,
        vertices=np.concatenate([surface.vertices + half, surface.vertices - half]),
        faces=np.concatenate([faces, faces[:, ::-1] + count, rim]),
        uv=np.concatenate([surface.uv] * 2),
        colors=np.concatenate([surface.colors] * 2),
        picture=np.concatenate([surface.picture, surface.picture, *[surface.picture[owner]] * 2]),
    )


def _rim(surface: ColoredSurface) -> tuple[Int[np.ndarray, "k 2"], Int[np.ndarray, "k"]]:
    """Return the sides that belong to one face alone, and their faces."""
    sides = np.concatenate([surface.faces[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    welded = np.sort(weld_index(surface.vertices)[sides], axis=1)
    _, edge, total = np.unique(welded, axis=0, return_inverse=True, return_counts=True)
    alone = total[edge.reshape(-1)] == 1
    owner = np.tile(np.arange(len(surface.faces)), 3)
    return sides[alone], owner[alone]
