"""The format-independent form of a scene or an object: meshes, inertia and convex pieces.

Everything is in the body's own frame (an object's is its canonical frame scaled to metres; the
table's has its origin at the centre of its box), z up in the world, metres, kilograms, radians.
Names are identifiers that all formats allow.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int

from ..physics.inertia import body_mass
from ..physics.mjcf import Document, GeomKind, document, object_document, primitive_kind
from ..scene import TABLE, ConvexPart, Mesh, Object, Scene

if TYPE_CHECKING:
    from trimesh import Trimesh

from itertools import product

from ..physics.inertia import volume_mass
from ..physics.mjcf import FLOOR

RESERVED = ("world", "floor", "scene", "sun", "PhysicsScene", TABLE)
"""Reserved names, which exports use for other elements."""

SEGMENTS = 32
"""Number of sides of a round part in formats without a primitive for it."""


@dataclass(frozen=True, eq=False)
class ExportPiece:
    """One convex piece of a body's collision shape.

    Attributes:
        kind: kind of shape; "mesh" is the convex hull of ``vertices``.
        center: centre of its box, metres.
        half: half extents of its box along the body's axes, metres; for a sphere, its radius three
            times.
        axis: axis of a cylinder, 0, 1 or 2.
        vertices, faces: its surface, facing outwards; round pieces have ``SEGMENTS`` sides, whose
            vertices lie on the surface.
    """

    kind: GeomKind
    center: Float[np.ndarray, "3"]
    half: Float[np.ndarray, "3"]
    axis: int
    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]

    @property
    def radius(self) -> float:
        """Radius of a cylinder or a sphere, in metres."""
        return float(np.delete(self.half, self.axis).mean())


@dataclass(frozen=True, eq=False)
class ExportBody:
    """One body of a scene.

    Attributes:
        name: an identifier, unique in the scene.
        label: its name in words.
        fixed: whether it is static.
        position, quaternion: its pose in the world frame, metres and a unit wxyz quaternion.
        mass, com, inertia: kilograms, metres, and kg m² about ``com`` along the body's axes.
        friction: coefficient of sliding friction.
        mesh: its visual mesh, in the unit box; ``vertices`` are the same in metres.
        pieces: its collision shape.
    """

    name: str
    label: str
    fixed: bool
    position: Float[np.ndarray, "3"]
    quaternion: Float[np.ndarray, "4"]
    mass: float
    com: Float[np.ndarray, "3"]
    inertia: Float[np.ndarray, "3 3"]
    friction: float
    mesh: Mesh
    vertices: Float[np.ndarray, "n 3"]
    pieces: tuple[ExportPiece, ...]


@dataclass(frozen=True, eq=False)
class ExportWorld:
    """Bodies above a floor at z = 0, in a form that does not depend on the export format.

    Attributes:
        name: name of the scene or the object.
        bodies: the table, if there is one, followed by the objects.
        ground: coefficient of friction of the floor and the table.
        mjcf: returns the same bodies as an MJCF with its files.
    """

    name: str
    bodies: tuple[ExportBody, ...]
    ground: float
    mjcf: Callable[[], Document]


def scene_world(scene: Scene) -> ExportWorld:
    """Return a scene in a form that does not depend on the export format.

    Raises:
        SceneError: the table's shape has no volume.
    """
    return ExportWorld(scene.name, bodies_of(scene), scene.table.friction, lambda: document(scene))


def object_world(thing: Object) -> ExportWorld:
    """Return one object at its pose above a floor that has the object's friction."""

    def mjcf() -> Document:
        return object_document(thing, visuals=True, floor=thing.friction)

    (name,) = legal_names([thing.name])
    return ExportWorld(thing.name, (_object_body(name, thing),), thing.friction, mjcf)


def bodies_of(scene: Scene) -> tuple[ExportBody, ...]:
    """Return a scene's bodies: the table, which is fixed, and the objects at rest.

    Raises:
        SceneError: the table's shape has no volume.
    """
    table = scene.table
    weight = body_mass(table.model.mesh, table.scale, table.model.physics, table.parts)
    names = legal_names([thing.name for thing in scene.objects])
    upright = np.array([1.0, 0.0, 0.0, 0.0])
    return (
        ExportBody(
            TABLE, table.model.label, True, np.array([0.0, 0.0, table.height / 2]), upright,
            weight.mass, weight.com, weight.inertia, table.friction, table.model.mesh,
            table.model.mesh.vertices * table.scale, tuple(map(piece_of, table.parts)),
        ),
        *(_object_body(name, thing) for name, thing in zip(names, scene.objects, strict=True)),
    )  # fmt: skip


def _object_body(name: str, thing: Object) -> ExportBody:
    return ExportBody(
        name, thing.label, False, thing.pose.position, thing.pose.quaternion,
        thing.mass, thing.com, thing.inertia, thing.friction, thing.model.mesh,
        thing.model.mesh.vertices * thing.scale, tuple(map(piece_of, thing.parts)),
    )  # fmt: skip


def legal_names(names: Iterable[str]) -> list[str]:
    """Return an identifier for each name: ASCII, unique, and not in ``RESERVED``.

    Valid names are unchanged. Letters lose their accents, other characters become "_".
    """
    asked = [*names]
    kept = {name for name in asked if _plain(name) == name and name not in RESERVED}
    taken = {*RESERVED, *kept}
    return [name if name in kept else free_name(_plain(name), taken) for name in asked]


def _plain(name: str) -> str:
    ascii_ = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    word = re.sub(r"[^A-Za-z0-9_]", "_", ascii_) or "thing"
    return f"_{word}" if word[0].isdigit() else word


def free_name(word: str, taken: set[str]) -> str:
    """Return the word, with a number appended if it is taken, and mark the result as taken."""
    name, number = word, 2
    while name in taken:
        name, number = f"{word}_{number}", number + 1
    taken.add(name)
    return name


def piece_of(part: ConvexPart) -> ExportPiece:
    """Return a convex part as MuJoCo represents it in collisions: as a primitive if possible."""
    kind, (low, high) = primitive_kind(part), part.bounds
    center, half = (low + high) / 2, (high - low) / 2
    surface = _surface(kind, part, half)
    vertices = np.asarray(surface.vertices, np.float64)
    if kind != "mesh":
        vertices = vertices + center
    axis = int(part.axis)
    return ExportPiece(kind, center, half, axis, vertices, np.asarray(surface.faces, np.int64))


def _surface(kind: GeomKind, part: ConvexPart, half: Float[np.ndarray, "3"]) -> Trimesh:
    """Return a part's surface: in place if it is a hull, about the origin if it is a primitive."""
    import trimesh
    from trimesh import creation

    if kind == "mesh":
        return trimesh.convex.convex_hull(part.vertices.round(6))
    if kind == "box":
        return creation.box(2 * half)
    if kind == "cylinder":
        radius = float(np.delete(half, part.axis).mean())
        upright = creation.cylinder(radius, 2 * float(half[part.axis]), sections=SEGMENTS)
        turned = np.roll(upright.vertices, part.axis - 2, axis=1)  # a rotation: sides stay outside
        return trimesh.Trimesh(turned, upright.faces, process=False)
    ball = creation.uv_sphere(1.0, count=(SEGMENTS, SEGMENTS))
    return trimesh.Trimesh(ball.vertices * half, ball.faces, process=False)


_SIZE = np.array([8.0, 8.0, 0.1])  # metres
_DENSITY = 2000.0  # kg/m³
_COLOR = (237, 237, 235)
_FACES = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
)  # fmt: skip


def floor_body(friction: float) -> ExportBody:
    """Return the floor, a fixed body whose upper side is at z = 0."""
    corners = np.array([*product((-0.5, 0.5), repeat=3)])
    vertices, faces = corners * _SIZE, np.array(_FACES)
    mesh = Mesh(corners, faces, np.full((8, 2), 0.5), np.full((2, 2, 3), _COLOR, np.uint8))
    weight = volume_mass(vertices[faces], _DENSITY)
    return ExportBody(
        FLOOR, FLOOR, True, np.array([0.0, 0.0, -_SIZE[2] / 2]), np.array([1.0, 0.0, 0.0, 0.0]),
        weight.mass, weight.com, weight.inertia, friction, mesh, vertices,
        (piece_of(ConvexPart(vertices, "box")),),
    )  # fmt: skip
