"""Detection of the camera and of a tabletop that is complete, cut off, or at eye level."""

from __future__ import annotations

from contextlib import suppress
from functools import lru_cache

import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy.optimize import least_squares

from ....errors import SceneError
from ....scene import PlannedTable, View
from ..eye.sight import EyeReading, see
from .cut_plane import is_cut, plane_from_view
from .free_outline import as_seen
from .outline import find_outline, top_of
from .plane import TablePlane, fit_plane


def find_tabletop(
    image: UInt8[np.ndarray, "h w 3"],
    plan: PlannedTable | None = None,
    length: float | None = None,
    view: View | None = None,
) -> TablePlane:
    """Find the tabletop in a picture, and the camera.

    ``plan``, the table described by a text, fixes its shape and proportions. The ``length`` in
    metres defaults to the plan's, or else to a typical one. ``view`` fixes the camera if given.

    Raises:
        BackendError: the detector's weights are missing or damaged.
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
    """Find the tabletop; the result is cached, because several stages use the same picture."""
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


_BAND = 1.0  # maximum ratio of the bare top's height to the objects', for a picture from eye level
_STEEP = float(np.deg2rad(30.0))  # elevation estimates above this are trusted
_CERTAIN = 0.5  # minimum confidence of the compared objects
_LEAST = 2  # minimum number of them
_ALL = 90.0  # percentile of the columns' heights that represents the top
_ELEVATIONS = np.deg2rad([2.0, 3.5, 5.0, 6.5, 8.0, 9.5, 11.0])  # candidates
_USUAL = 0.55  # depth of a typical tabletop relative to its width
_FAR = 40.0  # maximum visible distance in such a picture, in camera heights


def is_from_eye_level(sight: EyeReading, top: Bool[np.ndarray, "h w"], elevation: float) -> bool:
    """Return whether a picture was taken from only slightly above the tabletop.

    ``top`` is the tabletop including the objects on it; ``elevation`` (radians) is the detector's
    estimate.
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
    """Return the tabletop at the elevation with the most typical proportions, or None if none fits.

    ``fov`` (radians) is vertical; ``hidden`` and ``length`` are as in ``plane_from_view``.
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


_GRID = 24  # samples along the longer side
_DOUBT = np.deg2rad(3.0)  # typical error of the map in radians


def fit_view(latitude: Float[np.ndarray, "h w"]) -> tuple[float, float]:
    """Estimate the elevation and vertical field of view (radians) of a roll-free camera.

    ``latitude`` is each pixel's angle below the horizon in radians. Pixels are square, and the
    principal point is the image centre.
    """
    height, width = latitude.shape
    step = max(height, width) / _GRID
    y, x = np.mgrid[step / 2 : height : step, step / 2 : width : step]
    seen = latitude[y.astype(int), x.astype(int)].ravel()
    u, v = (x.ravel() - width / 2) / height, (y.ravel() - height / 2) / height

    def off(p: np.ndarray) -> np.ndarray:
        return (_angles(u, v, p[0], np.exp(p[1])) - seen) / _DOUBT

    start = np.array([np.clip(np.median(seen), 0.15, 1.45), np.log(1.5)])
    bounds = [0.02, np.log(0.6)], [np.pi / 2, np.log(6.0)]
    elevation, focal = least_squares(off, start, bounds=bounds, loss="soft_l1").x
    return float(elevation), float(2 * np.arctan(0.5 / np.exp(focal)))


def _angles(
    u: Float[np.ndarray, "n"], v: Float[np.ndarray, "n"], elevation: float, focal: float
) -> Float[np.ndarray, "n"]:
    """Return rays' angles below the horizon; ``u``, ``v`` and ``focal`` are in picture heights."""
    down = v / focal * np.cos(elevation) + np.sin(elevation)
    return np.arcsin(np.clip(down / np.sqrt(1 + (u**2 + v**2) / focal**2), -1, 1))
