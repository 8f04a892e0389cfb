from pathlib import Path

import pytest
import torch
from moving_points import LIMIT, PartedPoint, Point, TensorPoints, points

from generator.errors import InputError
from tabletopgen_env.learning.algorithms.learner import Counts
from tabletopgen_env.learning.ppo.actor_critic import ActorCritic, divergence
from tabletopgen_env.learning.ppo.config import PPOConfig
from tabletopgen_env.learning.ppo.ppo import BatchPPO
from tabletopgen_env.learning.ppo.worlds import TensorWorlds
from tabletopgen_env.learning.recipes import Network

FLAT = Network("flat", (16, 16), activation="tanh")


def learner(seed: int = 0, inputs: dict[str, int] | None = None, **config) -> BatchPPO:
    return BatchPPO(FLAT, inputs or {"": 2}, 2, PPOConfig(**{"rollout": 8, **config}), seed)


def learn(ppo: BatchPPO, worlds: TensorWorlds, rollouts: int, seed: int = 0) -> list[float]:
    """Train; return the mean rewards of the rollouts' steps, as scaled by PPO."""
    seen, rewards = worlds.reset(seed), []
    for _ in range(rollouts):
        seen, rollout = ppo.collect(worlds, seen)
        rewards.append(float(rollout.rewards.mean()))
        ppo.update(rollout)
    return rewards


def state(ppo: BatchPPO) -> dict[str, torch.Tensor]:
    return {name: value.clone() for name, value in ppo.nets.state_dict().items()}


def alike(one: BatchPPO, other: BatchPPO) -> bool:
    a, b = state(one), state(other)
    return all(torch.equal(a[k], b[k]) for k in a)


def arrivals(ppo: BatchPPO, worlds: TensorWorlds) -> int:
    """Count the points that the exported actor brings to the origin within the time limit."""
    actor, squash = ppo.export()
    assert squash == "clip"
    seen, arrived = worlds.reset(9), 0
    for _ in range(LIMIT):
        step = worlds.step(actor(seen[""]).clamp(-1, 1))
        seen, arrived = step.seen, int(step.success.sum())
    return arrived


def test_points_learn_to_go_to_the_origin() -> None:
    ppo, worlds = learner(rollout=24, gamma=0.8), TensorWorlds(points(8))
    assert arrivals(ppo, worlds) <= 2
    rewards = learn(ppo, worlds, 25)
    assert max(rewards[:3]) < min(rewards[-3:])
    assert arrivals(ppo, worlds) >= 7


def test_the_same_seed_learns_the_same() -> None:
    made = [learner(seed) for seed in (0, 0, 1)]
    before = torch.random.get_rng_state()
    for ppo in made:
        learn(ppo, TensorWorlds(points()), 3)
    assert alike(made[0], made[1]) and not alike(made[0], made[2])
    assert torch.equal(torch.random.get_rng_state(), before), "nobody else's randomness is touched"


@pytest.mark.parametrize("kind", [Point, PartedPoint])
def test_tensors_and_arrays_teach_the_same(kind: type[Point]) -> None:
    inputs = {"": 2} if kind is Point else {"x": 1, "y": 1}
    one, other = (learner(inputs=inputs) for _ in range(2))
    learn(one, TensorWorlds(points(3, kind)), 3)
    learn(other, TensorWorlds(TensorPoints(points(3, kind))), 3)
    assert alike(one, other)


@pytest.mark.skipif(not torch.cuda.is_available(), reason="needs a GPU")
def test_it_learns_where_the_worlds_are_and_acts_anywhere(tmp_path: Path) -> None:
    worlds = TensorWorlds(TensorPoints(points(8), "cuda"))
    config = PPOConfig(rollout=24, gamma=0.8)
    ppo = BatchPPO(FLAT, {"": 2}, 2, config, 0, worlds.device)
    learn(ppo, worlds, 25)
    assert arrivals(ppo, TensorWorlds(points(8))) >= 7
    ppo.write(tmp_path, replay=False)
    other = BatchPPO(FLAT, {"": 2}, 2, config, 1)
    other.read(tmp_path, Counts())
    assert arrivals(other, TensorWorlds(points(8))) >= 7


def test_a_time_limit_ends_no_value(monkeypatch) -> None:
    """At a time limit, the value of the last observation is bootstrapped; at an end, zero."""
    ppo = learner(rollout=LIMIT + 1, gamma=0.9)
    monkeypatch.setattr(ppo.nets, "values", lambda seen: 100 + seen[""][:, 0])
    monkeypatch.setattr(ppo.nets, "means", lambda seen: torch.tensor([[9.0, 9.0], [0.0, 0.0]]))
    ppo.nets.log_std.data.fill_(-20.0)
    worlds = TensorWorlds(points(2))
    seen = worlds.reset([1, 2])
    still = float(seen[""][1, 0])
    reward = 1 - float(seen[""][1].norm())
    _, rollout = ppo.collect(worlds, seen)
    ended = int(rollout.over[:, 0].nonzero()[0, 0])
    assert ended < LIMIT - 1, "the first one falls off the edge"
    assert abs(float(rollout.rewards[ended, 0])) < 0.5
    assert rollout.over[:, 1].nonzero()[:, 0].tolist() == [LIMIT - 1]
    assert float(rollout.rewards[LIMIT - 2, 1]) == pytest.approx(0.1 * reward, abs=1e-4)
    wanted = 0.1 * reward + 0.9 * (100 + still)
    assert float(rollout.rewards[LIMIT - 1, 1]) == pytest.approx(wanted, rel=1e-5)
    assert ppo.episodes == int(rollout.over.sum()) >= 2


def test_the_first_step_of_an_update_is_the_policy_gradient(monkeypatch) -> None:
    """For an unchanged policy, the clipped objective is the mean advantage: 0."""
    ppo, worlds = learner(epochs=1, minibatches=1), TensorWorlds(points())
    _, rollout = ppo.collect(worlds, worlds.reset(0))
    figures = ppo.update(rollout)
    assert figures.policy_loss == pytest.approx(0, abs=1e-6) and figures.kl == pytest.approx(0)
    assert ppo.updates == 1 and figures.learning_rate > ppo.config.learning_rate


def test_densities_and_divergences_are_those_of_torch() -> None:
    nets = ActorCritic(FLAT, {"": 2}, 3, 0.7, 0)
    nets.log_std.data.copy_(torch.tensor([-1.0, 0.2, 0.5]))
    means, other, actions = torch.randn(3, 6, 3, generator=torch.Generator().manual_seed(0))
    own = torch.distributions.Normal(means, nets.log_std.exp())
    assert torch.allclose(nets.log_probs(actions, means), own.log_prob(actions).sum(-1))
    assert torch.allclose(nets.entropy(), own.entropy()[0].sum())
    to = torch.distributions.Normal(other, 0.4)
    wanted = torch.distributions.kl_divergence(own, to).sum(-1)
    log_std = torch.full((3,), 0.4).log()
    assert torch.allclose(divergence(means, nets.log_std, other, log_std), wanted, atol=1e-5)


def test_a_policy_that_moves_too_far_learns_slower() -> None:
    rates = []
    for target in (1e-6, 0.0, 10.0):
        ppo = learner(target_kl=target)
        learn(ppo, TensorWorlds(points()), 1)
        rates.append(ppo.learning_rate)
    assert rates[0] < rates[1] == PPOConfig().learning_rate < rates[2]


def test_what_was_written_goes_on_as_if_nothing_had_happened(tmp_path: Path) -> None:
    whole, first, again = learner(), learner(), learner(7)
    for ppo in (whole, first):
        learn(ppo, TensorWorlds(points()), 2)
    first.write(tmp_path, replay=True)
    assert again.read(tmp_path, Counts(updates=first.updates, episodes=first.episodes)) is False
    assert alike(again, whole) and again.learning_rate == whole.learning_rate
    for ppo in (whole, again):
        learn(ppo, TensorWorlds(points()), 2, seed=3)
    assert alike(again, whole) and again.updates == whole.updates


def test_what_is_no_checkpoint_of_it_is_not_read(tmp_path: Path) -> None:
    wide = BatchPPO(Network("flat", (8,)), {"": 2}, 2, PPOConfig(), 0)
    wide.write(tmp_path, replay=False)
    with pytest.raises(RuntimeError):
        learner().read(tmp_path, Counts())


def test_settings_out_of_range_are_refused() -> None:
    for wrong in ({"gamma": 1.0}, {"rollout": 0}, {"clip": 0}, {"std": -1}, {"epochs": 1.5}):
        with pytest.raises(InputError, match=next(iter(wrong))):
            PPOConfig(**wrong)
