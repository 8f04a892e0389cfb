"""Replay buffers: filled by the expert, and kept on disk without a pickle."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from stable_baselines3 import HerReplayBuffer
from stable_baselines3.common.buffers import ReplayBuffer

from generator.errors import InputError, SceneError

from ..episodes import Held
from ..expert.run import TaskExpert

MISSES = 100
"""After so many episodes in a row that the expert does not solve, filling ends in an error."""

_ARRAYS = ("actions", "rewards", "dones", "timeouts")
_EPISODES = ("ep_start", "ep_length")


@dataclass(frozen=True, eq=False)
class Transition:
    """One step of the expert, as a replay buffer takes it."""

    seen: Any
    action: np.ndarray
    reward: float
    after: Any
    ended: bool
    cut: bool


def fill(buffer: ReplayBuffer, env: gym.Env[Any, np.ndarray], episodes: int, seed: int) -> int:
    """Put solved episodes of the expert into a buffer; return how many.

    Episodes go on to the time limit, so that the buffer shows what staying there is worth; their
    last transitions are marked as timeouts, not as ends. A buffer of several environments takes
    as many episodes at a time, so the number is rounded up to a multiple of theirs.

    Args:
        buffer: the buffer, of "ee_delta" actions.
        env: where the expert acts; it observes what the buffer holds.
        episodes: how many.
        seed: of the episodes.

    Raises:
        InputError: the buffer has no room for them.
        SceneError: the expert solves none of ``MISSES`` episodes in a row.
    """
    wide = buffer.n_envs
    rounds = -(-episodes // wide)
    solved = _solved(env, seed)
    for _ in range(rounds):
        together = [next(solved) for _ in range(wide)]
        length = len(together[0])
        if rounds * length > buffer.buffer_size:
            raise InputError(
                f"{rounds * wide} demonstrations of {length} steps do not fit into a buffer of "
                f"{buffer.buffer_size * wide}; make it larger (options.buffer_size)."
            )
        if any(len(e) != length for e in together):
            raise InputError("Demonstrations need a task whose episodes are all as long.")
        for steps in zip(*together, strict=True):
            _add(buffer, steps)
    return rounds * wide


def expert_episode(env: gym.Env[Any, np.ndarray], seed: int) -> list[Transition] | None:
    """Return an episode of the expert to the time limit; None unless it solves it."""
    seen, info = env.reset(seed=seed)
    expert = TaskExpert(env)
    try:
        expert.reset()
    except SceneError:
        return None
    made: list[Transition] = []
    held, solved = Held(), False
    while not made or not (made[-1].ended or made[-1].cut):
        action = expert.act()
        after, reward, ended, cut, info = env.step(action)
        made.append(Transition(seen, action, float(reward), after, ended, cut))
        solved = held.after(info) or solved
        seen = after
    return made if solved else None


def _solved(env: gym.Env[Any, np.ndarray], seed: int) -> Iterator[list[Transition]]:
    """Yield solved episodes without end."""
    rng = np.random.default_rng((seed, 4))
    missed = 0
    while missed < MISSES:
        made = expert_episode(env, int(rng.integers(2**31)))
        missed = missed + 1 if made is None else 0
        if made is not None:
            yield made
    raise SceneError(
        f"The expert solves none of {MISSES} episodes here; use other scenes, or no demonstrations."
    )


def _add(buffer: ReplayBuffer, steps: tuple[Transition, ...]) -> None:
    buffer.add(
        _stacked([s.seen for s in steps]), _stacked([s.after for s in steps]),
        np.stack([s.action for s in steps]), np.array([s.reward for s in steps], np.float32),
        np.array([s.ended or s.cut for s in steps]),
        [{"TimeLimit.truncated": s.cut and not s.ended} for s in steps],
    )  # fmt: skip


def _stacked(seen: list[Any]) -> Any:
    if isinstance(seen[0], dict):
        return {key: np.stack([s[key] for s in seen]) for key in seen[0]}
    return np.stack(seen)


def write_buffer(buffer: ReplayBuffer, path: Path) -> None:
    """Write what a buffer holds as arrays."""
    held = buffer.buffer_size if buffer.full else buffer.pos
    arrays = {name: array[:held] for name, array in _arrays(buffer).items()}
    arrays["position"] = np.array([buffer.pos, buffer.full, buffer.buffer_size])
    if isinstance(buffer, HerReplayBuffer):
        arrays["began"] = buffer._current_ep_start
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays)


def read_buffer(buffer: ReplayBuffer, path: Path) -> None:
    """Put into a new buffer what one of the same size held; unfinished episodes end there.

    Raises:
        InputError: the file is damaged, or of another buffer.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            position, full, size = (int(v) for v in file["position"])
            held = size if full else position
            if size != buffer.buffer_size or not 0 <= position <= size:
                raise ValueError(f"it is of a buffer of {size}, not {buffer.buffer_size}")
            for name, array in _arrays(buffer).items():
                array[:held] = file[name]
            buffer.pos, buffer.full = position, bool(full)
            if isinstance(buffer, HerReplayBuffer):
                buffer._current_ep_start[:] = file["began"]
                _end_episodes(buffer)
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
        raise InputError(
            f"{path} is no replay buffer of this run ({error}). Delete it to go on without."
        ) from error


def _end_episodes(buffer: HerReplayBuffer) -> None:
    """End unfinished episodes as by a time limit, as the environments begin anew."""
    last = (buffer.pos - 1) % buffer.buffer_size
    for k in np.flatnonzero(buffer._current_ep_start != buffer.pos):
        buffer.dones[last, k] = buffer.timeouts[last, k] = 1.0
        buffer._compute_episode_length(int(k))


def _arrays(buffer: ReplayBuffer) -> dict[str, np.ndarray]:
    """Return a buffer's own arrays by name."""
    found = {name: getattr(buffer, name) for name in _ARRAYS}
    for name in ("observations", "next_observations"):
        held: Any = getattr(buffer, name)
        parts = held.items() if isinstance(held, dict) else [("", held)]
        found |= {f"{name}.{part}": array for part, array in parts}
    if isinstance(buffer, HerReplayBuffer):
        found |= {name: getattr(buffer, name) for name in _EPISODES}
    return found
