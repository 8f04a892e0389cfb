"""Generic solids: closed triangle meshes with their convex pieces, standing on z = 0.

A solid has its own frame (z up, long side along x) in any unit of length; ``PosedSolid`` transforms
it to the object frame of ``projection``.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
import shapely.affinity
import shapely.ops
import trimesh
from jaxtyping import Float, Int

from ....geometry import rotation_z
from ....meshes.pixels import largest_piece
from ....scene import ConvexPart

Polygon = shapely.Polygon


@dataclass(frozen=True, eq=False)
class ConvexSolid:
    """A closed mesh with welded vertices and outward-facing triangles, and its convex pieces."""

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    parts: tuple[ConvexPart, ...]


@dataclass(frozen=True, eq=False)
class PosedSolid:
    """A solid rotated by ``yaw`` and moved to ``position``; ``kind`` names its family."""

    kind: str
    solid: ConvexSolid
    yaw: float
    position: Float[np.ndarray, "3"]

    @property
    def world(self) -> Float[np.ndarray, "n 3"]:
        """The vertices in the object frame."""
        return self.solid.vertices @ rotation_z(self.yaw).T + self.position


def box(width: float, depth: float, height: float) -> ConvexSolid:
    """Return a box of the given x, y, z extent."""
    mesh = trimesh.creation.box(extents=(width, depth, height))
    vertices = np.asarray(mesh.vertices) + np.array([0, 0, height / 2])
    return ConvexSolid(vertices, np.asarray(mesh.faces), (ConvexPart(vertices, "box"),))


def stack_of_ellipses(
    heights: Float[np.ndarray, "k"],
    radii: Float[np.ndarray, "k"],
    shifts: Float[np.ndarray, "k"],
    depth: float,
    segments: int = 40,
) -> ConvexSolid:
    """Return the solid through level ellipses at ``heights`` that start at 0.

    Each ellipse has the half width ``radii`` > 0 along x, ``depth`` times that along y, and its
    centre at x = ``shifts``.
    """
    angle = np.arange(segments) * 2 * np.pi / segments
    ring = np.column_stack([np.cos(angle), depth * np.sin(angle), np.zeros(segments)])
    k = len(heights)
    middles = np.column_stack([shifts, np.zeros(k), heights])
    rings = (ring * radii[:, None, None] + middles[:, None]).reshape(-1, 3)
    vertices = np.concatenate([rings, middles[[0, -1]]])
    here, after = np.arange(segments), np.roll(np.arange(segments), -1)
    faces = []
    for level in range(k - 1):
        a, b = level * segments + here, level * segments + after
        c, d = a + segments, b + segments
        faces += [np.column_stack([a, b, d]), np.column_stack([a, d, c])]
    top = (k - 1) * segments
    faces.append(np.column_stack([after, here, np.full(segments, k * segments)]))
    faces.append(np.column_stack([top + here, top + after, np.full(segments, k * segments + 1)]))
    return ConvexSolid(vertices, np.concatenate(faces), _frusta(heights, radii, shifts, depth))


def _frusta(
    heights: Float[np.ndarray, "k"],
    radii: Float[np.ndarray, "k"],
    shifts: Float[np.ndarray, "k"],
    depth: float,
    maximum: int = 8,
) -> tuple[ConvexPart, ...]:
    """Split a stack into at most ``maximum`` pieces; straight, round pieces become cylinders."""
    keep = simplify_profile(heights, np.column_stack([radii, shifts]), maximum + 1)
    angle = np.arange(16) * 2 * np.pi / 16
    ring = np.column_stack([np.cos(angle), depth * np.sin(angle), np.zeros(16)])
    parts = []
    for a, b in pairwise(keep):
        ends = [radii[i] * ring + [shifts[i], 0, heights[i]] for i in (a, b)]
        straight = abs(radii[a] - radii[b]) < 0.04 * max(radii[a], radii[b])
        straight &= abs(shifts[a] - shifts[b]) < 0.02 * radii[a]
        parts.append(ConvexPart(np.concatenate(ends), "cylinder" if straight else "hull"))
    return tuple(parts)


def simplify_profile(
    heights: Float[np.ndarray, "k"],
    profile: Float[np.ndarray, "k c"],
    maximum: int,
    slack: float = 0.01,
) -> list[int]:
    """Return the indices of at most ``maximum`` levels that preserve a profile's shape.

    ``profile`` has several lengths per level. Levels are added where the polyline deviates most,
    until the largest error is below ``slack`` times the largest length.
    """
    keep = [0, len(heights) - 1]
    columns = profile.T
    while len(keep) < maximum:
        error = np.max(
            [np.abs(np.interp(heights, heights[keep], c[keep]) - c) for c in columns], axis=0
        )
        worst = int(error.argmax())
        if error[worst] < slack * np.abs(profile).max() or worst in keep:
            break
        keep = sorted([*keep, worst])
    return keep


def join(solids: list[ConvexSolid]) -> ConvexSolid:
    """Merge solids in a common frame into one solid, whose parts stay closed."""
    counts = np.cumsum([0, *(len(s.vertices) for s in solids)])
    return ConvexSolid(
        np.concatenate([s.vertices for s in solids]),
        np.concatenate([s.faces + n for s, n in zip(solids, counts, strict=False)]),
        tuple(part for s in solids for part in s.parts),
    )


def prism(outline: Polygon, height: float) -> ConvexSolid:
    """Return the extrusion of a polygon in the xy plane from z = 0 to ``height``."""
    mesh = trimesh.creation.extrude_polygon(outline, height, engine="earcut")
    mesh.merge_vertices()
    parts = []
    for piece in convex_pieces(outline):
        flat = np.asarray(hull_ring(piece).coords)[:-1]
        points = np.concatenate([np.insert(flat, 2, z, axis=1) for z in (0, height)])
        rectangular = piece.area > 0.995 * piece.envelope.area
        parts.append(ConvexPart(points, "box" if rectangular else "hull"))
    return ConvexSolid(np.asarray(mesh.vertices), np.asarray(mesh.faces), tuple(parts))


def upright(outline: Polygon, depth: float) -> ConvexSolid:
    """Return the extrusion of a polygon in the xz plane (z up) along y from -depth/2 to depth/2."""
    lying = prism(outline, depth)

    def stand(points: np.ndarray) -> np.ndarray:
        return np.column_stack([points[:, 0], depth / 2 - points[:, 2], points[:, 1]])

    parts = tuple(ConvexPart(stand(p.vertices), p.kind) for p in lying.parts)
    return ConvexSolid(stand(lying.vertices), lying.faces, parts)


def convex_pieces(outline: Polygon, maximum: int = 8, slack: float = 0.03) -> list[Polygon]:
    """Split a polygon into at most ``maximum`` nearly convex pieces.

    The piece with the largest deviation from its convex hull is split through its deepest dent,
    until every piece fills its hull except for ``slack`` of the total area.
    """
    pieces = [outline]
    while len(pieces) < maximum:
        lack = [p.convex_hull.area - p.area for p in pieces]
        worst = int(np.argmax(lack))
        if lack[worst] < slack * outline.area:
            break
        halves = _cut_at_dent(pieces[worst])
        if len(halves) < 2:
            break
        pieces[worst : worst + 1] = halves
    return pieces[:maximum] if len(pieces) > maximum else pieces


def largest_polygon(shape: shapely.Geometry) -> Polygon:
    """Return the largest polygon of a geometry, or an empty one if it has none."""
    polygons = [g for g in shapely.get_parts(shape) if isinstance(g, Polygon)]
    return max(polygons, key=lambda g: g.area, default=Polygon())


def hull_ring(shape: Polygon) -> shapely.LinearRing:
    """Return the outline of a polygon's convex hull."""
    return shapely.LinearRing(shapely.get_coordinates(shape.convex_hull))


def _cut_at_dent(piece: Polygon) -> list[Polygon]:
    """Split a polygon through its largest hole or deepest dent, in the best of 12 directions."""
    ring = np.asarray(piece.exterior.coords)[:-1]
    hull = hull_ring(piece)
    depth = np.array([hull.distance(shapely.Point(p)) for p in ring])
    dent, reach = ring[int(depth.argmax())], float(np.ptp(ring, axis=0).max()) * 4
    if piece.interiors:
        hole = max(piece.interiors, key=lambda ring: shapely.Polygon(ring).area)
        dent = np.array(hole.centroid.coords[0])
    best: tuple[float, list[Polygon]] = (np.inf, [piece])
    for angle in np.arange(12) * np.pi / 12:
        step = reach * np.array([np.cos(angle), np.sin(angle)])
        cut = shapely.ops.split(piece, shapely.LineString([dent - step, dent + step]))
        halves = [g for g in cut.geoms if isinstance(g, Polygon) and g.area > 1e-3 * piece.area]
        lack = sum(h.convex_hull.area - h.area for h in halves)
        # Additional pieces and slivers add to the cost.
        cost = lack / piece.area + 0.02 * len(halves)
        if len(halves) >= 2 and cost < best[0]:
            best = (cost, halves)
    return best[1]


def heightfield(heights: Float[np.ndarray, "a b"], width: float, depth: float) -> ConvexSolid:
    """Return the solid under a grid of vertex heights over a width (x) by depth (y) rectangle.

    Cells whose four corners are all zero are empty; only the largest connected piece is kept.
    """
    a, b = heights.shape
    used = heights > 0
    cells = used[:-1, :-1] | used[1:, :-1] | used[:-1, 1:] | used[1:, 1:]
    cells = largest_piece(cells)
    floor = 0.02 * float(heights.max())
    x, y = np.meshgrid(
        np.linspace(-width / 2, width / 2, a), np.linspace(-depth / 2, depth / 2, b), indexing="ij"
    )
    top = np.column_stack([x.ravel(), y.ravel(), np.maximum(heights, floor).ravel()])
    vertices = np.concatenate([top, top * [1, 1, 0]])
    i, j = np.nonzero(cells)
    p, q, r, s = i * b + j, (i + 1) * b + j, (i + 1) * b + j + 1, i * b + j + 1
    quads = np.column_stack([p, q, r, s])
    lower = quads + a * b
    faces = [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]], lower[:, [0, 2, 1]], lower[:, [0, 3, 2]]]
    edges = np.concatenate([quads[:, [k, (k + 1) % 4]] for k in range(4)])
    known = {(int(u), int(v)) for u, v in edges}
    rim = np.array([e for e in map(tuple, edges.tolist()) if (e[1], e[0]) not in known])
    u, v = rim[:, 0], rim[:, 1]
    faces += [np.column_stack([u, v + a * b, v]), np.column_stack([u, u + a * b, v + a * b])]
    triangles = np.concatenate(faces)
    kept, triangles = np.unique(triangles, return_inverse=True)
    parts = _strips(vertices, quads, width)
    return ConvexSolid(vertices[kept], triangles.reshape(-1, 3), parts)


def _strips(
    vertices: Float[np.ndarray, "n 3"], quads: Int[np.ndarray, "q 4"], width: float, count: int = 6
) -> tuple[ConvexPart, ...]:
    """Return the convex hulls of a height field's slices along x."""
    middle = vertices[quads].mean(1)[:, 0]
    index = np.clip(((middle / width + 0.5) * count).astype(int), 0, count - 1)
    parts = []
    for k in range(count):
        corners = np.unique(quads[index == k])
        if len(corners) >= 4:
            points = vertices[corners]
            points = np.concatenate([points, points * [1, 1, 0]])
            parts.append(ConvexPart(trimesh.convex.convex_hull(points).vertices))
    return tuple(parts)
