"""Elevation and field of view from a map of angles below the horizon."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares

_GRID = 24  # samples along the longer side
_DOUBT = np.deg2rad(3.0)  # typical error of the map in radians


def fit_view(latitude: Float[np.ndarray, "h w"]) -> tuple[float, float]:
    """Return the elevation and vertical field of view (radians) of a level camera.

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
    """Return the angles of rays below the horizon; u, v and focal are in picture heights."""
    down = v / focal * np.cos(elevation) + np.sin(elevation)
    return np.arcsin(np.clip(down / np.sqrt(1 + (u**2 + v**2) / focal**2), -1, 1))
