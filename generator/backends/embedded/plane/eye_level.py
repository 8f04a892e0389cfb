"""Pictures from hardly above the tabletop: a narrow band of it, and things much taller than that.

The eye reads the view from how walls, floors and tables lie in a picture; before a wall it reads
too steep a one. How much of the picture's height the bare top covers, over the height of the things
on it, tells such pictures apart: on rendered tables seen from 30 degrees and more it is hardly ever
below 1, from less than 16 it often is.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool

from ....scene import View
from ..eye.sight import EyeReading

_BAND = 1.0  # height of the bare top over that of the things, of a picture from eye level
_DEPTH = 7.0  # usual depth of a tabletop over the height of what stands on it
_STEEP = float(np.deg2rad(30.0))  # a view that the eye reads steeper than this is not doubted
_CERTAIN = 0.5  # certainty of the things that are compared
_LEAST = 2  # of them, at least
_ALL = 90.0  # percentile of the columns' heights that stands for the band's
_LOWEST, _HIGHEST = float(np.deg2rad(2.0)), float(np.deg2rad(11.0))


def view_from_eye_level(
    sight: EyeReading, top: Bool[np.ndarray, "h w"], expected: View
) -> View | None:
    """Return the view of a picture that is taken from eye level, else None.

    ``top`` is the tabletop with what is on it, ``expected`` the view that the eye reads; of that,
    the field of view stays.
    """
    things = [t.whole for t in sight.things if t.score >= _CERTAIN and (t.whole & top).any()]
    heights = [int(np.ptp(np.flatnonzero(thing.any(1)))) + 1 for thing in things]
    if len(heights) < _LEAST or expected.elevation > _STEEP:
        return None
    bare = top & sight.shows("top")
    if not bare.any():
        return None
    shown = bare.sum(0)
    band = float(np.percentile(shown[shown > 0], _ALL)) / float(np.median(heights))
    if band >= _BAND:
        return None
    below = np.arctan2(band, _DEPTH)  # how far below the horizon the top lies
    row = float(np.flatnonzero(bare.any(1)).mean()) / top.shape[0] - 0.5
    offset = np.arctan(2 * row * np.tan(expected.fov / 2))
    return View(0.0, float(np.clip(below - offset, _LOWEST, _HIGHEST)), expected.fov)
