"""Training of the grasp head on the expert's grasps."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from ...detection.model import SHARPNESS, GraspBatch, loss_of
from ...detection.network import PLACE, PLACES, TURNS
from ..networks.grasp_head import GraspHead, turn_maps
from .demos import GraspShowing

SEEN_TURNS = 4
"""Number of finger directions per demonstration in a batch. Training on a third of all directions
takes a third of the time.
"""

_RATE = 3e-3
_TOLD = 10  # number of loss reports
# metres horizontally and vertically, radians: tolerance for equal grasps
_CLOSE = (0.008, 0.012, np.deg2rad(16.0))

Places = tuple[Int[Tensor, "k"], Float[Tensor, "k 5"], Float[Tensor, "k"]]
"""The cells that contain a grasp, the best grasp in each of them, and its score."""


def teach_head(
    head: GraspHead,
    shown: Sequence[GraspShowing],
    steps: int,
    generator: torch.Generator,
    note: Callable[[int, float], None] | None = None,
    size: int = 16,
) -> None:
    """Train a grasp head in place on ``steps`` batches of ``size`` randomly mirrored examples.

    Each demonstration contributes ``SEEN_TURNS`` finger directions, in at least one of which the
    expert has a grasp.

    ``note`` receives the number of steps done and the mean loss since its last call.
    """
    optimiser = torch.optim.AdamW(head.parameters(), _RATE, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, _RATE, total_steps=steps)
    losses: list[float] = []
    head.requires_grad_(True).train()
    for step in range(1, steps + 1):
        rows = torch.randint(len(shown), (size,), generator=generator).tolist()
        signs = 2 * torch.randint(2, (size, 2), generator=generator) - 1
        batch, sides = some_turns(*batch_of([shown[row] for row in rows], signs), generator)
        loss = loss_of(head(batch.seen, sides), batch)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(head.parameters(), 1.0)
        optimiser.step()
        schedule.step()
        losses.append(float(loss.detach()))
        if note is not None and step % max(steps // _TOLD, 1) == 0:
            note(step, float(np.mean(losses)))
            losses.clear()
    head.requires_grad_(False).eval()


def batch_of(
    shown: Sequence[GraspShowing], signs: Int[Tensor, "b 2"]
) -> tuple[GraspBatch, Float[Tensor, "b t 6"]]:
    """Return a training batch of demonstrations, and the grasp head's inputs other than the maps.

    ``signs`` is -1 where an axis of the hand is mirrored. The mirror image of a grasp is a grasp of
    the mirrored object by an arm at the mirrored position.
    """
    maps = torch.from_numpy(np.stack([one.maps for one in shown]))
    seen, sides = turn_maps(maps, torch.from_numpy(np.stack([one.stands for one in shown])))
    seen, sides = seen.clone(), sides.clone()
    share = torch.zeros(len(shown), TURNS * PLACES**2)
    grasp = torch.zeros(*share.shape, 5)
    for row, (one, sign) in enumerate(zip(shown, signs.tolist(), strict=True)):
        for axis in (0, 1):
            if sign[axis] < 0:
                seen[row] = seen[row].flip(axis + 2)
                # the cosine or sine of its bearing, and the sine of twice the bearing
                sides[row, :, [axis, 3]] *= -1
        places, best, scores = _places(one.grasps, sign)
        if len(places):
            share[row, places] = torch.softmax(scores / SHARPNESS, 0)
            grasp[row, places] = best
    return GraspBatch(seen, share, (share > 0).float(), grasp), sides


def some_turns(
    batch: GraspBatch, sides: Float[Tensor, "b t 6"], generator: torch.Generator
) -> tuple[GraspBatch, Float[Tensor, "b k 6"]]:
    """Reduce a batch to ``SEEN_TURNS`` randomly chosen finger directions per demonstration.

    One of the directions is drawn with a probability equal to its share of the grasps. The shares
    of the remaining cells are then normalised.
    """
    by_turn = batch.share.unflatten(1, (TURNS, -1))
    first = torch.multinomial(by_turn.sum(2) + 1e-6, 1, generator=generator)
    others = torch.rand(by_turn.shape[:2], generator=generator).scatter(1, first, 2.0)
    turns = others.argsort(1, descending=True)[:, :SEEN_TURNS]
    rows = torch.arange(len(turns))[:, None]
    share = by_turn[rows, turns].flatten(1)
    share = share / share.sum(1, keepdim=True).clamp(min=1e-6)
    possible, grasp = (
        part.unflatten(1, (TURNS, -1))[rows, turns].flatten(1, 2)
        for part in (batch.possible, batch.grasp)
    )
    return GraspBatch(batch.seen[rows, turns], share, possible, grasp), sides[rows, turns]


def _places(grasps: Float[np.ndarray, "g 7"], sign: Sequence[int]) -> Places:
    """Return the indices of the cells with grasps, and each cell's best grasp and its score."""
    angle, x, y, z, opening, width, score = grasps.T
    turn = np.rint(angle * TURNS / np.pi).astype(int) % TURNS
    angle = turn * np.pi / TURNS
    along = (x * np.cos(angle) + y * np.sin(angle)) * sign[0]
    across = (y * np.cos(angle) - x * np.sin(angle)) * sign[1]
    i, j = (np.floor(at / PLACE + PLACES / 2).astype(int) for at in (along, across))
    inside = (np.minimum(i, j) >= 0) & (np.maximum(i, j) < PLACES)
    rows = np.column_stack([along, across, z, width, opening - width, score])[inside]
    places, first = np.unique(((turn * PLACES + i) * PLACES + j)[inside], return_index=True)
    kept = torch.from_numpy(rows[first]).float()  # grasps are sorted best first
    return torch.from_numpy(places), kept[:, :5], kept[:, 5]


def found_share(head: GraspHead, shown: Sequence[GraspShowing], worse: float = 0.6) -> float:
    """Return the fraction of demonstrations for which the head's plan matches an expert grasp.

    Grasps match within 8 mm horizontally, 12 mm vertically and 16 degrees. Only grasps whose score
    is at most ``worse`` below that of the expert's choice count.
    """
    return float(np.mean([_is_found(head, one, worse) for one in shown]))


def _is_found(head: GraspHead, one: GraspShowing, worse: float) -> bool:
    maps, stands = (torch.from_numpy(part)[None] for part in (one.maps, one.stands))
    x, y, z, angle, _, _ = head.plan(maps, stands)[0].tolist()
    good = one.grasps[one.grasps[:, -1] >= one.grasps[0, -1] - worse]
    turn = np.abs((good[:, 0] - angle + np.pi / 2) % np.pi - np.pi / 2)
    aside = np.hypot(good[:, 1] - x, good[:, 2] - y)
    up = np.abs(good[:, 3] - z)
    return bool(((aside < _CLOSE[0]) & (up < _CLOSE[1]) & (turn < _CLOSE[2])).any())
