"""Pictures from hardly above the tabletop: a narrow band of it, and things much taller than that.

The eye reads the view from how walls, floors and tables lie in a picture; before a wall it reads
too steep a one. How much of the picture's height the bare top covers, over the height of the things
on it, tells such pictures apart: on rendered tables seen from 30 degrees and more it is hardly ever
below 1, from less than 16 it often is. The band does not tell how deep the table is; it is taken to
be as deep as tables usually are, and that tells the view.
"""

from __future__ import annotations

from contextlib import suppress

import numpy as np
from jaxtyping import Bool

from ....errors import SceneError
from ....scene import View
from ..eye.sight import EyeReading
from .cut_plane import plane_from_view
from .plane import TablePlane

_BAND = 1.0  # height of the bare top over that of the things, of a picture from eye level
_STEEP = float(np.deg2rad(30.0))  # a view that the eye reads steeper than this is not doubted
_CERTAIN = 0.5  # certainty of the things that are compared
_LEAST = 2  # of them, at least
_ALL = 90.0  # percentile of the columns' heights that stands for the band's
_ELEVATIONS = np.deg2rad([2.0, 3.5, 5.0, 6.5, 8.0, 9.5, 11.0])  # that are tried
_USUAL = 0.55  # depth of a tabletop over its width
_FAR = 40.0  # camera heights up to which such a picture shows the tabletop


def is_from_eye_level(sight: EyeReading, top: Bool[np.ndarray, "h w"], elevation: float) -> bool:
    """Tell whether a picture is taken from hardly above the tabletop.

    ``top`` is the tabletop with what is on it, ``elevation`` (radians) what the eye reads.
    """
    things = [t.whole for t in sight.things if t.score >= _CERTAIN and (t.whole & top).any()]
    heights = [int(np.ptp(np.flatnonzero(thing.any(1)))) + 1 for thing in things]
    shown = (top & sight.shows("top")).sum(0)
    if len(heights) < _LEAST or elevation > _STEEP or not shown.any():
        return False
    return float(np.percentile(shown[shown > 0], _ALL)) < _BAND * float(np.median(heights))


def plane_from_eye_level(
    top: Bool[np.ndarray, "h w"],
    fov: float,
    hidden: Bool[np.ndarray, "h w"],
    length: float | None = None,
) -> TablePlane | None:
    """Return the tabletop in the view in which it is most like a usual one; None if there is none.

    ``fov`` (radians) is vertical; ``hidden`` and ``length`` are those of ``plane_from_view``.
    """
    best, least = None, np.inf
    for elevation in _ELEVATIONS:
        with suppress(SceneError):
            view = View(0.0, float(elevation), fov)
            found = plane_from_view(top, view, hidden=hidden, length=length, reach=_FAR)
            unlike = abs(float(np.log(found.size[1] / found.size[0] / _USUAL)))
            if unlike < least:
                best, least = found, unlike
    return best
