"""Catalogue objects in MuJoCo: hollow things hold a ball, everything rests where it stands."""

import mujoco
import numpy as np
import pytest
from built import Models

from generator.scene import Model
from tabletop_objects import CATEGORIES, build

HOLLOW = (
    *("mug", "bowl", "teacup", "glass", "basket", "pan", "tray", "desk_tray", "pitcher", "ramekin"),
    *("mixing_bowl", "colander", "baking_tray", "plant_pot", "shot_glass"),
)


def moments(model: Model) -> tuple[np.ndarray, np.ndarray]:
    """Centre of mass and covariance (about it) of a uniform solid of the model's shape."""
    v = model.mesh.vertices.astype(float) * model.size
    a, b, c = (v[model.mesh.faces[:, k]] for k in range(3))
    w = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    s = a + b + c
    center = (w[:, None] * s / 4).sum(0) / w.sum()
    second = sum(np.einsum("n,ni,nj->ij", w, p, p) for p in (a, b, c, s)) / 20 / w.sum()
    return center, second - np.outer(center, center)


def stand(spec: mujoco.MjSpec, model: Model, free: bool) -> mujoco.MjsBody:
    """Add a model's collision parts to a scene, standing on the floor."""
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
        center, spread = moments(model)
        spread = spread * 0.2
        inertia = np.trace(spread) * np.eye(3) - spread
        body.explicitinertial, body.mass, body.ipos = True, 0.2, center
        body.fullinertia = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return body


def room() -> mujoco.MjSpec:
    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1])
    return spec


@pytest.mark.parametrize("key", HOLLOW)
def test_ball_falls_into_hollow_things(key: str):
    assert CATEGORIES[key].container
    model = build(key, 1)
    spec = room()
    stand(spec, model, free=False)
    radius = 0.15 * float(model.size[:2].min())
    ball = spec.worldbody.add_body(name="ball", pos=[0.002, 0.003, model.size[2] + 2 * radius])
    ball.add_freejoint()
    ball.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[radius, 0, 0], mass=0.02)
    compiled = spec.compile()
    data = mujoco.MjData(compiled)
    for _ in range(750):
        mujoco.mj_step(compiled, data)
    x, y, z = data.body("ball").xpos
    assert z - radius < 0.5 * model.size[2], "the ball lies on top instead of inside"
    assert z - radius > -1e-3
    assert np.hypot(x, y) < 0.5 * model.size[:2].max()


@pytest.mark.slow
def test_rests_as_it_is_made(variants: Models):
    spec = room()
    model = variants[0]
    stand(spec, model, free=True)
    compiled = spec.compile()
    data = mujoco.MjData(compiled)
    for _ in range(500):
        mujoco.mj_step(compiled, data)
    moved = np.linalg.norm(data.qpos[:3] - [0, 0, model.size[2] / 2])
    turned = 2 * np.degrees(np.arccos(min(1.0, abs(data.qpos[3]))))
    assert moved < 0.005 and turned < 3.0
