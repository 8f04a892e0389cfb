"""Matches what was detected in a freely drawn top view to the instances."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from ...backends.protocols import Segmenter
from ...errors import SceneError
from ...scene import TABLE, Detection, Instance, TopView


def complete_boxes(
    top: TopView, instances: tuple[Instance, ...], segmenter: Segmenter
) -> tuple[TopView, tuple[str, ...]]:
    """Return the top view with a box for every instance that can be found in its picture.

    Detections are matched to instances of the same label, nearest relative position first; a
    wrong label costs more than any distance. What matches none is left out, with a warning.

    Raises:
        SceneError: the picture shows no object.
    """
    missing = [i for i in instances if i.name != TABLE and i.name not in top.boxes]
    if not missing:
        return top, ()
    labels = (TABLE, *dict.fromkeys(i.label for i in missing))
    found = segmenter.segment(np.asarray(top.image), labels)
    things = [d for d in found if d.label != TABLE]
    if top.boxes and not things:
        return top, ()
    tables = [top.table_box] if top.boxes else [d.box for d in found if d.label == TABLE]
    if not tables or not things:
        raise SceneError("The top view shows no object on the table; draw it again.")
    table = np.asarray(tables[0])
    frame = next(np.asarray(i.box) for i in instances if i.name == TABLE)
    cost = np.array([[_cost(i, frame, d, table) for d in things] for i in missing])
    boxes = dict(top.boxes)
    rows, columns = linear_sum_assignment(cost)
    for row, column in zip(map(int, rows), map(int, columns), strict=True):
        boxes[missing[row].name] = things[column].box
    extra = len(things) - len(columns)
    message = f"The top view shows {extra} more than the picture; left out."
    return replace(top, table_box=table, boxes=boxes), (message,) if extra > 0 else ()


def _cost(
    instance: Instance,
    frame: Float[np.ndarray, "4"],
    detection: Detection,
    table: Float[np.ndarray, "4"],
) -> float:
    here = _relative(np.asarray(instance.box), frame)
    there = _relative(np.asarray(detection.box), table)
    return float(np.linalg.norm(here - there)) + 2.0 * (instance.label != detection.label)


def _relative(box: Float[np.ndarray, "4"], frame: Float[np.ndarray, "4"]) -> np.ndarray:
    return ((box[:2] + box[2:]) / 2 - frame[:2]) / np.maximum(frame[2:] - frame[:2], 1)
