"""How many processors there are to compute on, and how many of them this process takes."""

from __future__ import annotations

import os


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
    told = os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return int(told) if told.isdecimal() and int(told) else cores()
