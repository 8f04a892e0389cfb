"""Racks, boxes and vessels: models that stand or lean in slots, and flat objects filed on edge."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from tabletop_objects.values import Extent, Holder, parts_to_unit_box, to_unit_box

from ..physics.parts import body_parts
from ..scene import ConvexPart, Mesh, Model, Slot
from ..scene.quarter_turns import Steps, turn
from .bunches import Stance, Stem, arrange_bunch, measure_stem
from .cavities import SECTORS, Cavity, find_cavity

_LEAN = np.deg2rad(9.0)  # tilt of filed objects towards the end of the row
_SQUARE = 1.2  # minimum ratio of a box's corner distance to its side distance
_FLAT = 0.22  # maximum ratio of thickness to width of filed objects
_MIN_WIDTH = 0.1  # minimum width of filed objects, metres
_GAP = 8e-4  # gap between objects, metres


@dataclass(frozen=True)
class _Box:
    """Half extents of a box along and across a row of objects; ``axis`` 0 is x, and 1 is y."""

    length: float
    width: float
    axis: int


def _boxes(cavity: Cavity) -> list[_Box]:
    """Return the two possible rows in a rectangular vessel, or none if it is round."""
    radii = cavity.radii[0]
    across, corner = radii[:: SECTORS // 4], radii[SECTORS // 8 :: SECTORS // 4]
    if corner.min() < _SQUARE * across.min():
        return []
    x, y = float(min(across[0], across[2])), float(min(across[1], across[3]))
    return sorted([_Box(x, y, 0), _Box(y, x, 1)], key=lambda box: -box.length)


def is_flat(model: Model) -> bool:
    """Return whether a lying object is flat and wide, like a book or a record."""
    x, y, z = (float(v) for v in model.size)
    return z < _FLAT * min(x, y) and min(x, y) > _MIN_WIDTH


def file_away(
    things: Mapping[str, Model], cavity: Cavity
) -> dict[str, tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]]] | None:
    """Return the rotation and centre of each flat object when filed in a box.

    Returns None if the box is round or has no room for the row.
    """
    sizes = [np.sort(np.asarray(m.size, float)) for m in things.values()]
    thick = sum(float(size[0]) for size in sizes) / np.cos(_LEAN) + _GAP * len(sizes)
    for box in _boxes(cavity):
        for side in (1, 2):  # height when standing on the longer edge, or on the shorter one
            tall = max(min(float(size[side]), cavity.depth) for size in sizes)
            wide = max(float(size[3 - side]) for size in sizes)
            start = _start(box, wide, cavity)
            room = 1.9 * box.length - tall * np.sin(_LEAN) - start
            if wide <= 2 * box.width - 2 * _GAP and thick <= room:
                return _row(things, side, replace(box, length=box.length - start), cavity, tall)
    return None


def _start(box: _Box, wide: float, cavity: Cavity) -> float:
    """Return how far from the box's end a row must start, since posts may stand in the corners."""
    for start in np.linspace(0.0, 0.2 * box.length, 12):
        ends = np.array([[start - box.length, s * wide / 2, z] for s in (-1, 1)
                         for z in (cavity.floor, cavity.rim)])  # fmt: skip
        if box.axis:
            ends[:, :2] = ends[:, 1::-1] * [-1, 1]
        ends[:, :2] += cavity.middle
        away = np.hypot(*(ends[:, :2] - cavity.middle).T)
        if (away <= cavity.wall(ends) + _GAP).all():
            return float(start)
    return 0.2 * box.length


def _row(
    things: Mapping[str, Model],
    side: int,
    box: _Box,
    cavity: Cavity,
    tall: float,
) -> dict[str, tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]]]:
    c, s = np.cos(_LEAN), np.sin(_LEAN)
    tip = np.array([[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]])  # +z leans towards -x
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    into = quarter if box.axis else np.eye(3)
    at = -box.length + tall * s + _GAP
    found = {}
    for name, model in things.items():
        size = np.sort(np.asarray(model.size, float))
        upright = _on_edge(model, side)
        foot = np.array([at + size[0] / 2 / c, 0.0, cavity.floor + size[0] / 2 * s + _GAP])
        middle = foot + tip @ [0.0, 0.0, size[side] / 2]
        found[name] = (into @ tip @ upright, into @ middle + [*cavity.middle, 0.0])
        at += size[0] / c + _GAP
    return found


def _on_edge(model: Model, side: int) -> Float[np.ndarray, "3 3"]:
    """Return the rotation that stands a lying object on edge, with ``side`` up and facing +x."""
    face = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])  # z to x, x to -z
    if (model.size[0] <= model.size[1]) == (side == 1):
        return face
    return face @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


LIES = 0.95
"""Maximum length of an object that lies in a vessel, as a fraction of the mouth's width."""

_SLENDER = 1.9  # minimum ratio of height to width of objects that lean in a vessel
_WIDER = 1.1  # minimum ratio between the widths of an object's head and its other end
_BLOSSOM = 4.0  # minimum ratio of head width to stem width for objects whose head must be visible
_SHOWN = 0.56  # maximum fraction of such an object's length that is inside a vessel
_FEW = 4  # maximum number of objects of equal length in a vessel
_LENGTHS = (1.0, 0.92, 1.06, 0.96, 1.1)  # relative lengths of flowers that stand together
_LARGER = (1.0, 1.12, 1.25, 1.4, 1.55)  # growth factors of a vessel, tried until all objects fit

_WAYS: Mapping[str, tuple[Steps, ...]] = {
    "edge": ((("y", -90),), (("z", 90), ("y", -90)), (), (("z", 90),), (("x", 90), ("z", 90)),
             (("y", -90), ("x", 90))),
    "end": ((("y", -90), ("z", 90)), (("y", -90),), (), (("z", 90),), (("x", 90),),
            (("x", 90), ("z", 90))),
    "side": ((("x", 90),), (), (("z", 90),), (("y", 90), ("z", 90))),
}  # fmt: skip
"""Rotations to try for each stance in a holder."""


def stand_in_holder(model: Model, holder: Holder) -> Model:
    """Return a model rotated as it stands in its slot of a holder."""
    wanted = np.array(holder.stand((float(model.size[0]), float(model.size[1]),
                                    float(model.size[2]))))  # fmt: skip
    turned = [turn(model, steps) for steps in _WAYS[holder.stance]]
    return min(turned, key=lambda m: round(float(np.abs(m.size - wanted).max()), 6))


def room_of(models: Sequence[Model]) -> Extent:
    """Return the extent of the largest standing object, in metres."""
    across, along, up = np.max([model.size for model in models], axis=0)
    return float(across), float(along), float(up)


def name_slots(holder: Model, names: Sequence[str]) -> Model:
    """Return a holder's model with its slots assigned to the objects in order."""
    pairs = zip(holder.slots, names, strict=False)
    return replace(holder, slots=tuple(replace(slot, name=name) for slot, name in pairs))


def head_up(model: Model) -> Model:
    """Return a standing model with its wide end up, such as bristles, blossoms or whisk wires."""
    spheres = measure_stem(model).spheres
    wide = np.hypot(spheres[:, 0], spheres[:, 1]) + spheres[:, 3]
    share = spheres[:, 2] / float(model.size[2])
    foot, head = float(wide[share < 0.45].max()), float(wide[share > 0.55].max())
    return turn(model, (("x", 180),)) if foot > _WIDER * head else model


def fill_vessel(
    vessel: Model, things: Mapping[str, Model], upright: Mapping[str, bool], *, may_grow: bool
) -> tuple[Model, dict[str, Model]]:
    """Return a vessel with slots for long objects, and the models that lean in it.

    ``things`` are the models, standing straight. If the vessel is too small, it is enlarged
    slightly, provided that this is allowed. Objects without room are not returned.
    """
    if len(things) > _FEW:
        things = {
            name: replace(model, size=model.size * [1, 1, _LENGTHS[k % len(_LENGTHS)]])
            for k, (name, model) in enumerate(things.items())
        }
    stems = {name: measure_stem(model) for name, model in things.items()}
    if may_grow:
        vessel = _make_shallow(vessel, [s for n, s in stems.items() if not upright[n]])
    best: tuple[Model, Cavity, list[Stance | None]] | None = None
    factors = _LARGER if may_grow else (1.0,)
    for factor in factors:
        larger = replace(vessel, size=vessel.size * [factor, factor, 1 + 0.25 * (factor - 1)])
        cavity = find_cavity(larger)
        if cavity is None:
            return vessel, {}
        stances = arrange_bunch(list(stems.values()), cavity, [upright[n] for n in stems],
                                strict=factor < factors[-1])  # fmt: skip
        missing = stances.count(None)
        if best is None or missing < best[2].count(None):
            best = larger, cavity, stances
        if not missing:
            break
    assert best is not None
    slots, made = [], {}
    for name, stance in zip(stems, best[2], strict=True):
        if stance is not None:
            made[name], at = _lean(things[name], stems[name], stance)
            slots.append(Slot(at / best[0].size, name=name))
    return replace(best[0], slots=tuple(slots)), made


def _make_shallow(vessel: Model, stems: Sequence[Stem]) -> Model:
    """Return a vessel made so shallow that the flowers in it remain visible."""
    cavity = find_cavity(vessel)
    heads = [s.length for s in stems if s.spheres[:, 3].max() > _BLOSSOM * s.core]
    if cavity is None or not heads:
        return vessel
    share = float(np.clip(_SHOWN * min(heads) / cavity.depth, 0.55, 1.0))
    return replace(vessel, size=vessel.size * [1.0, 1.0, share])


def leans(model: Model, cavity: Cavity) -> bool:
    """Return whether a standing object is long enough to lean in or protrude from a vessel."""
    slender = float(model.size[2]) > _SLENDER * float(model.size[:2].min())
    return slender and float(model.size[2]) > 0.6 * cavity.depth


def file_in_box(
    vessel: Model, flat: Mapping[str, Model], cavity: Cavity
) -> tuple[Model, dict[str, Model]] | None:
    """Put flat objects on edge in a box; return all the models, or None if they do not fit."""
    turned = file_away(flat, cavity)
    if turned is None:
        return None
    slots, made = list(vessel.slots), {}
    for name, (rotation, middle) in turned.items():
        stem = Stem(np.zeros(3), 0.0, 0.0, np.zeros((0, 4)))
        made[name], at = _lean(flat[name], stem, Stance(rotation, middle))
        slots.append(Slot(at / vessel.size, name=name))
    return replace(vessel, slots=tuple(slots)), made


def _lean(model: Model, stem: Stem, stance: Stance) -> tuple[Model, Float[np.ndarray, "3"]]:
    """Return a leaning model and the centre, in metres, of its underside in the vessel's frame."""
    mesh = model.mesh
    turned = (mesh.vertices * model.size - stem.foot) @ stance.turn.T + stance.foot
    unit, center, extent = to_unit_box(
        Mesh(turned.astype(np.float32), mesh.faces, mesh.uv, mesh.texture, mesh.opacity)
    )
    parts = tuple(
        ConvexPart((part.vertices - stem.foot) @ stance.turn.T + stance.foot)
        for part in body_parts(model, model.size)
    )
    leaning = replace(
        model, mesh=unit, size=extent, parts=parts_to_unit_box(parts, center, extent), slots=()
    )
    return leaning, center - np.array([0.0, 0.0, float(extent[2]) / 2])
