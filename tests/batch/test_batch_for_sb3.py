"""A batch as a vector environment of Stable-Baselines3."""

import numpy as np
import pytest
from stable_baselines3 import PPO
from tables import COMPILING, need_warp

from generator.errors import InputError

need_warp()
pytestmark = [pytest.mark.usefixtures("kernels"), pytest.mark.timeout(COMPILING)]

from tabletopgen_env.learning.adapters.batches import BatchVecEnv  # noqa: E402
from tabletopgen_env.parallel.batch.decks import DeckConfig  # noqa: E402
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv  # noqa: E402


def test_sb3_learns_on_a_batch() -> None:
    batch = TabletopBatchEnv(
        3, ["vanity", "coffee-square"], task="Lift", device="cpu", deck=DeckConfig(episodes=2),
        max_episode_steps=4,
    )  # fmt: skip
    env = BatchVecEnv(batch)
    env.seed(1)
    first = env.reset()
    env.seed(1)
    assert np.array_equal(first, env.reset()), "a seed's episodes come again"
    for step in range(4):
        seen, rewards, done, infos = env.step(np.zeros((3, 5), np.float32))
        assert seen.dtype == np.float32 and rewards.dtype == np.float32
        assert done.tolist() == [step == 3] * 3
    assert all(info["TimeLimit.truncated"] and not info["failed"] for info in infos)
    assert not np.array_equal(infos[0]["terminal_observation"], seen[0])
    model = PPO("MlpPolicy", env, n_steps=8, batch_size=12, n_epochs=1, device="cpu", seed=0)
    model.learn(24)
    assert model.num_timesteps == 24
    for refused in (lambda: env.set_attr("task", 1), lambda: env.env_method("reset")):
        with pytest.raises(InputError, match="of their own"):
            refused()
    assert env.get_attr("num_envs", [0, 2]) == [3, 3]
    env.close()
