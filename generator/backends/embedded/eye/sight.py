"""What the eye sees in one picture: the table, the things with their masks and names, the view.

Three looks: the whole picture finds things; each thing is looked at again, closer, for a finer
mask; and once more, alone, for its name.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8
from torch import Tensor
from torch.nn import functional

from .closeups import closeup
from .frames import Frame
from .network import REGIONS, STRIDE, Eye, Maps
from .weights import Weights, load_weights

SIDE = 544
"""Longer side in pixels that a picture is looked at with."""

_CLOSE = 192  # side of the closer looks
_ROOM = 1.6  # side of a closer look over the longer side of the thing's box
_FAINT = 0.1  # certainty below which a cell is not asked
_KEPT = 72  # finds looked at again
_CHOICES = 4  # cells of a closer look that are asked
_HELD = 0.75  # share of a first find that a closer one must show
_YIELD = 0.6  # of the first look's certainty, which the closer one must have
_LEAST = 0.15  # certainty of a thing that is told at all
_MOST = 200  # cells asked
_SAME = 0.6  # overlap (IoU) at which two masks of the first look are one thing
_PART = 0.65  # share of a find within another from which it may be a part of it
_ALIKE = 0.7  # share of the part's certainty that the whole must have
_INNER = 0.08  # certainty of a find within another
_SHARED = 0.35  # share of the smaller of two finds that both claim, at which the surer one stands


@dataclass(frozen=True, eq=False)
class Thing:
    """Something on the table. Masks are at picture size; ``whole`` includes what is hidden.

    ``names`` are probabilities over the catalogue's categories and, last, "unknown".
    """

    score: float
    visible: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"]
    names: Float[np.ndarray, "k"]


@dataclass(frozen=True, eq=False)
class Sight:
    """A picture, read. Maps are at picture size.

    ``region``: probabilities of background, the table's upper side, the rest of the table, and
    things. ``top``: probability that the tabletop is there, things on it or not. ``latitude``:
    each pixel's angle below the horizon, radians. ``inner`` are finds within one of ``things``:
    what is in or on it, or parts of it; only who expects something there can tell.
    """

    things: tuple[Thing, ...]
    region: Float[np.ndarray, "4 h w"]
    top: Float[np.ndarray, "h w"]
    latitude: Float[np.ndarray, "h w"]
    inner: tuple[Thing, ...] = ()

    def shows(self, *kinds: str) -> Bool[np.ndarray, "h w"]:
        """Return the pixels that most likely show one of these ``REGIONS``."""
        return np.isin(self.region.argmax(0), [REGIONS.index(kind) for kind in kinds])


@dataclass(frozen=True, eq=False)
class _Seen:
    """One thing, with masks at picture size."""

    score: float
    visible: Bool[np.ndarray, "h w"]
    whole: Bool[np.ndarray, "h w"]


@dataclass(frozen=True, eq=False)
class _Finds:
    """Things in cells of one look, surest first: how sure, mask probabilities (n, 2, h, w)."""

    score: Tensor
    masks: Tensor

    def __getitem__(self, kept: list[int]) -> _Finds:
        return _Finds(self.score[kept], self.masks[kept])


def look(image: UInt8[np.ndarray, "h w 3"], least: float = 0.4) -> Sight:
    """Read a picture; things less certain than ``least`` are left out.

    Raises:
        BackendError: the weights are missing or damaged.
    """
    weights = load_weights()
    height, width = image.shape[:2]
    factor = SIDE / max(height, width)
    small = _resized(image, factor)
    with torch.inference_mode():
        maps = weights.eye(_tensor(_padded(small)))
        finds = _finds(weights.eye, maps, small.shape[:2])
        seen, inner = _closer(weights.eye, image, finds, factor)
        inner += seen
        seen = _sure(seen, least)
        inner = _within(inner, seen)

        def full(x: Tensor) -> np.ndarray:
            return _enlarged(x, small.shape[:2], (height, width))

        top = full(maps.top[0].sigmoid())[0]
        every = seen + inner
        names = _named(weights, image, [x.visible for x in every], float((top > 0.5).sum()))
    things = tuple(
        Thing(x.score, x.visible, x.whole, name) for x, name in zip(every, names, strict=True)
    )
    told, within = things[: len(seen)], things[len(seen) :]
    region, latitude = full(maps.region[0].softmax(0)), full(maps.latitude[0])[0]
    return Sight(told, region, top, latitude, within)


def see(image: UInt8[np.ndarray, "h w 3"]) -> Sight:
    """Return what :func:`look` sees, also of what is hardly certain; the last sights are kept."""
    return _seen(image.tobytes(), image.shape[:2])


@lru_cache(maxsize=2)
def _seen(pixels: bytes, size: tuple[int, int]) -> Sight:
    return look(np.frombuffer(pixels, np.uint8).reshape(*size, 3), least=_LEAST)


def _resized(image: UInt8[np.ndarray, "h w 3"], factor: float) -> UInt8[np.ndarray, "a b 3"]:
    size = max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor))
    way = cv2.INTER_AREA if factor < 1 else cv2.INTER_LINEAR
    return cv2.resize(image, size, interpolation=way)


def _padded(image: UInt8[np.ndarray, "h w 3"]) -> UInt8[np.ndarray, "a b 3"]:
    """Fill up to multiples of 32 by repeating the last row and column."""
    down, right = -image.shape[0] % 32, -image.shape[1] % 32
    return cv2.copyMakeBorder(image, 0, down, 0, right, cv2.BORDER_REPLICATE)


def _tensor(*images: UInt8[np.ndarray, "h w 3"]) -> Tensor:
    batch = torch.from_numpy(np.stack(images)).permute(0, 3, 1, 2).float() / 255
    return batch.contiguous(memory_format=torch.channels_last)


def _enlarged(x: Tensor, seen: tuple[int, ...], size: tuple[int, int]) -> np.ndarray:
    """Carry maps (c, h, w) of any stride over a padded look to the picture's size."""
    stride = -(-(seen[0]) // 32) * 32 / x.shape[1]
    big = functional.interpolate(x[None].float(), scale_factor=stride, mode="bilinear")[0]
    big = big[:, : seen[0], : seen[1]]
    return functional.interpolate(big[None], size=size, mode="bilinear")[0].numpy()


def _finds(eye: Eye, maps: Maps, seen: tuple[int, ...], owner: int = 0) -> _Finds:
    """Ask look ``owner``'s cells that are surest to lie within things; keep one find a thing."""
    heat = maps.heat[owner : owner + 1].sigmoid()
    peaks = heat * (functional.max_pool2d(heat, 3, 1, 1) == heat)
    peaks[..., -(-seen[0] // STRIDE) :, :] = 0
    peaks[..., -(-seen[1] // STRIDE) :] = 0
    score, place = peaks[0, 0].flatten().topk(min(_MOST, peaks.numel()))
    place = place[score > _FAINT]
    cells = torch.stack([place % heat.shape[3], place // heat.shape[3]], 1)
    finds = _answers(eye, maps, torch.full((len(cells),), owner), cells)
    overlap, _ = _overlaps(finds.masks[:, 0] > 0.5)
    return finds[_apart(finds.score, overlap > _SAME)[:_KEPT]]


def _answers(eye: Eye, maps: Maps, owner: Tensor, cells: Tensor) -> _Finds:
    """Return what cells answer; sure is who lies within a thing and drew all of it."""
    box = maps.box[owner, :, cells[:, 1], cells[:, 0]].exp()
    masks = eye.masks(maps, owner, cells, (box[:, :2] + box[:, 2:4]).amax(1)).sigmoid()
    heat = maps.heat[owner, 0, cells[:, 1], cells[:, 0]].sigmoid()
    quality = eye.quality(maps, owner, cells, masks[:, 0]).sigmoid()
    shows = (masks[:, 0] > 0.5).sum((1, 2)) > 1
    return _Finds(heat.sqrt() * quality * shows, masks)


def _overlaps(masks: Tensor) -> tuple[Tensor, Tensor]:
    """Return, of masks (n, h, w), their overlap (IoU) and the share of each that others cover."""
    flat = masks.flatten(1).float()
    area = flat.sum(1).clamp(min=1)[:, None]
    both = flat @ flat.T
    return both / (area + area.T - both), both / area


def _apart(score: Tensor, clash: Tensor) -> list[int]:
    """Return finds that do not clash (n, n) with a surer one, surest first."""
    kept: list[int] = []
    for k in score.argsort(descending=True).tolist():
        if score[k] > 0 and not clash[k, kept].any():
            kept.append(k)
    return kept


def _closer(
    eye: Eye, image: UInt8[np.ndarray, "h w 3"], finds: _Finds, factor: float
) -> tuple[list[_Seen], list[_Seen]]:
    """Look at all finds again from near; where that shows nothing surer, the first look stands.

    Returns also what else shows within them from near.
    """
    if not len(finds.score):
        return [], []
    frames = [_frame(masks, factor) for masks in finds.masks]
    maps = eye(_tensor(*[frame.cut(image) for frame in frames]))

    def full(frame: Frame, score: float, masks: Tensor) -> _Seen:
        fine = functional.interpolate(masks[None], size=(_CLOSE, _CLOSE), mode="bilinear")[0]
        visible, whole = frame.spread(fine.numpy(), image.shape[:2])
        return _Seen(score, visible, visible | whole)

    seen, inner = [], []
    for k, frame in enumerate(frames):
        carried = [frame.carried(m, factor, STRIDE, STRIDE) for m in finds.masks[k].numpy()]
        first = torch.from_numpy(np.stack(carried))
        score, masks = _chosen(eye, maps, k, float(finds.score[k]), first)
        seen.append(full(frame, score, masks))
        others = _finds(eye, maps, (_CLOSE, _CLOSE), k)
        drawn = others.masks[:, 0] > 0.5
        held = (drawn & (first[0] > 0.5)).sum((1, 2)) / drawn.sum((1, 2)).clamp(min=1)
        wanted = ((others.score > _INNER) & (held > _PART)).nonzero()[:, 0].tolist()
        inner += [full(frame, float(others.score[j]), others.masks[j]) for j in wanted]
    return seen, inner


def _frame(masks: Tensor, factor: float) -> Frame:
    """Return the frame around a find's masks (2, h, w), in cells of the first look."""
    covered = (masks.amax(0) > 0.5).numpy()
    rows, columns = np.flatnonzero(covered.any(1)), np.flatnonzero(covered.any(0))
    low = np.array([columns[0], rows[0]]) * STRIDE / factor
    high = np.array([columns[-1] + 1, rows[-1] + 1]) * STRIDE / factor
    return Frame.around(low, high, _CLOSE, _ROOM, 32 / factor)


def _chosen(eye: Eye, maps: Maps, k: int, score: float, first: Tensor) -> tuple[float, Tensor]:
    """Return look ``k``'s surest find that shows most of the first look's, or that one."""
    wanted = first[0] > 0.5
    heat, place = (maps.heat[k, 0].sigmoid() * wanted).flatten().topk(_CHOICES)
    place = place[heat > _FAINT]
    width = wanted.shape[1]
    cells = torch.stack([place % width, place // width], 1)
    finds = _answers(eye, maps, torch.full((len(cells),), k), cells)
    drawn = finds.masks[:, 0] > 0.5
    held = (drawn & wanted).sum((1, 2)) / wanted.sum().clamp(min=1)
    sure = finds.score * (held > _HELD)
    if not len(sure) or float(sure.max()) < _YIELD * score:
        return score, first
    best = int(sure.argmax())
    return (score * float(sure[best])) ** 0.5, finds.masks[best]


def _sure(seen: list[_Seen], least: float) -> list[_Seen]:
    """Keep what is sure enough, one a thing, surest first; a little that two claim, it has."""
    if not seen:
        return []
    score = torch.tensor([x.score if x.score >= least else 0.0 for x in seen])
    _, within = _overlaps(torch.from_numpy(np.stack([x.visible for x in seen])))
    shared = torch.maximum(within, within.T)
    score = _wholes_first(score, within, shared > _SHARED)
    kept = _apart(score, shared > _SHARED)
    taken = np.zeros_like(seen[0].visible)
    found = []
    for k in kept:
        visible = seen[k].visible & ~taken
        taken |= visible
        found.append(_Seen(float(score[k]), visible, seen[k].whole))
    return found


def _within(found: list[_Seen], told: list[_Seen]) -> list[_Seen]:
    """Return the finds that lie within one that is told, surest first and apart from each other."""
    kept: list[_Seen] = []
    for x in sorted(found, key=lambda x: -x.score):
        area = int(x.visible.sum())
        if x.score < _INNER or not area:
            continue
        held = any(
            (x.visible & t.visible).sum() > _PART * area and area < _PART * t.visible.sum()
            for t in told
        )
        shared = (
            (x.visible & o.visible).sum() / max(min(area, int(o.visible.sum())), 1) for o in kept
        )
        if held and all(share < _SHARED for share in shared):
            kept.append(x)
    return kept


def _wholes_first(score: Tensor, within: Tensor, clash: Tensor) -> Tensor:
    """Return scores (n) that make a thing as sure as its part, if it is about as sure itself.

    ``within`` (n, n) is the share of each find that others cover. Surer finds that stand apart from
    each other within a third are two things, not parts of one.
    """
    first = score.clone()
    for k in range(len(score)):
        held = (within[:, k] > _PART) & (within[k] < _PART) & (score >= score[k]) & (score > 0)
        parts = held.nonzero()[:, 0]
        if len(parts) and clash[parts][:, parts].all():
            surest = float(score[parts].max())
            if float(score[k]) > _ALIKE * surest:
                first[k] = surest + 1e-4
    return first


def _named(
    weights: Weights,
    image: UInt8[np.ndarray, "h w 3"],
    masks: Sequence[Bool[np.ndarray, "h w"]],
    tabletop: float,
) -> list[Float[np.ndarray, "k"]]:
    """Return the probabilities of the names of things; ``tabletop`` in pixels."""
    if not masks:
        return []
    looks = [closeup(image, mask, tabletop) for mask in masks]
    pictures = _tensor(*[look.image for look in looks])
    visible = torch.from_numpy(np.stack([look.visible for look in looks]))
    told = torch.tensor([look.hints for look in looks])
    logits = weights.eye.names(pictures, visible, told)
    turned = weights.eye.names(pictures.flip(3), visible.flip(2), told)
    return list(((logits + turned) / 2 / weights.temperature).softmax(1).numpy())
