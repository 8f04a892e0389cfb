"""What cameras show: pictures, depth and which slot each pixel belongs to.

Keys of the observation, by camera (``front``, ``wrist``, ``top``) and kind:

======================  ====================================================================
``front``               rgb: the picture, ``uint8`` (height, width, 3)
``front_depth``         depth: metres along the optical axis, ``float32`` (height, width);
                        10 where nothing is or what is lies farther
``front_segmentation``  segmentation: what the pixel shows, ``uint8`` (height, width): 0 the
                        background, 1 the robot with its pedestal, 2 the table with the marked
                        spot, 3 and up the objects in slot order (3 is slot 0, the target);
                        objects without a slot are background
======================  ====================================================================

``front`` looks at table and robot from across the table, ``wrist`` sits on the hand, and ``top``
looks straight down at the table, the robot's side below; it shows the whole top in pictures at
least as wide as high.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np
from gymnasium import spaces
from jaxtyping import Shaped, UInt8

from generator.errors import InputError, choices
from generator.scene import TABLE

from ..robot.mount import PEDESTAL
from ..world.composition import FRONT_CAMERA, MARKER, TOP_CAMERA, WRIST_CAMERA
from ..world.world import World
from .kinds import Drawer, Kind

if TYPE_CHECKING:
    from collections.abc import Sequence

CameraName = Literal["front", "wrist", "top"]

CAMERAS: Mapping[str, str] = MappingProxyType(
    {"front": FRONT_CAMERA, "wrist": WRIST_CAMERA, "top": TOP_CAMERA}
)
"""The model's cameras by their name in observations."""

SLOTS = 12
"""Objects that an observation has room for."""

DEPTH_FAR = 10.0
"""Depth that stands for everything farther, and for nothing at all, metres."""

BACKGROUND, ROBOT, TABLETOP, FIRST_SLOT = 0, 1, 2, 3
"""What the numbers of a segmentation mean."""

LAST_LABEL = FIRST_SLOT + SLOTS - 1

_SMALLEST, _LARGEST = 8, 2048
_MOST_POINTS = 1 << 16


@dataclass(frozen=True)
class ObservationConfig:
    """Which cameras an observation has, what it takes from them, and how large.

    Args:
        cameras: some of "front", "wrist" and "top".
        kinds: some of "rgb", "depth" and "segmentation", for each camera (pixel modes).
        image_size: height and width in pixels, or one number for both.
        points: points of a point cloud.

    Raises:
        InputError: an unknown or repeated camera or kind, none at all, or a size out of range.
    """

    cameras: Sequence[CameraName] = ("front", "wrist")
    kinds: Sequence[Kind] = ("rgb",)
    image_size: int | tuple[int, int] = 128
    points: int = 1024

    def __post_init__(self) -> None:
        object.__setattr__(self, "cameras", _some("camera", self.cameras, CAMERAS))
        object.__setattr__(self, "kinds", _some("kind", self.kinds, get_args(Kind)))
        size = picture_size("image_size", self.image_size, _LARGEST)
        object.__setattr__(self, "image_size", size)
        if not _whole(self.points, 1, _MOST_POINTS):
            raise InputError(f"points must be between 1 and {_MOST_POINTS}, got {self.points!r}.")

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the pictures, pixels."""
        assert isinstance(self.image_size, tuple)
        return self.image_size

    def key(self, camera: CameraName, kind: Kind) -> str:
        """Return the key of what ``camera`` shows."""
        return camera if kind == "rgb" else f"{camera}_{kind}"

    def picture_spaces(self) -> dict[str, spaces.Space[Any]]:
        """Return the space of each picture by its key."""
        made: dict[Kind, spaces.Space[Any]] = {
            "rgb": spaces.Box(0, 255, (*self.size, 3), np.uint8),
            "depth": spaces.Box(0.0, DEPTH_FAR, self.size, np.float32),
            "segmentation": spaces.Box(0, LAST_LABEL, self.size, np.uint8),
        }
        return {self.key(c, kind): made[kind] for c in self.cameras for kind in self.kinds}


def picture_size(name: str, size: int | tuple[int, int], most: int) -> tuple[int, int]:
    """Return height and width of the setting ``name``, each at most ``most`` pixels.

    Raises:
        InputError: it is neither one number nor two, or out of range.
    """
    sizes = tuple(size) if isinstance(size, Iterable) else (size, size)
    if len(sizes) != 2 or not all(_whole(k, _SMALLEST, most) for k in sizes):
        raise InputError(
            f"{name} must be between {_SMALLEST} and {most} pixels, one number or "
            f"(height, width), got {size!r}."
        )
    return int(sizes[0]), int(sizes[1])


def pictures(
    config: ObservationConfig, world: World, drawer: Drawer, order: Sequence[str]
) -> dict[str, Shaped[np.ndarray, "h w *c"]]:
    """Return the pictures of ``config`` by their key, objects in the slots' ``order``."""
    labels = geom_labels(world, order)
    seen: dict[str, Shaped[np.ndarray, "h w *c"]] = {}
    for camera in config.cameras:
        drawn = drawer.draw(world, CAMERAS[camera], config.kinds)
        for kind, picture in drawn.items():
            if kind == "depth":
                picture = np.minimum(picture, np.float32(DEPTH_FAR))
            elif kind == "segmentation":
                picture = labels[picture]
            seen[config.key(camera, kind)] = picture
    return seen


def geom_labels(world: World, order: Sequence[str]) -> UInt8[np.ndarray, "ngeom+1"]:
    """Return what each geom is in a segmentation; the last entry is for geom -1, nothing."""
    model = world.model
    body = np.full(model.nbody, BACKGROUND, np.uint8)
    body[world.robot_bodies] = ROBOT
    body[model.body(PEDESTAL).id] = ROBOT
    body[[model.body(TABLE).id, model.body(MARKER).id]] = TABLETOP
    body[world.bodies[[world.index(name) for name in order]]] = FIRST_SLOT + np.arange(len(order))
    return np.append(body[model.geom_bodyid], np.uint8(BACKGROUND))


def _some(what: str, wanted: Any, known: Collection[str]) -> tuple[str, ...]:
    """Return ``wanted`` as a tuple of known names."""
    several = isinstance(wanted, Iterable) and not isinstance(wanted, str)
    names: tuple[Any, ...] = tuple(wanted) if several else (wanted,)
    for name in names:
        if name not in list(known):  # what is wrong may have no hash
            raise InputError(f"Unknown {what} {name!r}." + choices(str(name), known))
    if not names or len(set(names)) < len(names):
        raise InputError(
            f"An observation needs one {what} or more, each once, got {names}." + choices("", known)
        )
    return names


def _whole(value: Any, low: int, high: int) -> bool:
    """Return whether ``value`` is a whole number from ``low`` to ``high``."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return bool(whole and low <= value <= high)
