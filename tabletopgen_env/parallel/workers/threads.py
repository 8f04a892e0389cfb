"""All slots in this process, on a few threads."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium.vector import AutoresetMode

from .arrays import lay_out
from .infos import merge
from .slots import Job, SlotSet, attempt


class ThreadSlots:
    """Slots on ``threads`` threads; each slot stays on one thread, as OpenGL contexts require.

    A copy has copies of the environments, and its own threads.
    """

    def __init__(self, envs: Sequence[gym.Env], mode: AutoresetMode, threads: int) -> None:
        one: Any = envs[0]
        self.arrays = lay_out(np.zeros, len(envs), one.observation_space, one.action_space)
        self.slots = SlotSet(envs, mode, self.arrays)
        self.live = True
        self._mode = mode
        self._workers = [ThreadPoolExecutor(1, f"tabletop-{k}") for k in range(threads)]

    def step(self) -> dict[str, Any]:
        """Step or reset every slot."""
        count = len(self.slots.envs)
        return merge(count, enumerate(self._each(self.slots.step, range(count))))

    def reset(self, seeds: Mapping[int, int | None], options: dict[str, Any]) -> dict[str, Any]:
        """Reset some slots."""

        def start(k: int) -> dict[str, Any]:
            return self.slots.reset(k, seed=seeds[k], options=options or None)

        return merge(len(self.slots.envs), zip(seeds, self._each(start, seeds), strict=True))

    def visit(self, jobs: Mapping[int, Job]) -> list[Any]:
        """Run each job on the environment of its slot."""
        return self._each(lambda k: jobs[k](self.slots.envs[k]), jobs)

    def close(self) -> None:
        """Close the environments and end the threads; repeated calls are allowed."""
        if not self.live:
            return
        self.live = False
        try:
            self._each(lambda k: self.slots.envs[k].close(), range(len(self.slots.envs)))
        finally:
            for worker in self._workers:
                worker.shutdown()

    def _each(self, work: Callable[[int], Any], slots: Iterable[int]) -> list[Any]:
        """Run each slot's work in its thread; at the end, raise the first failed slot's error."""
        slots, count = list(slots), len(self._workers)

        def work_off(mine: list[int]) -> dict[int, Any]:
            return {k: attempt(work, k) for k in mine}

        shares = [[k for k in slots if k % count == w] for w in range(count)]
        jobs = [w.submit(work_off, s) for w, s in zip(self._workers, shares, strict=True) if s]
        done: dict[int, Any] = {}
        for job in jobs:
            done |= job.result()
        for k in slots:
            if isinstance(done[k], Exception):
                raise done[k]
        return [done[k] for k in slots]

    def __reduce__(self) -> tuple[type[ThreadSlots], tuple[Any, ...]]:
        return type(self), (self.slots.envs, self._mode, len(self._workers))
