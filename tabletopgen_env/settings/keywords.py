"""The keywords of ``gymnasium.make``: groups of ``EnvConfig``, or their fields."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import fields
from types import MappingProxyType
from typing import Any, TypedDict

from generator.errors import InputError, choices, require_known

from ..actions import ActionConfig, ActionMode, GripperMode
from ..randomization import Randomization
from ..rendering.config import (
    CameraName,
    CameraPreset,
    GeometryKind,
    HintKind,
    InstructionKind,
    ObservationConfig,
    ObservationMode,
    PictureSize,
    RenderConfig,
    RenderMode,
    TargetMark,
)
from ..rendering.kinds import Kind, RendererChoice
from ..robot.panda import Panda
from ..world.worlds import Masters, WorldConfig
from .config import EnvConfig, InfoKind, RewardMode


class Settings(TypedDict, total=False):
    """Optional keywords, each a field of ``EnvConfig`` or of one of its groups.

    A group is given as a whole (``observation=ObservationConfig("pixels", points=64)``), as a dict
    of its fields, or by separate fields (``observation="pixels", points=64``), but not in two ways
    at once.
    """

    observation: ObservationMode | ObservationConfig
    cameras: Sequence[CameraName] | CameraPreset
    kinds: Sequence[Kind]
    image_size: PictureSize | Mapping[CameraName, PictureSize] | None
    points: int
    grasp_hint: bool | HintKind
    geometry: GeometryKind
    instruction: InstructionKind | None
    target_mark: TargetMark
    calibration: bool
    action: ActionMode | ActionConfig
    gripper: GripperMode
    control_hz: int
    render: RenderConfig
    render_mode: RenderMode | None
    render_size: int | tuple[int, int]
    renderer: RendererChoice
    worlds: WorldConfig
    robot: Panda | None
    cache: int
    masters: Masters | None
    reward: RewardMode
    randomization: Randomization | str | None
    certified: bool
    infos: InfoKind


KEYWORDS = frozenset(Settings.__annotations__)

GROUPS: Mapping[str, type] = MappingProxyType(
    {
        "observation": ObservationConfig,
        "action": ActionConfig,
        "render": RenderConfig,
        "worlds": WorldConfig,
    }
)
"""The class of each group of settings."""

_RENAMED: Mapping[tuple[str, str], str] = MappingProxyType(
    {
        ("observation", "mode"): "observation",
        ("action", "mode"): "action",
        ("render", "mode"): "render_mode",
        ("render", "size"): "render_size",
    }
)


class UnknownSettingError(InputError, TypeError):
    """Unknown keyword of an environment.

    A ``TypeError`` that contains Python's standard message: libraries that probe the keywords of an
    environment (TorchRL's ``GymEnv`` tries ``frameskip``) expect both.
    """


def keywords_of(group: str) -> dict[str, str]:
    """Return the field of a group that each keyword sets."""
    names = (field.name for field in fields(GROUPS[group]))
    return {_RENAMED.get((group, name), name): name for name in names}


def read_settings(settings: Mapping[str, Any]) -> EnvConfig:
    """Return the config that keywords describe; see ``Settings``.

    Raises:
        UnknownSettingError: a keyword is unknown.
        InputError: a value is invalid, or a group and one of its fields are both set.
    """
    check_settings(settings)
    rest = dict(settings)
    groups = {group: _read_group(group, rest) for group in GROUPS}
    return EnvConfig(**groups, **rest)


def check_settings(given: Iterable[str], *more: str) -> None:
    """Check that all names are keywords of an environment, or in ``more``.

    Raises:
        UnknownSettingError: a name is unknown.
    """
    known = {*KEYWORDS, "scenes", "task", "preset", *more}
    for name in given:
        if name not in known:
            raise UnknownSettingError(
                f"An environment has no setting {name!r}: unexpected keyword argument {name!r}."
                + choices(name, known)
            )


def _read_group(group: str, rest: dict[str, Any]) -> Any:
    """Remove the keywords of a settings group from ``rest``; return the group that they set."""
    kind, names = GROUPS[group], keywords_of(group)
    whole = rest.pop(group) if isinstance(rest.get(group), kind | Mapping) else None
    flat = {name: rest.pop(name) for name in names if name in rest}
    if group in rest:
        raise InputError(f"{group} must be a {kind.__name__}, got {rest[group]!r}.")
    if whole is None:
        return kind(**{names[name]: value for name, value in flat.items()})
    if flat:
        raise InputError(
            f"{group} is given, so {', '.join(flat)} cannot be given separately. Set them in the "
            f"{kind.__name__}."
        )
    if isinstance(whole, kind):
        return whole
    for name in whole:
        require_known(name, names.values(), f"{kind.__name__} has no setting")
    return kind(**whole)
