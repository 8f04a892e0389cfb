"""The finished scene held against its picture: a refinement that assembly undoes does not stay.

The joint refinement goes by outlines before the scene is assembled. Freeing overlaps and settling
move things again, so what is published is measured again, in the same measure.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from ..scene import Placement, Scene
from .refinement import Refinement

WORSE = 0.005
"""By how much the finished scene's outlines may agree worse than those before the refinement."""

UNREFINED = "The joint refinement is left out: finished, the scene agrees better without it."

Placements = tuple[Placement, ...]


def finished(
    build: Callable[[Placements, tuple[str, ...]], Scene],
    measure: Callable[[Scene], float],
    refined: Refinement,
    unrefined: Placements,
) -> Scene:
    """Return the scene built of the refined placements, its report's misfit filled in.

    If it agrees worse than the unrefined placements did, these are built as well; a sound scene
    stays before one that is not, then the one that agrees better.

    Args:
        build: assembles and judges placements, with these warnings.
        measure: one minus the overlap of a finished scene's outlines with the picture's.
        refined: what the joint refinement found; without a misfit before, it did nothing.
        unrefined: the placements that it was given.
    """
    scene = build(refined.placements, ())
    if not refined.before:
        return scene
    misfit = measure(scene)
    if misfit > refined.before + WORSE and refined.after < refined.before:
        other = build(unrefined, (UNREFINED,))
        its = measure(other)
        if (_sound(other), -its) > (_sound(scene), -misfit):
            scene, misfit = other, its
    if scene.report is None:
        return scene
    both = (round(refined.before, 6), round(misfit, 6))
    return scene.replace(report=replace(scene.report, misfit=both))


def _sound(scene: Scene) -> bool:
    return scene.report is None or scene.report.passed
