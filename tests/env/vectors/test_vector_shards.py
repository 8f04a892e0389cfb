"""Slots in processes equal slots on threads, bit for bit, with the same interface."""

import copy
import itertools
import multiprocessing
import os
import pickle
import threading
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
import shard_tasks
from extent import part_of
from gymnasium.vector import AutoresetMode
from rollouts import rollout, same
from toy import toy_scene
from worlds import two_scenes

from generator.errors import InputError, SceneError
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.scenes import CurriculumScenes, RefreshingScenes

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"
STILL = np.zeros((3, 5))


@pytest.fixture(scope="module")
def shards() -> Any:
    """Three slots in two processes; tests leave them reset."""
    envs = TabletopVectorEnv(3, scenes=two_scenes(), processes=2, autoreset_mode="Disabled")
    yield envs
    envs.close()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("mode", "observation"),
    part_of(
        itertools.product([mode.value for mode in AutoresetMode], ["state", "goal"]),
        ("SameStep", "state"), ("NextStep", "goal"), ("Disabled", "goal"),
    ),
)  # fmt: skip
def test_a_rollout_is_that_of_threads_to_the_bit(mode: str, observation: str) -> None:
    setting: dict[str, Any] = {
        "scenes": two_scenes(), "observation": observation, "max_episode_steps": 4,
        "autoreset_mode": mode, "randomization": "light",
    }  # fmt: skip
    masked = mode == "Disabled"
    threads = rollout(TabletopVectorEnv(3, threads=2, **setting), masked=masked)
    shards = rollout(TabletopVectorEnv(3, processes=2, **setting), masked=masked)
    assert same(threads, shards)
    assert any("final_obs" in info for *_, info in shards) == (mode == "SameStep")


@pytest.mark.slow
def test_the_number_of_processes_changes_nothing() -> None:
    runs = [
        rollout(TabletopVectorEnv(3, scenes=two_scenes(), processes=n, max_episode_steps=4))
        for n in (1, 2, 4)
    ]
    assert all(same(runs[0], run) for run in runs[1:])


def test_slots_are_single_environments_with_their_seeds(shards: Any) -> None:
    together, _ = shards.reset(seed=[7, 3, 11])
    steps = [shards.step(np.full((3, 5), 0.3)) for _ in range(10)]
    for k, seed in enumerate((7, 3, 11)):
        alone = make_env(two_scenes())
        assert np.array_equal(alone.reset(seed=seed)[0], together[k])
        for seen, reward, *_, info in steps:
            expected = alone.step(np.full(5, 0.3))
            assert np.array_equal(expected[0], seen[k]) and expected[1] == reward[k]
            assert expected[4]["instruction"] == info["instruction"][k]


@pytest.mark.slow
def test_pictures_and_renders_come_from_processes() -> None:
    setting: dict[str, Any] = {
        "scenes": toy_scene(), "observation": "pixels+state", "image_size": 24,
        "render_mode": "rgb_array", "render_size": (20, 30),
    }  # fmt: skip
    envs = [TabletopVectorEnv(3, **setting, **how) for how in ({"threads": 1}, {"processes": 2})]
    drawn = []
    for each in envs:
        each.reset(seed=0)
        drawn.append([*(each.step(np.ones((3, 5))) for _ in range(2)), each.render()])
        each.close()
    assert same(*drawn) and drawn[0][0][0]["front"].shape == (3, 24, 24, 3)


def test_slots_are_split_evenly_and_in_order(shards: Any) -> None:
    pids = shards.visit(shard_tasks.pid)
    assert pids == [shards.pids[0], shards.pids[0], shards.pids[1]] and os.getpid() not in pids
    assert shards.visit(shard_tasks.pid, [2, 0]) == [pids[2], pids[0]]
    for wrong in (3, -1):
        with pytest.raises(InputError, match="Slots must be from 0 to 2, got"):
            shards.visit(shard_tasks.pid, [wrong])


def test_what_was_returned_is_not_written_to_again(shards: Any) -> None:
    first, info = shards.reset(seed=0)
    kept, terms = first.copy(), info["reward_terms"]["reach"].copy()
    shards.step(np.ones((3, 5)))
    assert np.array_equal(first, kept) and np.array_equal(info["reward_terms"]["reach"], terms)


def test_attributes_are_called_got_and_set(shards: Any) -> None:
    shards.reset(seed=0)
    assert shards.get_attr("reward") == ("dense",) * 3
    shards.set_attr("reward", ["sparse", "dense", "sparse"])
    assert shards.call("get_wrapper_attr", "reward") == ("sparse", "dense", "sparse")
    rewards = shards.step(STILL)[1]
    assert rewards[0] == rewards[2] == -1.0 < rewards[1]
    shards.set_attr("reward", "dense")
    assert [len(rng.random(2)) for rng in shards.np_random] == [2, 2, 2]
    assert shards.visit(lambda env: env.unwrapped.world.data.time) == pytest.approx([0.05] * 3)
    with pytest.raises(InputError, match="requires one value for each of the"):
        shards.set_attr("reward", ["dense"])
    with pytest.raises(InputError, match="in other processes; use call"):
        _ = shards.envs


def test_a_mask_resets_some_slots_and_options_reach_them(shards: Any) -> None:
    shards.reset(seed=0)
    before = shards.step(np.ones((3, 5)))[0]
    mask = {"reset_mask": np.array([False, False, True]), "target": "cube_1"}
    after, info = shards.reset(options=mask)
    assert np.array_equal(before[:2], after[:2]) and not np.array_equal(before[2], after[2])
    assert info["_target"].tolist() == [False, False, True] and info["target"][2] == "cube_1"


def test_errors_arrive_with_their_class_and_slot(shards: Any) -> None:
    shards.reset(seed=0)
    with pytest.raises(InputError, match="Unknown reset option 'colour'") as caught:
        shards.reset(options={"colour": 1})
    assert caught.value.__notes__ == ["(in slot 0 of the vector environment)"]
    with pytest.raises(InputError, match=r"Call reset\(\).*slots \[0, 1, 2\] have no episode"):
        shards.step(STILL)
    shards.reset(seed=0)
    with pytest.raises(InputError, match="must be finite") as caught:
        shards.step(np.array([[0.0] * 5, [0.0] * 5, [np.nan] * 5]))
    assert "slot 2" in caught.value.__notes__[0]
    with pytest.raises(InputError, match="cannot be sent between processes"):
        shards.visit(lambda env: threading.Lock())
    held = threading.Lock()
    with pytest.raises(InputError, match="The functions for the slots cannot be sent"):
        shards.visit(lambda env: held)
    with pytest.raises(AttributeError, match="nothing"):
        shards.get_attr("nothing")
    assert shards.step(STILL)[1].shape == (3,), "the shards go on"


def test_errors_of_others_keep_their_traceback(shards: Any) -> None:
    shards.reset(seed=0)

    def fail(env: gym.Env) -> None:
        raise shard_tasks.UnportableError("no ", "words")

    with pytest.raises(RuntimeError, match="UnportableError: no words") as caught:
        shards.visit(fail, [1])
    told = "".join(caught.value.__notes__)
    assert "slot 1" in told and "in fail" in told
    with pytest.raises(ZeroDivisionError):
        shards.visit(lambda env: 1 / 0)


def test_what_cannot_be_sent_is_refused_before_anything_starts() -> None:
    class Held(shard_tasks.Reach):
        def __init__(self) -> None:
            super().__init__()
            object.__setattr__(self, "held", threading.Lock())

    with pytest.raises(InputError, match="the scenes and the settings cannot be sent between"):
        TabletopVectorEnv(2, scenes=toy_scene(), task=Held(), processes=1)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"processes": 0}, "processes must be a whole number >= 1, got 0"),
        ({"processes": 1.5}, "processes must be a whole number >= 1"),
        ({"processes": 2, "threads": 2}, "only one of threads=2 and processes=2"),
        ({"process": 2}, "no setting 'process'.*Did you mean 'processes'"),
        ({"processes": 1, "observation": "stat"}, "Did you mean 'state'"),
    ],
)
def test_wrong_settings_are_explained(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        TabletopVectorEnv(**{"num_envs": 2, "scenes": toy_scene(), **settings})


@pytest.mark.slow
@pytest.mark.parametrize("copied", [copy.deepcopy, lambda envs: pickle.loads(pickle.dumps(envs))])
def test_a_copy_has_processes_of_its_own_and_goes_on_alike(copied: Any) -> None:
    envs: Any = gym.make_vec(ID, num_envs=3, scenes=two_scenes(), processes=2, max_episode_steps=2)
    envs.reset(seed=1)
    actions = np.full((3, 5), 0.3, np.float32)
    envs.step(actions)
    other = copied(envs)
    assert not {*other.pids} & {*envs.pids}
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        other.step(actions)
    assert same(other.reset(), envs.reset())
    for _ in range(4):
        assert same(envs.step(actions), other.step(actions))
    envs.close()
    assert other.step(actions)[1].shape == (3,)
    other.close()
    with pytest.raises(InputError, match="closed"):
        copied(other).reset()


@pytest.mark.slow
def test_it_is_made_by_its_id() -> None:
    envs: Any = gym.make_vec(ID, num_envs=3, scenes=toy_scene(), processes=4)
    assert len(envs.pids) == 3 and envs.spec.id == "TabletopGen/PickPlace-v0"
    seen, _ = envs.reset(seed=0)
    assert envs.observation_space.contains(seen)
    assert envs.step(envs.action_space.sample())[1].shape == (3,)
    envs.close()


@pytest.mark.slow
def test_one_source_is_asked_by_all_processes_and_told_how_episodes_end() -> None:
    source = shard_tasks.Counting()
    envs = TabletopVectorEnv(
        4, task="Reach", scenes=source, processes=2, max_episode_steps=2, cache=2
    )
    for _ in range(3):
        envs.reset(seed=0)
        for _ in range(2):
            envs.step(np.zeros((4, 5)))
    assert source.draws == 12 and source.records == [False] * 8
    for keys in envs.visit(shard_tasks.key):
        assert {*keys.split(",")} <= {"lent:0", "lent:1"}, "compiled worlds are met again"
    envs.close()
    assert source.closed == 0, "it was passed in"


@pytest.mark.slow
def test_a_curriculum_learns_of_all_slots_together() -> None:
    def played(**how: Any) -> tuple[list[Any], CurriculumScenes]:
        scenes = [toy_scene(name=f"scene_{k}") for k in range(4)]
        source = CurriculumScenes(scenes)
        envs = TabletopVectorEnv(3, task="Reach", scenes=source, max_episode_steps=2, **how)
        return rollout(envs), source

    (threads, one), (shards, other) = played(threads=1), played(processes=1)
    assert same(threads, shards)
    assert np.array_equal(one.sampler.counts, other.sampler.counts)
    assert one.sampler.counts.sum() > 0


@pytest.mark.slow
def test_a_pool_is_renewed_for_all_slots_together() -> None:
    first = [toy_scene(name=f"first_{k}") for k in range(2)]
    source = RefreshingScenes(
        "a desk", 2, every_resets=4, synchronous=True, seed=0, initial=first  # type: ignore
    )  # fmt: skip
    envs = TabletopVectorEnv(4, task="Reach", scenes=source, processes=2)
    for _ in range(3):
        envs.reset()
    assert source.renewals == 2, "12 draws, of which the 5th and the 9th were due"
    with pytest.raises(InputError, match="'scene' cannot be a RefreshingScenes for slots in sev"):
        envs.reset(options={"scene": source})
    with pytest.raises(InputError, match="'scene' cannot be a CurriculumScenes for slots in sev"):
        envs.reset(options={"scene": "curriculum:coffee-square"})
    envs.close()
    source.close()


@pytest.mark.slow
def test_a_source_that_fails_fails_the_reset() -> None:
    envs = TabletopVectorEnv(2, task="Reach", scenes=shard_tasks.Failing(), processes=2)
    with pytest.raises(RuntimeError, match="UnportableError: nothing to draw") as caught:
        envs.reset()
    assert "slot 0" in "".join(caught.value.__notes__)
    envs.close()


@pytest.mark.slow
def test_an_episode_with_nothing_to_do_is_the_same_error_as_in_one_process() -> None:
    envs = TabletopVectorEnv(2, task="Stack", scenes=toy_scene([]), processes=1)
    with pytest.raises(SceneError, match="no valid task") as caught:
        envs.reset()
    assert "slot 0" in caught.value.__notes__[0]
    envs.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_fork_says_that_its_processes_are_elsewhere(shards: Any) -> None:
    shards.reset(seed=0)
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)

    def work() -> None:
        told = []
        for call in (lambda: shards.step(STILL), lambda: pickle.dumps(shards)):
            try:
                call()
            except InputError as error:
                told.append(str(error))
        shards.close()
        sender.send(told)

    process = context.Process(target=work, daemon=True)
    process.start()
    try:
        assert receiver.poll(60), "it hangs"
        assert ["send a pickled copy" in told for told in receiver.recv()] == [True, True]
    finally:
        process.kill()
        process.join(60)
    assert shards.step(STILL)[1].shape == (3,), "here it goes on"
