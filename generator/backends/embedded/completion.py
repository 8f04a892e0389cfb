"""Complete one object of the reference image: hidden parts redrawn, clean soft outline."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy import ndimage

from ...geometry import mask_box
from ...scene import TABLE, Detection, Instance, Reference
from .pixels import hull_of, largest_piece, nearest_inside

_LONG = 288  # least long side of a crop, pixels
_MOST = 640
_MARGIN = 0.04
_MIRRORED = 0.15  # least share of a symmetric outline that must be seen on both sides

Mask = Bool[np.ndarray, "h w"]


def complete(reference: Reference, detection: Detection, others: tuple[Detection, ...]) -> Instance:
    """Return the instance of a detection, drawn whole on a transparent ground (Sec. 3.1).

    Where another detection lies within the object's outline, or touches it and the outline is
    dented or cut there, the outline is completed and the colours are carried on.
    """
    hider = _union(detection.mask.shape, [o.mask for o in others if o.label != TABLE])
    seen = detection.mask & ~hider if (detection.mask & ~hider).any() else detection.mask
    near = ndimage.binary_fill_holes(detection.mask) if (hider & ~seen).any() else detection.mask
    whole = complete_mask(detection.mask | (near & hider), hider & ~seen)
    hidden = whole & ~seen
    occluded = bool(hidden.sum() > 0.02 * seen.sum())
    colors = carry_colors(reference.image, seen, whole) if hidden.any() else reference.image
    box = crop_box(mask_box(whole))
    return Instance(
        detection.label,
        detection.label,
        detection.box,
        detection.mask,
        cut_out(colors, whole, box),
        box,
        occluded,
        detection.score,
    )


def _union(shape: tuple[int, ...], masks: list[np.ndarray]) -> Mask:
    joined = np.zeros(shape, bool)
    for mask in masks:
        joined |= mask
    return joined


def complete_mask(mask: Mask, hider: Mask) -> Mask:
    """Return ``mask`` grown into ``hider`` where the object probably goes on behind it.

    Two guesses are joined: the object's mirror image about a vertical line, if its outline has
    such an axis, and the convex hull of what is visible; both only inside the hider.
    """
    x0, y0, x1, y1 = mask_box(mask).astype(int)
    reach = max(x1 - x0, y1 - y0)
    rows = slice(max(0, y0 - reach), y1 + reach)
    columns = slice(max(0, x0 - reach), x1 + reach)
    own, other = mask[rows, columns], hider[rows, columns]
    near = cv2.dilate(own.astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    if (near & other).sum() < 8:
        return mask
    touching = np.array(ndimage.binary_propagation(near & other, mask=other), dtype=bool)
    guess = hull_of(own)
    mirror = mirrored_mask(own, other)
    if mirror is not None:
        guess = guess | mirror
    grown = own | (guess & touching)
    whole = mask.copy()
    whole[rows, columns] = largest_piece(grown) | own
    return whole


def mirrored_mask(mask: Mask, hider: Mask) -> Mask | None:
    """Return the mask reflected about the vertical axis of its outline, or None if it has none.

    The outline against the background must fall onto itself or behind the hider; the axis where
    most of it does, and next to none falls elsewhere, is taken.
    """
    brush = np.ones((3, 3), np.uint8)
    rim = mask & (cv2.erode(mask.astype(np.uint8), brush, borderValue=0) == 0)
    free = rim & (cv2.dilate(hider.astype(np.uint8), np.ones((5, 5), np.uint8)) == 0)
    near = cv2.dilate(free.astype(np.uint8), brush) > 0
    x0, _, x1, _ = mask_box(mask).astype(int)
    ys, xs = np.nonzero(free)
    if len(xs) < 12:
        return None
    best = (_MIRRORED, 0)
    for twice in range(2 * x0, 2 * x1 + 1):
        other = twice - xs
        on = (other >= 0) & (other < mask.shape[1])
        met, covered = near[ys[on], other[on]], hider[ys[on], other[on]]
        astray = 1 - (met | covered).sum() / len(xs)
        best = max(best, (float(met.mean() - 3 * astray) if on.any() else -1.0, twice))
    if best[0] <= _MIRRORED:
        return None
    ys, xs = np.nonzero(mask)
    other = best[1] - xs
    on = (other >= 0) & (other < mask.shape[1])
    reflected = np.zeros_like(mask)
    reflected[ys[on], other[on]] = True
    return reflected


def carry_colors(
    image: UInt8[np.ndarray, "h w 3"], mask: Mask, whole: Mask
) -> UInt8[np.ndarray, "h w 3"]:
    """Return the image with the object's colours carried into ``whole`` beyond ``mask``.

    Rows are continued from the nearest visible pixel, then blended by Telea's inpainting.
    """
    x0, y0, x1, y1 = mask_box(whole).astype(int)
    cut = slice(max(y0 - 4, 0), y1 + 4), slice(max(x0 - 4, 0), x1 + 4)
    core = cv2.erode(mask[cut].astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    core = core if core.any() else mask[cut]
    carried = image[cut][nearest_inside(core, (3.0, 1.0))]
    missing = (whole & ~mask)[cut]
    soft = cv2.GaussianBlur(carried, (0, 0), 2.0)
    patch = np.where(missing[..., None], soft, image[cut])
    brush = np.ones((5, 5), np.uint8)
    seam = cv2.dilate(missing.astype(np.uint8), brush) > 0
    seam &= cv2.erode(missing.astype(np.uint8), brush) == 0
    patch = np.where(seam[..., None] & whole[cut][..., None], carried, patch)
    patch = cv2.inpaint(
        np.ascontiguousarray(patch), (seam & whole[cut]).astype(np.uint8), 3, cv2.INPAINT_TELEA
    )
    drawn = image.copy()
    drawn[cut] = patch
    return drawn


def crop_box(box: Float[np.ndarray, "4"]) -> Float[np.ndarray, "4"]:
    """Return the box with a small margin all around, in whole pixels."""
    margin = max(2.0, _MARGIN * float((box[2:] - box[:2]).max()))
    return np.array([*np.floor(box[:2] - margin), *np.ceil(box[2:] + margin)])


def cut_out(
    image: UInt8[np.ndarray, "h w 3"], mask: Mask, box: Float[np.ndarray, "4"]
) -> UInt8[np.ndarray, "ch cw 4"]:
    """Cut a box (it may leave the image) out as RGBA with a soft edge, enlarged if small.

    Colours outside the mask are those of the nearest pixel inside, so that edges stay clean.
    """
    x0, y0, x1, y1 = box.astype(int)
    rows = np.clip(np.arange(y0, y1), 0, image.shape[0] - 1)
    columns = np.clip(np.arange(x0, x1), 0, image.shape[1] - 1)
    color, inside = image[np.ix_(rows, columns)], mask[np.ix_(rows, columns)].copy()
    inside[(np.arange(y0, y1) != rows)] = False
    inside[:, (np.arange(x0, x1) != columns)] = False
    core = cv2.erode(inside.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    core = core if core.sum() > 9 else inside
    clean = color[nearest_inside(core)]
    long = max(x1 - x0, y1 - y0)
    zoom = float(np.clip(_LONG / long, 1.0 if long <= _MOST else _MOST / long, None))
    size = max(1, round((x1 - x0) * zoom)), max(1, round((y1 - y0) * zoom))
    how = cv2.INTER_CUBIC if zoom > 1 else cv2.INTER_AREA
    alpha_how = cv2.INTER_LINEAR if zoom > 1 else how
    alpha = cv2.resize(inside.astype(np.float32), size, interpolation=alpha_how)
    alpha = cv2.GaussianBlur(alpha, (0, 0), max(0.6, 0.5 * zoom))
    soft = np.clip((alpha - 0.5) * max(zoom, 1.0) * 1.5 + 0.5, 0, 1)
    clean = cv2.resize(clean, size, interpolation=how)
    return np.dstack([clean, np.round(soft * 255).astype(np.uint8)])
