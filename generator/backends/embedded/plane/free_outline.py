"""Detected outlines of tabletops that are not rectangles, ellipses or triangles."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely

from ....geometry import convex_outline
from .outline import Outline
from .plane import RADIUS, TablePlane

_EXPLAINED = 0.975  # overlap, seen from above, above which a shape explains an outline
_LIKELY, _CLOSE = 0.93, 2.0  # a lower overlap suffices if the edge error is within this many pixels
_GRID = 160  # grid points per side for the overlap
_RAYS = 64  # corners of such an outline
_BLUNT = 0.02  # radius of its sharpest corners, relative to the length


def as_seen(plane: TablePlane, outline: Outline, factor: float) -> TablePlane:
    """Return the tabletop with its detected outline if no ideal shape explains the outline.

    Frame and size then follow the outline; the length is unchanged. Regions hidden by objects are
    ignored. ``factor`` is working pixels per picture pixel.
    """
    least = _LIKELY if plane.error * factor < _CLOSE else _EXPLAINED
    if _agreement(plane, outline, factor) > least:
        return plane
    seen = shapely.Polygon(convex_outline(plane.to_table(outline.hull / factor)))
    blunt = _BLUNT * plane.size[0]  # removes spikes caused by single points
    rim = seen.buffer(-blunt).buffer(blunt).exterior
    along = np.linspace(0, 1, _RAYS, endpoint=False)
    points = shapely.line_interpolate_point(rim, along, normalized=True)
    edge = convex_outline(shapely.get_coordinates(points))
    low, high = edge.min(0), edge.max(0)
    middle, grown = (low + high) / 2, plane.size[0] / float(high[0] - low[0])
    edge = (edge - middle) * grown
    position = (plane.camera.position - [*middle, 0.0]) * grown
    camera = replace(plane.camera, position=position)
    size = (plane.size[0], float(high[1] - low[1]) * grown)
    radius = min(plane.radius * grown, RADIUS * min(size))
    return replace(plane, camera=camera, size=size, radius=radius, edge=edge)


def _agreement(plane: TablePlane, outline: Outline, factor: float) -> float:
    """Return the IoU of the detected tabletop and its ideal shape, outside hidden regions."""
    ideal = shapely.Polygon(plane.top())
    hull = shapely.Polygon(plane.to_table(outline.hull / factor))
    x0, y0, x1, y1 = ideal.union(hull).bounds
    grid = np.stack(np.meshgrid(np.linspace(x0, x1, _GRID), np.linspace(y0, y1, _GRID)), -1)
    points = grid.reshape(-1, 2)
    column, row = np.floor(plane.to_pixels(points) * factor).astype(int).T
    height, width = outline.hidden.shape
    inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
    at = row.clip(0, height - 1), column.clip(0, width - 1)
    plain = ~(inside & outline.hidden[at])
    a, b = (inside & outline.top[at])[plain], shapely.contains_xy(ideal, points[plain])
    return float((a & b).sum() / max((a | b).sum(), 1))
