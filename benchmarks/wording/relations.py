"""Relations between objects, from their boxes and their load-bearing contacts.

Metres. Sides and corners of the table are shares of its width and depth, from its centre.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from wording.seen import Seen, Thing

NEAR = 0.15
"""Maximum distance in metres of two adjacent objects."""
ROUND = 0.30
"""Maximum distance in metres between an object and those around it."""
SIDE = 0.08
"""Share of the table's width, or depth, beyond which an object is on that side."""
MIDDLE = (0.2, 0.25)
"""Shares of the table's width and depth within which an object is in its middle."""
CORNER = (0.18, 0.14)
"""Shares of the table's width and depth beyond which an object is in a corner."""
STEP = 0.01
"""Minimum distance in metres of one object's centre beyond another's."""
SKEW = 0.7
"""Maximum sideways offset per metre in the requested direction."""
SHALLOW = 0.05
"""Height in metres up to which objects on a tray, a dish or a rack count as in it."""
GROWTH = 0.02
"""Minimum share by which each of several ordered objects is larger or smaller than the one
before."""

Things = Sequence[Thing]
Signs = tuple[float, float]
TOWARDS: Mapping[str, Signs] = {
    "left": (-1, 0), "right": (1, 0), "behind": (0, 1), "front": (0, -1),
}  # fmt: skip
ZONES: Mapping[str, Signs] = {
    "leftside": (-1, 0), "rightside": (1, 0), "backside": (0, 1), "frontside": (0, -1),
    "backleftcorner": (-1, 1), "backrightcorner": (1, 1),
    "frontleftcorner": (-1, -1), "frontrightcorner": (1, -1),
}  # fmt: skip


def pair(kind: str, a: Thing, b: Thing, seen: Seen) -> bool:
    """Return whether one object stands in a relation to another."""
    if kind in TOWARDS:
        return towards(TOWARDS[kind], a, b)
    if kind == "on":
        return seen.on(a, b)
    if kind == "in":
        return seen.inside(a, b) or (b.size[2] <= SHALLOW and seen.on(a, b))
    if kind == "near":
        return gap(a, b) <= NEAR and not seen.on(a, b) and not seen.on(b, a)
    raise KeyError(kind)


def gaps(a: Thing, b: Thing) -> np.ndarray:
    """Return the gaps between two boxes along x and y, 0 where they overlap."""
    return np.maximum(0.0, np.maximum(a.low - b.high, b.low - a.high))[:2]


def gap(a: Thing, b: Thing) -> float:
    return float(np.linalg.norm(gaps(a, b)))


def towards(way: Signs, a: Thing, b: Thing) -> bool:
    """Return whether ``a`` is on the side of ``b`` that ``way`` (x, y) points to."""
    axis = 0 if way[0] else 1
    ahead = float((a.centre - b.centre)[axis] * way[axis])
    along, aside = gaps(a, b)[axis], gaps(a, b)[1 - axis]
    return ahead > STEP and (along >= SKEW * aside or ahead >= abs((a.centre - b.centre)[1 - axis]))


def between(a: Thing, p: Thing, q: Thing) -> bool:
    """Return whether an object is between two others, seen from above."""
    line = (q.centre - p.centre)[:2]
    length = float(np.linalg.norm(line))
    if length < STEP:
        return False
    offset = (a.centre - p.centre)[:2]
    along = float(offset @ line) / length**2
    aside = abs(float(offset[0] * line[1] - offset[1] * line[0])) / length
    wide = max(0.35 * length, float(max(a.size[:2])) / 2)
    return 0.1 <= along <= 0.9 and aside <= wide


def zone(kind: str, a: Thing, seen: Seen) -> bool:
    """Return whether an object is in the middle, on a side or in a corner of the table."""
    place = a.centre[:2] / np.array(seen.top)
    if kind == "centre":
        return bool((np.abs(place) <= MIDDLE).all())
    signs = ZONES[kind]
    least = np.array(CORNER if all(signs) else (SIDE, SIDE))
    asked = np.array(signs) != 0
    return bool((place * signs > least)[asked].all())


def row(things: Things, direction: int | None = None) -> bool:
    """Return whether objects form a line, in a given direction (0 along x, 1 along y) or any."""
    if len(things) < 2:
        return False
    places = np.array([t.centre[:2] for t in things])
    offsets = places - places.mean(0)
    _, _, axes = np.linalg.svd(offsets)
    along, aside = offsets @ axes[0], offsets @ axes[1]
    steps = np.diff(np.sort(along))
    length = float(np.ptp(along))
    if len(things) == 2 and gap(*things) > NEAR:
        return False
    if direction is not None and abs(axes[0][direction]) < 0.8:
        return False
    apart = steps.min() > min(STEP, 0.2 * length / len(things))
    return bool(apart and np.abs(aside).max() <= max(0.02, 0.12 * length))


def ordered(things: Things, sign: int) -> bool:
    """Return whether objects from left to right grow (1) or shrink (-1), in height or in volume."""
    line = sorted(things, key=lambda t: float(t.centre[0]))
    measures = [[float(np.prod(t.extents)) for t in line], [float(t.extents[2]) for t in line]]
    rises = [all(sign * (b - a) > GROWTH * a for a, b in itertools.pairwise(m)) for m in measures]
    return len(line) > 1 and any(rises)


def stack(things: Things, seen: Seen, piles: int = 1) -> bool:
    """Return whether objects lie on each other, in at most a given number of piles."""
    names = {t.name for t in things}
    bottoms = [t for t in things if not seen.below(t.name) & names]
    return len(things) > 1 and 0 < len(bottoms) <= piles and len(bottoms) < len(things)


def widest(things: Things, middle: np.ndarray) -> float:
    """Return the largest angle between neighbours around a position (2,), degrees."""
    offsets = np.array([t.centre[:2] - middle for t in things])
    angles = np.sort(np.degrees(np.arctan2(offsets[:, 1], offsets[:, 0])))
    return float(np.diff(np.append(angles, angles[0] + 360.0)).max())


def circle(things: Things) -> bool:
    """Return whether objects form a circle or a square."""
    if len(things) < 3:
        return False
    places = np.array([t.centre[:2] for t in things])
    middle = places.mean(0)
    radii = np.linalg.norm(places - middle, axis=1)
    even = float(radii.std() / max(radii.mean(), 1e-9)) <= 0.25
    return even and widest(things, middle) <= min(2.2 * 360 / len(things), 190)


def around(things: Things, b: Thing) -> bool:
    """Return whether objects surround another: two on either side, more on all sides."""
    close = all(gap(a, b) <= ROUND for a in things)
    most = {1: 360.0, 2: 250.0}.get(len(things), 200.0)
    return bool(things) and close and widest(things, b.centre[:2]) <= most


def eachside(things: Things, b: Thing) -> bool:
    """Return whether there is an object on either side of another."""
    pairs = (("left", "right"), ("front", "behind"))
    sides = [[any(towards(TOWARDS[w], a, b) for a in things) for w in ways] for ways in pairs]
    return any(all(both) for both in sides)


def upright(a: Thing) -> bool:
    """Return whether an object stands: it is higher than wide, seen from its narrow side."""
    reach = a.points[:, :2] @ a.edges[:, :2].T
    return bool(a.size[2] >= 1.3 * np.ptp(reach, axis=0).min())


def corners(things: Things, seen: Seen) -> bool:
    """Return whether each of four corners has an object, and no object is elsewhere."""
    found = {k for k in ZONES if "corner" in k for a in things if zone(k, a, seen)}
    inside = all(any(zone(k, a, seen) for k in found) for a in things)
    return inside and len(found) == min(4, len(things))


ALONE: Mapping[str, Callable[[Thing, Seen], bool]] = {
    "upright": lambda a, seen: upright(a),
    "lying": lambda a, seen: bool(a.size[2] <= 0.7 * max(a.size[:2])),
    "empty": lambda a, seen: not any(seen.on(t, a) for t in seen.things),
}
"""Relations of a single object."""
TOGETHER: Mapping[str, Callable[[Things, Seen], bool]] = {
    "row": lambda things, seen: row(things),
    "column": lambda things, seen: row(things, 1),
    "order": lambda things, seen: ordered(things, 1),
    "descending": lambda things, seen: ordered(things, -1),
    "circle": lambda things, seen: circle(things),
    "corners": corners,
}
"""Relations within a group of objects."""


def holds(
    kind: str, a: Sequence[Things], b: Sequence[Things], how: int | str | None, seen: Seen
) -> bool:
    """Return whether a relation holds, for objects of each pattern on its two sides."""
    things = [t for group in a for t in group]
    others = [t for group in b for t in group]
    if not things or (b and not others):
        return False
    if kind in TOGETHER:
        return TOGETHER[kind](things, seen)
    if kind == "stack":
        return stack(things, seen, len(things) - 1 if how == "some" else 1)
    if kind == "oneach":
        return all(any(seen.on(x, y) for x in things if x is not y) for y in others)
    if kind == "noton":
        return not any(seen.on(x, y) for x in things for y in others)
    if kind in ("around", "eachside"):
        judge = around if kind == "around" else eachside
        return any(judge([x for x in things if x is not y], y) for y in others)
    right = [t for t in things if _one(kind, t, b, others, seen)]
    least = len(things) if how is None else 1 if how == "some" else int(how)
    return len(right) >= least


def _one(kind: str, a: Thing, b: Sequence[Things], others: Things, seen: Seen) -> bool:
    if kind in ALONE:
        return ALONE[kind](a, seen)
    if kind == "between":
        ends = itertools.product(*b) if len(b) > 1 else itertools.combinations(others, 2)
        return any(between(a, p, q) for p, q in ends if p is not q and a is not p and a is not q)
    if kind in ZONES or kind == "centre":
        return zone(kind, a, seen)
    return any(pair(kind, a, other, seen) for other in others if other is not a)
