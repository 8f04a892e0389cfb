"""Where the tabletop of a picture is, and the camera that sees it: whole, or cut by the frame."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from jaxtyping import UInt8

from ....scene import PlannedTable, View
from ..eye.horizon import fit_view
from ..eye.sight import see
from .cut_plane import is_cut, plane_from_view
from .eye_level import is_from_eye_level, plane_from_eye_level
from .free_outline import as_seen
from .outline import find_outline, top_of
from .plane import TablePlane, fit_plane


def find_tabletop(
    image: UInt8[np.ndarray, "h w 3"],
    plan: PlannedTable | None = None,
    length: float | None = None,
    view: View | None = None,
) -> TablePlane:
    """Find the tabletop in a picture and the camera that sees it.

    What a text said of the table, ``plan``, fixes its shape and proportions; its ``length``,
    metres, is the plan's, else what is usual. ``view`` is kept to if given.

    Raises:
        BackendError: the eye's weights are missing or damaged.
        SceneError: the picture shows no tabletop.
    """
    found = _find(image.tobytes(), image.shape[:2], plan, length, None)
    if view is None or np.allclose(_numbers(found.view), _numbers(view), atol=1e-4):
        return found
    return _find(image.tobytes(), image.shape[:2], plan, length, view)


def _numbers(view: View) -> tuple[float, float, float]:
    return view.azimuth, view.elevation, view.fov


@lru_cache(maxsize=8)
def _find(
    pixels: bytes,
    size: tuple[int, int],
    plan: PlannedTable | None,
    length: float | None,
    view: View | None,
) -> TablePlane:
    """Answer for :func:`find_tabletop`; stages ask for one picture's again and again."""
    image = np.frombuffer(pixels, np.uint8).reshape(*size, 3)
    sight = see(image)
    elevation, fov = fit_view(sight.latitude)
    expected = View(0.0, elevation, fov)
    top = top_of(sight)
    things = sight.shows("thing")
    if plan is None and view is None and is_from_eye_level(sight, top, elevation):
        low = plane_from_eye_level(top, fov, things, length)
        if low is not None:
            return low
    if plan is None and is_cut(top):
        return plane_from_view(top, view or expected, hidden=things, length=length)
    outline, factor = find_outline(image, sight)
    plane = fit_plane(outline, factor, (size[1], size[0]), expected, plan, length, view)
    return plane if plan is not None else as_seen(plane, outline, factor)
