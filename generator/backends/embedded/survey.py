"""What the stages' geometric questions rest on: the table plane, and solids where depth shows them.

A reference with depth is measured; one without is explained by its tabletop's outline.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ...scene import TABLE, Instance, Reference, SizePrior, Stacking, View
from .depth_measure import Solid, measure_solid, stack_solids
from .depth_plane import find_depth_plane
from .plane import TablePlane
from .stacking import stack
from .tabletop import find_tabletop

_THIN = 0.004  # metres: the least extent of anything


@dataclass(frozen=True, eq=False)
class Survey:
    """The tabletop of a reference, and its things' solids (metres); without depth there is none."""

    plane: TablePlane
    solids: Mapping[str, Solid]


def survey(
    reference: Reference,
    instances: tuple[Instance, ...],
    length: float | None = None,
    view: View | None = None,
) -> Survey:
    """Return the tabletop's plane and the things' solids.

    ``length`` and ``view`` are for references without depth, as in ``tabletop.find_tabletop``;
    ``instances`` may hold the table alone.

    Raises:
        SceneError: no tabletop in the picture or its depth map.
    """
    if reference.depth is None or reference.intrinsics is None:
        plan = reference.plan.table if reference.plan else None
        return Survey(find_tabletop(np.asarray(reference.image), plan, length, view), {})
    table = next((np.asarray(i.mask) for i in instances if i.name == TABLE), None)
    plane = find_depth_plane(reference.depth, reference.intrinsics, table)
    found = {
        i.name: measure_solid(np.asarray(i.mask), reference.depth, plane)
        for i in instances
        if i.name != TABLE
    }
    return Survey(plane, {name: solid for name, solid in found.items() if solid is not None})


def stacking_of(
    instances: tuple[Instance, ...],
    solids: Mapping[str, Solid],
    container: Callable[[str], bool],
) -> Mapping[str, Stacking]:
    """Return what each instance stands on: by depth if it shows solids, else by the masks."""
    if not solids:
        return stack(instances, container)
    return stack_solids(instances, solids, container)


def solid_size(
    instance: Instance,
    solids: Mapping[str, Solid],
    stacking: Mapping[str, Stacking],
    usual: SizePrior | None,
) -> SizePrior:
    """Return a thing's measured extent, in the axes of its ``usual`` size if there is one.

    Of an unknown thing x and y are the world's, as its model is built. A known thing of which
    something is hidden keeps its usual proportions, at the scale of what shows.
    """
    solid = solids[instance.name]
    height = max(solid.top - floor_of(instance.name, solids, stacking), _THIN)
    if usual is None:
        return SizePrior(instance.name, np.maximum([*solid.across, height], _THIN))
    length, width = solid.extent
    sides = (length, width) if usual.extent[0] >= usual.extent[1] else (width, length)
    measured = np.maximum([*sides, height], _THIN)
    if instance.occluded:
        factor = float(np.clip((measured / usual.extent).max(), 1 / 1.6, 1.6))
        measured = usual.extent * factor
    return SizePrior(instance.name, measured, usual.placement, usual.axes)


def floor_of(name: str, solids: Mapping[str, Solid], stacking: Mapping[str, Stacking]) -> float:
    """Return how high above the tabletop the surface lies that a thing stands on, metres."""
    below = stacking[name].on
    if below not in solids:
        return 0.0
    support = solids[below]
    return max(support.inner if stacking[name].inside else support.top, 0.0)


def box_corners(solid: Solid) -> Float[np.ndarray, "2 2"]:
    """Return the lowest and highest corner of a solid's footprint along the table's axes."""
    half = np.asarray(solid.across) / 2
    return np.stack([solid.center - half, solid.center + half])
