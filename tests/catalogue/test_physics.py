"""Containers of the catalogue hold a ball in MuJoCo."""

import mujoco
import numpy as np
import pytest

from generator.objects.checks import floor_spec, stand
from tabletop_objects import CATEGORIES, build

HOLLOW = (
    *("mug", "bowl", "teacup", "glass", "basket", "pan", "tray", "desk_tray", "pitcher", "ramekin"),
    *("mixing_bowl", "colander", "baking_tray", "plant_pot", "shot_glass"),
)


@pytest.mark.parametrize("key", HOLLOW)
def test_ball_falls_into_hollow_things(key: str):
    assert CATEGORIES[key].container
    model = build(key, 1)
    spec = floor_spec()
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
