"""Comparison of a top view with the picture, to find objects that an image model moved or omitted.

The picture determines each object's top-view box on the plane of the tabletop (``ground``). One
scale and one shift map all of these boxes into a correct top view. Both are estimated from the
majority of the drawn objects on the table. If too few of these agree, the ends of the tabletop are
used instead and, if these are cut off, usual sizes.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from jaxtyping import Float

from ...geometry import rotated_extent
from ...scene import TABLE, Instance, Model, Rotation, Stacking, TopView, View
from .ground import boxes_on_ground, table_on_ground

_ASTRAY = 0.05  # maximum deviation from geometry, as a fraction of the table's longer side
_OWN = 0.15  # additional deviation, as a fraction of the box's own length
_CLOSE = 0.5  # fraction of that limit within which boxes agree on a scale and a shift
_LOOSE = 1.5  # factor on the limit if only the tabletop's ends determine scale and shift
_VAGUE = 3.0  # factor on the limit if only usual sizes determine them
_GROWN = 1.6  # maximum factor by which a box may be drawn too large or too small
_TINY = 0.02  # negligible difference between lengths, as a fraction of the table's longer side
_ROOM = 0.15  # how far an object's centre may be outside its support's box, as a fraction of it
_FEWEST = 4  # minimum number of objects on the table for a reliable scale and shift
_AGREE = 0.6  # minimum fraction of these that must agree; at least three
_SCALED = 1.6  # maximum factor between that scale and the one from the tabletop's ends
_SHIFTED = 0.3  # maximum distance from the ends' shift, as a fraction of the table's longer side

_ELSEWHERE = "the top view shows it in a different position; corrected by geometry"
_MOST = (
    "The top view shows {} of {} objects on the table in different positions than the picture; "
    "geometry placed all of them."
)
_LACKS = "missing in the top view; added by geometry"

Box = Float[np.ndarray, "4"]


@dataclass(frozen=True, eq=False)
class _Carried:
    """A scale and a shift that map ground boxes to the top view; ``slack`` scales the limits."""

    scale: float
    shift: Float[np.ndarray, "2"]
    slack: float = 1.0

    def __call__(self, box: Box) -> Box:
        return self.scale * box + np.tile(self.shift, 2)


def check_top_view(
    top: TopView,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    stacking: Mapping[str, Stacking],
    view: View,
    image_size: tuple[int, int],
    only_missing: bool = False,
) -> tuple[TopView, tuple[str, ...]]:
    """Return the top view with a box for every instance and a warning for each correction.

    A box whose position or size differs too much from the geometric box is replaced by the latter.
    If most boxes differ, all are replaced. ``models`` and ``rotations`` determine the boxes'
    proportions. The scale and the shift are estimated only from objects that stand on the table.
    ``top`` may lack boxes; ``view`` and ``image_size`` (width, height) are those of the reference
    picture. With ``only_missing``, the boxes that the top view has are kept unchanged.
    """
    ground = boxes_on_ground(instances, models, rotations, stacking, view, image_size)
    boxes = {name: np.asarray(box, float) for name, box in top.boxes.items()}
    table, *things = sorted(instances, key=lambda i: i.name != TABLE)
    on = {i.name: stacking[i.name].on if i.name in stacking else TABLE for i in things}
    length = _length(top.table_box)
    ends = _by_ends(table_on_ground(table, view, image_size), top)
    drawn = {n: boxes[n] for n in ground if on[n] == TABLE and n in boxes}
    guesses = {i.name: _guess(i, table, top, boxes, models, rotations) for i in things}
    carried = _agreement(ground, drawn, ends, length) or ends or _by_sizes(ground, guesses)
    placed = {n: carried(box) for n, box in ground.items()} if carried else {}
    remarks: dict[str, str] = {}
    warnings: tuple[str, ...] = ()
    if carried and not only_missing:
        remarks = _false(boxes, placed, drawn, carried.slack * length)
        astray = sum(what == _ELSEWHERE for what in remarks.values())
        if 2 * astray > len(drawn):
            remarks = dict.fromkeys(placed, "")
            warnings = (_MOST.format(astray, len(drawn)),)
        boxes |= {name: placed[name] for name in remarks}
    for thing in sorted(things, key=lambda i: stacking[i.name].order if i.name in stacking else 2):
        name, below = thing.name, boxes.get(on[thing.name])
        lost = name not in boxes
        if lost or not (only_missing or below is None or _over(boxes[name], below)):
            boxes[name] = _put([placed.get(name), boxes.get(name), guesses[name]], below)
            shown = "does not show the object" if lost else "shows the object elsewhere"
            placed_on = f"the object is on {on[name]}, but the top view {shown}; it was moved there"
            remarks[name] = _LACKS if below is None else placed_on
    warnings += tuple(f"{name}: {what}." for name, what in remarks.items() if what)
    repaired = tuple(dict.fromkeys((*top.repaired, *remarks)))
    return replace(top, boxes=boxes, repaired=repaired), warnings


def _length(box: Box) -> float:
    """Return a box's longer side."""
    return float(np.max(box[2:] - box[:2]))


def _size(box: Box) -> float:
    """Return the square root of a box's area."""
    return float(np.sqrt(np.prod(np.maximum(box[2:] - box[:2], 1e-9))))


def _middle(box: Box) -> Float[np.ndarray, "2"]:
    return box.reshape(2, 2).mean(0)


def _center(box: Box, on: Box) -> Box:
    return box + np.tile(_middle(on) - _middle(box), 2)


def _put(tries: Sequence[Box | None], below: Box | None) -> Box:
    """Return the first box over its support, or else the first box, centred on that support."""
    known = [b for b in tries if b is not None]
    if below is None:
        return known[0]
    return next((b for b in known if _over(b, below)), _center(known[0], below))


def _over(box: Box, below: Box) -> bool:
    """Return whether the centre of a box lies over another box, with a tolerance."""
    middle, slack = _middle(box), _ROOM * (below[2:] - below[:2])
    return bool((middle >= below[:2] - slack).all() and (middle <= below[2:] + slack).all())


def _false(
    boxes: Mapping[str, Box], placed: Mapping[str, Box], standing: Collection[str], unit: float
) -> dict[str, str]:
    """Return a remark for each drawn box that contradicts the geometry; ``unit`` is in pixels."""
    remarks: dict[str, str] = {}
    for name in (n for n in placed if n in boxes):
        box, there = boxes[name], placed[name]
        grown = _size(box) / _size(there)
        if name in standing and _off(box, there) > _limit(there, unit):
            remarks[name] = _ELSEWHERE
        elif abs(np.log(grown)) > np.log(_GROWN) and abs(_size(box) - _size(there)) > _TINY * unit:
            remarks[name] = (
                f"drawn {grown:.2g} times too large in the top view; resized by geometry"
            )
    return remarks


def _off(box: Box, there: Box) -> float:
    return float(np.linalg.norm(_middle(box) - _middle(there)))


def _limit(box: Box, length: float) -> float:
    return _ASTRAY * length + _OWN * _size(box)


def _agreement(
    ground: Mapping[str, Box], drawn: Mapping[str, Box], ends: _Carried | None, length: float
) -> _Carried | None:
    """Return the scale and shift that fit most of the drawn boxes, or None if there are none."""
    names = list(drawn)
    if len(names) < _FEWEST:
        return None
    best: tuple[float, list[str]] = (0.0, [])
    for pair in combinations(names, 2):
        carried = _fit([ground[n] for n in pair], [drawn[n] for n in pair])
        if carried is None:
            continue
        there = {n: carried(ground[n]) for n in names}
        off = {n: _off(there[n], drawn[n]) / _limit(there[n], length) for n in names}
        agree = [n for n in names if off[n] < _CLOSE]
        worth = len(agree) - 0.5 * float(np.mean([off[n] for n in agree])) if agree else 0.0
        if worth > best[0]:
            best = worth, agree
    if len(best[1]) < max(_FEWEST - 1, _AGREE * len(names)):
        return None
    carried = _fit([ground[n] for n in best[1]], [drawn[n] for n in best[1]])
    return carried if carried and _likely(carried, ends, ground, drawn, length) else None


def _likely(
    carried: _Carried,
    ends: _Carried | None,
    ground: Mapping[str, Box],
    drawn: Mapping[str, Box],
    length: float,
) -> bool:
    """Return whether a scale and a shift are close to those derived from the tabletop's ends."""
    if ends is None:
        return True
    middle = np.mean([ground[n] for n in drawn], axis=0)
    scaled = abs(np.log(carried.scale / ends.scale)) < np.log(_SCALED)
    return bool(scaled and _off(carried(middle), ends(middle)) < _SHIFTED * length)


def _fit(here: Sequence[Box], there: Sequence[Box]) -> _Carried | None:
    """Return the scale and shift that best map the centres, or None for a nonpositive scale."""
    a, b = (np.array([_middle(box) for box in boxes]) for boxes in (here, there))
    x, y = a - a.mean(0), b - b.mean(0)
    spread = float((x * x).sum())
    scale = float((x * y).sum()) / spread if spread > 1e-12 else 0.0
    return _Carried(scale, b.mean(0) - scale * a.mean(0)) if scale > 0 else None


def _by_ends(ends: Float[np.ndarray, "3"] | None, top: TopView) -> _Carried | None:
    """Return the scale and shift that map the tabletop's left, right and far ends onto its box."""
    if ends is None or ends[1] - ends[0] < 1e-6:
        return None
    left, far, right, _ = top.table_box
    scale = float((right - left) / (ends[1] - ends[0]))
    return _Carried(scale, np.array([left, far]) - scale * ends[[0, 2]], _LOOSE)


def _by_sizes(ground: Mapping[str, Box], guesses: Mapping[str, Box]) -> _Carried | None:
    """Return the scale and shift that map the ground boxes to the guessed ones."""
    if not ground:
        return None
    scale = float(np.median([_size(guesses[n]) / _size(box) for n, box in ground.items()]))
    shift = np.mean([_middle(guesses[n]) - scale * _middle(box) for n, box in ground.items()], 0)
    return _Carried(scale, shift, _VAGUE)


def _guess(
    thing: Instance,
    table: Instance,
    top: TopView,
    boxes: Mapping[str, Box],
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
) -> Box:
    """Return a box of the model's size, positioned on the table as in the picture."""

    def extent(name: str) -> Float[np.ndarray, "2"]:
        yaw = rotations[name].yaw if name in rotations else 0.0
        return rotated_extent(np.asarray(models[name].size), yaw)

    known = {n: box for n, box in {**boxes, TABLE: top.table_box}.items() if n in models}
    pixels = [_size(np.asarray(box)) / np.sqrt(np.prod(extent(n))) for n, box in known.items()]
    half = extent(thing.name) * float(np.median(pixels or [1.0])) / 2
    frame = np.asarray(table.box)
    share = (_middle(np.asarray(thing.box)) - frame[:2]) / np.maximum(frame[2:] - frame[:2], 1)
    low, high = np.asarray(top.table_box).reshape(2, 2)
    middle = low + np.clip(share, 0, 1) * (high - low)
    return np.concatenate([middle - half, middle + half])
