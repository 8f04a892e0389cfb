"""Properties of meshes and models: closedness, volume, mass, fingerprint."""

from __future__ import annotations

import hashlib

import numpy as np

from ..physics.inertia import body_mass
from ..physics.parts import model_parts
from ..scene import Mesh, Model


def is_closed(mesh: Mesh) -> bool:
    """Return whether each edge is used equally often in both directions, after merging vertices.

    Only vertices with bitwise equal positions are merged.
    """
    _, index = np.unique(mesh.vertices + np.float32(0), axis=0, return_inverse=True)
    faces = index.reshape(-1)[mesh.faces].astype(np.int64)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    count = len(mesh.vertices)
    forwards = np.sort(edges[:, 0] * count + edges[:, 1])
    backwards = np.sort(edges[:, 1] * count + edges[:, 0])
    return bool((forwards == backwards).all())


def mass_of(model: Model) -> float:
    """Return the mass of a model at its nominal size, kg."""
    return body_mass(model.mesh, model.size, model.physics, model_parts(model, model.size)).mass


def fingerprint(model: Model) -> str:
    """Return a digest of a model's visual and collision data."""
    mesh = model.mesh
    arrays = mesh.vertices, mesh.faces, mesh.uv, mesh.texture, model.size
    digest = hashlib.sha256()
    for array in (*arrays, *(part.vertices for part in model.parts)):
        digest.update(str(array.shape).encode())
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()
