"""The metric table plane of an RGB-D picture, found from 3D points instead of colours.

Planes are drawn from triples of neighbouring points (a seeded RANSAC: Fischler and Bolles, 1981),
refined by least squares on their inliers, and scored: a tabletop faces up, is low in the picture,
carries objects, and lies above a floor.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int

from ....errors import SceneError
from ....geometry import Camera, convex_outline, inside_margin
from ....scene import Intrinsics
from ..plane.cut_plane import plane_of_region
from ..plane.plane import TablePlane

TALLEST = 0.6
"""Maximum height above the tabletop, in metres, of anything that counts as standing on it."""

_SEED = 0
_SAMPLES = 14_000  # points used for scoring hypotheses
_TRIES = 500  # hypotheses per plane
_PLANES = 5  # planes drawn in sequence
_NEAR = 0.12  # distance between the points of a triple, as a fraction of the longer side
_WARP = 0.01  # metres by which a depth map may deviate from the tabletop's plane
_FINEST = 0.003  # metres; no depth map is assumed to be more precise
_LOWEST, _TILT = np.deg2rad(6.0), np.deg2rad(40.0)  # minimum elevation, maximum roll
# minimum fraction of the valid points, and minimum area in m², of a tabletop
_SHARE, _AREA = 0.05, 0.04
# a tabletop of this area (m²) at this height (m) above a plane makes that plane the floor
_FLOOR_GAP, _FLOOR_AREA = 0.25, 0.1
_PARALLEL = np.deg2rad(15.0)


@dataclass(frozen=True)
class Level:
    """A plane in camera axes (x right, y down, z forward), whose unit ``normal`` faces the camera.

    ``height`` is the camera's distance from the plane in metres. ``grain`` is the standard
    deviation of the plane's points relative to ``noise``: the coarseness of this depth map.
    """

    normal: tuple[float, float, float]
    height: float
    grain: float = 0.6

    def above(self, points: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n"]:
        """Return the heights of points (in camera axes) above the plane in metres."""
        return points @ np.array(self.normal) + self.height

    def spread(self, distance: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
        """Return the measurement error of points on the plane at a given distance, in metres."""
        return np.maximum(2.5 * self.grain * noise(distance), _FINEST)


def camera_points(
    depth: Float[np.ndarray, "h w"], intrinsics: Intrinsics
) -> Float[np.ndarray, "h w 3"]:
    """Return each pixel's point in camera axes in metres, or NaN where the depth is 0."""
    h, w = depth.shape
    z = np.where(depth > 0, depth, np.nan).astype(np.float64)
    x = (np.arange(w) - intrinsics.cx) / intrinsics.fx
    y = (np.arange(h) - intrinsics.cy) / intrinsics.fy
    return np.stack([x[None] * z, y[:, None] * z, z], -1)


def noise(distance: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
    """Return the accuracy of a depth camera in metres, which degrades with distance."""
    return 0.004 + 0.004 * np.square(distance)


def find_depth_plane(
    depth: Float[np.ndarray, "h w"],
    intrinsics: Intrinsics,
    table: Bool[np.ndarray, "h w"] | None = None,
) -> TablePlane:
    """Return the tabletop of an RGB-D picture, with a metric camera and the visible part's outline.

    ``depth`` is in metres along the optical axis, 0 where unknown. ``table`` marks pixels of the
    table, if known, and is used only to choose between planes.

    Raises:
        SceneError: no level plane could be a tabletop.
    """
    frozen = np.ascontiguousarray(depth, np.float32)
    hint = None if table is None else np.packbits(table).tobytes()
    return _solve(frozen.tobytes(), *frozen.shape, intrinsics, hint)


@lru_cache(maxsize=4)
def _solve(
    data: bytes, height: int, width: int, intrinsics: Intrinsics, hint: bytes | None
) -> TablePlane:
    """Solve for the plane; the result is cached, because several stages need it."""
    depth = np.frombuffer(data, np.float32).reshape(height, width)
    points = camera_points(depth, intrinsics)
    table = None
    if hint is not None:
        bits = np.unpackbits(np.frombuffer(hint, np.uint8), count=height * width)
        table = bits.reshape(height, width) > 0
    level = _choose(points, table)
    for _ in range(2):  # the region determines the points, and the points determine the coarseness
        level = _refine(level, points[top_region(points, level)[0]])
    region, carried = top_region(points, level)
    camera = level_camera(level, intrinsics, width, height)
    hidden = np.isnan(points[..., 2]) | (level.above(points) > 2 * level.spread(points[..., 2]))
    places = (points[carried] @ camera.rotation + camera.position)[:, :2]
    return plane_of_region(region, camera, _open(hidden, 3), places)


def level_camera(level: Level, intrinsics: Intrinsics, width: int, height: int) -> Camera:
    """Return the camera in the plane's frame (origin below it, y along its view, z upwards)."""
    up = np.array(level.normal)
    ahead = np.array([0.0, 0.0, 1.0]) - up[2] * up
    # for a view from straight above, y points to the picture's top
    if np.linalg.norm(ahead) < 0.02:
        ahead = np.array([0.0, -1.0, 0.0]) + up[1] * up
    ahead /= np.linalg.norm(ahead)
    rotation = np.column_stack([np.cross(ahead, up), ahead, up])
    focal = float(np.sqrt(intrinsics.fx * intrinsics.fy))
    offset = (intrinsics.cx + 0.5 - width / 2, intrinsics.cy + 0.5 - height / 2)
    fov = float(2 * np.arctan(height / 2 / focal))
    return Camera(np.array([0, 0, level.height]), rotation, fov, width, height, offset)


# ------------------------------------------------------------------------------------- regions


def smooth(points: Float[np.ndarray, "h w 3"]) -> Bool[np.ndarray, "h w"]:
    """Return the valid pixels that are not behind a depth discontinuity."""
    z = points[..., 2]
    known = np.isfinite(z)
    low = cv2.erode(np.where(known, z, np.inf).astype(np.float32), np.ones((3, 3), np.uint8))
    z = np.where(known, z, 0.0)
    return known & (z - np.where(known, low, 0.0) < 0.012 + 0.01 * z)


def top_region(
    points: Float[np.ndarray, "h w 3"], level: Level
) -> tuple[Bool[np.ndarray, "h w"], Bool[np.ndarray, "h w"]]:
    """Return the pixels of a single tabletop, and of the objects standing on it.

    The top consists of the pixels on the plane that are connected, directly or through those
    objects; a second table at the same height but apart in depth is excluded.
    """
    above = level.above(points)
    spread = level.spread(points[..., 2])
    on = np.abs(above) < np.maximum(spread, np.minimum(2 * spread, _WARP))
    linked = smooth(points) & (above > -spread) & (above < TALLEST)
    count, numbers = cv2.connectedComponents(linked.astype(np.uint8), connectivity=4)
    sizes = np.bincount(numbers[on & linked], minlength=count)
    sizes[0] = 0
    largest = numbers == sizes.argmax()
    return _open(on & largest, 3), _open(linked & ~on & largest & (above > 0), 5)


def _open(mask: Bool[np.ndarray, "h w"], side: int) -> Bool[np.ndarray, "h w"]:
    kernel = np.ones((side, side), np.uint8)
    return cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, kernel) > 0


def _refine(level: Level, points: Float[np.ndarray, "n 3"]) -> Level:
    """Refine a plane in three iterations, fitting it to its inliers by least squares."""
    for _ in range(3):
        near = np.abs(level.above(points)) < level.spread(points[:, 2])
        if near.sum() < 50:
            return level
        inliers, weight = points[near], 1 / noise(points[near, 2]) ** 2
        middle = np.average(inliers, axis=0, weights=weight)
        off = (inliers - middle) * np.sqrt(weight)[:, None]
        normal = np.linalg.eigh(off.T @ off)[1][:, 0]
        level = _plane_through(middle, normal)
        off = np.abs(level.above(inliers)) / noise(inliers[:, 2])
        level = replace(level, grain=float(np.clip(1.4826 * np.median(off), 0.05, 0.6)))
    return level


def _plane_through(point: Float[np.ndarray, "3"], normal: Float[np.ndarray, "3"]) -> Level:
    distance = float(point @ normal)
    if distance > 0:
        normal, distance = -normal, -distance
    x, y, z = (float(v) for v in normal)
    return Level((x, y, z), -distance)


# ------------------------------------------------------------------------------------- choosing


@dataclass(frozen=True, eq=False)
class _Candidate:
    """A plane with its inliers among the sampled points and its score as a tabletop."""

    level: Level
    inliers: Bool[np.ndarray, "n"]
    area: float
    score: float


def _choose(points: Float[np.ndarray, "h w 3"], table: Bool[np.ndarray, "h w"] | None) -> Level:
    """Return the plane with the best score as a tabletop.

    Raises:
        SceneError: no plane can be a tabletop.
    """
    height, width = points.shape[:2]
    stride = max(1, int(np.sqrt(height * width / _SAMPLES)))
    grid = points[::stride, ::stride]
    known = np.isfinite(grid[..., 2])
    rows, columns = np.nonzero(known)
    cloud = grid[known]
    hint = None if table is None else table[::stride, ::stride][known]
    found = _candidates(cloud, np.column_stack([columns, rows]), max(grid.shape[:2]), hint)
    fit = [c for c in found if c.inliers.mean() > _SHARE and c.area > _AREA]
    if not fit:
        raise SceneError(
            "No table plane in the depth map: no level surface of at least "
            f"{_AREA * 1e4:.0f} cm² lies below the camera. Point the camera down at the tabletop, "
            "and check the depth units and intrinsics."
        )
    if hint is not None and hint.mean() > _SHARE:
        held = [float((c.inliers & hint).sum()) for c in fit]
        if max(held) > 0.3 * hint.sum():
            return fit[int(np.argmax(held))].level
    floors = {id(low) for low in fit for top in fit if _stands_over(top, low, cloud)}
    tops = [c for c in fit if id(c) not in floors] or fit
    return max(tops, key=lambda c: c.score).level


def _stands_over(top: _Candidate, low: _Candidate, cloud: Float[np.ndarray, "n 3"]) -> bool:
    """Return whether ``top`` is a tabletop above ``low``, which is then the floor."""
    parallel = np.dot(top.level.normal, low.level.normal) > np.cos(_PARALLEL)
    gap = float(np.median(low.level.above(cloud[top.inliers])))
    return bool(parallel and gap > _FLOOR_GAP and top.area > _FLOOR_AREA)


def _candidates(
    cloud: Float[np.ndarray, "n 3"],
    pixels: Int[np.ndarray, "n 2"],
    side: int,
    hint: Bool[np.ndarray, "n"] | None,
) -> list[_Candidate]:
    """Find planes one after another, each among the points that are not on the previous ones."""
    rng = np.random.default_rng(_SEED)
    left = np.ones(len(cloud), bool)
    found: list[_Candidate] = []
    for _ in range(_PLANES):
        if left.sum() < 3 or left.mean() < _SHARE:
            break
        level = _draw(cloud[left], pixels[left], side, rng)
        if level is None:
            break
        level = _refine(level, cloud[left])
        inliers = np.abs(level.above(cloud)) < 1.5 * noise(cloud[:, 2])
        left &= ~inliers
        if _faces_up(np.array(level.normal)[None])[0] and inliers.any():
            found.append(_judge(level, _one_piece(inliers, pixels), cloud, pixels, side))
    return found


def _draw(
    cloud: Float[np.ndarray, "n 3"],
    pixels: Int[np.ndarray, "n 2"],
    side: int,
    rng: np.random.Generator,
) -> Level | None:
    """Return the level plane with the most inliers among planes through three nearby points."""
    first = rng.integers(len(cloud), size=_TRIES)
    others = [_neighbours(pixels, first, _NEAR * side, rng) for _ in range(2)]
    a, b, c = (cloud[k] for k in (first, *others))
    normals = np.cross(b - a, c - a)
    length = np.linalg.norm(normals, axis=1)
    normals = normals / np.maximum(length, 1e-12)[:, None]
    normals *= -np.sign((normals * a).sum(1))[:, None]
    usable = (length > 1e-6) & _faces_up(normals)
    if not usable.any():
        return None
    normals, heights = normals[usable], -(normals * a).sum(1)[usable]
    tolerance = noise(cloud[:, 2])
    pairs = zip(normals, heights, strict=True)
    best = int(np.argmax([(np.abs(cloud @ n + h) < tolerance).sum() for n, h in pairs]))
    return _plane_through(-normals[best] * heights[best], normals[best])


def _neighbours(
    pixels: Int[np.ndarray, "n 2"], first: np.ndarray, reach: float, rng: np.random.Generator
) -> np.ndarray:
    """Return, for each first point, a random valid point within about ``reach`` pixels."""
    wanted = np.round(pixels[first] + rng.uniform(-reach, reach, (len(first), 2)))
    column, row = np.clip(wanted, 0, pixels.max(0)).T
    width = pixels[:, 0].max() + 1
    keys = pixels[:, 1] * width + pixels[:, 0]  # sorted by row, then column
    return np.minimum(np.searchsorted(keys, row * width + column), len(pixels) - 1)


def _faces_up(normals: Float[np.ndarray, "n 3"]) -> Bool[np.ndarray, "n"]:
    """Return which planes face upwards, assuming a roughly upright camera."""
    elevation = np.arcsin(np.clip(-normals[:, 2], -1, 1))
    roll = np.arctan2(np.abs(normals[:, 0]), -normals[:, 1])
    steep = elevation > np.deg2rad(75)  # seen from above, roll is not meaningful
    return (elevation > _LOWEST) & ((roll < _TILT) | steep) & (normals[:, 1] < 0.1)


def _one_piece(
    inliers: Bool[np.ndarray, "n"], pixels: Int[np.ndarray, "n 2"]
) -> Bool[np.ndarray, "n"]:
    """Return the largest group of inliers that is connected in the picture, ignoring small gaps."""
    columns, rows = pixels.T
    image = np.zeros((rows.max() + 1, columns.max() + 1), np.uint8)
    image[rows[inliers], columns[inliers]] = 1
    closed = cv2.morphologyEx(image, cv2.MORPH_CLOSE, np.ones((5, 5), np.uint8))
    numbers = cv2.connectedComponents(closed, connectivity=4)[1][rows, columns]
    sizes = np.bincount(numbers[inliers])
    sizes[0] = 0
    return inliers & (numbers == sizes.argmax())


def _judge(
    level: Level,
    inliers: Bool[np.ndarray, "n"],
    cloud: Float[np.ndarray, "n 3"],
    pixels: Int[np.ndarray, "n 2"],
    side: int,
) -> _Candidate:
    """Score a plane as a tabletop.

    The best ones are large and low in the picture, and have objects on them, but nothing tall.
    """
    normal = np.array(level.normal)
    flat = cloud - level.above(cloud)[:, None] * normal  # projected onto the plane
    east = np.cross(normal, [0.0, 0.0, 1.0]) if abs(normal[2]) < 0.9 else np.array([1.0, 0, 0])
    east /= np.linalg.norm(east)
    place = flat @ np.column_stack([east, np.cross(normal, east)])
    inner = place[inliers]
    above = level.above(cloud)
    over = (inside_margin(place, convex_outline(inner)) > 0) & (above > 2 * noise(cloud[:, 2]))
    carried = float((over & (above < TALLEST)).sum() / inliers.sum())
    towering = float((over & (above >= TALLEST)).sum() / inliers.sum())
    cell = np.round(inner / 0.02).astype(int)
    area = len(np.unique(cell, axis=0)) * 0.02**2
    low = float(pixels[inliers, 1].mean() / side)
    score = float(inliers.mean()) * (0.4 + low) * (0.5 + min(carried, 0.5)) / (1 + 4 * towering)
    return _Candidate(level, inliers, area, score)
