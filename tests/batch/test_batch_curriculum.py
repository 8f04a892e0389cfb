"""A curriculum over the episodes of a batch."""

import numpy as np
import pytest
import torch
from tables import COMPILING, need_warp

from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.core import rewards
from tabletopgen_env.scenes import CurriculumScenes, DifficultySampler, SceneChoice, difficulty

need_warp()
pytestmark = [
    pytest.mark.slow, pytest.mark.usefixtures("kernels"), pytest.mark.timeout(COMPILING)
]  # fmt: skip

from tabletopgen_env.parallel.batch.decks import DeckConfig  # noqa: E402
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv  # noqa: E402

SCENES = ["vanity", "coffee-square"]


def batch(scenes: SceneChoice, task: str = "Reach") -> TabletopBatchEnv:
    return TabletopBatchEnv(
        2, scenes, task, device="cpu", deck=DeckConfig(episodes=3), max_episode_steps=2
    )


def play(env: TabletopBatchEnv, monkeypatch: pytest.MonkeyPatch) -> list[list[int]]:
    """Play episodes, successful at the first scene only; return the started ones."""
    own = rewards.terms

    def terms(*given):
        first = env.episodes.scene[env._row] == 0
        return own(*given) | {"success": first.float()}

    monkeypatch.setattr(rewards, "terms", terms)
    begun = [env.reset(seed=4)[1]["episode_row"].tolist()]
    for _ in range(4):
        for _ in range(2):
            env.step(torch.zeros(2, 5))
        begun.append(env._row.tolist())
    return begun


def test_a_batch_draws_by_its_curriculum_and_tells_it_how_episodes_end(monkeypatch) -> None:
    alike = [batch(CurriculumScenes(SCENES, DifficultySampler(halflife=1e9))) for _ in range(2)]
    begun = [play(env, monkeypatch) for env in alike]
    assert begun[0] == begun[1], "the same seed, the same ends: the same draws"
    env = alike[0]
    bins = env.sampler.bins(env.episodes.difficulty)
    counts = np.zeros_like(env.sampler.counts)
    for row in np.concatenate(begun[0][:-1]):  # the last ones are under way
        counts[bins[row]] += [1, int(env.episodes.scene[row]) == 0]
    assert env.sampler.counts == pytest.approx(counts, abs=1e-6) and counts[:, 0].sum() == 8
    env.prepare(seed=5)
    assert env.swap(wait=True)
    assert env.sampler.counts == pytest.approx(counts, abs=1e-6), "a swap keeps them"
    drawn = env.reset(seed=1)[1]["episode_row"]
    assert int(drawn.min()) >= 0 and int(drawn.max()) < len(env.episodes)


def test_episodes_are_rated_by_scene_and_target() -> None:
    env = batch("curriculum:vanity", "Lift")
    assert len(env.sampler.counts) == len(DifficultySampler().counts)
    assert env.bank.scenes == ("vanity",), "all scenes of fixed ones, once"
    single = make_env("vanity", task=env.task, randomization=None)
    for row, seed in enumerate(env.episodes.seeds):
        single.reset(seed=seed)
        assert single.goal.target is not None
        assert env.episodes.difficulty[row] == difficulty(single.world.scene, single.goal.target)
    env.close()
