"""Points that move to the origin: a small vector environment on NumPy or torch."""

from typing import Any

import gymnasium as gym
import numpy as np
import torch
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, SyncVectorEnv, VectorEnv

LIMIT = 12
"""Steps of an episode."""


class Point(gym.Env[Any, np.ndarray]):
    """A point in the plane; its reward is 1 minus the distance; beyond 2 it falls off the edge."""

    observation_space = spaces.Box(-5, 5, (2,), np.float32)
    action_space = spaces.Box(-1, 1, (2,), np.float32)

    def reset(self, *, seed: int | None = None, options: Any = None) -> Any:
        super().reset(seed=seed)
        self.at, self.steps = self.np_random.uniform(-1, 1, 2), 0
        return self.at.astype(np.float32), {}

    def step(self, action: np.ndarray) -> Any:
        self.at, self.steps = self.at + 0.2 * action, self.steps + 1
        away = float(np.linalg.norm(self.at))
        seen = self.at.astype(np.float32)
        return seen, 1 - away, away > 2, self.steps >= LIMIT, {"success": away < 0.1}


class PartedPoint(Point):
    """The same, observed in two parts."""

    observation_space = spaces.Dict({k: spaces.Box(-5, 5, (1,), np.float32) for k in "xy"})

    def reset(self, **given: Any) -> Any:
        seen, info = super().reset(**given)
        return _parts(seen), info

    def step(self, action: np.ndarray) -> Any:
        seen, *rest = super().step(action)
        return _parts(seen), *rest


class TensorPoints(VectorEnv[Any, Any, Any]):
    """Points as tensors with NumPy dynamics; infos as in batches of worlds."""

    metadata = {"autoreset_mode": AutoresetMode.SAME_STEP}  # noqa: RUF012

    def __init__(self, points: SyncVectorEnv, device: str = "cpu") -> None:
        self.points, self.device = points, torch.device(device)
        self.num_envs = points.num_envs
        for name in ("observation_space", "action_space"):
            for kind in (name, f"single_{name}"):
                setattr(self, kind, getattr(points, kind))

    def reset(self, *, seed: Any = None, options: Any = None) -> Any:
        return self._tensors(self.points.reset(seed=seed)[0]), {}

    def step(self, actions: torch.Tensor) -> Any:
        assert actions.device.type == self.device.type
        seen, rewards, terminated, truncated, infos = self.points.step(actions.cpu().numpy())
        over = terminated | truncated
        success = np.asarray(infos.get("success", np.zeros(self.num_envs, bool)))
        last = seen
        if over.any():
            success = np.where(over, infos["final_info"]["success"], success)
            rows = [infos["final_obs"][k] if over[k] else _row(seen, k) for k in range(len(over))]
            last = _stack(rows)
        more = {"success": success, "final_obs": last, "_final_obs": over}
        given = (seen, rewards, terminated, truncated, more)
        return tuple(self._tensors(part) for part in given)

    def _tensors(self, seen: Any) -> Any:
        if isinstance(seen, dict):
            return {name: self._tensors(part) for name, part in seen.items()}
        return torch.tensor(seen, device=self.device)


def points(count: int = 4, kind: type[Point] = Point) -> SyncVectorEnv:
    """Return points that reset within the step that ends their episode."""
    return SyncVectorEnv([kind] * count, autoreset_mode=AutoresetMode.SAME_STEP)


def _parts(seen: np.ndarray) -> dict[str, np.ndarray]:
    return {"x": seen[:1], "y": seen[1:]}


def _row(seen: Any, k: int) -> Any:
    return {n: v[k] for n, v in seen.items()} if isinstance(seen, dict) else seen[k]


def _stack(rows: list[Any]) -> Any:
    if isinstance(rows[0], dict):
        return {name: np.stack([row[name] for row in rows]) for name in rows[0]}
    return np.stack(rows)
