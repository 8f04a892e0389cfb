"""Every task succeeds exactly as documented, with full reward only then."""

from dataclasses import replace

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene
from worlds import STILL, wait

from generator.errors import InputError, SceneError
from generator.geometry import yaw_quaternion
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.goals.goal import RAISED, Into, OnTop, Raised
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.push import WAY
from tabletopgen_env.tasks.registry import task_named

TOP = 0.74


def start(task: str, scene=None, seed: int = 0, **options) -> TabletopEnv:
    env = make_env(scene or toy_scene(), task=task)
    env.reset(seed=seed, options=options)
    return env


def put(env: TabletopEnv, name: str, x: float, y: float, on: float = TOP) -> None:
    rest = env.world.position(name)[2] - env.world.lowest(name)
    env.world.teleport(name, np.array([x, y, on + rest + 2e-4]))


def is_done(env: TabletopEnv) -> bool:
    """Return whether info and reward both report success."""
    reward, info = wait(env)
    assert (reward == pytest.approx(1.0)) == info["success"]
    return info["success"]


# ------------------------------------------------------------------------------------------ all
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_fresh_episode_is_not_done_and_its_terms_are_shares(name) -> None:
    env = start(name)
    for seed in range(5):
        _, info = env.reset(seed=seed)
        terms = info["reward_terms"]
        assert not info["success"] and terms["success"] == 0.0
        assert all(type(value) is float and 0.0 <= value <= 1.0 for value in terms.values())
        assert sum(w * terms[n] for n, w in env.task.weights.items()) < 0.9
        assert info["goals"][0] < info["goals"][1] <= env.task.most


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_goal_vectors_alone_give_the_reward(name) -> None:
    env = make_env(toy_scene(), task=name, observation="goal", reward="sparse")
    seen, _ = env.reset(seed=3)
    assert env.observation_space.contains(seen)
    achieved, desired = seen["achieved_goal"], seen["desired_goal"]
    assert env.compute_reward(achieved, desired, None) == -1.0
    assert env.compute_reward(desired, desired, None) == 0.0
    both = env.compute_reward(np.stack([achieved, desired]), np.stack([desired] * 2), None)
    assert both.tolist() == [-1.0, 0.0]
    dense = make_env(toy_scene(), task=name, observation="goal")
    dense.reset(seed=3)
    assert dense.compute_reward(desired, desired, None) == pytest.approx(1.0)
    assert dense.compute_reward(achieved, desired, None) < 1.0


def test_unknown_tasks_and_presets_name_what_there_is() -> None:
    with pytest.raises(InputError, match="Did you mean 'Stack'"):
        make_env(toy_scene(), task="Stak")
    with pytest.raises(InputError, match=r"no preset 'kitchn'.*'kitchen'"):
        task_named("Sequence", "kitchn")
    with pytest.raises(InputError, match="Lift has no presets"):
        task_named("Lift", "kitchen")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("task", "options", "message"),
    [
        ("Reach", {"target": "cube_1"}, "Reach has no target"),
        ("Reach", {"goal": (0.1, 0.2)}, r"point \(x, y, z\)"),
        ("Lift", {"goal": "spot"}, "no goal to choose"),
        ("Push", {"goal": "bowl_1"}, "goal of Push must be a point"),
        ("Push", {"goal": (9.0, 0.0)}, "not on the table"),
        ("Stack", {"goal": "boxx_1"}, "Did you mean 'box_1'"),
        ("Stack", {"goal": (0.0, 0.0)}, "name of an object"),
        ("Swap", {"goal": (0.0, 0.0)}, "name of the other object"),
        ("Tidy", {"target": "cube_1"}, "omit the option 'target'"),
        ("Sequence", {"target": "cube_1"}, "omit .target. and .goal."),
    ],
)
def test_wrong_options_are_explained(task, options, message) -> None:
    with pytest.raises(InputError, match=message):
        start(task, **options)


@pytest.mark.parametrize("name", [n for n in NAMES if n != "Reach"])
def test_a_table_without_things_offers_nothing(name) -> None:
    with pytest.raises(SceneError, match="no objects"):
        start(name, toy_scene(()))


# ------------------------------------------------------------------------------------- one by one
def test_reach_is_done_where_the_tool_is_within_two_centimetres() -> None:
    env = start("Reach")
    tool = env.world.data.site_xpos[env.world.tcp].copy()
    for aside, done in ((0.015, True), (0.03, False)):
        env.reset(seed=0, options={"goal": (tool[0] + aside, tool[1], tool[2])})
        assert is_done(env) == done


def test_reach_goals_are_clear_of_things() -> None:
    env = start("Reach")
    for seed in range(30):
        env.reset(seed=seed)
        spot = env.goal.spot
        assert env.world.mount.reaches(spot[None])[0]
        for obj in env.world.scene.objects:
            near = np.linalg.norm(obj.pose.position[:2] - spot[:2]) < obj.scale[:2].max() / 2
            assert not near or spot[2] > obj.pose.position[2] + obj.scale[2] / 2 + 0.02


def test_lift_asks_for_both_fingers_at_a_height() -> None:
    env = start("Lift", target="cube_1")
    world, hand = env.world, env.world.data.site_xpos[env.world.tcp].copy()
    assert isinstance(env.goal, Raised)
    begin = world.position("cube_1")
    env.world.teleport("cube_1", begin + np.array([0.0, 0.0, sum(RAISED) / 2]))
    _, _, _, _, info = env.step(STILL)
    assert not info["success"], "in the air, but not held"
    near = replace(env.goal, start=hand - [0.0, 0.0, sum(RAISED) / 2])
    env._episode = replace(env.episode, goals=(near,), starts=(float(near.start[2]),))
    closed = np.array([0.0, 0, 0, 0, -1])
    for _ in range(15):
        world.teleport("cube_1", hand, yaw_quaternion(world.mount.yaw))
        env.step(closed)
    for _ in range(3):
        _, reward, _, _, info = env.step(closed)
    assert info["success"] and reward == pytest.approx(1.0)
    env._episode = replace(env.episode, goals=(replace(near, start=hand - [0, 0, 0.05]),))
    assert not env.step(closed)[4]["success"], "held, but too low"


def test_push_is_done_where_it_lies_at_rest_as_it_stood() -> None:
    env = start("Push", target="cube_1", goal=(0.0, -0.1))
    put(env, "cube_1", 0.03, -0.1)
    assert is_done(env)
    put(env, "cube_1", 0.05, -0.1)
    assert not is_done(env), "5 cm aside"


def test_a_pushed_thing_that_fell_over_is_no_success() -> None:
    slab = toy_object("slab_1", (0.09, 0.08, 0.06), (-0.15, -0.1))
    env = start("Push", toy_scene((slab,)), target="slab_1", goal=(0.0, -0.1))
    turned = np.array([np.cos(np.pi / 4), np.sin(np.pi / 4), 0.0, 0.0])
    env.world.teleport("slab_1", np.array([0.0, -0.1, TOP + 0.0402]), turned)
    _, info = wait(env)
    assert not info["success"] and info["reward_terms"]["place"] == 1.0


def test_the_gripper_stays_closed_while_pushing() -> None:
    env = start("Push")
    for _ in range(20):
        env.step(STILL)  # whose last entry asks to open
    assert env.world.data.qpos[env.world.finger_qpos].sum() < 0.005


@pytest.mark.slow
def test_ways_to_push_along_are_free_and_of_the_stated_length() -> None:
    env = start("Push")
    for seed in range(20):
        env.reset(seed=seed)
        world, goal = env.world, env.goal
        begin = world.position(goal.target)[:2]
        way = goal.spot[:2] - begin
        assert WAY[0] <= np.linalg.norm(way) <= WAY[1] + 1e-9
        for other in world.scene.objects:
            if other.name != goal.target:
                for t in np.linspace(0, 1, 9):
                    gap = np.linalg.norm(begin + t * way - other.pose.position[:2])
                    assert gap > other.scale[:2].min() / 2
        assert goal.target not in ("bottle_1", "box_1"), "slender or too heavy"


def test_stack_is_done_on_the_flat_top_and_nowhere_else() -> None:
    env = start("Stack", target="cube_1", goal="box_1")
    assert isinstance(env.goal, OnTop)
    put(env, "cube_1", 0.4, 0.15, on=TOP + 0.1)
    assert is_done(env)
    put(env, "cube_1", 0.4, 0.0)
    assert not is_done(env), "beside it"
    put(env, "can_1", 0.4, 0.15, on=TOP + 0.1)
    put(env, "cube_1", 0.4, 0.15, on=TOP + 0.21)
    assert not is_done(env), "on a can on it"


@pytest.mark.slow
def test_things_are_stacked_on_flat_tops_only() -> None:
    env = start("Stack")
    bases = {env.reset(seed=k)[1]["goal"] for k in range(30)}
    assert bases <= {"box_1", "can_1", "bottle_1", "cube_1"} and "box_1" in bases


def test_swap_is_done_when_both_have_changed_places() -> None:
    env = start("Swap", target="cube_1", goal="can_1")
    cube, can = (env.world.position(n)[:2] for n in ("cube_1", "can_1"))
    aside = env.goal.spot[:2]
    assert env.reset(seed=0, options={"target": "cube_1", "goal": "can_1"})[1]["goals"] == (0, 3)
    put(env, "can_1", *aside)
    reward, info = wait(env)
    assert info["goals"] == (1, 3) and info["target"] == "cube_1" and not info["success"]
    put(env, "cube_1", *can)
    more, info = wait(env)
    assert info["goals"] == (2, 3) and info["target"] == "can_1" and more > reward
    put(env, "can_1", *cube)
    assert is_done(env)
    put(env, "cube_1", *aside)
    assert not is_done(env)


def test_tidy_is_done_when_all_lie_inside() -> None:
    tray = toy_object("tray_1", (0.3, 0.3, 0.06), (0.25, 0.0), wall=0.01)
    small = [
        toy_object(f"cube_{k}", (0.04, 0.04, 0.04), (-0.2 + 0.1 * k, -0.1), mass=0.05)
        for k in range(3)
    ]
    env = start("Tidy", toy_scene((tray, *small)))
    goals = env.episode.goals
    assert {g.target for g in goals} == {"cube_0", "cube_1", "cube_2"}
    assert all(isinstance(g, Into) and g.reference == "tray_1" for g in goals)
    asked = wait(env, 1)[1]["instruction"]
    assert asked.startswith("put the ") and asked.endswith(" cube from the left into the tray")
    assert asked.count("the ") == 7 and asked.count(", ") == asked.count(" and ") == 1
    rewards = []
    for k, y in enumerate((-0.06, 0.0, 0.06)):
        assert not is_done(env)
        put(env, f"cube_{k}", 0.25, y, on=TOP + 0.007)
        rewards.append(wait(env)[0])
    assert rewards == sorted(rewards) and is_done(env)


@pytest.mark.slow
def test_tidy_takes_what_fits_beside_the_rest() -> None:
    tray = toy_object("tray_1", (0.3, 0.3, 0.06), (0.25, 0.0), wall=0.01)
    wide = [
        toy_object(f"slab_{k}", (0.07, 0.22, 0.03), (-0.03, (-0.2, 0.2)[k]), mass=0.1)
        for k in range(2)
    ]
    small = [toy_object(f"cube_{k}", (0.04,) * 3, (-0.3 + 0.1 * k, 0.0)) for k in range(3)]
    env = start("Tidy", toy_scene((tray, *wide, *small)))
    assert [g.target for g in env.episode.goals] == ["slab_0", "cube_2", "cube_1", "cube_0"]
    lying = toy_object("plank_1", (0.12, 0.12, 0.03), (0.25, 0.0), top=TOP + 0.006)
    lying = replace(lying, placement=replace(lying.placement, on="tray_1", inside=True))
    env = start("Tidy", toy_scene((tray, lying, *wide, *small)))
    assert [g.target for g in env.episode.goals] == ["cube_2", "cube_1", "cube_0"]


def test_a_sequence_is_done_when_all_steps_hold_whatever_their_order() -> None:
    env = start("Sequence", seed=1)
    goals = env.episode.goals
    assert 2 <= len(goals) <= 3 and len({g.target for g in goals}) == len(goals)
    assert wait(env, 1)[1]["instruction"].count(", then ") == len(goals) - 1
    for k in reversed(range(len(goals))):
        assert not is_done(env)
        center = goals[k].region(env.world).center
        env.world.teleport(goals[k].target, center)
        wait(env, 40)
    assert wait(env)[1]["reward_terms"]["met"] >= 2 / 3


def test_presets_find_their_things_by_what_they_are() -> None:
    cucumber = toy_object("cucumber_1", (0.12, 0.03, 0.03), (-0.2, -0.1))
    carrot = toy_object("carrot_1", (0.12, 0.03, 0.03), (-0.2, 0.0))
    shaker = toy_object("salt_shaker_1", (0.04, 0.04, 0.07), (-0.2, 0.1))
    bowl = toy_object("bowl_1", (0.2, 0.2, 0.06), (0.1, -0.15), wall=0.008)
    board = toy_object("cutting_board_1", (0.3, 0.2, 0.015), (0.1, 0.15))
    scene = toy_scene((cucumber, carrot, shaker, bowl, board))
    env = make_env(scene, task="Sequence", preset="kitchen")
    _, info = env.reset(seed=0)
    assert [(g.target, g.reference) for g in env.episode.goals] == [
        ("cucumber_1", "bowl_1"),
        ("carrot_1", "cutting_board_1"),
        ("salt_shaker_1", "cutting_board_1"),
    ]
    assert "cutting board" in info["instruction"]
    put(env, "cucumber_1", 0.1, -0.15, on=TOP + 0.006)
    put(env, "carrot_1", 0.1, 0.12, on=TOP + 0.015)
    put(env, "salt_shaker_1", 0.1, 0.2, on=TOP + 0.015)
    assert is_done(env)
    with pytest.raises(SceneError, match=r"no cucumber.*it has bottle, bowl"):
        make_env(toy_scene(toy_objects()), task="Sequence", preset="kitchen").reset(seed=0)


def test_presets_refuse_tables_where_a_thing_cannot_be_taken() -> None:
    things = (
        toy_object("cucumber_1", (0.14, 0.03, 0.03), (-0.2, 0.0)),
        toy_object("carrot_1", (0.1, 0.03, 0.03), (0.0, -0.15)),
        toy_object("salt_shaker_1", (0.04, 0.04, 0.07), (0.0, 0.2)),
        toy_object("bowl_1", (0.2, 0.2, 0.06), (0.2, 0.1), wall=0.008),
        toy_object("cutting_board_1", (0.2, 0.2, 0.02), (0.25, -0.15), mass=1.0),
    )
    walls = tuple(toy_object(f"wall_{k}", (0.2, 0.03, 0.2), (-0.2, 0.04 * k)) for k in (-1, 1))
    for extra, told in (((), None), (walls, "cucumber_1: no grasp of the object is in")):
        env = make_env(toy_scene(things + extra), task="Sequence", preset="kitchen")
        if told is None:
            env.reset(seed=0)
            continue
        with pytest.raises(SceneError, match=told):
            env.reset(seed=0)


def test_stacked_things_have_their_mass_over_the_top() -> None:
    thing = replace(
        toy_object("brush_1", (0.16, 0.03, 0.03), (-0.2, 0.0)), com=np.array([0.05, 0.0, 0.0])
    )
    small, large = (
        toy_object(f"{name}_1", (size, size, 0.03), (0.1, 0.1 * k), mass=1.0)
        for k, (name, size) in enumerate((("tin", 0.08), ("board", 0.16)))
    )
    with pytest.raises(SceneError, match="no flat top in reach that can carry it"):
        make_env(toy_scene((thing, small)), task="Stack").reset(seed=0)
    env = make_env(toy_scene((thing, large)), task="Stack")
    env.reset(seed=0, options={"target": "brush_1"})
    assert env.goal.reference == "board_1"


def test_tidy_asks_for_nothing_that_lies_on_what_fills_a_shallow_cup() -> None:
    tall, flat = (
        toy_object("can_1", (0.03, 0.03, 0.09), (0.2, 0.1)),
        toy_object("die_1", (0.024, 0.024, 0.024), (0.1, 0.1)),
    )
    deep, full = (
        toy_object("mug_1", (0.085, 0.085, height), (0.0, 0.0), wall=0.006)
        for height in (0.09, 0.024)
    )
    assert len(start("Tidy", toy_scene((deep, tall, flat))).episode.goals) == 2
    with pytest.raises(SceneError, match="no valid target"):
        start("Tidy", toy_scene((full, tall, flat)))
