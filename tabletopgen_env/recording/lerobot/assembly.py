"""Assembly of a dataset from its episodes."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..summaries import Summaries
from .segments import DATA, Segment
from .tables import write_tasks
from .videos import join

if TYPE_CHECKING:
    import pyarrow as pa
    import pyarrow.parquet as pq

VERSION = "v3.0"
"""Version of the format."""

_FILE = "chunk-{chunk_index:03d}/file-{file_index:03d}"
_DATA_PATH = f"data/{_FILE}.parquet"
_VIDEO_PATH = f"videos/{{video_key}}/{_FILE}.mp4"
_EPISODES_PATH = f"meta/episodes/{_FILE}.parquet"
# columns of an episode's own row
_PLACE = ("meta/episodes/chunk_index", "meta/episodes/file_index")
_EPISODES_A_GROUP = 64  # episodes per row group


@dataclass(frozen=True)
class Limits:
    """Maximum sizes of files and folders.

    Attributes:
        data_mb: size of a table, in units of 2^20 bytes.
        video_mb: size of a video, in units of 2^20 bytes.
        files: number of files in a folder ("chunk").
    """

    data_mb: float = 100
    video_mb: float = 200
    files: int = 1000


class _Rollover:
    """The number of the current file, which increases when the file would become too large."""

    def __init__(self, most_mb: float, files: int) -> None:
        self._most, self._files = most_mb * 2**20, files
        self._number, self._size = 0, 0

    def place(self, size: int) -> tuple[int, int]:
        """Return the chunk and file numbers for ``size`` more bytes."""
        if self._size and self._size + size > self._most:
            self._number += 1
            self._size = 0
        self._size += size
        return divmod(self._number, self._files)


class _Tables:
    """A writer of Parquet files; each table becomes a row group, and all have the same columns."""

    def __init__(self, root: Path, pattern: str) -> None:
        self._root, self._pattern = root, pattern
        self._path: Path | None = None
        self._writer: pq.ParquetWriter | None = None

    def add(self, table: pa.Table, chunk: int, file: int) -> None:
        """Write a table as one more row group of a file."""
        import pyarrow.parquet as pq

        path = self._root / self._pattern.format(chunk_index=chunk, file_index=file)
        if path != self._path or self._writer is None:
            self.close()
            path.parent.mkdir(parents=True, exist_ok=True)
            self._path = path
            self._writer = pq.ParquetWriter(path, table.schema, compression="snappy")
        self._writer.write_table(table, row_group_size=max(len(table), 1))

    def close(self) -> None:
        """Close the current file."""
        if self._writer is not None:
            self._writer.close()
            self._writer = None


def assemble(
    segments: Iterable[Segment],
    place: Path,
    features: Mapping[str, Mapping[str, Any]],
    info: Mapping[str, Any],
    limits: Limits,
) -> None:
    """Write the dataset of episodes to a folder; ``info`` extends ``meta/info.json``.

    Raises:
        OSError: a file cannot be written.
    """
    place.mkdir()
    videos = [name for name, feature in features.items() if feature["dtype"] == "video"]
    rows = _Rows(place, features, videos, info["fps"], limits)
    try:
        for segment in segments:
            rows.add(segment)
    finally:
        rows.close()
    for name in videos:
        _write_videos(rows.parts[name], place, name, info["fps"])
    write_tasks([*rows.tasks], place / "meta" / "tasks.parquet")
    figures = rows.summaries.figures()
    stats = {name: _shape(figures[name], features[name]) for name in figures}
    _write_json(stats, place / "meta" / "stats.json")
    whole = {
        "codebase_version": VERSION,
        **info,
        "total_episodes": rows.episodes,
        "total_frames": rows.frames,
        "total_tasks": len(rows.tasks),
        "chunks_size": limits.files,
        "data_files_size_in_mb": limits.data_mb,
        "video_files_size_in_mb": limits.video_mb,
        "splits": {"train": f"0:{rows.episodes}"},
        "data_path": _DATA_PATH,
        "video_path": _VIDEO_PATH if videos else None,
        "features": features,
    }
    _write_json(whole, place / "meta" / "info.json")


class _Rows:
    """The tables of steps and episodes during assembly, and the positions of the videos."""

    def __init__(
        self,
        place: Path,
        features: Mapping[str, Mapping[str, Any]],
        videos: Sequence[str],
        fps: int,
        limits: Limits,
    ) -> None:
        self._features, self._videos, self._fps = features, videos, fps
        self._data = _Tables(place, _DATA_PATH), _Rollover(limits.data_mb, limits.files)
        self._meta = _Tables(place, _EPISODES_PATH), _Rollover(limits.data_mb, limits.files)
        self._files = {name: _Rollover(limits.video_mb, limits.files) for name in videos}
        self._shown: dict[tuple[str, int, int], int] = {}  # frames in a video so far
        self._waiting: list[dict[str, Any]] = []
        self.parts: dict[str, dict[tuple[int, int], list[Path]]] = {name: {} for name in videos}
        self.tasks: dict[str, int] = {}
        self.summaries = Summaries()
        self.episodes = self.frames = 0

    def add(self, segment: Segment) -> None:
        """Write one more episode."""
        import pyarrow.parquet as pq

        path = segment.folder / DATA
        tables, files = self._data
        chunk, file = files.place(path.stat().st_size)
        tables.add(pq.read_table(path), chunk, file)
        self.tasks.setdefault(segment.task, len(self.tasks))
        row = {
            "episode_index": self.episodes,
            "tasks": [segment.task],
            "length": segment.length,
            "data/chunk_index": chunk,
            "data/file_index": file,
            "dataset_from_index": self.frames,
            "dataset_to_index": self.frames + segment.length,
        }
        for name in self._videos:
            row |= self._video_columns(name, segment)
        row |= segment.facts
        for name, summary in segment.summaries.items():
            figures = _shape(summary.figures(), self._features[name])
            row |= {f"stats/{name}/{figure}": value for figure, value in figures.items()}
        self._add_episode(row)
        self.summaries.add(segment.summaries)
        self.episodes += 1
        self.frames += segment.length

    def close(self) -> None:
        """Close all files."""
        self._write_episodes()
        self._data[0].close()
        self._meta[0].close()

    def _video_columns(self, name: str, segment: Segment) -> dict[str, Any]:
        path = segment.video(name)
        chunk, file = self._files[name].place(path.stat().st_size)
        self.parts[name].setdefault((chunk, file), []).append(path)
        first = self._shown.get((name, chunk, file), 0)
        self._shown[name, chunk, file] = last = first + segment.length
        return {
            f"videos/{name}/chunk_index": chunk,
            f"videos/{name}/file_index": file,
            f"videos/{name}/from_timestamp": first / self._fps,
            f"videos/{name}/to_timestamp": last / self._fps,
        }

    def _add_episode(self, row: dict[str, Any]) -> None:
        import pyarrow as pa

        chunk, file = self._meta[1].place(pa.Table.from_pylist([row]).nbytes)
        row |= dict(zip(_PLACE, (chunk, file), strict=True))
        known = self._waiting[-1] if self._waiting else row
        if len(self._waiting) == _EPISODES_A_GROUP or any(known[n] != row[n] for n in _PLACE):
            self._write_episodes()
        self._waiting.append(row)

    def _write_episodes(self) -> None:
        """Write the pending rows of episodes, which all belong to one file."""
        import pyarrow as pa

        if self._waiting:
            chunk, file = (self._waiting[-1][name] for name in _PLACE)
            self._meta[0].add(pa.Table.from_pylist(self._waiting), chunk, file)
            self._waiting = []


def _write_videos(
    parts: Mapping[tuple[int, int], Sequence[Path]], place: Path, name: str, fps: int
) -> None:
    for (chunk, file), paths in parts.items():
        relative = _VIDEO_PATH.format(video_key=name, chunk_index=chunk, file_index=file)
        path = place / relative
        path.parent.mkdir(parents=True, exist_ok=True)
        join(paths, path, fps)


def _shape(figures: Mapping[str, Any], feature: Mapping[str, Any]) -> dict[str, Any]:
    """Return statistics in LeRobot's shape: (channels, 1, 1) for pictures."""
    if feature["dtype"] not in ("image", "video"):
        return dict(figures)
    return {
        name: value if name == "count" else np.reshape(value, (-1, 1, 1)).tolist()
        for name, value in figures.items()
    }


def _write_json(value: Any, path: Path) -> None:
    path.write_text(json.dumps(value, indent=4) + "\n", encoding="utf-8")
