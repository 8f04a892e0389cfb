"""Slots stepped together equal slots stepped alone, up to rounding."""

from typing import Any

import numpy as np
import pytest
from extent import count
from worlds import two_scenes

from generator.errors import InputError
from tabletopgen_env.parallel.vector import Processes, TabletopVectorEnv

SLOTS, STEPS = count(5, 3), count(24, 12)  # in two processes, and three episodes each


def play(mode: str, **settings: Any) -> list[Any]:
    """Play a few steps; return the result of every call."""
    env = TabletopVectorEnv(
        SLOTS, scenes=two_scenes(), autoreset_mode=mode, max_episode_steps=count(9, 5), **settings
    )
    rng = np.random.default_rng(0)
    kept: list[Any] = [env.reset(seed=3)]
    for _ in range(STEPS):
        kept.append(env.step(rng.uniform(-1, 1, env.action_space.shape)))
        over = kept[-1][2] | kept[-1][3]
        if mode == "Disabled" and over.any():
            kept.append(env.reset(seed=7, options={"reset_mask": over}))
    env.close()
    return kept


def assert_alike(one: Any, other: Any, at: str) -> None:
    """Compare nested results, numbers up to rounding."""
    assert type(one) is type(other), at
    if isinstance(one, dict):
        assert one.keys() == other.keys(), at
        for key in one:
            assert_alike(one[key], other[key], f"{at}[{key!r}]")
    elif isinstance(one, tuple):
        assert len(one) == len(other), at
        for k, pair in enumerate(zip(one, other, strict=True)):
            assert_alike(*pair, f"{at}[{k}]")
    elif isinstance(one, np.ndarray) and one.dtype.kind == "f":
        np.testing.assert_allclose(one, other, atol=2e-3, err_msg=at)
    elif isinstance(one, np.ndarray) and one.dtype == object:
        assert len(one) == len(other), at
        for k, pair in enumerate(zip(one, other, strict=True)):
            assert_alike(*pair, f"{at}[{k}]")
    elif isinstance(one, float):
        assert one == pytest.approx(other, abs=2e-3), at
    else:
        assert np.array_equal(one, other), at


@pytest.mark.parametrize(
    ("mode", "settings"),
    [
        ("SameStep", {"task": "PickPlace", "randomization": "starts"}),
        ("NextStep", {"task": "Push", "reward": "sparse"}),
        ("Disabled", {"task": "Reach", "observation": "goal", "action": "joint_delta"}),
    ],
)
def test_they_do_what_they_do_alone(mode: str, settings: dict[str, Any]) -> None:
    alone = play(mode, threads=1, **settings)
    together = play(mode, processes=Processes(2, together=True), **settings)
    assert_alike(tuple(together), tuple(alone), "call")


def test_what_the_core_has_not_is_refused() -> None:
    for settings, why in (
        ({"observation": "pixels"}, "observation='pixels'"),
        ({"grasp_hint": True}, "grasp_hint=True"),
        ({"randomization": "strong"}, "noise in readings"),
    ):
        with pytest.raises(InputError, match=why):
            TabletopVectorEnv(2, processes=Processes(1, together=True), **settings)
