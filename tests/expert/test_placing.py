"""Placement: beside the contents, rotated to fit, over the rim out of the fingers' reach."""

from dataclasses import replace

import numpy as np
import pytest
from toy import corners, toy_object, toy_scene
from worlds import begun

from generator.geometry import wrap
from generator.scene import ConvexPart, Object
from tabletopgen_env.affordance import Opening
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.expert.pick import Picker
from tabletopgen_env.expert.planning.heights import solid
from tabletopgen_env.expert.planning.placement import Place, plan_place
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.goals.goal import Into, OnTop

TOP = 0.74
CUBE = toy_object("cube", (0.04, 0.04, 0.04), (-0.15, 0.0))
BOARD = toy_object("board", (0.2, 0.2, 0.02), (0.15, 0.0), mass=1.0)


def holding(*objects: Object, goal: str, task: str = "Stack") -> tuple[TabletopEnv, TaskExpert]:
    """Return an environment whose expert has just lifted the first object."""
    env = make_env(toy_scene(objects), task=task)
    expert = begun(env, 0, target=objects[0].name, goal=goal)
    for _ in range(80):
        env.step(expert.act())
        if expert.phase == "carry":
            return env, expert
    pytest.fail(f"not lifted, {expert.phase}")


def place(env: TabletopEnv, opening: float = 0.06) -> Place:
    axis = env.world.base_rotation.T @ env.world.data.site_xmat[env.world.tcp].reshape(3, 3)[:, 0]
    return plan_place(env.world, env.goal, float(np.arctan2(axis[1], axis[0])), opening)


@pytest.mark.slow
def test_the_middle_is_best_unless_something_stands_there() -> None:
    env, _ = holding(CUBE, BOARD, goal="board")
    assert isinstance(env.goal, OnTop)
    np.testing.assert_allclose(place(env).target, [0.15, 0.0], atol=0.01)
    other = toy_object("other", (0.04, 0.04, 0.04), (0.4, 0.2))
    env, _ = holding(CUBE, BOARD, other, goal="board")
    env.world.teleport("other", np.array([0.15, 0.0, TOP + 0.0402]))
    found = place(env)
    away = np.abs(found.target - [0.15, 0.0])
    assert away.max() > 0.04, "clear of the other cube"
    assert np.linalg.norm(found.target - [0.15, 0.0]) <= 0.1
    assert found.tool[2] == pytest.approx(place(env).tool[2])


def tray(yaw_across: bool) -> Object:
    """A tray 20 cm long and 7 cm wide, its long side along y if ``yaw_across``."""
    size = np.array([0.07, 0.2, 0.03] if yaw_across else [0.2, 0.07, 0.03])
    x, y, z = size / 2
    boxes = [
        ((-x, -y, -z), (x, y, -z + 0.005)),
        ((-x, -y, -z), (-x + 0.005, y, z)), ((x - 0.005, -y, -z), (x, y, z)),
        ((-x, -y, -z), (x, -y + 0.005, z)), ((-x, y - 0.005, -z), (x, y, z)),
    ]  # fmt: skip
    made = toy_object("tray", tuple(size), (0.15, 0.0), mass=1.0)
    return replace(made, parts=tuple(ConvexPart(corners(*box), "box") for box in boxes))


@pytest.mark.parametrize("across", [False, True])
def test_a_long_thing_is_turned_to_lie_along_a_tray(across: bool) -> None:
    bar = toy_object("bar", (0.13, 0.02, 0.02), (-0.15, 0.0))
    env = make_env(toy_scene((bar, tray(across))), task="Lift")
    expert = begun(env, 0, target="bar")
    for _ in range(60):
        env.step(expert.act())
    world = env.world
    hollow = Opening(np.zeros(2), np.array([0.03, 0.09] if across else [0.09, 0.03]),
                     -0.01, 0.015, 0.005, 0.005, 0.0)  # fmt: skip
    goal = Into("bar", "tray", hollow, 0.02)
    axis = world.base_rotation.T @ world.data.site_xmat[world.tcp].reshape(3, 3)[:, 0]
    yaw = float(np.arctan2(axis[1], axis[0]))
    found = plan_place(world, goal, yaw, 0.04)
    turned = abs(wrap(2 * (found.yaw - yaw))) / 2
    assert turned == pytest.approx(np.pi / 2 if across else 0.0, abs=0.2)


@pytest.mark.slow
def test_a_turn_of_the_hand_is_no_slip() -> None:
    mug = toy_object("mug", (0.085, 0.085, 0.095), (-0.15, 0.0), wall=0.006, mass=0.3)
    env, expert = holding(mug, BOARD, goal="board")
    now = expert._now
    assert isinstance(now, Picker)
    planned = now._drop._place
    now._drop._place = replace(planned, yaw=wrap(planned.yaw + 1.5))
    phases = set()
    for _ in range(60):
        env.step(expert.act())
        phases.add(expert.phase)
    assert "lower" in phases and "approach" not in phases


def test_a_layer_thinner_than_a_voxel_is_solid() -> None:
    cup = (
        ConvexPart(corners((0.0, 0.0, 0.0), (0.05, 0.05, 0.004)), "box"),
        ConvexPart(corners((0.0, 0.0, 0.0371), (0.05, 0.05, 0.0379)), "box"),
    )
    shape = solid(cup, 0.005, 0.003)
    columns = shape.filled.reshape(-1, len(shape.levels))
    (column,) = columns[shape.nearest(np.array([[0.025, 0.025]]))]
    assert column[:1].all() and column.sum() in (2, 3)
    assert shape.levels[column].max() == pytest.approx(0.0375, abs=0.002)
