"""What candidates are compared with, and L_rot of Eq. 1 for objects of a scene, all at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float, Int

from ...backends.protocols import Encoder
from ...geometry import view_rotation
from ...scene import Instance, Model, View
from .config import RotationConfig
from .losses import (
    appearance_loss,
    contour_distance,
    edge_loss,
    rotation_loss,
    silhouette_loss,
)

if TYPE_CHECKING:
    from torch import Tensor

    from ...render.soft import Fit, Surface


@dataclass(frozen=True, eq=False)
class Target:
    """What the renders of ``s`` objects are compared with, in crops of one resolution.

    ``mask`` is S, softened like the renders; ``distance`` is D_S over ``edge_unit``; ``features``
    are Phi(I_instance); ``weight`` is how much each pixel counts, ``weights`` that at the
    features' sizes.
    """

    mask: Float[Tensor, "s h w"]
    distance: Float[Tensor, "s h w"]
    features: tuple[Float[Tensor, "s c h w"], ...]
    weight: Float[Tensor, "s h w"]
    weights: tuple[Float[Tensor, "s h w"], ...]


@dataclass(frozen=True, eq=False)
class Candidates:
    """Poses to compare: each one's object, yaw and tilt (radians), and place in its crop."""

    owner: Int[Tensor, "b"]
    yaw: Float[Tensor, "b"]
    tilt: Float[Tensor, "b"]
    fit: Fit | None = None


@dataclass(frozen=True, eq=False)
class Objective:
    """L_rot of Eq. 1 for ``s`` objects, each seen in its own place of the image.

    ``middle`` and ``span`` are the objects' boxes in x/z, y/z of the camera. ``loose`` marks those
    whose outline was completed by a guess: they may be shifted and scaled in their crops.
    """

    surface: Surface
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
        """Render the candidates and return each one's loss."""
        from ...render import soft

        owner, target = poses.owner, self.target
        rotation = soft.object_to_camera(poses.yaw, poses.tilt, self.world_to_camera)
        center = soft.fit_center(
            self.surface.corners[owner], rotation.detach(), self.middle[owner], self.span[owner]
        )
        images = soft.render(
            self.surface, rotation, center, target.mask.shape[-1], self.config.keep_aspect, owner,
            poses.fit,
        )  # fmt: skip
        weight = target.weight[owner]
        return rotation_loss(
            silhouette_loss(images.silhouette, target.mask[owner], weight),
            edge_loss(soft.sobel_edges(images.silhouette), target.distance[owner], weight),
            appearance_loss(
                self.encoder.features(images.image),
                tuple(level[owner] for level in target.features),
                tuple(level[owner] for level in target.weights),
            ),
            self.config,
        )


def make_target(
    instance: Instance,
    encoder: Encoder,
    config: RotationConfig,
    resolution: int,
    hidden: Bool[np.ndarray, "h w"] | None = None,
) -> Target:
    """Crop the completed instance tightly and prepare it for Eqs. 2 to 4.

    ``hidden`` marks the image's pixels where something else may hide the object.

    Raises:
        InputError: the instance's crop is wholly transparent.
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
    weight = torch.ones_like(soft[:, 3])
    if hidden is not None and config.unsure < 1:
        over = tight_crop(mask_in_crop(hidden, instance), tight, resolution, config.keep_aspect)
        weight = weight - (1 - config.unsure) * torch.as_tensor(over[..., 3])
    sizes = [level.shape[-2:] for level in features]
    weights = tuple(functional.interpolate(weight[None], s, mode="area")[0] for s in sizes)
    return Target(soft[:, 3], torch.as_tensor(distance)[None], features, weight, weights)


def make_objective(
    models: list[Model],
    instances: list[Instance],
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    image_size: tuple[int, int],
    seed: int = 0,
    hidden: list[Bool[np.ndarray, "h w"] | None] | None = None,
) -> tuple[Objective, Objective]:
    """Prepare Eq. 1 for objects of one image, coarsely and at full resolution.

    ``image_size`` is (width, height) of the reference image; ``hidden`` as in ``make_target``.
    """
    import torch

    from ...render.crop import in_reference, tight_box
    from ...render.soft import sample_surface, stack

    focal = image_size[1] / 2 / np.tan(view.fov / 2)
    boxes = np.array([in_reference(i, tight_box(i)) for i in instances])
    middle = ((boxes[:, :2] + boxes[:, 2:]) / 2 - np.array(image_size) / 2) / focal
    span = (boxes[:, 2:] - boxes[:, :2]) / focal
    surface = stack([sample_surface(m.mesh, m.size, config.points, seed) for m in models])
    masks = hidden or [None] * len(instances)

    def at(resolution: int, points: Surface) -> Objective:
        targets = [
            make_target(i, encoder, config, resolution, h)
            for i, h in zip(instances, masks, strict=True)
        ]

        def tensor(array: np.ndarray) -> Tensor:
            return torch.as_tensor(array, dtype=torch.float32, device=config.device)

        return Objective(
            points.to(config.device),
            _stacked(targets, config.device),
            encoder,
            config,
            tensor(view_rotation(view)),
            tensor(middle if config.perspective else 0 * middle),
            tensor(span),
            torch.tensor([config.refine_fit and i.occluded for i in instances]).to(config.device),
        )

    coarse = at(config.coarse_resolution, surface.thinned(config.thinning))
    return coarse, at(config.resolution, surface)


def _stacked(targets: list[Target], device: str) -> Target:
    import torch

    def joined(*tensors: Tensor) -> Tensor:
        return torch.cat(tensors).to(device)

    return Target(
        joined(*(t.mask for t in targets)),
        joined(*(t.distance for t in targets)),
        tuple(joined(*level) for level in zip(*(t.features for t in targets), strict=True)),
        joined(*(t.weight for t in targets)),
        tuple(joined(*level) for level in zip(*(t.weights for t in targets), strict=True)),
    )
