"""How many processors there are to compute on, and how many of them this process takes."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_TURN = threading.RLock()  # what torch computes on is the process's, not a thread's


def cores() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def threads() -> int:
    """Return on how many threads this process computes; no result depends on it.

    That is OMP_NUM_THREADS, which says so to NumPy's BLAS and to torch, too, and which a batch and
    Ray set for the processes that share a machine; else all processors.
    """
    setting = os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return int(setting) if setting.isdecimal() and int(setting) else cores()


@contextmanager
def torch_threads(count: int) -> Iterator[None]:
    """Run torch on so many threads inside the block. What blocks of several threads do, mixes."""
    import torch

    before = torch.get_num_threads()
    torch.set_num_threads(count)
    try:
        yield
    finally:
        torch.set_num_threads(before)


@contextmanager
def single_thread() -> Iterator[None]:
    """Run torch on one thread inside the block.

    One thread adds in one order, so results do not depend on the machine's cores. Small work, like
    splats, is not worth sharing, either: more threads make it slower, and on a busy machine many
    times slower. Threads take turns; what a block waits for must not enter another one.
    """
    with _TURN, torch_threads(1):
        yield
