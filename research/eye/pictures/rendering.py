"""From a seed to a finished sample: stage, draw, read the ground truth, post-process."""

from __future__ import annotations

import dataclasses

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int

from generator.geometry import Camera

from ..sample import BACKGROUND, OBJECT, TABLE_REST, TOP, Sample, fill
from . import finishing
from .gl import GlPainter, PlacedMesh
from .staging import Staging, backdrop_board, stage
from .supply import Supply

_LEAST = 12  # minimum visible pixels of an instance


def render_sample(rng: np.random.Generator, supply: Supply, painter: GlPainter) -> Sample:
    """Return one random sample drawn by ``painter``, which holds the supply's stock."""
    while True:
        staging = stage(rng, supply, painter.side)
        sample = draw(rng, staging, supply, painter)
        if (sample.region != BACKGROUND).mean() > 0.04:
            return sample


def draw(rng: np.random.Generator, staging: Staging, supply: Supply, painter: GlPainter) -> Sample:
    """Return the finished sample of a staged scene."""
    camera = staging.camera
    painter.hang(staging.backdrop)
    board = backdrop_board(camera, supply.stock.backdrop)
    solid = [*staging.objects, *staging.tabletop, *staging.surroundings]
    ids, depth = painter.ids(solid, camera)
    image = painter.picture([*solid, board], camera, staging.lamps, rng)
    n, t = len(staging.objects), len(staging.tabletop)
    visible = np.where((ids >= 0) & (ids < n), ids + 1, 0)
    on_table = (ids >= n) & (ids < n + t)
    outline = _project(staging.outline, camera)
    top = fill(outline, painter.side, painter.side)
    if staging.mirror > 0:
        image = _reflect(rng, image, on_table & top, staging, board, painter)
    full = painter.silhouettes(staging.objects, _boxes(staging, supply), camera)
    region = np.full(ids.shape, BACKGROUND, np.uint8)
    region[on_table] = TABLE_REST
    region[on_table & top] = TOP
    region[visible > 0] = OBJECT
    if staging.cartoon:
        image = finishing.cartoon(rng, image, *_ink(staging, ids, depth))
    clean = staging.setting == "white" or staging.cartoon
    picture = finishing.develop(rng, image, clean)
    kept, visible = _keep_shown(visible, full)
    lost = (region == OBJECT) & (visible == 0)
    region[lost] = np.where(top[lost], TOP, BACKGROUND)
    return _sample(staging, supply, picture, visible, full, kept, region, top, outline, depth)


def _ink(
    staging: Staging, ids: Int[np.ndarray, "h w"], depth: Float[np.ndarray, "h w"]
) -> tuple[Int[np.ndarray, "h w"], Float[np.ndarray, "h w"]]:
    """Return ids and depth for ink edges: the table is one object, a white floor none."""
    n = len(staging.objects)
    end = n + len(staging.tabletop)
    ids = np.where((ids >= n) & (ids < end), n, ids)
    if staging.setting != "white":
        return ids, depth
    return np.where(ids >= end, -1, ids), np.where(ids >= end, np.inf, depth)


def _sample(
    staging: Staging,
    supply: Supply,
    picture: np.ndarray,
    visible: Int[np.ndarray, "h w"],
    full: Bool[np.ndarray, "n h w"],
    kept: list[int],
    region: np.ndarray,
    top: Bool[np.ndarray, "h w"],
    outline: Float[np.ndarray, "k 2"],
    depth: Float[np.ndarray, "h w"],
) -> Sample:
    placed = [staging.placed[k] for k in kept]
    number = {0: 0, **{k + 1: j + 1 for j, k in enumerate(kept)}}
    return Sample(
        image=picture,
        visible=visible.astype(np.uint8),
        full=full[kept],
        category=np.array([supply.categories[p.model] for p in placed], np.int16),
        region=region,
        top=top,
        outline=outline.astype(np.float32),
        view=staging.view,
        focal=staging.camera.focal,
        yaw=np.array([p.yaw for p in placed], np.float32),
        upright=np.array([p.upright for p in placed], bool),
        size=np.array([p.size for p in placed], np.float32).reshape(-1, 3),
        position=np.array([p.position for p in placed], np.float32).reshape(-1, 3),
        support=np.array([number.get(p.support, -1) for p in placed], np.int16),
        depth=depth.astype(np.float16),
    )


def _keep_shown(
    visible: Int[np.ndarray, "h w"], full: Bool[np.ndarray, "n h w"]
) -> tuple[list[int], Int[np.ndarray, "h w"]]:
    """Return the sufficiently visible instances, and the index map renumbered to them.

    Two drawings of an edge may differ by a pixel; visible pixels are added to the whole mask.
    """
    counts = np.bincount(visible.ravel(), minlength=len(full) + 1)[1:]
    kept = [k for k in range(len(full)) if counts[k] >= _LEAST]
    number = np.zeros(len(full) + 1, np.int64)
    for j, k in enumerate(kept):
        number[k + 1] = j + 1
        full[k] |= visible == k + 1
    return kept, number[visible]


def _boxes(staging: Staging, supply: Supply) -> Float[np.ndarray, "n 4"]:
    """Return pixel boxes that contain each object's projection."""
    boxes = np.zeros((len(staging.placed), 4))
    for k, placed in enumerate(staging.placed):
        corners = np.stack(np.meshgrid(*[[-0.5, 0.5]] * 3), -1).reshape(-1, 3) * placed.size
        corners = corners @ placed.rotation.T + placed.position
        if (staging.camera.to_camera(corners)[:, 2] < 0.05).any():
            boxes[k] = [-1e6, -1e6, 1e6, 1e6]
            continue
        pixels = staging.camera.project(corners)
        boxes[k] = [*(pixels.min(0) - 2), *(pixels.max(0) + 2)]
    return boxes


def _project(corners: Float[np.ndarray, "k 3"], camera: Camera) -> Float[np.ndarray, "m 2"]:
    """Return a convex polygon's pixels, clipped near the camera."""
    near = 0.02
    depth = camera.to_camera(corners)[:, 2] - near
    cut = []
    for k in range(len(corners)):
        j = (k + 1) % len(corners)
        if depth[k] >= 0:
            cut.append(corners[k])
        if (depth[k] >= 0) != (depth[j] >= 0):
            share = depth[k] / (depth[k] - depth[j])
            cut.append(corners[k] + share * (corners[j] - corners[k]))
    return camera.project(np.array(cut)) if len(cut) >= 3 else np.zeros((0, 2))


def _reflect(
    rng: np.random.Generator,
    image: Float[np.ndarray, "h w 3"],
    shiny: Bool[np.ndarray, "h w"],
    staging: Staging,
    board: PlacedMesh,
    painter: GlPainter,
) -> Float[np.ndarray, "h w 3"]:
    """Return the picture with a faint reflection of the objects in the tabletop."""
    height = staging.outline[0, 2]
    flip = np.diag([1.0, 1.0, -1.0])
    under = [
        dataclasses.replace(
            thing,
            linear=flip @ thing.linear,
            position=flip @ thing.position + [0, 0, 2 * height],
            color=(*thing.color[:3], 1.0),
        )
        for thing in staging.objects
    ]
    seen = painter.picture([*under, board], staging.camera, staging.lamps, rng, passes=1)
    seen = cv2.GaussianBlur(seen, (0, 0), float(rng.uniform(0.5, 3)))
    ids, _ = painter.ids([*under, board], staging.camera)
    soft = cv2.GaussianBlur((shiny & (ids < len(under)) & (ids >= 0)).astype(np.float32), (0, 0), 1)
    weight = (soft * shiny * staging.mirror)[..., None]
    return image * (1 - weight) + seen * weight
