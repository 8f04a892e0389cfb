"""Data types for pictures: the reference image, detections and the camera (Secs. 3.1 and 3.3)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, UInt8

from tabletop_objects.values import BOX, MASK, PICTURE, freeze, frozen_array

from ..errors import InputError, require_number
from .plan import ScenePlan

_MIN_FOV = 0.01  # radians
_MAX_PIXELS = 1e9  # pixels


@dataclass(frozen=True)
class Intrinsics:
    """The focal lengths and principal point of a picture's camera, in pixels of the picture.

    The convention is that of OpenCV and ROS: x right, y down, and the *centre* of the top-left
    pixel at (0, 0), so the principal point of a centred camera is
    ((width - 1) / 2, (height - 1) / 2).
    """

    fx: float
    fy: float
    cx: float
    cy: float

    def __post_init__(self) -> None:
        for name, above in (("fx", 0.0), ("fy", 0.0), ("cx", None), ("cy", None)):
            value = getattr(self, name)
            require_number(f"Intrinsics.{name}", value, above=above, maximum=_MAX_PIXELS)
            object.__setattr__(self, name, float(value))

    def scale(self, across: float, down: float) -> Intrinsics:
        """Return the intrinsics of the picture after it is resized by the given factors."""
        cx, cy = (self.cx + 0.5) * across - 0.5, (self.cy + 0.5) * down - 0.5
        return Intrinsics(self.fx * across, self.fy * down, cx, cy)


@dataclass(frozen=True, eq=False)
class Reference:
    """The reference image I_ref (Sec. 3), with its ``prompt`` and ``plan`` if available.

    For an RGB-D picture, ``depth`` is the distance along the optical axis in metres, 0 where
    unknown, and ``intrinsics`` are the camera's. Either both or neither must be given.
    """

    image: UInt8[np.ndarray, "h w 3"]
    prompt: str | None = None
    plan: ScenePlan | None = None
    depth: Float[np.ndarray, "h w"] | None = None
    intrinsics: Intrinsics | None = None

    def __post_init__(self) -> None:
        freeze(self, image=PICTURE)
        if (self.depth is None) != (self.intrinsics is None):
            raise InputError("A Reference must have both depth and intrinsics, or neither.")
        if self.depth is not None:
            freeze(self, depth=(np.float32, self.image.shape[:2]))
            if self.depth.min() < 0:
                raise InputError(
                    "Reference.depth is in metres; it must be >= 0, where 0 means unknown."
                )


@dataclass(frozen=True, eq=False)
class Detection:
    """A segmented region of an image: its label, tight pixel box, mask, and score in [0, 1].

    ``full`` is the mask of the whole object, including its occluded part, if the segmenter predicts
    it; if it is None, the completion stage estimates it.
    """

    label: str
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"]
    score: float = 1.0
    full: Bool[np.ndarray, "h w"] | None = None

    def __post_init__(self) -> None:
        freeze(self, mask=MASK, box=BOX)
        if self.full is not None:
            freeze(self, full=(np.bool_, self.mask.shape))


@dataclass(frozen=True, eq=False)
class Instance:
    """One object of the reference image (Sec. 3.1).

    ``mask`` (visible pixels, with holes filled) and ``box`` are in reference pixels. ``crop`` is
    the completed RGBA picture of the object alone, and ``crop_box`` is its extent in reference
    pixels, which may exceed the image. ``occluded`` is true if part of the object was completed.
    """

    name: str
    label: str
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"]
    crop: UInt8[np.ndarray, "ch cw 4"]
    crop_box: Float[np.ndarray, "4"]
    occluded: bool = False
    score: float = 1.0

    def __post_init__(self) -> None:
        freeze(self, box=BOX, mask=MASK, crop=(np.uint8, (None, None, 4)), crop_box=BOX)


@dataclass(frozen=True)
class View:
    """The camera of the reference image (Sec. 3.3), with angles in radians.

    ``azimuth`` 0 looks along +y (from the front); positive values move the camera towards +x.
    ``elevation`` is measured from the horizon, in (0, pi/2]. ``fov`` is the vertical field of view.
    A positive ``roll`` lowers the camera's right side: the image turns counter-clockwise.
    """

    azimuth: float
    elevation: float
    fov: float
    roll: float = 0.0

    def __post_init__(self) -> None:
        if not np.abs([self.azimuth, self.elevation, self.fov, self.roll]).max() < 1e4:
            raise InputError(
                f"View must have angles in radians below 1e4 in magnitude, got {self}."
            )
        sides = 0 < self.elevation <= np.pi / 2 + 1e-9, _MIN_FOV <= self.fov <= np.pi - _MIN_FOV
        if not all(sides):
            raise InputError(
                f"View must have elevation in (0, pi/2] rad, and fov in [{_MIN_FOV}, pi - "
                f"{_MIN_FOV}] rad, got {self}."
            )


USUAL_VIEW = View(azimuth=0.0, elevation=np.deg2rad(55.0), fov=np.deg2rad(35.0))
"""A view from the front and above, for scenes without a picture."""


@dataclass(frozen=True, eq=False)
class TopView:
    """I_top: the table seen from straight above (Sec. 3.3, TSA).

    The view is orthographic: +u is world +x, and +v (down) is world -y. ``table_box`` and ``boxes``
    (by instance name) are pixel boxes in this view. The boxes of the ``repaired`` instances come
    from geometry, not from the drawn picture. ``metres_per_pixel`` is None unless the scale was
    measured. ``warnings`` lists what went wrong.
    """

    image: UInt8[np.ndarray, "h w 3"]
    table_box: Float[np.ndarray, "4"]
    boxes: Mapping[str, Float[np.ndarray, "4"]]
    repaired: tuple[str, ...] = ()
    metres_per_pixel: float | None = None
    warnings: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        boxes = {
            name: frozen_array(box, *BOX, f"TopView.boxes[{name!r}]")
            for name, box in self.boxes.items()
        }
        object.__setattr__(self, "boxes", boxes)
        freeze(self, image=PICTURE, table_box=BOX)
