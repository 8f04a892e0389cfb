"""What an environment shows: its observation, and what ``render`` draws."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np

from generator.errors import InputError, choices

from .kinds import RENDERERS, Kind, RendererChoice

CameraName = Literal["front", "wrist", "top"]

ObservationMode = Literal[
    "state", "goal", "pixels", "pixels+state", "point_cloud", "point_cloud+state"
]
MODES: tuple[ObservationMode, ...] = get_args(ObservationMode)

HintKind = Literal["planned", "detected"]
"""Who says where to grasp and where to let go."""

RenderMode = Literal["rgb_array", "depth_array", "human"]
RENDER_MODES: tuple[RenderMode, ...] = get_args(RenderMode)

_SMALLEST, _LARGEST, _LARGEST_SHOWN = 8, 2048, 4096  # pixels along a side
_MOST_POINTS = 1 << 16


@dataclass(frozen=True)
class ObservationConfig:
    """What a policy sees.

    Args:
        mode: "state", "goal", "pixels", "pixels+state", "point_cloud" or "point_cloud+state"; see
            ``observations.modes``.
        cameras: what pictures and point clouds are taken with: some of "front", "wrist" and "top".
        kinds: what pixel observations hold of each: some of "rgb", "depth" and "segmentation".
        image_size: height and width of the pictures in pixels, or one number for both.
        points: points of a point cloud.
        grasp_hint: whether the state ends with a grasp of the target, or its place: "planned" (or
            True) by the expert's planners, "detected" by a network that sees height maps; see
            ``observations.grasp_hint``. Not for "pixels" and "point_cloud" alone.

    Raises:
        InputError: an unknown mode; an unknown or repeated camera or kind, or none at all; a size
            out of range; a hint in a mode without the state.
    """

    mode: ObservationMode = "state"
    cameras: Sequence[CameraName] = ("front", "wrist")
    kinds: Sequence[Kind] = ("rgb",)
    image_size: int | tuple[int, int] = 128
    points: int = 1024
    grasp_hint: bool | HintKind = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "cameras", _some("camera", self.cameras, get_args(CameraName)))
        object.__setattr__(self, "kinds", _some("kind", self.kinds, get_args(Kind)))
        size = _picture_size("image_size", self.image_size, _LARGEST)
        object.__setattr__(self, "image_size", size)
        if not _is_whole(self.points, 1, _MOST_POINTS):
            raise InputError(f"points must be between 1 and {_MOST_POINTS}, got {self.points!r}.")
        _check_name("observation mode", self.mode, MODES)
        if self.grasp_hint and self.mode in ("pixels", "point_cloud"):
            raise InputError(
                f"The grasp hint is part of the state, and {self.mode!r} has none; use "
                f"'{self.mode}+state'."
            )

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the pictures, pixels."""
        assert isinstance(self.image_size, tuple)
        return self.image_size

    def key(self, camera: CameraName, kind: Kind) -> str:
        """Return the key of what ``camera`` shows."""
        return camera if kind == "rgb" else f"{camera}_{kind}"


@dataclass(frozen=True)
class RenderConfig:
    """What ``render`` returns, and what draws all pictures, those of observations too.

    Args:
        mode: None, "rgb_array", "depth_array" or "human".
        size: (height, width) of what ``render`` returns, or one number for both.
        renderer: "auto", "gl" or "software"; see ``rendering.drawer``.

    Raises:
        InputError: an unknown mode or renderer, or a size out of range.
    """

    mode: RenderMode | None = None
    size: int | tuple[int, int] = (480, 640)
    renderer: RendererChoice = "auto"

    def __post_init__(self) -> None:
        if self.mode is not None:
            _check_name("render mode", self.mode, RENDER_MODES)
        _check_name("renderer", self.renderer, RENDERERS)
        size = _picture_size("render_size", self.size, _LARGEST_SHOWN)
        object.__setattr__(self, "size", size)

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width, pixels."""
        assert isinstance(self.size, tuple)
        return self.size


def _check_name(what: str, name: Any, known: Collection[str]) -> None:
    if name not in known:
        raise InputError(f"Unknown {what} {name!r}." + choices(str(name), known))


def _picture_size(name: str, size: int | tuple[int, int], maximum: int) -> tuple[int, int]:
    """Return height and width of the setting ``name``, each at most ``maximum`` pixels."""
    sizes = tuple(size) if isinstance(size, Iterable) else (size, size)
    if len(sizes) != 2 or not all(_is_whole(k, _SMALLEST, maximum) for k in sizes):
        raise InputError(
            f"{name} must be between {_SMALLEST} and {maximum} pixels, one number or "
            f"(height, width), got {size!r}."
        )
    return int(sizes[0]), int(sizes[1])


def _some(what: str, wanted: Any, known: Collection[str]) -> tuple[str, ...]:
    """Return ``wanted`` as a tuple of known names."""
    several = isinstance(wanted, Iterable) and not isinstance(wanted, str)
    names: tuple[Any, ...] = tuple(wanted) if several else (wanted,)
    for name in names:
        _check_name(what, name, known)
    if not names or len(set(names)) < len(names):
        raise InputError(
            f"An observation needs one {what} or more, each once, got {names}." + choices("", known)
        )
    return names


def _is_whole(value: Any, low: int, high: int) -> bool:
    """Return whether ``value`` is an integer from ``low`` to ``high``."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return bool(whole and low <= value <= high)
