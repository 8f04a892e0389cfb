"""Coarse search over the full circle, followed by gradient descent from the best candidates.

Each level compares fewer candidates at a higher resolution; for most objects the result is clear
before the last level.
"""

# Torch's tensor methods lack type annotations.
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ...geometry import wrap
from .certainty import OTHER, margin, widths
from .config import RotationConfig
from .objective import Candidates, Levels, Objective, reaching_past
from .prior import agrees, prefer, same_side
from .results import Place, RotationAnswer, RotationCandidate, Rows
from .symmetry import looks_order, looks_round

if TYPE_CHECKING:
    from torch import Tensor


_CHUNK = 24  # number of an object's coarse candidates per rendering batch
_SHIFT = 0.3  # Adam's step size for shift and zoom, relative to that for yaw


def search(levels: Levels, priors: Sequence[float | None] | None = None) -> list[RotationAnswer]:
    """Return the result for each object.

    A rotationally symmetric object has a single candidate, yaw 0. ``priors`` are yaws (radians)
    that the models' own orientations imply (see ``prior``), or None.
    """
    config, coarse, fine = levels.coarse.config, levels.coarse, levels.fine
    hints = [None] * len(coarse) if priors is None else list(priors)
    starts, crowded, still, whole = _starts(levels, hints)

    def rivals_of(rows: Rows, maximum: int, share: float) -> Rows:
        return [
            _rivals(found, maximum, share, config, hint)
            for found, hint in zip(rows, hints, strict=True)
        ]

    rounds = [starts]
    if config.coarse_steps:
        apart = [[] if crowd else found for found, crowd in zip(starts, crowded, strict=True)]
        refined = refine(coarse, apart, config.coarse_steps)
        rounds.append([new or old for new, old in zip(refined, starts, strict=True)])
    if config.rival_steps:
        rivals = rivals_of(rounds[-1], config.rivals, config.rival)
        rounds.append(refine(fine, rivals, config.rival_steps))
    rivals = rivals_of(rounds[-1], config.rivals, config.doubt)
    close = levels.close() if config.close_steps and any(rivals) else fine
    if config.close_steps:
        doubtful = [found if len(found) > 1 else [] for found in rivals]
        refined = refine(close, doubtful, config.close_steps)
        rounds.append([new or old[:1] for new, old in zip(refined, rivals, strict=True)])
    finalists = rivals_of(rounds[-1], config.finalists, config.tie)
    last = refine(close, finalists, config.steps)
    rounds.append([prefer(found, hint) for found, hint in zip(last, hints, strict=True)])
    exact = widths(close, [flat or found[0] for flat, found in zip(still, rounds[-1], strict=True)])
    looks = [[found[k] for found in reversed(rounds)] for k in range(len(coarse))]
    return [
        RotationAnswer([[flat]])
        if flat
        else _answer(levels, k, looks[k], exact[k], whole[k], hints[k])
        for k, flat in enumerate(still)
    ]


def _answer(
    levels: Levels,
    number: int,
    looks: Rows,
    width: float,
    candidates: list[RotationCandidate],
    prior: float | None,
) -> RotationAnswer:
    """Return an object's result; check for symmetry if a distinct yaw has a similar loss."""
    # The coarse search is needed too, since all finalists may be symmetric to each other.
    config, sure, order = levels.coarse.config, margin(looks), 1
    least = min(looks[0], key=lambda f: f.loss).yaw
    if config.flat and sure < config.doubt:
        order = looks_order(levels.close(), number, looks[0][0].yaw, config.flat)
        overruled = abs(wrap(order * (least - looks[0][0].yaw))) / order >= OTHER
        sure = margin(looks, order)
        sure = sure if overruled else sure or margin([looks[0][:1], candidates], order)
        looks = [[same_side(looks[0][0], order, prior), *looks[0][1:]], *looks[1:]]
    return RotationAnswer(looks, sure, width, False, order)


def _starts(
    levels: Levels, priors: Sequence[float | None]
) -> tuple[Rows, list[bool], list[RotationCandidate | None], Rows]:
    """Return each object's starting yaws, whether it is ambiguous or round, and all its losses."""
    config = levels.coarse.config
    yaws = np.arange(0, 2 * np.pi - 1e-9, config.coarse_step)
    losses, places = coarse_search(levels.coarse, yaws)
    suspects = np.ptp(losses, axis=1) < config.suspect * losses.min(1)
    flat = looks_round(levels.close, suspects, config.flat)
    starts: Rows = []
    crowded: list[bool] = []
    for k, row in enumerate(losses):
        best = select(yaws, row, config)
        close = len(best) > 1 and row[best[-1]] < (1 + config.crowded) * row.min()
        crowded.append(not flat[k] and bool(close))  # too similar: select again at full resolution
        if crowded[-1]:
            row = losses_at(levels.fine, k, yaws, places[k])
            best = select(yaws, row, config)
        found = [RotationCandidate(float(yaws[n]), float(row[n]), 0.0, places[k][n]) for n in best]
        hint = priors[k]
        if hint is not None:
            found = _with_start(levels.fine if crowded[-1] else levels.coarse, k, found, hint)
        starts.append([] if flat[k] else found)
    still = [
        RotationCandidate(0.0, float(row[0])) if f else None
        for f, row in zip(flat, losses, strict=True)
    ]
    whole = [
        [RotationCandidate(float(yaw), float(loss)) for yaw, loss in zip(yaws, row, strict=True)]
        for row in losses
    ]
    return starts, crowded, still, whole


def _with_start(
    objective: Objective, number: int, found: list[RotationCandidate], yaw: float
) -> list[RotationCandidate]:
    """Return ``found``, with a start at ``yaw`` (radians) if it has none nearby, sorted by loss."""
    if any(abs(wrap(f.yaw - yaw)) < objective.config.separation / 3 for f in found):
        return found
    nearest = min(found, key=lambda f: abs(wrap(f.yaw - yaw)))
    (loss,) = losses_at(objective, number, np.array([yaw]), [nearest.place])
    start = RotationCandidate(yaw, float(loss), 0.0, nearest.place)
    return sorted([*found, start], key=lambda f: f.loss)


def coarse_search(
    objective: Objective, yaws: Float[np.ndarray, "n"]
) -> tuple[Float[np.ndarray, "s n"], list[list[Place]]]:
    """Return each object's lowest loss at each yaw (radians), and the crop position that gives it.

    An object that may be occluded is also drawn so that it extends beyond its box, at one side at a
    time.
    """
    import torch

    losses = coarse_losses(objective, yaws)
    places: list[list[Place]] = [[(0.0, 0.0, 0.0)] * len(yaws) for _ in range(len(objective))]
    cut = objective.target.cut & objective.loose[:, None]
    for k, side in torch.nonzero(cut).cpu().numpy().tolist():
        yaw = torch.as_tensor(yaws, dtype=torch.float32, device=objective.middle.device)
        owner = torch.full((len(yaws),), k, device=yaw.device)
        with torch.no_grad():
            fit = reaching_past(objective, Candidates(owner, yaw, torch.zeros_like(yaw)), side)
        rows = torch.cat([fit.shift, fit.zoom[:, None]], 1).cpu().numpy().tolist()
        found = losses_at(objective, k, yaws, rows)
        for n in np.flatnonzero(found < losses[k]):
            losses[k, n], places[k][n] = found[n], tuple(rows[n])
    return losses, places


def coarse_losses(objective: Objective, yaws: Float[np.ndarray, "n"]) -> Float[np.ndarray, "s n"]:
    """Return the loss of Eq. 1 for each object at each yaw (radians), without gradients."""
    import torch

    count = len(objective)
    device = objective.middle.device
    chunks = torch.as_tensor(yaws, dtype=torch.float32, device=device).split(_CHUNK)
    rows: list[Tensor] = []
    with torch.no_grad():
        for chunk in chunks:
            owner = torch.arange(count, device=device).repeat_interleave(len(chunk))
            yaw = chunk.repeat(count)
            losses = objective(Candidates(owner, yaw, torch.zeros_like(yaw)))
            rows.append(losses.view(count, -1))
    return torch.cat(rows, 1).cpu().numpy()


def losses_at(
    objective: Objective,
    number: int,
    yaws: Float[np.ndarray, "n"],
    places: Sequence[Sequence[float]],
) -> Float[np.ndarray, "n"]:
    """Return an object's losses at given yaws (radians) and crop positions, without gradients."""
    import torch

    from ...render.soft import CropFit

    device = objective.middle.device
    rows = torch.as_tensor(np.column_stack([yaws, places]), dtype=torch.float32, device=device)
    out: list[Tensor] = []
    with torch.no_grad():
        for part in rows.split(_CHUNK):
            owner = torch.full((len(part),), number, device=device)
            fit = CropFit(part[:, 1:3], part[:, 3])
            out.append(objective(Candidates(owner, part[:, 0], torch.zeros_like(part[:, 0]), fit)))
    return torch.cat(out).cpu().numpy()


def select(
    yaws: Float[np.ndarray, "n"], losses: Float[np.ndarray, "n"], config: RotationConfig
) -> list[int]:
    """Return the indices of the best yaws: up to ``candidates``, at least ``separation`` apart."""
    chosen: list[int] = []
    for k in np.argsort(losses, kind="stable"):
        if all(abs(wrap(yaws[k] - yaws[n])) >= config.separation - 1e-6 for n in chosen):
            chosen.append(int(k))
        if len(chosen) == config.candidates:
            break
    return chosen


def refine(objective: Objective, starts: Rows, steps: int) -> Rows:
    """Run Adam from each start, and return the best point of each path, sorted by loss.

    ``starts`` has a list for each object. The whole batch stops once no path improves.
    """
    import torch

    from ...render.soft import CropFit

    config, device = objective.config, objective.middle.device
    owners = [k for k, found in enumerate(starts) for _ in found]
    if not owners:
        return [[] for _ in starts]
    owner = torch.tensor(owners, device=device)
    begin = torch.tensor(
        [[f.yaw, f.tilt, *f.place] for found in starts for f in found], device=device
    )
    yaw = begin[:, 0].clone().requires_grad_()
    tilt = _unbound(begin[:, 1], config.max_tilt).requires_grad_(config.refine_camera)
    loose = objective.loose[owner, None].float()
    change = torch.zeros(len(owners), 3, device=device, requires_grad=bool(loose.any()))

    def poses() -> tuple[Candidates, Float[Tensor, "b 3"]]:
        place = begin[:, 2:] + loose * _bound(change, config.max_fit)
        fit = CropFit(place[:, :2], place[:, 2]) if change.requires_grad else None
        return Candidates(owner, yaw, _bound(tilt, config.max_tilt), fit), place

    groups = [
        {"params": [yaw, tilt], "lr": config.learning_rate},
        {"params": [change], "lr": _SHIFT * config.learning_rate},
    ]
    optimiser = torch.optim.Adam(groups)
    rates = [group["lr"] for group in optimiser.param_groups]
    costs = config.fit_cost / config.max_fit**2 if config.max_fit else 0.0
    best = torch.full((len(owners), 6), torch.inf, device=device)
    waited = 0
    for step in range(steps + 1):
        candidates, place = poses()
        loss = objective(candidates)
        now = torch.stack([loss, candidates.yaw, candidates.tilt], 1)
        now = torch.cat([now, place], 1).detach()
        progress = now[:, 0] < best[:, 0] - 1e-3 * best[:, 0].nan_to_num(posinf=0.0).abs()
        waited = 0 if bool(progress.any()) else waited + 1
        best = torch.where(now[:, :1] < best[:, :1], now, best)
        if step == steps or (config.patience and waited >= config.patience):
            break
        optimiser.zero_grad()
        (loss.sum() + costs * change.square().sum()).backward()
        optimiser.step()
        if config.decay:
            fall = 0.5 * (1 + np.cos(np.pi * (step + 1) / steps))
            for group, rate in zip(optimiser.param_groups, rates, strict=True):
                group["lr"] = rate * fall
    rows: list[list[float]] = best.cpu().numpy().tolist()
    refined = iter([RotationCandidate(wrap(r[1]), r[0], r[2], (r[3], r[4], r[5])) for r in rows])
    return [sorted((next(refined) for _ in found), key=lambda f: f.loss) for found in starts]


def _rivals(
    found: list[RotationCandidate],
    maximum: int,
    share: float,
    config: RotationConfig,
    prior: float | None,
) -> list[RotationCandidate]:
    """Return the best distinct candidates, one of which agrees with the prior yaw if possible."""
    kept: list[RotationCandidate] = []
    for candidate in sorted(found, key=lambda f: f.loss):
        near = any(abs(wrap(candidate.yaw - f.yaw)) < config.separation / 3 for f in kept)
        if not near and candidate.loss <= (1 + share) * (kept[0].loss if kept else np.inf):
            kept.append(candidate)
    best = kept[:maximum]
    if prior is not None and not any(agrees(f.yaw, prior) for f in best):
        best[-1:] = next(([f] for f in kept[maximum:] if agrees(f.yaw, prior)), best[-1:])
    return best


def _bound(raw: Tensor, maximum: float) -> Tensor:
    return maximum * (raw / maximum).tanh() if maximum else 0 * raw


def _unbound(value: Tensor, maximum: float) -> Tensor:
    return maximum * (value / maximum).clamp(-0.999, 0.999).atanh() if maximum else 0 * value
