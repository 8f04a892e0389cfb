"""Pictures of a batch compared with those of the single environment."""

import numpy as np
import pytest
import torch
from tables import COMPILING, need_warp

from tabletopgen_env.env import make_env

need_warp()
pytestmark = [
    pytest.mark.slow, pytest.mark.usefixtures("kernels"), pytest.mark.timeout(COMPILING)
]  # fmt: skip

from tabletopgen_env.parallel.batch.decks import DeckConfig  # noqa: E402
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv  # noqa: E402

SCENES = ["vanity", "coffee-square"]
VIEWS = {
    "observation": "pixels+state",
    "cameras": ("front", "wrist", "top"),
    "image_size": (64, 96),
}


def batch(worlds: int = 2, **more) -> TabletopBatchEnv:
    return TabletopBatchEnv(
        worlds, SCENES, task="Lift", device="cpu", deck=DeckConfig(episodes=1), **{**VIEWS, **more}
    )


def test_worlds_look_as_in_the_single_environment() -> None:
    env, single = batch(), make_env(SCENES, task="Lift", **VIEWS)
    seen, _ = env.reset(options={"episodes": [0, 1]})
    assert env.observation_space.contains({k: v.numpy() for k, v in seen.items()})
    before = {key: value.clone() for key, value in seen.items()}
    actions = torch.tensor([[0.5, 0.0, -1.0, 0.3, -1.0]] * 2)
    for step in range(4):
        for k in range(2):
            if step == 0:
                name = env.bank.scenes[int(env.episodes.scene[k])]
                wanted, _ = single.reset(seed=env.episodes.seeds[k], options={"scene": name})
                for camera, most in (("front", 3.0), ("wrist", 5.0), ("top", 8.0)):
                    gap = np.abs(seen[camera][k].numpy().astype(float) - wanted[camera])
                    assert gap.mean() < most and np.median(gap) <= 3, (camera, name)
                    other = np.abs(seen[camera][1 - k].numpy().astype(float) - wanted[camera])
                    assert other.mean() > 2 * gap.mean() + 5, "each world shows its own table"
        seen, *_ = env.step(actions)
    assert not torch.equal(seen["wrist"], before["wrist"]), "the hand's camera moves with it"
    for k in range(2):
        name = env.bank.scenes[int(env.episodes.scene[k])]
        single.reset(seed=env.episodes.seeds[k], options={"scene": name})
        for _ in range(4):
            wanted, *_ = single.step(actions[k].numpy())
        gap = np.abs(seen["wrist"][k].numpy().astype(float) - wanted["wrist"])
        assert gap.mean() < 5


def test_pictures_follow_resets_and_swaps() -> None:
    env = batch(1, observation="pixels", cameras=("front",), max_episode_steps=1)
    first = env.reset(options={"episodes": [0]})[0]["front"].clone()
    seen, *_, infos = env.step(torch.zeros(1, 5))
    last = infos["final_obs"]["front"]
    assert (last.float() - first.float()).abs().mean() < 3, "what was seen last"
    begun, _ = env.reset(options={"episodes": [int(infos["_final_obs"].sum())]})
    assert (begun["front"].float() - first.float()).abs().mean() > 5, "another table"
    assert set(seen) == {"front"} and seen["front"].shape == (1, 64, 96, 3)
    env.prepare(seed=3)
    assert env.swap(wait=True)
    again = env.reset(options={"episodes": [0]})[0]["front"]
    assert (again.float() - first.float()).abs().mean() < 8, "the same table, another start"
    env.close()
