"""The features of a dataset in ``meta/info.json``, and their values at each step."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import Shaped

from ...observations.proprioception import SHARED
from ..config import LeRobotConfig
from ..episodes import RecordedEpisode
from .depth import DEPTH_INFO
from .videos import CODECS, DEPTH_CODEC, GOP, Codec

PICTURES = "observation.images."
"""Prefix of the names of picture features."""

_XYZ = ("x", "y", "z")
_JOINTS = [f"joint_{k}" for k in range(1, 8)]
_AXES = [f"hand.{axis}_axis.{k}" for axis in "xy" for k in _XYZ]
PROPRIO_NAMES = (
    *(f"{joint}.position" for joint in _JOINTS),
    *(f"{joint}.velocity" for joint in _JOINTS),
    "gripper.opening",
    *(f"tool.{k}" for k in _XYZ),
    *_AXES,
    *(f"{joint}.command_ahead" for joint in _JOINTS),
    "gripper.command",
    "gripper.velocity",
)
"""Entries of ``observation.state``, the robot's proprioception, in order."""

ACTION_NAMES = ("tool.x", "tool.y", "tool.z", "hand.yaw", "gripper")
"""Entries of an action in the mode "ee_delta"."""

_SLOT = (
    *(f"center.{k}" for k in _XYZ),
    *(f"{axis}_axis.{k}" for axis in "xy" for k in _XYZ),
    *(f"half_extent.{k}" for k in _XYZ),
    *(f"velocity.{k}" for k in _XYZ),
    *(f"angular_velocity.{k}" for k in _XYZ),
    "present",
)
STATE_NAMES = (
    *(f"{finger}_finger.touches_target" for finger in ("left", "right")),
    *(f"target_from_tool.{k}" for k in _XYZ),
    *(f"table.{k}" for k in ("height", "half_length", "half_width")),
    *(f"object_{slot}.{name}" for slot in range(12) for name in _SLOT),
    "goal.on_object",
    *(f"goal.center.{k}" for k in _XYZ),
    *(f"goal.{k}" for k in ("semi_axis_x", "semi_axis_y", "yaw", "semi_axis_z")),
    *(f"goal_from_target.{k}" for k in _XYZ),
)
"""Names of the entries of ``observation.environment_state``, the flat state without the robot's."""

HINT_NAMES = (
    *(f"grasp_hint.from_tool.{k}" for k in _XYZ),
    *(f"grasp_hint.{k}" for k in ("turn", "opening", "breadth", "rise", "stage")),
)
"""Names of the additional entries of ``observation.environment_state`` with a ``grasp_hint``."""

_COUNTERS: Mapping[str, str] = MappingProxyType(
    {
        "timestamp": "float32",
        "frame_index": "int64",
        "episode_index": "int64",
        "index": "int64",
        "task_index": "int64",
    }
)


def step_values(
    episode: RecordedEpisode, privileged: bool
) -> dict[str, Shaped[np.ndarray, "t *d"]]:
    """Return the table values for each step, keyed by feature, excluding counters and pictures.

    Observations are those before the step; results of the step begin with ``next.``.
    """
    steps = len(episode.rewards)
    last = np.arange(1, steps + 1) == steps
    values: dict[str, np.ndarray] = {"observation.state": episode.proprio[:-1]}
    if privileged and episode.state is not None:
        values["observation.environment_state"] = episode.state[:-1, SHARED:]
    success = np.asarray(episode.infos["success"])
    values |= {
        "action": episode.actions,
        "next.reward": episode.rewards,
        "next.done": last,
        "next.truncated": last,
        "next.success": success[1:],
    }
    for camera, views in episode.cameras.items():
        rows = views["extrinsics"][:-1].reshape(steps, 16)
        values[f"camera.{camera}.extrinsics"] = rows.astype(np.float32)
    return values


def features_of(
    values: Mapping[str, Shaped[np.ndarray, "t *d"]],
    pictures: Mapping[str, Shaped[np.ndarray, "t h w *c"]],
    fps: int,
    config: LeRobotConfig,
) -> dict[str, dict[str, Any]]:
    """Return the entry of each feature in ``meta/info.json``."""
    named = {
        "observation.state": PROPRIO_NAMES,
        "observation.environment_state": (*STATE_NAMES, *HINT_NAMES),
        "action": ACTION_NAMES,
    }
    found: dict[str, dict[str, Any]] = {}
    for name, rows in values.items():
        names = named.get(name)
        found[name] = {
            "dtype": str(rows.dtype),
            "shape": list(rows.shape[1:]) or [1],
            "names": None if names is None else list(names[: rows.shape[1]]),
        }
    for name, rows in pictures.items():
        found[PICTURES + name] = _picture_feature(rows, fps, config)
    counters = {n: {"dtype": kind, "shape": [1], "names": None} for n, kind in _COUNTERS.items()}
    return found | counters


def is_depth(rows: Shaped[np.ndarray, "t h w *c"]) -> bool:
    """Return whether pictures contain depth."""
    return rows.dtype == np.float32


def codec_of(rows: Shaped[np.ndarray, "t h w *c"], config: LeRobotConfig) -> Codec | None:
    """Return the codec of a camera's video, or None if its pictures are stored in the tables."""
    # labels: always lossless
    if config.video == "none" or (rows.dtype == np.uint8 and rows.ndim == 3):
        return None
    return DEPTH_CODEC if is_depth(rows) else CODECS[config.video]


def _picture_feature(
    rows: Shaped[np.ndarray, "t h w *c"], fps: int, config: LeRobotConfig
) -> dict[str, Any]:
    height, width = rows.shape[1:3]
    channels = rows.shape[3] if rows.ndim == 4 else 1
    codec = codec_of(rows, config)
    info: dict[str, Any] = {"is_depth_map": is_depth(rows)}
    if codec is not None:
        info |= {
            "video.height": height,
            "video.width": width,
            "video.channels": channels,
            "video.codec": codec.name,
            "video.pix_fmt": codec.pixels,
            "video.fps": fps,
            "video.g": GOP,
            "has_audio": False,
        }
        if codec.quality is not None:
            info["video.crf"] = codec.quality if config.quality is None else config.quality
        else:
            info["video.extra_options"] = {"x265-params": "lossless=1"}
    if is_depth(rows):
        info |= DEPTH_INFO if codec is not None else {"depth_unit": "m"}
    return {
        "dtype": "image" if codec is None else "video",
        "shape": [height, width, channels],
        "names": ["height", "width", "channels"],
        "info": info,
    }
