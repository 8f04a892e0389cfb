from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from toy import toy_object, toy_scene
from worlds import begun

from generator.errors import InputError, SceneError
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.planning.drop import load
from tabletopgen_env.expert.run import TaskExpert


def episode(
    env: Any,
    seed: int,
    disturb: Callable[[int, TaskExpert], None] = lambda step, expert: None,
    **options: Any,
) -> tuple[bool, list[np.ndarray], TaskExpert]:
    """Return whether the expert solves it, and its actions; ``disturb`` precedes each."""
    expert = begun(env, seed, **options)
    actions: list[np.ndarray] = []
    for step in range(200):
        actions.append(expert.act())
        disturb(step, expert)
        if env.step(actions[-1])[4]["success"]:
            return True, actions, expert
    return False, actions, expert


@pytest.fixture(scope="module")
def env() -> Any:
    made = make_env(toy_scene())
    yield made
    made.close()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("target", "goal"),
    [
        ("cube_1", "bowl_1"), ("can_1", "spot"), ("mug_1", "bowl_1"), ("bottle_1", "spot"),
        ("bowl_1", "spot"), ("cube_1", "mug_1"),
    ],
)  # fmt: skip
def test_it_solves_every_kind_of_goal(env: Any, target: str, goal: str) -> None:
    solved, actions, expert = episode(env, 3, target=target, goal=goal)
    assert solved, expert.phase
    stacked = np.array(actions)
    assert stacked.dtype == np.float32
    assert (np.abs(stacked) <= 1).all()


@pytest.mark.slow
def test_same_seed_same_actions(env: Any) -> None:
    first, second = (episode(env, 7)[1] for _ in range(2))
    np.testing.assert_array_equal(first, second)


def test_it_goes_after_an_object_that_is_moved_away(env: Any) -> None:
    def move(step: int, expert: TaskExpert) -> None:
        if step == 14:
            env.world.teleport("cube_1", np.array([-0.25, -0.05, 0.7625]))

    solved, _, expert = episode(env, 1, move, target="cube_1", goal="bowl_1")
    assert solved, expert.phase
    assert expert.attempts == 2


def test_it_picks_up_again_what_it_lost(env: Any) -> None:
    lost: list[int] = []

    def lose(step: int, expert: TaskExpert) -> None:
        if expert.phase == "carry" and not lost:
            env.world.teleport("cube_1", np.array([-0.2, 0.0, 0.7625]))
            lost.append(step)

    solved, _, expert = episode(env, 1, lose, target="cube_1", goal="bowl_1")
    assert solved, expert.phase
    assert lost and expert.attempts == 2


def test_it_says_when_nothing_can_be_done() -> None:
    block = toy_object("block", (0.1, 0.1, 0.1), (0.0, 0.0))
    env = make_env(toy_scene((block, toy_object("cube", (0.04, 0.04, 0.04), (0.2, 0.0)))))
    env.reset(seed=0, options={"target": "block", "goal": (-0.2, 0.0)})
    with pytest.raises(SceneError, match="no grasp of 'block'"):
        TaskExpert(env).reset()


@pytest.mark.parametrize(
    "settings",
    [{"action": "joint_delta"}, {"action": "ee_absolute"}, {"gripper": "binary"},
     {"control_hz": 10}],
)  # fmt: skip
def test_it_acts_in_one_mode_only(settings: dict[str, Any]) -> None:
    with pytest.raises(InputError, match="ee_delta"):
        TaskExpert(make_env(toy_scene(), **settings))


@pytest.mark.slow
def test_what_is_placed_is_left_alone() -> None:
    env = make_env(toy_scene(), task="PickPlace")
    expert = begun(env, 0, target="cube_1", goal="spot")
    met = [env.step(expert.act())[4]["success"] for _ in range(220)]
    assert any(met) and all(met[met.index(True) :]) and expert.attempts == 1


@pytest.mark.parametrize("task", ["Lift", "PickPlace"])
def test_a_heavy_bowl_turns_about_the_fingers_until_it_hangs(task: str) -> None:
    bowl = toy_object("bowl_1", (0.22, 0.22, 0.07), (0.05, 0.0), wall=0.012, mass=1.0)
    env = make_env(toy_scene((bowl,)), task=task)
    goal = {"goal": "spot"} if task == "PickPlace" else {}
    solved, _, expert = episode(env, 0, target="bowl_1", **goal)
    assert solved and expert.attempts == 1, "it is in the hand all the while"


def test_what_is_held_is_as_broad_as_it_is_where_it_is() -> None:
    bowl = toy_object("bowl_1", (0.2, 0.2, 0.07), (0.05, 0.0), wall=0.012)
    env = make_env(toy_scene((bowl,)), task="Lift")
    env.reset(seed=0)
    tool = env.world.data.site_xpos[env.world.tcp]
    env.world.teleport("bowl_1", tool + np.array([0.09, 0.0, -0.03]))
    away, broad = load(env.world, "bowl_1", 0.0)
    np.testing.assert_allclose(away, [0.09, 0.0, 0.0], atol=1e-6)
    assert 0.1 <= broad < 0.13
    away, broad = load(env.world, "bowl_1", 1.0)
    assert not away.any() and broad >= 0.19, "turned, it may come to be anywhere around"
