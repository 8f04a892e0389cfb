"""Completed episodes on disk before assembly, each in a folder that is published atomically."""

from __future__ import annotations

import json
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from generator.errors import StorageError
from generator.io.bounded import is_count, parse_object, read_regular

from ..summaries import RowSummary

DATA, ABOUT = "data.parquet", "episode.json"
"""The files of a segment other than its videos: the table of its steps, and its metadata."""

_MOST_BYTES = 1 << 24  # maximum size of a metadata file, bytes


@dataclass(frozen=True, eq=False)
class Segment:
    """An episode on disk.

    Attributes:
        folder: folder of its files.
        number: number of the episode among those played.
        length: number of steps.
        task: the instruction.
        facts: additional columns of the table of episodes.
        summaries: summaries of its features, by name.
    """

    folder: Path
    number: int
    length: int
    task: str
    facts: Mapping[str, Any]
    summaries: Mapping[str, RowSummary]

    def video(self, feature: str) -> Path:
        """Return the file of a feature's video."""
        return self.folder / f"{feature}.mp4"


class SegmentStore:
    """The segments in a folder, which is created if it is missing.

    Incomplete segments of a killed process are removed.

    Raises:
        OSError: a file cannot be written.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        folder.mkdir(exist_ok=True)
        for path in folder.glob("new-*"):
            shutil.rmtree(path)

    def __iter__(self) -> Iterator[Segment]:
        """Yield the segments in order.

        Raises:
            StorageError: a segment is damaged.
        """
        for place in map(self._place, count()):
            if not place.is_dir():
                return
            yield _read(place)

    def _place(self, number: int) -> Path:
        return self._folder / f"episode-{number:06d}"

    def begin(self) -> Path:
        """Return a new folder for the files of a segment."""
        return Path(tempfile.mkdtemp(prefix="new-", dir=self._folder))

    def publish(self, segment: Segment, index: int) -> None:
        """Publish a segment as segment ``index``; its files must be in a folder from ``begin``."""
        about = {
            "number": segment.number,
            "length": segment.length,
            "task": segment.task,
            "facts": segment.facts,
            "statistics": {name: s.figures() for name, s in segment.summaries.items()},
        }
        (segment.folder / ABOUT).write_text(json.dumps(about), encoding="utf-8")
        segment.folder.rename(self._place(index))


def _read(folder: Path) -> Segment:
    """Read the segment in a folder.

    Raises:
        StorageError: the segment is damaged.
    """
    what = "The recorded episode"
    raw = read_regular(folder / ABOUT, what, StorageError, max_bytes=_MOST_BYTES)
    about = parse_object(raw, f"{what} {folder.name}", StorageError)
    try:
        number, length, task, facts = (about[n] for n in ("number", "length", "task", "facts"))
        if not (is_count(number) and is_count(length) and isinstance(task, str)):
            raise TypeError("no episode")
        summaries = {n: RowSummary.of_figures(s) for n, s in about["statistics"].items()}
        return Segment(folder, number, length, task, dict(facts), summaries)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise StorageError(
            f"{what} {folder} is damaged ({error!r}). Remove {folder.parent.parent} and record "
            "again."
        ) from error
