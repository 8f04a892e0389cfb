"""The floor as a body: a flat box, which every engine has; some lack a plane, or break on it."""

from __future__ import annotations

from itertools import product

import numpy as np

from ..physics.inertia import volume_mass
from ..physics.mjcf import FLOOR
from ..scene import ConvexPart, Mesh
from .bodies import ExportBody, piece_of

_SIZE = np.array([8.0, 8.0, 0.1])  # metres
_DENSITY = 2000.0  # kg/m³
_COLOR = (237, 237, 235)
_FACES = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
)  # fmt: skip


def floor_body(friction: float) -> ExportBody:
    """Return the floor, fixed, its upper side at z = 0."""
    corners = np.array([*product((-0.5, 0.5), repeat=3)])
    vertices, faces = corners * _SIZE, np.array(_FACES)
    mesh = Mesh(corners, faces, np.full((8, 2), 0.5), np.full((2, 2, 3), _COLOR, np.uint8))
    weight = volume_mass(vertices[faces], _DENSITY)
    return ExportBody(
        FLOOR, FLOOR, True, np.array([0.0, 0.0, -_SIZE[2] / 2]), np.array([1.0, 0.0, 0.0, 0.0]),
        weight.mass, weight.com, weight.inertia, friction, mesh, vertices,
        (piece_of(ConvexPart(vertices, "box")),),
    )  # fmt: skip
