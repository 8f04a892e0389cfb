"""Replay buffers: prefilling with the expert's episodes, and storage without pickle."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from stable_baselines3 import HerReplayBuffer
from stable_baselines3.common.buffers import ReplayBuffer

from generator.errors import InputError, SceneError
from generator.io.bounded import read_arrays

from ...episodes import episode_seeds
from .recorded import Demonstration, demonstrate, stack

MISSES = 100
"""The number of consecutive unsolved episodes after which prefilling fails."""

_MAX_REST = 2**20  # maximum size of a buffer's file without its arrays, bytes
_ARRAYS = ("actions", "rewards", "dones", "timeouts")
_EPISODES = ("ep_start", "ep_length")


def fill(
    buffer: ReplayBuffer,
    env: gym.Env[Any, np.ndarray],
    episodes: int,
    seed: int,
    between: Callable[[], None] | None = None,
) -> int:
    """Add successful episodes of the expert to a buffer; return the number of episodes.

    Episodes run to the time limit and end as timeouts, so that the buffer covers the value of
    staying at the goal. Their number is rounded up to a multiple of the buffer's number of
    environments. ``between`` is called before each episode and may raise an exception to stop.

    Raises:
        InputError: the buffer is too small for them.
        SceneError: the expert solves none of ``MISSES`` episodes in a row.
    """
    wide = buffer.n_envs
    rounds = -(-episodes // wide)
    solved = _solved_episodes(env, seed, between or (lambda: None))
    for _ in range(rounds):
        together = [next(solved) for _ in range(wide)]
        length = len(together[0].actions)
        if rounds * length > buffer.buffer_size:
            raise InputError(
                f"{rounds * wide} demonstrations of {length} steps do not fit into a replay "
                f"buffer of {buffer.buffer_size * wide} steps; increase options.buffer_size."
            )
        if any(len(d.actions) != length for d in together):
            raise InputError("Demonstrations need a task whose episodes all have the same length.")
        for step in range(length):
            _add(buffer, together, step)
    return rounds * wide


def _solved_episodes(
    env: gym.Env[Any, np.ndarray], seed: int, between: Callable[[], None]
) -> Iterator[Demonstration]:
    """Yield successful episodes of the expert, indefinitely."""
    seeds = episode_seeds(seed, 4)
    missed = 0
    while missed < MISSES:
        between()
        shown = demonstrate(env, next(seeds), to_the_limit=True)
        missed += 1
        if shown is not None and shown.solved:
            missed = 0
            yield shown
    raise SceneError(
        f"The expert solves none of {MISSES} episodes in these scenes; use other scenes, or "
        "train without demonstrations."
    )


def _add(buffer: ReplayBuffer, together: Sequence[Demonstration], step: int) -> None:
    last = step == len(together[0].actions) - 1
    buffer.add(
        stack([d.observation(step) for d in together]),
        stack([d.observation(step + 1) for d in together]),
        np.stack([d.actions[step] for d in together]),
        np.stack([d.rewards[step] for d in together]),
        np.full(len(together), last), [{"TimeLimit.truncated": last}] * len(together),
    )  # fmt: skip


def write_buffer(buffer: ReplayBuffer, path: Path) -> None:
    """Write the content of a buffer as arrays."""
    held = buffer.buffer_size if buffer.full else buffer.pos
    arrays = {name: array[:held] for name, array in _arrays(buffer).items()}
    arrays["position"] = np.array([buffer.pos, buffer.full, buffer.buffer_size])
    if isinstance(buffer, HerReplayBuffer):
        arrays["began"] = buffer._current_ep_start
    with path.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays)


def read_buffer(buffer: ReplayBuffer, path: Path) -> None:
    """Load a saved replay buffer into a new one of equal size, ending unfinished episodes.

    Raises:
        InputError: the file is damaged, or belongs to another buffer.
    """
    own = _arrays(buffer)
    most = sum(array.nbytes for array in own.values()) + _MAX_REST
    try:
        file = read_arrays(path, "The replay buffer", InputError, max_bytes=most)
        position, full, size = (int(v) for v in file["position"])
        held = size if full else position
        if size != buffer.buffer_size or not 0 <= position <= size:
            raise ValueError(f"the file contains a buffer of size {size}, not {buffer.buffer_size}")
        for name, array in own.items():
            array[:held] = _like(file[name], array[:held])
        buffer.pos, buffer.full = position, bool(full)
        if isinstance(buffer, HerReplayBuffer):
            began = buffer._current_ep_start
            began[:] = _like(file["began"], began)
            if ((began < 0) | (began >= size)).any():
                raise ValueError("an episode starts outside the buffer")
        _end_episodes(buffer)
    except (ValueError, KeyError, TypeError, IndexError, OverflowError) as error:
        raise InputError(
            f"{path} is not a valid replay buffer of this run ({error}). Delete the file to "
            "continue without the buffer."
        ) from error


def _like(kept: np.ndarray, own: np.ndarray) -> np.ndarray:
    """Return ``kept`` if its dtype and shape match those of ``own``; raise ValueError otherwise."""
    if kept.shape != own.shape or kept.dtype.kind != own.dtype.kind:
        raise ValueError(
            f"the array is {kept.dtype} of shape {kept.shape}, expected {own.dtype} "
            f"of shape {own.shape}"
        )
    return kept


def _end_episodes(buffer: ReplayBuffer) -> None:
    """Mark unfinished episodes as timed out, since the environments are reset."""
    if not (buffer.pos or buffer.full):
        return
    last = (buffer.pos - 1) % buffer.buffer_size
    running = np.flatnonzero(buffer.dones[last] == 0)
    buffer.dones[last, running] = buffer.timeouts[last, running] = 1.0
    if isinstance(buffer, HerReplayBuffer):
        for k in np.flatnonzero(buffer._current_ep_start != buffer.pos):
            buffer._compute_episode_length(int(k))


def _arrays(buffer: ReplayBuffer) -> dict[str, np.ndarray]:
    """Return a buffer's arrays by name."""
    found = {name: getattr(buffer, name) for name in _ARRAYS}
    for name in ("observations", "next_observations"):
        held: Any = getattr(buffer, name)
        parts = held.items() if isinstance(held, dict) else [("", held)]
        found |= {f"{name}.{part}": array for part, array in parts}
    if isinstance(buffer, HerReplayBuffer):
        found |= {name: getattr(buffer, name) for name in _EPISODES}
    return found
