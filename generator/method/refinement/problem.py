"""Settings and tensors of the joint refinement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ...geometry import Camera, view_rotation
from ...scene import Instance, Mesh, Model, Placement, View
from .clearance import Crowd, make_crowd

if TYPE_CHECKING:
    from torch import Tensor

    from ...render.soft import SampledSurface


from ...errors import require


@dataclass(frozen=True, eq=False)
class ObservedThings:
    """Visible outlines of ``n`` objects in tight crops, and the camera's direction.

    ``middle`` holds the crops' centres in the camera's x/z, y/z; ``scale`` is in pixels per unit of
    these.
    """

    mask: Float[Tensor, "n r r"]
    weight: Float[Tensor, "n r r"]
    middle: Float[Tensor, "n 2"]
    scale: Float[Tensor, "n 1"]
    rotation: Float[Tensor, "3 3"]


@dataclass(frozen=True, eq=False)
class PosedThings:
    """Surfaces and poses of ``n`` objects: yaw (radians) and box centre (metres)."""

    surface: SampledSurface
    yaw: Float[Tensor, "n"]
    place: Float[Tensor, "n 3"]


@dataclass(frozen=True, eq=False)
class Links:
    """How the motion and growth of objects (columns) affect the objects on them (rows).

    ``carries`` is 1 for an object itself and for all of its supports. ``lifts`` is how much their
    growth lifts the object's centre: half of its own height, and the heights of its supports unless
    it is inside them.
    """

    carries: Float[Tensor, "n n"]
    lifts: Float[Tensor, "n n"]


@dataclass(frozen=True, eq=False)
class Problem:
    """All inputs of the loss for ``n`` objects."""

    seen: ObservedThings
    posed: PosedThings
    links: Links
    crowd: Crowd


def make_seen(
    things: Sequence[Instance],
    all_things: Sequence[Instance],
    view: View,
    image_size: tuple[int, int],
    config: RefinementConfig,
) -> ObservedThings:
    """Return the visible outlines of objects, which any of ``all_things`` may occlude."""
    from ...render.crop import MARGIN, hiders, in_reference, mask_in_crop, tight_box, tight_crop
    from ...render.soft import smooth

    size = config.resolution
    tight = [tight_box(i) for i in things]
    boxes = np.array([in_reference(i, t) for i, t in zip(things, tight, strict=True)])
    eye = Camera(np.zeros(3), view_rotation(view), view.fov, *image_size)
    masks = [tight_crop(i.crop, t, size)[..., 3] for i, t in zip(things, tight, strict=True)]
    weights = np.ones((len(things), size, size), np.float32)
    for weight, thing, box in zip(weights, things, tight, strict=True):
        if (hidden := hiders(thing, all_things)) is not None:
            over = tight_crop(mask_in_crop(hidden, thing), box, size)[..., 3]
            weight -= (1 - config.unsure) * over
    span = (boxes[:, 2:] - boxes[:, :2]).max(1) / eye.focal
    return ObservedThings(
        smooth(tensor(masks)[:, None])[:, 0],
        tensor(weights),
        tensor(((boxes[:, :2] + boxes[:, 2:]) / 2 - eye.center) / eye.focal),
        tensor(size * (1 - 2 * MARGIN) / span[:, None]),
        tensor(view_rotation(view)),
    )


def make_problem(
    seen: ObservedThings,
    moving: Sequence[Placement],
    placements: Sequence[Placement],
    models: Mapping[str, Model],
    table_scale: Float[np.ndarray, "3"],
    config: RefinementConfig,
    seed: int,
) -> Problem:
    """Return the problem for the ``moving`` objects, which are some or all of the placed ones."""
    below = {p.name: p for p in placements}
    chains = [[q.name for q in _chain(p, below)] for p in moving]
    crowd = make_crowd(moving, chains, models, table_scale)
    posed = pose_placements(moving, models, config, seed)
    return Problem(seen, posed, make_links(moving, placements), crowd)


def make_links(moving: Sequence[Placement], placements: Sequence[Placement]) -> Links:
    """Return how the ``moving`` objects (some or all of the placed ones) affect those on them."""
    below = {p.name: p for p in placements}
    rows = {p.name: k for k, p in enumerate(moving)}
    carries, lifts = np.eye(len(moving)), np.diag([p.scale[2] / 2 for p in moving])
    for k, thing in enumerate(moving):
        inside = thing.inside
        for p in _chain(thing, below):
            if p.name in rows:
                carries[k, rows[p.name]] = 1.0
                lifts[k, rows[p.name]] = 0.0 if inside else p.scale[2]
            inside = p.inside
    return Links(tensor(carries), tensor(lifts))


def pose_placements(
    placements: Sequence[Placement],
    models: Mapping[str, Model],
    config: RefinementConfig,
    seed: int,
) -> PosedThings:
    """Return placed objects, with points sampled from their models."""
    meshes, scales = [models[p.name].mesh for p in placements], [p.scale for p in placements]
    places = np.array([p.translation for p in placements])
    return make_posed(meshes, scales, [p.yaw for p in placements], places, config, seed)


def make_posed(
    meshes: Sequence[Mesh],
    scales: Sequence[Float[np.ndarray, "3"]],
    yaws: Sequence[float],
    places: Float[np.ndarray, "n 3"],
    config: RefinementConfig,
    seed: int,
) -> PosedThings:
    """Return posed objects, with points sampled from their surfaces."""
    from ...render.soft import sample_surface, stack

    pairs = zip(meshes, scales, strict=True)
    surfaces = [sample_surface(mesh, scale, config.points, seed) for mesh, scale in pairs]
    return PosedThings(stack(surfaces), tensor(yaws), tensor(places))


def standpoint(seen: ObservedThings, posed: PosedThings) -> Float[Tensor, "3"]:
    """Return the camera position, for a given direction, that centres the objects in their crops.

    The position minimises the squared distances of the objects' centres from their rays.
    """
    rays = np.column_stack([seen.middle.numpy(), np.ones(len(seen.middle))]) @ seen.rotation.numpy()
    rays = rays.astype(float) / np.linalg.norm(rays, axis=1, keepdims=True)
    across = np.eye(3) - rays[:, :, None] * rays[:, None]
    points = posed.place.numpy().astype(float)
    left, right = np.asarray(across.sum(0)), np.asarray((across @ points[..., None]).sum(0))[:, 0]
    return tensor(np.linalg.lstsq(left, right, rcond=None)[0])


def tensor(array: object) -> Tensor:
    """Return numbers as a single-precision torch tensor."""
    import torch

    return torch.as_tensor(np.asarray(array), dtype=torch.float32)


def _chain(placement: Placement, below: Mapping[str, Placement]) -> list[Placement]:
    """Return an object's support, the support of that support, and so on down to the table."""
    chain: list[Placement] = []
    while placement.on in below and below[placement.on] not in chain:
        placement = below[placement.on]
        chain.append(placement)
    return chain


@dataclass(frozen=True)
class RefinementConfig:
    """Settings of the refinement that fits all objects and the camera jointly to the masks.

    Attributes:
        steps: number of Adam steps; 0 disables the refinement.
        learning_rate: Adam's initial step, in units of the scales below; it decays to zero.
        turn, move, grow: typical errors of yaw (radians), position (metres) and size (logarithm). A
            quantity whose error is 0 is fixed.
        resolution: side of the compared crops, pixels.
        points: number of surface points sampled per object.
        unsure: weight of the pixels where another instance may occlude this one.
    """

    steps: int = 40
    learning_rate: float = 0.15
    turn: float = float(np.deg2rad(3.0))
    move: float = 0.015
    grow: float = 0.04
    resolution: int = 64
    points: int = 2500
    unsure: float = 0.2

    def __post_init__(self) -> None:
        require(self, "steps", minimum=0, integer=True)
        require(self, "learning_rate", above=0)
        require(self, "turn", "move", "grow", minimum=0)
        require(self, "resolution", minimum=16, integer=True)
        require(self, "points", minimum=100, integer=True)
        require(self, "unsure", minimum=0, maximum=1)
