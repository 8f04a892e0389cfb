"""What tests ask of meshes and models: are they closed, what do they weigh, are they the same."""

import numpy as np

from generator.physics.inertia import body_mass
from generator.physics.parts import model_parts
from generator.scene import Mesh, Model


def is_closed(mesh: Mesh) -> bool:
    """Whether each edge, vertices merged by position, is met as often forwards as backwards."""
    _, index = np.unique(mesh.vertices + np.float32(0), axis=0, return_inverse=True)
    faces = index.reshape(-1)[mesh.faces].astype(np.int64)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    count = len(mesh.vertices)
    forwards = np.sort(edges[:, 0] * count + edges[:, 1])
    backwards = np.sort(edges[:, 1] * count + edges[:, 0])
    return bool((forwards == backwards).all())


def mass_of(model: Model) -> float:
    """Mass in kilograms at the model's own size."""
    return body_mass(model.mesh, model.size, model.physics, model_parts(model, model.size)).mass


def fingerprint(model: Model) -> tuple[bytes, ...]:
    parts = b"".join(p.vertices.tobytes() for p in model.parts)
    mesh = model.mesh
    arrays = (mesh.vertices, mesh.faces, mesh.uv, mesh.texture, model.size)
    return (*(a.tobytes() for a in arrays), parts)
