"""Joint refinement, beyond the paper: all objects and the camera against all masks at once.

DRO turns one object at a time and TSA places them from another picture. Here yaw, place and size
of every object are moved together, by gradient, until what the reference picture's camera sees of
the scene agrees with the instances' outlines. Objects keep standing on what they stand on, and
apart from one another.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ..errors import require
from ..geometry import Camera, view_rotation, wrap
from ..render.contact import at_rest
from ..scene import Instance, Model, Placement, View

if TYPE_CHECKING:
    from torch import Tensor

    from ..render.soft import Surface

_HELD = 0.05  # weight of staying where DRO and TSA put things
_APART = 20.0  # weight of a metre by which two things come too near, or one leaves the table
_WORSE = 0.02  # an object whose own outline agrees that much less keeps its place


@dataclass(frozen=True)
class RefinementConfig:
    """Settings of the joint refinement.

    Attributes:
        steps: Adam's steps; 0 leaves everything as it is.
        learning_rate: Adam's first step, in units of the scales below; it falls to zero.
        turn, move, grow: how far yaw (radians), place (metres) and size (logarithm) usually are
            wrong; 0 leaves it as it is.
        resolution: side of the compared crops, pixels.
        points: surface points drawn per object.
        unsure: weight of pixels where another instance may hide this one.
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
        require(self, "steps", least=0, whole=True)
        require(self, "learning_rate", above=0)
        require(self, "turn", "move", "grow", least=0)
        require(self, "resolution", least=16, whole=True)
        require(self, "points", least=100, whole=True)
        require(self, "unsure", least=0, most=1)


@dataclass(frozen=True, eq=False)
class Refinement:
    """What the joint refinement found.

    ``before`` and ``after`` are one minus the overlap of outlines (Eq. 2), the mean over the
    objects; ``after`` is never more.
    """

    placements: tuple[Placement, ...]
    before: float
    after: float


def refine_scene(
    instances: Sequence[Instance],
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_scale: Float[np.ndarray, "3"],
    view: View,
    image_size: tuple[int, int],
    config: RefinementConfig | None = None,
    seed: int = 0,
) -> Refinement:
    """Move all objects, and the camera's place, together to where the outlines agree best.

    Args:
        instances: the reference picture's, with their completed crops.
        models: canonical models by name.
        placements: where DRO and TSA put the objects, world frame.
        table_scale: the table's extent, metres.
        view: the reference picture's camera.
        image_size: (width, height) of the reference picture.
        config: settings.
        seed: of the surface samples.

    The camera's direction is not moved: outlines agree as well with an elevation 3 degrees off, so
    they do not tell it; the table's edges do.

    What comes out worse is not taken, for the whole scene or for an object. A picture with fewer
    than two objects, which cannot tell where the camera stands, is left as it is.
    """
    config = config or RefinementConfig()
    shown = {i.name: i for i in instances if (i.crop[..., 3] > 127).any()}
    moving = [p for p in placements if p.name in shown]
    if len(moving) < 2 or not config.steps:
        return Refinement(tuple(placements), 0.0, 0.0)
    from ..render.soft import single_thread

    with single_thread():
        problem = _problem(moving, shown, models, table_scale, view, image_size, config, seed)
        start, best, steps = _descend(problem, config)
    better = best < start + _WORSE
    if best.mean() >= start.mean():
        return Refinement(tuple(placements), float(start.mean()), float(start.mean()))
    kept = np.where(better[:, None], steps, 0.0)
    rows = {p.name: k for k, p in enumerate(moving)}
    moved = {}
    for k, p in enumerate(moving):
        across = kept[k, 1:3] + (kept[rows[p.on], 1:3] if p.on in rows else 0.0)
        moved[p.name] = replace(
            p,
            yaw=wrap(p.yaw + kept[k, 0]),
            translation=p.translation + np.append(across, 0.0),
            scale=p.scale * np.exp(kept[k, 3]),
        )
    rested = at_rest([moved.get(p.name, p) for p in placements], models, float(table_scale[2]))
    after = float(np.where(better, best, start).mean())
    return Refinement(rested, float(start.mean()), after)


# --------------------------------------------------------------------------------------- problem


@dataclass(frozen=True, eq=False)
class _Problem:
    """Everything the loss needs of ``n`` objects, as tensors.

    ``place`` are box centres, ``half`` half heights, ``base`` the row of what each stands on, or
    -1; ``near`` the least distance of two centres; ``room`` half the table's length and width.
    """

    surface: Surface
    mask: Tensor
    weight: Tensor
    middle: Tensor
    scale: Tensor
    yaw: Tensor
    place: Tensor
    half: Tensor
    base: Tensor
    near: Tensor
    room: Tensor
    rotation: Tensor
    camera: Tensor


def _problem(
    placements: Sequence[Placement],
    shown: Mapping[str, Instance],
    models: Mapping[str, Model],
    table_scale: Float[np.ndarray, "3"],
    view: View,
    image_size: tuple[int, int],
    config: RefinementConfig,
    seed: int,
) -> _Problem:
    import torch

    from ..render.crop import MARGIN, hiders, in_reference, mask_in_crop, tight_box, tight_crop
    from ..render.soft import sample_surface, smooth, stack

    things = [shown[p.name] for p in placements]
    size = config.resolution
    tight = [tight_box(i) for i in things]
    boxes = np.array([in_reference(i, t) for i, t in zip(things, tight, strict=True)])
    eye = Camera(np.zeros(3), view_rotation(view), view.fov, *image_size)
    middle = ((boxes[:, :2] + boxes[:, 2:]) / 2 - eye.center) / eye.focal
    span = (boxes[:, 2:] - boxes[:, :2]).max(1) / eye.focal
    masks, weights = [], []
    for thing, box in zip(things, tight, strict=True):
        masks.append(tight_crop(thing.crop, box, size)[..., 3])
        hidden = hiders(thing, list(shown.values()))
        sure = np.ones((size, size), np.float32)
        if hidden is not None:
            over = tight_crop(mask_in_crop(hidden, thing), box, size)[..., 3]
            sure -= (1 - config.unsure) * over
        weights.append(sure)
    place = np.array([p.translation for p in placements])
    names = [p.name for p in placements]
    base = [names.index(p.on) if p.on in names else -1 for p in placements]
    radius = np.array([float(p.scale[:2].mean()) / 2 for p in placements])
    apart = np.linalg.norm(place[:, None, :2] - place[None, :, :2], axis=2)
    near = np.minimum(apart, radius[:, None] + radius[None])
    related = np.array([[p.on == q.name or q.on == p.name for q in placements] for p in placements])
    near[related | np.eye(len(names), dtype=bool)] = 0.0

    def tensor(array: object) -> Tensor:
        return torch.as_tensor(np.asarray(array), dtype=torch.float32)

    return _Problem(
        stack([
            sample_surface(models[p.name].mesh, p.scale, config.points, seed) for p in placements
        ]),
        smooth(tensor(masks)[:, None])[:, 0],
        tensor(weights),
        tensor(middle),
        tensor(size * (1 - 2 * MARGIN) / span[:, None]),
        tensor([p.yaw for p in placements]),
        tensor(place),
        tensor([p.scale[2] / 2 for p in placements]),
        torch.tensor(base),
        tensor(near),
        tensor(table_scale[:2] / 2),
        tensor(view_rotation(view)),
        tensor(_standpoint(place, middle, eye)),
    )  # fmt: skip


def _standpoint(
    points: Float[np.ndarray, "n 3"], middle: Float[np.ndarray, "n 2"], eye: Camera
) -> Float[np.ndarray, "3"]:
    """Return where a camera of known direction stands that sees points at x/z, y/z ``middle``.

    Least squares over the distances of the points from their rays.
    """
    rays = np.column_stack([middle, np.ones(len(middle))]) @ eye.rotation
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    across = np.eye(3) - rays[:, :, None] * rays[:, None]
    return np.linalg.lstsq(across.sum(0), (across @ points[..., None]).sum(0)[:, 0], rcond=None)[0]


# --------------------------------------------------------------------------------------- descent


def _descend(
    problem: _Problem, config: RefinementConfig
) -> tuple[np.ndarray, np.ndarray, Float[np.ndarray, "n 4"]]:
    """Return each object's misfit at the start and at the best step, and its turn, move and growth.

    The camera's place is found first, with everything else as it is: TSA does not tell it.
    """
    import torch

    count = len(problem.yaw)
    units = torch.tensor([config.turn, config.move, config.move, config.grow])
    body = torch.zeros(count, 4, requires_grad=True)
    eye = torch.zeros(3, requires_grad=True)
    reach = 0.02 * float((problem.place - problem.camera).norm(dim=1).mean())

    def loss(moving: bool) -> tuple[Tensor, Tensor]:
        steps = body * units if moving else torch.zeros(count, 4)
        misfit = _misfit(problem, steps, reach * eye, config.resolution)
        held = _HELD * body.square().mean() + _APART * _crowding(problem, steps)
        return misfit, misfit.mean() + held

    start = best = torch.zeros(count)
    lowest, found = torch.inf, torch.zeros(count, 4)
    for moving, rounds in ((False, config.steps // 2), (True, config.steps)):
        parameters = [body, eye] if moving else [eye]
        optimiser = torch.optim.Adam(parameters, config.learning_rate)
        for step in range(rounds + 1):
            misfit, total = loss(moving)
            if moving and step == 0:
                start = misfit.detach()
            if moving and float(total.detach()) < lowest:
                lowest, best = float(total.detach()), misfit.detach()
                found = (body * units).detach().clone()
            if step == rounds:
                break
            optimiser.zero_grad()
            total.backward()
            optimiser.step()
            fall = 0.5 * (1 + np.cos(np.pi * (step + 1) / max(rounds, 1)))
            optimiser.param_groups[0]["lr"] = config.learning_rate * fall
    return start.numpy(), best.numpy(), found.numpy().astype(float)


def _misfit(problem: _Problem, steps: Tensor, eye: Tensor, resolution: int) -> Tensor:
    """Return one minus the overlap of each object's outline with its mask."""
    import torch

    from ..render import soft

    move = torch.cat([steps[:, 1:3], torch.zeros_like(steps[:, :1])], 1)
    grow = steps[:, 3].exp()
    on = problem.base >= 0
    carried = torch.where(on[:, None], move[problem.base.clamp_min(0)], torch.zeros_like(move))
    lift = torch.zeros_like(move)
    lift[:, 2] = problem.half * (grow - 1)
    place = problem.place + move + carried + lift
    level = torch.zeros_like(grow)
    rotation = soft.object_to_camera(problem.yaw + steps[:, 0], level, problem.rotation)
    away = (place - problem.camera - eye)[:, None]
    # A thing twice as large at twice the distance looks the same.
    center = soft.turned(away, problem.rotation.expand(len(steps), 3, 3))[:, 0] / grow[:, None]
    drawn = soft.render(
        problem.surface, rotation, center, resolution, owner=torch.arange(len(steps)),
        window=soft.Window(problem.middle, problem.scale),
    )  # fmt: skip
    return 1 - soft.soft_iou(drawn.silhouette, problem.mask, problem.weight)


def _crowding(problem: _Problem, steps: Tensor) -> Tensor:
    """Return by how much things come too near to one another or leave the table, metres."""
    place = problem.place[:, :2] + steps[:, 1:3]
    apart = ((place[:, None] - place[None]).square().sum(2) + 1e-12).sqrt()
    close = (problem.near - apart).clamp_min(0).sum() / 2
    beyond = (place.abs() - problem.room).clamp_min(0).sum()
    return close + beyond
