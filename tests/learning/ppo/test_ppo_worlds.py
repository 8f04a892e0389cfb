import gymnasium as gym
import numpy as np
import pytest
import torch
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from moving_points import LIMIT, PartedPoint, Point, TensorPoints, points

from generator.errors import InputError
from tabletopgen_env.learning.ppo.worlds import TensorWorlds
from tabletopgen_env.parallel.vector import TabletopVectorEnv


def outwards(count: int) -> torch.Tensor:
    """Return actions that push the first point over the edge and hold the others."""
    return torch.tensor([[1.0, 1.0]] + [[0.0, 0.0]] * (count - 1))


@pytest.mark.parametrize("kind", [Point, PartedPoint])
def test_both_kinds_of_arrays_give_the_same(kind: type[Point]) -> None:
    one, other = TensorWorlds(points(3, kind)), TensorWorlds(TensorPoints(points(3, kind)))
    seen, also = one.reset(5), other.reset(5)
    met = set()
    for _ in range(2 * LIMIT):
        assert seen.keys() == also.keys() == ({""} if kind is Point else {"x", "y"})
        a, b = one.step(outwards(3)), other.step(outwards(3))
        assert all(torch.equal(a.seen[k], b.seen[k]) for k in a.seen)
        assert a.last.keys() == b.last.keys()
        assert all(torch.equal(a.last[k], b.last[k]) for k in a.last)
        for name in ("rewards", "terminated", "truncated", "cut", "success"):
            assert torch.equal(getattr(a, name), getattr(b, name)), name
        assert a.rewards.dtype == torch.float32
        assert a.cut.tolist() == a.truncated.nonzero()[:, 0].tolist()
        met |= {"terminated"} if a.terminated.any() else set()
        met |= {"cut"} if len(a.cut) else set()
        seen, also = a.seen, b.seen
    assert met == {"terminated", "cut"}


def test_what_was_seen_last_is_no_start() -> None:
    worlds = TensorWorlds(points(2))
    begun = worlds.reset([1, 2])[""].clone()
    for _ in range(LIMIT):
        step = worlds.step(torch.zeros(2, 2))
    assert step.cut.tolist() == [0, 1]
    assert torch.equal(step.last[""], begun), "they did not move"
    assert not torch.allclose(step.seen[""], begun), "new episodes begin elsewhere"


def test_success_is_of_the_step_that_ended_the_episode() -> None:
    worlds = TensorWorlds(points(1))
    at = worlds.reset(1)[""]
    for _ in range(LIMIT):
        step = worlds.step((-at / 0.2).clamp(-1, 1))
        at = step.seen[""]
    assert step.over.tolist() == step.success.tolist() == [True]


def test_arrays_of_the_cpu_are_not_copied() -> None:
    class Noting(SyncVectorEnv):
        def step(self, actions):
            self.given = actions
            return super().step(actions)

    env = Noting([Point], autoreset_mode=AutoresetMode.SAME_STEP, copy=False)
    worlds = TensorWorlds(env)
    seen = worlds.reset(0)[""]
    assert np.shares_memory(seen.numpy(), env._observations)
    actions = torch.zeros(1, 2)
    worlds.step(actions)
    assert np.shares_memory(env.given, actions.numpy())


def test_other_autoresets_are_refused() -> None:
    for mode in (AutoresetMode.NEXT_STEP, AutoresetMode.DISABLED):
        with pytest.raises(InputError, match="SameStep"):
            TensorWorlds(SyncVectorEnv([Point], autoreset_mode=mode))


def test_tables_are_worlds(table: str) -> None:
    env = TabletopVectorEnv(
        2, scenes=table, task="Reach", autoreset_mode="SameStep", max_episode_steps=3
    )
    worlds = TensorWorlds(env)
    assert isinstance(env, gym.vector.VectorEnv)
    size = env.single_observation_space.shape
    assert worlds.reset([1, 2])[""].shape == (2, *size)
    steps = [worlds.step(torch.zeros(2, 5)) for _ in range(3)]
    assert [len(s.cut) for s in steps] == [0, 0, 2]
    assert steps[2].last[""].shape == (2, *size)
    assert not torch.equal(steps[2].last[""], steps[2].seen[""])
    worlds.close()
