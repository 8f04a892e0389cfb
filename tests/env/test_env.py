"""The environment with Gymnasium and SB3: determinism, options, vectors, training, errors."""

import pickle

import gymnasium as gym
import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene

from generator.errors import InputError, SceneError
from generator.scene import Scene
from tabletopgen_env.actions import ACTIONS
from tabletopgen_env.env import DRAWS, GoalTabletopEnv, TabletopEnv, make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.scenes import SceneRef

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"


def rollout(env: gym.Env, seed: int, steps: int = 30) -> list[np.ndarray]:
    """Observations and rewards of random actions over two episodes."""
    env.action_space.seed(seed)
    seen = []
    for episode_seed in (seed, None):
        observation, _ = env.reset(seed=episode_seed)
        seen.append(observation)
        for _ in range(steps):
            observation, reward, *_ = env.step(env.action_space.sample())
            seen += [observation, np.array(reward)]
    return seen


@pytest.mark.slow
@pytest.mark.parametrize("action", ACTIONS)
def test_same_seed_gives_the_same_trajectory_bit_for_bit(action) -> None:
    a = rollout(make_env([toy_scene(), toy_scene(toy_objects()[:4])], action=action), seed=3)
    b = rollout(make_env([toy_scene(), toy_scene(toy_objects()[:4])], action=action), seed=3)
    assert all(np.array_equal(x, y) for x, y in zip(a, b, strict=True))


def test_a_reused_environment_repeats_its_trajectory() -> None:
    env = make_env(toy_scene())
    first, again = rollout(env, seed=5), rollout(env, seed=5)
    assert all(np.array_equal(x, y) for x, y in zip(first, again, strict=True))


def test_other_seeds_differ() -> None:
    env = make_env(toy_scene())
    assert not np.array_equal(env.reset(seed=1)[0], env.reset(seed=2)[0])


def test_made_by_id_it_truncates_and_never_terminates() -> None:
    env = gym.make(ID, scenes=toy_scene(), max_episode_steps=5)
    env.reset(seed=0)
    ends = [env.step(env.action_space.sample())[2:4] for _ in range(5)]
    assert ends == [(False, False)] * 4 + [(False, True)]


def test_info_names_the_task_and_the_reward_terms() -> None:
    env = make_env(toy_scene())
    env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    _, reward, _, _, info = env.step(env.action_space.sample())
    assert info["instruction"] == "put the cube into the bowl"
    assert (info["scene"], info["target"], info["goal"]) == ("toy", "cube_1", "bowl_1")
    assert set(info["reward_terms"]) == {"reach", "grasp", "lift", "place", "met", "success"}
    assert info["success"] is info["is_success"] is False
    assert 0 < reward < 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("task", "options", "told"),
    [
        ("Reach", {}, (None, None)),
        ("Lift", {"target": "cube_1"}, ("cube_1", None)),
        ("Push", {"target": "cube_1"}, ("cube_1", "spot")),
        ("PickPlace", {"target": "cube_1", "goal": "spot"}, ("cube_1", "spot")),
        ("Swap", {"target": "cube_1", "goal": "can_1"}, ("can_1", "spot")),  # aside, at first
    ],
)
def test_info_names_a_goal_only_where_there_is_one(task, options, told) -> None:
    info = make_env(toy_scene(), task=task).reset(seed=0, options=options)[1]
    assert (info["target"], info["goal"]) == told
    envs = TabletopVectorEnv(2, scenes=toy_scene(), task=task, threads=1)
    _, infos = envs.reset(seed=0, options=options)
    assert list(infos["goal"]) == [told[1]] * 2
    envs.close()


@pytest.mark.parametrize("count", [1, 2])
def test_where_there_is_nothing_to_do_the_scenes_are_counted_once(count: int) -> None:
    box = (toy_object("box_1", (0.3, 0.3, 0.3), (0.0, 0.0)),)
    env = make_env([toy_scene(box, name=f"bare_{k}") for k in range(count)], task="Lift")
    said = "the one scene drawn" if count == 1 else "2 drawn scenes"
    with pytest.raises(SceneError, match=f"^There is no valid task in {said}. Scene 'bare_0'"):
        env.reset(seed=0)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"foo": 1}, "An environment has no setting 'foo'"),
        ({"contol_hz": 10}, "Did you mean 'control_hz'"),
        ({"robot": "panda"}, "robot must be a Panda .* got 'panda'"),
    ],
)
def test_settings_that_there_are_not_are_refused_when_it_is_made(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        gym.make(ID, scenes=toy_scene(), **settings)


def test_info_names_what_fell_off_the_table() -> None:
    env = make_env(toy_scene())
    assert env.reset(seed=0)[1]["off_table"] == ()
    env.world.teleport("can_1", np.array([0.9, 0.0, 0.76]))
    env.world.teleport("mug_1", np.array([0.0, 0.9, 0.76]))
    still = np.array([0.0, 0.0, 0.0, 0.0, 1.0])
    found = [env.step(still)[4]["off_table"] for _ in range(20)]
    assert found[0] == () and set(found[-1]) == {"can_1", "mug_1"}
    assert env.reset(seed=0)[1]["off_table"] == ()


def test_reset_options_choose_scene_target_and_spot() -> None:
    env = make_env(toy_scene())
    other = toy_scene((toy_object("pen_1", (0.02, 0.02, 0.05), (0.0, 0.0)),), name="other")
    _, info = env.reset(seed=0, options={"scene": other, "goal": (0.1, -0.15)})
    assert (info["scene"], info["target"], info["goal"]) == ("other", "pen_1", "spot")
    assert np.allclose(env.goal.spot, [0.1, -0.15, 0.74])


def test_a_given_container_draws_a_target_that_fits_it() -> None:
    die = toy_object("die_1", (0.02, 0.02, 0.02), (0.0, -0.2))
    env = make_env(toy_scene((*toy_objects(), die)))
    drawn = {env.reset(seed=k, options={"goal": "mug_1"})[1]["target"] for k in range(5)}
    assert drawn and drawn <= {"die_1", "cube_1"}  # nothing else here goes in


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"colour": "red"}, "Unknown reset option 'colour'"),
        ({"target": "cann_1"}, "No object 'cann_1'.*Did you mean 'can_1'"),
        ({"goal": "bole_1"}, "No object 'bole_1'.*bottle_1, bowl_1"),
        ({"target": "can_1", "goal": "cube_1"}, "not a container"),
        ({"goal": (3.0, 0.0)}, "not on the table"),
        ({"goal": (np.nan, 0.0)}, "two finite numbers"),
        *((kind, r"options must be a dict.*Available: goal, scene, target")
          for kind in (["a"], "scene", 3, ())),
    ],
)  # fmt: skip
def test_wrong_reset_options_are_explained(options, message) -> None:
    with pytest.raises(InputError, match=message):
        make_env(toy_scene()).reset(seed=0, options=options)


def test_a_scene_with_nothing_graspable_says_why() -> None:
    scene = toy_scene((toy_object("safe_1", (0.3, 0.3, 0.3), (0.0, 0.0), mass=20.0),))
    with pytest.raises(SceneError, match=r"safe_1: the mass of 20 kg exceeds"):
        make_env(scene).reset(seed=0)
    with pytest.raises(SceneError, match="no objects"):
        make_env(toy_scene(())).reset(seed=0)


@pytest.mark.slow
def test_scenes_with_nothing_to_do_are_passed_over() -> None:
    empty = toy_scene((), name="empty")
    env = make_env([empty, toy_scene()])
    assert {env.reset(seed=seed)[1]["scene"] for seed in range(6)} == {"toy"}


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"observation": "stat"}, "Did you mean 'state'"),
        ({"action": "ee"}, "Available: ee_absolute, ee_delta, .*joint_target"),
        ({"gripper": "open"}, "Available: binary, continuous"),
        ({"control_hz": 30}, "must divide the 500"),
        ({"reward": "shaped"}, "Available: dense, sparse"),
        ({"render_mode": "ansi"}, "Available: depth_array, human, rgb_array"),
        ({"observation": "pixels", "image_size": 4}, "between 8 and 2048"),
        ({"renderer": "vulkan"}, "Available: auto, gl, software"),
        ({"scenes": 7}, "scenes has type int"),
        ({"action": ["ee_delta"]}, r"Unknown action mode \['ee_delta'\].*Available: ee_absolute"),
        ({"observation": ["state"]}, "Available: goal, pixels"),
        ({"cameras": [["front"]]}, "Unknown camera.*Available: front, side, top, wrist"),
        ({"cache": 0}, "cache must be a whole number >= 1, got 0"),
        ({"cache": "all"}, "cache must be a whole number >= 1, got 'all'"),
        (
            {"render_size": (0, 0)},
            r"render_size must be .* between 8 and 4096 pixels, got \(0, 0\)",
        ),
        ({"render_size": "big"}, r"one number or \(height, width\), .* got 'big'"),
        ({"render_size": (480,)}, r"render_size must be"),
        ({"render_size": None}, r"render_size must be"),
        ({"certified": "yes"}, "certified must be True or False, got 'yes'"),
        ({"grasp_hint": "x"}, "grasp_hint must be True, False, 'planned' or 'detected', got 'x'"),
        ({"grasp_hint": ["x"]}, r"grasp_hint must be .*got \['x'\]"),
        ({"grasp_hint": 1}, r"grasp_hint must be .*got 1"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        make_env(**{"scenes": toy_scene(), **settings})


@pytest.mark.slow
def test_render_size_may_be_one_number() -> None:
    env = make_env(toy_scene(), render_mode="depth_array", render_size=16, renderer="software")
    env.reset(seed=0)
    assert env.render().shape == (16, 16)


def test_stepping_before_reset_and_closing_twice() -> None:
    env = make_env(toy_scene())
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        env.step(np.zeros(5))
    env.close()
    env.close()


@pytest.mark.parametrize(
    "options", [{"target": "nope_1"}, {"scene": toy_scene(())}, {"colour": "red"}]
)
def test_a_reset_that_fails_leaves_no_episode(options) -> None:
    env = make_env(toy_scene())
    env.reset(seed=0)
    with pytest.raises((InputError, SceneError)):
        env.reset(options=options)
    for ask in (lambda: env.step(np.zeros(5)), lambda: env.world, lambda: env.episode):
        with pytest.raises(InputError, match=r"Call reset\(\)"):
            ask()
    env.reset(seed=0)
    env.step(np.zeros(5))


def test_a_reset_that_fails_when_all_is_drawn_leaves_no_episode(monkeypatch) -> None:
    env = make_env(toy_scene(), task="Lift")
    env.reset(seed=0)
    with monkeypatch.context() as broken, pytest.raises(ZeroDivisionError):
        broken.setattr(type(env.task), "desired_goal", lambda *_: 1 / 0)
        env.reset()
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        env.step(np.zeros(5))


def test_sparse_rewards_are_zero_or_minus_one() -> None:
    env = make_env(toy_scene(), reward="sparse")
    env.reset(seed=0)
    assert env.step(env.action_space.sample())[1] == -1.0


def test_the_goal_environment_alone_has_compute_reward() -> None:
    assert isinstance(make_env(toy_scene(), observation="goal"), GoalTabletopEnv)
    assert not hasattr(TabletopEnv, "compute_reward")


@pytest.mark.parametrize("reward", ["dense", "sparse"])
def test_compute_reward_is_vectorised_and_agrees_with_step(reward) -> None:
    env = make_env(toy_scene(), observation="goal", reward=reward)
    env.reset(seed=0)
    steps = [env.step(env.action_space.sample()) for _ in range(8)]
    achieved = np.array([s[0]["achieved_goal"] for s in steps])
    desired = np.array([s[0]["desired_goal"] for s in steps])
    rewards = env.compute_reward(achieved, desired, [s[4] for s in steps])
    assert rewards.shape == (8,)
    assert np.array_equal(rewards, [s[1] for s in steps])
    best = env.compute_reward(achieved, achieved, None)
    assert np.array_equal(best, np.full(8, 1.0 if reward == "dense" else 0.0))


@pytest.mark.slow
def test_two_environments_in_processes_step_apart() -> None:
    envs = gym.make_vec(
        ID, num_envs=2, vectorization_mode="async", scenes=toy_scene(), max_episode_steps=4
    )
    first, info = envs.reset(seed=[0, 1])
    assert first.shape == (2, 279) and len(info["instruction"]) == 2
    assert not np.array_equal(first[0], first[1])
    for _ in range(6):
        observation, reward, terminated, _, _ = envs.step(envs.action_space.sample())
    assert observation.shape == (2, 279) and reward.shape == (2,) and not terminated.any()
    alone = make_env(toy_scene())
    assert np.array_equal(alone.reset(seed=1)[0], first[1])
    envs.close()


def test_the_spec_survives_pickling() -> None:
    spec = gym.make(ID, scenes=toy_scene()).spec
    assert pickle.loads(pickle.dumps(spec)).id == "TabletopGen/PickPlace-v0"


@pytest.mark.slow
def test_a_policy_trains_with_ppo() -> None:
    from stable_baselines3 import PPO

    env = gym.make(ID, scenes=toy_scene(), max_episode_steps=40)
    model = PPO("MlpPolicy", env, n_steps=64, batch_size=32, n_epochs=2, seed=0, device="cpu")
    model.learn(192)
    assert model.num_timesteps == 192
    action, _ = model.predict(env.reset(seed=0)[0], deterministic=True)
    assert env.action_space.contains(action)


@pytest.mark.slow
def test_a_policy_trains_with_sac_and_hindsight() -> None:
    from stable_baselines3 import SAC, HerReplayBuffer

    env = gym.make(
        ID, scenes=toy_scene(), observation="goal", reward="sparse", max_episode_steps=40
    )
    model = SAC(
        "MultiInputPolicy", env, replay_buffer_class=HerReplayBuffer,
        replay_buffer_kwargs={"n_sampled_goal": 4}, learning_starts=100, buffer_size=2000,
        batch_size=64, policy_kwargs={"net_arch": [32, 32]}, seed=0, device="cpu",
    )  # fmt: skip
    model.learn(200)
    assert model.num_timesteps == 200
    sampled = model.replay_buffer.sample(64)
    assert sampled.rewards.max() == 0.0  # hindsight found successes


@pytest.mark.parametrize("failures", [2, 1000])
def test_a_table_that_cannot_be_made_is_passed_over(failures: int) -> None:
    tried = []

    def load() -> Scene:
        tried.append(len(tried))
        if len(tried) <= failures:
            raise SceneError("It would not settle.")
        return toy_scene()

    class Unsound:
        def draw(self, rng: np.random.Generator) -> SceneRef:
            return SceneRef("unsound", load)

    env = make_env(Unsound(), task="Lift")
    if failures > DRAWS:
        with pytest.raises(SceneError, match="would not settle"):
            env.reset(seed=0)
        assert len(tried) == DRAWS
    else:
        env.reset(seed=0)
        assert len(tried) == failures + 1
