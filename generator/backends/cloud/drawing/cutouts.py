"""One thing cut out of the picture, and its redrawing put back to where it was cut out."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy import signal

from ....geometry import mask_box
from ....meshes.pixels import Mask, dilate, erode, nearest_inside
from ....scene import TABLE, Detection, Instance, Reference
from ..server.json_text import Wrong
from .pictures import RGBA, apart, thing_in

SIDE = 1024
"""Pixels of a cut-out's side."""

_ROOM = 1.4  # side of the cut-out, times the longer side of the thing's box
_MARGIN = 0.04  # of a crop's longer side, around the thing
_COARSE = 128  # pixels at which a redrawing is put in place
_SCALES = np.geomspace(0.8, 1.25, 11)
_FINE = np.linspace(0.97, 1.03, 7)  # around the best of these, at twice the pixels
_MOVED = 0.05  # what a change of size costs, so that none is made for nothing
_COVERED = 0.6  # least share of what was seen that the redrawing covers
_BEYOND = 0.6  # most that it covers beside, as a share of that
_EDGE = 2.5  # reference pixels beside what was seen that are no hidden part yet
_HIDDEN = 0.02  # share of what was seen from which a thing counts as hidden in part

_GROUNDS = {"white": (255, 255, 255), "grey": (128, 128, 128), "pure green": (0, 220, 60),
            "magenta": (225, 0, 200)}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Cutout:
    """A square of the picture with one thing on a plain ground.

    ``box`` is the square in reference pixels (it may leave the picture). ``seen`` is where the
    thing shows, ``unknown`` where something hides it, if it is there, or the picture ends.
    ``ground`` names the colour of everything else, one that the thing does not have.
    """

    detection: Detection
    box: Float[np.ndarray, "4"]
    picture: UInt8[np.ndarray, "s s 3"]
    seen: Mask
    unknown: Mask
    ground: str

    @property
    def keep(self) -> UInt8[np.ndarray, "s s 4"]:
        """The mask of an edit: opaque where the picture must stay, clear where it is drawn."""
        return np.dstack([self.picture, np.where(erode(self.seen, 5), 255, 0).astype(np.uint8)])


def cut(reference: Reference, detection: Detection, others: tuple[Detection, ...]) -> Cutout:
    """Return the cut-out of a detection."""
    x0, y0, x1, y1 = detection.box
    half = _ROOM * max(x1 - x0, y1 - y0) / 2
    middle = np.array([x0 + x1, y0 + y1]) / 2
    box = np.concatenate([middle - half, middle + half])
    scale = SIDE / (2 * half)
    shift = -box[:2] * scale + scale / 2 - 0.5
    warp = np.array([[scale, 0, shift[0]], [0, scale, shift[1]]])

    def move(mask: np.ndarray) -> Mask:
        there = cv2.warpAffine(mask.astype(np.uint8) * 255, warp, (SIDE, SIDE))
        return there > 127

    image = np.ascontiguousarray(reference.image)
    colors = cv2.warpAffine(image, warp, (SIDE, SIDE), flags=cv2.INTER_CUBIC)
    seen = move(np.asarray(detection.mask))
    everywhere = np.ones(image.shape[:2], bool)
    hiders = (o.mask for o in others if o.label != TABLE)  # it hides nothing that stands on it
    unknown = move(np.any([~everywhere, *hiders], axis=0)) | ~move(everywhere)
    name = _ground(colors[seen])
    picture = np.where(seen[..., None], colors, np.array(_GROUNDS[name], np.uint8))
    return Cutout(detection, box, picture.astype(np.uint8), seen, unknown & ~seen, name)


def _ground(colors: UInt8[np.ndarray, "n 3"]) -> str:
    """Return the ground that is farthest from a thing's colours, nearly all of them."""

    def off(name: str) -> float:
        return float(np.percentile(apart(colors, _GROUNDS[name]), 3)) if len(colors) else 0.0

    return max(_GROUNDS, key=lambda name: min(off(name), 80.0))


def put_back(redrawn: RGBA, cutout: Cutout) -> Instance:
    """Return the instance of a redrawn cut-out: whole, clean, on nothing, where it was.

    Image models move and resize what they draw again; it is moved to cover what was seen of the
    thing, and little that certainly is something else.

    Raises:
        Wrong: it is not drawn alone, or is not the thing that was cut out.
    """
    square = _square(redrawn)
    mask = thing_in(square)
    scale, shift = _register(mask, cutout)
    box = mask_box(mask)
    margin = max(2.0, _MARGIN * float((box[2:] - box[:2]).max()))
    side = square.shape[0]
    low = np.clip(np.floor(box[:2] - margin), 0, side).astype(int)
    high = np.clip(np.ceil(box[2:] + margin), 0, side).astype(int)
    window = np.s_[low[1] : high[1], low[0] : high[0]]
    crop = _clean(square[window], mask[window])
    pixel = (cutout.box[2] - cutout.box[0]) / side  # reference pixels in one of the redrawing

    def there(point: np.ndarray) -> np.ndarray:
        return cutout.box[:2] + (side / 2 + (point - side / 2) * scale + shift * side) * pixel

    found = cutout.detection
    edge = 2 * max(1, round(_EDGE / pixel * SIDE / side)) + 1
    deep = cutout.unknown & ~dilate(cutout.seen, edge)
    hidden = (_place(mask, scale, shift, SIDE) & deep).sum()
    crop_box, label = np.concatenate([there(low), there(high)]), found.label
    occluded = bool(hidden > _HIDDEN * cutout.seen.sum())
    return Instance(label, label, found.box, found.mask, crop, crop_box, occluded, found.score)


def _square(picture: RGBA) -> RGBA:
    """Return a picture made square by stretching its own edges outward."""
    height, width = picture.shape[:2]
    side = max(height, width)
    x, y = (side - width) // 2, (side - height) // 2
    around = (y, side - height - y, x, side - width - x)
    return cv2.copyMakeBorder(picture, *around, cv2.BORDER_REPLICATE)


def _register(mask: Mask, cutout: Cutout) -> tuple[float, Float[np.ndarray, "2"]]:
    """Return the size and the shift (shares of the side) that put a redrawing in place."""
    scale, _ = _best(mask, cutout, _SCALES, _COARSE)
    scale, shift = _best(mask, cutout, _FINE * scale, 2 * _COARSE)
    seen, worth = _worth(cutout, _COARSE)
    own = _place(mask, scale, shift, _COARSE)
    covered = float((own & seen).sum() / max(seen.sum(), 1))
    beyond = float((own & (worth < 0)).sum() / max(seen.sum(), 1))
    if covered < _COVERED or beyond > _BEYOND:
        raise Wrong(
            f"what was drawn covers {covered:.0%} of the thing that was cut out, and {beyond:.0%} "
            "beside it: its shape is another."
        )
    return scale, shift


def _best(
    mask: Mask, cutout: Cutout, scales: Float[np.ndarray, "k"], side: int
) -> tuple[float, Float[np.ndarray, "2"]]:
    """Return the scale of some, and the shift, that gain most at a resolution of ``side``."""
    seen, worth = _worth(cutout, side)
    best = (-np.inf, 1.0, np.zeros(2))
    for scale in scales.tolist():
        own = _place(mask, scale, np.zeros(2), side).astype(float)
        gain = signal.fftconvolve(worth, own[::-1, ::-1], mode="full") / max(seen.sum(), 1)
        row, column = np.unravel_index(int(np.argmax(gain)), gain.shape)
        value = float(gain[row, column]) - _MOVED * abs(float(np.log(scale)))
        if value > best[0]:
            best = (value, scale, (np.array([column, row]) - (side - 1)) / side)
    return best[1], best[2]


def _worth(cutout: Cutout, side: int) -> tuple[Mask, Float[np.ndarray, "s s"]]:
    """Return where the thing is seen, and what covering a pixel gains: -1 where it is not."""
    seen = _small(cutout.seen, side)
    return seen, np.where(seen, 1.0, np.where(_small(cutout.unknown, side), 0.0, -1.0))


def _small(mask: Mask, side: int) -> Mask:
    return cv2.resize(mask.astype(np.float32), (side, side), interpolation=cv2.INTER_AREA) > 0.5


def _place(
    mask: Mask, scale: float, shift: Float[np.ndarray, "2"], side: int
) -> Bool[np.ndarray, "c c"]:
    """Return a mask at another resolution, resized about its middle and moved."""
    factor = side / mask.shape[0] * scale
    small = cv2.resize(
        mask.astype(np.float32), None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA
    )
    corner = (side - np.array(small.shape[::-1])) / 2 + np.asarray(shift) * side
    warp = np.array([[1, 0, corner[0]], [0, 1, corner[1]]])
    return cv2.warpAffine(small, warp, (side, side)) > 0.5


def _clean(picture: RGBA, mask: Mask) -> RGBA:
    """Return a crop with a soft edge, and beyond it the colours of the thing, not the ground's."""
    core = cv2.erode(mask.astype(np.uint8), np.ones((5, 5), np.uint8), borderValue=0) > 0
    core = core if core.sum() > 9 else mask
    colors = picture[..., :3][nearest_inside(core)]
    soft = cv2.GaussianBlur(mask.astype(np.float32), (0, 0), 0.9)
    alpha = np.round(255 * np.clip((soft - 0.25) / 0.5, 0, 1)).astype(np.uint8)
    return np.dstack([colors, alpha])
