"""Instance extraction (Sec. 3.1): list what is there, segment it, complete each thing."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Sequence

import cv2
import numpy as np
from jaxtyping import Bool

from ..backends.protocols import Imager, Reasoner, Segmenter
from ..errors import SceneError
from ..geometry import main_parts, mask_box
from ..scene import TABLE, Detection, Instance, Reference

SPECK = 1e-4
"""A region below this share of the picture is dropped."""

GAP = 0.02
"""A hole below this share of its region is filled; larger ones (a handle) are real."""


def extract(
    reference: Reference, reasoner: Reasoner, segmenter: Segmenter, imager: Imager
) -> tuple[Instance, ...]:
    """Return the table, named "table", and then every thing on it, named ``<label>_<k>``.

    Raises:
        SceneError: no table in the picture, or nothing stands on it.
    """
    labels = tuple(reasoner.list_objects(reference))
    if TABLE not in labels:
        labels = (TABLE, *labels)
    image = np.asarray(reference.image)
    found = segmenter.segment(image, labels, reference.depth, reference.intrinsics)
    kept = tuple(c for d in found if (c := clean(d)) is not None)
    tables = [d for d in kept if d.label == TABLE]
    things = [d for d in kept if d.label != TABLE]
    if not tables:
        raise SceneError(
            "No table found in the picture. Show the whole tabletop on a plain, light ground."
        )
    if not things:
        raise SceneError(
            "Nothing found on the table. Use a picture with at least one thing that differs in "
            "colour from the tabletop."
        )
    table = max(tables, key=lambda d: int(d.mask.sum()))
    ordered = [table, *things]
    names = [TABLE, *unique_names([d.label for d in things])]
    instances = []
    for name, detection in zip(names, ordered, strict=True):
        others = tuple(d for d in ordered if d is not detection)
        completed = imager.complete(reference, detection, others)
        instances.append(dataclasses.replace(completed, name=name))
    return tuple(instances)


def clean(detection: Detection) -> Detection | None:
    """Return the detection without specks and pin holes, or None if nothing is left.

    Small islands (under a tenth of the largest) go, small holes (``GAP``) are filled; the box is
    made tight.
    """
    mask = fill_holes(main_parts(np.asarray(detection.mask)), GAP)
    if mask.sum() < SPECK * mask.size:
        return None
    return dataclasses.replace(detection, mask=mask, box=mask_box(mask))


def fill_holes(mask: Bool[np.ndarray, "h w"], share: float) -> Bool[np.ndarray, "h w"]:
    """Fill enclosed holes smaller than ``share`` of the mask's area."""
    outside = (~mask).astype(np.uint8)
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(outside, connectivity=4)
    border = np.unique(np.concatenate([numbers[0], numbers[-1], numbers[:, 0], numbers[:, -1]]))
    small = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] < share * max(int(mask.sum()), 1))
    inner = np.setdiff1d(np.setdiff1d(small, border), [0])
    return mask | np.isin(numbers, inner)


def unique_names(labels: Sequence[str]) -> list[str]:
    """Return a file-safe unique name per label: "toy car" twice gives toy_car_1, toy_car_2."""
    counts: dict[str, int] = {}
    names = []
    for label in labels:
        stem = re.sub(r"[^0-9a-z]+", "_", label.lower()).strip("_") or "object"
        counts[stem] = counts.get(stem, 0) + 1
        names.append(f"{stem}_{counts[stem]}")
    return names
