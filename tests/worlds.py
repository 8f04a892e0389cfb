"""Worlds and environments of toy scenes."""

from typing import Any

import numpy as np
from toy import toy_objects, toy_scene

from generator.scene import Object, Scene
from tabletopgen_env.env import TabletopEnv
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import FixedScenes, SceneSource
from tabletopgen_env.world.world import World

STILL = np.array([0.0, 0.0, 0.0, 0.0, 1.0])
"""The action that moves nothing, the fingers open."""


def world_of(*objects: Object) -> World:
    """Return the world of a toy table with these objects, at its start."""
    world = World(toy_scene(objects), Panda())
    world.reset()
    return world


def two_scenes() -> list[Scene]:
    """Return the toy scene, and one with four of its objects."""
    return [toy_scene(), toy_scene(toy_objects()[:4], name="four")]


def wait(env: TabletopEnv, steps: int = 20) -> tuple[float, dict[str, Any]]:
    """Take no action; return reward and info of the last step."""
    for _ in range(steps):
        _, reward, _, _, info = env.step(STILL)
    return reward, info


def begun(env: TabletopEnv, seed: int = 0, **options: Any) -> TaskExpert:
    env.reset(seed=seed, options=options)
    expert = TaskExpert(env)
    expert.reset()
    return expert


def names(source: SceneSource) -> list[str]:
    """Return the names of a fixed source's scenes, in order."""
    assert isinstance(source, FixedScenes)
    return [ref.load().name for ref in source.refs]
