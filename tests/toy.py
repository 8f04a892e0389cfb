"""Small hand-made scenes for tests: boxes and rings on a table, with exact numbers."""

import itertools
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.geometry import yaw_quaternion
from generator.scene import (
    ConvexPart,
    Mesh,
    Model,
    Object,
    Physics,
    Placement,
    Pose,
    Provenance,
    Scene,
    Table,
)

CUBE_FACES = np.array([
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
])  # fmt: skip


def corners(low: Any, high: Any) -> Float[np.ndarray, "8 3"]:
    """Corners of a box, z fastest."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return np.array([[x, y, z] for x in (x0, x1) for y in (y0, y1) for z in (z0, z1)])


def cube_mesh(color: tuple[int, int, int] = (180, 120, 60)) -> Mesh:
    """The unit box."""
    texture = np.full((2, 2, 3), color, np.uint8)
    return Mesh(corners([-0.5] * 3, [0.5] * 3), CUBE_FACES, np.zeros((8, 2)), texture)


def ring_parts(size: Float[np.ndarray, "3"], wall: float, floor: float) -> tuple[ConvexPart, ...]:
    """A cup of 12 wedges and a floor, metres, filling ``size``."""
    angles = np.linspace(0, 2 * np.pi, 13)
    low, high = -size[2] / 2, size[2] / 2
    parts = []
    for a, b in itertools.pairwise(angles):
        flat = [
            (scale * np.cos(t), scale * np.sin(t))
            for t in (a, b)
            for scale in (1, 1 - 2 * wall / size[0])
        ]
        outline = np.array(flat) * size[:2] / 2
        parts.append(ConvexPart(np.array([[x, y, z] for x, y in outline for z in (low, high)])))
    disc = np.column_stack([np.cos(angles[:-1]), np.sin(angles[:-1])]) * size[:2] / 2
    rounds = [[x, y, z] for x, y in disc for z in (low, low + floor)]
    return (*parts, ConvexPart(np.array(rounds)))


def toy_object(
    name: str,
    size: tuple[float, float, float],
    xy: tuple[float, float],
    *,
    yaw: float = 0.0,
    top: float = 0.74,
    mass: float = 0.15,
    wall: float | None = None,
    kind: str = "box",
    color: tuple[int, int, int] = (180, 120, 60),
    friction: float = 0.6,
) -> Object:
    """A box, a cylinder (by ``kind``) or, with ``wall``, an open cup, resting on ``top``."""
    extent = np.array(size)
    if wall is not None:
        parts = ring_parts(extent, wall, 0.006)
    else:
        parts = (ConvexPart(corners(-extent / 2, extent / 2), kind),)  # type: ignore[arg-type]
    label = name.rsplit("_", 1)[0]
    model = Model(
        label, label, cube_mesh(color), extent, Physics(), parts, label, container=wall is not None
    )
    position = np.array([*xy, top + extent[2] / 2])
    inertia = mass / 12 * np.diag(extent @ extent - extent**2)
    return Object(
        name,
        model,
        Placement(name, yaw, position, extent),
        parts,
        mass,
        np.zeros(3),
        inertia,
        friction,
        Pose(position, yaw_quaternion(yaw)),
    )


def toy_table(
    outline: Float[np.ndarray, "k 2"] | None = None,
    size: tuple[float, float, float] = (1.2, 0.7, 0.74),
) -> Table:
    """A table whose top is the convex ``outline`` (default: the rectangle), on one column."""
    length, width, height = size
    if outline is None:
        outline = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [length / 2, width / 2]
    top, under = height / 2, height / 2 - 0.03
    slab = ConvexPart(np.array([[x, y, z] for x, y in outline for z in (under, top)]))
    column = ConvexPart(corners([-0.05, -0.05, -top], [0.05, 0.05, under]), "box")
    model = Model("table", "table", cube_mesh((200, 180, 150)), np.array(size))
    return Table(model, np.array(size), (slab, column), outline)


def toy_objects() -> tuple[Object, ...]:
    """A cube, a can, a mug, a bowl, a bottle and a heavy box."""
    return (
        toy_object("cube_1", (0.045, 0.045, 0.045), (-0.15, -0.1), yaw=0.4, color=(200, 60, 50)),
        toy_object("can_1", (0.06, 0.06, 0.11), (0.12, 0.05), mass=0.3, kind="cylinder"),
        toy_object("mug_1", (0.085, 0.085, 0.095), (-0.05, 0.12), wall=0.006, mass=0.3),
        toy_object("bowl_1", (0.17, 0.17, 0.06), (0.22, -0.14), wall=0.008, mass=0.35),
        toy_object("bottle_1", (0.06, 0.06, 0.2), (-0.3, 0.1), mass=0.4, kind="cylinder"),
        toy_object("box_1", (0.2, 0.14, 0.1), (0.4, 0.15), mass=2.5, color=(90, 110, 140)),
    )


def toy_scene(
    objects: tuple[Object, ...] | None = None, table: Table | None = None, name: str = "toy"
) -> Scene:
    """A scene of ``toy_objects`` (or others) on ``toy_table``."""
    return Scene(
        name,
        table or toy_table(),
        toy_objects() if objects is None else objects,
        Provenance("manual", seed=0),
    )
