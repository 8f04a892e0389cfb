"""Domain randomisation: settings, independent draws, exact restoration, the environment."""

import json
from dataclasses import fields, replace

import gymnasium as gym
import mujoco
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from randomized import OPTIONS, STRONG, only, started
from stable_baselines3.common.env_checker import check_env as sb3_check_env
from toy import toy_objects, toy_scene

from generator.errors import InputError
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.goals.goal import Raised
from tabletopgen_env.randomization import PRESETS, SWITCHES, Randomization, Randomizer
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.tasks.task import episode as begun
from tabletopgen_env.world.world import World


def model_bytes(world: World) -> bytes:
    buffer = np.zeros(mujoco.mj_sizeModel(world.model), np.uint8)
    mujoco.mj_saveModel(world.model, None, buffer)
    return buffer.tobytes()


# --------------------------------------------------------------------------------------- settings
def test_every_setting_belongs_to_one_switch_and_is_off() -> None:
    listed = [name for names in SWITCHES.values() for name in names]
    assert sorted(listed) == sorted(field.name for field in fields(Randomization))
    assert not any(Randomization().is_on(switch) for switch in SWITCHES)
    assert all(STRONG.is_on(switch) for switch in SWITCHES)
    for switch in SWITCHES:
        assert [s for s in SWITCHES if only(switch).is_on(s)] == [switch]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"light_turn": -0.1}, "light_turn must be a number >= 0 and <= 1.5708, got -0.1"),
        ({"tint": 1.5}, "tint must be a number >= 0 and <= 1, got 1.5"),
        ({"camera_move": float("nan")}, "camera_move must be a number >= 0 and <= 1"),
        ({"position_noise": "much"}, "position_noise must be a number .*, got 'much'"),
        ({"table_height": 0.2}, "table_height must be a number >= 0 and <= 0.08"),
        ({"turn": True}, "turn must be a number >= 0"),
        ({"mass": (1.2, 0.8)}, "0 < low <= high, got \\(1.2, 0.8\\)"),
        ({"mass": (0.0, 1.0)}, "0 < low <= high"),
        ({"friction": (-1.0, 1.0)}, "0 < low <= high"),
        ({"stiffness": 0.1}, "must be two factors"),
        ({"damping": (1.0, 1.0, 1.0)}, "must be two factors"),
        ({"ambient": (1.0, float("inf"))}, "0 < low <= high"),
        ({"delay": -1}, "delay must be a whole number >= 0 and <= 100"),
        ({"delay": 1.5}, "delay must be a whole number"),
        ({"distractors": (4, 2)}, "0 <= min <= max, got \\(4, 2\\)"),
        ({"distractors": (-1, 2)}, "0 <= min <= max"),
        ({"distractors": 3}, "two whole numbers"),
        (
            {"lights": True},
            "set light_turn and light_color and ambient to turn on the switch 'lights'",
        ),
        ({"masss": (0.5, 2.0)}, "no setting 'masss'.*Did you mean 'mass'"),
    ],
)
def test_wrong_settings_are_refused(settings, message) -> None:
    with pytest.raises(InputError, match=f"Randomization.*{message}"):
        Randomization(**settings)


def test_presets_go_by_name_and_lists_are_ranges() -> None:
    assert Randomizer("light").settings == PRESETS["light"]
    assert Randomizer(None).settings == Randomization()
    assert Randomization(mass=[0.5, 2.0]) == Randomization(mass=(0.5, 2.0))  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"Unknown randomization 'srong'.*Did you mean 'strong'"):
        make_env(toy_scene(), randomization="srong")
    with pytest.raises(InputError, match="Unknown randomization True"):
        make_env(toy_scene(), randomization=True)


# --------------------------------------------------------------------------- draws and undoing
def test_off_it_changes_nothing_and_draws_nothing() -> None:
    env, _, drawn = started(None)
    assert drawn == {}
    assert model_bytes(env.world) == model_bytes(marked(World(toy_scene(), Panda()), env))


def marked(world: World, env: TabletopEnv) -> World:
    """The world with the marker as ``env`` shows it."""
    world.show_marker(env.goal.spot, env.task.marker_radius)
    return world


@pytest.mark.slow
@pytest.mark.parametrize("switch", SWITCHES)
def test_a_switch_draws_the_same_whatever_else_is_on(switch) -> None:
    everything = started(STRONG, seed=4)[2]
    alone = started(only(switch), seed=4)[2]
    assert set(alone) == {switch} and set(everything) == set(SWITCHES)
    if switch == "start":  # which of its draws has room depends on where things are
        assert alone[switch]["joints"] == everything[switch]["joints"]
        there = {n: getattr(Randomization(), n) for s in ("poses", "table") for n in SWITCHES[s]}
        everything = started(replace(STRONG, **there), seed=4)[2]
    assert alone[switch] == everything[switch]


@pytest.mark.slow
def test_what_is_drawn_leaves_scenes_and_tasks_as_they_were() -> None:
    scenes = [toy_scene(name="a"), toy_scene(toy_objects()[:4], name="b")]
    settings = Randomization(tint=0.5, mass=(0.5, 2.0), delay=2, distractors=(0, 3))
    plain, changed = (make_env(scenes, randomization=choice) for choice in (None, settings))
    for seed in range(4):
        infos = [env.reset(seed=seed)[1] for env in (plain, changed)]
        for key in ("scene", "target", "goal", "instruction"):
            assert infos[0][key] == infos[1][key]


def test_same_seed_same_draws_and_trajectory_another_episode_others() -> None:
    runs = []
    for _ in range(2):
        env, seen, drawn = started("strong", seed=7)
        env.action_space.seed(0)
        run = [seen] + [env.step(env.action_space.sample())[0] for _ in range(8)]
        runs.append((run, drawn, env.reset(options=OPTIONS)[1]["randomization"]))
    assert all(np.array_equal(*pair) for pair in zip(runs[0][0], runs[1][0], strict=True))
    assert runs[0][1:] == runs[1][1:]
    assert all(runs[0][1][switch] != runs[0][2][switch] for switch in ("mass", "lights", "table"))


def test_what_was_drawn_is_plain_numbers() -> None:
    assert json.loads(json.dumps(started("strong")[2])) == started("strong")[2]


@pytest.mark.slow
@pytest.mark.parametrize("switch", [*SWITCHES, "everything"])
def test_a_world_is_put_back_to_the_byte(switch) -> None:
    randomizer = Randomizer(STRONG if switch == "everything" else only(switch))
    world, fresh = World(toy_scene(), Panda()), World(toy_scene(), Panda())
    compiled = model_bytes(world)
    for episode in range(3):
        randomizer.restart(np.random.default_rng(episode))
        randomizer.begin(world)
        randomizer.finish(world, begun(world, (Raised("cube_1", world.position("cube_1")),)))
        world.step(5)
    changed = model_bytes(world) != compiled or world.scene is not fresh.scene
    assert changed or switch in ("delay", "noise", "start")
    randomizer.restore(world)
    assert model_bytes(world) == compiled == model_bytes(fresh)
    assert world.absent == frozenset()
    for made in (world, fresh):
        made.reset()
        made.data.ctrl[made.actuators[:7]] += 0.05
        made.step(40)
    for name in ("qpos", "qvel", "xpos", "cam_xpos"):
        assert np.array_equal(getattr(world.data, name), getattr(fresh.data, name)), name
    assert np.array_equal(world.mount.position, fresh.mount.position)
    assert np.array_equal(world.base_position, fresh.base_position)


def test_episodes_do_not_add_up() -> None:
    env = make_env(toy_scene(), randomization=only("mass"))
    masses = World(toy_scene(), Panda()).model.body_mass
    for seed in range(3):
        drawn = env.reset(seed=seed)[1]["randomization"]["mass"]
        factors = [drawn[name] for name in env.world.names]
        assert np.allclose(env.world.model.body_mass[env.world.bodies],
                           masses[env.world.bodies] * factors)  # fmt: skip


@pytest.mark.slow
def test_pictures_are_those_of_the_unchanged_world_after_undoing() -> None:
    env, seen, _ = started(
        Randomization(light_turn=0.5, light_color=0.3, ambient=(0.5, 0.6), camera_move=0.05,
                      camera_turn=0.05, camera_fov=0.1, tint=0.6),
        observation="pixels", cameras=("front", "top"), image_size=24, renderer="software",
    )  # fmt: skip
    plain, usual, _ = started(None, observation="pixels", cameras=("front", "top"),
                              image_size=24, renderer="software")  # fmt: skip
    for camera in ("front", "top"):
        assert (seen[camera] != usual[camera]).mean() > 0.3
    env._randomizer.restore(env.world)
    env.world.reset()
    env.world.show_marker(env.goal.spot, env.task.marker_radius)
    again = env._drawer((24, 24))
    for camera, key in (("front", "front"), ("overhead", "top")):
        assert np.array_equal(again.rgb(env.world, camera), usual[key])
    plain.close()
    env.close()


# -------------------------------------------------------------------------------- as environment
@pytest.mark.slow
@pytest.mark.parametrize("observation", ["goal", "pixels+state"])
def test_both_checkers_pass_with_everything_on(observation) -> None:
    env = make_env(toy_scene(toy_objects()[:2]), observation=observation, image_size=36,
                   renderer="software", randomization="strong", points=64)  # fmt: skip
    check_env(env, skip_render_check=True)
    sb3_check_env(env, warn=False)


@pytest.mark.slow
def test_vectors_of_environments_pass_on_what_was_drawn() -> None:
    envs = gym.make_vec(
        "tabletopgen_env:TabletopGen/PickPlace-v0", num_envs=2, vectorization_mode="sync",
        scenes=toy_scene(), randomization="strong", max_episode_steps=3,
    )  # fmt: skip
    _, info = envs.reset(seed=[0, 1])
    heights = info["randomization"]["table"]["height"]
    assert heights.shape == (2,) and heights[0] != heights[1]
    for _ in range(5):
        envs.step(envs.action_space.sample())
    envs.close()
