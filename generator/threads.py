"""Processor count and the number of threads this process computes with."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_TURN = threading.RLock()  # torch's thread count belongs to the process, not to a thread


def cores() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def threads() -> int:
    """Return the number of threads to compute with; results do not depend on it.

    This is OMP_NUM_THREADS if set, which NumPy's BLAS and torch read too, and which a batch and Ray
    set for processes that share a machine; otherwise all processors.
    """
    setting = os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return int(setting) if setting.isdecimal() and int(setting) else cores()


@contextmanager
def torch_threads(count: int) -> Iterator[None]:
    """Run torch on ``count`` threads inside the block; not for several Python threads at once."""
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

    One thread sums in a fixed order, so results do not depend on the number of cores. Small work
    such as splats does not profit from more threads either; on a busy machine they make it many
    times slower. Threads take turns: code that a block waits for must not enter another one.
    """
    with _TURN, torch_threads(1):
        yield
