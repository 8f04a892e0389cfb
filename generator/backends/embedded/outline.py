"""Finding the tabletop in a picture: which pixels are its top surface, and their outline.

No learned weights. The top is a large flat patch: fill the picture with balls that cannot pass
an edge, at several edge strengths and ball sizes; patches that do not reach the border are
candidates; the convex hull of the right one is the outline of the top (objects standing on it
make holes and bays, never bulges, in the patch).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

WORKING_SIZE = 640
"""Longest side, in pixels, of the copy of the picture that is analysed."""

_FLATNESS = (0.35, 0.6, 1.0, 1.8, 3.2, 6.0)  # CIELAB units per pixel
_BALLS = (2, 4, 7)  # pixels
_ALIKE = 9.0  # CIELAB distance under which two patches can be one surface
_GROUND_SHARE = 0.02  # of an outline's inside: no more of it may be background
_STICKING = 1.3  # times its own area: a patch that widens the outline by more sticks out
_WHITE = 2.5  # CIELAB distance from the background under which a patch is background
_FLOOR_RIM = 0.4  # of a patch's rim: with more of it at the background, it lies on the floor
_SMALLEST = 0.03  # of the picture, a table's top


@dataclass(frozen=True, eq=False)
class Candidate:
    """A patch that may be the tabletop.

    ``points`` are edge points on its outline in working pixels, counter-clockwise on screen, with
    outward unit ``normals``; where something hides the outline there are no points. ``hull`` is
    the outline closed over the hidden stretches. ``score`` grows with the share of the outline
    where the patch visibly ends, with how much of the outline it fills, with its size and width
    against everything that is not background, and falls with what lies above it.
    """

    patch: Bool[np.ndarray, "h w"]
    hull: Float[np.ndarray, "k 2"]
    points: Float[np.ndarray, "n 2"]
    normals: Float[np.ndarray, "n 2"]
    score: float


def working_copy(image: UInt8[np.ndarray, "h w 3"]) -> tuple[Float[np.ndarray, "a b 3"], float]:
    """Return the picture as CIELAB at working size, and working pixels per picture pixel."""
    factor = min(1.0, WORKING_SIZE / max(image.shape[:2]))
    size = (max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor)))
    small = cv2.resize(image, size, interpolation=cv2.INTER_AREA) if factor < 1 else image
    lab = cv2.cvtColor(np.ascontiguousarray(small, np.float32) / 255.0, cv2.COLOR_RGB2LAB)
    return np.asarray(lab), factor


def gradient(lab: Float[np.ndarray, "h w 3"]) -> Float[np.ndarray, "h w"]:
    """Return the edge strength, CIELAB units per pixel, of the edge-preserving smoothed picture."""
    smooth = cv2.bilateralFilter(lab.astype(np.float32), 7, 6, 4)
    strength = np.zeros(lab.shape[:2], np.float32)
    for c in range(3):
        gx = cv2.Scharr(smooth[..., c], cv2.CV_32F, 1, 0) / 32
        gy = cv2.Scharr(smooth[..., c], cv2.CV_32F, 0, 1) / 32
        strength = np.maximum(strength, np.hypot(gx, gy))
    return strength


def _disc(radius: int) -> np.ndarray:
    return cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))


def flat_patches(
    strength: Float[np.ndarray, "h w"], threshold: float, radius: int
) -> Int[np.ndarray, "h w"]:
    """Number the patches that a ball of ``radius`` can fill without touching an edge (0: none)."""
    free = cv2.erode((strength < threshold).astype(np.uint8), _disc(radius))
    count, numbers = cv2.connectedComponents(free, connectivity=4)
    grown = np.zeros_like(numbers)
    areas = np.bincount(numbers.ravel(), minlength=count)
    for k in np.argsort(-areas[1:])[:40] + 1:
        if areas[k] < 12:
            break
        ball = cv2.dilate((numbers == k).astype(np.uint8), _disc(radius)) > 0
        grown[ball & (grown == 0)] = k
    return grown


def background_patch(patches: Int[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    """Return the patches that own the picture's border: what lies around the table."""
    border = np.concatenate([patches[0], patches[:, 0], patches[:, -1]])
    owners, counts = np.unique(border[border > 0], return_counts=True)
    return np.isin(patches, owners[counts > 0.02 * len(border)])


def _ground(
    patches: Int[np.ndarray, "h w"], lab: Float[np.ndarray, "h w 3"]
) -> Bool[np.ndarray, "h w"]:
    """Return the background with the patches of its very colour, such as between the legs."""
    ground = background_patch(patches)
    if not ground.any():
        return ground
    usual = np.median(lab[ground], axis=0)
    for k in np.unique(patches[~ground & (patches > 0)]):
        own = patches == k
        if np.abs(np.median(lab[own], axis=0) - usual).max() < _WHITE:
            ground |= own
    return ground


def _beside(patch: Bool[np.ndarray, "h w"], near_ground: Bool[np.ndarray, "h w"]) -> bool:
    """Return whether most of what a patch borders on is ground: a shadow on the floor."""
    rim = patch & (cv2.erode(patch.astype(np.uint8), _disc(1)) == 0)
    return bool((rim & near_ground).sum() > _FLOOR_RIM * rim.sum())


def _joined(
    patches: Int[np.ndarray, "h w"], lab: Float[np.ndarray, "h w 3"], background: np.ndarray
) -> Iterator[Bool[np.ndarray, "h w"]]:
    """Yield the largest inner patches, alone and with their neighbours of like colour."""
    numbers = np.unique(patches[~background & (patches > 0)])
    areas = {k: int((patches == k).sum()) for k in numbers}
    color = {k: np.median(lab[patches == k], axis=0) for k in numbers}
    largest = sorted(numbers, key=lambda k: -areas[k])[:3]
    for seed in largest:
        yield patches == seed
    if not largest:
        return
    seed = largest[0]
    near_ground = cv2.dilate(background.astype(np.uint8), _disc(9)) > 0
    inner = [k for k in numbers if k == seed or not _beside(patches == k, near_ground)]
    for alike in (_ALIKE, 2 * _ALIKE):
        kin = [k for k in inner if np.abs(color[k] - color[seed]).max() < alike]
        chosen = _connected(patches, seed, kin)
        if len(chosen) > 1:
            yield np.isin(patches, chosen)
        if len(kin) > len(chosen):  # pieces of the top that a thing separates
            yield np.isin(patches, kin)
        compact = _compact(patches, seed, kin, areas)
        if len(compact) < len(kin):
            yield np.isin(patches, compact)


def _connected(patches: Int[np.ndarray, "h w"], seed: int, kin: list[int]) -> list[int]:
    """Return those of ``kin`` that a chain of near neighbours joins to ``seed``."""
    chosen, grew = {seed}, True
    while grew:
        near = cv2.dilate(np.isin(patches, list(chosen)).astype(np.uint8), _disc(9)) > 0
        new = {k for k in kin if k not in chosen and (near & (patches == k)).any()}
        grew = bool(new)
        chosen |= new
    return sorted(chosen)


def _compact(
    patches: Int[np.ndarray, "h w"], seed: int, kin: list[int], areas: dict[int, int]
) -> list[int]:
    """Return ``kin`` without patches that widen their common outline by more than they fill of it.

    Such a patch sticks out: a shadow on the floor, a front face.
    """
    hulls = {k: _hull(patches == k) for k in kin}

    def area(members: list[int]) -> float:
        points = np.concatenate([hulls[k] for k in members]).astype(np.float32)
        return cv2.contourArea(cv2.convexHull(points))

    whole = area(kin) if kin else 0.0
    return [
        k
        for k in kin
        if k == seed or whole - area([j for j in kin if j != k]) < _STICKING * areas[k]
    ]


def _hull(patch: Bool[np.ndarray, "h w"]) -> Float[np.ndarray, "k 2"]:
    ys, xs = np.nonzero(patch)
    return cv2.convexHull(np.stack([xs, ys], 1).astype(np.float32))[:, 0].astype(float) + 0.5


def walk(outline: Float[np.ndarray, "k 2"], count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return ``count`` evenly spaced points on a closed outline and their outward normals."""
    ends = np.roll(outline, -1, axis=0)
    lengths = np.linalg.norm(ends - outline, axis=1)
    stations = np.linspace(0, lengths.sum(), count, endpoint=False)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    edge = np.clip(np.searchsorted(starts, stations, side="right") - 1, 0, len(outline) - 1)
    share = (stations - starts[edge]) / np.maximum(lengths[edge], 1e-9)
    points = outline[edge] + share[:, None] * (ends - outline)[edge]
    along = (ends - outline)[edge] / np.maximum(lengths[edge], 1e-9)[:, None]
    normals = np.column_stack([along[:, 1], -along[:, 0]])
    outward = np.sign(((points - outline.mean(0)) * normals).sum(1).sum()) or 1.0
    return points, normals * outward


def sample(field: Float[np.ndarray, "h w"], points: Float[np.ndarray, "n 2"]) -> np.ndarray:
    """Return a picture's values at pixel positions (centres at halves), bilinear, edges repeat."""
    map_x = (points[..., 0] - 0.5).astype(np.float32)
    map_y = (points[..., 1] - 0.5).astype(np.float32)
    flat = cv2.remap(
        np.ascontiguousarray(field, np.float32),
        map_x.reshape(1, -1) if map_x.ndim == 1 else map_x,
        map_y.reshape(1, -1) if map_y.ndim == 1 else map_y,
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return np.asarray(flat).reshape(points.shape[:-1] + np.asarray(field).shape[2:])


def snap(
    points: Float[np.ndarray, "n 2"],
    normals: Float[np.ndarray, "n 2"],
    strength: Float[np.ndarray, "h w"],
    inward: float,
    outward: float,
) -> tuple[np.ndarray, np.ndarray]:
    """Move points outward along their normals onto the first clear edge; return also its strength.

    An edge is clear if it is a peak of at least half the strongest one in reach.
    """
    offsets = np.arange(-inward, outward + 0.25, 0.5)
    along = points[:, None] + offsets[None, :, None] * normals[:, None]
    values = sample(strength, along)
    padded = np.pad(values, ((0, 0), (1, 1)), mode="edge")
    peak = (values >= padded[:, :-2]) & (values >= padded[:, 2:])
    best = (peak & (values >= 0.5 * values.max(1, keepdims=True))).argmax(1)
    return along[np.arange(len(points)), best], values[np.arange(len(points)), best]


def _candidate(
    patch: Bool[np.ndarray, "h w"],
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    foreground: Bool[np.ndarray, "h w"],
    background: Bool[np.ndarray, "h w"],
) -> Candidate | None:
    hull = _hull(patch)
    if len(hull) < 3 or cv2.contourArea(hull.astype(np.float32)) < _SMALLEST * patch.size:
        return None
    inside = np.zeros(patch.shape, np.uint8)
    cv2.fillConvexPoly(inside, np.round(hull - 0.5).astype(np.int32), 1)
    if (background & (inside > 0)).sum() > _GROUND_SHARE * inside.sum():
        return None
    points, normals = walk(hull, 240)
    distance = cv2.distanceTransform((~patch).astype(np.uint8), cv2.DIST_L2, 3)
    shown = sample(distance, points) < 3.0
    if shown.sum() < 40:
        return None
    normals = normals[shown]
    snapped, _ = snap(points[shown], normals, strength, 1.0, 7.0)
    ends = _ends(lab, snapped, normals)
    if ends.sum() < 30:
        return None
    filled = patch.sum() / max(cv2.contourArea(hull.astype(np.float32)), 1.0)
    width = np.ptp(hull[:, 0]) / max(np.ptp(np.flatnonzero(foreground.any(0))), 1)
    above = foreground[: int(hull[:, 1].min())].sum() / max(foreground.sum(), 1)
    score = float(ends.mean() * np.sqrt(filled) * min(width, 1.0) ** 2 * (1 - above) ** 2)
    score *= min(1.0, inside.sum() / max(foreground.sum(), 1))
    score /= 1 + _front_step(lab, snapped, normals) / 10
    return Candidate(patch, hull, snapped[ends], normals[ends], score)


def _ends(
    lab: Float[np.ndarray, "h w 3"], points: Float[np.ndarray, "n 2"], normals: np.ndarray
) -> Bool[np.ndarray, "n"]:
    """Return where the surface really ends: its colour does not come back beyond a vein."""
    step = sample(lab, points + 12 * normals) - sample(lab, points - 4 * normals)
    return np.linalg.norm(step, axis=1) > 2.5


def _front_step(
    lab: Float[np.ndarray, "h w 3"], points: Float[np.ndarray, "n 2"], normals: np.ndarray
) -> float:
    """Return the change of colour just inside the front, CIELAB; large if a front face is in."""
    front = normals[:, 1] > 0.7
    if not front.any():
        return 0.0
    points, normals = points[front], normals[front]
    step = sample(lab, points - 3 * normals) - sample(lab, points - 16 * normals)
    return float(np.median(np.linalg.norm(step, axis=1)))


def candidates(lab: Float[np.ndarray, "h w 3"]) -> tuple[Candidate, ...]:
    """Return patches that may be the tabletop, best score first, near doubles dropped."""
    strength = gradient(lab)
    foreground = ~background_patch(flat_patches(strength, 1.0, 4))
    if not foreground.any():
        return ()
    found: list[Candidate] = []
    for threshold in _FLATNESS:
        for radius in _BALLS:
            patches = flat_patches(strength, threshold, radius)
            background = _ground(patches, lab)
            for patch in _joined(patches, lab, background):
                candidate = _candidate(patch, lab, strength, foreground, background)
                if candidate is not None and not any(_same(candidate, f) for f in found):
                    found.append(candidate)
    return tuple(sorted(found, key=lambda f: -f.score))


def _same(a: Candidate, b: Candidate) -> bool:
    low_a, high_a, low_b, high_b = a.hull.min(0), a.hull.max(0), b.hull.min(0), b.hull.max(0)
    close = np.abs(np.concatenate([low_a - low_b, high_a - high_b])).max() < 3
    return bool(close and (a.patch & b.patch).sum() > 0.9 * (a.patch | b.patch).sum())
