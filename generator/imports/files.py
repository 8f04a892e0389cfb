"""The files of a foreign scene: plain ones inside of its folder, and no others."""

from __future__ import annotations

from pathlib import Path

from ..bundle import read_inside
from ..errors import BundleError, InputError


def read_source(folder: Path, name: str, limit: int) -> bytes:
    """Read a plain file inside of a folder: no way out of it, no links, no more than ``limit``.

    Raises:
        InputError: the file is missing, too large, or not inside of the folder.
    """
    try:
        return read_inside(folder, name, limit)
    except BundleError as error:
        told = f"{error}".replace("leaves the bundle", "leaves the folder")
        told = told.replace("a bundle has plain files only", "only plain files are read")
        told = told.replace(" Make or copy the bundle again.", "")
        raise InputError(f"The scene cannot be imported: {told}") from error
