"""Top-view Spatial Alignment, TSA (Sec. 3.3): translations and scales from a view from above."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from ..backends.protocols import Imager, Reasoner, Segmenter
from ..errors import SceneError
from ..geometry import rotated_extent, rotation_z
from ..render.contact import Body, resting_height
from ..scene import (
    TABLE,
    Detection,
    Instance,
    Mesh,
    Model,
    Placement,
    Reference,
    Rotation,
    SizePrior,
    Stacking,
    TopView,
    View,
)


@dataclass(frozen=True)
class AlignmentConfig:
    """Settings of TSA.

    tau: tolerance of the aspect ratio in the RMA-Score (Eq. 6; the paper's 0.25).
    size_limit: an object's scale stays within this factor of its commonsense size, both ways.
    guess_limit: the same in a picture that came without a text: names, and with them commonsense
        sizes, are guesses there.
    table_limit: an anchor that would make the table this much larger or smaller than its
        commonsense size is passed over.
    """

    tau: float = 0.25
    size_limit: float = 1.6
    guess_limit: float = 4.0
    table_limit: float = 2.0


@dataclass(frozen=True, eq=False)
class Alignment:
    """What TSA found (Fig. 14).

    ``placements`` are the objects', in the instances' order, without the table; ``table_scale``
    is the table's extent in metres; ``scores`` the RMA-Score of each object.
    """

    anchor: str
    metres_per_pixel: float
    table_scale: Float[np.ndarray, "3"]
    placements: tuple[Placement, ...]
    top_view: TopView
    stacking: Mapping[str, Stacking]
    scores: Mapping[str, float]
    warnings: tuple[str, ...] = ()


# ------------------------------------------------------------------------------------ equations


def pixel_area_and_ratio_error(
    box: Float[np.ndarray, "4"], size: Float[np.ndarray, "3"], yaw: float
) -> tuple[float, float]:
    """Return A_px and epsilon_ratio of Eq. 5.

    A_px = w_img h_img and epsilon_ratio = |log r_phys - log r_img|, with r = width / height; r_phys
    is of the physical ``size`` (metres) turned by ``yaw`` and projected onto the XY-plane.
    """
    w_img, h_img = box[2] - box[0], box[3] - box[1]
    w_phys, h_phys = rotated_extent(np.asarray(size), yaw)
    error = abs(np.log(w_phys / h_phys) - np.log(w_img / h_img))
    return float(w_img * h_img), float(error)


def rma_score(area: float, ratio_error: float, tau: float = 0.25) -> float:
    """Return the Ratio-Matched and Area-Weighted Score, Eq. 6: A_px / (1 + (eps / tau)^2)."""
    return area / (1.0 + (ratio_error / tau) ** 2)


def select_anchor(scores: Mapping[str, float]) -> str:
    """Return the name with the highest RMA-Score (the first of equals)."""
    if not scores:
        raise SceneError("No object can be the scaling anchor: the top view shows none.")
    return max(scores, key=lambda name: scores[name])


def metres_per_pixel(
    box: Float[np.ndarray, "4"], size: Float[np.ndarray, "3"], yaw: float
) -> float:
    """Return alpha, metres per top-view pixel, from the anchor: root of the areas' ratio."""
    w_phys, h_phys = rotated_extent(np.asarray(size), yaw)
    return float(np.sqrt(w_phys * h_phys / ((box[2] - box[0]) * (box[3] - box[1]))))


def own_extent(
    across: Float[np.ndarray, "2"], yaw: float, size: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "3"]:
    """Return the extent along an object's own axes, given its axis-aligned top-view extent.

    Args:
        across: width and height of the box in the top view, metres (along world x and y).
        yaw: the object's yaw, radians.
        size: commonsense extent; gives the proportions where the box does not.

    The box is W = |cos| l + |sin| w, H = |sin| l + |cos| w. Its inverse is used as far as it is
    well-conditioned (|cos 2 yaw| near 1) and agrees with the proportions to within a factor 1.4;
    near 45 degrees the proportions of ``size`` are kept. Height follows the mean scale.
    """
    c, s = abs(np.cos(yaw)), abs(np.sin(yaw))
    box = rotated_extent(size, yaw)
    factor = float(np.sqrt(across.prod() / box.prod()))
    kept = size * factor
    det = c * c - s * s
    trust = float(np.clip((abs(det) - 0.3) / 0.5, 0.0, 1.0))
    if trust > 0:
        solved = np.array([c * across[0] - s * across[1], c * across[1] - s * across[0]]) / det
        change = np.log(np.maximum(solved, 1e-6) / kept[:2])
        if (solved > 0).all() and np.abs(change).max() < np.log(1.4):
            kept[:2] *= np.exp(trust * change)
    return kept


def rectangle_box(
    box: Float[np.ndarray, "4"], mesh: Mesh, size: Float[np.ndarray, "3"], yaw: float
) -> Float[np.ndarray, "4"]:
    """Return the top-view box of an object's own turned rectangle, given its outline's box.

    Eqs. 5 and 6 project the box of the physical size. What the top view shows is the outline of
    the thing itself, which is smaller (a mug turned by 45 degrees) and may lie off the centre (its
    handle). ``mesh`` is canonical, ``size`` in metres, ``yaw`` in radians.
    """
    points = mesh.vertices[:, :2] * size[:2] @ rotation_z(yaw)[:2, :2].T
    low, high = points.min(0), points.max(0)
    pixels = (box[2:] - box[:2]) / np.maximum(high - low, 1e-6)  # per metre, along u and v
    middle = (box[:2] + box[2:]) / 2 - (low + high) / 2 * [1, -1] * pixels
    half = rotated_extent(size, yaw) / 2 * pixels
    return np.concatenate([middle - half, middle + half])


# ---------------------------------------------------------------------------------------- stage


def align(
    reference: Reference,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    sizes: Mapping[str, SizePrior],
    rotations: Mapping[str, Rotation],
    view: View,
    imager: Imager,
    segmenter: Segmenter,
    reasoner: Reasoner,
    config: AlignmentConfig | None = None,
) -> Alignment:
    """Find translation t_i and scale s_i of every instance, and the table's scale.

    The world origin is on the floor under the table's centre; an object's z comes from lowering
    its mesh onto the mesh of what it stands on or in.

    Raises:
        SceneError: the top view shows no object.
    """
    config = config or AlignmentConfig()
    shown = imager.top_view(reference, instances, models, rotations, view)
    top_view = complete_boxes(shown, instances, segmenter)
    names = [i.name for i in instances if i.name != TABLE and i.name in top_view.boxes]
    yaws = {n: rotations[n].yaw if n in rotations else 0.0 for n in names}
    physical = {n: np.asarray(models[n].size) for n in names}
    boxes = {
        n: rectangle_box(np.asarray(top_view.boxes[n]), models[n].mesh, physical[n], yaws[n])
        for n in names
    }
    top = replace(top_view, boxes=boxes)
    scores = {
        n: rma_score(*pixel_area_and_ratio_error(top.boxes[n], physical[n], yaws[n]), config.tau)
        for n in names
    }
    warnings: list[str] = []
    anchor, alpha = _scale(top, scores, physical, yaws, sizes, config, warnings)
    modelled = reference.plan is None and TABLE in models
    usual = np.asarray(models[TABLE].size) if modelled else sizes[TABLE].extent
    table_scale = _table_scale(top, alpha, usual, modelled)
    stacking = dict(reasoner.stacking_order(reference, instances, view))
    limit = config.guess_limit if reference.plan is None else config.size_limit
    scales = {}
    for n in names:
        box = np.asarray(top.boxes[n])
        extent = own_extent((box[2:] - box[:2]) * alpha, yaws[n], physical[n])
        if sizes[n].measured:
            extent[2] = physical[n][2]
        scales[n] = _limited(n, extent, sizes[n].extent, limit, warnings)
    placements = _place(names, top, alpha, table_scale, yaws, scales, models, stacking)
    return Alignment(
        anchor, alpha, table_scale, placements, top_view, stacking, scores, tuple(warnings)
    )


def _scale(
    top: TopView,
    scores: Mapping[str, float],
    physical: Mapping[str, np.ndarray],
    yaws: Mapping[str, float],
    sizes: Mapping[str, SizePrior],
    config: AlignmentConfig,
    warnings: list[str],
) -> tuple[str, float]:
    """Return the anchor and alpha; anchors that make the table absurd are passed over.

    A top view of measured scale keeps it.
    """
    if top.metres_per_pixel is not None:
        return select_anchor(scores), top.metres_per_pixel
    box = np.asarray(top.table_box)
    length = float(np.sqrt(np.prod(box[2:] - box[:2])))
    usual = float(np.sqrt(np.prod(sizes[TABLE].extent[:2])))
    left = dict(scores)
    while left:
        anchor = select_anchor(left)
        alpha = metres_per_pixel(top.boxes[anchor], physical[anchor], yaws[anchor])
        if 1 / config.table_limit <= alpha * length / usual <= config.table_limit:
            return anchor, alpha
        warnings.append(f"{anchor}: its size would make the table {alpha * length:.2f} m across.")
        del left[anchor]
    anchor = select_anchor(scores)
    return anchor, usual / length


def _table_scale(
    top: TopView, alpha: float, usual: Float[np.ndarray, "3"], modelled: bool
) -> Float[np.ndarray, "3"]:
    """Rescale the table to its box.

    A table modelled from the picture keeps its proportions; the height of another follows at most
    a little (people keep theirs).
    """
    box = np.asarray(top.table_box)
    across = (box[2:] - box[:2]) * alpha
    factor = float(np.sqrt(across.prod() / np.prod(usual[:2])))
    return np.array([*across, usual[2] * (factor if modelled else np.clip(factor, 0.85, 1.15))])


def _limited(
    name: str,
    extent: Float[np.ndarray, "3"],
    usual: Float[np.ndarray, "3"],
    limit: float,
    warnings: list[str],
) -> Float[np.ndarray, "3"]:
    """Return the extent scaled to stay within ``limit`` of the usual, by the two longest sides.

    The third may be as thin as a picture shows it.
    """
    factor = float(np.sqrt(np.prod(np.sort(extent)[1:]) / np.prod(np.sort(usual)[1:])))
    allowed = float(np.clip(factor, 1 / limit, limit))
    if not np.isclose(allowed, factor):
        warnings.append(
            f"{name}: measured {factor:.2f} times its usual size, kept at {allowed:.2f} times."
        )
    return extent * (allowed / factor)


def _place(
    names: list[str],
    top: TopView,
    alpha: float,
    table_scale: Float[np.ndarray, "3"],
    yaws: Mapping[str, float],
    scales: Mapping[str, np.ndarray],
    models: Mapping[str, Model],
    stacking: Mapping[str, Stacking],
) -> tuple[Placement, ...]:
    """Put each object at its box's centre and lower it onto its support, supports first."""
    table = np.asarray(top.table_box)
    middle = (table[:2] + table[2:]) / 2
    bodies: dict[str, Body] = {}
    placed: dict[str, Placement] = {}
    for name in sorted(names, key=lambda n: stacking[n].order if n in stacking else 2):
        rank = stacking.get(name, Stacking(2))
        on = rank.on if rank.on in bodies else TABLE
        inside = rank.inside and on != TABLE
        box = np.asarray(top.boxes[name])
        xy = ((box[:2] + box[2:]) / 2 - middle) * alpha * [1, -1]
        if on != TABLE:
            reach = rotated_extent(scales[on], yaws[on]) / 2
            own = rotated_extent(scales[name], yaws[name]) / 2
            room = np.maximum(0.8 * reach - own, 0) if inside else 0.8 * reach
            at = bodies[on].position[:2]
            xy = at + np.clip(xy - at, -room, room)
        body = Body(models[name].mesh, scales[name], yaws[name], np.array([*xy, 0.0]))
        support = bodies.get(on)
        z = resting_height(body, support, float(table_scale[2]))
        bodies[name] = body.at_height(z)
        placed[name] = Placement(
            name, yaws[name], bodies[name].position, scales[name], on=on, inside=inside
        )
    return tuple(placed[name] for name in names)


# ------------------------------------------------------------- boxes in a top view drawn freely


def complete_boxes(top: TopView, instances: tuple[Instance, ...], segmenter: Segmenter) -> TopView:
    """Return the top view with a box for every instance that can be found in its picture.

    Detections are matched to instances of the same label, nearest relative position first; a
    wrong label costs more than any distance.

    Raises:
        SceneError: the picture shows no object.
    """
    missing = [i for i in instances if i.name != TABLE and i.name not in top.boxes]
    if not missing:
        return top
    labels = (TABLE, *dict.fromkeys(i.label for i in missing))
    found = segmenter.segment(np.asarray(top.image), labels)
    table = next((d for d in found if d.label == TABLE), None)
    things = [d for d in found if d.label != TABLE]
    if table is None or not things:
        raise SceneError("The top view shows no object on the table; draw it again.")
    frame = next(np.asarray(i.box) for i in instances if i.name == TABLE)
    cost = np.array([[_cost(i, frame, d, np.asarray(table.box)) for d in things] for i in missing])
    boxes = dict(top.boxes)
    for row, column in zip(*linear_sum_assignment(cost), strict=True):
        boxes[missing[row].name] = things[column].box
    table_box = top.table_box if top.boxes else table.box
    return replace(top, table_box=table_box, boxes=boxes)


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
