"""Hand-made models for tests of physics and assembly: boxes, balls, cups, a table."""

from collections.abc import Sequence

import numpy as np
from scipy.spatial import ConvexHull
from toy import corners, cube_mesh, ring_parts

from generator.scene import ConvexPart, Mesh, Model, Physics, Placement, Provenance
from tabletop_objects.values import parts_to_unit_box, to_unit_box

TABLE_SIZE = np.array([1.2, 0.7, 0.74])
MANUAL = Provenance("manual", seed=0)
UNIT = corners([-0.5] * 3, [0.5] * 3)


def box(density: float = 600.0, shell: float | None = None) -> Model:
    """Return a box, with its extents from the placement."""
    part = ConvexPart(UNIT, "box")
    return Model("box", "box", cube_mesh(), np.full(3, 0.1), Physics(density, 0.6, shell), (part,))


def ball(density: float = 600.0) -> Model:
    part = ConvexPart(UNIT, "ellipsoid")
    return Model("ball", "ball", sphere_mesh(), np.full(3, 0.04), Physics(density), (part,))


def cup(size: tuple[float, float, float]) -> Model:
    """Return an open cup with walls of 6 mm."""
    parts = parts_to_unit_box(ring_parts(np.array(size), 0.006, 0.006), np.zeros(3), np.array(size))
    physics = Physics(2000.0, 0.6, shell=0.004)
    return Model("cup", "cup", drawn(parts), np.array(size), physics, parts, container=True)


def drawn(parts: Sequence[ConvexPart]) -> Mesh:
    """Return a mesh of the given convex parts."""
    points, faces, count = [], [], 0
    for part in parts:
        hull = ConvexHull(part.vertices)
        points.append(part.vertices)
        faces.append(hull.simplices + count)
        count += len(part.vertices)
    uv = np.zeros((count, 2))
    picture = np.full((4, 4, 3), 200, np.uint8)
    return Mesh(np.concatenate(points), np.concatenate(faces), uv, picture)


def table() -> Model:
    slab = ConvexPart(UNIT * [1, 1, 0.04] + [0, 0, 0.48], "box")
    column = ConvexPart(UNIT * [0.1, 0.1, 0.96] + [0, 0, -0.02], "box")
    return Model("table", "table", cube_mesh(), TABLE_SIZE, Physics(), (slab, column))


def put(
    name: str,
    xy: tuple[float, float],
    size: tuple[float, float, float],
    *,
    yaw: float = 0.0,
    on: str = "table",
    inside: bool = False,
) -> Placement:
    """Return a placement; the assembly determines heights."""
    return Placement(name, yaw, np.array([*xy, 0.8]), np.array(size), on, inside)


def sphere_mesh(around: int = 48, up: int = 24) -> Mesh:
    """A closed sphere with a seam, in the unit box."""
    u, v = np.meshgrid(np.linspace(0, 1, around + 1), np.linspace(0, 1, up + 1))
    a, b = 2 * np.pi * u, np.pi * (v - 0.5)
    points = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], -1) / 2
    row = around + 1
    faces = []
    for j in range(up):
        for i in range(around):
            p, q = j * row + i, (j + 1) * row + i
            faces += [[p, p + 1, q + 1], [p, q + 1, q]]
    uv = np.stack([u, v], -1).reshape(-1, 2)
    mesh = Mesh(points.reshape(-1, 3), np.array(faces), uv, np.full((4, 4, 3), 200, np.uint8))
    return to_unit_box(mesh)[0]


def cylinder_mesh() -> Mesh:
    """A plain upright cylinder in the unit box."""
    import trimesh

    made = trimesh.creation.cylinder(radius=0.5, height=1.0, sections=64)
    uv, texture = np.zeros((len(made.vertices), 2)), np.full((2, 2, 3), 150, np.uint8)
    return Mesh(made.vertices, made.faces, uv, texture)
