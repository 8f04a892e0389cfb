"""The order that a job's process receives, and the progress messages that it sends."""

from __future__ import annotations

import json
import os
import re
import threading
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from generator.errors import InputError
from generator.io.files import write_whole
from generator.io.pictures import encode_png

_STEM = re.compile(r"[a-z0-9_]{1,64}")


@dataclass(frozen=True)
class JobOrder:
    """The description of a job that its process receives from the server as one line of JSON.

    Attributes:
        kind: the kind of the job, or "estimate".
        request: the request of the job.
        scenes: the workspace, the destination of new bundles.
        figures: the folder of this job's pictures.
        files: the folder of this job's files.
        bundle: the input scene of the job.
        picture: the uploaded picture.
    """

    kind: str
    request: Mapping[str, Any]
    scenes: Path
    figures: Path
    files: Path
    bundle: Path | None = None
    picture: Path | None = None

    @classmethod
    def parse(cls, payload: Mapping[str, Any]) -> JobOrder:
        """Return the order from JSON values."""
        paths = {k: Path(payload[k]) for k in ("scenes", "figures", "files")}
        more = {k: Path(v) for k in ("bundle", "picture") if (v := payload.get(k))}
        return cls(payload["kind"], payload["request"], **paths, **more)

    def plain(self) -> dict[str, Any]:
        """Return the order as JSON values."""
        paths = ("scenes", "figures", "files", "bundle", "picture")
        paths_as_text = {k: None if (v := getattr(self, k)) is None else str(v) for k in paths}
        return {"kind": self.kind, "request": dict(self.request), **paths_as_text}

    @property
    def start(self) -> Path:
        """The input scene of the job; raises InputError if it has none."""
        if self.bundle is None:
            raise InputError("The job does not specify a scene.")
        return self.bundle


class Telling:
    """A sender of JSON lines to the server: stages, figures, and a result or an error."""

    def __init__(self, file: BinaryIO, figures: Path) -> None:
        self._file, self._figures = file, figures
        self._lock = threading.Lock()

    def say(self, **message: Any) -> None:
        """Send one message; end this process if the server can no longer be reached."""
        try:
            with self._lock:
                self._file.write(json.dumps(message).encode() + b"\n")
                self._file.flush()
        except OSError:
            os._exit(1)

    def stage(self, name: str, number: int, total: int) -> None:
        """Report the start of a stage."""
        self.say(type="stage", name=name, number=number, total=total)

    def show(self, stage: str, pictures: Mapping[str, np.ndarray | bytes]) -> None:
        """Atomically write the pictures of a stage, keyed by file stem, and report each one.

        Raises:
            StorageError: the folder is not writable.
        """
        for stem, picture in pictures.items():
            assert _STEM.fullmatch(stem), stem
            content = picture if isinstance(picture, bytes) else encode_png(picture)
            self._figures.mkdir(parents=True, exist_ok=True)
            path = self._figures / f"{stem}.png"
            write_whole(path, content, "A figure", "Free disk space.")
            self.say(type="figure", name=path.name, stage=stage)
