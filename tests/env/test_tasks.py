"""PickPlace: draws, success, and maximum of the reward."""

from dataclasses import replace

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene
from worlds import STILL, wait

from generator.composition import compose
from generator.errors import SceneError
from generator.geometry import yaw_quaternion
from generator.scene import PlannedObject, PlannedTable, ScenePlan
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.goals.goal import SPOT, the
from tabletopgen_env.goals.instructions import refer
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.pick_place import PickPlace
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.world.composition import FRONT_CAMERA, TOP_CAMERA
from tabletopgen_env.world.world import World

AHEAD = np.pi / 2
"""Where a robot at the viewer's side looks: along y."""


def start(target: str, goal, scene=None, at=None) -> TabletopEnv:
    """Return an environment with a target and a goal, the target placed ``at`` a position."""
    env = make_env(scene or toy_scene())
    env.reset(seed=0, options={"target": target, "goal": goal})
    if at is not None:
        env.world.teleport(target, np.array(at))
    return env


SPOT_AT = (0.1, -0.15)
ON_SPOT = (*SPOT_AT, 0.7627)


@pytest.mark.parametrize(("goal", "at"), [(SPOT_AT, ON_SPOT), ("bowl_1", (0.24, -0.15, 0.79))])
def test_standing_on_the_spot_or_resting_in_the_bowl_is_the_only_full_reward(goal, at) -> None:
    reward, info = wait(start("cube_1", goal, at=at))
    assert info["success"] and reward == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("goal", "position", "most", "why"),
    [
        (SPOT_AT, (0.1, -0.10, 0.7626), 0.7, "5 cm aside"),
        (SPOT_AT, (-0.2, -0.15, 0.7626), 0.7, "elsewhere"),
        (SPOT_AT, (0.22, -0.14, 0.78), 0.7, "in the bowl"),
        ("bowl_1", (0.22, -0.25, 0.7626), 1.0, "beside the bowl"),
        ("bowl_1", (-0.05, 0.12, 0.80), 1.0, "in the mug instead"),
    ],
)
def test_standing_elsewhere_is_no_success(goal, position, most, why) -> None:
    reward, info = wait(start("cube_1", goal, at=position))
    assert not info["success"] and reward < most, why


def test_hovering_over_the_spot_is_no_success() -> None:
    _, reward, _, _, info = start("cube_1", SPOT_AT, at=(*SPOT_AT, 0.85)).step(STILL)
    assert not info["success"] and reward < 1


def test_moving_through_the_spot_is_no_success() -> None:
    env = start("cube_1", SPOT_AT, at=ON_SPOT)
    world = env.world
    world.data.qvel[world._object_dof[world.index("cube_1")][0]] = 0.1
    desired = env.task.desired_goal(world, env.episode)
    achieved = env.task.achieved_goal(world, env.episode, desired)
    gaps = env.task.gaps(achieved, desired)
    assert env.task.terms(world, env.episode, gaps)["success"] == 0.0


def test_being_held_on_the_spot_is_no_success() -> None:
    env = start("cube_1", SPOT_AT, at=ON_SPOT)
    assert wait(env)[1]["success"]
    hand = env.world.data.site_xpos[env.world.tcp].copy()
    lifted = replace(env.goal, spot=hand - [0.0, 0.0, env.goal.rest])  # the spot, up at the hand
    env._episode = replace(env.episode, goals=(lifted,))
    closed = np.array([0.0, 0, 0, 0, -1])
    for _ in range(15):
        env.world.teleport("cube_1", hand, yaw_quaternion(env.world.mount.yaw))
        env.step(closed)
    for _ in range(5):
        _, reward, _, _, info = env.step(closed)
    assert env.world.touches("cube_1") == (True, True, True)
    assert info["reward_terms"]["place"] == 1.0
    assert not info["success"] and reward == pytest.approx(1 - PickPlace.weights["success"])


def test_lying_across_the_rim_is_no_success() -> None:
    stick = toy_object("stick_1", (0.3, 0.02, 0.02), (-0.3, -0.2), mass=0.05)
    scene = toy_scene((*toy_objects(), stick))
    _, info = wait(start("stick_1", "bowl_1", scene, at=(0.22, -0.14, 0.811)))
    assert info["reward_terms"]["place"] == 1.0 and not info["success"]


def test_the_goal_follows_its_container() -> None:
    env = start("cube_1", "bowl_1")
    env.world.teleport("bowl_1", np.array([0.3, -0.1, 0.77]))
    env.world.teleport("cube_1", np.array([0.3, -0.1, 0.79]))
    assert wait(env)[1]["success"]


def test_reward_rises_along_the_way() -> None:
    env = start("cube_1", (0.2, 0.1))
    world, rewards = env.world, []
    desired = env.task.desired_goal(world, env.episode)
    for xyz in [(-0.15, -0.1, 0.763), (-0.15, -0.1, 0.83), (0.0, 0.0, 0.83), (0.2, 0.1, 0.83),
                (0.2, 0.1, 0.78), (0.2, 0.1, 0.763)]:  # fmt: skip
        world.teleport("cube_1", np.array(xyz))
        achieved = env.task.achieved_goal(world, env.episode, desired)
        terms = env.task.terms(world, env.episode, env.task.gaps(achieved, desired))
        assert all(0 <= v <= 1 for v in terms.values())
        rewards.append(sum(PickPlace.weights[k] * terms[k] for k in ("lift", "place", "success")))
    assert rewards == sorted(rewards) and rewards[-1] == pytest.approx(0.75)


@pytest.mark.parametrize("name", NAMES)
def test_weights_sum_to_one(name) -> None:
    assert sum(task_named(name).weights.values()) == pytest.approx(1.0)


@pytest.mark.slow
def test_targets_and_spots_are_drawn_from_what_can_be_done() -> None:
    env = make_env(toy_scene())
    targets, goals = set(), set()
    for seed in range(40):
        env.reset(seed=seed)
        goal, world = env.goal, env.world
        targets.add(goal.target)
        goals.add(goal.reference or SPOT)
        if goal.spot is not None:
            assert world.mount.reaches(goal.spot[None])[0]
            for other in world.scene.objects:
                if other.name != goal.target:
                    gap = np.linalg.norm(other.pose.position[:2] - goal.spot[:2])
                    assert gap > other.scale[:2].min() / 2 + 0.03
    assert targets == {"cube_1", "can_1", "mug_1", "bowl_1", "bottle_1"}  # not the heavy box
    assert {"spot", "bowl_1"} <= goals <= {"spot", "bowl_1", "mug_1"}


def test_what_carries_or_lies_inside_something_is_no_target() -> None:
    can, bowl, cube = toy_objects()[1], toy_objects()[3], toy_objects()[0]
    above = replace(cube, placement=replace(cube.placement, on="can_1"))
    env = make_env(toy_scene((can, above)))
    assert {env.reset(seed=k)[1]["target"] for k in range(6)} == {"cube_1"}
    within = replace(cube, placement=replace(cube.placement, on="bowl_1", inside=True))
    with pytest.raises(SceneError, match=r"inside bowl_1.*cube_1 stands on it|cube_1.*bowl_1"):
        make_env(toy_scene((bowl, within))).reset(seed=0)


def mug(k: int, x: float, y: float = 0.0):
    return toy_object(f"mug_{k}", (0.07, 0.07, 0.09), (x, y))


def test_the_instruction_tells_alike_things_apart() -> None:
    two = toy_scene((mug(1, 0.2), mug(2, -0.2)))
    assert [refer(two, o, AHEAD) for o in two.objects] == ["the right mug", "the left mug"]
    three = toy_scene((mug(1, 0.2), mug(2, -0.2), mug(3, 0.0)))
    assert refer(three, three.objects[2], AHEAD) == "the second mug from the left"
    planned = tuple(
        PlannedObject(f"mug_{k}", "mug", "mug", {"color": c}) for k, c in ((1, "red"), (2, "blue"))
    )
    plan = ScenePlan("two mugs", PlannedTable(), planned)
    assert refer(two.replace(plan=plan), two.objects[0], AHEAD) == "the red mug"
    behind = toy_scene((mug(0, 0.1, 0.2), mug(1, 0.1, -0.1)))  # the order of their names
    assert [refer(behind, o, AHEAD) for o in behind.objects] == ["the left mug", "the right mug"]


@pytest.mark.parametrize("degrees", [90, 31, 0, -60, 180, 265])
def test_left_and_right_are_the_robots(degrees: float) -> None:
    yaw = np.deg2rad(degrees)
    ahead, left = np.array([np.cos(yaw), np.sin(yaw)]), np.array([-np.sin(yaw), np.cos(yaw)])
    far = [0.12 * left + 0.1 * ahead, -0.12 * left + 0.15 * ahead, -0.02 * left - 0.1 * ahead]
    mugs = [toy_object(f"mug_{k}", (0.07, 0.07, 0.09), (p[0], p[1])) for k, p in enumerate(far)]
    scene = toy_scene(tuple(mugs))
    base = np.array([*-0.4 * ahead, scene.table.height])
    world = World(scene, Panda(), Mount(base, float(yaw)))
    sideways = [float(world.to_base(world.position(name))[1]) for name in world.names]
    assert sideways == pytest.approx([0.12, -0.12, -0.02], abs=1e-3), "y is to the robot's left"
    assert [the(world, name) for name in world.names] == [
        "the first mug from the left", "the third mug from the left", "the second mug from the left"
    ]  # fmt: skip
    world.absent = frozenset({"mug_2"})
    assert [the(world, name) for name in ("mug_0", "mug_1")] == ["the left mug", "the right mug"]

    def across(camera: str) -> bool:
        """Return whether the camera shows the robot's left on the right."""
        shown = world.model.cam_mat0[world.model.camera(camera).id].reshape(3, 3)[:, 0]
        return bool(shown[:2] @ left > 0.99)

    assert across(FRONT_CAMERA) and not across(TOP_CAMERA)


def test_the_instruction_counts_only_what_is_on_the_table() -> None:
    def mug(k: int, x: float):
        return toy_object(f"mug_{k}", (0.06, 0.06, 0.09), (x, 0.0))

    bowls = [
        toy_object(f"bowl_{k}", (0.17, 0.17, 0.06), (0.3 * k, -0.2), wall=0.008) for k in (0, 1)
    ]
    scene = toy_scene((mug(1, 0.15), mug(2, -0.15), mug(3, 0.0), *bowls))
    asked = {"target": "mug_3", "goal": "bowl_1"}
    full = make_env(scene).reset(seed=0, options=asked)[1]
    assert full["instruction"] == "put the second mug from the left into the right bowl"
    env = make_env(scene, randomization=Randomization(distractors=(0, 2)))
    told = set()
    for seed in range(12):
        info = env.reset(seed=seed, options=asked)[1]
        gone = set(info["randomization"]["distractors"]["absent"])
        mugs = {"mug_1": "left", "mug_2": "right"}
        left = [side for name, side in mugs.items() if name not in gone]
        word = {0: "mug", 1: f"{left[0] if left else ''} mug", 2: "second mug from the left"}
        bowl = "bowl" if "bowl_0" in gone else "right bowl"
        assert info["instruction"] == f"put the {word[len(left)]} into the {bowl}"
        told.add(info["instruction"])
    assert len(told) > 3
    assert env.step(STILL)[4]["instruction"] == info["instruction"]


def test_a_hindsight_goal_is_met_by_what_was_achieved() -> None:
    env = make_env(toy_scene(), observation="goal", reward="sparse")
    seen, _ = env.reset(seed=0)
    achieved = seen["achieved_goal"]
    assert env.compute_reward(achieved, seen["desired_goal"], None) == -1.0
    assert env.compute_reward(achieved, achieved, None) == 0.0
    moved = achieved.copy()
    moved[0] += achieved[3] + 0.01
    assert env.compute_reward(moved, achieved, None) == -1.0


def test_resetting_leaves_the_scene_where_it_settled() -> None:
    env = start("cube_1", "bowl_1")
    before = {name: env.world.position(name) for name in env.world.names}
    env.world.step(20 * 25)
    for name, position in before.items():
        assert np.linalg.norm(env.world.position(name) - position) < 2e-3, name


def test_what_is_too_wide_may_be_asked_to_be_stacked() -> None:
    env = make_env("office-round", task="Stack", certified=False)
    assert env.reset(seed=0, options={"target": "book_1"})[1]["target"] == "book_1"


@pytest.mark.slow
def test_stack_asks_for_no_top_that_the_arm_cannot_hold_a_thing_over() -> None:
    text = "A dining table with a cutting board at the front and two wine glasses at the back."
    near, far = (make_env(compose(text, seed), task="Stack") for seed in (1, 0))
    assert near.reset(seed=0)[1]["goal"] == "cutting_board_1"
    with pytest.raises(SceneError, match="wine_glass_1: no flat top in reach that can carry it"):
        far.reset(seed=0)
