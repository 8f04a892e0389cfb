import pytest
import torch

from tabletopgen_env.learning.ppo.rollout import advantages


def plain(rewards, values, over, last, gamma: float, gae_lambda: float) -> list[list[float]]:
    """Sum the discounted deltas of each step until its episode ends: eq. 16 literally."""
    steps, worlds = len(rewards), len(rewards[0])
    found = [[0.0] * worlds for _ in range(steps)]
    for w in range(worlds):
        for begin in range(steps):
            weight = 1.0
            for k in range(begin, steps):
                after = last[w] if k + 1 == steps else values[k + 1][w]
                ahead = 0.0 if over[k][w] else after
                found[begin][w] += weight * (rewards[k][w] + gamma * ahead - values[k][w])
                if over[k][w]:
                    break
                weight *= gamma * gae_lambda
    return found


@pytest.mark.parametrize(("gamma", "gae_lambda"), [(0.9, 0.8), (0.99, 1.0), (0.5, 0.0), (0.0, 0.9)])
def test_advantages_are_those_of_a_plain_loop(gamma: float, gae_lambda: float) -> None:
    random = torch.Generator().manual_seed(3)
    rewards, values = torch.randn(2, 17, 5, generator=random, dtype=torch.float64)
    last = torch.randn(5, generator=random, dtype=torch.float64)
    over = torch.rand(17, 5, generator=random) < 0.2
    over[:, 4], over[:, 3] = False, True
    wanted = plain(*(a.tolist() for a in (rewards, values, over, last)), gamma, gae_lambda)
    got = advantages(rewards, values, over, last, gamma, gae_lambda)
    assert torch.allclose(got, torch.tensor(wanted, dtype=torch.float64), atol=1e-12)


def test_nothing_comes_back_over_an_episode_s_end() -> None:
    rewards, over = torch.zeros(4, 1), torch.zeros(4, 1, dtype=torch.bool)
    rewards[3], over[1] = 1.0, True
    got = advantages(rewards, torch.zeros(4, 1), over, torch.zeros(1), 0.5, 1.0)
    assert got[:, 0].tolist() == [0.0, 0.0, 0.5, 1.0]
