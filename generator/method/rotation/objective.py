"""The images to which renders are compared, and the loss L_rot (Eq. 1) of all objects at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float, Int

from ...backends.protocols import Encoder
from ...errors import InputError
from ...geometry import view_rotation
from ...scene import Instance, Model, View
from .config import RotationConfig
from .equations import appearance_loss, contour_distance, edge_loss, rotation_loss, silhouette_loss

if TYPE_CHECKING:
    from torch import Tensor

    from ...render.soft import CropFit, SampledSurface, SoftImages

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...render.soft import CropFit


_NEAR_SIDE = 0.04  # distance from the box's side within which occlusion counts, fraction of crop
_TOUCH = 0.08  # minimum fraction of a side that is occluded


@dataclass(frozen=True, eq=False)
class Target:
    """The images to which the renders of ``s`` objects are compared, as crops of one resolution.

    ``image`` is the crop over grey and ``mask`` is S, both smoothed like the renders; ``distance``
    is D_S divided by ``edge_unit``; ``features`` are Phi(I_instance); ``weight`` is the weight of
    each pixel, and ``weights`` are the same at the features' resolutions. ``cut`` marks the sides
    of the box (left, top, right, bottom) at which the object may be occluded and may therefore
    extend beyond the box.
    """

    image: Float[Tensor, "s 3 h w"]
    mask: Float[Tensor, "s h w"]
    distance: Float[Tensor, "s h w"]
    features: tuple[Float[Tensor, "s c h w"], ...]
    weight: Float[Tensor, "s h w"]
    weights: tuple[Float[Tensor, "s h w"], ...]
    cut: Bool[Tensor, "s 4"]


@dataclass(frozen=True, eq=False)
class Candidates:
    """Poses to compare, each with an object index, yaw and tilt in radians, and a crop position."""

    owner: Int[Tensor, "b"]
    yaw: Float[Tensor, "b"]
    tilt: Float[Tensor, "b"]
    fit: CropFit | None = None


@dataclass(frozen=True, eq=False)
class Objective:
    """The loss L_rot (Eq. 1) of ``s`` objects, each seen at its own position in the image.

    ``middle`` and ``span`` are the centres and sizes of the objects' boxes in the camera's x/z,
    y/z. ``loose`` marks objects whose outline was completed by a guess; they may be shifted and
    scaled in their crops.
    """

    surface: SampledSurface
    target: Target
    encoder: Encoder
    config: RotationConfig
    world_to_camera: Float[Tensor, "3 3"]
    middle: Float[Tensor, "s 2"]
    span: Float[Tensor, "s 2"]
    loose: Bool[Tensor, "s"]

    def __len__(self) -> int:
        return len(self.middle)

    def __call__(self, poses: Candidates) -> Float[Tensor, "b"]:
        """Render the candidates and return the loss of each."""
        return self.compare(self.render(poses), self.target, poses.owner)

    def place(self, poses: Candidates) -> tuple[Float[Tensor, "b 3 3"], Float[Tensor, "b 3"]]:
        """Return the candidates' object-to-camera rotations, and their centres in metres."""
        from ...render import soft

        owner = poses.owner
        rotation = soft.object_to_camera(poses.yaw, poses.tilt, self.world_to_camera)
        center = soft.fit_center(
            self.surface.corners[owner], rotation, self.middle[owner], self.span[owner]
        )
        return rotation, center

    def render(self, poses: Candidates) -> SoftImages:
        """Draw the candidates, each in its own crop."""
        from ...render import soft

        return soft.render(
            self.surface, *self.place(poses), self.target.mask.shape[-1],
            self.config.keep_aspect, poses.owner, poses.fit, normals=self.config.relight,
        )  # fmt: skip

    def compare(
        self, images: SoftImages, target: Target, owner: Int[Tensor, "b"]
    ) -> Float[Tensor, "b"]:
        """Return the loss (Eq. 1) of each render against the target whose index is in ``owner``."""
        from ...render import soft
        from ...render.relight import relit

        weight, image = target.weight[owner], images.image
        if self.config.relight:
            image = relit(images, target.image[owner], weight * target.mask[owner].square())
        return rotation_loss(
            silhouette_loss(images.silhouette, target.mask[owner], weight),
            edge_loss(soft.sobel_edges(images.silhouette), target.distance[owner], weight),
            appearance_loss(
                self.encoder.features(image),
                tuple(level[owner] for level in target.features),
                tuple(level[owner] for level in target.weights),
            ),
            self.config,
        )


@dataclass(frozen=True, eq=False)
class Levels:
    """Objectives of the same objects at three resolutions; ``close()`` builds one on first use."""

    coarse: Objective
    fine: Objective
    close: Callable[[], Objective]


def make_target(
    instance: Instance,
    encoder: Encoder,
    config: RotationConfig,
    resolution: int,
    hidden: Bool[np.ndarray, "h w"] | None = None,
) -> Target:
    """Crop the completed instance tightly and prepare it for Eqs. 2 to 4.

    ``hidden`` marks the image's pixels where the object may be occluded.

    Raises:
        InputError: the instance's crop is fully transparent.
    """
    import torch
    from torch.nn import functional

    from ...render.crop import mask_in_crop, tight_box, tight_crop
    from ...render.soft import smooth

    tight = tight_box(instance)
    rgba = tight_crop(instance.crop, tight, resolution, config.keep_aspect)
    pixels = torch.as_tensor(rgba).permute(2, 0, 1)[None]
    soft = smooth(pixels)
    image = soft[:, :3] + 0.5 * (1 - soft[:, 3:])
    distance = contour_distance(rgba[..., 3] > 0.5) / (config.edge_unit * resolution)
    with torch.no_grad():
        features = encoder.features(image)
    weight, cut = torch.ones_like(soft[:, 3]), np.zeros(4, bool)
    if hidden is not None and config.unsure < 1:
        rgba = tight_crop(mask_in_crop(hidden, instance), tight, resolution, config.keep_aspect)
        over = np.ascontiguousarray(rgba[..., 3])
        weight = weight - (1 - config.unsure) * torch.as_tensor(over)
        if config.keep_aspect:
            cut = cut_sides(over > 0.5, tight)
    sizes = [level.shape[-2:] for level in features]
    weights = tuple(functional.interpolate(weight[None], s, mode="area")[0] for s in sizes)
    return Target(image, soft[:, 3], torch.as_tensor(distance)[None], features, weight, weights,
                  torch.as_tensor(cut)[None])  # fmt: skip


def cut_sides(
    hidden: Bool[np.ndarray, "r r"], box: Float[np.ndarray, "4"]
) -> Bool[np.ndarray, "4"]:
    """Return which sides (left, top, right, bottom) of the tight crop of ``box`` are occluded."""
    from ...render.crop import MARGIN

    side = len(hidden)
    half = side * (0.5 - MARGIN) * (box[2:] - box[:2]) / (box[2:] - box[:2]).max()
    x0, y0, x1, y1 = np.round(np.concatenate([side / 2 - half, side / 2 + half])).astype(int)
    x1, y1 = max(x1, x0 + 1), max(y1, y0 + 1)
    near = round(_NEAR_SIDE * side)
    strips = (
        hidden[y0:y1, max(x0 - near, 0) : x0 + near].any(1),
        hidden[max(y0 - near, 0) : y0 + near, x0:x1].any(0),
        hidden[y0:y1, x1 - near : x1 + near].any(1),
        hidden[y1 - near : y1 + near, x0:x1].any(0),
    )
    return np.array([float(strip.mean()) > _TOUCH for strip in strips])


def make_objectives(
    models: list[Model],
    instances: list[Instance],
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    image_size: tuple[int, int],
    seed: int = 0,
    hidden: list[Bool[np.ndarray, "h w"] | None] | None = None,
) -> Levels:
    """Prepare the objectives (Eq. 1) of one image's objects at the configured resolutions.

    ``image_size`` is (width, height) of the reference image; ``hidden`` is as in ``make_target``.

    Raises:
        InputError: torch does not have the configured device; a crop or a mesh is empty.
    """
    import torch

    from ...render.crop import in_reference, tight_box
    from ...render.soft import sample_surface, stack

    device, count = torch.device(config.device), torch.cuda.device_count()
    if device.type == "cuda" and (device.index or 0) >= count:
        raise InputError(
            f"RotationConfig.device is {config.device!r}, but torch finds {count} CUDA GPUs. Use "
            "'cpu', or install torch with CUDA."
        )

    focal = image_size[1] / 2 / np.tan(view.fov / 2)
    boxes = np.array([in_reference(i, tight_box(i)) for i in instances])
    middle = ((boxes[:, :2] + boxes[:, 2:]) / 2 - np.array(image_size) / 2) / focal
    span = (boxes[:, 2:] - boxes[:, :2]) / focal
    masks = hidden or [None] * len(instances)
    loose = config.refine_fit and config.max_fit > 0

    def sample(points: int) -> SampledSurface:
        return stack([sample_surface(m.mesh, m.size, points, seed) for m in models])

    def at(resolution: int, points: SampledSurface) -> Objective:
        pairs = zip(instances, masks, strict=True)
        targets = [make_target(i, encoder, config, resolution, h) for i, h in pairs]

        def tensor(array: np.ndarray) -> Tensor:
            return torch.as_tensor(array, dtype=torch.float32, device=config.device)

        return Objective(
            points.to(config.device), _stack(targets, config.device), encoder, config,
            tensor(view_rotation(view)), tensor(middle if config.perspective else 0 * middle),
            tensor(span), torch.tensor([loose and i.occluded for i in instances]).to(config.device),
        )  # fmt: skip

    surface = sample(config.points)
    return Levels(
        at(config.coarse_resolution, surface.thin(config.thinning)),
        at(config.resolution, surface),
        cache(lambda: at(config.close_resolution, sample(config.close_points))),
    )


def _stack(targets: list[Target], device: str) -> Target:
    import torch

    def join(values: Sequence[Any]) -> Any:
        if isinstance(values[0], tuple):
            return tuple(join(level) for level in zip(*values, strict=True))
        return torch.cat(list(values)).to(device)

    return Target(*(join([getattr(t, field.name) for t in targets]) for field in fields(Target)))


LEFT, TOP, RIGHT, BOTTOM = range(4)

_MOST = 0.3  # limit of the change of size, and of position as a fraction of the crop's side


def reaching_past(objective: Objective, poses: Candidates, side: int) -> CropFit:
    """Return the shift and zoom at which candidates fit their boxes on all sides except ``side``.

    The two sides adjacent to it determine the size; the opposite side determines the position. A
    candidate that would end inside its box, or extend far beyond it, is fitted tightly instead.
    """
    import torch

    from ...render.crop import MARGIN
    from ...render.soft import CropFit, bounds

    owner = poses.owner
    low, high = bounds(objective.surface.corners[owner], *objective.place(poses))
    own, box = high - low, objective.span[owner]
    inner = 1 - 2 * MARGIN
    own = inner * own / own.amax(1, keepdim=True)  # as fractions of the crop's side
    box = inner * box / box.amax(1, keepdim=True)
    along, across = (1, 0) if side in (LEFT, RIGHT) else (0, 1)
    zoom = (box[:, along] / own[:, along]).log()
    past = own[:, across] * zoom.exp() - box[:, across]
    usable = (past > 0) & (past < _MOST) & (zoom.abs() < _MOST)
    past, zoom = (torch.where(usable, value, 0.0) for value in (past, zoom))
    shift = torch.zeros_like(own)
    shift[:, across] = past / 2 if side in (RIGHT, BOTTOM) else -past / 2
    return CropFit(shift, zoom)
