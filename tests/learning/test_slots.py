"""The vector environment for SB3 equals ``DummyVecEnv`` of the same environments."""

import gymnasium as gym
import numpy as np
import pytest
from stable_baselines3.common.vec_env import DummyVecEnv
from toy import toy_scene

from generator.errors import InputError
from tabletopgen_env.env import make_env
from tabletopgen_env.learning.adapters.slots import SlotVecEnv
from tabletopgen_env.parallel.vector import TabletopVectorEnv

LIMIT = 7


def both(observation: str, processes: int | None = None) -> tuple[SlotVecEnv, DummyVecEnv]:
    scene = toy_scene()
    settings = {"task": "Push", "observation": observation}

    def one() -> gym.Env:
        return gym.wrappers.TimeLimit(make_env(scene, **settings), LIMIT)

    slots = TabletopVectorEnv(
        2, autoreset_mode="SameStep", max_episode_steps=LIMIT, scenes=scene, processes=processes,
        **settings,
    )  # fmt: skip
    return SlotVecEnv(slots), DummyVecEnv([one, one])


def same(a, b) -> bool:
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    return bool(np.array_equal(a, b))


@pytest.mark.slow
@pytest.mark.parametrize("processes", [None, 2])
@pytest.mark.parametrize("observation", ["state", "goal"])
def test_it_gives_what_sb3s_own_gives(observation: str, processes: int | None) -> None:
    ours, theirs = both(observation, processes)
    assert ours.observation_space == theirs.observation_space
    theirs._seeds = list(ours.seed(3))
    assert same(ours.reset(), theirs.reset())
    assert [i["target"] for i in ours.reset_infos] == [i["target"] for i in theirs.reset_infos]
    rng = np.random.default_rng(0)
    ended, begun = 0, set()
    for _ in range(2 * LIMIT + 1):
        actions = rng.uniform(-1, 1, (2, 5)).astype(np.float32)
        got, wanted = ours.step(actions), theirs.step(actions)
        assert same(got[0], wanted[0])
        assert np.array_equal(got[1], wanted[1]) and np.array_equal(got[2], wanted[2])
        for mine, other in zip(got[3], wanted[3], strict=True):
            for key in ("success", "is_success", "instruction", "goals", "reward_terms"):
                assert mine[key] == other[key]
        ended += int(got[2].sum())
        for mine, other, over in zip(got[3], wanted[3], got[2], strict=True):
            assert ("terminal_observation" in mine) == over
            if over:
                assert mine["TimeLimit.truncated"] is True is other["TimeLimit.truncated"]
                assert same(mine["terminal_observation"], other["terminal_observation"])
        for mine, other in zip(ours.reset_infos, theirs.reset_infos, strict=True):
            assert mine.keys() == other.keys()
            assert mine["reward_terms"] == other["reward_terms"]
            begun.add(tuple(mine["reward_terms"].values()))
    assert ended == 4 and len(begun) == 6, "renewed as slots reset themselves"
    ours.close()


def test_slots_of_neighbouring_runs_have_other_seeds() -> None:
    ours, _ = both("state")
    seeds = [s for run in range(50) for s in ours.seed(run)]
    assert len(set(seeds)) == 100 and list(ours.seed(3)) == list(ours.seed(3))
    ours.close()


def test_slots_that_do_not_reset_themselves_are_refused() -> None:
    slots = TabletopVectorEnv(1, scenes="office-desk", task="Reach", max_episode_steps=5)
    with pytest.raises(InputError, match="autoreset_mode='SameStep', not 'NextStep'"):
        SlotVecEnv(slots)
    slots.close()


def test_a_seed_is_one_of_the_rule() -> None:
    slots = TabletopVectorEnv(1, scenes="office-desk", task="Reach", autoreset_mode="SameStep")
    with pytest.raises(InputError, match="A seed must"):
        SlotVecEnv(slots).seed(-1)
    slots.close()


def test_options_are_of_all_slots_alike() -> None:
    ours, _ = both("state")
    ours.set_options({"target": "cube_1"})
    ours.reset()
    assert [info["target"] for info in ours.reset_infos] == ["cube_1"] * 2
    ours.set_options([{"target": "cube_1"}, {}])
    with pytest.raises(InputError, match="same options"):
        ours.reset()
    ours.close()


@pytest.mark.parametrize("processes", [None, pytest.param(2, marks=pytest.mark.slow)])
def test_methods_and_attributes_are_those_of_the_slots(processes: int | None) -> None:
    ours, _ = both("goal", processes)
    ours.seed(0)
    seen = ours.reset()
    goals = seen["desired_goal"]
    (reward,) = ours.env_method("compute_reward", goals, goals, [{}, {}], indices=[0])
    assert reward.shape == (2,)
    assert ours.get_attr("render_mode") == [None, None]
    assert ours.env_is_wrapped(gym.wrappers.TimeLimit) == [True, True]
    assert ours.env_is_wrapped(gym.wrappers.FrameStackObservation, [1]) == [False]
    ours.set_attr("reward", "sparse", indices=[1])
    assert ours.get_attr("reward") == ["dense", "sparse"]
    assert not ours.has_attr("nothing")
    ours.close()
