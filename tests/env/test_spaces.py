"""Tasks, observation and action modes under Gymnasium's and SB3's checkers; the flat state."""

import itertools
import warnings
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from extent import part_of
from gymnasium.utils.env_checker import check_env
from stable_baselines3.common.env_checker import check_env as sb3_check_env
from toy import toy_object, toy_scene, toy_table

import tabletopgen_env  # registers the environments  # noqa: F401
from generator.scene import Scene
from tabletopgen_env.actions import ACTIONS
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.rendering.config import MODES
from tabletopgen_env.rendering.views import SLOTS
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.worlds import Masters

IDS = sorted(name for name in gym.registry if name.startswith("TabletopGen/"))
ALL = list(itertools.product(IDS, MODES, ACTIONS))
PAIRED = [
    (name, observation, action)
    for name, observation, action in ALL
    if (IDS.index(name) + [*MODES].index(observation) - [*ACTIONS].index(action)) % len(ACTIONS)
    == 0
]
"""A part of them: any two of a task, an observation and an action together."""

CHECKED = [three for three in ALL if three[1] in ("state", "goal") or three in PAIRED]
"""What the checkers, which draw dozens of pictures, are run on: without pictures, all three."""


def scene_for_every_task() -> Scene:
    things = (
        toy_object("cube_1", (0.04, 0.04, 0.04), (0.05, -0.1)),
        toy_object("cube_2", (0.045, 0.045, 0.04), (-0.15, -0.15)),
        toy_object("tray_1", (0.22, 0.22, 0.05), (-0.2, 0.1), wall=0.01),
        toy_object("box_1", (0.16, 0.14, 0.05), (0.25, 0.1)),
    )
    return toy_scene(things)


def check(name: str, *ignored: str, **settings: Any) -> None:
    """Run both checkers; every warning but those ``ignored`` is an error."""
    given = {"scenes": scene_for_every_task(), "render_mode": "rgb_array"} | settings
    env = gym.make(name, **given)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for message in (".*needs a display.*", *ignored):
            warnings.filterwarnings("ignore", message=message)
        check_env(env.unwrapped, skip_render_check=True)
        sb3_check_env(env.unwrapped)
    env.close()


@pytest.fixture(scope="module")
def shared() -> dict[str, Any]:
    """A scene and its compiled world, for environments to copy."""
    robot = Panda()
    return {"scenes": scene_for_every_task(), "robot": robot, "masters": Masters(robot)}


@pytest.mark.parametrize("left_out", range(3))
def test_any_two_modes_are_checked_together(left_out: int) -> None:
    def pairs(of: list[tuple[str, str, str]]) -> set[tuple[str, ...]]:
        return {(*three[:left_out], *three[left_out + 1 :]) for three in of}

    assert pairs(PAIRED) == pairs(ALL)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "observation", "action"), part_of(CHECKED, *PAIRED))
def test_both_checkers_pass(name, observation, action, shared) -> None:
    told = {"instruction": "tokens"} if observation == "pixels+proprio" else {}  # SB3 reads no text
    small, shape = ".*minimal resolution for an image", ".*unconventional shape"
    check(
        name, small, shape, observation=observation, action=action, image_size=16, points=64,
        cameras=("front",), renderer="software", **told, **shared,
    )  # fmt: skip


def few_steps(env: gym.Env) -> list[bytes]:
    """Return the results of a seeded reset and some random actions, all within their spaces."""
    rng, shape = np.random.default_rng(4), env.action_space.shape
    seen, info = env.reset(seed=11)
    given = [*values(seen), *values(info["reward_terms"])]
    for _ in range(3):
        assert env.observation_space.contains(seen)
        seen, *rest, info = env.step(rng.uniform(-1, 1, shape).astype(np.float32))
        assert [type(value) for value in rest] == [float, bool, bool]
        given += [*values(seen), *rest, *values(info["reward_terms"])]
    return [np.asarray(value).tobytes() for value in given]


def values(seen: Any) -> list[Any]:
    """Return the values of a dict, or a value that is not a dict."""
    return list(seen.values()) if isinstance(seen, dict) else [seen]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "observation", "action"), part_of(ALL, *PAIRED))
def test_two_seeded_environments_agree_to_the_bit(name, observation, action, shared) -> None:
    settings = {
        "observation": observation, "action": action, "image_size": 8, "points": 16,
        "cameras": ("front",), "renderer": "software", **shared,
    }  # fmt: skip
    first, again = (
        few_steps(gym.make(name, disable_env_checker=True, **settings)) for _ in range(2)
    )
    assert first == again
    assert len(set(first)) > 4, "something moves"


@pytest.mark.slow
@pytest.mark.parametrize("task", ["PickPlace", "Push"])
def test_whole_episodes_with_contact_agree_to_the_bit(task, shared) -> None:
    """Grasping, carrying and pushing: sliding contacts, islands that wake and sleep."""

    def whole() -> tuple[list[bytes], bool, bool]:
        env = make_env(task=task, **shared)
        seen = [env.reset(seed=2)[0].tobytes()]
        expert, touched = TaskExpert(env), False
        expert.reset()
        for _ in range(120):
            observation, reward, _, _, info = env.step(expert.act())
            seen += [observation.tobytes(), np.float64(reward).tobytes()]
            touched |= bool(observation[32:34].any())
        return seen, touched, info["success"]

    first, again = whole(), whole()
    assert first[1:] == (True, True), "fingers have touched the target, and it is done"
    assert first == again


@pytest.mark.slow
@pytest.mark.parametrize("observation", ["state", "goal", "pixels", "pixels+state"])
def test_as_they_come_neither_checker_warns(observation) -> None:
    check(IDS[0], observation=observation)


@pytest.mark.slow
def test_depth_and_segmentation_pass_the_checkers() -> None:
    check(
        IDS[0], ".*unconventional shape", observation="pixels+state", image_size=(36, 40),
        cameras=("front", "wrist", "top"), kinds=("rgb", "depth", "segmentation"),
        gripper="binary", control_hz=50,
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("renderer", ["auto", "software"])
def test_render_modes_pass_the_checker(renderer) -> None:
    env = gym.make(IDS[0], scenes=toy_scene(), render_mode="rgb_array", render_size=(16, 16),
                   renderer=renderer)  # fmt: skip
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=".*needs a display.*")
        check_env(env.unwrapped)
    env.close()


def small_round_scene():
    angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    outline = 0.35 * np.column_stack([np.cos(angle), np.sin(angle)])
    table = toy_table(outline, (0.7, 0.7, 0.45))
    things = (toy_object("cube_1", (0.04, 0.04, 0.04), (0.05, 0.0), top=0.45),)
    return toy_scene(things, table, "round")


@pytest.mark.slow
@pytest.mark.parametrize("observation", MODES)
def test_spaces_do_not_depend_on_the_scene(observation) -> None:
    many = tuple(
        toy_object(f"cube_{k}", (0.04, 0.04, 0.04), (-0.45 + 0.07 * k, 0.0)) for k in range(14)
    )
    envs = [
        make_env(scene, observation=observation, image_size=16, renderer="software")
        for scene in (toy_scene(), small_round_scene(), toy_scene(many))
    ]
    assert envs[0].observation_space == envs[1].observation_space == envs[2].observation_space
    for env in envs:
        assert env.observation_space.contains(env.reset(seed=0)[0])


def test_observations_stay_inside_the_space_when_things_fly_off() -> None:
    env = make_env(toy_scene(), observation="goal")
    env.reset(seed=0)
    world = env.world
    world.teleport(env.goal.target, np.array([30.0, 0.0, 5.0]))
    world.data.qvel[:] = 200.0
    observation = env.step(np.zeros(5, np.float32))[0]
    assert env.observation_space.contains(observation)


def test_the_flat_state_holds_what_its_table_says() -> None:
    env = make_env(toy_scene())
    state, _ = env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    world = env.world
    tcp = world.to_base(world.data.site_xpos[world.tcp])
    cube, bowl = (world.to_base(world.position(name)) for name in ("cube_1", "bowl_1"))
    assert np.allclose(state[0:7], world.data.qpos[world.arm_qpos], atol=1e-6)
    assert np.isclose(state[14], 0.08)
    assert np.allclose(state[15:18], tcp, atol=1e-6)
    assert np.allclose(state[34:37], cube - tcp, atol=1e-6)
    assert np.allclose(state[37:40], [-0.01, 0.6, 0.35], atol=1e-6)
    slots = state[40:268].reshape(SLOTS, 19)
    assert np.allclose(slots[0, :3], cube, atol=1e-6) and np.allclose(slots[0, 9:12], 0.0225)
    assert np.allclose(slots[1, :3], bowl, atol=1e-6)
    assert slots[:, 18].tolist() == [1.0] * 6 + [0.0] * 6 and not slots[6:].any()
    assert state[268] == 1.0
    assert np.allclose(state[269:271], bowl[:2], atol=1e-3)
    assert np.allclose(state[276:279], state[269:272] - cube, atol=1e-6)


def test_the_state_is_seen_from_the_robots_own_seat() -> None:
    """A scene rotated by half a turn about the table's centre gives the same state."""
    here = toy_object("cube_1", (0.04, 0.04, 0.04), (0.05, -0.1))
    env = make_env(toy_scene((here,)))
    state, _ = env.reset(seed=0, options={"goal": (0.2, 0.0)})
    world = env.world
    assert np.allclose(world.to_world(world.to_base(np.eye(3))), np.eye(3))
    back = world.to_world(state[40:43].astype(float))
    assert np.allclose(back, here.pose.position, atol=1e-5)
    forward = world.to_world(np.array([1.0, 0.0, 0.0])) - world.base_position
    assert np.allclose(forward, [np.cos(world.mount.yaw), np.sin(world.mount.yaw), 0.0])


@pytest.mark.slow
def test_pixels_show_the_scene() -> None:
    env = make_env(toy_scene(), observation="pixels+state", image_size=48)
    seen, _ = env.reset(seed=0)
    assert set(seen) == {"front", "wrist", "state"}
    assert seen["front"].shape == (48, 48, 3) and seen["front"].std() > 10
    assert not np.array_equal(seen["front"], seen["wrist"])
    env.close()
