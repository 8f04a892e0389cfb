"""Feasible starts: targets keep a reachable grasp."""

from dataclasses import replace

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.scene import Object, Pose, Scene
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.expert.planning.choice import choose
from tabletopgen_env.randomization.feasible import Feasible

CUBE = (0.04, 0.04, 0.04)
WALL = (0.16, 0.02, 0.2)


def shown(*walls: tuple[float, float], cube: tuple[float, float] = (0.0, 0.0)) -> TabletopEnv:
    things = [toy_object("cube_1", CUBE, cube)]
    things += [toy_object(f"wall_{k}", WALL, xy, mass=2.0) for k, xy in enumerate(walls)]
    env = make_env(toy_scene(tuple(things)), task="Lift", certified=False)
    env.reset(seed=0, options={"target": "cube_1"})
    return env


def moved(scene: Scene, name: str, xy: tuple[float, float]) -> Scene:
    """Return the scene with a displaced object."""

    def put(thing: Object) -> Object:
        at = np.array([*xy, thing.pose.position[2]])
        return replace(thing, pose=Pose(at, thing.pose.quaternion))

    return scene.replace(objects=tuple(put(o) if o.name == name else o for o in scene.objects))


def after(env: TabletopEnv, name: str, xy: tuple[float, float]) -> bool:
    """Return whether the episode is feasible after an object is displaced."""
    world, feasible = env.world, Feasible(env.world, env.episode.goals)
    assert feasible.now()
    world.rearrange(moved(world.scene, name, xy))
    world.reset()
    return feasible.now()


def test_what_stays_free_and_near_can_be_taken() -> None:
    assert after(shown(), "cube_1", (0.03, -0.02))


@pytest.mark.slow
def test_what_the_arm_does_not_reach_cannot() -> None:
    assert not after(shown(), "cube_1", (0.55, 0.3))


def test_what_leaves_the_fingers_no_room_cannot_stand_there() -> None:
    env = shown((0.0, 0.1), (0.0, -0.1))
    world, feasible = env.world, Feasible(env.world, env.episode.goals)
    world.rearrange(moved(moved(world.scene, "wall_0", (0.0, 0.032)), "wall_1", (0.0, -0.032)))
    world.reset()
    assert choose(world, "cube_1") is None
    assert not feasible.now()


def test_another_grasp_will_do_where_the_first_is_blocked(monkeypatch: pytest.MonkeyPatch) -> None:
    env = shown((0.0, 0.3))
    feasible = Feasible(env.world, env.episode.goals)
    monkeypatch.setattr("tabletopgen_env.randomization.feasible.grasps_along", lambda *_: iter(()))
    assert feasible.now()
    monkeypatch.setattr("tabletopgen_env.randomization.feasible.choose", lambda *_: None)
    assert not feasible.now()


def test_what_had_no_grasp_before_asks_for_none() -> None:
    env = shown(cube=(0.55, 0.3))
    env.world.rearrange(moved(env.world.scene, "cube_1", (0.5, 0.3)))
    env.world.reset()
    assert Feasible(env.world, env.episode.goals).now()
