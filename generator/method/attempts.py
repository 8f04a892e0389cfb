"""Repeated attempts: layouts of a plan are tried until one is sound and fulfils the plan."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..layout.relation_check import list_unmet
from ..scene import Scene

ATTEMPTS = 6
"""Number of layouts to try until one passes its gate."""

_STRIDE = 7919  # difference between the seeds of two attempts


@dataclass(frozen=True, eq=False)
class Candidate:
    """A layout that has not yet been judged by the gate.

    Attributes:
        judge: function that returns the judged scene, with the outcome of each relation in its
            report.
        unmet: number of relations that are known not to hold. Layouts with fewer are judged first,
            since judging a layout takes longer than making one.
    """

    judge: Callable[[], Scene]
    unmet: int = 0


@dataclass(frozen=True, eq=False)
class Attempts:
    """The scene that passed its gate and meets the most relations, or None, and the failed ones."""

    best: Scene | None
    failed: tuple[Scene, ...]


def try_layouts(lay_out: Callable[[int], Candidate], seed: int, *, fulfilled: int) -> Attempts:
    """Lay out and judge scenes until one passes its gate and satisfies all relations.

    Args:
        lay_out: function that returns the layout for a seed.
        seed: the seed of the first layout.
        fulfilled: the number of layouts after which a sound scene is accepted even if some of its
            relations do not hold.
    """
    best: Scene | None = None
    failed: list[Scene] = []
    waiting: list[Candidate] = []
    for attempt in range(ATTEMPTS):
        waiting.append(lay_out(seed + _STRIDE * attempt))
        enough = attempt + 1 >= fulfilled
        for candidate in sorted(waiting, key=lambda each: each.unmet):
            worse = best is not None and len(list_unmet(best)) <= candidate.unmet
            if candidate.unmet and (worse or not enough):
                break
            waiting.remove(candidate)
            scene = candidate.judge()
            if scene.report is not None and not scene.report.passed:
                failed.append(scene)
            elif best is None or len(list_unmet(scene)) < len(list_unmet(best)):
                best = scene
        if best is not None and (enough or not list_unmet(best)):
            break
    return Attempts(best, tuple(failed))
