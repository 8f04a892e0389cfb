"""What speaks against a scene of a picture: its view does not show what the picture shows.

The physical gate says whether a scene is sound; these say whether it is the picture's.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..bundle import Segments
from ..errors import InputError
from ..scene import TABLE, Instance, Reference, Scene
from .scores import Comparison, Score, compare

EYE_LEVEL = float(np.deg2rad(12.0))
"""Elevation, radians, below which a picture does not show how far back things stand."""

_TABLE = 0.35  # overlap (IoU) of the table's outlines below which the tables are two
_THINGS = 0.3  # mean overlap of the things' below which they are others; of one, worth a word
_GONE = 0.05  # overlap of one thing's below which it is not where the picture has it
_MANY = 3  # one in so many of such things is one too many


@dataclass(frozen=True)
class PictureMatch:
    """How a scene's view compares with its picture.

    ``mean_iou`` is the mean overlap (intersection over union, in [0, 1]) of the outlines of what
    was found in the picture; what was not found is not counted. It is None where the two cannot be
    compared. ``doubts`` say why the view does not show what the picture shows; ``notes`` name
    single things that it shows elsewhere, or not at all.
    """

    mean_iou: float | None
    doubts: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def match_picture(
    scene: Scene, instances: tuple[Instance, ...], reference: Reference
) -> PictureMatch:
    """Draw a scene from its picture's camera and compare the two.

    ``instances`` are what was found in the picture, the table among them.
    """
    try:
        seen = compare(scene, Segments.of(instances), np.asarray(reference.image))
    except InputError as error:
        return PictureMatch(None, (f"The scene cannot be held against the picture: {error}",))
    shown = np.asarray(seen.rendered.ids)
    if not (shown >= 0).any():
        blank = "The simulated view is blank: nothing of the scene is where the picture has it."
        return PictureMatch(0.0, (blank,))
    things = [score for score in seen.scores if score.name != TABLE and score.found]
    doubts = (*_doubt_table(seen), *_doubt_things(seen, things))
    return PictureMatch(seen.mean_iou, doubts, tuple(_note_things(things)))


def warn_of_eye_level(scene: Scene) -> tuple[str, ...]:
    """Return a warning if the picture was taken from hardly above the tabletop."""
    elevation = scene.view.elevation
    if elevation >= EYE_LEVEL:
        return ()
    return (
        f"The picture is taken from eye level ({np.rad2deg(elevation):.0f}°): how far back things "
        "stand, and how deep they are, cannot be seen and is guessed.",
    )


def _doubt_table(seen: Comparison) -> tuple[str, ...]:
    overlap = seen.table.iou
    if overlap >= _TABLE:
        return ()
    return (
        f"The simulated table covers {100 * overlap:.0f} % of the picture's (intersection over "
        f"union; {100 * _TABLE:.0f} % at least is asked).",
    )


def _doubt_things(seen: Comparison, things: list[Score]) -> tuple[str, ...]:
    gone = [score.name for score in things if score.built and score.iou < _GONE]
    doubts = []
    if things and seen.mean_iou < _THINGS:
        doubts.append(
            f"The simulated things cover {100 * seen.mean_iou:.0f} % of the picture's on average "
            f"({100 * _THINGS:.0f} % at least is asked)."
        )
    if gone and _MANY * len(gone) >= len(things):
        doubts.append(f"Not where the picture has them: {', '.join(gone)}.")
    return tuple(doubts)


def _note_things(things: list[Score]) -> list[str]:
    """Return a line for each built thing whose outlines hardly overlap."""
    return [
        f"{score.name} is not as the picture shows it: the outlines overlap by "
        f"{100 * score.iou:.0f} % (intersection over union)."
        for score in things
        if score.built and score.iou < _THINGS
    ]
