"""The vector environment: identical to single ones, Gymnasium's contract, clear errors."""

import subprocess
import sys
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode
from rollouts import rollout, same
from toy import toy_objects, toy_scene
from worlds import two_scenes

from generator.errors import InputError, SceneError
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.parallel.workers.checks import read_mode
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import SceneRef, resolve
from tabletopgen_env.world.worlds import Masters

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"
MODES = [mode.value for mode in AutoresetMode]


@pytest.mark.slow
@pytest.mark.parametrize("observation", ["state", "goal"])
@pytest.mark.parametrize("mode", MODES)
def test_it_is_gymnasiums_serial_vector_to_the_bit(mode, observation) -> None:
    setting = {"scenes": two_scenes(), "observation": observation, "max_episode_steps": 4}
    serial = gym.make_vec(
        ID,
        num_envs=3,
        vectorization_mode="sync",
        vector_kwargs={"autoreset_mode": AutoresetMode(mode)},
        **setting,
    )
    own = gym.make_vec(ID, num_envs=3, autoreset_mode=mode, threads=2, **setting)
    assert isinstance(own, TabletopVectorEnv)
    assert own.metadata["autoreset_mode"] == serial.metadata["autoreset_mode"]
    assert own.observation_space == serial.observation_space
    masked = mode == "Disabled"
    a, b = rollout(serial, masked=masked), rollout(own, masked=masked)
    assert same(a, b)
    assert any("final_obs" in info for *_, info in b) == (mode == "SameStep")


@pytest.mark.slow
def test_the_number_of_threads_changes_nothing() -> None:
    runs = [
        rollout(TabletopVectorEnv(5, scenes=two_scenes(), threads=n, max_episode_steps=4))
        for n in (1, 2, 5)
    ]
    assert same(runs[0], runs[1]) and same(runs[0], runs[2])


@pytest.mark.slow
def test_slots_are_single_environments_with_their_seeds() -> None:
    envs = TabletopVectorEnv(2, scenes=two_scenes(), threads=2)
    together, _ = envs.reset(seed=[7, 3])
    steps = [envs.step(np.full((2, 5), 0.3)) for _ in range(10)]
    for k, seed in enumerate((7, 3)):
        alone = make_env(two_scenes())
        assert np.array_equal(alone.reset(seed=seed)[0], together[k])
        for seen, reward, *_, info in steps:
            expected = alone.step(np.full(5, 0.3))
            assert np.array_equal(expected[0], seen[k]) and expected[1] == reward[k]
            assert expected[4]["instruction"] == info["instruction"][k]
    envs.close()


def test_what_was_returned_is_not_written_to_again() -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene())
    first = envs.reset(seed=0)
    kept = first[0].copy()
    envs.step(np.ones((2, 5)))
    assert np.array_equal(first[0], kept)
    envs.close()


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["sync", "async", "vector_entry_point"])
def test_it_can_be_made_in_every_way(mode) -> None:
    envs = gym.make_vec(ID, num_envs=2, vectorization_mode=mode, scenes=toy_scene())
    seen, _ = envs.reset(seed=0)
    assert envs.observation_space.contains(seen)
    assert envs.step(envs.action_space.sample())[1].shape == (2,)
    envs.close()


def test_attributes_are_called_got_and_set() -> None:
    envs = TabletopVectorEnv(3, scenes=two_scenes(), max_episode_steps=9)
    envs.reset(seed=0)
    assert envs.get_attr("reward") == ("dense",) * 3
    envs.set_attr("reward", ["sparse", "dense", "sparse"])
    assert envs.call("get_wrapper_attr", "reward") == ("sparse", "dense", "sparse")
    rewards = envs.step(np.zeros((3, 5)))[1]
    assert rewards[0] == rewards[2] == -1.0 < rewards[1]
    worlds = envs.get_attr("world")
    assert len({id(world.model) for world in worlds}) == 3, "models are written to"
    envs.close()


def test_options_reach_every_slot_and_a_mask_resets_some() -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene())
    with pytest.raises(InputError, match="Reset all slots"):
        envs.reset(options={"reset_mask": np.array([True, False])})
    options = {"target": "cube_1", "goal": "bowl_1"}
    _, info = envs.reset(seed=0, options=options)
    assert list(info["target"]) == ["cube_1"] * 2
    before = envs.step(np.ones((2, 5)))[0]
    mask = {"reset_mask": np.array([False, True])}
    after, info = envs.reset(options=mask)
    assert np.array_equal(before[0], after[0]) and not np.array_equal(before[1], after[1])
    assert info["_target"].tolist() == [False, True] and "reset_mask" in mask
    envs.close()


def test_slots_share_compiled_scenes_but_no_models() -> None:
    (ref,) = resolve(toy_scene()).refs
    loads = []
    counted = SceneRef(ref.key, lambda: loads.append(1) or ref.load())
    masters = Masters(Panda())
    first, second = masters.twin(counted), masters.twin(counted)
    assert len(loads) == 1 and first.model is not second.model
    first.show_marker(np.array([0.1, 0.0, 0.74]), 0.2)
    first.step(10)
    assert second.model.geom_size[second._marker_geom, 0] != 0.2 and second.data.time == 0.0


def test_masters_keep_the_scenes_used_last() -> None:
    loads = []
    refs = [resolve(toy_scene(toy_objects()[:1], name=str(k))).refs[0] for k in range(3)]
    refs = [SceneRef(r.key, lambda r=r: loads.append(r.key) or r.load()) for r in refs]
    masters = Masters(Panda(), size=2)
    for k in (0, 1, 0, 2, 0, 1):
        masters.twin(refs[k])
    assert [r.key for r in (refs[0], refs[1], refs[2], refs[1])] == loads


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"num_envs": 0}, "num_envs must be a whole number >= 1, got 0"),
        ({"num_envs": None}, "num_envs must be"),
        ({"threads": 0}, "threads must be a whole number >= 1, got 0"),
        ({"max_episode_steps": 0}, "max_episode_steps must be a whole number >= 1"),
        ({"cache": 0}, "cache must be a whole number >= 1, got 0"),
        ({"autoreset_mode": 3}, "Unknown autoreset mode 3.*Available: Disabled, NextStep"),
        ({"autoreset_mode": "samestep"}, "Did you mean 'SameStep'"),
        ({"observation": "stat"}, "Did you mean 'state'"),
        ({"thread": 2}, "no setting 'thread'.*Did you mean 'threads'"),
        ({"grasp_hnt": True}, "no setting 'grasp_hnt'.*Did you mean 'grasp_hint'"),
        ({"robot": "panda"}, "robot must be a Panda .* got 'panda'"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        TabletopVectorEnv(**{"num_envs": 2, "scenes": toy_scene(), **settings})


@pytest.mark.parametrize("mode", AutoresetMode)
def test_autoreset_modes_go_by_value_or_name(mode: AutoresetMode) -> None:
    assert read_mode(mode) is read_mode(mode.value) is read_mode(mode.name) is mode


def test_wrong_calls_are_explained() -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene(), max_episode_steps=1, autoreset_mode="Disabled")
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        envs.step(np.zeros((2, 5)))
    with pytest.raises(
        InputError, match="2 slots require a single seed or a list of 2 seeds, got 3"
    ):
        envs.reset(seed=[1, 2, 3])
    with pytest.raises(
        InputError, match=r"2 slots require a single seed or a list of 2 seeds, got 1\.5"
    ):
        envs.reset(seed=1.5)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="options must be a dict"):
        envs.reset(options=["reset_mask"])  # type: ignore[arg-type]
    for mask in (np.array([0, 1]), np.zeros(2, bool), np.ones(3, bool)):
        with pytest.raises(InputError, match="reset_mask must be an array of 2 bools"):
            envs.reset(options={"reset_mask": mask})
    with pytest.raises(InputError, match="Unknown reset option") as caught:
        envs.reset(options={"colour": 1})
    assert "slot 0" in caught.value.__notes__[0]
    envs.reset(seed=0)
    with pytest.raises(InputError, match="require one action each, got 1"):
        envs.step(np.zeros((1, 5)))
    for actions in (3, None, np.array(0.0)):
        with pytest.raises(InputError, match="2 slots require one action each, got"):
            envs.step(actions)
    with pytest.raises(InputError, match="must be finite") as caught:
        envs.step(np.array([[0.0] * 5, [np.nan] * 5]))
    assert "slot 1" in caught.value.__notes__[0]
    assert [world.data.time for world in envs.get_attr("world")] == [0.0, 0.0], "none has moved"
    envs.step(np.zeros((2, 5)))
    with pytest.raises(InputError, match=r"slots \[0, 1\] are over"):
        envs.step(np.zeros((2, 5)))
    envs.close()
    envs.close()
    with pytest.raises(InputError, match="closed"):
        envs.step(np.zeros((2, 5)))


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
def test_after_a_reset_that_fails_no_slot_moves_until_it_is_done(mode) -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene(), max_episode_steps=2, autoreset_mode=mode)
    envs.reset(seed=0)
    still = np.zeros((2, 5))
    envs.step(still)
    if mode == "NextStep":
        envs.step(still)  # the next step would reset the slots
    mask = {"reset_mask": np.array([False, True])}
    with pytest.raises(InputError, match="nope_1"):
        envs.reset(options={"target": "nope_1", **mask})
    with pytest.raises(InputError, match=r"Call reset\(\).* slots \[1\] have no episode"):
        envs.step(still)
    time = envs.envs[0].get_wrapper_attr("world").data.time
    assert time == pytest.approx(0.1 if mode == "NextStep" else 0.05), "it has not moved"
    envs.reset(options=mask)
    envs.step(still)
    envs.close()


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_a_slot_that_could_not_be_reset_by_a_step_has_no_episode(mode, monkeypatch) -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene(), max_episode_steps=1, autoreset_mode=mode)
    envs.reset(seed=0)
    still = np.zeros((2, 5))
    if mode == "NextStep":
        envs.step(still)

    def fails(**given: Any) -> Any:
        raise SceneError("nothing to do")

    with monkeypatch.context() as broken, pytest.raises(SceneError):
        broken.setattr(envs.envs[1], "reset", fails)
        envs.step(still)
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        envs.step(still)
    envs.reset(seed=0)
    envs.step(still)
    envs.close()


@pytest.mark.slow
def test_pictures_come_from_several_threads() -> None:
    settings: dict[str, Any] = {
        "scenes": toy_scene(),
        "observation": "pixels",
        "image_size": 24,
        "render_mode": "rgb_array",
        "render_size": (20, 30),
    }
    envs = TabletopVectorEnv(3, threads=2, **settings)
    seen, _ = envs.reset(seed=0)
    seen = envs.step(np.ones((3, 5)))[0]
    pictures = envs.render()
    assert [p.shape for p in pictures] == [(20, 30, 3)] * 3
    alone = make_env(**settings)
    for k in range(3):
        alone.reset(seed=k)
        expected = alone.step(np.ones(5))[0]
        assert all(np.array_equal(expected[key], seen[key][k]) for key in expected)
        assert np.array_equal(alone.render(), pictures[k])
    envs.close()
    alone.close()


@pytest.mark.slow
def test_a_program_that_forgets_to_close_it_ends() -> None:
    code = (
        "import sys; sys.path.insert(0, 'tests')\n"
        "from toy import toy_scene\n"
        "from tabletopgen_env.parallel.vector import TabletopVectorEnv\n"
        "envs = TabletopVectorEnv(2, threads=2, scenes=toy_scene(), observation='pixels',"
        " image_size=16)\n"
        "envs.reset(seed=0)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (0, "")


def test_it_is_a_vector_environment_of_the_registered_kind() -> None:
    envs = gym.make_vec(ID, num_envs=2, scenes=toy_scene())
    assert isinstance(envs, TabletopVectorEnv) and envs.spec.id == "TabletopGen/PickPlace-v0"
    assert envs.envs[0].get_wrapper_attr("_max_episode_steps") == 200
    envs.close()
