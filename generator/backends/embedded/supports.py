"""Supports of objects, from depth maps or else from visible and whole masks (Fig. 25).

Where two masks overlap in the picture, the object in front is visible. An object *on* another is
visible with its foot inside the other's outline. An object *in* another is partly visible: its
lower end is behind the front wall, and its upper end in front of the back wall. An object *behind*
another is nowhere visible in the overlap, and an object *in front* has its foot below the other's.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import cv2
import numpy as np
from jaxtyping import Bool

from ...scene import TABLE, Instance, Stacking
from ..protocols import Instances
from .depth.measure import ObservedSolid, holds

Supports = dict[str, tuple[str, bool]]
"""The support of each object by name, and whether the object is inside the support."""

_HELD = 0.5  # minimum fraction of an object's footprint points above its support
_FOOT = 0.2  # height of the foot, relative to the object's
_ON = 0.6  # minimum fraction of the foot within the other's outline
# minimum height of the foot above the other's lower edge, relative to the other's height
_CLEAR = 0.06
_PART = 0.12  # minimum fraction of the overlap in which an object counts as visible
_LARGER = 0.6  # minimum area of a support, relative to the carried object


def whole_mask(instance: Instance) -> Bool[np.ndarray, "h w"]:
    """Return an instance's mask including its hidden parts, from its completed crop."""
    visible = np.asarray(instance.mask)
    if not instance.occluded:
        return visible
    x0, y0, x1, y1 = instance.crop_box
    rows, columns = instance.crop.shape[:2]
    scale = np.array([(x1 - x0) / columns, (y1 - y0) / rows])
    shift = np.array([x0, y0]) + 0.5 * scale - 0.5
    warp = np.array([[scale[0], 0, shift[0]], [0, scale[1], shift[1]]])
    alpha = np.ascontiguousarray(instance.crop[..., 3])
    placed = cv2.warpAffine(alpha, warp, (visible.shape[1], visible.shape[0]))
    return visible | (placed > 127)


def stack(
    instances: Instances,
    container: Callable[[str], bool],
    solids: Mapping[str, ObservedSolid] | None = None,
) -> Mapping[str, Stacking]:
    """Return each instance's support: from ``solids`` if there are any, or else from the masks.

    ``container`` returns whether objects with a label can contain others.
    """
    things = [i for i in instances if i.name != TABLE]
    containers = {i.name: container(i.label) for i in things}
    found = _by_solids(containers, solids) if solids else _by_masks(things, containers)
    return _order(list(containers), found)


def _by_solids(containers: Mapping[str, bool], solids: Mapping[str, ObservedSolid]) -> Supports:
    """Return the support at the base of each object, and whether that support is hollow.

    An object with a hidden foot seems to hover; without anything below, it stands on the table.
    """
    found: Supports = {}
    for name in [n for n in containers if n in solids]:
        held = {b: holds(solids[b], solids[name]) for b in containers if b != name and b in solids}
        below = max(held, key=lambda b: (held[b], b), default=None)
        if below is not None and held[below] > _HELD:
            found[name] = below, solids[below].hollow or containers[below]
    return found


def _by_masks(things: list[Instance], containers: Mapping[str, bool]) -> Supports:
    seen = {i.name: (np.asarray(i.mask), whole_mask(i)) for i in things}
    found: Supports = {}
    for name, own in seen.items():
        rated = {
            other: carries(*own, *below, containers[other])
            for other, below in seen.items()
            if other != name and below[1].sum() > _LARGER * own[1].sum()
        }
        best = max(rated, key=lambda n: rated[n][0], default=None)
        if best is not None and rated[best][0] > 0:
            found[name] = best, rated[best][1]
    return found


def carries(
    visible: Bool[np.ndarray, "h w"],
    full: Bool[np.ndarray, "h w"],
    below_visible: Bool[np.ndarray, "h w"],
    below: Bool[np.ndarray, "h w"],
    holds: bool,
) -> tuple[float, bool]:
    """Return the confidence that ``below`` carries the object, and whether the object is inside."""
    rows = np.flatnonzero(full.any(1))
    edges = np.flatnonzero(below.any(1))
    if not len(rows) or not len(edges):
        return 0.0, False
    foot = full.copy()
    foot[: int(rows[-1] - _FOOT * (rows[-1] - rows[0]))] = False
    within = float((foot & below).sum() / max(foot.sum(), 1))
    if within < _ON or not _above(foot, below, _CLEAR * (edges[-1] - edges[0] + 1)):
        return 0.0, False
    both = full & below
    shows = float((visible & both).sum() / max(both.sum(), 1))
    hidden = float((below_visible & both).sum() / max(both.sum(), 1))
    if hidden < _PART < shows:
        return within * shows, holds
    if holds and min(hidden, shows) >= _PART:
        return within * (shows + hidden), True
    return 0.0, False


def _above(foot: Bool[np.ndarray, "h w"], below: Bool[np.ndarray, "h w"], margin: float) -> bool:
    """Return whether an object's base ends above the lower edge of ``below`` in most columns."""
    columns = np.flatnonzero((foot & below).any(0))
    if not len(columns):
        return False
    height = foot.shape[0]
    ends = height - foot[::-1, columns].argmax(0)
    edges = height - below[::-1, columns].argmax(0)
    return bool(np.mean(ends + margin < edges) > 0.5)


def _order(names: list[str], found: Supports) -> Mapping[str, Stacking]:
    """Number the layers from the table up; objects in a cycle of supports stand on the table."""
    result = {TABLE: Stacking(1)}
    for name in names:
        chain = [name]
        while chain[-1] in found and found[chain[-1]][0] not in chain:
            chain.append(found[chain[-1]][0])
        grounded = chain[-1] not in found
        below, inside = found[name] if grounded and name in found else (TABLE, False)
        result[name] = Stacking(1 + len(chain), below, inside)
    return result
