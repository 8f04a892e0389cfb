"""Instance extraction (Sec. 3.1): list the objects, segment them, and complete each one."""

from __future__ import annotations

import contextlib
import dataclasses
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..backends.protocols import Each, Imager, Reasoner, Segmenter, in_turn
from ..errors import SceneError, require
from ..geometry import mask_box
from ..meshes.pixels import fill_holes, main_parts
from ..scene import TABLE, Detection, Instance, Reference, ScenePlan

SPECK = 1e-4
"""Regions smaller than this fraction of the picture are dropped."""

GAP = 0.02
"""Holes smaller than this fraction of their region are filled; larger holes, such as those in
handles, are kept."""

SHOWN = 0.6
"""A drawing is accepted if it shows at least this fraction of the planned objects. Objects inside
others are not counted, since a drawing may hide them."""

_APART = 1_000_003  # difference between the seeds of two drawings


@dataclass(frozen=True)
class ExtractionConfig:
    """Settings of instance extraction.

    Attributes:
        drawings: maximum number of drawings per plan; drawing stops once enough of the plan is
            visible.

    Raises:
        InputError: ``drawings`` is not a whole number from 1.
    """

    drawings: int = 3

    def __post_init__(self) -> None:
        require(self, "drawings", minimum=1, integer=True)


def extract(
    reference: Reference,
    reasoner: Reasoner,
    segmenter: Segmenter,
    imager: Imager,
    seed: int = 0,
    config: ExtractionConfig | None = None,
    *,
    complete_each: Each = in_turn,
) -> tuple[Reference, tuple[Instance, ...]]:
    """Return the table, named "table", and then every object on it, named ``<label>_<k>``.

    Image models omit or hide some of the planned objects. If too few are detected (``SHOWN``), the
    plan is drawn again with another seed; the returned reference is the drawing that shows the
    most. A given picture is never replaced.

    Raises:
        SceneError: the picture shows no table, or nothing on it.
    """
    plan = reference.plan
    best, (tables, things) = reference, _find(reference, reasoner, segmenter)
    config = config or ExtractionConfig()
    for k in range(1, config.drawings):
        if plan is None or len(things) >= SHOWN * _count_in_sight(plan):
            break
        with contextlib.suppress(SceneError):  # the drawing is unusable: keep the previous one
            drawn = dataclasses.replace(reference, image=imager.draw(plan, seed + _APART * k))
            found = _find(drawn, reasoner, segmenter)
            if found[0] and len(found[1]) > len(things):
                best, (tables, things) = drawn, found
    if not tables:
        raise SceneError(
            "No table found in the picture. Show the whole tabletop on a plain, light background."
        )
    if not things:
        raise SceneError(
            "Nothing found on the table. Use a picture with at least one object that differs "
            "in colour from the tabletop."
        )
    table = max(tables, key=lambda d: int(d.mask.sum()))
    return best, _complete(best, (table, *things), imager, complete_each)


def _count_in_sight(plan: ScenePlan) -> int:
    """Return the number of planned objects that are not inside another object."""
    return sum(all(r.kind != "in" for r in o.relations) for o in plan.objects)


def _find(
    reference: Reference, reasoner: Reasoner, segmenter: Segmenter
) -> tuple[list[Detection], list[Detection]]:
    """Return a segmenter's cleaned detections of tables and objects."""
    labels = tuple(reasoner.list_objects(reference))
    if TABLE not in labels:
        labels = (TABLE, *labels)
    image = np.asarray(reference.image)
    found = segmenter.segment(image, labels, reference.depth, reference.intrinsics)
    kept = tuple(c for d in found if (c := clean(d)) is not None)
    return [d for d in kept if d.label == TABLE], [d for d in kept if d.label != TABLE]


def _complete(
    reference: Reference, found: tuple[Detection, ...], imager: Imager, complete_each: Each
) -> tuple[Instance, ...]:
    """Return the detections cropped, completed and uniquely named, with the table first."""

    def complete(detection: Detection) -> Instance:
        others = tuple(d for d in found if d is not detection)
        return imager.complete(reference, detection, others)

    names = [TABLE, *unique_names([d.label for d in found[1:]])]
    completed = zip(names, complete_each(complete, found), strict=True)
    return tuple(dataclasses.replace(instance, name=name) for name, instance in completed)


def clean(detection: Detection) -> Detection | None:
    """Return the detection without specks and pinholes, or None if nothing remains.

    Small islands (less than a tenth of the largest) are removed, small holes (``GAP``) are filled,
    and the box is made tight.
    """
    mask = fill_holes(main_parts(np.asarray(detection.mask)), GAP)
    if mask.sum() < SPECK * mask.size:
        return None
    return dataclasses.replace(detection, mask=mask, box=mask_box(mask))


def unique_names(labels: Sequence[str]) -> list[str]:
    """Return a unique, file-safe name for each label: toy_car_1 and toy_car_2 for two toy cars."""
    counts: dict[str, int] = {}
    names: list[str] = []
    for label in labels:
        stem = re.sub(r"[^0-9a-z]+", "_", label.lower()).strip("_") or "object"
        counts[stem] = counts.get(stem, 0) + 1
        names.append(f"{stem}_{counts[stem]}")
    return names
