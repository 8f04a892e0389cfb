"""Detection of the table, of the objects (with masks and names), and of the view in one picture.

There are four passes: the whole picture gives detections, and a crop around each refines its mask;
crops of the selected objects refine their outlines, and close-ups give their names.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import cv2
import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8
from torch import Tensor
from torch.nn import functional

from ....geometry import mask_box
from ....threads import single_thread
from .closeups import Closeup, closeup, impressions
from .detections import FAINT, Detections, answers, ask, tensor
from .frames import Frame
from .judge import EyeDetection, clues_of
from .network import REGIONS, STRIDE, Eye, Maps
from .outlines import outline_things
from .weights import Weights, load_judge, load_weights

SIDES = (544, 704)
"""Minimum and maximum length in pixels of the picture's longer side in the first pass."""

CLOSE = 192
"""Side length of the crops in pixels."""

_ROOM = 1.6  # crop size relative to the longer side of the object's box
_ASKED = 24  # cells of a crop that are decoded for additional objects
_CHOICES = 4  # cells of a crop that are decoded for its object
_HELD = 0.75  # minimum fraction of the first detection that the refined one covers
_YIELD = 0.6  # minimum confidence of the refined detection, relative to the first one
_LEAST = 0.15  # minimum confidence of reported objects
_SAME = 0.6  # overlap (IoU) above which two detections are the same
_NEAR = 0.15  # minimum confidence of objects that only a crop shows
_INSIDE = 0.3  # minimum fraction of such an object within the crop's own object
_MOST = 16  # such detections
_NAMELESS = np.zeros(0)


@dataclass(frozen=True, eq=False)
class EyeReading:
    """The detections in a picture; all maps have the picture's size.

    ``region``: probabilities of background, the table's top surface, the rest of the table, and
    objects. ``top``: probability of the tabletop, including the area under objects. ``latitude``:
    each pixel's angle below the horizon in radians.
    """

    things: tuple[EyeDetection, ...]
    region: Float[np.ndarray, "4 h w"]
    top: Float[np.ndarray, "h w"]
    latitude: Float[np.ndarray, "h w"]

    def shows(self, *kinds: str) -> Bool[np.ndarray, "h w"]:
        """Return the pixels whose most probable region is one of the given ``REGIONS``."""
        return np.isin(self.region.argmax(0), [REGIONS.index(kind) for kind in kinds])


def look(image: UInt8[np.ndarray, "h w 3"], minimum: float = 0.4) -> EyeReading:
    """Detect objects with a confidence of at least ``minimum``.

    Raises:
        BackendError: the weights are missing or damaged.
    """
    weights = load_weights()
    glance = glance_at(weights, image)
    with single_thread(), torch.inference_mode():
        chosen = load_judge().choose(clues_of(glance.things, glance.region), minimum)
        found = [replace(glance.things[k], score=sure) for k, sure in chosen]
        found = outline_things(weights.eye, image, found)
        tabletop = float((glance.top > 0.5).sum())
        names = name_all(weights, image, [thing.visible for thing in found], tabletop)
    shown = split_shared([thing.visible for thing in found])
    things = tuple(
        replace(thing, visible=visible, names=likely)
        for thing, visible, likely in zip(found, shown, names, strict=True)
        if visible.any()
    )
    return replace(glance, things=things)


def split_shared(masks: Sequence[Bool[np.ndarray, "h w"]]) -> list[Bool[np.ndarray, "h w"]]:
    """Return disjoint masks; shared pixels go to the smaller mask, whose object is in front."""
    shown = list(masks)
    taken = np.zeros_like(masks[0]) if masks else np.zeros(0, bool)
    for k in sorted(range(len(masks)), key=lambda k: int(masks[k].sum())):
        shown[k] = masks[k] & ~taken
        taken |= masks[k]
    return shown


def glance_at(weights: Weights, image: UInt8[np.ndarray, "h w 3"]) -> EyeReading:
    """Return all detections of a picture after the second pass, before selection."""
    height, width = image.shape[:2]
    factor = float(np.clip(max(height, width), *SIDES)) / max(height, width)
    small = _resize(image, factor)
    with single_thread(), torch.inference_mode():
        maps = weights.eye(tensor(_pad(small)))

        def full(x: Tensor) -> np.ndarray:
            return _enlarge(x, small.shape[:2], (height, width))

        top = full(maps.top[0].sigmoid())[0]
        region, latitude = full(maps.region[0].softmax(0)), full(maps.latitude[0])[0]
        seen = _closer(weights.eye, image, ask(weights.eye, maps, small.shape[:2]), factor)
        names = name_all(weights, image, [x.visible for x in seen], float((top > 0.5).sum()))
    detections = tuple(replace(x, names=n) for x, n in zip(seen, names, strict=True))
    return EyeReading(detections, region, top, latitude)


def see(image: UInt8[np.ndarray, "h w 3"]) -> EyeReading:
    """Return the result of :func:`look` with a low threshold; the latest results are cached."""
    return _read(image.tobytes(), image.shape[:2])


@lru_cache(maxsize=4)  # the number of drawings evaluated per text, plus one
def _read(pixels: bytes, size: tuple[int, int]) -> EyeReading:
    return look(np.frombuffer(pixels, np.uint8).reshape(*size, 3), minimum=_LEAST)


def _resize(image: UInt8[np.ndarray, "h w 3"], factor: float) -> UInt8[np.ndarray, "a b 3"]:
    size = max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor))
    way = cv2.INTER_AREA if factor < 1 else cv2.INTER_LINEAR
    return cv2.resize(image, size, interpolation=way)


def _pad(image: UInt8[np.ndarray, "h w 3"]) -> UInt8[np.ndarray, "a b 3"]:
    """Pad a picture to multiples of 32 pixels by repeating its last row and column."""
    down, right = -image.shape[0] % 32, -image.shape[1] % 32
    return cv2.copyMakeBorder(image, 0, down, 0, right, cv2.BORDER_REPLICATE)


def _enlarge(x: Tensor, seen: tuple[int, ...], size: tuple[int, int]) -> np.ndarray:
    """Resample maps (c, h, w) of a padded picture, at any stride, to the picture's size."""
    stride = -(-(seen[0]) // 32) * 32 / x.shape[1]
    big = functional.interpolate(x[None].float(), scale_factor=stride, mode="bilinear")[0]
    big = big[:, : seen[0], : seen[1]]
    return functional.interpolate(big[None], size=size, mode="bilinear")[0].numpy()


def _closer(
    eye: Eye, image: UInt8[np.ndarray, "h w 3"], detections: Detections, factor: float
) -> list[EyeDetection]:
    """Refine all detections in crops, and add objects that only the crops show.

    If a crop shows nothing more confident, the first detection is kept.
    """
    if not len(detections.score):
        return []
    frames = [_frame(masks, factor) for masks in detections.masks]
    maps = eye(tensor(*[frame.cut(image) for frame in frames]))
    size = image.shape[:2]
    seen, more = [], []
    for k, frame in enumerate(frames):
        carried = [frame.carry(m, factor, STRIDE, STRIDE) for m in detections.masks[k].numpy()]
        first = float(detections.score[k])
        thing = torch.from_numpy(np.stack(carried))
        score, masks = _choose(eye, maps, k, first, thing)
        if score > FAINT:
            seen.append(EyeDetection(first, score, *spread(frame, masks, size), _NAMELESS))
        near = ask(eye, maps, (CLOSE, CLOSE), k, _ASKED)
        drawn = near.masks[:, 0] > 0.5
        held = (drawn & (thing.amax(0) > 0.5)).sum((1, 2)) > _INSIDE * drawn.sum((1, 2))
        clues = zip(near.score.tolist(), near.masks, held.tolist(), strict=True)
        more += [(score, frame, masks) for score, masks, in_it in clues if in_it and score > _NEAR]
    more.sort(key=lambda found: -found[0])
    return _new([f for f in seen if f.visible.any()], more, size)


def _new(
    seen: list[EyeDetection], more: list[tuple[float, Frame, Tensor]], size: tuple[int, ...]
) -> list[EyeDetection]:
    """Return ``seen`` extended by the crops' detections, without duplicates."""
    taken = [(detection.visible, int(detection.visible.sum())) for detection in seen]
    new: list[EyeDetection] = []
    for score, frame, masks in more:
        visible, whole = spread(frame, masks, size)
        area = int(visible.sum())
        if not area:
            continue
        x0, y0, x1, y1 = mask_box(visible).astype(int)
        window = np.s_[y0:y1, x0:x1]
        inside = visible[window]
        shared = ((int((inside & mask[window]).sum()), other) for mask, other in taken)
        if all(both < _SAME * (area + other - both) for both, other in shared):
            taken.append((visible, area))
            new.append(EyeDetection(0.0, score, visible, whole, _NAMELESS))
        if len(new) == _MOST:
            break
    return seen + new


def spread(
    frame: Frame, masks: Tensor, size: tuple[int, ...]
) -> tuple[Bool[np.ndarray, "h w"], Bool[np.ndarray, "h w"]]:
    """Return a crop's visible and whole masks, mapped to a picture of ``size`` (h, w)."""
    fine = functional.interpolate(masks[None], size=(frame.side, frame.side), mode="bilinear")[0]
    visible, whole = frame.spread(fine.numpy(), size)
    return visible, visible | whole


def _frame(masks: Tensor, factor: float) -> Frame:
    """Return the frame around a detection's masks (2, h, w), given in cells of the first pass."""
    low, high = mask_box((masks.amax(0) > 0.5).numpy()).reshape(2, 2) * STRIDE / factor
    return Frame.around(low, high, CLOSE, _ROOM, 32 / factor)


def _choose(eye: Eye, maps: Maps, k: int, score: float, first: Tensor) -> tuple[float, Tensor]:
    """Return the best detection in crop ``k`` that covers ``first``, or else ``first`` itself."""
    wanted = first[0] > 0.5
    heat, place = (maps.heat[k, 0].sigmoid() * wanted).flatten().topk(_CHOICES)
    place = place[heat > FAINT]
    width = wanted.shape[1]
    cells = torch.stack([place % width, place // width], 1)
    detections = answers(eye, maps, torch.full((len(cells),), k), cells)
    drawn = detections.masks[:, 0] > 0.5
    held = (drawn & wanted).sum((1, 2)) / wanted.sum().clamp(min=1)
    sure = detections.score * (held > _HELD)
    if not len(sure) or float(sure.max()) < _YIELD * score:
        return score, first
    best = int(sure.argmax())
    return (score * float(sure[best])) ** 0.5, detections.masks[best]


def name_all(
    weights: Weights,
    image: UInt8[np.ndarray, "h w 3"],
    masks: Sequence[Bool[np.ndarray, "h w"]],
    tabletop: float,
) -> list[Float[np.ndarray, "_k"]]:
    """Return the name probabilities of objects; ``tabletop`` is in pixels."""
    if not masks:
        return []
    return name_closeups(weights, [closeup(image, mask, tabletop) for mask in masks])


def name_closeups(weights: Weights, looks: Sequence[Closeup]) -> list[Float[np.ndarray, "_k"]]:
    """Return the name probabilities of close-ups."""
    logits = weights.eye.namer(impressions(weights.eye, looks)).mean(0)
    return list((logits / weights.temperature).softmax(1).numpy())
