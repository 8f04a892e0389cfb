"""What the stages' geometric questions rest on: the table plane, and solids where depth shows them.

A reference with depth is measured; one without is explained by its tabletop's outline.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ....scene import TABLE, Instance, Reference, SizePrior, Stacking, View
from ...protocols import Instances
from ..depth.measure import ObservedSolid, measure_solid
from ..depth.plane import find_depth_plane
from ..depth.things import height_above_floor
from ..plane.plane import TablePlane
from ..plane.tabletop import find_tabletop
from .supports import whole_mask

_THIN = 0.004  # metres: the least extent of anything
_SHOWN = 0.85  # share of a thing that must show for its size to count as measured
_ROUNDISH = 0.8  # width to length of a thing of unknown kind
_BACK = 1.6  # how much wider than it shows a thing may be that hides its own back


@dataclass(frozen=True, eq=False)
class Survey:
    """The tabletop of a reference, and its things' solids (metres); without depth there is none.

    ``height`` is how high the tabletop is above a floor that depth shows too; None if it does not.
    """

    plane: TablePlane
    solids: Mapping[str, ObservedSolid]
    height: float | None = None


def survey(
    reference: Reference,
    instances: Instances,
    length: float | None = None,
    view: View | None = None,
) -> Survey:
    """Return the tabletop's plane and the things' solids (SceneError: no tabletop).

    ``length`` and ``view`` are for references without depth, as in ``tabletop.find_tabletop``;
    ``instances`` may hold the table alone.
    """
    if reference.depth is None or reference.intrinsics is None:
        plan = reference.plan.table if reference.plan else None
        return Survey(find_tabletop(np.asarray(reference.image), plan, length, view), {})
    table = next((np.asarray(i.mask) for i in instances if i.name == TABLE), None)
    plane = find_depth_plane(reference.depth, reference.intrinsics, table)
    solids = {
        i.name: solid
        for i in instances
        if i.name != TABLE
        and (solid := measure_solid(np.asarray(i.mask), reference.depth, plane)) is not None
    }
    return Survey(plane, solids, height_above_floor(reference.depth, plane))


def solid_size(
    instance: Instance,
    solids: Mapping[str, ObservedSolid],
    stacking: Mapping[str, Stacking],
    usual: SizePrior | None,
) -> SizePrior:
    """Return a thing's measured extent, in the axes of its ``usual`` size if there is one.

    Something narrower at its top hides its own back: its width is then what its usual proportions
    make of its length, within reason. Of what other things hide nothing counts as measured: a known
    thing keeps its usual proportions, at the scale of what shows.
    """
    solid = solids[instance.name]
    height = max(solid.top - floor_of(instance.name, solids, stacking), _THIN)
    length, width = solid.extent
    if solid.tapers:
        ratio = _ROUNDISH if usual is None else float(np.divide(*np.sort(usual.extent[:2])))
        width = max(width, min(ratio * length, _BACK * width))
    turned = usual is not None and usual.extent[0] < usual.extent[1]
    seen = np.maximum([*((width, length) if turned else (length, width)), height], _THIN)
    whole = np.asarray(whole_mask(instance))
    hidden = float(np.asarray(instance.mask).sum()) < _SHOWN * float(whole.sum())
    if usual is None:
        return SizePrior(instance.name, seen, measured=not hidden)
    if hidden:
        factor = float(np.clip((seen / usual.extent).max(), 1 / 1.6, 1.6))
        seen = np.maximum(seen, usual.extent * factor)
    return SizePrior(instance.name, seen, usual.placement, usual.axes, measured=not hidden)


def floor_of(
    name: str, solids: Mapping[str, ObservedSolid], stacking: Mapping[str, Stacking]
) -> float:
    """Return how high above the tabletop the surface lies that a thing stands on, metres."""
    below = stacking[name].on
    if below not in solids:
        return 0.0
    support = solids[below]
    return max(support.inner if stacking[name].inside else support.top, 0.0)
