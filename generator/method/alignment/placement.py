"""TSA as a stage: the position and scale of every object from a top view."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from ...backends.protocols import Imager, PoseGuesser, Reasoner, Segmenter
from ...errors import BackendError, SceneError, require
from ...geometry import rotated_extent
from ...render.contact import at_rest
from ...scene import (
    TABLE,
    Detection,
    Instance,
    Model,
    Placement,
    Reference,
    Rotation,
    SizePrior,
    Stacking,
    TopView,
    View,
)
from .equations import (
    metres_per_pixel,
    own_extent,
    pixel_area_and_ratio_error,
    rectangle_box,
    rma_score,
    select_anchor,
)
from .top_view_check import check_top_view


def complete_boxes(
    top: TopView, instances: tuple[Instance, ...], segmenter: Segmenter
) -> tuple[TopView, tuple[str, ...]]:
    """Return the top view with a box for every instance that is visible in its picture.

    Detections are matched to instances with the same label, starting with the nearest relative
    positions; a wrong label costs more than any distance. Detections without a match are dropped
    with a warning.

    Raises:
        SceneError: no object is visible in the picture.
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
        raise SceneError("The top view shows no object on the table. Draw it again.")
    table = np.asarray(tables[0])
    frame = next(np.asarray(i.box) for i in instances if i.name == TABLE)
    cost = np.array([[_cost(i, frame, d, table) for d in things] for i in missing])
    boxes = dict(top.boxes)
    rows, columns = linear_sum_assignment(cost)
    for row, column in zip(map(int, rows), map(int, columns), strict=True):
        boxes[missing[row].name] = things[column].box
    extra = len(things) - len(columns)
    message = (
        f"The top view shows {extra} more objects than the picture; these objects are ignored."
    )
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


@dataclass(frozen=True)
class AlignmentConfig:
    """Settings of TSA.

    Attributes:
        tau: tolerance of the aspect ratio in the RMA-Score (Eq. 6; the paper's 0.25).
        size_limit: maximum factor between an object's scale and its commonsense size, in both
            directions.
        guess_limit: the same limit for a picture without a text, for which the names, and therefore
            the commonsense sizes, are guesses.
        table_limit: an anchor is skipped if it would make the table larger or smaller than its
            commonsense size by this factor.
        check: whether to compare the top view with the reference picture. Objects that an image
            model moved or drew far too large or too small are then corrected by geometry. The paper
            has no such check. Missing objects are added by geometry in either case.
    """

    tau: float = 0.25
    size_limit: float = 1.6
    guess_limit: float = 4.0
    table_limit: float = 2.0
    check: bool = True

    def __post_init__(self) -> None:
        require(self, "tau", above=0)
        require(self, "size_limit", "guess_limit", "table_limit", minimum=1, allow_inf=True)


@dataclass(frozen=True, eq=False)
class Alignment:
    """The result of TSA (Fig. 14).

    ``placements`` are the placements of the objects, in the order of the instances and without the
    table; ``table_scale`` is the table's extent in metres; ``scores`` holds the RMA-Score of each
    object. If TSA is disabled (Sec. 4.3), the anchor, the scale and the top view are None, and
    there are no scores.
    """

    anchor: str | None
    metres_per_pixel: float | None
    table_scale: Float[np.ndarray, "3"]
    placements: tuple[Placement, ...]
    top_view: TopView | None
    stacking: Mapping[str, Stacking]
    scores: Mapping[str, float]
    warnings: tuple[str, ...] = ()


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
    """Estimate the translation t_i and scale s_i of every instance, and the table's scale.

    The world origin is on the floor under the table's centre. The z coordinate of an object is
    found by lowering its mesh onto the mesh of its support.

    Raises:
        SceneError: no object is visible in the top view.
    """
    config = config or AlignmentConfig()
    shown = imager.top_view(reference, instances, models, rotations, view)
    stacking = dict(reasoner.stacking_order(reference, instances, view))
    top_view, messages = complete_boxes(shown, instances, segmenter)
    height, width = reference.image.shape[:2]
    top_view, repairs = check_top_view(
        top_view, instances, models, rotations, stacking, view, (width, height),
        only_missing=not config.check,
    )  # fmt: skip
    warnings = [*shown.warnings, *messages, *repairs]
    names = [i.name for i in instances if i.name != TABLE]
    yaws = {n: rotations[n].yaw if n in rotations else 0.0 for n in names}
    physical = {n: np.asarray(models[n].size) for n in names}
    top = replace(top_view, boxes={
        n: rectangle_box(np.asarray(top_view.boxes[n]), models[n].mesh, physical[n], yaws[n])
        for n in names
    })  # fmt: skip
    scores = {
        n: rma_score(*pixel_area_and_ratio_error(top.boxes[n], physical[n], yaws[n]), config.tau)
        for n in names
    }
    anchor, alpha = _scale(top, scores, physical, yaws, sizes, config, warnings)
    modelled = reference.plan is None and TABLE in models
    usual = np.asarray(models[TABLE].size) if modelled else sizes[TABLE].extent
    table_scale = _table_scale(top, alpha, usual, modelled)
    limit = config.guess_limit if reference.plan is None else config.size_limit
    scales: dict[str, np.ndarray] = {}
    for n in names:
        box = np.asarray(top.boxes[n])
        extent = own_extent((box[2:] - box[:2]) * alpha, yaws[n], physical[n])
        if sizes[n].measured:
            extent[2] = physical[n][2]
        scales[n] = _limit(n, extent, sizes[n].extent, limit, warnings)
    centers = _centers(top, alpha)
    placements = place_objects(names, centers, table_scale, yaws, scales, models, stacking)
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
    """Return the anchor and alpha, skipping anchors that imply an implausible table size."""
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
    """Scale the table to its top-view box; the height changes little unless it is ``modelled``."""
    box = np.asarray(top.table_box)
    across = (box[2:] - box[:2]) * alpha
    factor = float(np.sqrt(across.prod() / np.prod(usual[:2])))
    return np.array([*across, usual[2] * (factor if modelled else np.clip(factor, 0.85, 1.15))])


def _limit(
    name: str,
    extent: Float[np.ndarray, "3"],
    usual: Float[np.ndarray, "3"],
    limit: float,
    warnings: list[str],
) -> Float[np.ndarray, "3"]:
    """Return the extent with the two longest sides within a factor ``limit`` of the usual ones."""
    factor = float(np.sqrt(np.prod(np.sort(extent)[1:]) / np.prod(np.sort(usual)[1:])))
    allowed = float(np.clip(factor, 1 / limit, limit))
    if not np.isclose(allowed, factor):
        warnings.append(
            f"{name}: measured {factor:.2f} times its usual size, limited to {allowed:.2f} times."
        )
    return extent * (allowed / factor)


def _centers(top: TopView, alpha: float) -> dict[str, Float[np.ndarray, "2"]]:
    """Return the boxes' centres relative to the table's centre, in metres along world x and y."""
    middle = np.asarray(top.table_box).reshape(2, 2).mean(0)
    return {
        name: (np.asarray(box).reshape(2, 2).mean(0) - middle) * alpha * [1, -1]
        for name, box in top.boxes.items()
    }


def place_objects(
    names: list[str],
    centers: Mapping[str, Float[np.ndarray, "2"]],
    table_scale: Float[np.ndarray, "3"],
    yaws: Mapping[str, float],
    scales: Mapping[str, np.ndarray],
    models: Mapping[str, Model],
    stacking: Mapping[str, Stacking],
) -> tuple[Placement, ...]:
    """Place each object, supports first, at its centre and lower it onto its support."""
    found: dict[str, Placement] = {}
    for name in sorted(names, key=lambda n: stacking[n].order if n in stacking else 2):
        rank = stacking.get(name, Stacking(2))
        on = rank.on if rank.on in found else TABLE
        inside = rank.inside and on != TABLE
        xy = centers[name]
        if on != TABLE:
            reach = rotated_extent(scales[on], yaws[on]) / 2
            own = rotated_extent(scales[name], yaws[name]) / 2
            room = np.maximum(0.8 * reach - own, 0) if inside else 0.8 * reach
            at = found[on].translation[:2]
            xy = at + np.clip(xy - at, -room, room)
        position = np.array([*xy, 0.0])
        found[name] = Placement(name, yaws[name], position, scales[name], on=on, inside=inside)
    return at_rest([found[name] for name in names], models, float(table_scale[2]))


def ask_layout(
    reference: Reference,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    sizes: Mapping[str, SizePrior],
    rotations: Mapping[str, Rotation],
    view: View,
    reasoner: Reasoner,
    guesser: PoseGuesser,
) -> Alignment:
    """Return an alignment with the reasoner's positions and scales, and a table of the usual size.

    The reasoner also determines the supports, as in TSA, so only x, y and the sizes differ from
    TSA. There is no anchor and no top view.

    Raises:
        BackendError: an answer is missing.
    """
    guesses = guesser.guess_layout(reference, instances, sizes, view)
    stacking = dict(reasoner.stacking_order(reference, instances, view))
    names = [i.name for i in instances if i.name != TABLE]
    for name in names:
        if name not in guesses:
            raise BackendError(
                f"guess_layout: {type(guesser).__name__} returned no position for {name!r}."
            )
    yaws = {n: rotations[n].yaw if n in rotations else 0.0 for n in names}
    centers = {n: guesses[n].center for n in names}
    scales = {n: guesses[n].size for n in names}
    table_scale = sizes[TABLE].extent
    placements = place_objects(names, centers, table_scale, yaws, scales, models, stacking)
    return Alignment(None, None, table_scale, placements, None, stacking, {})
