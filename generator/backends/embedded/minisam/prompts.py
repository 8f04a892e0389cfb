"""Prompts: boxes around detected objects, then points on objects that no mask covers yet.

A grid of points over the whole picture would find the same objects as the detector's object map, at
ten times the cost. Uncertain points come last.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float

from ....geometry import mask_box
from ..eye.network import REGIONS
from ..eye.sight import EyeReading
from .network import PromptedPicture

_FAINT = 0.15  # minimum confidence of a detection used as a prompt
_GOOD, _STABLE = 0.7, 0.8  # minimum quality and stability of a mask
_FAIR = 0.55  # minimum quality for a box prompt, which a detection supports
_THING, _DOUBT = 0.5, 0.15  # object probability in the detector's map: certain, possible
_SEEN = 0.5  # minimum mean object probability under a mask
_POINTS = 60  # maximum number of point prompts
_SMALLEST = 0.004  # minimum radius of uncovered regions, as a fraction of the picture's longer side
_LARGEST = 0.4  # maximum area of a mask, as a fraction of the picture
_TABLE = 0.6  # a mask that covers more of the tabletop than this is the table
_PIECE = 0.03  # minimum area of a separate piece, as a fraction of its mask


@dataclass(frozen=True, eq=False)
class Proposal:
    """A mask that may be an object.

    ``quality`` is the model's own quality estimate times the mask's stability; ``seen`` is the
    detector's mean object probability under the mask.
    """

    mask: Bool[np.ndarray, "h w"]
    quality: float
    seen: float


def propose(look: PromptedPicture, sight: EyeReading) -> list[Proposal]:
    """Return the masks for all prompts, except masks of the table and the background."""
    things = sight.region[REGIONS.index("thing")]
    top = sight.top > 0.5
    found: list[Proposal] = []
    covered = np.zeros(things.shape, bool)
    for mask, quality in _ask_boxes(look, sight):
        if _keep(found, mask, quality, things, top):
            covered |= mask
    for share in (_THING, _DOUBT):
        for mask, quality in _ask_points(look, things > share, covered):
            if _keep(found, mask, quality, things, top):
                covered |= mask
    return found


def _ask_boxes(
    look: PromptedPicture, sight: EyeReading
) -> Iterator[tuple[Bool[np.ndarray, "h w"], float]]:
    for thing in sight.things:
        if thing.score < _FAINT:
            continue
        drawn = look.in_box(mask_box(thing.visible))
        if drawn.quality >= _FAIR and drawn.stability >= _STABLE:
            yield clean(look.spread(drawn)), drawn.quality * drawn.stability


def _ask_points(
    look: PromptedPicture, asked: Bool[np.ndarray, "h w"], covered: Bool[np.ndarray, "h w"]
) -> Iterator[tuple[Bool[np.ndarray, "h w"], float]]:
    """Prompt repeatedly at the centre of the widest uncovered region; yield masks and qualities."""
    least = max(2.0, _SMALLEST * max(asked.shape))
    for _ in range(_POINTS):
        inside = cv2.distanceTransform((asked & ~covered).astype(np.uint8), cv2.DIST_L2, 5)
        y, x = (int(v) for v in np.unravel_index(int(inside.argmax()), inside.shape))
        radius = float(inside[y, x])
        if radius < least:
            return
        drawn = look.at_point(np.array([x + 0.5, y + 0.5]))
        disc = cv2.circle(np.zeros(asked.shape, np.uint8), (x, y), int(1.5 * radius) + 1, 1, -1)
        covered |= disc > 0
        if drawn.quality >= _GOOD and drawn.stability >= _STABLE:
            yield clean(look.spread(drawn)), drawn.quality * drawn.stability


def _keep(
    found: list[Proposal],
    mask: Bool[np.ndarray, "h w"],
    quality: float,
    things: Float[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
) -> bool:
    """Keep a mask if it may be an object; return whether it was kept."""
    kept = may_be_thing(mask, things, top)
    if kept:
        found.append(Proposal(mask, quality, float(things[mask].mean())))
    return kept


def may_be_thing(
    mask: Bool[np.ndarray, "h w"],
    things: Float[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
) -> bool:
    """Return whether a mask is neither the table nor background, according to the detector."""
    if not mask.any() or mask.sum() > _LARGEST * mask.size:
        return False
    if (mask & top).sum() > _TABLE * top.sum():
        return False
    return float(things[mask].mean()) >= _SEEN


def clean(mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    """Return a mask without small separate pieces."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8))
    if count <= 2:
        return mask
    kept = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] > _PIECE * mask.sum())
    return np.isin(labels, kept[kept > 0])
