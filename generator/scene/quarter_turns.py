"""Exact rotations of models about the axes by multiples of 90 degrees."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from jaxtyping import Int

from tabletop_objects.values import ConvexPart, Mesh, Model

from ..errors import InputError, choices

Steps = Sequence[tuple[str, int]]
"""Rotations about the fixed axes "x", "y" or "z", in degrees, applied in order."""


def turn(model: Model, steps: Steps) -> Model:
    """Return a model rotated by multiples of 90 degrees, with its size and orientation updated."""
    turn = quarter_turn(steps)
    if (turn == np.eye(3, dtype=int)).all():
        return model
    mesh, parts = apply_quarter_turns(model.mesh, model.parts, steps)
    seen = None if model.orientation is None else model.orientation @ turn.T
    size = np.abs(turn) @ model.size
    return dataclasses.replace(model, mesh=mesh, parts=parts, size=size, orientation=seen, slots=())


def quarter_turn(steps: Steps) -> Int[np.ndarray, "3 3"]:
    """Return the exact integer rotation matrix of a sequence of quarter turns.

    Raises:
        InputError: An axis is unknown, or an angle is not a multiple of 90 degrees.
    """
    total = np.eye(3, dtype=int)
    for axis, degrees in steps:
        if axis not in ("x", "y", "z") or degrees % 90:
            raise InputError(
                "An orientation step must be (axis, multiple of 90 degrees), got "
                f"{(axis, degrees)!r}." + choices(str(axis), "xyz")
            )
        k = "xyz".index(axis)
        i, j = (k + 1) % 3, (k + 2) % 3
        quarter = np.zeros((3, 3), dtype=int)
        quarter[k, k], quarter[j, i], quarter[i, j] = 1, 1, -1
        total = np.linalg.matrix_power(quarter, int(degrees // 90) % 4) @ total
    return total


def apply_quarter_turns(
    mesh: Mesh, parts: tuple[ConvexPart, ...], steps: Steps
) -> tuple[Mesh, tuple[ConvexPart, ...]]:
    """Rotate a canonical mesh and its convex parts exactly, about the fixed axes.

    The unit box is mapped onto itself. Primitives remain primitives; a cylinder's axis turns too.
    """
    turn = quarter_turn(steps)
    vertices = mesh.vertices @ turn.T.astype(np.float32)
    axes = np.abs(turn).argmax(0)
    carried = tuple(
        dataclasses.replace(part, vertices=part.vertices @ turn.T, axis=int(axes[part.axis]))
        for part in parts
    )
    return dataclasses.replace(mesh, vertices=vertices), carried
