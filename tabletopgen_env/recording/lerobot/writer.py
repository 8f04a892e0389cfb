"""The writer of LeRobot datasets, which stores one episode at a time."""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium import spaces
from jaxtyping import Shaped

from generator.errors import InputError, StorageError
from generator.io.bounded import parse_object, read_regular

from ..config import LeRobotConfig, RecordConfig
from ..episodes import RecordedEpisode
from ..formats.about import describe_dataset
from ..summaries import RowSummary, summarize, summarize_colors, summarize_depth
from .assembly import Limits, assemble
from .depth import quantize
from .features import PICTURES, codec_of, features_of, is_depth, step_values
from .segments import DATA, Segment, SegmentStore
from .tables import encode_picture, step_table
from .videos import encode

LIMITS = Limits()
"""Maximum file sizes."""

_ROBOT = "panda"
_FEATURES = "features.json"  # files beside the first episode
_MOST_BYTES = 1 << 20  # maximum size of the features' file, bytes


class LeRobotWriter:
    """A writer of a new folder; completed episodes are stored beside it, for resuming.

    Raises:
        InputError: pictures have an odd size, which videos do not support.
        StorageError: a stored episode is damaged.
        OSError: a file cannot be written.
    """

    def __init__(
        self, place: Path, config: RecordConfig, env: gym.Env[Any, Any], lerobot: LeRobotConfig
    ) -> None:
        self._place, self._lerobot = place, lerobot
        self._about = describe_dataset(config, env)
        self._fps = int(self._about["fps"])
        space = env.observation_space
        parts = space.spaces if isinstance(space, spaces.Dict) else {"state": space}
        self._privileged = len(parts) == 1 if lerobot.privileged is None else lerobot.privileged
        if self._privileged and "state" not in parts:
            raise InputError(
                "privileged needs the flat state, which observation='pixels+proprio' does not "
                "include; use 'pixels+state'."
            )
        if lerobot.video != "none":
            _check_sizes(parts)
        if place.is_dir():  # a process was killed during assembly
            shutil.rmtree(place)
        self._segments = SegmentStore(place.parent / "episodes")
        self._tasks: dict[str, int] = {}
        self._frames = self.kept = self.resumed_at = 0
        for segment in self._segments:
            self._count(segment)
            self.resumed_at = segment.number + 1

    def add(self, episode: RecordedEpisode) -> None:
        """Encode and store one more episode."""
        folder = self._segments.begin()
        try:
            segment = self._write(episode, folder)
            self._segments.publish(segment, self.kept)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise
        self._count(segment)

    def _write(self, episode: RecordedEpisode, folder: Path) -> Segment:
        """Write the files of an episode to a folder."""
        import pyarrow.parquet as pq

        length, task = len(episode.rewards), str(episode.facts["instruction"])
        values = step_values(episode, self._privileged)
        pictures = {name: rows[:-1] for name, rows in episode.pictures.items()}
        features = features_of(values, pictures, self._fps, self._lerobot)
        if not self.kept:
            (folder / _FEATURES).write_text(json.dumps(features), encoding="utf-8")
        numbers = values | self._counters(length, task)
        encoded = self._write_pictures(pictures, folder)
        pq.write_table(step_table({**numbers, **encoded}, features), folder / DATA)
        summaries = {name: summarize(rows) for name, rows in numbers.items()}
        summaries |= {PICTURES + n: _summarize_pictures(rows) for n, rows in pictures.items()}
        facts = _episode_columns(episode)
        return Segment(folder, episode.number, length, task, facts, summaries)

    def finish(self) -> None:
        """Assemble the dataset."""
        path, what = next(iter(self._segments)).folder / _FEATURES, "The recording's list"
        raw = read_regular(path, what, StorageError, max_bytes=_MOST_BYTES)
        features = parse_object(raw, f"{what} {str(path)!r}", StorageError)
        info = {"robot_type": _ROBOT, "fps": self._fps}
        assemble(self._segments, self._place, features, info, LIMITS)
        about = self._about | {"lerobot": asdict(self._lerobot)}
        text = json.dumps(about, indent=4) + "\n"
        (self._place / "meta" / "tabletopgen.json").write_text(text, encoding="utf-8")

    def close(self) -> None:
        """Do nothing, since every episode is complete when it is added."""

    def _count(self, segment: Segment) -> None:
        self._tasks.setdefault(segment.task, len(self._tasks))
        self._frames += segment.length
        self.kept += 1

    def _counters(self, steps: int, task: str) -> dict[str, Shaped[np.ndarray, "t"]]:
        """Return the columns that every LeRobot dataset has."""
        frames = np.arange(steps, dtype=np.int64)
        known = self._tasks.get(task, len(self._tasks))
        return {
            "timestamp": (frames / self._fps).astype(np.float32),
            "frame_index": frames,
            "episode_index": np.full(steps, self.kept, np.int64),
            "index": self._frames + frames,
            "task_index": np.full(steps, known, np.int64),
        }

    def _write_pictures(
        self, pictures: Mapping[str, Shaped[np.ndarray, "t h w *c"]], folder: Path
    ) -> dict[str, list[bytes]]:
        """Write the videos; return the columns of pictures that are not in a video."""
        columns: dict[str, list[bytes]] = {}
        for name, rows in pictures.items():
            codec = codec_of(rows, self._lerobot)
            if codec is None:
                columns[PICTURES + name] = [encode_picture(row) for row in rows]
            else:
                shown = quantize(rows) if is_depth(rows) else rows
                path = folder / f"{PICTURES}{name}.mp4"
                encode(shown, path, self._fps, codec, self._lerobot.quality)
        return columns


def _check_sizes(parts: Mapping[str, spaces.Space[Any]]) -> None:
    for name, part in parts.items():
        shape = part.shape or ()
        if len(shape) > 1 and (shape[0] % 2 or shape[1] % 2):
            raise InputError(
                f"A video needs an even width and height, but {name!r} has {shape[0]} x "
                f"{shape[1]}. Choose another image_size, or --video none."
            )


def _summarize_pictures(rows: Shaped[np.ndarray, "t h w *c"]) -> RowSummary:
    if is_depth(rows):
        return summarize_depth(rows)
    return summarize_colors(rows if rows.ndim == 4 else rows[..., None])


def _episode_columns(episode: RecordedEpisode) -> dict[str, Any]:
    """Return an episode's additional columns in the table of episodes."""
    facts = {n: v for n, v in episode.facts.items() if n not in ("instruction", "steps")}
    views = {
        f"cameras/{camera}/intrinsics": views["intrinsics"][0].reshape(-1).tolist()
        for camera, views in episode.cameras.items()
    }
    return {**facts, **views}
