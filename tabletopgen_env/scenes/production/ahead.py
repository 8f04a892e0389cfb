"""Generation of scenes in several processes before they are loaded."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing

from generator.jobs.pools import pool_of
from generator.scene import Scene

from ..source import SceneRef


def make_ahead(
    refs: Sequence[SceneRef], workers: int, ray: str | None
) -> Generator[SceneRef, None, None]:
    """Generate scenes in a pool of local processes or on Ray; yield references to the results.

    The load functions must be picklable and independent of local files.

    Raises:
        BackendError: Ray is not available.
        SceneError: a scene cannot be generated, or a process ended unexpectedly.
    """
    with closing(pool_of(workers, ray)) as pool:
        for ref, scene in zip(refs, pool.map(_make, refs), strict=True):
            yield SceneRef(ref.key, lambda scene=scene: scene, ref.difficulty)


def _make(ref: SceneRef) -> Scene:
    return ref.load()
