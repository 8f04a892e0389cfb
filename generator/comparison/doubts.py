"""Reasons to doubt that a scene's view matches its picture.

The physical gate checks whether a scene is physically valid; these checks compare it with the
picture.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..bundle import Segments
from ..errors import InputError
from ..scene import TABLE, Instance, Reference, Scene
from .scores import Comparison, Score, compare

EYE_LEVEL = float(np.deg2rad(12.0))
"""Camera elevation, in radians, below which a picture does not show the depth of objects."""

_TABLE = 0.35  # minimum IoU of the table's outlines
_THINGS = 0.3  # minimum mean IoU of the objects' outlines, and of one object before a note
_GONE = 0.05  # IoU below which an object counts as missing from its place
_MANY = 3  # the match fails if one in this many objects is missing


@dataclass(frozen=True)
class PictureMatch:
    """The agreement between a scene's view and its picture.

    ``mean_iou`` is the mean overlap (intersection over union, in [0, 1]) of the outlines of the
    objects detected in the picture; undetected objects are not counted. It is None if the
    comparison is impossible. ``doubts`` are reasons why the view does not match the picture;
    ``notes`` name single objects that are elsewhere in the picture or missing from it.
    """

    mean_iou: float | None
    doubts: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def match_picture(
    scene: Scene, instances: tuple[Instance, ...], reference: Reference
) -> PictureMatch:
    """Render a scene from its picture's camera and compare the rendering with the picture.

    ``instances`` are the detections in the picture, including the table.
    """
    try:
        seen = compare(scene, Segments.of(instances), np.asarray(reference.image))
    except InputError as error:
        return PictureMatch(None, (f"The scene cannot be compared with the picture: {error}",))
    shown = np.asarray(seen.rendered.ids)
    if not (shown >= 0).any():
        blank = "The simulated view is blank: no part of the scene is where the picture shows it."
        return PictureMatch(0.0, (blank,))
    things = [score for score in seen.scores if score.name != TABLE and score.found]
    doubts = (*_doubt_table(seen), *_doubt_things(seen, things))
    return PictureMatch(seen.mean_iou, doubts, tuple(_note_things(things)))


def warn_of_eye_level(scene: Scene) -> tuple[str, ...]:
    """Return a warning if the picture was taken from only slightly above the tabletop."""
    elevation = scene.view.elevation
    if elevation >= EYE_LEVEL:
        return ()
    return (
        (
            f"The picture was taken from eye level ({np.rad2deg(elevation):.0f}°): the sizes "
            "and positions of objects from front to back are not visible and were guessed."
        ),
    )


def _doubt_table(seen: Comparison) -> tuple[str, ...]:
    overlap = seen.table.iou
    if overlap >= _TABLE:
        return ()
    return (
        (
            f"The simulated table overlaps the picture's by {100 * overlap:.0f} % (intersection "
            f"over union; the minimum is {100 * _TABLE:.0f} %)."
        ),
    )


def _doubt_things(seen: Comparison, things: list[Score]) -> tuple[str, ...]:
    gone = [score.name for score in things if score.built and score.iou < _GONE]
    doubts = []
    if things and seen.mean_iou < _THINGS:
        doubts.append(
            f"The simulated objects overlap those in the picture by "
            f"{100 * seen.mean_iou:.0f} % on average; the threshold is {100 * _THINGS:.0f} %."
        )
    if gone and _MANY * len(gone) >= len(things):
        doubts.append(f"These objects are not where the picture shows them: {', '.join(gone)}.")
    return tuple(doubts)


def _note_things(things: list[Score]) -> list[str]:
    """Return a line for each built object that hardly overlaps its own mask in the picture."""
    return [
        (
            f"{score.name} differs from the picture: the outlines overlap by {100 * score.iou:.0f} "
            "% (intersection over union)."
        )
        for score in things
        if score.built and score.iou < _THINGS
    ]
