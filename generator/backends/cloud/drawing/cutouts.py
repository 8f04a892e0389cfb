"""Cut-outs of single objects from the picture, and the registration of their redrawn versions."""

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
"""Side length of a cut-out in pixels."""

_ROOM = 1.4  # side of the cut-out, relative to the longer side of the object's box
_MARGIN = 0.04  # margin around the object, as a fraction of the crop's longer side
_COARSE = 128  # resolution of the registration in pixels
_SCALES = np.geomspace(0.8, 1.25, 11)
_FINE = np.linspace(0.97, 1.03, 7)  # scales around the best coarse one, at twice the resolution
_MOVED = 0.05  # penalty on the scale, so that it changes only for a reason
_COVERED = 0.6  # minimum fraction of the visible region that the redrawn object covers
_BEYOND = 0.6  # maximum area covered outside of it, as a fraction of the visible region
_EDGE = 2.5  # reference pixels around the visible region that do not count as a hidden part
_HIDDEN = 0.02  # hidden area, as a fraction of the visible one, above which an object is occluded

_GROUNDS = {"white": (255, 255, 255), "grey": (128, 128, 128), "pure green": (0, 220, 60),
            "magenta": (225, 0, 200)}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Cutout:
    """A square part of the picture with one object on a uniform background.

    ``box`` is the square in reference pixels (it may exceed the picture). ``seen`` is the visible
    region of the object; ``unknown`` is where something may hide it or the picture ends. ``ground``
    names the background colour, one that does not occur in the object.
    """

    detection: Detection
    box: Float[np.ndarray, "4"]
    picture: UInt8[np.ndarray, "s s 3"]
    seen: Mask
    unknown: Mask
    ground: str

    @property
    def keep(self) -> UInt8[np.ndarray, "s s 4"]:
        """The cut-out as RGBA, opaque where it is kept and transparent where it is redrawn."""
        return np.dstack([self.picture, np.where(erode(self.seen, 5), 255, 0).astype(np.uint8)])


def cut(reference: Reference, detection: Detection, others: tuple[Detection, ...]) -> Cutout:
    """Return a square cut-out of a detected object on a uniform background."""
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
    # objects on the table do not count as hiding the table
    hiders = (o.mask for o in others if o.label != TABLE)
    unknown = move(np.any([~everywhere, *hiders], axis=0)) | ~move(everywhere)
    name = _ground(colors[seen])
    picture = np.where(seen[..., None], colors, np.array(_GROUNDS[name], np.uint8))
    return Cutout(detection, box, picture.astype(np.uint8), seen, unknown & ~seen, name)


def _ground(colors: UInt8[np.ndarray, "n 3"]) -> str:
    """Return the background colour that differs most from nearly all of an object's colours."""

    def off(name: str) -> float:
        return float(np.percentile(apart(colors, _GROUNDS[name]), 3)) if len(colors) else 0.0

    return max(_GROUNDS, key=lambda name: min(off(name), 80.0))


def put_back(redrawn: RGBA, cutout: Cutout) -> Instance:
    """Return a complete instance of a redrawn object, registered to its place in the picture.

    Image models move and scale the objects that they redraw. The object is registered so that it
    covers its visible region, and little of the region that certainly shows something else.

    Raises:
        Wrong: the object is not drawn alone, or its shape differs from the cut-out's.
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
    # reference pixels per pixel of the redrawn picture
    pixel = (cutout.box[2] - cutout.box[0]) / side

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
    """Return a picture padded to a square by replicating its edges."""
    height, width = picture.shape[:2]
    side = max(height, width)
    x, y = (side - width) // 2, (side - height) // 2
    around = (y, side - height - y, x, side - width - x)
    return cv2.copyMakeBorder(picture, *around, cv2.BORDER_REPLICATE)


def _register(mask: Mask, cutout: Cutout) -> tuple[float, Float[np.ndarray, "2"]]:
    """Return the scale and the relative shift that register a redrawn object to its cut-out."""
    scale, _ = _best(mask, cutout, _SCALES, _COARSE)
    scale, shift = _best(mask, cutout, _FINE * scale, 2 * _COARSE)
    seen, worth = _worth(cutout, _COARSE)
    own = _place(mask, scale, shift, _COARSE)
    covered = float((own & seen).sum() / max(seen.sum(), 1))
    beyond = float((own & (worth < 0)).sum() / max(seen.sum(), 1))
    if covered < _COVERED or beyond > _BEYOND:
        raise Wrong(
            f"the drawn object differs in shape from the cut-out: it covers {covered:.0%} of the "
            f"cut-out, and extends beyond it by {beyond:.0%} of the cut-out's area."
        )
    return scale, shift


def _best(
    mask: Mask, cutout: Cutout, scales: Float[np.ndarray, "k"], side: int
) -> tuple[float, Float[np.ndarray, "2"]]:
    """Return the scale and shift of ``mask`` with the largest gain, at ``side`` pixels per side."""
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
    """Return the visible region and a map of gains: 1 inside it, 0 where unknown, -1 elsewhere."""
    seen = _small(cutout.seen, side)
    return seen, np.where(seen, 1.0, np.where(_small(cutout.unknown, side), 0.0, -1.0))


def _small(mask: Mask, side: int) -> Mask:
    return cv2.resize(mask.astype(np.float32), (side, side), interpolation=cv2.INTER_AREA) > 0.5


def _place(
    mask: Mask, scale: float, shift: Float[np.ndarray, "2"], side: int
) -> Bool[np.ndarray, "c c"]:
    """Return a mask at another resolution, scaled about its centre and shifted."""
    factor = side / mask.shape[0] * scale
    small = cv2.resize(
        mask.astype(np.float32), None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA
    )
    corner = (side - np.array(small.shape[::-1])) / 2 + np.asarray(shift) * side
    warp = np.array([[1, 0, corner[0]], [0, 1, corner[1]]])
    return cv2.warpAffine(small, warp, (side, side)) > 0.5


def _clean(picture: RGBA, mask: Mask) -> RGBA:
    """Return a masked crop with a soft edge, extending the object's colours beyond the mask."""
    core = cv2.erode(mask.astype(np.uint8), np.ones((5, 5), np.uint8), borderValue=0) > 0
    core = core if core.sum() > 9 else mask
    colors = picture[..., :3][nearest_inside(core)]
    soft = cv2.GaussianBlur(mask.astype(np.float32), (0, 0), 0.9)
    alpha = np.round(255 * np.clip((soft - 0.25) / 0.5, 0, 1)).astype(np.uint8)
    return np.dstack([colors, alpha])
