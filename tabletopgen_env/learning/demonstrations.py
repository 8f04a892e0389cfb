"""Episodes of the expert, or of a policy with the expert's advice, as arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import gymnasium as gym
import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ..expert.run import TaskExpert

PATIENCE = 4.0
"""How patient the expert is with a learner."""

HELD = 5
"""For how many steps in a row success has to hold for an episode to count as solved."""

Policy = Callable[[Float[np.ndarray, "o"]], Float[np.ndarray, "a"]]


@dataclass(frozen=True, eq=False)
class Demonstration:
    """One episode: what was seen, what the expert would do there, what was done, and what came.

    ``observations`` has one row more than the others; ``solved`` says how it ended.
    """

    observations: Float[np.ndarray, "t1 o"]
    advice: Float[np.ndarray, "t a"]
    actions: Float[np.ndarray, "t a"]
    rewards: Float[np.ndarray, "t"]
    solved: bool
    instruction: str


def demonstrate(
    env: gym.Env[Any, np.ndarray],
    seed: int,
    policy: Policy | None = None,
    noise: float = 0.0,
) -> Demonstration | None:
    """Play one episode with the expert watching; None if it knows no way.

    Args:
        env: an environment in the action mode "ee_delta".
        seed: of the episode, and of the noise.
        policy: who acts; None for the expert itself.
        noise: standard deviation of what is added to the expert's motion (not to the gripper), so
            that it shows how to come back.
    """
    rng = np.random.default_rng((seed, 1))
    seen, info = env.reset(seed=seed)
    expert = TaskExpert(env, 1.0 if policy is None else PATIENCE)
    try:
        expert.reset()
    except SceneError:
        return None
    shown, advised, done, earned = [seen], [], [], []
    held, over = 0, False
    while not over and held < HELD:
        advice = expert.act()
        action = advice if policy is None else policy(seen)
        if policy is None and noise:
            shaken = advice[:-1] + rng.normal(0.0, noise, len(advice) - 1)
            action = np.append(np.clip(shaken, -1, 1), advice[-1]).astype(np.float32)
        seen, reward, ended, cut, info = env.step(action)
        over = ended or cut
        held = held + 1 if info["success"] else 0
        shown.append(seen)
        advised.append(advice)
        done.append(action)
        earned.append(reward)
    return Demonstration(
        np.asarray(shown, np.float32), np.asarray(advised, np.float32),
        np.asarray(done, np.float32), np.asarray(earned, np.float32),
        held >= HELD, info["instruction"],
    )  # fmt: skip


def demonstrations(
    env: gym.Env[Any, np.ndarray],
    seeds: Iterator[int],
    count: int,
    policy: Policy | None = None,
    noise: float = 0.0,
) -> Iterator[Demonstration]:
    """Yield ``count`` demonstrations with seeds drawn from ``seeds``; those without are skipped.

    Raises:
        SceneError: of a hundred seeds in a row the expert knew a way with none.
    """
    missed = 0
    while count:
        found = demonstrate(env, next(seeds), policy, noise)
        if found is None:
            missed += 1
            if missed == 100:
                raise SceneError(
                    "The expert finds nothing it can do in 100 episodes; use other scenes."
                )
            continue
        missed = 0
        count -= 1
        yield found
