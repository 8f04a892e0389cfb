"""Mass, centre of mass and inertia of meshes and convex parts, computed by exact integrals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ..errors import SceneError
from ..scene import ConvexPart, Mesh, Physics
from ..scene.triangles import Faces, Vertices, closed, scaled_normals

_LEAST_MASS = 2e-3  # kg; minimum mass, so that contacts stay well conditioned
_WELD = 1e-6  # fraction of the unit box; closer vertices are merged

LEAST_GYRATION = 0.005
"""Minimum radius of gyration as a fraction of the box's diagonal, so that thin wires are stable at
the usual time steps. For a pencil, the ratio about its long axis is 0.015; for a skewer of 3 mm by
200 mm, it is 0.005."""

Triangles = Float[np.ndarray, "m 3 3"]


@dataclass(frozen=True, eq=False)
class MassProperties:
    """Mass properties: ``mass`` in kg, ``com`` in m, and ``inertia`` about ``com`` in kg m^2."""

    mass: float
    com: Float[np.ndarray, "3"]
    inertia: Float[np.ndarray, "3 3"]


def body_mass(
    mesh: Mesh, scale: Float[np.ndarray, "3"], physics: Physics, parts: Sequence[ConvexPart]
) -> MassProperties:
    """Return the mass properties of a canonical mesh at ``scale`` (its extent in metres).

    Hollow objects are surfaces with the thickness ``physics.shell``. Others have the volume of
    their mesh or, if that is not watertight, of ``parts`` (metres).

    Raises:
        SceneError: the shape has no volume.
    """
    triangles = (mesh.vertices.astype(np.float64) * scale)[mesh.faces]
    if physics.shell is not None:
        found = surface_mass(triangles, physics.density * physics.shell)
    elif is_watertight(mesh):
        found = volume_mass(triangles, physics.density)
    else:
        found = parts_mass(parts, physics.density)
    return _bound(found, np.asarray(scale, float))


def volume_mass(triangles: Triangles, density: float) -> MassProperties:
    """Return the mass properties of the solid enclosed by outward-facing triangles.

    Signed tetrahedra to the origin are summed, each with volume v = det(a, b, c) / 6 and second
    moment v / 20 (aaᵀ + bbᵀ + ccᵀ + ssᵀ) with s = a + b + c (F. Tonon, J. Math. Stat. 1, 2004).
    """
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    return _from_moments(density * volumes, triangles, 4.0, 20.0)


def surface_mass(triangles: Triangles, areal_density: float) -> MassProperties:
    """Return the mass properties of a thin shell of ``areal_density`` (kg/m^2).

    A triangle's second moment is A / 12 (aaᵀ + bbᵀ + ccᵀ + ssᵀ).
    """
    areas = np.linalg.norm(scaled_normals(triangles), axis=1) / 2
    return _from_moments(areal_density * areas, triangles, 3.0, 12.0)


def parts_mass(parts: Sequence[ConvexPart], density: float) -> MassProperties:
    """Return the mass properties of several convex hulls; overlaps count twice."""
    from scipy.spatial import ConvexHull

    pieces = []
    for part in parts:
        hull = ConvexHull(part.vertices)
        triangles = part.vertices[hull.simplices]
        inward = np.einsum("ij,ij->i", scaled_normals(triangles), hull.equations[:, :3]) < 0
        triangles[inward] = triangles[inward][:, ::-1]
        pieces.append(triangles)
    if not pieces:
        raise SceneError("An object without a closed mesh and without convex parts has no mass.")
    return volume_mass(np.concatenate(pieces), density)


def box_mass(
    mass: float, center: Float[np.ndarray, "3"], size: Float[np.ndarray, "3"]
) -> MassProperties:
    """Return the mass properties of a solid box of ``mass`` (kg), ``center`` and ``size`` (m)."""
    squares = np.square(size)
    return MassProperties(mass, center, mass / 12 * np.diag(squares.sum() - squares))


def join_bodies(bodies: Sequence[MassProperties]) -> MassProperties:
    """Return the mass properties of rigidly connected bodies, by the parallel axis theorem."""
    mass = sum(body.mass for body in bodies)
    com = sum((body.mass * body.com for body in bodies), np.zeros(3)) / mass
    inertia = np.zeros((3, 3))
    for body in bodies:
        arm = body.com - com
        inertia += body.inertia + body.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return MassProperties(mass, com, inertia)


def is_watertight(mesh: Mesh) -> bool:
    """Return whether a mesh, with texture seams joined, encloses a volume and faces outwards."""
    vertices, faces = weld(mesh)
    if not closed(faces):
        return False
    a, b, c = vertices[faces].transpose(1, 0, 2)
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) > 0


def weld(mesh: Mesh) -> tuple[Vertices, Faces]:
    """Return vertices and faces with coincident vertices merged and slivers removed."""
    cells = np.round(mesh.vertices.astype(np.float64) / _WELD).astype(np.int64)
    places, index = np.unique(cells, axis=0, return_inverse=True)
    faces = index.reshape(-1)[mesh.faces].astype(np.int64)
    whole = (faces != np.roll(faces, 1, axis=1)).all(1)
    return places * _WELD, faces[whole]


def _from_moments(
    weights: Float[np.ndarray, "m"], triangles: Triangles, first: float, second: float
) -> MassProperties:
    """Return the mass properties of triangles, or of tetrahedra to the origin if ``first`` is 4."""
    total = float(weights.sum())
    if not total > 0:
        raise SceneError(f"A shape must enclose a volume; its computed mass is {total:.3g} kg.")
    sums = triangles.sum(1)
    com = (weights[:, None] * sums).sum(0) / first / total
    moment = np.einsum("m,mki,mkj->ij", weights, triangles, triangles)
    moment = (moment + np.einsum("m,mi,mj->ij", weights, sums, sums)) / second
    about_com = moment - total * np.outer(com, com)
    return MassProperties(total, com, np.trace(about_com) * np.eye(3) - about_com)


def _bound(found: MassProperties, scale: Float[np.ndarray, "3"]) -> MassProperties:
    """Clip the centre of mass to the box, and raise mass and inertia to their minima."""
    mass = max(found.mass, _LEAST_MASS)
    inertia = found.inertia * (mass / found.mass)
    floor = mass * (LEAST_GYRATION * float(np.linalg.norm(scale))) ** 2
    values, axes = np.linalg.eigh((inertia + inertia.T) / 2)
    values = np.maximum(values, floor)
    values[2] = min(values[2], values[0] + values[1])
    com = np.clip(found.com, -scale / 2, scale / 2)
    return MassProperties(mass, com, axes @ np.diag(values) @ axes.T)
