"""Parametric tables: any convex top, and a few kinds of legs with free dimensions.

All parts are convex pieces between two rings, so a form's silhouette is very cheap to compute: the
modeler compares hundreds of forms with a picture.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np
import shapely
from jaxtyping import Float

from tabletop_objects.kit import surfaces
from tabletop_objects.kit.outlines import ellipse, rectangle
from tabletop_objects.kit.parts import hull_part
from tabletop_objects.kit.shapes import mesh_of, shape
from tabletop_objects.kit.solids import loft, prism
from tabletop_objects.values import parts_to_unit_box, to_unit_box

from ...scene import TABLE, Model, Physics

LegStyle = Literal["posts", "sled", "trestle", "pedestal"]
Ring = Float[np.ndarray, "2 _ 3"]

_THREE = 0.56  # fraction of the top's area within a triangle, above which it has three legs
_SQUARE = rectangle(1, 1)
_CIRCLE = ellipse(1, 1, 16)


@dataclass(frozen=True, eq=False)
class TableForm:
    """A table in metres; the centre of its top's bounding box is at x = y = 0.

    ``outline`` is the outline of the top, convex and counter-clockwise; ``corners`` are the corners
    for its legs (``corners_of``). ``inset`` is the distance of the joints inside the corners, along
    x and y; ``lean`` is the outward distance of the feet from the joints. ``high`` and ``low`` are
    a leg's widths under the top and at the floor; for a pedestal, the diameters of the column and
    the base. ``apron`` is the height of the boards between legs.
    """

    outline: Float[np.ndarray, "k 2"]
    corners: Float[np.ndarray, "n 2"]
    height: float
    thickness: float = 0.03
    legs: LegStyle = "posts"
    inset: tuple[float, float] = (0.06, 0.06)
    lean: float = 0.0
    high: float = 0.05
    low: float = 0.05
    apron: float = 0.0

    @property
    def size(self) -> Float[np.ndarray, "3"]:
        """The length, width and height."""
        return np.array([*np.ptp(self.outline, axis=0), self.height])

    def joints(self) -> Float[np.ndarray, "n 2"]:
        """Return the points where the legs join the top, inside its corners."""
        corners = self.corners
        if len(corners) == 3:
            middle = corners.mean(0)
            away = np.linalg.norm(corners - middle, axis=1, keepdims=True)
            return middle + (corners - middle) * np.maximum(1 - self.inset[0] / away, 0.1)
        return np.sign(corners) * np.maximum(np.abs(corners) - self.inset, self.high / 2)

    def pieces(self) -> list[Ring]:
        """Return the legs' convex pieces (two rings each, from z = 0), within the top's bounds."""
        top = self.height - self.thickness
        made = {"posts": self._posts, "sled": self._sled, "trestle": self._trestle,
                "pedestal": self._pedestal}  # fmt: skip
        rings = made[self.legs](top)
        low, high = self.outline.min(0), self.outline.max(0)
        for ring in rings:
            flat = ring[..., :2]
            under, over = low - flat.min(1, keepdims=True), flat.max(1, keepdims=True) - high
            if under.max() > 0 or over.max() > 0:
                ring[..., :2] = np.clip(flat + under.clip(0) - over.clip(0), low, high)
        return rings

    def feet(self) -> Float[np.ndarray, "n 2"]:
        """Return the corners of the parts on the floor; the table's height does not affect them."""
        return np.concatenate([ring[0, :, :2] for ring in self.pieces() if ring[0, 0, 2] == 0])

    def _posts(self, top: float) -> list[Ring]:
        joints = self.joints()
        middle = joints.mean(0)
        out = (joints - middle) / np.linalg.norm(joints - middle, axis=1, keepdims=True)
        feet = joints + self.lean * out
        rings = [
            _piece(_SQUARE * self.low + foot, 0.0, _SQUARE * self.high + joint, top)
            for foot, joint in zip(feet, joints, strict=True)
        ]
        if self.apron:
            for a, b in zip(joints, np.roll(joints, -1, 0), strict=True):
                rings.append(_board(a, b, 0.4 * self.high, top - self.apron, top))
        return rings

    def _sled(self, top: float) -> list[Ring]:
        joints = self.joints()
        order = np.argsort(joints[:, 0], kind="stable")
        pairs = [joints[order[:2]], joints[order[-2:]]]
        rings = [_piece(_SQUARE * self.low + j, 0.0, _SQUARE * self.high + j, top) for j in joints]
        return rings + [_board(a, b, self.low, 0.0, 0.8 * self.low) for a, b in pairs]

    def _trestle(self, top: float) -> list[Ring]:
        reach = np.abs(self.joints()).max(0)
        rings = []
        for end in (-reach[0], reach[0]):
            middle = np.array([end, 0.0])
            post = _SQUARE * [self.high, 2 * self.high] + middle
            rings.append(_piece(post, 0.0, post, top))
            front, back = np.array([end, -reach[1]]), np.array([end, reach[1]])
            bars = (0.0, top - self.low)
            rings += [_board(front, back, self.low, z, z + self.low) for z in bars]
        return rings

    def _pedestal(self, top: float) -> list[Ring]:
        thick = 0.05 * self.height
        base, column = _CIRCLE * self.low, _CIRCLE * self.high
        return [_piece(base, 0.0, 0.9 * base, thick), _piece(column, thick, column, top)]

    def build(self) -> Model:
        """Return the canonical model in plain grey, with one convex part per piece."""
        top = prism(self.outline, self.height - self.thickness, self.height)
        grey = surfaces.plain((200, 200, 200))
        solids, parts = [(top, grey)], [hull_part(_thin(self.outline, top.bounds[:, 2]))]
        for ring in self.pieces():
            foot = ring[0, :, :2]
            solids.append((loft(ring, foot - foot.mean(0)), grey))
            parts.append(hull_part(ring.reshape(-1, 3)))
        mesh, center, extent = to_unit_box(mesh_of(shape(solids, parts)))
        unit = parts_to_unit_box(tuple(parts), center, extent)
        return Model(TABLE, TABLE, mesh, self.size, Physics(600.0, 0.7), unit, category=TABLE)


def corners_of(outline: Float[np.ndarray, "k 2"]) -> Float[np.ndarray, "n 2"]:
    """Return a triangular top's corners, or else the rim points on its bounding box's diagonals."""
    polygon = shapely.Polygon(outline)
    rays = np.linspace(0, 2 * np.pi, 36, endpoint=False) + np.pi / 2
    middle = np.array(polygon.centroid.coords[0])
    reach = float(np.ptp(outline, axis=0).max())
    rim = _hits(polygon, middle, reach * np.column_stack([np.cos(rays), np.sin(rays)]))
    a, b, c = (rim[list(k)] for k in zip(*combinations(range(len(rim)), 3), strict=True))
    area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    if area.max() > _THREE * polygon.area:
        k = int(area.argmax())
        return np.stack([a[k], b[k], c[k]])
    half = np.ptp(outline, axis=0) / 2
    rays = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    return _hits(polygon, np.zeros(2), rays)


def _hits(
    polygon: shapely.Polygon, middle: Float[np.ndarray, "2"], rays: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n 2"]:
    """Return where rays from a point inside a convex polygon leave the polygon, or else end."""
    ends = [polygon.intersection(shapely.LineString([middle, middle + ray])) for ray in rays]
    return np.stack([shapely.get_coordinates(end)[-1] for end in ends])


def _piece(
    lower: Float[np.ndarray, "k 2"], z0: float, upper: Float[np.ndarray, "k 2"], z1: float
) -> Ring:
    return np.stack([at_height(lower, z0), at_height(upper, z1)])


def at_height(ring: Float[np.ndarray, "k 2"], z: float) -> Float[np.ndarray, "k 3"]:
    """Return the points of a level ring at height ``z``."""
    points = np.full((len(ring), 3), float(z))
    points[:, :2] = ring
    return points


def _board(
    a: Float[np.ndarray, "2"], b: Float[np.ndarray, "2"], thick: float, z0: float, z1: float
) -> Ring:
    """Return an upright board from ``a`` to ``b``."""
    along = (b - a) / max(float(np.linalg.norm(b - a)), 1e-9)
    side = np.array([along[1], -along[0]]) * thick / 2
    ring = np.stack([a + side, b + side, b - side, a - side])
    return _piece(ring, z0, ring, z1)


def _thin(
    outline: Float[np.ndarray, "k 2"], heights: Float[np.ndarray, "2"]
) -> Float[np.ndarray, "n 3"]:
    """Return up to 16 corners of an outline, including its extremes, at each of two heights."""
    at = np.linspace(0, 2 * np.pi, 12, endpoint=False) + np.pi / 12
    ways = np.column_stack([np.cos(at), np.sin(at)])
    ways = np.concatenate([ways, [[1, 0], [-1, 0], [0, 1], [0, -1]]])
    ring = outline[np.unique((outline @ ways.T).argmax(0))]
    return np.concatenate([at_height(ring, z) for z in heights])
