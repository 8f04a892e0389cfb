"""The embedded segmenter: the table and everything on it, found by a learned detector."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8

from ...errors import SceneError
from ...geometry import mask_box
from ...language.names import assign, free_labels, shape_word, weigh
from ...meshes.pixels import dilate, foot_of, main_parts
from ...scene import TABLE, Detection, Intrinsics
from ...threads import single_thread
from .carriers import find_carriers
from .depth.plane import find_depth_plane
from .depth.things import confirm
from .examples import compare_sizes, rate_words, scales_of
from .eye.judge import EyeDetection
from .eye.sight import EyeReading, name_all, see
from .eye.weights import load_weights
from .plane.outline import top_of
from .plane.plane import TablePlane
from .plane.tabletop import find_tabletop

Named = list[tuple[EyeDetection, str]]

GENERIC = "object"
"""The label that requests any object on the table."""

SURE = 0.5
"""Minimum confidence of an object that was not requested."""

_CARRIER = 0.6  # confidence of a carrier that is detected by its colour
_ASKED = 0.15  # minimum confidence of a requested object
_MOST = 64  # maximum number of objects per picture
_LOOKED = 0.03  # minimum probability of a category whose size and shape are compared
_SMALLEST = 1.5e-4  # minimum area of an object, as a fraction of the picture
# width of GrabCut's band around a mask's boundary, relative to the picture's longer side
_BAND = 0.012


@dataclass(frozen=True)
class EmbeddedSegmenter:
    """A segmenter that detects objects with this project's small network (``eye``)."""

    def segment(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        labels: tuple[str, ...],
        depth: Float[np.ndarray, "h w"] | None = None,
        intrinsics: Intrinsics | None = None,
    ) -> tuple[Detection, ...]:
        """Return the table first, then the objects; the closest to the viewer comes last.

        Labels may repeat: each stands for one expected object. If "table" and "object" are the only
        labels, all confident detections are returned under their own names. Depth confirms the
        detections.

        Raises:
            BackendError: the detector's weights are missing or damaged.
            SceneError: the picture contains no tabletop, or too many objects on it.
        """
        image = np.ascontiguousarray(image)
        return detect(image, see(image), labels, depth, intrinsics)


def detect(
    image: UInt8[np.ndarray, "h w 3"],
    sight: EyeReading,
    labels: tuple[str, ...],
    depth: Float[np.ndarray, "h w"] | None,
    intrinsics: Intrinsics | None,
) -> tuple[Detection, ...]:
    """Return the table and the objects as in ``protocols.Segmenter``, given an ``EyeReading``."""
    wanted = tuple(w for w in labels if w not in (TABLE, GENERIC))
    things = _on_table(sight, _ASKED if wanted else SURE)
    things += _carriers(image, sight, things)
    if len(things) > _MOST:
        raise SceneError(
            f"There are more than {_MOST} objects on the table. Cut the picture into parts that "
            "each show fewer objects."
        )
    table = table_of(image, sight)
    measured = None
    if depth is not None and intrinsics is not None:
        measured = find_depth_plane(depth, intrinsics, table)
    if wanted:
        named = _pick_wanted(image, things, wanted, measured)
    else:
        named = _label(image, things, measured)
    found = [
        Detection(label, mask_box(t.visible), t.visible, t.score, t.whole | t.visible)
        for t, label in named
        if t.visible.any()
    ]
    if depth is not None and measured is not None:
        found = confirm(found, depth, measured)
    for thing in found:
        table &= ~thing.mask
    table_found = Detection(TABLE, mask_box(table), table)
    return (table_found, *sorted(found, key=lambda d: (d.box[3], d.box[0])))


def table_of(image: UInt8[np.ndarray, "h w 3"], sight: EyeReading) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of the table: the detected region, refined to the picture's edges."""
    return refine(image, main_parts(sight.shows("top", "legs")))


def _on_table(sight: EyeReading, minimum: float) -> list[EyeDetection]:
    """Return the objects that stand on the table or on each other, not next to or under it."""
    stands = stand_on(sight, [thing.whole for thing in sight.things])
    return [
        thing
        for thing, on in zip(sight.things, stands, strict=True)
        if on and thing.score >= minimum and thing.visible.mean() >= _SMALLEST
    ]


def _carriers(
    image: UInt8[np.ndarray, "h w 3"], sight: EyeReading, things: Sequence[EyeDetection]
) -> list[EyeDetection]:
    """Return the boards and mats under objects, which the detector mistakes for the tabletop."""
    top = sight.top > 0.5
    wholes = find_carriers(image, top, [t.visible for t in things if t.score >= SURE])
    if not wholes:
        return []
    hidden = np.any([t.visible for t in things], axis=0)
    shown = [whole & ~hidden for whole in wholes]
    with single_thread(), torch.inference_mode():
        names = name_all(load_weights(), image, shown, float(top.sum()))
    return [
        EyeDetection(_CARRIER, _CARRIER, mask, whole, likely)
        for mask, whole, likely in zip(shown, wholes, names, strict=True)
    ]


def stand_on(sight: EyeReading, masks: Sequence[Bool[np.ndarray, "h w"]]) -> list[bool]:
    """Return whether each mask's lower end is on the tabletop or on a hidden part of it."""
    top = top_of(sight)
    near = dilate(top, max(top.shape) // 60 + 1)
    feet = map(foot_of, masks)
    return [bool((foot & near).sum() > 0.5 * foot.sum()) for foot in feet]


def _pick_wanted(
    image: UInt8[np.ndarray, "h w 3"],
    things: Sequence[EyeDetection],
    wanted: tuple[str, ...],
    measured: TablePlane | None,
) -> Named:
    """Return objects that match the requested words; uncertain objects must resemble their word."""
    if not things:
        return []
    plane = measured or find_tabletop(image)
    scores = np.array([t.score for t in things])
    likely, sizes = rate_words(things, wanted, plane), compare_sizes(things, wanted, plane)
    pairs = assign(likely, scores, sizes, scores < SURE, metric=measured is not None)
    return [(things[i], wanted[j]) for i, j in pairs]


def _label(
    image: UInt8[np.ndarray, "h w 3"], things: Sequence[EyeDetection], measured: TablePlane | None
) -> Named:
    """Return the objects with their labels; ``measured`` is the metric plane from a depth map."""
    if not things:
        return []
    keys = load_weights().categories
    names = np.stack([t.names for t in things]).astype(float)
    looks = looks_of(things, measured or find_tabletop(image), keys)
    labels = free_labels(weigh(names, looks, metric=measured is not None), keys)
    return [(t, label or _shape(t)) for t, label in zip(things, labels, strict=True)]


def looks_of(
    things: Sequence[EyeDetection], plane: TablePlane, keys: Sequence[str]
) -> list[dict[int, tuple[float, float]] | None]:
    """Return each object's apparent size and shape difference for each of its likely categories."""
    looks: list[dict[int, tuple[float, float]] | None] = []
    for thing in things:
        likely = np.flatnonzero(thing.names[:-1] > _LOOKED).tolist()
        scales = scales_of(thing, [keys[k] for k in likely], plane)
        looks.append(None if scales is None else {k: scales[keys[k]] for k in likely})
    return looks


def _shape(thing: EyeDetection) -> str:
    x0, y0, x1, y1 = mask_box(thing.visible)
    share = float(thing.visible.sum() / ((x1 - x0) * (y1 - y0)))
    return shape_word(x1 - x0, y1 - y0, share)


def refine(
    image: UInt8[np.ndarray, "h w 3"], mask: Bool[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Align a mask's boundary with the picture's edges, using GrabCut in a band around it.

    The inside and the outside are fixed; a result that changes the area much is discarded.
    """
    if not mask.any():
        return mask
    x0, y0, x1, y1 = mask_box(mask).astype(int)
    thick = cv2.distanceTransform(mask[y0:y1, x0:x1].astype(np.uint8), cv2.DIST_L2, 3).max()
    band = int(np.clip(_BAND / 2 * max(mask.shape), 1, max(1.0, thick / 2)))
    pad = 4 * band
    window = np.s_[max(0, y0 - pad) : y1 + pad, max(0, x0 - pad) : x1 + pad]
    inner = mask[window].astype(np.uint8)
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * band + 1, 2 * band + 1))
    sure, possible = cv2.erode(inner, kernel), cv2.dilate(inner, kernel)
    if not sure.any() or (possible > 0).all():
        return mask
    trimap = np.where(possible > 0, cv2.GC_PR_BGD, cv2.GC_BGD).astype(np.uint8)
    trimap[inner > 0] = cv2.GC_PR_FGD
    trimap[sure > 0] = cv2.GC_FGD
    crop = np.ascontiguousarray(image[window][..., ::-1])
    cv2.setRNGSeed(0)
    models = np.zeros((1, 65)), np.zeros((1, 65))
    cv2.grabCut(crop, trimap, (0, 0, 1, 1), *models, 2, cv2.GC_INIT_WITH_MASK)
    cut = (trimap == cv2.GC_FGD) | (trimap == cv2.GC_PR_FGD)
    if not 0.8 < cut.sum() / inner.sum() < 1.25:
        return mask
    result = np.zeros_like(mask)
    result[window] = cut
    return result
