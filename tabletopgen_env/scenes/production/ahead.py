"""Scenes made by several processes before they are loaded."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing

from generator.jobs.pools import pool_of
from generator.scene import Scene

from ..source import SceneRef


def make_ahead(
    refs: Sequence[SceneRef], workers: int, ray: str | None
) -> Generator[SceneRef, None, None]:
    """Yield references to the same scenes, made by as many processes, here or on a Ray cluster.

    What one is loaded from must be picklable, and not in files of this machine.

    Raises:
        BackendError: no Ray.
        SceneError: a scene cannot be made, or a process has ended abruptly.
    """
    with closing(pool_of(workers, ray)) as pool:
        for ref, scene in zip(refs, pool.map(_make, refs), strict=True):
            yield SceneRef(ref.key, lambda scene=scene: scene, ref.difficulty)


def _make(ref: SceneRef) -> Scene:
    return ref.load()
