"""Which finds are things, and which overlapping finds are two things rather than one.

Suppressing every find that overlaps a surer one loses what lies in a bowl or before a box. A small
network learns it instead, as in Hosang et al., "Learning non-maximum suppression", CVPR 2017, from
what the looks left: certainties, names, sizes, the region below, and how the finds overlap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor, nn

from .network import REGIONS

ALONE = 26 + len(REGIONS)
"""Clues about one find."""

BOTH = 2 * ALONE + 7
"""Clues about two finds that overlap."""

_HIDDEN = 48
_MEMBERS = 3  # networks that are averaged
_TOUCH = 0.1  # share of the smaller of two finds from which they are judged together
_COARSE = 544  # most pixels of the longer side at which masks are compared
_SURE = 0.3  # certainty from which another find counts as covered
_APART = 0.35  # probability that two finds are two things, from which both stay


@dataclass(frozen=True, eq=False)
class Find:
    """A find before it is judged: certainties of both looks, masks, names as in ``Thing``."""

    first: float
    score: float
    visible: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"]
    names: Float[np.ndarray, "k"]


@dataclass(frozen=True, eq=False)
class Clues:
    """What is known of n finds, and of their m overlapping pairs (the larger one first)."""

    alone: Float[np.ndarray, "n a"]
    pairs: Int[np.ndarray, "m 2"]
    both: Float[np.ndarray, "m b"]


class _Member(nn.Sequential):
    """A small network that tells a probability's logit."""

    def __init__(self, inward: int) -> None:
        super().__init__(
            nn.Linear(inward, _HIDDEN),
            nn.ReLU(),
            nn.Dropout(0.1),
            nn.Linear(_HIDDEN, _HIDDEN),
            nn.ReLU(),
            nn.Linear(_HIDDEN, 1),
        )


class Panel(nn.Module):
    """Some small networks that agree on a probability; ``mean`` and ``spread`` are of the clues."""

    mean: Tensor
    spread: Tensor

    def __init__(self, inward: int) -> None:
        super().__init__()
        self.register_buffer("mean", torch.zeros(inward))
        self.register_buffer("spread", torch.ones(inward))
        self.members = nn.ModuleList(_Member(inward) for _ in range(_MEMBERS))

    def forward(self, clues: Tensor) -> Tensor:
        """Return each member's logits (members, n) for clues (n, c)."""
        x = (clues - self.mean) / self.spread
        return torch.stack([member(x)[:, 0] for member in self.members])


class Judge(nn.Module):
    """See the module."""

    def __init__(self) -> None:
        super().__init__()
        self.alone = Panel(ALONE)
        self.both = Panel(BOTH)

    @torch.inference_mode()
    def choose(self, clues: Clues, least: float) -> list[tuple[int, float]]:
        """Return the finds that are things with at least this probability, and it; surest first.

        A find goes if it is more likely than not the same as, or part of, a surer one.
        """
        alone, both = (
            panel(torch.from_numpy(told)).mean(0).sigmoid().numpy()
            for panel, told in ((self.alone, clues.alone), (self.both, clues.both))
        )
        apart = np.ones((len(alone), len(alone)), bool)
        for (i, j), chance in zip(clues.pairs, both, strict=True):
            apart[i, j] = apart[j, i] = chance > _APART
        kept: list[int] = []
        for k in np.argsort(-alone, kind="stable"):
            if alone[k] >= least and apart[k, kept].all():
                kept.append(int(k))
        return [(k, float(alone[k])) for k in kept]


def clues_of(finds: Sequence[Find], region: Float[np.ndarray, "r h w"]) -> Clues:
    """Return what is known of the finds of one picture; ``region`` as in ``Sight``."""
    count, step = len(finds), -(-max(region.shape[1:]) // _COARSE)
    if not count:
        return Clues(
            np.zeros((0, ALONE), np.float32),
            np.zeros((0, 2), int),
            np.zeros((0, BOTH), np.float32),
        )
    near = np.s_[:, ::step, ::step]
    visible = np.stack([f.visible for f in finds])[near].reshape(count, -1).astype(np.float32)
    whole = np.stack([f.whole for f in finds])[near].reshape(count, -1).astype(np.float32)
    below = region[near].reshape(len(region), -1)
    area = np.maximum(visible.sum(1), 1)
    shared = visible @ visible.T
    within = shared / area[:, None]  # of the row's find, how much the column's covers
    behind = whole @ visible.T / area[None]  # of the column's find, what the row's whole covers
    overlap = shared / (area[:, None] + area[None] - shared)
    for matrix in (within, behind, overlap):
        np.fill_diagonal(matrix, 0)
    names = np.stack([f.names for f in finds])
    score = np.array([f.score for f in finds])
    larger = area[None] > area[:, None]
    surest = names[:, :-1].max(1)

    def most(shares: Float[np.ndarray, "n n"]) -> list[Float[np.ndarray, "n"]]:
        """Return each find's largest share, and how sure and how well named that other find is."""
        other, share = shares.argmax(1), shares.max(1)
        touches = share > _TOUCH / 2
        return [share, np.where(touches, score[other], 0), np.where(touches, surest[other], 0)]

    holder, held = most(within * larger), most(within.T * ~larger)
    rival, hidden = most(overlap), most(behind * ~larger)
    wide, tall = _sides([f.visible for f in finds])
    alone = np.stack(
        [
            _logit(score),
            _logit(np.array([f.first for f in finds])),
            surest,
            names[:, -1],
            -(names * np.log(names + 1e-9)).sum(1) / 3,
            np.log(area / below.shape[1]) / 3,
            np.log(wide / tall),
            area * step**2 / (wide * tall),
            [_cut(f.visible) for f in finds],
            np.log(np.maximum(whole.sum(1), 1) / area),
            *(below @ visible.T / area),
            *holder,
            *held,
            *rival,
            *hidden,
            (within > 0.5).sum(1) / 3,
            ((within.T > 0.5) & (score > _SURE)).sum(1) / 3,
            score.argsort().argsort() / count,
            np.full(count, count / 20),
        ],
        axis=1,
    ).astype(np.float32)
    first, second = np.nonzero(np.triu(np.maximum(within, within.T) > _TOUCH, 1))
    swap = area[first] < area[second]
    i, j = np.where(swap, second, first), np.where(swap, first, second)
    length = np.linalg.norm(names, axis=1)
    both = np.concatenate(
        [
            alone[i],
            alone[j],
            np.stack(
                [
                    within[i, j],
                    within[j, i],
                    overlap[i, j],
                    (names[i] * names[j]).sum(1) / (length[i] * length[j]),
                    np.log(area[i] / area[j]),
                    behind[i, j],
                    behind[j, i],
                ],
                axis=1,
            ),
        ],
        axis=1,
    ).astype(np.float32)
    return Clues(alone, np.stack([i, j], 1), both)


def _logit(chance: Float[np.ndarray, "n"]) -> Float[np.ndarray, "n"]:
    inside = np.clip(chance, 1e-4, 1 - 1e-4)
    return np.log(inside / (1 - inside))


def _sides(
    masks: Sequence[Bool[np.ndarray, "h w"]],
) -> tuple[Float[np.ndarray, "n"], Float[np.ndarray, "n"]]:
    """Return the widths and heights of the masks' boxes, pixels; 1 for an empty mask."""
    sides = []
    for mask in masks:
        rows, columns = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
        sides.append((np.ptp(columns) + 1, np.ptp(rows) + 1) if len(rows) else (1, 1))
    wide, tall = np.array(sides, float).T
    return wide, tall


def _cut(mask: Bool[np.ndarray, "h w"]) -> bool:
    """Tell whether a mask reaches the picture's frame."""
    return bool(mask[0].any() or mask[-1].any() or mask[:, 0].any() or mask[:, -1].any())
