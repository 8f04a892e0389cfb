"""Who runs the tasks: processes of this machine, or a Ray cluster."""

from __future__ import annotations

from dataclasses import dataclass

from .task_pool import TaskPool
from .workers import WorkerPool


@dataclass(frozen=True)
class PoolOptions:
    """Who does the work; the result does not depend on it.

    Attributes:
        workers: How much is done in parallel, each by a process with one thread: one for each
            processor is fastest.
        ray: Have the Ray cluster at this address do it ("auto": the one of this machine); "local"
            starts Ray here (pip install 'tabletopgen[ray]'). What lies in files, such as bundles
            that are named by a path, has to be in a folder that all machines share.
    """

    workers: int = 1
    ray: str | None = None


def pool_of(width: int, ray: str | None = None) -> TaskPool:
    """Return a pool of ``width`` processes here or, with the address of a cluster, on Ray.

    Raises:
        BackendError: Ray is not installed, or there is none at the address.
    """
    if ray is None:
        return WorkerPool(width)
    from .on_ray import RayPool

    return RayPool(ray, width)
