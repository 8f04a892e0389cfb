"""Uploaded pictures, identified by their content rather than their name."""

from __future__ import annotations

import contextlib
import hashlib
import threading
import time
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

from generator.errors import InputError, StorageError
from generator.io.bounded import read_regular
from generator.io.files import remove_file, write_whole
from generator.io.pictures import encode_png
from generator.pictures import format_of

from ..contracts import PictureRow
from ..refusals import RefusedError
from ..specs import PICTURE_ID

MAX_BYTES = 20 * 2**20
"""Maximum size of an uploaded picture."""

_KEPT_SECONDS = 24 * 3600.0  # minimum age for removal: a job may still be about to use the picture
_ADVICE = "Free disk space."


@dataclass(frozen=True)
class PictureShelf:
    """The uploaded pictures in a folder, with ids derived from their content."""

    folder: Path

    def add(self, data: bytes, cancelled: threading.Event | None = None) -> PictureRow:
        """Store a picture; duplicates are stored once.

        A child process decodes it; setting ``cancelled`` from another thread kills that process.

        Raises:
            RefusedError: the content is not a picture.
            InputError: the picture is damaged, over a limit, or ``cancelled`` is set.
            StorageError: the folder is not writable.
        """
        from generator.method.reference import ReferenceConfig, read_image

        limits = ReferenceConfig(max_bytes=MAX_BYTES)
        if format_of(data, limits.picture_limits.formats) is None:
            raise RefusedError(415, "This file is not a PNG, JPEG, WebP, BMP, TIFF or GIF picture.")
        image = read_image(data, limits, cancelled)
        name = hashlib.sha256(data).hexdigest()[:32]
        write_whole(self.folder / f"{name}.png", encode_png(image), "The picture", _ADVICE)
        write_whole(self.folder / name, data, "The picture", _ADVICE)
        return PictureRow(name, image.shape[1], image.shape[0])

    def path(self, name: str) -> Path:
        """Return the path of a picture in its original form.

        Raises:
            RefusedError: the picture does not exist.
        """
        if not PICTURE_ID.fullmatch(name) or not (self.folder / name).is_file():
            raise RefusedError(404, f"There is no picture {name[:80]!r}.")
        return self.folder / name

    def sweep(self, wanted: Collection[str]) -> None:
        """Remove unused pictures older than a day; errors are ignored."""
        oldest = time.time() - _KEPT_SECONDS
        for path in self.folder.iterdir():
            name = path.name.removesuffix(".png")
            if PICTURE_ID.fullmatch(name) and name not in wanted:
                with contextlib.suppress(OSError, StorageError):
                    if path.lstat().st_mtime < oldest:
                        remove_file(self.folder, path.name)

    def read_shown(self, name: str) -> bytes:
        """Return a picture as PNG, upright and reduced to the size used for processing.

        Raises:
            RefusedError: no picture has this id.
        """
        shown = self.path(name).with_suffix(".png")
        return read_regular(shown, "The picture", InputError, max_bytes=4 * MAX_BYTES)
