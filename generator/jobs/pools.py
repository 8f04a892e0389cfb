"""Selection of the worker pool: local processes or a Ray cluster."""

from __future__ import annotations

from dataclasses import dataclass

from .task_pool import TaskPool
from .workers import WorkerPool


@dataclass(frozen=True)
class PoolOptions:
    """Worker options, which do not affect results.

    Attributes:
        workers: Number of parallel processes, with one thread each; one per processor is fastest.
        ray: Use the Ray cluster at this address ("auto": the one of this machine); "local" starts
            Ray on this machine (pip install 'tabletopgen[ray]'). Files, such as bundles given by
            path, must be in a folder that all machines share.
    """

    workers: int = 1
    ray: str | None = None


def pool_of(width: int, ray: str | None = None) -> TaskPool:
    """Return a pool of ``width`` processes: local, or on a Ray cluster if ``ray`` is given.

    Raises:
        BackendError: Ray is not installed, or no cluster runs at the address.
    """
    if ray is None:
        return WorkerPool(width)
    from .on_ray import RayPool

    return RayPool(ray, width)
