"""Settings of observations and of ``render``."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import Any, Literal, get_args

import numpy as np

from generator.errors import InputError, choices

from .kinds import RENDERERS, Kind, RendererChoice

CameraName = Literal["front", "wrist", "top", "side"]
CameraPreset = Literal["maniskill", "droid"]
PictureSize = int | tuple[int, int]
"""Height and width in pixels, or one number for both."""

PRESETS: Mapping[str, Mapping[CameraName, tuple[int, int]]] = MappingProxyType({
    "maniskill": {"front": (128, 128), "wrist": (128, 128)},
    "droid": {"front": (180, 320), "side": (180, 320), "wrist": (180, 320)},
})  # fmt: skip
"""Cameras and picture sizes as in other datasets; camera poses and lenses are not adopted."""

ObservationMode = Literal[
    "state", "goal", "pixels", "pixels+proprio", "pixels+state", "point_cloud", "point_cloud+state"
]
MODES: tuple[ObservationMode, ...] = get_args(ObservationMode)

InstructionKind = Literal["none", "text", "tokens", "embedding"]
"""Forms of the instruction in an observation."""

TargetMark = Literal["none", "overlay", "mask"]
"""Ways to mark the target in pictures."""

HintKind = Literal["planned", "detected"]
"""Sources of the grasp hint."""

GeometryKind = Literal["none", "height_map"]
"""Representations of the objects' shapes."""

RenderMode = Literal["rgb_array", "depth_array", "human"]
RENDER_MODES: tuple[RenderMode, ...] = get_args(RenderMode)

_CAMERAS: tuple[CameraName, ...] = get_args(CameraName)
_SMALLEST, _USUAL, _LARGEST, _LARGEST_SHOWN = 8, 128, 2048, 4096  # pixels along a side
_MAX_POINTS = 1 << 16


@dataclass(frozen=True)
class ObservationConfig:
    """Settings of the observation.

    Args:
        mode: "state", "goal", "pixels", "pixels+proprio", "pixels+state", "point_cloud" or
            "point_cloud+state"; see ``observations.modes``.
        cameras: cameras of pictures and point clouds, from "front", "wrist", "top" and "side"; or a
            preset of cameras and sizes, "maniskill" or "droid" (``PRESETS``).
        kinds: images per camera, from "rgb", "depth" and "segmentation".
        image_size: height and width of the pictures in pixels, or one number for both; or a mapping
            from camera to size. None means the preset's size, or 128 without a preset.
        points: number of points in a point cloud.
        grasp_hint: appends a grasp of the target, or its place of release, to the state: "planned"
            (or True) by the expert's planners, "detected" by a network from height maps; see
            ``observations.grasp_hint``. Not available for "pixels" and "point_cloud" alone.
        geometry: "height_map" adds height maps around the target and its goal (see
            ``observations.height_map``), which makes "state" a dict; "none" adds nothing. Not
            available for "goal", whose goals hindsight replay replaces.
        instruction: form of the instruction in modes with pictures or points: "text", "tokens",
            "embedding" (``observations.instructions``) or "none". None means "text" with
            "pixels+proprio", and "none" otherwise.
        target_mark: mark of the target in pictures: an "overlay" on the colours, a "mask" as a
            separate entry, or "none"; see ``views``.
        calibration: whether to add an entry with each camera's calibration; see ``views``.

    Raises:
        InputError: a setting is unknown; a camera or kind is repeated, or none is given; a size is
            out of range, or belongs to a camera that is not selected; or the mode does not support
            the hint, geometry, instruction, mark or calibration.
    """

    mode: ObservationMode = "state"
    cameras: Sequence[CameraName] | CameraPreset = ("front", "wrist")
    kinds: Sequence[Kind] = ("rgb",)
    image_size: PictureSize | Mapping[CameraName, PictureSize] | None = None
    points: int = 1024
    grasp_hint: bool | HintKind = False
    geometry: GeometryKind = "none"
    instruction: InstructionKind | None = None
    target_mark: TargetMark = "none"
    calibration: bool = False

    def __post_init__(self) -> None:
        cameras, sizes = _read_cameras(self.cameras, self.image_size)
        object.__setattr__(self, "cameras", cameras)
        alike = len(set(sizes.values())) == 1
        object.__setattr__(self, "image_size", sizes[cameras[0]] if alike else sizes)
        object.__setattr__(self, "kinds", _some("kind", self.kinds, get_args(Kind)))
        if not _is_whole(self.points, 1, _MAX_POINTS):
            raise InputError(f"points must be between 1 and {_MAX_POINTS}, got {self.points!r}.")
        _check_name("observation mode", self.mode, MODES)
        _check_name("geometry", self.geometry, get_args(GeometryKind))
        if self.looks and self.mode == "goal":
            raise InputError(
                "geometry='height_map' depends on the goal, which hindsight replay replaces in "
                "'goal'; use observation='state'."
            )
        if self.looks and self.mode == "pixels+proprio":
            raise InputError(
                "geometry='height_map' shows hidden surfaces, which 'pixels+proprio', limited to "
                "the inputs of a real robot, cannot include; use 'pixels+state', or kinds with "
                "'depth'."
            )
        if self.grasp_hint and self.mode in ("pixels", "pixels+proprio", "point_cloud"):
            raise InputError(
                f"The grasp hint is part of the state, which {self.mode!r} does not have; use "
                f"'{self.mode.partition('+')[0]}+state'."
            )
        self._check_marks()

    def _check_marks(self) -> None:
        """Validate the instruction, target mark and calibration; replace None with a default."""
        if self.instruction is None:
            default: InstructionKind = "text" if self.mode == "pixels+proprio" else "none"
            object.__setattr__(self, "instruction", default)
        _check_name("instruction", self.instruction, get_args(InstructionKind))
        _check_name("target_mark", self.target_mark, get_args(TargetMark))
        if self.instruction != "none" and self.is_flat:
            raise InputError(
                f"instruction={self.instruction!r} requires a mode with pictures or points, not "
                f"{self.mode!r}; info['instruction'] has the string."
            )
        if self.target_mark != "none" and not self.mode.startswith("pixels"):
            raise InputError(
                f"target_mark={self.target_mark!r} requires pictures, which {self.mode!r} does "
                f"not have; use a mode with pixels."
            )
        if self.target_mark == "overlay" and "rgb" not in self.kinds:
            raise InputError("target_mark='overlay' requires colour pictures; add 'rgb' to kinds.")
        if not isinstance(self.calibration, bool | np.bool_):
            raise InputError(f"calibration must be True or False, got {self.calibration!r}.")
        if self.calibration and not self.mode.startswith("pixels"):
            raise InputError(
                f"calibration=True requires pictures, which {self.mode!r} does not have; use a "
                f"mode with pixels."
            )

    @property
    def looks(self) -> bool:
        """Whether the observation has height maps."""
        return self.geometry != "none"

    @property
    def is_flat(self) -> bool:
        """Whether the observation has neither pictures nor points."""
        return self.mode in ("state", "goal")

    @cached_property
    def sizes(self) -> dict[CameraName, tuple[int, int]]:
        """The height and width of each camera's pictures, in pixels."""
        return _read_cameras(self.cameras, self.image_size)[1]

    def key(self, camera: CameraName, kind: Kind) -> str:
        """Return the observation key of an image of ``camera``."""
        return camera if kind == "rgb" else f"{camera}_{kind}"


@dataclass(frozen=True)
class RenderConfig:
    """Settings of ``render``, and of the renderer of all pictures, including observations.

    Args:
        mode: None, "rgb_array", "depth_array" or "human".
        size: (height, width) of the pictures of ``render``, or one number for both.
        renderer: "auto", "gl" or "software"; see ``rendering.drawer``.

    Raises:
        InputError: the mode or renderer is unknown, or the size is out of range.
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
        """The height and width in pixels."""
        assert isinstance(self.size, tuple)
        return self.size


def _check_name(what: str, name: Any, known: Collection[str]) -> None:
    if name not in known:
        raise InputError(f"Unknown {what} {name!r}." + choices(str(name), known))


def _picture_size(name: str, size: int | tuple[int, int], maximum: int) -> tuple[int, int]:
    """Return the height and width in the setting ``name``, each at most ``maximum`` pixels."""
    sizes = tuple(size) if isinstance(size, Iterable) else (size, size)
    if len(sizes) != 2 or not all(_is_whole(k, _SMALLEST, maximum) for k in sizes):
        raise InputError(
            f"{name} must be one number or (height, width), between {_SMALLEST} and {maximum} "
            f"pixels, got {size!r}."
        )
    return int(sizes[0]), int(sizes[1])


def _some(what: str, wanted: Any, known: Collection[str]) -> tuple[str, ...]:
    """Return ``wanted`` as a tuple of names, after checking that they are known and distinct."""
    several = isinstance(wanted, Iterable) and not isinstance(wanted, str)
    names: tuple[Any, ...] = tuple(wanted) if several else (wanted,)
    for name in names:
        _check_name(what, name, known)
    if not names or len(set(names)) < len(names):
        raise InputError(
            f"An observation must have at least one {what} and no duplicates, got {names}."
            + choices("", known)
        )
    return names


def _read_cameras(
    wanted: Any, size: Any
) -> tuple[tuple[CameraName, ...], dict[CameraName, tuple[int, int]]]:
    """Return the selected cameras, and the size of each camera's pictures in pixels."""
    preset = PRESETS.get(wanted) if isinstance(wanted, str) else None
    names: Any = _some("camera", wanted if preset is None else tuple(preset), _CAMERAS)
    if isinstance(size, Mapping):
        for name in size:
            _check_name("camera", name, _CAMERAS)
        if set(size) != set(names):
            raise InputError(
                f"image_size must have a size for each of the cameras {', '.join(names)}, got "
                f"{', '.join(map(str, size)) or 'none'}."
            )
        return names, {n: _picture_size("image_size", size[n], _LARGEST) for n in names}
    if size is None:
        return names, {n: (_USUAL, _USUAL) if preset is None else preset[n] for n in names}
    return names, dict.fromkeys(names, _picture_size("image_size", size, _LARGEST))


def _is_whole(value: Any, low: int, high: int) -> bool:
    """Return whether ``value`` is an integer in [``low``, ``high``]."""
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return bool(whole and low <= value <= high)
