"""Stability of a model on a floor in MuJoCo: its motion within one second."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ..physics.spec import new_data
from ..scene import Model

if TYPE_CHECKING:
    import mujoco

MASS = 0.2
"""Mass of a free body, kg. The motion of a uniform solid does not depend on it."""

STEPS = 500
"""Number of steps of 2 ms."""


def floor_spec() -> mujoco.MjSpec:
    """Return a spec with a floor at z = 0."""
    import mujoco

    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1])
    return spec


def stand(spec: mujoco.MjSpec, model: Model, free: bool) -> mujoco.MjsBody:
    """Add a model's collision parts to a spec as a body standing on the floor; return the body."""
    import mujoco

    body = spec.worldbody.add_body(name=model.name, pos=[0, 0, model.size[2] / 2])
    for k, part in enumerate(model.parts):
        mesh = spec.add_mesh(name=f"part{k}")
        mesh.uservert = (part.vertices * model.size).astype(np.float32).ravel()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=f"part{k}",
            friction=[model.physics.friction, 0.005, 1e-4],
        )
    if free:
        body.add_freejoint()
        center, spread = _moments(model)
        inertia = MASS * (np.trace(spread) * np.eye(3) - spread)
        body.explicitinertial, body.mass, body.ipos = True, MASS, center
        body.fullinertia = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return body


def drift(model: Model) -> tuple[float, float]:
    """Return how far a free model moves (metres) and turns (degrees) within one second."""
    import mujoco

    spec = floor_spec()
    stand(spec, model, free=True)
    compiled = spec.compile()
    data = new_data(compiled)
    for _ in range(STEPS):
        mujoco.mj_step(compiled, data)
    moved = float(np.linalg.norm(data.qpos[:3] - [0, 0, model.size[2] / 2]))
    return moved, float(2 * np.degrees(np.arccos(min(1.0, abs(data.qpos[3])))))


def _moments(model: Model) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
    """Return the centre of mass of a uniform solid and its covariance about that centre."""
    v = model.mesh.vertices.astype(float) * model.size
    a, b, c = (v[model.mesh.faces[:, k]] for k in range(3))
    w = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    s = a + b + c
    center = (w[:, None] * s / 4).sum(0) / w.sum()
    second = sum(np.einsum("n,ni,nj->ij", w, p, p) for p in (a, b, c, s)) / 20 / w.sum()
    return center, second - np.outer(center, center)
