"""Sec. 3.3, Differentiable Rotation Optimizer (DRO): each object's yaw r_i, Eqs. 1 to 4.

Every candidate yaw is rendered softly, cropped tightly and compared with the tight crop of the
completed instance: a coarse search over the whole turn, then Adam on the best candidates, all of
them in one tensor.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from ..backends.protocols import Encoder
from ..errors import InputError
from ..geometry import mask_box, view_rotation, wrap
from ..scene import TABLE, Instance, Model, Reference, Rotation, View

if TYPE_CHECKING:
    from torch import Tensor

    from ..render.soft import Surface

_EPSILON = 1e-6
_CHUNK = 24  # coarse candidates rendered at once


@dataclass(frozen=True)
class RotationConfig:
    """Settings of the rotation optimiser.

    The defaults are made for a plain CPU; ``paper()`` gives the values of Sec. 4.1.

    Attributes:
        lambda_s, lambda_e, lambda_a: weights of Eq. 1.
        coarse_step: step of the coarse search over the whole turn, radians.
        candidates: how many coarse angles are refined.
        separation: smallest angle between two candidates, radians; 0 takes the best angles even
            if they are neighbours. A separation keeps the opposite direction in the race.
        learning_rate: Adam's step, radians.
        steps: Adam's steps.
        decay: let the step fall to zero along a cosine, which ends on the minimum itself.
        flat: an object whose coarse losses vary by less than this share of the lowest looks the
            same from all sides; it keeps yaw 0.
        patience: stop after that many steps without progress; 0 never stops early.
        resolution: side of the compared crops, pixels.
        points: surface points drawn per object.
        edge_unit: the distance that counts as 1 in Eq. 3, as a share of the crop's side.
        keep_aspect: pad the tight crop to a square; False stretches it, which drops the aspect.
        perspective: see each object along its own ray; False looks at all of them as if they
            stood at the image centre.
        refine_camera: also adjust the camera's elevation per candidate, within ``max_tilt``.
        max_tilt: largest change of elevation, radians.
    """

    lambda_s: float = 0.5
    lambda_e: float = 0.5
    lambda_a: float = 2.0
    coarse_step: float = float(np.deg2rad(5.0))
    candidates: int = 8
    separation: float = float(np.deg2rad(15.0))
    learning_rate: float = 3e-2
    steps: int = 40
    decay: bool = True
    flat: float = 0.15
    patience: int = 12
    resolution: int = 96
    points: int = 6000
    edge_unit: float = 0.1
    keep_aspect: bool = True
    perspective: bool = True
    refine_camera: bool = True
    max_tilt: float = float(np.deg2rad(5.0))

    def __post_init__(self) -> None:
        if not 0 < self.coarse_step <= np.pi or self.candidates < 1 or self.steps < 0:
            raise InputError(
                "RotationConfig needs coarse_step in (0, pi] radians, at least 1 candidate and "
                f"no negative steps, got {self}."
            )
        if self.resolution < 16 or self.points < 100:
            raise InputError(
                f"RotationConfig needs resolution >= 16 and points >= 100, got {self}."
            )

    @classmethod
    def paper(cls) -> RotationConfig:
        """Return the settings of Sec. 4.1 and 6.1; minutes per object on a CPU."""
        return cls(
            separation=0.0,
            steps=140,
            decay=False,
            flat=0.0,
            patience=0,
            resolution=256,
            points=40_000,
            keep_aspect=False,
            perspective=False,
            refine_camera=False,
        )


# ------------------------------------------------------------------------------------ equations


def silhouette_loss(soft: Float[Tensor, "b h w"], mask: Float[Tensor, "h w"]) -> Float[Tensor, "b"]:
    """Eq. 2: one minus the soft intersection over union of silhouette and mask."""
    both = (soft * mask).sum((-2, -1))
    either = (mask + soft - soft * mask).sum((-2, -1))
    return 1 - both / (either + _EPSILON)


def edge_loss(edges: Float[Tensor, "b h w"], distance: Float[Tensor, "h w"]) -> Float[Tensor, "b"]:
    """Eq. 3: mean distance D_S to the mask's contour, weighted by each candidate's own edges."""
    return (edges * distance).sum((-2, -1)) / (edges.sum((-2, -1)) + _EPSILON)


def appearance_loss(
    rendered: tuple[Float[Tensor, "b c h w"], ...], target: tuple[Float[Tensor, "1 c h w"], ...]
) -> Float[Tensor, "b"]:
    """Eq. 4: squared distance of the features Phi, averaged over positions and maps.

    The average, where the paper prints a sum, keeps lambda_a independent of the resolution.
    """
    levels = [(a - b).square().sum(1).mean((-2, -1)) for a, b in zip(rendered, target, strict=True)]
    return sum(levels[1:], levels[0]) / len(levels)


def rotation_loss(
    silhouette: Float[Tensor, "b"],
    edge: Float[Tensor, "b"],
    appearance: Float[Tensor, "b"],
    config: RotationConfig,
) -> Float[Tensor, "b"]:
    """Eq. 1: the weighted sum of the three terms."""
    return config.lambda_s * silhouette + config.lambda_e * edge + config.lambda_a * appearance


def contour_distance(mask: Bool[np.ndarray, "h w"]) -> Float[np.ndarray, "h w"]:
    """Return D_S of Eq. 3: each pixel's distance to the nearest Canny edge of ``mask``, pixels."""
    import cv2

    edges = cv2.Canny(mask.astype(np.uint8) * 255, 100, 200)
    return cv2.distanceTransform(255 - edges, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)


# --------------------------------------------------------------------------------------- target


@dataclass(frozen=True, eq=False)
class Target:
    """What the renders are compared with.

    ``mask`` is S, softened like the renders; ``distance`` is D_S over ``edge_unit``; ``features``
    are Phi(I_instance); ``box`` is the object's place in the reference image, pixels.
    """

    mask: Float[Tensor, "h w"]
    distance: Float[Tensor, "h w"]
    features: tuple[Tensor, ...]
    box: Float[np.ndarray, "4"]


def make_target(instance: Instance, encoder: Encoder, config: RotationConfig) -> Target:
    """Crop the completed instance tightly and prepare it for Eqs. 2 to 4.

    Raises:
        InputError: the instance's crop is wholly transparent.
    """
    import torch

    from ..render.crop import tight_crop
    from ..render.soft import smooth

    alpha = instance.crop[..., 3] > 127
    if not alpha.any():
        raise InputError(f"Instance {instance.name!r} has an empty crop; it shows no object.")
    tight = mask_box(alpha)
    rgba = tight_crop(instance.crop, tight, config.resolution, config.keep_aspect)
    pixels = torch.as_tensor(rgba).permute(2, 0, 1)[None]
    soft = smooth(pixels)
    image = soft[:, :3] + 0.5 * (1 - soft[:, 3:])
    distance = contour_distance(rgba[..., 3] > 0.5) / (config.edge_unit * config.resolution)
    with torch.no_grad():
        features = encoder.features(image)
    return Target(soft[0, 3], torch.as_tensor(distance), features, _in_reference(instance, tight))


def _in_reference(instance: Instance, tight: Float[np.ndarray, "4"]) -> Float[np.ndarray, "4"]:
    """Carry a box of the crop into reference pixels."""
    low, high = instance.crop_box[:2], instance.crop_box[2:]
    height, width = instance.crop.shape[:2]
    pixel = (high - low) / np.array([width, height])
    return np.concatenate([low + tight[:2] * pixel, low + tight[2:] * pixel])


# --------------------------------------------------------------------------------------- search


@dataclass(frozen=True, eq=False)
class Objective:
    """L_rot of Eq. 1 as a function of yaw, for one object seen in one place of the image.

    ``middle`` and ``span`` are the object's box in x/z, y/z of the camera.
    """

    surface: Surface
    target: Target
    encoder: Encoder
    config: RotationConfig
    world_to_camera: Tensor
    middle: Tensor
    span: Tensor

    def __call__(self, yaw: Float[Tensor, "b"], tilt: Float[Tensor, "b"]) -> Float[Tensor, "b"]:
        """Render the candidates (radians) and return each one's loss."""
        from ..render import soft

        rotation = soft.object_to_camera(yaw, tilt, self.world_to_camera)
        center = soft.fit_center(self.surface, rotation.detach(), self.middle, self.span)
        images = soft.render(
            self.surface, rotation, center, self.config.resolution, self.config.keep_aspect
        )
        return rotation_loss(
            silhouette_loss(images.silhouette, self.target.mask),
            edge_loss(soft.sobel_edges(images.silhouette), self.target.distance),
            appearance_loss(self.encoder.features(images.image), self.target.features),
            self.config,
        )


def make_objective(
    model: Model,
    instance: Instance,
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    image_size: tuple[int, int],
    seed: int = 0,
) -> Objective:
    """Prepare Eq. 1 for one object; ``image_size`` is (width, height) of the reference image."""
    import torch

    from ..render.soft import sample_surface

    target = make_target(instance, encoder, config)
    focal = image_size[1] / 2 / np.tan(view.fov / 2)
    middle = ((target.box[:2] + target.box[2:]) / 2 - np.array(image_size) / 2) / focal
    span = (target.box[2:] - target.box[:2]) / focal
    return Objective(
        sample_surface(model.mesh, model.size, config.points, seed),
        target,
        encoder,
        config,
        torch.as_tensor(view_rotation(view), dtype=torch.float32),
        torch.as_tensor(middle if config.perspective else 0 * middle, dtype=torch.float32),
        torch.as_tensor(span, dtype=torch.float32),
    )


def optimise_rotation(
    model: Model,
    instance: Instance,
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    image_size: tuple[int, int],
    seed: int = 0,
) -> Rotation:
    """Find the yaw of one object: coarse search, then gradient descent on the candidates.

    Args:
        model: canonical model; its ``size`` gives the proportions.
        instance: the completed crop (its alpha is S) and its place in the image.
        view: camera of the reference image.
        encoder: appearance features Phi.
        config: settings.
        image_size: (width, height) of the reference image in pixels.
        seed: of the surface samples.

    Returns:
        The best yaw in [-pi, pi) with its loss, and every refined (yaw, loss), best first.

    Raises:
        InputError: the crop is empty or the model has no surface.
    """
    from ..render.soft import single_thread

    yaws = np.arange(0, 2 * np.pi - 1e-9, config.coarse_step)
    with single_thread():
        objective = make_objective(model, instance, view, encoder, config, image_size, seed)
        losses = coarse_losses(objective, yaws)
        if np.ptp(losses) < config.flat * losses.min():
            still = (0.0, float(losses[0]))
            return Rotation(instance.name, *still, candidates=(still,))
        start = select_candidates(yaws, losses, config)
        refined = sorted(refine(objective, start), key=lambda pair: pair[1])
    best = refined[0]
    return Rotation(instance.name, best[0], best[1], tuple(refined))


def coarse_losses(objective: Objective, yaws: Float[np.ndarray, "n"]) -> Float[np.ndarray, "n"]:
    """Return Eq. 1 at each yaw (radians), without gradients."""
    import torch

    with torch.no_grad():
        chunks = torch.as_tensor(yaws, dtype=torch.float32).split(_CHUNK)
        return torch.cat([objective(c, torch.zeros_like(c)) for c in chunks]).numpy()


def select_candidates(
    yaws: Float[np.ndarray, "n"], losses: Float[np.ndarray, "n"], config: RotationConfig
) -> Float[np.ndarray, "k"]:
    """Return the yaws of lowest loss, at most ``candidates``, at least ``separation`` apart."""
    chosen: list[float] = []
    for yaw in yaws[np.argsort(losses, kind="stable")]:
        if all(abs(wrap(yaw - other)) >= config.separation - 1e-6 for other in chosen):
            chosen.append(float(yaw))
        if len(chosen) == config.candidates:
            break
    return np.array(chosen)


def refine(objective: Objective, start: Float[np.ndarray, "k"]) -> list[tuple[float, float]]:
    """Descend from each start yaw with Adam; return the best (yaw, loss) along each path."""
    import torch

    config = objective.config
    yaw = torch.tensor(start, dtype=torch.float32, requires_grad=True)
    tilt = torch.zeros_like(yaw, requires_grad=config.refine_camera)
    optimiser = torch.optim.Adam([yaw, tilt], config.learning_rate)
    best, best_yaw = torch.full_like(yaw.detach(), torch.inf), yaw.detach().clone()
    waited = 0
    for step in range(config.steps + 1):
        loss = objective(yaw, config.max_tilt * torch.tanh(tilt / config.max_tilt))
        better = loss.detach() < best
        waited = 0 if bool((loss.detach() < best - 1e-3 * best.abs()).any()) else waited + 1
        best = torch.where(better, loss.detach(), best)
        best_yaw = torch.where(better, yaw.detach(), best_yaw)
        if step == config.steps or (config.patience and waited >= config.patience):
            break
        optimiser.zero_grad()
        loss.sum().backward()
        optimiser.step()
        if config.decay:
            fall = 0.5 * (1 + np.cos(np.pi * (step + 1) / config.steps))
            optimiser.param_groups[0]["lr"] = config.learning_rate * fall
    return [(wrap(float(y)), float(v)) for y, v in zip(best_yaw, best, strict=True)]


def estimate_rotations(
    reference: Reference,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    view: View,
    encoder: Encoder,
    config: RotationConfig | None = None,
    seed: int = 0,
    progress: Callable[[str], None] | None = None,
) -> dict[str, Rotation]:
    """Estimate r_i of every instance but the table, whose yaw is 0 by the view's definition.

    ``progress`` is called with each instance's name before its search begins.

    Raises:
        InputError: an instance has no model, or shows nothing.
    """
    config = config or RotationConfig()
    height, width = reference.image.shape[:2]
    rotations = {}
    for instance in instances:
        if instance.name == TABLE:
            continue
        if instance.name not in models:
            raise InputError(f"Instance {instance.name!r} has no model; make the models first.")
        if progress:
            progress(instance.name)
        rotations[instance.name] = optimise_rotation(
            models[instance.name], instance, view, encoder, config, (width, height), seed
        )
    return rotations
