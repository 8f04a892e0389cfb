"""Watertight solids: boxes, prisms, solids of revolution and tubes, all built as lofts.

Every solid is closed once vertices at the same position are merged, and its faces are
counter-clockwise seen from outside. Vertices are duplicated along texture seams and sharp edges.
Lengths are in metres, angles in radians. Texture coordinates lie in [0, 1]^2, with u to the right
and v upwards for a viewer who looks at the face from outside.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from ..values import frozen_array
from .outlines import ellipse, inset, lift, rectangle

SHARP = np.deg2rad(38.0)
"""Angle between two faces, in radians, above which they do not share the vertices of their edge."""


@dataclass(frozen=True, eq=False)
class Solid:
    """A closed triangle mesh with texture coordinates."""

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "vertices", frozen_array(self.vertices, np.float64, (None, 3), "Solid.vertices")
        )
        object.__setattr__(
            self, "faces", frozen_array(self.faces, np.int32, (None, 3), "Solid.faces")
        )
        object.__setattr__(
            self, "uv", frozen_array(self.uv, np.float64, (len(self.vertices), 2), "Solid.uv")
        )

    @property
    def bounds(self) -> Float[np.ndarray, "2 3"]:
        """The lowest and highest corners of the bounding box."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)])

    @property
    def volume(self) -> float:
        """The enclosed volume in cubic metres."""
        return signed_volume(self.vertices, self.faces)

    @property
    def area(self) -> float:
        """The surface area in square metres."""
        a, b, c = self.vertices[self.faces].transpose(1, 0, 2)
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2

    def move(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
        """Return a translated copy of the solid."""
        return Solid(self.vertices + np.array([x, y, z]), self.faces, self.uv)

    def scale(self, x: float, y: float, z: float) -> Solid:
        """Return a copy of the solid, scaled along the axes by positive factors."""
        return Solid(self.vertices * np.array([x, y, z]), self.faces, self.uv)

    def turn(self, axis: int, angle: float) -> Solid:
        """Rotate a copy of the solid about the x (0), y (1) or z (2) axis through the origin."""
        c, s = float(np.cos(angle)), float(np.sin(angle))
        i, j = (axis + 1) % 3, (axis + 2) % 3
        vertices = self.vertices.copy()
        vertices[:, i] = c * self.vertices[:, i] - s * self.vertices[:, j]
        vertices[:, j] = s * self.vertices[:, i] + c * self.vertices[:, j]
        return Solid(vertices, self.faces, self.uv)

    def bend(self, warp: Callable[[Float[np.ndarray, "n 3"]], Float[np.ndarray, "n 3"]]) -> Solid:
        """Return a copy of the solid with its vertices moved by ``warp``.

        The result must not intersect itself.
        """
        return Solid(warp(self.vertices.copy()), self.faces, self.uv)

    def paint(self, low: tuple[float, float], high: tuple[float, float]) -> Solid:
        """Return a copy of the solid with its texture limited to the area ``low`` to ``high``."""
        corner, span = np.array(low), np.array(high) - np.array(low)
        return Solid(self.vertices, self.faces, corner + self.uv * span)


def signed_volume(vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]) -> float:
    """Return the signed volume of a closed mesh, which is positive if its faces point outwards."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def join(solids: Sequence[Solid]) -> Solid:
    """Join several solids into one, but keep their surfaces separate."""

    def add(a: Solid, b: Solid) -> Solid:
        return Solid(np.concatenate([a.vertices, b.vertices]), np.concatenate([a.faces, b.faces
                                                                               + len(a.vertices)]),
                     np.concatenate([a.uv, b.uv]))  # fmt: skip

    return reduce(add, solids)


def refine(solid: Solid) -> Solid:
    """Return the solid with every triangle split into four, so that it can be bent smoothly."""
    v, f, uv = solid.vertices, solid.faces, solid.uv
    pairs = np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
    ends = np.sort(pairs, axis=1)
    middles = (v[ends[:, 0]] + v[ends[:, 1]]) / 2
    number = len(v) + np.arange(len(pairs)).reshape(3, -1).T
    a, b, c = f.T
    ab, bc, ca = number.T
    faces = np.concatenate(
        [np.column_stack(t) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    )
    between = (uv[ends[:, 0]] + uv[ends[:, 1]]) / 2
    return Solid(np.concatenate([v, middles]), faces, np.concatenate([uv, between]))


def _lanes(points: Float[np.ndarray, "k d"], closed: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return the indices of points, repeated at sharp corners, and which neighbours are joined."""
    ring = np.concatenate([points, points[:1]]) if closed else points
    steps = np.diff(ring, axis=0)
    lengths = np.linalg.norm(steps, axis=1, keepdims=True)
    ways = steps / np.where(lengths > 0, lengths, 1)
    turns = np.arccos(np.clip((ways[:-1] * ways[1:]).sum(1), -1, 1))
    index, spans = [0], []
    for k in range(1, len(ring)):
        index.append(k)
        spans.append(True)
        if k < len(ring) - 1 and turns[k - 1] > SHARP:
            index.append(k)
            spans.append(False)
    return np.array(index), np.array(spans)


def _along(points: Float[np.ndarray, "k d"]) -> Float[np.ndarray, "k"]:
    """Return the arc length up to each point of a polyline as a fraction of the total."""
    lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    return lengths / lengths[-1] if lengths[-1] > 0 else np.linspace(0, 1, len(points))


_OUTLINE = "The outline crosses itself or turns clockwise; give a simple counter-clockwise polygon."


def _triangles(outline: Float[np.ndarray, "k 2"]) -> Int[np.ndarray, "m 3"]:
    """Triangulate a simple counter-clockwise polygon by ear clipping."""

    def cross(o: np.ndarray, a: np.ndarray, b: np.ndarray) -> Any:
        return (a[..., 0] - o[..., 0]) * (b[..., 1] - o[..., 1]) - (a[..., 1] - o[..., 1]) * (
            b[..., 0] - o[..., 0]
        )

    left, faces = list(range(len(outline))), []
    turn = cross(np.roll(outline, 1, 0), outline, np.roll(outline, -1, 0))
    if cross(outline[0], outline[:-1], outline[1:]).sum() <= 0:
        raise ValueError(_OUTLINE)
    if (turn >= 0).all():
        return np.array([(0, k, k + 1) for k in range(1, len(outline) - 1)])
    while len(left) > 3:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = outline[i], outline[j], outline[m]
            if cross(a, b, c) <= 1e-15:
                continue
            rest = outline[[n for n in left if n not in (i, j, m)]]
            inside = (cross(a, b, rest) >= 0) & (cross(b, c, rest) >= 0) & (cross(c, a, rest) >= 0)
            if not inside.any():
                faces.append((i, j, m))
                left.pop(k)
                break
        else:
            raise ValueError(_OUTLINE)
    return np.array([*faces, tuple(left)])


def _cap(ring: Float[np.ndarray, "m 3"], outline: Float[np.ndarray, "m 2"], flip: bool) -> Solid:
    faces = _triangles(outline)
    low, span = outline.min(0), np.maximum(np.ptp(outline, axis=0), 1e-12)
    uv = (outline - low) / span
    if flip:
        faces, uv = faces[:, ::-1], uv * [-1, 1] + [1, 0]
    return Solid(ring, faces, uv)


def loft(
    rings: Float[np.ndarray, "k m 3"],
    outline: Float[np.ndarray, "m 2"] | None = None,
    *,
    v: Float[np.ndarray, "rows"] | None = None,
    profile: Float[np.ndarray, "k d"] | None = None,
    loop: bool = False,
) -> Solid:
    """Return the solid that connects a stack of rings.

    Each ring is closed and counter-clockwise seen from the last ring's side. ``outline`` is the
    flattened ring that closes the two ends and determines sharp edges; None means that the ends
    shrink to a point and the rings are smooth. ``profile`` is the curve along which the rings run
    (default: through their first points). ``loop`` joins the last ring to the first. Texture
    coordinate u runs once around; ``v`` is the vertical coordinate of each ring, and in a loop ends
    with one more value, for the first ring.
    """
    rings = np.asarray(rings, float)
    if loop:
        rings = np.concatenate([rings, rings[:1]])
    size = rings.shape[1]
    path = rings[:, 0] if profile is None else np.asarray(profile, float)
    if loop and profile is not None:
        path = np.concatenate([path, path[:1]])
    rows, down = _lanes(path, False)
    section = ellipse(1, 1, size) if outline is None else outline
    columns, across = _lanes(section, True)
    heights = _along(path) if v is None else np.asarray(v, float)
    around = _along(np.concatenate([section, section[:1]]))

    vertices = rings[rows][:, columns % size]
    uv = np.stack(np.broadcast_arrays(around[columns][None], heights[rows][:, None]), -1)
    number = np.arange(len(rows) * len(columns)).reshape(len(rows), len(columns))
    corner = (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1])
    keep = down[:, None] & across[None]
    a, b, c, d = (block[keep] for block in corner)
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    flat = vertices.reshape(-1, 3)
    p = flat[faces]
    whole = ~(
        (p[:, 0] == p[:, 1]).all(1) | (p[:, 1] == p[:, 2]).all(1) | (p[:, 2] == p[:, 0]).all(1)
    )
    solids = [Solid(flat, faces[whole], np.clip(uv.reshape(-1, 2), 0, 1))]
    if outline is not None and not loop:
        solids += [_cap(rings[0], outline, True), _cap(rings[-1], outline, False)]
    return outward(join(solids))


def outward(solid: Solid) -> Solid:
    """Return the solid with its faces pointing outwards."""
    faces = solid.faces if solid.volume > 0 else solid.faces[:, ::-1]
    return Solid(solid.vertices, faces, solid.uv)


def prism(outline: Any, low: float, high: float, bevel: float = 0.0) -> Solid:
    """Return ``outline`` (counter-clockwise) extruded from z ``low`` to ``high``.

    ``bevel`` chamfers the upper and lower edges; the outline must then be convex. The texture lies
    flat on the top and bottom and wraps around the side.
    """
    outline = np.asarray(outline, float)
    if bevel <= 0:
        return loft(np.stack([lift(outline, low), lift(outline, high)]), outline)
    bevel = min(bevel, 0.49 * (high - low))
    small = inset(outline, bevel)
    rings = [(small, low), (outline, low + bevel), (outline, high - bevel), (small, high)]
    return loft(np.stack([lift(o, z) for o, z in rings]), outline)


def box(x: float, y: float, z: float) -> Solid:
    """Return a box on z = 0, centred in x and y; each face shows the whole texture."""
    unit = _unit_box()
    return Solid(unit.vertices * [x, y, z] + [0, 0, z / 2], unit.faces, unit.uv)


@cache
def _unit_box() -> Solid:
    """Return a unit cube centred at the origin."""
    corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2
    frames = [  # outward normal, direction of u, direction of v
        ([0, -1, 0], [1, 0, 0], [0, 0, 1]),
        ([0, 1, 0], [-1, 0, 0], [0, 0, 1]),
        ([1, 0, 0], [0, 1, 0], [0, 0, 1]),
        ([-1, 0, 0], [0, -1, 0], [0, 0, 1]),
        ([0, 0, 1], [1, 0, 0], [0, 1, 0]),
        ([0, 0, -1], [-1, 0, 0], [0, 1, 0]),
    ]
    vertices = np.concatenate(
        [np.array(n) / 2 + corner[:, :1] * u + corner[:, 1:] * v for n, u, v in frames]
    )
    faces = np.concatenate([np.array([[0, 1, 2], [0, 2, 3]]) + 4 * k for k in range(6)])
    return Solid(vertices, faces, np.tile(corner + 0.5, (6, 1)))


def block(x: float, y: float, z: float, radius: float, bevel: float = 0.0, steps: int = 4) -> Solid:
    """Return a box on z = 0 with rounded vertical edges and chamfered rims."""
    return prism(rectangle(x, y, radius, steps), 0, z, bevel)


def open_box(x: float, y: float, z: float, wall: float, bottom: float) -> list[Solid]:
    """Return an open box on z = 0: a bottom and four walls."""
    side = box(wall, y, z - bottom).move(z=bottom)
    front = box(x - 2 * wall, wall, z - bottom).move(z=bottom)
    return [box(x, y, bottom), side.move(x=-(x - wall) / 2), side.move(x=(x - wall) / 2),
            front.move(y=-(y - wall) / 2), front.move(y=(y - wall) / 2)]  # fmt: skip


def lathe(
    profile: Any, segments: int = 32, *, v: Sequence[float] | None = None, loop: bool = False
) -> Solid:
    """Return the solid that results from revolving ``profile`` (radius, z) points about the z axis.

    The profile starts and ends on the axis (radius 0), or with ``loop`` is a closed curve away
    from it. It runs counter-clockwise, with the material on its left: from the centre of the bottom
    outwards, up the outside, and back down the inside of hollow objects. u runs around (0.5 faces
    the viewer at -y); v runs along the profile, or is given for each point.
    """
    profile = np.asarray(profile, float)
    angles = np.pi / 2 + 2 * np.pi * np.arange(segments) / segments
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(segments)])
    rings = profile[:, :1, None] * ring + profile[:, 1:, None] * np.array([0.0, 0.0, 1.0])
    heights = None if v is None else np.asarray(v, float)
    if loop and heights is not None:
        heights = np.concatenate([heights, heights[:1]])
    return loft(rings, None, v=heights, profile=profile, loop=loop)


def cylinder(
    radius: float, height: float, segments: int = 24, *, top: float | None = None, bevel: float = 0
) -> Solid:
    """Return a cylinder on z = 0, or a cone whose upper radius is ``top``."""
    upper = radius if top is None else top
    unit = ellipse(2, 2, segments, np.pi / 2)
    radii, heights = [radius, upper], [0.0, height]
    if bevel > 0:
        radii = [radius - bevel, radius, upper, upper - bevel]
        heights = [0, bevel, height - bevel, height]
    rings = np.stack([lift(unit * r, z) for r, z in zip(radii, heights, strict=True)])
    return loft(rings, unit, profile=np.column_stack([radii, heights]))


def ellipsoid(x: float, y: float, z: float, segments: int = 24, rings: int = 14) -> Solid:
    """Return an ellipsoid with *diameters* x, y and z, centred at the origin."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, rings + 1)
    profile = np.column_stack([np.cos(angles), np.sin(angles)]) / 2
    profile[[0, -1], 0] = 0
    return lathe(profile, segments).scale(x, y, z)


def torus(radius: float, tube: float, segments: int = 28, sides: int = 10) -> Solid:
    """Return a torus about z, centred at the origin; ``tube`` is the radius of its tube."""
    return lathe(ellipse(2 * tube, 2 * tube, sides) + np.array([radius, 0.0]), segments, loop=True)


def tube(
    path: Any, radius: Any, sides: int = 10, *, squash: float = 1.0, loop: bool = False
) -> Solid:
    """Return a round rod along ``path`` (k points), closed at its ends.

    ``radius`` is one number, or one per point. ``squash`` is the height of the cross-section
    relative to its width, which stays as level as the path allows.
    """
    section = ellipse(2, 2 * squash, sides)
    return sweep(path, section, radius, loop=loop)


def sweep(
    path: Any, section: Float[np.ndarray, "m 2"], scale: Any = 1.0, *, loop: bool = False
) -> Solid:
    """Sweep the counter-clockwise ``section`` (width, height) along ``path``, with scaling."""
    path = np.asarray(path, float)
    ways = np.roll(path, -1, 0) - np.roll(path, 1, 0) if loop else np.gradient(path, axis=0)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    start = np.eye(3)[2] if abs(ways[0, 2]) < 0.9 else np.eye(3)[1]
    ups = []
    up = start
    for way in ways:
        up = up - way * (up @ way)
        up = up / np.linalg.norm(up)
        ups.append(up)
    up_ways = np.array(ups)
    sides = np.cross(ways, up_ways)
    size = np.broadcast_to(np.asarray(scale, float), len(path))[:, None, None]
    rings = path[:, None] + size * (
        section[None, :, :1] * sides[:, None] + section[None, :, 1:] * up_ways[:, None]
    )
    return loft(rings, section, profile=path, loop=loop)


Point = tuple[float, float, float]

Profile = Sequence[tuple[float, float]]
"""Points (radius, z) of the outer surface of a solid of revolution, in metres."""
