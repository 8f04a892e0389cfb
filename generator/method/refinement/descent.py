"""The mismatch between rendered and observed outlines, and its minimisation by gradient descent."""

# Torch's tensor methods lack type annotations.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from .problem import ObservedThings, PosedThings, Problem, RefinementConfig, standpoint

if TYPE_CHECKING:
    from torch import Tensor

_HELD = 0.05  # weight of deviations from the poses of DRO and TSA
_APART = 20.0  # weight per metre of overlap or of distance beyond the table's edge
_ROUNDS = 20  # number of Adam steps for the camera's position
_REACH = 0.02  # unit of the camera's motion, as a fraction of the objects' mean distance


def misfits(
    seen: ObservedThings, posed: PosedThings, config: RefinementConfig
) -> tuple[Float[np.ndarray, "n"], Float[Tensor, "3"]]:
    """Return one minus the overlap of each object's outline and mask, and the camera's position.

    The camera's position maximises the overlap, since nothing else determines it.
    """
    import torch

    middle = standpoint(seen, posed)
    unit = _unit(posed, middle)
    eye = torch.zeros(3, requires_grad=True)
    optimiser = torch.optim.LBFGS(
        [eye], lr=0.5, max_iter=_ROUNDS, tolerance_change=1e-5, line_search_fn="strong_wolfe"
    )

    def look() -> Tensor:
        return _misfit(seen, posed, middle + unit * eye, config.resolution)

    def closure() -> float:
        optimiser.zero_grad()
        mean = look().mean()
        mean.backward()
        return float(mean.detach())

    optimiser.step(closure)
    with torch.no_grad():
        if not eye.isfinite().all():  # diverged: the objects are far from their outlines
            eye.zero_()
        return look().numpy(), middle + unit * eye


def descend(
    problem: Problem, camera: Float[Tensor, "3"], config: RefinementConfig
) -> Float[np.ndarray, "n 4"]:
    """Return each object's rotation, displacement and growth at the best step; all start at zero.

    ``camera`` is the camera's initial position, which is optimised too.
    """
    import torch

    seen, posed, links = problem.seen, problem.posed, problem.links
    units = torch.tensor([config.turn, config.move, config.move, config.grow])
    body = torch.zeros(len(posed.yaw), 4, requires_grad=True)
    unit = _unit(posed, camera)
    eye = torch.zeros(3, requires_grad=True)
    lowest, found = torch.inf, torch.zeros(len(posed.yaw), 4)

    def loss() -> Tensor:
        nonlocal lowest, found
        steps = body * units
        grow = steps[:, 3].exp()
        across, up = links.carries @ steps[:, 1:3], links.lifts @ (grow - 1)
        place = posed.place + torch.cat([across, up[:, None]], 1)
        moved = PosedThings(posed.surface, posed.yaw + steps[:, 0], place)
        misfit = _misfit(seen, moved, camera + unit * eye, config.resolution, grow).mean()
        crowding = problem.crowd.cost(place[:, :2], moved.yaw, grow)
        total = misfit + _HELD * body.square().mean() + _APART * crowding
        if float(total.detach()) < lowest:
            lowest, found = float(total.detach()), steps.detach().clone()
        return total

    optimiser = torch.optim.Adam([body, eye], config.learning_rate)
    for step in range(config.steps):
        optimiser.zero_grad()
        loss().backward()
        optimiser.step()
        fall = 0.5 * (1 + np.cos(np.pi * (step + 1) / config.steps))
        optimiser.param_groups[0]["lr"] = config.learning_rate * fall
    with torch.no_grad():
        loss()
    return found.numpy().astype(float)


def _unit(posed: PosedThings, camera: Float[Tensor, "3"]) -> float:
    return _REACH * float((posed.place - camera).norm(dim=1).mean())


def _misfit(
    seen: ObservedThings,
    posed: PosedThings,
    camera: Float[Tensor, "3"],
    resolution: int,
    grow: Float[Tensor, "n"] | None = None,
) -> Float[Tensor, "n"]:
    """Return one minus the overlap of each outline, scaled by ``grow``, with its mask."""
    import torch

    from ...render import soft

    count = len(posed.yaw)
    rotation = soft.object_to_camera(posed.yaw, torch.zeros(count), seen.rotation)
    away = (posed.place - camera)[:, None]
    center = soft.rotate(away, seen.rotation.expand(count, 3, 3))[:, 0]
    if grow is not None:  # an object that is twice as large at twice the distance looks the same
        center = center / grow[:, None]
    drawn = soft.render(
        posed.surface, rotation, center, resolution, owner=torch.arange(count),
        window=soft.CropWindow(seen.middle, seen.scale),
    )  # fmt: skip
    return 1 - soft.soft_iou(drawn.silhouette, seen.mask, seen.weight)
