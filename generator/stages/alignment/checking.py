"""A top view held against the reference picture: what an image model moved, dropped or invented.

Both pictures show where things touch the table. A ray through the front of a thing's foot in the
reference picture meets the table's plane; seen from above, the same point is the near edge of its
box. One scale and one shift carry all of them from one to the other, if the top view is true.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import combinations

import numpy as np
from jaxtyping import Float

from ...geometry import Camera, rotated_extent
from ...render.crop import in_reference, tight_box
from ...scene import TABLE, Instance, Model, Rotation, Stacking, TopView, View

_ASTRAY = 0.07  # of the table's longer side: how far a box may be from where geometry has it
_OWN = 0.5  # of a box's longer side, which may be added to that
_CLOSE = 0.4  # of that distance: what agrees on a scale and a shift
_ROOM = 0.15  # of its support's box: how far beyond it the middle of what stands there may be
_FEWEST = 4  # things on the table from which a scale and a shift can be trusted
_AGREE = 0.5  # share of them that must agree


def check_top_view(
    top: TopView,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    stacking: Mapping[str, Stacking],
    view: View,
    image_size: tuple[int, int],
) -> tuple[TopView, tuple[str, ...]]:
    """Return the top view with every box where geometry confirms it, and a warning per repair.

    Args:
        top: boxes as they were drawn and detected; some may be missing.
        instances: the reference picture's, the table among them.
        models: give a missing box its proportions.
        rotations: and its yaw.
        stacking: what stands on what; only what stands on the table tells scale and shift.
        view: the reference picture's camera.
        image_size: (width, height) of the reference picture.

    Where too few things agree to tell what is right, the top view is kept as it is.
    """
    things = [i for i in instances if i.name != TABLE]
    on = {i.name: stacking[i.name].on if i.name in stacking else TABLE for i in things}
    feet = {i.name: foot for i in things if (foot := _foot(i, view, image_size)) is not None}
    standing = [n for n in feet if on[n] == TABLE and n in top.boxes]
    boxes = {name: np.asarray(box, float) for name, box in top.boxes.items()}
    length = float(np.max(top.table_box[2:] - top.table_box[:2]))
    towards = _towards(view)
    near = {n: _near_edge(boxes[n], towards) for n in standing}
    limits = {n: _ASTRAY * length + _OWN * float(np.ptp(boxes[n].reshape(2, 2), axis=0).max())
              for n in standing}  # fmt: skip
    carried = _agreed(feet, near, limits)
    if carried is None:
        return top, ()
    scale, shift = carried
    repaired, warnings = [], []
    for name in feet:
        if on[name] != TABLE:
            continue
        there = scale * feet[name] + shift
        if name not in boxes:
            boxes[name] = _moved(_shape(name, models, rotations, boxes), there, towards)
            warnings.append(f"{name}: the top view lacks it; geometry put it in.")
        elif np.linalg.norm(there - near[name]) > limits[name]:
            boxes[name] = _moved(boxes[name], there, towards)
            warnings.append(f"{name}: the top view has it elsewhere; geometry put it back.")
        else:
            continue
        repaired.append(name)
    for name in sorted(on, key=lambda n: stacking[n].order if n in stacking else 0):
        below = on[name]
        if below not in boxes or (name in boxes and _over(boxes[name], boxes[below])):
            continue
        lost = name not in boxes
        shape = _shape(name, models, rotations, boxes) if lost else boxes[name]
        middle = boxes[below].reshape(2, 2).mean(0)
        boxes[name] = shape + np.tile(middle - shape.reshape(2, 2).mean(0), 2)
        repaired.append(name)
        what = "lacks it" if lost else "does not show it there"
        warnings.append(f"{name}: it is on {below}, and the top view {what}; it was put there.")
    return replace(top, boxes=boxes, repaired=(*top.repaired, *repaired)), tuple(warnings)


def _foot(
    instance: Instance, view: View, image_size: tuple[int, int]
) -> Float[np.ndarray, "2"] | None:
    """Return where the front of a thing's foot is on a plane one unit below the camera.

    In top-view axes: right and down. None if it shows nothing, or the ray does not meet the plane.
    """
    if not (instance.crop[..., 3] > 127).any():
        return None
    tight = in_reference(instance, tight_box(instance)).reshape(2, 2)
    camera = Camera.looking_at(np.zeros(3), view, 1.0, *image_size)
    ray = camera.rays(np.array([[tight[:, 0].mean(), tight[1, 1]]]))[0]
    if ray[2] > -0.02:
        return None
    return ray[:2] / -ray[2] * [1, -1]


def _towards(view: View) -> Float[np.ndarray, "2"]:
    """Return the direction towards the camera in the top view."""
    camera = Camera.looking_at(np.zeros(3), view, 1.0, 2, 2)
    flat = camera.position[:2] * [1, -1]
    length = float(np.linalg.norm(flat))
    return flat / length if length > 1e-6 else np.array([0.0, 1.0])


def _near_edge(
    box: Float[np.ndarray, "4"], towards: Float[np.ndarray, "2"]
) -> Float[np.ndarray, "2"]:
    """Return the point of a box's ellipse that is nearest to the camera."""
    half = (box[2:] - box[:2]) / 2
    reach = half**2 * towards / max(float(np.linalg.norm(half * towards)), 1e-9)
    return (box[:2] + box[2:]) / 2 + reach


def _moved(
    box: Float[np.ndarray, "4"], there: Float[np.ndarray, "2"], towards: Float[np.ndarray, "2"]
) -> Float[np.ndarray, "4"]:
    return box + np.tile(there - _near_edge(box, towards), 2)


def _agreed(
    feet: Mapping[str, np.ndarray], near: Mapping[str, np.ndarray], limits: Mapping[str, float]
) -> tuple[float, Float[np.ndarray, "2"]] | None:
    """Return the scale and shift on which most things agree; None if they do not."""
    names = list(near)
    if len(names) < _FEWEST:
        return None
    here = np.array([feet[n] for n in names])
    there = np.array([near[n] for n in names])
    limit = np.array([limits[n] for n in names])
    best: tuple[float, np.ndarray] = (0.0, np.zeros(len(names), bool))
    for i, j in combinations(range(len(names)), 2):
        fit = _fitted(here[[i, j]], there[[i, j]])
        if fit is None:
            continue
        off = np.linalg.norm(fit[0] * here + fit[1] - there, axis=1) / limit
        agrees = off < _CLOSE
        worth = float(agrees.sum() - 0.5 * off[agrees].mean()) if agrees.any() else 0.0
        if worth > best[0]:
            best = worth, agrees
    if best[1].sum() < max(_FEWEST - 1, _AGREE * len(names)):
        return None
    return _fitted(here[best[1]], there[best[1]])


def _fitted(
    here: Float[np.ndarray, "n 2"], there: Float[np.ndarray, "n 2"]
) -> tuple[float, Float[np.ndarray, "2"]] | None:
    """Return the scale and shift that carry points onto others best; None if they turn them."""
    a, b = here - here.mean(0), there - there.mean(0)
    spread = float((a * a).sum())
    scale = float((a * b).sum()) / spread if spread > 1e-12 else 0.0
    return (scale, there.mean(0) - scale * here.mean(0)) if scale > 0 else None


def _shape(
    name: str,
    models: Mapping[str, Model],
    rotations: Mapping[str, Rotation],
    boxes: Mapping[str, Float[np.ndarray, "4"]],
) -> Float[np.ndarray, "4"]:
    """Return a box at the origin for a thing that has none, by the others' pixels per metre."""

    def extent(other: str) -> Float[np.ndarray, "2"]:
        yaw = rotations[other].yaw if other in rotations else 0.0
        return rotated_extent(np.asarray(models[other].size), yaw)

    pixels = np.median([
        np.sqrt(np.prod(box[2:] - box[:2]) / np.prod(extent(other)))
        for other, box in boxes.items() if other in models
    ])  # fmt: skip
    half = extent(name) * float(pixels) / 2
    return np.concatenate([-half, half])


def _over(box: Float[np.ndarray, "4"], below: Float[np.ndarray, "4"]) -> bool:
    """Tell whether the middle of a box lies over another, or nearly."""
    middle, slack = box.reshape(2, 2).mean(0), _ROOM * (below[2:] - below[:2])
    return bool((middle >= below[:2] - slack).all() and (middle <= below[2:] + slack).all())
