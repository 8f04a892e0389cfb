"""Learned non-maximum suppression, which selects the detections that are separate objects.

Suppressing every detection that overlaps a more confident one would lose objects in bowls or in
front of boxes. A small network decides instead, as in Hosang et al., "Learning non-maximum
suppression", CVPR 2017, based on confidences, names, sizes, the region below, and the overlaps
between detections.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor, nn

from ....geometry import mask_box
from .network import REGIONS

ALONE = 26 + len(REGIONS)
"""Number of features of one detection."""

BOTH = 2 * ALONE + 7
"""Number of features of a pair of overlapping detections."""

_HIDDEN = 48
_MEMBERS = 3  # number of averaged networks
_TOUCH = 0.1  # overlap, as a fraction of the smaller detection, above which a pair is evaluated
_COARSE = 544  # maximum pixels of the longer side at which masks are compared
_SURE = 0.3  # confidence above which another detection counts as covered
_APART = 0.35  # probability of being two objects, above which both detections of a pair stay


@dataclass(frozen=True, eq=False)
class EyeDetection:
    """A detected object: its confidences after the first and the second pass, and its masks.

    ``whole`` includes hidden parts. ``names`` are probabilities over the catalogue's categories,
    with "unknown" as the last entry.
    """

    first: float
    score: float
    visible: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"]
    names: Float[np.ndarray, "k"]


@dataclass(frozen=True, eq=False)
class Clues:
    """Features of n detections, and of their m overlapping pairs (the larger detection first)."""

    alone: Float[np.ndarray, "n a"]
    pairs: Int[np.ndarray, "m 2"]
    both: Float[np.ndarray, "m b"]


def _member(inward: int) -> nn.Sequential:
    """Return a small network with one logit as output."""
    return nn.Sequential(
        nn.Linear(inward, _HIDDEN), nn.ReLU(), nn.Dropout(0.1),
        nn.Linear(_HIDDEN, _HIDDEN), nn.ReLU(), nn.Linear(_HIDDEN, 1),
    )  # fmt: skip


class Panel(nn.Module):
    """An ensemble of small networks; ``mean`` and ``spread`` normalise the features."""

    mean: Tensor
    spread: Tensor

    def __init__(self, inward: int) -> None:
        super().__init__()
        self.register_buffer("mean", torch.zeros(inward))
        self.register_buffer("spread", torch.ones(inward))
        self.members = nn.ModuleList(_member(inward) for _ in range(_MEMBERS))

    def forward(self, clues: Tensor) -> Tensor:
        """Return each member's logits (members, n) for features (n, c)."""
        x = (clues - self.mean) / self.spread
        return torch.stack([member(x)[:, 0] for member in self.members])


class DetectionJudge(nn.Module):
    """The network for learned non-maximum suppression; see the module docstring."""

    def __init__(self) -> None:
        super().__init__()
        self.alone = Panel(ALONE)
        self.both = Panel(BOTH)

    @torch.inference_mode()
    def choose(self, clues: Clues, minimum: float) -> list[tuple[int, float]]:
        """Return the selected detections with their probabilities, by descending probability.

        A detection is selected with a probability of at least ``minimum``, unless it is probably
        the same as, or part of, a more probable one.
        """
        alone, both = (
            panel(torch.from_numpy(inputs)).mean(0).sigmoid().numpy()
            for panel, inputs in ((self.alone, clues.alone), (self.both, clues.both))
        )
        apart = np.ones((len(alone), len(alone)), bool)
        for (i, j), chance in zip(clues.pairs, both, strict=True):
            apart[i, j] = apart[j, i] = chance > _APART
        kept: list[int] = []
        for k in np.argsort(-alone, kind="stable"):
            if alone[k] >= minimum and apart[k, kept].all():
                kept.append(int(k))
        return [(k, float(alone[k])) for k in kept]


def clues_of(detections: Sequence[EyeDetection], region: Float[np.ndarray, "r h w"]) -> Clues:
    """Return the features of one picture's detections; ``region`` is ``EyeReading.region``."""
    if not detections:
        nothing = np.zeros((0, ALONE), np.float32), np.zeros((0, BOTH), np.float32)
        return Clues(nothing[0], np.zeros((0, 2), int), nothing[1])
    step = -(-max(region.shape[1:]) // _COARSE)
    shares = _Shares.of(detections, step)
    scores, names = np.array([f.score for f in detections]), np.stack([f.names for f in detections])
    below = region[:, ::step, ::step].reshape(len(region), -1)
    alone = np.column_stack(
        [
            _logit(scores),
            _logit(np.array([f.first for f in detections])),
            names[:, :-1].max(1),
            names[:, -1],
            -(names * np.log(names + 1e-9)).sum(1) / 3,
            _shape(detections, shares, step),
            (below @ shares.visible.T / shares.area).T,
            _company(shares, scores, names),
        ]
    ).astype(np.float32)
    pairs = shares.pairs()
    return Clues(alone, pairs, _together(alone, pairs, shares, names))


@dataclass(frozen=True, eq=False)
class _Shares:
    """Matrices of the pairwise overlaps of n detections, with zero diagonals.

    ``visible`` are the masks (as flat pixels at the reduced resolution); ``area`` and ``reach`` are
    the pixel counts of the visible and the whole masks. ``within`` is the fraction of the row's
    detection that the column's covers, ``behind`` the fraction of the column's detection that the
    row's whole mask covers, and ``overlap`` the IoU.
    """

    visible: Float[np.ndarray, "n p"]
    area: Float[np.ndarray, "n"]
    reach: Float[np.ndarray, "n"]
    within: Float[np.ndarray, "n n"]
    behind: Float[np.ndarray, "n n"]
    overlap: Float[np.ndarray, "n n"]

    @classmethod
    def of(cls, detections: Sequence[EyeDetection], step: int) -> _Shares:
        """Compute the overlaps of detections at every ``step``-th pixel."""
        visible, whole = (
            np.stack([mask[::step, ::step].ravel() for mask in masks]).astype(np.float32)
            for masks in ([f.visible for f in detections], [f.whole for f in detections])
        )
        area, shared = np.maximum(visible.sum(1), 1), visible @ visible.T
        within, behind = shared / area[:, None], whole @ visible.T / area[None]
        overlap = shared / (area[:, None] + area[None] - shared)
        for matrix in (within, behind, overlap):
            np.fill_diagonal(matrix, 0)
        return cls(visible, area, np.maximum(whole.sum(1), 1), within, behind, overlap)

    def pairs(self) -> Int[np.ndarray, "m 2"]:
        """Return the pairs of overlapping detections, each with the larger detection first."""
        i, j = np.nonzero(np.triu(np.maximum(self.within, self.within.T) > _TOUCH, 1))
        swap = self.area[i] < self.area[j]
        return np.column_stack([np.where(swap, j, i), np.where(swap, i, j)])


def _shape(
    detections: Sequence[EyeDetection], shares: _Shares, step: int
) -> Float[np.ndarray, "n 5"]:
    """Return each detection's size, aspect ratio, box fill, frame contact and hidden fraction."""
    masks = [f.visible for f in detections]
    boxes = np.array([mask_box(m) if m.any() else (0, 0, 1, 1) for m in masks], float)
    wide, tall = (boxes[:, 2:] - boxes[:, :2]).T
    return np.column_stack(
        [
            np.log(shares.area / shares.visible.shape[1]) / 3,
            np.log(wide / tall),
            shares.area * step**2 / (wide * tall),
            [_cut(mask) for mask in masks],
            np.log(shares.reach / shares.area),
        ]
    )


def _company(
    shares: _Shares, scores: Float[np.ndarray, "n"], names: Float[np.ndarray, "n k"]
) -> Float[np.ndarray, "n 16"]:
    """Return features of each detection relative to others: overlaps, scores, names and ranks."""
    named, count = names[:, :-1].max(1), len(scores)
    larger = shares.area[None] > shares.area[:, None]
    within, covers = shares.within, shares.within.T

    def most(part: Float[np.ndarray, "n n"]) -> list[Float[np.ndarray, "n"]]:
        other, share = part.argmax(1), part.max(1)
        touches = share > _TOUCH / 2
        return [share, np.where(touches, scores[other], 0), np.where(touches, named[other], 0)]

    return np.column_stack(
        [
            *most(within * larger),
            *most(covers * ~larger),
            *most(shares.overlap),
            *most(shares.behind * ~larger),
            (within > 0.5).sum(1) / 3,
            ((covers > 0.5) & (scores > _SURE)).sum(1) / 3,
            scores.argsort().argsort() / count,
            np.full(count, count / 20),
        ]
    )


def _together(
    alone: Float[np.ndarray, "n a"],
    pairs: Int[np.ndarray, "m 2"],
    shares: _Shares,
    names: Float[np.ndarray, "n k"],
) -> Float[np.ndarray, "m b"]:
    """Return features of pairs: those of both detections, their overlaps and name similarity."""
    i, j = pairs.T
    length = np.linalg.norm(names, axis=1)
    return np.column_stack(
        [
            alone[i],
            alone[j],
            shares.within[i, j],
            shares.within[j, i],
            shares.overlap[i, j],
            (names[i] * names[j]).sum(1) / (length[i] * length[j]),
            np.log(shares.area[i] / shares.area[j]),
            shares.behind[i, j],
            shares.behind[j, i],
        ]
    ).astype(np.float32)


def _logit(chance: Float[np.ndarray, "n"]) -> Float[np.ndarray, "n"]:
    inside = np.clip(chance, 1e-4, 1 - 1e-4)
    return np.log(inside / (1 - inside))


def _cut(mask: Bool[np.ndarray, "h w"]) -> bool:
    """Return whether a mask reaches the picture's frame."""
    return bool(mask[0].any() or mask[-1].any() or mask[:, 0].any() or mask[:, -1].any())
