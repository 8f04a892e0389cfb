"""Coarse search over the whole turn, then gradient descent on the best candidates."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ...geometry import wrap
from .config import RotationConfig
from .objective import Candidates, Objective

if TYPE_CHECKING:
    from torch import Tensor

_CHUNK = 24  # coarse candidates of an object rendered at once
_SHIFT = 0.3  # Adam's step of shift and zoom, per step of yaw

Found = tuple[float, float, float]
"""A candidate's yaw, its loss and its tilt."""


def search(coarse: Objective, fine: Objective) -> list[list[Found]]:
    """Return the refined candidates of every object, best first.

    An object that looks the same from all sides has one candidate, yaw 0.
    """
    config = coarse.config
    yaws = np.arange(0, 2 * np.pi - 1e-9, config.coarse_step)
    losses = coarse_losses(coarse, yaws)
    flat = np.ptp(losses, axis=1) < config.flat * losses.min(1)
    starts = [
        [] if still else [(float(yaw), 0.0, 0.0) for yaw in select_candidates(yaws, row, config)]
        for row, still in zip(losses, flat, strict=True)
    ]
    if config.coarse_steps:
        better = refine(coarse, starts, config.coarse_steps)
        starts = [_distinct(found)[: config.finalists] for found in better]
    refined = refine(fine, starts, config.steps)
    return [
        [(0.0, float(row[0]), 0.0)] if still else found
        for row, still, found in zip(losses, flat, refined, strict=True)
    ]


def coarse_losses(objective: Objective, yaws: Float[np.ndarray, "n"]) -> Float[np.ndarray, "s n"]:
    """Return Eq. 1 of each object at each yaw (radians), without gradients."""
    import torch

    count = len(objective)
    device = objective.middle.device
    chunks = torch.as_tensor(yaws, dtype=torch.float32, device=device).split(_CHUNK)
    rows = []
    with torch.no_grad():
        for chunk in chunks:
            owner = torch.arange(count, device=device).repeat_interleave(len(chunk))
            yaw = chunk.repeat(count)
            losses = objective(Candidates(owner, yaw, torch.zeros_like(yaw)))
            rows.append(losses.view(count, -1))
    return torch.cat(rows, 1).cpu().numpy()


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


def refine(objective: Objective, starts: list[list[Found]], steps: int) -> list[list[Found]]:
    """Descend with Adam from each start; return the best of each path, best first.

    ``starts`` has a list for each object. The whole batch stops once no path gets better.
    """
    import torch

    from ...render.soft import Fit

    config, device = objective.config, objective.middle.device
    owners = [k for k, found in enumerate(starts) for _ in found]
    if not owners:
        return [[] for _ in starts]
    owner = torch.tensor(owners, device=device)
    begin = torch.tensor([[yaw, tilt] for found in starts for yaw, _, tilt in found], device=device)
    yaw = begin[:, 0].clone().requires_grad_()
    tilt = _unbounded(begin[:, 1], config.max_tilt).requires_grad_(config.refine_camera)
    loose = objective.loose[owner, None].float()
    place = torch.zeros(len(owners), 3, device=device, requires_grad=bool(loose.any()))

    def poses() -> Candidates:
        fit = None
        if place.requires_grad:
            bounded = loose * _bounded(place, config.max_fit)
            fit = Fit(bounded[:, :2], bounded[:, 2])
        return Candidates(owner, yaw, _bounded(tilt, config.max_tilt), fit)

    groups = [
        {"params": [yaw, tilt], "lr": config.learning_rate},
        {"params": [place], "lr": _SHIFT * config.learning_rate},
    ]
    optimiser = torch.optim.Adam(groups)
    rates = [group["lr"] for group in optimiser.param_groups]
    best = torch.full((len(owners), 3), torch.inf, device=device)
    waited = 0
    for step in range(steps + 1):
        candidates = poses()
        loss = objective(candidates)
        now = torch.stack([loss, candidates.yaw, candidates.tilt], 1).detach()
        progress = now[:, 0] < best[:, 0] - 1e-3 * best[:, 0].nan_to_num(posinf=0.0).abs()
        waited = 0 if bool(progress.any()) else waited + 1
        best = torch.where(now[:, :1] < best[:, :1], now, best)
        if step == steps or (config.patience and waited >= config.patience):
            break
        optimiser.zero_grad()
        (loss.sum() + config.fit_cost * place.square().sum() / config.max_fit**2).backward()
        optimiser.step()
        if config.decay:
            fall = 0.5 * (1 + np.cos(np.pi * (step + 1) / steps))
            for group, rate in zip(optimiser.param_groups, rates, strict=True):
                group["lr"] = rate * fall
    rows = iter(best.cpu().tolist())
    refined = [[_found(*next(rows)) for _ in found] for found in starts]
    return [sorted(found, key=lambda f: f[1]) for found in refined]


def _found(loss: float, yaw: float, tilt: float) -> Found:
    return wrap(yaw), loss, tilt


def _distinct(found: list[Found], apart: float = float(np.deg2rad(3.0))) -> list[Found]:
    """Return candidates, best first, without those that have come to the same place."""
    kept: list[Found] = []
    for candidate in found:
        if all(abs(wrap(candidate[0] - other[0])) > apart for other in kept):
            kept.append(candidate)
    return kept


def _bounded(raw: Tensor, most: float) -> Tensor:
    return most * (raw / most).tanh()


def _unbounded(value: Tensor, most: float) -> Tensor:
    return most * (value / most).clamp(-0.999, 0.999).atanh()
