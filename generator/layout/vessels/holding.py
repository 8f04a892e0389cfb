"""Models made to stand in what holds them, and the places that it has for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from tabletop_objects.values import Extent, Holder, parts_to_unit_box, to_unit_box

from ...physics.parts import body_parts
from ...scene import ConvexPart, Mesh, Model, Slot
from ...scene.turning import Steps, turn
from .bunches import Stance, Stem, arrange_bunch, measure_stem
from .cavities import Cavity, find_cavity
from .filing import file_away

LIES = 0.95
"""Share of a vessel's mouth up to whose length a long thing lies in it."""

_SLENDER = 1.9  # height to width from which a thing leans in a vessel
_WIDER = 1.1  # how much wider than its other end a thing's head is
_BLOSSOM = 4.0  # how much thicker than its stem a thing's head is that is to be seen
_SHOWN = 0.56  # share of its length that such a thing may be in a vessel
_FEW = 4  # of more things that stand together some are longer than others
_LENGTHS = (1.0, 0.92, 1.06, 0.96, 1.1)  # of flowers that stand together
_LARGER = (1.0, 1.12, 1.25, 1.4, 1.55)  # how much a vessel may grow until all find room

_WAYS: Mapping[str, tuple[Steps, ...]] = {
    "edge": ((("y", -90),), (("z", 90), ("y", -90)), (), (("z", 90),), (("x", 90), ("z", 90)),
             (("y", -90), ("x", 90))),
    "end": ((("y", -90), ("z", 90)), (("y", -90),), (), (("z", 90),), (("x", 90),),
            (("x", 90), ("z", 90))),
    "side": ((("x", 90),), (), (("z", 90),), (("y", 90), ("z", 90))),
}  # fmt: skip
"""Turns to try, for each stance in a holder."""


def stand_in_holder(model: Model, holder: Holder) -> Model:
    """Return a model turned as it stands in its place of a holder."""
    wanted = np.array(holder.stand((float(model.size[0]), float(model.size[1]),
                                    float(model.size[2]))))  # fmt: skip
    turned = [turn(model, steps) for steps in _WAYS[holder.stance]]
    return min(turned, key=lambda m: round(float(np.abs(m.size - wanted).max()), 6))


def room_of(models: Sequence[Model]) -> Extent:
    """Return the extent of the largest of things that stand, metres."""
    across, along, up = np.max([model.size for model in models], axis=0)
    return float(across), float(along), float(up)


def name_slots(holder: Model, names: Sequence[str]) -> Model:
    """Return a holder's model with its places given to things, in order."""
    pairs = zip(holder.slots, names, strict=False)
    return replace(holder, slots=tuple(replace(slot, name=name) for slot, name in pairs))


def head_up(model: Model) -> Model:
    """Return a standing model with its wide end up: bristles, blossoms, the wires of a whisk."""
    spheres = measure_stem(model).spheres
    wide = np.hypot(spheres[:, 0], spheres[:, 1]) + spheres[:, 3]
    share = spheres[:, 2] / float(model.size[2])
    foot, head = float(wide[share < 0.45].max()), float(wide[share > 0.55].max())
    return turn(model, (("x", 180),)) if foot > _WIDER * head else model


def fill_vessel(
    vessel: Model, things: Mapping[str, Model], upright: Mapping[str, bool], *, may_grow: bool
) -> tuple[Model, dict[str, Model]]:
    """Return a vessel with places for long things, and those as they lean in it.

    ``things`` stand straight; the vessel grows a little where it has no room for all, if it may.
    What finds no room is not among those returned.
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
    """Return a vessel that is not so deep that flowers vanish in it."""
    cavity = find_cavity(vessel)
    heads = [s.length for s in stems if s.spheres[:, 3].max() > _BLOSSOM * s.core]
    if cavity is None or not heads:
        return vessel
    share = float(np.clip(_SHOWN * min(heads) / cavity.depth, 0.55, 1.0))
    return replace(vessel, size=vessel.size * [1.0, 1.0, share])


def leans(model: Model, cavity: Cavity) -> bool:
    """Tell whether a standing thing is so long that it leans in a vessel, or stands out of it."""
    slender = float(model.size[2]) > _SLENDER * float(model.size[:2].min())
    return slender and float(model.size[2]) > 0.6 * cavity.depth


def file_in_box(
    vessel: Model, flat: Mapping[str, Model], cavity: Cavity
) -> tuple[Model, dict[str, Model]] | None:
    """Return a box with places for flat things on their edges, and those; None: no room."""
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
    """Return a model as it leans, and the middle of its underside in the vessel's frame, metres."""
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
