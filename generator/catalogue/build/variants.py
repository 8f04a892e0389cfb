"""Shapes made of others: things that keep still or lie as they settle, in more sizes and shades."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from ...scene import ConvexPart
from ..surfaces.look import Look
from .category import Category
from .collision import box_part
from .shape import Piece, Shape, shape


def keep_still(made: Callable[[Look], Shape]) -> Callable[[Look], Shape]:
    """Return a shape function whose things lie on a thin flat part under most of their length."""

    def make(look: Look) -> Shape:
        thing = made(look)
        points = np.concatenate([part.vertices for part in thing.parts])
        low, high = points.min(0), points.max(0)
        x, y = 0.7 * (high - low)[0], 0.9 * (high - low)[1]
        at = float(low[0] + high[0]) / 2, float(low[1] + high[1]) / 2, float(low[2])
        return replace(thing, parts=(*thing.parts, box_part(float(x), float(y), 0.003, at)))

    return make


def in_sizes(made: Callable[[Look], Shape], spread: float) -> Callable[[Look], Shape]:
    """Return a shape function whose things are larger and smaller by up to ``spread``."""

    def make(look: Look) -> Shape:
        thing = made(look)
        return thing.scale(look.between(1 - spread, 1 + spread))

    return make


def vary(kind: Category, sizes: float = 0.15, shades: float = 0.12) -> Category:
    """Return a category whose things also differ in size and shade, by up to these shares."""

    def make(look: Look) -> Shape:
        thing = kind.shape(look).scale(look.between(1 - sizes, 1 + sizes))
        light, warm = look.between(1 - shades, 1 + shades), look.between(-0.4, 0.4) * shades
        tint = light * np.array([1 + warm, 1, 1 - warm])
        pieces = tuple(
            Piece(p.solid, np.clip(p.tile * tint, 0, 255).round().astype(np.uint8))
            for p in thing.pieces
        )
        return replace(thing, pieces=pieces)

    return replace(kind, shape=make)


def at_rest(kind: Category) -> Category:
    """Return a category whose things lie as they come to rest, on the nearest stable side."""
    return replace(kind, shape=lambda look: settle_shape(kind.shape(look)))


def settle_shape(thing: Shape) -> Shape:
    """Return a shape turned onto the side nearest to its underside on which it does not tip."""
    points = np.concatenate([part.vertices for part in thing.parts])
    hull = ConvexHull(points)
    center = _center(thing)
    span = float(np.ptp(points, axis=0).max())
    down = hull.equations[np.argsort(hull.equations[:, 2])]
    for normal, offset in zip(down[:, :3], down[:, 3], strict=True):
        turn = _turn_down(normal)
        touching = points @ normal + offset > -0.002 * span
        if _margin((points[touching] @ turn.T)[:, :2], (turn @ center)[:2]) > 0.01 * span:
            break
    else:
        return thing
    low = float((points @ turn.T)[:, 2].min())
    parts = [ConvexPart(part.vertices @ turn.T - [0, 0, low]) for part in thing.parts]
    moved = [
        (replace(p.solid, vertices=p.solid.vertices @ turn.T - [0, 0, low]), p.tile)
        for p in thing.pieces
    ]
    return shape(moved, parts, thing.opacity)


def _center(thing: Shape) -> np.ndarray:
    """Return the centre of mass of a shape's solids."""
    corners = np.concatenate([p.solid.vertices[p.solid.faces] for p in thing.pieces])
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    return (volume[:, None] * corners.sum(1) / 4).sum(0) / volume.sum()


def _turn_down(normal: np.ndarray) -> np.ndarray:
    """Return the smallest rotation that turns a unit vector to point straight down."""
    axis = np.cross(normal, [0, 0, -1])
    sine, cosine = float(np.linalg.norm(axis)), float(-normal[2])
    if sine < 1e-9:
        return np.eye(3) if cosine > 0 else np.diag([1.0, -1.0, -1.0])
    x, y, z = axis / sine
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + sine * cross + (1 - cosine) * cross @ cross


def _margin(ground: np.ndarray, center: np.ndarray) -> float:
    """Return how far inside the hull of ``ground`` (n, 2) a point is; below 0 outside."""
    try:
        sides = ConvexHull(ground).equations
    except (QhullError, ValueError):
        return -1.0
    return float(-(sides[:, :2] @ center + sides[:, 2]).max())
