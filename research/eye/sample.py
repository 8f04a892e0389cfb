"""One training picture with the ground truth for all outputs of the eye."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from generator.geometry import Camera, view_rotation
from generator.scene import View

BACKGROUND, TOP, TABLE_REST, OBJECT = 0, 1, 2, 3
"""Values of ``Sample.region``."""

UNKNOWN = -1
"""Category of an object that is not in the catalogue."""

UNNAMED = -2
"""Category of a catalogue object whose name is not trained; it may resemble any other."""

_PIXELS, _SHARE = 100, 0.15  # minimum visible share of an object to detect, and of its whole mask


def worth_finding(
    visible: Int[np.ndarray, "n"], full: Int[np.ndarray, "n"]
) -> Bool[np.ndarray, "n"]:
    """Return which objects are visible enough to be detected, from the pixels of their masks."""
    return (visible >= _PIXELS) & (visible >= _SHARE * np.maximum(full, 1))


@dataclass(frozen=True, eq=False)
class Sample:
    """A rendered tabletop and its ground truth; instance ``k`` is 1-based in ``visible``.

    Attributes:
        image: sRGB.
        visible: the instance in each pixel; 0 is none.
        full: whole mask of each instance, including hidden parts, cropped to the picture.
        category: index into the shard's category keys, ``UNKNOWN`` or ``UNNAMED``.
        region: ``BACKGROUND``, ``TOP`` (its visible surface), ``TABLE_REST`` or ``OBJECT``.
        top: the tabletop's whole upper surface, including parts hidden by objects.
        outline: pixels (x, y) of the top's outline in order, possibly outside the picture. Parts
            behind the camera are cut off. Empty if the whole top is behind the camera.
        view: azimuth, elevation and vertical field of view, radians, as ``scene.View``.
        focal: focal length in pixels; the principal point is the image centre.
        yaw: rotation of each instance about +z, radians (of a tipped one: before it tipped over).
        upright: whether each instance stands in its everyday state.
        size: extent along each instance's own axes, metres.
        position: world centre of each instance's box, metres.
        support: the support of each instance: 0 the table, ``k`` instance ``k``.
        depth: metres along the optical axis; infinite in the background.
    """

    image: UInt8[np.ndarray, "h w 3"]
    visible: UInt8[np.ndarray, "h w"]
    full: Bool[np.ndarray, "n h w"]
    category: Int[np.ndarray, "n"]
    region: UInt8[np.ndarray, "h w"]
    top: Bool[np.ndarray, "h w"]
    outline: Float[np.ndarray, "k 2"]
    view: View
    focal: float
    yaw: Float[np.ndarray, "n"]
    upright: Bool[np.ndarray, "n"]
    size: Float[np.ndarray, "n 3"]
    position: Float[np.ndarray, "n 3"]
    support: Int[np.ndarray, "n"]
    depth: Float[np.ndarray, "h w"]

    @property
    def latitude(self) -> Float[np.ndarray, "h w"]:
        """Angle of each pixel's ray below the horizon, radians."""
        return latitude(self.view, *self.image.shape[:2])


def latitude(view: View, height: int, width: int) -> Float[np.ndarray, "h w"]:
    """Return the angle of each pixel's ray below the horizon, radians (float32)."""
    camera = Camera(np.zeros(3), view_rotation(view), view.fov, width, height)
    rows, columns = np.mgrid[0:height, 0:width] + 0.5
    rays = camera.rays(np.column_stack([columns.ravel(), rows.ravel()]))
    return np.arcsin(np.clip(-rays[:, 2], -1, 1)).reshape(height, width).astype(np.float32)


def fill(outline: Float[np.ndarray, "k 2"], height: int, width: int) -> Bool[np.ndarray, "h w"]:
    """Return the pixels whose centre is inside a polygon given in pixels."""
    import cv2

    mask = np.zeros((height, width), np.uint8)
    if len(outline) >= 3:
        bits = 6
        corners = np.clip(outline - 0.5, -20000, 20000) * (1 << bits)
        cv2.fillPoly(mask, [np.round(corners).astype(np.int32)], 1, shift=bits)
    return mask.astype(bool)
