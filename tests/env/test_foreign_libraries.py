"""The environments with Gymnasium wrappers, Stable-Baselines3, its contrib and TorchRL.

What is not installed is skipped, with the command that installs it.
"""

import subprocess
import sys
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from toy import toy_object, toy_scene

import tabletopgen_env  # registers the environments  # noqa: F401
from generator.errors import InputError, TabletopError
from generator.scene import Scene

ID = "tabletopgen_env:TabletopGen/Lift-v0"
IDS = sorted(name for name in gym.registry if name.startswith("TabletopGen/"))
SMALL: dict[str, Any] = {"image_size": 36, "cameras": ("front",), "renderer": "software"}


def need(package: str, extra: str) -> Any:
    """Return a package, or skip the test and say how to install it."""
    return pytest.importorskip(
        package, reason=f"{package} is not installed: pip install 'tabletopgen[{extra}]'"
    )


def bare() -> Scene:
    """A scene with nothing to lift."""
    return toy_scene((toy_object("box_1", (0.3, 0.3, 0.3), (0.0, 0.0)),), name="bare")


# -------------------------------------------------------------------------------------- Gymnasium


@pytest.mark.parametrize("options", [{"scene": "typo"}, {"scene": bare()}, {"target": "typo"}])
def test_a_first_reset_that_fails_leaves_the_environment_sound(options: dict[str, Any]) -> None:
    env = gym.make(ID, scenes=toy_scene())
    with pytest.raises(TabletopError):
        env.reset(options=options)
    with pytest.raises(InputError, match="Call reset"):
        env.step(env.action_space.sample())
    first, _ = env.reset(seed=3)
    again, _ = gym.make(ID, scenes=toy_scene()).reset(seed=3)
    assert np.array_equal(first, again)
    for _ in range(3):
        assert env.observation_space.contains(env.step(env.action_space.sample())[0])
    env.close()


def test_no_registered_id_is_wrapped_in_what_a_failed_reset_breaks() -> None:
    assert IDS and all(gym.registry[name].disable_env_checker for name in IDS)


def test_gymnasiums_order_and_time_limit_are_kept() -> None:
    env = gym.make(ID, scenes=toy_scene(), max_episode_steps=2)
    with pytest.raises(gym.error.ResetNeeded):
        env.step(env.action_space.sample())
    env.reset(seed=0)
    assert [env.step(env.action_space.sample())[3] for _ in range(2)] == [False, True]
    env.close()


@pytest.mark.parametrize("make", [gym.make, gym.make_vec], ids=["make", "make_vec"])
def test_an_unknown_keyword_is_a_type_error_as_of_any_function(make) -> None:
    message = "unexpected keyword argument 'frameskip'.*Available: .*certified"
    with pytest.raises(TypeError, match=message) as raised:
        make(ID, scenes=toy_scene(), frameskip=4)
    assert isinstance(raised.value, InputError)


@pytest.mark.parametrize("many", [False, True])
def test_infos_of_numbers_hold_the_same_numbers_each_time(many: bool) -> None:
    settings: dict[str, Any] = {"scenes": toy_scene(), "infos": "numbers"}
    env = gym.make_vec(ID, num_envs=2, **settings) if many else gym.make(ID, **settings)
    _, first = env.reset(seed=0)
    later = env.step(env.action_space.sample())[4]
    assert first.keys() == later.keys()
    for info in (first, later):
        assert {"success", "is_success", "certified", "reward_reach"} <= info.keys()
        assert all(np.asarray(value).dtype.kind in "fb" for value in info.values())
    env.close()
    with pytest.raises(InputError, match="Unknown infos 'number'"):
        gym.make(ID, scenes=toy_scene(), infos="number")


# ------------------------------------------------------------------------- Stable-Baselines3


@pytest.mark.slow
def test_sb3_learns_from_all_that_a_robot_has() -> None:
    sb3 = need("stable_baselines3", "train")
    env = gym.make(
        ID, scenes=toy_scene(), observation="pixels+proprio", instruction="embedding", **SMALL
    )
    model = sb3.PPO("MultiInputPolicy", env, n_steps=8, batch_size=8, n_epochs=1, device="cpu")
    model.learn(16)
    assert model.num_timesteps == 16
    env.close()


def test_a_text_that_sb3_cannot_read_is_announced_when_it_is_made() -> None:
    need("stable_baselines3", "train")
    with pytest.warns(UserWarning, match="instruction='embedding'"):
        gym.make(ID, scenes=toy_scene(), observation="pixels+proprio", **SMALL)


_LATE_IMPORT = """
import sys, warnings, gymnasium as gym
from tabletopgen_env.observations.instructions import instruction_space
space = gym.spaces.Dict({"instruction": instruction_space("text")})
assert space["instruction"].shape is None and "stable_baselines3" not in sys.modules
from stable_baselines3.common.vec_env import DummyVecEnv
class Bare(gym.Env):
    observation_space, action_space = space, gym.spaces.Discrete(2)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    try:
        DummyVecEnv([Bare])
    except TypeError as error:
        print("failed:", error)
print("warnings:", *[str(w.message) for w in caught if "instruction=" in str(w.message)])
"""


@pytest.mark.slow
def test_a_text_that_sb3_cannot_read_is_announced_if_sb3_is_imported_later() -> None:
    need("stable_baselines3", "train")
    done = subprocess.run(
        [sys.executable, "-c", _LATE_IMPORT], capture_output=True, text=True, timeout=240,
        check=True,
    )  # fmt: skip
    assert "failed: 'NoneType' object is not iterable" in done.stdout
    assert done.stdout.count("instruction='embedding'") == 1


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", ["TQC", "RecurrentPPO", "TRPO", "ARS"])
def test_sb3_contrib_learns(algorithm: str) -> None:
    contrib = need("sb3_contrib", "contrib")
    policy = {"RecurrentPPO": "MlpLstmPolicy"}.get(algorithm, "MlpPolicy")
    settings: dict[str, dict[str, Any]] = {
        "TQC": {"learning_starts": 8, "batch_size": 8, "buffer_size": 100},
        "RecurrentPPO": {"n_steps": 16, "batch_size": 8, "n_epochs": 1},
        "TRPO": {"n_steps": 16, "batch_size": 8},
        "ARS": {"n_delta": 1},
    }
    env = gym.make(ID, scenes=toy_scene(), max_episode_steps=8)
    kind = getattr(contrib, algorithm)
    model = kind(policy, env, device="cpu", seed=0, **settings[algorithm])
    model.learn(16)
    assert model.num_timesteps >= 16
    env.close()


# ------------------------------------------------------------------------------------- TorchRL


def rolled(env: Any) -> list[Any]:
    """Check an environment's specs as TorchRL does; return when its episodes end in five steps."""
    from torchrl.envs.utils import check_env_specs

    try:
        check_env_specs(env)
        played = env.rollout(5, break_when_any_done=False)
        return played["next", "done"].squeeze(-1).tolist()
    finally:
        env.close()


ENDS = [[False, False, True, False, False]]


@pytest.mark.slow
@pytest.mark.parametrize("observation", ["state", "goal", "pixels+proprio", "point_cloud+state"])
def test_torchrl_makes_an_environment_by_its_id(observation: str) -> None:
    envs = need("torchrl.envs", "torchrl")
    more = {} if observation in ("state", "goal") else {**SMALL, "points": 16}
    env = envs.GymEnv(ID, scenes=toy_scene(), observation=observation, frame_skip=2, **more)
    assert rolled(env) == [False] * 5


@pytest.mark.slow
@pytest.mark.parametrize("processes", [None, 1])
@pytest.mark.parametrize(
    ("mode", "observation", "infos"),
    [("Disabled", "state", "all"), ("Disabled", "goal", "all"), ("SameStep", "state", "numbers")],
)
def test_torchrl_wraps_a_vector_environment(
    mode: str, observation: str, infos: str, processes: int | None
) -> None:
    envs = need("torchrl.envs", "torchrl")
    vector = gym.make_vec(
        ID, num_envs=2, scenes=toy_scene(), autoreset_mode=mode, max_episode_steps=3,
        observation=observation, infos=infos, processes=processes,
    )  # fmt: skip
    assert rolled(envs.GymWrapper(vector)) == ENDS * 2


@pytest.mark.slow
def test_torchrl_makes_a_vector_of_processes_by_an_id() -> None:
    envs = need("torchrl.envs", "torchrl")
    env = envs.GymEnv(ID, num_envs=2, scenes="office-desk", infos="numbers")
    assert rolled(env) == [[False] * 5] * 2
