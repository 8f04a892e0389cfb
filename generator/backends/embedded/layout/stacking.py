"""What stands on or in what, from visible and whole masks alone (Fig. 25).

Where two things overlap in the picture, the one on top shows. What stands *on* another shows with
its foot inside the other's outline. What stands *in* another shows in part: its lower end is behind
the front wall, its upper end before the back wall. What stands *behind* shows nowhere in the
overlap, and what stands *in front* has its foot below the other's.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool

from ....scene import TABLE, Instance, Stacking

_FOOT = 0.2  # of a thing's height: its foot
_ON = 0.6  # share of the foot within the other's outline
_CLEAR = 0.06  # of the other's height, by which the foot lies above the other's lower edge
_PART = 0.12  # share of the overlap from which somebody shows in it
_LARGER = 0.6  # least area of a support, times the area of what it carries


@dataclass(frozen=True, eq=False)
class _Seen:
    """An instance's masks in the picture: what shows, and all of it."""

    visible: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"]


def whole_mask(instance: Instance) -> Bool[np.ndarray, "h w"]:
    """Return an instance's mask with its hidden parts, as its completed crop shows them."""
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
    instances: tuple[Instance, ...], container: Callable[[str], bool]
) -> Mapping[str, Stacking]:
    """Return what each instance stands on; ``container`` tells whether a label holds things."""
    things = [i for i in instances if i.name != TABLE]
    seen = {i.name: _Seen(np.asarray(i.mask), whole_mask(i)) for i in things}
    holds = {i.name: container(i.label) for i in things}
    found: dict[str, tuple[str, bool]] = {}
    for name, own in seen.items():
        rated = {
            other: carries(own.visible, own.whole, below.visible, below.whole, holds[other])
            for other, below in seen.items()
            if other != name and below.whole.sum() > _LARGER * own.whole.sum()
        }
        best = max(rated, key=lambda n: rated[n][0], default=None)
        if best is not None and rated[best][0] > 0:
            found[name] = best, rated[best][1]
    return _order(list(seen), found)


def carries(
    visible: Bool[np.ndarray, "h w"],
    full: Bool[np.ndarray, "h w"],
    below_visible: Bool[np.ndarray, "h w"],
    below: Bool[np.ndarray, "h w"],
    holds: bool,
) -> tuple[float, bool]:
    """Tell how surely one thing carries another (0: it does not), and whether inside of it."""
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
    """Tell whether a foot ends above the other's lower edge, in most of its columns."""
    columns = np.flatnonzero((foot & below).any(0))
    if not len(columns):
        return False
    height = foot.shape[0]
    ends = height - foot[::-1, columns].argmax(0)
    edges = height - below[::-1, columns].argmax(0)
    return bool(np.mean(ends + margin < edges) > 0.5)


def _order(names: list[str], found: Mapping[str, tuple[str, bool]]) -> Mapping[str, Stacking]:
    """Number the layers from the table up; a circle of supports stands on the table."""
    result = {TABLE: Stacking(1)}
    for name in names:
        chain = [name]
        while chain[-1] in found and found[chain[-1]][0] not in chain:
            chain.append(found[chain[-1]][0])
        grounded = chain[-1] not in found
        below, inside = found[name] if grounded and name in found else (TABLE, False)
        result[name] = Stacking(1 + len(chain), below, inside)
    return result
