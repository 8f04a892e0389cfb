"""Rollouts of a vector environment, and their comparison."""

from typing import Any

import numpy as np


def same(a: Any, b: Any) -> bool:
    """Return whether two nested structures of dicts, tuples, arrays and values are identical."""
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(same(a[k], b[k]) for k in a)
    if isinstance(a, tuple | list):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, np.ndarray) and a.dtype == object:
        return a.shape == b.shape and all(map(same, a.tolist(), b.tolist()))
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b)
    return type(a) is type(b) and a == b


def rollout(envs: Any, steps: int = 11, seed: int = 5, masked: bool = False) -> list[Any]:
    """Reset, act at random, and close; ``masked`` resets slots whose episodes have ended."""
    rng = np.random.default_rng(0)
    seen: list[Any] = [envs.reset(seed=seed)]
    for _ in range(steps):
        actions = rng.uniform(-1, 1, envs.action_space.shape).astype(np.float32)
        seen.append(envs.step(actions))
        ended = seen[-1][2] | seen[-1][3]
        if masked and ended.any():
            seen.append(envs.reset(options={"reset_mask": ended}))
    envs.close()
    return seen
