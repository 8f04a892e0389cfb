"""Files that are written in one go, with an error that says what to do."""

from __future__ import annotations

import tempfile
from pathlib import Path

from .errors import StorageError


def write_whole(path: Path, content: str | bytes, what: str, advice: str) -> None:
    """Write a file that all may read, whole or not at all.

    Args:
        path: where; the folder must be there.
        content: bytes, or a text for UTF-8.
        what: what it is, for the message of an error: "The policy".
        advice: what to do then: "Choose another folder."

    Raises:
        StorageError: it cannot be written.
    """
    part = None
    try:
        try:
            with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
                part = Path(file.name)
                file.write(content.encode() if isinstance(content, str) else content)
            part.chmod(0o644)
            part.replace(path)
        finally:  # also when it is interrupted
            if part is not None:
                part.unlink(missing_ok=True)
    except OSError as error:
        raise StorageError(
            f"{what} cannot be written to {path}: {error.strerror or error}. {advice}"
        ) from error


def write_file(content: bytes, path: Path) -> Path:
    """Write a file that may be there already, making its folder if it is missing.

    Raises:
        StorageError: the file cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        raise StorageError(
            f"{path} cannot be written: {error.strerror or error}. Choose another folder."
        ) from error
    return path


def make_private(folder: Path) -> None:
    """Make a folder and those above that are missing, for their owner alone."""
    if folder.is_dir():
        return
    if not folder.parent.is_dir():
        make_private(folder.parent)
    folder.mkdir(mode=0o700, exist_ok=True)
