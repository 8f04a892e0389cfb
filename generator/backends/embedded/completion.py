"""Completion of one object in the reference image: its hidden parts, and a feathered outline."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Float, UInt8
from scipy import ndimage

from ...geometry import mask_box
from ...meshes.pixels import (
    Mask,
    dilate,
    erode,
    hull_of,
    in_one_piece,
    largest_piece,
    nearest_inside,
)
from ...scene import TABLE, Detection, Instance, Reference

_LONG = 288  # minimum length of a crop's longer side in pixels
_MOST = 640
_MARGIN = 0.04
_MIRRORED = 0.15  # minimum fraction of a symmetric outline that is visible on both sides
_SYMMETRIC = 0.93  # fraction of a symmetric outline that its mirror image covers
_ALIKE = 20.0  # usual difference between mirrored pixels of a symmetric object, in grey levels


def complete(reference: Reference, detection: Detection, others: tuple[Detection, ...]) -> Instance:
    """Return the instance of a detection, completed on a transparent background (Sec. 3.1).

    Where another detection hides the object, the complete outline is the detection's full mask, if
    there is one. Otherwise the outline is completed where another detection lies within it, or
    touches it at a dent or cut. Separate pieces are joined. Hidden pixels get the colours of their
    mirror images if the object looks symmetric, and otherwise those of their surroundings.
    """
    mask = detection.mask
    hider = np.any([np.zeros_like(mask), *(o.mask for o in others if o.label != TABLE)], axis=0)
    seen = mask & ~hider if (mask & ~hider).any() else mask
    if detection.full is not None:
        whole = largest_piece(mask | (detection.full & dilate(hider, 5))) | mask
    else:
        near = ndimage.binary_fill_holes(mask) if (hider & ~seen).any() else mask
        whole = complete_mask(mask | (near & hider), hider & ~seen)
    whole = in_one_piece(whole)
    hidden = whole & ~seen
    occluded = bool(hidden.sum() > 0.02 * seen.sum())
    colors = reference.image
    if hidden.any():
        colors, drawn = mirror_colors(colors, seen, whole)
        colors = carry_colors(colors, drawn, whole) if (whole & ~drawn).any() else colors
    box = crop_box(mask_box(whole))
    label, crop = detection.label, cut_out(colors, whole, box)
    return Instance(label, label, detection.box, mask, crop, box, occluded, detection.score)


def complete_mask(mask: Mask, hider: Mask) -> Mask:
    """Return ``mask`` extended into ``hider`` where the object probably continues behind it.

    It is extended within its mirror image about a vertical axis, if it has one, or else within its
    convex hull.
    """
    x0, y0, x1, y1 = mask_box(mask).astype(int)
    reach = max(x1 - x0, y1 - y0)
    window = np.s_[max(0, y0 - reach) : y1 + reach, max(0, x0 - reach) : x1 + reach]
    own, other = mask[window], hider[window]
    near = dilate(own, 7) & other
    if near.sum() < 8:
        return mask
    touching = np.array(ndimage.binary_propagation(near, mask=other), dtype=bool)
    guess, mirror = hull_of(own), mirrored_mask(own, other)
    if mirror is not None:
        guess = guess | mirror
    whole = mask.copy()
    whole[window] = largest_piece(own | (guess & touching)) | own
    return whole


def mirrored_mask(mask: Mask, hider: Mask) -> Mask | None:
    """Return a mask mirrored about its vertical symmetry axis, or None if it is not symmetric.

    A reflection about this axis maps most of the unoccluded outline onto itself or behind the
    hider, and almost none of it elsewhere.
    """
    brush = np.ones((3, 3), np.uint8)
    rim = mask & (cv2.erode(mask.astype(np.uint8), brush, borderValue=0) == 0)
    free = rim & ~dilate(hider, 5)
    near = dilate(free, 3)
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


def mirror_colors(
    image: UInt8[np.ndarray, "h w 3"], seen: Mask, full: Mask
) -> tuple[UInt8[np.ndarray, "h w 3"], Mask]:
    """Colour hidden pixels like their mirror images; return the picture and its known pixels.

    The known pixels are ``seen`` alone if the outline has no vertical axis of symmetry, or if its
    two sides differ.
    """
    x0, _, x1, _ = mask_box(full).astype(int)
    ys, xs = np.nonzero(full)
    middle, slack = x0 + x1 - 1, max(1, (x1 - x0) // 12)
    overlaps = {}
    for twice in range(middle - slack, middle + slack + 1):
        other = twice - xs
        on = (other >= 0) & (other < full.shape[1])
        overlaps[twice] = float(full[ys[on], other[on]].sum() / len(xs))
    twice = max(overlaps, key=lambda t: (overlaps[t], -abs(t - middle)))
    core = erode(seen, 3)
    other = np.clip(twice - xs, 0, full.shape[1] - 1)
    both = core[ys, xs] & core[ys, other] & (np.abs(other - xs) > slack)
    if overlaps[twice] < _SYMMETRIC or both.sum() < 0.1 * len(xs):
        return image, seen
    gap = image[ys[both], xs[both]].astype(int) - image[ys[both], other[both]]
    if np.median(np.abs(gap).mean(1)) > _ALIKE:
        return image, seen
    lost = ~seen[ys, xs] & core[ys, other]
    drawn, known = image.copy(), seen.copy()
    drawn[ys[lost], xs[lost]] = image[ys[lost], other[lost]]
    known[ys[lost], xs[lost]] = True
    return drawn, known


def carry_colors(
    image: UInt8[np.ndarray, "h w 3"], mask: Mask, full: Mask
) -> UInt8[np.ndarray, "h w 3"]:
    """Return the image with the object's colours extended from ``mask`` into ``full``.

    Rows are continued from the nearest visible pixel, then blended by Telea's inpainting.
    """
    x0, y0, x1, y1 = mask_box(full).astype(int)
    cut = np.s_[max(y0 - 4, 0) : y1 + 4, max(x0 - 4, 0) : x1 + 4]
    core = erode(mask[cut], 5)
    core = core if core.any() else mask[cut]
    carried = image[cut][nearest_inside(core, (3.0, 1.0))]
    missing = (full & ~mask)[cut]
    soft = cv2.GaussianBlur(carried, (0, 0), 2.0)
    seam = dilate(missing, 5) & ~erode(missing, 5) & full[cut]
    patch = np.where(mask[cut][..., None], image[cut], soft)
    patch = np.where(seam[..., None], carried, patch)
    drawn = image.copy()
    drawn[cut] = cv2.inpaint(patch, seam.astype(np.uint8), 3, cv2.INPAINT_TELEA)
    return drawn


def crop_box(box: Float[np.ndarray, "4"]) -> Float[np.ndarray, "4"]:
    """Return the box, enlarged by a small margin and rounded to whole pixels."""
    margin = max(2.0, _MARGIN * float((box[2:] - box[:2]).max()))
    return np.array([*np.floor(box[:2] - margin), *np.ceil(box[2:] + margin)])


def cut_out(
    image: UInt8[np.ndarray, "h w 3"], mask: Mask, box: Float[np.ndarray, "4"]
) -> UInt8[np.ndarray, "ch cw 4"]:
    """Return a soft-edged RGBA cut-out of a box, which may exceed the image; enlarge it if small.

    Colours outside the mask are those of the nearest pixel inside, so that edges stay clean.
    """
    x0, y0, x1, y1 = box.astype(int)
    rows = np.clip(np.arange(y0, y1), 0, image.shape[0] - 1)
    columns = np.clip(np.arange(x0, x1), 0, image.shape[1] - 1)
    color, inside = image[np.ix_(rows, columns)], mask[np.ix_(rows, columns)].copy()
    inside[np.arange(y0, y1) != rows] = False
    inside[:, np.arange(x0, x1) != columns] = False
    core = erode(inside, 3)
    core = core if core.sum() > 9 else inside
    clean = color[nearest_inside(core)]
    long = max(x1 - x0, y1 - y0)
    zoom = float(np.clip(_LONG / long, 1.0 if long <= _MOST else _MOST / long, None))
    size = max(1, round((x1 - x0) * zoom)), max(1, round((y1 - y0) * zoom))
    how, alpha_how = cv2.INTER_AREA, cv2.INTER_AREA
    if zoom > 1:
        how, alpha_how = cv2.INTER_CUBIC, cv2.INTER_LINEAR
    alpha = cv2.resize(inside.astype(np.float32), size, interpolation=alpha_how)
    alpha = cv2.GaussianBlur(alpha, (0, 0), max(0.6, 0.5 * zoom))
    soft = np.clip((alpha - 0.5) * max(zoom, 1.0) * 1.5 + 0.5, 0, 1)
    clean = cv2.resize(clean, size, interpolation=how)
    return np.dstack([clean, np.round(soft * 255).astype(np.uint8)])
