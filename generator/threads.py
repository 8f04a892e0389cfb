"""Number of available processors and number of compute threads of this process."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_TURN = threading.RLock()  # torch's thread count is global to the process, not per thread


def cores() -> int:
    """Return the number of processors available to this process."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def threads() -> int:
    """Return the number of compute threads; results do not depend on it.

    This is OMP_NUM_THREADS if set, otherwise all processors. NumPy's BLAS and torch read the same
    variable; batches and Ray set it for processes that share a machine.
    """
    setting = os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return int(setting) if setting.isdecimal() and int(setting) else cores()


@contextmanager
def torch_threads(count: int) -> Iterator[None]:
    """Run torch on ``count`` threads inside the block; use it in one Python thread at a time."""
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

    One thread sums in a fixed order, so results do not depend on the number of cores. Small
    operations such as splats do not benefit from more threads, and on a busy machine more threads
    make them many times slower. Only one Python thread at a time may be inside the block, so the
    block must not wait for code in another thread that enters it too.
    """
    with _TURN, torch_threads(1):
        yield
