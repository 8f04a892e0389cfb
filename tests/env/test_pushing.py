"""Push targets: objects that slide rather than roll, along stable paths."""

from dataclasses import replace

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.scene import ConvexPart, Object
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.tasks.push import LONGEST, Push, slidable, tips
from tabletopgen_env.world.world import World


def ball(radius: float) -> Object:
    """A ball of facets, as the catalogue makes them, lying on one of them."""
    box = toy_object("ball", (2 * radius, 2 * radius, 2 * radius), (0.0, 0.0))
    around, up = np.meshgrid(np.arange(12) * np.pi / 6, np.linspace(-1.4, 1.4, 8))
    ring = np.cos(up)
    points = np.stack([ring * np.cos(around), ring * np.sin(around), np.sin(up)], -1)
    return replace(box, parts=(ConvexPart(radius * points.reshape(-1, 3)),))


def test_balls_roll_and_blocks_do_not() -> None:
    assert tips(ball(0.03))
    assert not tips(toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0)))
    assert not tips(toy_object("cup", (0.08, 0.08, 0.06), (0.0, 0.0), wall=0.006))


def test_what_holds_fast_to_the_table_topples() -> None:
    post = toy_object("post", (0.04, 0.04, 0.06), (0.0, 0.0))  # it tips at a lean of 34 degrees
    assert not tips(replace(post, friction=0.6))
    assert tips(replace(post, friction=0.7))


def test_a_ball_is_not_asked_for_and_the_reason_is_told() -> None:
    world = World(toy_scene((ball(0.03),)), Panda())
    world.reset()
    assert slidable(world) == {"ball": "the object would topple or roll"}


@pytest.mark.parametrize("yaw", [0.0, 0.7])
def test_long_things_are_pushed_across(yaw: float) -> None:
    bar = toy_object("bar", (0.18, 0.03, 0.03), (0.0, 0.0), yaw=yaw)
    world = World(toy_scene((bar,)), Panda())
    world.reset()
    for seed in range(12):
        spot = Push().sample(world, np.random.default_rng(seed)).goals[0].spot
        assert spot is not None
        ahead = spot[:2] / np.linalg.norm(spot[:2])
        outline = world.footprints["bar"]
        broad = np.ptp(outline @ np.array([-ahead[1], ahead[0]]))
        assert np.ptp(outline @ ahead) <= LONGEST * broad
