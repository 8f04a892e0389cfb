"""Close-up segmentation of each object, to refine its outline and to find parts that were missed.

A point prompt at the middle of an outline selects the object without prescribing its extent. The
parts of the resulting mask beyond the outline belong to the object, unless they are another object
whose own middle gives a different mask: two pieces of one object give the same whole, whereas a
tomato in front of an orange does not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ....geometry import mask_box
from ....meshes.pixels import dilate, foot_of, mask_iou
from ..eye.frames import Frame
from .network import SIDE, Drawn, PromptedModel, PromptedPicture
from .prompts import clean
from .selection import foot_row

_ROOM = 2.6  # crop size relative to the longer side of the object's box
_GAIN = 1.15  # minimum resolution gain of a crop over the first pass
_LEAST = 48.0  # minimum size of a crop in picture pixels
_GOOD, _STABLE = 0.7, 0.7  # minimum quality and stability of an outline
_SAME = 0.5  # minimum overlap (IoU) with the first outline
_SURE, _FIRM = 0.9, 0.85  # minimum quality and stability of a whole that no other piece confirms
_HOLDS = 0.9  # minimum fraction of the outline within its whole
_MORE = 1.1  # minimum area of a whole relative to the outline
_INSIDE = 0.7  # fraction of another object within a whole, above which it is a piece of it
_FREE = 0.1  # fraction of another object within a whole, below which it is separate
_AGREED = 0.75  # minimum overlap (IoU) of the wholes of two pieces of one object
_CONTACT = 0.3  # minimum contact length, relative to the size of the smaller outline
_STACKED = 0.7  # minimum fraction of an upper piece's foot that is above the lower piece
_ONE = 0.85  # minimum quality and stability of a mask that shows two outlines as one
_COVERS = 0.85  # minimum mutual coverage of this mask and the two outlines


@dataclass(frozen=True, eq=False)
class Closer:
    """The outline from a close-up, and the whole object's mask if the outline shows only a part.

    ``firm`` is True if no other piece needs to confirm the whole.
    """

    mask: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"] | None = None
    firm: bool = False


def look_closer(
    model: PromptedModel,
    look: PromptedPicture,
    image: UInt8[np.ndarray, "h w 3"],
    mask: Bool[np.ndarray, "h w"],
) -> Closer:
    """Segment one object in a close-up, or in ``look`` if a close-up would not show more detail."""
    frame = _frame(mask)
    near = look if frame is None else model.look(image, frame)
    drawn = near.in_box(mask_box(mask))
    fine = clean(near.spread(drawn))
    if not (_is_good(drawn) and mask_iou(fine, mask) >= _SAME):
        fine = mask
    drawn, whole = _ask_middle(near, fine)
    if frame is not None and _is_cut(whole, frame):
        drawn, whole = _ask_middle(look, fine)
    held = int((whole & fine).sum()) >= _HOLDS * int(fine.sum())
    larger = int(whole.sum()) >= _MORE * int(fine.sum())
    if not (held and larger and _is_good(drawn) and drawn.quality >= _SURE):
        return Closer(fine)
    return Closer(fine, whole, drawn.stability >= _FIRM)


def complete(
    seen: Sequence[Closer],
    clear: Sequence[bool],
    may_be_thing: Callable[[Bool[np.ndarray, "h w"]], bool],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the outlines, each extended with the parts that it missed; merge pieces of one object.

    ``clear`` marks outlines that are certainly separate objects; only their own close-ups can show
    that they are pieces. ``may_be_thing`` rejects wholes that are the table or the background.
    """
    seen = [c if c.whole is None or may_be_thing(c.whole) else replace(c, whole=None) for c in seen]
    areas = [int(c.mask.sum()) for c in seen]
    owner = list(range(len(seen)))
    masks = [c.mask for c in seen]
    for k in sorted(range(len(seen)), key=lambda k: -areas[k]):
        whole = seen[k].whole
        if whole is None or owner[k] != k:
            continue
        shared = [int((whole & c.mask).sum()) / max(a, 1) for c, a in zip(seen, areas, strict=True)]
        inside = [j for j, s in enumerate(shared) if j != k and s > _INSIDE]
        cut = any(_FREE < s <= _INSIDE for s in shared)
        agreed = [_agrees(seen[j], whole) for j in inside]
        if cut or not all(a or not clear[j] for j, a in zip(inside, agreed, strict=True)):
            continue
        if seen[k].firm or any(agreed):
            taken = [j for j in inside if owner[j] == j]
            masks[k] = np.any([whole, masks[k], *(masks[j] for j in taken)], axis=0)
            for j in taken:
                owner[j] = k
    return [masks[k] for k in range(len(seen)) if owner[k] == k]


def _agrees(other: Closer, whole: Bool[np.ndarray, "h w"]) -> bool:
    return other.whole is not None and mask_iou(other.whole, whole) >= _AGREED


def ask_unions(
    model: PromptedModel,
    look: PromptedPicture,
    image: UInt8[np.ndarray, "h w 3"],
    masks: Sequence[Bool[np.ndarray, "h w"]],
) -> Iterator[tuple[int, int, Bool[np.ndarray, "h w"]]]:
    """Prompt with the box around each pair of outlines; yield masks that show a pair as one object.

    Only pairs with one outline directly above the other are tried; objects side by side are
    separate.
    """
    reach = max(masks[0].shape) // 250 + 2 if masks else 0
    for i, j in combinations(range(len(masks)), 2):
        upper, lower = sorted((masks[i], masks[j]), key=foot_row)
        if not _rests_on(upper, lower, reach):
            continue
        both = upper | lower
        frame = _frame(both)
        near = look if frame is None else model.look(image, frame)
        drawn = near.in_box(mask_box(both))
        if drawn.quality < _ONE or drawn.stability < _ONE:
            continue
        mask = clean(near.spread(drawn))
        covers = all((mask & m).sum() > _COVERS * m.sum() for m in (upper, lower))
        if covers and (mask & both).sum() > _COVERS * mask.sum():
            yield i, j, mask


def _rests_on(upper: Bool[np.ndarray, "h w"], lower: Bool[np.ndarray, "h w"], reach: int) -> bool:
    """Return whether the lower outline is directly below most of the upper outline's lower end."""
    gap = mask_box(lower)[:2] - mask_box(upper)[2:], mask_box(upper)[:2] - mask_box(lower)[2:]
    if float(np.max(gap)) > reach:
        return False
    near = dilate(lower, 2 * reach + 1)
    smaller = min(int(upper.sum()), int(lower.sum()))
    if int((near & upper).sum()) < _CONTACT * reach * smaller**0.5:
        return False
    foot = foot_of(upper)
    columns = np.flatnonzero(foot.any(0))
    last = upper.shape[0] - 1 - upper[::-1, columns].argmax(0)
    below = np.minimum(last + reach, upper.shape[0] - 1)
    return float(near[below, columns].mean()) >= _STACKED


def _frame(mask: Bool[np.ndarray, "h w"]) -> Frame | None:
    """Return the close-up frame of a mask, or None if it adds no detail to the first pass."""
    low, high = mask_box(mask).reshape(2, 2)
    frame = Frame.around(low, high, SIDE, _ROOM, _LEAST)
    first = SIDE / max(mask.shape)
    return frame if frame.scale >= _GAIN * first else None


def _is_cut(mask: Bool[np.ndarray, "h w"], frame: Frame) -> bool:
    """Return whether a frame cuts a mask that continues in the picture."""
    box, size = mask_box(mask), mask.shape[1::-1]
    low, high = np.array(frame.corner) + 1, np.array(frame.corner) + frame.side / frame.scale - 1
    return bool(
        ((box[:2] <= low) & (low > 1)).any()
        or ((box[2:] >= high) & (high < np.array(size) - 1)).any()
    )


def _ask_middle(
    look: PromptedPicture, mask: Bool[np.ndarray, "h w"]
) -> tuple[Drawn, Bool[np.ndarray, "h w"]]:
    drawn = look.at_point(_middle(mask))
    return drawn, clean(look.spread(drawn))


def _is_good(drawn: Drawn) -> bool:
    return drawn.quality >= _GOOD and drawn.stability >= _STABLE


def _middle(mask: Bool[np.ndarray, "h w"]) -> Float[np.ndarray, "2"]:
    """Return the point (x, y) of a mask that is farthest from its boundary, in pixels."""
    inside = cv2.distanceTransform(np.pad(mask.astype(np.uint8), 1), cv2.DIST_L2, 5)[1:-1, 1:-1]
    y, x = np.unravel_index(int(inside.argmax()), inside.shape)
    return np.array([x + 0.5, y + 0.5])
