"""What speaks against a scene of a picture: its view does not show what the picture shows.

The physical gate says whether a scene is sound; these say whether it is the picture's.
"""

from __future__ import annotations

import numpy as np

from ..bundle import Segments
from ..errors import InputError
from ..scene import TABLE, Instance, Reference, Scene
from .scores import Comparison, compare

EYE_LEVEL = float(np.deg2rad(12.0))
"""Elevation, radians, below which a picture does not show how far back things stand."""

_TABLE = 0.35  # overlap (IoU) of the table's outlines below which the tables are two
_THINGS = 0.3  # mean overlap of the things' below which they are others
_GONE = 0.05  # overlap of one thing's below which it is not where the picture has it


def find_doubts(
    scene: Scene, instances: tuple[Instance, ...], reference: Reference
) -> tuple[str, ...]:
    """Return why a scene's view does not show what its picture shows; nothing if it does.

    ``instances`` have the table among them. The scene is drawn from the picture's camera.
    """
    try:
        seen = compare(scene, Segments.of(instances), np.asarray(reference.image))
    except InputError as error:
        return (f"The scene cannot be held against the picture: {error}",)
    shown = np.asarray(seen.rendered.ids)
    if not (shown >= 0).any():
        return ("The simulated view is blank: nothing of the scene is where the picture has it.",)
    return (*_doubt_table(seen), *_doubt_things(seen))


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


def _doubt_things(seen: Comparison) -> tuple[str, ...]:
    things = [score for score in seen.scores if score.name != TABLE and score.found]
    gone = [score.name for score in things if score.built and score.iou < _GONE]
    doubts = []
    if things and seen.mean_iou < _THINGS:
        doubts.append(
            f"The simulated things cover {100 * seen.mean_iou:.0f} % of the picture's on average "
            f"({100 * _THINGS:.0f} % at least is asked)."
        )
    if gone and 2 * len(gone) >= len(things):
        doubts.append(f"Not where the picture has them: {', '.join(gone)}.")
    return tuple(doubts)
