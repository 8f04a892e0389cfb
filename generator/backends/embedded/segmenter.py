"""The embedded segmenter: the table, and everything on it that is not the table's colour."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, UInt8

from ...geometry import mask_box
from ...scene import TABLE, Detection
from .naming import name_things, total_unlikeness
from .outline import working_copy
from .plane import find_plane
from .regions import find_regions
from .splitting import split_things

GENERIC = "object"
"""The label that asks for anything on the table."""


@dataclass(frozen=True)
class Segmenter:
    """Finds things by geometry and colour alone; needs a plain, light ground."""

    def segment(
        self, image: UInt8[np.ndarray, "h w 3"], labels: tuple[str, ...]
    ) -> tuple[Detection, ...]:
        """Return the table first, then the things, nearest to the viewer last.

        Labels may repeat: each stands for one expected thing, and regions are split until there
        are enough. With no label beyond "table" and "object" things are named by likeness.

        Raises:
            SceneError: no tabletop in the picture.
        """
        image = np.ascontiguousarray(image)
        plane = find_plane(image)
        lab, _ = working_copy(image)
        regions = find_regions(lab, plane)
        wanted = tuple(w for w in labels if w not in (TABLE, GENERIC))

        def unlikeness(parts: list[Bool[np.ndarray, "h w"]]) -> float:
            big = [_enlarge(part, image.shape[:2]) for part in parts]
            return total_unlikeness(image, plane, big, wanted)

        small = split_things(lab, regions.strength, regions.things, len(wanted), unlikeness)
        masks = [refine(image, mask) for mask in small]
        masks = sorted((m for m in masks if m.any()), key=_foot)
        names = name_things(image, plane, masks, wanted)
        things = [
            Detection(name[0], mask_box(mask), mask, name[1])
            for name, mask in zip(names, masks, strict=True)
            if name is not None
        ]
        covered = np.any(masks, axis=0) if masks else np.zeros(image.shape[:2], bool)
        table = _enlarge(regions.table, image.shape[:2]) & ~covered
        return (Detection(TABLE, mask_box(table), table), *things)


def _foot(mask: Bool[np.ndarray, "h w"]) -> tuple[int, int]:
    box = mask_box(mask)
    return int(box[3]), int(box[0])


def _enlarge(mask: Bool[np.ndarray, "h w"], shape: tuple[int, ...]) -> Bool[np.ndarray, "a b"]:
    size = (shape[1], shape[0])
    return cv2.resize(mask.astype(np.float32), size, interpolation=cv2.INTER_LINEAR) > 0.5


def refine(
    image: UInt8[np.ndarray, "h w 3"], mask: Bool[np.ndarray, "a b"]
) -> Bool[np.ndarray, "h w"]:
    """Carry a mask from working size to the picture and pull its rim onto the picture's edges.

    GrabCut decides a band of two working pixels around the mask's outline; the inside and the
    outside are given.
    """
    shape = image.shape[:2]
    big = _enlarge(mask, shape)
    factor = shape[1] / mask.shape[1]
    if not big.any():
        return big
    band = max(2, round(2 * factor))
    x0, y0, x1, y1 = mask_box(big).astype(int)
    pad = 4 * band
    window = np.s_[max(0, y0 - pad) : y1 + pad, max(0, x0 - pad) : x1 + pad]
    inner = big[window].astype(np.uint8)
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * band + 1, 2 * band + 1))
    sure, possible = cv2.erode(inner, kernel), cv2.dilate(inner, kernel)
    trimap = np.where(possible > 0, cv2.GC_PR_BGD, cv2.GC_BGD).astype(np.uint8)
    trimap[inner > 0] = cv2.GC_PR_FGD
    trimap[sure > 0] = cv2.GC_FGD
    if not (sure.any() and (possible == 0).any()):
        return big
    crop = np.ascontiguousarray(image[window][..., ::-1])
    cv2.setRNGSeed(0)
    models = np.zeros((1, 65)), np.zeros((1, 65))
    cv2.grabCut(crop, trimap, (0, 0, 1, 1), *models, 2, cv2.GC_INIT_WITH_MASK)
    result = np.zeros_like(big)
    result[window] = (trimap == cv2.GC_FGD) | (trimap == cv2.GC_PR_FGD)
    return result
