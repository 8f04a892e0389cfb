"""Tasks use the settled scene, not the plan."""

from dataclasses import replace

import pytest
from toy import toy_object, toy_scene

from generator.bundle import digest
from generator.errors import SceneError
from generator.scene import RelationOutcome, Report, Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes.difficulty import difficulty_terms
from tabletopgen_env.world.world import World

IN_BOWL = RelationOutcome("cube_1", "in", "bowl_1", False, -0.1)


def scene_of(*outcomes: RelationOutcome) -> Scene:
    """Return a cube that was planned inside a bowl, but stands beside it."""
    cube = toy_object("cube_1", (0.045, 0.045, 0.045), (-0.15, -0.1))
    bowl = toy_object("bowl_1", (0.17, 0.17, 0.06), (0.1, -0.1), wall=0.008, mass=0.35)
    cube = replace(cube, placement=replace(cube.placement, on="bowl_1", inside=True))
    return toy_scene((cube, bowl)).replace(report=Report(0.0, 0.0, 0.0, relations=outcomes))


def test_a_thing_that_missed_its_bowl_can_be_put_into_it() -> None:
    env = make_env(scene_of(IN_BOWL), task="PickPlace")
    _, info = env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    assert info["instruction"] == "put the cube into the bowl"
    assert not info["success"]
    offered = {env.reset(seed=seed)[1]["instruction"] for seed in range(8)}
    assert "put the cube into the bowl" in offered


def test_without_outcomes_supports_are_believed() -> None:
    with pytest.raises(SceneError, match="lies inside bowl_1"):
        make_env(scene_of(), task="Lift").reset(seed=0)
    make_env(scene_of(IN_BOWL), task="Lift").reset(seed=0)


def test_what_stands_on_the_table_after_all_counts_as_clutter() -> None:
    assert difficulty_terms(scene_of(IN_BOWL))["clutter"] > difficulty_terms(scene_of())["clutter"]


def test_a_world_keeps_the_digest_of_its_bundle() -> None:
    scene = scene_of(IN_BOWL)
    world = World(scene, Panda())
    assert world.scene is not scene
    assert world.digest == digest(scene)
