"""Strokes: behind the centre of mass, with room for fingers and palm."""

from dataclasses import replace
from typing import Any, cast

import numpy as np
import pytest
from toy import toy_object, toy_scene
from worlds import begun

from generator.scene import Object
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.planning.strokes import plan_stroke
from tabletopgen_env.expert.push import Pusher
from tabletopgen_env.goals.goal import Pushed
from tabletopgen_env.world.world import World

TOP = 0.74
BOOK = toy_object("book", (0.12, 0.12, 0.03), (0.0, 0.0))


def at_table(*objects: Object) -> World:
    env = make_env(toy_scene(objects), task="Push")
    env.reset(seed=0, options={"target": objects[0].name, "goal": (0.1, 0.0)})
    return env.world


def test_a_stroke_begins_behind_the_object() -> None:
    stroke = plan_stroke(at_table(BOOK), "book", np.array([0.15, 0.0]))
    assert stroke is not None
    np.testing.assert_allclose(stroke.ahead, [1.0, 0.0], atol=1e-6)
    assert -0.13 < stroke.start[0] < -0.08
    assert stroke.start[1] == pytest.approx(0.0, abs=1e-3)
    assert TOP + 0.0088 < stroke.start[2] < TOP + 0.03


def test_it_pushes_at_the_centre_of_mass() -> None:
    heavy = toy_object("head", (0.03, 0.09, 0.03), (0.06, 0.0))
    handle = toy_object("handle", (0.15, 0.02, 0.02), (0.0, 0.0))
    offset = heavy.pose.position - handle.pose.position
    hammer = replace(
        handle,
        parts=(*handle.parts, type(heavy.parts[0])(heavy.parts[0].vertices + offset)),
        com=np.array([0.05, 0.0, 0.0]),
    )
    stroke = plan_stroke(at_table(hammer), "handle", np.array([0.0, 0.12]))
    assert stroke is not None
    assert stroke.start[0] == pytest.approx(0.05, abs=0.005)


WALLS = tuple(toy_object(f"wall_{k}", (0.3, 0.02, 0.2), (0.0, k * 0.09)) for k in (-1, 1))
BAR = toy_object("bar", (0.2, 0.03, 0.03), (0.0, 0.0), mass=0.3)
TURNED = tuple(
    toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0), yaw=yaw, mass=0.1) for yaw in (0.5, 0.9)
)


@pytest.mark.parametrize(
    ("objects", "goal", "steps", "once"),
    [
        ((BOOK, *WALLS), (0.12, 0.0), 120, False),
        ((BAR,), (0.03, 0.13), 120, False),
        (TURNED[:1], (0.2, 0.02), 70, True),
        (TURNED[1:], (0.05, 0.2), 70, True),
    ],
    ids=["little room", "a long thing", "at its edge", "at its edge, turned more"],
)
def test_it_pushes_and_what_it_pushes_stays_before_the_hand(
    objects: tuple[Object, ...], goal: tuple[float, float], steps: int, once: bool
) -> None:
    env = make_env(toy_scene(objects), task="Push")
    expert = begun(env, 0, target=objects[0].name, goal=goal)
    assert any(env.step(expert.act())[4]["success"] for _ in range(steps)), expert.phase
    assert not once or expert.attempts == 1


def test_a_wall_beside_the_way_stops_the_palm_unless_room_is_tight() -> None:
    world, spot = at_table(BOOK, *WALLS), np.array([0.15, 0.0])
    assert plan_stroke(world, "book", spot) is None
    assert plan_stroke(world, "book", spot, care="tight") is not None


def test_the_fingers_meet_the_wall_of_a_hollow_thing_under_what_stands_out() -> None:
    bowl = toy_object("bowl", (0.12, 0.12, 0.05), (0.0, 0.0), wall=0.01)
    stick = toy_object("stick", (0.015, 0.015, 0.1), (0.0, 0.0))
    rise = np.array([0.0, 0.0, 0.025])
    mortar = replace(
        bowl, parts=(*bowl.parts, type(stick.parts[0])(stick.parts[0].vertices + rise))
    )
    stroke = plan_stroke(at_table(mortar), "bowl", np.array([0.15, 0.0]))
    assert stroke is not None
    assert stroke.start[2] < TOP + 0.05, "over the wall the fingers would miss it"
    assert stroke.start[0] < -0.06


def test_the_fingers_do_not_ride_over_a_low_part_to_meet_a_high_one() -> None:
    slab = toy_object("tablet", (0.12, 0.16, 0.0075), (0.0, 0.0))
    bump = toy_object("bump", (0.03, 0.04, 0.003), (0.0, 0.0))
    rise = np.array([0.02, 0.0, 0.00525])
    tablet = replace(slab, parts=(*slab.parts, type(bump.parts[0])(bump.parts[0].vertices + rise)))
    stroke = plan_stroke(at_table(tablet), "tablet", np.array([0.15, 0.0]))
    assert stroke is not None
    assert stroke.start[0] < -0.06 - 0.02, "it begins behind the slab, not over it"


def test_a_tight_stroke_does_not_come_down_on_a_neighbour() -> None:
    neighbour = toy_object("neighbour", (0.04, 0.04, 0.1), (-0.075, 0.0))
    world, spot = at_table(BOOK, neighbour), np.array([0.15, 0.0])
    assert plan_stroke(world, "book", spot, care="tight") is None
    assert plan_stroke(world, "book", spot, care="bold") is not None


def test_the_hand_turns_above_what_stands_around() -> None:
    post = toy_object("post", (0.02, 0.02, 0.15), (-0.1, 0.09))
    env: Any = make_env(toy_scene((BOOK, post)), task="Push")
    env.reset(seed=0, options={"target": "book", "goal": (0.15, 0.0)})
    pusher = Pusher(env, cast(Pushed, env.unwrapped.goal))
    pusher.reset()
    while pusher.phase != "descend":
        env.step(pusher.act())
    pusher._plan = replace(pusher._plan, yaw=pusher._plan.yaw + 1.5)
    pusher._enter("approach")
    assert pusher.act()[2] > 0.5, "up, for the palm is lower than the post"


def test_it_gives_up_a_stroke_whose_start_is_taken() -> None:
    env = make_env(toy_scene((BOOK, toy_object("box", (0.08, 0.08, 0.08), (0.3, 0.2), mass=1.0))),
                   task="Push")  # fmt: skip
    expert = begun(env, 0, target="book", goal=(0.15, 0.0))
    env.world.teleport("box", np.array([-0.105, 0.0, TOP + 0.04]))
    phases: list[str] = []
    for _ in range(75):
        env.step(expert.act())
        phases.append(expert.phase)
    assert "descend" in phases
    after = phases[phases.index("descend") :]
    assert "approach" in after, after
    assert "stroke" not in after[: after.index("approach")]
