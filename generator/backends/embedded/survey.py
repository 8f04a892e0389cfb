"""Geometry of a reference: the table plane and, with a depth map, the objects as solids.

A reference with depth is measured; without depth, the tabletop's outline gives the plane.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...scene import TABLE, Instance, Reference, SizePrior, Stacking, View
from ..protocols import Instances
from .depth.measure import ObservedSolid, measure_solid
from .depth.plane import find_depth_plane
from .depth.things import height_above_floor
from .plane.plane import TablePlane
from .plane.tabletop import find_tabletop
from .supports import whole_mask

_THIN = 0.004  # minimum extent of any object in metres
_SHOWN = 0.85  # minimum visible fraction of an object for a measured size
_ROUNDISH = 0.8  # ratio of width to length of an unknown object
_BACK = 1.6  # maximum ratio of an object's width to its visible width if it hides its own back


@dataclass(frozen=True, eq=False)
class Survey:
    """The tabletop of a reference and, if it has a depth map, its objects' solids in metres.

    ``height`` is the height of the tabletop above a floor, or None if depth does not show it.
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
    """Return the tabletop's plane and the objects' solids.

    ``length`` and ``view`` are for references without depth, as in ``tabletop.find_tabletop``.
    ``instances`` may consist of the table alone.

    Raises:
        SceneError: the picture contains no tabletop.
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
    """Return an object's measured extent, along the axes of its ``usual`` size if there is one.

    An object with a narrower top hides its own back: its width is then derived from its length and
    its usual proportions, within limits. An object hidden by others does not count as measured: it
    keeps its usual proportions, if known, at the scale of its visible part.
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
    """Return the height of an object's support above the tabletop in metres."""
    below = stacking[name].on
    if below not in solids:
        return 0.0
    support = solids[below]
    return max(support.inner if stacking[name].inside else support.top, 0.0)
